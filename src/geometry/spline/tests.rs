//! Splines reproduce lines, approximate the circle with the stated orders, and pass through their points.

use super::*;
use std::f64::consts::TAU;

fn uneven(n: u32) -> impl Iterator<Item = f64> {
    (0..n).map(move |k| {
        let s = f64::from(k) / f64::from(n);
        s + 0.02 * (TAU * 3.0 * s).sin()
    })
}

/// At any distances, with every end condition.
#[test]
fn a_straight_line_is_reproduced() {
    let points: Vec<DVec2> = [0.0, 0.1, 0.15, 0.7, 1.0].map(|s| DVec2::new(1.0 + 2.0 * s, 3.0 - s)).to_vec();
    for count in 2..=5 {
        let spline = Spline::open(&points[..count]).unwrap();
        for k in 0..=20 {
            let jet = spline.jet(f64::from(k) / 20.0);
            let (a, d) = (points[0], points[count - 1] - points[0]);
            assert!(jet.position.distance(a + f64::from(k) / 20.0 * d) < 1e-14);
            assert!(jet.second.length() < 1e-12, "{count}: {}", jet.second);
        }
    }
}

/// The errors on unevenly spaced points of a circle: position of order 4, curvature of order 2.
#[test]
fn the_circle_is_approximated_with_the_stated_orders() {
    let errors = |n: u32| {
        let points: Vec<DVec2> = uneven(n).map(|s| DVec2::from_angle(TAU * s)).collect();
        let spline = Spline::closed(&points).unwrap();
        let jets: Vec<Jet> = (0..10 * n).map(|k| spline.jet(f64::from(k) / f64::from(10 * n))).collect();
        let worst = |error: fn(&Jet) -> f64| jets.iter().map(error).fold(0.0, f64::max);
        [worst(|jet| (jet.position.length() - 1.0).abs()), worst(|jet| (jet.curvature() - 1.0).abs())]
    };
    let [coarse, fine] = [errors(100), errors(200)];
    println!("{coarse:?}, {fine:?}");
    assert!((14.0..18.0).contains(&(coarse[0] / fine[0])), "position: {coarse:?}, {fine:?}");
    assert!((3.5..4.5).contains(&(coarse[1] / fine[1])), "curvature: {coarse:?}, {fine:?}");
    assert!(fine[0] < 4e-8 && fine[1] < 4e-4, "{fine:?}");
}

#[test]
fn the_curve_passes_through_its_points_with_continuous_curvature() {
    let points: Vec<DVec2> =
        uneven(30).map(|s| (1.0 + 0.3 * (TAU * 2.0 * s).cos()) * DVec2::from_angle(TAU * s)).collect();
    for spline in [Spline::open(&points).unwrap(), Spline::closed(&points).unwrap()] {
        let cubics: Vec<[DVec2; 4]> = spline.cubics().collect();
        let length = spline.knots[spline.len() - 1];
        for (k, [a, b, _, _]) in cubics.iter().enumerate() {
            assert_eq!(*a, spline.points[k]);
            let jet = spline.jet(spline.knots[k] / length);
            assert!(jet.position.distance(*a) < 1e-15);
            let h = spline.knots[k + 1] - spline.knots[k];
            assert!((length * 3.0 / h * (*b - *a)).distance(jet.first) < 1e-11 * length);
        }
        for w in cubics.windows(2) {
            let second = |[p, q, r]: [DVec2; 3], h: f64| (p - 2.0 * q + r) / (h * h);
            let h = w.iter().map(|c| c[0].distance(c[3])).collect::<Vec<_>>();
            let [left, right] = [second([w[0][1], w[0][2], w[0][3]], h[0]), second([w[1][0], w[1][1], w[1][2]], h[1])];
            assert!(left.distance(right) < 1e-10, "{left}, {right}");
        }
    }
    let closed = Spline::closed(&points).unwrap();
    let [start, end] = [closed.jet(0.0), closed.jet(1.0)];
    assert!(start.first.distance(end.first) < 1e-12 && start.second.distance(end.second) < 1e-9);
}

#[test]
fn what_has_no_spline_is_refused() {
    let p = DVec2::new(0.3, 0.1);
    assert!(Spline::open(&[]).is_none() && Spline::open(&[p]).is_none() && Spline::open(&[p, p]).is_none());
    assert!(Spline::closed(&[p, DVec2::ZERO]).is_none());
    assert!(Spline::open(&[p, DVec2::NAN]).is_none());
}
