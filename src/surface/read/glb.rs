//! GLB: a glTF document and its first buffer in one binary file.

use super::scalar::{Cursor, Scalar};
use super::{Fault, Item, Neighbor, Place, SurfaceError, Unsupported, gltf};
use crate::surface::Surface;
use serde_json::Value;

/// Signature, version and length.
const HEADER: usize = 12;
const JSON: u32 = 0x4E4F_534A;
const BINARY: u32 = 0x004E_4942;

/// Reads the JSON chunk and the binary chunk; others are skipped.
pub(super) fn read(bytes: &[u8], neighbor: &mut Neighbor) -> Result<Surface, SurfaceError> {
    let GlbChunks { document, buffer } = GlbChunks::of(bytes)?;
    gltf::read(document, buffer, neighbor)
}

/// The chunks of a file.
pub(crate) struct GlbChunks<'a> {
    /// The document.
    pub document: &'a [u8],
    /// Its first buffer, with up to 3 bytes of padding.
    pub buffer: Option<&'a [u8]>,
}

impl<'a> GlbChunks<'a> {
    /// Finds the chunks.
    pub(crate) fn of(bytes: &'a [u8]) -> Result<Self, SurfaceError> {
        let [document, buffer] = chunks(bytes)?;
        let missing = || SurfaceError::missing(Place::Byte(12), Item::JsonChunk);
        Ok(Self { document: document.ok_or_else(missing)?, buffer })
    }
}

/// The JSON chunk and the binary chunk.
fn chunks(bytes: &[u8]) -> Result<[Option<&[u8]>; 2], SurfaceError> {
    if !bytes.starts_with(b"glTF") {
        return Err(SurfaceError::malformed(Place::Byte(0), Fault::NotGlb));
    }
    let mut cursor = Cursor { bytes, offset: 4, big_endian: false };
    let version = cursor.number(Scalar::U32, Item::Version)?;
    if version != 2.0 {
        return Err(SurfaceError::unsupported(Place::Byte(4), Unsupported::Version(version as u32)));
    }
    let length = cursor.number(Scalar::U32, Item::FileLength)? as usize;
    let (mut document, mut buffer) = (None, None);
    // what follows the length that the file says it has is padding
    let end = if (HEADER..bytes.len()).contains(&length) { length } else { bytes.len() };
    while cursor.offset < end {
        let length = cursor.number(Scalar::U32, Item::ChunkLength)? as usize;
        let kind = cursor.number(Scalar::U32, Item::ChunkType)? as u32;
        let start = cursor.offset;
        cursor.skip(length, Item::Chunk { length })?;
        let chunk = &bytes[start..cursor.offset];
        match kind {
            JSON if document.is_none() => document = Some(without_padding(chunk)),
            BINARY if buffer.is_none() => buffer = Some(chunk),
            _ => {}
        }
    }
    Ok([document, buffer])
}

/// A text without the zeros that some programs fill it up with, where the standard has blanks.
fn without_padding(text: &[u8]) -> &[u8] {
    let end = text.iter().rposition(|&b| b != 0).map_or(0, |last| last + 1);
    &text[..end]
}

/// A GLB file of a document and its buffer, whose length is a multiple of 4.
pub(crate) fn container(document: &Value, buffer: &[u8]) -> Vec<u8> {
    let mut document = document.to_string().into_bytes();
    document.resize(document.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((28 + document.len() as u32 + buffer.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &*document), (b"BIN\0", buffer)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}
