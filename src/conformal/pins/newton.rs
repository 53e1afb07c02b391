//! The point of a side that sees three arcs under given measures: Newton's method.
//!
//! In the plane the derivatives are those of [`View::derivative`] at first; each step then corrects them along itself
//! (Broyden 1965), which saves one or two kernels. A step that leaves the side or does not improve is halved. On a surface
//! they are those of the discrete harmonic functions of the arcs, which are nearly right, so that each step divides the
//! error by ten or more. Both end at rounding, or where finite elements jump from triangle to triangle.

use super::arcs::Arcs;
use super::difference;
use super::slices::Slices;
use super::view::View;
use crate::conformal::{InteriorPoint, MapError, PreparedSide, Side};
use crate::geometry::{DMat2, DVec2};

/// Differences of measures that are rounding. Next to a right-angled corner images are off by their square roots, so that a
/// search does not end earlier where measures are known to 1e-12 only.
const ROUNDING: f64 = 2e-14;
/// Differences of measures below which a step that does not improve is not halved: what is left is rounding.
const NOISE: f64 = 1e-11;
/// Steps: from the error of finite elements, two or three suffice in the plane.
const STEPS: usize = 30;
/// Halvings of a step.
const HALVINGS: i32 = 8;
/// The largest difference that is left to finite elements' jumps, relative to the least of the three arcs; a larger one
/// means that the beginning was too far off.
const FAR: f64 = 1e-3;

/// The share of the difference that a step leaves where the derivative was nearly right.
const NEAR: f64 = 0.02;

/// The same at a point that the side's equation does not resolve, so that measures seen from it are not exact: it is
/// found again after the side has been prepared for it.
const UNRESOLVED: f64 = 0.3;

/// A point with the measures seen from there.
pub type Found<'a> = (InteriorPoint, View<'a>);

/// A side with three marks on its boundary and the measures that the first two arcs are to have.
#[derive(Clone, Copy)]
pub struct Wanted<'a> {
    pub side: Side,
    pub prepared: &'a PreparedSide,
    pub marks: [f64; 3],
    pub measures: DVec2,
    pub slices: &'a Slices,
}

/// A point, and by how much the measures seen from there are too large.
struct Try<'a> {
    view: View<'a>,
    off: DVec2,
}

impl<'a> Wanted<'a> {
    fn try_at(&self, x: InteriorPoint) -> Result<Try<'a>, MapError> {
        let view = View::new((self.side, self.prepared), x, self.marks[0], self.slices)?;
        let off = view.arcs(self.marks) - self.measures;
        Ok(Try { view, off })
    }

    /// The largest difference of the measures seen from a point of the plane; `None` outside.
    pub fn off(&self, x: DVec2) -> Option<f64> {
        self.try_at(x.into()).ok().map(|found| size(found.off))
    }

    /// Whether a difference is small enough for the place where it is left.
    fn is_met(&self, off: f64, x: InteriorPoint) -> bool {
        let is_resolved = match (x, self.prepared.equation()) {
            (InteriorPoint::Plane(x), Some(equation)) => equation.resolves(x),
            _ => true,
        };
        let most = if is_resolved { FAR } else { UNRESOLVED };
        let DVec2 { x, y } = self.measures;
        off <= most * x.min(y).min(1.0 - x - y)
    }

    /// The point of the plane near `x`; `None` if none was found.
    pub fn in_plane(&self, x: DVec2) -> Result<Option<Found<'a>>, MapError> {
        self.newton(x, self.try_at(x.into())?)
    }

    /// As [`Self::in_plane`]; `None` also if the measures seen from `x` differ by more than `most`.
    pub fn nearby(&self, x: DVec2, most: f64) -> Result<Option<Found<'a>>, MapError> {
        let first = self.try_at(x.into())?;
        if size(first.off) <= most { self.newton(x, first) } else { Ok(None) }
    }

    fn newton(&self, mut x: DVec2, mut best: Try<'a>) -> Result<Option<Found<'a>>, MapError> {
        let mut derivative = None;
        for _ in 0..STEPS {
            if size(best.off) <= ROUNDING {
                break;
            }
            let known: DMat2 = derivative.unwrap_or_else(|| best.view.derivative(self.marks));
            let step = -known.inverse().mul_vec2(best.off);
            let Some((next, found)) = self.improved(x, size(best.off), step)? else { break };
            // near the point the correction is better than a derivative anew, farther away it is not
            let is_near = size(found.off) <= NEAR * size(best.off);
            derivative = is_near.then(|| corrected(known, next - x, found.off - best.off));
            (x, best) = (next, found);
        }
        Ok(self.is_met(size(best.off), x.into()).then(|| (x.into(), best.view)))
    }

    /// The step, or a part of it, after which the difference is smaller than `before`.
    fn improved(&self, x: DVec2, before: f64, step: DVec2) -> Result<Option<(DVec2, Try<'a>)>, MapError> {
        let halvings = if before > NOISE { HALVINGS } else { 1 };
        let parts = (0..halvings).map(|k| x + step * 0.5f64.powi(k));
        for next in parts.filter(|&next| next != x && self.prepared.contains(next)) {
            let found = self.try_at(next.into())?;
            if size(found.off) < before {
                return Ok(Some((next, found)));
            }
        }
        Ok(None)
    }

    /// The point of the surface; `None` if none was found.
    pub fn on_surface(&self, arcs: &Arcs) -> Result<Option<Found<'a>>, MapError> {
        let mut asked = self.measures;
        let mut best: Option<(InteriorPoint, Try<'a>)> = None;
        for _ in 0..STEPS {
            let Some(x) = self.slices.place(|| arcs.point(self.prepared, asked)) else { break };
            let found = self.try_at(x)?;
            if best.as_ref().is_some_and(|(_, least)| size(found.off) >= size(least.off)) {
                break;
            }
            asked -= found.off;
            let is_exact = size(found.off) <= ROUNDING;
            best = Some((x, found));
            if is_exact {
                break;
            }
        }
        Ok(best.filter(|(x, found)| self.is_met(size(found.off), *x)).map(|(x, found)| (x, found.view)))
    }
}

/// A derivative that takes `step` to `change`, and differs from `known` in that direction only.
fn corrected(known: DMat2, step: DVec2, change: DVec2) -> DMat2 {
    let missing = (change - known.mul_vec2(step)) / step.length_squared();
    known + DMat2::from_cols(missing * step.x, missing * step.y)
}

fn size(off: DVec2) -> f64 {
    difference(off, DVec2::ZERO)
}
