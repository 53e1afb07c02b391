//! Domains whose map from the unit disk is known in closed form.

use riemap::conformal::{KernelMode, PrepareSettings, PreparedSide, prepare_curve};
use riemap::exact::{Complex, complex, point};
use riemap::geometry::{Curve, CurvePoint, DVec2, Piece, SimplePolygon};
use riemap::outline::{CurveForm, Interpretation};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// A map g from the unit disk onto a domain.
#[derive(Debug, Clone, Copy)]
pub enum Closed {
    /// w + a w^k.
    Power { a: f64, k: i32 },
    /// w/(1 − a w) + b w².
    Rational { a: f64, b: f64 },
    /// The digon with vertices ±1 between two circular arcs, or lines: (1 + z)/(1 − z) has the arguments from `from` to
    /// from + α π.
    Digon { alpha: f64, from: f64 },
}

fn power(z: Complex, exponent: f64) -> Complex {
    Complex::from_polar(z.norm().powf(exponent), z.arg() * exponent)
}

impl Closed {
    /// g(w).
    pub fn place(self, w: Complex) -> Complex {
        match self {
            Self::Power { a, k } => w + a * w.powi(k),
            Self::Rational { a, b } => w / (Complex::from(1.0) - a * w) + b * w * w,
            Self::Digon { alpha, from } => {
                // the disk onto the right half-plane, the wedge around the real axis, and back
                let half = (Complex::from(1.0) + w) / (Complex::from(1.0) - w);
                let wedge = power(half, alpha) * Complex::from_polar(1.0, from + 0.5 * alpha * PI);
                (wedge - 1.0) / (wedge + 1.0)
            }
        }
    }

    /// g′(w).
    pub fn slope(self, w: Complex) -> Complex {
        match self {
            Self::Power { a, k } => Complex::from(1.0) + a * f64::from(k) * w.powi(k - 1),
            Self::Rational { a, b } => (Complex::from(1.0) - a * w).powi(-2) + 2.0 * b * w,
            Self::Digon { alpha, from } => {
                let half = (Complex::from(1.0) + w) / (Complex::from(1.0) - w);
                let wedge = power(half, alpha) * Complex::from_polar(1.0, from + 0.5 * alpha * PI);
                let rate = 2.0 * alpha / ((Complex::from(1.0) - w) * (Complex::from(1.0) + w));
                2.0 * wedge * rate / ((wedge + 1.0) * (wedge + 1.0))
            }
        }
    }

    /// R at g(w).
    pub fn radius(self, w: Complex) -> f64 {
        self.slope(w).norm() * (1.0 - w.norm_sqr())
    }

    /// The curve and a polygon of its points: of a digon exactly, otherwise the spline through n points on it.
    pub fn curve(self, n: usize) -> (SimplePolygon, Curve) {
        let at = |k: usize, n: usize| point(self.place(Complex::from_polar(1.0, TAU * k as f64 / n as f64)));
        let Self::Digon { from, alpha } = self else {
            let polygon = SimplePolygon::try_from((0..n).map(|k| at(k, n)).collect::<Vec<_>>()).unwrap();
            let form = CurveForm { interpretation: Interpretation::Smooth, ..CurveForm::default() };
            let curve = form.curve(&polygon).unwrap();
            assert!(curve.is_smooth());
            return (polygon, curve.into_curve());
        };
        let curve = Curve::new(vec![arc(from, false), arc(from + alpha * PI, true)]).unwrap();
        let place = |k: u32| {
            let t = 0.5 * (1.0 - (f64::from(k % 200) / 200.0 * PI).cos());
            curve.position(CurvePoint::new(k as usize / 200, t))
        };
        (SimplePolygon::try_from((0..400).map(place).collect::<Vec<_>>()).unwrap(), curve)
    }

    pub fn prepared(self, n: usize, near: Complex) -> Arc<PreparedSide> {
        let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
        let (polygon, curve) = self.curve(n);
        Arc::new(prepare_curve((&polygon, &curve), &[point(near)], &settings, &mut |_| ()).unwrap())
    }

    /// The w of a place, from the nearest of a grid by Newton's method.
    pub fn inverse(self, z: DVec2) -> Complex {
        let z = complex(z);
        if let Self::Digon { alpha, from } = self {
            let wedge = (Complex::from(1.0) + z) / (Complex::from(1.0) - z);
            let half = power(wedge * Complex::from_polar(1.0, -from - 0.5 * alpha * PI), 1.0 / alpha);
            return if half.is_finite() { (half - 1.0) / (half + 1.0) } else { Complex::from(1.0) };
        }
        let grid = (0..1600).map(|k| Complex::from_polar(f64::from(k / 80 + 1) / 20.0, TAU * f64::from(k % 80) / 80.0));
        let start = grid.min_by(|a, b| (self.place(*a) - z).norm().total_cmp(&(self.place(*b) - z).norm()));
        (0..30).fold(start.unwrap(), |w, _| w - (self.place(w) - z) / self.slope(w))
    }
}

/// The arc of the z with arg (1 + z)/(1 − z) = θ in (−π, π), from −1 to 1 or back.
fn arc(theta: f64, is_back: bool) -> Piece {
    let ends = [DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0)];
    // above the real axis for θ > 0: the peak is i tan(θ/2), the center i (tan² − 1)/(2 tan)
    let peak = (0.5 * theta).tan();
    if peak.abs() < 1e-12 {
        return Piece::Line(if is_back { [ends[1], ends[0]] } else { ends });
    }
    let center = DVec2::new(0.0, 0.5 * (peak - 1.0 / peak));
    let radius = 1.0 / theta.sin().abs();
    // seen from the center, half of the arc takes |θ|
    let middle = 0.5 * PI * peak.signum();
    // clockwise from −1 to 1 above the axis, counter-clockwise below it
    let [start, end] = [middle + theta, middle - theta];
    let [from, to] = if is_back { [end, start] } else { [start, end] };
    Piece::circular(center, radius, from, to)
}

/// The harmonic measure of the arc of the unit circle from angle a counter-clockwise to b, from w.
pub fn measure(w: Complex, a: f64, b: f64) -> f64 {
    let angle = |t: f64| {
        let unit = Complex::from_polar(1.0, t);
        ((unit - w) / (Complex::from(1.0) - w.conj() * unit)).arg()
    };
    if b - a >= TAU { 1.0 } else { (angle(b) - angle(a)).rem_euclid(TAU) / TAU }
}
