//! Rays and nearest points: exact on a cube, closed form on a sphere, equal to a search over all triangles.

#![allow(clippy::unwrap_used, reason = "tests")]

use super::nearest::nearest_in_triangle;
use super::{Surface, SurfaceMesh, SurfacePreset, SurfaceTree};
use crate::geometry::{DVec2, DVec3};
use crate::mesh::{BarycentricPoint, TriMesh};
use proptest::prelude::*;
use std::sync::LazyLock;
use std::time::Instant;

fn place(mesh: &TriMesh<DVec3>, point: BarycentricPoint) -> DVec3 {
    let corners = mesh.triangles()[point.triangle().index()];
    corners.iter().zip(point.weights()).map(|(&v, w)| w * mesh.vertices()[v as usize]).sum()
}

/// The cube [0, 1]³ without its bottom.
fn cube() -> TriMesh<DVec3> {
    let vertices = (0..8).map(|v| DVec3::new(f64::from(v & 1), f64::from(v >> 1 & 1), f64::from(v >> 2))).collect();
    let quads = [[4, 5, 7, 6], [0, 1, 5, 4], [1, 3, 7, 5], [3, 2, 6, 7], [2, 0, 4, 6]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    SurfaceMesh::new(&Surface::new(vertices, triangles)).unwrap().mesh().clone()
}

#[test]
fn rays_meet_a_cube_first_where_they_enter_from_outside_and_inside() {
    let mesh = cube();
    let tree = SurfaceTree::new(&mesh);
    let cases = [
        // the top from above; through the open bottom to the top from inside; a side from outside, and from inside
        ([0.25, 0.5, 3.0], [0.0, 0.0, -1.0], Some(([0.25, 0.5, 1.0], 2.0))),
        ([0.25, 0.5, -3.0], [0.0, 0.0, 2.0], Some(([0.25, 0.5, 1.0], 4.0))),
        ([-1.0, 0.5, 0.75], [1.0, 0.0, 0.0], Some(([0.0, 0.5, 0.75], 1.0))),
        ([0.5, 0.5, 0.75], [1.0, 0.0, 0.0], Some(([1.0, 0.5, 0.75], 0.5))),
        // exactly on the diagonal of a side, an edge and a corner of the cube
        ([0.5, 0.5, 2.0], [0.0, 0.0, -1.0], Some(([0.5, 0.5, 1.0], 1.0))),
        ([1.0, 0.25, 3.0], [0.0, 0.0, -1.0], Some(([1.0, 0.25, 1.0], 2.0))),
        ([2.0, 2.0, 2.0], [-1.0, -1.0, -1.0], Some(([1.0, 1.0, 1.0], 3.0_f64.sqrt()))),
        ([1.5, 0.25, 3.0], [0.0, 0.0, -1.0], None),
        ([0.25, 0.5, 3.0], [0.0, 0.0, 1.0], None),
        ([0.25, 0.5, 3.0], [0.0; 3], None),
        ([f64::NAN, 0.5, 3.0], [0.0, 0.0, -1.0], None),
    ];
    for (origin, direction, expected) in cases {
        let hit = tree.ray(DVec3::from_array(origin), DVec3::from_array(direction));
        assert_eq!(hit.is_some(), expected.is_some(), "from {origin:?} along {direction:?}: {hit:?}");
        if let (Some((point, distance)), Some((at, length))) = (hit, expected) {
            let error = place(&mesh, point).distance(DVec3::from_array(at));
            assert!(error < 1e-15 && (distance - length).abs() < 1e-15, "from {origin:?}: {point:?}, {distance}");
        }
    }
}

#[test]
fn a_point_of_a_cube_is_hidden_from_behind_it_and_seen_from_before() {
    let tree = SurfaceTree::new(&cube());
    let on_top = DVec3::new(0.5, 0.25, 1.0);
    assert!(!tree.hides(DVec3::new(3.0, 0.5, 2.0), on_top));
    assert!(tree.hides(DVec3::new(3.0, 0.5, 0.5), on_top));
    assert!(!tree.hides(DVec3::new(0.5, 0.25, -2.0), on_top), "through the open bottom");
}

fn hemisphere() -> &'static (TriMesh<DVec3>, SurfaceTree) {
    static HEMISPHERE: LazyLock<(TriMesh<DVec3>, SurfaceTree)> = LazyLock::new(|| {
        let surface = SurfacePreset::Hemisphere.surface(120).unwrap();
        let mesh = SurfaceMesh::new(&surface).unwrap().mesh().clone();
        let tree = SurfaceTree::new(&mesh);
        (mesh, tree)
    });
    &HEMISPHERE
}

#[test]
fn rays_from_the_center_of_a_hemisphere_meet_it_near_the_sphere() {
    let (mesh, tree) = hemisphere();
    // chords of a sphere sag by s²/8 for triangles whose circumcircle has the diameter s
    let longest = mesh.triangles().iter().flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
    let edge = |[a, b]: [u32; 2]| mesh.vertices()[a as usize].distance(mesh.vertices()[b as usize]);
    let sag = longest.map(edge).fold(0.0, f64::max).powi(2) / 6.0;
    for k in 0..200 {
        let (height, turn) = (f64::from(k) / 200.0 + 0.002, 2.4 * f64::from(k));
        let direction = DVec3::new(turn.cos(), turn.sin(), 0.0) * (1.0 - height * height).sqrt() + height * DVec3::Z;
        let (point, distance) = tree.ray(DVec3::ZERO, 5.0 * direction).unwrap();
        assert!(distance <= 1.0 + 1e-15 && distance > 1.0 - sag, "{distance} along {direction}");
        assert!(place(mesh, point).distance(distance * direction) < 1e-14);
    }
    assert!(tree.ray(DVec3::ZERO, -DVec3::Z).is_none());
}

#[test]
fn rays_at_vertices_and_edges_do_not_slip_through() {
    let (mesh, tree) = hemisphere();
    let eye = DVec3::new(0.3, -0.2, 0.1);
    for triangle in mesh.triangles() {
        let [a, b, _] = triangle.map(|v| mesh.vertices()[v as usize]);
        for target in [a, a.lerp(b, 0.5), a.lerp(b, 1.0 / 3.0)] {
            let is_rim = target.z < 1e-9;
            let hit = tree.ray(eye, target - eye);
            assert!(is_rim || hit.is_some_and(|(p, _)| place(mesh, p).distance(target) < 1e-12), "{target}: {hit:?}");
        }
    }
}

/// Reference answer: the least distance over all triangles.
fn nearest_by_force(mesh: &TriMesh<DVec3>, at: DVec3) -> f64 {
    let distance = |corners: &[u32; 3]| {
        let corners = corners.map(|v| mesh.vertices()[v as usize]);
        let weights = nearest_in_triangle(corners, at);
        corners.iter().zip(weights).map(|(&p, w)| w * p).sum::<DVec3>().distance(at)
    };
    mesh.triangles().iter().map(distance).fold(f64::INFINITY, f64::min)
}

/// The least distance along the ray at which its line meets a triangle, by Cramer's rule.
fn first_by_force(mesh: &TriMesh<DVec3>, origin: DVec3, direction: DVec3) -> Option<f64> {
    let meets = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|v| mesh.vertices()[v as usize]);
        let (u, v) = (b - a, c - a);
        let normal = u.cross(v);
        let distance = (a - origin).dot(normal) / direction.dot(normal);
        let p = origin + distance * direction - a;
        let (s, t) =
            (p.cross(v).dot(normal) / normal.length_squared(), u.cross(p).dot(normal) / normal.length_squared());
        (s >= 0.0 && t >= 0.0 && s + t <= 1.0 && distance >= 0.0).then_some(distance)
    };
    mesh.triangles().iter().filter_map(meets).min_by(f64::total_cmp)
}

fn places() -> impl Strategy<Value = DVec3> {
    [-2.0..2.0, -2.0..2.0, -2.0..2.0].prop_map(DVec3::from_array)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn the_nearest_point_is_that_of_all_triangles(at in places()) {
        let (mesh, tree) = hemisphere();
        let (point, distance) = tree.nearest(at).unwrap();
        prop_assert!((distance - nearest_by_force(mesh, at)).abs() < 1e-14);
        prop_assert!((place(mesh, point).distance(at) - distance).abs() < 1e-14);
    }

    #[test]
    fn the_first_hit_is_that_of_all_triangles(origin in places(), target in places()) {
        let (mesh, tree) = hemisphere();
        let direction = (target - origin).normalize();
        let (hit, expected) = (tree.ray(origin, direction), first_by_force(mesh, origin, direction));
        prop_assert_eq!(hit.is_some(), expected.is_some());
        if let (Some((point, distance)), Some(expected)) = (hit, expected) {
            // rays that graze the surface magnify rounding
            prop_assert!((distance - expected).abs() < 1e-9, "{} against {}", distance, expected);
            prop_assert!(place(mesh, point).distance(origin + distance * direction) < 1e-12);
        }
    }
}

#[test]
fn from_far_away_the_nearest_point_is_the_outermost_one() {
    let (mesh, tree) = hemisphere();
    for k in 0..40 {
        let up = DVec2::from_angle(0.15 * f64::from(k));
        let direction = DVec3::new(0.6 * up.x, 0.6 * up.y, 0.8);
        let outermost = mesh.vertices().iter().map(|p| p.dot(direction)).fold(f64::NEG_INFINITY, f64::max);
        for distance in [1e3, 1e8, 1e16, 1e100, 1e300] {
            let (point, _) = tree.nearest(distance * direction).unwrap();
            let reached = place(mesh, point).dot(direction);
            // seen from the side, a point at a small offset loses the square of the offset
            assert!(reached >= outermost - 1.0 / distance.min(1e6), "{k}, {distance:e}: {reached} of {outermost}");
        }
    }
}

#[test]
fn what_is_not_finite_is_near_nothing() {
    assert!(SurfaceTree::new(&cube()).nearest(DVec3::NAN).is_none());
}

#[test]
#[ignore = "a measurement: prints the times of this machine"]
fn seventy_thousand_triangles() {
    let mesh = SurfaceMesh::new(&SurfacePreset::Hemisphere.surface(650).unwrap()).unwrap().mesh().clone();
    let build = || {
        let start = Instant::now();
        (SurfaceTree::new(&mesh), start.elapsed())
    };
    let (tree, least) = (0..9).map(|_| build()).min_by_key(|(_, time)| *time).unwrap();
    let places: Vec<_> = (0..1000).map(|k| DVec3::new(2.0, f64::from(k) / 500.0 - 1.0, 1.5)).collect();
    let start = Instant::now();
    let hits = places.iter().filter(|&&p| tree.ray(p, DVec3::new(0.1, 0.1, 0.3) - p).is_some()).count();
    let rays = start.elapsed() / 1000;
    let start = Instant::now();
    let found = places.iter().filter(|&&p| tree.nearest(p).is_some()).count();
    let nearest = start.elapsed() / 1000;
    println!("{} triangles: tree {least:?}, ray {rays:?}, nearest {nearest:?}", mesh.triangles().len());
    assert_eq!((hits, found), (1000, 1000));
}
