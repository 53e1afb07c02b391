//! The map and its derivative at any point of either side, by Cauchy's integral over the boundary map.
//!
//! Between two curves with measures from the integral equation, f is known along the mapped curve, analytic except at
//! its own junctions and at the points that go to junctions of the other curve: the integral is divided at both. With
//! finite elements on a side it is that of a polygon with linear values (`polygonal`), right to 2 or 3 digits.

mod polygonal;
mod sliced;

use super::curved::CurveMap;
use super::{ConformalMap, Side};
use crate::cauchy_integral::{BoundaryFunction, CauchyIntegral, Evaluation, Placement};
use crate::geometry::{CurvePoint, DVec2, Junction};
use polygonal::PolygonalMap;
pub use sliced::SlicedInterior;
use std::sync::Arc;

/// Why there is no such map.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoInteriorMap {
    /// A side is a surface.
    #[error("the {side} is a surface; only a map between two outlines can be evaluated at any point")]
    Surface {
        /// Which side.
        side: Side,
    },
}

/// The map from one side into the other one, at any point.
#[derive(Debug, Clone)]
pub struct InteriorMap<'a> {
    form: Form<'a>,
}

#[derive(Debug, Clone)]
enum Form<'a> {
    Curved(Box<CurveMap<'a>>, CauchyIntegral),
    Polygonal(PolygonalMap),
}

/// The image of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InteriorImage {
    /// Of a point inside.
    Inside(Evaluation),
    /// Of a point on the boundary.
    Boundary {
        /// The image.
        value: DVec2,
        /// f′, as re + i im; `None` at corners of either side and next to them, and with finite elements.
        derivative: Option<DVec2>,
        /// An estimate of the error of the image.
        error: f64,
    },
    /// A point outside has none.
    Outside,
}

impl BoundaryFunction for CurveMap<'_> {
    fn value(&self, point: CurvePoint) -> DVec2 {
        self.onto_curve().position(self.image(point))
    }

    fn error(&self, point: CurvePoint) -> f64 {
        Self::error(self, point)
    }
}

impl ConformalMap {
    /// The map from side `from` into the other one, prepared for evaluation at many points: f for the source, its
    /// inverse for the target, whichever mesh is mapped. Some 10,000 images of boundary points.
    ///
    /// Errors: a side is a surface.
    pub fn interior_map(&self, from: Side) -> Result<InteriorMap<'_>, NoInteriorMap> {
        if let Some(side) = Side::BOTH.into_iter().find(|&side| self.side(side).is_surface()) {
            return Err(NoInteriorMap::Surface { side });
        }
        let curves = self.curve_map(from).zip(self.curve_map(from.other()));
        let Some((curves, back)) = curves else {
            let map = PolygonalMap::new(self, from);
            return map.map(|map| InteriorMap { form: Form::Polygonal(map) });
        };
        let breaks = breaks(&curves, &back);
        let integral = CauchyIntegral::new(curves.from_curve(), &breaks, &curves);
        Ok(InteriorMap { form: Form::Curved(Box::new(curves), integral) })
    }

    /// Replaces the images of the mapped mesh's interior vertices by those of [`Self::interior_map`]; boundary vertices
    /// keep theirs. Returns the number of interior vertices that lie beyond the curve, next to a concave part of it
    /// which the mesh's edges cut off: those keep their images, too. `progress` is called with the completed fraction.
    ///
    /// Errors: a side is a surface.
    pub fn extend_exactly(&mut self, progress: &mut dyn FnMut(f64)) -> Result<usize, NoInteriorMap> {
        let side = self.mapped_side();
        let Some(domain) = self.domain(side).map(Arc::clone) else { return Err(NoInteriorMap::Surface { side }) };
        let interior = self.interior_map(side)?;
        let (vertices, boundary) = (domain.mesh().vertices(), domain.samples().len());
        let mut images = self.images.clone();
        let mut beyond = 0;
        for k in boundary..vertices.len() {
            progress(k as f64 / vertices.len() as f64);
            match interior.image(vertices[k]) {
                InteriorImage::Inside(Evaluation { value, .. }) | InteriorImage::Boundary { value, .. } => {
                    images[k] = value;
                }
                InteriorImage::Outside => beyond += 1,
            }
        }
        self.images = images;
        Ok(beyond)
    }
}

/// The points that go to junctions of the other curve; `back` is the inverse.
fn breaks(curves: &CurveMap<'_>, back: &CurveMap<'_>) -> Vec<CurvePoint> {
    let junctions = curves.onto_curve().junctions().iter().enumerate();
    let breaks = junctions.filter(|(_, kind)| **kind != Junction::Analytic);
    breaks.map(|(k, _)| back.image(CurvePoint::new(k, 0.0))).collect()
}

impl InteriorMap<'_> {
    /// The image of a point. O([`Self::node_count`]).
    pub fn image(&self, z: DVec2) -> InteriorImage {
        let (curves, integral) = match &self.form {
            Form::Curved(curves, integral) => (curves, integral),
            Form::Polygonal(map) => return map.image(z),
        };
        match integral.placement(z) {
            Placement::Inside => InteriorImage::Inside(integral.evaluate(z)),
            Placement::Boundary(at) => InteriorImage::Boundary {
                value: curves.value(at),
                derivative: integral.boundary_derivative(at),
                error: BoundaryFunction::error(&**curves, at),
            },
            Placement::Outside => InteriorImage::Outside,
        }
    }

    /// The number of boundary points in the sum.
    pub fn node_count(&self) -> usize {
        match &self.form {
            Form::Curved(_, integral) => integral.node_count(),
            Form::Polygonal(map) => map.node_count(),
        }
    }

    /// Whether the map is between polygons with linear values, since a side has finite elements.
    pub fn is_polygonal(&self) -> bool {
        matches!(self.form, Form::Polygonal(_))
    }
}
