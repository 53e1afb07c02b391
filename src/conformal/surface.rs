//! The geometry of a surface as a side (section 4.3): a triangle mesh in space, flipped to intrinsic Delaunay.
//!
//! A surface is prepared like a planar domain except for its geometry: the Laplacian comes from
//! edge lengths, by default of the intrinsic Delaunay triangulation of its vertices, so that
//! no weight is negative, ψ ≥ 0, and the matching keeps the order of the boundary.

use crate::geometry::DVec3;
use crate::mesh::{BarycentricPoint, FlipReport, IntrinsicMesh, TriMesh};
use crate::outline::BoundaryPoint;
use crate::surface::{SurfaceMesh, SurfaceTree, farthest_from_boundary};
use std::sync::OnceLock;

/// A surface with the lengths along its boundary.
///
/// Lengths and fractions belong to the `m` boundary vertices of the mesh, in their order; the center lies inside.
#[derive(Debug, Clone)]
pub struct MeshedSurface {
    surface: SurfaceMesh,
    edge_lengths: Vec<f64>,
    fractions: Vec<f64>,
    flips: FlipReport,
    centre: BarycentricPoint,
    tree: OnceLock<SurfaceTree>,
    holes: OnceLock<Vec<Vec<u32>>>,
}

impl MeshedSurface {
    /// The surface and its intrinsic triangulation, flipped to Delaunay if `delaunay`, else unchanged.
    pub(super) fn flipped(surface: SurfaceMesh, delaunay: bool) -> (Self, IntrinsicMesh) {
        let mut intrinsic = IntrinsicMesh::of(surface.mesh());
        let flips = if delaunay { intrinsic.make_delaunay() } else { unflipped(&intrinsic) };
        let centre = farthest_from_boundary(surface.mesh());
        (Self::from_parts(surface, flips, centre), intrinsic)
    }

    /// The surface from its parts, as they are after a transfer.
    pub(super) fn from_parts(surface: SurfaceMesh, flips: FlipReport, centre: BarycentricPoint) -> Self {
        let (edge_lengths, fractions) = along_boundary(surface.mesh());
        Self { surface, edge_lengths, fractions, flips, centre, tree: OnceLock::new(), holes: OnceLock::new() }
    }

    /// The surface as it was read and repaired: boundary loop first.
    pub fn surface(&self) -> &SurfaceMesh {
        &self.surface
    }

    /// The triangle mesh of the surface.
    pub fn mesh(&self) -> &TriMesh<DVec3> {
        self.surface.mesh()
    }

    /// The report on the intrinsic Delaunay flips; without flips, the number of negative weights.
    pub fn flips(&self) -> FlipReport {
        self.flips
    }

    /// The default interior point: the vertex farthest from the boundary.
    pub fn centre(&self) -> BarycentricPoint {
        self.centre
    }

    /// The lengths of the boundary edges, `m` of them.
    pub fn edge_lengths(&self) -> &[f64] {
        &self.edge_lengths
    }

    /// The position of each boundary vertex as a fraction of the loop's length from the first one.
    pub fn fractions(&self) -> &[f64] {
        &self.fractions
    }

    /// The point of the loop at fraction `s` of its length (taken modulo 1).
    pub fn at_fraction(&self, s: f64) -> BoundaryPoint {
        BoundaryPoint::at_fraction(&self.fractions, s)
    }

    /// The fraction of the loop's length at a point of the loop.
    pub fn fraction_at(&self, point: BoundaryPoint) -> f64 {
        point.fraction_in(&self.fractions)
    }

    /// The search tree for rays and nearest points; built on the first call.
    pub fn tree(&self) -> &SurfaceTree {
        self.tree.get_or_init(|| SurfaceTree::new(self.surface.mesh()))
    }

    /// The search tree if it is already built; building takes a while for millions of triangles.
    pub fn tree_if_made(&self) -> Option<&SurfaceTree> {
        self.tree.get()
    }

    /// The boundary loops that repairs have filled ([`SurfaceMesh::holes`]); found on the first call.
    pub fn holes(&self) -> &[Vec<u32>] {
        self.holes.get_or_init(|| self.surface.holes())
    }

    /// The position in space of a point of the boundary loop.
    pub fn boundary_position(&self, point: BoundaryPoint) -> DVec3 {
        let (m, edge) = (self.surface.mesh().boundary_count(), point.edge());
        let [a, b] = [edge, (edge + 1) % m].map(|k| self.surface.mesh().vertices()[k as usize]);
        a.lerp(b, point.fraction())
    }

    /// The position in space of a point of the surface.
    pub fn position(&self, point: BarycentricPoint) -> DVec3 {
        let corners = self.surface.mesh().triangles()[point.triangle().index()];
        corners.iter().zip(point.weights()).map(|(&v, w)| w * self.surface.mesh().vertices()[v as usize]).sum()
    }
}

fn unflipped(intrinsic: &IntrinsicMesh) -> FlipReport {
    let negative = intrinsic.negative_weights();
    FlipReport { flips: 0, negative_before: negative, negative_after: negative }
}

/// The lengths of the boundary edges, and the fraction of their sum before each.
fn along_boundary(mesh: &TriMesh<DVec3>) -> (Vec<f64>, Vec<f64>) {
    let boundary = &mesh.vertices()[..mesh.boundary_count() as usize];
    let next = boundary.iter().cycle().skip(1);
    let lengths: Vec<f64> = boundary.iter().zip(next).map(|(p, q)| p.distance(*q)).collect();
    let total: f64 = lengths.iter().sum();
    let before = lengths.iter().scan(0.0, |sum, length| Some(std::mem::replace(sum, *sum + length)));
    let fractions = before.map(|sum| sum / total).collect();
    (lengths, fractions)
}
