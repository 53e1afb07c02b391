//! The density next to an interior point: what the polynomials of a panel cannot follow, in closed form.
//!
//! On a panel that is not short against its distance from x, the right side g of the equation has a peak. It is
//! replaced by its projection g̃ onto the panel's polynomials, whose moments are those of g: as the kernel is smooth from
//! panel to panel, the solution for g̃ has the right charges, and its density lacks g − g̃ only. The integral of g is an
//! angle: ∫ g dλ = Δ arg(z − x)/π, to rounding however near x is. Within a compressed block the kernel is not smooth;
//! there the last coefficients of g̃ tell how much is left open.

use super::layout::{End, Layout, Panel};
use super::leg::{Leg, kernel};
use super::legendre::{NODES, Rule, Values, polynomials, series};
use super::system::System;
use crate::geometry::{Curve, DVec2};
use std::f64::consts::FRAC_1_PI;
use std::sync::Arc;

/// Panels longer than this, in distances from x, have a peak. With 0.5, 16 terms leave 8.1⁻¹⁶ = 3e-15 of the density.
const LONG: f64 = 0.5;
/// Steps of Gauss and Newton's method to the parameter nearest to x; the place only has to be near it.
const STEPS: usize = 12;
/// The most intervals of the graded rule on each side of the peak: distances down to 2⁻⁶⁰ of the panel.
const MOST_INTERVALS: usize = 60;

/// The peak of one panel.
#[derive(Debug, Clone)]
pub struct Peak {
    leg: Leg,
    /// The leg's junction minus x.
    base: DVec2,
    from: f64,
    to: f64,
    /// The parameter next to x.
    nearest: f64,
    /// y − x at `from` and at `nearest`.
    seen: [DVec2; 2],
    /// ±1/π: the measure per angle.
    rate: f64,
    /// The projection of dω/dξ, ξ from −1 at `from` to 1 at `to`.
    projection: Values,
}

/// A peak at one parameter.
#[derive(Debug, Clone, Copy)]
pub struct PeakAt {
    t: f64,
    /// The distance from x.
    distance: f64,
    /// |dz/dt|.
    speed: f64,
    /// g − g̃ by the parameter.
    pub density: f64,
    /// ∫ (g − g̃) from the panel's first parameter.
    excess: f64,
}

/// The peaks of the panels near x, by panel.
pub type Peaks = Vec<Option<Arc<Peak>>>;

/// The peaks of all panels that are long against their distance from x.
pub fn peaks(curve: &Curve, layout: &Layout, system: &System, x: DVec2) -> Peaks {
    let places: Vec<DVec2> = system.places().collect();
    let distance = |nodes: &[DVec2]| nodes.iter().map(|place| place.distance(x)).fold(f64::INFINITY, f64::min);
    let panels = layout.panels.iter().zip(places.chunks(NODES)).zip(system.panel_lengths());
    let peak = |((panel, nodes), length): ((&Panel, &[DVec2]), f64)| {
        // nodes lie closer than a tenth of the panel to one another
        let is_near = length > LONG * (distance(nodes) - 0.1 * length);
        is_near.then(|| Arc::new(Peak::new(curve, panel, x)))
    };
    panels.map(peak).collect()
}

impl Peak {
    fn new(curve: &Curve, panel: &Panel, x: DVec2) -> Self {
        let is_incoming = panel.end == End::Finish;
        let leg = Leg::new(curve, panel.piece, is_incoming);
        let junction = if is_incoming { (panel.piece + 1) % curve.pieces().len() } else { panel.piece };
        let mut peak = Self {
            base: curve.pieces()[junction].jet(0.0).position - x,
            from: panel.from,
            to: panel.to,
            nearest: panel.from,
            seen: [DVec2::ZERO; 2],
            rate: if is_incoming { -FRAC_1_PI } else { FRAC_1_PI },
            projection: [0.0; NODES],
            leg,
        };
        peak.nearest = peak.nearest_parameter();
        peak.seen = [peak.from, peak.nearest].map(|t| peak.place(t));
        peak.projection = peak.projected();
        peak
    }

    /// y − x at a parameter.
    fn place(&self, t: f64) -> DVec2 {
        self.base + self.leg.node(t, 0.0).offset
    }

    fn nearest_parameter(&self) -> f64 {
        let at = |k: usize| self.from + (self.to - self.from) * 0.5 * (1.0 + Rule::get().nodes[k]);
        let nodes = (0..NODES).map(at);
        let mut t =
            nodes.min_by(|a, b| self.place(*a).length().total_cmp(&self.place(*b).length())).unwrap_or(self.from);
        for _ in 0..STEPS {
            let slope = self.leg.length * self.leg.outward(t);
            t = (t - self.place(t).dot(slope) / slope.length_squared()).clamp(self.from, self.to);
        }
        t
    }

    /// g dλ/dt: the density by the parameter.
    fn sharp(&self, t: f64) -> f64 {
        let node = self.leg.node(t, 0.0);
        self.leg.length * kernel(node.normal, self.base + node.offset)
    }

    fn xi(&self, t: f64) -> f64 {
        2.0 * (t - self.from) / (self.to - self.from) - 1.0
    }

    /// The Legendre coefficients of dω/dξ, by rules on intervals that double in length away from the peak.
    fn projected(&self) -> Values {
        let rule = Rule::get();
        let distance = self.place(self.nearest).length() / (self.leg.length * self.leg.outward(self.nearest).length());
        let mut coefficients = [0.0; NODES];
        for (sign, reach) in [(-1.0, self.nearest - self.from), (1.0, self.to - self.nearest)] {
            let (mut near, mut far) = (0.0, distance.max(reach * 0.5_f64.powi(MOST_INTERVALS as i32)));
            while near < reach {
                let half = 0.5 * (far.min(reach) - near);
                for (node, weight) in rule.nodes.iter().zip(rule.weights) {
                    let t = self.nearest + sign * (near + half * (1.0 + node));
                    let (p, mass) = (polynomials(self.xi(t)), half * weight * self.sharp(t));
                    for (k, coefficient) in coefficients.iter_mut().enumerate() {
                        *coefficient += 0.5 * (2 * k + 1) as f64 * mass * p[k];
                    }
                }
                (near, far) = (far.min(reach), 2.0 * far);
            }
        }
        coefficients
    }

    /// The projection g̃ at the panel's nodes.
    pub fn right_side(&self) -> Values {
        let half = 0.5 * (self.to - self.from) * self.leg.length;
        Rule::get().nodes.map(|node| series(&self.projection, node).0 / half)
    }

    /// The projection of dω/dξ.
    pub fn projection(&self) -> &Values {
        &self.projection
    }

    /// What the peak has at a parameter.
    pub fn at(&self, t: f64) -> PeakAt {
        let node = self.leg.node(t, 0.0);
        let place = self.base + node.offset;
        let [start, middle] = self.seen;
        // the panel bends by less than π/2 on either side of the peak
        let seen = if t <= self.nearest { angle(start, place) } else { angle(start, middle) + angle(middle, place) };
        let (projected, integral) = series(&self.projection, self.xi(t));
        let sharp = self.leg.length * kernel(node.normal, place);
        PeakAt {
            t,
            distance: place.length(),
            speed: self.leg.length * node.normal.length(),
            density: sharp - projected * 2.0 / (self.to - self.from),
            excess: self.rate * seen - integral,
        }
    }

    /// ∫ (g − g̃) from one parameter to a larger one; in proportion to itself where they are near to each other.
    pub fn between(&self, from: &PeakAt, to: &PeakAt) -> f64 {
        let half = 0.5 * (to.t - from.t);
        if 4.0 * half * from.speed > from.distance {
            return to.excess - from.excess;
        }
        let rule = Rule::get();
        rule.nodes.iter().zip(rule.weights).map(|(x, w)| half * w * self.at(from.t + half * (1.0 + x)).density).sum()
    }
}

/// The angle from one direction to another; an arccosine would be off by 1e-8 near 0.
fn angle(a: DVec2, b: DVec2) -> f64 {
    a.perp_dot(b).atan2(a.dot(b))
}
