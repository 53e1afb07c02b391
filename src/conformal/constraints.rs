//! What determines a map: the two sides, the direction, the extension, `f(x₁) = x₂` and `f(y₁) = y₂`.

use super::Extension;
use crate::geometry::DVec2;
use crate::mesh::BarycentricPoint;

/// One of the two sides.
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

/// One value for each side, indexed by [`Side`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, serde::Serialize, serde::Deserialize)]
pub struct PerSide<T> {
    /// The source's.
    pub source: T,
    /// The target's.
    pub target: T,
}

impl<T> PerSide<T> {
    /// The two values.
    pub const fn new(source: T, target: T) -> Self {
        Self { source, target }
    }

    /// Computes the value of each side, the source's first.
    pub fn from_fn(mut value: impl FnMut(Side) -> T) -> Self {
        let source = value(Side::Source);
        Self { source, target: value(Side::Target) }
    }

    /// Applies `f` to both values, the source's first.
    pub fn map<U>(self, mut f: impl FnMut(T) -> U) -> PerSide<U> {
        PerSide { source: f(self.source), target: f(self.target) }
    }

    /// Both values by reference.
    pub const fn as_ref(&self) -> PerSide<&T> {
        PerSide { source: &self.source, target: &self.target }
    }

    /// Both values by mutable reference.
    pub const fn as_mut(&mut self) -> PerSide<&mut T> {
        PerSide { source: &mut self.source, target: &mut self.target }
    }

    /// The two values, the source's first.
    pub fn into_array(self) -> [T; 2] {
        [self.source, self.target]
    }

    /// The values with their sides, the source's first.
    pub fn iter(&self) -> impl Iterator<Item = (Side, &T)> {
        [(Side::Source, &self.source), (Side::Target, &self.target)].into_iter()
    }

    /// Exchanges the two values.
    pub const fn swap(&mut self) {
        std::mem::swap(&mut self.source, &mut self.target);
    }
}

impl<T> From<[T; 2]> for PerSide<T> {
    /// The source's value, then the target's.
    fn from([source, target]: [T; 2]) -> Self {
        Self { source, target }
    }
}

impl<T> PerSide<Option<T>> {
    /// Both values, if neither is `None`.
    pub fn both(self) -> Option<PerSide<T>> {
        Some(PerSide { source: self.source?, target: self.target? })
    }
}

impl<T> std::ops::Index<Side> for PerSide<T> {
    type Output = T;

    fn index(&self, side: Side) -> &T {
        match side {
            Side::Source => &self.source,
            Side::Target => &self.target,
        }
    }
}

impl<T> std::ops::IndexMut<Side> for PerSide<T> {
    fn index_mut(&mut self, side: Side) -> &mut T {
        match side {
            Side::Source => &mut self.source,
            Side::Target => &mut self.target,
        }
    }
}

/// Which mesh is mapped. With one surface, the surface's mesh is mapped in either direction.
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

    /// The direction in which this side's mesh is mapped.
    pub fn mapping(side: Side) -> Self {
        match side {
            Side::Source => Self::Forward,
            Side::Target => Self::Backward,
        }
    }
}

/// Which mesh is mapped, and how the boundary map is extended to its interior.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct MapSettings {
    /// Which mesh is mapped.
    pub direction: Direction,
    /// How the boundary map is extended to the interior of that mesh.
    pub extension: Extension,
}

impl MapSettings {
    /// A direction and an extension.
    pub const fn new(direction: Direction, extension: Extension) -> Self {
        Self { direction, extension }
    }
}

impl From<Direction> for MapSettings {
    /// The direction with the default extension.
    fn from(direction: Direction) -> Self {
        Self { direction, extension: Extension::default() }
    }
}

/// A point inside a side.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum InteriorPoint {
    /// A place in a planar domain.
    Plane(DVec2),
    /// A point of a surface.
    Surface(BarycentricPoint),
}

impl InteriorPoint {
    /// The position in the plane; `None` for a point of a surface.
    pub fn in_plane(self) -> Option<DVec2> {
        match self {
            Self::Plane(x) => Some(x),
            Self::Surface(_) => None,
        }
    }

    /// The point of a surface; `None` for a point of the plane.
    pub fn on_surface(self) -> Option<BarycentricPoint> {
        match self {
            Self::Plane(_) => None,
            Self::Surface(point) => Some(point),
        }
    }
}

impl From<DVec2> for InteriorPoint {
    fn from(x: DVec2) -> Self {
        Self::Plane(x)
    }
}

impl From<BarycentricPoint> for InteriorPoint {
    fn from(point: BarycentricPoint) -> Self {
        Self::Surface(point)
    }
}

/// `f(x₁) = x₂`, `f(y₁) = y₂`.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct Constraints {
    /// `x₁` and `x₂`, inside their sides.
    pub points: PerSide<InteriorPoint>,
    /// `y₁` and `y₂`, as fractions of the boundary's length from its first point.
    pub anchors: PerSide<f64>,
}

impl Constraints {
    /// `(x₁, y₁)` and `(x₂, y₂)`.
    pub fn new(source: (impl Into<InteriorPoint>, f64), target: (impl Into<InteriorPoint>, f64)) -> Self {
        Self { points: PerSide::new(source.0.into(), target.0.into()), anchors: PerSide::new(source.1, target.1) }
    }

    /// The same constraints with another interior point on one side.
    #[must_use]
    pub fn with_point(mut self, side: Side, point: impl Into<InteriorPoint>) -> Self {
        self.points[side] = point.into();
        self
    }

    /// The same constraints with another anchor on one side.
    #[must_use]
    pub fn with_anchor(mut self, side: Side, anchor: f64) -> Self {
        self.anchors[side] = anchor;
        self
    }
}
