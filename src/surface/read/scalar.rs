//! Numbers in binary files.

use super::{Item, Place, SurfaceError};

/// The type of a number in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    /// Its size in bytes.
    pub(crate) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Its name in PLY files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::I8 => "char",
            Self::U8 => "uchar",
            Self::I16 => "short",
            Self::U16 => "ushort",
            Self::I32 => "int",
            Self::U32 => "uint",
            Self::F32 => "float",
            Self::F64 => "double",
        }
    }

    /// The nearest number of this type.
    pub(crate) fn nearest(self, value: f64) -> f64 {
        match self {
            Self::I8 => f64::from(value.round() as i8),
            Self::U8 => f64::from(value.round() as u8),
            Self::I16 => f64::from(value.round() as i16),
            Self::U16 => f64::from(value.round() as u16),
            Self::I32 => f64::from(value.round() as i32),
            Self::U32 => f64::from(value.round() as u32),
            Self::F32 => f64::from(value as f32),
            Self::F64 => value,
        }
    }

    /// Appends the nearest number of this type.
    pub(crate) fn encode(self, value: f64, big_endian: bool, bytes: &mut Vec<u8>) {
        let whole = value.round();
        let little = match self {
            Self::I8 => (whole as i8).to_le_bytes().to_vec(),
            Self::U8 => (whole as u8).to_le_bytes().to_vec(),
            Self::I16 => (whole as i16).to_le_bytes().to_vec(),
            Self::U16 => (whole as u16).to_le_bytes().to_vec(),
            Self::I32 => (whole as i32).to_le_bytes().to_vec(),
            Self::U32 => (whole as u32).to_le_bytes().to_vec(),
            Self::F32 => (value as f32).to_le_bytes().to_vec(),
            Self::F64 => value.to_le_bytes().to_vec(),
        };
        if big_endian {
            bytes.extend(little.into_iter().rev());
        } else {
            bytes.extend(little);
        }
    }

    pub(super) fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }

    /// Decodes the number at the start of `bytes`; exact, since every type fits into an f64.
    pub(crate) fn decode(self, bytes: &[u8], big_endian: bool) -> Option<f64> {
        let mut little = [0_u8; 8];
        let own = little.get_mut(..self.size())?;
        own.copy_from_slice(bytes.get(..self.size())?);
        if big_endian {
            own.reverse();
        }
        let [a, b, c, d, ..] = little;
        Some(match self {
            Self::I8 => f64::from(a as i8),
            Self::U8 => f64::from(a),
            Self::I16 => f64::from(i16::from_le_bytes([a, b])),
            Self::U16 => f64::from(u16::from_le_bytes([a, b])),
            Self::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            Self::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            Self::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            Self::F64 => f64::from_le_bytes(little),
        })
    }
}

/// A reading position in binary data.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<'a> {
    pub bytes: &'a [u8],
    pub offset: usize,
    pub big_endian: bool,
}

impl Cursor<'_> {
    pub(super) fn place(&self) -> Place {
        Place::Byte(self.offset)
    }

    /// Reads the next number; `what` names it in the error at the end of the file.
    pub(super) fn number(&mut self, scalar: Scalar, what: Item) -> Result<f64, SurfaceError> {
        let rest = self.bytes.get(self.offset..).unwrap_or_default();
        let value = scalar.decode(rest, self.big_endian).ok_or_else(|| SurfaceError::missing(self.place(), what))?;
        self.offset += scalar.size();
        Ok(value)
    }

    /// Where the rest begins, if it holds more than blanks and padding: zeros, or the Ctrl-Z of old systems.
    pub(super) fn surplus(&self) -> Option<Place> {
        let rest = self.bytes.get(self.offset..).unwrap_or_default();
        let is_padding = |b: &u8| b.is_ascii_whitespace() || matches!(b, 0 | 0x1A);
        (!rest.iter().all(is_padding)).then(|| self.place())
    }

    /// Skips `count` bytes.
    pub(super) fn skip(&mut self, count: usize, what: Item) -> Result<(), SurfaceError> {
        let end = self.offset.checked_add(count).filter(|&end| end <= self.bytes.len());
        self.offset = end.ok_or_else(|| SurfaceError::missing(self.place(), what))?;
        Ok(())
    }
}
