//! A GLB file with other texture coordinates: its scene, materials and images stay.
//!
//! `TEXCOORD_0` is the layout, with v downwards as glTF has it, and (0, 0) at vertices that were left out. If the file has
//! textures, the coordinates that it had move on, from `TEXCOORD_0` to `TEXCOORD_1` and so on, and its textures with them, so
//! that it looks as before. Vertices that were added follow those of their primitive, with attributes in between those of the
//! vertices at their edge's ends; joints, weights and tangents are those of the nearest one.

use super::added::Added;
use super::gltf_data::GltfData;
use super::{Faces, Numbers, SurfaceSource, faces::Written};
use crate::export::Flattened;
use crate::geometry::DVec2;
use crate::surface::{GlbChunks, GltfPart, Surface};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The attributes that are means at added vertices.
const MEANS: [&str; 4] = ["POSITION", "NORMAL", "TEXCOORD", "COLOR"];

/// The file; `None` if buffers lie outside of it, a mesh is placed twice or vertices were added that its accessors cannot
/// take, and if it is not that of the surface.
pub(super) fn written(flattened: &Flattened, source: SurfaceSource<'_>) -> Option<Vec<u8>> {
    let chunks = GlbChunks::of(source.bytes).ok()?;
    let parts = chunks.parts().ok()?;
    let primitives: BTreeSet<[usize; 2]> = parts.iter().map(|part| part.primitive).collect();
    if primitives.len() < parts.len() {
        return None;
    }
    let mut data = GltfData::new(&chunks)?;
    move_coordinates(&mut data.document)?;
    let numbers = Numbers::new(source.surface);
    let mut faces = Faces::new(source.surface, flattened, &numbers);
    let coordinates = faces.coordinates();
    let added = Added::new(flattened, source.surface, &numbers);
    let mut first = 0;
    for part in &parts {
        let mut divided = Divided {
            part,
            first,
            surface: source.surface,
            added: &added,
            new: Vec::new(),
            known: BTreeMap::new(),
            elements: None,
        };
        let triangles = divided.triangles(&mut faces)?;
        first += part.vertices as u32;
        divided.write(&triangles, &coordinates, &mut data)?;
    }
    faces.is_complete().then(|| data.bytes())
}

/// A new vertex of a primitive.
struct NewVertex {
    /// Its number after those of the file.
    number: u32,
    /// The primitive's vertices whose mean it is.
    weights: Vec<(u32, f64)>,
}

/// A primitive with added vertices.
struct Divided<'a> {
    part: &'a GltfPart,
    /// The number in the file of its first vertex.
    first: u32,
    surface: &'a Surface,
    added: &'a Added,
    new: Vec<NewVertex>,
    /// The new vertices by their numbers and the vertices whose means they are.
    known: BTreeMap<(u32, Vec<u32>), u32>,
    /// The primitive's vertices by those of the surface, once they are needed.
    elements: Option<HashMap<u32, u32>>,
}

impl Divided<'_> {
    /// The primitive's triangles, those of flattened faces as they are there.
    fn triangles(&mut self, faces: &mut Faces<'_>) -> Option<Vec<[u32; 3]>> {
        let mut triangles = Vec::with_capacity(self.part.triangles.len());
        for &given in &self.part.triangles {
            let upright = self.part.upright(given);
            match faces.next(&upright.map(|v| self.first + v))? {
                Written::LeftOut => triangles.push(given),
                Written::Whole { corners, is_turned } => {
                    let [a, b, c] = <[u32; 3]>::try_from(corners).ok()?;
                    let found = self.vertices(if is_turned { [a, c, b] } else { [a, b, c] }, upright)?;
                    triangles.push(self.part.upright(found));
                }
                Written::Parts(parts) => {
                    for part in parts {
                        let found = self.vertices(part, upright)?;
                        triangles.push(self.part.upright(found));
                    }
                }
            }
        }
        Some(triangles)
    }

    /// The primitive's vertices with these numbers in the file; `corners` are those of the triangle there.
    fn vertices(&mut self, numbers: [u32; 3], corners: [u32; 3]) -> Option<[u32; 3]> {
        let [a, b, c] = numbers.map(|number| self.vertex(number, corners));
        Some([a?, b?, c?])
    }

    fn vertex(&mut self, number: u32, corners: [u32; 3]) -> Option<u32> {
        let Some(k) = number.checked_sub(self.surface.count_in_file() as u32) else {
            return self.given(number, corners);
        };
        let weights = self.added.get(k as usize)?.weights().to_vec();
        let weights = weights.into_iter().map(|(number, weight)| Some((self.given(number, corners)?, weight)));
        let weights: Vec<(u32, f64)> = weights.collect::<Option<_>>()?;
        let key = (number, weights.iter().map(|(vertex, _)| *vertex).collect());
        let next = (self.part.vertices + self.new.len()) as u32;
        let vertex = *self.known.entry(key).or_insert(next);
        if vertex == next {
            self.new.push(NewVertex { number, weights });
        }
        Some(vertex)
    }

    /// The primitive's vertex that became the same one as this of the file, if possible one of `corners`.
    fn given(&mut self, number: u32, corners: [u32; 3]) -> Option<u32> {
        let surface = self.surface;
        let wanted = surface.vertex_in_file(number)?;
        let first = self.first;
        let became = |vertex: u32| surface.vertex_in_file(first + vertex);
        if let Some(corner) = corners.into_iter().find(|&vertex| became(vertex) == Some(wanted)) {
            return Some(corner);
        }
        let all = 0..self.part.vertices as u32;
        let elements = self.elements.get_or_insert_with(|| all.filter_map(|v| Some((became(v)?, v))).collect());
        elements.get(&wanted).copied()
    }

    /// Replaces the primitive's triangles and attributes.
    fn write(self, triangles: &[[u32; 3]], coordinates: &[Option<DVec2>], data: &mut GltfData) -> Option<()> {
        let Self { part, first, new, .. } = self;
        if !new.is_empty() {
            extend_attributes(part, &new, data)?;
        }
        let numbers = (first..first + part.vertices as u32).chain(new.iter().map(|vertex| vertex.number));
        let uv = |number: u32| {
            let uv = coordinates.get(number as usize).copied().flatten();
            uv.map_or([0.0, 0.0], |uv| [uv.x, 1.0 - uv.y])
        };
        let accessor = data.add_pairs(numbers.map(uv))?;
        let primitive = data.primitive(part.primitive)?;
        primitive["attributes"]["TEXCOORD_0"] = accessor.into();
        // the compressed copy has the old coordinates
        if let Some(extensions) = primitive.get_mut("extensions").and_then(Value::as_object_mut) {
            extensions.remove("KHR_draco_mesh_compression");
        }
        if triangles != part.triangles {
            let accessor = data.add_triangles(triangles)?;
            let primitive = data.primitive(part.primitive)?;
            primitive["indices"] = accessor.into();
            primitive["mode"] = 4.into();
        }
        Some(())
    }
}

/// Gives a primitive's attributes the values of new vertices. `None` if it has morph targets.
fn extend_attributes(part: &GltfPart, new: &[NewVertex], data: &mut GltfData) -> Option<()> {
    let primitive = data.primitive(part.primitive)?;
    if primitive.get("targets").is_some() {
        return None;
    }
    let attributes = primitive["attributes"].as_object()?.clone();
    for (name, accessor) in attributes {
        let mut elements = data.elements(accessor.as_u64()? as usize)?;
        if elements.count()? != part.vertices {
            return None;
        }
        for NewVertex { weights, .. } in new {
            if MEANS.iter().any(|start| name.starts_with(start)) {
                elements.mix(weights, name == "NORMAL")?;
            } else {
                let nearest = weights.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
                elements.copy(nearest.0)?;
            }
        }
        let accessor = data.add(&elements)?;
        data.primitive(part.primitive)?["attributes"][name] = accessor.into();
    }
    Some(())
}

/// Makes room for `TEXCOORD_0`, if textures use it. `None` if morph targets have texture coordinates.
fn move_coordinates(document: &mut Value) -> Option<()> {
    if document.get("textures").and_then(Value::as_array).is_none_or(Vec::is_empty) {
        return Some(());
    }
    let meshes = document.get_mut("meshes")?.as_array_mut()?.iter_mut();
    for primitive in meshes.filter_map(|mesh| mesh.get_mut("primitives")?.as_array_mut()).flatten() {
        let has_coordinates = |target: &Value| target.as_object().is_some_and(|keys| keys.contains_key("TEXCOORD_0"));
        if primitive["targets"].as_array().is_some_and(|targets| targets.iter().any(has_coordinates)) {
            return None;
        }
        let attributes = primitive.get_mut("attributes")?.as_object_mut()?;
        let name = |k: usize| format!("TEXCOORD_{k}");
        let sets = (0..attributes.len()).take_while(|&k| attributes.contains_key(&name(k))).count();
        for k in (0..sets).rev() {
            let accessor = attributes[&name(k)].clone();
            attributes.insert(name(k + 1), accessor);
        }
    }
    let materials = document.get_mut("materials").and_then(Value::as_array_mut);
    materials.into_iter().flatten().for_each(move_textures);
    Some(())
}

/// Moves the textures of a material to the next coordinates.
fn move_textures(value: &mut Value) {
    let Value::Object(fields) = value else { return };
    for (key, field) in fields {
        if key.ends_with("Texture") && field["index"].is_u64() {
            field["texCoord"] = (field["texCoord"].as_u64().unwrap_or(0).saturating_add(1)).into();
            if let Some(own) = field.pointer_mut("/extensions/KHR_texture_transform/texCoord") {
                *own = (own.as_u64().unwrap_or(0).saturating_add(1)).into();
            }
        } else {
            move_textures(field);
        }
    }
}
