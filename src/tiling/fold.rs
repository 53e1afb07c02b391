//! Folding: half-turns about the middles of the central tile's edges bring any point of the disk into the central tile.
//!
//! A point outside of that tile lies beyond the edge of its sector, the 2p-th of a turn either way from the edge's
//! middle; the half-turn about that middle brings it nearer to 0, since the edge is the bisector of 0 and the neighbor's
//! center. The orbit of a point is discrete, so that this ends. `shaders/tiling.wgsl` does the same by pixel.

use super::motion::Motion;
use super::{Tile, Tiling};
use crate::geometry::DVec2;
use num_complex::Complex64;
use std::f64::consts::TAU;

/// The most half-turns: the fold of a point at 1e-15 of the circle takes 70 in {3, 7}, whose tiles are smallest.
const MOST_TURNS: u32 = 160;

/// A point beyond an edge by less than this, in the hyperbolic metric, lies on it.
const ON_EDGE: f64 = 1e-9;

/// A point of the disk as it lies in the central tile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Folded {
    /// Where it comes to lie, in the sector of the edge on the positive real axis: its argument is from −π/p to π/p.
    pub place: DVec2,
    /// The hyperbolic distances of that place from the mirrors, which are the lines in which the sides of a triangle lie:
    /// from the tile's center to the middle of an edge, from the center to a corner, and the edge.
    pub distances: [f64; 3],
    /// Whether it lies in one of the triangles that are mirror images of the central ones: they alternate.
    pub is_mirrored: bool,
    /// The tile in which it lies.
    pub tile: Tile,
}

impl Tiling {
    /// Folds a point of the open disk into the central tile; `None` for points outside of the disk or at the circle up to
    /// rounding. Cost: a few operations for each tile between the point and 0.
    pub fn fold(self, point: DVec2) -> Option<Folded> {
        let circle = self.edge_circle();
        let (mut z, mut onto_center) = (Complex64::new(point.x, point.y), Motion::IDENTITY);
        for half_turns in 0..MOST_TURNS {
            let u = self.direction(self.sector(z, 0.0));
            let w = u.conj() * z;
            let gap = 1.0 - w.norm_sqr();
            if gap.is_nan() || gap <= 0.0 {
                return None;
            }
            let distances = self.distances(w, circle);
            if distances[2] > -ON_EDGE {
                let tile = Tile { motion: onto_center.inverse(), half_turns };
                let place = DVec2::new(w.re, w.im);
                return Some(Folded { place, distances, is_mirrored: w.im < 0.0, tile });
            }
            let turn = Motion::half_turn(u, circle);
            (z, onto_center) = (turn.image(z), turn.after(&onto_center));
        }
        None
    }

    /// The distances of a point of the sector of the first edge from the three mirrors; the third is negative beyond the
    /// edge: sinh d is 2|y|/(1 − |w|²), 2(x sin π/p − |y| cos π/p)/(1 − |w|²) and (|w|² + 1 − 2cx)/(ρ(1 − |w|²)) for an edge
    /// on the circle about c with the radius ρ.
    fn distances(self, w: Complex64, [center, radius]: [f64; 2]) -> [f64; 3] {
        let [angle, _] = self.angles();
        let gap = 1.0 - w.norm_sqr();
        let along = 2.0 * w.im.abs() / gap;
        let across = 2.0 * (w.re * angle.sin() - w.im.abs() * angle.cos()) / gap;
        let edge = (w.norm_sqr() + 1.0 - 2.0 * center * w.re) / (radius * gap);
        [along, across, edge].map(f64::asinh)
    }

    /// The number of the edge in whose sector a point lies; sectors are turned by `shift` turns.
    pub(super) fn sector(self, z: Complex64, shift: f64) -> u8 {
        let p = f64::from(self.p());
        ((z.arg() / TAU - shift) * p).round().rem_euclid(p) as u8
    }

    /// The direction from 0 to the middle of the edge with this number.
    pub(super) fn direction(self, edge: u8) -> Complex64 {
        Complex64::cis(TAU * f64::from(edge) / f64::from(self.p()))
    }
}
