//! What determines a map: the two sides, the direction, the extension, `f(x₁) = x₂` and `f(y₁) = y₂`.

use super::Extension;
use crate::geometry::DVec2;

/// One of the two domains.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Ω₁.
    Source,
    /// Ω₂.
    Target,
}

impl Side {
    /// Both, source first.
    pub const BOTH: [Self; 2] = [Self::Source, Self::Target];

    /// The other one.
    #[must_use]
    pub fn other(self) -> Self {
        match self {
            Self::Source => Self::Target,
            Self::Target => Self::Source,
        }
    }
}

impl std::fmt::Display for Side {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Source => "source",
            Self::Target => "target",
        })
    }
}

/// Which mesh is mapped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Direction {
    /// The source's vertices are mapped into the target.
    Forward,
    /// The target's vertices are mapped into the source, as texture coordinates.
    #[default]
    Backward,
}

impl Direction {
    /// The side whose mesh is mapped.
    pub fn mapped_side(self) -> Side {
        match self {
            Self::Forward => Side::Source,
            Self::Backward => Side::Target,
        }
    }
}

/// Which mesh is mapped, and how its inside follows the boundary.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub struct MapSettings {
    /// Which mesh is mapped.
    pub direction: Direction,
    /// How the boundary map is extended into it.
    pub extension: Extension,
}

impl From<Direction> for MapSettings {
    /// With the default extension.
    fn from(direction: Direction) -> Self {
        Self { direction, extension: Extension::default() }
    }
}

/// `f(x₁) = x₂`, `f(y₁) = y₂`.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Constraints {
    /// `x₁`, inside Ω₁.
    pub source_point: DVec2,
    /// `x₂`, inside Ω₂.
    pub target_point: DVec2,
    /// `y₁`, as a fraction of the arc length of the source outline from its first point.
    pub source_anchor: f64,
    /// `y₂`, likewise on the target outline.
    pub target_anchor: f64,
}

impl Constraints {
    /// The interior point of a side.
    pub fn point(&self, side: Side) -> DVec2 {
        match side {
            Side::Source => self.source_point,
            Side::Target => self.target_point,
        }
    }

    /// The anchor of a side.
    pub fn anchor(&self, side: Side) -> f64 {
        match side {
            Side::Source => self.source_anchor,
            Side::Target => self.target_anchor,
        }
    }
}
