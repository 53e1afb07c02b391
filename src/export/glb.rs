//! A flattened surface as a binary glTF 2.0 file, self-contained: one mesh with normals and one material.
//!
//! Numbers are f32, as glTF requires. If f32 would lose the surface's shape, positions are stored relative to its center
//! and scaled to unit size, and the node holds the transformation. The second texture coordinate is 1 − v, since glTF's
//! points down. Normals are the means of the triangles' normals at a vertex, weighted by their areas.
//!
//! | | `TEXCOORD_0` | `TEXCOORD_1` |
//! |---|---|---|
//! | without a picture | the layout | – |
//! | with a picture, as the base color | the picture's | the layout |

use super::flattened::{Division, Placement};
use crate::geometry::{DVec2, DVec3};
use crate::surface::container;
use serde_json::{Value, json};

/// Triangles in space.
pub(super) struct Shape<'a> {
    /// Positions.
    pub vertices: &'a [DVec3],
    /// Vertex triples.
    pub triangles: &'a [[u32; 3]],
}

/// The surface to be written.
pub(super) struct Mesh<'a> {
    /// Positions and triangles.
    pub shape: Shape<'a>,
    /// Texture coordinates in the layout, v up, one for each vertex.
    pub coordinates: &'a [DVec2],
}

/// The picture of a GLB's material.
pub struct Base<'a> {
    /// The bytes of a PNG file. Beyond its edges the outermost pixels are repeated.
    pub png: &'a [u8],
    /// The place in the picture of a position in the outline, as parts of its width and height from its upper left corner.
    pub lookup: &'a dyn Fn(DVec2) -> DVec2,
}

/// A neutral light gray, for surfaces without a picture.
const PLAIN: [f64; 4] = [0.8, 0.8, 0.8, 1.0];
/// Neither glossy nor powdery: most viewers light it as they do plaster.
const ROUGHNESS: f64 = 0.8;
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const LINEAR: u32 = 9729;
const LINEAR_MIPMAP_LINEAR: u32 = 9987;
const CLAMP_TO_EDGE: u32 = 33071;

/// The file. `placement` is that of the coordinates; `divisions` are of the last vertices.
pub(super) fn encode(
    mesh: &Mesh<'_>,
    placement: Placement,
    divisions: &[Division],
    base: Option<&Base<'_>>,
) -> Vec<u8> {
    let mut file = File::default();
    let (frame, mut attributes) = file.shape(&mesh.shape);
    let layout: Vec<f64> = mesh.coordinates.iter().flat_map(|uv| [uv.x, 1.0 - uv.y]).collect();
    if let Some(base) = base {
        let looked_up = |uv: &DVec2| (base.lookup)(placement.position(*uv)).to_array();
        attributes["TEXCOORD_0"] =
            file.floats(&mesh.coordinates.iter().flat_map(looked_up).collect::<Vec<_>>(), 2).into();
        attributes["TEXCOORD_1"] = file.floats(&layout, 2).into();
    } else {
        attributes["TEXCOORD_0"] = file.floats(&layout, 2).into();
    }
    let indices = file.indices(mesh.shape.triangles);
    let mut document = document(frame, &attributes, indices, base.is_some());
    if !divisions.is_empty() {
        document["meshes"][0]["extras"] = json!({ "divisions": divisions });
    }
    if let Some(base) = base {
        let view = file.view(base.png, None);
        document["images"] = json!([{ "bufferView": view, "mimeType": "image/png", "name": "picture" }]);
        document["samplers"] = json!([{ "magFilter": LINEAR, "minFilter": LINEAR_MIPMAP_LINEAR,
            "wrapS": CLAMP_TO_EDGE, "wrapT": CLAMP_TO_EDGE }]);
        document["textures"] = json!([{ "sampler": 0, "source": 0 }]);
    }
    file.bytes(document)
}

/// The file of a surface with coordinates in space, which are the attribute `_SOURCE`, as they are.
pub(super) fn encode_mapped(vertices: &[DVec3], triangles: &[[u32; 3]], source: &[DVec3]) -> Vec<u8> {
    let mut file = File::default();
    let (frame, mut attributes) = file.shape(&Shape { vertices, triangles });
    attributes["_SOURCE"] = file.vectors(source).into();
    let indices = file.indices(triangles);
    file.bytes(document(frame, &attributes, indices, false))
}

/// One mesh in a scene, with a material.
fn document(frame: (DVec3, f64), attributes: &Value, indices: usize, has_picture: bool) -> Value {
    json!({
        "asset": { "version": "2.0", "generator": "riemap" },
        "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [node(frame)],
        "meshes": [{ "primitives": [{ "attributes": attributes, "indices": indices, "material": 0 }] }],
        "materials": [material(has_picture)],
    })
}

fn node((middle, size): (DVec3, f64)) -> Value {
    if (middle, size) == (DVec3::ZERO, 1.0) {
        return json!({ "mesh": 0, "name": "surface" });
    }
    json!({ "mesh": 0, "name": "surface", "translation": middle.to_array(), "scale": [size, size, size] })
}

/// Seen from both sides: a surface with a boundary shows its back.
fn material(has_picture: bool) -> Value {
    let mut reflectance = json!({ "metallicFactor": 0.0, "roughnessFactor": ROUGHNESS });
    if has_picture {
        reflectance["baseColorTexture"] = json!({ "index": 0, "texCoord": 0 });
    } else {
        reflectance["baseColorFactor"] = json!(PLAIN);
    }
    json!({ "name": "surface", "pbrMetallicRoughness": reflectance, "doubleSided": true })
}

/// Unit normals, one for each vertex; (0, 0, 1) where there is none, as in no triangle.
fn normals(mesh: &Shape<'_>) -> Vec<DVec3> {
    let (_, size) = extent(mesh);
    let mut sums = vec![DVec3::ZERO; mesh.vertices.len()];
    for triangle in mesh.triangles {
        // of unit size, so that areas neither underflow nor overflow
        let [a, b, c] = triangle.map(|v| mesh.vertices[v as usize] / size);
        let normal = (b - a).cross(c - a);
        for &v in triangle {
            sums[v as usize] += normal;
        }
    }
    sums.into_iter().map(|sum| sum.normalize_or(DVec3::Z)).collect()
}

/// The center and the largest extent of what the triangles cover.
fn extent(mesh: &Shape<'_>) -> (DVec3, f64) {
    let corners = mesh.triangles.iter().flatten().map(|&v| mesh.vertices[v as usize]);
    let (low, high) = corners.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
    (low.midpoint(high), (high - low).max_element())
}

/// The origin and unit of the f32 coordinates: those of the surface's file, unless the triangles are so far from its
/// origin, so large or so small that f32 would lose their shape.
fn frame(mesh: &Shape<'_>) -> (DVec3, f64) {
    const FARTHEST: f64 = 16.0;
    const SIZES: std::ops::RangeInclusive<f64> = 1e-6..=1e6;
    let (middle, extent) = extent(mesh);
    if SIZES.contains(&extent) && middle.abs().max_element() <= FARTHEST * extent {
        return (DVec3::ZERO, 1.0);
    }
    (middle, extent)
}

/// The buffer, its views and accessors.
#[derive(Default)]
struct File {
    buffer: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl File {
    /// A part of the buffer that begins at a multiple of 4; its number.
    fn view(&mut self, bytes: &[u8], target: Option<u32>) -> usize {
        let mut view = json!({ "buffer": 0, "byteOffset": self.buffer.len(), "byteLength": bytes.len() });
        if let Some(target) = target {
            view["target"] = target.into();
        }
        self.views.push(view);
        self.buffer.extend(bytes);
        self.buffer.resize(self.buffer.len().next_multiple_of(4), 0);
        self.views.len() - 1
    }

    /// An accessor of vectors of `width` numbers; its number.
    fn floats(&mut self, values: &[f64], width: usize) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|&value| (value as f32).to_le_bytes()).collect();
        let view = self.view(&bytes, Some(ARRAY_BUFFER));
        let count = values.len() / width;
        self.accessors
            .push(json!({ "bufferView": view, "componentType": FLOAT, "count": count, "type": format!("VEC{width}") }));
        self.accessors.len() - 1
    }

    /// An accessor of vectors in space; its number.
    fn vectors(&mut self, values: &[DVec3]) -> usize {
        self.floats(&values.iter().flat_map(DVec3::to_array).collect::<Vec<_>>(), 3)
    }

    /// The frame of a shape's positions, and the attributes with its positions and normals.
    fn shape(&mut self, shape: &Shape<'_>) -> ((DVec3, f64), Value) {
        let frame = frame(shape);
        let positions = self.positions(shape, frame);
        let normals = self.vectors(&normals(shape));
        (frame, json!({ "POSITION": positions, "NORMAL": normals }))
    }

    /// The positions, with their bounds, which glTF requires.
    fn positions(&mut self, mesh: &Shape<'_>, (middle, size): (DVec3, f64)) -> usize {
        // a vertex in no triangle may be anywhere
        let most = DVec3::splat(f64::from(f32::MAX));
        let places: Vec<DVec3> = mesh.vertices.iter().map(|&p| ((p - middle) / size).clamp(-most, most)).collect();
        let (low, high) = places.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| {
            let rounded = p.as_vec3().as_dvec3();
            (low.min(rounded), high.max(rounded))
        });
        let accessor = self.vectors(&places);
        self.accessors[accessor]["min"] = json!(low.to_array());
        self.accessors[accessor]["max"] = json!(high.to_array());
        accessor
    }

    fn indices(&mut self, triangles: &[[u32; 3]]) -> usize {
        let bytes: Vec<u8> = triangles.as_flattened().iter().flat_map(|v| v.to_le_bytes()).collect();
        let view = self.view(&bytes, Some(ELEMENT_ARRAY_BUFFER));
        let count = 3 * triangles.len();
        self.accessors
            .push(json!({ "bufferView": view, "componentType": UNSIGNED_INT, "count": count, "type": "SCALAR" }));
        self.accessors.len() - 1
    }

    /// The header and both chunks.
    fn bytes(self, mut document: Value) -> Vec<u8> {
        document["accessors"] = self.accessors.into();
        document["bufferViews"] = self.views.into();
        document["buffers"] = json!([{ "byteLength": self.buffer.len() }]);
        container(&document, &self.buffer)
    }
}
