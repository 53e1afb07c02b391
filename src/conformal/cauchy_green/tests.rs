//! Properties of Cauchy–Green coordinates: reproduction, limits, formula, order of convergence.

use super::*;
use crate::conformal::{PrepareSettings, prepare};
use crate::exact::{Complex, complex, disk, point};
use crate::geometry::SimplePolygon;
use crate::mesh::Sizing;
use crate::outline::{Preset, Sampling};
use std::f64::consts::TAU;

/// Σγ and Σγv are sums of about a hundred terms of size ≤ 4 (log 1e-9 / 2π), each accurate to 4 roundings.
const ROUNDING: f64 = 2e-13;

fn coordinates(polygon: &[DVec2], z: DVec2) -> Vec<DVec2> {
    let mut gamma = Vec::new();
    Contour::new(polygon).coordinates(z, &mut gamma);
    gamma
}

fn points(list: &[[f64; 2]]) -> Vec<DVec2> {
    list.iter().map(|&p| DVec2::from_array(p)).collect()
}

/// Polygons with convex, reflex and straight corners; a needle, a slit, a spike next to a short edge.
fn polygons() -> Vec<(&'static str, Vec<DVec2>)> {
    vec![
        ("square", points(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])),
        ("straight corner", points(&[[0.0, 0.0], [0.25, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])),
        ("L", points(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]])),
        ("needle", points(&[[0.0, 0.0], [1.0, -1e-4], [1.0, 1e-4]])),
        ("slit", points(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [1e-6, 1.0], [0.0, 0.0], [-1e-6, 1.0], [-1.0, 1.0]])),
        (
            "spike",
            points(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.5], [7.0, 0.5 + 1e-5], [1.0, 0.5 + 2e-5], [1.0, 1.0], [0.0, 1.0]]),
        ),
    ]
}

/// The unit vector from vertex `k` into the domain, along the bisector of its angle.
fn inwards(polygon: &[DVec2], k: usize) -> DVec2 {
    let m = polygon.len();
    let (to, from) = (polygon[(k + 1) % m] - polygon[k], polygon[(k + m - 1) % m] - polygon[k]);
    let angle = to.perp_dot(from).atan2(to.dot(from)).rem_euclid(TAU);
    DVec2::from_angle(0.5 * angle).rotate(to.normalize())
}

fn assert_reproduced(name: &str, polygon: &[DVec2], z: DVec2) {
    let gamma = coordinates(polygon, z);
    let sum: DVec2 = gamma.iter().sum();
    let point: DVec2 = gamma.iter().zip(polygon).map(|(&g, &v)| contour::times(g, v)).sum();
    assert!(sum.distance(DVec2::X) < ROUNDING, "{name}, z = {z}: Σγ − 1 = {}", sum - DVec2::X);
    let size = polygon.iter().map(|v| v.length()).fold(0.0, f64::max);
    assert!(point.distance(z) < ROUNDING * size, "{name}, z = {z}: Σγv − z = {}", point - z);
}

#[test]
fn constants_and_the_identity_are_reproduced_inside_next_to_and_on_the_boundary() {
    for (name, polygon) in polygons() {
        let m = polygon.len();
        for (k, &v) in polygon.iter().enumerate() {
            let next = polygon[(k + 1) % m];
            let edge = next - v;
            let depth = edge.perp().normalize() * 1e-9 * edge.length().min(1e-3);
            for t in [1e-12, 1e-6, 0.3, 0.5, 1.0 - 1e-6] {
                let z = v + t * edge + depth;
                if SimplePolygon::try_from(polygon.clone()).unwrap().contains(z) {
                    assert_reproduced(name, &polygon, z);
                }
            }
            assert_reproduced(name, &polygon, v);
            assert_reproduced(name, &polygon, v + 1e-9 * inwards(&polygon, k));
        }
    }
    for z in [[0.5, 0.0], [1.0, 0.25], [0.75, 1.0], [0.0, 0.125]] {
        assert_reproduced("square, on an edge", &polygons()[0].1, DVec2::from_array(z));
    }
}

#[test]
fn coordinates_on_the_boundary_are_the_limits_from_inside() {
    let depth = 1e-10;
    for (name, polygon) in polygons() {
        for k in 0..polygon.len() {
            let (on, inside) = (coordinates(&polygon, polygon[k]), polygon[k] + depth * inwards(&polygon, k));
            let error = on.iter().zip(coordinates(&polygon, inside)).map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
            // γ is Hölder there: the change is depth · log(depth) over the shortest edge, 5e-6 in the slit's mouth
            assert!(error < 1e-3, "{name}, vertex {k}: {error:e}");
        }
    }
    let square = &polygons()[0].1;
    let (on, inside) = (coordinates(square, DVec2::new(0.3, 0.0)), coordinates(square, DVec2::new(0.3, depth)));
    let error = on.iter().zip(inside).map(|(a, b)| a.distance(b)).fold(0.0, f64::max);
    assert!(error < 1e-9, "edge: {error:e}");
}

#[test]
fn corner_of_a_square_has_the_closed_form() {
    // z = v_0: γ_0 = (i (2π − π/2) + log 1)/(2πi) = 3/4
    let gamma = coordinates(&polygons()[0].1, DVec2::ZERO);
    assert!(gamma[0].distance(DVec2::new(0.75, 0.0)) < 1e-15, "{gamma:?}");
}

#[test]
fn coordinates_are_those_of_the_paper() {
    // equation (15) as printed, where none of its logarithms is near its branch cut
    let polygon: Vec<DVec2> =
        (0..40).map(|k| DVec2::from_angle(TAU * f64::from(k) / 40.0) * (1.0 + 0.3 * f64::from(k % 3))).collect();
    let v = |k: usize| complex(polygon[k % 40]);
    for z in [DVec2::ZERO, DVec2::new(0.6, -0.3), DVec2::new(0.1, 0.9)] {
        let gamma = coordinates(&polygon, z);
        let z = complex(z);
        for (k, &value) in gamma.iter().enumerate() {
            let (before, here, after) = (v(k + 39), v(k), v(k + 1));
            let right = (after - z) / (after - here) * ((after - z) / (here - z)).ln();
            let left = (before - z) / (here - before) * ((here - z) / (before - z)).ln();
            let expected = (right - left) / Complex::new(0.0, TAU);
            let error = (complex(value) - expected).norm();
            // the printed difference loses a few digits by cancellation
            assert!(error < 1e-14, "k = {k}, z = {z:?}: {value} and {expected:?}");
        }
    }
}

#[test]
fn far_and_near_edges_have_the_same_logarithm() {
    // an edge of length h at distance r: the series is used from r = 4h on, and the shorter one from r = 23h on
    for r in [3.98, 4.02, 22.5, 22.7, 1e3, 1e6] {
        for angle in [0.1, 1.3, 2.9, -1.0] {
            let (v, w) = (DVec2::from_angle(angle) * r - 0.5 * DVec2::X, DVec2::from_angle(angle) * r + 0.5 * DVec2::X);
            let contour = Contour::new(&[v, w]);
            let exact = (complex(w) / complex(v)).ln();
            contour.for_blocks(DVec2::ZERO, |_, logs, _| {
                let log = Complex::new(logs.log[0][0], logs.log[1][0]);
                assert!((log - exact).norm() < 4e-16, "r = {r}, angle {angle}: {log:?} and {exact:?}");
            });
        }
    }
}

fn circle(m: u32) -> Vec<DVec2> {
    (0..m).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(m))).collect()
}

/// The largest error of f̂ for the boundary values f(v_k) at points of the disk |z| ≤ 0.9.
fn largest_error(m: u32, f: impl Fn(Complex) -> Complex) -> f64 {
    let polygon = circle(m);
    let contour = Contour::new(&polygon);
    let values = BoundaryValues::new(polygon.iter().map(|&v| point(f(complex(v)))));
    let points = (0..200).map(|k| DVec2::from_angle(2.4 * f64::from(k)) * 0.9 * (f64::from(k) / 200.0).sqrt());
    points.map(|z| contour.evaluate(z, &values).distance(point(f(complex(z))))).fold(0.0, f64::max)
}

#[test]
fn holomorphic_functions_are_reproduced_to_second_order() {
    let square = |z: Complex| z * z;
    for (name, f) in [("z²", &square as &dyn Fn(Complex) -> Complex), ("Möbius", &disk::figure_7)] {
        let errors = [100, 200, 400, 800, 1600].map(|m| largest_error(m, f));
        println!("{name}: {errors:?}");
        for pair in errors.windows(2) {
            // linear interpolation of f on edges of length h: h² f''/8
            assert!((3.8..4.2).contains(&(pair[0] / pair[1])), "{name}: {errors:?}");
        }
    }
    // h²/8 · 2 = 3.9e-6 at m = 1600
    assert!(largest_error(1600, square) < 8e-6);
}

fn domain(preset: Preset, count: u32) -> Arc<MeshedDomain> {
    let settings = PrepareSettings {
        sampling: Sampling::Uniform { count, keep_corners: true },
        sizing: Sizing::Graded(0.2),
        ..PrepareSettings::default()
    };
    Arc::clone(prepare(preset.outline().polygon(), &settings, &mut |_| ()).unwrap().domain().unwrap())
}

fn whole(coordinates: &mut CauchyGreen, values: &BoundaryValues) -> Vec<DVec2> {
    let mut images = vec![DVec2::NAN; coordinates.domain().mesh().vertices().len()];
    let done = coordinates.advance(0, values, &mut images, &mut |_| ControlFlow::Continue(()));
    assert_eq!(done, images.len());
    images
}

/// Boundary values that are rough and of all sizes, as they may occur in a drag.
fn rough(m: usize) -> BoundaryValues {
    BoundaryValues::new((0..m).map(|k| DVec2::from_angle(k as f64 * k as f64) * (1.0 + k as f64 / m as f64) + 1e3))
}

#[test]
fn stored_coordinates_agree_with_f64_ones() {
    for preset in [Preset::Gingerbread, Preset::Star, Preset::VShape] {
        let domain = domain(preset, 501);
        let values = rough(501);
        let mut stored = CauchyGreen::new(Arc::clone(&domain), usize::MAX);
        let mut exact = CauchyGreen::new(Arc::clone(&domain), 0);
        assert_eq!((stored.mode(), exact.mode()), (CauchyGreenMode::Stored, CauchyGreenMode::OnTheFly));
        let (a, b) = (whole(&mut stored, &values), whole(&mut exact, &values));
        let bytes = CauchyGreen::estimate_bytes(501, domain.mesh().vertices().len());
        assert_eq!((stored.stored_bytes(), exact.stored_bytes()), (bytes, 0));
        let error = a.iter().zip(&b).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        println!("{}: f32 is off by {:.1e} of the extent", preset.name(), error / 4.0);
        // 6e-8 of Σ|γ| ≤ 8, for images of extent 4
        assert!(error < 4.0 * 1e-6, "{}: {error:e}", preset.name());
    }
}

#[test]
fn constants_are_exact_and_the_identity_holds_in_both_modes() {
    let domain = domain(Preset::Heart, 300);
    let vertices = domain.mesh().vertices();
    let constant = BoundaryValues::new(vec![DVec2::new(0.1, -1e5); 300]);
    let identity = BoundaryValues::new(domain.samples().points().iter().copied());
    for (budget, tolerance) in [(usize::MAX, 1e-6), (0, ROUNDING)] {
        let mut coordinates = CauchyGreen::new(Arc::clone(&domain), budget);
        assert!(whole(&mut coordinates, &constant).iter().all(|&w| w == DVec2::new(0.1, -1e5)));
        let images = whole(&mut coordinates, &identity);
        let error = images.iter().zip(vertices).map(|(w, v)| w.distance(*v)).fold(0.0, f64::max);
        assert!(error < tolerance, "{:?}: {error:e}", coordinates.mode());
    }
}

#[test]
fn chunks_and_threads_do_not_change_a_bit() {
    let domain = domain(Preset::Star, 700);
    let values = rough(700);
    for budget in [usize::MAX, 0] {
        let mut at_once = CauchyGreen::new(Arc::clone(&domain), budget);
        let expected = whole(&mut at_once, &values);
        let mut chunked = CauchyGreen::new(Arc::clone(&domain), budget);
        let (mut images, mut next, mut steps) = (vec![DVec2::NAN; expected.len()], 0, 0);
        while next < images.len() {
            let mut heard = 0.0;
            next = chunked.advance(next, &values, &mut images, &mut |fraction| {
                heard = fraction;
                ControlFlow::Break(())
            });
            assert_eq!(heard, next as f64 / images.len() as f64);
            assert!(images[next..].iter().all(|w| w.is_nan()), "only what is done is written");
            steps += 1;
        }
        assert!(steps > 3, "{steps} chunks");
        assert_eq!(images, expected);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        let threaded = pool.install(|| whole(&mut CauchyGreen::new(Arc::clone(&domain), budget), &values));
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        let alone = pool.install(|| whole(&mut CauchyGreen::new(Arc::clone(&domain), budget), &values));
        assert!(threaded == expected && alone == expected);
        // a separate range gives the same as the whole
        let mut part = vec![DVec2::NAN; 37];
        at_once.apply(11..48, &values, &mut part);
        assert_eq!(part, expected[11..48]);
    }
}
