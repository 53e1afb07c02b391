//! The entries of ± K°, with weights: zero within blocks and within straight lines, integrals that are exact for
//! polynomials where a node lies near a panel, and the kernel times the weight elsewhere.
//!
//! The singular system of the exterior is completed by the total charge, times |z′|/length: its solution has total 1.

use super::corner::Problem;
use super::layout::{Layout, Panel};
use super::leg::kernel;
use super::legendre::{NODES, Values};
use super::panel::PanelNodes;
use crate::geometry::{Curve, DVec2};
use std::ops::Range;

/// K° between the nodes of a layout.
#[derive(Debug)]
pub struct Entries<'a> {
    layout: &'a Layout,
    panels: &'a [PanelNodes],
    /// The places of the junctions.
    bases: &'a [DVec2],
    is_straight: Vec<bool>,
    sign: f64,
    /// For each node the panels near it, in ascending order, and the weights of each.
    close: Vec<Vec<(u32, Values)>>,
    /// For each panel the nodes near it.
    close_nodes: Vec<Vec<u32>>,
    /// The factor of the total charge: 1/length for the exterior, else 0.
    completion: f64,
}

impl<'a> Entries<'a> {
    /// Integrates over the panels that are near to nodes.
    pub fn new(
        curve: &Curve,
        layout: &'a Layout,
        (panels, bases): (&'a [PanelNodes], &'a [DVec2]),
        problem: Problem,
    ) -> Self {
        let is_straight = curve.pieces().iter().map(crate::geometry::Piece::is_straight).collect();
        let weights = panels.iter().flat_map(|panel| panel.nodes.iter().map(|node| node.weight));
        let mut entries = Self {
            layout,
            panels,
            bases,
            is_straight,
            sign: problem.sign(),
            close: vec![Vec::new(); panels.len() * NODES],
            close_nodes: vec![Vec::new(); panels.len()],
            completion: if problem == Problem::Exterior { weights.sum::<f64>().recip() } else { 0.0 },
        };
        entries.integrate_close();
        entries
    }

    fn integrate_close(&mut self) {
        let places: Vec<DVec2> = self.panels.iter().map(|panel| self.bases[panel.junction] + panel.middle).collect();
        let reaches: Vec<f64> = self.panels.iter().map(PanelNodes::reach).collect();
        for a in 0..self.panels.len() {
            for b in 0..self.panels.len() {
                let is_apart = places[a].distance(places[b]) > reaches[a] + self.panels[b].slope.reach();
                if is_apart || self.is_zero(a, b) || self.pair(a, b).is_smooth() {
                    continue;
                }
                let (pair, source) = (self.pair(a, b), &self.panels[b]);
                for (i, y) in self.panels[a].nodes.iter().enumerate() {
                    if !source.slope.may_be_near((places[a] - places[b]) + (y.offset - self.panels[a].middle)) {
                        continue;
                    }
                    let differences = std::array::from_fn(|j| pair.difference(i, j));
                    if let Some(weights) = source.slope.close_weights(y.normal, &differences, source.rate) {
                        self.close[a * NODES + i].push((b as u32, weights));
                        self.close_nodes[b].push((a * NODES + i) as u32);
                    }
                }
            }
        }
    }

    /// The number of nodes.
    pub fn len(&self) -> usize {
        self.close.len()
    }

    /// The panels that are near to a node, in ascending order.
    pub fn close_panels(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        self.close[node].iter().map(|(panel, _)| *panel as usize)
    }

    /// The nodes that are near to a panel.
    pub fn close_nodes(&self, panel: usize) -> &[u32] {
        &self.close_nodes[panel]
    }

    /// The weight of a node.
    pub fn weight(&self, node: usize) -> f64 {
        self.panels[node / NODES].nodes[node % NODES].weight
    }

    /// The place of a node.
    pub fn place(&self, node: usize) -> DVec2 {
        let panel = &self.panels[node / NODES];
        self.bases[panel.junction] + panel.nodes[node % NODES].offset
    }

    /// The outward normal at a node, times |dz/dλ|.
    pub fn normal(&self, node: usize) -> DVec2 {
        self.panels[node / NODES].nodes[node % NODES].normal
    }

    /// The factor of the total charge in a node's equation.
    pub fn completion(&self, node: usize) -> f64 {
        if self.completion > 0.0 { self.completion * self.normal(node).length() } else { 0.0 }
    }

    /// The panels of each block, and the other ones alone, in the order of the curve; panels after the last one count on
    /// from the first. The first block may begin before the first panel.
    pub fn atoms(&self) -> Vec<Range<usize>> {
        let count = self.panels.len();
        let block = |panel: usize| self.layout.panels[panel % count].block;
        let is_joined = |a: usize, b: usize| block(a).is_some() && block(a) == block(b);
        let start = (0..count).rev().take_while(|&panel| is_joined(panel, 0)).last().unwrap_or(0);
        let mut atoms: Vec<Range<usize>> = Vec::new();
        for panel in start..start + count {
            match atoms.last_mut() {
                Some(last) if is_joined(last.start, panel) => last.end = panel + 1,
                _ => atoms.push(panel..panel + 1),
            }
        }
        atoms
    }

    /// The block that a node belongs to.
    pub fn block(&self, node: usize) -> Option<usize> {
        self.layout.panels[node / NODES].block
    }

    /// Whether K from panel `b` to panel `a` is 0.
    fn is_zero(&self, a: usize, b: usize) -> bool {
        let (p, q): (&Panel, &Panel) = (&self.layout.panels[a], &self.layout.panels[b]);
        let in_one_line = p.piece == q.piece && self.is_straight[p.piece];
        in_one_line || (p.block.is_some() && p.block == q.block)
    }

    fn pair(&self, a: usize, b: usize) -> Pair<'a> {
        let [target, source] = [&self.panels[a], &self.panels[b]];
        Pair {
            target,
            source,
            difference: self.bases[target.junction] - self.bases[source.junction],
            is_same: a == b,
            // the target's offsets from its first point and the source's from its last one, or the other way round
            shared: if self.panels.len() < 3 { None } else { shared_end(a, b, self.panels.len()) },
        }
    }

    /// Calls `write` with the row and the column in `rows` and `columns`, and the entry, for all that are not 0. Indices
    /// of one panel should follow one another.
    pub fn for_each(&self, rows: &[usize], columns: &[usize], mut write: impl FnMut(usize, usize, f64)) {
        let panel = |node: &usize, other: &usize| node / NODES == other / NODES;
        let mut first_row = 0;
        for rows in rows.chunk_by(panel) {
            let mut first_column = 0;
            for columns in columns.chunk_by(panel) {
                let (a, b) = (rows[0] / NODES, columns[0] / NODES);
                let is_zero = self.is_zero(a, b);
                if !is_zero || self.completion > 0.0 {
                    let pair = self.pair(a, b);
                    for (k, &i) in rows.iter().enumerate() {
                        let close = self.close[i].binary_search_by_key(&(b as u32), |(panel, _)| *panel);
                        let close = close.ok().map(|k| &self.close[i][k].1);
                        let completion = self.completion(i);
                        for (l, &j) in columns.iter().enumerate() {
                            let weight = pair.source.nodes[j % NODES].weight;
                            let value = match close {
                                _ if is_zero => 0.0,
                                Some(weights) => weights[j % NODES],
                                None => pair.kernel(i % NODES, j % NODES) * weight,
                            };
                            write(first_row + k, first_column + l, self.sign * value + completion * weight);
                        }
                    }
                }
                first_column += columns.len();
            }
            first_row += rows.len();
        }
    }
}

/// Which end of the target panel is an end of the source panel, if they are neighbours: 0 the first, 1 the last.
fn shared_end(target: usize, source: usize, count: usize) -> Option<usize> {
    if (source + 1) % count == target {
        Some(0)
    } else if (target + 1) % count == source {
        Some(1)
    } else {
        None
    }
}

/// Two panels, and how differences of their nodes are formed.
struct Pair<'a> {
    target: &'a PanelNodes,
    source: &'a PanelNodes,
    difference: DVec2,
    is_same: bool,
    shared: Option<usize>,
}

impl Pair<'_> {
    /// Whether the kernel is smooth from one to the other: neighbors are divided by no corner, since those lie in blocks.
    fn is_smooth(&self) -> bool {
        self.is_same || self.shared.is_some()
    }

    fn difference(&self, i: usize, j: usize) -> DVec2 {
        match self.shared {
            _ if self.is_same => self.target.ends[0][i] - self.source.ends[0][j],
            Some(end) => self.target.ends[end][i] - self.source.ends[1 - end][j],
            None => self.difference + (self.target.nodes[i].offset - self.source.nodes[j].offset),
        }
    }

    fn kernel(&self, i: usize, j: usize) -> f64 {
        let y = &self.target.nodes[i];
        if self.is_same && i == j { y.diagonal } else { kernel(y.normal, self.difference(i, j)) }
    }
}
