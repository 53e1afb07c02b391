//! Möbius maps of the unit disk onto itself: z ↦ (a z + b)/(b̄ z + ā).

use crate::geometry::DVec2;
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
    /// With z = v², w = u² on the circle, (a z + b)/(b̄ z + ā) is w where a v + b v̄ = r u for a real r. The left side is a
    /// real linear map of v; it takes the dependency Σ v_k sin(arg v_{k+2} − arg v_{k+1}) = 0 of three directions to that of
    /// their images, which gives the r_k. Nothing cancels where the points are close to each other.
    pub fn through(from: [Complex64; 3], onto: [Complex64; 3]) -> Option<Self> {
        let [v, u] = [from, onto].map(|points| points.map(|z| 0.5 * z.arg()));
        let gap = |angles: [f64; 3], k: usize| (angles[(k + 2) % 3] - angles[(k + 1) % 3]).sin();
        let image = |k: usize| Complex64::from_polar(gap(u, k) / gap(v, k), u[k]);
        // the two directions farthest from each other
        let left_out = (0..3).max_by(|&j, &k| gap(v, j).abs().total_cmp(&gap(v, k).abs()))?;
        let [j, k] = [(left_out + 1) % 3, (left_out + 2) % 3];
        let [p, q] = [j, k].map(image);
        let [s, t] = [j, k].map(|k| Complex64::from_polar(1.0, v[k]));
        let area = Complex64::new(0.0, -2.0 * gap(v, left_out));
        Self::new((p * t.conj() - q * s.conj()) / area, (q * s - p * t) / area)
    }

    /// This map after another one.
    #[must_use]
    pub fn after(&self, first: &Self) -> Self {
        Self { a: self.a * first.a + self.b * first.b.conj(), b: self.a * first.b + self.b * first.a.conj() }
    }

    /// The turn z ↦ e^{i turn} z about 0.
    pub fn turn(turn: f64) -> Self {
        Self { a: Complex64::from_polar(1.0, 0.5 * turn), b: Complex64::ZERO }
    }

    /// The map onto itself without turn that takes `point` to 0, z ↦ (z − p)/(1 − p̄ z); `None` unless |p| < 1.
    pub fn to_middle(point: Complex64) -> Option<Self> {
        Self::small(0.0, -point)
    }

    /// The point half way, by the disk's own distance, from 0 to a point of the disk.
    pub fn half_way(point: Complex64) -> Complex64 {
        point / (1.0 + (1.0 - point.norm_sqr()).max(0.0).sqrt())
    }

    /// The point at the share `t` of the shortest way from one point of the disk to another, by the disk's own distance;
    /// `None` if one is on the circle.
    pub fn along(from: Complex64, to: Complex64, t: f64) -> Option<Complex64> {
        let middle = Self::to_middle(from)?;
        let whole = middle.image(to);
        let distance = Some(whole.norm()).filter(|distance| *distance < 1.0)?;
        let part = if distance > 0.0 { (t * distance.atanh()).tanh() / distance } else { 0.0 };
        Some(middle.inverse().image(whole * part))
    }

    /// How far this map is from another one: how far the one after the inverse of the other moves 0, by the disk's own
    /// distance 2 artanh |z|, plus the angle by which it turns there.
    pub fn distance(&self, other: &Self) -> f64 {
        let between = self.inverse().after(other);
        let turn = (2.0 * between.a.arg()).rem_euclid(TAU);
        2.0 * between.b.norm().asinh() + turn.min(TAU - turn)
    }

    /// The inverse map.
    #[must_use]
    pub fn inverse(&self) -> Self {
        Self { a: self.a.conj(), b: -self.b }
    }

    /// The image of any point of the closed disk.
    pub fn image(&self, z: Complex64) -> Complex64 {
        (self.a * z + self.b) / (self.b.conj() * z + self.a.conj())
    }

    /// The logarithm of the absolute derivative at a point of the closed disk: −2 ln |b̄ z + ā|.
    pub fn log_scale(&self, z: Complex64) -> f64 {
        -(self.b.conj() * z + self.a.conj()).norm_sqr().ln()
    }

    /// The area of the triangle whose corners are the images of three points of the closed disk, negative if clockwise.
    ///
    /// f(z) − f(w) = (z − w)/((b̄ z + ā)(b̄ w + ā)): images close to each other do not cancel.
    pub fn area(&self, [z, u, v]: [Complex64; 3]) -> f64 {
        let [at_z, at_u, at_v] = [z, u, v].map(|point| (self.b.conj() * point + self.a.conj()).inv());
        let (p, q) = ((u - z) * at_u, (v - z) * at_v);
        0.5 * at_z.norm_sqr() * (p.conj() * q).im
    }

    /// The triangle whose corners are the images of three points of the closed disk, moved so that the first one is at 0.
    pub fn triangle(&self, [z, u, v]: [Complex64; 3]) -> [DVec2; 3] {
        let [at_z, at_u, at_v] = [z, u, v].map(|point| (self.b.conj() * point + self.a.conj()).inv());
        let [p, q] = [(u - z) * at_z * at_u, (v - z) * at_z * at_v];
        [DVec2::ZERO, DVec2::new(p.re, p.im), DVec2::new(q.re, q.im)]
    }

    /// The image of the point of the circle at the angle 2πω, as such an ω modulo 1.
    pub fn omega(&self, omega: f64) -> f64 {
        self.apply(Complex64::from_polar(1.0, TAU * omega)).arg() / TAU
    }

    /// The image of a point of the circle.
    pub fn apply(&self, z: Complex64) -> Complex64 {
        let image = self.image(z);
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
    fn a_map_and_its_inverse_are_the_identity_and_its_scale_is_that_of_its_images() {
        let map = Moebius::small(1.2, Complex64::new(-0.5, 0.7)).unwrap();
        let identity = map.inverse().after(&map);
        let z = Complex64::new(0.3, -0.8);
        assert!((identity.image(z) - z).norm() < 1e-15 && identity.distance(&Moebius::turn(TAU)) < 1e-15);
        let h = Complex64::new(1e-6, 0.0);
        let slope = (map.image(z + h) - map.image(z - h)).norm() / 2e-6;
        assert!((slope.ln() - map.log_scale(z)).abs() < 1e-9, "{slope}");
        let half = Moebius::half_way(z);
        let left = Moebius::to_middle(half).unwrap().image(z).norm();
        assert!((left - half.norm()).abs() < 1e-15, "{left} is left of {half}");
        let part = Moebius::along(z, Complex64::new(-0.2, 0.1), 0.25).unwrap();
        let far = |w: Complex64| Moebius::to_middle(z).unwrap().image(w).norm().atanh();
        assert!((far(part) - 0.25 * far(Complex64::new(-0.2, 0.1))).abs() < 1e-14, "{part}");
        let moved = Moebius::to_middle(z).unwrap().distance(&Moebius::turn(0.0));
        assert!((moved - 2.0 * z.norm().atanh()).abs() < 1e-14, "{moved}");
    }

    #[test]
    fn three_points_are_taken_to_three_points_and_the_rest_follows() {
        let known = Moebius::small(2.0, Complex64::new(0.3, -0.6)).unwrap();
        // an error of rounding in the points is divided by the square of their distance elsewhere
        for (angles, elsewhere) in
            [([0.1, 2.0, 4.0], 1e-13), ([6.0, 0.2, 3.0], 1e-13), ([5.0, 3.0, 1.0], 1e-13), ([0.0, 1e-4, 2e-4], 1e-6)]
        {
            let from = circle(angles);
            let found = Moebius::through(from, from.map(|z| known.apply(z))).unwrap();
            let off = |z: Complex64| (found.apply(z) - known.apply(z)).norm();
            let rest = off(Complex64::from_polar(1.0, 1.3));
            println!("{angles:?}: {:?}, elsewhere {rest:e}", from.map(off));
            assert!(rest < elsewhere && from.into_iter().all(|z| off(z) < 1e-11), "{angles:?}");
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
