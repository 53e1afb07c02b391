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
    /// The first vertex that is not replaced yet; `None` if none is to be replaced.
    next: Option<usize>,
    /// The replacement by exact images; not together with `next`.
    exact: Option<ExactImages>,
}

impl Refinement {
    /// Ends the replacement. The stored coordinates are kept.
    pub(super) fn clear(&mut self) {
        (self.next, self.exact) = (None, None);
    }

    /// Restarts with the boundary images `values` of `domain`. Coordinates of the same domain are kept.
    pub(super) fn restart(&mut self, domain: &Arc<MeshedDomain>, values: &[DVec2]) {
        if !self.coordinates.as_ref().is_some_and(|known| Arc::ptr_eq(known.domain(), domain)) {
            self.coordinates = Some(CauchyGreen::new(Arc::clone(domain), STORED_BYTES));
        }
        self.values.set(values);
        (self.next, self.exact) = (Some(0), None);
    }

    /// Restarts with exact images.
    pub(super) fn restart_exactly(&mut self, exact: Option<ExactImages>) {
        (self.next, self.exact) = (None, exact);
    }

    /// Replaces images by exact ones, if those are asked for, for about `budget_ms`; returns whether that is complete.
    pub(super) fn advance_exactly(&mut self, map: &ConformalMap, images: &mut [DVec2], budget_ms: f64) -> bool {
        self.exact.as_mut().is_none_or(|exact| exact.advance(map, images, Deadline::in_ms(budget_ms)))
    }

    /// Replaces images for about `budget_ms` (at least one chunk); returns whether all are replaced.
    pub(super) fn advance(&mut self, images: &mut [DVec2], budget_ms: f64) -> bool {
        let (Some(next), Some(coordinates)) = (&mut self.next, &mut self.coordinates) else { return true };
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
        let (Some(next), Some(coordinates)) = (&mut self.next, &self.coordinates) else { return };
        let mut exact = CauchyGreen::new(Arc::clone(coordinates.domain()), 0);
        let mut go_on = |done| {
            progress(done);
            ControlFlow::Continue(())
        };
        *next = exact.advance(0, &self.values, images, &mut go_on);
    }

    /// The fraction of the vertices whose images are replaced; 1 if none is to be replaced.
    pub(super) fn progress(&self, vertices: usize) -> f64 {
        let done = self.exact.as_ref().map(ExactImages::done).or(self.next);
        done.map_or(1.0, |done| done as f64 / vertices as f64)
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
