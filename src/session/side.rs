//! One side of the session: its outline, the surface that may stand in the outline's place, and the points of each.

use super::{DomainSpec, OutlineSpec, SurfaceSpec, SurfaceState};
use crate::conformal::{InteriorPoint, PrepareSettings};
use crate::geometry::DVec2;
use crate::mesh::BarycentricPoint;

/// The two points of an outline, or those of a surface.
///
/// `interior` is `None` until it is set: the pole of inaccessibility of an outline, the vertex of a
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

/// One side. While a surface stands there, the outline waits behind it with its own points.
#[derive(Debug, Clone, PartialEq)]
pub struct SideState {
    /// The outline and how it is discretised.
    pub domain: DomainSpec,
    /// The outline's interior point `x`; `None` until it is set: the pole of inaccessibility.
    pub interior: Option<DVec2>,
    /// The outline's boundary point `y`, as a fraction of arc length.
    pub anchor: f64,
    /// The surface in the outline's place.
    pub surface: Option<SurfaceState>,
}

impl SideState {
    /// An outline without a surface, with the default points.
    pub(super) fn new(outline: OutlineSpec, settings: PrepareSettings) -> Self {
        Self { domain: DomainSpec { outline, settings }, interior: None, anchor: 0.0, surface: None }
    }

    /// The outline's points.
    pub fn outline_points(&self) -> SidePoints {
        SidePoints::Outline { interior: self.interior, anchor: self.anchor }
    }

    /// The points of what stands here: of the surface, else of the outline.
    pub fn points(&self) -> SidePoints {
        self.surface.as_ref().map_or_else(|| self.outline_points(), SurfaceState::points)
    }

    /// Puts both points; those of a surface only where one stands. An anchor that is not finite stays
    /// as it was, any other is taken modulo 1.
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

    /// Moves the interior point of what `point` is a point of, if that is there.
    pub(super) fn move_interior(&mut self, point: InteriorPoint) {
        match (point, &mut self.surface) {
            (InteriorPoint::Plane(point), _) => self.interior = Some(point),
            (InteriorPoint::Surface(point), Some(surface)) => surface.point = Some(point),
            (InteriorPoint::Surface(_), None) => {}
        }
    }

    /// Moves the boundary point of what stands here: of the surface, else of the outline.
    pub(super) fn move_anchor(&mut self, fraction: f64) {
        place_anchor(self.surface.as_mut().map_or(&mut self.anchor, |surface| &mut surface.anchor), fraction);
    }

    /// Puts a surface in the outline's place. The same surface in another resolution keeps its points, but
    /// for an interior point of triangles that are others.
    pub(super) fn set_surface(&mut self, spec: SurfaceSpec) {
        let old = self.surface.take().filter(|old| old.spec.shape.is_like(&spec.shape));
        let mut new = SurfaceState::new(spec);
        if let Some(old) = old {
            new.anchor = old.anchor;
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
