//! Conjugate gradients preconditioned by an incomplete Cholesky factor without fill:
//! for domains whose complete factor does not fit into memory.
//!
//! Meijerink and van der Vorst (1977): for an M-matrix such as L̂ the incomplete factor
//! exists. It needs as much memory as L̂ itself; a solve takes O(n^½) iterations of
//! O(n), 15 to 300 times as long as the sweeps of a complete factor. The residual is
//! small in norm only: unlike the sweeps, this is *not* accurate componentwise.

use super::{DirichletLaplacian, Lanes, LaplaceError};

/// The residual, relative to the right-hand side, at which a solve ends: the rounding
/// of the recurrence reaches 1e-14 to 1e-13 on meshes of 10⁴ to 10⁶ unknowns.
const TOLERANCE: f64 = 1e-12;

/// Iterations per √n before a solve is given up; meshes of 10³ to 10⁵ unknowns take 1 to 2.
const PATIENCE: f64 = 20.0;

/// A solve did not reach its tolerance.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("the iterative solver did not converge: its relative residual is {residual:.1e}")]
pub struct NotConverged {
    /// The relative residual that it has come to.
    pub residual: f64,
}

/// L̂ and its incomplete Cholesky factor.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pcg {
    /// Where the rows of the lower triangles start (n+1).
    starts: Vec<u32>,
    /// The columns of each row, ascending; the last is the diagonal.
    columns: Vec<u32>,
    /// L̂.
    matrix: Vec<f64>,
    /// The factor, with the reciprocal diagonal.
    factor: Vec<f64>,
}

/// A [`Pcg`] as flat arrays.
#[derive(Debug, Clone, PartialEq)]
pub struct PcgBuffers {
    /// Where the rows start.
    pub starts: Vec<u32>,
    /// The columns.
    pub columns: Vec<u32>,
    /// The entries of L̂.
    pub matrix: Vec<f64>,
    /// The entries of the factor.
    pub factor: Vec<f64>,
}

impl Pcg {
    /// Factors L̂ incompletely. Cost O(n). Errors: [`LaplaceError::NotPositiveDefinite`].
    pub fn new(laplacian: &DirichletLaplacian) -> Result<Self, LaplaceError> {
        // the upper triangle by columns is the lower one by rows
        let (starts, columns) = (laplacian.interior.proper_indptr(), laplacian.interior.indices());
        let matrix = laplacian.interior.data().to_vec();
        let mut solver =
            Self { starts: starts.into_owned(), columns: columns.to_vec(), factor: matrix.clone(), matrix };
        for row in 0..solver.len() {
            solver.factor_row(row)?;
        }
        Ok(solver)
    }

    /// The number of unknowns, `n`.
    pub fn len(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Whether there are no unknowns.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    fn row(&self, row: usize) -> std::ops::Range<usize> {
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

    /// The product of two pieces of rows of the factor.
    fn overlap(&self, mut a: std::ops::Range<usize>, mut b: std::ops::Range<usize>) -> f64 {
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

    /// Solves L̂ x = b in place, lane after lane. Errors: [`NotConverged`]; `x` then holds the last iterate.
    pub fn solve<const K: usize>(&self, x: &mut [Lanes<K>]) -> Result<(), NotConverged> {
        (0..K).try_for_each(|lane| {
            let right: Vec<f64> = x.iter().map(|lanes| lanes[lane]).collect();
            let (solution, residual) = self.conjugate_gradients(right);
            for (lanes, value) in x.iter_mut().zip(solution) {
                lanes[lane] = value;
            }
            if residual <= TOLERANCE { Ok(()) } else { Err(NotConverged { residual }) }
        })
    }

    /// The solution and its relative residual.
    fn conjugate_gradients(&self, mut residual: Vec<f64>) -> (Vec<f64>, f64) {
        let mut solution = vec![0.0; residual.len()];
        let scale = dot(&residual, &residual).sqrt();
        if scale == 0.0 {
            return (solution, 0.0);
        }
        let mut product = vec![0.0; residual.len()];
        let mut direction = residual.clone();
        self.precondition(&mut direction);
        let mut energy = dot(&residual, &direction);
        let mut relative = 1.0;
        for _ in 0..(PATIENCE * (residual.len() as f64).sqrt()) as usize + 50 {
            self.multiply(&direction, &mut product);
            let step = energy / dot(&direction, &product);
            add_scaled(&mut solution, step, &direction);
            add_scaled(&mut residual, -step, &product);
            relative = dot(&residual, &residual).sqrt() / scale;
            if relative <= TOLERANCE || relative.is_nan() {
                break;
            }
            product.copy_from_slice(&residual);
            self.precondition(&mut product);
            let next = dot(&residual, &product);
            let share = next / std::mem::replace(&mut energy, next);
            for (d, z) in direction.iter_mut().zip(&product) {
                *d = z + share * *d;
            }
        }
        (solution, relative)
    }

    /// `product = L̂ x`.
    fn multiply(&self, x: &[f64], product: &mut [f64]) {
        for row in 0..x.len() {
            let range = self.row(row);
            let mut sum = self.matrix[range.end - 1] * x[row];
            for entry in range.start..range.end - 1 {
                let column = self.columns[entry] as usize;
                sum += self.matrix[entry] * x[column];
                // rows are ascending: the products of smaller columns are begun already
                product[column] += self.matrix[entry] * x[row];
            }
            product[row] = sum;
        }
    }

    /// Solves with the incomplete factor, in place.
    fn precondition(&self, x: &mut [f64]) {
        for row in 0..x.len() {
            let range = self.row(row);
            let mut sum = x[row];
            for entry in range.start..range.end - 1 {
                sum -= self.factor[entry] * x[self.columns[entry] as usize];
            }
            x[row] = sum * self.factor[range.end - 1];
        }
        for row in (0..x.len()).rev() {
            let range = self.row(row);
            let value = x[row] * self.factor[range.end - 1];
            x[row] = value;
            for entry in range.start..range.end - 1 {
                x[self.columns[entry] as usize] -= self.factor[entry] * value;
            }
        }
    }

    /// As flat arrays.
    pub fn to_buffers(&self) -> PcgBuffers {
        let Self { starts, columns, matrix, factor } = self.clone();
        PcgBuffers { starts, columns, matrix, factor }
    }

    /// From flat arrays; `None` if they are not consistent.
    pub fn from_buffers(buffers: PcgBuffers) -> Option<Self> {
        let PcgBuffers { starts, columns, matrix, factor } = buffers;
        let solver = Self { starts, columns, matrix, factor };
        solver.check_invariants().then_some(solver)
    }

    /// Whether every row ends with its diagonal, after ascending columns, and the arrays have one length.
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

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// `x += factor · y`.
fn add_scaled(x: &mut [f64], factor: f64, y: &[f64]) {
    for (x, y) in x.iter_mut().zip(y) {
        *x += factor * y;
    }
}
