//! The mapped mesh of a map as OBJ, PLY or GLB, not scaled.
//!
//! | sides | positions | coordinates |
//! |---|---|---|
//! | two outlines (OBJ only), two surfaces | on the target | on the source |
//! | one surface | on the surface | in the plane |
//!
//! On surfaces, the vertices are those of the mapped one's file, all of them and in its order; a vertex that a repair has
//! dropped has no image and lies at that of the first vertex which has one. Between outlines they have the order of the mesh:
//! boundary first. Triangles that fill a hole are omitted.
//!
//! Between surfaces, the coordinates on the source are `source_x`, `source_y`, `source_z` in PLY and the attribute `_SOURCE`
//! in GLB, whose texture coordinates are planar.

use super::as_read::{Numbers, is_of};
use super::{EncodedSurface, FileFormat, Flattened, SurfaceSource, flattened::number, glb};
use crate::conformal::{ConformalMap, Direction, Places};
use crate::geometry::DVec3;
use crate::mesh::VertexId;
use crate::surface::Surface;
use std::fmt::Write as _;

/// The mesh in a file format; `None` in one that has no place for its coordinates. `source` is the file of the mapped surface:
/// over an outline it is written as it was read, and onto another surface with its vertices alone.
pub fn mapped_mesh(
    map: &ConformalMap,
    format: FileFormat,
    source: Option<SurfaceSource<'_>>,
) -> Option<EncodedSurface> {
    if map.mapped().is_surface() && !map.is_through_disk() {
        return Some(Flattened::new(map, false)?.encode_as_read(format, source));
    }
    let mesh = MappedMesh::of(map, source.map(|source| source.surface));
    let bytes = match format {
        FileFormat::Obj => mesh.obj().into_bytes(),
        FileFormat::Ply if map.is_through_disk() => mesh.ply().into_bytes(),
        FileFormat::Glb if map.is_through_disk() => {
            glb::encode_mapped(&mesh.positions, &mesh.triangles, &mesh.coordinates)
        }
        _ => return None,
    };
    Some(EncodedSurface { bytes, is_bare: source.is_some_and(|source| SurfaceSource::is_kept(source.format, format)) })
}

/// A mesh with positions on the target and coordinates on the source, both in the plane or both in space.
struct MappedMesh {
    positions: Vec<DVec3>,
    coordinates: Vec<DVec3>,
    is_in_space: bool,
    triangles: Vec<[u32; 3]>,
}

impl MappedMesh {
    /// `read` is the mapped surface as it was read.
    fn of(map: &ConformalMap, read: Option<&Surface>) -> Self {
        let surface = map.mapped().surface().map(|meshed| meshed.surface());
        let own = in_space(map.mapped().vertices());
        let images = in_space(map.image_places());
        let triangles = map.given(map.mapped().triangles()).copied();
        let (own, images, triangles) = match surface {
            Some(disk) => (
                disk.origin_positions().map(Some).collect::<Vec<_>>(),
                (0..disk.origin_count() as u32)
                    .map(|origin| images.get(disk.number_of(VertexId::new(origin))?.index()).copied())
                    .collect(),
                triangles.map(|t| t.map(|v| number(disk, v))).collect(),
            ),
            None => (some(own), some(images), triangles.collect()),
        };
        // the reader may have merged vertices of the file
        let places = surface.map(|disk| disk.origin_positions().collect::<Vec<_>>());
        let read = read.filter(|read| places.is_some_and(|places| is_of(&places, read)));
        let (own, images, triangles) = match read.map(Numbers::new) {
            Some(numbers) => {
                let triangles: Vec<[u32; 3]> = triangles;
                let renumbered = triangles.into_iter().map(|t| t.map(|v| numbers.of(v))).collect();
                (numbers.spread(&own), numbers.spread(&images), renumbered)
            }
            None => (own, images, triangles),
        };
        let own = completed(own);
        let images = completed(images);
        let (positions, coordinates) = match map.direction() {
            Direction::Forward => (images, own),
            Direction::Backward => (own, images),
        };
        Self { positions, coordinates, is_in_space: surface.is_some(), triangles }
    }

    /// `vt k` belongs to `v k`.
    fn obj(&self) -> String {
        let mut text = String::from("# riemap: v lies in the target, vt are source coordinates (not scaled)\n");
        for p in &self.positions {
            let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
        }
        for p in &self.coordinates {
            let _ = if self.is_in_space {
                writeln!(text, "vt {} {} {}", p.x, p.y, p.z)
            } else {
                writeln!(text, "vt {} {}", p.x, p.y)
            };
        }
        for [a, b, c] in self.triangles.iter().map(|t| t.map(|v| v + 1)) {
            let _ = writeln!(text, "f {a}/{a} {b}/{b} {c}/{c}");
        }
        text
    }

    fn ply(&self) -> String {
        let mut text = String::from(
            "ply\nformat ascii 1.0\n\
             comment riemap: x y z lie in the target, source_x source_y source_z in the source\n",
        );
        let _ = writeln!(text, "element vertex {}", self.positions.len());
        for name in ["x", "y", "z", "source_x", "source_y", "source_z"] {
            let _ = writeln!(text, "property double {name}");
        }
        let faces = self.triangles.len();
        let _ = write!(text, "element face {faces}\nproperty list uchar uint vertex_indices\nend_header\n");
        for (p, q) in self.positions.iter().zip(&self.coordinates) {
            let _ = writeln!(text, "{} {} {} {} {} {}", p.x, p.y, p.z, q.x, q.y, q.z);
        }
        for [a, b, c] in &self.triangles {
            let _ = writeln!(text, "3 {a} {b} {c}");
        }
        text
    }
}

fn some<T>(all: Vec<T>) -> Vec<Option<T>> {
    all.into_iter().map(Some).collect()
}

/// The images, those of dropped vertices at the first one.
fn completed(images: Vec<Option<DVec3>>) -> Vec<DVec3> {
    let first = images.iter().flatten().next().copied().unwrap_or_default();
    images.into_iter().map(|image| image.unwrap_or(first)).collect()
}

/// The positions, those in the plane at height 0.
fn in_space(places: Places<'_>) -> Vec<DVec3> {
    match places {
        Places::Plane(places) => places.iter().map(|p| p.extend(0.0)).collect(),
        Places::Space(places) => places.to_vec(),
    }
}
