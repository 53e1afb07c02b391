//! Interpolative decomposition: a few columns of a matrix from which the others are combined.
//!
//! Householder's QR factorization with column pivoting (Golub and Van Loan, Matrix Computations, 5.4), which ends as soon
//! as what is left is below a tolerance. (faer's goes on to the end, and updates norms by squares, which are noise below
//! 1e-8 of the largest column: there its pivots are no longer the largest columns.)
//!
//! A matrix with many more rows than columns is multiplied by a sparse matrix of random signs first, which keeps the linear
//! dependencies of its columns and changes the norms of their combinations by a factor of order 1 (Martinsson and Tropp,
//! Acta Numerica 29 (2020) 403, section 9.2).

use faer::Mat;

/// A ≈ A[:, columns] · `combination`, which is the identity on these columns.
pub struct Skeleton {
    /// The chosen columns.
    pub columns: Vec<usize>,
    /// A row for each chosen column, a column for each column of A.
    pub combination: Mat<f64>,
}

/// A squared norm that has fallen to this share by subtraction is computed anew.
const CANCELLED: f64 = 1e-8;

/// The factorization while columns are chosen.
struct Pivoted {
    matrix: Mat<f64>,
    order: Vec<usize>,
    /// For each column the squared norm of what is left of it, and this norm when it was last computed from the column.
    rest: Vec<[f64; 2]>,
}

/// The rows of a sketch, per column of the matrix.
const SKETCH: usize = 2;
/// The rows of a sketch that each row of the matrix is added to.
const SIGNS: usize = 8;
/// Matrices of more rows, in rows of their sketch, are sketched.
const TALL: f64 = 1.5;

/// The terms of a sum that are added at once.
const LANES: usize = 8;

/// Σ a b, in `LANES` sums, which the compiler can form at once.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a, b) = (a.chunks_exact(LANES), b[..a.len()].chunks_exact(LANES));
    let rest: f64 = a.remainder().iter().zip(b.remainder()).map(|(x, y)| x * y).sum();
    let mut sums = [0.0; LANES];
    for (a, b) in a.zip(b) {
        for k in 0..LANES {
            sums[k] += a[k] * b[k];
        }
    }
    sums.iter().sum::<f64>() + rest
}

fn squared(column: &[f64]) -> f64 {
    dot(column, column)
}

/// Chooses columns of A, given as its transpose, until what is left of every other one is below `tolerance` times the
/// largest column, in the sketch if there is one; at least one. O(rows · columns + columns² · chosen).
pub fn skeleton(transposed: &Mat<f64>, tolerance: f64) -> Skeleton {
    let rows = SKETCH * transposed.nrows();
    let is_tall = transposed.ncols() as f64 > TALL * rows as f64;
    let sketched = is_tall.then(|| sketch(transposed, rows));
    let matrix = sketched.as_ref().unwrap_or(transposed).transpose().to_owned();
    let norms: Vec<f64> = (0..matrix.ncols()).map(|j| squared(matrix.col_as_slice(j))).collect();
    let least = tolerance * tolerance * norms.iter().copied().fold(0.0, f64::max);
    let (most, order) = (matrix.nrows().min(norms.len()), (0..norms.len()).collect());
    let mut pivoted = Pivoted { matrix, order, rest: norms.iter().map(|&norm| [norm; 2]).collect() };
    let rank = (0..most).find(|&k| !pivoted.eliminate(k, least)).unwrap_or(most).max(1);
    pivoted.skeleton(rank)
}

/// Aᵀ Sᵀ from Aᵀ, with a sparse S of `rows` rows, in each of whose columns up to `SIGNS` entries are ±1; the same S for the
/// same sizes.
fn sketch(transposed: &Mat<f64>, rows: usize) -> Mat<f64> {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 32) as usize
    };
    let mut sketched: Mat<f64> = Mat::zeros(transposed.nrows(), rows);
    for j in 0..transposed.ncols() {
        let source = transposed.col_as_slice(j);
        for _ in 0..SIGNS {
            let random = next();
            let sign = if random & 1 == 0 { 1.0 } else { -1.0 };
            let target = sketched.col_as_slice_mut((random >> 1) % rows);
            target.iter_mut().zip(source).for_each(|(x, a)| *x += sign * a);
        }
    }
    sketched
}

impl Pivoted {
    /// Makes the largest column the next one, and takes its direction out of those that follow; false if nothing is left.
    fn eliminate(&mut self, k: usize, least: f64) -> bool {
        let count = self.order.len();
        let Some(pivot) = (k..count).max_by(|&a, &b| self.rest[a][0].total_cmp(&self.rest[b][0])) else { return false };
        let mut v = self.matrix.col_as_slice(pivot)[k..].to_vec();
        let norm = squared(&v);
        if norm <= least {
            return false;
        }
        self.order.swap(k, pivot);
        self.rest.swap(k, pivot);
        for i in 0..self.matrix.nrows() {
            let (a, b) = (self.matrix[(i, k)], self.matrix[(i, pivot)]);
            (self.matrix[(i, k)], self.matrix[(i, pivot)]) = (b, a);
        }
        let diagonal = -norm.sqrt().copysign(v[0]);
        v[0] -= diagonal;
        let scale = 2.0 / squared(&v);
        for j in k + 1..count {
            let target = &mut self.matrix.col_as_slice_mut(j)[k..];
            let factor = scale * dot(&v, target);
            target.iter_mut().zip(&v).for_each(|(x, v)| *x -= factor * v);
            let [left, reference] = &mut self.rest[j];
            *left -= target[0] * target[0];
            if *left <= CANCELLED * *reference {
                *left = squared(&target[1..]);
                *reference = *left;
            }
        }
        self.matrix[(k, k)] = diagonal;
        true
    }

    /// The first `rank` chosen columns, and how the others are combined from them.
    fn skeleton(&self, rank: usize) -> Skeleton {
        let mut combination = Mat::zeros(rank, self.order.len());
        for (place, &column) in self.order.iter().enumerate() {
            if place < rank {
                combination[(place, column)] = 1.0;
                continue;
            }
            let mut x = self.matrix.col_as_slice(place)[..rank].to_vec();
            for i in (0..rank).rev() {
                let (rest, solved) = x.split_at_mut(i);
                solved[0] /= self.matrix[(i, i)];
                let above = self.matrix.col_as_slice(i);
                rest.iter_mut().zip(above).for_each(|(x, r)| *x -= r * solved[0]);
            }
            combination.col_as_slice_mut(column).copy_from_slice(&x);
        }
        Skeleton { columns: self.order[..rank].to_vec(), combination }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_of_a_smooth_kernel_are_combined_from_a_few() {
        let kernel = |i: usize, j: usize| 1.0 / (3.0 + i as f64 / 50.0 + j as f64 / 40.0);
        let matrix = Mat::from_fn(50, 40, kernel);
        let Skeleton { columns, combination } = skeleton(&matrix.transpose().to_owned(), 1e-12);
        assert!(columns.len() < 12, "{} columns", columns.len());
        let chosen = Mat::from_fn(50, columns.len(), |i, k| matrix[(i, columns[k])]);
        let off = (&chosen * &combination - &matrix).norm_max();
        assert!(off < 1e-12, "off by {off:e}");
    }

    #[test]
    fn a_matrix_of_zeros_has_one_column_in_its_skeleton() {
        let Skeleton { columns, combination } = skeleton(&Mat::zeros(3, 4), 1e-12);
        assert_eq!(columns.len(), 1);
        assert!(combination.norm_max() <= 1.0);
    }
}
