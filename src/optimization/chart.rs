//! A side in the unit disk: the map g that takes the side's default point to 0, with its scale.
//!
//! Positions are those of the mesh's vertices ([`disk_coordinates`]), the scale is that of [`log_disk_scale`]; both are
//! piecewise linear in the mesh's triangles. Where a side crowds, positions round to the circle and the scale stays right.

use crate::conformal::{
    HarmonicMeasure, InteriorPoint, MapError, PreparedSide, Side, SideGeometry, disk_coordinates, log_disk_scale,
    poisson_kernel,
};
use crate::geometry::{DVec2, DVec3};
use crate::laplace::NotConverged;
use crate::mesh::{BarycentricPoint, DiskLayout, TriangleId, locate};
use crate::outline::BoundaryPoint;
use num_complex::Complex64;
use std::f64::consts::TAU;
use std::sync::Arc;

/// A place nearer to the circle than this is taken for one of the boundary: nearer, positions from finite elements are not
/// right, and walks among triangles that crowd there take long.
const RIM: f64 = 1e-10;

/// One side and its map to the disk.
#[derive(Debug)]
pub struct Chart {
    prepared: Arc<PreparedSide>,
    /// The triangle of the default point.
    middle: TriangleId,
    /// By boundary edge the triangle at it.
    edge_triangles: Vec<u32>,
    /// g at the vertices.
    places: Vec<DVec2>,
    /// ln |g′| at the vertices.
    scale: Vec<f64>,
    measure: HarmonicMeasure,
}

impl Chart {
    /// The map of a side: one kernel and two solves.
    pub fn new(side: Side, prepared: &Arc<PreparedSide>) -> Result<Self, MapError> {
        let not_converged = |error: NotConverged| MapError::NotConverged { side, error };
        let middle = located(prepared, prepared.default_point(), None).ok_or(MapError::OtherKind { side })?;
        let kernel = poisson_kernel(prepared, middle).map_err(not_converged)?;
        let mut measure = HarmonicMeasure::default();
        measure.set_along(prepared.edge_lengths(), &kernel, BoundaryPoint::new(0, 0.0));
        let places = disk_coordinates(prepared, &measure).map_err(not_converged)?;
        let scale = log_disk_scale(prepared, &kernel).map_err(not_converged)?;
        let edge_triangles = triangles_at_edges(prepared);
        Ok(Self { prepared: Arc::clone(prepared), middle: middle.triangle(), edge_triangles, places, scale, measure })
    }

    /// The side.
    pub fn prepared(&self) -> &Arc<PreparedSide> {
        &self.prepared
    }

    /// The image of a boundary point, given as a fraction of the boundary's length.
    pub fn on_circle(&self, fraction: f64) -> Complex64 {
        Complex64::from_polar(1.0, TAU * self.measure.at(self.prepared.at_fraction(fraction)))
    }

    /// The boundary point with this image on the circle, as a fraction of the boundary's length.
    pub fn fraction(&self, image: Complex64) -> f64 {
        self.prepared.fraction_at(self.measure.point_at((image.arg() / TAU).rem_euclid(1.0)))
    }

    /// The image of an inner point; `None` if it is not inside of the mesh.
    pub fn image(&self, x: InteriorPoint) -> Option<Complex64> {
        let found = located(&self.prepared, x, None)?;
        let corners = self.prepared.triangles().get(found.triangle().index())?;
        Some(complex(corners.iter().zip(found.weights()).map(|(&v, w)| w * self.places[v as usize]).sum()))
    }

    /// The triangle of the default point, from which walks begin where no nearer triangle is known: beside the boundary they
    /// may begin among triangles that are folded by rounding, and find no way out.
    pub fn middle(&self) -> TriangleId {
        self.middle
    }

    /// The inner point with this image; `None` where the image of the mesh is folded.
    pub fn point(&self, image: Complex64) -> Option<InteriorPoint> {
        self.locate(image, self.middle).map(|found| self.position(found))
    }

    /// A point of the mesh as one of the side.
    pub fn position(&self, point: BarycentricPoint) -> InteriorPoint {
        match self.prepared.geometry() {
            SideGeometry::Space(_) => point.into(),
            SideGeometry::Plane(domain) => {
                let corners = domain.mesh().corner_places(point.triangle());
                corners.into_iter().zip(point.weights()).map(|(corner, w)| w * corner).sum::<DVec2>().into()
            }
        }
    }

    /// The point of the mesh with this image, sought from a triangle nearby, then from the middle; beside the circle, one of
    /// the boundary.
    pub fn locate(&self, image: Complex64, near: TriangleId) -> Option<BarycentricPoint> {
        if image.norm() > 1.0 - RIM {
            return Some(self.on_boundary(image));
        }
        let (triangles, neighbours) = match self.prepared.geometry() {
            SideGeometry::Plane(domain) => (domain.mesh().triangles(), domain.mesh().neighbours()),
            SideGeometry::Space(surface) => (surface.mesh().triangles(), surface.mesh().neighbours()),
        };
        let layout = DiskLayout { triangles, neighbours, places: &self.places };
        let from = |start: TriangleId| layout.locate(DVec2::new(image.re, image.im), start, &mut 0);
        from(near).or_else(|| if near == self.middle { None } else { from(self.middle) })
    }

    fn on_boundary(&self, image: Complex64) -> BarycentricPoint {
        let at = self.measure.point_at((image.arg() / TAU).rem_euclid(1.0));
        let triangle = self.edge_triangles[at.edge() as usize];
        let next = (at.edge() + 1) % self.prepared.boundary_count() as u32;
        let weights = self.prepared.triangles()[triangle as usize].map(|v| match v {
            v if v == at.edge() => 1.0 - at.fraction(),
            v if v == next => at.fraction(),
            _ => 0.0,
        });
        BarycentricPoint::new(TriangleId::new(triangle), weights)
    }

    /// ln |g′| at a point of the mesh.
    pub fn scale(&self, point: BarycentricPoint) -> f64 {
        let corners = self.prepared.triangles()[point.triangle().index()];
        corners.iter().zip(point.weights()).map(|(&v, w)| w * self.scale[v as usize]).sum()
    }

    /// Image and ln |g′| at the middle of a triangle.
    pub fn at_middle(&self, triangle: usize) -> (Complex64, f64) {
        let corners = self.prepared.triangles()[triangle];
        let place = corners.iter().map(|&v| self.places[v as usize]).sum::<DVec2>() / 3.0;
        (complex(place), corners.iter().map(|&v| self.scale[v as usize]).sum::<f64>() / 3.0)
    }

    /// The images of a triangle's corners.
    pub fn at_corners(&self, triangle: usize) -> [Complex64; 3] {
        self.prepared.triangles()[triangle].map(|v| complex(self.places[v as usize]))
    }

    /// The positions of a triangle's corners; the plane lies at z = 0.
    pub fn corners(&self, triangle: usize) -> [DVec3; 3] {
        let triangle = TriangleId::new(triangle as u32);
        match self.prepared.geometry() {
            SideGeometry::Plane(domain) => domain.mesh().corner_places(triangle).map(|p| p.extend(0.0)),
            SideGeometry::Space(surface) => surface.mesh().corner_places(triangle),
        }
    }

    /// The triangles that were not added by a repair, with their areas.
    pub fn triangles(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let surface = self.prepared.surface().map(|meshed| meshed.surface());
        let is_given =
            move |&t: &usize| surface.is_none_or(|mesh| mesh.origin_of_triangle(TriangleId::new(t as u32)).is_some());
        (0..self.prepared.triangles().len()).filter(is_given).map(|t| {
            let [a, b, c] = self.corners(t);
            (t, 0.5 * (b - a).cross(c - a).length())
        })
    }
}

/// By boundary edge k → k+1 the triangle with both ends as corners, one after the other.
fn triangles_at_edges(side: &PreparedSide) -> Vec<u32> {
    let m = side.boundary_count() as u32;
    let mut found = vec![0; m as usize];
    for (t, corners) in (0u32..).zip(side.triangles()) {
        for i in 0..3 {
            let (from, to) = (corners[i], corners[(i + 1) % 3]);
            if from < m && to == (from + 1) % m {
                found[from as usize] = t;
            }
        }
    }
    found
}

fn complex(p: DVec2) -> Complex64 {
    Complex64::new(p.x, p.y)
}

/// Where an inner point lies in the mesh of its side.
pub fn located(prepared: &PreparedSide, x: InteriorPoint, near: Option<TriangleId>) -> Option<BarycentricPoint> {
    match (prepared.geometry(), x) {
        (SideGeometry::Plane(domain), InteriorPoint::Plane(x)) => locate(domain.mesh(), x, near),
        (SideGeometry::Space(_), InteriorPoint::Surface(x)) => Some(x),
        _ => None,
    }
}
