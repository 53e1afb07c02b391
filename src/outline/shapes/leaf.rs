//! A maple leaf: sharp lobes joined by slightly hollow curves.

use super::super::pen::{Drawn, Pen};
use crate::geometry::DVec2;

/// The left half from the top tip down to the stem: a point, and the angle in
/// degrees by which the arc towards it leaves its chord (negative: hollow).
const HALF: [(f64, f64, f64); 15] = [
    (-0.165, 0.690, -7.0),
    (-0.330, 0.770, -9.0),
    (-0.235, 0.300, 9.0),
    (-0.470, 0.545, -11.0),
    (-0.530, 0.430, -9.0),
    (-0.800, 0.490, -8.0),
    (-0.735, 0.290, -9.0),
    (-0.960, 0.175, -9.0),
    (-0.590, -0.095, -9.0),
    (-0.665, -0.300, -9.0),
    (-0.330, -0.275, -7.0),
    (-0.350, -0.395, -7.0),
    (-0.040, -0.330, 5.0),
    (-0.030, -0.980, 3.0),
    (0.030, -0.980, 0.0),
];

pub(in super::super) fn maple_leaf() -> Drawn {
    let mut pen = Pen::at(DVec2::new(0.0, 1.0));
    for (x, y, degrees) in HALF {
        pen.bow(DVec2::new(x, y), f64::to_radians(degrees));
    }
    // The right half runs upwards: each arc with the next point of the mirror image.
    for k in (0..HALF.len() - 2).rev() {
        let (x, y, _) = HALF[k];
        pen.bow(DVec2::new(-x, y), HALF[k + 1].2.to_radians());
    }
    pen.bow(DVec2::new(0.0, 1.0), HALF[0].2.to_radians());
    pen.close()
}
