//! The modulus of a quadrilateral from the measures of its four arcs.

use std::f64::consts::PI;

/// The arithmetic–geometric mean of two positive numbers. Converges quadratically, also from 1 and 1e-300.
fn arithmetic_geometric_mean(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..40 {
        if (a - b).abs() <= 4.0 * f64::EPSILON * a {
            break;
        }
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    0.5 * (a + b)
}

/// The extremal distance between the first and the third of four consecutive arcs, given all four harmonic measures.
///
/// With the chords of the disk, λ = sin πω₁ sin πω₃ / (sin π(ω₁+ω₂) sin π(ω₂+ω₃)) is the cross ratio, and
/// 1 − λ = sin πω₂ sin πω₄ / (the same) by Ptolemy's theorem, so that neither cancels. The quadrilateral is a rectangle
/// of sides K(λ), K(1 − λ) in Legendre's parameter, and K(m) = π / 2 agm(1, √(1 − m)). A vanishing arc gives 0 or ∞.
pub fn modulus([first, second, third, fourth]: [f64; 4]) -> f64 {
    let sine = |omega: f64| (PI * omega.max(0.0)).sin();
    let near = sine(first) * sine(third);
    let far = sine(second) * sine(fourth);
    let (lambda, rest) = (near / (near + far), far / (near + far));
    arithmetic_geometric_mean(1.0, rest.sqrt()) / arithmetic_geometric_mean(1.0, lambda.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_modulus_of_four_arcs_is_that_of_the_closed_form() {
        assert!((modulus([0.25; 4]) - 1.0).abs() < 1e-15);
        // marks at the angles (0, .35, .7, 1.25)π
        let m = modulus([0.175, 0.175, 0.275, 0.375]);
        assert!((m - 1.045_465_950_033_828_5).abs() < 1e-14, "{m}");
        for arcs in [[0.1, 0.2, 0.3, 0.4], [1e-9, 0.5, 1e-12, 0.5 - 1e-9], [0.4, 1e-20, 0.6, 1e-3]] {
            let product = modulus(arcs) * modulus([arcs[1], arcs[2], arcs[3], arcs[0]]);
            assert!((product - 1.0).abs() < 1e-14, "{arcs:?}: {product}");
        }
        // K(1 − λ)/K(λ) → log(16/λ)/π for small λ
        let small = modulus([1e-100, 0.5, 1e-100, 0.5]);
        let lambda = (PI * 1e-100).powi(2);
        assert!((small - (16.0_f64.ln() - lambda.ln()) / PI).abs() < 1e-12, "{small}");
    }
}
