//! The lines of an OBJ file, for writing it again with other texture coordinates.
//!
//! Vertices are counted from 0 and no longer relative to the line, and the old texture coordinates are left out; normals
//! are words as in the file. Lines that end in a backslash are joined with the next one.

use super::SurfaceError;
use super::obj::{joined, vertex_of};
use super::text::{Line, line_end, without_comment};
use std::borrow::Cow;

/// The text of an OBJ file.
pub(crate) struct ObjFile<'a> {
    text: Cow<'a, [u8]>,
}

/// A corner of a face.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct ObjCorner<'a> {
    /// Its vertex, counted from 0.
    pub vertex: u32,
    /// The word of its normal, as in the file; empty without one.
    pub normal: &'a [u8],
}

/// A line.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum ObjLine<'a> {
    /// A vertex: the whole line.
    Vertex(&'a [u8]),
    /// Texture coordinates.
    Coordinates,
    /// A face, and its comment with the mark.
    Face(Vec<ObjCorner<'a>>, &'a [u8]),
    /// Points or polylines, by their keyword and their vertices.
    Points(&'a [u8], Vec<u32>),
    /// A free-form curve or surface, whose lines are not understood.
    FreeForm,
    /// Any other line.
    Other(&'a [u8]),
}

impl<'a> ObjFile<'a> {
    /// The text in `bytes`, in UTF-8 or after a byte order mark in UTF-16.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        let text = match super::decoded(bytes) {
            Cow::Borrowed(bytes) => joined(bytes),
            Cow::Owned(bytes) => joined(&bytes).into_owned().into(),
        };
        Self { text }
    }

    /// The lines in order. Errors: a corner is not a number.
    pub(crate) fn lines(&self) -> impl Iterator<Item = Result<ObjLine<'_>, SurfaceError>> {
        let end = line_end(&self.text);
        let text = self.text.trim_ascii_end();
        let mut vertices = 0;
        text.split(move |&b| b == end).enumerate().map(move |(k, line)| {
            let read = read(k + 1, line.strip_suffix(b"\r").unwrap_or(line), vertices);
            vertices += usize::from(matches!(read, Ok(ObjLine::Vertex(_))));
            read
        })
    }
}

/// A line after so many vertices.
fn read(number: usize, whole: &[u8], vertices: usize) -> Result<ObjLine<'_>, SurfaceError> {
    let line = Line::of(number, whole);
    let mut words = line.words();
    let vertex = |word| vertex_of(word, line, vertices).map(|vertex| (vertex - 1) as u32);
    match words.next() {
        Some(b"v") => Ok(ObjLine::Vertex(whole)),
        Some(b"vt") => Ok(ObjLine::Coordinates),
        Some(b"f") => {
            let corner = |word| Ok(ObjCorner { vertex: vertex(word)?, normal: normal_of(word) });
            let comment = &whole[without_comment(whole).len()..];
            Ok(ObjLine::Face(words.map(corner).collect::<Result<_, _>>()?, comment))
        }
        Some(keyword @ (b"l" | b"p")) => Ok(ObjLine::Points(keyword, words.map(vertex).collect::<Result<_, _>>()?)),
        Some(b"cstype" | b"surf" | b"curv" | b"curv2") => Ok(ObjLine::FreeForm),
        _ => Ok(ObjLine::Other(whole)),
    }
}

/// The color at the end of a vertex's line, three numbers after its place; `None` without one.
pub(crate) fn vertex_color(line: &[u8]) -> Option<[f64; 3]> {
    let words = Line::of(0, line).words().skip(4).map(|word| std::str::from_utf8(word).ok()?.parse().ok());
    words.collect::<Option<Vec<f64>>>()?.try_into().ok()
}

/// The third part of `7/3/5` or `7//5`; empty without one.
fn normal_of(word: &[u8]) -> &[u8] {
    word.split(|&b| b == b'/').nth(2).unwrap_or_default()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn lines_have_absolute_vertices_and_their_comments() {
        let text = b"o a # it\r\nv 1 2 3 .5 0 1\nvt 0 0\nv 0 0 0\n\nf -1//2 1/1/-1 \\\n 2 # c\nl 1/1 -1\n";
        let file = ObjFile::new(text);
        let lines: Vec<ObjLine> = file.lines().map(Result::unwrap).collect();
        let corner = |vertex, normal| ObjCorner { vertex, normal };
        let corners = vec![corner(1, &b"2"[..]), corner(0, b"-1"), corner(1, b"")];
        let expected = [
            ObjLine::Other(b"o a # it"),
            ObjLine::Vertex(b"v 1 2 3 .5 0 1"),
            ObjLine::Coordinates,
            ObjLine::Vertex(b"v 0 0 0"),
            ObjLine::Other(b""),
            ObjLine::Face(corners, b"# c"),
            ObjLine::Other(b""),
            ObjLine::Points(b"l", vec![0, 1]),
        ];
        assert_eq!(lines, expected);
    }
}
