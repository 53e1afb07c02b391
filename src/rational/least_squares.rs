//! The smallest right singular vector of a matrix that grows by columns, and least squares with it.
//!
//! A thin QR factorization is extended by modified Gram–Schmidt with reorthogonalization, whose loss of orthogonality
//! is that of Householder's (Giraud, Langou and Rozložník 2005), and which reads each column once a round; the vector
//! comes from inverse iteration with Rᴴ R, whose condition is that of the matrix, not of its square. O(m n) for a
//! column, O(n²) for a vector.

use num_complex::Complex64;

/// Most rounds of inverse iteration. The error falls by (σ_n/σ_{n−1})² a round; where both are alike, any vector of
/// their space has almost the least residual.
const MOST_ROUNDS: usize = 20;
/// A change of direction, squared, at which inverse iteration ends.
const SETTLED: f64 = 1e-12;
/// The least pivot, in largest ones.
const LEAST_PIVOT: f64 = 1e-300;

/// An m×n matrix in factored form.
#[derive(Debug, Clone, Default)]
pub struct GrowingQr {
    /// Orthonormal columns.
    q: Vec<Vec<Complex64>>,
    /// The columns of R, up to the diagonal.
    r: Vec<Vec<Complex64>>,
}

/// Σ conj(a) b.
fn dot(a: &[Complex64], b: &[Complex64]) -> Complex64 {
    let (mut re, mut im) = (0.0, 0.0);
    for (a, b) in a.iter().zip(b) {
        re += a.re * b.re + a.im * b.im;
        im += a.re * b.im - a.im * b.re;
    }
    Complex64::new(re, im)
}

fn norm(a: &[Complex64]) -> f64 {
    a.iter().map(Complex64::norm_sqr).sum::<f64>().sqrt()
}

impl GrowingQr {
    /// Appends a column, of the same length as the others.
    pub fn push(&mut self, mut column: Vec<Complex64>) {
        let mut coefficients = vec![Complex64::ZERO; self.q.len()];
        for _ in 0..2 {
            for (q, coefficient) in self.q.iter().zip(&mut coefficients) {
                let part = dot(q, &column);
                column.iter_mut().zip(q).for_each(|(value, q)| *value -= part * q);
                *coefficient += part;
            }
        }
        let length = norm(&column);
        coefficients.push(length.into());
        if length > 0.0 {
            divide(&mut column, length);
        }
        self.q.push(column);
        self.r.push(coefficients);
    }

    /// Keeps the first columns.
    pub fn truncate(&mut self, columns: usize) {
        self.q.truncate(columns);
        self.r.truncate(columns);
    }

    /// The unit vector x with the least |A x|; empty for a matrix without columns.
    pub fn smallest(&self) -> Vec<Complex64> {
        let n = self.r.len();
        let largest = (0..n).map(|k| self.r[k][k].re).fold(0.0, f64::max);
        let least = (f64::EPSILON * f64::EPSILON * largest).max(LEAST_PIVOT);
        let pivots: Vec<f64> = (0..n).map(|k| self.r[k][k].re.max(least)).collect();
        let mut x = vec![Complex64::ONE; n];
        scale(&mut x);
        for _ in 0..MOST_ROUNDS {
            let mut next = x.clone();
            self.solve_conjugate(&pivots, &mut next);
            scale(&mut next);
            self.solve(&pivots, &mut next);
            scale(&mut next);
            let cosine = dot(&x, &next).norm_sqr();
            x = next;
            if 1.0 - cosine < SETTLED {
                break;
            }
        }
        x
    }

    /// The x with the least |A x − b| for the last column b and the matrix A of the columns before it; a dependent column
    /// counts as if its pivot were the least one.
    pub fn least_squares(&self) -> Vec<Complex64> {
        let Some((last, columns)) = self.r.split_last() else { return Vec::new() };
        let largest = (0..columns.len()).map(|k| columns[k][k].re).fold(0.0, f64::max);
        let least = (f64::EPSILON * largest).max(LEAST_PIVOT);
        let pivots: Vec<f64> = (0..columns.len()).map(|k| columns[k][k].re.max(least)).collect();
        let mut x = last[..columns.len()].to_vec();
        self.solve(&pivots, &mut x);
        x
    }

    /// x ← R⁻ᴴ x.
    fn solve_conjugate(&self, pivots: &[f64], x: &mut [Complex64]) {
        for k in 0..x.len() {
            let known = dot(&self.r[k][..k], &x[..k]);
            x[k] = (x[k] - known) / pivots[k];
        }
    }

    /// x ← R⁻¹ x.
    fn solve(&self, pivots: &[f64], x: &mut [Complex64]) {
        for k in (0..x.len()).rev() {
            let value = x[k] / pivots[k];
            x[k] = value;
            x[..k].iter_mut().zip(&self.r[k]).for_each(|(x, r)| *x -= value * r);
        }
    }
}

fn divide(x: &mut [Complex64], by: f64) {
    for x in x {
        *x /= by;
    }
}

/// Scales to length 1, first by the largest part, so that no square overflows.
fn scale(x: &mut [Complex64]) {
    let largest = x.iter().fold(0.0, |most: f64, x| most.max(x.re.abs()).max(x.im.abs()));
    if largest > 0.0 && largest.is_finite() {
        divide(x, largest);
        let length = norm(x);
        divide(x, length);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_singular_vector_is_found_although_it_is_1e_13_of_the_largest() {
        // A = U diag(1, 1e-3, 1e-13) Vᴴ with U from three orthogonal columns, V a complex reflection
        let v = [Complex64::new(0.5, 0.1), Complex64::new(-0.3, 0.6), Complex64::new(0.2, -0.5)];
        let length = dot(&v, &v).re;
        let reflection = |i: usize, k: usize| {
            let unit = if i == k { Complex64::ONE } else { Complex64::ZERO };
            unit - 2.0 * v[i] * v[k].conj() / length
        };
        let u = |row: usize, k: usize| (std::f64::consts::PI * (row as f64 + 0.5) * k as f64 / 50.0).cos();
        let singular = [1.0, 1e-3, 1e-13];
        let mut qr = GrowingQr::default();
        for column in 0..3 {
            let entry = |row: usize| (0..3).map(|k| reflection(column, k).conj() * u(row, k) * singular[k]).sum();
            qr.push((0..50).map(entry).collect());
        }
        let found = qr.smallest();
        let exact: Vec<Complex64> = (0..3).map(|i| reflection(i, 2)).collect();
        let off = 1.0 - dot(&found, &exact).norm();
        assert!(off.abs() < 1e-6, "1 − cos = {off:e}");
    }

    #[test]
    fn a_dependent_column_gives_the_vector_of_the_null_space() {
        let mut qr = GrowingQr::default();
        let column: Vec<Complex64> = (0..9).map(|k| Complex64::new(1.0 + f64::from(k), f64::from(k * k))).collect();
        qr.push(column.clone());
        qr.push(column);
        let x = qr.smallest();
        assert!((x[0] + x[1]).norm() < 1e-12 && (x[0].norm() - 0.5_f64.sqrt()).abs() < 1e-12, "{x:?}");
    }
}
