//! The guarantees of sampling, on formulas, presets and outlines found in practice.

use super::*;
use crate::mesh::{Sizing, mesh_domain};
use crate::outline::Preset;
use proptest::prelude::*;
use std::f64::consts::TAU;

fn polygon(points: Vec<DVec2>) -> SimplePolygon {
    SimplePolygon::try_from(points).unwrap()
}

fn circle(n: usize, radius: impl Fn(usize) -> f64) -> SimplePolygon {
    polygon((0..n).map(|k| DVec2::from_angle(TAU * k as f64 / n as f64) * radius(k)).collect())
}

fn square() -> SimplePolygon {
    polygon([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(DVec2::from).to_vec())
}

fn adaptive(polygon: &SimplePolygon, target: Option<u32>) -> BoundarySamples {
    let samples = sample(polygon, Sampling::Adaptive { target }).unwrap();
    assert_eq!(samples.check_invariants(), Ok(()));
    samples
}

fn uniform(polygon: &SimplePolygon, count: u32, keep_corners: bool) -> Result<BoundarySamples, SamplingError> {
    sample(polygon, Sampling::Uniform { count, keep_corners })
}

fn distance(polygon: &SimplePolygon, x: DVec2) -> f64 {
    let to_edge = |(a, b): (DVec2, DVec2)| {
        (a + ((x - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0) * (b - a)).distance(x)
    };
    polygon.edges().map(to_edge).fold(f64::INFINITY, f64::min)
}

type Named = (String, SimplePolygon);

fn presets() -> impl Iterator<Item = Named> {
    Preset::ALL.into_iter().map(|preset| (preset.name().to_owned(), preset.outline().into_polygon()))
}

#[test]
fn uniform_samples_are_equally_spaced_from_the_first_vertex() {
    let samples = uniform(&square(), 64, false).unwrap();
    assert_eq!(samples.check_invariants(), Ok(()));
    assert_eq!(samples.points[0], DVec2::new(-1.0, -1.0));
    for (k, &s) in samples.fractions.iter().enumerate() {
        assert_eq!(s, k as f64 / 64.0);
    }
    assert!(samples.edge_lengths.iter().all(|e| (e - 0.125).abs() < 1e-15));
}

#[test]
fn thinned_samples_are_some_of_the_samples() {
    let samples = adaptive(&circle(500, |k| 1.0 + 0.3 * (TAU * k as f64 / 100.0).cos()), None);
    for most in [0, 3, 50, samples.len() - 1] {
        let few = samples.thinned(most);
        assert_eq!((few.check_invariants(), few.len()), (Ok(()), most.max(3)));
        let kept = few
            .points
            .iter()
            .zip(&few.fractions)
            .map(|(p, &s)| samples.points[samples.at_fraction(s).edge() as usize] == *p);
        assert!(kept.into_iter().all(|kept| kept), "{most}");
    }
    assert_eq!(samples.thinned(samples.len()), samples);
}

#[test]
fn kept_corners_are_samples_and_the_count_holds() {
    for count in [4, 5, 11, 97] {
        let samples = uniform(&square(), count, true).unwrap();
        assert_eq!(samples.check_invariants(), Ok(()));
        assert_eq!(samples.len(), count as usize);
        assert!(square().vertices().iter().all(|v| samples.points.contains(v)), "{count} samples");
    }
    assert_eq!(uniform(&square(), 3, true), Err(SamplingError::MoreCornersThanSamples { corners: 4, count: 3 }));
    let (kept, equal) = (uniform(&circle(5000, |_| 1.0), 77, true), uniform(&circle(5000, |_| 1.0), 77, false));
    let differences = kept.unwrap().points.into_iter().zip(equal.unwrap().points).map(|(a, b)| a.distance(b));
    assert!(differences.fold(0.0, f64::max) < 1e-12, "a dense circle has no corners");
}

#[test]
fn impossible_counts_are_refused() {
    assert_eq!(uniform(&square(), 2, false), Err(SamplingError::TooFew { count: 2 }));
    let too_many = SamplingError::TooMany { count: MAX_SAMPLES + 1, limit: MAX_SAMPLES };
    assert_eq!(uniform(&square(), MAX_SAMPLES + 1, false), Err(too_many));
    assert!(sample(&square(), Sampling::Adaptive { target: Some(0) }).is_err());
}

#[test]
fn a_circle_is_sampled_evenly_and_wiggles_below_the_spacing_do_not_matter() {
    let smooth = adaptive(&circle(6000, |_| 1.0), None);
    let range = smooth.edge_lengths.iter().fold((f64::INFINITY, 0.0f64), |(low, high), &e| (low.min(e), high.max(e)));
    assert!(range.1 / range.0 < 1.01, "{range:?}");
    // 2·10⁻⁴ off the circle at every other one of 6000 vertices: they turn by 40° each
    let noisy = adaptive(&circle(6000, |k| 1.0 + 2e-4 * (k % 2) as f64), None);
    assert!(noisy.len().abs_diff(smooth.len()) * 20 < smooth.len(), "{} and {}", noisy.len(), smooth.len());
}

#[test]
fn adaptive_spacing_is_graded_towards_corners() {
    let samples = adaptive(&square(), None);
    assert!(square().vertices().iter().all(|v| samples.points.contains(v)));
    let longest = samples.edge_lengths.iter().copied().fold(0.0, f64::max);
    let at_corner = samples.edge_lengths[0];
    println!("m {}, edges {at_corner:.2e} … {longest:.2e}", samples.len());
    assert!((30.0..60.0).contains(&(longest / at_corner)));
    let m = samples.len();
    for k in 0..m {
        let ratio = samples.edge_lengths[k] / samples.edge_lengths[(k + 1) % m];
        assert!((0.7..1.43).contains(&ratio), "edges {k} and {} have the ratio {ratio}", k + 1);
    }
}

#[test]
fn curvature_and_channels_limit_the_spacing() {
    let tip: f64 = 0.02;
    let ellipse = polygon(
        (0..8000).map(|k| DVec2::from_angle(TAU * f64::from(k) / 8000.0) * DVec2::new(1.0, tip.sqrt())).collect(),
    );
    // the radius of curvature at the tip is b²/a = 0.02
    let edge = adaptive(&ellipse, None).edge_lengths[0];
    assert!(edge < 0.36 * tip && edge > 0.1 * tip, "edge {edge} at a tip of radius {tip}");
    let width = 0.02;
    let half = [(-1.0, -1.0), (-0.2, -1.0), (-0.2, -width / 2.0), (0.2, -width / 2.0), (0.2, -1.0), (1.0, -1.0)];
    let dumbbell = half.into_iter().chain(half.map(|(x, y)| (-x, -y)));
    let samples = adaptive(&polygon(dumbbell.map(DVec2::from).collect()), None);
    let in_channel = |k: &usize| samples.points[*k].x.abs() < 0.19 && samples.points[*k].y.abs() < 0.011;
    let longest = (0..samples.len()).filter(in_channel).map(|k| samples.edge_lengths[k]).fold(0.0, f64::max);
    assert!(longest < 0.36 * width && longest > 0.1 * width, "edge {longest} in a channel of width {width}");
}

#[test]
fn from_far_away_the_nearest_sample_is_the_outermost_one() {
    let samples = uniform(&circle(48, |_| 1.0), 48, true).unwrap();
    for &outermost in &samples.points {
        for distance in [1.5, 1e8, 1e16, 1e100] {
            let found = samples.position(samples.nearest(distance * outermost));
            assert!(found.distance(outermost) < 1e-14, "{found} for {outermost} from {distance:e}");
        }
    }
}

#[test]
fn targets_are_met_and_samples_lie_on_the_outline() {
    assert_targets_are_met_on_the_outline(presets());
}

fn assert_targets_are_met_on_the_outline(outlines: impl Iterator<Item = Named>) {
    for (name, shape) in outlines {
        for target in [100, 400, 2500] {
            let samples = adaptive(&shape, Some(target));
            let m = samples.len() as f64;
            assert!((m / f64::from(target) - 1.0).abs() < 0.05, "{name}: {m} samples for {target}");
            assert_eq!(samples.points[0], shape.vertices()[0]);
            let off = samples.points.iter().map(|&p| distance(&shape, p)).fold(0.0, f64::max);
            assert!(off < 1e-14 * shape.perimeter(), "{name}: a sample is {off:e} off the outline");
        }
    }
}

#[test]
fn samples_cover_the_outline() {
    assert_samples_cover_the_outline(presets());
}

fn assert_samples_cover_the_outline(outlines: impl Iterator<Item = Named>) {
    for (name, shape) in outlines {
        let covered = polygon(adaptive(&shape, None).points).area() / shape.area();
        assert!((covered - 1.0).abs() < 9e-4, "{name}: the samples cover {covered}");
    }
}

#[test]
fn samples_of_all_outlines_form_simple_polygons_that_can_be_meshed() {
    assert_samples_can_be_meshed(presets());
}

fn assert_samples_can_be_meshed(outlines: impl Iterator<Item = Named>) {
    for (name, shape) in outlines {
        for target in [None, Some(12), Some(60), Some(1000)] {
            let samples = adaptive(&shape, target);
            let (mesh, report) = mesh_domain(&samples.points, Sizing::default()).unwrap();
            println!("{name} {target:?}: m {}, n {} ({} added)", samples.len(), mesh.interior_count(), report.added);
            assert_eq!(mesh.check_invariants(), Ok(()));
            assert!(report.complete, "{name} {target:?}");
            if target.is_none() {
                assert!((400..=840).contains(&samples.len()), "{name}: {} samples", samples.len());
                assert!(mesh.interior_count() < 9000, "{name}: {} vertices", mesh.interior_count());
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(5), ..ProptestConfig::default() })]

    /// Stars with radii between 10⁻² and 1: thin spikes beside thin notches.
    #[test]
    fn samples_of_random_stars_are_simple(radii in prop::collection::vec(-2.0f64..0.0, 5..80), target in 3u32..600, turn in 0.0f64..6.0) {
        let m = radii.len() as f64;
        let star: Vec<DVec2> = radii.iter().enumerate().map(|(k, r)| DVec2::from_angle(turn + TAU * k as f64 / m) * 10f64.powf(*r)).collect();
        let star = polygon(star);
        for target in [None, Some(target)] {
            let samples = adaptive(&star, target);
            prop_assert!(SimplePolygon::try_from(samples.points).is_ok());
        }
    }
}

/// Icons and a coast line.
mod shared_data {
    use super::*;
    use crate::outline::{OutlineError, parse};
    use crate::test_data::shared_outlines;

    /// The outlines that are simple polygons: all but one.
    fn outlines() -> Vec<Named> {
        let read = |path: std::path::PathBuf| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            match parse(&name, &std::fs::read(path).unwrap()) {
                Ok(outline) => Some((name, outline.polygon)),
                Err(error) => {
                    assert!(matches!(error, OutlineError::Polygon(_)), "{name}: {error}");
                    None
                }
            }
        };
        let paths = shared_outlines();
        let simple: Vec<_> = paths.iter().cloned().filter_map(read).collect();
        assert_eq!(simple.len(), paths.len() - 1);
        simple
    }

    #[test]
    #[ignore = "needs ../shared/data"]
    fn samples_cover_the_outline() {
        assert_samples_cover_the_outline(outlines().into_iter());
    }

    #[test]
    #[ignore = "needs ../shared/data"]
    fn targets_are_met_and_samples_lie_on_the_outline() {
        assert_targets_are_met_on_the_outline(outlines().into_iter());
    }

    #[test]
    #[ignore = "needs ../shared/data"]
    fn samples_of_all_outlines_form_simple_polygons_that_can_be_meshed() {
        assert_samples_can_be_meshed(outlines().into_iter());
    }
}
