//! Harmonic measure as seen from one point of a side, by the kernel that maps of the side have, counted from an anchor.
//!
//! The disk map with value 0 at the point and angle 2πω at the boundary has an inverse g. Its derivative at 0,
//! g′(0) = ∫ γ e^{−2πiω} dω over the boundary γ, tells how measures change with the point: the harmonic function that is 1
//! on the arc from angle A to B and 0 elsewhere is (B − A)/2π + Re(i (e^{−iB} − e^{−iA}) w)/π + O(w²) at w.

use super::slices::{INTERRUPTED, Slices};
use crate::boundary_integral::{self, BoundaryIntegralError};
use crate::conformal::{CurveBoundary, HarmonicMeasure, InteriorPoint, MapError, PreparedSide, Side, SideGeometry};
use crate::geometry::{DMat2, DVec2, DVec3};
use crate::mesh::{BarycentricPoint, locate};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Places of the boundary, equally spaced in measure, from which g′(0) is summed: the error is that of Taylor coefficients
/// beyond it, 1e-3 where the boundary has corners.
const PLACES: u32 = 64;

/// Half of the length, as a share of the boundary's, from which a density is taken.
const DIFFERENCE: f64 = 1e-6;

/// The harmonic measure of a side's boundary, seen from a point. Places of the boundary are fractions of its length.
pub struct View<'a> {
    prepared: &'a PreparedSide,
    anchor: f64,
    measure: Measure<'a>,
}

enum Measure<'a> {
    Curve(&'a CurveBoundary, Arc<boundary_integral::HarmonicMeasure>),
    Mesh(Arc<HarmonicMeasure>),
}

impl<'a> View<'a> {
    /// The measure seen from `x`, a step of `slices`. Errors: `x` is not inside, or the kernel there could not be computed.
    pub fn new(
        (side, prepared): (Side, &'a PreparedSide),
        x: InteriorPoint,
        anchor: f64,
        slices: &Slices,
    ) -> Result<Self, MapError> {
        let on_mesh = |x: BarycentricPoint| {
            let measure = slices.on_mesh(prepared, x, anchor).unwrap_or(Err(INTERRUPTED));
            measure.map(Measure::Mesh).map_err(|error| MapError::NotConverged { side, error })
        };
        let measure = match (prepared.geometry(), x) {
            (SideGeometry::Plane(domain), InteriorPoint::Plane(x)) => {
                let outside = MapError::PointOutside { side, x: x.x, y: x.y };
                if let Some(equation) = prepared.equation() {
                    match slices.on_curve(equation, x) {
                        Some(Ok(measure)) => Measure::Curve(equation.boundary(), measure),
                        Some(Err(BoundaryIntegralError::NotInside { .. })) => return Err(outside),
                        Some(Err(error)) => return Err(MapError::BoundaryIntegral { side, error }),
                        None => return Err(MapError::NotConverged { side, error: INTERRUPTED }),
                    }
                } else {
                    let located = if prepared.contains(x) { locate(domain.mesh(), x, None) } else { None };
                    on_mesh(located.ok_or(outside)?)?
                }
            }
            (SideGeometry::Space(_), InteriorPoint::Surface(x)) => on_mesh(x)?,
            _ => return Err(MapError::OtherKind { side }),
        };
        Ok(Self { prepared, anchor, measure })
    }

    /// The measure of the arc from `a` counter-clockwise to `b`.
    fn between(&self, a: f64, b: f64) -> f64 {
        match &self.measure {
            Measure::Curve(boundary, measure) => measure.between(boundary.at_fraction(a), boundary.at_fraction(b)),
            Measure::Mesh(measure) => {
                let [a, b] = [a, b].map(|s| measure.at(self.prepared.at_fraction(s)));
                if b < a { 1.0 + (b - a) } else { b - a }
            }
        }
    }

    /// The measures of the arcs from the first mark to the second and from there to the third.
    pub fn arcs(&self, [a, b, c]: [f64; 3]) -> DVec2 {
        DVec2::new(self.between(a, b), self.between(b, c))
    }

    /// The measure per share of the boundary's length at a place.
    pub fn density(&self, s: f64) -> f64 {
        let ends = [s - DIFFERENCE, s + DIFFERENCE].map(|s| s.rem_euclid(1.0));
        self.between(ends[0], ends[1]) / (2.0 * DIFFERENCE)
    }

    /// The measure from the anchor counter-clockwise to a place.
    pub fn omega(&self, s: f64) -> f64 {
        self.between(self.anchor, s)
    }

    /// The places with these measures, each taken modulo 1, from the anchor on.
    pub fn fractions(&self, omegas: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let omegas = omegas.into_iter().map(|omega| omega.rem_euclid(1.0));
        match &self.measure {
            Measure::Curve(boundary, measure) => {
                let measure = measure.from_anchor(boundary.at_fraction(self.anchor));
                omegas.map(|omega| boundary.fraction(measure.point_at(omega))).collect()
            }
            Measure::Mesh(measure) => omegas.map(|omega| self.prepared.fraction_at(measure.point_at(omega))).collect(),
        }
    }

    /// The positions of the places with these measures, each taken modulo 1, from the anchor on.
    pub fn positions(&self, omegas: impl IntoIterator<Item = f64>) -> Vec<DVec3> {
        let omegas = omegas.into_iter().map(|omega| omega.rem_euclid(1.0));
        match &self.measure {
            Measure::Curve(boundary, measure) => {
                let measure = measure.from_anchor(boundary.at_fraction(self.anchor));
                omegas.map(|omega| boundary.curve().position(measure.point_at(omega)).extend(0.0)).collect()
            }
            Measure::Mesh(measure) => {
                omegas.map(|omega| self.prepared.boundary_place(measure.point_at(omega))).collect()
            }
        }
    }

    /// The position of a place; the plane lies at z = 0.
    pub fn position(&self, s: f64) -> DVec3 {
        match &self.measure {
            Measure::Curve(boundary, _) => boundary.curve().position(boundary.at_fraction(s)).extend(0.0),
            Measure::Mesh(_) => self.prepared.boundary_place(self.prepared.at_fraction(s)),
        }
    }

    /// The derivatives of [`Self::arcs`] by the point, of a planar side: columns by x and y.
    pub fn derivative(&self, marks: [f64; 3]) -> DMat2 {
        let places = self.positions((0..PLACES).map(|k| f64::from(k) / f64::from(PLACES)));
        let expansion: Complex64 = places
            .into_iter()
            .zip(0u32..)
            .map(|(place, k)| {
                let turned = Complex64::from_polar(1.0 / f64::from(PLACES), -TAU * f64::from(k) / f64::from(PLACES));
                turned * Complex64::new(place.x, place.y)
            })
            .sum();
        let [a, b, c] = marks.map(|s| Complex64::from_polar(1.0, -TAU * self.omega(s)));
        let [first, second] = [b - a, c - b].map(|chord| Complex64::I * chord / (PI * expansion));
        DMat2::from_cols(DVec2::new(first.re, second.re), DVec2::new(-first.im, -second.im))
    }
}
