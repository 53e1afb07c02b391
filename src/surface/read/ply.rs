//! PLY, the polygon file format: text and binary in both byte orders.
//!
//! Reads `x`, `y`, `z` of the element `vertex` and the list `vertex_indices` (or
//! `vertex_index`) of `face` and of `tristrips`, where −1 ends a strip; all other elements and properties are skipped. In text,
//! what follows the properties on the last line of a row is passed over, unless several rows stand on one line.

use super::faces::{Faces, vertex_of};
use super::ply_header::{Body, Element, Encoding, Header, Property, Shape, header};
use super::scalar::{Cursor, Scalar};
use super::text::{number, shown};
use super::{Fault, Item, Place, SurfaceError};
use crate::geometry::DVec3;
use crate::surface::Surface;

/// Reads text or binary PLY.
pub(super) fn read(bytes: &[u8]) -> Result<Surface, SurfaceError> {
    let Header { encoding, elements, body } = header(bytes)?;
    let mut numbers = Numbers::new(bytes, encoding, body, rows(&elements));
    let mut faces = Faces::default();
    // faces may precede the vertices that they name
    let of_vertices = elements.iter().filter(|element| element.name == "vertex");
    let vertices = of_vertices.fold(0_usize, |sum, element| sum.saturating_add(element.count));
    for element in &elements {
        match element.name.as_str() {
            "vertex" => read_vertices(element, &mut numbers, &mut faces)?,
            "face" => read_faces(element, vertices, &mut numbers, &mut faces)?,
            "tristrips" => read_strips(element, vertices, &mut numbers, &mut faces)?,
            _ if element.properties.is_empty() => {}
            _ => (0..element.count).try_for_each(|_| skip(&element.properties, &mut numbers))?,
        }
    }
    faces.surplus = numbers.surplus();
    faces.finish()
}

/// The number of rows of the body.
pub(super) fn rows(elements: &[Element]) -> usize {
    let rows = elements.iter().filter(|element| !element.properties.is_empty());
    rows.fold(0_usize, |sum, element| sum.saturating_add(element.count))
}

/// The unread rest of a text body.
pub(super) struct Words<'a> {
    rest: &'a [u8],
    /// The line where it begins.
    line: usize,
    line_end: u8,
    /// Whether no line holds several rows.
    is_row_by_row: bool,
}

impl<'a> Words<'a> {
    /// Passes over the rest of the line on which a row ends.
    fn end_row(&mut self) {
        if self.is_row_by_row {
            let end = self.rest.iter().position(|b| *b == self.line_end).unwrap_or(self.rest.len());
            self.rest = &self.rest[end..];
        }
    }

    fn skip_blanks(&mut self) {
        let start = self.rest.iter().position(|b| !b.is_ascii_whitespace()).unwrap_or(self.rest.len());
        self.line += self.rest[..start].split(|&b| b == self.line_end).count() - 1;
        self.rest = &self.rest[start..];
    }

    /// The next word; empty at the end of the file.
    fn next(&mut self) -> &'a [u8] {
        self.skip_blanks();
        let end = self.rest.iter().position(u8::is_ascii_whitespace).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word
    }
}

/// The numbers of the body in sequence, text or binary.
pub(super) enum Numbers<'a> {
    Text(Words<'a>),
    Binary(Cursor<'a>),
}

impl<'a> Numbers<'a> {
    /// The numbers of a body with so many rows.
    pub(super) fn new(bytes: &'a [u8], encoding: Encoding, body: Body, rows: usize) -> Self {
        match encoding {
            Encoding::Text => {
                let Body { offset, line, line_end } = body;
                let rest = &bytes[offset..];
                let lines = rest.split(|&b| b == line_end).filter(|line| !line.trim_ascii().is_empty());
                Self::Text(Words { rest, line, line_end, is_row_by_row: lines.count() >= rows })
            }
            Encoding::LittleEndian | Encoding::BigEndian => {
                Self::Binary(Cursor { bytes, offset: body.offset, big_endian: encoding == Encoding::BigEndian })
            }
        }
    }

    fn place(&self) -> Place {
        match self {
            Self::Text(words) => Place::Line(words.line),
            Self::Binary(cursor) => cursor.place(),
        }
    }

    /// Ends a row.
    pub(super) fn end_row(&mut self) {
        if let Self::Text(words) = self {
            words.end_row();
        }
    }

    /// The place of what is read next in binary data, of what was read last in text.
    fn place_of(&self, before: Place) -> Place {
        if let Self::Text(_) = self { self.place() } else { before }
    }

    /// Where the rest begins, if it holds more than blanks.
    fn surplus(mut self) -> Option<Place> {
        match &mut self {
            Self::Text(words) => {
                words.skip_blanks();
                (!words.rest.is_empty()).then(|| self.place())
            }
            Self::Binary(cursor) => cursor.surplus(),
        }
    }

    pub(super) fn next(&mut self, scalar: Scalar, what: Item) -> Result<f64, SurfaceError> {
        match self {
            Self::Binary(cursor) => cursor.number(scalar, what),
            Self::Text(words) => {
                let word = words.next();
                let place = Place::Line(words.line);
                if word.is_empty() {
                    return Err(SurfaceError::missing(place, what));
                }
                number(word).ok_or_else(|| SurfaceError::NotANumber { place, found: shown(word) })
            }
        }
    }

    /// Reads the length of a list.
    pub(super) fn length(&mut self, scalar: Scalar) -> Result<usize, SurfaceError> {
        let place = self.place();
        let length = self.next(scalar, Item::ListLength)?;
        let whole = length >= 0.0 && length.fract() == 0.0 && length <= f64::from(u32::MAX);
        if whole { Ok(length as usize) } else { Err(SurfaceError::malformed(place, Fault::ListLength(length))) }
    }

    fn skip(&mut self, shape: Shape) -> Result<(), SurfaceError> {
        match shape {
            Shape::One(scalar) => self.next(scalar, Item::Property).map(|_| ()),
            Shape::List { length, item } => {
                let count = self.length(length)?;
                match self {
                    Self::Binary(cursor) => cursor.skip(count * item.size(), Item::List),
                    Self::Text(_) => (0..count).try_for_each(|_| self.next(item, Item::List).map(|_| ())),
                }
            }
        }
    }
}

fn skip(properties: &[Property], numbers: &mut Numbers<'_>) -> Result<(), SurfaceError> {
    properties.iter().try_for_each(|property| numbers.skip(property.shape))?;
    numbers.end_row();
    Ok(())
}

fn read_vertices(element: &Element, numbers: &mut Numbers<'_>, faces: &mut Faces) -> Result<(), SurfaceError> {
    for name in ["x", "y", "z"] {
        if !element.properties.iter().any(|p| p.name == name && matches!(p.shape, Shape::One(_))) {
            return Err(SurfaceError::missing(Place::Line(1), Item::VertexProperty(name)));
        }
    }
    for _ in 0..element.count {
        let mut point = DVec3::ZERO;
        for property in &element.properties {
            let coordinate = match property.name.as_str() {
                "x" => &mut point.x,
                "y" => &mut point.y,
                "z" => &mut point.z,
                _ => {
                    numbers.skip(property.shape)?;
                    continue;
                }
            };
            let Shape::One(scalar) = property.shape else { continue };
            *coordinate = numbers.next(scalar, Item::VertexCoordinate)?;
        }
        faces.vertices.push(point);
        numbers.end_row();
    }
    Ok(())
}

/// Whether a property holds the corners of a face or of strips.
pub(super) fn is_list(property: &Property) -> bool {
    property.name == "vertex_indices" || property.name == "vertex_index"
}

/// The numbers of a list, each with its place.
type List = [(f64, Place)];

/// Calls `read` with the list of every row, the numbers as they are, each with its place.
fn read_lists(
    element: &Element,
    numbers: &mut Numbers<'_>,
    read: &mut dyn FnMut(&List) -> Result<(), SurfaceError>,
) -> Result<(), SurfaceError> {
    if element.count > 0 && !element.properties.iter().any(is_list) {
        return Err(SurfaceError::missing(Place::Line(1), Item::FaceProperty));
    }
    let mut list = Vec::new();
    for _ in 0..element.count {
        for property in &element.properties {
            let (true, Shape::List { length, item }) = (is_list(property), property.shape) else {
                numbers.skip(property.shape)?;
                continue;
            };
            let count = numbers.length(length)?;
            list.clear();
            for _ in 0..count {
                let before = numbers.place();
                let index = numbers.next(item, Item::FaceCorner)?;
                list.push((index, numbers.place_of(before)));
            }
            read(&list)?;
        }
        numbers.end_row();
    }
    Ok(())
}

/// A corner's vertex.
fn corner((index, place): &(f64, Place), vertices: usize) -> Result<u32, SurfaceError> {
    let whole = if index.fract() == 0.0 { *index as i64 } else { -1 };
    vertex_of(whole, vertices, || place.clone())
}

fn read_faces(
    element: &Element,
    vertices: usize,
    numbers: &mut Numbers<'_>,
    faces: &mut Faces,
) -> Result<(), SurfaceError> {
    let mut corners = Vec::new();
    read_lists(element, numbers, &mut |list| {
        corners.clear();
        for index in list {
            corners.push(corner(index, vertices)?);
        }
        faces.push(&corners);
        Ok(())
    })
}

fn read_strips(
    element: &Element,
    vertices: usize,
    numbers: &mut Numbers<'_>,
    faces: &mut Faces,
) -> Result<(), SurfaceError> {
    read_lists(element, numbers, &mut |list| {
        list.split(|(index, _)| *index == -1.0).try_for_each(|strip| {
            let corners = strip.iter().map(|index| corner(index, vertices)).collect::<Result<Vec<_>, _>>()?;
            faces.push_strip(&corners);
            Ok(())
        })
    })
}
