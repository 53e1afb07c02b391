//! Closed forms on the unit disk: Poisson kernel, harmonic measure, Möbius maps (sections 1.2 and 3.1).

use super::Complex;
use std::f64::consts::TAU;

/// `P_x(t) = (1 − |x|²) / (2π |p(t) − x|²)`, p(t) = e^{it}: the Poisson kernel per unit of arc length.
pub fn poisson_kernel(x: Complex, t: f64) -> f64 {
    let (distance, radius) = ((Complex::cis(t) - x).norm(), x.norm());
    (1.0 - radius * radius) / (TAU * distance * distance)
}

/// The harmonic measure at `x` of the arc from angle 0 to `t` in `[0, 2π]`:
/// `(2θ − t)/2π`, θ in `[0, 2π]` the angle at x between p(0) and p(t).
pub fn harmonic_measure(x: Complex, t: f64) -> f64 {
    if t <= 0.0 || t >= TAU {
        return f64::from(u8::from(t > 0.0));
    }
    // p(t) − x over p(0) − x has argument θ or θ − 2π; at a boundary angle strictly
    // between 0 and 2π, θ is strictly between 0 and 2π too
    let argument = ((Complex::cis(t) - x) / (Complex::ONE - x)).arg();
    let theta = if argument < 0.0 { argument + TAU } else { argument };
    (2.0 * theta - t) / TAU
}

/// `φ(z) = (a − z)(1 − āb) / ((a − b)(1 − āz))`: the disk to itself, a → 0 and b → 1 (|b| = 1).
pub fn moebius(a: Complex, b: Complex, z: Complex) -> Complex {
    (a - z) * (Complex::ONE - a.conj() * b) / ((a - b) * (Complex::ONE - a.conj() * z))
}

/// The map of the paper's Figure 7, `f(z) = (1 − 5i + 6iz) / (6 + (−5 + i)z)`:
/// 0.6 + 0.2i → −0.5i and 1 → 1.
pub fn figure_7(z: Complex) -> Complex {
    (Complex::new(1.0, -5.0) + Complex::new(0.0, 6.0) * z) / (Complex::new(6.0, 0.0) + Complex::new(-5.0, 1.0) * z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measure_is_the_integral_of_the_kernel() {
        let x = Complex::new(0.6, 0.2);
        let steps = 20_000;
        let width = TAU / f64::from(steps);
        let mut sum = 0.0;
        for k in 0..steps {
            let t = width * (f64::from(k) + 0.5);
            sum += width * poisson_kernel(x, t);
            let error = (harmonic_measure(x, t + 0.5 * width) - sum).abs();
            assert!(error < 1e-6, "t = {t}: error {error:e}");
        }
    }

    #[test]
    fn figure_7_takes_the_constraints_to_their_images() {
        let (x, y) = (figure_7(Complex::new(0.6, 0.2)), figure_7(Complex::ONE));
        assert!((x - Complex::new(0.0, -0.5)).norm() < 1e-15, "{x:?}");
        assert!((y - Complex::ONE).norm() < 1e-15, "{y:?}");
    }

    #[test]
    fn figure_7_is_a_quotient_of_the_papers_normalisations() {
        let (a, b) = (Complex::new(0.6, 0.2), Complex::new(0.0, -0.5));
        let z = Complex::new(-0.3, 0.45);
        let left = moebius(a, Complex::ONE, z);
        let right = moebius(b, Complex::ONE, figure_7(z));
        assert!((left - right).norm() < 1e-14, "{left:?} and {right:?}");
    }
}
