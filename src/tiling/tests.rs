//! Angles, lengths, areas and numbers of tiles; folding does not depend on the tile that a point is in.

use super::motion::distance;
use super::*;
use crate::geometry::DVec2;

const SYMBOLS: [(u8, u8); 6] = [(7, 3), (4, 5), (5, 4), (3, 7), (8, 3), (6, 6)];

fn tilings() -> [Tiling; 6] {
    SYMBOLS.map(|(p, q)| Tiling::new(p, q).unwrap())
}

/// The angle at b between the geodesics to a and to c: that of their directions after b is moved to 0.
fn angle(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let moved = |z: DVec2| {
        let [z, b] = [z, b].map(|p| num_complex::Complex64::new(p.x, p.y));
        (z - b) / (1.0 - b.conj() * z)
    };
    (moved(c) / moved(a)).arg().abs()
}

/// Turns about 0 by the p-th part of a turn, and half-turns: they generate the group.
fn some_motions(tiling: Tiling) -> Vec<Motion> {
    tiling.tiles(0.05, 60).into_iter().map(|tile| tile.motion).collect()
}

#[test]
fn there_are_hyperbolic_tilings_and_others() {
    assert_eq!(Tiling::new(4, 4), Err(TilingError::Euclidean { p: 4, q: 4 }));
    assert_eq!(Tiling::new(3, 5), Err(TilingError::Spherical { p: 3, q: 5, solid: Solid::Icosahedron }));
    assert_eq!(Tiling::new(2, 9), Err(TilingError::OutOfRange { p: 2, q: 9 }));
    assert_eq!(Tiling::new(21, 3), Err(TilingError::OutOfRange { p: 21, q: 3 }));
    for (p, q) in TILING_NUMBERS.flat_map(|p| TILING_NUMBERS.map(move |q| (p, q))) {
        let excess = (u32::from(p) - 2) * (u32::from(q) - 2);
        match Tiling::new(p, q) {
            Ok(tiling) => assert!(excess > 4 && (tiling.p(), tiling.q()) == (p, q)),
            Err(TilingError::Euclidean { .. }) => assert_eq!(excess, 4),
            Err(TilingError::Spherical { .. }) => assert!(excess < 4),
            Err(error @ TilingError::OutOfRange { .. }) => assert_eq!(None, Some(error), "in the range"),
        }
    }
    assert!(TilingError::Euclidean { p: 6, q: 3 }.to_string().starts_with("{6, 3} lives in the plane"));
}

#[test]
fn the_fundamental_triangle_has_its_angles_and_sides() {
    for tiling in tilings() {
        let [p, q] = [tiling.p(), tiling.q()].map(f64::from);
        for tile in tiling.tiles(0.02, 40) {
            let (center, middle) = (tile.center(), tile.along_edge(tiling, 0, 0.0));
            let corner = tile.along_edge(tiling, 0, 1.0);
            let angles = [angle(middle, center, corner), angle(center, corner, middle), angle(corner, middle, center)];
            for (found, parts) in angles.into_iter().zip([p, q, 2.0]) {
                assert!((found - PI / parts).abs() < 1e-11, "{tiling}: {found} instead of π/{parts}");
            }
            for (found, expected) in [
                (distance(center, middle), tiling.inradius()),
                (distance(center, corner), tiling.circumradius()),
                (distance(tile.along_edge(tiling, 0, -1.0), corner), tiling.edge()),
            ] {
                assert!((found - expected).abs() < 1e-11, "{tiling}: {found} instead of {expected}");
            }
        }
    }
    // cosh r of {7, 3} is 1/(2 sin π/7)
    let heptagon = Tiling::default();
    assert!((heptagon.inradius() - 0.545_274_831_75).abs() < 1e-9, "{}", heptagon.inradius());
    assert!((heptagon.edge() - 0.566_256_306_73).abs() < 1e-9, "{}", heptagon.edge());
    assert!((heptagon.circumradius() - 0.620_671_737_56).abs() < 1e-9, "{}", heptagon.circumradius());
}

#[test]
fn the_area_of_every_tile_is_its_angular_defect() {
    assert!((Tiling::default().area() - PI / 3.0).abs() < 1e-14);
    for tiling in tilings() {
        for tile in tiling.tiles(0.02, 40) {
            let corners: Vec<DVec2> = tile.corners(tiling).collect();
            let count = corners.len();
            let at = |k: usize| corners[k % count];
            let angles: f64 = (0..count).map(|k| angle(at(k), at(k + 1), at(k + 2))).sum();
            let defect = (count as f64 - 2.0) * PI - angles;
            assert!((defect - tiling.area()).abs() < 1e-10, "{tiling}: {defect} instead of {}", tiling.area());
        }
    }
}

/// The tiles by their number of steps from the central one, each step over an edge.
fn generations(tiling: Tiling, most: usize) -> Vec<usize> {
    let (mut known, mut last, mut counts) = (vec![Tile::CENTRAL], vec![Tile::CENTRAL], vec![1]);
    while counts.len() < most {
        let mut next: Vec<Tile> = Vec::new();
        for tile in &last {
            for found in (0..tiling.p()).map(|edge| tile.neighbor(tiling, edge)) {
                if !known.iter().chain(&next).any(|other| other.is_same(&found, tiling)) {
                    next.push(found);
                }
            }
        }
        counts.push(next.len());
        known.extend(&next);
        last = next;
    }
    counts
}

#[test]
fn generations_have_their_numbers() {
    // 7 F(2n) heptagons, F being Fibonacci's numbers
    assert_eq!(generations(Tiling::default(), 6), [1, 7, 21, 56, 147, 385]);
    assert_eq!(generations(Tiling::new(4, 5).unwrap(), 5), [1, 4, 12, 28, 64]);
}

#[test]
fn every_tile_is_listed_once_and_none_is_missing() {
    for tiling in tilings() {
        let tiles = tiling.tiles(0.04, 5000);
        for (k, tile) in tiles.iter().enumerate() {
            assert!(tiles[..k].iter().all(|other| !other.is_same(tile, tiling)), "{tiling}: tile {k} twice");
            for neighbor in (0..tiling.p()).map(|edge| tile.neighbor(tiling, edge)) {
                let is_listed = tiles.iter().any(|other| other.is_same(&neighbor, tiling));
                // of the same size up to rounding: the limit may lie between two of a ring
                assert!(is_listed || neighbor.size(tiling) < 0.04 + 1e-9, "{tiling}: a neighbor of {k} is missing");
            }
        }
        assert_eq!(tiles, tiling.tiles(0.04, 5000), "deterministic");
        assert_eq!(tiling.tiles(0.04, 11).len(), 11);
    }
}

#[test]
fn neighbors_share_an_edge() {
    for tiling in tilings() {
        for tile in tiling.tiles(0.05, 30) {
            for edge in 0..tiling.p() {
                let other = tile.neighbor(tiling, edge);
                for at in [-1.0, -0.3, 0.0, 0.8, 1.0] {
                    let (here, there) = (tile.along_edge(tiling, edge, at), other.along_edge(tiling, edge, -at));
                    assert!(here.distance(there) < 1e-12, "{tiling}, edge {edge}: {here} and {there}");
                }
            }
        }
    }
}

#[test]
fn depth_is_measured_by_the_distance() {
    for radius in [0.0, 0.3, 0.99, 1.0 - 1e-9] {
        let point = DVec2::new(0.0, -radius);
        assert!((depth(point) - (0.25 * distance(point, DVec2::ZERO)).tanh()).abs() < 1e-9, "{radius}");
    }
    assert_eq!([depth(DVec2::ZERO), depth(DVec2::X), depth(2.0 * DVec2::X)], [0.0, 1.0, 1.0]);
}

/// Points of the disk in a spiral.
fn points() -> impl Iterator<Item = DVec2> {
    (0..300).map(|k| (1.0 - 0.97_f64.powi(k)) * DVec2::from_angle(2.4 * f64::from(k)))
}

#[test]
fn folding_does_not_depend_on_the_tile() {
    for tiling in tilings() {
        let motions = some_motions(tiling);
        for (k, point) in points().enumerate() {
            let here = tiling.fold(point).unwrap();
            let there = tiling.fold(motions[k % motions.len()].apply(point)).unwrap();
            for (a, b) in here.distances.into_iter().zip(there.distances) {
                // an error of 1e-16 grows by the metric, up to 2e5 here and again in the other tile
                assert!((a - b).abs() < 1e-6, "{tiling} at {point}: {here:?}, {there:?}");
            }
            assert!(here.distances.iter().all(|d| *d >= -1e-6), "inside of the triangle: {here:?}");
            let is_at_mirror = here.distances.iter().any(|d| *d < 1e-6);
            assert!(is_at_mirror || here.is_mirrored == there.is_mirrored, "motions mirror nothing");
        }
    }
}

#[test]
fn a_folded_point_lies_in_the_tile_that_is_said() {
    for tiling in tilings() {
        for point in points() {
            let folded = tiling.fold(point).unwrap();
            let center = folded.tile.center();
            let nearest = (0..tiling.p()).map(|edge| folded.tile.neighbor(tiling, edge).center());
            let others = nearest.map(|center| distance(center, point)).fold(f64::INFINITY, f64::min);
            assert!(distance(center, point) < others + 1e-6, "{tiling}: {point} is not in the tile at {center}");
        }
    }
}

/// With an even number around a corner, tiles on both sides of an edge differ, whatever the way to them.
#[test]
fn two_colors_alternate_where_they_can() {
    for tiling in tilings() {
        let tiles = tiling.tiles(0.05, 400);
        let parity = |tile: &Tile| tile.half_turns % 2;
        let mut clashes = 0;
        for tile in &tiles {
            for neighbor in (0..tiling.p()).map(|edge| tile.neighbor(tiling, edge)) {
                let listed = tiles.iter().find(|other| other.is_same(&neighbor, tiling));
                clashes += usize::from(listed.is_some_and(|listed| parity(listed) == parity(tile)));
            }
        }
        assert_eq!(clashes == 0, tiling.is_two_colorable(), "{tiling}: {clashes} clashes");
    }
}

#[test]
fn points_at_the_circle_and_beyond_are_in_no_tile() {
    for point in [DVec2::X, DVec2::new(0.8, -0.7), DVec2::NAN, DVec2::new(f64::INFINITY, 0.0)] {
        assert_eq!(Tiling::default().fold(point), None, "{point}");
    }
}

#[cfg(feature = "io")]
#[test]
fn pairs_are_checked_when_they_are_read() {
    let tiling = Tiling::new(4, 5).unwrap();
    assert_eq!(serde_json::to_string(&tiling).unwrap(), "[4,5]");
    assert_eq!(serde_json::from_str::<Tiling>("[4,5]").unwrap(), tiling);
    let refused = serde_json::from_str::<Tiling>("[4,4]").unwrap_err().to_string();
    assert!(refused.contains("lives in the plane"), "{refused}");
}
