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
use crate::surface::{Surface, SurfaceFormat};
use faces::Faces;
use numbers::Numbers;

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
    /// Whether the file has this format, so that it can be written as it was read.
    pub fn has_format(&self, format: FileFormat) -> bool {
        matches!(
            (self.format, format),
            (SurfaceFormat::Obj, FileFormat::Obj)
                | (SurfaceFormat::Ply, FileFormat::Ply)
                | (SurfaceFormat::Glb, FileFormat::Glb)
        )
    }
}

impl Flattened {
    /// The file with texture coordinates, in its own format. `None` if what it has besides triangles cannot be kept: then
    /// [`Self::encode`] writes bare triangles.
    pub fn as_read(&self, source: SurfaceSource<'_>) -> Option<Vec<u8>> {
        match source.format {
            SurfaceFormat::Obj => obj::written(self, source),
            SurfaceFormat::Ply => ply::written(self, source),
            SurfaceFormat::Glb => glb::written(self, source),
            SurfaceFormat::Stl | SurfaceFormat::Off | SurfaceFormat::Gltf => None,
        }
    }
}
