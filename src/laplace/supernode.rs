//! The factor's layout: supernodes cut into narrow row-major chunks.
//!
//! A supernode is a run of columns of L with the same rows below them. It is cut
//! into chunks of 8, 4, 2 or 1 columns; a chunk stores its rows one after the
//! other, so that a sweep reads L once, in order, whatever the number of
//! right-hand sides. All chunks of a supernode share one list of row indices.

use super::multifrontal::TILE;

/// The widths that the sweeps are compiled for, largest first.
pub(super) const WIDTHS: [u32; 4] = [8, 4, 2, 1];

/// `width` consecutive columns of L.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Chunk {
    /// The first column.
    pub column: u32,
    /// The number of columns, one of [`WIDTHS`].
    pub width: u32,
    /// The index of its rows below the diagonal block in the row list.
    pub rows: u32,
    /// The number of these rows.
    pub row_count: u32,
    /// The index of its values: the width×width lower triangle (row-major, stored as a full square,
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
    /// No chunks, with capacity for about `values` entries.
    pub fn with_capacity(values: usize) -> Self {
        Self { values: Vec::with_capacity(values), ..Self::default() }
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

    /// Appends the columns of a supernode: in tiles of four rows, each with all its
    /// columns; the first `pivot_tiles` hold the diagonal block, the others the `rows` below.
    pub fn push_supernode(
        &mut self,
        columns: std::ops::Range<u32>,
        rows: &[u32],
        tiles: &[[f64; TILE]],
        pivot_tiles: usize,
    ) {
        let block = Block { tiles, pivot_tiles, columns: columns.len(), rows: rows.len() };
        let first_row = self.rows.len();
        self.rows.extend(columns.clone());
        self.rows.extend_from_slice(rows);
        let mut offset = 0;
        while offset < columns.len() {
            let width = WIDTHS.into_iter().find(|&w| offset + w as usize <= columns.len()).unwrap_or(1) as usize;
            self.list.push(Chunk {
                column: columns.start + offset as u32,
                width: width as u32,
                rows: (first_row + offset + width) as u32,
                row_count: (self.rows.len() - first_row - offset - width) as u32,
                values: self.values.len() as u32,
            });
            match width {
                8 => self.push_rows::<8>(block, offset),
                4 => self.push_rows::<4>(block, offset),
                2 => self.push_rows::<2>(block, offset),
                _ => self.push_rows::<1>(block, offset),
            }
            offset += width;
        }
    }

    /// Appends W columns of a block, starting at row and column `offset`, row by row.
    fn push_rows<const W: usize>(&mut self, block: Block<'_>, offset: usize) {
        let first = self.values.len();
        let (pivots, below) = block.tiles.split_at(block.pivot_tiles * block.columns);
        for (tiles, rows) in [(pivots, offset..block.columns), (below, 0..block.rows)] {
            for row in rows {
                let tile = &tiles[row / TILE * block.columns + offset..][..W];
                self.values.extend(tile.iter().map(|column| column[row % TILE]));
            }
        }
        for (i, row) in self.values[first..][..W * W].chunks_exact_mut(W).enumerate() {
            row[i] = row[i].recip();
            row[i + 1..].fill(0.0);
        }
    }
}

/// The columns of a supernode in tiles.
#[derive(Clone, Copy)]
struct Block<'a> {
    tiles: &'a [[f64; TILE]],
    pivot_tiles: usize,
    columns: usize,
    rows: usize,
}
