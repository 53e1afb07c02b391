//! Harmonic measure and invariants from the boundary integral equation against exact values.
//!
//! Exact values: OEIS A117240; Bornemann et al., The SIAM 100-Digit Challenge, problem 10; NIST's tables of
//! capacities; Schwarz–Christoffel integrals evaluated to 25 digits; closed forms of disk, blob and V.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use riemap::boundary_integral::{
    BoundaryIntegral, BoundaryIntegralError, Estimate, Invariants, InvariantsRequest, Settings, invariants,
};
use riemap::exact::{Complex, blob, point, vshape};
use riemap::geometry::{Curve, CurvePoint, DVec2, Jet, Piece, SimplePolygon};
use riemap::outline::{CurveForm, Preset};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};

fn polygon(points: &[(f64, f64)]) -> Curve {
    let points: Vec<DVec2> = points.iter().map(|&p| p.into()).collect();
    Curve::from_polygon(&SimplePolygon::try_from(points).unwrap()).unwrap()
}

fn rectangle(width: f64, height: f64) -> Curve {
    polygon(&[(0.0, 0.0), (width, 0.0), (width, height), (0.0, height)])
}

fn regular(n: u32, radius: f64) -> Curve {
    let corner = |k: u32| {
        let p = radius * DVec2::from_angle(TAU * f64::from(k) / f64::from(n));
        (p.x, p.y)
    };
    polygon(&(0..n).map(corner).collect::<Vec<_>>())
}

fn l_shape() -> Curve {
    polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)])
}

fn ellipse(a: f64) -> Curve {
    let axes = [DVec2::new(a, 0.0), DVec2::new(0.0, 1.0)];
    Curve::new(vec![Piece::Arc { center: DVec2::ZERO, axes, from: 0.0, to: TAU }]).unwrap()
}

fn half_disk() -> Curve {
    let diameter = Piece::Line([DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0)]);
    Curve::new(vec![Piece::circular(DVec2::ZERO, 1.0, 0.0, PI), diameter]).unwrap()
}

fn all(curve: &Curve, x: (f64, f64)) -> Invariants {
    invariants(curve, &InvariantsRequest::new(x.into())).unwrap()
}

/// The estimate is right up to `tolerance`, relative to the value, and its error covers what it is off by. `slack` is
/// the rounding of the expected value as it is written here.
fn assert_estimate(name: &str, found: Estimate, expected: f64, tolerance: f64) {
    let off = (found.value - expected).abs();
    println!("{name}: {} for {expected}: off by {off:.1e}, estimated {:.1e}", found.value, found.error);
    assert!(off <= tolerance * expected.abs(), "{name}: {} for {expected}, off by {off:e}", found.value);
    assert!(off <= found.error + f64::EPSILON * expected.abs(), "{name}: off by {off:e}, estimated {:e}", found.error);
    assert!(found.error <= 100.0 * tolerance * expected.abs(), "{name}: an estimate of {:e}", found.error);
}

#[test]
fn rectangles_have_the_harmonic_measures_of_the_series() {
    let ends = |rho: f64| {
        let term = |k: i32| {
            let odd = f64::from(2 * k + 1);
            f64::from(1 - 2 * (k % 2)) / ((0.5 * PI * rho * odd).cosh() * odd)
        };
        4.0 / PI * (0..60).map(term).sum::<f64>()
    };
    assert!((ends(10.0) / 3.837_587_979_251_226e-7 - 1.0).abs() < 1e-15);
    assert!((ends(3.0) - 0.022_873_301_501_334_33).abs() < 1e-16);
    for (rho, tolerance) in [(10.0, 1e-9), (3.0, 1e-13), (1.0, 1e-14), (0.4, 1e-14)] {
        let found = all(&rectangle(rho, 1.0), (0.5 * rho, 0.5));
        for end in [found.pieces[1], found.pieces[3]] {
            assert_estimate(&format!("an end of the {rho}×1 rectangle"), end, 0.5 * ends(rho), tolerance);
        }
    }
}

#[test]
fn regular_polygons_and_rectangles_have_their_radii_and_capacities() {
    let cases = [
        (3, Some(0.566_046_680_363_159_7), 0.421_753_934_648_426_8 * 3.0_f64.sqrt()),
        (4, Some(0.762_759_763_501_813_2), 0.590_170_299_508_048_1 * SQRT_2),
        (6, None, 0.920_371_373_317_942_5),
    ];
    for (n, radius, capacity) in cases {
        let found = all(&regular(n, 1.0), (0.0, 0.0));
        if let Some(radius) = radius {
            assert_estimate(&format!("R of the regular {n}-gon"), found.conformal_radius, radius, 1e-14);
        }
        // the coarser resolution has few panels without a point near: the square's error is 5e-12 where it is off by 1e-16
        assert_estimate(&format!("capacity of the regular {n}-gon"), found.capacity, capacity, 1e-13);
    }
    let found = all(&rectangle(2.0, 1.0), (1.0, 0.5));
    assert_estimate("R of the 2×1 rectangle", found.conformal_radius, 0.631_890_877_749_891_1, 1e-14);
    assert_estimate("its capacity", found.capacity, 0.874_757_278_171_439_9, 1e-13);
}

#[test]
fn ellipses_have_their_radii_and_capacities() {
    for (a, radius) in [(2.0, 1.212_001_445_787_871_8), (4.0, 1.259_500_758_998_134_9)] {
        let found = all(&ellipse(a), (0.0, 0.0));
        assert_estimate(&format!("R of the ellipse {a}"), found.conformal_radius, radius, 1e-14);
        assert_estimate("its capacity", found.capacity, 0.5 * (a + 1.0), 1e-14);
    }
}

#[test]
fn the_l_shape_has_its_invariants() {
    let found = all(&l_shape(), (0.5, 0.5));
    // The arm's end is also given as .01330309202402327, with which the sides have 1 − 2e-14 in all.
    let [long, inner] = [0.394_497_233_238_905_2, 0.092_199_674_737_061_53];
    let end = 0.5 - long - inner;
    let sides = [long, end, inner, inner, end, long];
    for (k, side) in sides.into_iter().enumerate() {
        assert_estimate(&format!("side {k}"), found.pieces[k], side, if side == end { 1e-13 } else { 1e-14 });
    }
    assert_estimate("R", found.conformal_radius, 0.653_579_438_242_370_7, 1e-14);
    assert_estimate("capacity", found.capacity, 1.084_890_390_444_781, 1e-14);
}

fn modulus(curve: &Curve, x: (f64, f64), marks: [CurvePoint; 4]) -> Estimate {
    let request = InvariantsRequest::new(x.into()).with_marks(Some(marks));
    invariants(curve, &request).unwrap().modulus.unwrap()
}

#[test]
fn quadrilaterals_have_their_moduli() {
    let l = l_shape();
    let corners = |k: [usize; 4]| k.map(|k| CurvePoint::new(k, 0.0));
    let x = (0.5, 0.5);
    let ends = modulus(&l, x, corners([1, 2, 4, 5]));
    assert_estimate("L between its arms' ends", ends, 2.558_523_142_342_013, 1e-13);
    assert_estimate(
        "L between (0,0)–(2,0) and (1,2)–(0,2)",
        modulus(&l, x, corners([0, 1, 4, 5])),
        3.0_f64.sqrt(),
        1e-13,
    );
    for marks in [[0, 1, 2, 4], [1, 3, 4, 0], [5, 0, 1, 2]] {
        let [a, b, c, d] = marks;
        let product = modulus(&l, x, corners(marks)).value * modulus(&l, x, corners([b, c, d, a])).value;
        assert!((product - 1.0).abs() < 1e-13, "{marks:?}: M M* = {product}");
    }
    let disk = Preset::Disk.curve().unwrap();
    let marks = [0.0, 0.35, 0.7, 1.25].map(|angle| CurvePoint::new(0, 0.5 * angle));
    for x in [(0.0, 0.0), (0.5, -0.3)] {
        assert_estimate("four arcs of the disk", modulus(&disk, x, marks), 1.045_465_950_033_828_6, 1e-14);
    }
    // crowded: both ends have 2e-7 from the middle
    let long = modulus(&rectangle(10.0, 1.0), (5.0, 0.5), corners([1, 2, 3, 0]));
    assert_estimate("between the ends of the 10×1 rectangle", long, 10.0, 1e-11);
}

#[test]
fn curved_corners_and_tangent_junctions_are_resolved() {
    let found = all(&half_disk(), (0.0, 0.5));
    assert_estimate("R of the half-disk", found.conformal_radius, 0.6, 1e-14);
    assert_estimate("hm of its diameter", found.pieces[1], 0.409_665_529_398_266_9, 1e-14);
    // a rounded square: what two resolutions differ by is no more than the estimate
    let found = all(&rounded_square(), (0.2, 0.1));
    let total: f64 = found.pieces.iter().map(|piece| piece.value).sum();
    assert!((total - 1.0).abs() < 1e-13, "{total}");
    for piece in &found.pieces {
        assert!(piece.error < 1e-12, "{piece:?}");
    }
}

/// The square [−1, 1]² with corners of radius 0.4: curvature jumps eight times.
fn rounded_square() -> Curve {
    let mut pieces = Vec::new();
    for k in 0..4 {
        let turn = DVec2::from_angle(FRAC_PI_2 * f64::from(k));
        let at = |x: f64, y: f64| DVec2::new(x, y).rotate(turn);
        pieces.push(Piece::Line([at(1.0, -0.6), at(1.0, 0.6)]));
        let from = FRAC_PI_2 * f64::from(k);
        pieces.push(Piece::circular(at(0.6, 0.6), 0.4, from, from + FRAC_PI_2));
    }
    Curve::new(pieces).unwrap()
}

#[test]
fn hyperbolic_distances_in_the_disk_are_those_of_the_closed_form() {
    let disk = Preset::Disk.curve().unwrap();
    for (x, y) in [((0.1, 0.2), (-0.5, 0.3)), ((0.9, 0.0), (-0.9, 0.0)), ((0.999, 0.0), (0.0, 0.0))] {
        let (a, b) = (DVec2::from(x), DVec2::from(y));
        let request = InvariantsRequest::new(a).with_second_point(Some(b));
        let found = invariants(&disk, &request).unwrap();
        let ratio = a.distance(b) / DVec2::new(1.0 - a.dot(b), a.perp_dot(b)).length();
        let name = format!("from {x:?} to {y:?}");
        assert_estimate(&name, found.hyperbolic_distance.unwrap(), 2.0 * ratio.atanh(), 1e-12);
        let radius = (1.0 - a.length()) * (1.0 + a.length());
        assert_estimate("R", found.conformal_radius, radius, 1e-12);
    }
}

/// The largest difference, along the boundary, of ω from `x` and a formula, both from parameter 0 of piece 0.
fn worst(curve: &Curve, x: DVec2, exact: impl Fn(DVec2) -> f64) -> (f64, f64) {
    let integral = BoundaryIntegral::prepare(curve, &Settings::default().with_points(&[x])).unwrap();
    let measure = integral.harmonic_measure(x).unwrap();
    let anchored = measure.from_anchor(CurvePoint::new(0, 0.0));
    let mut worst = 0.0_f64;
    for k in 1..3000 {
        let place = curve.point_at_fraction(f64::from(k) / 3000.0);
        let off = (anchored.forward(place) - exact(curve.position(place)) + 0.5).rem_euclid(1.0) - 0.5;
        worst = worst.max(off.abs());
    }
    println!("{} unknowns: {worst:.1e}, estimated {:.1e}", integral.unknowns(), measure.error_estimate());
    (worst, measure.error_estimate())
}

/// arg of the disk automorphism that takes `a` to 0, at e^{2πiω}, over 2π, from ω = 0.
fn disk_measure(a: Complex, omega: f64) -> f64 {
    let image = |z: Complex| (z - a) / (Complex::ONE - a.conj() * z);
    (image(Complex::cis(TAU * omega)) / image(Complex::ONE)).arg().rem_euclid(TAU) / TAU
}

fn quintic(t: f64) -> Jet {
    let (z, fifth) = (Complex::cis(t), 0.12 * Complex::cis(5.0 * t));
    Jet { position: point(z + fifth), first: point(Complex::I * (z + 5.0 * fifth)), second: point(-z - 25.0 * fifth) }
}

#[test]
fn smooth_curves_by_formula_have_ten_digits_along_the_boundary() {
    let v = Preset::VShape.curve().unwrap();
    let tip = DVec2::new(0.96, 0.8432);
    let (off, estimate) = worst(&v, tip, |y| vshape::harmonic_measure(tip, y));
    assert!(off < 1e-11 && off <= estimate && estimate < 1e-9, "V: {off:e}, estimated {estimate:e}");

    let curve = Preset::Blob.curve().unwrap();
    let a = Complex::new(0.2, 0.1);
    let integral_at = point(blob::from_disk(a));
    let integral = BoundaryIntegral::prepare(&curve, &Settings::default().with_points(&[integral_at])).unwrap();
    let measure = integral.harmonic_measure(integral_at).unwrap();
    let anchored = measure.from_anchor(CurvePoint::new(0, 0.0));
    for k in 1..3000 {
        let omega = f64::from(k) / 3000.0;
        let off = anchored.forward(CurvePoint::new(0, omega)) - disk_measure(a, omega);
        assert!(off.abs() < 1e-12, "blob, ω = {omega}: {off:e}");
    }

    let piece = Piece::Formula { function: quintic, from: 0.0, to: TAU };
    let curve = Curve::new(vec![piece]).unwrap().analytic_at(0).unwrap();
    let (off, estimate) = worst(&curve, DVec2::ZERO, quintic_measure);
    assert!(off < 1e-11 && off <= estimate && estimate < 1e-9, "z + 0.12 z⁵: {off:e}, estimated {estimate:e}");
}

/// The place of z + 0.12 z⁵ = y on the unit circle, as a share of the whole.
fn quintic_measure(y: DVec2) -> f64 {
    let target = Complex::new(y.x, y.y);
    let mut z = Complex::cis(target.arg());
    for _ in 0..50 {
        let fourth = z * z * z * z;
        z -= (z + 0.12 * fourth * z - target) / (Complex::ONE + 0.6 * fourth);
    }
    z.arg().rem_euclid(TAU) / TAU
}

/// A name, the curve by its fraction, an interior point, and the measure up to a boundary point.
type Case<'a> = (&'a str, &'a dyn Fn(f64) -> DVec2, DVec2, &'a dyn Fn(DVec2) -> f64);

/// Lists of points of smooth curves, whose splines the panels span: the error falls to 1e-9, and is covered by the
/// estimate although the spline is not the curve.
#[test]
fn dense_lists_of_smooth_curves_have_their_measures() {
    let x = DVec2::new(0.5, 0.2);
    let circle = |s: f64| DVec2::from_angle(TAU * s);
    let of_circle = |y: DVec2| {
        let image = |y: DVec2| {
            let (z, a) = (Complex::new(y.x, y.y), Complex::new(x.x, x.y));
            (z - a) / (Complex::ONE - a.conj() * z)
        };
        (image(y) / image(DVec2::X)).arg().rem_euclid(TAU) / TAU
    };
    let fifth = |s: f64| quintic(TAU * s).position;
    let cases: [Case<'_>; 2] =
        [("disk", &circle, x, &of_circle), ("z + 0.12 z⁵", &fifth, DVec2::ZERO, &quintic_measure)];
    for (name, curve, x, exact) in cases {
        for (n, most) in [(64, 1e-4), (200, 1e-6), (1000, 1e-8), (6000, 1e-9), (100_000, 1e-9)] {
            let points: Vec<DVec2> = (0..n).map(|k| curve(f64::from(k) / f64::from(n))).collect();
            let smooth = CurveForm::default().curve(&SimplePolygon::try_from(points).unwrap()).unwrap();
            let Some(Piece::Spline { spline, .. }) = smooth.curve().pieces().first() else {
                unreachable!("{name}: no spline")
            };
            let integral = BoundaryIntegral::prepare(smooth.curve(), &Settings::default().with_points(&[x])).unwrap();
            let measure = integral.harmonic_measure(x).unwrap();
            let anchored = measure.from_anchor(CurvePoint::new(0, 0.0));
            let off = spline.knots_between([0, spline.len() - 1], [0.0, 1.0]).step_by((n / 1000).max(1) as usize);
            let off = off.map(|(t, k)| {
                let off = anchored.forward(CurvePoint::new(0, t)) - exact(spline.points()[k]);
                ((off + 0.5).rem_euclid(1.0) - 0.5).abs()
            });
            let (off, estimate) = (off.fold(0.0, f64::max), measure.error_estimate());
            println!(
                "{name}, {n} points, {} unknowns: off by {off:.1e}, estimated {estimate:.1e}",
                integral.unknowns()
            );
            assert!(off < most && integral.unknowns() <= 1536, "{name}, {n} points: off by {off:e}");
            assert!(off <= estimate && estimate < 1e3 * off, "{name}, {n}: off by {off:e}, estimated {estimate:e}");
        }
    }
}

/// Interior points that were not known when the equation was factored, down to 1e-12 from the circle and next to the
/// end of the ellipse's long axis.
#[test]
fn points_next_to_a_smooth_boundary_need_no_new_factor() {
    let disk = Preset::Disk.curve().unwrap();
    let integral = BoundaryIntegral::prepare(&disk, &Settings::default()).unwrap();
    for distance in [0.5, 0.1, 1e-2, 1e-3, 1e-6] {
        // next to a peak Newton's method may go to and fro from some places
        const SHARES: u32 = 20_000;
        let x = (1.0 - distance) * DVec2::from_angle(0.7);
        let measure = integral.harmonic_measure(x).unwrap();
        let anchored = measure.from_anchor(CurvePoint::new(0, 0.0));
        let mut worst = 0.0_f64;
        for k in 1..SHARES {
            let share = f64::from(k) / f64::from(SHARES);
            // the angle at x is half the sum of the angles of both measures, from x and from the center
            let seen = ((DVec2::from_angle(TAU * share) - x).to_angle() - (DVec2::X - x).to_angle()).rem_euclid(TAU);
            let exact = 2.0 * seen / TAU - share;
            worst = worst.max((anchored.forward(CurvePoint::new(0, share)) - exact).abs());
            let found = anchored.point_at(share);
            // the density is 1/distance there, and the parameter is rounded
            let off = (anchored.forward(found) - share).abs();
            assert!(off < 1e-13 + 1e-15 / distance, "{distance:e}, {share}: {off:e}");
        }
        println!("{distance:e}: off by {worst:.1e}, estimated {:.1e}", measure.error_estimate());
        assert!(worst < 1e-12 / distance.sqrt(), "{distance:e}: off by {worst:e}");
    }
}

#[test]
fn measure_inside_of_corner_panels_is_that_of_the_finer_resolution() {
    for (curve, x) in [(l_shape(), (0.3, 0.4)), (half_disk(), (0.1, 0.5)), (regular(3, 1.0), (0.1, 0.1))] {
        let settings = Settings::default().with_points(&[x.into()]);
        let coarse = BoundaryIntegral::prepare(&curve, &settings).unwrap();
        let fine = BoundaryIntegral::prepare(&curve, &settings.clone().finer()).unwrap();
        let [a, b] = [&coarse, &fine].map(|integral| integral.harmonic_measure(x.into()).unwrap());
        let anchor = curve.point_at_fraction(0.123);
        let (a, b) = (a.from_anchor(anchor), b.from_anchor(anchor));
        for piece in 0..curve.pieces().len() {
            for exponent in 0..30 {
                let t = 0.5_f64.powi(exponent);
                for place in [CurvePoint::new(piece, t), CurvePoint::before_end(piece, t)] {
                    let off = a.forward(place) - b.forward(place);
                    assert!(off.abs() < 1e-12, "piece {piece}, {t:e}: {off:e}");
                    let sum = a.forward(place) + a.backward(place);
                    assert!((sum - 1.0).abs() < 1e-14, "piece {piece}, {t:e}: {sum}");
                }
            }
        }
    }
}

#[test]
fn points_are_found_from_their_measure_and_measures_rise() {
    for curve in [l_shape(), half_disk(), Preset::Heart.curve().unwrap()] {
        let x = DVec2::new(0.1, 0.3);
        let integral = BoundaryIntegral::prepare(&curve, &Settings::default().with_points(&[x])).unwrap();
        let measure = integral.harmonic_measure(x).unwrap();
        let anchor = curve.point_at_fraction(0.3);
        let anchored = measure.from_anchor(anchor);
        let mut before = 0.0;
        for k in 0..=2000 {
            let omega = f64::from(k) / 2000.0;
            let found = anchored.point_at(omega);
            let off = anchored.forward(found) - omega;
            assert!(off.abs() < 1e-14 || (off.abs() - 1.0).abs() < 1e-14, "{omega}: {off:e}");
            let back = anchored.backward(anchored.point_before(omega)) - omega;
            // the anchor itself is at 0 and at 1
            assert!(back.abs() < 1e-14 || (back.abs() - 1.0).abs() < 1e-14, "backwards {omega}: {back:e}");
            if k > 0 && k < 2000 {
                assert!(anchored.forward(found) >= before, "{omega}");
                before = anchored.forward(found);
            }
        }
        // next to the anchor both directions keep their relative accuracy
        for tiny in [1e-6, 1e-9, 1e-12] {
            assert!((anchored.forward(anchored.point_at(tiny)) / tiny - 1.0).abs() < 1e-3, "{tiny}");
            assert!((anchored.backward(anchored.point_before(tiny)) / tiny - 1.0).abs() < 1e-3, "{tiny}");
        }
    }
}

#[test]
fn what_cannot_be_computed_is_refused() {
    let outside = invariants(&l_shape(), &InvariantsRequest::new(DVec2::new(1.5, 1.5)));
    assert_eq!(outside, Err(BoundaryIntegralError::NotInside { at: DVec2::new(1.5, 1.5) }));
    let few = Settings::default().with_max_unknowns(100);
    let refused = BoundaryIntegral::prepare(&l_shape(), &few).unwrap_err();
    assert!(matches!(refused, BoundaryIntegralError::TooManyUnknowns { needed, limit: 100 } if needed > 100));
    let comb: Vec<(f64, f64)> = (0..13_000)
        .flat_map(|k| [(f64::from(k), 0.0), (f64::from(k) + 0.5, 3.0)])
        .chain([(13_000.0, 5.0), (0.0, 5.0)])
        .collect();
    let refused = invariants(&polygon(&comb), &InvariantsRequest::new(DVec2::new(6500.0, 4.0)));
    assert!(matches!(refused, Err(BoundaryIntegralError::TooManyUnknowns { .. })), "{refused:?}");
}

#[test]
fn invariants_do_not_depend_on_place_and_size() {
    for scale in [1e-20, 1.0, 1e20] {
        let at = |x: f64, y: f64| (scale * (x + 3.0), scale * (y - 7.0));
        let l = [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)].map(|(x, y)| at(x, y));
        let found = all(&polygon(&l), at(0.5, 0.5));
        assert!((found.pieces[0].value - 0.394_497_233_238_905_2).abs() < 1e-13, "{scale:e}: {:?}", found.pieces[0]);
        assert!((found.conformal_radius.value / scale - 0.653_579_438_242_370_7).abs() < 1e-12, "{scale:e}");
        assert!((found.capacity.value / scale - 1.084_890_390_444_781).abs() < 1e-12, "{scale:e}");
    }
}

/// At the far end of the 40×1 rectangle the density is nothing but rounding, of either sign: arcs between points in one
/// panel are nothing too, and not the rest of the boundary.
#[test]
fn an_arc_in_the_dark_is_no_way_around() {
    let curve = rectangle(40.0, 1.0);
    let integral = BoundaryIntegral::prepare(&curve, &Settings::default()).unwrap();
    let measure = integral.harmonic_measure(DVec2::new(1.0, 0.5)).unwrap();
    let at = |k: u32| curve.point_at_fraction(0.3 + 1e-3 * f64::from(k));
    for k in 0..300 {
        let [there, around] = [measure.between(at(k), at(k + 1)), measure.between(at(k + 1), at(k))];
        assert!((0.0..1e-12).contains(&there), "{k}: {there:e}");
        assert!((around - 1.0).abs() < 1e-12, "{k}: {around:e}");
    }
}
