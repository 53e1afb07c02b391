//! Closed paths in the family of conformal maps between two sides.
//!
//! The maps of one side onto another have three degrees of freedom: two for the interior point, one for
//! the boundary point. A [`Loop`] starts and ends at given points. An interior point moves around a
//! circle (file `circle`); the boundary point moves once around the boundary, at constant speed in
//! harmonic measure, which in the disk is a rotation at constant speed. At constant speed in arc length
//! the map would change fast where the Poisson kernel is large, and hardly at all in crowded parts.

mod circle;

pub use circle::Circle;

use crate::conformal::{HarmonicMeasure, InteriorPoint, PerSide, PreparedSide};
use crate::geometry::DVec2;
use std::sync::Arc;

/// The points that move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Path {
    /// x₁ moves around a circle in the source.
    SourcePoint,
    /// x₂ moves around a circle in the target.
    TargetPoint,
    /// y₁ moves around the source's boundary.
    #[default]
    Boundary,
    /// x₁ and y₁ as above, and x₂ in the opposite direction; an interior point of a surface does not move.
    All,
}

impl Path {
    /// All paths.
    pub const ALL: [Self; 4] = [Self::SourcePoint, Self::TargetPoint, Self::Boundary, Self::All];

    fn moves_source_point(self) -> bool {
        matches!(self, Self::SourcePoint | Self::All)
    }

    fn moves_target_point(self) -> bool {
        matches!(self, Self::TargetPoint | Self::All)
    }

    fn moves_boundary(self) -> bool {
        matches!(self, Self::Boundary | Self::All)
    }
}

/// The map at which a loop starts.
#[derive(Debug, Clone, Copy)]
pub struct Start<'a> {
    sides: PerSide<(&'a Arc<PreparedSide>, InteriorPoint)>,
    measure: &'a HarmonicMeasure,
}

impl<'a> Start<'a> {
    /// The sides with x₁ and x₂, and the harmonic measure of the source from x₁, counted from y₁.
    pub fn new(sides: PerSide<(&'a Arc<PreparedSide>, InteriorPoint)>, measure: &'a HarmonicMeasure) -> Self {
        Self { sides, measure }
    }
}

/// A position on a loop; `None` for points that do not move.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Place {
    /// x₁, x₂.
    pub interior: PerSide<Option<DVec2>>,
    /// y₁, as a fraction of the length of the source's boundary.
    pub anchor: Option<f64>,
}

/// A closed path in the family.
#[derive(Debug, Clone)]
pub struct Loop {
    circles: PerSide<Option<Circle>>,
    turn: Option<Turn>,
}

/// One turn of the boundary point.
#[derive(Debug, Clone)]
struct Turn {
    source: Arc<PreparedSide>,
    measure: HarmonicMeasure,
}

impl Loop {
    /// The loop along `path` from `start`; `None` if no point would move, as with a surface's interior point only.
    pub fn new(path: Path, start: &Start<'_>) -> Option<Self> {
        let circle = |(side, point): (&Arc<PreparedSide>, InteriorPoint)| {
            Some(Circle::through(point.in_plane()?, side.domain()?.samples()))
        };
        let PerSide { source, target } = start.sides;
        let source = Some(source).filter(|_| path.moves_source_point()).and_then(circle);
        let target = Some(target).filter(|_| path.moves_target_point()).and_then(circle);
        let target = target.map(|circle| if path == Path::All { circle.reversed() } else { circle });
        let turn = || Turn { source: Arc::clone(start.sides.source.0), measure: start.measure.clone() };
        let turn = path.moves_boundary().then(turn);
        (source.is_some() || target.is_some() || turn.is_some())
            .then_some(Self { circles: PerSide::new(source, target), turn })
    }

    /// The points at time `t` modulo 1; at 0 they are at the start.
    pub fn at(&self, t: f64) -> Place {
        let t = t.rem_euclid(1.0);
        let interior = self.circles.map(|circle| circle.map(|circle| circle.at(t)));
        Place { interior, anchor: self.turn.as_ref().map(|turn| turn.at(t)) }
    }
}

impl Turn {
    fn at(&self, t: f64) -> f64 {
        let point = if t == 0.0 { self.measure.anchor() } else { self.measure.point_at(t) };
        self.source.fraction_at(point)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
