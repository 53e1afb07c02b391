//! The numbers of a flattened surface's vertices in its file, counted from 0, and the file's texture coordinates.
//!
//! The reader may have merged vertices of the file, and a repair others at the same place: a flattened vertex has the number
//! of the first vertex of the file that became it, and all of these have its coordinates.

use crate::export::Flattened;
use crate::surface::Surface;

/// The numbers of vertices.
pub(in crate::export) struct Numbers<'a> {
    surface: &'a Surface,
    /// For each vertex of the surface the first one of the file that became it.
    first: Vec<u32>,
}

impl<'a> Numbers<'a> {
    pub(in crate::export) fn new(surface: &'a Surface) -> Self {
        let mut first = vec![u32::MAX; surface.vertices().len()];
        for number in (0..surface.count_in_file() as u32).rev() {
            if let Some(vertex) = surface.vertex_in_file(number) {
                first[vertex as usize] = number;
            }
        }
        Self { surface, first }
    }

    /// The number of a flattened vertex; those that are not of the surface follow the file's.
    pub(in crate::export) fn of(&self, vertex: u32) -> u32 {
        let added = |beyond: u32| self.surface.count_in_file() as u32 + beyond;
        self.first.get(vertex as usize).copied().unwrap_or_else(|| added(vertex - self.first.len() as u32))
    }

    /// Whether a flattened vertex is not of the surface.
    pub(super) fn is_added(&self, vertex: u32) -> bool {
        vertex as usize >= self.first.len()
    }

    /// What belongs to the vertices of the file, then to the added ones; `None` for vertices that were left out. `own` is what
    /// belongs to the flattened vertices.
    pub(in crate::export) fn spread<T: Copy>(&self, own: &[Option<T>]) -> Vec<Option<T>> {
        let in_file = (0..self.surface.count_in_file() as u32).map(|number| self.surface.vertex_in_file(number));
        let in_file = in_file.map(|vertex| own.get(vertex? as usize).copied().flatten());
        in_file.chain(own.iter().skip(self.first.len()).copied()).collect()
    }

    /// The number of vertices that are not of the surface.
    pub(super) fn added_count(&self, flattened: &Flattened) -> usize {
        flattened.vertices().len() - self.first.len()
    }
}
