//! Fits of functions that are known in closed form.

use super::*;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// A function on a polygon's boundary, or on the unit circle where there are no corners.
struct Given<F: Fn(Complex64) -> Complex64> {
    corners: Vec<Complex64>,
    function: F,
}

impl<F: Fn(Complex64) -> Complex64> Boundary for Given<F> {
    fn rays(&self) -> usize {
        2 * self.corners.len().max(1)
    }

    fn is_singular(&self, _: usize) -> bool {
        !self.corners.is_empty()
    }

    fn pair(&self, ray: usize, offset: f64) -> [Complex64; 2] {
        let z = if self.corners.is_empty() {
            let half = 0.5 * offset * TAU;
            Complex64::from_polar(1.0, if ray == 0 { half } else { -half })
        } else {
            let n = self.corners.len();
            let (from, to) = (self.corners[ray / 2], self.corners[(ray / 2 + 1) % n]);
            if ray.is_multiple_of(2) { from + 0.5 * offset * (to - from) } else { to + 0.5 * offset * (from - to) }
        };
        [z, (self.function)(z)]
    }
}

fn circle<F: Fn(Complex64) -> Complex64>(function: F) -> Given<F> {
    Given { corners: Vec::new(), function }
}

fn fitted(boundary: &dyn Boundary, tolerance: f64) -> Fit {
    let inside = |z: Complex64| z.norm() < 1.0;
    fitted_in(boundary, tolerance, &inside)
}

fn fitted_in(boundary: &dyn Boundary, tolerance: f64, inside: &dyn Fn(Complex64) -> bool) -> Fit {
    let started = web_time::Instant::now();
    let fit = Fit::new(boundary, inside, Goal { tolerance, degree: 250, precision: Precision::Double }, &mut |_| true)
        .unwrap();
    println!(
        "degree {}, error {:.1e} of {:.1e}, poles {}, {:.0} ms",
        fit.function().degree(),
        fit.error(),
        fit.extent(),
        fit.poles().len(),
        1e3 * started.elapsed().as_secs_f64()
    );
    assert!(fit.poles().iter().all(|&pole| !inside(pole)), "no pole inside");
    fit
}

#[test]
fn a_moebius_map_has_degree_one_and_its_own_pole() {
    let a = Complex64::new(0.4, -0.3);
    let moebius = |z: Complex64| (z - a) / (1.0 - a.conj() * z);
    let fit = fitted(&circle(moebius), 1e-12);
    assert_eq!(fit.function().degree(), 1);
    assert!(fit.error() < 1e-14, "{:e}", fit.error());
    assert!((fit.poles()[0] - 1.0 / a.conj()).norm() < 1e-12, "{:?}", fit.poles());
}

#[test]
fn the_exponential_is_fitted_on_the_circle_with_few_poles() {
    let fit = fitted(&circle(Complex64::exp), 1e-12);
    assert!(fit.function().degree() <= 9 && fit.error() <= 1e-12 * fit.extent(), "{:e}", fit.error());
    let z = Complex64::new(0.3, 0.6);
    assert!((fit.function().at(z) - z.exp()).norm() < 1e-12);
}

#[test]
fn the_tangent_of_a_multiple_shows_its_poles() {
    // poles at ±π/2.6, outside of the circle
    let fit = fitted(&circle(|z| (1.3 * z).tan()), 1e-10);
    let pole = Complex64::new(std::f64::consts::FRAC_PI_2 / 1.3, 0.0);
    let off = fit.poles().iter().map(|z| (z - pole).norm()).fold(f64::INFINITY, f64::min);
    assert!(off < 1e-8, "{off:e}");
}

#[test]
fn roots_at_the_corners_of_a_polygon_are_fitted_to_ten_digits() {
    let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    let corners: Vec<Complex64> = corners.iter().map(|&(x, y)| Complex64::new(x, y)).collect();
    let reentrant = corners[3];
    // analytic inside: the cut of the power points out of the notch
    let function = move |z: Complex64| ((z - reentrant) * Complex64::from_polar(1.0, TAU * 3.0 / 8.0)).powf(2.0 / 3.0);
    let inside = |z: Complex64| z.re > 0.0 && z.im > 0.0 && z.re < 2.0 && z.im < 2.0 && !(z.re >= 1.0 && z.im >= 1.0);
    let fit = fitted_in(&Given { corners, function }, 1e-10, &inside);
    assert!(fit.error() <= 1e-10 * fit.extent(), "{:e}", fit.error());
    let z = Complex64::new(0.9, 0.95);
    assert!((fit.function().at(z) - function(z)).norm() < 1e-10 * fit.extent());
}

#[test]
fn the_inverse_of_a_polynomial_map_is_fitted() {
    // z = w + 0.12 w⁵: the circle's image is the boundary, its values the circle
    struct Inverse;
    impl Boundary for Inverse {
        fn rays(&self) -> usize {
            2
        }
        fn is_singular(&self, _: usize) -> bool {
            false
        }
        fn pair(&self, ray: usize, offset: f64) -> [Complex64; 2] {
            let half = 0.5 * offset * TAU;
            let w = Complex64::from_polar(1.0, if ray == 0 { half } else { -half });
            [w + 0.12 * w.powu(5), w]
        }
    }
    let inside = |z: Complex64| z.norm() < 0.88;
    let fit = fitted_in(&Inverse, 1e-10, &inside);
    assert!(fit.error() <= 1e-10, "{:e}", fit.error());
    for k in 0..40 {
        let w = Complex64::from_polar(0.97, f64::from(k));
        let off = (fit.function().at(w + 0.12 * w.powu(5)) - w).norm();
        assert!(off < 1e-10, "{off:e} inside");
    }
}

/// For given poles both ways give the function back, with the poles asked for, whatever the support points.
#[test]
fn a_function_with_given_poles_is_interpolated_and_fitted() {
    let poles = [Complex64::new(1.2, 0.3), Complex64::new(-0.2, -1.1), Complex64::new(1.0, 1.0)];
    let function = move |z: Complex64| poles.iter().map(|pole| (z - pole).inv()).sum::<Complex64>() + z;
    let samples = samples::Samples::new(&circle(function), 1e-10, f64::EPSILON);
    let support: Vec<Complex64> =
        samples.points.iter().step_by(samples.points.len() / 7).map(|point| point.z).collect();
    let by_values = fixed_poles::interpolated(&samples, support.clone(), &poles);
    let by_squares = fixed_poles::fitted(&samples, 1e-10, support, &poles);
    for found in [by_values, by_squares] {
        let z = Complex64::new(0.3, -0.5);
        let off = (found.at(z) - function(z)).norm();
        assert!(off < 1e-12, "{off:e}");
        for pole in poles {
            let off = found.poles().iter().map(|found| (found - pole).norm()).fold(f64::INFINITY, f64::min);
            assert!(off < 1e-11, "{pole}: {off:e}");
        }
    }
}

#[test]
fn noise_leaves_no_pole_inside_and_an_error_that_is_said() {
    let noise = |z: Complex64| 1e-6 * (1e5 * z.re).sin();
    let fit = fitted(&circle(|z: Complex64| z.exp() + noise(z)), 1e-10);
    assert!(fit.error() > 1e-10 && fit.error() < 1e-4, "{:e}", fit.error());
}

#[test]
fn a_fit_ends_when_it_is_cancelled() {
    let goal = Goal { tolerance: 1e-10, degree: 100, precision: Precision::Double };
    let mut steps = 0;
    let result = Fit::new(&circle(Complex64::exp), &|z| z.norm() < 1.0, goal, &mut |_| {
        steps += 1;
        steps < 4
    });
    assert_eq!((result, steps), (Err(Cancelled), 4));
}

#[test]
fn a_fit_ends_while_poles_are_removed_too() {
    let goal = Goal { tolerance: 1e-10, degree: 100, precision: Precision::Double };
    let noise = |z: Complex64| z.exp() + 1e-6 * (1e5 * z.re).sin();
    let mut is_removing = false;
    let result = Fit::new(&circle(noise), &|z| z.norm() < 1.0, goal, &mut |done| {
        is_removing = done == 1.0;
        !is_removing
    });
    assert!(result == Err(Cancelled) && is_removing);
}

#[test]
fn in_single_precision_five_digits_hold_in_f32() {
    let goal = Goal { tolerance: 1e-5, degree: 100, precision: Precision::Single };
    let fit = Fit::new(&circle(|z| (1.3 * z).tan()), &|z| z.norm() < 1.0, goal, &mut |_| true).unwrap();
    println!("degree {}, error {:.1e}", fit.function().degree(), fit.error());
    assert!(fit.digits() >= 5, "{:e}", fit.error());
    let z = Complex64::new(0.3, -0.6);
    assert!((fit.function().at_single(z) - (1.3 * z).tan()).norm() < 1e-5 * fit.extent());
    assert_eq!(fit.function(), &fit.function().rounded());
}

/// Points whose squares overflow in single precision leave no number, and such a value has no digit.
#[test]
fn what_single_precision_cannot_hold_has_no_digit() {
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)].map(|(x, y)| Complex64::new(1e25 * x, 1e25 * y));
    let large = Given { corners: corners.to_vec(), function: |z: Complex64| (1e-25 * z).tan() };
    let goal = Goal { tolerance: 1e-5, degree: 100, precision: Precision::Single };
    let fit = Fit::new(&large, &|z| z.re.abs().max(z.im.abs()) < 1e25, goal, &mut |_| true).unwrap();
    assert!(fit.digits() == 0 && fit.error().is_infinite(), "{:e}", fit.error());
}
