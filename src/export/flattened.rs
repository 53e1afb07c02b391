//! A parameterized surface as OBJ, PLY, GLB or CSV, and its layout as SVG.
//!
//! The vertices are those of the surface's file, all of them and in its order, and so are the triangles,
//! except those that a repair has dropped. Triangles that fill a hole are omitted.
//!
//! Where the surface is divided at the outline's corners, the new vertices follow those of the file, and the other parts
//! of divided triangles follow the triangles. What each new vertex divides is written too: in comments of OBJ and PLY, in
//! three more columns of CSV, and in the `extras` of a GLB's mesh.

use super::FileFormat;
use super::glb::{self, Base, Mesh, Shape};
use crate::conformal::{ConformalMap, CornerCuts, Divided};
use crate::geometry::{DVec2, DVec3};
use crate::surface::SurfaceMesh;
use std::fmt::Write as _;

/// The transformation from positions in the outline to texture coordinates: `(position − origin) · scale`.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Placement {
    origin: DVec2,
    scale: f64,
}

/// What a vertex that is not in the surface's file divides, in the file's numbers counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Division {
    /// The edge between two vertices, at a fraction of its length from the first one.
    Edge([u32; 2], f64),
    /// A triangle, in its middle.
    Triangle(u32),
}

/// A surface with texture coordinates.
#[non_exhaustive]
pub struct Flattened {
    vertices: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// For each triangle that of the surface as it was read from which it comes.
    origins: Vec<u32>,
    /// `None` for vertices that a repair has dropped.
    coordinates: Vec<Option<DVec2>>,
    /// What the vertices divide that are not in the file; they are the last ones.
    divisions: Vec<Division>,
    /// The transformation of the texture coordinates.
    pub placement: Placement,
}

impl Flattened {
    /// The surface as it was read, with images scaled into the unit box if `unit`; `None` if the map has no surface.
    pub fn new(map: &ConformalMap, unit: bool) -> Option<Self> {
        let disk = map.mapped().surface()?.surface();
        Some(Self::placed(disk, disk.mesh().triangles(), map.texture_coordinates(), unit))
    }

    /// As [`Self::new`], divided at the outline's corners; `None` unless `cuts` are of the map.
    pub fn cut(map: &ConformalMap, cuts: &CornerCuts, unit: bool) -> Option<Self> {
        let disk = map.mapped().surface()?.surface();
        let own = disk.mesh().vertices().len();
        if cuts.images().len() != own + cuts.added().len() {
            return None;
        }
        let mut images = map.texture_coordinates();
        for (origin, &image) in disk.vertex_origins().iter().zip(cuts.images()) {
            if let Some(old) = images.get_mut(*origin as usize) {
                *old = Some(image);
            }
        }
        images.extend(cuts.images()[own..].iter().copied().map(Some));
        let mut flattened = Self::placed(disk, cuts.triangles(), images, unit);
        flattened.vertices.extend(cuts.added().iter().map(|added| added.place));
        let parents = (disk.mesh().triangles().len()..cuts.triangles().len()).map(|k| (k, cuts.parent(k)));
        for (k, parent) in parents {
            if let Some(origin) = disk.origin_of_triangle(parent) {
                flattened.triangles.push(cuts.triangles()[k].map(|v| number(disk, v)));
                flattened.origins.push(origin.number());
            }
        }
        let divided = |divides: Divided| match divides {
            Divided::Edge { ends, fraction } => Division::Edge(ends.map(|v| number(disk, v.number())), fraction),
            Divided::Triangle(triangle) => Division::Triangle(disk.triangle_origins()[triangle.index()]),
        };
        flattened.divisions = cuts.added().iter().map(|added| divided(added.divides)).collect();
        Some(flattened)
    }

    /// The triangles of the file, the first of `triangles`, and these images.
    fn placed(disk: &SurfaceMesh, triangles: &[[u32; 3]], images: Vec<Option<DVec2>>, unit: bool) -> Self {
        let placement = if unit { unit_box(&images) } else { Placement { origin: DVec2::ZERO, scale: 1.0 } };
        let placed = |image: DVec2| (image - placement.origin) * placement.scale;
        let kept = triangles.iter().zip(disk.origins_of_triangles());
        let (triangles, origins) =
            kept.filter_map(|(t, origin)| Some((t.map(|v| number(disk, v)), origin?.number()))).unzip();
        Self {
            vertices: disk.origin_positions().collect(),
            triangles,
            origins,
            coordinates: images.into_iter().map(|image| image.map(placed)).collect(),
            divisions: Vec::new(),
            placement,
        }
    }

    /// The positions of all vertices.
    pub(super) fn vertices(&self) -> &[DVec3] {
        &self.vertices
    }

    /// Vertex triples.
    pub(super) fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// For each triangle that of the surface as it was read from which it comes.
    pub(super) fn origins(&self) -> &[u32] {
        &self.origins
    }

    /// The texture coordinates of all vertices; `None` for those that a repair has dropped.
    pub(super) fn coordinates(&self) -> &[Option<DVec2>] {
        &self.coordinates
    }

    /// What the vertices divide that are not in the file, from the first one on.
    pub fn divisions(&self) -> &[Division] {
        &self.divisions
    }

    /// The surface in a file format.
    pub fn encode(&self, format: FileFormat) -> Vec<u8> {
        match format {
            FileFormat::Obj => self.obj().into_bytes(),
            FileFormat::Ply => self.ply().into_bytes(),
            FileFormat::Glb => self.glb(None),
            FileFormat::Csv => self.csv().into_bytes(),
            FileFormat::Svg => self.svg().into_bytes(),
        }
    }

    /// The surface as a GLB, with a picture as its base color if there is one.
    pub fn glb(&self, base: Option<&Base<'_>>) -> Vec<u8> {
        let coordinates: Vec<DVec2> = self.coordinates.iter().map(|uv| uv.unwrap_or_default()).collect();
        let shape = Shape { vertices: &self.vertices, triangles: &self.triangles };
        let mesh = Mesh { shape, coordinates: &coordinates };
        glb::encode(&mesh, self.placement, &self.divisions, base)
    }

    /// Positions and coordinates; (0, 0) for vertices without coordinates, which are in no triangle.
    fn rows(&self) -> impl Iterator<Item = (DVec3, DVec2)> {
        let coordinates = self.coordinates.iter().map(|uv| uv.unwrap_or_default());
        self.vertices.iter().copied().zip(coordinates)
    }

    /// A line for each vertex that divides something; numbers count from `first`, and are those of `number`.
    pub(super) fn told(&self, text: &mut String, lead: &str, first: u32, number: &dyn Fn(u32) -> u32) {
        let from = self.vertices.len() - self.divisions.len();
        let number = |vertex| number(vertex) + first;
        for (vertex, division) in (from as u32..).zip(&self.divisions) {
            let vertex = number(vertex);
            let _ = match *division {
                Division::Edge([a, b], fraction) => {
                    writeln!(text, "{lead} vertex {vertex} divides the edge {} {} at {fraction}", number(a), number(b))
                }
                Division::Triangle(t) => {
                    writeln!(text, "{lead} vertex {vertex} is the middle of triangle {}", t + first)
                }
            };
        }
    }

    /// `vt k` belongs to `v k`.
    fn obj(&self) -> String {
        let mut text = String::from("# riemap: vertices in the order of the file, one vt for each\n");
        self.told(&mut text, "#", 1, &|vertex| vertex);
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
        let mut text = String::from("ply\nformat ascii 1.0\ncomment riemap: s t are texture coordinates\n");
        self.told(&mut text, "comment", 0, &|vertex| vertex);
        let _ = write!(
            text,
            "element vertex {}\n\
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

    /// A row for each vertex; the coordinates are empty if a repair has dropped it. With divided edges, three more
    /// columns: the edge's ends, counted from 0, and the fraction; empty for vertices of the file and in triangles.
    fn csv(&self) -> String {
        let is_divided = !self.divisions.is_empty();
        let mut text = String::from(if is_divided { "x,y,z,u,v,edge from,edge to,at\n" } else { "x,y,z,u,v\n" });
        let given = self.vertices.len() - self.divisions.len();
        for (k, (p, uv)) in self.vertices.iter().zip(&self.coordinates).enumerate() {
            let uv = uv.map_or_else(|| ",".to_owned(), |uv| format!("{},{}", uv.x, uv.y));
            let _ = write!(text, "{},{},{},{uv}", p.x, p.y, p.z);
            let _ = match k.checked_sub(given).and_then(|k| self.divisions.get(k)) {
                Some(Division::Edge([a, b], fraction)) => writeln!(text, ",{a},{b},{fraction}"),
                Some(Division::Triangle(_)) | None => writeln!(text, "{}", if is_divided { ",,," } else { "" }),
            };
        }
        text
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

impl Placement {
    /// The position in the outline of texture coordinates.
    pub fn position(self, coordinates: DVec2) -> DVec2 {
        coordinates / self.scale + self.origin
    }
}

/// The number in the file of a vertex of the mesh; those that are not in the file follow.
pub(super) fn number(disk: &SurfaceMesh, vertex: u32) -> u32 {
    let origins = disk.vertex_origins();
    origins
        .get(vertex as usize)
        .copied()
        .unwrap_or_else(|| (disk.origin_count() + vertex as usize - origins.len()) as u32)
}

/// Maps the bounding box of the coordinates into [0, 1]², its larger side onto a whole side.
fn unit_box(coordinates: &[Option<DVec2>]) -> Placement {
    let (low, high) = coordinates
        .iter()
        .flatten()
        .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &p| (low.min(p), high.max(p)));
    Placement { origin: low, scale: 1.0 / (high - low).max_element() }
}
