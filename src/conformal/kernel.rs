//! Harmonic coordinates and the Poisson kernel at a point, by the adjoint solve.
//!
//! The paper stores the harmonic coordinates of every vertex (n×m). Only one row
//! is ever needed: for x = ρ v_i + σ v_j + τ v_k, equations (9) and (A.1) give
//! φ_x = −L̄ᵀ g with L̂ g = ρ e_i + σ e_j + τ e_k (interior corners; the weight of
//! a boundary corner goes to its own coordinate). On a Delaunay mesh all terms
//! are non-negative, so φ_x is accurate componentwise.

use super::stencil::{self, Stencil};
use super::unfold::{self, UnfoldedPlaces};
use super::{PreparedSide, SideGeometry};
use crate::laplace::{Deadline, Lanes, NotConverged, RootPaths, SolveRun};
use crate::mesh::BarycentricPoint;

/// Working memory of the kernel; no allocation when it is reused.
#[derive(Debug, Clone, Default)]
pub(super) struct KernelScratch {
    pub(super) solution: Vec<Lanes<1>>,
    pub(super) paths: RootPaths,
    pub(super) run: SolveRun,
    /// Whether the weights are those of the triangle alone: no fallback is attempted.
    pub(super) is_linear: bool,
    pub(super) stencil: Stencil,
    pub(super) places: UnfoldedPlaces,
}

impl KernelScratch {
    pub(super) fn set_stencil(&mut self, weights: [(u32, f64); 3]) {
        self.stencil.clear();
        self.stencil.extend(weights);
    }
}

/// The corners of the triangle of x, with their barycentric weights.
fn linear(side: &PreparedSide, x: BarycentricPoint) -> [(u32, f64); 3] {
    let corners = side.triangles()[x.triangle().index()];
    [0, 1, 2].map(|i| (corners[i], x.weights()[i]))
}

/// The harmonic coordinates `φ_x` (length m) of the point `x`, equation (9); Σφ = 1, Σφ_k v_k = x.
///
/// Cost: one pruned solve, or with a table a sum of its rows. Errors: [`NotConverged`], from the iterative solver only.
pub fn harmonic_coordinates(side: &PreparedSide, x: BarycentricPoint) -> Result<Vec<f64>, NotConverged> {
    let (mut scratch, mut phi) = (KernelScratch::default(), Vec::new());
    scratch.set_stencil(linear(side, x));
    side.begin_combination(&mut scratch);
    side.advance_combination(&mut scratch, &mut phi, Deadline::NEVER)?;
    Ok(phi)
}

/// The values `ψ_k` (length m, per unit of length, ≥ 0) of the piecewise linear Poisson
/// kernel at `x`: ψ_k = φ_k / ((e_{k−1} + e_k)/2), equation (B.2).
///
/// φ is interpolated from the ring of vertices around `x` if all of them are interior (file
/// `stencil`; on a surface, if the ring is flat too, file `unfold`), else linearly as in (10). Σφ = 1 and
/// Σφ_k v_k = x hold in both cases in the plane, with an iterative solver up to its tolerance: the negative values that
/// it leaves are noise and are set to 0. On a surface without intrinsic Delaunay flips, values may be negative.
pub fn poisson_kernel(side: &PreparedSide, x: BarycentricPoint) -> Result<Vec<f64>, NotConverged> {
    let (mut scratch, mut psi) = (KernelScratch::default(), Vec::new());
    begin_kernel(side, x, &mut scratch);
    advance_kernel(side, x, &mut scratch, &mut psi, Deadline::NEVER)?;
    Ok(psi)
}

/// Starts computing [`poisson_kernel`].
pub(super) fn begin_kernel(side: &PreparedSide, x: BarycentricPoint, scratch: &mut KernelScratch) {
    match side.geometry() {
        SideGeometry::Plane(domain) => stencil::around(domain.mesh(), x, &mut scratch.stencil),
        SideGeometry::Space(surface) => {
            unfold::around(surface.mesh(), x, &mut scratch.stencil, &mut scratch.places);
        }
    }
    side.begin_kernel_of_stencil(scratch);
}

/// Continues until the kernel is in `psi` (true) or `deadline` has passed (`psi` is then meaningless).
pub(super) fn advance_kernel(
    side: &PreparedSide,
    x: BarycentricPoint,
    scratch: &mut KernelScratch,
    psi: &mut Vec<f64>,
    deadline: Deadline,
) -> Result<bool, NotConverged> {
    side.advance_kernel_of_stencil(linear(side, x), scratch, psi, deadline)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{PrepareSettings, prepare};
    use crate::laplace::DirichletLaplacian;
    use crate::mesh::{Sizing, TriangleId};
    use crate::outline::{Preset, Sampling};

    #[test]
    fn adjoint_kernel_equals_the_dense_table() {
        let settings = PrepareSettings::new(Sampling::Uniform { count: 60, keep_corners: false }, Sizing::Uniform);
        let l_shape = prepare(Preset::LShape.outline().polygon(), &settings, &mut |_| ()).unwrap();
        let laplacian = DirichletLaplacian::assemble(l_shape.domain().unwrap().mesh()).unwrap();
        let (m, n, solver) = (l_shape.boundary_count(), l_shape.interior_count(), &l_shape.system.solver);
        // Φ column by column: L̂ Φ̂ = −L̄
        let mut table = vec![vec![0.0; n]; m];
        for (column, coordinates) in laplacian.coupling().outer_iterator().zip(&mut table) {
            let mut x = vec![[0.0]; n];
            for (i, &entry) in column.iter() {
                x[solver.position(i as u32)] = [-entry];
            }
            solver.solve(solver.everything(), solver.everything(), &mut x).unwrap();
            for (i, value) in coordinates.iter_mut().enumerate() {
                *value = x[solver.position(i as u32)][0];
            }
        }
        for triangle in 0..l_shape.triangles().len() as u32 {
            let weights = [0.2, 0.3, 0.5];
            let phi =
                harmonic_coordinates(&l_shape, BarycentricPoint::new(TriangleId::new(triangle), weights)).unwrap();
            for (k, &value) in phi.iter().enumerate() {
                let corner = |v: u32| match (v as usize).checked_sub(m) {
                    Some(i) => table[k][i],
                    None => f64::from(u8::from(v as usize == k)),
                };
                let corners = l_shape.triangles()[triangle as usize];
                let expected: f64 = corners.iter().zip(weights).map(|(&v, w)| w * corner(v)).sum();
                assert!((value - expected).abs() <= 1e-12, "triangle {triangle}, k = {k}: {value} and {expected}");
            }
        }
    }
}
