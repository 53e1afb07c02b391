//! Surfaces from files: OBJ, PLY, STL, OFF, glTF and GLB.
//!
//! The readers are our own and small: a surface needs positions and faces only. No input
//! makes a reader panic, and readers access nothing but the given bytes, and the system's word on free memory where a
//! surface is large. Crates considered instead:
//!
//! | crate | why not |
//! |---|---|
//! | `tobj` 4 | its `LoadError` has no data: neither line nor number; polygons become fans, even where that turns triangles over |
//! | `obj-rs` 0.7 | errors without a line; coordinates are f32 |
//! | `stl_io` 0.11 | text that begins with `SOLID` is refused; coordinates of text are f32; an `io::Error` without place |
//!
//! `obj` and `stl` are 170 lines, and share lines, numbers, faces and welding with the other formats.

mod error;
mod faces;
mod fault;
mod glb;
mod gltf;
mod gltf_buffers;
mod gltf_pack;
mod gltf_parts;
mod item;
mod memory;
mod obj;
mod obj_lines;
mod off;
mod ply;
mod ply_file;
mod ply_header;
mod polygon;
mod scalar;
mod stl;
mod text;
mod weld;

use super::{Place, Surface};
use crate::utf16;
pub use error::SurfaceError;
pub(crate) use faces::distinct;
pub use fault::Fault;
pub(crate) use glb::{GlbChunks, container};
pub use gltf_pack::{PackedGltf, packed};
pub(crate) use gltf_parts::GltfPart;
pub use item::{Item, Unsupported};
pub(crate) use obj_lines::{ObjCorner, ObjFile, ObjLine, vertex_color};
pub(crate) use ply_file::{PlyFile, PlyValue};
pub(crate) use ply_header::{Element, Encoding, Property, Shape};
pub(crate) use scalar::Scalar;
use std::borrow::Cow;
use text::lines;

/// The largest accepted file size.
pub const MAX_BYTES: usize = 512 << 20;

/// Reads a surface from a file's name and bytes.
///
/// The first bytes decide the format, and where they do not, the extension (`obj`, `ply`, `stl`, `off`, `gltf`, `glb`).
/// Vertices that a program has split are merged (file `weld`). All objects of an OBJ file and the default scene of a glTF
/// file are read. Refused are surfaces that take more memory than there is. Cost O(bytes).
pub fn read_surface(file_name: &str, bytes: &[u8]) -> Result<Surface, SurfaceError> {
    read_surface_beside(file_name, bytes, &mut |_| None)
}

/// Gives the bytes of a neighboring file, whose name is relative to the folder of the one that is read and does not lead out
/// of it.
pub type Neighbor<'a> = dyn FnMut(&str) -> Option<Vec<u8>> + 'a;

/// As [`read_surface`], with the buffers of a glTF document in neighboring files.
pub fn read_surface_beside(file_name: &str, bytes: &[u8], neighbor: &mut Neighbor) -> Result<Surface, SurfaceError> {
    check_size(bytes.len())?;
    let decoded = decoded(bytes);
    let bytes = &*decoded;
    let format = SurfaceFormat::of(file_name, bytes)?;
    let surface = match format {
        SurfaceFormat::Obj => obj::read(bytes),
        SurfaceFormat::Ply => ply::read(bytes),
        SurfaceFormat::Stl => stl::read(bytes),
        SurfaceFormat::Off => off::read(bytes),
        SurfaceFormat::Gltf => gltf::read(bytes, None, neighbor),
        SurfaceFormat::Glb => glb::read(bytes, neighbor),
    }?;
    if surface.triangles.is_empty() {
        return Err(SurfaceError::NoTriangles);
    }
    Ok(weld::welded(surface, matches!(format, SurfaceFormat::Stl | SurfaceFormat::Gltf | SurfaceFormat::Glb)))
}

/// Text in UTF-16, or after a byte order mark, as editors put it, in UTF-8; anything else as it is.
pub(crate) fn decoded(bytes: &[u8]) -> Cow<'_, [u8]> {
    if stl::is_binary(bytes) {
        return bytes.into();
    }
    match utf16::decoded(bytes) {
        Some(text) => text.into_bytes().into(),
        None => bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes).into(),
    }
}

/// Checks the size of a file before its content is copied or read; `Err` above [`MAX_BYTES`].
pub fn check_size(bytes: usize) -> Result<(), SurfaceError> {
    if bytes > MAX_BYTES { Err(SurfaceError::TooLarge { bytes }) } else { Ok(()) }
}

/// The formats of surfaces, in the order of [`ENDINGS`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "the variants are the extensions")]
pub enum SurfaceFormat {
    Obj,
    Ply,
    Stl,
    Off,
    Gltf,
    Glb,
}

impl SurfaceFormat {
    const ALL: [Self; 6] = [Self::Obj, Self::Ply, Self::Stl, Self::Off, Self::Gltf, Self::Glb];

    /// The format of a file: that of its content, if it is known, or that of its name. A binary STL file begins with any
    /// words, and has zeros in the number after them.
    pub fn of(file_name: &str, bytes: &[u8]) -> Result<Self, SurfaceError> {
        let bytes = &*decoded(bytes);
        let extension = extension_of(file_name);
        let named = ENDINGS.iter().position(|ending| *ending == extension).map(|k| Self::ALL[k]);
        let may_be_stl = named == Some(Self::Stl) && bytes[..bytes.len().min(stl::HEADER)].contains(&0);
        let begun = by_first_bytes(bytes).filter(|begun| !may_be_stl || !matches!(begun, Self::Obj | Self::Off));
        begun.or(named).ok_or(SurfaceError::UnknownFormat { extension })
    }
}

/// The extensions that decide the format.
pub const ENDINGS: [&str; 6] = ["obj", "ply", "stl", "off", "gltf", "glb"];

/// Whether this name has one of [`ENDINGS`].
pub fn names_format(file_name: &str) -> bool {
    ENDINGS.contains(&extension_of(file_name).as_str())
}

/// The extension in lower case; empty if there is none.
fn extension_of(file_name: &str) -> String {
    file_name.rsplit_once('.').map_or("", |(_, extension)| extension).to_ascii_lowercase()
}

/// The format of a file that begins with these bytes.
fn by_first_bytes(bytes: &[u8]) -> Option<SurfaceFormat> {
    let first = bytes.trim_ascii_start();
    let begins = |word: &str| first.starts_with(word.as_bytes());
    let line = lines(bytes).next();
    let word = || line.and_then(|line| line.words().next()).unwrap_or_default();
    match first {
        // no text has so large a count of triangles in these bytes
        _ if stl::is_binary(bytes) => Some(SurfaceFormat::Stl),
        _ if line.is_some_and(|line| line.words().eq([b"ply"])) => Some(SurfaceFormat::Ply),
        _ if begins("glTF") => Some(SurfaceFormat::Glb),
        _ if begins("{") => Some(SurfaceFormat::Gltf),
        _ if stl::begins_as_text(first) => Some(SurfaceFormat::Stl),
        _ if off::is_keyword(word()) => Some(SurfaceFormat::Off),
        _ if obj::is_keyword(word()) => Some(SurfaceFormat::Obj),
        _ => None,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests;
