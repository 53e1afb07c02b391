//! The call to spade: constrained Delaunay triangulation and Delaunay refinement.
//!
//! Boundary edges are never split (`keep_constraint_edges`). Triangles are
//! collected by walking inward from the left side of every boundary edge without
//! crossing a constraint, so nothing depends on spade's own notion of outside.

use super::MeshError;
use crate::geometry::DVec2;
use spade::handles::{FixedFaceHandle, FixedVertexHandle, InnerTag};
use spade::{AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation};

/// Smallest angle that the refinement accepts, in degrees (the paper's).
const ANGLE_LIMIT_DEG: f64 = 20.0;

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// The input of one triangulation.
pub(super) struct Input<'a> {
    /// The boundary, counter-clockwise, simple.
    pub boundary: &'a [DVec2],
    /// Interior points.
    pub seeds: &'a [DVec2],
    /// Edges between seeds (numbered from `m`) that enclose regions not to be triangulated.
    pub holes: &'a [[u32; 2]],
    /// The largest area of a triangle, if limited.
    pub max_area: Option<f64>,
    /// The largest number of vertices that the refinement may add.
    pub max_added: usize,
}

/// The triangles between boundary and holes.
pub(super) struct Output {
    /// Vertices that the refinement added; numbered after the seeds.
    pub added: Vec<DVec2>,
    /// Counter-clockwise triples of vertex numbers: boundary, seeds, added.
    pub triangles: Vec<[u32; 3]>,
    /// Whether the refinement finished before its vertex budget ran out.
    pub complete: bool,
}

/// Triangulates and refines.
pub(super) fn triangulate(input: &Input) -> Result<Output, MeshError> {
    let mut cdt = load(input)?;
    let parameters = RefinementParameters::<f64>::new()
        .keep_constraint_edges()
        .exclude_outer_faces(true)
        .with_angle_limit(AngleLimit::from_deg(ANGLE_LIMIT_DEG))
        .with_min_required_area(min_area(input.boundary))
        .with_max_additional_vertices(input.max_added);
    let parameters = match input.max_area {
        Some(area) => parameters.with_max_allowed_area(area),
        None => parameters,
    };
    let complete = cdt.refine(parameters).refinement_complete;
    let triangles = inside_triangles(&cdt, input.boundary)?;
    let given = input.boundary.len() + input.seeds.len();
    let added = cdt.vertices().skip(given).map(|v| DVec2::new(v.position().x, v.position().y)).collect();
    Ok(Output { added, triangles, complete })
}

/// The constrained Delaunay triangulation of a polygon, counter-clockwise, without other vertices: `m − 2` triangles.
///
/// Errors: the polygon is not simple, or a coordinate other than 0 is below 1e-40 or above 1e60.
pub(crate) fn polygon_triangles(boundary: &[DVec2]) -> Result<Vec<[u32; 3]>, MeshError> {
    let cdt = load(&Input { boundary, seeds: &[], holes: &[], max_area: None, max_added: 0 })?;
    inside_triangles(&cdt, boundary)
}

/// Triangles below this area are not refined: that does no harm where edges are 1e-9 of
/// their neighbors' length, and the circumcenter of a smaller one is determined by rounding alone.
fn min_area(boundary: &[DVec2]) -> f64 {
    let m = boundary.len();
    let shortest = (0..m).map(|k| boundary[k].distance_squared(boundary[(k + 1) % m])).fold(f64::INFINITY, f64::min);
    (1e-4 * shortest).max(1e-20)
}

fn load(input: &Input) -> Result<Cdt, MeshError> {
    let m = input.boundary.len();
    let points: Vec<_> = input.boundary.iter().chain(input.seeds).map(|p| Point2::new(p.x, p.y)).collect();
    let count = points.len();
    let edges = (0..m).map(|k| [k, (k + 1) % m]).chain(input.holes.iter().map(|e| e.map(|v| v as usize)));
    let mut conflict = None;
    let cdt = Cdt::try_bulk_load_cdt(points, edges.collect(), |edge| {
        conflict.get_or_insert(edge);
    })
    .map_err(|_| MeshError::OutOfRange)?;
    if cdt.num_vertices() != count {
        return Err(MeshError::of_repeated_point(input.boundary));
    }
    if let Some([a, b]) = conflict {
        return Err(MeshError::of_crossing(input.boundary, a, b));
    }
    Ok(cdt)
}

/// The triangles reached from the boundary without crossing a constraint.
fn inside_triangles(cdt: &Cdt, boundary: &[DVec2]) -> Result<Vec<[u32; 3]>, MeshError> {
    let m = boundary.len();
    let mut inside = vec![false; cdt.num_all_faces()];
    let mut stack: Vec<FixedFaceHandle<InnerTag>> = Vec::new();
    for k in 0..m {
        let (from, to) = (FixedVertexHandle::from_index(k), FixedVertexHandle::from_index((k + 1) % m));
        let edge = cdt.get_edge_from_neighbors(from, to).filter(|edge| edge.is_constraint_edge());
        let face = edge.and_then(|edge| edge.face().as_inner());
        stack.push(face.ok_or_else(|| MeshError::of_crossing(boundary, k, (k + 1) % m))?.fix());
    }
    let mut triangles = Vec::new();
    while let Some(face) = stack.pop() {
        if std::mem::replace(&mut inside[face.index()], true) {
            continue;
        }
        let face = cdt.face(face);
        triangles.push(face.vertices().map(|v| v.index() as u32));
        for edge in face.adjacent_edges().into_iter().filter(|edge| !edge.is_constraint_edge()) {
            stack.extend(edge.rev().face().as_inner().map(|f| f.fix()));
        }
    }
    Ok(triangles)
}
