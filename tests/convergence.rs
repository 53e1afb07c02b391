//! The order of convergence at the default settings: adaptive samples and graded triangles.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::{ConformalMap, Constraints, Direction, PrepareSettings, Side, prepare};
use riemap::exact::{blob, vshape};
use riemap::figures::{ArcLength, fitted_order};
use riemap::geometry::{DVec2, SimplePolygon};
use riemap::mesh::Sizing;
use riemap::outline::{Preset, Sampling};
use std::f64::consts::TAU;
use std::sync::Arc;
use support::domains::domain;

const BLOB_CENTRE: DVec2 = DVec2::new(2.677_813_229_026_218, 2.466_851_711_366_240_7);
const V_POINT: DVec2 = DVec2::new(0.96, 0.8432);
const RESOLUTIONS: [u32; 5] = [250, 500, 1000, 2000, 4000];

/// A curve whose map to the blob is known in closed form.
struct Case {
    name: &'static str,
    polygon: SimplePolygon,
    /// The smooth curve, over one period of its parameter.
    curve: fn(f64) -> DVec2,
    period: f64,
    x: DVec2,
    /// The harmonic measure at `x` from the curve's start to the point of a parameter.
    measure: fn(f64) -> f64,
}

/// z + 0.12 z⁵ on the unit circle, t turns from 1.
fn five_lobes(t: f64) -> DVec2 {
    DVec2::from_angle(TAU * t) + 0.12 * DVec2::from_angle(5.0 * TAU * t)
}

fn cases() -> [Case; 2] {
    let points: Vec<DVec2> = (0..6000).map(|k| five_lobes(f64::from(k) / 6000.0)).collect();
    [
        Case {
            name: "V-shape",
            polygon: Preset::VShape.outline().polygon().clone(),
            curve: vshape::boundary,
            period: 4.0,
            x: V_POINT,
            measure: |t| vshape::harmonic_measure(V_POINT, vshape::boundary(t)),
        },
        Case {
            name: "z + 0.12 z⁵",
            polygon: SimplePolygon::try_from(points).unwrap(),
            curve: five_lobes,
            period: 1.0,
            x: DVec2::ZERO,
            measure: |t| t.rem_euclid(1.0),
        },
    ]
}

/// The parameter of the point of the curve nearest to `p`, which lies near arc length `s` of the whole.
fn foot(case: &Case, arc: &ArcLength, p: DVec2, s: f64) -> f64 {
    const STEP: f64 = 1e-6;
    let mut t = arc.parameter(s * arc.total());
    for _ in 0..3 {
        let tangent = ((case.curve)(t + STEP) - (case.curve)(t - STEP)) / (2.0 * STEP);
        t += (p - (case.curve)(t)).dot(tangent) / tangent.length_squared();
    }
    t
}

/// Mean and maximum distance of the boundary images in the blob from the exact ones.
fn image_error(case: &Case, arc: &ArcLength, settings: PrepareSettings) -> (f64, f64, usize) {
    let source = Arc::new(prepare(&case.polygon, &settings, &mut |_| ()).unwrap());
    let target = domain(Preset::Blob, settings);
    let constraints = Constraints::new((case.x, 0.0), (BLOB_CENTRE, 0.0));
    let map = ConformalMap::new(source, target, &constraints, Direction::Forward.into()).unwrap();
    let samples = map.domain(Side::Source).unwrap().samples();
    let exact = |k: usize| match k {
        0 => blob::boundary(0.0),
        k => blob::boundary((case.measure)(foot(case, arc, samples.points()[k], samples.fractions()[k]))),
    };
    let errors: Vec<f64> = (0..samples.len()).map(|k| map.images()[k].distance(exact(k))).collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    (mean, errors.iter().copied().fold(0.0, f64::max), samples.len())
}

#[test]
fn graded_maps_converge_with_the_number_of_samples() {
    for case in cases() {
        let arc = ArcLength::new(case.curve, case.period);
        let (mean, max, m) = image_error(&case, &arc, PrepareSettings::default());
        println!("{}, default (m = {m}): mean {mean:.2e}, max {max:.2e}", case.name);
        let mut points = Vec::new();
        for target in RESOLUTIONS {
            let settings = PrepareSettings::new(Sampling::Adaptive { target: Some(target) }, Sizing::default());
            let (mean, max, m) = image_error(&case, &arc, settings);
            println!("{}, m = {m}: mean {mean:.2e}, max {max:.2e}", case.name);
            points.push((target, mean));
        }
        let order = fitted_order(&points).unwrap();
        println!("{}: order {order:.2} in the mean", case.name);
        // 1.5 was observed on both; without a finer interior it is 0
        assert!(order >= 1.0, "{}: order {order:.2} of {points:?}", case.name);
    }
}
