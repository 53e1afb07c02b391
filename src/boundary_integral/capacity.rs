//! The logarithmic capacity of a curve, with an error estimate.
//!
//! log c = ∫ log|s − x| dμ(s) for any x inside, where μ is the equilibrium measure: (½ I + K*) μ = 0, ∫ dμ = 1. It depends on
//! the curve alone, and so do its panels and its error: the difference of two resolutions, and what a spline's points leave
//! open of the boundary: to first order (Hadamard's formula, as for the conformal radius), and beyond it as much as of the
//! harmonic measure from the middle.

use super::invariants::{Estimate, both, has_splines};
use super::layout::{Layout, layout};
use super::leg::Node;
use super::legendre::{NODES, Rule};
use super::spans::left_open;
use super::{BoundaryIntegral, BoundaryIntegralError, Problem, Settings, System};
use crate::geometry::{Curve, DVec2};
use std::f64::consts::TAU;

/// The logarithmic capacity, in units of the curve's coordinates. Cost O(n³) of n unknowns up to 2,048, about O(n^1.3) beyond, at
/// two resolutions. Fails if the curve needs too many unknowns, or if its equation is singular.
pub fn capacity(curve: &Curve) -> Result<Estimate, BoundaryIntegralError> {
    let finer = Settings::default().finer();
    let coarse = Equilibrium::compute(curve, &Settings::default())?;
    let fine = Equilibrium::compute(curve, &finer)?;
    let open = moved(curve, (&fine.layout, &fine.system), &fine.charges);
    let (middle, log_capacity) = fine.inside(curve)?;
    let beside = if has_splines(curve) { left_open_from(curve, middle, finer)? } else { 0.0 };
    Ok(both(coarse.inside(curve)?.1, log_capacity, 1.0).wider(open + beside).exp())
}

/// What splines leave open of harmonic measure from a point.
fn left_open_from(curve: &Curve, x: DVec2, settings: Settings) -> Result<f64, BoundaryIntegralError> {
    let integral = BoundaryIntegral::prepare(curve, &settings.with_points(&[x]))?;
    Ok(integral.harmonic_measure(x)?.error_estimate())
}

/// The equilibrium measure on panels.
struct Equilibrium {
    layout: Layout,
    system: System,
    /// Their total is 1.
    charges: Vec<f64>,
}

impl Equilibrium {
    fn compute(curve: &Curve, settings: &Settings) -> Result<Self, BoundaryIntegralError> {
        let layout = layout(curve, &[], (settings.fineness, Problem::Interior), settings.max_unknowns)?;
        let system = System::new(curve, &layout, Problem::Exterior)?;
        let charges = system.charges(&system.equilibrium());
        let total: f64 = charges.iter().sum();
        if !(total.is_finite() && total > 0.0) {
            return Err(BoundaryIntegralError::Singular);
        }
        let charges = charges.into_iter().map(|charge| charge / total).collect();
        Ok(Self { layout, system, charges })
    }

    /// The point inside that is farthest from all panels in lengths of the panels, and the potential there: it is constant inside.
    fn inside(&self, curve: &Curve) -> Result<(DVec2, f64), BoundaryIntegralError> {
        let lengths = self.system.panel_lengths();
        let places: Vec<DVec2> = self.system.places().collect();
        let middles = self.system.nodes().skip(NODES / 2).step_by(NODES).enumerate();
        let inward = |(k, (base, node)): (usize, (DVec2, &Node))| {
            let (from, step) = (base + node.offset, lengths[k] * node.normal.normalize_or_zero());
            STEPS.map(|steps| from - steps * step)
        };
        let clearance = |x: DVec2| {
            let of_node = |(k, place): (usize, &DVec2)| place.distance(x) / lengths[k / NODES];
            places.iter().enumerate().map(of_node).fold(f64::INFINITY, f64::min)
        };
        let candidates = middles.step_by(lengths.len().div_ceil(VIEWPOINTS)).flat_map(inward);
        let inside = candidates.filter(|&x| curve.contains(x)).map(|x| (clearance(x), x));
        let (_, x) = inside.max_by(|(a, _), (b, _)| a.total_cmp(b)).ok_or(BoundaryIntegralError::Singular)?;
        Ok((x, self.system.logarithm(&self.charges, x)))
    }
}

/// How many lengths of its panel a point is away from the boundary.
const STEPS: [f64; 6] = [0.25, 0.5, 1.0, 2.0, 4.0, 8.0];
/// The panels from which points are taken, of which the best one is used.
const VIEWPOINTS: usize = 64;

/// How much the logarithm of a radius changes where the boundary moves by what the points of its splines leave open.
pub(super) fn moved(curve: &Curve, (layout, system): (&Layout, &System), charges: &[f64]) -> f64 {
    let lengths = system.panel_lengths();
    let open: Vec<f64> = layout.panels.iter().map(|panel| left_open(curve, panel)).collect();
    let at = |(k, charge): (usize, &f64)| {
        let (panel, weight) = (k / NODES, 0.5 * Rule::get().weights[k % NODES]);
        charge * charge * open[panel] / (weight * lengths[panel])
    };
    TAU * charges.iter().enumerate().map(at).sum::<f64>()
}
