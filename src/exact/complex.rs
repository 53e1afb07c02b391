//! Complex numbers, as far as the closed forms need them.
//!
//! Branches: [`Complex::ln`], [`Complex::sqrt`] and [`Complex::arg`] are
//! principal, with the cut on the negative real axis.

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec2;

/// `re + i im`.
#[must_use]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Complex {
    /// The real part.
    pub re: f64,
    /// The imaginary part.
    pub im: f64,
}

impl Complex {
    /// 0.
    pub const ZERO: Self = Self::new(0.0, 0.0);
    /// 1.
    pub const ONE: Self = Self::new(1.0, 0.0);
    /// i.
    pub const I: Self = Self::new(0.0, 1.0);

    /// `re + i im`.
    pub const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    /// `e^{iθ}`.
    pub fn cis(theta: f64) -> Self {
        Self::new(theta.cos(), theta.sin())
    }

    /// `|z|`.
    pub fn abs(self) -> f64 {
        self.re.hypot(self.im)
    }

    /// The argument in `(−π, π]`.
    pub fn arg(self) -> f64 {
        self.im.atan2(self.re)
    }

    /// The conjugate.
    pub fn conj(self) -> Self {
        Self::new(self.re, -self.im)
    }

    /// `z²`.
    pub fn square(self) -> Self {
        self * self
    }

    /// `e^z`.
    pub fn exp(self) -> Self {
        self.re.exp() * Self::cis(self.im)
    }

    /// The principal logarithm.
    pub fn ln(self) -> Self {
        Self::new(self.abs().ln(), self.arg())
    }

    /// The root with non-negative real part.
    pub fn sqrt(self) -> Self {
        if self == Self::ZERO {
            return self;
        }
        // The larger of the two halves is computed without cancellation.
        let larger = (0.5 * (self.abs() + self.re.abs())).sqrt();
        let smaller = 0.5 * self.im / larger;
        if self.re >= 0.0 { Self::new(larger, smaller) } else { Self::new(smaller.abs(), larger.copysign(self.im)) }
    }

    /// `sin z`.
    pub fn sin(self) -> Self {
        Self::new(self.re.sin() * self.im.cosh(), self.re.cos() * self.im.sinh())
    }

    /// `cos z`.
    pub fn cos(self) -> Self {
        Self::new(self.re.cos() * self.im.cosh(), -self.re.sin() * self.im.sinh())
    }

    /// `tanh z`, without overflow for `|re z| < 350`.
    pub fn tanh(self) -> Self {
        let (a, b) = (2.0 * self.re, 2.0 * self.im);
        let denominator = a.cosh() + b.cos();
        Self::new(a.sinh() / denominator, b.sin() / denominator)
    }

    /// `arg sinh z` in `(−π, π]`, without overflow for any real part.
    pub fn arg_sinh(self) -> f64 {
        self.im.sin().atan2(self.re.tanh() * self.im.cos())
    }
}

impl From<DVec2> for Complex {
    fn from(p: DVec2) -> Self {
        Self::new(p.x, p.y)
    }
}

impl From<Complex> for DVec2 {
    fn from(z: Complex) -> Self {
        Self::new(z.re, z.im)
    }
}

impl From<f64> for Complex {
    fn from(re: f64) -> Self {
        Self::new(re, 0.0)
    }
}

impl Add for Complex {
    type Output = Self;
    fn add(self, w: Self) -> Self {
        Self::new(self.re + w.re, self.im + w.im)
    }
}

impl Sub for Complex {
    type Output = Self;
    fn sub(self, w: Self) -> Self {
        Self::new(self.re - w.re, self.im - w.im)
    }
}

impl Mul for Complex {
    type Output = Self;
    fn mul(self, w: Self) -> Self {
        Self::new(self.re * w.re - self.im * w.im, self.re * w.im + self.im * w.re)
    }
}

impl Mul<Complex> for f64 {
    type Output = Complex;
    fn mul(self, w: Complex) -> Complex {
        Complex::new(self * w.re, self * w.im)
    }
}

impl Div for Complex {
    type Output = Self;
    fn div(self, w: Self) -> Self {
        let scale = 1.0 / (w.re * w.re + w.im * w.im);
        scale * (self * w.conj())
    }
}

impl Neg for Complex {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functions_satisfy_their_identities() {
        for (re, im) in [(0.3, 0.4), (-1.2, 0.7), (2.0, -1.5), (-0.5, -0.1), (0.0, 1.0), (-2.0, 0.0)] {
            let z = Complex::new(re, im);
            let near = |a: Complex, b: Complex| (a - b).abs() < 1e-14 * (1.0 + a.abs());
            assert!(near(z.sqrt().square(), z) && z.sqrt().re >= 0.0, "sqrt {z:?}");
            assert!(near(z.ln().exp(), z), "ln {z:?}");
            assert!(near(z.sin().square() + z.cos().square(), Complex::ONE), "sin² + cos² {z:?}");
            let sinh = 0.5 * (z.exp() - (-z).exp());
            let cosh = 0.5 * (z.exp() + (-z).exp());
            assert!(near(z.tanh(), sinh / cosh), "tanh {z:?}");
            assert!((z.arg_sinh() - sinh.arg()).abs() < 1e-14, "arg sinh {z:?}");
            assert!(near(z * (Complex::ONE / z), Complex::ONE), "1/z {z:?}");
        }
    }
}
