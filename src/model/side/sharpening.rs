//! The integral equation of a side's outline: requested from the side's worker after the finite elements, which are on
//! the screen meanwhile, and given to the prepared side when its factor arrives.
//!
//! The request has the lowest priority: any other request to the worker supersedes it, and it is made again when the
//! worker is free and the outline that is prepared then still awaits its equation.

use crate::conformal::{BoundaryEquation, PreparedSide, Unsharpened};
use crate::geometry::DVec2;
use crate::language::Message;
use crate::model::side::request::{Generations, PendingRequest};
use crate::model::side::{OutlineRequest, preparation::Preparation};
use crate::session::DomainSpec;
use crate::worker::{Request, Response, Task, Transfer};

/// The request for a side's integral equation.
#[derive(Debug, Default)]
pub struct Sharpening {
    pending_request: PendingRequest<DomainSpec>,
    /// Why no more requests are made until another outline is prepared: the worker stopped.
    stopped: Option<Message>,
    /// The point that the last equation was requested for.
    point: Option<DVec2>,
}

impl Sharpening {
    /// Makes no requests: for a copy of a model, which has no worker.
    pub fn none() -> Self {
        Self { stopped: Some(Message::from(String::new())), ..Self::default() }
    }

    /// Why the worker stopped over the equation.
    pub fn stopped(&self) -> Option<&Message> {
        self.stopped.as_ref()
    }

    /// Whether the side is still to be given its equation, or one that resolves the interior point.
    pub fn is_wanted(&self, outline: &Preparation<OutlineRequest>, point: DVec2) -> bool {
        if self.stopped.is_some() || outline.is_busy() {
            return false;
        }
        let Some(side) = outline.prepared() else { return false };
        self.pending_request.is_busy() || side.awaits_equation() || self.is_unresolved(side, point)
    }

    /// Whether the equation does not resolve the point, and was not made for it.
    fn is_unresolved(&self, side: &PreparedSide, point: DVec2) -> bool {
        let is_resolved = |equation: &BoundaryEquation| equation.resolves(point);
        self.point != Some(point) && side.equation().is_some_and(|equation| !is_resolved(equation))
    }

    /// Whether a request is due for a side whose interior point is `point`. A point that moves is waited for.
    pub fn is_due(&self, outline: &Preparation<OutlineRequest>, point: DVec2, is_at_rest: bool) -> bool {
        let is_first = outline.prepared().is_some_and(|side| side.awaits_equation());
        !self.pending_request.is_busy() && self.is_wanted(outline, point) && (is_first || is_at_rest)
    }

    /// The request for the equation of the outline that is prepared.
    pub fn send(
        &mut self,
        outline: &Preparation<OutlineRequest>,
        point: DVec2,
        generations: &mut Generations,
    ) -> Option<Request> {
        let spec = outline.good()?.spec.clone();
        let task = Task::Equation { outline: Box::new((&spec.outline).into()), settings: spec.settings, point };
        self.point = Some(point);
        Some(self.pending_request.send(spec, task, generations))
    }

    /// Cancels the request: its worker was given another one, or another outline is prepared.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// Whether the request in flight has this generation.
    pub fn awaits(&self, generation: u64) -> bool {
        self.pending_request.awaits(generation)
    }

    /// The worker stopped over the request of this generation, or over any: the side stays with finite elements.
    pub fn worker_died(&mut self, generation: Option<u64>, reason: &Message) {
        if self.pending_request.is_lost(generation) {
            self.pending_request.forget();
            self.stopped = Some(reason.clone());
        }
    }

    /// Accepts a response; returns the prepared side with its equation, or with the reason why there is none.
    pub fn accept(
        &mut self,
        outline: &Preparation<OutlineRequest>,
        generation: u64,
        response: Response,
    ) -> Option<PreparedSide> {
        let last = self.pending_request.take_in(generation, response)?;
        let spec = self.pending_request.end()?;
        let (Response::Equation(equation), Some(side)) = (last, outline.prepared()) else { return None };
        let is_of_this = outline.good().is_some_and(|good| good.spec == spec);
        is_of_this.then(|| side.with_equation(equation.and_then(|arrays| read(&spec, arrays))))
    }
}

/// The equation from its arrays and the outline's curve, which do not travel together.
fn read(spec: &DomainSpec, arrays: Transfer) -> Result<BoundaryEquation, Unsharpened> {
    let curve = spec.outline.curve()?;
    arrays.into_equation(curve.curve()).ok_or(Unsharpened::Apart)
}
