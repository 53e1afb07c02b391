//! A surface in a session: its source, its settings and its two points.

use super::SidePoints;
use crate::conformal::SurfaceSettings;
use crate::mesh::BarycentricPoint;
use crate::surface::SurfacePreset;

/// Where a surface comes from.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SurfaceShape {
    /// A built-in surface.
    Preset {
        /// Its name.
        preset: SurfacePreset,
        /// The approximate number of boundary vertices.
        boundary: u32,
    },
    /// A surface from a file. Its triangles are too many for a session and stay in the file.
    File {
        /// The file's name.
        name: String,
    },
}

impl SurfaceShape {
    /// Whether the two differ at most in their resolution.
    pub fn is_like(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Preset { preset, .. }, Self::Preset { preset: other, .. }) => preset == other,
            _ => self == other,
        }
    }

    /// Whether it comes from the file of this name.
    pub fn is_file(&self, name: &str) -> bool {
        matches!(self, Self::File { name: known } if known == name)
    }

    /// A preset at its usual resolution.
    pub fn preset(preset: SurfacePreset) -> Self {
        Self::Preset { preset, boundary: SurfacePreset::USUAL_BOUNDARY }
    }
}

impl Default for SurfaceShape {
    fn default() -> Self {
        Self::preset(SurfacePreset::Hemisphere)
    }
}

/// A surface and how it is prepared.
#[derive(Debug, Clone, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct SurfaceSpec {
    /// Where it comes from.
    pub shape: SurfaceShape,
    /// Whether the safe repairs are made.
    #[serde(default)]
    pub repair: bool,
    /// Of several boundary loops the one that is the outline, counted from 0 by falling length; the repairs fill the
    /// others. Without repairs there is one loop.
    #[serde(default, skip_serializing_if = "is_longest")]
    pub outline_loop: u16,
    /// How it is discretized.
    #[serde(default)]
    pub settings: SurfaceSettings,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
fn is_longest(outline_loop: &u16) -> bool {
    *outline_loop == 0
}

/// What is painted of the filled holes of a repaired surface. The map is that of the filled surface in both cases, and
/// the surface's files never contain the filling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Holes {
    /// Their filling, gray in the colors of distortion.
    #[default]
    Filled,
    /// Nothing: neither the pattern, nor colors, nor edges.
    Open,
}

impl Holes {
    /// Whether the filling is painted.
    pub fn are_filled(&self) -> bool {
        *self == Self::Filled
    }
}

impl SurfaceSpec {
    /// A surface without repairs, with the default settings.
    pub fn new(shape: SurfaceShape) -> Self {
        Self { shape, ..Self::default() }
    }

    /// Makes the safe repairs, or leaves the surface as it is.
    #[must_use]
    pub fn with_repair(self, repair: bool) -> Self {
        Self { repair, ..self }
    }

    /// Chooses the boundary loop that is the outline.
    #[must_use]
    pub fn with_outline_loop(self, outline_loop: u16) -> Self {
        Self { outline_loop, ..self }
    }

    /// Replaces how it is discretized.
    #[must_use]
    pub fn with_settings(self, settings: SurfaceSettings) -> Self {
        Self { settings, ..self }
    }

    /// Whether the two are the same surface, at any resolution and with any settings.
    pub fn is_like(&self, other: &Self) -> bool {
        (self.repair, self.outline_loop) == (other.repair, other.outline_loop) && self.shape.is_like(&other.shape)
    }
}

/// A surface with its two points.
///
/// Invariant in a [`super::Session`]: the boundary point is a fraction in [0, 1]. Commands take it modulo 1, and
/// readers of links and files refuse any other value with [`super::OutOfRange`].
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct SurfaceState {
    pub(crate) spec: SurfaceSpec,
    #[serde(default)]
    pub(crate) point: Option<BarycentricPoint>,
    #[serde(default)]
    pub(crate) anchor: f64,
    #[serde(default, skip_serializing_if = "Holes::are_filled")]
    pub(crate) holes: Holes,
}

impl SurfaceState {
    /// The surface with its default points.
    pub fn new(spec: SurfaceSpec) -> Self {
        Self { spec, point: None, anchor: 0.0, holes: Holes::default() }
    }

    /// Where the surface comes from and how it is prepared.
    pub fn spec(&self) -> &SurfaceSpec {
        &self.spec
    }

    /// The interior point `x`; `None` until set, with the vertex farthest from the boundary as default.
    pub fn point(&self) -> Option<BarycentricPoint> {
        self.point
    }

    /// The boundary point `y`, as a fraction of the length of the boundary loop, in [0, 1].
    pub fn anchor(&self) -> f64 {
        self.anchor
    }

    /// What is painted of its filled holes.
    pub fn holes(&self) -> Holes {
        self.holes
    }

    /// Whether it needs more than the first formats hold: another outline than the longest loop, or open holes.
    #[cfg(feature = "io")]
    pub(super) fn chooses_loops(&self) -> bool {
        self.spec.outline_loop > 0 || !self.holes.are_filled()
    }

    /// Its two points.
    pub fn points(&self) -> SidePoints {
        SidePoints::Surface { interior: self.point, anchor: self.anchor }
    }
}
