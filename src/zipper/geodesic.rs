//! The elementary maps of the geodesic algorithm, on the upper half-plane H.
//!
//! D. E. Marshall & S. Rohde, "Convergence of a variant of the zipper algorithm for
//! conformal mapping", SIAM J. Numer. Anal. 45 (2007), section 1: the complement of
//! the first arc goes to H by i√((z − z₁)/(z − z₀)) if it is straight; then the geodesic of H from 0
//! to the image a of the next point is removed by f_a(z) = √((z/(1 − z/b))² + c²), with
//! b = |a|²/re a, c = |a|²/im a, which sends a to 0. After the last point, the
//! geodesic from 0 to the image ζ of z₀ closes the curve: w = z/(1 − z/ζ) makes it a
//! straight line, and −w² takes the part to its left to H.
//!
//! Here the first arc is that of the circle through three points z₀, z₁, z₂, for which the map is
//! i√(−T(z)/T(z₁)), T(z) = (z − z₂)/(z − z₀), so that a circle is mapped exactly.
//!
//! Only f_a up to a Möbius map of H matters. The one used here avoids cancellation: with
//! S² = (z − a)(z − ā), the root on the side of z, and ρ = (re a/|a|)²,
//!
//! f(z) = (|a|/im a) S (S + z) / (S + (1 − 2ρ) z + re a),
//!
//! which is f_a/(1 + f_a im a/(|a| b)), keeps ∞ and is nearly the identity far from a small arc
//! (f_a moves everything there to −b). Then the interior point is moved back to i, with the tip
//! fixed at 0. Harmonic measure from x is therefore always an angle, arctan t/π, which
//! shrinks as the curve grows: crowding loses digits only of parts with little harmonic measure from x.

use crate::exact::{Complex, sqrt};
use std::f64::consts::{FRAC_PI_2, TAU};

/// If im a/|a| is smaller, it is rounding error. A point at such an angle has a
/// harmonic measure of that order. Rounding: 1e-14 after 400 maps of a circle; signal: about 1e-6 for a
/// spike with a width of 1e-6 of the samples' distance.
const FLAT: f64 = 1e-13;

/// Squares of smaller numbers underflow.
const TINY: f64 = 1e-140;

/// A point of R ∪ {∞}: x/y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LinePoint {
    pub x: f64,
    pub y: f64,
}

impl LinePoint {
    pub const TIP: Self = Self { x: 0.0, y: 1.0 };

    /// The point x/y, with x and y scaled to the order of 1.
    fn new(x: f64, y: f64) -> Self {
        let scale = 1.0 / (x.abs() + y.abs());
        Self { x: scale * x, y: scale * y }
    }
}

/// The Möbius map of H that keeps 0 and takes ξ to i: u ↦ (im ξ/|ξ|²) u/(1 − u re ξ/|ξ|²).
#[derive(Debug, Clone, Copy)]
struct Recentre {
    scale: f64,
    shift: f64,
}

impl Recentre {
    /// `None` if ξ is not in H.
    fn at(xi: Complex) -> Option<Self> {
        let squared = xi.re * xi.re + xi.im * xi.im;
        let recentre = Self { scale: xi.im / squared, shift: xi.re / squared };
        (recentre.scale > 0.0 && recentre.scale.is_finite() && recentre.shift.is_finite()).then_some(recentre)
    }

    /// The image of n/d.
    fn quotient(self, n: Complex, d: Complex) -> Complex {
        (self.scale * n) / (d - self.shift * n)
    }

    fn line(self, n: f64, d: f64) -> LinePoint {
        LinePoint::new(self.scale * n, d - self.shift * n)
    }
}

/// The map of the complement of the first arc, from z₀ through z₁ to z₂, to H; z₂ goes to 0, x to i.
#[derive(Debug, Clone, Copy)]
pub(super) struct FirstArc {
    from: Complex,
    to: Complex,
    /// −1/T(z₁).
    factor: Complex,
    recentre: Recentre,
}

impl FirstArc {
    /// `None` if x lies on the arc, or two of the points coincide.
    pub fn new([from, middle, to]: [Complex; 3], x: Complex) -> Option<Self> {
        let factor = -((middle - from) / (middle - to));
        let plain = Self { from, to, factor, recentre: Recentre { scale: 1.0, shift: 0.0 } };
        let recentre = Recentre::at(plain.map(x))?;
        Some(Self { recentre, ..plain })
    }

    pub fn map(&self, z: Complex) -> Complex {
        let root = sqrt(self.factor * ((z - self.to) / (z - self.from)));
        self.recentre.quotient(Complex::I * root, Complex::ONE)
    }

    /// The images of the left sides of z₀, z₁ and z₂; before x is moved to i they are ∞, −1 and 0.
    pub fn line(&self) -> [LinePoint; 3] {
        [self.recentre.line(1.0, 0.0), self.recentre.line(-1.0, 1.0), LinePoint::TIP]
    }
}

/// f for one point, followed by the map that moves x back to i.
#[derive(Debug, Clone, Copy)]
pub(super) struct Geodesic {
    a: Complex,
    /// 1 − 2ρ = (im² a − re² a)/|a|².
    tilt: f64,
    /// |a|/im a.
    stretch: f64,
    recentre: Recentre,
}

/// Why the geodesic to a point cannot be removed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum NoGeodesic {
    /// The point coincides with the real line or with the tip, up to rounding.
    Collapsed,
    /// The geodesic runs through the interior point.
    ThroughInterior,
}

impl Geodesic {
    pub fn to(a: Complex) -> Result<Self, NoGeodesic> {
        let size = a.norm();
        let resolved = size > TINY && size < 1.0 / TINY && a.im > FLAT * size;
        if !resolved {
            return Err(NoGeodesic::Collapsed);
        }
        let recentre = Recentre { scale: 1.0, shift: 0.0 };
        let tilt = (a.im - a.re) / size * ((a.im + a.re) / size);
        let plain = Self { a, tilt, stretch: size / a.im, recentre };
        let (n, d) = plain.fraction(Complex::I);
        let recentre = Recentre::at(n / d).ok_or(NoGeodesic::ThroughInterior)?;
        Ok(Self { recentre, ..plain })
    }

    pub fn map(&self, z: Complex) -> Complex {
        let (n, d) = self.fraction(z);
        self.recentre.quotient(n, d)
    }

    /// f(z) as numerator and denominator. The root S is the one with re(S z̄) ≥ 0, so that S + z does not cancel.
    fn fraction(&self, z: Complex) -> (Complex, Complex) {
        let root = sqrt((z - self.a) * (z - self.a.conj()));
        let root = if root.re * z.re + root.im * z.im >= 0.0 { root } else { -root };
        (self.stretch * (root * (root + z)), root + self.tilt * z + Complex::from(self.a.re))
    }

    /// The image of a point of the real line; for 0, the image of the left side of the geodesic.
    pub fn map_line(&self, t: LinePoint) -> LinePoint {
        let (re, im) = (t.x - self.a.re * t.y, self.a.im * t.y);
        let side = if t.x == 0.0 { -t.y } else { t.x };
        let root = (re * re + im * im).sqrt().copysign(side);
        let n = self.stretch * root * (root + t.x);
        self.recentre.line(n, t.y * (root + self.tilt * t.x + self.a.re * t.y))
    }
}

/// The last map, from H minus the geodesic from 0 to ζ > 0 to the disk; i is mapped to 0 and ζ to 1.
///
/// With v = −w², it is (v − v_i)/(v − v̄_i), expanded to a form that does not cancel for small ζ:
/// (z − i)(ζz + i(ζ − 2z))(ζ + i)² / ((z + i)(ζz − i(ζ − 2z))(ζ − i)²).
#[derive(Debug, Clone, Copy)]
pub(super) struct Closing {
    zeta: Complex,
}

impl Closing {
    /// `None` if i is not to the left of the geodesic from 0 to ζ, that is unless 0 < ζ < ∞.
    pub fn new(zeta: LinePoint) -> Option<Self> {
        let value = zeta.x / zeta.y;
        (value > 0.0 && value.is_finite()).then_some(Self { zeta: Complex::from(value) })
    }

    pub fn map(&self, z: Complex) -> Complex {
        let (zeta, i) = (self.zeta, Complex::I);
        let turn = i * (zeta - 2.0 * z);
        let first = (z - i) / (z + i);
        let second = (zeta * z + turn) / (zeta * z - turn);
        let third = (zeta + i) / (zeta - i);
        first * second * (third * third)
    }

    /// The argument of the image of a boundary point, counter-clockwise from the image of ζ.
    pub fn angle(&self, t: LinePoint) -> f64 {
        let zeta = self.zeta.re;
        let last = self.zeta + Complex::I;
        let half = Complex::new(t.x, -t.y) * Complex::new(zeta * t.x, zeta * t.y - 2.0 * t.x) * (last * last);
        let half = half.arg();
        // the half angle is in [0, π], where rounding may turn π to −π
        2.0 * if half < -FRAC_PI_2 { half + TAU } else { half }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn samples() -> impl Iterator<Item = Complex> {
        (0..60).map(|k| {
            let k = f64::from(k);
            Complex::new((0.7 * k + 0.3).sin() * 3.0, 0.05 + 0.04 * k)
        })
    }

    #[test]
    fn geodesic_map_is_the_published_one_up_to_the_return_of_x() {
        for a in [Complex::new(0.4, 0.3), Complex::new(-2.0, 0.1), Complex::new(0.0, 0.5)] {
            let map = Geodesic::to(a).unwrap();
            let published = |z: Complex| {
                let squared = a.norm().powi(2);
                let (b, c) = (squared / a.re, squared / a.im);
                let w = z / (Complex::ONE - (1.0 / b) * z);
                let root = sqrt(w * w + Complex::from(c * c));
                if root.im < 0.0 { -root } else { root }
            };
            let recentre = Recentre::at(published(Complex::I)).unwrap();
            for z in samples() {
                let (actual, expected) = (map.map(z), recentre.quotient(published(z), Complex::ONE));
                assert!(
                    (actual - expected).norm() < 1e-11 * (1.0 + expected.norm()),
                    "{a:?}, {z:?}: {actual:?}, {expected:?}"
                );
                assert!(actual.im > 0.0, "{z:?} leaves the half-plane: {actual:?}");
            }
            assert!((map.map(Complex::I) - Complex::I).norm() < 1e-14, "x moves");
            assert!(map.map(a).norm() < 1e-14, "the tip is not at 0");
        }
    }

    #[test]
    fn line_is_the_limit_of_the_half_plane() {
        for a in [Complex::new(0.4, 0.3), Complex::new(-2.0, 0.1)] {
            let map = Geodesic::to(a).unwrap();
            for t in [-7.0, -1.0, -0.2, 0.3, 0.9, 5.0] {
                let line = map.map_line(LinePoint { x: t, y: 1.0 });
                let near = map.map(Complex::new(t, 1e-12));
                let value = line.x / line.y;
                assert!((near - Complex::from(value)).norm() < 1e-9 * (1.0 + value * value), "{t}: {value}, {near:?}");
                let flipped = map.map_line(LinePoint { x: -t, y: -1.0 });
                assert!((flipped.x / flipped.y - value).abs() < 1e-14 * value.abs(), "sign of the pair matters at {t}");
            }
        }
    }

    #[test]
    fn closing_takes_its_geodesic_to_the_circle_and_the_line_to_the_angles() {
        for zeta in [1e-9, 0.3, 1.0, 40.0] {
            let closing = Closing::new(LinePoint { x: zeta, y: 1.0 }).unwrap();
            assert!(closing.map(Complex::I).norm() == 0.0);
            assert!((closing.map(Complex::from(zeta)) - Complex::ONE).norm() < 1e-14);
            for k in 1..20 {
                let on = 0.5 * zeta * (Complex::ONE + Complex::cis(0.15 * f64::from(k)));
                assert!((closing.map(on).norm() - 1.0).abs() < 1e-14, "ζ = {zeta}, {on:?}");
            }
            for t in [zeta * 1.001, zeta + 1.0, -5.0, -1.0, -0.1] {
                let angle = closing.angle(LinePoint { x: t, y: 1.0 });
                let image = closing.map(Complex::from(t));
                assert!((image - Complex::cis(angle)).norm() < 1e-13, "ζ = {zeta}, t = {t}: {image:?}, {angle}");
            }
        }
    }

    #[test]
    fn points_on_the_line_are_collapsed() {
        for a in [Complex::ZERO, Complex::new(1.0, 1e-17), Complex::new(1.0, -1.0), Complex::new(f64::NAN, 1.0)] {
            assert_eq!(Geodesic::to(a).unwrap_err(), NoGeodesic::Collapsed);
        }
        assert_eq!(Geodesic::to(Complex::new(0.0, 2.0)).unwrap_err(), NoGeodesic::ThroughInterior);
    }
}
