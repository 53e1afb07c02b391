//! The LU factor of a dense matrix, P A = L U, in one array, so that it can move between threads and workers.
//!
//! L has unit diagonal and lies below the diagonal of the array, U on and above it; columns follow one another.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::lu::partial_pivoting::factor::{lu_in_place, lu_in_place_scratch};
use faer::{Mat, MatMut, Par, Spec};

/// A factored matrix.
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
        let mut values: Vec<f64> = matrix.col_iter().flat_map(|column| column.iter().copied()).collect();
        let (mut rows, mut inverse) = (vec![0_u32; n], vec![0_u32; n]);
        let mut memory = MemBuffer::new(lu_in_place_scratch::<u32, f64>(n, n, Par::Seq, Spec::default()));
        let lu = MatMut::from_column_major_slice_mut(&mut values, n, n);
        lu_in_place(lu, &mut rows, &mut inverse, Par::Seq, MemStack::new(&mut memory), Spec::default());
        Self { values, rows }
    }

    /// The factor from its arrays; `None` unless they are n² finite values and a permutation of n rows.
    #[cfg(feature = "io")]
    pub fn from_arrays(values: Vec<f64>, rows: Vec<u32>) -> Option<Self> {
        let mut is_there = vec![false; rows.len()];
        for &row in &rows {
            *is_there.get_mut(row as usize)? = true;
        }
        let is_sound = is_there.iter().all(|&there| there)
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
