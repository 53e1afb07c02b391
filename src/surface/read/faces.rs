//! Collects vertices and faces; cuts polygons into triangles after all vertices are read.

use super::polygon::triangulate;
use super::{MAX_TRIANGLES, Place, SurfaceError};
use crate::geometry::DVec3;
use crate::surface::{Surface, SurfaceNote};

/// The index, checked to be one of `vertices` vertices.
pub(super) fn vertex_of(index: i64, vertices: usize, place: impl Fn() -> Place) -> Result<u32, SurfaceError> {
    let vertex = u32::try_from(index).ok().filter(|&vertex| (vertex as usize) < vertices);
    vertex.ok_or_else(|| SurfaceError::IndexOutOfRange { place: place(), index, vertices })
}

/// The vertices and faces read so far.
#[derive(Debug, Default)]
pub(super) struct Faces {
    pub vertices: Vec<DVec3>,
    corners: Vec<u32>,
    /// Where each face ends in `corners`.
    ends: Vec<u32>,
    triangles: usize,
    /// The number of faces with fewer than three corners, which are dropped.
    dropped: usize,
    /// Where the file continues after everything that its counts announce.
    pub surplus: Option<Place>,
}

impl Faces {
    /// Adds a face; its indices are checked by the caller. One with fewer than three corners is dropped.
    pub(super) fn push(&mut self, corners: &[u32], place: impl Fn() -> Place) -> Result<(), SurfaceError> {
        if corners.len() < 3 {
            self.dropped += 1;
            return Ok(());
        }
        self.triangles += corners.len() - 2;
        if self.triangles > MAX_TRIANGLES {
            return Err(SurfaceError::TooManyTriangles { place: place() });
        }
        self.corners.extend_from_slice(corners);
        self.ends.push(self.corners.len() as u32);
        Ok(())
    }

    /// Adds the triangles of a strip: each corner after the first two makes one with the two before it, which are turned
    /// alternately. A strip repeats corners to go on elsewhere; such triangles are no faces.
    pub(super) fn push_strip(&mut self, strip: &[u32], place: impl Fn() -> Place) -> Result<(), SurfaceError> {
        for (k, &[a, b, c]) in strip.array_windows().enumerate() {
            if a != b && b != c && c != a {
                self.push(&if k.is_multiple_of(2) { [a, b, c] } else { [b, a, c] }, &place)?;
            }
        }
        Ok(())
    }

    /// The surface, with polygons cut into triangles.
    pub(super) fn finish(self) -> Surface {
        let Self { vertices, corners, ends, triangles: count, dropped, surplus } = self;
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
        let notes = cut.into_iter().chain(dropped).chain(surplus).collect();
        Surface::new(vertices, triangles).with_notes(notes)
    }
}
