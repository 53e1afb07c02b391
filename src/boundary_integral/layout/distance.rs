//! Whether panels are short against their distances from the other parts of the boundary.
//!
//! The density varies over the width of the side in which the problem lives, and next to corners over the distance from
//! them; of parts that are close across the other side it knows nothing, and integrals over close panels are exact.
//! Only the innermost panels of a block, whose density is no polynomial, must be clear of everything else.

use super::super::corner::Problem;
use super::shape::Shape;
use super::{Block, End, Fineness, Layout, Panel};
use crate::geometry::{Curve, Junction};

/// How much faster panels may grow from a common tangent than from a corner.
const GROWTH: f64 = 2.0;
/// A chord of at least this share of its arc belongs to one smooth stretch of the curve; of a half circle it is 0.64.
const LEAST_CHORD: f64 = 0.6;
/// The least distance of a junction from the other parts of the boundary, in innermost panels of its block: nothing then
/// lies in the ellipse around these panels in which points are near.
const CLEAR: f64 = 1.4;

/// The panels of a layout, and the lengths of the curve between them.
pub struct Distances<'a> {
    curve: &'a Curve,
    fineness: Fineness,
    problem: Problem,
    layout: &'a Layout,
    shapes: &'a [Shape],
    /// The lengths of the curve up to each panel, and the whole.
    along: Vec<f64>,
}

impl<'a> Distances<'a> {
    pub fn new(
        curve: &'a Curve,
        (fineness, problem): (Fineness, Problem),
        layout: &'a Layout,
        shapes: &'a [Shape],
    ) -> Self {
        let mut along = vec![0.0];
        along.extend(shapes.iter().scan(0.0, |sum, shape| {
            *sum += shape.length;
            Some(*sum)
        }));
        Self { curve, fineness, problem, layout, shapes, along }
    }

    /// Whether panel `k` is too long against its distance from another one that is not its neighbor, or from the ends of
    /// its piece.
    pub fn is_too_long(&self, k: usize) -> bool {
        let (panel, shape, count) = (&self.layout.panels[k], &self.shapes[k], self.shapes.len());
        let is_too_near = |other: usize| {
            let apart = (k + count - other) % count;
            let is_neighbor = apart <= 1 || apart == count - 1;
            !is_neighbor
                && shape.length > self.fineness.proximity * shape.gap(&self.shapes[other])
                && !self.belongs_together(panel, &self.layout.panels[other])
                && self.is_close(k, other)
        };
        (panel.block.is_none() && self.is_long_beside_junctions(k)) || (0..count).any(is_too_near)
    }

    /// Whether a panel outside of blocks is too long against its distance from the ends of its piece.
    fn is_long_beside_junctions(&self, k: usize) -> bool {
        let (shape, piece) = (&self.shapes[k], self.layout.panels[k].piece);
        [piece, (piece + 1) % self.curve.pieces().len()].into_iter().any(|junction| {
            let growth = self.growth(junction);
            growth.is_finite() && shape.length > growth * shape.distance_to(self.place(junction))
        })
    }

    /// The largest length of a panel in its distances from a junction.
    fn growth(&self, junction: usize) -> f64 {
        match self.curve.junctions()[junction] {
            Junction::Analytic => f64::INFINITY,
            Junction::Smooth => GROWTH * self.fineness.proximity,
            Junction::Corner { .. } => self.fineness.proximity,
        }
    }

    fn place(&self, junction: usize) -> crate::geometry::DVec2 {
        self.curve.pieces()[junction].jet(0.0).position
    }

    /// Whether something that does not continue the legs of a block is near its innermost panels.
    pub fn is_crowded(&self, block: &Block) -> bool {
        let place = self.place(block.junction);
        let innermost = self.shapes[block.panels[0]].length.max(self.shapes[block.panels[block.mesh.panels]].length);
        let is_near = |(panel, shape): (&Panel, &Shape)| {
            let is_own = panel.block.is_some_and(|own| std::ptr::eq(&raw const self.layout.blocks[own], block));
            let is_on_leg = self.is_on_leg(block, panel);
            !is_own
                && !is_on_leg
                && shape.may_be_within(place, CLEAR * innermost)
                && shape.distance_to(place) < CLEAR * innermost
        };
        self.layout.panels.iter().zip(self.shapes).any(is_near)
    }

    /// Whether a panel continues one of a block's legs: it lies on the same line, or begins within twice the block's
    /// reach.
    fn is_on_leg(&self, block: &Block, panel: &Panel) -> bool {
        let count = self.curve.pieces().len();
        let is_on_piece = panel.piece == block.junction || (panel.piece + 1) % count == block.junction;
        (is_on_piece && self.curve.pieces()[panel.piece].is_straight()) || self.is_beside(block, panel)
    }

    /// Whether a panel is too long against its distance from another one. On one analytic curve distances count only
    /// where they are clearly less than the length of the curve between: elsewhere the kernel is smooth. Across a
    /// common tangent it is bounded, and the density's singularity weak: panels may grow faster away from there.
    fn is_close(&self, k: usize, other: usize) -> bool {
        let length = self.shapes[k].length;
        let distance = self.shapes[k].distance_across(&self.shapes[other], self.problem);
        if length <= self.fineness.proximity * distance {
            return false;
        }
        let (first, last) = (k.min(other), k.max(other));
        let inner = self.along[last] - self.along[first + 1];
        let outer = self.along[self.shapes.len()] - self.along[last + 1] + self.along[first];
        let [p, q] = [first, last].map(|panel| self.layout.panels[panel].piece);
        let is_free = |junctions: &mut dyn Iterator<Item = usize>| {
            let growth = junctions.map(|junction| match self.curve.junctions()[junction] {
                Junction::Corner { .. } => 0.0,
                _ => self.growth(junction),
            });
            length <= growth.fold(f64::INFINITY, f64::min) * distance
        };
        let is_direct = |between: f64| distance >= LEAST_CHORD * between;
        let within = is_direct(inner) && is_free(&mut (p + 1..=q));
        let around = is_direct(outer) && is_free(&mut (q + 1..self.curve.pieces().len()).chain(0..=p));
        !(within || around)
    }

    /// Whether two panels need no distance: in one straight line, in one block, or a block and what is next to it.
    fn belongs_together(&self, panel: &Panel, other: &Panel) -> bool {
        let in_one_line = panel.piece == other.piece && self.curve.pieces()[panel.piece].is_straight();
        let in_one_block = panel.block.is_some() && panel.block == other.block;
        in_one_line
            || in_one_block
            || panel.block.is_some_and(|block| self.is_beside(&self.layout.blocks[block], other))
    }

    /// Whether a panel begins on a leg of a block within twice the block's reach.
    fn is_beside(&self, block: &Block, panel: &Panel) -> bool {
        let count = self.curve.pieces().len();
        let before = (block.junction + count - 1) % count;
        let from = |end: End| if panel.end == end { panel.from } else { 1.0 - panel.to };
        let [first, second] = block.scales.map(|scale| 2.0 * scale * block.mesh.panels as f64);
        (panel.piece == before && from(End::Finish) < first)
            || (panel.piece == block.junction && from(End::Start) < second)
    }
}
