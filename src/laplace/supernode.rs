//! The factor's layout: supernodes cut into narrow row-major chunks.
//!
//! A supernode is a run of columns of L with the same rows below them. It is cut
//! into chunks of 8, 4, 2 or 1 columns; a chunk stores its rows one after the
//! other, so that a sweep reads L once, in order, whatever the number of
//! right-hand sides. All chunks of a supernode share one list of row indices.

use super::{LaplaceError, Ordering};
use faer::sparse::linalg::cholesky::supernodal::SupernodalLltRef;

/// The widths that the sweeps are compiled for, largest first.
pub(super) const WIDTHS: [u32; 4] = [8, 4, 2, 1];

/// `width` consecutive columns of L.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Chunk {
    /// The first column.
    pub column: u32,
    /// How many, one of [`WIDTHS`].
    pub width: u32,
    /// Where its rows below the diagonal block start in the row list.
    pub rows: u32,
    /// How many rows there are.
    pub row_count: u32,
    /// Where its values start: the width×width lower triangle (row-major, whole,
    /// with the reciprocal diagonal), then the rows.
    pub values: u32,
}

/// All chunks in ascending order of columns, with their rows and values.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Chunks {
    pub list: Vec<Chunk>,
    pub rows: Vec<u32>,
    pub values: Vec<f64>,
}

impl Chunks {
    /// Copies faer's supernodal factor.
    pub fn from_supernodes(factor: SupernodalLltRef<'_, u32, f64>, ordering: &Ordering) -> Result<Self, LaplaceError> {
        let too_large = || LaplaceError::TooLarge { unknowns: ordering.forward.len() };
        let count = factor.symbolic().n_supernodes();
        if u32::try_from(factor.values().len() * 9 / 8 + 8 * count).is_err() {
            return Err(too_large()); // offsets are u32
        }
        let mut chunks = Self::default();
        chunks.values.reserve(factor.values().len());
        for s in 0..count {
            chunks.push_supernode(factor, s);
        }
        Ok(chunks)
    }

    /// Whether the chunks tile the columns `0..n` and stay inside their arrays, rows below columns.
    pub fn check_invariants(&self, n: usize) -> bool {
        let mut next = 0;
        let sound = self.list.iter().all(|chunk| {
            let (width, count) = (chunk.width as usize, chunk.row_count as usize);
            let end = chunk.column as usize + width;
            let in_order = std::mem::replace(&mut next, end) == chunk.column as usize;
            let rows = self.rows.get(chunk.rows as usize..).and_then(|rows| rows.get(..count));
            let values = self.values.len().checked_sub(chunk.values as usize);
            in_order
                && WIDTHS.contains(&chunk.width)
                && rows.is_some_and(|rows| rows.iter().all(|&r| (end..n).contains(&(r as usize))))
                && values.is_some_and(|left| left >= (width + count) * width)
        });
        sound && next == n
    }

    fn push_supernode(&mut self, factor: SupernodalLltRef<'_, u32, f64>, s: usize) {
        let supernode = factor.supernode(s);
        let (start, columns) = (supernode.start(), supernode.val().ncols());
        let first_row = self.rows.len();
        self.rows.extend((start..start + columns).map(|c| c as u32));
        self.rows.extend_from_slice(supernode.pattern());
        let rows_in_all = supernode.val().nrows();
        let start_of_values = factor.symbolic().col_ptr_for_val()[s] as usize;
        let block = &factor.values()[start_of_values..][..rows_in_all * columns];
        let mut offset = 0;
        while offset < columns {
            let width = WIDTHS.into_iter().find(|&w| offset + w as usize <= columns).unwrap_or(1) as usize;
            self.list.push(Chunk {
                column: (start + offset) as u32,
                width: width as u32,
                rows: (first_row + offset + width) as u32,
                row_count: (self.rows.len() - first_row - offset - width) as u32,
                values: self.values.len() as u32,
            });
            match width {
                8 => self.push_rows::<8>(block, rows_in_all, offset),
                4 => self.push_rows::<4>(block, rows_in_all, offset),
                2 => self.push_rows::<2>(block, rows_in_all, offset),
                _ => self.push_rows::<1>(block, rows_in_all, offset),
            }
            offset += width;
        }
    }

    /// Appends W columns of a column-major block (of `rows` rows), from row and column `offset` on, row by row.
    fn push_rows<const W: usize>(&mut self, block: &[f64], rows: usize, offset: usize) {
        let first = self.values.len();
        let columns: [&[f64]; W] =
            std::array::from_fn(|j| &block[(offset + j) * rows + offset..(offset + j + 1) * rows]);
        for row in 0..rows - offset {
            self.values.extend(columns.map(|column| column[row]));
        }
        for (i, row) in self.values[first..][..W * W].chunks_exact_mut(W).enumerate() {
            row[i] = row[i].recip();
            row[i + 1..].fill(0.0);
        }
    }
}
