//! Packs a glTF document, its buffers and its images into one GLB file.

use super::gltf_buffers::{loaded, unescaped};
use super::{MAX_BYTES, Neighbor, Place, decoded, glb};
use serde_json::{Value, json};
use std::collections::{BTreeSet, HashMap};

/// The most bytes of images that are packed; others stay outside.
const MOST_IMAGE_BYTES: usize = 64 << 20;

/// A document as one file.
pub struct PackedGltf {
    /// The GLB file.
    pub bytes: Vec<u8>,
    /// The names of the neighboring files that are in it.
    pub neighbors: BTreeSet<String>,
}

/// The GLB file with the content of a document (glTF 2.0, sections 3.6.1 and 4.4). Buffers and images may be `data:` URIs or in
/// neighboring files; those that are in none of these keep their URI. `None` if this is no document. Not packed is what makes
/// it larger than [`MAX_BYTES`], or of images more than 64 MB.
pub fn packed(document: &[u8], neighbor: &mut Neighbor) -> Option<PackedGltf> {
    let mut document: Value = serde_json::from_slice(&decoded(document)).ok()?;
    let buffers = document.get_mut("buffers")?.as_array_mut().map(std::mem::take)?;
    let mut whole = Whole::default();
    let mut kept = vec![Value::Null];
    let mut places = Vec::with_capacity(buffers.len());
    for buffer in buffers {
        let part = whole.part(&buffer, neighbor, &|_, total| total <= MAX_BYTES);
        places.push(part.map_or(BufferPlace::Kept(kept.len()), BufferPlace::Packed));
        if part.is_none() {
            kept.push(buffer);
        }
    }
    let mut views = match document.get_mut("bufferViews").map(Value::take) {
        Some(Value::Array(views)) => views,
        _ => Vec::new(),
    };
    for view in &mut views {
        // as it is read without one
        view.as_object_mut()?.entry("buffer").or_insert(0.into());
        move_view(view, &places);
    }
    let limit = whole.bytes.len() + MOST_IMAGE_BYTES;
    for image in document.get_mut("images").and_then(Value::as_array_mut).into_iter().flatten() {
        let is_taken = |bytes: &[u8], total| total <= limit && mime_type(bytes).is_some();
        let Some(part) = whole.part(image, neighbor, &is_taken) else { continue };
        let Some(kind) = mime_type(&whole.bytes[part.start..]) else { continue };
        image.as_object_mut()?.remove("uri");
        image["mimeType"] = kind.into();
        image["bufferView"] = views.len().into();
        views.push(json!({ "buffer": 0, "byteOffset": part.start, "byteLength": part.length }));
    }
    kept[0] = json!({ "byteLength": whole.bytes.len() });
    document["bufferViews"] = views.into();
    document["buffers"] = kept.into();
    Some(PackedGltf { bytes: glb::container(&document, &whole.bytes), neighbors: whole.neighbors })
}

/// The buffer of the packed file.
#[derive(Default)]
struct Whole {
    bytes: Vec<u8>,
    /// The parts by their URIs.
    parts: HashMap<String, Part>,
    /// The neighboring files among them.
    neighbors: BTreeSet<String>,
}

/// A part of a buffer.
#[derive(Debug, Clone, Copy)]
struct Part {
    start: usize,
    length: usize,
}

/// Where a buffer is now.
#[derive(Debug, Clone, Copy)]
enum BufferPlace {
    /// In the packed file's own.
    Packed(Part),
    /// Beside it, with this index.
    Kept(usize),
}

impl Whole {
    /// The part with the bytes of a buffer or of an image, each at a multiple of 4; `None` if these are elsewhere, or not
    /// taken; there would be so many bytes in all.
    fn part(
        &mut self,
        owner: &Value,
        neighbor: &mut Neighbor,
        is_taken: &dyn Fn(&[u8], usize) -> bool,
    ) -> Option<Part> {
        let uri = owner.get("uri")?.as_str()?;
        if let Some(part) = self.parts.get(uri) {
            return Some(*part);
        }
        let bytes = loaded(uri, Place::Byte(0), neighbor).ok()?;
        let part = Part { start: self.bytes.len(), length: bytes.len() };
        if !is_taken(&bytes, part.start + part.length) {
            return None;
        }
        self.bytes.extend_from_slice(&bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.parts.insert(uri.to_owned(), part);
        if !uri.starts_with("data:") {
            self.neighbors.insert(unescaped(uri));
        }
        Some(part)
    }
}

/// An offset at which no buffer has a byte.
const NOWHERE: u32 = u32::MAX;

/// Moves a view, and those of its extensions, to where its buffer is now. A view that reaches beyond its buffer is one beyond
/// the new one, so that no reader takes the bytes of another.
fn move_view(view: &mut Value, places: &[BufferPlace]) {
    let number = |view: &Value, key: &str| match view.get(key) {
        Some(number) => number.as_u64().map(|number| number as usize),
        None => Some(0),
    };
    let buffer = view.get("buffer").and_then(Value::as_u64).and_then(|buffer| places.get(buffer as usize));
    match buffer {
        Some(BufferPlace::Kept(index)) => view["buffer"] = (*index).into(),
        Some(BufferPlace::Packed(part)) => {
            let (offset, length) = (number(view, "byteOffset"), number(view, "byteLength"));
            let end = offset.zip(length).and_then(|(offset, length)| offset.checked_add(length));
            let is_inside = end.is_some_and(|end| end <= part.length);
            let start = offset.filter(|_| is_inside).map_or(NOWHERE as usize, |offset| part.start + offset);
            view["buffer"] = 0.into();
            view["byteOffset"] = start.into();
        }
        None => {}
    }
    let extensions = view.get_mut("extensions").and_then(Value::as_object_mut);
    for (_, extension) in extensions.into_iter().flatten() {
        move_view(extension, places);
    }
}

/// The kind of a picture, by its first bytes.
fn mime_type(bytes: &[u8]) -> Option<&'static str> {
    let kinds: [(&[u8], &str); 3] =
        [(b"\x89PNG", "image/png"), (b"\xFF\xD8\xFF", "image/jpeg"), (b"\xABKTX 20", "image/ktx2")];
    let is_webp = bytes.get(8..12) == Some(b"WEBP");
    let known = kinds.iter().find(|(start, _)| bytes.starts_with(start)).map(|(_, kind)| *kind);
    known.or(is_webp.then_some("image/webp"))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::surface::{SurfaceError, read_surface, read_surface_beside};

    /// A triangle whose positions are 36 bytes of a buffer, and another buffer.
    fn document(offset: &str, buffers: &str) -> String {
        format!(
            r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],
            "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}}],
            "bufferViews":[{{"buffer":0,"byteLength":36,"byteOffset":{offset}}}],"buffers":{buffers}}}"#
        )
    }

    fn corners(name: &str) -> Option<Vec<u8>> {
        let corners: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let bytes: Vec<u8> = corners.iter().flat_map(|x| x.to_le_bytes()).collect();
        match name {
            "a.bin" => Some(bytes),
            "cut.bin" => Some(bytes[..30].to_vec()),
            "b.bin" => Some(vec![1; 400]),
            _ => None,
        }
    }

    fn read(offset: &str, buffers: &str) -> Result<usize, SurfaceError> {
        let whole = packed(document(offset, buffers).as_bytes(), &mut corners).unwrap();
        read_surface("a.gltf", &whole.bytes).map(|surface| surface.triangles().len())
    }

    #[test]
    fn a_packed_document_is_read_as_before_and_refused_where_it_was() {
        let both = r#"[{"uri":"a.bin","byteLength":36},{"uri":"b.bin","byteLength":400}]"#;
        assert_eq!(read("0", both).unwrap(), 1);
        for offset in ["4", "36.5", "-4", "1e30"] {
            assert!(read(offset, both).is_err(), "{offset}");
        }
        let nameless = document("0", &both.replace("a.bin", "cut.bin")).replace(r#""buffer":0,"#, "");
        let whole = packed(nameless.as_bytes(), &mut corners).unwrap();
        assert!(read_surface("a.gltf", &whole.bytes).is_err());
        let cut = both.replace("a.bin", "cut.bin");
        let unpacked = read_surface_beside("a.gltf", document("0", &cut).as_bytes(), &mut corners).unwrap_err();
        assert_eq!(read("0", &cut).unwrap_err(), unpacked);
    }

    #[test]
    fn a_missing_buffer_is_named_and_the_others_are_packed() {
        let text = read("0", r#"[{"uri":"a.bin"},{"uri":"missing.bin"}]"#).unwrap_err().to_string();
        assert!(text.contains("missing.bin"), "{text}");
    }

    #[test]
    fn a_file_that_is_named_often_is_packed_once() {
        let buffers = vec![r#"{"uri":"a.bin"}"#; 1000].join(",");
        let whole = packed(document("0", &format!("[{buffers}]")).as_bytes(), &mut corners).unwrap();
        assert!(whole.bytes.len() < 1000 && whole.neighbors.len() == 1, "{}", whole.bytes.len());
    }
}
