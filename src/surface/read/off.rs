//! OFF, the object file format of Geomview: text; normals, colours and texture coordinates are passed over.

use super::faces::Faces;
use super::text::{Line, lines, shown};
use super::{Place, SurfaceError};
use crate::surface::Surface;

/// Reads `OFF` and its kin `COFF`, `NOFF`, `STOFF` …: a vertex and a face on each line.
pub(super) fn read(bytes: &[u8]) -> Result<Surface, SurfaceError> {
    let mut lines = lines(bytes);
    let (vertices, count) = header(&mut lines)?;
    let mut faces = Faces::default();
    let mut last = 0;
    for _ in 0..vertices {
        let line = next(&mut lines, last, "a vertex")?;
        last = line.number;
        let point = line.point(&mut line.words(), faces.vertices.len())?;
        faces.vertices.push(point);
    }
    let mut corners = Vec::new();
    for _ in 0..count {
        let line = next(&mut lines, last, "a face")?;
        last = line.number;
        let mut words = line.words();
        let wanted = line.count(&mut words, "the number of corners")?;
        corners.clear();
        for word in words.take(wanted) {
            corners.push(faces.known(line.integer_in(word)?, || line.place())?);
        }
        if corners.len() < wanted {
            return Err(SurfaceError::missing(line.place(), format!("corner {} of {wanted}", corners.len() + 1)));
        }
        faces.push(&corners, || line.place())?;
    }
    Ok(faces.finish())
}

/// The numbers of vertices and faces, on the line of the keyword or the next one.
fn header<'a>(lines: &mut impl Iterator<Item = Line<'a>>) -> Result<(usize, usize), SurfaceError> {
    let mut line = next(lines, 0, "the keyword OFF")?;
    let mut words = line.words().peekable();
    if let Some(word) = words.next_if(|word| word.ends_with(b"OFF")) {
        let kind = &word[..word.len() - 3];
        if kind.contains(&b'4') || kind.contains(&b'n') {
            return Err(SurfaceError::unsupported(
                line.place(),
                format!("a surface in 4 or n dimensions ({})", shown(word)),
            ));
        }
        if words.peek().is_some_and(|word| word.eq_ignore_ascii_case(b"BINARY")) {
            return Err(SurfaceError::unsupported(line.place(), "binary OFF"));
        }
        if words.peek().is_none() {
            line = next(lines, line.number, "the number of vertices")?;
            words = line.words().peekable();
        }
    }
    let vertices = line.count(&mut words, "the number of vertices")?;
    Ok((vertices, line.count(&mut words, "the number of faces")?))
}

fn next<'a>(lines: &mut impl Iterator<Item = Line<'a>>, last: usize, what: &str) -> Result<Line<'a>, SurfaceError> {
    lines.next().ok_or_else(|| SurfaceError::missing(Place::Line(last + 1), what))
}
