//! Conversion of a solver's factor to flat arrays, for the transfer between workers, and back.
//!
//! Arrays are checked when they are read: `None` if they are not a valid factor.

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
    /// Converts the factor to flat arrays.
    pub fn to_buffers(&self) -> FactorBuffers {
        let chunks = self.chunks.list.iter().flat_map(|c| [c.column, c.width, c.rows, c.row_count, c.values]).collect();
        FactorBuffers {
            forward: self.ordering.forward.clone(),
            chunks,
            rows: self.chunks.rows.clone(),
            values: self.chunks.values.clone(),
        }
    }

    /// The factor from flat arrays; `None` if they are not consistent.
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
    /// The index of the first entry of each row.
    pub starts: Vec<u32>,
    /// The column of each entry.
    pub columns: Vec<u32>,
    /// The entries of L̂.
    pub matrix: Vec<f64>,
    /// The entries of the incomplete factor.
    pub factor: Vec<f64>,
}

impl Pcg {
    /// Converts the solver to flat arrays.
    pub fn to_buffers(&self) -> PcgBuffers {
        let Self { starts, columns, matrix, factor } = self.clone();
        PcgBuffers { starts, columns, matrix, factor }
    }

    /// The solver from flat arrays; `None` if they are not consistent.
    pub fn from_buffers(buffers: PcgBuffers) -> Option<Self> {
        let PcgBuffers { starts, columns, matrix, factor } = buffers;
        let solver = Self { starts, columns, matrix, factor };
        solver.check_invariants().then_some(solver)
    }
}
