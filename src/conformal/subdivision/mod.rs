//! Surfaces computed on finer meshes than their own, with the results at their own vertices.
//!
//! Few triangles resolve neither harmonic measure nor images: a mesh without inner vertices has no freedom inside at all.
//! Every triangle is cut into four, which leaves the surface as it is, until harmonic measure at the surface's own boundary
//! vertices changes by less than [`TOLERANCE`], or [`MOST_TRIANGLES`] would be exceeded. The map is computed there, and what
//! is returned is that map at the surface's own vertices.
//!
//! | file | what |
//! |---|---|
//! | `places` | which places of both meshes correspond |
//! | `own` | the map at the own vertices, and its errors |

mod own;
mod places;

use super::{
    Constraints, HarmonicMeasure, InteriorPoint, MapError, PerSide, PrepareTimings, PreparedSide, QuarteredError, Side,
    Stage, SurfaceSettings, poisson_kernel, prepare_quartered,
};
use crate::laplace::NotConverged;
use crate::mesh::BarycentricPoint;
use crate::outline::BoundaryPoint;
pub use own::Finest;
pub use places::Cuts;
use std::sync::Arc;

/// The change of harmonic measure from a mesh to the next finer one after which no other follows: a hundredth of a degree of
/// the disk. With errors of order 1 or better, that of the finer mesh is not larger.
pub const TOLERANCE: f64 = 0.01 / 360.0;

/// The largest number of triangles.
pub const MOST_TRIANGLES: usize = 200_000;

/// Below so many triangles two meshes may agree by chance.
const LEAST_TRIANGLES: usize = 1_000;

/// A side with the finer mesh on which it is computed.
#[derive(Debug, Clone)]
pub struct Subdivided {
    own: Arc<PreparedSide>,
    /// The mesh before the last cut, to compare with.
    before: Arc<PreparedSide>,
    finest: Arc<PreparedSide>,
    cuts: Cuts,
    timings: PrepareTimings,
}

impl Subdivided {
    /// A side that is computed on its own mesh.
    pub fn not(own: &Arc<PreparedSide>) -> Self {
        let [own, before, finest] = [own, own, own].map(Arc::clone);
        Self { own, before, finest, cuts: Cuts::default(), timings: PrepareTimings::default() }
    }

    /// A surface, cut until harmonic measure from `x` is resolved; an outline as it is.
    pub fn new(
        own: &Arc<PreparedSide>,
        x: InteriorPoint,
        settings: SurfaceSettings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<Self, SubdivisionError> {
        let mut cut = Self::not(own);
        let Some(x) = x.on_surface() else { return Ok(cut) };
        let mut known = cut.measures(x)?;
        while let Some(surface) = cut.finest.surface().filter(|_| 4 * cut.finest.triangles().len() <= MOST_TRIANGLES) {
            let finer = Arc::new(prepare_quartered(surface, settings, progress)?);
            let timings = cut.timings.and(finer.timings());
            cut = Self { before: cut.finest, finest: finer, cuts: Cuts(cut.cuts.0 + 1), timings, ..cut };
            let measures = cut.measures(x)?;
            let change = range(known.iter().zip(&measures).map(|(a, b)| a - b));
            known = measures;
            if change <= TOLERANCE && cut.finest.triangles().len() >= LEAST_TRIANGLES {
                break;
            }
        }
        Ok(cut)
    }

    /// The side on its own mesh.
    pub fn own(&self) -> &Arc<PreparedSide> {
        &self.own
    }

    /// The side on the mesh before the finest one; the own one if it is not cut.
    pub fn before(&self) -> &Arc<PreparedSide> {
        &self.before
    }

    /// The side on the mesh on which it is computed.
    pub fn finest(&self) -> &Arc<PreparedSide> {
        &self.finest
    }

    /// The duration of the preparation of all finer meshes.
    pub fn timings(&self) -> PrepareTimings {
        self.timings
    }

    /// Whether it is cut.
    pub fn is_cut(&self) -> bool {
        self.cuts != Cuts::default()
    }

    /// The cuts that lead to the mesh before the finest one.
    fn cuts_before(&self) -> Cuts {
        Cuts(self.cuts.0.saturating_sub(1))
    }

    /// Harmonic measure from a point of the own mesh at the own boundary vertices, from the first one.
    fn measures(&self, x: BarycentricPoint) -> Result<Vec<f64>, NotConverged> {
        let psi = poisson_kernel(&self.finest, self.cuts.finer(x))?;
        let mut measure = HarmonicMeasure::default();
        measure.set_along(self.finest.edge_lengths(), &psi, BoundaryPoint::new(0, 0.0));
        Ok((0..self.own.boundary_count()).map(|k| measure.at_vertex(self.cuts.vertex(k, usize::MAX))).collect())
    }
}

/// The largest value less the least one.
fn range(values: impl Iterator<Item = f64>) -> f64 {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    high - low
}

/// `constraints` between the own meshes, between those with so many cuts.
fn finer(constraints: &Constraints, cuts: PerSide<Cuts>) -> Constraints {
    let point = |side: Side| match constraints.points[side] {
        InteriorPoint::Surface(point) => InteriorPoint::Surface(cuts[side].finer(point)),
        plane @ InteriorPoint::Plane(_) => plane,
    };
    Constraints { points: PerSide::from_fn(point), ..*constraints }
}

impl PerSide<Subdivided> {
    /// `constraints` between the own meshes, between the finest ones.
    pub fn finest(&self, constraints: &Constraints) -> Constraints {
        finer(constraints, PerSide::from_fn(|side| self[side].cuts))
    }

    /// The inverse of [`Self::finest`].
    pub fn own(&self, constraints: &Constraints) -> Constraints {
        let point = |side: Side| match constraints.points[side] {
            InteriorPoint::Surface(point) => InteriorPoint::Surface(self[side].cuts.coarser(point)),
            plane @ InteriorPoint::Plane(_) => plane,
        };
        Constraints { points: PerSide::from_fn(point), ..*constraints }
    }
}

/// Why a surface could not be computed on a finer mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SubdivisionError {
    /// A finer mesh could not be prepared.
    #[error("a finer mesh cannot be prepared: {0}")]
    Quartered(#[from] QuarteredError),
    /// The iterative solver did not converge.
    #[error(transparent)]
    NotConverged(#[from] NotConverged),
    /// The map on the finer mesh could not be computed.
    #[error(transparent)]
    Map(#[from] MapError),
}
