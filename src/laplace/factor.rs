//! The Cholesky factor L̂ = Pᵀ L Lᵀ P as flat arrays: its structure comes from faer, its entries from `multifrontal`.
//!
//! [`Factor::solve`] is pruned: its forward sweep visits only the root paths of
//! the right-hand side in the elimination tree, its backward sweep only the root
//! paths of the wanted unknowns. With three non-zero entries on the right and the
//! boundary's neighbours wanted, that is a small part of L.

use super::supernode::Chunks;
use super::{Deadline, DirichletLaplacian, Lanes, LaplaceError, Ordering, multifrontal};
use faer::Side;
use faer::perm::PermRef;
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};

/// Chunks between two checks of the deadline. The widest have 8 columns of some thousand rows:
/// 256 of them take about 5 ms; those of a small mesh take 20 µs, reading the clock 0.05 µs.
const BLOCK: usize = 256;

/// The parent of the root of the elimination tree.
const NO_PARENT: u32 = u32::MAX;

/// The Cholesky factor of L̂.
#[derive(Debug, Clone, PartialEq)]
pub struct Factor {
    pub(super) ordering: Ordering,
    pub(super) chunks: Chunks,
    /// The chunk of each (permuted) column.
    chunk_of: Vec<u32>,
    /// The elimination tree of the chunks.
    parent: Vec<u32>,
    everything: RootPaths,
}

/// A set of root paths in the elimination tree of a [`Factor`].
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RootPaths {
    /// The chunks on the paths, ascending.
    chunks: Vec<u32>,
    seen: Vec<bool>,
}

impl RootPaths {
    /// Empties the set and makes room for the chunks of another factor.
    fn clear(&mut self, count: usize) {
        for c in self.chunks.drain(..) {
            self.seen[c as usize] = false;
        }
        self.seen.resize(count, false);
        self.chunks.reserve(count); // the longest paths there can be: no allocation later
    }
}

impl Factor {
    /// Factors L̂ in the given ordering, within `budget_bytes` for the entries (the fronts temporarily
    /// take a fraction of that).
    /// Errors: [`LaplaceError::NotPositiveDefinite`], [`LaplaceError::TooLarge`].
    pub fn new(laplacian: &DirichletLaplacian, ordering: Ordering, budget_bytes: u64) -> Result<Self, LaplaceError> {
        let n = laplacian.interior.cols();
        if n == 0 {
            return Ok(Self::from_chunks(ordering, Chunks::default()));
        }
        let too_large = |bytes| LaplaceError::TooLarge { unknowns: n, bytes };
        let pointers = laplacian.interior.proper_indptr();
        let pattern = SymbolicSparseColMatRef::new_checked(n, n, &pointers, None, laplacian.interior.indices());
        let symbolic = factorize_symbolic_cholesky(
            pattern,
            Side::Upper,
            SymmetricOrdering::Custom(PermRef::new_checked(&ordering.forward, &ordering.inverse, n)),
            CholeskySymbolicParams {
                supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
                ..CholeskySymbolicParams::default()
            },
        )
        .map_err(|_| too_large(0))?;
        let SymbolicCholeskyRaw::Supernodal(structure) = symbolic.raw() else { return Err(too_large(0)) };
        let bytes = size_of::<f64>() as u64 * structure.len_val() as u64;
        // offsets are u32; a chunk's diagonal block is stored whole
        if bytes > budget_bytes || u32::try_from(structure.len_val() * 9 / 8 + 8 * structure.n_supernodes()).is_err() {
            return Err(too_large(bytes));
        }
        let chunks = multifrontal::factor(structure, &laplacian.interior, &ordering)?;
        Ok(Self::from_chunks(ordering, chunks))
    }

    pub(super) fn from_chunks(ordering: Ordering, chunks: Chunks) -> Self {
        debug_assert!(chunks.check_invariants(ordering.forward.len()));
        let mut chunk_of = vec![0; ordering.forward.len()];
        for (c, chunk) in chunks.list.iter().enumerate() {
            chunk_of[chunk.column as usize..][..chunk.width as usize].fill(c as u32);
        }
        let parent = chunks
            .list
            .iter()
            .map(
                |chunk| {
                    if chunk.row_count == 0 { NO_PARENT } else { chunk_of[chunks.rows[chunk.rows as usize] as usize] }
                },
            )
            .collect();
        let count = chunks.list.len();
        let everything = RootPaths { chunks: (0..count as u32).collect(), seen: vec![true; count] };
        Self { ordering, chunks, chunk_of, parent, everything }
    }

    /// The number of unknowns, `n`.
    #[cfg(test)]
    pub fn len(&self) -> usize {
        self.ordering.forward.len()
    }

    /// The position of an unknown in the vectors of [`Self::solve`].
    pub fn position(&self, unknown: u32) -> usize {
        self.ordering.inverse[unknown as usize] as usize
    }

    /// The unknown at each position.
    pub fn unknowns(&self) -> &[u32] {
        &self.ordering.forward
    }

    /// The whole tree: the argument of [`Self::solve`] if every unknown is wanted.
    pub fn everything(&self) -> &RootPaths {
        &self.everything
    }

    /// Collects into `paths` the paths from the `unknowns` to the root. Cost: their length.
    pub fn root_paths(&self, unknowns: impl IntoIterator<Item = u32>, paths: &mut RootPaths) {
        paths.clear(self.parent.len());
        for unknown in unknowns {
            let mut c = self.chunk_of[self.position(unknown)];
            while c != NO_PARENT && !std::mem::replace(&mut paths.seen[c as usize], true) {
                paths.chunks.push(c);
                c = self.parent[c as usize];
            }
        }
        paths.chunks.sort_unstable();
    }

    /// Solves L̂ x = b in place. `x` is ordered by [`Self::position`]; on entry it
    /// holds b, which is zero outside the unknowns of `given`; on exit it holds the
    /// solution at the unknowns on the paths of `wanted` (elsewhere, scratch).
    pub fn solve<const K: usize>(&self, given: &RootPaths, wanted: &RootPaths, x: &mut [Lanes<K>]) {
        self.chunks.forward(&given.chunks, x);
        self.chunks.backward(&wanted.chunks, x);
    }

    /// Continues [`Self::solve`] until it is complete (true) or `deadline` has passed; processes at least one block
    /// of chunks. `visited` counts the processed chunks and is 0 at the start; the other
    /// arguments must not change until the end. The solution is bit-identical to that of [`Self::solve`].
    pub(super) fn advance<const K: usize>(
        &self,
        visited: &mut usize,
        [given, wanted]: [&RootPaths; 2],
        x: &mut [Lanes<K>],
        deadline: Deadline,
    ) -> bool {
        let (up, down) = (given.chunks.len(), wanted.chunks.len());
        while *visited < up + down {
            if *visited < up {
                let next = (*visited + BLOCK).min(up);
                self.chunks.forward(&given.chunks[*visited..next], x);
                *visited = next;
            } else {
                let left = up + down - *visited;
                let next = left.saturating_sub(BLOCK);
                self.chunks.backward(&wanted.chunks[next..left], x);
                *visited += left - next;
            }
            if *visited < up + down && deadline.is_over() {
                return false;
            }
        }
        true
    }
}
