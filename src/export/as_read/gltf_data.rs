//! A glTF document with its buffer, to which accessors are added.

use crate::surface::{GlbChunks, Scalar, container};
use serde_json::{Value, json};

/// A document whose only buffer is in its file.
pub(super) struct GltfData {
    /// The document.
    pub document: Value,
    buffer: Vec<u8>,
}

/// The elements of an accessor, one after the other.
#[derive(Debug, Clone)]
pub(super) struct Elements {
    component: u64,
    kind: String,
    is_normalized: bool,
    bounds: [Value; 2],
    bytes: Vec<u8>,
}

/// The types of components by their codes.
const COMPONENTS: [(u64, Scalar); 6] = [
    (5120, Scalar::I8),
    (5121, Scalar::U8),
    (5122, Scalar::I16),
    (5123, Scalar::U16),
    (5125, Scalar::U32),
    (5126, Scalar::F32),
];
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

impl GltfData {
    /// `None` if the document has another buffer than that of the file.
    pub(super) fn new(chunks: &GlbChunks<'_>) -> Option<Self> {
        let document: Value = serde_json::from_slice(chunks.document).ok()?;
        let [buffer] = document["buffers"].as_array()?.as_slice() else { return None };
        let length = buffer["byteLength"].as_u64()? as usize;
        let is_own = buffer.is_object() && buffer["uri"].is_null();
        let buffer = chunks.buffer?.get(..length)?.to_vec();
        is_own.then_some(Self { document, buffer })
    }

    /// A primitive of a mesh, with attributes by their names.
    pub(super) fn primitive(&mut self, [mesh, k]: [usize; 2]) -> Option<&mut Value> {
        let primitive = self.document.get_mut("meshes")?.get_mut(mesh)?.get_mut("primitives")?.get_mut(k)?;
        primitive.get("attributes")?.is_object().then_some(primitive)
    }

    /// The elements of an accessor; `None` if it is sparse, or of matrices.
    pub(super) fn elements(&self, accessor: usize) -> Option<Elements> {
        let accessor = self.document["accessors"].get(accessor)?;
        let view = self.document["bufferViews"].get(accessor["bufferView"].as_u64()? as usize)?;
        if accessor.get("sparse").is_some() {
            return None;
        }
        let whole = |value: &Value| value.as_u64().unwrap_or(0) as usize;
        let mut elements = Elements {
            component: accessor["componentType"].as_u64()?,
            kind: accessor["type"].as_str()?.to_owned(),
            is_normalized: accessor["normalized"].as_bool().unwrap_or(false),
            bounds: ["min", "max"].map(|key| accessor[key].clone()),
            bytes: Vec::new(),
        };
        let size = elements.size()?;
        let start = whole(&view["byteOffset"]).checked_add(whole(&accessor["byteOffset"]))?;
        let stride = if view["byteStride"].is_null() { size } else { whole(&view["byteStride"]) };
        if stride < size {
            return None;
        }
        for k in 0..whole(&accessor["count"]) {
            let at = k.checked_mul(stride)?.checked_add(start)?;
            elements.bytes.extend(self.buffer.get(at..)?.get(..size)?);
        }
        Some(elements)
    }

    /// Adds an accessor of vertex attributes; its number. `None` if it is of matrices.
    pub(super) fn add(&mut self, elements: &Elements) -> Option<usize> {
        let size = elements.size()?;
        let stride = size.next_multiple_of(4);
        let count = elements.bytes.len() / size;
        let mut bytes = Vec::with_capacity(count * stride);
        for element in elements.bytes.chunks(size) {
            bytes.extend(element);
            bytes.resize(bytes.len().next_multiple_of(4), 0);
        }
        let mut accessor = json!({ "componentType": elements.component, "count": count, "type": elements.kind });
        if elements.is_normalized {
            accessor["normalized"] = true.into();
        }
        for (key, bound) in ["min", "max"].into_iter().zip(&elements.bounds).filter(|(_, bound)| !bound.is_null()) {
            accessor[key] = bound.clone();
        }
        self.added(accessor, &bytes, json!({ "byteStride": stride, "target": ARRAY_BUFFER }))
    }

    /// Adds an accessor of vertex triples; its number.
    pub(super) fn add_triangles(&mut self, triangles: &[[u32; 3]]) -> Option<usize> {
        let bytes: Vec<u8> = triangles.as_flattened().iter().flat_map(|v| v.to_le_bytes()).collect();
        let accessor = json!({ "componentType": 5125, "count": 3 * triangles.len(), "type": "SCALAR" });
        self.added(accessor, &bytes, json!({ "target": ELEMENT_ARRAY_BUFFER }))
    }

    /// Adds an accessor of pairs of f32; its number.
    pub(super) fn add_pairs(&mut self, pairs: impl Iterator<Item = [f64; 2]>) -> Option<usize> {
        let bytes = pairs.flatten().flat_map(|value| (value as f32).to_le_bytes()).collect();
        let (kind, bounds) = ("VEC2".to_owned(), [Value::Null, Value::Null]);
        self.add(&Elements { component: 5126, kind, is_normalized: false, bounds, bytes })
    }

    fn added(&mut self, mut accessor: Value, bytes: &[u8], mut view: Value) -> Option<usize> {
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        view["buffer"] = 0.into();
        view["byteOffset"] = self.buffer.len().into();
        view["byteLength"] = bytes.len().into();
        self.buffer.extend_from_slice(bytes);
        let views = self.document["bufferViews"].as_array_mut()?;
        accessor["bufferView"] = views.len().into();
        views.push(view);
        let accessors = self.document["accessors"].as_array_mut()?;
        accessors.push(accessor);
        Some(accessors.len() - 1)
    }

    /// The file.
    pub(super) fn bytes(mut self) -> Vec<u8> {
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        self.document["buffers"][0]["byteLength"] = self.buffer.len().into();
        container(&self.document, &self.buffer)
    }
}

impl Elements {
    fn scalar(&self) -> Option<Scalar> {
        COMPONENTS.iter().find(|(code, _)| *code == self.component).map(|(_, scalar)| *scalar)
    }

    /// The size of an element in bytes.
    fn size(&self) -> Option<usize> {
        let kinds = ["SCALAR", "VEC2", "VEC3", "VEC4"];
        Some(self.scalar()?.size() * (1 + kinds.iter().position(|kind| *kind == self.kind)?))
    }

    /// The number of elements.
    pub(super) fn count(&self) -> Option<usize> {
        self.bytes.len().checked_div(self.size()?)
    }

    /// Appends a copy of an element.
    pub(super) fn copy(&mut self, element: u32) -> Option<()> {
        let (start, size) = (element as usize, self.size()?);
        let copied = self.bytes.get(start * size..(start + 1) * size)?.to_vec();
        self.bytes.extend(copied);
        Some(())
    }

    /// Appends the weighted mean of elements, of unit length if `is_direction`.
    pub(super) fn mix(&mut self, weights: &[(u32, f64)], is_direction: bool) -> Option<()> {
        let (scalar, size) = (self.scalar()?, self.size()?);
        let mut sum = vec![0.0; size / scalar.size()];
        for &(element, weight) in weights {
            let bytes = self.bytes.get(element as usize * size..)?;
            for (k, value) in sum.iter_mut().enumerate() {
                *value += weight * scalar.decode(bytes.get(k * scalar.size()..)?, false)?;
            }
        }
        let length = sum.iter().map(|value| value * value).sum::<f64>().sqrt();
        let scale = if is_direction && length > 0.0 && scalar == Scalar::F32 { 1.0 / length } else { 1.0 };
        for value in sum {
            scalar.encode(value * scale, false, &mut self.bytes);
        }
        Some(())
    }
}
