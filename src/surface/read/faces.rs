//! Collects vertices and faces; cuts polygons into triangles after all vertices are read.

use super::memory::{ALWAYS, BYTES_PER_TRIANGLE, BYTES_PER_VERTEX, available};
use super::polygon::triangulate;
use super::{Place, SurfaceError};
use crate::geometry::DVec3;
use crate::surface::{Surface, SurfaceNote};

/// The index, checked to be one of `vertices` vertices.
pub(super) fn vertex_of(index: i64, vertices: usize, place: impl Fn() -> Place) -> Result<u32, SurfaceError> {
    let vertex = u32::try_from(index).ok().filter(|&vertex| (vertex as usize) < vertices);
    vertex.ok_or_else(|| SurfaceError::IndexOutOfRange { place: place(), index, vertices })
}

/// The corners without those that are the same as the one before, around the polygon.
pub(crate) fn distinct(corners: &[u32]) -> Vec<u32> {
    let mut distinct = corners.to_vec();
    distinct.dedup();
    while distinct.len() > 1 && distinct.first() == distinct.last() {
        distinct.pop();
    }
    distinct
}

/// The vertices and faces read so far.
#[derive(Debug, Default)]
pub(super) struct Faces {
    pub vertices: Vec<DVec3>,
    corners: Vec<u32>,
    /// Where each face ends in `corners`.
    ends: Vec<u32>,
    triangles: usize,
    /// The bytes that the surface may take, once that matters.
    available: Option<u64>,
    /// The number of faces with fewer than three corners, which are dropped.
    dropped: usize,
    /// Whether the line that ends the surface is missing.
    pub is_unended: bool,
    /// Where the file continues after everything that its counts announce.
    pub surplus: Option<Place>,
}

impl Faces {
    /// Adds a face; its indices are checked by the caller. One with fewer than three corners is dropped. A polygon's corners
    /// that repeat the one before are left out. What does not fit into memory is only counted.
    pub(super) fn push(&mut self, corners: &[u32]) {
        if corners.len() > 3 && (corners.first() == corners.last() || corners.windows(2).any(|pair| pair[0] == pair[1]))
        {
            self.push_distinct(&distinct(corners));
        } else {
            self.push_distinct(corners);
        }
    }

    fn push_distinct(&mut self, corners: &[u32]) {
        if corners.len() < 3 {
            self.dropped += 1;
            return;
        }
        self.triangles += corners.len() - 2;
        if self.fits() {
            self.corners.extend_from_slice(corners);
            self.ends.push(self.corners.len() as u32);
        }
    }

    /// The bytes that the surface and its map take.
    fn needed(&self) -> u64 {
        (BYTES_PER_TRIANGLE * self.triangles as u64).max(BYTES_PER_VERTEX * self.vertices.len() as u64)
    }

    fn fits(&mut self) -> bool {
        let needed = self.needed();
        needed <= ALWAYS || needed <= *self.available.get_or_insert_with(available)
    }

    /// Checks that what was added fits into memory.
    pub(super) fn check_memory(&mut self) -> Result<(), SurfaceError> {
        if self.fits() {
            return Ok(());
        }
        let megabytes = |bytes: u64| (bytes / 1_000_000) as usize;
        Err(SurfaceError::TooMuchMemory {
            triangles: self.triangles,
            vertices: self.vertices.len(),
            needed_mb: megabytes(self.needed()),
            available_mb: megabytes(self.available.unwrap_or_default()),
        })
    }

    /// Adds the triangles of a strip: each corner after the first two makes one with the two before it, which are turned
    /// alternately. A strip repeats corners to go on elsewhere; such triangles are no faces.
    pub(super) fn push_strip(&mut self, strip: &[u32]) {
        for (k, &[a, b, c]) in strip.array_windows().enumerate() {
            if a != b && b != c && c != a {
                self.push(&if k.is_multiple_of(2) { [a, b, c] } else { [b, a, c] });
            }
        }
    }

    /// The surface, with polygons cut into triangles. Errors: it does not fit into memory.
    pub(super) fn finish(mut self) -> Result<Surface, SurfaceError> {
        self.check_memory()?;
        let Self { vertices, corners, ends, triangles: count, dropped, is_unended, surplus, .. } = self;
        let (faces, mut triangles, mut polygons, mut start) = (ends.len(), Vec::with_capacity(count), 0, 0);
        for end in ends {
            match &corners[start..end as usize] {
                &[a, b, c] => triangles.push([a, b, c]),
                polygon => {
                    polygons += 1;
                    triangulate(&vertices, polygon, &mut triangles);
                }
            }
            start = end as usize;
        }
        let cut = (polygons > 0).then_some(SurfaceNote::Triangulated { polygons, faces });
        let dropped = (dropped > 0).then_some(SurfaceNote::DroppedFaces { count: dropped });
        let surplus = surplus.map(|place| SurfaceNote::Surplus { place });
        let unended = is_unended.then_some(SurfaceNote::Unended);
        let notes = cut.into_iter().chain(dropped).chain(unended).chain(surplus).collect();
        Ok(Surface::new(vertices, triangles).with_notes(notes))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_into_memory_is_counted_and_refused_with_the_numbers() {
        let with =
            |available: u64| Faces { vertices: vec![DVec3::ZERO; 3], available: Some(available), ..Faces::default() };
        let mut few = with(0);
        (0..1_000_000).for_each(|_| few.push(&[0, 1, 2]));
        assert_eq!(few.finish().map(|surface| surface.triangles().len()), Ok(1_000_000));
        let mut many = with(700_000_000);
        (0..1_200_000).for_each(|_| many.push(&[0, 1, 2]));
        assert!(many.ends.len() < 1_200_000);
        let expected =
            SurfaceError::TooMuchMemory { triangles: 1_200_000, vertices: 3, needed_mb: 720, available_mb: 700 };
        assert_eq!(many.finish(), Err(expected));
        let mut points = with(700_000_000);
        points.vertices = vec![DVec3::ZERO; 30_000_000];
        assert!(matches!(points.check_memory(), Err(SurfaceError::TooMuchMemory { needed_mb: 720, .. })));
    }
}
