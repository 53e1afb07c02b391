//! The rows of a PLY file, for writing it again with other texture coordinates. Every number is exact as f64.

use super::ply::{Numbers, is_list, rows};
use super::ply_header::{Element, Encoding, Header, Property, Shape, header, remarks};
use super::{Item, SurfaceError};

/// A PLY file whose rows are read in order.
pub(crate) struct PlyFile<'a> {
    /// How its numbers are encoded.
    pub encoding: Encoding,
    /// Its elements.
    pub elements: Vec<Element>,
    /// The lines of its header that are comments or `obj_info`.
    pub remarks: Vec<Vec<u8>>,
    numbers: Numbers<'a>,
}

/// The value of a property.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum PlyValue {
    /// A number.
    One(f64),
    /// A list of numbers.
    List(Vec<f64>),
}

impl<'a> PlyFile<'a> {
    /// Reads the header.
    pub(crate) fn new(bytes: &'a [u8]) -> Result<Self, SurfaceError> {
        let Header { encoding, elements, body } = header(bytes)?;
        let numbers = Numbers::new(bytes, encoding, body, rows(&elements));
        Ok(Self { encoding, elements, remarks: remarks(bytes, body), numbers })
    }

    /// The values of the next row, which has these properties; none are read of an element without properties.
    pub(crate) fn row(&mut self, properties: &[Property]) -> Result<Vec<PlyValue>, SurfaceError> {
        let row = properties.iter().map(|property| self.value(property.shape)).collect();
        if !properties.is_empty() {
            self.numbers.end_row();
        }
        row
    }

    fn value(&mut self, shape: Shape) -> Result<PlyValue, SurfaceError> {
        match shape {
            Shape::One(scalar) => self.numbers.next(scalar, Item::Property).map(PlyValue::One),
            Shape::List { length, item } => {
                let count = self.numbers.length(length)?;
                (0..count).map(|_| self.numbers.next(item, Item::List)).collect::<Result<_, _>>().map(PlyValue::List)
            }
        }
    }
}

impl Property {
    /// Whether it holds the corners of a face.
    pub(crate) fn is_corners(&self) -> bool {
        is_list(self) && matches!(self.shape, Shape::List { .. })
    }
}
