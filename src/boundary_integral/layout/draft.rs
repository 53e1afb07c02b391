//! The layout while it is refined: the sizes of the blocks, and the intervals between them.

use super::distance::Distances;
use super::shape::Shape;
use super::{Block, End, Fineness, Layout, Panel};
use crate::boundary_integral::corner::{BlockMesh, Problem};
use crate::boundary_integral::leg::Leg;
use crate::geometry::{Curve, DVec2, Junction};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Legs that are less than [`Fineness::blunt`] apart, inside or outside, have two panels on each leg of a block. Below
/// this angle two panels instead of four leave errors of 1e-14 and more, and the finer mesh has four.
const ACUTE: f64 = 0.7;
/// Two blocks that leave less of a piece between them meet.
const NOTHING_BETWEEN: f64 = 1e-9;
/// The panels of a piece between analytic junctions to start with, so that a closed piece is no neighbour of itself.
const FIRST_PANELS: u32 = 8;

/// The panels of a block on each leg.
fn block_mesh(junction: Junction, fineness: Fineness) -> BlockMesh {
    let finer = if fineness.blocks_are_fine { 2 } else { 1 };
    let panels = match junction {
        Junction::Corner { angle } => match angle.min(TAU - angle) {
            between if between < fineness.blunt.min(ACUTE) => 2 * finer,
            between if between < fineness.blunt => 2,
            _ => finer,
        },
        _ => 1,
    };
    BlockMesh { panels }
}

/// What is laid out so far: the sizes of the blocks and the intervals between them.
pub struct Draft<'a> {
    curve: &'a Curve,
    near: &'a [DVec2],
    fineness: Fineness,
    problem: Problem,
    meshes: Vec<Option<BlockMesh>>,
    /// The length of the panels of each junction's block.
    sizes: Vec<f64>,
    /// The intervals of t of each piece outside of blocks.
    between: Vec<Vec<[f64; 2]>>,
    /// The shapes of the last round's panels, by piece, end and bounds.
    known: BTreeMap<(usize, bool, u64, u64), Shape>,
}

impl<'a> Draft<'a> {
    pub fn new(curve: &'a Curve, near: &'a [DVec2], fineness: Fineness, problem: Problem) -> Self {
        let count = curve.pieces().len();
        let mesh = |junction: &Junction| (*junction != Junction::Analytic).then(|| block_mesh(*junction, fineness));
        let meshes: Vec<Option<BlockMesh>> = curve.junctions().iter().map(mesh).collect();
        let size = |k: usize| {
            let Some(mesh) = meshes[k] else { return 0.0 };
            // at most half of either leg
            let reach = |leg: &Leg| 0.5 * leg.length * leg.speed.min(1.0);
            let [a, b] = Leg::both(curve, k);
            fineness.block * reach(&a).min(reach(&b)) / mesh.panels as f64
        };
        let sizes = (0..count).map(size).collect();
        let (between, known) = (Vec::new(), BTreeMap::new());
        let mut draft = Self { curve, near, fineness, problem, meshes, sizes, between, known };
        draft.between = (0..count).map(|piece| draft.between_blocks(piece)).collect();
        draft
    }

    /// The parameter up to which the block at one end of a piece reaches.
    fn reach(&self, piece: usize, end: End) -> f64 {
        let junction = if end == End::Start { piece } else { (piece + 1) % self.sizes.len() };
        let panels = self.meshes[junction].map_or(0, |mesh| mesh.panels);
        panels as f64 * self.scale(piece, end)
    }

    /// The parameters per panel of the block at one end of a piece.
    fn scale(&self, piece: usize, end: End) -> f64 {
        let junction = if end == End::Start { piece } else { (piece + 1) % self.sizes.len() };
        let leg = Leg::new(self.curve, piece, end == End::Finish);
        self.sizes[junction] / (leg.speed * leg.length)
    }

    fn between_blocks(&self, piece: usize) -> Vec<[f64; 2]> {
        let (low, high) = (self.reach(piece, End::Start), 1.0 - self.reach(piece, End::Finish));
        if high - low < NOTHING_BETWEEN {
            return Vec::new();
        }
        let is_curved = !self.curve.pieces()[piece].is_straight();
        let count = if is_curved && low == 0.0 && high == 1.0 { FIRST_PANELS } else { 1 };
        let at = |k: u32| low + (high - low) * f64::from(k) / f64::from(count);
        (0..count).map(|k| [at(k), at(k + 1)]).collect()
    }

    /// The panels in the order of the curve.
    pub fn panels(&self) -> Layout {
        let mut blocks = self.blocks();
        let mut panels = Vec::new();
        let count = self.sizes.len();
        let block_of = |blocks: &[Block], junction: usize| blocks.iter().position(|block| block.junction == junction);
        for piece in 0..count {
            if let Some(block) = block_of(&blocks, piece) {
                let q = blocks[block].mesh.panels;
                for k in 0..q {
                    blocks[block].panels[q + k] = panels.len();
                    panels.push(self.block_panel(piece, End::Start, k, block));
                }
            }
            panels.extend(self.between[piece].iter().map(|&interval| panel_between(piece, interval)));
            if let Some(block) = block_of(&blocks, (piece + 1) % count) {
                for k in (0..blocks[block].mesh.panels).rev() {
                    blocks[block].panels[k] = panels.len();
                    panels.push(self.block_panel(piece, End::Finish, k, block));
                }
            }
        }
        Layout { panels, blocks }
    }

    /// The blocks, whose panels are not yet numbered.
    fn blocks(&self) -> Vec<Block> {
        let count = self.sizes.len();
        let block = |(junction, mesh): (usize, &Option<BlockMesh>)| {
            let (mesh, before) = ((*mesh)?, (junction + count - 1) % count);
            let scales = [self.scale(before, End::Finish), self.scale(junction, End::Start)];
            Some(Block { junction, mesh, scales, panels: vec![0; 2 * mesh.panels] })
        };
        self.meshes.iter().enumerate().filter_map(block).collect()
    }

    /// The panel `k` of a block, counted from its junction, at one end of a piece.
    fn block_panel(&self, piece: usize, end: End, k: usize, block: usize) -> Panel {
        let scale = self.scale(piece, end);
        Panel { piece, end, from: scale * k as f64, to: scale * (k + 1) as f64, block: Some(block) }
    }

    /// Splits every panel that is too long, or deviates from a spline by more than `tolerance`; whether there was one.
    pub fn split(&mut self, layout: &Layout, tolerance: f64) -> bool {
        let shapes = self.shapes(layout);
        let distances = Distances::new(self.curve, (self.fineness, self.problem), layout, &shapes);
        let is_too_long = |k: usize| {
            shapes[k].is_unresolved(self.fineness.tail, tolerance)
                || shapes[k].is_long_beside(self.near, self.fineness.nearness)
                || distances.is_too_long(k)
        };
        let too_long: Vec<bool> = (0..shapes.len()).map(is_too_long).collect();
        let mut halved: Vec<bool> = layout.blocks.iter().map(|block| distances.is_crowded(block)).collect();
        for (panel, _) in layout.panels.iter().zip(&too_long).filter(|(_, long)| **long) {
            if let Some(block) = panel.block {
                halved[block] = true;
            }
        }
        self.bisect(layout, &too_long);
        for (block, _) in layout.blocks.iter().zip(&halved).filter(|(_, halved)| **halved) {
            self.halve(block.junction);
        }
        too_long.contains(&true) || halved.contains(&true)
    }

    /// The shapes of the panels; those of the last round are known.
    fn shapes(&mut self, layout: &Layout) -> Vec<Shape> {
        let key = |panel: &Panel| (panel.piece, panel.end == End::Finish, panel.from.to_bits(), panel.to.to_bits());
        let mut known = std::mem::take(&mut self.known);
        let shape = |panel: &Panel| known.remove(&key(panel)).unwrap_or_else(|| Shape::of(self.curve, panel));
        let shapes: Vec<Shape> = layout.panels.iter().map(shape).collect();
        self.known = layout.panels.iter().map(key).zip(shapes.iter().cloned()).collect();
        shapes
    }

    fn bisect(&mut self, layout: &Layout, too_long: &[bool]) {
        let mut between = vec![Vec::new(); self.between.len()];
        let mut given = self.between.iter().map(|list| list.iter()).collect::<Vec<_>>();
        for (panel, &long) in layout.panels.iter().zip(too_long).filter(|(panel, _)| panel.block.is_none()) {
            let Some(&[low, high]) = given[panel.piece].next() else { continue };
            let middle = 0.5 * (low + high);
            if long {
                between[panel.piece].extend([[low, middle], [middle, high]]);
            } else {
                between[panel.piece].push([low, high]);
            }
        }
        self.between = between;
    }

    /// Halves a block; what it leaves becomes a panel on each leg.
    fn halve(&mut self, junction: usize) {
        let count = self.sizes.len();
        let before = (junction + count - 1) % count;
        let old = [self.reach(before, End::Finish), self.reach(junction, End::Start)];
        self.sizes[junction] *= 0.5;
        let new = [self.reach(before, End::Finish), self.reach(junction, End::Start)];
        self.between[before].push([1.0 - old[0], 1.0 - new[0]]);
        self.between[junction].insert(0, [new[1], old[1]]);
    }
}

/// The panel on an interval of t, measured from the nearer end of the piece.
fn panel_between(piece: usize, [low, high]: [f64; 2]) -> Panel {
    if low + high <= 1.0 {
        Panel { piece, end: End::Start, from: low, to: high, block: None }
    } else {
        Panel { piece, end: End::Finish, from: 1.0 - high, to: 1.0 - low, block: None }
    }
}
