//! A solver's factor as flat arrays, for a worker's border, and back.
//!
//! What comes back is checked: `None` for arrays that no factor makes.

use super::Ordering;
use super::factor::Factor;
use super::pcg::Pcg;
use super::supernode::{Chunk, Chunks};

/// A [`Factor`] as flat arrays.
#[derive(Debug, Clone, PartialEq)]
pub struct FactorBuffers {
    /// The permutation, `new → old`.
    pub forward: Vec<u32>,
    /// Five numbers per chunk: column, width, rows, row count, values.
    pub chunks: Vec<u32>,
    /// The row lists.
    pub rows: Vec<u32>,
    /// The entries of L.
    pub values: Vec<f64>,
}

impl Factor {
    /// As flat arrays.
    pub fn to_buffers(&self) -> FactorBuffers {
        let chunks = self.chunks.list.iter().flat_map(|c| [c.column, c.width, c.rows, c.row_count, c.values]).collect();
        FactorBuffers {
            forward: self.ordering.forward.clone(),
            chunks,
            rows: self.chunks.rows.clone(),
            values: self.chunks.values.clone(),
        }
    }

    /// From flat arrays; `None` if they are not consistent.
    pub fn from_buffers(buffers: FactorBuffers) -> Option<Self> {
        let n = buffers.forward.len();
        let mut inverse = vec![u32::MAX; n];
        for (new, &old) in buffers.forward.iter().enumerate() {
            *inverse.get_mut(old as usize)? = new as u32;
        }
        let (records, rest) = buffers.chunks.as_chunks::<5>();
        let list: Vec<Chunk> = records
            .iter()
            .map(|&[column, width, rows, row_count, values]| Chunk { column, width, rows, row_count, values })
            .collect();
        let chunks = Chunks { list, rows: buffers.rows, values: buffers.values };
        let permuted = inverse.iter().all(|&new| new != u32::MAX);
        (rest.is_empty() && permuted && chunks.check_invariants(n))
            .then(|| Self::from_chunks(Ordering { forward: buffers.forward, inverse }, chunks))
    }
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
}
