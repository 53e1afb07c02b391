//! Kernel and measure of one side of a map: those of the last complete update, and those of the update in progress.

use super::curved::SharpMeasure;
use super::{HarmonicMeasure, PreparedSide};
use crate::boundary_integral;
use std::sync::Arc;

/// What an update recomputes on one side. A new kernel implies a new measure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Renewal {
    pub kernel: bool,
    pub measure: bool,
}

/// Kernel and measure in two buffers each, so that no incomplete one is visible.
#[derive(Debug, Default)]
pub(super) struct Measured {
    /// ψ of the last complete update.
    pub kernel: Vec<f64>,
    /// ω̃ of the last complete update.
    pub measure: HarmonicMeasure,
    /// ψ of the update in progress, if it recomputes ψ.
    pub coming_kernel: Vec<f64>,
    coming_measure: HarmonicMeasure,
    /// The measure by the boundary integral, of the last complete update and of the one in progress.
    swept: Option<Arc<boundary_integral::HarmonicMeasure>>,
    pub coming_swept: Option<Arc<boundary_integral::HarmonicMeasure>>,
}

impl Measured {
    /// A complete kernel and measure.
    pub fn known(kernel: Vec<f64>, measure: HarmonicMeasure) -> Self {
        Self { kernel, measure, ..Self::default() }
    }

    /// Computes the new measure from the anchor at fraction `s`; the new kernel must be complete.
    pub fn set_measure(&mut self, side: &PreparedSide, s: f64, renewal: Renewal) {
        let kernel = if renewal.kernel { &self.coming_kernel } else { &self.kernel };
        self.coming_measure.set_along(side.edge_lengths(), kernel, side.at_fraction(s));
        let swept = if renewal.kernel { &self.coming_swept } else { &self.swept };
        if let (Some(boundary), Some(swept)) = (side.curve_boundary(), swept) {
            SharpMeasure::set(side, (boundary, swept), s, None, &mut self.coming_measure);
        }
    }

    /// ω̃ of the update in progress; the present one if it does not change.
    pub fn coming_measure(&self, renewal: Renewal) -> &HarmonicMeasure {
        if renewal.measure { &self.coming_measure } else { &self.measure }
    }

    /// Makes the results of a complete update visible.
    pub fn commit(&mut self, renewal: Renewal) {
        if renewal.kernel {
            std::mem::swap(&mut self.kernel, &mut self.coming_kernel);
            self.swept = self.coming_swept.take();
        }
        if renewal.measure {
            std::mem::swap(&mut self.measure, &mut self.coming_measure);
        }
    }
}
