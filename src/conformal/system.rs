//! The linear system of a side, independent of its geometry: kernel and extension.
//!
//! A planar domain and a surface differ in how a point becomes weights of vertices; what follows
//! is the same for both. Kernel and extension are begun, then advanced in pieces, each until a
//! deadline; the results are written at the end, all at once.

use super::kernel::KernelScratch;
use super::{ExtensionScratch, HarmonicTable, PreparedSide};
use crate::geometry::DVec2;
use crate::laplace::{Deadline, NotConverged, RootPaths, Solver, SolverKind};
use sprs::CsMatI;

/// The negative values that an iterative solver leaves, relative to the largest coordinate: its tolerance
/// of 1e-12 gives up to 1e-11 in a crowded domain; a stencil with negative results gives 1e-3.
const PCG_NOISE: f64 = 1e-9;

/// The Dirichlet problem of a side.
#[derive(Debug, Clone)]
pub(super) struct DirichletSystem {
    /// L̄ (n×m, by columns).
    pub coupling: CsMatI<f64, u32>,
    /// The solver for L̂.
    pub solver: Solver,
    /// The root paths of the boundary's neighbours.
    pub boundary_paths: RootPaths,
    /// All harmonic coordinates, if they are stored.
    pub table: Option<HarmonicTable>,
}

impl DirichletSystem {
    /// Combines the parts and computes the root paths of the boundary from them.
    pub fn new(coupling: CsMatI<f64, u32>, solver: Solver, table: Option<HarmonicTable>) -> Self {
        let mut boundary_paths = RootPaths::default();
        solver.root_paths(coupling.indices().iter().copied(), &mut boundary_paths);
        Self { coupling, solver, boundary_paths, table }
    }
}

impl PreparedSide {
    /// Starts computing the kernel ψ of the point whose weights are in `scratch`.
    pub(super) fn begin_kernel_of_stencil(&self, scratch: &mut KernelScratch) {
        scratch.is_linear = false;
        self.begin_combination(scratch);
    }

    /// Continues until the kernel is in `psi` (true) or `deadline` has passed. If the weights give a
    /// negative value, the kernel is computed from the weights `linear` of the point's triangle instead.
    pub(super) fn advance_kernel_of_stencil(
        &self,
        linear: [(u32, f64); 3],
        scratch: &mut KernelScratch,
        psi: &mut Vec<f64>,
        deadline: Deadline,
    ) -> Result<bool, NotConverged> {
        let iterative = self.solver_kind() == SolverKind::Pcg;
        loop {
            if !self.advance_combination(scratch, psi, deadline)? {
                return Ok(false);
            }
            let largest = || psi.iter().fold(0.0_f64, |max, &value| max.max(value));
            let noise = if iterative { PCG_NOISE * largest() } else { 0.0 };
            if scratch.is_linear || psi.iter().all(|&value| value >= -noise) {
                break;
            }
            scratch.set_stencil(linear);
            scratch.is_linear = true;
            self.begin_combination(scratch);
        }
        if iterative {
            for value in psi.iter_mut() {
                *value = value.max(0.0);
            }
        }
        let mut previous = self.edge_lengths()[self.boundary_count() - 1];
        for (value, &length) in psi.iter_mut().zip(self.edge_lengths()) {
            *value /= 0.5 * (previous + length);
            previous = length;
        }
        Ok(true)
    }

    /// Starts computing Σ weight · φ_vertex over the stencil.
    pub(super) fn begin_combination(&self, scratch: &mut KernelScratch) {
        scratch.run.restart();
        if self.system.table.is_some() {
            return;
        }
        let (solver, m) = (&self.system.solver, self.boundary_count() as u32);
        scratch.solution.clear();
        scratch.solution.resize(solver.len(), [0.0]);
        let interior = scratch.stencil.iter().filter_map(|&(vertex, weight)| Some((vertex.checked_sub(m)?, weight)));
        for (unknown, weight) in interior.clone() {
            scratch.solution[solver.position(unknown)] = [weight];
        }
        solver.root_paths(interior.map(|(unknown, _)| unknown), &mut scratch.paths);
    }

    /// Continues until the sum is in `phi` (true) or `deadline` has passed. With a table, one call completes it.
    pub(super) fn advance_combination(
        &self,
        scratch: &mut KernelScratch,
        phi: &mut Vec<f64>,
        deadline: Deadline,
    ) -> Result<bool, NotConverged> {
        let (solver, m) = (&self.system.solver, self.boundary_count() as u32);
        if self.system.table.is_none() {
            let KernelScratch { run, paths, solution, .. } = &mut *scratch;
            if !solver.advance(run, paths, &self.system.boundary_paths, solution, deadline)? {
                return Ok(false);
            }
        }
        phi.clear();
        phi.resize(m as usize, 0.0);
        for &(vertex, weight) in scratch.stencil.iter().filter(|(vertex, _)| *vertex < m) {
            phi[vertex as usize] = weight;
        }
        let interior = scratch.stencil.iter().filter_map(|&(vertex, weight)| Some((vertex.checked_sub(m)?, weight)));
        if let Some(table) = &self.system.table {
            for (unknown, weight) in interior {
                for (value, coordinate) in phi.iter_mut().zip(table.row(unknown as usize)) {
                    *value += weight * coordinate;
                }
            }
            return Ok(true);
        }
        for (value, column) in phi.iter_mut().zip(self.system.coupling.outer_iterator()) {
            for (unknown, &entry) in column.iter() {
                *value -= entry * scratch.solution[solver.position(unknown as u32)][0];
            }
        }
        Ok(true)
    }

    /// Starts computing the harmonic extension of `boundary`, see [`super::harmonic_extension`].
    pub(super) fn begin_extension(&self, boundary: impl Iterator<Item = DVec2>, scratch: &mut ExtensionScratch) {
        let ExtensionScratch { boundary: kept, solution, has_sources, run } = scratch;
        run.restart();
        *has_sources = false;
        kept.clear();
        kept.extend(boundary);
        solution.clear();
        solution.resize(self.system.solver.len(), [0.0; 2]);
        for (w, column) in kept.iter().zip(self.system.coupling.outer_iterator()) {
            for (unknown, &entry) in column.iter() {
                let right = &mut solution[self.system.solver.position(unknown as u32)];
                right[0] -= entry * w.x;
                right[1] -= entry * w.y;
            }
        }
    }

    /// Adds sources, by interior vertex and integrated over its cell, to the right-hand side of an extension that was begun.
    pub(super) fn add_sources(&self, sources: impl Iterator<Item = f64>, scratch: &mut ExtensionScratch) {
        scratch.has_sources = true;
        for (unknown, source) in (0u32..).zip(sources) {
            scratch.solution[self.system.solver.position(unknown)][0] += source;
        }
    }

    /// Continues until `values` holds those of all vertices (true) or `deadline` has passed (`values` is then
    /// unchanged). The deadline is checked every few milliseconds; the longest step is writing the `values` at the end.
    pub(crate) fn advance_extension(
        &self,
        scratch: &mut ExtensionScratch,
        values: &mut Vec<DVec2>,
        deadline: Deadline,
    ) -> Result<bool, NotConverged> {
        let ExtensionScratch { boundary, solution, has_sources, run } = scratch;
        let everything = self.system.solver.everything();
        let given = if *has_sources { everything } else { &self.system.boundary_paths };
        if !self.system.solver.advance(run, given, everything, solution, deadline)? {
            return Ok(false);
        }
        values.resize(boundary.len() + solution.len(), DVec2::ZERO);
        let (outer, inner) = values.split_at_mut(boundary.len());
        outer.copy_from_slice(boundary);
        for (&[x, y], &unknown) in solution.iter().zip(self.system.solver.unknowns()) {
            inner[unknown as usize] = DVec2::new(x, y);
        }
        Ok(true)
    }
}
