//! Wavefront OBJ: `v` and `f`; every other keyword is skipped.

use super::faces::Faces;
use super::text::{Line, line_end, lines};
use super::{Place, SurfaceError};
use crate::surface::Surface;
use std::borrow::Cow;

/// Whether a file that begins with this word, after comments, is an OBJ file.
pub(super) fn is_keyword(word: &[u8]) -> bool {
    matches!(word, b"v" | b"vt" | b"vn" | b"f" | b"o" | b"g" | b"s" | b"l" | b"mtllib" | b"usemtl")
}

/// Reads all objects and groups as one surface.
pub(super) fn read(bytes: &[u8]) -> Result<Surface, SurfaceError> {
    let bytes = joined(bytes);
    let mut faces = Faces::default();
    let mut corners = Vec::new();
    // a face may precede its vertices: its indices are checked at the end
    let mut largest = (0, 0);
    for line in lines(&bytes) {
        let mut words = line.words();
        match words.next() {
            Some(b"v") => {
                faces.vertices.push(line.point(&mut words)?);
            }
            Some(b"f") => {
                corners.clear();
                for word in words {
                    let vertex = vertex_of(word, line, faces.vertices.len())?;
                    if vertex > largest.0 {
                        largest = (vertex, line.number);
                    }
                    corners.push((vertex - 1) as u32);
                }
                faces.push(&corners);
            }
            _ => {}
        }
    }
    let (index, line) = largest;
    if index > faces.vertices.len() as i64 {
        let vertices = faces.vertices.len();
        return Err(SurfaceError::IndexOutOfRange { place: Place::Line(line), index, vertices });
    }
    faces.finish()
}

/// The number, from 1, of the vertex in `7`, `7/3`, `7//2` or `-1` (the last one so far).
pub(super) fn vertex_of(word: &[u8], line: Line<'_>, so_far: usize) -> Result<i64, SurfaceError> {
    let index = line.integer_in(word.split(|&b| b == b'/').next().unwrap_or_default())?;
    let vertex = if index < 0 { index.saturating_add(so_far as i64 + 1) } else { index };
    if (1..=i64::from(u32::MAX)).contains(&vertex) {
        return Ok(vertex);
    }
    Err(SurfaceError::IndexOutOfRange { place: line.place(), index, vertices: so_far })
}

/// Joins a line that ends in a backslash with the next one, unless the backslash is in a comment. The line
/// feeds removed that way are added after the joined line, so that line numbers stay correct.
pub(super) fn joined(bytes: &[u8]) -> Cow<'_, [u8]> {
    if !bytes.contains(&b'\\') {
        return bytes.into();
    }
    let (mut owned, mut held) = (Vec::with_capacity(bytes.len()), 0);
    let end = line_end(bytes);
    for line in bytes.split(|&b| b == end) {
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        if let Some(begun) = line.strip_suffix(b"\\").filter(|begun| !begun.contains(&b'#')) {
            owned.extend_from_slice(begun);
            owned.push(b' ');
            held += 1;
        } else {
            owned.extend_from_slice(line);
            owned.extend(std::iter::repeat_n(b'\n', 1 + std::mem::take(&mut held)));
        }
    }
    owned.into()
}
