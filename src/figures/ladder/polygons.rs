//! Polygons with notches and many corners.

use crate::geometry::{DVec2, SimplePolygon};
use std::f64::consts::{PI, TAU};

/// The square of side 2 about 0 with a wedge of this many degrees cut from the middle of its left side to 0, which is its
/// first corner.
pub fn notch(degrees: f64) -> Vec<DVec2> {
    let half = (0.5 * degrees).to_radians().tan();
    let corners = [(0.0, 0.0), (-1.0, -half), (-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (-1.0, half)];
    corners.map(DVec2::from).to_vec()
}

/// Corners on either side of the clef.
const CLEF_CORNERS: u32 = 100;
/// Half of its width.
const CLEF_HALF: f64 = 0.2;

/// The middle of the clef: a spiral of five quarters of a turn, from its inner end at 0 to its outer one at 1.
fn clef_middle(share: f64) -> DVec2 {
    (0.5 + 0.75 * share) * DVec2::from_angle(2.5 * PI * share)
}

/// The point half way along the clef.
pub fn clef_point() -> DVec2 {
    clef_middle(0.5)
}

/// A strip that winds as a clef does, with 200 corners, from the outer side of its inner end on.
pub fn clef() -> Vec<DVec2> {
    let side = |k: u32, offset: f64| {
        let share = f64::from(k) / f64::from(CLEF_CORNERS - 1);
        let along = clef_middle(share + 1e-6) - clef_middle(share - 1e-6);
        clef_middle(share) - offset * along.perp().normalize()
    };
    let outer = (0..CLEF_CORNERS).map(|k| side(k, CLEF_HALF));
    let inner = (0..CLEF_CORNERS).rev().map(|k| side(k, -CLEF_HALF));
    outer.chain(inner).collect()
}

/// A coast: a hexagon whose edges are halved `levels` times, so that it has 6·2ⁿ corners; each midpoint moves sideways by
/// up to `roughness` edges, by a generator with a fixed seed. A level that would cross itself is drawn anew; `None` if none
/// of a thousand does not.
pub fn coast(levels: u32, roughness: f64) -> Option<SimplePolygon> {
    let mut state = 7_u64;
    let mut random = || {
        // Knuth, The Art of Computer Programming, volume 2, section 3.3.4, table 1, line 26
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
    };
    let hexagon = (0..6).map(|k| DVec2::from_angle(TAU * f64::from(k) / 6.0)).collect::<Vec<_>>();
    let mut polygon = SimplePolygon::try_from(hexagon).ok()?;
    for _ in 0..levels {
        let mut finer = || {
            let moved = |(a, b): (DVec2, DVec2)| [a, a.midpoint(b) + 2.0 * roughness * random() * (b - a).perp()];
            polygon.edges().flat_map(moved).collect::<Vec<_>>()
        };
        polygon = (0..1000).find_map(|_| SimplePolygon::try_from(finer()).ok())?;
    }
    Some(polygon)
}
