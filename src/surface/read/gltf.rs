//! glTF 2.0: the triangles of the default scene, in the scene's coordinates.
//!
//! Buffers are embedded (base 64), in the GLB file, or neighboring files, for which the caller is asked. Positions may be
//! quantized (`KHR_mesh_quantization`) and accessors sparse. Compressed meshes are not supported, nor are morph targets that
//! have a weight; skins, and morph targets without, are ignored.

use super::faces::Faces;
use super::gltf_buffers::Buffers;
use super::{Fault, Item, Neighbor, Place, SurfaceError, Unsupported};
use crate::geometry::DVec3;
use crate::surface::Surface;
use crate::surface::survey::repeats;
use glam::{DMat4, DQuat};
use serde::Deserialize;
use serde::de::IgnoredAny;

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Document {
    scene: Option<usize>,
    scenes: Vec<Scene>,
    pub nodes: Vec<Node>,
    pub meshes: Vec<Mesh>,
    pub accessors: Vec<Accessor>,
    pub buffer_views: Vec<BufferView>,
    pub buffers: Vec<Buffer>,
    extensions_required: Vec<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Asset {
    version: String,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Scene {
    nodes: Vec<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Node {
    pub mesh: Option<usize>,
    children: Vec<usize>,
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
    weights: Option<Vec<f64>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Mesh {
    pub primitives: Vec<Primitive>,
    weights: Option<Vec<f64>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Primitive {
    pub attributes: Attributes,
    pub indices: Option<usize>,
    pub mode: Option<u32>,
    targets: Option<Vec<IgnoredAny>>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub position: Option<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct Accessor {
    pub buffer_view: Option<usize>,
    pub byte_offset: usize,
    pub component_type: u32,
    pub normalized: bool,
    pub count: usize,
    #[serde(rename = "type")]
    pub kind: String,
    pub sparse: Option<Sparse>,
}

/// Elements of an accessor that differ from its buffer view, or from 0.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Sparse {
    pub count: usize,
    pub indices: SparsePart,
    pub values: SparsePart,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct SparsePart {
    pub buffer_view: Option<usize>,
    pub byte_offset: usize,
    pub component_type: u32,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(super) struct BufferView {
    pub buffer: usize,
    pub byte_offset: usize,
    pub byte_length: usize,
    pub byte_stride: Option<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(super) struct Buffer {
    pub uri: Option<String>,
}

/// Extensions that change where positions or indices are stored, so that they cannot be ignored.
const COMPRESSIONS: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Refuses versions before 2, whose documents are built otherwise.
fn check_version(text: &str) -> Result<(), SurfaceError> {
    #[derive(Default, Deserialize)]
    #[serde(default)]
    struct Head {
        asset: Asset,
    }
    let version = serde_json::from_str(text).map(|Head { asset }| asset.version).unwrap_or_default();
    match version.split('.').next().unwrap_or_default().parse() {
        Ok(major @ ..2) => Err(SurfaceError::unsupported(part("asset"), Unsupported::Version(major))),
        _ => Ok(()),
    }
}

/// Reads a document; `binary` is the buffer of a GLB file, and `neighbor` gives the bytes of a file beside it.
pub(super) fn read(bytes: &[u8], binary: Option<&[u8]>, neighbor: &mut Neighbor) -> Result<Surface, SurfaceError> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let line = bytes[..error.valid_up_to()].split(|&byte| byte == b'\n').count();
        SurfaceError::malformed(Place::Line(line), Fault::NotGltf(error.to_string()))
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    check_version(text)?;
    let document: Document = serde_json::from_str(text)
        .map_err(|error| SurfaceError::malformed(Place::Line(error.line()), Fault::NotGltf(error.to_string())))?;
    if let Some(name) = document.extensions_required.iter().find(|name| COMPRESSIONS.contains(&name.as_str())) {
        return Err(SurfaceError::unsupported(part("extensionsRequired"), Unsupported::Extension(name.clone())));
    }
    let buffers = Buffers::new(&document, binary, neighbor)?;
    let mut faces = Faces::default();
    for (node, transform) in document.placed_nodes()? {
        if let Some(mesh) = document.nodes[node].mesh {
            let missing = || SurfaceError::missing(Place::Part(format!("nodes[{node}]")), Item::Mesh(mesh));
            let found = document.meshes.get(mesh).ok_or_else(missing)?;
            let weights = document.nodes[node].weights.as_ref().or(found.weights.as_ref());
            let is_morphed = weights.into_iter().flatten().any(|&weight| weight != 0.0);
            if is_morphed && found.primitives.iter().any(|part| part.targets.iter().flatten().next().is_some()) {
                return Err(SurfaceError::unsupported(part(&format!("meshes[{mesh}]")), Unsupported::Morphing));
            }
            for (k, primitive) in found.primitives.iter().enumerate() {
                let place = Place::Part(format!("meshes[{mesh}].primitives[{k}]"));
                read_primitive(primitive, &place, transform, &buffers, &mut faces)?;
            }
        }
    }
    faces.finish()
}

fn part(name: &str) -> Place {
    Place::Part(name.to_owned())
}

impl Document {
    /// The nodes of the default scene (of all roots if there is no scene) with their transforms.
    pub(super) fn placed_nodes(&self) -> Result<Vec<(usize, DMat4)>, SurfaceError> {
        let scene = self.scenes.get(self.scene.unwrap_or(0));
        let roots = match scene {
            Some(scene) => scene.nodes.clone(),
            None if self.scene.is_some() => return Err(SurfaceError::missing(part("scene"), Item::DefaultScene)),
            None => {
                let child = |k: &usize| self.nodes.iter().any(|node| node.children.contains(k));
                (0..self.nodes.len()).filter(|k| !child(k)).collect()
            }
        };
        let mut pending: Vec<(usize, DMat4)> = roots.into_iter().rev().map(|node| (node, DMat4::IDENTITY)).collect();
        let mut seen = vec![false; self.nodes.len()];
        let mut placed = Vec::new();
        while let Some((k, parent)) = pending.pop() {
            let place = || Place::Part(format!("nodes[{k}]"));
            let node = self.nodes.get(k).ok_or_else(|| SurfaceError::missing(place(), Item::Node))?;
            if std::mem::replace(&mut seen[k], true) {
                return Err(SurfaceError::malformed(place(), Fault::NodeTwice));
            }
            let transform = parent * node.transform();
            pending.extend(node.children.iter().rev().map(|&child| (child, transform)));
            placed.push((k, transform));
        }
        Ok(placed)
    }
}

impl Node {
    fn transform(&self) -> DMat4 {
        if let Some(matrix) = &self.matrix {
            return DMat4::from_cols_array(matrix);
        }
        DMat4::from_scale_rotation_translation(
            DVec3::from_array(self.scale.unwrap_or([1.0; 3])),
            self.rotation.map_or(DQuat::IDENTITY, DQuat::from_array),
            DVec3::from_array(self.translation.unwrap_or_default()),
        )
    }
}

fn read_primitive(
    primitive: &Primitive,
    place: &Place,
    transform: DMat4,
    buffers: &Buffers<'_>,
    faces: &mut Faces,
) -> Result<(), SurfaceError> {
    let mode = primitive.mode.unwrap_or(4);
    if mode < 4 {
        return Ok(()); // points and lines
    }
    let accessor = primitive.attributes.position;
    let accessor = accessor.ok_or_else(|| SurfaceError::missing(place.clone(), Item::Position))?;
    let first = faces.vertices.len();
    faces.vertices.extend(buffers.points(accessor)?.into_iter().map(|point| transform.transform_point3(point)));
    // nodes may place the same positions any number of times
    faces.check_memory()?;
    let count = faces.vertices.len() - first;
    let indices = match primitive.indices {
        Some(accessor) => buffers.indices(accessor)?,
        None => (0..count as u32).collect(),
    };
    if let Some(&index) = indices.iter().find(|&&index| index as usize >= count) {
        let index = i64::from(index);
        return Err(SurfaceError::IndexOutOfRange { place: place.clone(), index, vertices: count });
    }
    let mirrored = transform.determinant() < 0.0;
    let mut push = |a: usize, b: usize, c: usize| {
        let [a, b, c] = [a, b, c].map(|k| first as u32 + indices[k]);
        // strips repeat corners to go on elsewhere
        if mode == 4 || !repeats(&[a, b, c]) {
            faces.push(&if mirrored { [a, c, b] } else { [a, b, c] });
        }
    };
    let count = indices.len();
    match mode {
        4 if count % 3 == 0 => (0..count / 3).for_each(|t| push(3 * t, 3 * t + 1, 3 * t + 2)),
        5 => (2..count).for_each(|k| if k % 2 == 0 { push(k - 2, k - 1, k) } else { push(k - 1, k - 2, k) }),
        6 => (2..count).for_each(|k| push(0, k - 1, k)),
        4 => return Err(SurfaceError::malformed(place.clone(), Fault::CornerCount { count })),
        _ => return Err(SurfaceError::malformed(place.clone(), Fault::Mode(mode))),
    }
    Ok(())
}
