//! Where a point lies: inside of the curve, on it, or outside.

use super::panel::{End, Panel};
use super::{CauchyIntegral, complex};
use crate::geometry::{CurvePoint, DVec2};

/// Where a point lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Placement {
    /// Inside of the curve.
    Inside,
    /// On the curve, within rounding, at this point.
    Boundary(CurvePoint),
    /// Outside of the curve, or not finite.
    Outside,
}

/// Distances from the curve, in perimeters, up to which a point lies on it: a point of the curve written and read with
/// 15 digits does.
const ON_CURVE: f64 = 1e-14;
/// Steps of Newton's method for the nearest point of a panel; from the projection on its chord, 3 suffice.
const STEPS: usize = 6;
/// Panels of this length, in perimeters, and shorter ones lie next to singular points.
const SINGULAR: f64 = 1e-9;
/// A part of a panel's own height by which a point next to it may be farther from its chord.
const MARGIN: f64 = 1.1;

impl CauchyIntegral {
    /// Where a point lies.
    pub fn placement(&self, z: DVec2) -> Placement {
        if !z.is_finite() {
            return Placement::Outside;
        }
        let tolerance = ON_CURVE * self.curve.perimeter() + 2.0 * f64::EPSILON * z.length();
        let on = self.panels.iter().find_map(|panel| {
            let (local, half) = (panel.local(z), panel.half_chord().norm());
            let (slack, height) = (tolerance / half, MARGIN * panel.height);
            let is_beside = local.re.abs() <= 1.0 + height + slack && local.im.abs() <= height + slack;
            let (point, distance) = is_beside.then(|| self.nearest(panel, z, local.re))?;
            (distance <= tolerance).then_some(point)
        });
        match on {
            Some(point) => Placement::Boundary(point),
            None if self.curve.contains(z) => Placement::Inside,
            None => Placement::Outside,
        }
    }

    /// The point of a panel nearest to z, from a guess of its parameter in [−1, 1], and its distance.
    fn nearest(&self, panel: &Panel, z: DVec2, guess: f64) -> (CurvePoint, f64) {
        let (relative, stretch) = (complex(z - panel.base), &panel.stretch);
        // dx in terms of the piece's parameter
        let rate = 2.0 / (stretch.to - stretch.from);
        let mut x = guess.clamp(-1.0, 1.0);
        for _ in 0..STEPS {
            let place = stretch.place(&self.curve, x);
            let step = (relative - place.offset) / place.along;
            x = (x + rate * step.re).clamp(-1.0, 1.0);
        }
        let place = stretch.place(&self.curve, x);
        (place.point, (relative - place.offset).norm())
    }

    /// f′ at a point of the curve, from inside; `None` next to a corner and to other points where f may have no
    /// derivative, within `SINGULAR` perimeters.
    pub fn boundary_derivative(&self, at: CurvePoint) -> Option<DVec2> {
        let panel = self.panels.iter().find(|panel| panel.holds(at))?;
        let half = panel.half_chord();
        let slope = panel.polynomial(panel.local(self.curve.position(at)))[1] / half;
        (half.norm() > SINGULAR * self.curve.perimeter()).then(|| super::point(slope))
    }
}

impl Panel {
    fn holds(&self, at: CurvePoint) -> bool {
        let parameter = if self.stretch.end == End::Start { at.from_start() } else { at.to_end() };
        at.piece() == self.stretch.piece && (self.stretch.from..=self.stretch.to).contains(&parameter)
    }
}
