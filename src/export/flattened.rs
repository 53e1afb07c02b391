//! A parameterized surface as OBJ, PLY, GLB or CSV, and its layout as SVG.
//!
//! The vertices are those of the surface's file, all of them and in its order, and so are the triangles,
//! except those that a repair has dropped. Triangles that fill a hole are omitted.

use super::FileFormat;
use crate::conformal::ConformalMap;
use crate::geometry::{DVec2, DVec3};
use std::fmt::Write as _;

/// The transformation from positions in the outline to texture coordinates: `(position − origin) · scale`.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Placement {
    origin: DVec2,
    scale: f64,
}

/// A surface with texture coordinates.
#[non_exhaustive]
pub struct Flattened {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// `None` for vertices that a repair has dropped.
    coordinates: Vec<Option<DVec2>>,
    /// The transformation of the texture coordinates.
    pub placement: Placement,
}

impl Flattened {
    /// The surface as it was read, with images scaled into the unit box if `unit`; `None` if the map has no surface.
    pub fn new(map: &ConformalMap, unit: bool) -> Option<Self> {
        let images = map.texture_coordinates();
        let placement = if unit { unit_box(&images) } else { Placement { origin: DVec2::ZERO, scale: 1.0 } };
        let placed = |image: DVec2| (image - placement.origin) * placement.scale;
        let disk = map.mapped().surface()?.surface();
        let triangles = disk.mesh().triangles().iter();
        let kept = triangles.zip(disk.origins_of_triangles()).filter(|(_, origin)| origin.is_some());
        Some(Self {
            vertices: disk.origin_positions().collect(),
            triangles: kept.map(|(t, _)| t.map(|v| disk.vertex_origins()[v as usize])).collect(),
            coordinates: images.into_iter().map(|image| image.map(placed)).collect(),
            placement,
        })
    }

    /// The surface in a file format.
    pub fn encode(&self, format: FileFormat) -> Vec<u8> {
        match format {
            FileFormat::Obj => self.obj().into_bytes(),
            FileFormat::Ply => self.ply().into_bytes(),
            FileFormat::Glb => self.glb(),
            FileFormat::Csv => self.csv().into_bytes(),
            FileFormat::Svg => self.svg().into_bytes(),
        }
    }

    /// Positions and coordinates; (0, 0) for vertices without coordinates, which are in no triangle.
    fn rows(&self) -> impl Iterator<Item = (DVec3, DVec2)> {
        let coordinates = self.coordinates.iter().map(|uv| uv.unwrap_or_default());
        self.vertices.iter().copied().zip(coordinates)
    }

    /// `vt k` belongs to `v k`.
    fn obj(&self) -> String {
        let mut text = String::from("# riemap: vertices in the order of the file, one vt for each\n");
        for (p, _) in self.rows() {
            let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
        }
        for (_, uv) in self.rows() {
            let _ = writeln!(text, "vt {} {}", uv.x, uv.y);
        }
        for [a, b, c] in self.triangles.iter().map(|t| t.map(|v| v + 1)) {
            let _ = writeln!(text, "f {a}/{a} {b}/{b} {c}/{c}");
        }
        text
    }

    fn ply(&self) -> String {
        let mut text = format!(
            "ply\nformat ascii 1.0\ncomment riemap: s t are texture coordinates\nelement vertex {}\n\
             property double x\nproperty double y\nproperty double z\nproperty double s\nproperty double t\n\
             element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
            self.vertices.len(),
            self.triangles.len()
        );
        for (p, uv) in self.rows() {
            let _ = writeln!(text, "{} {} {} {} {}", p.x, p.y, p.z, uv.x, uv.y);
        }
        for [a, b, c] in &self.triangles {
            let _ = writeln!(text, "3 {a} {b} {c}");
        }
        text
    }

    /// A row for each vertex; the coordinates are empty if a repair has dropped it.
    fn csv(&self) -> String {
        let mut text = String::from("x,y,z,u,v\n");
        for (p, uv) in self.vertices.iter().zip(&self.coordinates) {
            let uv = uv.map_or_else(|| ",".to_owned(), |uv| format!("{},{}", uv.x, uv.y));
            let _ = writeln!(text, "{},{},{},{uv}", p.x, p.y, p.z);
        }
        text
    }

    /// One mesh in f32, as glTF requires; the second texture coordinate is 1 − v, since glTF's points down.
    /// If f32 would lose the surface's shape, the vertices are stored relative to its center and scaled to unit size,
    /// and the node holds the transformation.
    fn glb(&self) -> Vec<u8> {
        let (count, corners) = (self.vertices.len(), 3 * self.triangles.len());
        let mut buffer = Vec::with_capacity(20 * count + 4 * corners);
        let mut push = |value: f64| buffer.extend((value as f32).to_le_bytes());
        let (middle, size) = self.frame();
        // a vertex in no triangle may be anywhere
        let most = DVec3::splat(f64::from(f32::MAX));
        let placed = |p: DVec3| ((p - middle) / size).clamp(-most, most);
        self.rows().for_each(|(p, _)| placed(p).to_array().into_iter().for_each(&mut push));
        self.rows().for_each(|(_, uv)| [uv.x, 1.0 - uv.y].into_iter().for_each(&mut push));
        self.triangles.as_flattened().iter().for_each(|v| buffer.extend(v.to_le_bytes()));
        let (low, high) = self.vertices.iter().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), &p| {
            let rounded = placed(p).as_vec3().as_dvec3();
            (low.min(rounded), high.max(rounded))
        });
        let node = if (middle, size) == (DVec3::ZERO, 1.0) {
            serde_json::json!({ "mesh": 0 })
        } else {
            serde_json::json!({ "mesh": 0, "translation": middle.to_array(), "scale": [size, size, size] })
        };
        let document = serde_json::json!({
            "asset": { "version": "2.0", "generator": "riemap" },
            "scene": 0, "scenes": [{ "nodes": [0] }], "nodes": [node],
            "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0, "TEXCOORD_0": 1 }, "indices": 2 }] }],
            "accessors": [
                { "bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3",
                  "min": low.to_array(), "max": high.to_array() },
                { "bufferView": 1, "componentType": 5126, "count": count, "type": "VEC2" },
                { "bufferView": 2, "componentType": 5125, "count": corners, "type": "SCALAR" },
            ],
            "bufferViews": [
                { "buffer": 0, "byteLength": 12 * count },
                { "buffer": 0, "byteOffset": 12 * count, "byteLength": 8 * count },
                { "buffer": 0, "byteOffset": 20 * count, "byteLength": 4 * corners },
            ],
            "buffers": [{ "byteLength": buffer.len() }],
        });
        let mut document = document.to_string().into_bytes();
        document.resize(document.len().next_multiple_of(4), b' ');
        let mut bytes = b"glTF\x02\0\0\0".to_vec();
        bytes.extend((28 + document.len() as u32 + buffer.len() as u32).to_le_bytes());
        for (kind, chunk) in [(b"JSON", &document), (b"BIN\0", &buffer)] {
            bytes.extend((chunk.len() as u32).to_le_bytes());
            bytes.extend(kind);
            bytes.extend(chunk);
        }
        bytes
    }

    /// The origin and unit of a GLB's f32 coordinates: those of the file, unless the triangles are so far from its
    /// origin, so large or so small that f32 would lose their shape.
    fn frame(&self) -> (DVec3, f64) {
        const FARTHEST: f64 = 16.0;
        const SIZES: std::ops::RangeInclusive<f64> = 1e-6..=1e6;
        let (low, high) = self
            .triangles
            .iter()
            .flatten()
            .map(|&v| self.vertices[v as usize])
            .fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
        let (middle, extent) = (low.midpoint(high), (high - low).max_element());
        if SIZES.contains(&extent) && middle.abs().max_element() <= FARTHEST * extent {
            return (DVec3::ZERO, 1.0);
        }
        (middle, extent)
    }

    /// The edges of the layout, 1000 units wide, v up.
    fn svg(&self) -> String {
        const ACROSS: f64 = 1000.0;
        let Placement { origin, scale } = unit_box(&self.coordinates);
        let place = |v: u32| {
            let p = (self.coordinates[v as usize].unwrap_or_default() - origin) * scale * ACROSS;
            DVec2::new(p.x, ACROSS - p.y)
        };
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-5 -5 {0} {0}\" fill=\"none\" \
             stroke=\"#1b1b1f\" stroke-width=\"0.4\" stroke-linejoin=\"round\">\n<path d=\"",
            ACROSS + 10.0
        );
        for &t in &self.triangles {
            let [a, b, c] = t.map(place);
            let _ = write!(text, "M{:.2} {:.2}L{:.2} {:.2}L{:.2} {:.2}Z", a.x, a.y, b.x, b.y, c.x, c.y);
        }
        text.push_str("\"/>\n</svg>\n");
        text
    }
}

/// Maps the bounding box of the coordinates into [0, 1]², its larger side onto a whole side.
fn unit_box(coordinates: &[Option<DVec2>]) -> Placement {
    let (low, high) = coordinates
        .iter()
        .flatten()
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    Placement { origin: low, scale: 1.0 / (high - low).max_element() }
}
