//! A flattened surface as its own file with texture coordinates: everything else in the file stays as it is.
//!
//! The vertices of the file keep their numbers, and those that a repair or the outline's corners have added follow. A face
//! stays whole, with all its corners, unless a repair or the outline's corners have changed one of its triangles: then its
//! triangles stand in its place. Faces that a repair has left out stay too, without coordinates. Triangles that fill a hole
//! are omitted.

mod added;
mod faces;
mod glb;
mod gltf_data;
mod numbers;
mod obj;
mod ply;

use super::{FileFormat, Flattened};
use crate::geometry::DVec3;
use crate::surface::{Surface, SurfaceFormat, is_sound, packed};
use faces::Faces;
pub(super) use numbers::Numbers;

/// A surface's file, and the surface as it was read from it.
#[derive(Debug, Clone, Copy)]
pub struct SurfaceSource<'a> {
    /// Its format.
    pub format: SurfaceFormat,
    /// Its content.
    pub bytes: &'a [u8],
    /// The surface that was read from it, before any repair.
    pub surface: &'a Surface,
}

impl SurfaceSource<'_> {
    /// Whether a file of the surface's `own` format can be written as it was read in this one: a glTF document as GLB.
    pub fn is_kept(own: SurfaceFormat, format: FileFormat) -> bool {
        matches!(
            (own, format),
            (SurfaceFormat::Obj, FileFormat::Obj)
                | (SurfaceFormat::Ply, FileFormat::Ply)
                | (SurfaceFormat::Glb | SurfaceFormat::Gltf, FileFormat::Glb)
        )
    }
}

/// A surface in a file format.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EncodedSurface {
    /// The file.
    pub bytes: Vec<u8>,
    /// Whether the surface's own file has the same format, but cannot be written as it was read: triangle strips, free-form
    /// surfaces, a GLB's buffers in other files, meshes that are placed twice, and maps onto another surface.
    pub is_bare: bool,
}

impl Flattened {
    /// The surface in a file format. In that of its own file, everything else in the file stays as it is, if that can be;
    /// else these are bare triangles.
    pub fn encode_as_read(&self, format: FileFormat, source: Option<SurfaceSource<'_>>) -> EncodedSurface {
        let source = source.filter(|source| SurfaceSource::is_kept(source.format, format));
        match source.map(|source| self.as_read(source)) {
            Some(Some(bytes)) => EncodedSurface { bytes, is_bare: false },
            unkept => EncodedSurface { bytes: self.encode(format), is_bare: unkept.is_some() },
        }
    }

    /// The file with texture coordinates, in its own format; `None` if what it has besides triangles cannot be kept.
    fn as_read(&self, source: SurfaceSource<'_>) -> Option<Vec<u8>> {
        if !is_of(self.vertices(), source.surface) {
            return None;
        }
        match source.format {
            SurfaceFormat::Obj => obj::written(self, source),
            SurfaceFormat::Ply => ply::written(self, source),
            SurfaceFormat::Glb => glb::written(self, source),
            SurfaceFormat::Gltf => {
                glb::written(self, SurfaceSource { bytes: &packed(source.bytes, &mut |_| None)?.bytes, ..source })
            }
            SurfaceFormat::Stl | SurfaceFormat::Off => None,
        }
    }
}

/// Whether vertices begin with those of a surface as it was read. One at no place is written at another one's.
pub(super) fn is_of(vertices: &[DVec3], surface: &Surface) -> bool {
    let given = surface.vertices();
    let own = vertices.get(..given.len());
    own.is_some_and(|own| own.iter().zip(given).all(|(own, given)| own == given || !is_sound(*given)))
}
