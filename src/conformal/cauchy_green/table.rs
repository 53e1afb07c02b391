//! Rows of Γ in f32, real parts before imaginary parts, and their product with the images.
//!
//! The product reads memory once, in order. Lanes of f32 add [`RUN`] terms each, which are then summed
//! in f64: the rounding of γ, 6e-8 of each term, remains the largest error.

use super::contour::Contour;
use super::values::BoundaryValues;
use crate::geometry::DVec2;

/// Sums computed in parallel: a 256-bit register, or two of 128 bits.
const LANES: usize = 8;

/// Terms that a lane adds in f32 before the sum is moved to f64: their rounding is random, below 3e-7 of the lane's
/// sum.
const RUN: usize = 32;

/// m rounded up to a multiple of [`LANES`].
pub(super) fn padded(m: usize) -> usize {
    m.next_multiple_of(LANES)
}

/// The numbers in a stored row: a real and an imaginary part per boundary vertex.
pub(super) fn row_length(m: usize) -> usize {
    2 * padded(m)
}

/// Writes γ(z) into a row (of [`row_length`]).
pub(super) fn fill_row(contour: &Contour, z: DVec2, gamma: &mut Vec<DVec2>, row: &mut [f32]) {
    contour.coordinates(z, gamma);
    let (re, im) = row.split_at_mut(padded(contour.len()));
    for ((re, im), value) in re.iter_mut().zip(im).zip(gamma.iter()) {
        (*re, *im) = (value.x as f32, value.y as f32);
    }
}

/// Σ γ_k w_k for a stored row.
pub(super) fn apply_row(row: &[f32], values: &BoundaryValues) -> DVec2 {
    let (re, im) = row.split_at(row.len() / 2);
    let runs = re.chunks(RUN * LANES).zip(im.chunks(RUN * LANES));
    let [x, y] = &values.singles;
    let images = x.chunks(RUN * LANES).zip(y.chunks(RUN * LANES));
    let sum =
        runs.zip(images).map(|((re, im), (x, y))| run(re, im, x, y)).fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
    values.restore(DVec2::from_array(sum))
}

/// The sum over up to `RUN · LANES` terms.
fn run(re: &[f32], im: &[f32], x: &[f32], y: &[f32]) -> [f64; 2] {
    let (re, im) = (re.as_chunks::<LANES>().0, im.as_chunks::<LANES>().0);
    let (x, y) = (x.as_chunks::<LANES>().0, y.as_chunks::<LANES>().0);
    // four sums rather than two: written as re·x − im·y in one step, the compiler pairs the wrong lanes
    let mut sums = [[0.0_f32; LANES]; 4];
    for (((re, im), x), y) in re.iter().zip(im).zip(x).zip(y) {
        for (sum, (a, b)) in sums.iter_mut().zip([(re, x), (im, y), (re, y), (im, x)]) {
            for i in 0..LANES {
                sum[i] += a[i] * b[i];
            }
        }
    }
    let [re_x, im_y, re_y, im_x] = sums.map(|lanes| lanes.iter().map(|&value| f64::from(value)).sum::<f64>());
    [re_x - im_y, re_y + im_x]
}
