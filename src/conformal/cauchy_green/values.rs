//! The boundary images w_k, prepared for the sums over them.
//!
//! Because Σγ_k = 1, f̂ = c + s Σγ_k (w_k − c)/s for any c and s. With c the middle and s the
//! size of the images a constant is reproduced exactly, and f32 represents the rest to 6e-8 of s.

use super::contour::{Contour, over_two_pi_i};
use crate::geometry::{Bounds, DVec2};

/// Values at the vertices of a [`Contour`], linear on its edges.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BoundaryValues {
    centre: DVec2,
    scale: f64,
    /// (w_k + w_{k+1})/2, centred and scaled, by coordinate.
    means: [Vec<f64>; 2],
    /// w_{k+1} − w_k, scaled.
    steps: [Vec<f64>; 2],
    /// w_k, centred and scaled, padded by zeros to the length of a stored row.
    pub(super) singles: [Vec<f32>; 2],
}

impl BoundaryValues {
    /// The values `w_k`.
    pub fn new(values: impl IntoIterator<Item = DVec2>) -> Self {
        let mut result = Self::default();
        result.set(&values.into_iter().collect::<Vec<_>>());
        result
    }

    /// Replaces the values; allocates nothing if there are no more than before.
    pub fn set(&mut self, values: &[DVec2]) {
        let [low, high] = Bounds::of(values.iter().copied()).corners();
        self.centre = low.midpoint(high);
        self.scale = (high - low).max_element();
        let inverse = if self.scale > 0.0 { self.scale.recip() } else { 0.0 };
        let scaled = |w: DVec2| ((w - self.centre) * inverse).to_array();
        for i in 0..2 {
            let next = values.iter().skip(1).chain(values.first());
            self.means[i].clear();
            self.steps[i].clear();
            self.singles[i].clear();
            for (&w, &next) in values.iter().zip(next) {
                let (w, next) = (scaled(w)[i], scaled(next)[i]);
                self.means[i].push(0.5 * (w + next));
                self.steps[i].push(next - w);
                self.singles[i].push(w as f32);
            }
            self.singles[i].resize(super::table::padded(values.len()), 0.0);
        }
    }

    /// The number of values, m.
    pub fn len(&self) -> usize {
        self.means[0].len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The value for the centered and scaled sum.
    pub(super) fn restore(&self, sum: DVec2) -> DVec2 {
        self.centre + self.scale * sum
    }
}

impl Contour {
    /// f̂(z) = Σ_k γ_k(z) w_k in f64, without storing γ: Σ (L (w_k + w_{k+1})/2 − E (w_{k+1} − w_k))/(2πi).
    ///
    /// z on the boundary gives the limit from inside; z must not lie outside.
    pub fn evaluate(&self, z: DVec2, values: &BoundaryValues) -> DVec2 {
        debug_assert_eq!(values.len(), self.len(), "a value per vertex");
        let (mut re, mut im) = (0.0, 0.0);
        self.for_blocks(z, |first, logs, count| {
            let range = first..first + count;
            let (mx, my) = (&values.means[0][range.clone()], &values.means[1][range.clone()]);
            let (sx, sy) = (&values.steps[0][range.clone()], &values.steps[1][range]);
            let ([lx, ly], [ex, ey]) = (&logs.log, &logs.rest);
            // two lanes: the compiler must not reorder a sum by itself
            let mut sums = [[0.0; 2]; 2];
            for k in 0..count {
                let sum = &mut sums[k % 2];
                sum[0] += lx[k] * mx[k] - ly[k] * my[k] - (ex[k] * sx[k] - ey[k] * sy[k]);
                sum[1] += lx[k] * my[k] + ly[k] * mx[k] - (ex[k] * sy[k] + ey[k] * sx[k]);
            }
            re += sums[0][0] + sums[1][0];
            im += sums[0][1] + sums[1][1];
        });
        values.restore(over_two_pi_i(DVec2::new(re, im)))
    }
}
