//! The Cauchy–Green or exact images of a map, computed chunk by chunk so that a large mesh does not block a frame.

use super::cauchy_green::{BoundaryValues, CauchyGreen, CauchyGreenMode, STORED_BYTES};
use super::exact_images::ExactImages;
use super::{ConformalMap, MeshedDomain};
use crate::geometry::DVec2;
use crate::laplace::Deadline;
use std::ops::ControlFlow;
use std::sync::Arc;
use web_time::Instant;

/// The progress of replacing harmonic images by others.
#[derive(Debug, Default)]
pub(super) struct Refinement {
    coordinates: Option<CauchyGreen>,
    values: BoundaryValues,
    pending: Pending,
}

/// The images that are to be replaced.
#[derive(Debug, Default)]
enum Pending {
    /// None, or none any more.
    #[default]
    Nothing,
    /// By Cauchy–Green ones, from this vertex on.
    CauchyGreen(usize),
    /// By exact ones, not begun.
    ExactDue,
    /// By exact ones.
    Exact(Box<ExactImages>),
}

impl Refinement {
    /// Ends the replacement. The stored coordinates are kept.
    pub(super) fn clear(&mut self) {
        self.pending = Pending::Nothing;
    }

    /// Restarts with the boundary images `values` of `domain`. Coordinates of the same domain are kept.
    pub(super) fn restart(&mut self, domain: &Arc<MeshedDomain>, values: &[DVec2]) {
        if !self.coordinates.as_ref().is_some_and(|known| Arc::ptr_eq(known.domain(), domain)) {
            self.coordinates = Some(CauchyGreen::new(Arc::clone(domain), STORED_BYTES));
        }
        self.values.set(values);
        self.pending = Pending::CauchyGreen(0);
    }

    /// Restarts with exact images.
    pub(super) fn restart_exactly(&mut self) {
        self.pending = Pending::ExactDue;
    }

    /// Replaces images of `map` by exact ones for about `budget_ms`, if those are asked for; returns whether that is
    /// complete, as it is at once with finite elements on a side.
    pub(super) fn advance_exactly(&mut self, map: &ConformalMap, images: &mut [DVec2], budget_ms: f64) -> bool {
        let deadline = Deadline::in_ms(budget_ms);
        if matches!(self.pending, Pending::ExactDue) {
            let begun = ExactImages::begin(map).map(Box::new);
            self.pending = begun.map_or(Pending::Nothing, Pending::Exact);
        }
        let Pending::Exact(exact) = &mut self.pending else { return true };
        let is_complete = exact.advance(map, images, deadline);
        if is_complete {
            self.pending = Pending::Nothing;
        }
        is_complete
    }

    /// Replaces images for about `budget_ms` (at least one chunk); returns whether all are replaced.
    pub(super) fn advance(&mut self, images: &mut [DVec2], budget_ms: f64) -> bool {
        let (Pending::CauchyGreen(next), Some(coordinates)) = (&mut self.pending, &mut self.coordinates) else {
            return true;
        };
        if *next < images.len() {
            let start = Instant::now();
            let mut go_on = |_| {
                let in_time = start.elapsed().as_secs_f64() * 1e3 < budget_ms;
                if in_time { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
            };
            *next = coordinates.advance(*next, &self.values, images, &mut go_on);
        }
        *next == images.len()
    }

    /// Replaces all images, in f64, without storing coordinates; `progress` is called with the completed fraction.
    pub(super) fn finish_exactly(&mut self, images: &mut [DVec2], progress: &mut dyn FnMut(f64)) {
        let (Pending::CauchyGreen(next), Some(coordinates)) = (&mut self.pending, &self.coordinates) else { return };
        let mut exact = CauchyGreen::new(Arc::clone(coordinates.domain()), 0);
        let mut go_on = |done| {
            progress(done);
            ControlFlow::Continue(())
        };
        *next = exact.advance(0, &self.values, images, &mut go_on);
    }

    /// The fraction of the vertices whose images are replaced; 1 if none is to be replaced.
    pub(super) fn progress(&self, vertices: usize) -> f64 {
        let done = match &self.pending {
            Pending::Nothing => vertices,
            Pending::CauchyGreen(next) => *next,
            Pending::ExactDue => 0,
            Pending::Exact(exact) => exact.done(),
        };
        if vertices == 0 { 1.0 } else { done as f64 / vertices as f64 }
    }

    /// Whether the coordinates are stored or computed; `None` if they were never needed.
    pub(super) fn mode(&self) -> Option<CauchyGreenMode> {
        self.coordinates.as_ref().map(CauchyGreen::mode)
    }

    /// Takes the coordinates of `old` if they belong to the same domain.
    pub(super) fn adopt(&mut self, domain: &Arc<MeshedDomain>, old: Self) {
        if old.coordinates.as_ref().is_some_and(|known| Arc::ptr_eq(known.domain(), domain)) {
            self.coordinates = old.coordinates;
        }
    }
}
