//! The buffers of a glTF document, and typed reading from them.

use super::gltf::Document;
use super::scalar::Scalar;
use super::{Fault, Item, Place, SurfaceError, Unsupported};
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
    pub(super) fn new(document: &'a Document, binary: Option<&'a [u8]>) -> Result<Self, SurfaceError> {
        let load = |(k, uri): (usize, Option<&'a str>)| -> Result<Cow<'a, [u8]>, SurfaceError> {
            let place = || Place::Part(format!("buffers[{k}]"));
            match uri {
                Some(uri) => embedded(uri, place()).map(Cow::Owned),
                None if k == 0 => binary.map(Cow::Borrowed).ok_or_else(|| SurfaceError::missing(place(), Item::Data)),
                None => Err(SurfaceError::missing(place(), Item::Data)),
            }
        };
        let bytes = document.buffers.iter().map(|buffer| buffer.uri.as_deref()).enumerate().map(load);
        Ok(Self { document, bytes: bytes.collect::<Result<_, _>>()? })
    }

    /// An accessor of positions.
    pub(super) fn points(&self, accessor: usize) -> Result<Vec<DVec3>, SurfaceError> {
        let mut points = Vec::new();
        self.read(accessor, "VEC3", &[(5126, Scalar::F32)], |[x, y, z]| points.push(DVec3::new(x, y, z)))?;
        Ok(points)
    }

    /// An accessor of vertex indices.
    pub(super) fn indices(&self, accessor: usize) -> Result<Vec<u32>, SurfaceError> {
        let types = [(5121, Scalar::U8), (5123, Scalar::U16), (5125, Scalar::U32)];
        let mut indices = Vec::new();
        self.read(accessor, "SCALAR", &types, |[index]| indices.push(index as u32))?;
        Ok(indices)
    }

    /// Reads `K` numbers for each element of an accessor.
    fn read<const K: usize>(
        &self,
        index: usize,
        kind: &'static str,
        types: &[(u32, Scalar)],
        mut take: impl FnMut([f64; K]),
    ) -> Result<(), SurfaceError> {
        let place = || Place::Part(format!("accessors[{index}]"));
        let missing = |what: Item| SurfaceError::missing(place(), what);
        let accessor = self.document.accessors.get(index).ok_or_else(|| missing(Item::Accessor))?;
        if accessor.sparse.is_some() {
            return Err(SurfaceError::unsupported(place(), Unsupported::SparseAccessor));
        }
        let scalar = types.iter().find(|(code, _)| *code == accessor.component_type).map(|(_, scalar)| *scalar);
        let (Some(scalar), true) = (scalar, accessor.kind == kind) else {
            let (found, component) = (accessor.kind.clone(), accessor.component_type);
            return Err(SurfaceError::malformed(place(), Fault::AccessorType { found, component, needed: kind }));
        };
        let view = accessor.buffer_view.ok_or_else(|| missing(Item::BufferView))?;
        let view = self.document.buffer_views.get(view).ok_or_else(|| missing(Item::BufferView))?;
        let buffer = self.bytes.get(view.buffer).ok_or_else(|| missing(Item::Buffer))?;
        let end = view.byte_offset.checked_add(view.byte_length);
        let bytes = end.and_then(|end| buffer.get(view.byte_offset..end));
        let bytes = bytes.ok_or_else(|| missing(Item::ViewedData))?;
        if accessor.count > bytes.len() {
            return Err(missing(Item::Element { index: bytes.len(), count: accessor.count }));
        }
        let stride = view.byte_stride.unwrap_or(K * scalar.size());
        for element in 0..accessor.count {
            let start = element.checked_mul(stride).and_then(|start| start.checked_add(accessor.byte_offset));
            let mut values = [0.0; K];
            for (k, value) in values.iter_mut().enumerate() {
                let rest = start.and_then(|start| bytes.get(start.checked_add(k * scalar.size())?..));
                let found = rest.and_then(|rest| scalar.decode(rest, false));
                *value = found.ok_or_else(|| missing(Item::Element { index: element, count: accessor.count }))?;
            }
            take(values);
        }
        Ok(())
    }
}

/// The bytes in a `data:` URI.
fn embedded(uri: &str, place: Place) -> Result<Vec<u8>, SurfaceError> {
    let Some((kind, text)) = uri.strip_prefix("data:").and_then(|rest| rest.split_once(',')) else {
        let name: String = uri.chars().take(60).collect();
        return Err(SurfaceError::unsupported(place, Unsupported::SeparateFile(name)));
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

/// Base 64 (RFC 4648, section 4), taken with or without padding.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);
