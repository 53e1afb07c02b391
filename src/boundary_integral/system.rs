//! The global system (I ± K° R) ρ̃ = g: its nodes, its blocks and its factor.

use super::corner::{Compressed, PlacedBlock, Problem, compress};
use super::entries::Entries;
use super::error::BoundaryIntegralError;
use super::factor::Factor;
use super::layout::{Block, Layout};
use super::leg::{Leg, Node, kernel};
use super::legendre::NODES;
use super::panel::PanelNodes;
use super::peak::Peaks;
use crate::geometry::{Curve, DVec2, Junction};
use std::sync::Arc;

/// A factored system.
#[derive(Debug)]
pub struct System {
    panels: Vec<PanelNodes>,
    /// The places of the junctions.
    bases: Vec<DVec2>,
    blocks: Vec<PlacedBlock>,
    factor: Factor,
}

impl System {
    /// Assembles and factors the system. Fails where a corner is not resolved, or the factor is too large.
    pub fn new(curve: &Curve, layout: &Layout, problem: Problem) -> Result<Self, BoundaryIntegralError> {
        let panels: Vec<PanelNodes> = layout.panels.iter().map(|panel| PanelNodes::new(curve, panel)).collect();
        let bases: Vec<DVec2> = curve.pieces().iter().map(|piece| piece.jet(0.0).position).collect();
        let blocks = compressed_blocks(curve, layout, problem)?;
        let entries = Entries::new(curve, layout, (&panels, &bases), problem);
        let factor = Factor::new(&entries, &blocks, MAX_FACTOR_MB)?;
        Ok(Self { panels, bases, blocks, factor })
    }

    /// A system that was factored before, with the compressed matrices of its blocks.
    #[cfg(feature = "io")]
    pub fn factored(curve: &Curve, layout: &Layout, blocks: Vec<Arc<Compressed>>, factor: Factor) -> Self {
        let place = |(block, compressed): (&Block, _)| PlacedBlock { rows: rows(block), compressed };
        Self {
            panels: layout.panels.iter().map(|panel| PanelNodes::new(curve, panel)).collect(),
            bases: curve.pieces().iter().map(|piece| piece.jet(0.0).position).collect(),
            blocks: layout.blocks.iter().zip(blocks).map(place).collect(),
            factor,
        }
    }

    /// The factor of the matrix.
    #[cfg(feature = "io")]
    pub fn factor(&self) -> &Factor {
        &self.factor
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
    pub fn blocks(&self) -> &[PlacedBlock] {
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
        for block in &self.blocks {
            let density = &block.compressed.matrix * block.gather(transformed);
            block.nodes().zip(density.col_as_slice(0)).for_each(|(node, value)| charges[node] = *value);
        }
        charges.iter_mut().zip(self.nodes()).for_each(|(charge, (_, node))| *charge *= node.weight);
        charges
    }
}

/// The first node of each panel of a block.
fn rows(block: &Block) -> Vec<usize> {
    block.panels.iter().map(|panel| panel * NODES).collect()
}

/// The largest factor, in megabytes. One of 400,000 unknowns of a coast takes about 3,500.
const MAX_FACTOR_MB: usize = if cfg!(target_family = "wasm") { 500 } else { 4000 };

/// Angles that differ by less have one matrix.
const SAME_ANGLE: f64 = 1e-15;

fn compressed_blocks(
    curve: &Curve,
    layout: &Layout,
    problem: Problem,
) -> Result<Vec<PlacedBlock>, BoundaryIntegralError> {
    let mut known: Vec<(f64, usize, Arc<Compressed>)> = Vec::new();
    let mut compressed = |block: &Block| {
        let (legs, junction) = (Leg::both(curve, block.junction), curve.junctions()[block.junction]);
        let straight_angle = match junction {
            Junction::Corner { angle } if legs.iter().all(Leg::is_straight) => Some(angle),
            _ => None,
        };
        let same = |(angle, panels, _): &&(f64, usize, Arc<Compressed>)| {
            straight_angle.is_some_and(|own| (own - angle).abs() <= SAME_ANGLE * own) && *panels == block.mesh.panels
        };
        if let Some((.., found)) = known.iter().find(same) {
            return Ok(Arc::clone(found));
        }
        let at = curve.pieces()[block.junction].jet(0.0).position;
        let new = compress(&legs, junction, block.mesh, block.scales, problem);
        let new = Arc::new(new.ok_or(BoundaryIntegralError::CornerNotResolved { at })?);
        if let Some(angle) = straight_angle {
            known.push((angle, block.mesh.panels, Arc::clone(&new)));
        }
        Ok(new)
    };
    let placed = |block: &Block| Ok(PlacedBlock { rows: rows(block), compressed: compressed(block)? });
    layout.blocks.iter().map(placed).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::super::hierarchical::{HierarchicalFactor, Refusal};
    use super::super::layout::{Fineness, layout};
    use super::*;
    use crate::geometry::SimplePolygon;
    use crate::outline::Preset;
    use std::f64::consts::TAU;

    /// What `read` finds of a curve's system, with its dense factor, and its entries.
    fn of_system<T>(curve: &Curve, problem: Problem, read: impl FnOnce(&System, &Entries<'_>) -> T) -> T {
        let layout = layout(curve, &[], (Fineness::STANDARD, problem), 4000).unwrap();
        let system = System::new(curve, &layout, problem).unwrap();
        assert!(matches!(system.factor, Factor::Dense(_)), "{} unknowns", system.unknowns());
        let entries = Entries::new(curve, &layout, (&system.panels, &system.bases), problem);
        read(&system, &entries)
    }

    fn check(name: &str, curve: &Curve, problem: Problem) {
        of_system(curve, problem, |system, entries| {
            for gathered in [HierarchicalFactor::along, HierarchicalFactor::by_place] {
                let hierarchical = gathered(entries, &system.blocks, 100).unwrap();
                solve_alike(name, (system, problem), &hierarchical);
            }
        });
    }

    fn solve_alike(name: &str, (system, problem): (&System, Problem), hierarchical: &HierarchicalFactor) {
        let places: Vec<DVec2> = system.places().collect();
        let right: Vec<f64> = system.uniform().zip(&places).map(|(length, p)| length * (1.0 + p.x * p.y)).collect();
        let [dense, found] = [system.factor.solve(&right), hierarchical.solve(&right)].map(|x| system.charges(&x));
        let size = dense.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let off = dense.iter().zip(&found).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(off < 1e-10 * size, "{name}, {problem:?}: off by {off:e} of {size:e}");
    }

    #[test]
    fn the_hierarchical_factor_solves_what_the_dense_one_solves() {
        for preset in [Preset::Star, Preset::Heart, Preset::VShape] {
            let outline = preset.outline();
            let curve = outline.curve().unwrap();
            check(preset.name(), curve.curve(), Problem::Interior);
            check(preset.name(), curve.curve(), Problem::Exterior);
        }
    }

    /// A wall of it alone nearly surrounds the middle.
    #[test]
    fn a_ring_with_a_gap_is_solved_by_both() {
        let at = |r: f64, k: f64| DVec2::from_angle(TAU * (0.01 + 0.98 * k / 8.0)) * r;
        let outer = (0..=8).map(|k| at(1.0, f64::from(k)));
        let inner = (0..=8).rev().map(|k| at(0.8, f64::from(k)));
        let curve =
            Curve::from_polygon(&SimplePolygon::try_from(outer.chain(inner).collect::<Vec<_>>()).unwrap()).unwrap();
        check("ring", &curve, Problem::Interior);
    }

    #[test]
    fn clusters_along_a_spiral_are_refused() {
        let curve = Preset::Spiral.curve().unwrap();
        of_system(&curve, Problem::Interior, |system, entries| {
            assert_eq!(HierarchicalFactor::along(entries, &system.blocks, 100).err(), Some(Refusal::Unsuited));
        });
    }

    #[test]
    fn a_factor_that_is_too_large_is_refused() {
        let curve = Preset::Star.curve().unwrap();
        of_system(&curve, Problem::Interior, |system, entries| {
            assert_eq!(HierarchicalFactor::along(entries, &system.blocks, 1).err(), Some(Refusal::TooLarge));
            assert!(HierarchicalFactor::along(entries, &system.blocks, 30).is_ok());
        });
    }

    #[cfg(feature = "io")]
    #[test]
    fn a_hierarchical_factor_from_its_arrays_solves_alike_and_other_arrays_are_refused() {
        let (hierarchical, right) = of_system(&Preset::Star.curve().unwrap(), Problem::Interior, |system, entries| {
            let factor = HierarchicalFactor::along(entries, &system.blocks, 100).unwrap();
            (factor, system.uniform().collect::<Vec<f64>>())
        });
        let again = Factor::from_flat(hierarchical.to_flat()).unwrap();
        assert!(again.solve(&right) == hierarchical.solve(&right));
        let refused = |change: &dyn Fn(&mut super::super::factor::FlatFactor)| {
            let mut flat = hierarchical.to_flat();
            change(&mut flat);
            assert!(Factor::from_flat(flat).is_none());
        };
        refused(&|flat| flat.integers[0] += 1);
        refused(&|flat| flat.integers[1] = u32::MAX);
        refused(&|flat| flat.integers[2] = flat.integers[3]);
        refused(&|flat| *flat.integers.last_mut().unwrap() = u32::MAX);
        refused(&|flat| flat.floats[0].truncate(7));
        refused(&|flat| flat.floats[1][0] = f64::NAN);
    }
}
