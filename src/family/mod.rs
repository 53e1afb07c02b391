//! Closed ways through the family of conformal maps between two sides.
//!
//! The maps of one side onto another have three degrees of freedom: two for the interior point, one for
//! the boundary point. A [`Loop`] begins and ends at given points. An interior point goes around a
//! circle (file `circle`); the boundary point turns once so that equal times are equal
//! harmonic measures: in the disk that is a rotation at constant speed, while equal arc lengths would
//! rush through what crowding has made small, and stand still where it is large.

mod circle;

pub use circle::Circle;

use crate::conformal::{HarmonicMeasure, InteriorPoint, PerSide, PreparedSide};
use crate::geometry::DVec2;
use std::sync::Arc;

/// Which of the points move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Path {
    /// x₁ goes around a circle in the source.
    SourcePoint,
    /// x₂ goes around a circle in the target.
    TargetPoint,
    /// y₁ turns around the source.
    #[default]
    Boundary,
    /// x₁ and y₁ as above, and x₂ the other way around; a point of a surface stays.
    All,
}

impl Path {
    /// All of them.
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

/// Where a loop begins: the map that is there.
#[derive(Debug, Clone, Copy)]
pub struct Start<'a> {
    /// The sides, and x₁ and x₂ in them.
    pub sides: PerSide<(&'a Arc<PreparedSide>, InteriorPoint)>,
    /// The harmonic measure of the source from y₁, seen from x₁.
    pub measure: &'a HarmonicMeasure,
}

/// Points on a loop; `None` for those that do not move.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Place {
    /// x₁, x₂.
    pub interior: [Option<DVec2>; 2],
    /// y₁, as a fraction of the length of the source's boundary.
    pub anchor: Option<f64>,
}

/// A closed way through the family.
#[derive(Debug, Clone)]
pub struct Loop {
    circles: [Option<Circle>; 2],
    turn: Option<Turn>,
}

/// One turn of the boundary point.
#[derive(Debug, Clone)]
struct Turn {
    source: Arc<PreparedSide>,
    measure: HarmonicMeasure,
}

impl Loop {
    /// The loop along `path` from `start`. `None` where nothing would move: a point of a surface alone.
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
        (source.is_some() || target.is_some() || turn.is_some()).then_some(Self { circles: [source, target], turn })
    }

    /// The points at time `t`, of which only the fraction counts: at 0 they are where the loop begins.
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
