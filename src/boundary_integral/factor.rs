//! The factor of the system's matrix: dense for few unknowns, hierarchical for many.
//!
//! The LU factor of a dense matrix, P A = L U, is in one array, so that it can move between threads and workers.
//!
//! L has unit diagonal and lies below the diagonal of the array, U on and above it; columns follow one another.

use super::corner::{PlacedBlock, add_identity};
use super::entries::Entries;
use super::error::BoundaryIntegralError;
use super::hierarchical::HierarchicalFactor;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::factor::{lu_in_place, lu_in_place_scratch};
use faer::{Mat, MatMut, Par, Spec};

/// The unknowns from which on the factor is hierarchical. For 1,920 unknowns of a coast the dense one takes 0.37 s and this
/// one 0.19 s, for 3,840 1.9 s and 0.43 s; for 1,984 unknowns of a comb of 8 teeth 0.34 s and 0.53 s, for 2,944 of 12 teeth
/// 1.1 s and 0.9 s.
const HIERARCHICAL_FROM: usize = 2048;

/// The unknowns from which on clusters are gathered by place where those along the curve are unstable: for 1,760 unknowns of
/// the spiral they take 2.4 s, and the dense factor 0.26 s.
const BY_PLACE_FROM: usize = 4096;

/// A factored matrix I + K° R.
#[derive(Debug, Clone)]
pub enum Factor {
    /// Few unknowns.
    Dense(DenseFactor),
    /// Many.
    Hierarchical(HierarchicalFactor),
}

impl Factor {
    /// Factors the matrix with these entries and blocks. Fails if that takes more than `limit_mb` megabytes.
    pub fn new(entries: &Entries<'_>, blocks: &[PlacedBlock], limit_mb: usize) -> Result<Self, BoundaryIntegralError> {
        if entries.len() >= HIERARCHICAL_FROM {
            let along = HierarchicalFactor::along(entries, blocks, limit_mb);
            match along {
                Ok(factor) => return Ok(Self::Hierarchical(factor)),
                Err(_) if entries.len() >= BY_PLACE_FROM => {
                    let by_place = HierarchicalFactor::by_place(entries, blocks, limit_mb);
                    let too_large = |_| BoundaryIntegralError::TooMuchMemory { limit_mb };
                    return by_place.map(Self::Hierarchical).map_err(too_large);
                }
                Err(_) => {}
            }
        }
        let all: Vec<usize> = (0..entries.len()).collect();
        let mut matrix = Mat::zeros(all.len(), all.len());
        entries.for_each(&all, &all, |i, j, value| matrix[(i, j)] = value);
        for block in blocks {
            let places: Vec<usize> = block.nodes().collect();
            block.multiply_columns(&mut matrix, &places);
        }
        add_identity(&mut matrix);
        Ok(Self::Dense(DenseFactor::new(&matrix)))
    }

    /// A⁻¹ times `right`.
    pub fn solve(&self, right: &[f64]) -> Vec<f64> {
        match self {
            Self::Dense(factor) => factor.solve(right),
            Self::Hierarchical(factor) => factor.solve(right),
        }
    }
}

/// A factor as flat arrays.
#[cfg(feature = "io")]
#[derive(Debug, Clone, Default)]
pub struct FlatFactor {
    /// Of a dense factor its values; of a hierarchical one the matrices of each level, and the values of the top.
    pub floats: Vec<Vec<f64>>,
    /// The number of levels, the permutation's length, the permutation, and what the levels need.
    pub integers: Vec<u32>,
}

#[cfg(feature = "io")]
impl Factor {
    /// The number of unknowns.
    pub fn len(&self) -> usize {
        match self {
            Self::Dense(factor) => factor.len(),
            Self::Hierarchical(factor) => factor.len(),
        }
    }

    /// The factor as flat arrays.
    pub fn to_flat(&self) -> FlatFactor {
        match self {
            Self::Hierarchical(factor) => factor.to_flat(),
            Self::Dense(factor) => {
                let integers = [0, factor.len() as u32].into_iter().chain(factor.rows.iter().copied()).collect();
                FlatFactor { floats: vec![factor.values.clone()], integers }
            }
        }
    }

    /// The factor from flat arrays; `None` unless [`Self::to_flat`] may have written them.
    pub fn from_flat(flat: FlatFactor) -> Option<Self> {
        if *flat.integers.first()? > 0 {
            return HierarchicalFactor::from_flat(flat).map(Self::Hierarchical);
        }
        let rows = flat.integers.get(2..)?.to_vec();
        let is_sound = flat.integers[1] as usize == rows.len() && flat.floats.len() == 1;
        let values = flat.floats.into_iter().next().filter(|_| is_sound)?;
        DenseFactor::from_arrays(values, rows).map(Self::Dense)
    }
}

/// Whether all of 0 … n − 1 are there once.
#[cfg(feature = "io")]
pub fn is_permutation(indices: &[u32]) -> bool {
    let mut is_there = vec![false; indices.len()];
    indices.iter().all(|&index| is_there.get_mut(index as usize).is_some_and(|there| !std::mem::replace(there, true)))
}

/// The LU factor of a dense matrix.
#[derive(Debug, Clone)]
pub struct DenseFactor {
    values: Vec<f64>,
    /// The row of A that became row i.
    rows: Vec<u32>,
}

impl DenseFactor {
    /// Factors a square matrix with partial pivoting, on one thread. O(n³).
    pub fn new(matrix: &Mat<f64>) -> Self {
        let n = matrix.nrows();
        let mut values = Vec::with_capacity(n * n);
        (0..n).for_each(|j| values.extend_from_slice(matrix.col_as_slice(j)));
        let (mut rows, mut inverse) = (vec![0_u32; n], vec![0_u32; n]);
        let mut memory = MemBuffer::new(lu_in_place_scratch::<u32, f64>(n, n, Par::Seq, Spec::default()));
        let lu = MatMut::from_column_major_slice_mut(&mut values, n, n);
        lu_in_place(lu, &mut rows, &mut inverse, Par::Seq, MemStack::new(&mut memory), Spec::default());
        Self { values, rows }
    }

    /// The factor from its arrays; `None` unless they are n² finite values and a permutation of n rows.
    #[cfg(feature = "io")]
    pub fn from_arrays(values: Vec<f64>, rows: Vec<u32>) -> Option<Self> {
        let is_sound = is_permutation(&rows)
            && Some(values.len()) == rows.len().checked_mul(rows.len())
            && values.iter().all(|value| value.is_finite());
        is_sound.then_some(Self { values, rows })
    }

    /// The arrays: values by columns, and the permutation.
    #[cfg(feature = "io")]
    pub fn arrays(&self) -> (&[f64], &[u32]) {
        (&self.values, &self.rows)
    }

    /// The number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// A⁻¹ times `right`. O(n²).
    pub fn solve(&self, right: &[f64]) -> Vec<f64> {
        let n = self.len();
        let mut x: Vec<f64> = self.rows.iter().map(|&row| right[row as usize]).collect();
        for (k, column) in self.values.chunks_exact(n.max(1)).enumerate() {
            let (solved, rest) = x.split_at_mut(k + 1);
            subtract(rest, solved[k], &column[k + 1..]);
        }
        for (k, column) in self.values.chunks_exact(n.max(1)).enumerate().rev() {
            let (rest, solved) = x.split_at_mut(k);
            solved[0] /= column[k];
            subtract(rest, solved[0], &column[..k]);
        }
        x
    }
}

/// x ← x − factor · column.
fn subtract(x: &mut [f64], factor: f64, column: &[f64]) {
    for (x, entry) in x.iter_mut().zip(column) {
        *x -= factor * entry;
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn a_solution_satisfies_its_equations_and_the_arrays_give_the_same_factor() {
        let n = 37;
        let entry =
            |i: usize, j: usize| ((i * 31 + j * 17 + 5) % 23) as f64 - 11.0 + if i + j == n { 40.0 } else { 0.0 };
        let matrix = Mat::from_fn(n, n, entry);
        let factor = DenseFactor::new(&matrix);
        let right: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let x = factor.solve(&right);
        for (i, expected) in right.iter().enumerate() {
            let left: f64 = (0..n).map(|j| entry(i, j) * x[j]).sum();
            assert!((left - expected).abs() < 1e-11, "row {i}: {left}, expected {expected}");
        }
        let (values, rows) = factor.arrays();
        let again = DenseFactor::from_arrays(values.to_vec(), rows.to_vec()).unwrap();
        assert_eq!(again.solve(&right), x);
        assert!(DenseFactor::from_arrays(values[1..].to_vec(), rows.to_vec()).is_none());
        assert!(DenseFactor::from_arrays(values.to_vec(), vec![0; n]).is_none(), "no permutation");
        let mut broken = values.to_vec();
        broken[3] = f64::NAN;
        assert!(DenseFactor::from_arrays(broken, rows.to_vec()).is_none());
    }
}
