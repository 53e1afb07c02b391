//! OFF, the object file format of Geomview: text and binary; normals, colors and texture coordinates are skipped.

use super::faces::{Faces, vertex_of};
use super::scalar::{Cursor, Scalar};
use super::text::{Line, lines, shown};
use super::{Item, Place, SurfaceError, Unsupported};
use crate::geometry::DVec3;
use crate::surface::Surface;
use std::iter::Peekable;

/// Reads `OFF` and its variants `COFF`, `NOFF`, `STOFF` …: in text one vertex per line, and one face, or where there are more
/// lines than faces, faces that go on in the next lines.
pub(super) fn read(bytes: &[u8]) -> Result<Surface, SurfaceError> {
    let mut all = lines(bytes).peekable();
    let (vertices, count) = match header(&mut all)? {
        Header::Text(vertices, count) => (vertices, count),
        Header::Binary(keyword) => return read_binary(bytes, keyword),
    };
    let mut faces = Faces::default();
    let mut last = 0;
    for _ in 0..vertices {
        let line = next(&mut all, last, Item::Vertex)?;
        last = line.number;
        faces.vertices.push(line.point(&mut line.words())?);
    }
    let rest: Vec<Line> = all.collect();
    let goes_on = rest.len() > count;
    let mut rest = rest.into_iter();
    for _ in 0..count {
        let line = next(&mut rest, last, Item::Face)?;
        last = line.number;
        let end = read_face(line, if goes_on { Some(&mut rest) } else { None }, &mut faces)?;
        last = last.max(end);
    }
    faces.surplus = rest.next().map(|line| line.place());
    faces.finish()
}

/// Reads a face that begins on a line and may go on in `further` ones; the number of its last line.
fn read_face<'a>(
    line: Line<'a>,
    mut further: Option<&mut dyn Iterator<Item = Line<'a>>>,
    faces: &mut Faces,
) -> Result<usize, SurfaceError> {
    let vertices = faces.vertices.len();
    let (mut line, mut words) = (line, line.words().collect::<Vec<_>>().into_iter());
    let wanted = line.count(&mut words, Item::CornerCount)?;
    let mut corners = Vec::new();
    while corners.len() < wanted {
        if let Some(word) = words.next() {
            corners.push(vertex_of(line.integer_in(word)?, vertices, || line.place())?);
        } else if let Some(after) = further.as_mut().and_then(Iterator::next) {
            (line, words) = (after, after.words().collect::<Vec<_>>().into_iter());
        } else {
            return Err(SurfaceError::missing(line.place(), Item::Corner { index: corners.len() + 1, count: wanted }));
        }
    }
    faces.push(&corners);
    Ok(line.number)
}

/// What the header says.
enum Header<'a> {
    /// The numbers of vertices and faces.
    Text(usize, usize),
    /// The keyword before the word `BINARY`.
    Binary(&'a [u8]),
}

/// The numbers of vertices and faces, with or without a keyword before them, on one line or several; the keyword and the
/// first number may be one word.
fn header<'a>(lines: &mut Peekable<impl Iterator<Item = Line<'a>>>) -> Result<Header<'a>, SurfaceError> {
    let mut line = next(lines, 0, Item::OffKeyword)?;
    let mut words: Vec<&[u8]> = line.words().collect();
    words.reverse();
    if let Some((keyword, rest)) = words.pop_if(|word| split(word).is_some()).and_then(split) {
        if is_of_other_dimension(keyword) {
            return Err(SurfaceError::unsupported(line.place(), Unsupported::Dimensions(shown(keyword))));
        }
        if words.last().is_some_and(|word| word.eq_ignore_ascii_case(b"BINARY")) {
            return Ok(Header::Binary(keyword));
        }
        words.extend((!rest.is_empty()).then_some(rest));
    }
    let mut counts = [0, 0];
    for (count, what) in counts.iter_mut().zip([Item::VertexCount, Item::FaceCount]) {
        if words.is_empty() {
            line = next(lines, line.number, what)?;
            words = line.words().collect();
            words.reverse();
        }
        *count = line.count(&mut std::iter::from_fn(|| words.pop()), what)?;
    }
    if words.is_empty() {
        // the number of edges is ignored; a vertex has three words at least
        lines.next_if(|line| line.words().count() == 1);
    }
    Ok(Header::Text(counts[0], counts[1]))
}

/// The keyword at the beginning of a word, and the number after it, if there is one.
fn split(word: &[u8]) -> Option<(&[u8], &[u8])> {
    let end = word.windows(3).position(|part| part.eq_ignore_ascii_case(b"OFF"))? + 3;
    let (keyword, rest) = word.split_at(end);
    rest.iter().all(u8::is_ascii_digit).then_some((keyword, rest))
}

/// Whether a file begins as OFF: `OFF` in upper or lower case, with or without letters before it, or a number after it.
pub(super) fn is_keyword(word: &[u8]) -> bool {
    split(word).is_some()
}

/// `4OFF` and `nOFF`, where `NOFF` has normals; in lower case they cannot be distinguished.
fn is_of_other_dimension(keyword: &[u8]) -> bool {
    keyword.contains(&b'4') || keyword.contains(&b'n') && keyword.ends_with(b"OFF")
}

fn next<'a>(lines: &mut impl Iterator<Item = Line<'a>>, last: usize, what: Item) -> Result<Line<'a>, SurfaceError> {
    lines.next().ok_or_else(|| SurfaceError::missing(Place::Line(last + 1), what))
}

/// Numbers for each vertex besides its position: two texture coordinates, three of a normal, four of a color.
fn others(keyword: &[u8]) -> usize {
    let letters = keyword[..keyword.len() - 3].to_ascii_uppercase();
    let has = |part: &[u8]| letters.windows(part.len()).any(|letters| letters == part);
    2 * usize::from(has(b"ST")) + 3 * usize::from(has(b"N")) + 4 * usize::from(has(b"C"))
}

/// Reads the binary form, most significant bytes first: after the line of the keyword the numbers of vertices, faces and
/// edges; each vertex; each face as the number of its corners, these, the number of the numbers of its color, and these.
fn read_binary(bytes: &[u8], keyword: &[u8]) -> Result<Surface, SurfaceError> {
    let offset = bytes.iter().position(|&b| b == b'\n').map_or(bytes.len(), |line| line + 1);
    let mut cursor = Cursor { bytes, offset, big_endian: true };
    let [vertices, count, _] =
        [Item::VertexCount, Item::FaceCount, Item::ElementCount].map(|what| whole(&mut cursor, what));
    let (vertices, count, others) = (vertices?, count?, others(keyword));
    let mut faces = Faces::default();
    for _ in 0..vertices {
        let mut point = [0.0; 3];
        for coordinate in &mut point {
            *coordinate = cursor.number(Scalar::F32, Item::OffNumber)?;
        }
        cursor.skip(others * Scalar::F32.size(), Item::OffNumber)?;
        faces.vertices.push(DVec3::from_array(point));
    }
    let mut corners = Vec::new();
    for _ in 0..count {
        corners.clear();
        for index in 1..=whole(&mut cursor, Item::CornerCount)? {
            let place = cursor.place();
            let corner = cursor.number(Scalar::I32, Item::Corner { index, count: index })?;
            corners.push(vertex_of(corner as i64, vertices, || place.clone())?);
        }
        let colors = whole(&mut cursor, Item::OffNumber)?;
        cursor.skip(colors.saturating_mul(Scalar::F32.size()), Item::OffNumber)?;
        faces.push(&corners);
    }
    faces.surplus = cursor.surplus();
    faces.finish()
}

/// The next number, a count.
fn whole(cursor: &mut Cursor<'_>, what: Item) -> Result<usize, SurfaceError> {
    let place = cursor.place();
    let count = cursor.number(Scalar::I32, what)?;
    let negative = || SurfaceError::malformed(place, super::Fault::Count { what, found: count.to_string() });
    if count >= 0.0 { Ok(count as usize) } else { Err(negative()) }
}
