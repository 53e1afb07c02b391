//! The global system (I ± K° R) ρ̃ = g: its nodes, its matrix and its dense LU factor.

use super::corner::{Compressed, Problem, compress};
use super::factor::DenseFactor;
use super::entries::Entries;
use super::layout::Layout;
use super::leg::{Leg, Node, kernel};
use super::legendre::NODES;
use super::panel::PanelNodes;
use super::peak::Peaks;
use crate::geometry::{Curve, DVec2, Junction};
use faer::Mat;

/// A factored system.
#[derive(Debug)]
pub struct System {
    panels: Vec<PanelNodes>,
    /// The places of the junctions.
    bases: Vec<DVec2>,
    /// For each block the first rows of its panels, in the block's order, and its compressed matrix.
    blocks: Vec<(Vec<usize>, Compressed)>,
    factor: DenseFactor,
}

impl System {
    /// Assembles and factors the system.
    pub fn new(curve: &Curve, layout: &Layout, problem: Problem) -> Self {
        let panels: Vec<PanelNodes> = layout.panels.iter().map(|panel| PanelNodes::new(curve, panel)).collect();
        let bases: Vec<DVec2> = curve.pieces().iter().map(|piece| piece.jet(0.0).position).collect();
        let blocks = compressed_blocks(curve, layout, problem);
        let entries = Entries::new(curve, layout, (&panels, &bases), problem);
        let all: Vec<usize> = (0..entries.len()).collect();
        let mut matrix = Mat::zeros(all.len(), all.len());
        entries.for_each(&all, &all, |i, j, value| matrix[(i, j)] = value);
        for (rows, compressed) in &blocks {
            multiply_columns(&mut matrix, rows, &compressed.matrix);
        }
        for k in 0..matrix.nrows() {
            matrix[(k, k)] += 1.0;
        }
        let mut system = Self { panels, bases, blocks, factor: DenseFactor::new(&Mat::new()) };
        if problem == Problem::Exterior {
            system.complete(&mut matrix);
        }
        system.factor = DenseFactor::new(&matrix);
        system
    }

    /// A system that was factored before, with the compressed matrices of its blocks.
    #[cfg(feature = "io")]
    pub fn factored(curve: &Curve, layout: &Layout, blocks: Vec<Compressed>, factor: DenseFactor) -> Self {
        let rows = |block: &super::layout::Block| block.panels.iter().map(|panel| panel * NODES).collect();
        Self {
            panels: layout.panels.iter().map(|panel| PanelNodes::new(curve, panel)).collect(),
            bases: curve.pieces().iter().map(|piece| piece.jet(0.0).position).collect(),
            blocks: layout.blocks.iter().map(rows).zip(blocks).collect(),
            factor,
        }
    }

    /// The factor of the matrix.
    #[cfg(feature = "io")]
    pub fn factor(&self) -> &DenseFactor {
        &self.factor
    }

    /// Adds the total charge, times |z′|/length, to the singular system of the exterior: the solution then has total 1.
    fn complete(&self, matrix: &mut Mat<f64>) {
        let weights: Vec<f64> = self.nodes().map(|(_, node)| node.weight).collect();
        let total: f64 = weights.iter().sum();
        let column: Vec<f64> = self.uniform().collect();
        let mut row = Mat::from_fn(1, weights.len(), |_, j| weights[j] / total);
        for (rows, compressed) in &self.blocks {
            multiply_columns(&mut row, rows, &compressed.matrix);
        }
        for j in 0..weights.len() {
            for i in 0..weights.len() {
                matrix[(i, j)] += column[i] * row[(0, j)];
            }
        }
    }

    /// |dz/dλ| at the nodes: the density of arc length.
    fn uniform(&self) -> impl Iterator<Item = f64> + '_ {
        self.nodes().map(|(_, node)| node.normal.length())
    }

    /// All nodes with the place that their offsets are relative to.
    pub fn nodes(&self) -> impl Iterator<Item = (DVec2, &Node)> + '_ {
        self.panels.iter().flat_map(|panel| panel.nodes.iter().map(|node| (self.bases[panel.junction], node)))
    }

    /// The places of all nodes.
    pub fn places(&self) -> impl Iterator<Item = DVec2> + '_ {
        self.nodes().map(|(base, node)| base + node.offset)
    }

    /// The lengths of the panels.
    pub fn panel_lengths(&self) -> Vec<f64> {
        self.panels.iter().map(PanelNodes::length).collect()
    }

    /// Σ q log|s − a| over the charges.
    pub fn logarithm(&self, charges: &[f64], a: DVec2) -> f64 {
        self.nodes().zip(charges).map(|((base, node), q)| q * ((base - a) + node.offset).length().ln()).sum()
    }

    /// The number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.panels.len() * NODES
    }

    /// The compressed blocks, in the order of the layout.
    pub fn blocks(&self) -> &[(Vec<usize>, Compressed)] {
        &self.blocks
    }

    /// The transformed density ρ̃ of harmonic measure from x; where there are peaks, without what they exceed their
    /// projections by.
    pub fn harmonic(&self, x: DVec2, peaks: &Peaks) -> Vec<f64> {
        let at_node = |(base, node): (DVec2, &Node)| kernel(node.normal, (base - x) + node.offset);
        let mut right: Vec<f64> = self.nodes().map(at_node).collect();
        for (values, peak) in right.chunks_mut(NODES).zip(peaks) {
            if let Some(peak) = peak {
                values.copy_from_slice(&peak.right_side());
            }
        }
        self.solution(right.into_iter())
    }

    /// The transformed density of the equilibrium measure, up to a factor.
    pub fn equilibrium(&self) -> Vec<f64> {
        self.solution(self.uniform())
    }

    fn solution(&self, right: impl Iterator<Item = f64>) -> Vec<f64> {
        let right: Vec<f64> = right.collect();
        self.factor.solve(&right)
    }

    /// The measure of each node, weight times R ρ̃: sums of smooth functions over them are integrals.
    pub fn charges(&self, transformed: &[f64]) -> Vec<f64> {
        let mut charges = transformed.to_vec();
        for (rows, compressed) in &self.blocks {
            let density = &compressed.matrix * gather(rows, transformed);
            for (k, i) in indices(rows).enumerate() {
                charges[i] = density[(k, 0)];
            }
        }
        charges.iter_mut().zip(self.nodes()).for_each(|(charge, (_, node))| *charge *= node.weight);
        charges
    }
}

/// The rows of a block's nodes, given the first row of each of its panels.
fn indices(rows: &[usize]) -> impl Iterator<Item = usize> + '_ {
    rows.iter().flat_map(|&row| row..row + NODES)
}

/// The values at a block's nodes.
pub fn gather(rows: &[usize], values: &[f64]) -> Mat<f64> {
    Mat::from_fn(rows.len() * NODES, 1, |k, _| values[rows[k / NODES] + k % NODES])
}

/// The columns of a block times its matrix.
fn multiply_columns(matrix: &mut Mat<f64>, rows: &[usize], r: &Mat<f64>) {
    let part = Mat::from_fn(matrix.nrows(), rows.len() * NODES, |i, k| matrix[(i, rows[k / NODES] + k % NODES)]);
    let product = &part * r;
    for (k, j) in indices(rows).enumerate() {
        matrix.col_mut(j).copy_from(product.col(k));
    }
}

/// Angles that differ by less have one matrix.
const SAME_ANGLE: f64 = 1e-15;

fn compressed_blocks(curve: &Curve, layout: &Layout, problem: Problem) -> Vec<(Vec<usize>, Compressed)> {
    let mut known: Vec<(f64, usize, Compressed)> = Vec::new();
    let mut compressed = |block: &super::layout::Block| {
        let (legs, junction) = (Leg::both(curve, block.junction), curve.junctions()[block.junction]);
        let straight_angle = match junction {
            Junction::Corner { angle } if legs.iter().all(Leg::is_straight) => Some(angle),
            _ => None,
        };
        let same = |(angle, panels, _): &&(f64, usize, Compressed)| {
            straight_angle.is_some_and(|own| (own - angle).abs() <= SAME_ANGLE * own) && *panels == block.mesh.panels
        };
        if let Some((.., found)) = known.iter().find(same) {
            return found.clone();
        }
        let new = compress(&legs, junction, block.mesh, block.scales, problem);
        if let Some(angle) = straight_angle {
            known.push((angle, block.mesh.panels, new.clone()));
        }
        new
    };
    let rows = |panels: &[usize]| panels.iter().map(|panel| panel * NODES).collect();
    layout.blocks.iter().map(|block| (rows(&block.panels), compressed(block))).collect()
}
