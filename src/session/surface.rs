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
pub struct SurfaceSpec {
    /// Where it comes from.
    pub shape: SurfaceShape,
    /// Whether the safe repairs are made.
    #[serde(default)]
    pub repair: bool,
    /// How it is discretized.
    #[serde(default)]
    pub settings: SurfaceSettings,
}

impl SurfaceSpec {
    /// Whether the two are the same surface, at any resolution and with any settings.
    pub fn is_like(&self, other: &Self) -> bool {
        self.repair == other.repair && self.shape.is_like(&other.shape)
    }
}

/// A surface with its two points.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize, serde::Deserialize)]
pub struct SurfaceState {
    /// The surface.
    pub spec: SurfaceSpec,
    /// The interior point `x`; `None` until set, with the vertex farthest from the boundary as default.
    #[serde(default)]
    pub point: Option<BarycentricPoint>,
    /// The boundary point `y`, as a fraction of the length of the boundary loop.
    #[serde(default)]
    pub anchor: f64,
}

impl SurfaceState {
    /// The surface with its default points.
    pub fn new(spec: SurfaceSpec) -> Self {
        Self { spec, point: None, anchor: 0.0 }
    }

    /// Its two points.
    pub fn points(&self) -> SidePoints {
        SidePoints::Surface { interior: self.point, anchor: self.anchor }
    }
}
