//! The paper's preprocessing as an option: the harmonic coordinates of all interior vertices, n×m.
//!
//! Appendix A: Φ̂ = −L̂⁻¹ L̄, by blocks of boundary vertices, eight columns in one
//! sweep. With the table a kernel is a weighted sum of rows, without a solve;
//! the adjoint solve of file `kernel` gives the same numbers without the table's memory.

use super::Memory;
use crate::laplace::{NotConverged, RootPaths, Solver};
use sprs::CsMatI;

/// n/m² of uniform meshes in round outlines is 0.06 (heart, disk); of graded ones 0.01 (m = 700) and less.
const UNIFORM_SHARE: f64 = 0.04;

/// Columns solved for at once: the number of values in a cache line.
const BLOCK: usize = 8;

/// The harmonic coordinates Φ̂ of the interior vertices.
#[derive(Debug, Clone, PartialEq)]
pub struct HarmonicTable {
    columns: usize,
    /// n rows of m values.
    values: Vec<f64>,
}

/// Why the table could not be made.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TableError {
    /// The table is larger than its memory limit.
    #[error(
        "the table of {rows}×{columns} harmonic coordinates takes {} MB, more than the {} MB it may take: \
         about {fitting_samples} boundary samples fit, or use the adjoint kernel, which needs no table",
        bytes / 1_000_000, budget / 1_000_000
    )]
    TooLarge {
        /// Interior vertices, `n`.
        rows: usize,
        /// Boundary vertices, `m`.
        columns: usize,
        /// The memory that the table needs.
        bytes: u64,
        /// The memory limit.
        budget: u64,
        /// The number of samples with which a table for this kind of mesh fits.
        fitting_samples: usize,
    },
    /// A solve did not converge.
    #[error(transparent)]
    NotConverged(#[from] NotConverged),
}

impl HarmonicTable {
    /// The memory that the table of an n×m domain needs.
    pub fn bytes(n: usize, m: usize) -> u64 {
        size_of::<f64>() as u64 * n as u64 * m as u64
    }

    /// Checks that the table fits. The sample count that fits is estimated for n = O(m²) if the mesh has as
    /// many vertices as a uniform one of a round outline, else for n = O(m), on the safe side.
    pub fn check(n: usize, m: usize, memory: Memory) -> Result<(), TableError> {
        let (bytes, budget) = (Self::bytes(n, m), memory.table_bytes);
        if bytes <= budget {
            return Ok(());
        }
        let share = budget as f64 / bytes as f64;
        let uniform = n as f64 > UNIFORM_SHARE * (m as f64).powi(2);
        let fitting_samples = (m as f64 * if uniform { share.cbrt() } else { share.sqrt() }) as usize;
        Err(TableError::TooLarge { rows: n, columns: m, bytes, budget, fitting_samples })
    }

    /// Solves for all coordinates; `progress` is called with the completed percentage. Call [`Self::check`] first.
    ///
    /// Cost: m/8 sweeps of eight lanes.
    pub(super) fn new(
        solver: &Solver,
        coupling: &CsMatI<f64, u32>,
        progress: &mut dyn FnMut(u8),
    ) -> Result<Self, TableError> {
        let (n, m) = (solver.len(), coupling.cols());
        let mut values = vec![0.0; n * m];
        let mut block = vec![[0.0; BLOCK]; n];
        let mut paths = RootPaths::default();
        let mut told = None;
        for first in (0..m).step_by(BLOCK) {
            let percent = (100 * first / m) as u8;
            if told.replace(percent) != Some(percent) {
                progress(percent);
            }
            let columns = first..(first + BLOCK).min(m);
            block.fill([0.0; BLOCK]);
            for (lane, column) in columns.clone().filter_map(|k| coupling.outer_view(k)).enumerate() {
                for (unknown, &entry) in column.iter() {
                    block[solver.position(unknown as u32)][lane] = -entry;
                }
            }
            let given = columns.clone().filter_map(|k| coupling.outer_view(k));
            let given = given.flat_map(|column| column.indices().to_vec());
            solver.root_paths(given, &mut paths);
            solver.solve(&paths, solver.everything(), &mut block)?;
            for (lanes, &unknown) in block.iter().zip(solver.unknowns()) {
                values[unknown as usize * m..][columns.clone()].copy_from_slice(&lanes[..columns.len()]);
            }
        }
        Ok(Self { columns: m, values })
    }

    /// The coordinates of one interior vertex (length m).
    pub fn row(&self, unknown: usize) -> &[f64] {
        &self.values[unknown * self.columns..][..self.columns]
    }

    /// All values, row after row.
    #[cfg(feature = "io")]
    pub(super) fn values(&self) -> &[f64] {
        &self.values
    }

    /// The table from the values of an n×m one; `None` if there are not n·m of them.
    #[cfg(feature = "io")]
    pub(super) fn from_values(values: Vec<f64>, n: usize, m: usize) -> Option<Self> {
        (n.checked_mul(m) == Some(values.len())).then_some(Self { columns: m, values })
    }
}
