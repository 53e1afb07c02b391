//! Collects vertices and faces; cuts polygons into triangles after all vertices are read.

use super::polygon::triangulate;
use super::{MAX_TRIANGLES, Place, SurfaceError};
use crate::geometry::DVec3;
use crate::surface::{Surface, SurfaceNote};

/// The largest number of corners of a face: cutting off ears takes quadratic time.
pub const MAX_CORNERS: usize = 1000;

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
    /// Where the file continues after everything that its counts announce.
    pub surplus: Option<Place>,
}

impl Faces {
    /// Adds a face; its indices are checked by the caller.
    pub(super) fn push(&mut self, corners: &[u32], place: impl Fn() -> Place) -> Result<(), SurfaceError> {
        if !(3..=MAX_CORNERS).contains(&corners.len()) {
            return Err(SurfaceError::Corners { place: place(), count: corners.len() });
        }
        self.triangles += corners.len() - 2;
        if self.triangles > MAX_TRIANGLES {
            return Err(SurfaceError::TooManyTriangles { place: place() });
        }
        self.corners.extend_from_slice(corners);
        self.ends.push(self.corners.len() as u32);
        Ok(())
    }

    /// The surface, with polygons cut into triangles.
    pub(super) fn finish(self) -> Surface {
        let Self { vertices, corners, ends, triangles: count, surplus } = self;
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
        let notes = cut.into_iter().chain(surplus.map(|place| SurfaceNote::Surplus { place })).collect();
        Surface::new(vertices, triangles).with_notes(notes)
    }
}
