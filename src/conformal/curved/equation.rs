//! The factored integral equation of a side's boundary, which a prepared side is given with its preparation or afterwards.

use super::preparation::{Outlined, equation_settings};
use super::{CurveBoundary, Unsharpened};
use crate::boundary_integral::{BoundaryIntegral, BoundaryIntegralError, HarmonicMeasure};
use crate::geometry::{Curve, DVec2, SimplePolygon};
use crate::outline::BoundaryPoint;
use std::sync::{Arc, Mutex, PoisonError};

use super::super::{MeshedDomain, PrepareSettings};

/// The integral equation of a curve, with the samples of a side on the curve.
#[derive(Debug, Clone)]
pub struct BoundaryEquation {
    boundary: Arc<CurveBoundary>,
    integral: Arc<BoundaryIntegral>,
    /// The last harmonic measures, the latest first.
    recent: Arc<Mutex<Vec<Swept>>>,
}

/// A harmonic measure with the point that it is seen from.
type Swept = (DVec2, Arc<HarmonicMeasure>);

/// The number of harmonic measures that are kept: a drag of pins asks for that of the last frame, for those of a few steps
/// of Newton's method, and for the last one again to map with it.
const RECENT: usize = 2;

impl BoundaryEquation {
    /// Factors the equation of an outline's curve, on which the samples of the outline's preparation with `settings`
    /// lie; `near` are interior points to resolve even next to the boundary.
    ///
    /// Errors: the equation needs more than [`super::MAX_UNKNOWNS`] unknowns, or is not resolved, or the samples do not lie
    /// on the curve.
    pub fn prepare(
        (polygon, curve): (&SimplePolygon, &Curve),
        near: &[DVec2],
        settings: &PrepareSettings,
    ) -> Result<Self, Unsharpened> {
        let outlined = Outlined { polygon, curve: Some(curve) };
        Self::of(outlined.boundary(settings)?, &outlined.near(near))
    }

    /// Factors the equation of a curve with samples.
    pub(in crate::conformal) fn of(boundary: CurveBoundary, near: &[DVec2]) -> Result<Self, Unsharpened> {
        let prepare = |near: &[DVec2]| {
            let curve = boundary.curve();
            BoundaryIntegral::prepare(curve, &equation_settings(curve, near))
        };
        let integral = match prepare(near) {
            // without panels for points next to the boundary they cost digits, not the equation
            Err(BoundaryIntegralError::TooManyUnknowns { .. }) if !near.is_empty() => prepare(&[])?,
            result => result?,
        };
        Ok(Self::new(boundary, integral))
    }

    fn new(boundary: CurveBoundary, integral: BoundaryIntegral) -> Self {
        Self { boundary: Arc::new(boundary), integral: Arc::new(integral), recent: Arc::default() }
    }

    /// The same equation with samples at `places` among its own.
    pub(in crate::conformal) fn resampled(&self, places: &[BoundaryPoint]) -> Self {
        Self { boundary: Arc::new(self.boundary.resampled(places)), ..self.clone() }
    }

    /// The curve with the samples.
    pub fn boundary(&self) -> &Arc<CurveBoundary> {
        &self.boundary
    }

    /// The factored equation.
    pub fn integral(&self) -> &BoundaryIntegral {
        &self.integral
    }

    /// The harmonic measure from `x`, which must lie inside. O(N²) for N unknowns, or O(1) if it is one of the last two.
    pub fn harmonic_measure(&self, x: DVec2) -> Result<Arc<HarmonicMeasure>, BoundaryIntegralError> {
        let recent = || self.recent.lock().unwrap_or_else(PoisonError::into_inner);
        let known = recent().iter().find(|(at, _)| *at == x).map(|(_, measure)| Arc::clone(measure));
        let measure = match known {
            Some(measure) => measure,
            None => Arc::new(self.integral.harmonic_measure(x)?),
        };
        let mut recent = recent();
        recent.retain(|(at, _)| *at != x);
        recent.insert(0, (x, Arc::clone(&measure)));
        recent.truncate(RECENT);
        Ok(measure)
    }

    /// Whether harmonic measure from `x` is resolved as well as from a point far from the boundary.
    pub fn resolves(&self, x: DVec2) -> bool {
        self.integral.resolves(x)
    }

    /// Whether the samples of a domain are those on the curve.
    pub(in crate::conformal) fn is_of(&self, domain: &MeshedDomain) -> bool {
        let (points, places) = (self.boundary.points(), domain.samples().points());
        let position = |k: usize| self.boundary.curve().position(points[k]);
        points.len() == places.len() && places.iter().enumerate().all(|(k, place)| position(k) == *place)
    }
}

/// A [`BoundaryEquation`] as flat arrays, without its curve.
#[cfg(feature = "io")]
#[derive(Debug, Clone, Default, serde::Serialize, serde::Deserialize)]
pub(crate) struct FlatEquation {
    /// The factored equation.
    pub integral: crate::boundary_integral::FlatIntegral,
    /// Of each sample the piece, t and 1 − t.
    #[serde(skip)]
    pub points: Vec<f64>,
}

#[cfg(feature = "io")]
impl BoundaryEquation {
    /// The equation as flat arrays.
    pub(crate) fn to_flat(&self) -> FlatEquation {
        let flat = |point: &crate::geometry::CurvePoint| [point.piece() as f64, point.from_start(), point.to_end()];
        FlatEquation {
            integral: self.integral.to_flat(),
            points: self.boundary.points().iter().flat_map(flat).collect(),
        }
    }

    /// The equation of `curve` from flat arrays; `None` unless [`Self::to_flat`] wrote them for this curve.
    pub(crate) fn from_flat(curve: &Curve, FlatEquation { integral, points }: FlatEquation) -> Option<Self> {
        let (points, []) = points.as_chunks::<3>() else { return None };
        let point = |&[piece, from_start, to_end]: &[f64; 3]| {
            let point = crate::geometry::CurvePoint::of_parts(piece as usize, from_start, to_end)?;
            (point.piece() as f64 == piece).then_some(point)
        };
        let points = points.iter().map(point).collect::<Option<Vec<_>>>()?;
        let boundary = CurveBoundary::with_points(curve, points)?;
        let integral = BoundaryIntegral::from_flat(curve, integral)?;
        Some(Self::new(boundary, integral))
    }
}
