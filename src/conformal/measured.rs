//! Kernel and measure of one side of a map: those of the last complete update, beside those of the one under way.

use super::HarmonicMeasure;
use crate::outline::BoundaryPoint;

/// What an update makes anew of one side. A new kernel brings a new measure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Renewal {
    pub kernel: bool,
    pub measure: bool,
}

/// Kernel and measure, each twice, so that nobody sees one that is not finished.
#[derive(Debug, Default)]
pub(super) struct Measured {
    /// ψ of the last complete update.
    pub kernel: Vec<f64>,
    /// ω̃ of the last complete update.
    pub measure: HarmonicMeasure,
    /// ψ of the update under way, if it renews that.
    pub coming_kernel: Vec<f64>,
    coming_measure: HarmonicMeasure,
}

impl Measured {
    /// Makes the coming measure, as soon as the coming kernel is there.
    pub fn set_measure(&mut self, edge_lengths: &[f64], anchor: BoundaryPoint, renewal: Renewal) {
        let kernel = if renewal.kernel { &self.coming_kernel } else { &self.kernel };
        self.coming_measure.set_along(edge_lengths, kernel, anchor);
    }

    /// ω̃ of the update under way.
    pub fn coming_measure(&self, renewal: Renewal) -> &HarmonicMeasure {
        if renewal.measure { &self.coming_measure } else { &self.measure }
    }

    /// The update under way is complete.
    pub fn commit(&mut self, renewal: Renewal) {
        if renewal.kernel {
            std::mem::swap(&mut self.kernel, &mut self.coming_kernel);
        }
        if renewal.measure {
            std::mem::swap(&mut self.measure, &mut self.coming_measure);
        }
    }
}
