//! How sharp the map on the screen is: the kernel that each side uses, and the estimate of the error.

use crate::conformal::{ConformalMap, KernelMode, Side};
use crate::language::Message;
use crate::model::Model;
use serde::Serialize;
use web_time::Instant;

/// The kernel of a side in the map that is shown.
#[derive(Debug, Clone, PartialEq)]
pub enum SideKernel {
    /// Finite elements, as requested.
    FiniteElements(KernelMode),
    /// Finite elements, until the factor of the boundary's integral equation arrives.
    Sharpening,
    /// The boundary's integral equation.
    Integral {
        /// The size of its matrix.
        unknowns: usize,
    },
    /// Finite elements although the boundary integral was requested; with the reason.
    Stays(Message),
}

/// Estimates of the largest errors on the boundary of a map: of harmonic measure, and of an image.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ErrorBounds {
    /// Of harmonic measure.
    pub omega: f64,
    /// Of the images of the boundary vertices, in the units of the side that they lie on.
    pub image: f64,
}

/// An estimate that took less is made with every update, else when a drag rests, in ms.
const CHEAP_MS: f64 = 1.0;

/// The last estimate, and the generation of the map that it is of.
#[derive(Debug, Default)]
pub struct Estimated {
    bounds: Option<ErrorBounds>,
    generation: u64,
    milliseconds: f64,
}

impl Estimated {
    fn renew(&mut self, map: Option<&ConformalMap>, generation: u64) {
        let start = Instant::now();
        let estimate = map.and_then(ConformalMap::error_estimate);
        self.bounds = estimate.map(|estimate| ErrorBounds { omega: estimate.omega, image: estimate.image });
        self.generation = generation;
        self.milliseconds = start.elapsed().as_secs_f64() * 1e3;
    }
}

impl Model {
    /// The kernel of a side in the map that is shown; `None` before the side is prepared.
    pub fn side_kernel(&self, side: Side) -> Option<SideKernel> {
        let prepared = self.prepared(side)?;
        let stopped = self.sides[side].sharpening.stopped().filter(|_| prepared.awaits_equation());
        Some(if let Some(integral) = prepared.boundary_integral() {
            SideKernel::Integral { unknowns: integral.unknowns() }
        } else if let Some(reason) = prepared.unsharpened() {
            SideKernel::Stays(Message::from(reason))
        } else if let Some(reason) = stopped {
            SideKernel::Stays(reason.clone())
        } else if prepared.awaits_equation() {
            SideKernel::Sharpening
        } else if prepared.table().is_some() {
            SideKernel::FiniteElements(KernelMode::Table)
        } else {
            SideKernel::FiniteElements(KernelMode::Adjoint)
        })
    }

    /// The estimate of the errors of the map that is shown: while points move, that of the last map that was estimated.
    /// `None` unless both measures are from the boundary integral.
    pub fn error_bounds(&self) -> Option<ErrorBounds> {
        if self.is_draft() { None } else { self.shown.estimated.bounds }
    }

    /// Estimates the errors of the full or the refined map: at once if that is cheap or nothing moves.
    pub(super) fn estimate(&mut self, is_moving: bool) {
        let is_affordable = !is_moving || self.shown.estimated.milliseconds < CHEAP_MS;
        // images of interior vertices have no part in it
        if is_affordable && !self.is_draft() && self.shown.estimated.generation != self.shown.map_generation {
            let shown = &mut self.shown;
            let milliseconds = shown.estimated.milliseconds;
            shown.estimated.renew(self.fine.map().or(shown.map.as_ref()), shown.map_generation);
            if self.fine.map().is_some() {
                // a map that moves is not refined
                shown.estimated.milliseconds = milliseconds;
            }
        }
    }
}
