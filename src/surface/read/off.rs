//! OFF, the object file format of Geomview: text; normals, colors and texture coordinates are skipped.

use super::faces::{Faces, vertex_of};
use super::text::{Line, lines, shown};
use super::{Item, Place, SurfaceError, Unsupported};
use crate::surface::Surface;
use std::iter::Peekable;

/// Reads `OFF` and its variants `COFF`, `NOFF`, `STOFF` …: one vertex or face per line.
pub(super) fn read(bytes: &[u8]) -> Result<Surface, SurfaceError> {
    let mut lines = lines(bytes).peekable();
    let (vertices, count) = header(&mut lines)?;
    let mut faces = Faces::default();
    let mut last = 0;
    for _ in 0..vertices {
        let line = next(&mut lines, last, Item::Vertex)?;
        last = line.number;
        let point = line.point(&mut line.words(), faces.vertices.len())?;
        faces.vertices.push(point);
    }
    let mut corners = Vec::new();
    for _ in 0..count {
        let line = next(&mut lines, last, Item::Face)?;
        last = line.number;
        let mut words = line.words();
        let wanted = line.count(&mut words, Item::CornerCount)?;
        corners.clear();
        for word in words.take(wanted) {
            corners.push(vertex_of(line.integer_in(word)?, vertices, || line.place())?);
        }
        if corners.len() < wanted {
            return Err(SurfaceError::missing(line.place(), Item::Corner { index: corners.len() + 1, count: wanted }));
        }
        faces.push(&corners, || line.place())?;
    }
    faces.surplus = lines.next().map(|line| line.place());
    Ok(faces.finish())
}

/// The numbers of vertices and faces, with or without a keyword before them, on one line or several.
fn header<'a>(lines: &mut Peekable<impl Iterator<Item = Line<'a>>>) -> Result<(usize, usize), SurfaceError> {
    let mut line = next(lines, 0, Item::OffKeyword)?;
    let mut words = line.words().peekable();
    if let Some(word) = words.next_if(|word| is_keyword(word)) {
        check_kind(line.place(), word, words.peek().copied())?;
    }
    let mut counts = [0, 0];
    for (count, what) in counts.iter_mut().zip([Item::VertexCount, Item::FaceCount]) {
        if words.peek().is_none() {
            line = next(lines, line.number, what)?;
            words = line.words().peekable();
        }
        *count = line.count(&mut words, what)?;
    }
    if words.next().is_none() {
        // the number of edges is ignored; a vertex has three words at least
        lines.next_if(|line| line.words().count() == 1);
    }
    Ok((counts[0], counts[1]))
}

/// Returns an error if the keyword and the word after it name a kind that is not supported.
fn check_kind(place: Place, keyword: &[u8], after: Option<&[u8]>) -> Result<(), SurfaceError> {
    if is_of_other_dimension(keyword) {
        return Err(SurfaceError::unsupported(place, Unsupported::Dimensions(shown(keyword))));
    }
    match after {
        Some(word) if word.eq_ignore_ascii_case(b"BINARY") => {
            Err(SurfaceError::unsupported(place, Unsupported::BinaryOff))
        }
        _ => Ok(()),
    }
}

/// `OFF` in upper or lower case, with or without letters before it.
pub(super) fn is_keyword(word: &[u8]) -> bool {
    word.len() >= 3 && word[word.len() - 3..].eq_ignore_ascii_case(b"OFF")
}

/// `4OFF` and `nOFF`, where `NOFF` has normals; in lower case they cannot be distinguished.
fn is_of_other_dimension(keyword: &[u8]) -> bool {
    keyword.contains(&b'4') || keyword.contains(&b'n') && keyword.ends_with(b"OFF")
}

fn next<'a>(lines: &mut impl Iterator<Item = Line<'a>>, last: usize, what: Item) -> Result<Line<'a>, SurfaceError> {
    lines.next().ok_or_else(|| SurfaceError::missing(Place::Line(last + 1), what))
}
