//! One panel of the boundary: its nodes, its polynomial, and integrals over it seen from nearby.
//!
//! From a distance, 16 nodes integrate a density times the kernel. From a point y next to the panel, the kernel is
//! no polynomial any more, and the integral is taken exactly for the polynomial through the density (product
//! integration): with z(ξ) the panel and ξ₀ the root of z(ξ₀) = y,
//!
//! ∫ σ(ξ) Re(n/(y − z(ξ))) dξ = Re(n ∫ σ(ξ) h(ξ)/(ξ₀ − ξ) dξ),  h(ξ) = (ξ₀ − ξ)/(y − z(ξ)),
//!
//! where h is smooth and ∫ Pₖ(ξ)/(ξ₀ − ξ) dξ = 2 Qₖ(ξ₀). Straight panels: Helsing and Ojala, J. Comput. Phys. 227 (2008)
//! 2899; the root of curved ones: af Klinteberg and Barnett, BIT 61 (2021) 83 ("singularity swap").

use super::layout::{End, Panel};
use super::leg::{Leg, Node};
use super::legendre::{NODES, Rule, Values, bernstein, complex_polynomials, second_kind};
use crate::geometry::{Curve, DVec2, gauss_legendre};
use num_complex::Complex64;
use std::f64::consts::FRAC_1_PI;
use std::sync::OnceLock;

/// A panel is near a point inside of its Bernstein ellipse of this parameter. Outside of it the panel's rule integrates
/// polynomials times the kernel with errors of 3⁻³² = 5e-16.
const NEAR: f64 = 3.0;
/// No point of that ellipse is further from the panel's middle, in half lengths; for a curved panel a little more.
const REACH: f64 = 1.9;
/// Steps of Newton's method to the root; 4 to 6 are taken.
const MOST_STEPS: u32 = 30;

/// dz/dξ of a panel, ξ from −1 to 1 in the order of its nodes.
#[derive(Debug, Clone)]
pub enum Slope {
    /// A straight panel's.
    Straight(Complex64),
    /// The Legendre coefficients of a curved panel's.
    Curved(Box<[Complex64; NODES]>),
}

fn complex(p: DVec2) -> Complex64 {
    Complex64::new(p.x, p.y)
}

/// A rule that is exact for dz/dξ, a polynomial of degree 15.
fn half_rule() -> &'static [(f64, f64)] {
    static RULE: OnceLock<Vec<(f64, f64)>> = OnceLock::new();
    RULE.get_or_init(|| gauss_legendre(NODES / 2))
}

impl Slope {
    /// The slope of the parameters [from, to] of a leg, outwards.
    pub fn new(leg: &Leg, [from, to]: [f64; 2]) -> Self {
        let half = 0.5 * (to - from) * leg.length;
        if leg.is_straight() {
            return Self::Straight(complex(half * leg.outward(from)));
        }
        let rule = Rule::get();
        let slopes = rule.nodes.map(|x| half * leg.outward(from + 0.5 * (to - from) * (1.0 + x)));
        let [x, y] = [0, 1].map(|i| rule.coefficients(&std::array::from_fn(|k| slopes[k][i])));
        Self::Curved(Box::new(std::array::from_fn(|k| Complex64::new(x[k], y[k]))))
    }

    fn at(&self, xi: Complex64) -> Complex64 {
        match self {
            Self::Straight(slope) => *slope,
            Self::Curved(coefficients) => {
                let p = complex_polynomials(xi);
                coefficients.iter().zip(p).map(|(c, p)| c * p).sum()
            }
        }
    }

    /// Half of the panel's length, up to its curvature.
    fn half_length(&self) -> f64 {
        match self {
            Self::Straight(slope) => slope.norm(),
            Self::Curved(coefficients) => coefficients[0].norm(),
        }
    }

    /// δ with z(ξ + δ) − z(ξ) = `difference`, in proportion to itself; `None` if Newton's method does not find it.
    fn root(&self, xi: f64, difference: Complex64) -> Option<Complex64> {
        let mut delta = difference / self.at(xi.into());
        if matches!(self, Self::Straight(_)) {
            return Some(delta);
        }
        for _ in 0..MOST_STEPS {
            let mean: Complex64 =
                half_rule().iter().map(|(x, w)| 0.5 * w * self.at(xi + 0.5 * (1.0 + x) * delta)).sum();
            let step = (delta * mean - difference) / self.at(xi + delta);
            delta -= step;
            if step.norm() <= 4.0 * f64::EPSILON * delta.norm() {
                return Some(delta);
            }
            if delta.norm().is_nan() || delta.norm() >= 2.0 * NEAR {
                return None;
            }
        }
        None
    }

    /// The distance from the panel's middle up to which points may be near the panel.
    pub fn reach(&self) -> f64 {
        REACH * self.half_length()
    }

    /// Whether a point may be near the panel, given its difference from the panel's middle.
    pub fn may_be_near(&self, from_middle: DVec2) -> bool {
        from_middle.length() <= self.reach()
    }

    /// Where a point near the panel lies, given its differences from all nodes; `None` if it is not near.
    fn seen(&self, differences: &[DVec2; NODES]) -> Option<Seen> {
        let nodes = &Rule::get().nodes;
        let distance = |j: &usize| differences[*j].length_squared();
        let nearest = (0..NODES).min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        let delta = self.root(nodes[nearest], complex(differences[nearest]))?;
        let xi = nodes[nearest] + delta;
        let from_nodes = nodes.map(|node| delta + (nodes[nearest] - node));
        (bernstein(xi) < NEAR).then_some(Seen { xi, from_nodes })
    }

    /// The weights that take a density's values at the nodes to ∫ k(y, s) σ(s) dλ for the target y with this normal
    /// (times |dz/dλ|), given the differences y − s from all nodes, and dλ/dξ; `None` if y is not near the panel, whose
    /// own rule is then exact to rounding.
    pub fn close_weights(&self, normal: DVec2, differences: &[DVec2; NODES], rate: f64) -> Option<Values> {
        let Seen { xi, from_nodes } = self.seen(differences)?;
        let q = second_kind(xi);
        let normal = FRAC_1_PI * rate * complex(normal);
        Some(std::array::from_fn(|j| {
            let moment: Complex64 = q.iter().zip(Rule::get().to_series()).map(|(q, row)| row[j] * q).sum();
            (normal * (from_nodes[j] / complex(differences[j])) * moment).re
        }))
    }
}

/// Where a point lies near a panel.
struct Seen {
    /// The root ξ₀ of z(ξ₀) = y.
    xi: Complex64,
    /// ξ₀ minus the nodes.
    from_nodes: [Complex64; NODES],
}

/// The nodes of one panel, in the order of its parameter.
#[derive(Debug, Clone)]
pub struct PanelNodes {
    /// The junction that offsets are relative to.
    pub junction: usize,
    /// The nodes.
    pub nodes: [Node; NODES],
    /// The nodes relative to the panel's first and last point in the direction of the curve.
    pub ends: [[DVec2; NODES]; 2],
    /// dz/dξ.
    pub slope: Slope,
    /// The middle, relative to the junction.
    pub middle: DVec2,
    /// dλ/dξ.
    pub rate: f64,
}

impl PanelNodes {
    /// The nodes of a panel of a curve.
    pub fn new(curve: &Curve, panel: &Panel) -> Self {
        let rule = Rule::get();
        let is_incoming = panel.end == End::Finish;
        let leg = Leg::new(curve, panel.piece, is_incoming);
        let half = 0.5 * (panel.to - panel.from);
        let at = |k: usize| panel.from + half * (1.0 + rule.nodes[k]);
        let slopes: [DVec2; NODES] = std::array::from_fn(|k| half * leg.length * leg.outward(at(k)));
        let [x, y] = [0, 1].map(|i| rule.integrals(&std::array::from_fn(|k| slopes[k][i])));
        let whole: DVec2 = slopes.iter().zip(rule.weights).map(|(d, w)| w * *d).sum();
        let near: [DVec2; NODES] = std::array::from_fn(|k| DVec2::new(x[k], y[k]));
        let far = near.map(|offset| offset - whole);
        Self {
            junction: if is_incoming { (panel.piece + 1) % curve.pieces().len() } else { panel.piece },
            nodes: std::array::from_fn(|k| leg.node(at(k), half * rule.weights[k])),
            ends: if is_incoming { [far, near] } else { [near, far] },
            slope: Slope::new(&leg, [panel.from, panel.to]),
            middle: leg.node(0.5 * (panel.from + panel.to), 0.0).offset,
            rate: half * leg.length,
        }
    }

    /// The largest distance of a node from the middle.
    pub fn reach(&self) -> f64 {
        self.nodes.iter().map(|node| node.offset.distance(self.middle)).fold(0.0, f64::max)
    }

    /// The panel's length.
    pub fn length(&self) -> f64 {
        self.nodes.iter().map(|node| node.weight * node.normal.length()).sum()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::Piece;

    /// z(ξ) − z(η) from η and ξ − η, without cancellation.
    fn chord(piece: &Piece, eta: f64, difference: f64) -> DVec2 {
        match *piece {
            Piece::Arc { axes: [a, b], from, to, .. } => {
                let half = 0.25 * (to - from) * difference;
                let (sin, cos) = (from + 0.5 * (to - from) * (1.0 + eta) + half).sin_cos();
                2.0 * half.sin() * (b * cos - a * sin)
            }
            _ => 0.5 * difference * piece.jet(0.5).first,
        }
    }

    /// ∫ P(ξ) Re(n/(y − z)) dξ by a rule that is graded towards the point `next` of the panel, whose difference from y is
    /// `offset`.
    fn graded(piece: &Piece, density: impl Fn(f64) -> f64, normal: Complex64, next: f64, offset: DVec2) -> f64 {
        let value = |difference: f64| {
            let away = complex(offset - chord(piece, next, difference));
            density(next + difference) * (normal / away).re
        };
        let rule = gauss_legendre(NODES);
        let mut sum = 0.0;
        for (end, sign) in [(next + 1.0, -1.0), (1.0 - next, 1.0)] {
            for k in 0..60 {
                let [far, near] = [k, k + 1].map(|k| if k == 60 { 0.0 } else { end * 0.5_f64.powi(k) });
                let half = 0.5 * (far - near);
                sum += rule.iter().map(|(x, w)| half * w * value(sign * (near + half * (1.0 + x)))).sum::<f64>();
            }
        }
        sum
    }

    #[test]
    fn near_panels_are_integrated_exactly_straight_and_curved() {
        let rule = Rule::get();
        let pieces = [
            Piece::Line([DVec2::new(0.1, 0.2), DVec2::new(1.3, 0.7)]),
            Piece::circular(DVec2::new(0.3, -0.2), 1.1, 0.2, 1.0),
        ];
        let density = |xi: f64| 1.0 + 0.3 * xi - 0.7 * xi * xi + xi.powi(7);
        for piece in pieces {
            let curve_leg = Leg::alone(piece.clone());
            let slope = Slope::new(&curve_leg, [0.0, 1.0]);
            let places = rule.nodes.map(|xi| piece.jet(0.5 * (1.0 + xi)).position);
            for (next, height) in [(0.2, 0.3), (0.13, 1e-2), (-0.71, -1e-4), (0.999, 1e-6), (0.5, -1e-9)] {
                let jet = piece.jet(0.5 * (1.0 + next));
                let offset = height * jet.first.perp();
                let y = jet.position + offset;
                let normal = DVec2::new(0.6, 0.8);
                let weights = slope.close_weights(normal, &places.map(|z| y - z), 1.0).unwrap();
                let found: f64 = weights.iter().zip(rule.nodes).map(|(w, xi)| w * density(xi)).sum();
                let expected = FRAC_1_PI * graded(&piece, density, complex(normal), next, offset);
                // rounding of y, 1e-16, moves the result by the logarithm's slope at the panel's end only
                let off = (found - expected).abs();
                assert!(off < 2e-13 * (1.0 - height.abs().ln()), "{next}, {height}: off by {off:e} of {expected}");
            }
            let far = piece.jet(0.5).position + DVec2::new(4.0, -3.0);
            assert!(slope.close_weights(DVec2::X, &places.map(|z| far - z), 1.0).is_none());
        }
    }
}
