//! The cotangent Laplacian of a mesh and its Cholesky factor.
//!
//! [`DirichletLaplacian`] holds the blocks L̂ and L̄ of the paper's appendix A;
//! `Factor` is the Cholesky factor of L̂ as flat arrays, with sweeps that visit
//! only what a sparse right-hand side, or a sparse set of wanted unknowns, needs. `Solver` is
//! that factor or, where it does not fit, conjugate gradients; a solve of either can be
//! interrupted at a [`Deadline`].

#[cfg(any(feature = "io", test))]
mod buffers;
mod cotangent;
mod deadline;
mod factor;
#[cfg(test)]
mod factor_tests;
mod multifrontal;
mod ordering;
mod pcg;
mod pcg_run;
mod solver;
mod supernode;
mod sweep;
#[cfg(test)]
mod tests;
mod unrolled;

#[cfg(any(feature = "io", test))]
pub(crate) use buffers::{FactorBuffers, PcgBuffers};

pub use cotangent::DirichletLaplacian;
pub use deadline::Deadline;
pub(crate) use factor::{Factor, RootPaths};
pub(crate) use ordering::Ordering;
pub use pcg::NotConverged;
pub(crate) use pcg::Pcg;
pub use solver::SolverKind;
pub(crate) use solver::{SolveRun, Solver};
pub(crate) use sweep::Lanes;

use crate::mesh::VertexId;

/// Why the Laplacian of a mesh could not be assembled or factored.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LaplaceError {
    /// The assembled pattern is not a valid sparse matrix: the mesh is inconsistent.
    #[error("the mesh is inconsistent: {0}")]
    Structure(String),
    /// A planar triangle is too thin to have angles.
    #[error("a triangle near ({x}, {y}) is too thin to have angles: use more samples, or a less narrow outline")]
    Degenerate {
        /// The x coordinate of a corner.
        x: f64,
        /// The y coordinate of a corner.
        y: f64,
    },
    /// A triangle of a surface is too thin to have angles.
    #[error("a triangle at vertex {vertex} of the surface is too thin to have angles")]
    DegenerateAt {
        /// One of its corners, in the numbering of the mesh.
        vertex: VertexId,
    },
    /// A pivot of the Cholesky factorisation is not positive.
    #[error("the Laplacian is not positive definite at interior vertex {vertex}: a triangle there is degenerate")]
    NotPositiveDefinite {
        /// The interior vertex, `0 … n−1`.
        vertex: usize,
    },
    /// The factor does not fit into its memory limit, or has more entries than a 32-bit index can count.
    #[error(
        "the factor of {unknowns} unknowns takes {} MB, more than fits: use fewer samples, graded sizing, \
         or the iterative solver", bytes / 1_000_000
    )]
    TooLarge {
        /// The number of interior vertices, `n`.
        unknowns: usize,
        /// The memory that the factor needs; 0 if not even its structure could be computed.
        bytes: u64,
    },
}
