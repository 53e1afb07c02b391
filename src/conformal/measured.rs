//! Kernel and measure of one side of a map: those of the last complete update, and those of the update in progress.

use super::HarmonicMeasure;
use crate::outline::BoundaryPoint;

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
}

impl Measured {
    /// A complete kernel and measure.
    pub fn known(kernel: Vec<f64>, measure: HarmonicMeasure) -> Self {
        Self { kernel, measure, ..Self::default() }
    }

    /// Computes the new measure; the new kernel must be complete.
    pub fn set_measure(&mut self, edge_lengths: &[f64], anchor: BoundaryPoint, renewal: Renewal) {
        let kernel = if renewal.kernel { &self.coming_kernel } else { &self.kernel };
        self.coming_measure.set_along(edge_lengths, kernel, anchor);
    }

    /// ω̃ of the update in progress; the present one if it does not change.
    pub fn coming_measure(&self, renewal: Renewal) -> &HarmonicMeasure {
        if renewal.measure { &self.coming_measure } else { &self.measure }
    }

    /// Makes the results of a complete update visible.
    pub fn commit(&mut self, renewal: Renewal) {
        if renewal.kernel {
            std::mem::swap(&mut self.kernel, &mut self.coming_kernel);
        }
        if renewal.measure {
            std::mem::swap(&mut self.measure, &mut self.coming_measure);
        }
    }
}
