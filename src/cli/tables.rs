//! The numbers of a map as JSON, and its summary.

use crate::conformal::{ConformalMap, FrameTimings, PrepareTimings, Quality, Side};
use crate::geometry::DVec2;
use crate::mesh::TriMesh;

/// The size of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Counts {
    /// Boundary vertices.
    pub m: u32,
    /// Interior vertices.
    pub n: usize,
    /// Triangles.
    pub triangles: usize,
}

impl Counts {
    /// Of this mesh.
    pub fn of(mesh: &TriMesh) -> Self {
        Self { m: mesh.boundary_count, n: mesh.interior_count(), triangles: mesh.triangles.len() }
    }
}

/// Milliseconds by stage; the preparation of both domains is added.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct MapTimings {
    #[serde(flatten)]
    prepare: PrepareTimings,
    #[serde(flatten)]
    frame: FrameTimings,
}

/// What `--json` prints, and the end of a .json file.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Summary {
    /// Angle distortion of the mapped mesh.
    pub quality: Quality,
    /// Where the time went.
    pub timing_ms: MapTimings,
    /// The mapped mesh.
    pub counts: Counts,
}

impl Summary {
    /// Of this map.
    pub fn of(map: &ConformalMap) -> Self {
        let [a, b] = Side::BOTH.map(|side| map.domain(side).timings);
        let prepare = PrepareTimings {
            sample: a.sample + b.sample,
            mesh: a.mesh + b.mesh,
            assemble: a.assemble + b.assemble,
            order: a.order + b.order,
            factor: a.factor + b.factor,
            table: a.table + b.table,
        };
        Self {
            quality: map.quality(),
            timing_ms: MapTimings { prepare, frame: map.timings() },
            counts: Counts::of(map.mapped_mesh()),
        }
    }
}

#[derive(serde::Serialize)]
struct Boundary<'a> {
    boundary: &'a [DVec2],
}

#[derive(serde::Serialize)]
struct MapDocument<'a> {
    source: Boundary<'a>,
    target: Boundary<'a>,
    boundary_map: Vec<[f64; 4]>,
    harmonic_measure: Vec<f64>,
    vertices: &'a [DVec2],
    triangles: &'a [[u32; 3]],
    images: &'a [DVec2],
    #[serde(flatten)]
    summary: Summary,
}

/// The boundary samples of the mapped side with their images: x, y, u, v.
fn boundary_map(map: &ConformalMap) -> Vec<[f64; 4]> {
    let mesh = map.mapped_mesh();
    let boundary = &mesh.vertices[..mesh.boundary_count as usize];
    boundary.iter().zip(map.images()).map(|(p, q)| [p.x, p.y, q.x, q.y]).collect()
}

/// The harmonic measure at every boundary sample of the mapped side, from its anchor.
fn harmonic_measure(map: &ConformalMap) -> Vec<f64> {
    let measure = map.measure(map.direction().mapped_side());
    (0..measure.vertex_count()).map(|k| measure.at_vertex(k)).collect()
}

/// The whole map as JSON.
pub fn json(map: &ConformalMap, summary: Summary) -> Result<Vec<u8>, serde_json::Error> {
    let mesh = map.mapped_mesh();
    let boundary = |side| Boundary { boundary: map.domain(side).samples.points.as_slice() };
    serde_json::to_vec(&MapDocument {
        source: boundary(Side::Source),
        target: boundary(Side::Target),
        boundary_map: boundary_map(map),
        harmonic_measure: harmonic_measure(map),
        vertices: &mesh.vertices,
        triangles: &mesh.triangles,
        images: map.images(),
        summary,
    })
}
