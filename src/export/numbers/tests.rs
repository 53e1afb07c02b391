//! The written tables and meshes contain the map, and can be read back.

use super::*;
use crate::conformal::{Constraints, Direction, PreparedSide, SurfaceSettings, prepare, prepare_surface};
use crate::export::{FileFormat, mapped_mesh};
use crate::geometry::{DVec2, DVec3};
use crate::outline::{Preset, Sampling};
use crate::surface::{SurfaceMesh, SurfacePreset};
use std::sync::Arc;

fn domain(preset: Preset, count: u32) -> Arc<PreparedSide> {
    let sampling = Sampling::Uniform { count, keep_corners: true };
    let settings = crate::conformal::PrepareSettings { sampling, ..Default::default() };
    Arc::new(prepare(preset.outline().polygon(), &settings, &mut |_| ()).unwrap())
}

/// A map whose anchors lie inside edges, far from the first points.
fn map(direction: Direction) -> ConformalMap {
    let (source, target) = (domain(Preset::Heart, 120), domain(Preset::Square, 90));
    let constraints = Constraints::new((source.default_point(), 0.413), (target.default_point(), 0.777));
    ConformalMap::new(source, target, &constraints, direction.into()).unwrap()
}

fn rows(text: &str) -> Vec<Vec<f64>> {
    text.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
}

fn mapped_obj(map: &ConformalMap) -> String {
    String::from_utf8(mapped_mesh(map, FileFormat::Obj, None).unwrap().bytes).unwrap()
}

/// The number of decreases in a column of arc-length fractions, which must lie in [0, 1].
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
        assert_eq!(rows.len(), map.mapped().boundary_count());
        let column = |k: usize| rows.iter().map(|row| row[k]).collect::<Vec<f64>>();
        assert_eq!((falls(&column(0)), falls(&column(1)), falls(&column(6))), (1, 1, 0));
        assert!(rows[0][0] >= 0.413 && rows[0][1] >= 0.777 && rows[0][6] >= 0.0);
        for row in &rows {
            for (side, (s, x, y)) in Side::BOTH.into_iter().zip([(row[0], row[2], row[3]), (row[1], row[4], row[5])]) {
                let samples = map.domain(side).unwrap().samples();
                let distance = samples.position(samples.at_fraction(s)).distance(DVec2::new(x, y));
                assert!(distance < 1e-12, "{side}: {distance:e}");
            }
        }
    }
}

#[test]
fn partners_have_the_same_harmonic_measure() {
    let map = map(Direction::Backward);
    let source = map.domain(Side::Source).unwrap().samples();
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
        let mesh = map.mapped().domain().unwrap().mesh();
        assert_eq!(
            (surface.vertices().len(), surface.triangles().len()),
            (mesh.vertices().len(), mesh.triangles().len())
        );
        let area: f64 = surface
            .triangles()
            .iter()
            .map(|t| t.map(|v| surface.vertices()[v as usize]))
            .map(|[a, b, c]| 0.5 * (b - a).cross(c - a).z)
            .sum();
        let target = &map.domain(Side::Target).unwrap().samples().points();
        let expected: f64 = (0..target.len()).map(|k| 0.5 * target[k].perp_dot(target[(k + 1) % target.len()])).sum();
        // the image of the source's mesh cuts the square's corners
        let tolerance = if direction == Direction::Forward { 0.03 } else { 1e-9 };
        assert!((area / expected - 1.0).abs() < tolerance, "{area} is not {expected}");
        assert_eq!(text.lines().filter(|line| line.starts_with("vt ")).count(), mesh.vertices().len());
    }
}

fn surface(preset: SurfacePreset) -> Arc<PreparedSide> {
    let mesh = SurfaceMesh::new(&preset.surface(40).unwrap()).unwrap();
    Arc::new(prepare_surface(mesh, SurfaceSettings::default(), &mut |_| ()).unwrap())
}

#[test]
fn places_on_a_surface_have_three_coordinates_and_lie_on_it() {
    let (hemisphere, paraboloid) = (surface(SurfacePreset::Hemisphere), surface(SurfacePreset::Paraboloid));
    let heart = domain(Preset::Heart, 120);
    for (source, target) in [(&hemisphere, &heart), (&heart, &hemisphere), (&hemisphere, &paraboloid)] {
        let at = Constraints::new((source.default_point(), 0.1), (target.default_point(), 0.2));
        let map = ConformalMap::new(source.clone(), target.clone(), &at, Direction::Forward.into()).unwrap();
        let text = boundary_csv(&map);
        let in_space = [source, target].map(|side| side.is_surface());
        let columns = 2 + in_space.iter().map(|&in_space| if in_space { 3 } else { 2 }).sum::<usize>() + 1;
        assert_eq!(text.lines().next().unwrap().split(',').count(), columns);
        for row in rows(&text) {
            // the hemisphere's rim is the unit circle at height 0
            let rim = if in_space[0] { &row[2..5] } else { &row[4..7] };
            assert!(in_space[0] || in_space[1]);
            assert!((1.0 - rim[0].hypot(rim[1])).abs() < 4e-3 && rim[2].abs() < 1e-12, "{rim:?}");
        }
        let obj = mapped_obj(&map);
        let count = |start: &str| obj.lines().filter(|line| line.starts_with(start)).count();
        assert_eq!((count("v "), count("vt ")), (map.mapped().vertex_count(), map.mapped().vertex_count()));
        assert_eq!(count("f "), map.mapped().triangles().len());
        let numbers = |line: &str| line.split(' ').skip(1).map(|n| n.parse().unwrap()).collect::<Vec<f64>>();
        for line in obj.lines().filter(|line| line.starts_with("v ")) {
            let place = DVec3::from_slice(&numbers(line));
            if map.is_through_disk() {
                // between the paraboloid and its chords
                let lift = place.z - place.truncate().length_squared();
                assert!((-1e-9..0.03).contains(&lift), "{place}");
            } else {
                assert!((place.length() - 1.0).abs() < 1e-9, "{place}");
            }
        }
    }
}
