//! The tiles of a hyperbolic tiling, carried from the unit disk into a drawing.
//!
//! Points of a tile's edges, at equal hyperbolic distances, are located in the mesh as it lies in the disk, and moved to
//! where the mesh is drawn. Tiles are followed outwards while they are large enough to be seen in the drawing, so that
//! there are as many in a crowded arm as in the middle. Left out are smaller ones, those that reach beyond the mesh, and
//! those so near to the circle that f64 does not resolve them.

use super::polylines::Line;
use crate::geometry::{Bounds, DVec2};
use crate::mesh::{DiskLayout, TriangleId, neighbours_of};
use crate::tiling::{Tile, Tiling};

/// The least size of a tile that is drawn, relative to the drawing: 2.5 of its 448 units.
const LEAST: f64 = 0.0056;
/// Tiles are followed while they are larger than this part of [`LEAST`]: a way along a wall may lead to larger ones.
const FOLLOWED: f64 = 0.3;
/// The most tiles that are looked at; drawings have some thousands.
const MOST_TILES: usize = 60_000;
/// 1 − |c|² of a tile's center c from which on its points are no longer told apart: the mesh is solved to 1e-14.
const RESOLVED: f64 = 1e-11;
/// The length of the pieces of an edge relative to the drawing, and their numbers.
const PIECE: f64 = 0.009;
const PIECES: [f64; 2] = [2.0, 24.0];

/// A mesh that lies in the disk and in a drawing.
pub struct CarriedMesh<'a> {
    /// The positions of the vertices in the drawing.
    pub positions: &'a [DVec2],
    /// Those in the disk.
    pub coordinates: &'a [DVec2],
    /// The triangles.
    pub triangles: &'a [[u32; 3]],
}

impl CarriedMesh<'_> {
    /// The tiles as closed lines, from the central one outwards.
    pub fn tiles(&self, tiling: Tiling) -> Vec<Line> {
        let mut lines = Vec::new();
        self.visit(tiling, &mut |carrier, tile, scale| {
            lines.extend(carrier.outline(tiling, tile, scale).map(|points| Line { points, is_closed: true }));
        });
        lines
    }

    /// The mirrors in the tiles: lines from their centers to their corners and to the middles of their edges.
    pub fn mirrors(&self, tiling: Tiling) -> Vec<Line> {
        let mut lines = Vec::new();
        self.visit(tiling, &mut |carrier, tile, scale| {
            lines.extend((0..2 * tiling.p()).filter_map(|ray| {
                let points = carrier.carry_line(scale, &|at| tile.along_ray(tiling, ray, at))?;
                Some(Line { points, is_closed: false })
            }));
        });
        lines
    }

    /// Calls `draw` for each tile that is seen, with the size of the drawing.
    fn visit(&self, tiling: Tiling, draw: &mut dyn FnMut(&mut Carrier<'_>, &Tile, f64)) {
        let [low, high] = Bounds::of(self.positions.iter().copied()).corners();
        let scale = (high - low).max_element();
        let neighbours = neighbours_of(self.triangles, self.coordinates.len());
        let layout = DiskLayout { triangles: self.triangles, neighbours: &neighbours, places: self.coordinates };
        let mut carrier = Carrier { layout, positions: self.positions, at: TriangleId::new(0) };
        tiling.visit_tiles(MOST_TILES, |tile| {
            if 1.0 - tile.center().length_squared() < RESOLVED {
                return false;
            }
            let corners: Option<Vec<DVec2>> = tile.corners(tiling).map(|corner| carrier.carry(corner)).collect();
            let Some(corners) = corners else { return false };
            let [low, high] = Bounds::of(corners).corners();
            let size = (high - low).max_element();
            if size >= LEAST * scale {
                draw(&mut carrier, tile, scale);
            }
            size >= FOLLOWED * LEAST * scale
        });
    }
}

/// Moves points of the disk to the drawing.
struct Carrier<'a> {
    layout: DiskLayout<'a>,
    positions: &'a [DVec2],
    /// Where the last point was.
    at: TriangleId,
}

impl Carrier<'_> {
    fn carry(&mut self, place: DVec2) -> Option<DVec2> {
        let found = self.layout.locate(place, self.at, &mut 0)?;
        self.at = found.triangle();
        let corners = self.layout.triangles[found.triangle().index()].map(|v| self.positions[v as usize]);
        Some(corners.into_iter().zip(found.weights()).map(|(corner, weight)| weight * corner).sum())
    }

    /// The points around a tile, without repeating the first.
    fn outline(&mut self, tiling: Tiling, tile: &Tile, scale: f64) -> Option<Vec<DVec2>> {
        let mut points = Vec::new();
        for edge in 0..tiling.p() {
            points.extend(self.carry_line(scale, &|at| tile.along_edge(tiling, edge, 2.0 * at - 1.0))?);
            points.pop();
        }
        Some(points)
    }

    /// A line in the disk, given from 0 to 1, in pieces of nearly equal hyperbolic length.
    fn carry_line(&mut self, scale: f64, place: &dyn Fn(f64) -> DVec2) -> Option<Vec<DVec2>> {
        let ends = [self.carry(place(0.0))?, self.carry(place(1.0))?];
        let pieces = (ends[0].distance(ends[1]) / (PIECE * scale)).ceil().clamp(PIECES[0], PIECES[1]) as u32;
        (0..=pieces).map(|k| self.carry(place(f64::from(k) / f64::from(pieces)))).collect()
    }
}
