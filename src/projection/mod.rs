//! Map projections of least distortion: for a region of the sphere the conformal map whose scale varies least.
//!
//! By Chebyshev's theorem (proved by Grave; Milnor, Amer. Math. Monthly 76 (1969) 1101) it is the one with constant scale
//! along the boundary. In stereographic coordinates z the sphere has the metric λ |dz|, λ = 2/(1 + |z|²), and a conformal
//! map f the scale k = |f′|/λ. log|f′| is harmonic, so that one Dirichlet problem gives it: log|f′| = log λ on the
//! boundary, where then k = 1. log k is subharmonic: k < 1 inside, and the ratio of scales is 1/min k.
//!
//! | file | what it does |
//! |---|---|
//! | `sphere` | longitude and latitude, stereographic coordinates |
//! | `ring`, `seam` | rings of a file as directed edges; cuts at the antimeridian are joined |
//! | `region` | the largest region, divided finely, in stereographic coordinates about its center |
//! | `arcs`, `potential` | log f′ as a polynomial and poles outside, by least squares on the boundary |
//! | `development` | f by integration of f′, on a mesh and from there anywhere inside |
//! | `cap`, `stereographic` | the best stereographic projection, to compare with |
//! | `example` | an island by formula |
//! | `graticule` | lines and lattices of longitude and latitude |
//!
//! The map is conformal to rounding, since f′ is a formula, and its ratio of scales is never larger than the best
//! stereographic projection's. The scale along the boundary is 1 up to [`Projection::residual`], by which all else is
//! bounded. Not guaranteed: that the residual is small. Polygons leave 1e-7, coasts with very many bays
//! 1e-4, long and narrow wound strips 1e-2.

mod arcs;
mod cap;
mod development;
mod error;
mod example;
mod graticule;
mod potential;
mod region;
mod ring;
mod seam;
mod sphere;
mod stereographic;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

use crate::geometry::{DVec2, PolygonError, SimplePolygon};
use crate::mesh::{TriMesh, TriangleId, locate};
use development::Development;
pub use error::{Contact, ProjectionError};
pub use example::island;
pub use graticule::{Graticule, LatticePoint};
pub use region::{LEAST_CLEARANCE, Region, Selection};
pub use ring::Place;
use sphere::{lon_lat, on_sphere};
pub use stereographic::Stereographics;

/// The conformal map of least distortion of a region of the unit sphere.
///
/// x and y are in radii of the sphere, the scale along the boundary is 1; the point of least scale is at the origin, with
/// north along y.
#[derive(Debug, Clone)]
pub struct Projection {
    region: Region,
    development: Development,
    /// The point of least scale, in stereographic coordinates.
    least: DVec2,
    least_log: f64,
    /// The largest log k on the boundary.
    most_log: f64,
    stereographic: Stereographics,
    overlap: Option<DVec2>,
    is_stereographic: bool,
}

/// The share of the work that the fit takes, roughly: its least squares are solved up to thirty times.
const FITTED: f64 = 0.75;

/// log λ(z) − log 2.
fn log_metric(z: DVec2) -> f64 {
    -z.length_squared().ln_1p()
}

impl Projection {
    /// Computes the map. If the boundary values are met so badly that the best stereographic projection has a smaller ratio
    /// of scales, as with a cap, whose boundary is a circle but for rounding, the map is that one.
    ///
    /// Cost: some seconds for boundaries with many corners.
    pub fn new(region: Region) -> Result<Self, ProjectionError> {
        Self::telling(region, &mut |_| true)
    }

    /// As [`Self::new`]; `progress` is called with the share that is done, which may also fall, and returns whether to go on.
    /// Errors: also [`ProjectionError::Cancelled`], if it said no.
    pub fn telling(region: Region, progress: &mut dyn FnMut(f64) -> bool) -> Result<Self, ProjectionError> {
        let stereographic = stereographic::best(&region);
        // in these coordinates the best stereographic projection is f(z) = z
        let region = region.about(on_sphere(stereographic.center))?;
        let fitted = potential::fit(&region, &log_metric, &mut |done| progress(FITTED * done));
        let fitted = Self::developed(region.clone(), stereographic, fitted.ok_or(ProjectionError::Cancelled)?)?;
        if fitted.scale_ratio() <= stereographic.ratio {
            return Ok(fitted);
        }
        let constant = potential::constant(&region, &log_metric);
        Ok(Self { is_stereographic: true, ..Self::developed(region, stereographic, constant)? })
    }

    fn developed(
        region: Region,
        stereographic: Stereographics,
        fitted: potential::Fitted,
    ) -> Result<Self, ProjectionError> {
        let development = Development::new(&region, fitted)?;
        let (least, least_log) = development.least(&region);
        let most_log = development.most();
        let development = development.placed(least, region.frame().north_at(least));
        let overlap = overlap(development.boundary_images(), &region);
        Ok(Self { region, development, least, least_log, most_log, stereographic, overlap, is_stereographic: false })
    }

    /// The region.
    pub fn region(&self) -> &Region {
        &self.region
    }

    /// The largest scale over the least one, of this map.
    pub fn scale_ratio(&self) -> f64 {
        (self.most_log - self.least_log).exp()
    }

    /// The largest |log k| on the boundary, where it should be 0. By the maximum principle log k differs nowhere by more
    /// from that of the map of least distortion, and the logarithm of [`Self::scale_ratio`] by at most twice as much.
    pub fn residual(&self) -> f64 {
        self.development.residual()
    }

    /// Whether the map is the best stereographic projection, because the one that was fitted varies more.
    pub fn is_stereographic(&self) -> bool {
        self.is_stereographic
    }

    /// The stereographic projection whose scale varies least over the region.
    pub fn stereographic(&self) -> Stereographics {
        self.stereographic
    }

    /// Longitude and latitude of the point of least scale, in degrees.
    pub fn least_scale_at(&self) -> DVec2 {
        lon_lat(self.region.frame().to_sphere(self.least))
    }

    /// Longitude and latitude of a point where the boundary's image crosses or touches itself; `None` if the map is one
    /// to one.
    pub fn overlap(&self) -> Option<DVec2> {
        self.overlap
    }

    /// The images of the boundary's points, in the order of [`Region::lon_lat`].
    pub fn boundary(&self) -> &[DVec2] {
        self.development.boundary_images()
    }

    /// The mesh on which lines of equal scale are drawn, in stereographic coordinates.
    pub fn mesh(&self) -> &TriMesh {
        self.development.mesh()
    }

    /// The images of the mesh's vertices.
    pub fn images(&self) -> &[DVec2] {
        self.development.images()
    }

    /// The scale k at the mesh's vertices.
    pub fn scales(&self) -> Vec<f64> {
        self.development.logs().iter().map(|log| log.exp()).collect()
    }

    /// The image of a point of the region, and k there; `None` outside.
    pub fn image(&self, lon_lat: DVec2) -> Option<(DVec2, f64)> {
        let z = self.region.frame().to_plane(on_sphere(lon_lat));
        let (image, _) = self.image_in_plane(z, None)?;
        Some((image, self.development.log_scale(z).exp()))
    }

    /// The image of a point in stereographic coordinates, and the triangle that contains it.
    fn image_in_plane(&self, z: DVec2, hint: Option<TriangleId>) -> Option<(DVec2, TriangleId)> {
        let at = locate(self.development.mesh(), z, hint)?;
        Some((self.development.image(z, at.triangle()), at.triangle()))
    }
}

/// Where the closed chain of images meets itself.
fn overlap(images: &[DVec2], region: &Region) -> Option<DVec2> {
    match SimplePolygon::try_from(images.to_vec()) {
        Err(
            PolygonError::EdgesCross { first, .. }
            | PolygonError::EdgesTouch { first, .. }
            | PolygonError::RepeatedPoint { first, .. }
            | PolygonError::FoldsBack { index: first, .. },
        ) => region.lon_lat().get(first).copied(),
        _ => None,
    }
}
