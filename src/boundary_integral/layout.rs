//! Where the panels lie: compressed blocks at the junctions, and panels between them that are split until the curve is
//! resolved, and until each is short against its distance from all parts of the boundary that are not its neighbours.

use super::BoundaryIntegralError;
use super::corner::BlockMesh;
use super::leg::Leg;
use super::legendre::{NODES, Rule, last_two};
use crate::geometry::{Curve, DVec2, Junction};
use std::f64::consts::TAU;

/// How finely the boundary is divided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// The largest length of a panel in distances to other parts of the boundary. With 1.5 and 2 the presets' ω is off
    /// by 1e-14, with 2.5 that of the ends of the 10×1 rectangle by 1e-10 of itself.
    pub proximity: f64,
    /// The largest length of a panel in distances to the given interior points.
    pub nearness: f64,
    /// The largest share of the last two Legendre coefficients of z′.
    pub tail: f64,
    /// The length of a block's panels, in shares of the most that fits.
    pub block: f64,
    /// Whether blocks have twice the panels where that makes a difference.
    pub blocks_are_fine: bool,
}

impl Fineness {
    /// Errors of ω of 1e-13 on polygons and of 1e-11 on smooth curves.
    pub const STANDARD: Self = Self { proximity: 2.0, nearness: 0.8, tail: 1e-10, block: 1.0, blocks_are_fine: false };
    /// To compare with: about twice the unknowns.
    pub const FINE: Self = Self { proximity: 1.4, nearness: 0.5, tail: 1e-12, block: 0.6, blocks_are_fine: true };
}

/// The end of a piece from which a panel is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum End {
    /// By t.
    Start,
    /// By 1 − t.
    Finish,
}

/// A panel: the parameters from `from` to `to` of a piece, measured from one of its ends.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Panel {
    pub piece: usize,
    pub end: End,
    pub from: f64,
    pub to: f64,
    /// The block that the panel belongs to.
    pub block: Option<usize>,
}

/// A compressed block at a junction.
#[derive(Debug, Clone, serde::Serialize, serde::Deserialize)]
pub struct Block {
    pub junction: usize,
    pub mesh: BlockMesh,
    /// Parameters per panel of each leg.
    pub scales: [f64; 2],
    /// The panels of the first leg, from the junction outwards, then those of the second.
    pub panels: Vec<usize>,
}

/// The panels in the order of the curve, and the blocks among them.
#[derive(Debug, Clone, Default, serde::Serialize, serde::Deserialize)]
pub struct Layout {
    pub panels: Vec<Panel>,
    pub blocks: Vec<Block>,
}

/// Legs that are less than `BLUNT` apart, inside or outside, have two panels on each leg of a block, and less than `NARROW` four: the panel beyond
/// the block must be distant from the other leg. With one panel a corner of 90° leaves errors of 1e-14, one of 60° of
/// 3e-13; with two panels both leave 1e-15.
const BLUNT: f64 = 1.3;
const NARROW: f64 = 0.3;
/// Below it, two panels instead of four leave errors of 1e-14 and more, and the finer mesh has four.
const ACUTE: f64 = 0.7;
/// Rounds of splitting; each halves what is too long.
const MOST_ROUNDS: usize = 60;
/// Two blocks that leave less of a piece between them meet.
const NOTHING_BETWEEN: f64 = 1e-9;
/// The panels of a piece between analytic junctions to start with, so that a closed piece is no neighbour of itself.
const FIRST_PANELS: u32 = 8;

/// The panels of a block on each leg.
fn block_mesh(junction: Junction, is_fine: bool) -> BlockMesh {
    let finer = if is_fine { 2 } else { 1 };
    let panels = match junction {
        Junction::Corner { angle } => match angle.min(TAU - angle) {
            between if between < NARROW => 4,
            between if between < ACUTE => 2 * finer,
            between if between < BLUNT => 2,
            _ => finer,
        },
        _ => 1,
    };
    BlockMesh { panels }
}

/// What is laid out so far: the sizes of the blocks and the intervals between them.
struct Draft<'a> {
    curve: &'a Curve,
    near: &'a [DVec2],
    fineness: Fineness,
    meshes: Vec<Option<BlockMesh>>,
    /// The length of the panels of each junction's block.
    sizes: Vec<f64>,
    /// The intervals of t of each piece outside of blocks.
    between: Vec<Vec<[f64; 2]>>,
}

/// Lays out the panels of a curve. Fails if they have more than `limit` nodes.
pub fn layout(
    curve: &Curve,
    near: &[DVec2],
    fineness: Fineness,
    limit: usize,
) -> Result<Layout, BoundaryIntegralError> {
    let least = curve.pieces().len() * NODES;
    if least > limit {
        return Err(BoundaryIntegralError::TooManyUnknowns { needed: least, limit });
    }
    let mut draft = Draft::new(curve, near, fineness);
    for _ in 0..MOST_ROUNDS {
        let layout = draft.panels();
        let needed = layout.panels.len() * NODES;
        if needed > limit {
            return Err(BoundaryIntegralError::TooManyUnknowns { needed, limit });
        }
        if !draft.split(&layout) {
            return Ok(layout);
        }
    }
    Err(BoundaryIntegralError::NotResolved)
}

impl<'a> Draft<'a> {
    fn new(curve: &'a Curve, near: &'a [DVec2], fineness: Fineness) -> Self {
        let count = curve.pieces().len();
        let mesh = |junction: &Junction| {
            (*junction != Junction::Analytic).then(|| block_mesh(*junction, fineness.blocks_are_fine))
        };
        let meshes: Vec<Option<BlockMesh>> = curve.junctions().iter().map(mesh).collect();
        let size = |k: usize| {
            let Some(mesh) = meshes[k] else { return 0.0 };
            // at most half of either leg
            let reach = |leg: &Leg| 0.5 * leg.length * leg.speed.min(1.0);
            let [a, b] = Leg::both(curve, k);
            fineness.block * reach(&a).min(reach(&b)) / mesh.panels as f64
        };
        let sizes = (0..count).map(size).collect();
        let mut draft = Self { curve, near, fineness, meshes, sizes, between: Vec::new() };
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
    fn panels(&self) -> Layout {
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

    /// Splits every panel that is too long; whether there was one.
    fn split(&mut self, layout: &Layout) -> bool {
        let mut shapes: Vec<Shape> = layout.panels.iter().map(|panel| Shape::of(self.curve, panel)).collect();
        let mut along = 0.0;
        for shape in &mut shapes {
            shape.along = along;
            along += shape.length;
        }
        let too_long: Vec<bool> = (0..shapes.len()).map(|k| self.is_too_long(layout, &shapes, k)).collect();
        let mut halved = vec![false; layout.blocks.len()];
        for (panel, _) in layout.panels.iter().zip(&too_long).filter(|(_, long)| **long) {
            if let Some(block) = panel.block {
                halved[block] = true;
            }
        }
        self.bisect(layout, &too_long);
        for (block, _) in layout.blocks.iter().zip(halved).filter(|(_, halved)| *halved) {
            self.halve(block.junction);
        }
        too_long.contains(&true)
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

    fn is_too_long(&self, layout: &Layout, shapes: &[Shape], k: usize) -> bool {
        let (panel, shape) = (&layout.panels[k], &shapes[k]);
        let is_near = |x: &DVec2| shape.length > self.fineness.nearness * shape.distance_to(*x);
        if shape.tail > self.fineness.tail || self.near.iter().any(is_near) {
            return true;
        }
        let count = shapes.len();
        (0..count).any(|other| {
            let apart = (k + count - other) % count;
            let is_neighbour = apart <= 1 || apart == count - 1;
            !is_neighbour
                && shape.length > self.fineness.proximity * shape.gap(&shapes[other])
                && !self.belongs_together(layout, panel, &layout.panels[other])
                && self.is_close(layout, shapes, k, other)
        })
    }

    /// Whether a panel is too long against its distance from another one. On one analytic curve distances count only
    /// where they are clearly less than the length of the curve between: elsewhere the kernel is smooth. Across a
    /// common tangent it is bounded, and the density's singularity weak: panels may grow faster away from there.
    fn is_close(&self, layout: &Layout, shapes: &[Shape], k: usize, other: usize) -> bool {
        let distance = shapes[k].distance(&shapes[other]);
        if shapes[k].length <= self.fineness.proximity * distance {
            return false;
        }
        let (first, last) = (k.min(other), k.max(other));
        let inner = shapes[last].along - (shapes[first].along + shapes[first].length);
        let end = shapes.last().map_or(0.0, |shape| shape.along + shape.length);
        let outer = end - (shapes[last].along + shapes[last].length) + shapes[first].along;
        let [p, q] = [first, last].map(|panel| layout.panels[panel].piece);
        let is_free = |junctions: &mut dyn Iterator<Item = usize>| {
            let growth = junctions.map(|junction| match self.curve.junctions()[junction] {
                Junction::Analytic => f64::INFINITY,
                Junction::Smooth => GROWTH * self.fineness.proximity,
                Junction::Corner { .. } => 0.0,
            });
            shapes[k].length <= growth.fold(f64::INFINITY, f64::min) * distance
        };
        let is_direct = |between: f64| distance >= LEAST_CHORD * between;
        let within = is_direct(inner) && is_free(&mut (p + 1..=q));
        let around = is_direct(outer) && is_free(&mut (q + 1..self.sizes.len()).chain(0..=p));
        !(within || around)
    }

    /// Whether two panels need no distance: in one straight line, in one block, or a block and what is next to it.
    fn belongs_together(&self, layout: &Layout, panel: &Panel, other: &Panel) -> bool {
        let in_one_line = panel.piece == other.piece && self.curve.pieces()[panel.piece].is_straight();
        let in_one_block = panel.block.is_some() && panel.block == other.block;
        in_one_line || in_one_block || panel.block.is_some_and(|block| self.is_beside(&layout.blocks[block], other))
    }

    /// Whether a panel begins on a leg of a block within twice the block's reach.
    fn is_beside(&self, block: &Block, panel: &Panel) -> bool {
        let count = self.sizes.len();
        let before = (block.junction + count - 1) % count;
        let from = |end: End| if panel.end == end { panel.from } else { 1.0 - panel.to };
        (panel.piece == before && from(End::Finish) < 2.0 * self.reach(before, End::Finish))
            || (panel.piece == block.junction && from(End::Start) < 2.0 * self.reach(block.junction, End::Start))
    }
}

/// How much faster panels may grow from a common tangent than from a corner.
const GROWTH: f64 = 2.0;
/// A chord of at least this share of its arc belongs to one smooth stretch of the curve; of a half circle it is 0.64.
const LEAST_CHORD: f64 = 0.6;

/// The panel on an interval of t, measured from the nearer end of the piece.
fn panel_between(piece: usize, [low, high]: [f64; 2]) -> Panel {
    if low + high <= 1.0 {
        Panel { piece, end: End::Start, from: low, to: high, block: None }
    } else {
        Panel { piece, end: End::Finish, from: 1.0 - high, to: 1.0 - low, block: None }
    }
}

/// The number of points of a panel that distances are taken from.
const POINTS: usize = 7;

/// The shape of a panel.
struct Shape {
    points: [DVec2; POINTS],
    center: DVec2,
    radius: f64,
    length: f64,
    tail: f64,
    /// The length of the curve up to the panel.
    along: f64,
}

impl Shape {
    fn of(curve: &Curve, panel: &Panel) -> Self {
        let piece = &curve.pieces()[panel.piece];
        let at = |t: f64| if panel.end == End::Start { t } else { 1.0 - t };
        let step = (panel.to - panel.from) / (POINTS - 1) as f64;
        let points: [DVec2; POINTS] = std::array::from_fn(|k| piece.jet(at(panel.from + step * k as f64)).position);
        let center = points[POINTS / 2];
        let radius = points.iter().map(|p| p.distance(center)).fold(0.0, f64::max);
        let chords: f64 = points.windows(2).map(|pair| pair[0].distance(pair[1])).sum();
        // the cubic correction of inscribed chords is below 1 % here
        let tail = if piece.is_straight() { 0.0 } else { tail_of_slope(curve, panel) };
        Self { points, center, radius, length: chords, tail, along: 0.0 }
    }

    /// A lower bound of the distance.
    fn gap(&self, other: &Self) -> f64 {
        self.center.distance(other.center) - self.radius - other.radius
    }

    fn distance(&self, other: &Self) -> f64 {
        other.points.iter().map(|&x| self.distance_to(x)).fold(f64::INFINITY, f64::min)
    }

    fn distance_to(&self, x: DVec2) -> f64 {
        self.points.iter().map(|p| p.distance(x)).fold(f64::INFINITY, f64::min)
    }
}

/// How far the tangent's last coefficients may be above those of z′. The tangent must be resolved as well: on the blob,
/// whose formula is slow where it bends, panels that resolve only z′ leave errors of 2e-4.
const TANGENT: f64 = 1e-3;

/// The share of the last Legendre coefficients in z′, and `TANGENT` times that in z′/|z′|.
fn tail_of_slope(curve: &Curve, panel: &Panel) -> f64 {
    let rule = Rule::get();
    let leg = Leg::new(curve, panel.piece, panel.end == End::Finish);
    let slopes = rule.nodes.map(|x| leg.outward(panel.from + 0.5 * (panel.to - panel.from) * (1.0 + x)));
    let tangents = slopes.map(DVec2::normalize_or_zero);
    share_of_tail(&slopes).max(TANGENT * share_of_tail(&tangents))
}

/// The larger of both coordinates' last coefficients, in shares of the largest vector.
fn share_of_tail(vectors: &[DVec2; NODES]) -> f64 {
    let rule = Rule::get();
    let largest = vectors.iter().map(|d| d.length()).fold(0.0, f64::max);
    let last = |coordinate: usize| last_two(&rule.coefficients(&std::array::from_fn(|k| vectors[k][coordinate])));
    last(0).max(last(1)) / largest
}
