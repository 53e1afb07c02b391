//! The curves compared with closed forms on the disk.

use crate::closed_form::ExactMap;
use crate::conformal::{ConformalMap, Constraints, Direction, PerSide, PrepareSettings, PreparedSide, prepare};
use crate::geometry::DVec2;
use crate::mesh::Sizing;
use crate::model::curves::exact::{ExactCurves, KeptExact};
use crate::model::curves::*;
use crate::outline::{Preset, Sampling};
use std::f64::consts::TAU;
use std::sync::Arc;

/// The unit disk; its first vertex is (1, 0).
fn disk() -> Arc<PreparedSide> {
    let outline = Preset::Disk.outline();
    let sampling = Sampling::Uniform { count: 400, keep_corners: false };
    let settings = PrepareSettings { sampling, sizing: Sizing::Graded(0.1), ..PrepareSettings::default() };
    Arc::new(prepare(outline.polygon(), &settings, &mut |_| {}).unwrap())
}

fn curves(points: [DVec2; 2], anchors: [f64; 2], direction: Direction) -> Curves {
    let constraints = Constraints::new((points[0], anchors[0]), (points[1], anchors[1]));
    let disk = disk();
    let map = ConformalMap::new(Arc::clone(&disk), disk, &constraints, direction.into()).unwrap();
    Curves::new(&map, anchors.into())
}

const X: DVec2 = DVec2::new(0.6, 0.2);

/// The disk of [`Preset::Disk`]: its center, and the mean distance of its samples from it.
fn frame(domain: &PreparedSide) -> (DVec2, f64) {
    let points = domain.domain().unwrap().samples().points();
    let center = points.iter().sum::<DVec2>() / points.len() as f64;
    (center, points[0].distance(center))
}

#[test]
fn the_kernel_of_the_disk_has_its_closed_form_over_the_arc_length() {
    let (center, radius) = frame(&disk());
    for anchor in [0.0, 0.3337] {
        let curves = curves([center + radius * X, center], [anchor, 0.0], Direction::Forward);
        for &[x, y] in &curves.kernel.source.points {
            let on_circle = DVec2::from_angle(TAU * (x + anchor));
            let exact = (1.0 - X.length_squared()) / on_circle.distance_squared(X);
            // the peak is 5; 400 samples resolve it to a few thousandths
            assert!((y - exact).abs() < 0.03, "anchor {anchor}, x {x}: {y} for {exact}");
        }
        for &[x, y] in &curves.kernel.target.points {
            assert!((y - 1.0).abs() < 0.01, "the center's kernel is uniform, not {y} at {x}");
        }
    }
}

#[test]
fn measures_and_reparameterization_run_from_zero_to_one_without_decreasing() {
    let (center, radius) = frame(&disk());
    for (anchors, direction) in [
        ([0.0, 0.0], Direction::Forward),
        ([0.25, 0.0], Direction::Backward),
        ([0.1001, 0.7777], Direction::Forward),
        ([0.999, 0.5], Direction::Backward),
    ] {
        let curves = curves([center + radius * X, center - 0.5 * radius * X], anchors, direction);
        for curve in [&curves.measure.source, &curves.measure.target, &curves.reparameterisation] {
            let points = &curve.points;
            assert_eq!((points[0], points[points.len() - 1]), ([0.0, 0.0], [1.0, 1.0]), "{}", curve.name);
            for pair in points.windows(2) {
                assert!(pair[0][0] <= pair[1][0] && pair[0][1] <= pair[1][1], "{}: {pair:?}", curve.name);
            }
        }
    }
}

#[test]
fn from_the_center_the_reparameterization_is_the_harmonic_measure() {
    let (center, radius) = frame(&disk());
    let curves = curves([center + radius * X, center], [0.2, 0.6], Direction::Forward);
    let r = &curves.reparameterisation;
    for k in 0..=50 {
        let x = f64::from(k) / 50.0;
        // ω from the center is the arc length, up to the mesh's error
        let error = (r.at(x) - curves.measure.source.at(x)).abs();
        assert!(error < 2e-3, "at {x}: {error:e}");
    }
}

#[test]
fn partners_have_the_same_measure_and_are_mutual() {
    let (center, radius) = frame(&disk());
    let curves = curves([center + radius * X, center - 0.4 * radius * X], [0.3, 0.8], Direction::Backward);
    for k in 0..20 {
        let x = f64::from(k) / 20.0;
        let there = curves.partner(Side::Source, x);
        let back = curves.partner(Side::Target, there);
        assert!((back - x).abs() < 1e-9, "{x} → {there} → {back}");
        let fraction = curves.fraction(Side::Source, x);
        assert!((curves.along(Side::Source, fraction) - x).abs() < 1e-12, "{x} at {fraction}");
    }
}

/// In both directions, with any anchors: from the center r is the measure, from other points a Möbius map.
#[test]
fn the_exact_curves_lie_under_the_maps_own() {
    let points = [X, DVec2::new(-0.2, 0.4)];
    for (anchors, direction) in [([0.1, 0.7], Direction::Forward), ([0.8, 0.25], Direction::Backward)] {
        let curves = curves(points, anchors, direction);
        let constraints = Constraints::new((points[0], anchors[0]), (points[1], anchors[1]));
        let map = ExactMap::between(PerSide::from([Preset::Disk; 2]), &constraints).unwrap();
        let exact = ExactCurves::new(&map, &curves);
        // the kernel's error with 400 samples
        assert!(exact.difference < 2e-3, "{:e}", exact.difference);
        for (own, exact) in [
            (&curves.measure.source, &exact.measure.source),
            (&curves.measure.target, &exact.measure.target),
            (&curves.reparameterisation, &exact.reparameterisation),
        ] {
            let points = &exact.points;
            assert_eq!((points[0], points[points.len() - 1]), ([0.0, 0.0], [1.0, 1.0]), "{}", own.name);
            for pair in points.windows(2) {
                assert!(pair[0][0] <= pair[1][0] && pair[0][1] <= pair[1][1], "{}: {pair:?}", own.name);
            }
            for k in 0..=300 {
                let x = f64::from(k) / 300.0;
                let error = (own.at(x) - exact.at(x)).abs();
                // plus the error of a polyline with 320 points
                assert!(error < 3e-3, "{} at {x}: {error:e}", own.name);
            }
        }
    }
}

#[test]
fn decimation_keeps_every_peak_and_few_points() {
    let mut points: Vec<[f64; 2]> = (0..=40_000).map(|k| [f64::from(k) / 40_000.0, 1e-3 * f64::from(k % 7)]).collect();
    points[12_345][1] = 9.0;
    points[12_346][1] = -9.0;
    let few = decimate(&points, 300);
    assert!(few.len() <= 4 * 301, "{}", few.len());
    assert!(few.contains(&points[12_345]) && few.contains(&points[12_346]));
    assert!(few.windows(2).all(|pair| pair[0][0] < pair[1][0]));
    assert_eq!((few[0], few[few.len() - 1]), (points[0], points[40_000]));
    assert_eq!(decimate(&points[..300], 300), points[..300]);
    let rising: Vec<[f64; 2]> = (0..=4000).map(|k| f64::from(k) / 4000.0).map(|x| [x, x * x]).collect();
    let one_each = decimate(&rising, 300);
    assert!(one_each.len() <= 302, "{}", one_each.len());
    assert!(one_each.windows(2).take(300).all(|pair| pair[1][0] - pair[0][0] > 0.7 / 300.0), "no shorter pieces");
}

#[test]
fn a_flat_step_is_inverted_to_its_beginning() {
    let points = vec![[0.0, 0.0], [0.2, 0.5], [0.7, 0.5], [1.0, 1.0]];
    let curve = Curve { name: String::new(), points };
    assert_eq!(curve.inverse_at(0.5), 0.2);
    assert_eq!((curve.at(0.1), curve.at(0.45)), (0.25, 0.5));
    assert_eq!((curve.at(-1.0), curve.at(2.0)), (0.0, 1.0));
}

#[test]
fn exact_curves_are_recomputed_only_when_their_inputs_change() {
    let at = |point: DVec2| Constraints::new((point, 0.1), (DVec2::ZERO, 0.0));
    let of = |point: DVec2| curves([point, DVec2::ZERO], [0.1, 0.0], Direction::Forward);
    let (disks, mut kept) = (Some(PerSide::from([Preset::Disk; 2])), KeptExact::default());
    assert!(kept.update(disks, at(X), &of(X)) && kept.curves().is_some());
    let first = kept.curves().cloned();
    assert!(!kept.update(disks, at(X), &of(X)), "another extension of the same boundary map");
    assert!(kept.update(disks, at(0.5 * X), &of(0.5 * X)) && kept.curves() != first.as_ref());
    assert!(kept.update(disks, at(X), &of(X)) && kept.curves() == first.as_ref());
    assert!(kept.update(None, at(X), &of(X)) && kept.curves().is_none(), "not known");
}
