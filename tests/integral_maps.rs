//! Maps whose harmonic measures are from the integral equation on the boundary, compared with exact ones: V-shape →
//! blob, the disk's Möbius maps, the square's elliptic function, the L-shape; and what happens where it does not fit.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::boundary_integral::{BoundaryIntegral, BoundaryIntegralError, Settings};
use riemap::conformal::{
    ConformalMap, Constraints, Direction, ErrorEstimate, KernelMode, MAX_UNKNOWNS, MapError, PrepareError,
    PrepareSettings, PreparedSide, Side, SurfaceSettings, Unsharpened, prepare, prepare_curve, prepare_surface,
};
use riemap::exact::{self, blob, complex, point, square, vshape};
use riemap::geometry::{Curve, DVec2, SimplePolygon};
use riemap::mesh::Sizing;
use riemap::outline::{BoundaryPoint, Preset, Sampling};
use riemap::surface::{SurfaceMesh, SurfacePreset};
use std::f64::consts::TAU;
use std::sync::Arc;
use support::domains::domain;

const BLOB_CENTER: DVec2 = DVec2::new(2.677_813_229_026_218, 2.466_851_711_366_240_7);
const V_POINT: DVec2 = DVec2::new(0.96, 0.8432);

fn integral(settings: PrepareSettings) -> PrepareSettings {
    settings.with_kernel(KernelMode::Integral)
}

/// A preset, prepared for measures from `near`.
fn curved(preset: Preset, near: &[DVec2], settings: PrepareSettings) -> Arc<PreparedSide> {
    let (outline, curve) = (preset.outline(), preset.curve().unwrap());
    let side = prepare_curve((outline.polygon(), &curve), near, &integral(settings), &mut |_| ()).unwrap();
    assert_eq!(side.unsharpened(), None, "{preset}");
    Arc::new(side)
}

fn uniform(count: u32) -> PrepareSettings {
    PrepareSettings::new(Sampling::Uniform { count, keep_corners: false }, Sizing::Uniform)
}

/// The boundary vertices of the mapped side.
fn vertices(map: &ConformalMap) -> &[DVec2] {
    map.domain(map.mapped_side()).unwrap().samples().points()
}

/// The largest error of the boundary images, of which the estimate covers at least 95 %, and the estimate.
fn image_error(name: &str, map: &ConformalMap, exact: impl Fn(usize) -> DVec2) -> f64 {
    let ErrorEstimate { omega, image, points } = map.error_estimate().unwrap();
    let errors: Vec<f64> = (0..points.len()).map(|k| map.images()[k].distance(exact(k))).collect();
    let covered = errors.iter().zip(&points).filter(|(error, estimate)| error <= estimate).count();
    let largest = errors.iter().copied().fold(0.0, f64::max);
    println!(
        "{name}: images off by {largest:.1e}, estimated {image:.1e}; ω estimated {omega:.1e}; {covered} of {} covered",
        points.len()
    );
    assert!(largest <= image, "{name}: {largest:e} is not covered by {image:e}");
    assert!(covered as f64 >= 0.95 * points.len() as f64, "{name}: {covered} of {} are covered", points.len());
    largest
}

fn forward(source: &Arc<PreparedSide>, target: &Arc<PreparedSide>, constraints: Constraints) -> ConformalMap {
    ConformalMap::new(source.clone(), target.clone(), &constraints, Direction::Forward.into()).unwrap()
}

#[test]
fn v_shape_to_blob_has_eight_digits() {
    let (v, blob_side) = (
        curved(Preset::VShape, &[V_POINT], PrepareSettings::default()),
        curved(Preset::Blob, &[BLOB_CENTER], PrepareSettings::default()),
    );
    let map = forward(&v, &blob_side, Constraints::new((V_POINT, 0.0), (BLOB_CENTER, 0.0)));
    let exact: Vec<f64> = vertices(&map).iter().map(|&y| vshape::harmonic_measure(V_POINT, y)).collect();
    let off = exact.iter().enumerate().map(|(k, omega)| (map.measure(Side::Source).at_vertex(k) - omega).abs());
    let off = off.fold(0.0, f64::max);
    println!("ω off by {off:.1e}, estimated {:.1e}", map.error_estimate().unwrap().omega);
    assert!(off < 1e-10, "{off:e}");
    let error = image_error("V → blob", &map, |k| blob::boundary(exact[k]));
    assert!(error < 1e-8, "{error:e}");
}

#[test]
fn moebius_maps_of_the_disk_are_exact() {
    let (a, b) = (DVec2::new(0.6, 0.2), DVec2::new(0.0, -0.5));
    for settings in [PrepareSettings::default(), uniform(50)] {
        let disk = curved(Preset::Disk, &[a, b], settings);
        let map = forward(&disk, &disk, Constraints::new((a, 0.0), (b, 0.0)));
        let places = vertices(&map).to_vec();
        let error = image_error("disk → disk", &map, |k| point(exact::disk::figure_7(complex(places[k]))));
        assert!(error < 1e-12, "{error:e}");
    }
}

#[test]
fn the_square_is_mapped_by_the_elliptic_function_both_ways() {
    let square_side = curved(Preset::Square, &[], PrepareSettings::default());
    let disk = curved(Preset::Disk, &[], PrepareSettings::default());
    let constraints = Constraints::new((DVec2::ZERO, 0.0), (DVec2::ZERO, 0.0));
    let map = forward(&square_side, &disk, constraints);
    let fractions = square_side.fractions();
    let error = image_error("square → disk", &map, |k| DVec2::from_angle(square::boundary_angle(fractions[k])));
    assert!(error < 2e-12, "{error:e}");
    // next to a corner an error Δω becomes √Δω
    let back = forward(&disk, &square_side, constraints);
    let angles: Vec<f64> = vertices(&back).iter().map(|p| p.to_angle().rem_euclid(TAU)).collect();
    let inverse = |angle: f64| {
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if square::boundary_angle(middle) < angle { low = middle } else { high = middle }
        }
        square_side.curve_boundary().unwrap().curve().position(square_side.curve_boundary().unwrap().at_fraction(low))
    };
    let error = image_error("disk → square", &back, |k| inverse(angles[k]));
    assert!(error < 1e-6 && back.error_estimate().unwrap().omega < 1e-12, "{error:e}");
    let shares = Side::BOTH.map(|side| back.continued_share(side));
    assert_eq!((shares, back.coinciding_edges()), ([0.0, 0.0], 0));
}

fn polygon(points: &[(f64, f64)]) -> SimplePolygon {
    SimplePolygon::try_from(points.iter().map(|&p| p.into()).collect::<Vec<DVec2>>()).unwrap()
}

#[test]
fn a_files_polygon_has_the_measures_of_the_l_shape() {
    let l = polygon(&[(0., 0.), (2., 0.), (2., 1.), (1., 1.), (1., 2.), (0., 2.)]);
    let side = Arc::new(prepare(&l, &integral(PrepareSettings::default()), &mut |_| ()).unwrap());
    let disk = curved(Preset::Disk, &[], PrepareSettings::default());
    let map = forward(&side, &disk, Constraints::new((DVec2::new(0.5, 0.5), 0.0), (DVec2::ZERO, 0.0)));
    let [long, inner] = [0.394_497_233_238_905_2, 0.092_199_674_737_061_53];
    let end = 0.5 - long - inner;
    let omega = |place: DVec2| {
        let k = vertices(&map).iter().position(|&p| p == place).unwrap();
        map.measure(Side::Source).at_vertex(k)
    };
    let mut sum = 0.0;
    for (corner, step) in l.vertices()[1..].iter().zip([long, end, inner, inner, end]) {
        sum += step;
        let off = (omega(*corner) - sum).abs();
        assert!(off < 1e-12, "at {corner}: off by {off:e}");
    }
}

/// Weakly monotone, and close to the finite-element map, for every pair with the next preset.
#[test]
fn images_keep_the_order_and_agree_with_finite_elements() {
    for (k, source) in Preset::ALL.into_iter().enumerate() {
        let target = Preset::ALL[(k + 1) % Preset::ALL.len()];
        let [a, b] = [source, target].map(|preset| curved(preset, &[], PrepareSettings::default()));
        let constraints = Constraints::new((a.default_point(), 0.3), (b.default_point(), 0.6));
        for direction in [Direction::Forward, Direction::Backward] {
            let map = ConformalMap::new(a.clone(), b.clone(), &constraints, direction.into()).unwrap();
            let mapped = map.mapped_side();
            let (measure, other) = (map.measure(mapped), map.side(mapped.other()));
            assert!(measure.at_knots().windows(2).all(|pair| pair[0] <= pair[1]), "{source} → {target}: ω decreases");
            assert_eq!((measure.at_knots()[0], *measure.at_knots().last().unwrap()), (0.0, 1.0));
            let anchor = constraints.anchors[mapped.other()];
            let from_anchor = |&k: &usize| {
                let (image, _) = map.correspondence().on_curve(k).unwrap();
                let along = (map.image_fraction(image) - anchor + 1e-12).rem_euclid(1.0);
                // an image at the anchor, which the boundary ends with too
                if measure.at_vertex(k) > 0.9 && along < 2e-12 { 1.0 } else { along }
            };
            let along: Vec<f64> = measure.vertices().collect::<Vec<_>>().iter().map(from_anchor).collect();
            let falls = along.windows(2).filter(|pair| pair[1] < pair[0] - 1e-13).count();
            assert_eq!(falls, 0, "{source} → {target}, {direction:?}");
            assert!(map.images().iter().all(|w| w.is_finite()) && map.error_estimate().is_some());
            assert!(other.curve_boundary().is_some());
        }
    }
}

#[test]
fn finite_elements_agree_up_to_their_own_error() {
    let constraints = |side: [&Arc<PreparedSide>; 2]| {
        Constraints::new((side[0].default_point(), 0.1), (side[1].default_point(), 0.2))
    };
    let presets = [Preset::Heart, Preset::Disk];
    let [a, b] = presets.map(|preset| curved(preset, &[], PrepareSettings::default()));
    let [c, d] = presets.map(|preset| domain(preset, PrepareSettings::default()));
    let sharp = forward(&a, &b, constraints([&a, &b]));
    let plain = forward(&c, &d, constraints([&c, &d]));
    assert!(plain.error_estimate().is_none() && !plain.measure(Side::Source).is_sharp());
    let m = plain.mapped().boundary_count();
    assert_eq!(m, sharp.mapped().boundary_count());
    let apart = (0..m).map(|k| sharp.images()[k].distance(plain.images()[k])).fold(0.0, f64::max);
    println!("heart → disk: finite elements are off by up to {apart:.1e}");
    assert!(apart < 1e-2, "{apart:e}");
}

/// Around an anchor in the tip of the V, the measure from its middle falls to 1e-17.
#[test]
fn finite_elements_continue_where_the_measure_vanishes() {
    let middle = DVec2::new(0.0, -1.0);
    let v = curved(Preset::VShape, &[middle], PrepareSettings::default());
    let blob_side = curved(Preset::Blob, &[], PrepareSettings::default());
    let constraints = Constraints::new((middle, 0.0), (BLOB_CENTER, 0.0));
    for direction in [Direction::Forward, Direction::Backward] {
        let map = ConformalMap::new(v.clone(), blob_side.clone(), &constraints, direction.into()).unwrap();
        let share = map.continued_share(Side::Source);
        assert!(share > 0.01 && share < 0.9 && map.continued_share(Side::Target) == 0.0, "{share}");
        assert!(map.images().iter().all(|w| w.is_finite()));
        let knots = map.measure(Side::Source).at_knots();
        let small: Vec<f64> = knots.iter().copied().filter(|&omega| omega < 1e-9).collect();
        println!("{} knots below 1e-9, the first is {:e}; a share of {share:.3}", small.len(), small[1]);
        assert!(small.windows(2).all(|pair| pair[0] < pair[1]), "knots next to the anchor coincide");
        if direction == Direction::Forward {
            let exact = |k: usize| vshape::harmonic_measure(middle, vertices(&map)[k]);
            for j in (1..small.len()).filter(|&j| small[j] > 1e-15) {
                let (found, exact) = (small[j], exact(j));
                assert!((found / exact - 1.0).abs() < 0.2, "knot {j}: {found:e} for {exact:e}");
            }
        }
    }
}

#[test]
fn one_side_may_have_finite_elements() {
    let disk = curved(Preset::Disk, &[], PrepareSettings::default());
    let plain = domain(Preset::Disk, PrepareSettings::default());
    let constraints = Constraints::new((DVec2::new(0.4, 0.1), 0.0), (DVec2::new(0.0, -0.3), 0.0));
    let both = forward(&disk, &disk, constraints);
    for (a, b) in [(&disk, &plain), (&plain, &disk)] {
        let map = forward(a, b, constraints);
        assert!(map.error_estimate().is_none());
        let apart = map.images().iter().zip(both.images()).map(|(v, w)| v.distance(*w));
        let apart = (0..disk.boundary_count()).zip(apart).map(|pair| pair.1).fold(0.0, f64::max);
        assert!(apart < 1e-2, "{apart:e}");
    }
}

#[test]
fn a_point_between_mesh_and_curve_is_inside_and_one_beyond_is_not() {
    let disk = curved(Preset::Disk, &[DVec2::from_angle(0.4) * 0.98], uniform(8));
    let x = DVec2::from_angle(0.4) * 0.98;
    assert!(prepare(Preset::Disk.outline().polygon(), &uniform(8), &mut |_| ()).is_ok_and(|octagon| {
        let constraints = Constraints::new((x, 0.0), (DVec2::ZERO, 0.0));
        let octagon = Arc::new(octagon);
        ConformalMap::new(octagon.clone(), octagon, &constraints, Direction::Forward.into()).is_err()
    }));
    let map = forward(&disk, &disk, Constraints::new((x, 0.0), (DVec2::ZERO, 0.0)));
    for (k, y) in vertices(&map).iter().enumerate() {
        let exact = exact::disk::moebius(complex(x), complex(DVec2::X), complex(*y));
        let off = map.images()[k].distance(point(exact));
        assert!(off < 1e-9, "{k}: {off:e}");
    }
    let outside = Constraints::new((1.01 * DVec2::X, 0.0), (DVec2::ZERO, 0.0));
    let refused = ConformalMap::new(disk.clone(), disk, &outside, Direction::Forward.into()).unwrap_err();
    assert_eq!(refused, MapError::PointOutside { side: Side::Source, x: 1.01, y: 0.0 });
}

#[test]
fn what_does_not_fit_stays_with_finite_elements_and_says_so() {
    let star = |k: u32| {
        let p = (if k.is_multiple_of(2) { 1.0 } else { 0.8 }) * DVec2::from_angle(TAU * f64::from(k) / 4200.0);
        (p.x, p.y)
    };
    let many = polygon(&(0..4200).map(star).collect::<Vec<_>>());
    let side = prepare(&many, &integral(PrepareSettings::default()), &mut |_| ()).unwrap();
    let expected =
        |reason: &Unsharpened| matches!(reason, Unsharpened::Integral(BoundaryIntegralError::TooManyUnknowns { .. }));
    assert!(side.unsharpened().is_some_and(expected) && side.curve_boundary().is_none());
    let plain = prepare(&many, &PrepareSettings::default(), &mut |_| ()).unwrap();
    let constraints = Constraints::new((side.default_point(), 0.0), (side.default_point(), 0.25));
    let maps = [side, plain].map(Arc::new).map(|side| forward(&side, &side, constraints));
    assert_eq!(maps[0].images(), maps[1].images());
    let surface = SurfaceMesh::new(&SurfacePreset::ALL[0].surface(60).unwrap()).unwrap();
    let settings = SurfaceSettings::default().with_kernel(KernelMode::Integral);
    let refused = prepare_surface(surface, settings, &mut |_| ()).unwrap_err();
    assert_eq!(refused, PrepareError::IntegralOfSurface);
}

/// Anchors inside of edges, and re-anchoring: the map through two matched boundary points is the same.
#[test]
fn the_map_does_not_depend_on_which_matched_pair_anchors_it() {
    let [a, b] = [Preset::Cinquefoil, Preset::Heart].map(|preset| curved(preset, &[], PrepareSettings::default()));
    let constraints = Constraints::new((a.default_point(), 0.123), (b.default_point(), 0.777));
    let mut map = forward(&a, &b, constraints);
    let before = map.images()[..a.boundary_count()].to_vec();
    let k = a.boundary_count() / 3;
    let image = map.image_fraction(map.correspondence().on_curve(k).unwrap().0);
    let moved = Constraints::new(
        (a.default_point(), a.fraction_at(BoundaryPoint::new(k as u32, 0.0))),
        (b.default_point(), image),
    );
    map.update(&moved, Direction::Forward.into()).unwrap();
    let change = map.images().iter().zip(&before).map(|(w, v)| w.distance(*v)).fold(0.0, f64::max);
    println!("another pair of anchors moves the images by {change:.1e}");
    assert!(change < 1e-7, "{change:e}");
}

/// Panels for a point next to the boundary would be too many on an outline of many corners: they are left out.
#[test]
fn a_point_next_to_an_outline_of_many_corners_keeps_the_equation() {
    let star = |n: u32| {
        let corner = |k: u32| {
            let p =
                (if k.is_multiple_of(2) { 1.0 } else { 0.8 }) * DVec2::from_angle(TAU * f64::from(k) / f64::from(n));
            (p.x, p.y)
        };
        polygon(&(0..n).map(corner).collect::<Vec<_>>())
    };
    let fits = |outline: &SimplePolygon, near: &[DVec2]| {
        let settings = Settings::default().with_max_unknowns(MAX_UNKNOWNS).with_points(near);
        BoundaryIntegral::check(&Curve::from_polygon(outline).unwrap(), &settings).is_ok()
    };
    let most = star(40);
    assert!(fits(&most, &[]));
    let beside = |ends: &[DVec2]| {
        let [a, b] = [ends[0], ends[1]];
        (1..60).map(move |k| a.lerp(b, f64::from(k) / 60.0) * (1.0 - 1e-9))
    };
    let near: Vec<DVec2> = most.vertices().windows(2).flat_map(beside).collect();
    assert!(!fits(&most, &near), "the points need panels of their own");
    let curve = Curve::from_polygon(&most).unwrap();
    let settings = integral(PrepareSettings::default());
    let side = prepare_curve((&most, &curve), &near, &settings, &mut |_| ()).unwrap();
    assert!(side.unsharpened().is_none(), "{:?}", side.unsharpened());
    let kept = side.with_equation(Err(BoundaryIntegralError::NotResolved.into()));
    assert!(kept.equation().is_some(), "a second equation that fails leaves the first one");
}
