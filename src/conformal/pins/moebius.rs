//! Möbius maps of the unit disk onto itself: z ↦ (a z + b)/(b̄ z + ā).

use crate::geometry::DVec3;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// A Möbius map of the disk, with |a|² − |b|² = 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moebius {
    a: Complex64,
    b: Complex64,
}

impl Moebius {
    /// With a and b up to a real factor; `None` if they are those of no map of the disk onto itself.
    fn new(a: Complex64, b: Complex64) -> Option<Self> {
        let size = (a.norm() - b.norm()) * (a.norm() + b.norm());
        (size > 0.0 && size.is_finite()).then(|| Self { a: a / size.sqrt(), b: b / size.sqrt() })
    }

    /// z ↦ e^{i turn} (z + a)/(1 + ā z); `None` unless |a| < 1.
    pub fn small(turn: f64, a: Complex64) -> Option<Self> {
        let half = Complex64::from_polar(1.0, 0.5 * turn);
        Self::new(half, half * a)
    }

    /// The map that takes three points of the circle to three points of the circle in the same order; `None` for another
    /// order, or coinciding points.
    ///
    /// (a z + b)/(b̄ z + ā) is w on the circle where a z + b is a real multiple of √(z w), which is one linear equation
    /// for the parts of a and b.
    pub fn through(from: [Complex64; 3], onto: [Complex64; 3]) -> Option<Self> {
        let equation = |k: usize| {
            let [z, w] = [from[k].arg(), onto[k].arg()];
            let (u, v) = (0.5 * (z - w), 0.5 * (z + w));
            [u.sin(), u.cos(), -v.sin(), v.cos()]
        };
        let [x, y, z] = [0, 1, 2].map(equation);
        // the vector orthogonal to all three
        let minor = |left_out: usize| {
            let columns = (0..4).filter(|&k| k != left_out).map(|k| DVec3::new(x[k], y[k], z[k]));
            let columns: Vec<DVec3> = columns.collect();
            columns[0].cross(columns[1]).dot(columns[2])
        };
        Self::new(Complex64::new(minor(0), -minor(1)), Complex64::new(minor(2), -minor(3)))
    }

    /// This map after another one.
    pub fn after(&self, first: &Self) -> Self {
        Self { a: self.a * first.a + self.b * first.b.conj(), b: self.a * first.b + self.b * first.a.conj() }
    }

    /// The image of the point of the circle at the angle 2πω, as such an ω modulo 1.
    pub fn omega(&self, omega: f64) -> f64 {
        self.apply(Complex64::from_polar(1.0, TAU * omega)).arg() / TAU
    }

    /// The image of a point of the circle.
    pub fn apply(&self, z: Complex64) -> Complex64 {
        let image = (self.a * z + self.b) / (self.b.conj() * z + self.a.conj());
        image / image.norm()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn circle(angles: [f64; 3]) -> [Complex64; 3] {
        angles.map(|angle| Complex64::from_polar(1.0, angle))
    }

    #[test]
    fn three_points_are_taken_to_three_points_and_the_rest_follows() {
        let known = Moebius::small(2.0, Complex64::new(0.3, -0.6)).unwrap();
        for angles in [[0.1, 2.0, 4.0], [6.0, 0.2, 3.0], [5.0, 3.0, 1.0], [0.0, 1e-6, 2e-6]] {
            let from = circle(angles);
            let found = Moebius::through(from, from.map(|z| known.apply(z))).unwrap();
            let z = Complex64::from_polar(1.0, 1.3);
            assert!((found.apply(z) - known.apply(z)).norm() < 1e-3, "{angles:?}");
            for z in from {
                assert!((found.apply(z) - known.apply(z)).norm() < 1e-9, "{angles:?}");
            }
        }
        let [other_order, same] = [[0.1, 4.0, 2.0], [0.1, 0.1, 4.0]].map(circle);
        assert_eq!(Moebius::through(circle([0.1, 2.0, 4.0]), other_order), None);
        assert_eq!(Moebius::through(circle([0.1, 2.0, 4.0]), same), None);
    }

    #[test]
    fn maps_are_composed() {
        let [f, g] = [(0.4, 0.2), (-1.0, 0.9)].map(|(turn, a)| Moebius::small(turn, Complex64::new(a, 0.1)).unwrap());
        let z = Complex64::from_polar(1.0, 2.5);
        assert!((f.after(&g).apply(z) - f.apply(g.apply(z))).norm() < 1e-14);
        assert_eq!(Moebius::small(0.0, Complex64::new(0.0, 1.0)), None);
    }
}
