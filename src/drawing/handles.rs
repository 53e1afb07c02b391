//! Which vertices of an outline are handles: few enough to be grabbed, enough to reshape it by.

use super::simplify::simplified_ring;
use crate::geometry::{Bounds, DVec2};

/// An outline with so few vertices has a handle at each of them: it is a polygon that someone has set.
const ALL_OF: usize = 30;

/// The most handles that are made: 60 of them are 15 pixels apart in a viewport's smallest outline.
const MOST: usize = 60;

/// How far the chain of the handles may be from the outline, as a part of its size.
/// At 0.01 a circle has 16 handles, and a bump of a tenth of its radius still looks round; at 0.004 it has 32.
const FIRST_TOLERANCE: f64 = 0.01;

/// What the tolerance grows by until there are no more than [`MOST`].
const GROWTH: f64 = 1.25;

/// A turn by more than this at a vertex (20°) is a corner: dense polygons of curves turn by 0.1 at most.
const SHARP: f64 = 0.35;

/// The indices of the vertices that are handles, ascending.
pub(super) fn handles(vertices: &[DVec2]) -> Vec<usize> {
    if vertices.len() <= ALL_OF {
        return (0..vertices.len()).collect();
    }
    let mut tolerance = FIRST_TOLERANCE * Bounds::of(vertices.iter().copied()).size().max_element();
    loop {
        let kept = simplified_ring(vertices, tolerance);
        // a tolerance that is not positive and finite grows no more
        if kept.len() <= MOST || !(tolerance > 0.0 && tolerance.is_finite()) {
            return kept;
        }
        tolerance *= GROWTH;
    }
}

/// Whether the outline turns sharply at a vertex.
pub(super) fn is_sharp(vertices: &[DVec2], k: usize) -> bool {
    let n = vertices.len();
    let (p, q, r) = (vertices[(k + n - 1) % n], vertices[k], vertices[(k + 1) % n]);
    (q - p).angle_to(r - q).abs() > SHARP
}
