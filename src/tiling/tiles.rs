//! The tiles one by one, each once, without a table of those that are known.
//!
//! Every tile but the central one has a parent: the neighbor into which the straight line from its center to 0 leaves it;
//! through a corner, the one whose edge comes first. The parent is nearer to 0, so that the tiles are a tree, which is
//! walked in breadth: deterministic, O(1) a tile.

use super::motion::distance;
use super::{Motion, Tiling};
use crate::geometry::DVec2;
use num_complex::Complex64;
use std::collections::VecDeque;
use std::f64::consts::PI;

/// By this part of a turn the sectors of a tile's edges are turned, so that a line through a corner leaves over one of
/// the two edges there whatever its direction's rounding, 1e-12.
const TIE: f64 = 1e-7;

/// A tile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tile {
    /// The motion of the central tile onto this one.
    pub motion: Motion,
    /// The number of half-turns that it consists of; where two colors suffice, their parity is that of the tile's color.
    pub half_turns: u32,
}

impl Tile {
    /// The tile around 0.
    pub const CENTRAL: Self = Self { motion: Motion::IDENTITY, half_turns: 0 };

    /// Its center.
    pub fn center(&self) -> DVec2 {
        self.motion.apply(DVec2::ZERO)
    }

    /// Its p corners, counter-clockwise; edge k leads to corner k.
    pub fn corners(&self, tiling: Tiling) -> impl Iterator<Item = DVec2> {
        (0..tiling.p()).map(move |edge| self.along_edge(tiling, edge, 1.0))
    }

    /// A point of an edge, from its beginning, −1, to its end, 1, at equal hyperbolic distances:
    /// (it + e)/(1 + iet) in the direction of the edge, with e = tanh(r/2) and t = tanh of half the distance from its middle.
    pub fn along_edge(&self, tiling: Tiling, edge: u8, at: f64) -> DVec2 {
        let middle = (0.5 * tiling.inradius()).tanh();
        let along = Complex64::new(0.0, (0.25 * tiling.edge() * at).tanh());
        let place = tiling.direction(edge) * (along + middle) / (Complex64::ONE + middle * along);
        let image = self.motion.image(place);
        DVec2::new(image.re, image.im)
    }

    /// A point of the straight line from its center, 0, to a corner or to the middle of an edge, 1: line 2k leads to the
    /// middle of edge k, line 2k + 1 to corner k.
    pub fn along_ray(&self, tiling: Tiling, ray: u8, at: f64) -> DVec2 {
        let length = if ray.is_multiple_of(2) { tiling.inradius() } else { tiling.circumradius() };
        let direction = Complex64::cis(PI * f64::from(ray) / f64::from(tiling.p()));
        let image = self.motion.image(direction * (0.5 * at * length).tanh());
        DVec2::new(image.re, image.im)
    }

    /// The Euclidean diameter of the circle around it.
    pub fn size(&self, tiling: Tiling) -> f64 {
        let (t, c) = ((0.5 * tiling.circumradius()).tanh(), self.center().length_squared());
        2.0 * t * (1.0 - c) / (1.0 - t * t * c)
    }

    /// The tile on the other side of an edge; seen from there the edge has the same number.
    #[must_use]
    pub fn neighbor(&self, tiling: Tiling, edge: u8) -> Self {
        let turn = Motion::half_turn(tiling.direction(edge), tiling.edge_circle());
        Self { motion: self.motion.after(&turn), half_turns: self.half_turns + 1 }
    }

    /// Whether two tiles are the same: their centers are nearer to each other than neighbors' are.
    pub fn is_same(&self, other: &Self, tiling: Tiling) -> bool {
        distance(self.center(), other.center()) < tiling.inradius()
    }

    /// The edge over which the line to 0 leaves the tile; `None` for the central one.
    fn towards_center(&self, tiling: Tiling) -> Option<u8> {
        let origin = self.motion.inverse().image(Complex64::ZERO);
        // another tile's center is 0.27 away, as far as two neighbors in {3, 7}
        (origin.norm() > 0.1).then(|| tiling.sector(origin, TIE))
    }
}

impl Tiling {
    /// Calls `visit` with each tile once, in breadth from the central one; the tiles behind one for which it is false are
    /// left out. At most `most` tiles are visited.
    pub fn visit_tiles(self, most: usize, mut visit: impl FnMut(&Tile) -> bool) {
        let mut waiting = VecDeque::from([Tile::CENTRAL]);
        for _ in 0..most {
            let Some(tile) = waiting.pop_front() else { return };
            if !visit(&tile) {
                continue;
            }
            for edge in 0..self.p() {
                let next = tile.neighbor(self, edge);
                if next.towards_center(self) == Some(edge) {
                    waiting.push_back(next);
                }
            }
        }
    }

    /// The tiles of at least this Euclidean size ([`Tile::size`]), at most `most` of them, from the center outwards.
    pub fn tiles(self, least_size: f64, most: usize) -> Vec<Tile> {
        let mut tiles = Vec::new();
        self.visit_tiles(most, |tile| {
            let is_seen = tile.size(self) >= least_size;
            tiles.extend(is_seen.then_some(*tile));
            is_seen
        });
        tiles
    }
}
