//! Conjugate gradients preconditioned by an incomplete Cholesky factor without fill:
//! for domains whose complete factor does not fit into memory.
//!
//! Meijerink and van der Vorst (1977): for an M-matrix such as L̂ the incomplete factor
//! exists. It needs as much memory as L̂ itself; a solve takes O(n^½) iterations of
//! O(n), 15 to 300 times as long as the sweeps of a complete factor. The residual is
//! small in norm only: unlike the sweeps, this is *not* accurate componentwise.

use super::pcg_run::PcgRun;
use super::{Deadline, DirichletLaplacian, Lanes, LaplaceError};
use std::ops::Range;

/// The error of a solve that did not reach its tolerance.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the iterative solver did not converge: its relative residual is {residual:.1e}")]
#[non_exhaustive]
pub struct NotConverged {
    /// The relative residual that was reached.
    pub residual: f64,
}

/// L̂ and its incomplete Cholesky factor.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pcg {
    /// The index of the first entry of each row of the lower triangles (length n+1).
    pub(super) starts: Vec<u32>,
    /// The columns of each row, ascending; the last is the diagonal.
    pub(super) columns: Vec<u32>,
    /// The entries of L̂.
    pub(super) matrix: Vec<f64>,
    /// The entries of the incomplete factor, with the reciprocal diagonal.
    pub(super) factor: Vec<f64>,
}

impl Pcg {
    /// Computes the incomplete factor of L̂. Cost O(n). Errors: [`LaplaceError::NotPositiveDefinite`].
    pub fn new(laplacian: &DirichletLaplacian) -> Result<Self, LaplaceError> {
        // the upper triangle by columns is the lower one by rows
        let (starts, columns) = (laplacian.interior.proper_indptr(), laplacian.interior.indices());
        let matrix = laplacian.interior.data().to_vec();
        let mut solver =
            Self { starts: starts.into_owned(), columns: columns.to_vec(), factor: matrix.clone(), matrix };
        for row in 0..solver.len() {
            solver.factor_row(row)?;
        }
        debug_assert!(solver.check_invariants());
        Ok(solver)
    }

    /// The number of unknowns, `n`.
    pub fn len(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    fn row(&self, row: usize) -> Range<usize> {
        self.starts[row] as usize..self.starts[row + 1] as usize
    }

    fn factor_row(&mut self, row: usize) -> Result<(), LaplaceError> {
        let range = self.row(row);
        let diagonal = range.end - 1;
        let mut pivot = self.matrix[diagonal];
        for entry in range.start..diagonal {
            let above = self.row(self.columns[entry] as usize);
            let known = self.overlap(range.start..entry, above.start..above.end - 1);
            let value = (self.matrix[entry] - known) * self.factor[above.end - 1];
            self.factor[entry] = value;
            pivot -= value * value;
        }
        if pivot.is_nan() || pivot <= 0.0 {
            return Err(LaplaceError::NotPositiveDefinite { vertex: row });
        }
        self.factor[diagonal] = pivot.sqrt().recip();
        Ok(())
    }

    /// The inner product of two parts of rows of the factor.
    fn overlap(&self, mut a: Range<usize>, mut b: Range<usize>) -> f64 {
        let mut sum = 0.0;
        while !a.is_empty() && !b.is_empty() {
            match self.columns[a.start].cmp(&self.columns[b.start]) {
                std::cmp::Ordering::Less => a.start += 1,
                std::cmp::Ordering::Greater => b.start += 1,
                std::cmp::Ordering::Equal => {
                    sum += self.factor[a.start] * self.factor[b.start];
                    a.start += 1;
                    b.start += 1;
                }
            }
        }
        sum
    }

    /// Solves L̂ x = b in place, one lane after another. Errors: [`NotConverged`]; `x` then holds the last iterate.
    pub fn solve<const K: usize>(&self, x: &mut [Lanes<K>]) -> Result<(), NotConverged> {
        self.advance(&mut PcgRun::default(), x, Deadline::NEVER).map(|_| ())
    }

    /// `product = L̂ x`, by blocks of `rows` from the first to the last; a block reads no entry of `x` after its rows
    /// and writes no entry of `product` after them.
    pub(super) fn multiply(&self, rows: Range<usize>, x: &[f64], product: &mut [f64]) {
        for row in rows {
            let range = self.row(row);
            let mut sum = self.matrix[range.end - 1] * x[row];
            for entry in range.start..range.end - 1 {
                let column = self.columns[entry] as usize;
                sum += self.matrix[entry] * x[column];
                // rows are ascending: the products of smaller columns are already initialized
                product[column] += self.matrix[entry] * x[row];
            }
            product[row] = sum;
        }
    }

    /// The forward half of a solve with the incomplete factor, in place, by blocks of `rows` from the first to the
    /// last.
    pub(super) fn sweep_forward(&self, rows: Range<usize>, x: &mut [f64]) {
        for row in rows {
            let range = self.row(row);
            let mut sum = x[row];
            for entry in range.start..range.end - 1 {
                sum -= self.factor[entry] * x[self.columns[entry] as usize];
            }
            x[row] = sum * self.factor[range.end - 1];
        }
    }

    /// The backward half, by blocks of `rows` from the last to the first.
    pub(super) fn sweep_backward(&self, rows: Range<usize>, x: &mut [f64]) {
        for row in rows.rev() {
            let range = self.row(row);
            let value = x[row] * self.factor[range.end - 1];
            x[row] = value;
            for entry in range.start..range.end - 1 {
                x[self.columns[entry] as usize] -= self.factor[entry] * value;
            }
        }
    }

    /// Whether columns ascend in every row and end with the diagonal, and the arrays have the same length.
    pub fn check_invariants(&self) -> bool {
        let count = self.columns.len();
        let framed = self.starts.first().is_none_or(|&first| first == 0)
            && self.starts.last().is_none_or(|&last| last as usize == count)
            && self.starts.windows(2).all(|pair| pair[0] < pair[1])
            && (self.matrix.len(), self.factor.len()) == (count, count);
        framed
            && (0..self.len()).all(|row| {
                let columns = &self.columns[self.row(row)];
                columns.last() == Some(&(row as u32)) && columns.windows(2).all(|pair| pair[0] < pair[1])
            })
    }
}
