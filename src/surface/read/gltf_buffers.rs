//! The buffers of a glTF document, and typed reading from them.

use super::gltf::{Document, Sparse};
use super::scalar::Scalar;
use super::{Fault, Item, Neighbor, Place, SurfaceError, Unsupported};
use crate::geometry::DVec3;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use base64::{DecodeError, Engine as _};
use std::borrow::Cow;

/// The bytes of all buffers.
pub(super) struct Buffers<'a> {
    document: &'a Document,
    bytes: Vec<Cow<'a, [u8]>>,
}

impl<'a> Buffers<'a> {
    pub(super) fn new(
        document: &'a Document,
        binary: Option<&'a [u8]>,
        neighbor: &mut Neighbor,
    ) -> Result<Self, SurfaceError> {
        let load = |(k, uri): (usize, Option<&'a str>)| -> Result<Cow<'a, [u8]>, SurfaceError> {
            let place = || Place::Part(format!("buffers[{k}]"));
            match uri {
                Some(uri) => loaded(uri, place(), neighbor).map(Cow::Owned),
                None if k == 0 => binary.map(Cow::Borrowed).ok_or_else(|| SurfaceError::missing(place(), Item::Data)),
                None => Err(SurfaceError::missing(place(), Item::Data)),
            }
        };
        let bytes = document.buffers.iter().map(|buffer| buffer.uri.as_deref()).enumerate().map(load);
        Ok(Self { document, bytes: bytes.collect::<Result<_, _>>()? })
    }

    /// An accessor of positions, quantized or not.
    pub(super) fn points(&self, accessor: usize) -> Result<Vec<DVec3>, SurfaceError> {
        let types =
            [(5126, Scalar::F32), (5120, Scalar::I8), (5121, Scalar::U8), (5122, Scalar::I16), (5123, Scalar::U16)];
        Ok(self.read(accessor, "VEC3", &types)?.into_iter().map(DVec3::from_array).collect())
    }

    /// An accessor of vertex indices.
    pub(super) fn indices(&self, accessor: usize) -> Result<Vec<u32>, SurfaceError> {
        Ok(self.read(accessor, "SCALAR", &INDEX_TYPES)?.into_iter().map(|[index]| index as u32).collect())
    }

    /// `K` numbers for each element of an accessor.
    fn read<const K: usize>(
        &self,
        index: usize,
        kind: &'static str,
        types: &[(u32, Scalar)],
    ) -> Result<Vec<[f64; K]>, SurfaceError> {
        let place = || Place::Part(format!("accessors[{index}]"));
        let missing = |what: Item| SurfaceError::missing(place(), what);
        let accessor = self.document.accessors.get(index).ok_or_else(|| missing(Item::Accessor))?;
        let scalar = scalar_of(types, accessor.component_type);
        let (Some(scalar), true) = (scalar, accessor.kind == kind) else {
            let (found, component) = (accessor.kind.clone(), accessor.component_type);
            return Err(SurfaceError::malformed(place(), Fault::AccessorType { found, component, needed: kind }));
        };
        let mut elements = match (accessor.buffer_view, &accessor.sparse) {
            (None, Some(_)) if accessor.count <= MAX_ELEMENTS => vec![[0.0; K]; accessor.count],
            (view, _) => self.elements(view, accessor.byte_offset, scalar, accessor.count, &place)?,
        };
        if let Some(Sparse { count, indices, values }) = &accessor.sparse {
            let needed = "SCALAR";
            let Some(index_type) = scalar_of(&INDEX_TYPES, indices.component_type) else {
                let component = indices.component_type;
                let fault = Fault::AccessorType { found: needed.to_owned(), component, needed };
                return Err(SurfaceError::malformed(place(), fault));
            };
            let at: Vec<[f64; 1]> =
                self.elements(indices.buffer_view, indices.byte_offset, index_type, *count, &place)?;
            let new = self.elements(values.buffer_view, values.byte_offset, scalar, *count, &place)?;
            for ([at], new) in at.into_iter().zip(new) {
                let element = elements.get_mut(at as usize);
                *element.ok_or_else(|| missing(Item::Element { index: at as usize, count: accessor.count }))? = new;
            }
        }
        if accessor.normalized {
            elements.as_flattened_mut().iter_mut().for_each(|value| *value = normalized(*value, scalar));
        }
        Ok(elements)
    }

    /// `K` numbers for each of `count` elements in a buffer view.
    fn elements<const K: usize>(
        &self,
        view: Option<usize>,
        offset: usize,
        scalar: Scalar,
        count: usize,
        place: &dyn Fn() -> Place,
    ) -> Result<Vec<[f64; K]>, SurfaceError> {
        let missing = |what: Item| SurfaceError::missing(place(), what);
        let view = view.and_then(|view| self.document.buffer_views.get(view));
        let view = view.ok_or_else(|| missing(Item::BufferView))?;
        let buffer = self.bytes.get(view.buffer).ok_or_else(|| missing(Item::Buffer))?;
        let end = view.byte_offset.checked_add(view.byte_length);
        let bytes = end.and_then(|end| buffer.get(view.byte_offset..end));
        let bytes = bytes.ok_or_else(|| missing(Item::ViewedData))?;
        if count > bytes.len() {
            return Err(missing(Item::Element { index: bytes.len(), count }));
        }
        let stride = view.byte_stride.unwrap_or(K * scalar.size());
        let mut elements = vec![[0.0; K]; count];
        for (index, element) in elements.iter_mut().enumerate() {
            let start = index.checked_mul(stride).and_then(|start| start.checked_add(offset));
            for (k, value) in element.iter_mut().enumerate() {
                let rest = start.and_then(|start| bytes.get(start.checked_add(k * scalar.size())?..));
                let found = rest.and_then(|rest| scalar.decode(rest, false));
                *value = found.ok_or_else(|| missing(Item::Element { index, count }))?;
            }
        }
        Ok(elements)
    }
}

/// The types of vertex indices.
const INDEX_TYPES: [(u32, Scalar); 3] = [(5121, Scalar::U8), (5123, Scalar::U16), (5125, Scalar::U32)];

/// The most elements of an accessor without a buffer view, of which no file is the measure.
const MAX_ELEMENTS: usize = 12_000_000;

fn scalar_of(types: &[(u32, Scalar)], code: u32) -> Option<Scalar> {
    types.iter().find(|(known, _)| *known == code).map(|(_, scalar)| *scalar)
}

/// A normalized integer as a number in [−1, 1] (glTF 2.0, section 3.6.2.2).
fn normalized(value: f64, scalar: Scalar) -> f64 {
    match scalar {
        Scalar::I8 => (value / 127.0).max(-1.0),
        Scalar::U8 => value / 255.0,
        Scalar::I16 => (value / 32_767.0).max(-1.0),
        Scalar::U16 => value / 65_535.0,
        _ => value,
    }
}

/// The bytes in a `data:` URI, or in the neighboring file that a relative one names.
pub(super) fn loaded(uri: &str, place: Place, neighbor: &mut Neighbor) -> Result<Vec<u8>, SurfaceError> {
    let Some((kind, text)) = uri.strip_prefix("data:").and_then(|rest| rest.split_once(',')) else {
        let name = unescaped(uri);
        let found = if is_neighbor(&name) { neighbor(&name) } else { None };
        let missing = || SurfaceError::unsupported(place, Unsupported::SeparateFile(name.chars().take(60).collect()));
        return found.ok_or_else(missing);
    };
    if !kind.ends_with(";base64") {
        return Err(SurfaceError::unsupported(place, Unsupported::Encoding));
    }
    BASE64.decode(text).map_err(|error| {
        let position = match error {
            DecodeError::InvalidByte(position, _) => position,
            _ => text.len(),
        };
        SurfaceError::malformed(place, Fault::Base64 { position })
    })
}

/// The name in a URI, its `%` escapes decoded (RFC 3986, section 2.1).
pub(super) fn unescaped(uri: &str) -> String {
    let bytes = uri.as_bytes();
    let mut name = Vec::with_capacity(bytes.len());
    let mut k = 0;
    while k < bytes.len() {
        let digits = uri.get(k + 1..k + 3).and_then(|digits| u8::from_str_radix(digits, 16).ok());
        match digits {
            Some(byte) if bytes[k] == b'%' => {
                name.push(byte);
                k += 3;
            }
            _ => {
                name.push(bytes[k]);
                k += 1;
            }
        }
    }
    String::from_utf8_lossy(&name).into_owned()
}

/// Whether a name is that of a file in the same folder or below: no address, no way upwards.
fn is_neighbor(name: &str) -> bool {
    !name.contains(':') && !name.starts_with(['/', '\\']) && !name.split(['/', '\\']).any(|part| part == "..")
}

/// Base 64 (RFC 4648, section 4), taken with or without padding.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);
