//! What the planar mesher promises, on the shapes that break meshers.

use super::*;
use crate::geometry::DVec2;
use std::f64::consts::TAU;
use web_time::Instant;

fn closed(m: usize, f: impl Fn(f64) -> DVec2) -> Vec<DVec2> {
    (0..m).map(|k| f(TAU * k as f64 / m as f64)).collect()
}

fn disk(m: usize) -> Vec<DVec2> {
    closed(m, DVec2::from_angle)
}

/// A rounded heart.
fn heart(m: usize) -> Vec<DVec2> {
    closed(m, |t| {
        DVec2::new(
            16.0 * t.sin().powi(3),
            13.0 * t.cos() - 5.0 * (2.0 * t).cos() - 2.0 * (3.0 * t).cos() - (4.0 * t).cos(),
        )
    })
    .into_iter()
    .rev()
    .collect()
}

fn spiky(m: usize, arms: f64, depth: f64) -> Vec<DVec2> {
    closed(m, |t| DVec2::from_angle(t) * (1.0 + depth * (arms * t).sin()))
}

/// `m` points equally spaced along the polygon.
fn resampled(polygon: &[DVec2], m: usize) -> Vec<DVec2> {
    let polygon = crate::geometry::SimplePolygon::try_from(polygon.to_vec()).unwrap();
    crate::outline::sample(&polygon, crate::outline::Sampling::Uniform { count: m as u32, keep_corners: false })
        .unwrap()
        .points
}

#[test]
fn uniform_timing() {
    for (name, shape) in [
        ("disk", disk(350)),
        ("heart1000", resampled(&heart(5000), 1000)),
        ("spiky", resampled(&spiky(9000, 11.0, 0.6), 3200)),
    ] {
        for _ in 0..3 {
            let start = Instant::now();
            let (mesh, report) = mesh_domain(&shape, Sizing::Uniform).unwrap();
            println!("{name} m {} n {} {report:?} {:?}", shape.len(), mesh.interior_count(), start.elapsed());
        }
        let (mesh, _) = mesh_domain(&shape, Sizing::Uniform).unwrap();
        assert_eq!(mesh.check_invariants(), Ok(()));
        assert_eq!(&mesh.vertices[..shape.len()], &shape[..]);
    }
}

#[test]
fn random_points_are_found_from_any_hint_and_outside_points_are_not() {
    let shape = resampled(&spiky(4000, 7.0, 0.8), 700);
    let (mesh, _) = mesh_domain(&shape, Sizing::Uniform).unwrap();
    let mut state = 7u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1u64 << 31) as f64
    };
    let (mut inside, count) = (0, mesh.triangles.len() as f64);
    for _ in 0..2000 {
        let x = DVec2::new(4.0 * random() - 2.0, 4.0 * random() - 2.0);
        let found = locate(&mesh, x, (random() * count) as u32);
        let expected = mesh.triangles.iter().any(|t| {
            let [a, b, c] = t.map(|v| mesh.vertices[v as usize]);
            (b - a).perp_dot(x - a) >= 0.0 && (c - b).perp_dot(x - b) >= 0.0 && (a - c).perp_dot(x - c) >= 0.0
        });
        assert_eq!(found.is_some(), expected, "{x}");
        if let Some(found) = found {
            inside += 1;
            assert!(found.position(&mesh).distance(x) < 1e-14);
        }
    }
    assert!(inside > 300);
    let start = Instant::now();
    let mut hint = 0;
    let mut sum = 0.0;
    for k in 0..10_000 {
        let x = DVec2::from_angle(TAU * f64::from(k) / 10_000.0) * 0.15;
        let p = locate(&mesh, x, hint).unwrap();
        hint = p.triangle;
        sum += p.weights[0];
    }
    println!("locate from a near hint: {:?} each ({sum})", start.elapsed() / 10_000);
}

fn min_angle(mesh: &TriMesh, t: [u32; 3]) -> f64 {
    let p = t.map(|v| mesh.vertices[v as usize]);
    (0..3).map(|i| (p[(i + 1) % 3] - p[i]).angle_to(p[(i + 2) % 3] - p[i]).abs().to_degrees()).fold(180.0, f64::min)
}

fn quality(mesh: &TriMesh) -> String {
    let mut angles: Vec<f64> = mesh.triangles.iter().map(|&t| min_angle(mesh, t)).collect();
    angles.sort_by(f64::total_cmp);
    let at = |q: f64| angles[(q * (angles.len() - 1) as f64) as usize];
    format!("min angle {:.1}, 1% {:.1}, 10% {:.1}, median {:.1}", at(0.0), at(0.01), at(0.1), at(0.5))
}

#[test]
fn graded_timing() {
    for (name, shape) in [
        ("disk", disk(500)),
        ("heart1000", resampled(&heart(5000), 1000)),
        ("heart500", resampled(&heart(5000), 500)),
        ("spiky700", resampled(&spiky(9000, 11.0, 0.6), 700)),
        ("spiky3200", resampled(&spiky(9000, 11.0, 0.6), 3200)),
    ] {
        for growth in [0.05, 0.1, 0.15, 0.2, 0.4] {
            let start = Instant::now();
            let (mesh, report) = mesh_domain(&shape, Sizing::Graded(growth)).unwrap();
            let time = start.elapsed();
            let start = Instant::now();
            graded::seeds(&shape, growth).unwrap();
            println!(
                "{name} g {growth} n {} +{} {} {time:.1?} seeds {:.1?} {}",
                mesh.interior_count(),
                report.added,
                report.complete,
                start.elapsed(),
                quality(&mesh)
            );
        }
        let (mesh, _) = mesh_domain(&shape, Sizing::Uniform).unwrap();
        println!("uniform {} {}", mesh.interior_count(), quality(&mesh));
    }
}
