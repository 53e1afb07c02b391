//! STL, text and binary: three corners for each triangle, merged afterwards.

use super::faces::Faces;
use super::scalar::{Cursor, Scalar};
use super::text::lines;
use super::{Item, Place, SurfaceError};
use crate::geometry::DVec3;
use crate::surface::Surface;

/// 80 bytes without meaning, and the number of triangles.
pub(super) const HEADER: usize = 84;
/// Normal and three corners of 12 bytes each, and two bytes without meaning.
const RECORD: usize = 50;

/// Whether the length is that of a binary file with the stated number of triangles; some binary
/// files begin with the `solid` of text files.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    let count = bytes.get(80..).and_then(|rest| Scalar::U32.decode(rest, false));
    count.is_some_and(|count| HEADER + RECORD * count as usize == bytes.len())
}

/// Whether the first word is `solid`, in upper or lower case.
pub(super) fn begins_as_text(bytes: &[u8]) -> bool {
    bytes.trim_ascii_start().get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

/// Reads text or binary STL. Normals are ignored: corners are counter-clockwise seen from outside.
pub(super) fn read(bytes: &[u8]) -> Result<Surface, SurfaceError> {
    let beginning = &bytes[..bytes.len().min(HEADER)];
    let text = begins_as_text(beginning) && !is_binary(bytes) && !beginning.contains(&0);
    let faces = if text { read_text(bytes) } else { read_binary(bytes) }?;
    faces.finish()
}

fn read_binary(bytes: &[u8]) -> Result<Faces, SurfaceError> {
    let mut cursor = Cursor { bytes, offset: 80, big_endian: false };
    let stated = cursor.number(Scalar::U32, Item::TriangleCount)? as u32;
    // programs that do not know the number beforehand leave a placeholder
    let count = if matches!(stated, 0 | u32::MAX) { (bytes.len() - HEADER) / RECORD } else { stated as usize };
    let mut faces = Faces::default();
    for triangle in 0..count {
        cursor.skip(12, Item::TriangleNormal)?;
        let first = faces.vertices.len() as u32;
        for _ in 0..3 {
            let place = cursor.place();
            let mut point = [0.0; 3];
            for value in &mut point {
                let what = Item::TriangleCorner { triangle, count };
                *value = cursor.number(Scalar::F32, what).map_err(|_| SurfaceError::missing(place.clone(), what))?;
            }
            faces.vertices.push(DVec3::from_array(point));
        }
        faces.push(&[first, first + 1, first + 2]);
        cursor.skip(2, Item::TriangleEnd)?;
    }
    faces.surplus = cursor.surplus();
    Ok(faces)
}

/// Reads `vertex x y z` between `outer loop` and `endloop`; all other words are skipped, whatever the number of solids. Some
/// programs leave out `endsolid`.
fn read_text(bytes: &[u8]) -> Result<Faces, SurfaceError> {
    let mut faces = Faces::default();
    let mut corners = Vec::new();
    let mut last = 1;
    for line in lines(bytes) {
        last = line.number;
        let mut words = line.words();
        match words.next().map(<[u8]>::to_ascii_lowercase).as_deref() {
            Some(b"vertex") => {
                corners.push(faces.vertices.len() as u32);
                faces.vertices.push(line.point(&mut words)?);
            }
            Some(b"endloop") => {
                faces.push(&corners);
                corners.clear();
            }
            Some(b"solid") => faces.is_unended = true,
            Some(b"endsolid") => faces.is_unended = false,
            _ => {}
        }
    }
    if corners.is_empty() {
        return Ok(faces);
    }
    Err(SurfaceError::missing(Place::Line(last), Item::Keyword("endloop")))
}
