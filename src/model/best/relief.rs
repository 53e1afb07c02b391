//! The landscape as it is drawn: a rank of each vertex for its color, and level lines.
//!
//! It depends on the sides, on all constraints but x₁, on the direction and the criterion, and is computed anew when one of
//! them has changed; while x₁ is dragged it stays.

use super::SLICE_MS;
use super::sides::KnownSides;
use crate::conformal::{ConformalMap, Constraints, Direction, MeshedDomain, Side};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use crate::model::Model;
use crate::optimization::{Criterion, Landscape, Marks, OptimizeError};

/// Level lines, at equal steps of rank: a twelfth of the vertices lies between two of them.
const LEVELS: usize = 11;

/// A level line and the value there.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// The criterion.
    pub value: f64,
    /// Segments.
    pub line: Vec<[DVec2; 2]>,
}

/// A complete landscape.
#[derive(Debug)]
pub struct Landscapes {
    landscape: Landscape,
    ranks: Vec<f32>,
    levels: Vec<Level>,
}

impl Landscapes {
    fn new(landscape: Landscape) -> Self {
        let mut sorted: Vec<f64> = landscape.values().iter().copied().filter(|value| value.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        let count = sorted.len().max(1) as f32;
        let rank = |value: &f64| sorted.partition_point(|known| known < value) as f32 / count;
        let ranks = landscape.values().iter().map(rank).collect();
        let level = |k: usize| sorted.get(k * sorted.len() / (LEVELS + 1)).copied();
        let levels = (1..=LEVELS).filter_map(level).map(|value| Level { value, line: landscape.level_line(value) });
        Self { levels: levels.collect(), ranks, landscape }
    }

    /// The source whose vertices the ranks belong to.
    pub fn domain(&self) -> &MeshedDomain {
        self.landscape.domain()
    }

    /// By vertex the share of vertices with a lesser value, from 0 to 1.
    pub fn ranks(&self) -> &[f32] {
        &self.ranks
    }

    /// The best place, and the values that are said in numbers; `None` if no place has one.
    pub fn marks(&self) -> Option<Marks> {
        self.landscape.marks()
    }

    /// Level lines, from below.
    pub fn levels(&self) -> &[Level] {
        &self.levels
    }
}

/// What a landscape belongs to.
#[derive(Debug, Clone, PartialEq)]
struct Origin {
    sides: KnownSides,
    criterion: Criterion,
    /// With x₁ of the source's default point.
    constraints: Constraints,
    direction: Direction,
}

/// The landscape that is asked for, under way or complete.
#[derive(Debug, Default)]
pub(super) struct Relief {
    pub is_asked: bool,
    origin: Option<Origin>,
    /// Whether it was begun: while a drag changes the origin in every frame, it is not.
    is_begun: bool,
    coming: Option<Landscape>,
    /// Why there is none.
    pub error: Option<OptimizeError>,
    complete: Option<Landscapes>,
}

impl Relief {
    pub fn shown(&self) -> Option<&Landscapes> {
        self.complete.as_ref().filter(|_| self.is_asked)
    }
}

impl Model {
    /// Continues the landscape, if it is asked for; returns whether it is incomplete.
    pub(super) fn advance_relief(&mut self) -> bool {
        if !self.best.relief.is_asked || !self.is_mapped() || self.best.search.is_some() {
            return false;
        }
        let Some((sides, constraints)) = self.both_sides().zip(self.constraints()) else { return false };
        let constraints = constraints.with_point(Side::Source, sides.source.default_point());
        let direction = self.session.direction();
        let criterion = match self.criterion() {
            Ok(criterion) => criterion,
            Err(error) => {
                self.best.relief = Relief { is_asked: true, error: Some(error), ..Relief::default() };
                return false;
            }
        };
        let origin = Origin { sides: KnownSides::new(&sides), criterion: criterion.clone(), constraints, direction };
        if self.best.relief.origin.as_ref() != Some(&origin) {
            self.best.relief = Relief { is_asked: true, origin: Some(origin), ..Relief::default() };
            return true;
        }
        if !self.best.relief.is_begun {
            let mapped = self.map().map_or(direction.mapped_side(), ConformalMap::mapped_side);
            let relief = &mut self.best.relief;
            match Landscape::new(&sides, criterion, constraints, mapped) {
                Ok(landscape) => relief.coming = Some(landscape),
                Err(error) => relief.error = Some(error),
            }
            relief.is_begun = true;
        }
        let relief = &mut self.best.relief;
        let Some(mut landscape) = relief.coming.take() else { return false };
        if landscape.advance(Deadline::in_ms(SLICE_MS)) {
            relief.complete = Some(Landscapes::new(landscape));
        } else {
            relief.coming = Some(landscape);
        }
        true
    }
}
