//! What kernel and extension need of a domain, whatever its geometry: the linear system and the boundary's lengths.
//!
//! A planar domain and a surface differ in how a point becomes weights of vertices; after
//! that, both are this.

use super::kernel::KernelScratch;
use super::{HarmonicTable, PreparedDomain};
use crate::geometry::DVec2;
use crate::laplace::{Lanes, NotConverged, RootPaths, Solver, SolverKind};
use sprs::CsMatI;

/// What an iterative solver leaves below 0, relative to the largest coordinate: its tolerance
/// of 1e-12 gives up to 1e-11 in a crowded domain; a stencil that overshoots gives 1e-3.
const PCG_NOISE: f64 = 1e-9;

/// The Dirichlet problem of a prepared domain or surface, borrowed from it.
#[derive(Debug, Clone, Copy)]
pub(super) struct HarmonicSystem<'a> {
    /// The lengths of the boundary edges.
    pub edge_lengths: &'a [f64],
    /// L̄ (n×m, by columns).
    pub coupling: &'a CsMatI<f64, u32>,
    /// Solves with L̂.
    pub solver: &'a Solver,
    /// The root paths of the boundary's neighbours.
    pub boundary_paths: &'a RootPaths,
    /// All harmonic coordinates, where they are stored.
    pub table: Option<&'a HarmonicTable>,
}

impl PreparedDomain {
    pub(super) fn system(&self) -> HarmonicSystem<'_> {
        HarmonicSystem {
            edge_lengths: &self.samples.edge_lengths,
            coupling: &self.coupling,
            solver: &self.solver,
            boundary_paths: &self.boundary_paths,
            table: self.table.as_ref(),
        }
    }
}

impl HarmonicSystem<'_> {
    fn boundary_count(&self) -> u32 {
        self.edge_lengths.len() as u32
    }

    /// The kernel ψ of the point with the weights in `scratch`; where they give a negative value, of the
    /// weights `linear` of its triangle's corners instead.
    pub(super) fn kernel(
        &self,
        linear: [(u32, f64); 3],
        scratch: &mut KernelScratch,
        psi: &mut Vec<f64>,
    ) -> Result<(), NotConverged> {
        self.combine(scratch, psi)?;
        let iterative = self.solver.kind() == SolverKind::Pcg;
        let noise = if iterative { PCG_NOISE * psi.iter().fold(0.0_f64, |max, &value| max.max(value)) } else { 0.0 };
        if psi.iter().any(|&value| value < -noise) {
            scratch.set_stencil(linear);
            self.combine(scratch, psi)?;
        }
        if iterative {
            for value in psi.iter_mut() {
                *value = value.max(0.0);
            }
        }
        let mut previous = self.edge_lengths[self.edge_lengths.len() - 1];
        for (value, &length) in psi.iter_mut().zip(self.edge_lengths) {
            *value /= 0.5 * (previous + length);
            previous = length;
        }
        Ok(())
    }

    /// Σ weight · φ_vertex over the stencil, into `phi`.
    pub(super) fn combine(&self, scratch: &mut KernelScratch, phi: &mut Vec<f64>) -> Result<(), NotConverged> {
        let m = self.boundary_count();
        phi.clear();
        phi.resize(m as usize, 0.0);
        for &(vertex, weight) in scratch.stencil.iter().filter(|(vertex, _)| *vertex < m) {
            phi[vertex as usize] = weight;
        }
        let interior = scratch.stencil.iter().filter_map(|&(vertex, weight)| Some((vertex.checked_sub(m)?, weight)));
        if let Some(table) = self.table {
            for (unknown, weight) in interior {
                for (value, coordinate) in phi.iter_mut().zip(table.row(unknown as usize)) {
                    *value += weight * coordinate;
                }
            }
            return Ok(());
        }
        let solver = self.solver;
        scratch.solution.clear();
        scratch.solution.resize(solver.len(), [0.0]);
        for (unknown, weight) in interior.clone() {
            scratch.solution[solver.position(unknown)] = [weight];
        }
        solver.root_paths(interior.map(|(unknown, _)| unknown), &mut scratch.paths);
        solver.solve(&scratch.paths, self.boundary_paths, &mut scratch.solution)?;
        for (value, column) in phi.iter_mut().zip(self.coupling.outer_iterator()) {
            for (unknown, &entry) in column.iter() {
                *value -= entry * scratch.solution[solver.position(unknown as u32)][0];
            }
        }
        Ok(())
    }

    /// Replaces the interior part of `values` by the harmonic extension of its boundary part, see [`super::harmonic_extension`].
    pub(super) fn extend(&self, values: &mut [DVec2], scratch: &mut Vec<Lanes<2>>) -> Result<(), NotConverged> {
        let (boundary, interior) = values.split_at_mut(self.edge_lengths.len());
        scratch.clear();
        scratch.resize(self.solver.len(), [0.0; 2]);
        for (w, column) in boundary.iter().zip(self.coupling.outer_iterator()) {
            for (unknown, &entry) in column.iter() {
                let right = &mut scratch[self.solver.position(unknown as u32)];
                right[0] -= entry * w.x;
                right[1] -= entry * w.y;
            }
        }
        self.solver.solve(self.boundary_paths, self.solver.everything(), scratch)?;
        for (&[x, y], &unknown) in scratch.iter().zip(self.solver.unknowns()) {
            interior[unknown as usize] = DVec2::new(x, y);
        }
        Ok(())
    }
}
