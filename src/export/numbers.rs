//! The numbers of a map: its boundary correspondence as CSV.

use crate::conformal::{ConformalMap, Side};
use crate::outline::BoundaryPoint;
use std::fmt::Write as _;

/// The boundary correspondence: pairs of boundary points that are mapped to each other.
///
/// One row for each boundary vertex of the mapped side, counter-clockwise from the anchor y: s₁ and s₂, the fractions
/// of the boundaries' lengths from their first points; both positions, in the plane or in space; the harmonic measure
/// ω̃ from the anchor, equal on both sides; with a boundary integral on both, the estimated error of the image. ω̃ never decreases; neither do s₁ and s₂, except for one step from 1 to 0.
pub fn boundary_csv(map: &ConformalMap) -> String {
    let mapped = map.mapped_side();
    let measure = map.measure(mapped);
    let mut text = String::from("s1 (share of arc length),s2 (share of arc length)");
    for (side, k) in Side::BOTH.into_iter().zip(1..) {
        for axis in axes(map.side(side).is_surface()) {
            let _ = write!(text, ",{axis}{k} ({side} units)");
        }
    }
    text.push_str(",harmonic measure (from 0 to 1)");
    let estimate = map.error_estimate();
    if estimate.is_some() {
        let _ = write!(text, ",error ({} units)", mapped.other());
    }
    text.push('\n');
    for k in measure.vertices() {
        let (point, image) = (BoundaryPoint::new(k as u32, 0.0), map.correspondence().points()[k]);
        let at = |side: Side| if side == mapped { point } else { image };
        let fraction = |side: Side| match map.correspondence().on_curve(k) {
            Some((point, _)) if side != mapped => map.image_fraction(point),
            _ => map.side(side).fraction_at(at(side)),
        };
        let [s1, s2] = Side::BOTH.map(fraction);
        let _ = write!(text, "{s1},{s2}");
        for side in Side::BOTH {
            let place = match map.correspondence().on_curve(k) {
                Some((_, place)) if side != mapped => place.extend(0.0),
                _ => map.side(side).boundary_place(at(side)),
            };
            for (value, _) in place.to_array().iter().zip(axes(map.side(side).is_surface())) {
                let _ = write!(text, ",{value}");
            }
        }
        let _ = write!(text, ",{}", measure.at_vertex(k));
        if let Some(estimate) = &estimate {
            let _ = write!(text, ",{:e}", estimate.points[k]);
        }
        text.push('\n');
    }
    text
}

fn axes(in_space: bool) -> &'static [&'static str] {
    if in_space { &["x", "y", "z"] } else { &["x", "y"] }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
