//! Whether panels are short against their distances from the other parts of the boundary.

use super::shape::Shape;
use super::{Block, End, Fineness, Layout, Panel};
use crate::geometry::{Curve, Junction};

/// How much faster panels may grow from a common tangent than from a corner.
const GROWTH: f64 = 2.0;
/// A chord of at least this share of its arc belongs to one smooth stretch of the curve; of a half circle it is 0.64.
const LEAST_CHORD: f64 = 0.6;

/// The panels of a layout, and the lengths of the curve between them.
pub struct Distances<'a> {
    curve: &'a Curve,
    fineness: Fineness,
    layout: &'a Layout,
    shapes: &'a [Shape],
    /// The lengths of the curve up to each panel, and the whole.
    along: Vec<f64>,
}

impl<'a> Distances<'a> {
    pub fn new(curve: &'a Curve, fineness: Fineness, layout: &'a Layout, shapes: &'a [Shape]) -> Self {
        let mut along = vec![0.0];
        along.extend(shapes.iter().scan(0.0, |sum, shape| {
            *sum += shape.length;
            Some(*sum)
        }));
        Self { curve, fineness, layout, shapes, along }
    }

    /// Whether panel `k` is too long against its distance from another one that is not its neighbour.
    pub fn is_too_long(&self, k: usize) -> bool {
        let (panel, shape, count) = (&self.layout.panels[k], &self.shapes[k], self.shapes.len());
        (0..count).any(|other| {
            let apart = (k + count - other) % count;
            let is_neighbour = apart <= 1 || apart == count - 1;
            !is_neighbour
                && shape.length > self.fineness.proximity * shape.gap(&self.shapes[other])
                && !self.belongs_together(panel, &self.layout.panels[other])
                && self.is_close(k, other)
        })
    }

    /// Whether a panel is too long against its distance from another one. On one analytic curve distances count only
    /// where they are clearly less than the length of the curve between: elsewhere the kernel is smooth. Across a
    /// common tangent it is bounded, and the density's singularity weak: panels may grow faster away from there.
    fn is_close(&self, k: usize, other: usize) -> bool {
        let length = self.shapes[k].length;
        let distance = self.shapes[k].distance(&self.shapes[other]);
        if length <= self.fineness.proximity * distance {
            return false;
        }
        let (first, last) = (k.min(other), k.max(other));
        let inner = self.along[last] - self.along[first + 1];
        let outer = self.along[self.shapes.len()] - self.along[last + 1] + self.along[first];
        let [p, q] = [first, last].map(|panel| self.layout.panels[panel].piece);
        let is_free = |junctions: &mut dyn Iterator<Item = usize>| {
            let growth = junctions.map(|junction| match self.curve.junctions()[junction] {
                Junction::Analytic => f64::INFINITY,
                Junction::Smooth => GROWTH * self.fineness.proximity,
                Junction::Corner { .. } => 0.0,
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
