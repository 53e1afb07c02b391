//! Chooses the vertices of an outline that are handles: few enough to be grabbed, enough to reshape it.

use super::simplify::simplified_ring;
use crate::geometry::{Bounds, DVec2};

/// An outline with at most this many vertices has a handle at each: it is a polygon drawn point by point.
const ALL_OF: usize = 30;

/// The maximal number of handles: 60 are 15 pixels apart in the smallest outline of a viewport.
const MOST: usize = 60;

/// The initial tolerance between the polygon of the handles and the outline, as a part of its size.
/// At 0.01 a circle has 16 handles, and a bump of a tenth of its radius still looks round; at 0.004 it has 32.
const FIRST_TOLERANCE: f64 = 0.01;

/// The factor by which the tolerance grows until there are at most [`MOST`] handles.
const GROWTH: f64 = 1.25;

/// A larger turn (20°) at a vertex is a corner: dense polygons of curves turn by at most 0.1.
const SHARP: f64 = 0.35;

/// The indices of the handles' vertices, ascending.
pub(super) fn handles(vertices: &[DVec2]) -> Vec<usize> {
    if vertices.len() <= ALL_OF {
        return (0..vertices.len()).collect();
    }
    let mut tolerance = FIRST_TOLERANCE * Bounds::of(vertices.iter().copied()).size().max_element();
    loop {
        let kept = simplified_ring(vertices, tolerance);
        // a tolerance that is not positive and finite would never grow
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
