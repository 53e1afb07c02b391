//! Solving L̂ x = b: directly by a complete factor, or iteratively where that does not fit.

use super::pcg_run::PcgRun;
use super::{Deadline, DirichletLaplacian, Factor, Lanes, LaplaceError, NotConverged, Ordering, Pcg, RootPaths};

/// The requested solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SolverKind {
    /// The complete Cholesky factor; if it does not fit into memory, as [`Self::Pcg`].
    #[default]
    Direct,
    /// Conjugate gradients with an incomplete Cholesky factor.
    Pcg,
}

/// A solver of L̂ x = b.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Solver {
    /// A complete factor.
    Direct(Factor),
    /// Conjugate gradients; every solve visits every unknown.
    Pcg {
        /// The matrix and its incomplete factor.
        pcg: Pcg,
        /// `0, 1, …, n−1`.
        unknowns: Vec<u32>,
        /// The empty set of paths.
        nothing: RootPaths,
    },
}

/// The progress of an interrupted solve: see [`Solver::advance`]. No allocation when it is reused.
#[derive(Debug, Clone, Default)]
pub(crate) struct SolveRun {
    /// The number of chunks that a direct solve has visited.
    visited: usize,
    pcg: PcgRun,
}

impl SolveRun {
    /// Makes the next [`Solver::advance`] start a new solve.
    pub(crate) fn restart(&mut self) {
        self.visited = 0;
        self.pcg.restart();
    }
}

impl Solver {
    /// The direct solver.
    pub(crate) fn direct(
        laplacian: &DirichletLaplacian,
        ordering: Ordering,
        budget_bytes: u64,
    ) -> Result<Self, LaplaceError> {
        Factor::new(laplacian, ordering, budget_bytes).map(Self::Direct)
    }

    /// The iterative solver.
    pub(crate) fn pcg(laplacian: &DirichletLaplacian) -> Result<Self, LaplaceError> {
        Pcg::new(laplacian).map(Self::from)
    }

    /// The kind of this solver.
    pub fn kind(&self) -> SolverKind {
        match self {
            Self::Direct(_) => SolverKind::Direct,
            Self::Pcg { .. } => SolverKind::Pcg,
        }
    }

    /// The number of unknowns, `n`.
    pub fn len(&self) -> usize {
        self.unknowns().len()
    }

    /// The position of an unknown in the vectors of [`Self::solve`].
    pub fn position(&self, unknown: u32) -> usize {
        match self {
            Self::Direct(factor) => factor.position(unknown),
            Self::Pcg { .. } => unknown as usize,
        }
    }

    /// The unknown at each position.
    pub(crate) fn unknowns(&self) -> &[u32] {
        match self {
            Self::Direct(factor) => factor.unknowns(),
            Self::Pcg { unknowns, .. } => unknowns,
        }
    }

    /// The argument of [`Self::solve`] if every unknown is wanted.
    pub fn everything(&self) -> &RootPaths {
        match self {
            Self::Direct(factor) => factor.everything(),
            Self::Pcg { nothing, .. } => nothing,
        }
    }

    /// Collects into `paths` the chunks that [`Self::solve`] visits for the `unknowns`.
    pub(crate) fn root_paths(&self, unknowns: impl IntoIterator<Item = u32>, paths: &mut RootPaths) {
        if let Self::Direct(factor) = self {
            factor.root_paths(unknowns, paths);
        }
    }

    /// Solves L̂ x = b in place, `x` ordered by [`Self::position`]. On entry it holds b,
    /// zero outside the unknowns of `given`; on exit the solution at those of `wanted`.
    /// Errors: [`NotConverged`], from the iterative solver only.
    pub fn solve<const K: usize>(
        &self,
        given: &RootPaths,
        wanted: &RootPaths,
        x: &mut [Lanes<K>],
    ) -> Result<(), NotConverged> {
        match self {
            Self::Direct(factor) => {
                factor.solve(given, wanted, x);
                Ok(())
            }
            Self::Pcg { pcg, .. } => pcg.solve(x),
        }
    }

    /// Continues [`Self::solve`] until it is complete (true) or `deadline` has passed. The deadline is checked
    /// every few milliseconds at most: after some hundred supernodes, or one block of rows of an
    /// iteration of conjugate gradients; every call does at least that much.
    ///
    /// The first call after [`SolveRun::restart`] reads b from `x`; until the end all arguments except the
    /// deadline must not change. The solution is bit-identical however often the solve was
    /// interrupted. After the end, or an error, `run` is ready for another solve.
    pub(crate) fn advance<const K: usize>(
        &self,
        run: &mut SolveRun,
        given: &RootPaths,
        wanted: &RootPaths,
        x: &mut [Lanes<K>],
        deadline: Deadline,
    ) -> Result<bool, NotConverged> {
        let result = match self {
            Self::Direct(factor) => Ok(factor.advance(&mut run.visited, [given, wanted], x, deadline)),
            Self::Pcg { pcg, .. } => pcg.advance(&mut run.pcg, x, deadline),
        };
        if result != Ok(false) {
            run.restart();
        }
        result
    }
}

impl From<Pcg> for Solver {
    fn from(pcg: Pcg) -> Self {
        let unknowns = (0..pcg.len() as u32).collect();
        Self::Pcg { pcg, unknowns, nothing: RootPaths::default() }
    }
}
