//! The header of a PLY file: its elements and their properties.

use super::scalar::Scalar;
use super::text::{Line, line_end, lines, shown};
use super::{Fault, Item, Place, SurfaceError};

/// How the numbers of the body are encoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

/// One number, or a list of numbers with its length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    One(Scalar),
    List { length: Scalar, item: Scalar },
}

/// A property of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Property {
    pub name: String,
    pub shape: Shape,
}

/// An element, such as `vertex`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Element {
    pub name: String,
    pub count: usize,
    pub properties: Vec<Property>,
}

/// The header, and the position of the body.
#[derive(Debug)]
pub(super) struct Header {
    pub encoding: Encoding,
    pub elements: Vec<Element>,
    pub body: Body,
}

/// The position of the body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Body {
    /// Offset of the first byte.
    pub offset: usize,
    /// The line of that byte, from 1.
    pub line: usize,
    /// The byte that ends the lines of the header, and those of a text body.
    pub line_end: u8,
}

/// The longest header accepted, so that a long binary body is not searched for `end_header`.
const LONGEST: usize = 1 << 20;

/// Reads the header up to `end_header`.
pub(super) fn header(bytes: &[u8]) -> Result<Header, SurfaceError> {
    let body = body(bytes)?;
    let mut lines = lines(&bytes[..body.offset]);
    if lines.next().is_none_or(|line| !line.words().eq([b"ply"])) {
        return Err(SurfaceError::malformed(Place::Line(1), Fault::NotPly));
    }
    let (mut encoding, mut elements) = (None, Vec::<Element>::new());
    for line in lines {
        let mut words = line.words();
        match words.next() {
            Some(b"format") => encoding = Some(encoding_of(line, words.next())?),
            Some(b"element") => {
                let name = String::from_utf8_lossy(words.next().unwrap_or_default()).into_owned();
                let count = line.count(&mut words, Item::ElementCount)?;
                elements.push(Element { name, count, properties: Vec::new() });
            }
            Some(b"property") => {
                let property = property(line, &mut words)?;
                let missing = || SurfaceError::missing(line.place(), Item::PropertyElement);
                elements.last_mut().ok_or_else(missing)?.properties.push(property);
            }
            Some(b"comment" | b"obj_info" | b"end_header") | None => {}
            Some(word) => return Err(SurfaceError::malformed(line.place(), Fault::UnknownWord(shown(word)))),
        }
    }
    let encoding = encoding.ok_or_else(|| SurfaceError::missing(Place::Line(2), Item::FormatLine))?;
    Ok(Header { encoding, elements, body })
}

/// The lines of a header that are remarks: comments and `obj_info`.
pub(super) fn remarks(bytes: &[u8], body: Body) -> Vec<Vec<u8>> {
    let lines = bytes[..body.offset].split(|&b| b == body.line_end).map(<[u8]>::trim_ascii);
    let is_remark = |line: &&[u8]| {
        let word = line.split(u8::is_ascii_whitespace).next();
        matches!(word, Some(b"comment" | b"obj_info"))
    };
    lines.filter(is_remark).map(<[u8]>::to_vec).collect()
}

fn body(bytes: &[u8]) -> Result<Body, SurfaceError> {
    const LAST: &[u8] = b"end_header";
    let searched = &bytes[..bytes.len().min(LONGEST)];
    let missing = || SurfaceError::missing(Place::Line(1), Item::HeaderEnd);
    // line ends are counted in the header alone: a binary body may contain both kinds
    let end = searched.windows(LAST.len()).position(|word| word == LAST).ok_or_else(missing)? + LAST.len();
    let line_end = line_end(&bytes[..(end + 2).min(bytes.len())]);
    let mut offset = 0;
    for (k, line) in bytes.split_inclusive(|&b| b == line_end).enumerate() {
        offset += line.len();
        if line.trim_ascii() == LAST {
            return Ok(Body { offset, line: k + 2, line_end });
        }
        if offset > LONGEST {
            break;
        }
    }
    Err(missing())
}

fn encoding_of(line: Line<'_>, word: Option<&[u8]>) -> Result<Encoding, SurfaceError> {
    match word.unwrap_or_default() {
        b"ascii" => Ok(Encoding::Text),
        b"binary_little_endian" => Ok(Encoding::LittleEndian),
        b"binary_big_endian" => Ok(Encoding::BigEndian),
        other => Err(SurfaceError::malformed(line.place(), Fault::UnknownFormat(shown(other)))),
    }
}

fn property<'a>(line: Line<'a>, words: &mut impl Iterator<Item = &'a [u8]>) -> Result<Property, SurfaceError> {
    let scalar = |word: Option<&[u8]>| {
        let word = word.unwrap_or_default();
        scalar_of(word).ok_or_else(|| SurfaceError::malformed(line.place(), Fault::NoType(shown(word))))
    };
    let first = words.next();
    let shape = if first == Some(b"list") {
        let length = scalar(words.next())?;
        if length.is_float() {
            return Err(SurfaceError::malformed(line.place(), Fault::ListLengthType));
        }
        Shape::List { length, item: scalar(words.next())? }
    } else {
        Shape::One(scalar(first)?)
    };
    let name = words.next().ok_or_else(|| SurfaceError::missing(line.place(), Item::PropertyName))?;
    Ok(Property { name: String::from_utf8_lossy(name).into_owned(), shape })
}

fn scalar_of(word: &[u8]) -> Option<Scalar> {
    Some(match word {
        b"char" | b"int8" => Scalar::I8,
        b"uchar" | b"uint8" => Scalar::U8,
        b"short" | b"int16" => Scalar::I16,
        b"ushort" | b"uint16" => Scalar::U16,
        b"int" | b"int32" => Scalar::I32,
        b"uint" | b"uint32" => Scalar::U32,
        b"float" | b"float32" => Scalar::F32,
        b"double" | b"float64" => Scalar::F64,
        _ => return None,
    })
}
