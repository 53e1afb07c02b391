//! Harmonic measure from the boundary alone, and conformal invariants.
//!
//! For x inside of a closed curve Γ with outward normal n, the density μ of harmonic measure by arc length solves
//!
//! (½ I − K*) μ = r_x,  (K*μ)(y) = −(1/2π) ∫ n_y·(y − s)/|y − s|² μ(s) ds,  r_x(y) = (1/2π) n_y·(y − x)/|y − x|²:
//!
//! the charge swept from x onto Γ has the potential of x everywhere outside. The matrix does not depend on x: it is
//! factored once, densely or hierarchically (`factor`), and one substitution gives the measure from another point. Nyström's method on
//! Gauss–Legendre panels; what is next to a corner, or next to a jump of the curvature, is compressed (`corner`).
//! Densities below about 1e-15 of the largest one may have either sign.

mod capacity;
mod corner;
mod elliptic;
mod entries;
mod error;
mod factor;
#[cfg(feature = "io")]
mod flat;
mod hierarchical;
mod invariants;
mod layout;
mod leg;
mod legendre;
mod measure;
mod panel;
mod peak;
mod skeleton;
mod span;
mod spans;
mod straight;
mod system;

use crate::geometry::{Curve, DVec2};
pub use capacity::capacity;
use corner::Problem;
pub use elliptic::modulus;
pub use error::BoundaryIntegralError;
#[cfg(feature = "io")]
pub(crate) use flat::FlatIntegral;
pub use invariants::{Estimate, Invariants, InvariantsRequest, invariants, modulus_of_both};
use layout::{Fineness, Layout, layout};
pub use measure::{AnchoredMeasure, HarmonicMeasure};
use peak::peaks;
pub use span::Beside;
use system::System;

/// The default limit of the number of unknowns. A hierarchical factor takes about 8 kB for each of them on coasts and on
/// polygons like the maple leaf, but about 30 kB on combs of many deep teeth; it is refused where it exceeds 4 GB, in a browser
/// 500 MB.
pub const MAX_UNKNOWNS: usize = if cfg!(target_family = "wasm") { 49_152 } else { 400_000 };

/// How a boundary is divided.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    near: Vec<DVec2>,
    fineness: Fineness,
    max_unknowns: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self { near: Vec::new(), fineness: Fineness::STANDARD, max_unknowns: MAX_UNKNOWNS }
    }
}

impl Settings {
    /// Panels that also resolve harmonic measure from these points, which may lie next to the boundary. Points far
    /// from the boundary need not be named, and one that is not named costs digits, not validity.
    #[must_use]
    pub fn with_points(mut self, points: &[DVec2]) -> Self {
        self.near = points.to_vec();
        self
    }

    /// About twice the unknowns, to compare with.
    #[must_use]
    pub fn finer(mut self) -> Self {
        self.fineness = Fineness::FINE;
        self
    }

    /// Panels up to `factor` ≥ 1 times as long, on which the curve is less resolved: to show how errors fall.
    #[must_use]
    pub fn coarser(mut self, factor: f64) -> Self {
        let fineness = &mut self.fineness;
        fineness.proximity *= factor;
        fineness.nearness *= factor;
        // a panel twice as long has half of the digits
        fineness.tail = fineness.tail.powf(factor.recip());
        self
    }

    /// The limit of the number of unknowns.
    #[must_use]
    pub fn with_max_unknowns(mut self, max_unknowns: usize) -> Self {
        self.max_unknowns = max_unknowns;
        self
    }
}

/// The factored equation of a curve.
#[derive(Debug)]
pub struct BoundaryIntegral {
    curve: Curve,
    layout: Layout,
    system: System,
    /// Points outside, for the identity of the logarithm.
    outside: Vec<DVec2>,
    extent: f64,
    duration_ms: f64,
}

/// The largest length of a panel, in distances from an interior point, at which the point counts as resolved: the
/// series of 16 terms then leave 4.65⁻¹⁶ = 2e-11 of the density.
const RESOLVED: f64 = 0.9;

/// The largest number of points outside that the error estimate uses.
const OUTSIDE_POINTS: usize = 8;

impl BoundaryIntegral {
    /// Divides the curve into panels, assembles and factors the equation, on one thread. O(N³) for up to 2,048 unknowns N,
    /// then about O(N).
    pub fn prepare(curve: &Curve, settings: &Settings) -> Result<Self, BoundaryIntegralError> {
        let started = web_time::Instant::now();
        let layout = layout(curve, &settings.near, (settings.fineness, Problem::Interior), settings.max_unknowns)?;
        let system = System::new(curve, &layout, Problem::Interior)?;
        let outside = outside_points(curve, &layout, &system);
        let origin = curve.pieces()[0].jet(0.0).position;
        let extent = system.places().map(|place| place.distance(origin)).fold(0.0, f64::max);
        let duration_ms = 1e3 * started.elapsed().as_secs_f64();
        Ok(Self { curve: curve.clone(), layout, system, outside, extent, duration_ms })
    }

    /// Whether the curve can be divided within the limit of `settings`; a part of what [`Self::prepare`] costs.
    pub fn check(curve: &Curve, settings: &Settings) -> Result<(), BoundaryIntegralError> {
        layout(curve, &settings.near, (settings.fineness, Problem::Interior), settings.max_unknowns).map(|_| ())
    }

    /// Whether the panels resolve harmonic measure from `x`, which may lie next to the boundary.
    pub fn resolves(&self, x: DVec2) -> bool {
        let lengths = self.system.panel_lengths();
        let mut nodes = self.system.places().enumerate();
        nodes.all(|(k, place)| lengths[k / legendre::NODES] <= RESOLVED * place.distance(x))
    }

    /// The curve.
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.system.unknowns()
    }

    /// The time that the preparation took, in milliseconds.
    pub fn duration_ms(&self) -> f64 {
        self.duration_ms
    }

    /// The harmonic measure from `x`, which must lie inside. O(N²).
    pub fn harmonic_measure(&self, x: DVec2) -> Result<HarmonicMeasure, BoundaryIntegralError> {
        if !self.curve.contains(x) {
            return Err(BoundaryIntegralError::NotInside { at: x });
        }
        let peaks = peaks(&self.curve, &self.layout, &self.system, x);
        let transformed = self.system.harmonic(x, &peaks);
        let charges = self.system.charges(&transformed);
        if !charges.iter().all(|charge| charge.is_finite()) {
            // a point of the boundary itself is a pole of the right side
            let is_inside = self.resolves(x);
            return Err(if is_inside {
                BoundaryIntegralError::Singular
            } else {
                BoundaryIntegralError::NotInside { at: x }
            });
        }
        let measure = HarmonicMeasure::new(&self.curve, &self.layout, &self.system, (&transformed, &peaks));
        Ok(measure.with_residual(self.residual(&charges, x)))
    }

    /// The charge of each node of the measure swept from x.
    fn swept(&self, x: DVec2) -> Vec<f64> {
        self.system.charges(&self.system.harmonic(x, &peaks(&self.curve, &self.layout, &self.system, x)))
    }

    /// ∫ log|s − a| dω_x(s), for any `a` that is not too near to the boundary.
    pub fn logarithmic_mean(&self, x: DVec2, a: DVec2) -> f64 {
        self.system.logarithm(&self.swept(x), a)
    }

    /// The largest residual of ∫ z dω = x, in extents of the curve, and of ∫ log|z − a| dω = log|x − a|.
    fn residual(&self, charges: &[f64], x: DVec2) -> f64 {
        let total: f64 = charges.iter().sum();
        let mean: DVec2 = self.system.nodes().zip(charges).map(|((b, n), q)| *q * ((b - x) + n.offset)).sum();
        let logarithm = |a: &DVec2| (self.system.logarithm(charges, *a) - x.distance(*a).ln()).abs();
        let of_logarithms = self.outside.iter().map(logarithm).fold(0.0, f64::max);
        (mean.length() / self.extent).max(of_logarithms).max((total - 1.0).abs())
    }
}

/// The least distance of a point outside from a panel, in lengths of the panel: the panel's rule then integrates the
/// logarithm to 1e-13.
const CLEAR: f64 = 0.7;

/// Points outside, each at about the distance of a panel's length from the panel's middle, and not much nearer to any
/// other part of the boundary.
fn outside_points(curve: &Curve, layout: &Layout, system: &System) -> Vec<DVec2> {
    let step = layout.panels.len().div_ceil(OUTSIDE_POINTS).max(1);
    let places: Vec<DVec2> = system.places().collect();
    let lengths = system.panel_lengths();
    let point = |(k, (base, node)): (usize, (DVec2, &leg::Node))| {
        let a = base + node.offset + lengths[k] * node.normal.normalize_or_zero();
        let is_clear = |(i, place): (usize, &DVec2)| place.distance(a) > CLEAR * lengths[i / legendre::NODES];
        (places.iter().enumerate().all(is_clear) && !curve.contains(a)).then_some(a)
    };
    let middles = system.nodes().skip(legendre::NODES / 2).step_by(legendre::NODES);
    middles.enumerate().step_by(step).filter_map(point).collect()
}
