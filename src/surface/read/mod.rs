//! Surfaces from files: OBJ, PLY, STL, OFF, glTF and GLB.
//!
//! The readers are our own and small: a surface needs positions and faces only. No input
//! makes a reader panic, and readers access nothing but the given bytes. Crates considered instead:
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
mod item;
mod obj;
mod off;
mod ply;
mod ply_header;
mod polygon;
mod scalar;
mod stl;
mod text;
mod weld;

use super::{Place, Surface};
pub use error::SurfaceError;
pub use faces::MAX_CORNERS;
pub use fault::Fault;
pub use item::{Item, Unsupported};
use text::lines;

/// The largest accepted file size.
pub const MAX_BYTES: usize = 512 << 20;

/// The most triangles that a surface may have: their factor takes about 4 GB.
pub const MAX_TRIANGLES: usize = 4_000_000;

/// Reads a surface from a file's name and bytes.
///
/// The extension decides the format (`obj`, `ply`, `stl`, `off`, `gltf`, `glb`); with any
/// other, the first bytes do. In formats that repeat a vertex for each face (STL, glTF), vertices
/// at exactly equal positions are merged. All objects of an OBJ file and the
/// default scene of a glTF file are read. Cost O(bytes).
pub fn read_surface(file_name: &str, bytes: &[u8]) -> Result<Surface, SurfaceError> {
    check_size(bytes.len())?;
    // editors put a UTF-8 byte order mark before text
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").filter(|_| !stl::is_binary(bytes));
    let bytes = text.unwrap_or(bytes);
    let extension = extension_of(file_name);
    let surface = match extension.as_str() {
        "obj" => obj::read(bytes),
        "ply" => ply::read(bytes),
        "stl" => stl::read(bytes),
        "off" => off::read(bytes),
        "gltf" => gltf::read(bytes, None),
        "glb" => glb::read(bytes),
        _ => by_first_bytes(&extension, bytes),
    }?;
    if surface.triangles.is_empty() { Err(SurfaceError::NoTriangles) } else { Ok(surface) }
}

/// Checks the size of a file before its content is copied or read; `Err` above [`MAX_BYTES`].
pub fn check_size(bytes: usize) -> Result<(), SurfaceError> {
    if bytes > MAX_BYTES { Err(SurfaceError::TooLarge { bytes }) } else { Ok(()) }
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

fn by_first_bytes(extension: &str, bytes: &[u8]) -> Result<Surface, SurfaceError> {
    let first = bytes.trim_ascii_start();
    let begins = |word: &str| first.starts_with(word.as_bytes());
    let word = || lines(bytes).next().and_then(|line| line.words().next()).unwrap_or_default();
    match first {
        _ if begins("ply") => ply::read(bytes),
        _ if begins("glTF") => glb::read(bytes),
        _ if begins("{") => gltf::read(bytes, None),
        _ if stl::begins_as_text(first) || stl::is_binary(bytes) => stl::read(bytes),
        _ if off::is_keyword(word()) => off::read(bytes),
        _ if obj::is_keyword(word()) => obj::read(bytes),
        _ => Err(SurfaceError::UnknownFormat { extension: extension.to_owned() }),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests;
