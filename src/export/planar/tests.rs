//! The tables and meshes that are written hold the map, and are read again.

use super::*;
use crate::conformal::{Constraints, PreparedDomain, prepare};
use crate::outline::{Preset, Sampling};
use std::sync::Arc;

fn domain(preset: Preset, count: u32) -> Arc<PreparedDomain> {
    let sampling = Sampling::Uniform { count, keep_corners: true };
    let settings = crate::conformal::PrepareSettings { sampling, ..Default::default() };
    Arc::new(prepare(&preset.outline().polygon, &settings, &mut |_| ()).unwrap())
}

/// The anchors lie inside edges, and far from the first points.
fn map(direction: Direction) -> ConformalMap {
    let (source, target) = (domain(Preset::Heart, 120), domain(Preset::Square, 90));
    let constraints = Constraints {
        source_point: source.pole,
        target_point: target.pole,
        source_anchor: 0.413,
        target_anchor: 0.777,
    };
    ConformalMap::new(source, target, &constraints, direction.into()).unwrap()
}

fn rows(text: &str) -> Vec<Vec<f64>> {
    text.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
}

/// How often a share of arc length falls, and whether it is ever outside of [0, 1].
fn falls(column: &[f64]) -> usize {
    assert!(column.iter().all(|s| (0.0..=1.0).contains(s)));
    column.windows(2).filter(|pair| pair[1] < pair[0]).count()
}

#[test]
fn the_boundary_table_runs_once_around_both_outlines() {
    for direction in [Direction::Forward, Direction::Backward] {
        let map = map(direction);
        let text = boundary_csv(&map);
        assert_eq!(text.lines().next().unwrap().split(',').count(), 7);
        let rows = rows(&text);
        assert_eq!(rows.len(), map.domain(direction.mapped_side()).samples.len());
        let column = |k: usize| rows.iter().map(|row| row[k]).collect::<Vec<f64>>();
        assert_eq!((falls(&column(0)), falls(&column(1)), falls(&column(6))), (1, 1, 0));
        assert!(rows[0][0] >= 0.413 && rows[0][1] >= 0.777 && rows[0][6] >= 0.0);
        for row in &rows {
            for (side, (s, x, y)) in Side::BOTH.into_iter().zip([(row[0], row[2], row[3]), (row[1], row[4], row[5])]) {
                let samples = &map.domain(side).samples;
                let distance = samples.position(samples.at_fraction(s)).distance(DVec2::new(x, y));
                assert!(distance < 1e-12, "{side}: {distance:e}");
            }
        }
    }
}

#[test]
fn partners_have_the_same_harmonic_measure() {
    let map = map(Direction::Backward);
    let source = &map.domain(Side::Source).samples;
    for row in rows(&boundary_csv(&map)) {
        let there = map.measure(Side::Source).at(source.at_fraction(row[0]));
        assert!((there - row[6]).abs() < 1e-9, "{there} is not {}", row[6]);
    }
}

#[test]
fn a_measure_finds_the_point_before_which_it_lies() {
    let map = map(Direction::Backward);
    let measure = map.measure(Side::Source);
    for k in 0..=200 {
        let omega = f64::from(k) / 200.0;
        let back = measure.at(measure.point_at(omega));
        let error = (back - omega).abs().min(1.0 - (back - omega).abs());
        assert!(error < 1e-12, "{omega}: {error:e}");
    }
}

#[test]
fn the_mesh_file_is_read_back_as_a_surface_with_the_targets_area() {
    for direction in [Direction::Forward, Direction::Backward] {
        let map = map(direction);
        let text = mapped_obj(&map);
        let surface = crate::surface::read_surface("map.obj", text.as_bytes()).unwrap();
        let mesh = map.mapped_mesh();
        assert_eq!((surface.vertices.len(), surface.triangles.len()), (mesh.vertices.len(), mesh.triangles.len()));
        let area: f64 = surface
            .triangles
            .iter()
            .map(|t| t.map(|v| surface.vertices[v as usize]))
            .map(|[a, b, c]| 0.5 * (b - a).cross(c - a).z)
            .sum();
        let target = &map.domain(Side::Target).samples.points;
        let expected: f64 = (0..target.len()).map(|k| 0.5 * target[k].perp_dot(target[(k + 1) % target.len()])).sum();
        // the image of the source's mesh cuts the square's corners
        let tolerance = if direction == Direction::Forward { 0.03 } else { 1e-9 };
        assert!((area / expected - 1.0).abs() < tolerance, "{area} is not {expected}");
        assert_eq!(text.lines().filter(|line| line.starts_with("vt ")).count(), mesh.vertices.len());
    }
}
