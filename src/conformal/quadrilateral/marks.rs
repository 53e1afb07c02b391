//! Four marks on a boundary, in counter-clockwise cyclic order.

use super::QuadrilateralError;

/// Four fractions of a boundary's length in [0, 1), distinct and in counter-clockwise cyclic order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Marks([f64; 4]);

/// Marks nearer to each other than this fraction of the boundary are one point.
const APART: f64 = 1e-14;

impl Marks {
    /// Takes fractions modulo 1. Errors: one is not finite, two neighbors are one point, or the order is another one.
    pub fn new(fractions: [f64; 4]) -> Result<Self, QuadrilateralError> {
        if let Some(k) = fractions.iter().position(|s| !s.is_finite()) {
            return Err(QuadrilateralError::NotFinite { mark: k + 1 });
        }
        let marks = fractions.map(|s| s.rem_euclid(1.0));
        let steps = [0, 1, 2, 3].map(|k| (marks[(k + 1) % 4] - marks[k]).rem_euclid(1.0));
        if let Some(k) = steps.iter().position(|&step| !(APART..=1.0 - APART).contains(&step)) {
            return Err(QuadrilateralError::Coinciding { marks: [k + 1, (k + 1) % 4 + 1] });
        }
        // the steps add up to the number of turns: the first one that leads beyond the first mark is at fault
        if steps.iter().sum::<f64>() > 1.5 {
            let mut sum = 0.0;
            let beyond = steps.iter().take_while(|&&step| {
                sum += step;
                sum < 1.0
            });
            return Err(QuadrilateralError::Order { mark: beyond.count() + 1 });
        }
        Ok(Self(marks))
    }

    /// The fractions.
    pub fn fractions(&self) -> [f64; 4] {
        self.0
    }
}
