//! The map compared with exact solutions: the disk, Möbius maps, the tables for V-shape → blob.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::{
    BoundaryValues, ConformalMap, Constraints, Contour, Direction, Extension, MapSettings, PrepareSettings,
    PreparedSide, Side, harmonic_coordinates, prepare,
};
use riemap::exact::{self, complex, point};
use riemap::geometry::{DVec2, SimplePolygon};
use riemap::mesh::{Sizing, locate};
use riemap::outline::{Preset, Sampling};
use std::sync::Arc;
use support::data::exact_values;
use support::domains::domain;

fn uniform(count: u32) -> PrepareSettings {
    PrepareSettings::new(Sampling::Uniform { count, keep_corners: false }, Sizing::Uniform)
}

const BLOB_CENTRE: DVec2 = DVec2::new(2.677_813_229_026_218, 2.466_851_711_366_240_7);
const V_POINT: DVec2 = DVec2::new(0.96, 0.8432);

fn v_to_blob(source: PrepareSettings, target: PrepareSettings) -> ConformalMap {
    let constraints = Constraints::new((V_POINT, 0.0), (BLOB_CENTRE, 0.0));
    let (source, target) = (domain(Preset::VShape, source), domain(Preset::Blob, target));
    ConformalMap::new(source, target, &constraints, Direction::Forward.into()).unwrap()
}

/// The four mappings of the paper's Figure 8.
const FOUR_MAPPINGS: [MapSettings; 4] = [
    MapSettings::new(Direction::Forward, Extension::Harmonic),
    MapSettings::new(Direction::Forward, Extension::CauchyGreen),
    MapSettings::new(Direction::Backward, Extension::Harmonic),
    MapSettings::new(Direction::Backward, Extension::CauchyGreen),
];

fn complete_map(
    source: &Arc<PreparedSide>,
    target: &Arc<PreparedSide>,
    constraints: &Constraints,
    settings: MapSettings,
) -> ConformalMap {
    let mut map = ConformalMap::new(source.clone(), target.clone(), constraints, settings).unwrap();
    assert!(map.refine(f64::INFINITY) && map.extension_progress() == 1.0);
    map
}

/// Maximum and mean distance of the boundary images from those in the table.
fn image_errors(map: &ConformalMap, rows: &[Vec<f64>]) -> (f64, f64) {
    let errors: Vec<f64> =
        rows.iter().zip(map.images()).map(|(row, image)| image.distance(DVec2::new(row[3], row[4]))).collect();
    (errors.iter().copied().fold(0.0, f64::max), errors.iter().sum::<f64>() / errors.len() as f64)
}

fn v_shape_to_blob_matches_the_table(m: u32, largest: f64) {
    let rows = exact_values(&format!("vshape_to_blob_m{m}.txt"));
    let map = v_to_blob(uniform(m), uniform(1000));
    let samples = map.domain(Side::Source).unwrap().samples();
    let boundary = samples.points().iter().zip(&rows).map(|(p, row)| p.distance(DVec2::new(row[0], row[1])));
    let offset = boundary.fold(0.0, f64::max);
    assert!(offset < 1e-5, "m = {m}: the samples are {offset:e} off the table's");
    let (max, mean) = image_errors(&map, &rows);
    println!("V → blob, m = {m}: image error max {max:.2e}, mean {mean:.2e}");
    assert!(mean <= 2e-3, "m = {m}: mean image error {mean:e}");
    assert!(max <= largest, "m = {m}: largest image error {max:e}");
    let measure = map.measure(Side::Source);
    let omega: Vec<f64> = (0..m as usize).map(|k| measure.at_vertex(k)).collect();
    assert!(omega.windows(2).all(|w| w[0] <= w[1]), "m = {m}: ω decreases");
    let error = rows.iter().zip(&omega).map(|(row, w)| (row[2] - w).abs()).fold(0.0, f64::max);
    println!("V → blob, m = {m}: harmonic measure error {error:.2e}");
    assert!(error < 2e-3, "m = {m}: harmonic measure error {error:e}");
}

#[test]
fn v_shape_to_blob_m500() {
    v_shape_to_blob_matches_the_table(500, 7e-2);
}

#[test]
fn v_shape_to_blob_m1000() {
    v_shape_to_blob_matches_the_table(1000, 2.5e-2);
}

#[test]
fn v_shape_to_blob_m2000() {
    v_shape_to_blob_matches_the_table(2000, 1.5e-2);
}

/// The default settings, compared with the finest table, interpolated along the boundary.
#[test]
fn v_shape_to_blob_holds_under_the_default_settings() {
    let rows = exact_values("vshape_to_blob_m2000.txt");
    let map = v_to_blob(PrepareSettings::default(), PrepareSettings::default());
    let samples = map.domain(Side::Source).unwrap().samples();
    let m = rows.len();
    let exact = |s: f64| {
        let (k, t) = ((s * m as f64).floor(), (s * m as f64).fract());
        let at = |k: usize| DVec2::new(rows[k % m][3], rows[k % m][4]);
        at(k as usize).lerp(at(k as usize + 1), t)
    };
    let errors: Vec<f64> = samples.fractions().iter().zip(map.images()).map(|(&s, w)| w.distance(exact(s))).collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    println!("V → blob, default (m = {}): mean {mean:.2e}", samples.len());
    assert!(mean <= 4e-3, "mean image error {mean:e}");
}

#[test]
fn disk_kernel_and_measure_match_the_closed_form() {
    let disk = domain(Preset::Disk, uniform(400));
    let x = DVec2::new(0.6, 0.2);
    let anchor = anchor_at(&disk, DVec2::X);
    let constraints = Constraints::new((x, anchor), (DVec2::ZERO, anchor));
    let map = ConformalMap::new(disk.clone(), disk.clone(), &constraints, Direction::Forward.into()).unwrap();
    let z = complex(x);
    for (k, p) in disk.domain().unwrap().samples().points().iter().enumerate() {
        let t = p.to_angle();
        let t = if t.abs() < 1e-9 { 0.0 } else { t.rem_euclid(std::f64::consts::TAU) };
        let (kernel, exact) = (map.kernel(Side::Source)[k], exact::disk::poisson_kernel(z, t));
        assert!((kernel - exact).abs() < 0.02 * exact.max(0.1), "ψ({t}) = {kernel}, exact {exact}");
        let (measure, exact) = (map.measure(Side::Source).at_vertex(k), exact::disk::harmonic_measure(z, t));
        assert!((measure - exact).abs() < 5e-4, "ω({t}) = {measure}, exact {exact}");
    }
}

/// The fraction of arc length at the boundary point nearest to `p`.
fn anchor_at(domain: &PreparedSide, p: DVec2) -> f64 {
    domain.fraction_at(domain.domain().unwrap().samples().nearest(p))
}

fn figure_7_error(m: u32, settings: MapSettings) -> f64 {
    let disk = domain(Preset::Disk, uniform(m));
    let constraints = Constraints::new(
        (DVec2::new(0.6, 0.2), anchor_at(&disk, DVec2::X)),
        (DVec2::new(0.0, -0.5), anchor_at(&disk, DVec2::X)),
    );
    let map = complete_map(&disk, &disk, &constraints, settings);
    let vertices = map.mapped().domain().unwrap().mesh().vertices();
    let error = |(v, w): (&DVec2, &DVec2)| {
        let (from, to) = match settings.direction {
            Direction::Forward => (v, w),
            Direction::Backward => (w, v),
        };
        let exact = exact::disk::figure_7(complex(*from));
        point(exact).distance(*to)
    };
    vertices.iter().zip(map.images()).map(error).sum::<f64>() / vertices.len() as f64
}

#[test]
fn moebius_map_of_figure_7_converges() {
    for settings in FOUR_MAPPINGS {
        let errors: Vec<f64> = [50, 100, 200, 400].into_iter().map(|m| figure_7_error(m, settings)).collect();
        println!("Figure 7, {settings:?}: mean errors {errors:.6?}");
        // inscribed polygons and linear elements: second order, apart from the coarsest mesh
        assert!(errors[3] < errors[0] / 8.0, "{settings:?}: {errors:?}");
        assert!(errors[3] < 2e-3, "{settings:?}: {errors:?}");
    }
}

#[test]
fn harmonic_coordinates_sum_to_one_and_reproduce_the_point() {
    for preset in Preset::ALL {
        let prepared = domain(preset, PrepareSettings::default());
        let x = locate(prepared.domain().unwrap().mesh(), prepared.domain().unwrap().default_point(), None).unwrap();
        let phi = harmonic_coordinates(&prepared, x).unwrap();
        let sum: f64 = phi.iter().sum();
        let mean: DVec2 = phi.iter().zip(prepared.domain().unwrap().samples().points()).map(|(&w, &v)| w * v).sum();
        assert!((sum - 1.0).abs() < 1e-11, "{}: Σφ = {sum}", preset.name());
        assert!(
            mean.distance(prepared.domain().unwrap().default_point()) < 1e-10,
            "{}: Σφ v = {mean}, x = {}",
            preset.name(),
            prepared.domain().unwrap().default_point()
        );
        assert!(phi.iter().all(|&w| w >= 0.0), "{}: a harmonic coordinate is negative", preset.name());
    }
}

#[test]
fn identity_map_is_identity() {
    let heart = domain(Preset::Heart, PrepareSettings::default());
    for direction in [Direction::Forward, Direction::Backward] {
        let constraints = Constraints::new((heart.default_point(), 0.3), (heart.default_point(), 0.3));
        let map = ConformalMap::new(heart.clone(), heart.clone(), &constraints, direction.into()).unwrap();
        let error = map
            .images()
            .iter()
            .zip(heart.domain().unwrap().mesh().vertices())
            .map(|(w, v)| w.distance(*v))
            .fold(0.0, f64::max);
        assert!(error < 1e-7, "{direction:?}: {error:e}");
    }
}

/// Moving both anchors to points that the map already matches does not change it.
#[test]
fn map_does_not_depend_on_which_matched_pair_anchors_it() {
    let (source, target) =
        (domain(Preset::Star, PrepareSettings::default()), domain(Preset::Blob, PrepareSettings::default()));
    let mut constraints = Constraints::new((source.default_point(), 0.0), (target.default_point(), 0.0));
    let mut map = ConformalMap::new(source.clone(), target.clone(), &constraints, Direction::Forward.into()).unwrap();
    let before = map.images().to_vec();
    let k = source.boundary_count() / 3;
    constraints.anchors.source = source.fractions()[k];
    constraints.anchors.target = target.fraction_at(map.correspondence().points()[k]);
    map.update(&constraints, Direction::Forward.into()).unwrap();
    let change = map.images().iter().zip(&before).map(|(w, v)| w.distance(*v)).fold(0.0, f64::max);
    // the anchor's image inside a target edge is the root of a quadratic: equal up to rounding divided by ψ
    assert!(change < 1e-6, "the images moved by {change:e}");
}

#[test]
fn there_and_back_is_the_identity_up_to_the_mesh() {
    let (source, target) =
        (domain(Preset::Gingerbread, PrepareSettings::default()), domain(Preset::Heart, PrepareSettings::default()));
    let constraints = Constraints::new((source.default_point(), 0.0), (target.default_point(), 0.0));
    let there = ConformalMap::new(source.clone(), target.clone(), &constraints, Direction::Forward.into()).unwrap();
    let back = ConformalMap::new(source.clone(), target, &constraints, Direction::Backward.into()).unwrap();
    let mut errors: Vec<f64> = Vec::new();
    for v in &source.domain().unwrap().mesh().vertices()[source.boundary_count()..] {
        if let Some(z) = there.image_of(*v).and_then(|w| back.image_of(w)) {
            errors.push(z.distance(*v));
        }
    }
    errors.sort_by(f64::total_cmp);
    let median = errors[errors.len() / 2];
    assert!(errors.len() * 10 > source.interior_count() * 9, "only {} images lie inside", errors.len());
    assert!(median < 5e-3, "median error {median:e}");
}

/// x in the tip of the V: measures down to 1e-30 and below remain positive and in order.
#[test]
fn measures_of_the_far_arm_stay_positive_and_in_order() {
    let map = v_to_blob(uniform(1000), PrepareSettings::default());
    let kernel = map.kernel(Side::Source);
    let smallest = kernel.iter().copied().filter(|&v| v > 0.0).fold(f64::INFINITY, f64::min);
    println!("smallest ψ = {smallest:e}");
    assert!(kernel.iter().all(|&v| v >= 0.0));
    let mut tip = Constraints::new((DVec2::new(0.992, 0.985), 0.5), (BLOB_CENTRE, 0.25));
    let v = map.side(Side::Source).clone();
    let inside = v.domain().unwrap().nearest_inside(tip.points.source.in_plane().unwrap(), 1e-3);
    tip = tip.with_point(Side::Source, inside);
    let map = ConformalMap::new(v, map.side(Side::Target).clone(), &tip, Direction::Forward.into()).unwrap();
    let smallest = map.kernel(Side::Source).iter().copied().fold(f64::INFINITY, f64::min);
    println!("smallest ψ from the tip = {smallest:e}");
    assert!(smallest < 1e-30, "the tip should crowd: {smallest:e}");
    assert!(map.images().iter().all(|w| w.is_finite()));
    let points = map.correspondence().points();
    let start = map.side(Side::Source).at_fraction(0.5).edge() as usize + 1;
    let (target_start, count) = (map.side(Side::Target).at_fraction(0.25), points.len());
    let mt = map.side(Side::Target).boundary_count() as f64;
    let along = |k: usize| {
        let (vertex, p) = ((start + k) % count, points[(start + k) % count]);
        if p == target_start && map.measure(Side::Source).at_vertex(vertex) > 0.5 {
            return mt; // all the way around: the anchor again
        }
        let turn = f64::from(p.edge()) - f64::from(target_start.edge()) + (p.fraction() - target_start.fraction());
        turn.rem_euclid(mt)
    };
    for k in 1..count - 1 {
        assert!(along(k) >= along(k - 1), "images out of order at sample {k}: {} after {}", along(k), along(k - 1));
    }
}

#[test]
fn coarse_samplings_work() {
    let polygon = SimplePolygon::try_from(vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y]).unwrap();
    for count in [3, 4, 5, 8] {
        let coarse = Arc::new(prepare(&polygon, &uniform(count), &mut |_| ()).unwrap());
        let constraints = Constraints::new((coarse.default_point(), 0.1), (coarse.default_point(), 0.6));
        let map = ConformalMap::new(coarse.clone(), coarse, &constraints, Direction::Backward.into()).unwrap();
        assert!(map.images().iter().all(|w| w.is_finite()), "m = {count}");
    }
}

/// Median and 95th percentile of distances, relative to the extent of `samples`.
fn spread(distances: impl Iterator<Item = f64>, samples: &[DVec2]) -> [f64; 2] {
    let extent = samples.iter().map(|v| v.distance(samples[0])).fold(0.0, f64::max);
    let mut distances: Vec<f64> = distances.map(|d| d / extent).collect();
    distances.sort_by(f64::total_cmp);
    [distances[distances.len() / 2], distances[distances.len() * 95 / 100]]
}

/// `[f̃ to f̂ forward, f̃ to f̂ backward, forward and back with f̃, with f̂]` at m samples.
fn figure_8_differences(m: u32) -> [[f64; 2]; 4] {
    let sampling = Sampling::Uniform { count: m, keep_corners: true };
    let settings = PrepareSettings::new(sampling, Sizing::Graded(15.0 / f64::from(m)));
    let (source, target) = (domain(Preset::Gingerbread, settings), domain(Preset::Blob, settings));
    let constraints = Constraints::new((source.default_point(), 0.0), (target.default_point(), 0.0));
    let [forward, forward_cauchy, backward, backward_cauchy] =
        FOUR_MAPPINGS.map(|settings| complete_map(&source, &target, &constraints, settings));
    let between = |a: &ConformalMap, b: &ConformalMap, samples: &[DVec2]| {
        spread(a.images().iter().zip(b.images()).map(|(v, w)| v.distance(*w)), samples)
    };
    let there_and_back = |there: &ConformalMap, back: &ConformalMap| {
        let vertices = &source.domain().unwrap().mesh().vertices()[source.boundary_count()..];
        let returned = |v: &DVec2| Some(there.image_of(*v).and_then(|w| back.image_of(w))?.distance(*v));
        spread(vertices.iter().filter_map(returned), source.domain().unwrap().samples().points())
    };
    [
        between(&forward, &forward_cauchy, target.domain().unwrap().samples().points()),
        between(&backward, &backward_cauchy, source.domain().unwrap().samples().points()),
        there_and_back(&forward, &backward),
        there_and_back(&forward_cauchy, &backward_cauchy),
    ]
}

/// Figure 8: the four mappings differ at low resolution and agree at high resolution.
#[test]
fn four_mappings_of_figure_8_agree_at_fine_resolution() {
    let (coarse, fine) = (figure_8_differences(150), figure_8_differences(1200));
    println!("median and 95 % of f̃ − f̂ forward, backward, there and back with f̃, with f̂:\n{coarse:?}\n{fine:?}");
    for (coarse, fine) in coarse.iter().zip(fine) {
        // 8 times as fine: convergence of first to second order
        assert!(fine[0] < coarse[0] / 8.0, "{coarse:?}, {fine:?}");
        assert!(fine[0] < 5e-4, "{fine:?}");
    }
    // a thousandth of the extent is about a pixel
    assert!(fine[0][1] < 1e-3 && fine[1][1] < 1e-3, "f̃ − f̂: {fine:?}");
    // at the tips of the limbs, where images are crowded, neither extension returns well
    assert!(fine[3][1] < 1.5 * fine[2][1] && fine[2][1] < 1e-2, "there and back: {fine:?}");
}

/// The images are the same in chunks or at once; until then the images not yet refined are harmonic.
#[test]
fn refinement_replaces_harmonic_images_by_cauchy_green_ones() {
    let heart = domain(Preset::Heart, PrepareSettings::default());
    let disk = domain(Preset::Disk, PrepareSettings::default());
    let mut constraints = Constraints::new((heart.default_point(), 0.0), (DVec2::new(0.2, 0.1), 0.3));
    let [harmonic, complete] =
        [FOUR_MAPPINGS[0], FOUR_MAPPINGS[1]].map(|s| complete_map(&heart, &disk, &constraints, s));
    let mut map = ConformalMap::new(heart.clone(), disk.clone(), &constraints, FOUR_MAPPINGS[1]).unwrap();
    assert_eq!((map.extension_progress(), map.images()), (0.0, harmonic.images()));
    let (mut steps, mut before) = (0, 0.0);
    while !map.refine(0.0) {
        let progress = map.extension_progress();
        assert!(progress > before && progress < 1.0, "{progress} after {before}");
        let done = (progress * map.images().len() as f64).round() as usize;
        assert_eq!(map.images()[..done], complete.images()[..done]);
        assert_eq!(map.images()[done..], harmonic.images()[done..]);
        (steps, before) = (steps + 1, progress);
    }
    assert!(steps > 2, "{steps} steps");
    assert_eq!(map.images(), complete.images());
    assert_eq!(map.correspondence(), harmonic.correspondence());
    // the same settings change nothing; another point starts again; harmonic is complete at once
    map.update(&constraints, FOUR_MAPPINGS[1]).unwrap();
    assert_eq!(map.extension_progress(), 1.0);
    constraints = constraints.with_point(Side::Target, DVec2::new(0.1, 0.1));
    map.update(&constraints, FOUR_MAPPINGS[1]).unwrap();
    assert_eq!(map.extension_progress(), 0.0);
    map.update(&constraints, FOUR_MAPPINGS[0]).unwrap();
    assert!(map.extension_progress() == 1.0 && map.refine(0.0));
    let expected = complete_map(&heart, &disk, &constraints, FOUR_MAPPINGS[0]);
    assert_eq!(map.images(), expected.images());
}

/// The map that takes −i to the blob's center has a closed form on the whole V: g followed by the blob's g⁻¹.
///
/// Mean errors in the interior: of f̃, of f̂, and of f̂ with the exact images of the boundary.
fn v_from_its_middle(m: u32) -> [f64; 3] {
    let (v, blob) = (domain(Preset::VShape, uniform(m)), domain(Preset::Blob, uniform(1000)));
    let constraints = Constraints::new((DVec2::NEG_Y, 0.0), (BLOB_CENTRE, 0.0));
    let exact = |z: &DVec2| point(exact::blob::from_disk(exact::vshape::to_disk(complex(*z))));
    let inside = &v.domain().unwrap().mesh().vertices()[v.boundary_count()..];
    let mean = |images: &mut dyn Iterator<Item = DVec2>| {
        inside.iter().zip(images).map(|(z, w)| exact(z).distance(w)).sum::<f64>() / inside.len() as f64
    };
    let [harmonic, cauchy] = [FOUR_MAPPINGS[0], FOUR_MAPPINGS[1]].map(|settings| {
        let map = complete_map(&v, &blob, &constraints, settings);
        mean(&mut map.images()[v.boundary_count()..].iter().copied())
    });
    let (contour, values) = (
        Contour::new(v.domain().unwrap().samples().points()),
        BoundaryValues::new(v.domain().unwrap().samples().points().iter().map(exact)),
    );
    [harmonic, cauchy, mean(&mut inside.iter().map(|&z| contour.evaluate(z, &values)))]
}

#[test]
fn both_extensions_of_the_v_converge_to_the_closed_form() {
    let errors @ [coarse, _, fine] = [250, 500, 1000].map(v_from_its_middle);
    println!("V → blob from −i, inside, m = 250, 500, 1000: f̃, f̂, f̂ of the exact boundary: {errors:?}");
    assert!((0..3).all(|i| fine[i] < coarse[i] / 4.0), "{errors:?}");
    // f̂ has no maximum principle: the Hilbert transform of the boundary's error adds to it
    assert!(fine[0] < 1e-3 && fine[1] < 3.0 * fine[0] && fine[2] < fine[1], "{errors:?}");
}
