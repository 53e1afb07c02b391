//! The numeric Cholesky factorisation, multifrontal (Duff & Reid 1983; Liu 1992).
//!
//! Each supernode s gathers its columns of L̂ and its children's update matrices
//! into a front, factors its w columns and passes the Schur complement to its
//! parent. The rows of a front are stored in tiles of four, the columns of a tile one
//! after the other, so that every step is arithmetic on `[f64; 4]`: it compiles to
//! SIMD both natively and on the web (faer's dense kernels, with the same
//! structure, are 2.3 times slower in wasm than natively). The pivots are padded
//! to whole tiles, so that a tile never holds pivots and update rows together.

use super::supernode::Chunks;
use super::unrolled::unrolled;
use super::{LaplaceError, Ordering};
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use sprs::CsMatI;

/// The number of rows of a tile, and of columns of a block of pivots.
pub(super) const TILE: usize = 4;

/// One column of a tile.
type Column = [f64; TILE];

/// The end of a list of supernodes.
const NONE: u32 = u32::MAX;

/// Factors P L̂ Pᵀ, whose factor has the given structure, into chunks; L̂ is given by its upper triangle.
pub(super) fn factor(
    structure: &SymbolicSupernodalCholesky<u32>,
    matrix: &CsMatI<f64, u32>,
    ordering: &Ordering,
) -> Result<Chunks, LaplaceError> {
    let children = Children::new(structure);
    let matrix = LowerColumns::permuted(matrix, ordering);
    let mut front = Front::default();
    let mut updates: Vec<Update> = vec![Update::default(); structure.n_supernodes()];
    let mut pool = Pool::new();
    let mut place = vec![0; ordering.forward.len()];
    let mut chunks = Chunks::with_capacity(structure.len_val());
    for s in 0..structure.n_supernodes() {
        let supernode = structure.supernode(s);
        let columns = structure.supernode_begin()[s]..structure.supernode_end()[s];
        front.begin(columns.clone(), supernode.pattern(), &mut place, &mut pool);
        front.add_matrix(columns.clone(), &matrix, &place);
        for child in children.of(s) {
            let update = std::mem::take(&mut updates[child]);
            front.add_update(&update, structure.supernode(child).pattern(), &place);
            pool.give_back(update.values);
        }
        front.factor().map_err(|pivot| LaplaceError::NotPositiveDefinite {
            vertex: ordering.forward[columns.start as usize + pivot] as usize,
        })?;
        front.subtract_square();
        chunks.push_supernode(columns, supernode.pattern(), &front.tiles, front.width.div_ceil(TILE));
        updates[s] = std::mem::take(&mut front.update);
    }
    Ok(chunks)
}

/// The lower triangle of P L̂ Pᵀ by columns, from L̂, of which the upper triangle is stored.
struct LowerColumns {
    starts: Vec<u32>,
    entries: Vec<(u32, f64)>,
}

impl LowerColumns {
    fn permuted(matrix: &CsMatI<f64, u32>, ordering: &Ordering) -> Self {
        let n = matrix.cols();
        let mut starts = vec![0; n + 1];
        let places = || {
            matrix.iter().map(|(&value, (i, j))| {
                let (i, j) = (ordering.inverse[i as usize], ordering.inverse[j as usize]);
                (i.max(j), i.min(j), value)
            })
        };
        for (_, column, _) in places() {
            starts[column as usize] += 1;
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        // filling each column from its end turns the ends into the starts
        let mut entries = vec![(0, 0.0); matrix.nnz()];
        for (row, column, value) in places() {
            starts[column as usize] -= 1;
            entries[starts[column as usize] as usize] = (row, value);
        }
        Self { starts, entries }
    }

    fn column(&self, column: usize) -> &[(u32, f64)] {
        &self.entries[self.starts[column] as usize..self.starts[column + 1] as usize]
    }
}

/// The supernodes' elimination tree: the children of each supernode.
struct Children {
    first: Vec<u32>,
    next: Vec<u32>,
}

impl Children {
    /// The parent of a supernode is the supernode that contains its first row below the pivots.
    fn new(structure: &SymbolicSupernodalCholesky<u32>) -> Self {
        let count = structure.n_supernodes();
        let (mut first, mut next) = (vec![NONE; count], vec![NONE; count]);
        for s in (0..count).rev() {
            if let Some(&row) = structure.supernode(s).pattern().first() {
                let parent = structure.supernode_end().partition_point(|&end| end <= row);
                next[s] = std::mem::replace(&mut first[parent], s as u32);
            }
        }
        Self { first, next }
    }

    fn of(&self, s: usize) -> impl Iterator<Item = usize> + '_ {
        let following = |&c: &u32| Some(self.next[c as usize]).filter(|&c| c != NONE);
        std::iter::successors(Some(self.first[s]).filter(|&c| c != NONE), following).map(|c| c as usize)
    }
}

/// The update of a supernode's ancestors, to be subtracted: the lower triangle of a square
/// matrix over its rows, by columns of length `stride`, a multiple of [`TILE`].
#[derive(Debug, Clone, Default)]
struct Update {
    stride: usize,
    /// At least stride² values; those above the diagonal tiles are meaningless.
    values: Vec<f64>,
}

impl Update {
    fn columns(&self) -> impl Iterator<Item = &[f64]> {
        self.values.chunks_exact(self.stride.max(1)).take(self.stride)
    }

    fn columns_mut(&mut self) -> impl Iterator<Item = &mut [f64]> {
        self.values.chunks_exact_mut(self.stride.max(1)).take(self.stride)
    }
}

/// Reusable storage of finished update matrices, by powers of two; touching fresh memory is slow.
#[derive(Debug)]
struct Pool {
    spare: [Vec<Vec<f64>>; usize::BITS as usize],
}

impl Pool {
    fn new() -> Self {
        Self { spare: std::array::from_fn(|_| Vec::new()) }
    }

    /// At least `size` values with arbitrary content.
    fn take(&mut self, size: usize) -> Vec<f64> {
        let class = size.next_power_of_two();
        self.spare[class.ilog2() as usize].pop().unwrap_or_else(|| vec![0.0; class])
    }

    fn give_back(&mut self, values: Vec<f64>) {
        if !values.is_empty() {
            self.spare[values.len().ilog2() as usize].push(values);
        }
    }
}

/// A supernode being factored.
#[derive(Debug, Default)]
struct Front {
    /// The number of pivots.
    width: usize,
    /// The supernode's columns of L: tile after tile, `width` columns each; first the tiles of the pivots.
    tiles: Vec<Column>,
    update: Update,
}

impl Front {
    /// An empty front over the given columns and rows; stores in `place` the position of each row.
    fn begin(&mut self, columns: std::ops::Range<u32>, rows: &[u32], place: &mut [u32], pool: &mut Pool) {
        let padded = columns.len().next_multiple_of(TILE);
        self.width = columns.len();
        let stride = rows.len().next_multiple_of(TILE);
        for (at, column) in columns.enumerate() {
            place[column as usize] = at as u32;
        }
        for (at, &row) in rows.iter().enumerate() {
            place[row as usize] = (padded + at) as u32;
        }
        self.tiles.clear();
        self.tiles.resize((padded + stride) / TILE * self.width, [0.0; TILE]);
        self.update = Update { stride, values: pool.take(stride * stride) };
        for (j, column) in self.update.columns_mut().enumerate() {
            column[j - j % TILE..].fill(0.0);
        }
    }

    /// Adds the entries of the matrix.
    fn add_matrix(&mut self, columns: std::ops::Range<u32>, matrix: &LowerColumns, place: &[u32]) {
        for (at, column) in columns.enumerate() {
            for &(row, value) in matrix.column(column as usize) {
                let row = place[row as usize] as usize;
                self.tiles[row / TILE * self.width + at][row % TILE] += value;
            }
        }
    }

    /// Adds a child's update matrix over `rows`.
    fn add_update(&mut self, child: &Update, rows: &[u32], place: &[u32]) {
        let padded = self.width.next_multiple_of(TILE);
        for (j, (&row_of_column, values)) in rows.iter().zip(child.columns()).enumerate() {
            let column = place[row_of_column as usize] as usize;
            let entries = rows[j..].iter().map(|&row| place[row as usize] as usize).zip(&values[j..]);
            if column < self.width {
                for (row, value) in entries {
                    self.tiles[row / TILE * self.width + column][row % TILE] += value;
                }
            } else {
                let target = &mut self.update.values[(column - padded) * self.update.stride..][..self.update.stride];
                for (row, value) in entries {
                    target[row - padded] += value;
                }
            }
        }
    }

    /// Factors the pivots' columns, a block of [`TILE`] columns at a time; the error is the first pivot that is not
    /// positive.
    fn factor(&mut self) -> Result<(), usize> {
        let width = self.width;
        for (block, start) in (0..width).step_by(TILE).enumerate() {
            let end = (start + TILE).min(width);
            let (above, rest) = self.tiles.split_at_mut((block + 1) * width);
            let pivots = &mut above[block * width..];
            let (done, diagonal) = pivots.split_at_mut(start);
            let diagonal = &mut diagonal[..end - start];
            subtract(diagonal, &product(done, done));
            let lower = cholesky(diagonal).map_err(|pivot| start + pivot)?;
            for tile in rest.chunks_exact_mut(width) {
                let (left, here) = tile.split_at_mut(start);
                let here = &mut here[..end - start];
                subtract(here, &product(left, done));
                solve(here, &lower);
            }
        }
        Ok(())
    }

    /// Subtracts L₂ L₂ᵀ, with L₂ the rows below the pivots, from the update matrix.
    fn subtract_square(&mut self) {
        let Update { stride, values } = &mut self.update;
        let below = &self.tiles[self.width.div_ceil(TILE) * self.width..];
        for (j, right) in below.chunks_exact(self.width).enumerate() {
            let columns = &mut values[j * TILE * *stride..][..TILE * *stride];
            for (i, left) in below.chunks_exact(self.width).enumerate().skip(j) {
                for (column, sum) in columns.chunks_exact_mut(*stride).zip(product(left, right)) {
                    if let Some(entries) = column[i * TILE..].first_chunk_mut() {
                        add_scaled(entries, &sum, -1.0);
                    }
                }
            }
        }
    }
}

/// `left rightᵀ` of two tiles, by columns.
#[inline]
fn product(left: &[Column], right: &[Column]) -> [Column; TILE] {
    let mut sum = [[0.0; TILE]; TILE];
    for (l, r) in left.iter().zip(right) {
        unrolled!(j < TILE => add_scaled(&mut sum[j], l, r[j]));
    }
    sum
}

fn subtract(columns: &mut [Column], product: &[Column; TILE]) {
    for (column, product) in columns.iter_mut().zip(product) {
        add_scaled(column, product, -1.0);
    }
}

/// `sum += column · factor`.
#[allow(clippy::inline_always, reason = "the innermost step")]
#[inline(always)]
fn add_scaled(sum: &mut Column, column: &Column, factor: f64) {
    unrolled!(i < TILE => sum[i] += column[i] * factor);
}

/// The Cholesky factor of a block of pivots, in place and returned by columns with
/// the reciprocal diagonal; the error is the first pivot that is not positive.
fn cholesky(block: &mut [Column]) -> Result<[Column; TILE], usize> {
    let mut lower = [[0.0; TILE]; TILE];
    for j in 0..block.len() {
        let mut column = block[j];
        for earlier in &block[..j] {
            for i in j..TILE {
                column[i] -= earlier[i] * earlier[j];
            }
        }
        let pivot = column[j];
        if pivot.is_nan() || pivot <= 0.0 {
            return Err(j);
        }
        let root = pivot.sqrt();
        let reciprocal = root.recip();
        column[j] = root;
        for entry in &mut column[j + 1..] {
            *entry *= reciprocal;
        }
        block[j] = column;
        lower[j] = column;
        lower[j][j] = reciprocal;
    }
    Ok(lower)
}

/// Solves `X Lᵀ = B` for a tile, in place.
#[inline]
fn solve(tile: &mut [Column], lower: &[Column; TILE]) {
    for j in 0..tile.len() {
        let mut column = tile[j];
        for (earlier, factor) in tile[..j].iter().zip(lower) {
            add_scaled(&mut column, earlier, -factor[j]);
        }
        tile[j] = column.map(|entry| entry * lower[j][j]);
    }
}
