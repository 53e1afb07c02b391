//! Regions as rings: what is joined, turned and refused; the potential against a known one.

use super::*;
use std::f64::consts::PI;

fn rings(rings: &[&[[f64; 2]]]) -> Vec<Vec<DVec2>> {
    rings.iter().map(|ring| ring.iter().map(|&p| DVec2::from_array(p)).collect()).collect()
}

fn area(of: &[&[[f64; 2]]]) -> f64 {
    Region::new(&rings(of)).unwrap().area()
}

/// The area between two meridians and two parallels.
fn rectangle_area(width: f64, [low, high]: [f64; 2]) -> f64 {
    width.to_radians() * (high.to_radians().sin() - low.to_radians().sin())
}

fn assert_near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() < 1e-12, "{what}: {found} instead of {expected}");
}

#[test]
fn the_area_does_not_depend_on_direction_or_place() {
    let expected = rectangle_area(20.0, [10.0, 30.0]);
    for west in [0.0, 170.0, -190.0, 175.0] {
        let mut ring = [[west, 10.0], [west + 20.0, 10.0], [west + 20.0, 30.0], [west, 30.0]];
        assert_near(area(&[&ring]), expected, "counter-clockwise");
        ring.reverse();
        assert_near(area(&[&ring]), expected, "clockwise");
    }
    // across the antimeridian by a jump of longitude
    let jump = [[170.0, 10.0], [-170.0, 10.0], [-170.0, 30.0], [170.0, 30.0]];
    assert_near(area(&[&jump]), expected, "jump");
}

#[test]
fn parts_cut_at_the_antimeridian_become_one_region() {
    let east = [[170.0, 10.0], [180.0, 10.0], [180.0, 30.0], [170.0, 30.0]];
    let west = [[-180.0, 10.0], [-170.0, 10.0], [-170.0, 30.0], [-180.0, 30.0], [-180.0, 20.0]];
    let island = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    let region = Region::new(&rings(&[&island, &east, &west])).unwrap();
    assert_near(region.area(), rectangle_area(20.0, [10.0, 30.0]), "joined");
    assert_eq!(region.selection().rings, [2, 3]);
    assert_eq!(region.selection().left_out, 1);
    // a narrower side touches a part of the cut
    let narrow = [[-180.0, 15.0], [-170.0, 15.0], [-170.0, 25.0], [-180.0, 25.0]];
    let expected = rectangle_area(10.0, [10.0, 30.0]) + rectangle_area(10.0, [15.0, 25.0]);
    assert_near(area(&[&east, &narrow]), expected, "narrow");
}

#[test]
fn a_cap_around_a_pole_may_be_cut_or_wind_around_it() {
    let expected = 2.0 * PI * (1.0 - 60.0_f64.to_radians().sin());
    let winding: Vec<[f64; 2]> = (0..36).map(|k| [-180.0 + 10.0 * f64::from(k), 60.0]).collect();
    assert_near(area(&[&winding]), expected, "around the north pole");
    let mut backward = winding.clone();
    backward.reverse();
    assert_near(area(&[&backward]), expected, "backward");
    let south: Vec<[f64; 2]> = winding.iter().map(|p| [p[0], -60.0]).collect();
    assert_near(area(&[&south]), expected, "around the south pole");
    let mut cut: Vec<[f64; 2]> = (0..=36).map(|k| [-180.0 + 10.0 * f64::from(k), -60.0]).collect();
    cut.extend([[180.0, -80.0], [180.0, -90.0], [-180.0, -90.0], [-180.0, -70.0]]);
    assert_near(area(&[&cut]), expected, "cut from the pole");
    let few = [[-180.0, 60.0], [180.0, 60.0], [180.0, 90.0], [-180.0, 90.0]];
    assert_near(area(&[&few]), expected, "cut, in four points");
}

#[test]
fn a_region_larger_than_a_hemisphere_keeps_its_side() {
    // all but a rectangle around the north pole
    let below = [[-180.0, -90.0], [180.0, -90.0], [180.0, 50.0], [-180.0, 50.0]];
    assert_near(area(&[&below]), 2.0 * PI * (1.0 + 50.0_f64.to_radians().sin()), "below 50°");
    let wide = [[-170.0, -80.0], [0.0, -80.0], [170.0, -80.0], [170.0, 80.0], [0.0, 80.0], [-170.0, 80.0]];
    assert_near(area(&[&wide]), rectangle_area(340.0, [-80.0, 80.0]), "wide");
}

#[test]
fn what_is_no_region_is_refused_with_its_place() {
    let error = |of: &[&[[f64; 2]]]| Region::new(&rings(of)).unwrap_err().to_string();
    let good = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    let says = |found: String, words: &[&str]| {
        for word in words {
            assert!(found.contains(word), "no {word:?} in {found}");
        }
    };
    says(error(&[&good, &[[0.0, 0.0], [1.0, 91.0], [1.0, 1.0]]]), &["point 2 of ring 2", "91°"]);
    says(error(&[&[[0.0, 0.0], [400.0, 1.0], [1.0, 1.0]]]), &["point 2 of ring 1", "400°"]);
    says(error(&[&[[0.0, 0.0], [1.0, 1.0], [1.0, 1.0]]]), &["ring 1", "2 different points"]);
    let bow = [[10.0, 0.0], [12.0, 2.0], [12.0, 0.0], [10.0, 3.0]];
    says(error(&[&bow]), &["crosses itself at longitude 11.2", "point 1 of ring 1", "point 3 of ring 1"]);
    let sphere = [[-180.0, -90.0], [180.0, -90.0], [180.0, 90.0], [-180.0, 90.0]];
    says(error(&[&sphere]), &["whole sphere"]);
    let most = [[-179.8, -89.9], [0.0, -89.9], [179.8, -89.9], [179.8, 89.9], [0.0, 89.9], [-179.8, 89.9]];
    says(error(&[&most]), &["almost the whole sphere"]);
}

#[test]
fn the_fitted_function_is_the_harmonic_one() {
    // an L about the origin: Re z³ is its own extension
    let l = [[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [10.0, 10.0], [10.0, 20.0], [0.0, 20.0]];
    let region = Region::new(&rings(&[&l])).unwrap();
    let cube = |z: DVec2| z.x * z.x * z.x - 3.0 * z.x * z.y * z.y + z.x;
    let fitted = potential::fit(&region, &cube, &mut |_| true).unwrap();
    assert!(fitted.residual < 1e-9, "{:e}", fitted.residual);
    let z = region.polygon().pole_of_inaccessibility(1e-3);
    let found = fitted.potential.value(z).re;
    assert!((found - cube(z)).abs() < 1e-9, "{found} instead of {}", cube(z));
}

#[test]
fn scale_of_the_map_is_that_of_the_images() {
    let l = [[0.0, 40.0], [20.0, 40.0], [20.0, 50.0], [10.0, 50.0], [10.0, 60.0], [0.0, 60.0]];
    let projection = Projection::new(Region::new(&rings(&[&l])).unwrap()).unwrap();
    println!("residual {:e}, ratio {}", projection.residual(), projection.scale_ratio());
    let at = DVec2::new(7.0, 48.0);
    let step = 1e-4;
    let (image, scale) = projection.image(at).unwrap();
    let moved = |d: DVec2| (projection.image(at + d).unwrap().0 - projection.image(at - d).unwrap().0) / 2.0;
    let east = moved(DVec2::new(step, 0.0)) / (step.to_radians() * at.y.to_radians().cos());
    let north = moved(DVec2::new(0.0, step)) / step.to_radians();
    assert!(image.is_finite() && (east.length() - scale).abs() < 1e-7, "{} and {scale}", east.length());
    assert!(north.distance(east.perp()) < 1e-7, "{north} and {east}");
    // the image of the boundary is closed, and as long as the boundary, where the scale is 1
    let length = |points: &[DVec2]| (0..points.len()).map(|k| points[k].distance(points[(k + 1) % points.len()])).sum();
    let on_sphere: Vec<_> = projection.region().lon_lat().iter().map(|&p| sphere::on_sphere(p)).collect();
    let n = on_sphere.len();
    let expected: f64 = (0..n).map(|k| on_sphere[k].distance(on_sphere[(k + 1) % n])).sum();
    let found: f64 = length(projection.boundary());
    assert!((found / expected - 1.0).abs() < 2.0 * projection.residual() + 1e-5, "{found} and {expected}");
}

/// The largest scale is on the boundary, at one of its points or between two.
#[test]
fn the_largest_scale_is_found_between_the_points_of_the_boundary() {
    let l = [[0.0, 40.0], [20.0, 40.0], [20.0, 50.0], [10.0, 50.0], [10.0, 60.0], [0.0, 60.0]];
    let projection = Projection::new(Region::new(&rings(&[&l])).unwrap()).unwrap();
    let vertices = projection.region.polygon().vertices();
    let n = vertices.len();
    let log = |k: usize, share: f64| projection.development.log_scale(vertices[k].lerp(vertices[(k + 1) % n], share));
    let at_points = (0..n).map(|k| log(k, 0.0)).fold(f64::NEG_INFINITY, f64::max);
    let dense = (0..n).flat_map(|k| (0..200).map(move |j| (k, f64::from(j) / 200.0)));
    let values: Vec<f64> = dense.map(|(k, share)| log(k, share)).collect();
    let [lowest, most] = [f64::min, f64::max].map(|of| values.iter().copied().reduce(of).unwrap());
    let (found, residual) = (projection.most_log, projection.residual());
    println!("largest log k: {at_points:.6e} at points, {most:.6e} on a dense set, {found:.6e} found; {residual:.3e}");
    assert!(at_points <= found && most <= found + 1e-15 && found <= most + 0.01 * most.abs());
    assert!(residual >= most && residual >= -lowest);
}

/// Latitudes whose sums and differences round.
#[test]
fn cuts_are_joined_at_any_latitude() {
    for [low, high] in [[-4.14, 8.1], [2.17, 28.17], [-0.1, 0.7], [-9.99, 1.01]] {
        let east = [[170.0, low], [180.0, low], [180.0, high], [170.0, high]];
        let mut west = [[-180.0, low], [-170.3, low], [-170.3, high], [180.0, high]];
        let expected = rectangle_area(19.7, [low, high]);
        assert_near(area(&[&east, &west]), expected, "both counter-clockwise");
        west.reverse();
        assert_near(area(&[&east, &west]), expected, "one clockwise");
    }
    let cap = [[-180.0, -31.7], [180.0, -31.7], [180.0, 90.0], [-180.0, 90.0]];
    assert_near(area(&[&cap]), 2.0 * PI * (1.0 + 31.7_f64.to_radians().sin()), "cut from the pole");
}

#[test]
fn a_hole_between_joined_parts_is_filled() {
    // around a lake on the antimeridian
    let east = [
        [170.0, -20.0],
        [180.0, -20.0],
        [180.0, -4.0],
        [178.0, -4.0],
        [178.0, 4.0],
        [180.0, 4.0],
        [180.0, 20.0],
        [170.0, 20.0],
    ];
    let west = east.map(|[x, y]| [-x, y]);
    let region = Region::new(&rings(&[&east, &west])).unwrap();
    assert_near(region.area(), rectangle_area(20.0, [-20.0, 20.0]), "filled");
    assert_eq!((region.selection().holes, region.selection().left_out, region.selection().share), (1, 0, 1.0));
    // a band around the pole
    let parallel = |latitude: f64| (0..=36).map(move |k| [-180.0 + 10.0 * f64::from(k), latitude]);
    let band: Vec<[f64; 2]> = parallel(60.0).chain(parallel(70.0).rev()).collect();
    assert_near(area(&[&band]), 2.0 * PI * (1.0 - 60.0_f64.to_radians().sin()), "band");
}

#[test]
fn small_regions_with_few_corners_have_a_mesh() {
    for corners in
        [&[[10.0, 0.0], [10.1, 0.0], [10.05, 0.08]][..], &[[10.0, 50.0], [10.1, 50.0], [10.1, 50.1], [10.0, 50.1]]]
    {
        let projection = Projection::new(Region::new(&rings(&[corners])).unwrap()).unwrap();
        assert!(projection.mesh().vertices().len() > 100);
        let ratio = projection.scale_ratio() - 1.0;
        // of the order of the squared radius, in radians
        assert!(ratio > 1e-8 && ratio < 1e-6, "{ratio:e}");
        let at = projection.least_scale_at();
        assert!(projection.region().contains(on_sphere(at)), "{at}");
    }
}

#[test]
fn a_small_cap_around_a_pole_has_few_meridians() {
    let ring: Vec<[f64; 2]> = (0..200).map(|k| [-180.0 + 1.8 * f64::from(k), 89.95]).collect();
    let projection = Projection::new(Region::new(&rings(&[&ring])).unwrap()).unwrap();
    let graticule = projection.graticule();
    assert!(graticule.meridians.len() <= 80, "{}", graticule.meridians.len());
    assert!(projection.lattice().len() < 100_000);
}
