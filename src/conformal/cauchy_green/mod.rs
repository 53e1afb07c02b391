//! The Cauchy–Green extension f̂(z) = Σ_k γ_k(z) w_k into a mesh: equations (7) and (15);
//! Weber, Ben-Chen, Gotsman, "Complex barycentric coordinates with applications to planar
//! shape deformation" (2009).
//!
//! f̂ is holomorphic inside the polygon. It does not interpolate: a linear interpolant is not
//! the boundary value of a holomorphic function. On the boundary f̂ is the limit from inside,
//! so the boundary vertices are mapped too, and may leave the other outline slightly.
//!
//! | file | content |
//! |---|---|
//! | `contour` | logarithms of an edge, γ_k(z), limits on the boundary |
//! | `values` | the images w_k, and f̂(z) in f64 without storing γ |
//! | `table` | rows of Γ in f32 and their product with w |

mod contour;
mod table;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
mod values;

pub use contour::Contour;
pub use values::BoundaryValues;

use super::MeshedDomain;
use crate::geometry::DVec2;
use rayon::prelude::*;
use std::ops::{ControlFlow, Range};
use std::sync::Arc;

/// The largest size of a stored Γ: a mesh of 90,000 vertices with 700 samples. A 32-bit address
/// space (the web) has to hold the rest of the page in 4 GiB too.
pub const STORED_BYTES: usize = if usize::BITS > 32 { 512 << 20 } else { 256 << 20 };

/// Terms (vertex × sample) between two checks of the clock: about 4 ms of building on one
/// thread, 0.5 ms of applying.
const CHUNK_TERMS: usize = 1 << 18;

/// Fewer terms than this (about 10 µs) do not justify a task of their own.
const LEAST_TERMS_PER_TASK: usize = 1 << 13;

/// Whether γ is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum CauchyGreenMode {
    /// Γ is stored in f32: one product per map. Images are within 1e-6 of the extent of the f64 ones.
    Stored,
    /// γ is computed for every map, in f64, and not stored.
    OnTheFly,
}

/// The Cauchy–Green coordinates of the vertices of a mesh.
///
/// Γ is built chunk by chunk, when a vertex is first evaluated. All results are
/// independent of the chunks and of the number of threads, bit for bit.
#[derive(Debug)]
pub struct CauchyGreen {
    domain: Arc<MeshedDomain>,
    contour: Contour,
    mode: CauchyGreenMode,
    /// Rows of Γ, [`Self::chunk_rows`] to a block, starting with vertex 0.
    blocks: Vec<Vec<f32>>,
}

impl CauchyGreen {
    /// The coordinates for the mesh of `domain`; stores Γ if that takes at most `budget_bytes`. Cost O(m).
    pub fn new(domain: Arc<MeshedDomain>, budget_bytes: usize) -> Self {
        let contour = Contour::new(domain.samples().points());
        let bytes = Self::estimate_bytes(contour.len(), domain.mesh().vertices().len());
        let mode = if bytes <= budget_bytes { CauchyGreenMode::Stored } else { CauchyGreenMode::OnTheFly };
        Self { domain, contour, mode, blocks: Vec::new() }
    }

    /// The memory for storing Γ with this number of vertices: 8 bytes per term.
    pub fn estimate_bytes(m: usize, vertices: usize) -> usize {
        vertices.saturating_mul(table::row_length(m).saturating_mul(size_of::<f32>()))
    }

    /// Whether Γ is stored.
    pub fn mode(&self) -> CauchyGreenMode {
        self.mode
    }

    /// The bytes that are stored so far.
    pub fn stored_bytes(&self) -> usize {
        self.blocks.iter().map(|block| size_of_val(block.as_slice())).sum()
    }

    /// The domain whose mesh is mapped.
    pub fn domain(&self) -> &Arc<MeshedDomain> {
        &self.domain
    }

    /// Vertices per chunk.
    fn chunk_rows(&self) -> usize {
        (CHUNK_TERMS / self.contour.len().max(1)).max(1)
    }

    /// Maps the vertices from `from` on, chunk by chunk, into `images` (length m+n), storing
    /// the rows of Γ that are not stored yet. After each chunk `go_on` is called with the
    /// completed fraction and may stop. Returns the first vertex that is not done.
    ///
    /// If the memory for Γ cannot be allocated, the stored rows are freed and the mode is
    /// [`CauchyGreenMode::OnTheFly`] from then on.
    pub fn advance(
        &mut self,
        from: usize,
        values: &BoundaryValues,
        images: &mut [DVec2],
        go_on: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> usize {
        let (count, rows) = (self.domain.mesh().vertices().len(), self.chunk_rows());
        let mut done = from;
        while done < count {
            let chunk = done..(done - done % rows + rows).min(count);
            if self.mode == CauchyGreenMode::Stored && self.store_up_to(chunk.end).is_none() {
                (self.mode, self.blocks) = (CauchyGreenMode::OnTheFly, Vec::new());
            }
            done = chunk.end;
            self.apply(chunk.clone(), values, &mut images[chunk]);
            if go_on(done as f64 / count as f64).is_break() {
                break;
            }
        }
        done
    }

    /// Maps a range of vertices: with stored rows if they exist, else in f64. `images` has the
    /// length of the range. The result depends on the arguments and the stored rows alone.
    pub fn apply(&self, vertices: Range<usize>, values: &BoundaryValues, images: &mut [DVec2]) {
        let (rows, length) = (self.chunk_rows(), table::row_length(self.contour.len()));
        let points = &self.domain.mesh().vertices()[vertices.clone()];
        let map = |(i, (image, &z)): (usize, (&mut DVec2, &DVec2))| {
            let vertex = vertices.start + i;
            *image = match self.blocks.get(vertex / rows) {
                Some(block) => table::apply_row(&block[vertex % rows * length..][..length], values),
                None => self.contour.evaluate(z, values),
            };
        };
        let least = LEAST_TERMS_PER_TASK / self.contour.len().max(1) + 1;
        images.par_iter_mut().zip(points).enumerate().with_min_len(least).for_each(map);
    }

    /// Builds the blocks of Γ before vertex `end`; `None` if memory cannot be allocated.
    fn store_up_to(&mut self, end: usize) -> Option<()> {
        let (rows, length) = (self.chunk_rows(), table::row_length(self.contour.len()));
        while self.blocks.len() * rows < end {
            let start = self.blocks.len() * rows;
            let points = &self.domain.mesh().vertices()[start..];
            let points = &points[..points.len().min(rows)];
            let mut block = Vec::new();
            block.try_reserve_exact(points.len() * length).ok()?;
            block.resize(points.len() * length, 0.0);
            let rows = block.par_chunks_exact_mut(length).zip(points);
            rows.for_each_init(Vec::new, |gamma, (row, &z)| table::fill_row(&self.contour, z, gamma, row));
            self.blocks.push(block);
        }
        Some(())
    }
}
