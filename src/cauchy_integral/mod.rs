//! Cauchy's integral of a function that is given on a closed curve: values and derivatives inside, to the digits that
//! the boundary values have, however near to the curve.
//!
//! f(z) = ∮ F(ζ)/(ζ − z) dζ / ∮ 1/(ζ − z) dζ, the quotient ("barycentric form") because both integrals have almost the
//! same relative error. The curve is divided into panels of Gauss–Legendre nodes, broken where the curve or F is not
//! analytic and graded toward these points by bisection (`division`). A panel that is far from z, in terms of its own
//! length, is integrated by its Gauss rule, a near one exactly for the polynomial that interpolates F in ζ (Helsing &
//! Ojala, J. Comput. Phys. 227 (2008) 2899), so that z may lie anywhere inside.

mod division;
mod evaluation;
mod panel;
mod placement;
mod rule;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;

use crate::geometry::{Curve, CurvePoint, DVec2};
pub use division::Division;
use panel::Panel;
pub use placement::Placement;

/// A complex number.
type Complex = num_complex::Complex64;

/// A function on the points of a curve.
pub trait BoundaryFunction {
    /// F at a point; between break points of curve and function, F is analytic along the curve.
    fn value(&self, point: CurvePoint) -> DVec2;

    /// A bound of the error of [`Self::value`] there. Panels are not divided further than their values are right.
    fn error(&self, point: CurvePoint) -> f64;
}

/// The values of an analytic function inside of a curve, from those on it.
#[derive(Debug, Clone)]
pub struct CauchyIntegral {
    curve: Curve,
    /// In the order of the curve, around it.
    panels: Vec<Panel>,
    /// The values of the panels are relative to this one.
    center: Complex,
    /// The largest absolute value of F, for rounding errors.
    magnitude: f64,
    /// The largest distance between values.
    extent: f64,
}

/// f and its derivative at a point inside.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Evaluation {
    /// f(z).
    pub value: DVec2,
    /// f′(z), as re + i im.
    pub derivative: DVec2,
    /// An estimate of the error of the value: that of the boundary values and of the panels, weighted as they
    /// contribute.
    pub error: f64,
}

impl CauchyIntegral {
    /// Divides the curve so that F is resolved between its own junctions and `breaks`, the points where F is not
    /// analytic; they need no order.
    ///
    /// F is evaluated at the nodes of all panels that are tried: some ten thousand times for a dozen break points.
    pub fn new(curve: &Curve, breaks: &[CurvePoint], function: &dyn BoundaryFunction) -> Self {
        let mut division = Division::new(curve, breaks);
        division.advance(function, &mut || false);
        division.finish()
    }

    /// The curve.
    pub fn curve(&self) -> &Curve {
        &self.curve
    }

    /// The number of nodes.
    pub fn node_count(&self) -> usize {
        self.panels.len() * rule::NODES
    }
}

fn complex(p: DVec2) -> Complex {
    Complex::new(p.x, p.y)
}

fn point(z: Complex) -> DVec2 {
    DVec2::new(z.re, z.im)
}
