//! Cauchy's integral of functions that are known everywhere, with and without singular points on the curve.

use super::*;
use crate::geometry::{Jet, Piece};
use std::f64::consts::TAU;

/// A function given by its values at a position and at an offset from one point.
struct Known<'a> {
    curve: &'a Curve,
    /// The piece whose start, or the previous one whose end, is the singular point; then offsets are relative to it.
    corner: usize,
    f: &'a dyn Fn(Complex) -> Complex,
}

impl BoundaryFunction for Known<'_> {
    fn value(&self, at: CurvePoint) -> DVec2 {
        let count = self.curve.pieces().len();
        let corner = self.curve.pieces()[self.corner].jet(0.0).position;
        let piece = &self.curve.pieces()[at.piece()];
        let offset = if at.piece() == self.corner {
            piece.from_start(at.from_start()).position
        } else if (at.piece() + 1) % count == self.corner {
            piece.from_end(at.to_end()).position
        } else {
            self.curve.position(at) - corner
        };
        point((self.f)(complex(offset)))
    }

    fn error(&self, _: CurvePoint) -> f64 {
        0.0
    }
}

fn circle() -> Curve {
    Curve::new(vec![Piece::circular(DVec2::ZERO, 1.0, 0.0, TAU)]).unwrap()
}

fn polygon(corners: &[[f64; 2]]) -> Curve {
    let ends = corners.iter().zip(corners.iter().cycle().skip(1));
    Curve::new(ends.map(|(&a, &b)| Piece::Line([a, b].map(DVec2::from))).collect()).unwrap()
}

fn square() -> Curve {
    polygon(&[[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]])
}

/// Distances from the boundary.
const DISTANCES: [f64; 9] = [0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

#[test]
fn moebius_maps_of_the_disk_are_right_up_to_the_circle() {
    let curve = circle();
    let a = Complex::new(0.6, -0.3);
    let f = |z: Complex| (z - a) / (Complex::ONE - a.conj() * z);
    let f_prime = |z: Complex| (1.0 - a.norm_sqr()) / (Complex::ONE - a.conj() * z).powi(2);
    let offset = |z: Complex| f(z + 1.0);
    let integral = CauchyIntegral::new(&curve, &[], &Known { curve: &curve, corner: 0, f: &offset });
    for k in 0..500 {
        for d in DISTANCES {
            let z = (1.0 - d) * Complex::cis(0.7 * f64::from(k));
            let found = integral.evaluate(point(z));
            let error = (complex(found.value) - f(z)).norm();
            let slope_error = (complex(found.derivative) - f_prime(z)).norm();
            assert_eq!(integral.placement(point(z)), Placement::Inside);
            assert!(
                error < 3e-14 && slope_error < 3e-11,
                "at {z}, {d:e} inside: {error:e}, derivative {slope_error:e}"
            );
            assert!(error <= found.error && found.error < 1e-12, "estimate {:e}", found.error);
        }
    }
}

/// (z − c)^γ on the square with its singular point c in a corner or in the middle of a side.
fn check_powers(curve: &Curve, corner: usize, breaks: &[CurvePoint], tolerance: f64) {
    let c = curve.pieces()[corner].jet(0.0).position;
    for gamma in [0.25, 0.5, 2.0 / 3.0, 1.1, 4.0 / 3.0, 1.9, 2.5] {
        let inward = -complex(c) / c.length();
        let f = |offset: Complex| (offset / inward).powf(gamma);
        let f_prime = |offset: Complex| gamma * (offset / inward).powf(gamma - 1.0) / inward;
        let integral = CauchyIntegral::new(curve, breaks, &Known { curve, corner, f: &f });
        for d in DISTANCES.into_iter().filter(|&d| d >= 1e-9) {
            for turn in [-0.7, -0.3, 0.0, 0.2, 0.7] {
                let z = c + d * point(inward * Complex::cis(turn));
                let offset = complex(z - c);
                let found = integral.evaluate(z);
                let error = (complex(found.value) - f(offset)).norm();
                let relative = (complex(found.derivative) / f_prime(offset) - 1.0).norm();
                assert!(
                    error < tolerance && error <= 3.0 * found.error,
                    "γ = {gamma}, {d:e} from the corner: {error:e}, estimate {:e}",
                    found.error
                );
                assert!(
                    relative < 1e-11 + 1e-14 / d.powf(gamma.max(1.0)),
                    "γ = {gamma}, {d:e} from the corner: derivative {relative:e}"
                );
                assert!(found.error < 1e-10, "estimate {:e}", found.error);
            }
        }
    }
}

#[test]
fn powers_at_a_corner_are_right_next_to_it() {
    check_powers(&square(), 1, &[], 2e-13);
}

#[test]
fn powers_at_a_break_point_are_right_next_to_it() {
    check_powers(&polygon(&[[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 0.0]]), 4, &[], 2e-13);
}

#[test]
fn a_root_at_a_break_point_within_a_piece_is_as_right_as_its_parameter() {
    let curve = square();
    // offsets are relative to the start of the right side
    let f = |offset: Complex| (Complex::I - offset).powf(0.5);
    let integral = CauchyIntegral::new(&curve, &[CurvePoint::new(3, 0.5)], &Known { curve: &curve, corner: 3, f: &f });
    for d in DISTANCES.into_iter().filter(|&d| d >= 1e-8) {
        for turn in [-0.7, 0.0, 1.2] {
            let z = DVec2::X - d * DVec2::from_angle(turn);
            let exact = (Complex::I - complex(z - DVec2::new(1.0, -1.0))).powf(0.5);
            let error = (complex(integral.evaluate(z).value) - exact).norm();
            assert!(error < 1e-13 + 1e-16 / d.sqrt(), "{d:e} from the break point: {error:e}");
        }
    }
}

#[test]
fn points_are_placed() {
    let curve = circle();
    let one = |_: Complex| Complex::ONE;
    let integral = CauchyIntegral::new(&curve, &[], &Known { curve: &curve, corner: 0, f: &one });
    for k in 0..200 {
        let ray = DVec2::from_angle(0.1 * f64::from(k));
        assert!(matches!(integral.placement(ray), Placement::Boundary(_)), "{ray}");
        assert_eq!(integral.placement((1.0 - 1e-12) * ray), Placement::Inside);
        assert_eq!(integral.placement((1.0 + 1e-12) * ray), Placement::Outside);
    }
    assert_eq!(integral.placement(DVec2::new(f64::NAN, 0.0)), Placement::Outside);
}

/// The inverse of z + 0.12 z⁵ on the image of the circle, by its parameter.
struct InverseOfFifthPower;

impl BoundaryFunction for InverseOfFifthPower {
    fn value(&self, at: CurvePoint) -> DVec2 {
        DVec2::from_angle(TAU * at.from_start())
    }

    fn error(&self, _: CurvePoint) -> f64 {
        0.0
    }
}

#[test]
fn a_singular_point_of_the_parametrization_next_to_the_curve_is_resolved() {
    fn jet(s: f64) -> Jet {
        let [one, five] = [Complex::cis(TAU * s), Complex::cis(5.0 * TAU * s)];
        let i = Complex::I * TAU;
        let [first, second] = [i * (one + 0.6 * five), i * i * (one + 3.0 * five)];
        Jet { position: point(one + 0.12 * five), first: point(first), second: point(second) }
    }
    let formula = Piece::Formula { function: jet, from: 0.0, to: 1.0 };
    let curve = Curve::new(vec![formula]).unwrap().analytic_at(0).unwrap();
    let integral = CauchyIntegral::new(&curve, &[], &InverseOfFifthPower);
    for k in 0..500 {
        for d in DISTANCES {
            let z = (1.0 - d) * Complex::cis(0.7 * f64::from(k));
            let found = integral.evaluate(point(z + 0.12 * z.powi(5)));
            let error = (complex(found.value) - z).norm();
            let slope = complex(found.derivative) * (1.0 + 0.6 * z.powi(4));
            assert!(error < 1e-13 && error <= found.error, "at {z}: {error:e}, estimate {:e}", found.error);
            assert!((slope - 1.0).norm() < 1e-9, "at {z}: f′ is off by the factor {slope}");
        }
    }
}
