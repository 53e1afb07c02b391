//! `riemap flatten` from GLB to GLB: scene, materials, images and attributes stay, and the layout is `TEXCOORD_0`.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::surface::{Surface, SurfaceMesh, read_surface};
use serde_json::{Value, json};
use std::path::Path;
use support::program::{folder, succeeds};

const IMAGE: &[u8] = b"\x89PNG and so on";

/// A document in the making.
#[derive(Default)]
struct Glb {
    buffer: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Glb {
    fn view(&mut self, bytes: &[u8]) -> usize {
        self.views.push(json!({ "buffer": 0, "byteOffset": self.buffer.len(), "byteLength": bytes.len() }));
        self.buffer.extend(bytes);
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        self.views.len() - 1
    }

    fn accessor(&mut self, bytes: &[u8], component: u32, count: usize, kind: &str) -> usize {
        let view = self.view(bytes);
        let accessor = json!({ "bufferView": view, "componentType": component, "count": count, "type": kind });
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    fn floats(&mut self, values: &[f32], width: usize) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.accessor(&bytes, 5126, values.len() / width, &format!("VEC{width}"))
    }

    fn file(self, mut document: Value) -> Vec<u8> {
        document["buffers"] = json!([{ "byteLength": self.buffer.len() }]);
        document["bufferViews"] = self.views.into();
        document["accessors"] = self.accessors.into();
        let mut document = document.to_string().into_bytes();
        document.resize(document.len().next_multiple_of(4), b' ');
        let mut bytes = b"glTF\x02\0\0\0".to_vec();
        bytes.extend((28 + document.len() as u32 + self.buffer.len() as u32).to_le_bytes());
        for (kind, chunk) in [(b"JSON", &document), (b"BIN\0", &self.buffer)] {
            bytes.extend((chunk.len() as u32).to_le_bytes());
            bytes.extend(kind);
            bytes.extend(chunk);
        }
        bytes
    }
}

/// 2 × 2 squares from x = `from` on, with normals, colors and coordinates of their own; counter-clockwise if mirrored.
fn primitive(glb: &mut Glb, from: u8, material: u8) -> Value {
    let at = |k: u8| [f32::from(from + k % 3), f32::from(k / 3), 0.25 * f32::from(k / 3 * (from + k % 3))];
    let all = |of: &dyn Fn(u8) -> Vec<f32>| (0..9).flat_map(of).collect::<Vec<f32>>();
    let places = glb.floats(&all(&|k| at(k).to_vec()), 3);
    let normals = glb.floats(&all(&|_| vec![0.0, f32::from(material), f32::from(1 - material)]), 3);
    let coordinates = glb.floats(&all(&|k| vec![at(k)[0] / 4.0, at(k)[1] / 2.0]), 2);
    let colors: Vec<u8> = (0..9).flat_map(|k| [10 * k, material, 5, 255]).collect();
    let colors = glb.accessor(&colors, 5121, 9, "VEC4");
    glb.accessors[colors]["normalized"] = true.into();
    let corners = [0_u16, 1, 3, 4].into_iter().flat_map(|k| [k, k + 4, k + 1, k, k + 3, k + 4]);
    let corners: Vec<u8> = corners.flat_map(u16::to_le_bytes).collect();
    let indices = glb.accessor(&corners, 5123, 24, "SCALAR");
    let attributes = json!({ "POSITION": places, "NORMAL": normals, "TEXCOORD_0": coordinates, "COLOR_0": colors });
    json!({ "material": material, "indices": indices, "attributes": attributes })
}

/// Two primitives side by side under a node that mirrors and moves them; the first material has a texture.
fn two_primitives() -> Vec<u8> {
    let mut glb = Glb::default();
    let primitives = [primitive(&mut glb, 0, 0), primitive(&mut glb, 2, 1)];
    let image = glb.view(IMAGE);
    glb.file(json!({
        "asset": { "version": "2.0", "generator": "by hand" }, "scene": 0, "scenes": [{ "nodes": [0] }],
        "nodes": [{ "children": [1], "translation": [5, 0, 0] }, { "mesh": 0, "name": "sheet", "scale": [-1, 1, 1] }],
        "meshes": [{ "name": "sheet", "primitives": primitives }],
        "materials": [
            { "name": "red", "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } },
              "normalTexture": { "index": 0, "texCoord": 0, "scale": 0.5 } },
            { "name": "blue", "pbrMetallicRoughness": { "baseColorFactor": [0.0, 0.0, 1.0, 1.0] } }],
        "textures": [{ "source": 0 }], "images": [{ "bufferView": image, "mimeType": "image/png" }],
    }))
}

/// The document and the buffer of a file.
fn parsed(bytes: &[u8]) -> (Value, Vec<u8>) {
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!(number(8), bytes.len());
    let json = number(12);
    (serde_json::from_slice(&bytes[20..20 + json]).unwrap(), bytes[28 + json..].to_vec())
}

/// The numbers of an attribute of f32, `width` for each vertex.
fn attribute(bytes: &[u8], primitive: usize, name: &str, width: usize) -> Vec<Vec<f32>> {
    let (document, buffer) = parsed(bytes);
    let size = |value: &Value| value.as_u64().unwrap() as usize;
    let accessor = size(&document["meshes"][0]["primitives"][primitive]["attributes"][name]);
    let accessor = &document["accessors"][accessor];
    let view = &document["bufferViews"][size(&accessor["bufferView"])];
    let bytes = &buffer[size(&view["byteOffset"])..][..size(&view["byteLength"])];
    assert_eq!(bytes.len(), 4 * width * size(&accessor["count"]));
    let numbers: Vec<f32> = bytes.as_chunks().0.iter().map(|&four| f32::from_le_bytes(four)).collect();
    numbers.chunks(width).map(<[f32]>::to_vec).collect()
}

fn flattened(folder: &Path, bytes: &[u8], more: &[&str]) -> Vec<u8> {
    let [given, out] = ["given.glb", "flat.glb"].map(|name| folder.join(name).display().to_string());
    std::fs::write(&given, bytes).unwrap();
    succeeds(&[&["flatten", &*given], more, &["--out", &*out]].concat());
    std::fs::read(out).unwrap()
}

fn surface(bytes: &[u8]) -> Surface {
    read_surface("a.glb", bytes).unwrap()
}

fn area(surface: &Surface) -> f64 {
    let corners = surface.triangles().iter().map(|t| t.map(|v| surface.vertices()[v as usize]));
    corners.map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
}

#[test]
fn scene_materials_images_and_attributes_stay_in_a_glb() {
    let given = two_primitives();
    let written = flattened(&folder("glb"), &given, &["preset:disk", "--uv", "true"]);
    let ((before, _), (mut after, buffer)) = (parsed(&given), parsed(&written));
    assert_eq!(after["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"], json!({ "index": 0, "texCoord": 1 }));
    assert_eq!(after["materials"][0]["normalTexture"], json!({ "index": 0, "texCoord": 1, "scale": 0.5 }));
    after["materials"][0] = before["materials"][0].clone();
    for key in ["asset", "scenes", "nodes", "materials", "textures", "images"] {
        assert_eq!(after[key], before[key], "{key}");
    }
    assert!(buffer.windows(IMAGE.len()).any(|bytes| bytes == IMAGE));
    for part in 0..2 {
        for (name, old, width) in [
            ("POSITION", "POSITION", 3),
            ("NORMAL", "NORMAL", 3),
            ("TEXCOORD_1", "TEXCOORD_0", 2),
            ("COLOR_0", "COLOR_0", 1),
        ] {
            assert_eq!(attribute(&written, part, name, width), attribute(&given, part, old, width), "{name}");
        }
        assert_eq!(
            after["meshes"][0]["primitives"][part]["indices"],
            before["meshes"][0]["primitives"][part]["indices"]
        );
    }
    assert_eq!(surface(&written), surface(&given));
    // both primitives have a vertex at each place of the seam, with the same place in the layout
    let [left, right] = [0, 1].map(|part| attribute(&written, part, "TEXCOORD_0", 2));
    for (k, j) in [(2, 0), (5, 3), (8, 6)] {
        assert_eq!(left[k], right[j]);
    }
    // the rim lies on the unit circle; v points down
    let is_on_rim = |uv: &&Vec<f32>| (uv[0].hypot(1.0 - uv[1]) - 1.0).abs() < 0.02;
    assert_eq!(left.iter().chain(&right).filter(is_on_rim).count(), 14, "{left:?} {right:?}");
}

#[test]
fn new_vertices_have_attributes_and_divide_the_primitive_they_are_in() {
    let given = two_primitives();
    let written = flattened(&folder("glb-corners"), &given, &["preset:square", "--surface-anchor", "@0.03"]);
    let (before, after) = (surface(&given), surface(&written));
    assert!((area(&before) - area(&after)).abs() < 1e-6 && SurfaceMesh::new(&after).is_ok());
    let mut added = 0;
    for part in 0..2 {
        let places = attribute(&written, part, "POSITION", 3);
        added += places.len() - 9;
        assert_eq!(attribute(&written, part, "COLOR_0", 1).len(), places.len());
        assert_eq!(attribute(&written, part, "TEXCOORD_0", 2).len(), places.len());
        let coordinates = attribute(&written, part, "TEXCOORD_1", 2);
        for (place, uv) in places.iter().zip(&coordinates) {
            assert!((place[0] / 4.0 - uv[0]).abs() < 1e-6 && (place[1] / 2.0 - uv[1]).abs() < 1e-6, "{place:?} {uv:?}");
        }
        let normals = attribute(&written, part, "NORMAL", 3);
        assert!(normals.iter().all(|normal| *normal == [0.0, part as f32, 1.0 - part as f32]));
    }
    assert!(added >= 4, "{added}");
    let all: Vec<Vec<f32>> = (0..2).flat_map(|part| attribute(&written, part, "TEXCOORD_0", 2)).collect();
    for corner in [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        assert!(all.iter().any(|uv| *uv == corner), "{corner:?} is not hit");
    }
}

/// A glTF document with its buffer and its image in neighboring files gives one GLB with everything.
#[test]
fn a_gltf_document_takes_its_neighbors_into_the_glb() {
    let folder = folder("gltf");
    let ((mut document, mut buffer), whole) = (parsed(&two_primitives()), surface(&two_primitives()));
    let start = buffer.windows(IMAGE.len()).position(|bytes| bytes == IMAGE).unwrap();
    buffer.truncate(start);
    document["images"] = json!([{ "uri": "a%20picture.png", "name": "wood" }, { "uri": "elsewhere.png" }]);
    document["bufferViews"].as_array_mut().unwrap().pop();
    document["buffers"] = json!([{ "byteLength": buffer.len(), "uri": "sheet.bin" }]);
    let path = |name: &str| folder.join(name).display().to_string();
    std::fs::write(path("sheet.gltf"), document.to_string()).unwrap();
    std::fs::write(path("sheet.bin"), &buffer).unwrap();
    std::fs::write(path("a picture.png"), IMAGE).unwrap();
    succeeds(&["flatten", &path("sheet.gltf"), "preset:disk", "--out", &path("sheet.glb")]);
    let written = std::fs::read(path("sheet.glb")).unwrap();
    let (after, data) = parsed(&written);
    assert_eq!(after["materials"][1], document["materials"][1]);
    assert_eq!(after["nodes"], document["nodes"]);
    let image = &after["images"][0];
    assert_eq!(
        (&image["name"], &image["mimeType"], &image["uri"]),
        (&json!("wood"), &json!("image/png"), &Value::Null)
    );
    let view = &after["bufferViews"][image["bufferView"].as_u64().unwrap() as usize];
    assert_eq!(&data[view["byteOffset"].as_u64().unwrap() as usize..][..IMAGE.len()], IMAGE);
    assert_eq!(after["images"][1], json!({ "uri": "elsewhere.png" }));
    assert_eq!(surface(&written), whole);
}
