//! The map of the rectangle onto a quadrilateral, at the nodes of lattices.

use super::boundary::BoundaryMap;
use super::{Quadrilateral, QuadrilateralError};
use crate::cauchy_integral::{BoundaryFunction as _, CauchyIntegral};
use crate::geometry::{Curve, CurvePoint, DVec2, Piece};

/// The step of differences along a line, in distances from the rectangle's boundary: by Koebe's and de Branges's bounds of
/// the derivatives those of fourth order are off by 4e-7 at most.
const STEP: f64 = 0.01;

/// The conformal map of the rectangle onto a quadrilateral.
pub struct RectangleMap<'a> {
    boundary: BoundaryMap<'a>,
    inside: CauchyIntegral,
    /// The rectangle is [0, 1] × [0, modulus].
    size: DVec2,
}

/// A node of a lattice on the rectangle.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// The numbers of steps along both sides.
    pub steps: [u32; 2],
    /// The steps up to the node.
    pub at: [u32; 2],
}

impl Place {
    /// The point of the rectangle's boundary; `None` inside. The parameter counts from the nearer end of the side.
    fn on_boundary(self) -> Option<CurvePoint> {
        let ([n, m], [i, j]) = (self.steps, self.at);
        let share = |k: u32, of: u32| f64::from(k) / f64::from(of);
        let along = |piece: usize, k: u32, of: u32| {
            if 2 * k <= of {
                CurvePoint::new(piece, share(k, of))
            } else {
                CurvePoint::before_end(piece, share(of - k, of))
            }
        };
        match (i, j) {
            (_, 0) => Some(along(0, i, n)),
            _ if i == n => Some(along(1, j, m)),
            _ if j == m => Some(along(2, n - i, n)),
            (0, _) => Some(along(3, m - j, m)),
            _ => None,
        }
    }

    fn position(self, size: DVec2) -> DVec2 {
        let share = |k: usize| f64::from(self.at[k]) / f64::from(self.steps[k]);
        size * DVec2::new(share(0), share(1))
    }
}

impl Quadrilateral {
    /// The map of the rectangle onto this quadrilateral, prepared for many points.
    pub fn map(&self) -> Result<RectangleMap<'_>, QuadrilateralError> {
        let size = DVec2::new(1.0, self.modulus.value);
        let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
        let rectangle = Curve::new((0..4).map(|k| Piece::Line([corners[k], corners[(k + 1) % 4]])).collect())?;
        let boundary = BoundaryMap::new(self);
        let inside = CauchyIntegral::new(&rectangle, &boundary.breaks(), &boundary);
        Ok(RectangleMap { boundary, inside, size })
    }
}

impl RectangleMap<'_> {
    /// The image of a node: on the outline for nodes of the rectangle's boundary.
    pub(super) fn image(&self, place: Place) -> DVec2 {
        match place.on_boundary() {
            Some(at) => self.boundary.value(at),
            None => self.inside.evaluate(place.position(self.size)).value,
        }
    }

    /// The image of a node and an estimate of its error.
    pub(super) fn image_with_error(&self, place: Place) -> (DVec2, f64) {
        if let Some(at) = place.on_boundary() {
            return (self.boundary.value(at), self.boundary.error(at));
        }
        let found = self.inside.evaluate(place.position(self.size));
        (found.value, found.error)
    }

    /// The angle in radians between the images of the two lines through an interior node, by differences along each.
    pub(super) fn angle(&self, place: Place) -> f64 {
        let w = place.position(self.size);
        let step = STEP * w.min_element().min((self.size - w).min_element());
        let difference = |direction: DVec2| {
            let at = |k: f64| self.inside.evaluate(w + k * step * direction).value;
            8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))
        };
        difference(DVec2::X).angle_to(difference(DVec2::Y))
    }
}
