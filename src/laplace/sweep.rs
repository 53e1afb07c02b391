//! Triangular sweeps through the chunks of a factor, one or two right-hand sides at once.
//!
//! `Lanes<K>` interleaves K right-hand sides: each entry of L is loaded once for K
//! multiply-adds. Sums of numbers of one sign keep that sign: for an M-matrix
//! and a non-negative right-hand side no step cancels, so the solution is
//! accurate componentwise, down to the smallest normal numbers.

use super::supernode::{Chunk, Chunks};
use super::unrolled::unrolled;

/// The values of K right-hand sides at one unknown.
pub type Lanes<const K: usize> = [f64; K];

impl Chunks {
    /// Solves `L y = b` on the chunks in `visit` (ascending), in place.
    pub(super) fn forward<const K: usize>(&self, visit: &[u32], x: &mut [Lanes<K>]) {
        for &c in visit {
            let chunk = self.list[c as usize];
            match chunk.width {
                8 => self.forward_chunk::<8, K>(chunk, x),
                4 => self.forward_chunk::<4, K>(chunk, x),
                2 => self.forward_chunk::<2, K>(chunk, x),
                _ => self.forward_chunk::<1, K>(chunk, x),
            }
        }
    }

    /// Solves `Lᵀ x = y` on the chunks in `visit` (ascending; they are processed in reverse), in place.
    pub(super) fn backward<const K: usize>(&self, visit: &[u32], x: &mut [Lanes<K>]) {
        for &c in visit.iter().rev() {
            let chunk = self.list[c as usize];
            match chunk.width {
                8 => self.backward_chunk::<8, K>(chunk, x),
                4 => self.backward_chunk::<4, K>(chunk, x),
                2 => self.backward_chunk::<2, K>(chunk, x),
                _ => self.backward_chunk::<1, K>(chunk, x),
            }
        }
    }

    /// The chunk's row indices, its diagonal block and its rows below.
    fn parts<const W: usize>(&self, chunk: Chunk) -> (&[u32], &[[f64; W]], &[[f64; W]]) {
        let count = chunk.row_count as usize;
        let rows = &self.rows[chunk.rows as usize..][..count];
        let (values, _) = self.values[chunk.values as usize..][..(W + count) * W].as_chunks::<W>();
        let (diagonal, below) = values.split_at(W);
        (rows, diagonal, below)
    }

    fn forward_chunk<const W: usize, const K: usize>(&self, chunk: Chunk, x: &mut [Lanes<K>]) {
        let (rows, diagonal, below) = self.parts::<W>(chunk);
        let column = chunk.column as usize;
        let mut y = [[0.0; K]; W];
        for i in 0..W {
            let mut sum = x[column + i];
            for j in 0..i {
                subtract(&mut sum, diagonal[i][j], &y[j]);
            }
            y[i] = sum.map(|s| s * diagonal[i][i]);
            x[column + i] = y[i];
        }
        for (row, entries) in rows.iter().zip(below) {
            let target = &mut x[*row as usize];
            let mut sum = *target;
            unrolled!(j < W => subtract(&mut sum, entries[j], &y[j]));
            *target = sum;
        }
    }

    fn backward_chunk<const W: usize, const K: usize>(&self, chunk: Chunk, x: &mut [Lanes<K>]) {
        let (rows, diagonal, below) = self.parts::<W>(chunk);
        let column = chunk.column as usize;
        let mut y: [Lanes<K>; W] = std::array::from_fn(|i| x[column + i]);
        for (row, entries) in rows.iter().zip(below) {
            let value = &x[*row as usize];
            unrolled!(j < W => subtract(&mut y[j], entries[j], value));
        }
        for i in (0..W).rev() {
            for j in i + 1..W {
                let solved = y[j];
                subtract(&mut y[i], diagonal[j][i], &solved);
            }
            y[i] = y[i].map(|s| s * diagonal[i][i]);
            x[column + i] = y[i];
        }
    }
}

/// `sum −= entry · value`, lane by lane.
#[allow(clippy::inline_always, reason = "the innermost step: a call here costs a factor of two")]
#[inline(always)]
fn subtract<const K: usize>(sum: &mut Lanes<K>, entry: f64, value: &Lanes<K>) {
    const { assert!(K <= 8) };
    unrolled!(lane < K => sum[lane] -= entry * value[lane]);
}
