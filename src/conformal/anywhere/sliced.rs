//! The integral of [`super::InteriorMap`] between two curves, made in slices of a frame and kept beside the map.
//!
//! It owns all that an evaluation needs. It belongs to the boundary map that it was begun with: after an update another
//! one is needed.

use super::breaks;
use crate::cauchy_integral::{CauchyIntegral, Division, Evaluation, Placement};
use crate::conformal::{ConformalMap, Side};
use crate::geometry::DVec2;
use crate::laplace::Deadline;

/// The map from one side into the other one, in preparation or prepared.
#[derive(Debug, Clone)]
pub struct SlicedInterior {
    from: Side,
    state: State,
}

#[derive(Debug, Clone)]
enum State {
    Dividing(Box<Division>),
    Made(Box<CauchyIntegral>),
    /// A measure has changed to one from finite elements since this was begun.
    Lost,
}

impl ConformalMap {
    /// Begins the map from side `from`; `None` unless both measures are from the integral equation.
    pub fn begin_interior(&self, from: Side) -> Option<SlicedInterior> {
        let (curves, back) = self.curve_map(from).zip(self.curve_map(from.other()))?;
        let division = Division::new(curves.from_curve(), &breaks(&curves, &back));
        Some(SlicedInterior { from, state: State::Dividing(Box::new(division)) })
    }
}

impl SlicedInterior {
    /// Continues the preparation until it is complete (true) or `deadline` has passed. `map` is the map that it was
    /// begun with.
    pub fn advance(&mut self, map: &ConformalMap, deadline: Deadline) -> bool {
        let State::Dividing(division) = &mut self.state else { return true };
        let Some(curves) = map.curve_map(self.from) else {
            self.state = State::Lost;
            return true;
        };
        if !division.advance(&curves, &mut || deadline.is_over()) {
            return false;
        }
        if let State::Dividing(division) = std::mem::replace(&mut self.state, State::Lost) {
            self.state = State::Made(Box::new(division.finish()));
        }
        true
    }

    /// f and f′ at a point inside; `None` before the preparation is complete, on the boundary and outside.
    pub fn evaluate(&self, z: DVec2) -> Option<Evaluation> {
        let State::Made(integral) = &self.state else { return None };
        (integral.placement(z) == Placement::Inside).then(|| integral.evaluate(z))
    }

    /// Whether the preparation is complete.
    pub(in crate::conformal) fn is_made(&self) -> bool {
        matches!(self.state, State::Made(_))
    }
}
