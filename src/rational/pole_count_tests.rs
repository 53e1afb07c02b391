//! Poles that are known, and those of fits, are counted.

use super::fitting::Fitting;
use super::function::{Rational, weights_of_poles};
use super::pole_count::{Unresolved, poles_inside};
use super::samples::Samples;
use super::tests::{Given, circle};
use super::{Boundary, Fit, Goal, Precision};
use crate::geometry::sort_by_number;
use num_complex::Complex64;

const L_SHAPE: [(f64, f64); 6] = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];

fn l_shape<F: Fn(Complex64) -> Complex64>(function: F) -> Given<F> {
    Given { corners: L_SHAPE.map(|(x, y)| Complex64::new(x, y)).to_vec(), function }
}

/// The count for a function of these poles, whose support points are next to them.
fn counted(boundary: &dyn Boundary, poles: &[Complex64]) -> Result<u32, Unresolved> {
    counted_from(boundary, poles, poles)
}

/// The same with support points that are the samples next to these places, one for each pole, and the first sample.
fn counted_from(boundary: &dyn Boundary, places: &[Complex64], poles: &[Complex64]) -> Result<u32, Unresolved> {
    let samples = Samples::new(boundary, 1e-10, f64::EPSILON);
    let mut free: Vec<Complex64> = samples.points.iter().map(|point| point.z).collect();
    let mut support = vec![free.remove(0)];
    for place in places {
        sort_by_number(&mut free, |z| (z - place).norm());
        support.push(free.remove(0));
    }
    let weights = weights_of_poles(&support, poles);
    poles_inside(&Rational::new(support.clone(), support, weights), boundary, &samples)
}

#[test]
fn poles_inside_are_counted_among_those_outside() {
    let circle = circle(Complex64::exp);
    let inside: Vec<Complex64> =
        (0..12).map(|k| Complex64::from_polar(0.08 * f64::from(k), 2.4 * f64::from(k))).collect();
    let outside: Vec<Complex64> =
        (0..9).map(|k| Complex64::from_polar(1.02 + 0.3 * f64::from(k), 1.9 * f64::from(k))).collect();
    for count in 0..=inside.len() {
        let poles = [&inside[..count], &outside].concat();
        assert_eq!(counted(&circle, &poles), Ok(count as u32), "{count} of {}", poles.len());
    }
    let double = [inside[5], inside[5], outside[2]];
    assert_eq!(counted(&circle, &double), Ok(2), "a double pole counts twice");
}

/// Poles 1e-8 before and behind the edges, the circle, and each corner of the L-shape.
#[test]
fn poles_next_to_the_boundary_are_on_their_side() {
    const NEAR: f64 = 1e-8;
    let round = circle(Complex64::exp);
    for k in 0..40 {
        let on_circle = Complex64::from_polar(1.0, 0.1571 * f64::from(k) + 0.01);
        assert_eq!(counted(&round, &[on_circle * (1.0 - NEAR)]), Ok(1), "inside at {on_circle}");
        assert_eq!(counted(&round, &[on_circle * (1.0 + NEAR)]), Ok(0), "outside at {on_circle}");
    }
    let shape = l_shape(Complex64::exp);
    let corners = &shape.corners;
    for (k, &corner) in corners.iter().enumerate() {
        let [before, next] = [corners[(k + 5) % 6], corners[(k + 1) % 6]].map(|z| (z - corner) / (z - corner).norm());
        // into the L at its convex corners, into the notch at the reentrant one
        let is_reentrant = k == 3;
        let diagonal = NEAR * (before + next);
        assert_eq!(counted(&shape, &[corner + diagonal]), Ok(u32::from(!is_reentrant)), "corner {k}");
        assert_eq!(counted(&shape, &[corner - diagonal]), Ok(u32::from(is_reentrant)), "corner {k}");
        let on_edge = corner + 0.37 * next;
        let left = NEAR * Complex64::I * next;
        assert_eq!(counted(&shape, &[on_edge + left, on_edge - left]), Ok(1), "edge {k}");
    }
}

/// Clusters of poles at a corner, and support points as far from it as each of them, as fits have them; and one pole
/// inside.
#[test]
fn poles_that_cluster_at_a_corner_are_counted() {
    let shape = l_shape(Complex64::exp);
    let inwards = Complex64::new(1.0, 1.0);
    let places: Vec<Complex64> = (0..24).map(|k| 10f64.powf(-0.5 * f64::from(k)) * inwards).collect();
    let cluster: Vec<Complex64> = places.iter().map(|place| -place).collect();
    assert_eq!(counted_from(&shape, &places, &cluster), Ok(0));
    for distance in [1e-1, 1e-3, 1e-6, 1e-9] {
        let inside = distance * inwards;
        let [places, poles] = [&places, &cluster].map(|list| [&list[..], &[inside]].concat());
        assert_eq!(counted_from(&shape, &places, &poles), Ok(1), "{distance:e} from the corner");
    }
}

#[test]
fn a_pole_on_the_boundary_leaves_the_count_open_and_is_named() {
    let shape = l_shape(Complex64::exp);
    let pole = Complex64::new(0.73, 0.0);
    let Err(Unresolved(place)) = counted(&shape, &[pole, Complex64::new(3.0, 3.0)]) else { panic!("counted") };
    assert!((place - pole).norm() < 1e-12, "{place} for {pole}");
}

/// On noise AAA leaves dozens of poles inside, and each one is counted.
#[test]
fn poles_that_noise_leaves_inside_are_counted() {
    let noisy = noisy();
    let mut fitting = Fitting::new(&noisy, GOAL);
    let function = fitting.converge(&mut |_| true).unwrap();
    let computed = function.poles().iter().filter(|pole| pole.norm() < 1.0).count();
    println!("{computed} of {} computed poles are inside", function.poles().len());
    assert!(computed > 10, "{computed}");
    assert_eq!(poles_inside(&function, &noisy, &fitting.samples), Ok(computed as u32));
}

/// Before any pole is removed, powers at a corner leave one inside or none, among up to 140 that cluster there: as many as
/// are computed.
#[test]
fn poles_of_fits_to_powers_at_a_corner_are_counted() {
    let shift = Complex64::new(1.3, 0.7);
    let mut all = Vec::new();
    for (corner, turn, power) in
        [(0, -45.0_f64, 2.0 / 3.0), (0, -45.0, 0.5), (0, -45.0, 0.2), (3, 135.0, 2.0 / 3.0), (3, 135.0, 0.2)]
    {
        let (x, y) = L_SHAPE[corner];
        let rotation = Complex64::cis(turn.to_radians());
        // analytic inside: the cut points away from the corner
        let function = move |z: Complex64| ((z - shift - Complex64::new(x, y)) * rotation).powf(power);
        let shape = Given { corners: L_SHAPE.map(|(x, y)| Complex64::new(x, y) + shift).to_vec(), function };
        let mut fitting = Fitting::new(&shape, Goal { tolerance: 1e-8, degree: 250, ..GOAL });
        let function = fitting.converge(&mut |_| true).unwrap();
        let computed = function.poles().iter().filter(|&&pole| is_in_l_shape(pole - shift)).count();
        println!("z^{power:.2} at corner {corner}: degree {}, {computed} inside", function.degree());
        assert_eq!(poles_inside(&function, &shape, &fitting.samples), Ok(computed as u32));
        all.push(computed);
    }
    assert!(all.contains(&0) && all.contains(&1), "{all:?}");
}

fn is_in_l_shape(z: Complex64) -> bool {
    z.re.min(z.im) > 0.0 && z.re.min(z.im) < 1.0 && z.re.max(z.im) < 2.0
}

/// Where computed poles are taken for ones outside, the count still finds those inside, and they are removed.
#[test]
fn poles_that_are_placed_on_the_wrong_side_are_removed() {
    let fit = Fit::new(&noisy(), &|_| false, GOAL, &mut |_| true).unwrap();
    let inside = fit.poles().iter().filter(|pole| pole.norm() < 1.0).count();
    println!("degree {}, {inside} poles inside, error {:e}", fit.function().degree(), fit.error());
    assert_eq!((fit.poles_inside(), inside), (Some(0), 0));
    assert!(fit.error() < 1e-5, "{:e}", fit.error());
}

/// A pole that the function has itself cannot be removed: what is left has no digit.
#[test]
fn a_function_with_a_pole_inside_has_no_digit() {
    let pole = Complex64::new(0.3, -0.2);
    let fit = Fit::new(&circle(|z| (z - pole).inv()), &|_| false, GOAL, &mut |_| true).unwrap();
    assert!(fit.poles().iter().all(|found| found.norm() > 1.0) && fit.digits() == 0, "{:e}", fit.error());
}

const GOAL: Goal = Goal { tolerance: 1e-10, degree: 60, precision: Precision::Double };

fn noisy() -> Given<impl Fn(Complex64) -> Complex64> {
    circle(|z: Complex64| z.exp() + 1e-6 * (1e5 * z.re).sin())
}

/// p′/p = D′/D + Σ 1/(z − z_k) is Σ 1/(z − p_j) over all poles: none is missing among the computed ones, and none is there
/// twice.
#[test]
fn the_computed_poles_are_those_of_the_denominator() {
    let root = |z: Complex64| (z + Complex64::new(1e-9, 1e-9)).sqrt();
    let fits: [(&str, Fit); 3] = [
        ("tan", fit(&circle(|z| (1.3 * z).tan()), &|z| z.norm() < 1.0)),
        ("exp", fit(&circle(Complex64::exp), &|z| z.norm() < 1.0)),
        ("root", fit(&l_shape(root), &is_in_l_shape)),
    ];
    for (name, fit) in fits {
        for z in [Complex64::new(0.31, 0.42), Complex64::new(0.7, 0.1), Complex64::new(0.05, 0.6)] {
            let by_poles: Complex64 = fit.function().poles().iter().map(|pole| (z - pole).inv()).sum();
            let by_denominator = logarithmic_derivative(fit.function(), z);
            let off = (by_poles - by_denominator).norm() / by_denominator.norm().max(1.0);
            println!("{name}, degree {}: Σ 1/(z − p) = {by_poles}, p′/p = {by_denominator}", fit.function().degree());
            assert!(off < 1e-6, "{name} at {z}: off by {off:e}");
        }
    }
}

fn fit(boundary: &dyn Boundary, inside: &dyn Fn(Complex64) -> bool) -> Fit {
    let goal = Goal { tolerance: 1e-10, degree: 150, precision: Precision::Double };
    let fit = Fit::new(boundary, inside, goal, &mut |_| true).unwrap();
    assert_eq!(fit.poles_inside(), Some(0));
    fit
}

/// p′/p at z for p = D Π (z − z_k).
fn logarithmic_derivative(function: &Rational, z: Complex64) -> Complex64 {
    let [mut value, mut slope, mut sum] = [Complex64::ZERO; 3];
    for (point, weight) in function.support().iter().zip(function.weights()) {
        let inverse = (z - point).inv();
        value += weight * inverse;
        slope -= weight * inverse * inverse;
        sum += inverse;
    }
    slope / value + sum
}
