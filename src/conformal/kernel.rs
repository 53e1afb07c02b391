//! Harmonic coordinates and the Poisson kernel at a point, by the adjoint solve.
//!
//! The paper stores the harmonic coordinates of every vertex (n×m). Only one row
//! is ever needed: for x = ρ v_i + σ v_j + τ v_k, equations (9) and (A.1) give
//! φ_x = −L̄ᵀ g with L̂ g = ρ e_i + σ e_j + τ e_k (interior corners; the weight of
//! a boundary corner goes to its own coordinate). On a Delaunay mesh all terms
//! are non-negative, so φ_x is accurate componentwise.

use super::PreparedDomain;
use crate::laplace::{Lanes, RootPaths};
use crate::mesh::BarycentricPoint;

/// Working memory of [`harmonic_coordinates`]; reused, it allocates nothing.
#[derive(Debug, Clone, Default)]
pub struct KernelScratch {
    solution: Vec<Lanes<1>>,
    paths: RootPaths,
}

/// The harmonic coordinates `φ_x` (length m) of the point `x`; Σφ = 1, Σφ_k v_k = x.
///
/// Cost: one pruned solve.
pub fn harmonic_coordinates(
    domain: &PreparedDomain,
    x: BarycentricPoint,
    scratch: &mut KernelScratch,
    phi: &mut Vec<f64>,
) {
    let m = domain.mesh.boundary_count;
    phi.clear();
    phi.resize(m as usize, 0.0);
    scratch.solution.clear();
    scratch.solution.resize(domain.factor.len(), [0.0]);
    let corners = domain.mesh.triangles[x.triangle as usize];
    for (corner, weight) in corners.into_iter().zip(x.weights) {
        match corner.checked_sub(m) {
            Some(unknown) => scratch.solution[domain.factor.position(unknown)] = [weight],
            None => phi[corner as usize] = weight,
        }
    }
    let interior = corners.into_iter().filter_map(|corner| corner.checked_sub(m));
    domain.factor.root_paths(interior, &mut scratch.paths);
    domain.factor.solve(&scratch.paths, &domain.boundary_paths, &mut scratch.solution);
    for (value, column) in phi.iter_mut().zip(domain.coupling.outer_iterator()) {
        for (unknown, &entry) in column.iter() {
            *value -= entry * scratch.solution[domain.factor.position(unknown as u32)][0];
        }
    }
}

/// The values `ψ_k` (length m, per unit of length) of the piecewise linear Poisson
/// kernel at `x`: ψ_k = φ_k / ((e_{k−1} + e_k)/2), equation (B.2).
pub fn poisson_kernel(domain: &PreparedDomain, x: BarycentricPoint, scratch: &mut KernelScratch, psi: &mut Vec<f64>) {
    harmonic_coordinates(domain, x, scratch, psi);
    let lengths = &domain.samples.edge_lengths;
    let mut previous = lengths[lengths.len() - 1];
    for (value, &length) in psi.iter_mut().zip(lengths) {
        *value /= 0.5 * (previous + length);
        previous = length;
    }
}
