//! One side of the quadrilateral: harmonic measure along it as a function of the place on the rectangle's side.
//!
//! Let a, b, c, d be the marks in order, from a side's first one on, ω_ab … the measures of the arcs, and
//! σ_xy = sin πω_xy half a chord of the disk. sn² takes the rectangle [0, K] × [0, K′] to the upper half-plane and a, b, c,
//! d to 0, 1, 1/m, ∞, so that at u = tK on the side ab, with φ = πω_ap and γ = πω_ab,
//!
//! sin φ / sin(γ − φ) = (σ_da/σ_bd) sc²(tK | m) = ρ Θ(t)²,  ρ² = σ_ac σ_da/(σ_bc σ_bd),  Θ = (1 − m)^{1/4} sc.
//!
//! Θ is a quotient of theta functions of the ratio K′/K alone, Θ(½) = 1 and Θ(1 − t) = 1/Θ(t): from b the same formulas
//! hold with 1/ρ. No step cancels where γ ≤ π/2, as it is from the middle of the quadrilateral.

use std::f64::consts::PI;

/// A side of the quadrilateral.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct QuadrilateralSide {
    /// π times the measure of the side.
    gamma: f64,
    /// ρ.
    balance: f64,
    /// K′/K: the length of the neighboring sides of the rectangle over that of this one.
    ratio: f64,
}

/// An end of a side.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SideEnd {
    Start,
    Finish,
}

/// The sides of a quadrilateral whose arcs have these harmonic measures and whose rectangle has this modulus, the length
/// of the sides 2 and 4 over that of the sides 1 and 3.
pub fn sides(arcs: [f64; 4], modulus: f64) -> [QuadrilateralSide; 4] {
    let sine = |omega: f64| (PI * omega).sin();
    let [a, b, c, d] = arcs.map(sine);
    // of both ways from one mark to the opposite one, the smaller measure is right in proportion to itself
    let chord = |k: usize| sine((arcs[k] + arcs[k + 1]).min(arcs[k + 2] + arcs[(k + 3) % 4]));
    let [ac, bd] = [chord(0), chord(1)];
    // the diagonals take turns
    let squares = [ac * d / (b * bd), bd * a / (c * ac), ac * b / (d * bd), bd * c / (a * ac)];
    std::array::from_fn(|k| QuadrilateralSide {
        gamma: PI * arcs[k],
        balance: squares[k].sqrt(),
        ratio: if k % 2 == 0 { modulus } else { modulus.recip() },
    })
}

impl QuadrilateralSide {
    /// The measure between an end and the place at the share `t` in [0, ½] of the rectangle's side from that end.
    pub fn measure(&self, end: SideEnd, t: f64) -> f64 {
        self.measure_of(end, theta(self.ratio, t).powi(2))
    }

    /// The measure between an end and the point with this value of Θ².
    pub fn measure_of(&self, end: SideEnd, square: f64) -> f64 {
        let quotient = square * self.balance_from(end);
        let (sin, cos) = self.gamma.sin_cos();
        (quotient * sin).atan2(1.0 + quotient * cos) / PI
    }

    /// The share of the rectangle's side between an end and the point with the measure `omega` from it; `None` beyond ½.
    pub fn share(&self, end: SideEnd, omega: f64) -> Option<f64> {
        let phi = PI * omega;
        let square = phi.sin() / (self.balance_from(end) * (self.gamma - phi).sin());
        (0.0..=1.0).contains(&square).then(|| inverse_theta(self.ratio, square.sqrt()))
    }

    /// ρ: 1 seen from the middle.
    pub fn balance(&self) -> f64 {
        self.balance
    }

    fn balance_from(&self, end: SideEnd) -> f64 {
        if end == SideEnd::Start { self.balance } else { self.balance.recip() }
    }
}

/// Terms of the theta functions: nomes are at most e^{−π}, and the next term is 1e-27.
const TERMS: i32 = 4;

/// Θ(t) for t in [0, ½], which increases from 0 to 1; `ratio` is K′/K.
///
/// With the nome e^{−π ratio} it is θ₁/θ₂ at πt/2; where that is larger than e^{−π}, by Jacobi's imaginary transformation,
/// −i θ₁/θ₄ of the nome e^{−π/ratio} at iy, y = πt/(2 ratio).
fn theta(ratio: f64, t: f64) -> f64 {
    let sign = |n: i32| if n % 2 == 0 { 1.0 } else { -1.0 };
    let order = |n: i32| f64::from(2 * n + 1);
    let pronic = |n: i32| f64::from(n * (n + 1));
    if ratio >= 1.0 {
        let z = 0.5 * PI * t;
        let power = |n: i32| (-PI * ratio * pronic(n)).exp();
        let first: f64 = (0..TERMS).map(|n| sign(n) * power(n) * (order(n) * z).sin()).sum();
        let second: f64 = (0..TERMS).map(|n| power(n) * (order(n) * z).cos()).sum();
        return first / second;
    }
    let (rate, y) = (PI / ratio, 0.5 * PI * t / ratio);
    // 2 sinh(ky) e^{−e} and 2 cosh(ky) e^{−e}, which do not overflow together
    let sinh = |k: f64, e: f64| (k * y - e).exp() * -(-2.0 * k * y).exp_m1();
    let cosh = |k: f64, e: f64| (k * y - e).exp() + (-k * y - e).exp();
    let first: f64 = (0..TERMS).map(|n| sign(n) * sinh(order(n), rate * (pronic(n) + 0.25))).sum();
    let fourth: f64 = (1..=TERMS).map(|n| sign(n) * cosh(2.0 * f64::from(n), rate * f64::from(n * n))).sum();
    first / (1.0 + fourth)
}

/// The t in [0, ½] with this Θ, by bisection to neighboring numbers.
fn inverse_theta(ratio: f64, value: f64) -> f64 {
    let (mut low, mut high) = (0.0, 0.5);
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if theta(ratio, middle) <= value {
            low = middle;
        } else {
            high = middle;
        }
    }
}
