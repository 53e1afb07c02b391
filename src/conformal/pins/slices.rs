//! The search for the map through pins in slices of time.
//!
//! The search is a function of pins, sides and points nearby, and spends its time in harmonic measures and discrete
//! harmonic functions of the sides, in looking a place up in these, and in the fit of more than three pins. These are its
//! steps: the first two are advanced until a deadline, and each is kept once it is complete. A search that was interrupted
//! runs again from its beginning and gets the kept results back in the same order. An interrupted step ends in an error, of
//! which the search makes what it will: its outcome is dropped. So the result is, bit for bit, that of one slice without a
//! deadline.

use super::{PinError, Pins};
use crate::boundary_integral::{self, BoundaryIntegralError};
use crate::conformal::kernel::{KernelScratch, advance_kernel, begin_kernel};
use crate::conformal::{
    BoundaryEquation, Constraints, ExtensionScratch, HarmonicMeasure, InteriorPoint, PerSide, PreparedSide,
};
use crate::geometry::DVec2;
use crate::laplace::{Deadline, NotConverged};
use crate::mesh::BarycentricPoint;
use std::cell::RefCell;
use std::sync::Arc;

/// A search for the constraints of pins that may be interrupted.
#[derive(Debug)]
pub struct PinSearch {
    pins: Pins,
    near: PerSide<InteriorPoint>,
    slices: Slices,
}

impl PinSearch {
    /// A search as [`Pins::constraints`] makes it, from the points `near`.
    pub fn new(pins: Pins, near: PerSide<InteriorPoint>) -> Self {
        Self { pins, near, slices: Slices::new(Deadline::NEVER) }
    }

    /// The pins.
    pub fn pins(&self) -> &Pins {
        &self.pins
    }

    /// Goes on until the constraints are found or `deadline` has passed, which is checked every few milliseconds; `None` in
    /// the second case. To be called with the same sides each time, and not again after the end.
    pub fn advance(
        &mut self,
        sides: PerSide<&PreparedSide>,
        deadline: Deadline,
    ) -> Option<Result<Constraints, PinError>> {
        self.slices.begin(deadline);
        let found = self.pins.constraints_in(sides, self.near, &self.slices);
        (!self.slices.is_interrupted()).then_some(found)
    }
}

/// The steps of a search, kept over its slices.
#[derive(Debug)]
pub(super) struct Slices(RefCell<State>);

#[derive(Debug)]
struct State {
    deadline: Deadline,
    kept: Vec<Step>,
    /// The number of kept results that this slice has got back.
    replayed: usize,
    kernel: Option<(Box<KernelScratch>, Vec<f64>)>,
    extension: Option<(Box<ExtensionScratch>, Vec<DVec2>)>,
    /// Whether this slice has completed a step of its own.
    has_advanced: bool,
    is_interrupted: bool,
}

/// The result of a step.
#[derive(Debug, Clone)]
enum Step {
    OnCurve(Result<Arc<boundary_integral::HarmonicMeasure>, BoundaryIntegralError>),
    OnMesh(Result<Arc<HarmonicMeasure>, NotConverged>),
    Functions(Result<Arc<Vec<DVec2>>, NotConverged>),
    Place(Option<InteriorPoint>),
    Fit(Option<[PerSide<f64>; 3]>),
}

/// The result of a step, or `None` if it was interrupted.
type Slice<T, E> = Option<Result<Arc<T>, E>>;

/// The error in which an interrupted step ends.
pub(super) const INTERRUPTED: NotConverged = NotConverged { residual: f64::INFINITY };

impl Slices {
    /// Without kept results.
    pub fn new(deadline: Deadline) -> Self {
        Self(RefCell::new(State {
            deadline,
            kept: Vec::new(),
            replayed: 0,
            kernel: None,
            extension: None,
            has_advanced: false,
            is_interrupted: false,
        }))
    }

    fn begin(&self, deadline: Deadline) {
        let mut state = self.0.borrow_mut();
        (state.deadline, state.replayed) = (deadline, 0);
        (state.has_advanced, state.is_interrupted) = (false, false);
    }

    fn is_interrupted(&self) -> bool {
        self.0.borrow().is_interrupted
    }

    /// The harmonic measure of a curve, seen from a point.
    pub fn on_curve(
        &self,
        equation: &BoundaryEquation,
        x: DVec2,
    ) -> Slice<boundary_integral::HarmonicMeasure, BoundaryIntegralError> {
        match self.whole(|| Step::OnCurve(equation.harmonic_measure(x)))? {
            Step::OnCurve(found) => Some(found),
            _ => None,
        }
    }

    /// A place that is looked up in all of a mesh; `None` also if there is none.
    pub fn place(&self, find: impl FnOnce() -> Option<InteriorPoint>) -> Option<InteriorPoint> {
        match self.whole(|| Step::Place(find()))? {
            Step::Place(found) => found,
            _ => None,
        }
    }

    /// Three pairs of the map that misses more than three pins least; `None` also if there is none.
    pub fn fit(&self, fit: impl FnOnce() -> Option<[PerSide<f64>; 3]>) -> Option<[PerSide<f64>; 3]> {
        match self.whole(|| Step::Fit(fit()))? {
            Step::Fit(found) => found,
            _ => None,
        }
    }

    /// A step that is not divided.
    fn whole(&self, compute: impl FnOnce() -> Step) -> Option<Step> {
        self.step(|_| Some(compute()))
    }

    /// The kept result of the next step, or what `advance` makes of it; `None` if it is interrupted.
    fn step(&self, advance: impl FnOnce(&mut State) -> Option<Step>) -> Option<Step> {
        let mut state = self.0.borrow_mut();
        if let Some(known) = state.replay() {
            return Some(known);
        }
        if !state.may_go_on() {
            return None;
        }
        let step = advance(&mut state)?;
        state.keep(step.clone());
        Some(step)
    }

    /// The harmonic measure of a mesh, counted from an anchor and seen from a point.
    pub fn on_mesh(
        &self,
        side: &PreparedSide,
        x: BarycentricPoint,
        anchor: f64,
    ) -> Slice<HarmonicMeasure, NotConverged> {
        let begin = || {
            let mut scratch = Box::default();
            begin_kernel(side, x, &mut scratch);
            (scratch, Vec::new())
        };
        let advance = |state: &mut State| {
            let (mut scratch, mut kernel) = state.kernel.take().unwrap_or_else(begin);
            match advance_kernel(side, x, &mut scratch, &mut kernel, state.deadline) {
                Ok(true) => {
                    let mut measure = HarmonicMeasure::default();
                    measure.set_along(side.edge_lengths(), &kernel, side.at_fraction(anchor));
                    Some(Step::OnMesh(Ok(Arc::new(measure))))
                }
                Ok(false) => {
                    (state.kernel, state.is_interrupted) = (Some((scratch, kernel)), true);
                    None
                }
                Err(error) => Some(Step::OnMesh(Err(error))),
            }
        };
        match self.step(advance)? {
            Step::OnMesh(found) => Some(found),
            _ => None,
        }
    }

    /// The discrete harmonic functions with these boundary values, at all vertices.
    pub fn functions(
        &self,
        side: &PreparedSide,
        boundary: impl Iterator<Item = DVec2>,
    ) -> Slice<Vec<DVec2>, NotConverged> {
        let begin = || {
            let mut scratch = Box::default();
            side.begin_extension(boundary, &mut scratch);
            (scratch, Vec::new())
        };
        let advance = |state: &mut State| {
            let (mut scratch, mut values) = state.extension.take().unwrap_or_else(begin);
            match side.advance_extension(&mut scratch, &mut values, state.deadline) {
                Ok(true) => Some(Step::Functions(Ok(Arc::new(values)))),
                Ok(false) => {
                    (state.extension, state.is_interrupted) = (Some((scratch, values)), true);
                    None
                }
                Err(error) => Some(Step::Functions(Err(error))),
            }
        };
        match self.step(advance)? {
            Step::Functions(found) => Some(found),
            _ => None,
        }
    }
}

impl State {
    /// The next kept result.
    fn replay(&mut self) -> Option<Step> {
        let step = self.kept.get(self.replayed).cloned();
        self.replayed += usize::from(step.is_some());
        step
    }

    /// Whether the next step may be advanced: in every slice one is.
    fn may_go_on(&mut self) -> bool {
        self.is_interrupted |= self.has_advanced && self.deadline.is_over();
        !self.is_interrupted
    }

    fn keep(&mut self, step: Step) {
        self.kept.push(step);
        self.replayed = self.kept.len();
        self.has_advanced = true;
    }
}
