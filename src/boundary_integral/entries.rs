//! The entries of ± K°, with weights: zero within blocks and within straight lines, integrals that are exact for
//! polynomials where a node lies near a panel, and the kernel times the weight elsewhere.

use super::corner::Problem;
use super::layout::{Layout, Panel};
use super::leg::kernel;
use super::legendre::{NODES, Values};
use super::panel::PanelNodes;
use crate::geometry::{Curve, DVec2};

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
        let close = vec![Vec::new(); panels.len() * NODES];
        let mut entries = Self { layout, panels, bases, is_straight, sign: problem.sign(), close };
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

    /// Whether all entries from panel `b` to panel `a` are 0.
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
                if !self.is_zero(a, b) {
                    let pair = self.pair(a, b);
                    for (k, &i) in rows.iter().enumerate() {
                        let close = self.close[i].binary_search_by_key(&(b as u32), |(panel, _)| *panel);
                        let close = close.ok().map(|k| &self.close[i][k].1);
                        for (l, &j) in columns.iter().enumerate() {
                            let plain = || pair.kernel(i % NODES, j % NODES) * pair.source.nodes[j % NODES].weight;
                            let value = close.map_or_else(plain, |weights| weights[j % NODES]);
                            write(first_row + k, first_column + l, self.sign * value);
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
