//! Harmonic coordinates and the Poisson kernel at a point, by the adjoint solve.
//!
//! The paper stores the harmonic coordinates of every vertex (n×m). Only one row
//! is ever needed: for x = ρ v_i + σ v_j + τ v_k, equations (9) and (A.1) give
//! φ_x = −L̄ᵀ g with L̂ g = ρ e_i + σ e_j + τ e_k (interior corners; the weight of
//! a boundary corner goes to its own coordinate). On a Delaunay mesh all terms
//! are non-negative, so φ_x is accurate componentwise.

use super::PreparedDomain;
use super::stencil::{self, Stencil};
use crate::laplace::{Lanes, NotConverged, RootPaths, SolverKind};
use crate::mesh::BarycentricPoint;

/// What an iterative solver leaves below 0, relative to the largest coordinate: its tolerance
/// of 1e-12 gives up to 1e-11 in a crowded domain; a stencil that overshoots gives 1e-3.
const PCG_NOISE: f64 = 1e-9;

/// Working memory of the kernel functions; reused, it allocates nothing.
#[derive(Debug, Clone, Default)]
pub struct KernelScratch {
    solution: Vec<Lanes<1>>,
    paths: RootPaths,
    stencil: Stencil,
}

/// The harmonic coordinates `φ_x` (length m) of the point `x`, equation (9); Σφ = 1, Σφ_k v_k = x.
///
/// Cost: one pruned solve, or with a table a sum of its rows. Errors: [`NotConverged`], of an iterative solver only.
pub fn harmonic_coordinates(
    domain: &PreparedDomain,
    x: BarycentricPoint,
    scratch: &mut KernelScratch,
    phi: &mut Vec<f64>,
) -> Result<(), NotConverged> {
    scratch.stencil.clear();
    scratch.stencil.extend(domain.mesh.triangles[x.triangle as usize].into_iter().zip(x.weights));
    combine(domain, scratch, phi)
}

/// The values `ψ_k` (length m, per unit of length, ≥ 0) of the piecewise linear Poisson
/// kernel at `x`: ψ_k = φ_k / ((e_{k−1} + e_k)/2), equation (B.2).
///
/// φ is interpolated from the ring of vertices around `x` where it is interior (file
/// `stencil`), else linearly as in (10). Σφ = 1 and Σφ_k v_k = x hold either way, with an
/// iterative solver up to its tolerance: what it leaves below 0 is noise, and taken as 0.
pub fn poisson_kernel(
    domain: &PreparedDomain,
    x: BarycentricPoint,
    scratch: &mut KernelScratch,
    psi: &mut Vec<f64>,
) -> Result<(), NotConverged> {
    stencil::around(&domain.mesh, x, &mut scratch.stencil);
    combine(domain, scratch, psi)?;
    let iterative = domain.solver.kind() == SolverKind::Pcg;
    let noise = if iterative { PCG_NOISE * psi.iter().fold(0.0_f64, |max, &value| max.max(value)) } else { 0.0 };
    if psi.iter().any(|&value| value < -noise) {
        harmonic_coordinates(domain, x, scratch, psi)?;
    }
    if iterative {
        for value in psi.iter_mut() {
            *value = value.max(0.0);
        }
    }
    let lengths = &domain.samples.edge_lengths;
    let mut previous = lengths[lengths.len() - 1];
    for (value, &length) in psi.iter_mut().zip(lengths) {
        *value /= 0.5 * (previous + length);
        previous = length;
    }
    Ok(())
}

/// Σ weight · φ_vertex over the stencil, into `phi`.
fn combine(domain: &PreparedDomain, scratch: &mut KernelScratch, phi: &mut Vec<f64>) -> Result<(), NotConverged> {
    let m = domain.mesh.boundary_count;
    phi.clear();
    phi.resize(m as usize, 0.0);
    for &(vertex, weight) in scratch.stencil.iter().filter(|(vertex, _)| *vertex < m) {
        phi[vertex as usize] = weight;
    }
    let interior = scratch.stencil.iter().filter_map(|&(vertex, weight)| Some((vertex.checked_sub(m)?, weight)));
    if let Some(table) = &domain.table {
        for (unknown, weight) in interior {
            for (value, coordinate) in phi.iter_mut().zip(table.row(unknown as usize)) {
                *value += weight * coordinate;
            }
        }
        return Ok(());
    }
    let solver = &domain.solver;
    scratch.solution.clear();
    scratch.solution.resize(solver.len(), [0.0]);
    for (unknown, weight) in interior.clone() {
        scratch.solution[solver.position(unknown)] = [weight];
    }
    solver.root_paths(interior.map(|(unknown, _)| unknown), &mut scratch.paths);
    solver.solve(&scratch.paths, &domain.boundary_paths, &mut scratch.solution)?;
    for (value, column) in phi.iter_mut().zip(domain.coupling.outer_iterator()) {
        for (unknown, &entry) in column.iter() {
            *value -= entry * scratch.solution[solver.position(unknown as u32)][0];
        }
    }
    Ok(())
}
