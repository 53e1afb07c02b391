//! The guarantees of the planar mesher, on outlines that are hard to mesh.

use super::TriangleId;
use super::*;
use crate::geometry::{DVec2, orientation};
use proptest::prelude::*;
use std::f64::consts::TAU;
use web_time::Instant;

const SIZINGS: [Sizing; 4] = [Sizing::Uniform, Sizing::Graded(0.03), Sizing::Graded(0.15), Sizing::Graded(1.0)];

fn closed(m: usize, f: impl Fn(f64) -> DVec2) -> Vec<DVec2> {
    (0..m).map(|k| f(TAU * k as f64 / m as f64)).collect()
}

fn disk(m: usize) -> Vec<DVec2> {
    closed(m, DVec2::from_angle)
}

fn spiky(m: usize, arms: f64, depth: f64) -> Vec<DVec2> {
    closed(m, |t| DVec2::from_angle(t) * (1.0 + depth * (arms * t).sin()))
}

fn points(coordinates: &[(f64, f64)]) -> Vec<DVec2> {
    coordinates.iter().copied().map(DVec2::from).collect()
}

/// Each edge divided into `parts`.
fn divided(corners: &[(f64, f64)], parts: usize) -> Vec<DVec2> {
    let corners = points(corners);
    let edge = |k: usize| (corners[k], corners[(k + 1) % corners.len()]);
    let piece =
        |k: usize| (0..parts).map(move |j| edge(k).0.lerp(edge(k).1, j as f64 / parts as f64)).collect::<Vec<_>>();
    (0..corners.len()).flat_map(piece).collect()
}

/// A comb: `teeth` gaps of width `gap` cut down to the height 0.1.
fn comb(teeth: usize, gap: f64) -> Vec<DVec2> {
    let mut corners = vec![(0.0, 0.0), (1.0, 0.0)];
    for k in (0..teeth).rev() {
        let x = (k as f64 + 0.5) / teeth as f64;
        let half = 0.5 * gap / teeth as f64;
        corners.extend([(x + 1.5 * half, 1.0), (x + half, 0.1), (x - half, 0.1), (x - 1.5 * half, 1.0)]);
    }
    points(&corners)
}

/// A corridor of width `width` around a spiral of `turns` turns.
fn spiral(turns: f64, width: f64, m: usize) -> Vec<DVec2> {
    let arm = |t: f64, offset: f64| DVec2::from_angle(TAU * turns * t) * (0.3 + turns * t + offset);
    let inner = (0..m).map(|k| arm(1.0 - k as f64 / m as f64, 0.0));
    inner.chain((0..m).map(|k| arm((k as f64 + 1.0) / m as f64, width))).collect()
}

/// Meshes the boundary, checks every guarantee, and returns the mesh.
fn checked(boundary: &[DVec2], sizing: Sizing) -> TriMesh {
    let (mesh, report) = mesh_domain(boundary, sizing).unwrap();
    assert_eq!(mesh.check_invariants(), Ok(()));
    assert_eq!(&mesh.vertices[..boundary.len()], boundary, "the boundary is kept bit for bit");
    assert_eq!(mesh.boundary_count as usize, boundary.len());
    assert!(report.added <= mesh.interior_count());
    mesh
}

fn min_angle(mesh: &TriMesh, t: [u32; 3]) -> f64 {
    let p = t.map(|v| mesh.vertices[v as usize]);
    let angle = |i: usize| (p[(i + 1) % 3] - p[i]).angle_to(p[(i + 2) % 3] - p[i]).abs().to_degrees();
    (0..3).map(angle).fold(180.0, f64::min)
}

fn distance_to_boundary(boundary: &[DVec2], x: DVec2) -> f64 {
    boundary.iter().map(|p| p.distance(x)).fold(f64::INFINITY, f64::min)
}

#[test]
fn uniform_triangles_meet_the_papers_area_limit() {
    let boundary = disk(400);
    let mesh = checked(&boundary, Sizing::Uniform);
    let h = boundary[0].distance(boundary[1]);
    let too_large = mesh.triangles.iter().filter(|&&t| 0.5 * mesh.orientation(t) > 0.5 * h * h).count();
    assert!(too_large * 500 < mesh.triangles.len(), "{too_large} of {}", mesh.triangles.len());
    let (n, ideal) = (mesh.interior_count() as f64, 0.5 * TAU / (h * h));
    println!("n {n}, area / h² {ideal:.0}");
    assert!(n < 1.15 * ideal, "a lattice needs hardly more than area/h² vertices");
    let poor = mesh.triangles.iter().filter(|&&t| min_angle(&mesh, t) < 20.0).count();
    assert_eq!(poor, 0, "triangles below 20°");
}

#[test]
fn graded_triangles_grow_with_the_distance_from_the_boundary() {
    let boundary = disk(500);
    let h = boundary[0].distance(boundary[1]);
    for growth in [0.05, 0.15, 0.3] {
        let mesh = checked(&boundary, Sizing::Graded(growth));
        let ratio: Vec<f64> = mesh
            .triangles
            .iter()
            .map(|t| {
                let [a, b, c] = t.map(|v| mesh.vertices[v as usize]);
                let mean = (a.distance(b) + b.distance(c) + c.distance(a)) / 3.0;
                mean / (h + growth * distance_to_boundary(&boundary, (a + b + c) / 3.0))
            })
            .collect();
        let mean = ratio.iter().sum::<f64>() / ratio.len() as f64;
        let worst = ratio.iter().fold((f64::INFINITY, 0.0f64), |(low, high), &r| (low.min(r), high.max(r)));
        println!("growth {growth}: n {}, size / wanted {mean:.3}, {worst:.3?}", mesh.interior_count());
        assert!((0.85..1.15).contains(&mean), "growth {growth}: mean ratio {mean}");
        assert!(worst.0 > 0.55 && worst.1 < 1.8, "growth {growth}: extreme ratios {worst:?}");
        let poor = mesh.triangles.iter().filter(|&&t| min_angle(&mesh, t) < 20.0).count();
        assert_eq!(poor, 0, "triangles below 20°");
    }
}

#[test]
fn shapes_that_break_meshers_are_meshed() {
    let eps = 1e-9;
    let shapes = [
        ("triangle", points(&[(0.0, 0.0), (1.0, 0.0), (0.3, 0.7)])),
        ("sliver", points(&[(0.0, 0.0), (1.0, 0.0), (0.5, 1e-12)])),
        ("oblique sliver", points(&[(0.1, 0.3), (0.7, 0.9), (0.4, 0.600_000_000_001)])),
        ("square", points(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])),
        ("nearly collinear", divided(&[(0.0, 0.0), (1.0, 1e-15), (1.0, 1.0), (0.5, 1.0 + 1e-15), (0.0, 1.0)], 7)),
        (
            "neck",
            divided(
                &[(-1.0, -1.0), (-eps, 0.0), (-1.0, 1.0), (1.0, 1.0), (eps, 0.0), (1.0, -1.0)].map(|(x, y)| (y, x)),
                20,
            ),
        ),
        (
            "gap",
            divided(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (eps, 1.0), (0.0, -0.5), (-eps, 1.0), (-1.0, 1.0)], 15),
        ),
        (
            "spike",
            divided(
                &[(-1.0, -1.0), (1.0, -1.0), (1.0, 0.0), (50.0, eps), (1.0, 2.0 * eps), (1.0, 1.0), (-1.0, 1.0)],
                9,
            ),
        ),
        ("one long edge", [points(&[(0.0, 0.0)]), disk(300).into_iter().filter(|p| p.y > 0.0).collect()].concat()),
        ("L", divided(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)], 30)),
        ("comb", comb(20, 0.3)),
        ("tight comb", comb(30, 1e-7)),
        ("spiral", spiral(3.0, 0.4, 300)),
        ("spiky", spiky(700, 11.0, 0.97)),
        ("tiny edges", closed(200, |t| DVec2::from_angle(t + 0.999_999 * (t).sin()))),
    ];
    for (name, boundary) in shapes {
        for sizing in SIZINGS {
            let start = Instant::now();
            let mesh = checked(&boundary, sizing);
            println!("{name} {sizing:?}: m {} n {} {:?}", boundary.len(), mesh.interior_count(), start.elapsed());
            let (_, report) = mesh_domain(&boundary, sizing).unwrap();
            assert!(report.complete, "{name} {sizing:?}: {report:?}");
        }
    }
}

#[test]
fn scale_and_position_do_not_matter() {
    let shape = spiky(200, 5.0, 0.5);
    let reference = checked(&shape, Sizing::default()).interior_count();
    for scale in [1e-90, 1e-30, 3.0, 1e40, 1e90] {
        let scaled: Vec<DVec2> = shape.iter().map(|&p| p * scale).collect();
        let count = checked(&scaled, Sizing::default()).interior_count();
        assert!(count.abs_diff(reference) * 20 < reference, "{count} and {reference} vertices at scale {scale:e}");
    }
    let moved: Vec<DVec2> = shape.iter().map(|&p| p + DVec2::new(1e7, -3e8)).collect();
    let count = checked(&moved, Sizing::default()).interior_count();
    assert!(count.abs_diff(reference) * 10 < reference, "{count} and {reference} vertices far from the origin");
}

#[test]
fn the_same_input_gives_the_same_mesh() {
    for sizing in SIZINGS {
        let shape = spiky(300, 7.0, 0.7);
        assert_eq!(mesh_domain(&shape, sizing).unwrap(), mesh_domain(&shape, sizing).unwrap());
    }
}

#[test]
fn bad_boundaries_are_named() {
    let fails = |corners: &[(f64, f64)]| mesh_domain(&points(corners), Sizing::default()).unwrap_err();
    assert_eq!(fails(&[(0.0, 0.0), (1.0, 0.0)]), MeshError::TooFewPoints { count: 2 });
    assert_eq!(fails(&[(0.0, 0.0), (0.0, 1.0), (1.0, 0.0)]), MeshError::NotCounterClockwise);
    assert_eq!(fails(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0)]), MeshError::NotCounterClockwise);
    assert_eq!(fails(&[(0.0, 0.0), (f64::NAN, 0.0), (2.0, 0.0)]), MeshError::NotFinite { index: 1 });
    assert_eq!(fails(&[(0.0, 0.0); 4]), MeshError::OutOfRange);
    let bow = [(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (1.0, -1.0), (0.0, 3.0)];
    let on_the_base = |x: f64, y: f64| y.abs() < 1e-12 && (0.7..2.1).contains(&x);
    assert!(matches!(fails(&bow), MeshError::SelfCrossing { x, y } if on_the_base(x, y)), "{:?}", fails(&bow));
    let touching = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (1.0, 0.0), (0.0, 2.0)];
    assert!(matches!(fails(&touching), MeshError::SelfCrossing { .. }), "{:?}", fails(&touching));
    let twice = [(0.0, 0.0), (2.0, 0.0), (1.0, 1.0), (2.0, 2.0), (0.0, 2.0), (1.0, 1.0)];
    assert_eq!(fails(&twice), MeshError::RepeatedPoint { x: 1.0, y: 1.0 });
    let square = points(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    assert!(matches!(mesh_domain(&square, Sizing::Graded(f64::NAN)), Err(MeshError::Grading { .. })));
    assert!(matches!(mesh_domain(&disk(20_000), Sizing::Uniform), Err(MeshError::TooManyVertices { .. })));
    assert!(matches!(mesh_domain(&disk(20_000), Sizing::Graded(0.0)), Err(MeshError::Grading { .. })));
}

/// Whether some triangle contains `x`, exactly.
fn is_inside(mesh: &TriMesh, x: DVec2) -> bool {
    mesh.triangles.iter().any(|t| {
        let [a, b, c] = t.map(|v| mesh.vertices[v as usize]);
        orientation(a, b, x) >= 0.0 && orientation(b, c, x) >= 0.0 && orientation(c, a, x) >= 0.0
    })
}

/// A linear congruential generator with Knuth's constants, `[0, 1)`.
fn random_numbers(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1u64 << 31) as f64
    }
}

#[test]
fn points_are_found_from_any_hint_and_outside_points_are_not() {
    for boundary in [spiky(500, 7.0, 0.9), spiral(2.0, 0.4, 200), comb(8, 0.5)] {
        let mesh = checked(&boundary, Sizing::default());
        let (mut random, mut inside) = (random_numbers(7), 0);
        let (low, high) = super::hex_lattice::bounds(&boundary);
        for _ in 0..1500 {
            let x = low + (high - low) * DVec2::new(1.1 * random() - 0.05, 1.1 * random() - 0.05);
            let found = locate(&mesh, x, Some(TriangleId::new((random() * mesh.triangles.len() as f64) as u32)));
            assert_eq!(found.is_some(), is_inside(&mesh, x), "{x}");
            if let Some(found) = found {
                inside += 1;
                assert!(found.position(&mesh).distance(x) < 1e-14 && found.weights().iter().all(|&w| w >= 0.0));
                assert!((found.weights().iter().sum::<f64>() - 1.0).abs() < 1e-15 * 3.0);
            }
        }
        assert!(inside > 100, "{inside} of 1500 points were inside");
    }
}

#[test]
fn vertices_edges_and_the_boundary_are_found() {
    let mesh = checked(&spiky(300, 5.0, 0.8), Sizing::default());
    for (k, &x) in mesh.vertices.iter().enumerate() {
        let found = locate(&mesh, x, Some(TriangleId::new((k * 37 % mesh.triangles.len()) as u32))).unwrap();
        let corner = mesh.triangles[found.triangle().index()].iter().position(|&v| v == k as u32).unwrap();
        assert_eq!(found.weights()[corner], 1.0);
    }
    for k in 0..mesh.boundary_count as usize {
        // rounding puts about half of these outside
        let x = mesh.vertices[k].lerp(mesh.vertices[(k + 1) % mesh.boundary_count as usize], 0.3);
        let found = locate(&mesh, x, None).unwrap();
        assert!(found.position(&mesh).distance(x) < 1e-12);
    }
    assert_eq!(locate(&mesh, DVec2::new(f64::NAN, 0.0), None), None);
    assert_eq!(locate(&mesh, DVec2::new(9.0, 0.0), Some(TriangleId::new(u32::MAX))), None);
}

#[test]
fn the_point_nearest_inside_is_strictly_inside_and_inset() {
    let boundary = divided(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)], 20);
    let mesh = checked(&boundary, Sizing::default());
    let mut random = random_numbers(3);
    for _ in 0..500 {
        let x = DVec2::new(6.0 * random() - 2.0, 6.0 * random() - 2.0);
        let p = nearest_inside(&mesh, x, 0.05);
        let depth = |p: DVec2| super::locate::nearest_on_boundary(&mesh, p).2;
        assert!(locate(&mesh, p, None).is_some() && depth(p) > 0.0499, "{x} → {p}");
        if is_inside(&mesh, x) && depth(x) > 0.05 {
            assert_eq!(p, x);
        }
    }
    assert!(nearest_inside(&mesh, DVec2::new(1.5, 1.7), 0.05).distance(DVec2::new(1.0, 1.7)) < 0.8);
    assert!(nearest_inside(&mesh, DVec2::new(5.0, 0.5), 0.05).distance(DVec2::new(1.95, 0.5)) < 1e-12);
    let star = closed(40, |t| DVec2::from_angle(t) * if (t * 40.0 / TAU).round() % 2.0 == 0.0 { 1.0 } else { 0.1 });
    let p = nearest_inside(&checked(&star, Sizing::default()), DVec2::new(2.0, 0.0), 0.002);
    assert!(p.x > 0.9 && p.x < 0.99 && p.y.abs() < 1e-12, "near the tip of a spike, but clear of it: {p}");
    for sliver in [points(&[(0.0, 0.0), (1.0, 0.0), (0.5, 1e-12)]), comb(30, 1e-7)] {
        let mesh = checked(&sliver, Sizing::default());
        let p = nearest_inside(&mesh, DVec2::new(3.0, 2.0), 0.1);
        assert!(is_inside(&mesh, p) && super::locate::nearest_on_boundary(&mesh, p).2 > 0.0, "{p}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, rng_seed: proptest::test_runner::RngSeed::Fixed(20), ..ProptestConfig::default() })]

    /// Stars with radii between 10⁻³ and 1, so spikes with angles down to 10⁻³.
    #[test]
    fn random_stars_are_meshed(radii in prop::collection::vec(-3.0f64..0.0, 3..150), k in 0usize..4, turn in 0.0f64..6.0) {
        let m = radii.len() as f64;
        let star: Vec<DVec2> = radii.iter().enumerate().map(|(k, r)| DVec2::from_angle(turn + TAU * k as f64 / m) * 10f64.powf(*r)).collect();
        prop_assume!(star.len() > 4 || super::mesh_domain(&star, Sizing::Graded(1.0)).is_ok());
        let mesh = checked(&star, SIZINGS[k]);
        let centroid = |t: [u32; 3]| t.iter().map(|&v| mesh.vertices[v as usize] / 3.0).sum::<DVec2>();
        for (t, &triangle) in mesh.triangles.iter().enumerate().step_by(17) {
            let found = locate(&mesh, centroid(triangle), Some(TriangleId::new((t * 7 % mesh.triangles.len()) as u32)));
            prop_assert!(found.is_some(), "centroid of triangle {}", t);
        }
    }

    /// Narrow corridors: combs of random teeth and spirals of random width.
    #[test]
    fn random_combs_and_spirals_are_meshed(teeth in 1usize..40, gap in -6.0f64..-0.3, turns in 0.5f64..5.0, width in -5.0f64..-0.1, k in 0usize..4) {
        checked(&comb(teeth, 10f64.powf(gap)), SIZINGS[k]);
        checked(&spiral(turns, 10f64.powf(width), 200), SIZINGS[k]);
    }

    /// Any closed polyline gives a mesh or an error, never a panic.
    #[test]
    fn arbitrary_polylines_do_not_panic(points in prop::collection::vec((-4i8..5, -4i8..5), 3..12), k in 0usize..4) {
        let points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(f64::from(x), f64::from(y))).collect();
        if let Ok((mesh, _)) = mesh_domain(&points, SIZINGS[k]) {
            prop_assert_eq!(mesh.check_invariants(), Ok(()));
        }
    }
}
