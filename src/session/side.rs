//! One side of a session: its outline, the surface shown instead of it, if any, and the two points of each.

use super::{DomainSpec, OutlineSpec, SurfaceSpec, SurfaceState};
use crate::conformal::{InteriorPoint, PrepareSettings};
use crate::geometry::DVec2;
use crate::mesh::BarycentricPoint;

/// The two points of an outline, or those of a surface.
///
/// `interior` is `None` until set; the default is an outline's pole of inaccessibility, or the vertex of a
/// surface that is farthest from its boundary. `anchor` is a fraction of the boundary's length.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs, reason = "explained above")]
pub enum SidePoints {
    Outline { interior: Option<DVec2>, anchor: f64 },
    Surface { interior: Option<BarycentricPoint>, anchor: f64 },
}

impl SidePoints {
    /// The boundary point, as a fraction of the boundary's length.
    pub fn anchor(self) -> f64 {
        match self {
            Self::Outline { anchor, .. } | Self::Surface { anchor, .. } => anchor,
        }
    }
}

/// One side. A surface hides the outline, which keeps its own points.
///
/// Invariant: the boundary point of the outline is a fraction in [0, 1]. Commands take it modulo 1, and readers of
/// links and files refuse any other value with [`super::OutOfRange`].
#[derive(Debug, Clone, PartialEq)]
pub struct SideState {
    pub(super) domain: DomainSpec,
    pub(crate) interior: Option<DVec2>,
    pub(super) anchor: f64,
    pub(super) surface: Option<SurfaceState>,
}

impl SideState {
    /// The outline and how it is discretized.
    pub fn domain(&self) -> &DomainSpec {
        &self.domain
    }

    /// The outline's interior point `x`; `None` until set, with the pole of inaccessibility as default.
    pub fn interior(&self) -> Option<DVec2> {
        self.interior
    }

    /// The outline's boundary point `y`, as a fraction of arc length in [0, 1].
    pub fn anchor(&self) -> f64 {
        self.anchor
    }

    /// The surface shown instead of the outline.
    pub fn surface(&self) -> Option<&SurfaceState> {
        self.surface.as_ref()
    }

    /// A side with an outline, no surface, and the default points.
    pub(super) fn new(outline: OutlineSpec, settings: PrepareSettings) -> Self {
        Self { domain: DomainSpec { outline, settings }, interior: None, anchor: 0.0, surface: None }
    }

    /// The outline's points.
    pub fn outline_points(&self) -> SidePoints {
        SidePoints::Outline { interior: self.interior, anchor: self.anchor }
    }

    /// The points of the surface, or without one of the outline.
    pub fn points(&self) -> SidePoints {
        self.surface.as_ref().map_or_else(|| self.outline_points(), SurfaceState::points)
    }

    /// Sets both points; those of a surface only if the side has one. An anchor that is not finite is ignored, any
    /// other is taken modulo 1.
    pub(super) fn place(&mut self, points: SidePoints) {
        match (points, &mut self.surface) {
            (SidePoints::Outline { interior, anchor }, _) => {
                self.interior = interior;
                place_anchor(&mut self.anchor, anchor);
            }
            (SidePoints::Surface { interior, anchor }, Some(surface)) => {
                surface.point = interior;
                place_anchor(&mut surface.anchor, anchor);
            }
            (SidePoints::Surface { .. }, None) => {}
        }
    }

    /// Moves the outline's or the surface's interior point; ignored for a surface that the side does not have.
    pub(super) fn move_interior(&mut self, point: InteriorPoint) {
        match (point, &mut self.surface) {
            (InteriorPoint::Plane(point), _) => self.interior = Some(point),
            (InteriorPoint::Surface(point), Some(surface)) => surface.point = Some(point),
            (InteriorPoint::Surface(_), None) => {}
        }
    }

    /// Moves the boundary point of the surface, or without one of the outline.
    pub(super) fn move_anchor(&mut self, fraction: f64) {
        place_anchor(self.surface.as_mut().map_or(&mut self.anchor, |surface| &mut surface.anchor), fraction);
    }

    /// Shows a surface instead of the outline. The same surface at another resolution keeps its points, except an
    /// interior point in triangles that no longer exist.
    pub(super) fn set_surface(&mut self, spec: SurfaceSpec) {
        let old = self.surface.take().filter(|old| old.spec.shape.is_like(&spec.shape));
        let mut new = SurfaceState::new(spec);
        if let Some(old) = old {
            new.anchor = old.anchor;
            new.holes = old.holes;
            new.point = old.point.filter(|_| old.spec.shape == new.spec.shape);
        }
        self.surface = Some(new);
    }
}

fn place_anchor(anchor: &mut f64, fraction: f64) {
    if fraction.is_finite() {
        *anchor = fraction.rem_euclid(1.0);
    }
}
