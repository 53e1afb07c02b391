//! The closed forms compared with each other, a Fourier series, Möbius maps, and riemap's own map.

use super::*;
use crate::conformal::{ConformalMap, Direction, PrepareSettings, PreparedSide, Side, prepare};
use crate::exact::{Complex, disk};
use crate::mesh::Sizing;
use crate::outline::Sampling;
use crate::session::Command;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

const KNOWN: [Preset; 4] = [Preset::Disk, Preset::Square, Preset::Blob, Preset::VShape];

/// Two interior points: one near the middle, one in a corner, a lobe or an arm.
fn points(preset: Preset) -> [DVec2; 2] {
    match preset {
        Preset::Disk => [DVec2::new(0.1, -0.2), DVec2::new(-0.55, 0.6)],
        Preset::Square => [DVec2::new(0.0, 0.1), DVec2::new(0.7, -0.6)],
        Preset::Blob => [DVec2::new(2.7, 2.5), DVec2::new(4.6, 2.2)],
        // on the V's middle line, y = 2x² − 1
        _ => [DVec2::new(0.0, -1.0), DVec2::new(0.3, -0.82)],
    }
}

fn constraints(points: [DVec2; 2], anchors: [f64; 2]) -> Constraints {
    Constraints::new((points[0], anchors[0]), (points[1], anchors[1]))
}

#[test]
fn measures_rise_from_zero_to_one_and_are_inverted() {
    for preset in KNOWN {
        for x in points(preset) {
            let measure = ExactMeasure::new(preset, x).unwrap();
            assert_eq!((measure.at(0.0), measure.at(1.0)), (0.0, 1.0), "{preset}");
            let mut before = 0.0;
            for k in 1..3000 {
                let s = f64::from(k) / 3000.0;
                let omega = measure.at(s);
                assert!(omega >= before - 1e-15, "{preset} at {s}: {omega} after {before}");
                before = omega;
                // back to the point, or to one with the same measure up to rounding: the inverse's error times the
                // kernel
                let error = (measure.at(measure.inverse_at(omega)) - omega).abs();
                assert!(error < 1e-10, "{preset} at {s}: {error:e}");
            }
        }
    }
}

/// Separation of variables: from x + iy in [0, π]², the measure of the top side
/// is Σ over odd n of (4/nπ) sin nx sinh ny / sinh nπ.
#[test]
fn the_top_side_of_the_square_has_the_measure_of_its_fourier_series() {
    for x in [DVec2::new(0.2, 0.3), DVec2::new(-0.7, -0.1), DVec2::new(0.0, 0.0), DVec2::new(0.5, -0.6)] {
        let place = (x / 0.9 + DVec2::ONE) * (0.5 * PI);
        let term = |n: f64| {
            4.0 / (n * PI) * (n * place.x).sin() * (n * (place.y - PI)).exp() * (1.0 - (-2.0 * n * place.y).exp())
                / (1.0 - (-2.0 * n * PI).exp())
        };
        let series: f64 = (0..40).map(|k| term(f64::from(2 * k + 1))).sum();
        let measure = ExactMeasure::new(Preset::Square, x).unwrap();
        // the left half of the top side is the first eighth of the outline, the right half the last
        let top = measure.at(0.125) + (1.0 - measure.at(0.875));
        // the argument of g has a square-root singularity at the corners, where rounding becomes 1e-8
        assert!((top - series).abs() < 1e-7, "{x}: {top} for {series}");
    }
    let centre = ExactMeasure::new(Preset::Square, DVec2::ZERO).unwrap();
    assert!((centre.at(0.25) - 0.25).abs() < 1e-15 && (centre.at(0.5) - 0.5).abs() < 1e-15);
}

#[test]
fn on_the_disk_it_is_the_moebius_map_of_figure_7() {
    let [x1, x2] = [DVec2::new(0.6, 0.2), DVec2::new(0.0, -0.5)];
    let map = ExactMap::between([Preset::Disk; 2].into(), &constraints([x1, x2], [0.0, 0.0])).unwrap();
    for k in 1..200 {
        let x = f64::from(k) / 200.0;
        let image = disk::figure_7(Complex::cis(TAU * x)).arg().rem_euclid(TAU) / TAU;
        let error = (map.reparameterisation(Side::Source, x) - image).abs();
        assert!(error < 1e-11, "at {x}: {error:e}, the inverse is 1e-12 off");
    }
}

#[test]
fn there_and_back_is_the_identity_under_any_constraints() {
    for source in KNOWN {
        for target in KNOWN {
            let points = [points(source)[1], points(target)[0]];
            let map = ExactMap::between(PerSide::new(source, target), &constraints(points, [0.3, -0.45])).unwrap();
            for (from, x) in Side::BOTH.into_iter().flat_map(|side| (0..=60).map(move |k| (side, f64::from(k) / 60.0)))
            {
                let there = map.reparameterisation(from, x);
                let error = (map.measure(from, x) - map.measure(from.other(), there)).abs();
                assert!(error < 1e-10, "{source} → {target}, {from} at {x}: measures differ by {error:e}");
                let risen = map.measure(from, x + 1e-3) - map.measure(from, x - 1e-3);
                if risen < 1e-6 {
                    continue; // in the V's arms, where the measures of different points are equal in f64
                }
                let back = map.reparameterisation(from.other(), there);
                // 1e-10 of the measure, divided by a kernel of 5e-4
                assert!((back - x).abs() < 1e-6, "{source} → {target}, {from} at {x}: {there}, {back}");
            }
        }
    }
}

#[test]
fn maps_without_a_closed_form_are_none() {
    let at = |x: DVec2| constraints([x, DVec2::ZERO], [0.0; 2]);
    for preset in Preset::ALL {
        let map = ExactMap::between(
            PerSide::new(Preset::Disk, preset),
            &constraints([DVec2::ZERO, points(preset)[0]], [0.0; 2]),
        );
        assert_eq!(map.is_some(), KNOWN.contains(&preset), "{preset}");
    }
    assert!(ExactMap::between([Preset::Disk; 2].into(), &at(DVec2::new(1.0, 0.1))).is_none(), "outside");
    let anchored = |anchor| constraints([DVec2::ZERO; 2], [anchor, 0.0]);
    assert!(ExactMap::between([Preset::Disk; 2].into(), &anchored(f64::NAN)).is_none());
    let mut session = Session::default();
    assert!(ExactMap::of_session(&session, PerSide::default()).is_none(), "a gingerbread man has no closed form");
    for (side, preset) in [(Side::Source, Preset::Square), (Side::Target, Preset::Disk)] {
        session.apply(Command::SetOutline { side, outline: OutlineSpec::Preset(preset) });
    }
    assert!(ExactMap::of_session(&session, PerSide::default()).is_some());
    let outline = OutlineSpec::points(String::from("disk"), Preset::Disk.outline().into_polygon());
    session.apply(Command::SetOutline { side: Side::Target, outline });
    assert!(ExactMap::of_session(&session, PerSide::default()).is_none(), "loaded points are what they are");
}

fn prepared(preset: Preset) -> Arc<PreparedSide> {
    let sampling = Sampling::Adaptive { target: Some(1000) };
    let settings = PrepareSettings { sampling, sizing: Sizing::Graded(0.1), ..PrepareSettings::default() };
    Arc::new(prepare(preset.outline().polygon(), &settings, &mut |_| ()).unwrap())
}

/// riemap's map with 1000 adaptive samples per side, compared with the closed forms.
#[test]
fn the_harmonic_map_is_the_exact_one_up_to_its_discretisation() {
    let domains = KNOWN.map(prepared);
    for (source, first) in KNOWN.into_iter().zip(&domains) {
        for (target, second) in KNOWN.into_iter().zip(&domains) {
            let points = [points(source)[1], points(target)[0]];
            let constraints = constraints(points, [0.2, 0.9]);
            let exact = ExactMap::between(PerSide::new(source, target), &constraints).unwrap();
            let direction = Direction::Forward.into();
            let map = ConformalMap::new(Arc::clone(first), Arc::clone(second), &constraints, direction).unwrap();
            let (mut largest, mut in_measure) = (0.0_f64, 0.0_f64);
            for (k, &image) in map.correspondence().points().iter().enumerate() {
                let x = (first.fractions()[k] - 0.2).rem_euclid(1.0);
                let found = (second.fraction_at(image) - 0.9).rem_euclid(1.0);
                let distance = (exact.reparameterisation(Side::Source, x) - found).abs();
                largest = largest.max(distance.min(1.0 - distance));
                let distance = (exact.measure(Side::Source, x) - exact.measure(Side::Target, found)).abs();
                in_measure = in_measure.max(distance.min(1.0 - distance));
            }
            println!("{source} → {target}: {largest:.1e} of the length, {in_measure:.1e} of the measure");
            // the error of the kernels: at most 2.5e-3, with the V on both sides
            assert!(in_measure < 4e-3, "{source} → {target}: {in_measure:.2e} of the measure");
            // in the V's arms points at any distance have measures this close
            let bounded = target != Preset::VShape;
            assert!(!bounded || largest < 4e-3, "{source} → {target}: {largest:.2e} of the length");
        }
    }
}
