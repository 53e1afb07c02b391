//! A drawing contains the outlines, the pattern and the mesh of the map at the right positions.

use super::*;
use crate::conformal::{MapSettings, PrepareSettings, prepare};
use crate::outline::{self, Preset};
use std::f64::consts::TAU;
use std::sync::Arc;

fn map() -> (ConformalMap, Constraints) {
    let [source, target] = [Preset::Star, Preset::Heart]
        .map(|preset| Arc::new(prepare(preset.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap()));
    let constraints = Constraints::new((source.default_point(), 0.1), (target.default_point(), 0.6));
    (ConformalMap::new(source, target, &constraints, MapSettings::default()).unwrap(), constraints)
}

fn squares(panel: &Panel<'_>, cells: f64) -> Ruling {
    let (low, high) = panel.bounds();
    Ruling::Squares { origin: 0.5 * (low + high), spacing: (high - low).max_element() / cells }
}

/// Centered and scaled to height 1, flipped if y points down.
fn normalized(points: &[DVec2]) -> Vec<DVec2> {
    let [min, max] = Bounds::of(points.iter().copied()).corners();
    points.iter().map(|&p| (p - 0.5 * (min + max)) / (max - min).y).collect()
}

#[test]
fn a_drawing_opens_as_the_outline_that_it_shows() {
    let (map, constraints) = map();
    let panels = panels(&map, &constraints).unwrap();
    for side in Side::BOTH {
        let panel = panels[side];
        let wire = Some((panel.positions, panel.triangles));
        let text = svg(&[Part { side, panel, wire }], Some(squares(&panels.source, 12.0)));
        let back = outline::parse("map.svg", text.as_bytes()).unwrap();
        let (drawn, given) = (normalized(back.polygon().vertices()), normalized(panel.boundary));
        assert_eq!(drawn.len(), given.len());
        let farthest = given.iter().map(|p| drawn.iter().map(|q| p.distance(*q)).fold(f64::INFINITY, f64::min));
        let farthest = farthest.fold(0.0, f64::max);
        // three decimals in a drawing of 450 units, and single precision
        assert!(farthest < 1e-5, "{side}: {farthest:e}");
        assert_eq!(back.name(), side.to_string());
    }
}

#[test]
fn every_class_is_drawn_in_both_domains() {
    let (map, constraints) = map();
    let panels = panels(&map, &constraints).unwrap();
    let parts = Side::BOTH.map(|side| {
        let panel = panels[side];
        Part { side, panel, wire: Some((panel.positions, panel.triangles)) }
    });
    let text = svg(&parts, Some(squares(&panels.source, 12.0)));
    for (class, times) in [("outline", 2), ("mesh", 2), ("lines", 4), ("interior", 2), ("boundary", 2)] {
        assert_eq!(text.matches(&format!("class=\"{class}\"")).count(), times, "{class}");
    }
    let bare = svg(&parts.map(|part| Part { wire: None, ..part }), None);
    assert!(!bare.contains("class=\"mesh\"") && !bare.contains("class=\"lines\""));
    let inner = inner_edges(map.side(Side::Source).triangles()).count();
    let (m, n) = (map.side(Side::Source).boundary_count(), map.side(Side::Source).interior_count());
    assert_eq!(inner, 2 * m + 3 * n - 3 - m, "Euler: all edges but the outline's");
}

#[test]
fn lines_of_the_source_are_straight_whole_and_where_they_should_be() {
    let (map, constraints) = map();
    let panel = panels(&map, &constraints).unwrap().source;
    let Ruling::Squares { origin, spacing } = squares(&panel, 10.0) else { unreachable!() };
    for family in 0..FAMILIES {
        let lines = squares(&panel, 10.0).lines(family, panel.positions, panel.coordinates, panel.triangles);
        // a line meets a star in at most three pieces
        assert!((9..=27).contains(&lines.len()), "{} lines", lines.len());
        for line in lines {
            let level = (line.points[0] - origin)[family] / spacing;
            assert!((level - level.round()).abs() < 1e-9 && !line.is_closed);
            assert!(line.points.iter().all(|p| ((*p - origin)[family] / spacing - level.round()).abs() < 1e-9));
        }
    }
}

/// About the center of a disk, circles are closed and rays reach from their start to the boundary.
#[test]
fn circles_close_and_rays_reach_the_boundary() {
    let disk = prepare(Preset::Disk.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap();
    let vertices = disk.domain().unwrap().mesh().vertices();
    let conformal = Ruling::Conformal { rays: 12 };
    let polar = Ruling::Polar { pole: DVec2::ZERO, spacing: 0.25 };
    for (ruling, radii) in [
        (polar, vec![0.25, 0.5, 0.75]),
        (conformal, (1..=4).map(|k| (-TAU * f64::from(k) / 12.0).exp()).collect::<Vec<f64>>()),
    ] {
        let circles = ruling.lines(0, vertices, vertices, disk.triangles());
        let closed: Vec<_> = circles.iter().filter(|line| line.is_closed).collect();
        for radius in radii {
            let off = |line: &&&Line| line.points.iter().map(|p| (p.length() - radius).abs()).fold(0.0, f64::max);
            let nearest = closed.iter().map(|line| off(&line)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.02 * radius, "{ruling:?}: no circle of radius {radius} but {nearest} off");
        }
        let rays = ruling.lines(1, vertices, vertices, disk.triangles());
        let expected = if ruling == polar { 24 } else { 12 };
        assert_eq!(rays.len(), expected, "{ruling:?}: rays in one piece each");
        for ray in &rays {
            let outer = ray.points.iter().map(|p| p.length()).fold(0.0, f64::max);
            assert!(outer > 0.99, "{outer}");
        }
    }
}

/// On the disk, with x in the middle, the map to the disk is a turn: carried tiles are those of the plane, up to the mesh's
/// chords, and every one of them is a closed path.
#[test]
fn tiles_are_carried_to_where_they_belong() {
    use crate::tiling::Tiling;
    let disk = prepare(Preset::Disk.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap();
    let vertices = disk.domain().unwrap().mesh().vertices();
    let scaled: Vec<DVec2> = vertices.iter().map(|&p| 3.0 * p.perp() + DVec2::ONE).collect();
    for (p, q) in [(7, 3), (4, 5)] {
        let tiling = Tiling::new(p, q).unwrap();
        let lines =
            |mirrors, family| Ruling::Tiling { tiling, mirrors }.lines(family, &scaled, vertices, disk.triangles());
        let carried = lines(false, 0);
        // all that are larger than the limit of a panel, 0.0056 of twice the radius
        let expected = tiling.tiles(0.0118, 20_000);
        assert!(carried.len() + 40 > expected.len() && carried.len() > 150, "{} of {}", carried.len(), expected.len());
        for (line, tile) in carried.iter().zip(&expected).take(100) {
            assert!(line.is_closed);
            for corner in tile.corners(tiling).map(|corner| 3.0 * corner.perp() + DVec2::ONE) {
                let nearest = line.points.iter().map(|p| p.distance(corner)).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-12, "{tiling}: a corner is {nearest:e} off");
            }
        }
        assert!(lines(false, 1).is_empty());
        let mirrors = lines(true, 1);
        assert_eq!(mirrors.len(), 2 * usize::from(p) * carried.len());
        assert!(mirrors.iter().all(|line| !line.is_closed));
    }
}

/// In an arm whose end is seen from x under 1e-9 and less, tiles are as large as the arm is wide.
#[test]
fn tiles_are_followed_into_crowded_arms() {
    let settings = PrepareSettings::default();
    let arm = [(0.0, 0.0), (7.0, 0.0), (7.0, 1.0), (0.0, 1.0)].map(DVec2::from).to_vec();
    let side = Arc::new(prepare(&arm.try_into().unwrap(), &settings, &mut |_| ()).unwrap());
    let constraints = Constraints::new((DVec2::new(0.5, 0.5), 0.1), (DVec2::new(0.5, 0.5), 0.1));
    let map = ConformalMap::new(Arc::clone(&side), side, &constraints, MapSettings::default()).unwrap();
    let coordinates = crate::conformal::disk_coordinates(map.side(Side::Source), map.measure(Side::Source)).unwrap();
    let mesh = map.domain(Side::Source).unwrap().mesh();
    let ruling = Ruling::Tiling { tiling: crate::tiling::Tiling::default(), mirrors: false };
    let tiles = ruling.lines(0, mesh.vertices(), &coordinates, mesh.triangles());
    let size = |line: &Line| {
        let [low, high] = Bounds::of(line.points.iter().copied()).corners();
        (high - low).max_element()
    };
    for x in 0..4 {
        let here = tiles.iter().filter(|line| (line.points[0].x - f64::from(x)).abs() < 1.0);
        let largest = here.map(size).fold(0.0, f64::max);
        assert!((0.15..0.7).contains(&largest), "about x = {x} the largest tile has {largest}");
    }
}
