//! Where Newton's method begins for pins on a short part of a planar boundary, which the mesh does not resolve.
//!
//! There the domain is nearly a half-plane, with the pins at −a, 0 and b on its edge. The point that sees the three arcs
//! under thirds is the zero in the half-plane of the Hessian of (z + a) z (z − b):
//! z = a b (a − b + i √3 (a + b)) / (2 (a² + a b + b²)).

use crate::conformal::PreparedSide;
use crate::geometry::DVec2;

/// Halvings of the distance from the boundary until the point is inside.
const HALVINGS: i32 = 12;

/// The point next to the part of the boundary that holds all three marks and is shortest; `None` on a surface, or where no
/// such point is inside.
pub fn beside_short_part(prepared: &PreparedSide, marks: [f64; 3]) -> Option<DVec2> {
    if prepared.is_surface() {
        return None;
    }
    // the part begins behind the longest arc
    let arc = |k: usize| (marks[(k + 1) % 3] - marks[k % 3]).rem_euclid(1.0);
    let longest = (0..3).max_by(|&j, &k| arc(j).total_cmp(&arc(k)))?;
    let place = |s: f64| match prepared.curve_boundary() {
        Some(boundary) => boundary.curve().position(boundary.at_fraction(s)),
        None => prepared.boundary_place(prepared.at_fraction(s)).truncate(),
    };
    let [from, middle, to] = [1, 2, 3].map(|k| place(marks[(longest + k) % 3]));
    let along = (to - from).try_normalize()?;
    let (a, b) = (middle.distance(from), to.distance(middle));
    let scale = a * b / (2.0 * (a * a + a * b + b * b));
    let (shift, height) = (scale * (a - b) * along, 3f64.sqrt() * scale * (a + b) * along.perp());
    let places = (0..HALVINGS).map(|k| middle + shift + 0.5f64.powi(k) * height);
    places.into_iter().find(|&x| prepared.contains(x))
}
