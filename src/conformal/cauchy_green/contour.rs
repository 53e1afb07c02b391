//! Cauchy's integral over the edges of a polygon: the logarithms behind γ_k(z), equation (15).
//!
//! With a = v_k − z, b = v_{k+1} − z and d = b − a, edge k gives to the integral of a
//! function that is linear on it (w_k → w_{k+1}) the amount P w_k + Q w_{k+1} with
//!
//! ```text
//! P = b L/d − 1,   Q = 1 − a L/d,   L = log(b/a), principal value.
//! ```
//!
//! In q = d/(a + b) both follow from one number E: L = 2 artanh q = 2q (1 + E), P = L/2 + E,
//! Q = L/2 − E, E = q²/3 + q⁴/5 + …. Seen from afar q is small and the series has no
//! cancellation, no logarithm and no branch. Near by, L comes from a logarithm and an angle
//! whose sign is decided exactly, so that a point 1e-16 beside an edge is on its right side.
//!
//! On the boundary the values are the limits from inside, see [`Contour::near`].

use crate::geometry::{DVec2, orientation};
use std::f64::consts::TAU;

/// Edges are processed in blocks that fit into registers and the first-level cache.
pub(super) const BLOCK: usize = 64;

/// Up to this |q|² (an edge seen from four times its length) [`SERIES`] terms of E are enough:
/// E is off by q¹⁸/19, which is below 2⁻⁵⁵ |L| there, and so is L.
const FAR: f64 = 1.0 / 64.0;
const SERIES: usize = 8;

/// Up to this |q|² (23 times its length) four terms are enough: E is off by q¹⁰/11 < 2⁻⁵³ |L|.
const VERY_FAR: f64 = 1.0 / 2048.0;
const SHORT_SERIES: usize = 4;

/// L and E of a block of edges, with separate real and imaginary parts.
#[derive(Debug, Clone)]
pub(super) struct Logs {
    pub(super) log: [[f64; BLOCK]; 2],
    pub(super) rest: [[f64; BLOCK]; 2],
    /// |q|².
    nearness: [f64; BLOCK],
}

impl Logs {
    pub(super) fn new() -> Self {
        Self { log: [[0.0; BLOCK]; 2], rest: [[0.0; BLOCK]; 2], nearness: [0.0; BLOCK] }
    }

    /// With q in `log`: writes E into `rest` and L into `log`.
    fn expand<const TERMS: usize>(&mut self) {
        let ([x, y], [u, v]) = (&mut self.log, &mut self.rest);
        for k in 0..BLOCK {
            let (re, im) = (x[k] * x[k] - y[k] * y[k], 2.0 * x[k] * y[k]);
            let (mut p, mut q) = (1.0 / (2 * TERMS + 1) as f64, 0.0);
            for j in (1..TERMS).rev() {
                (p, q) = (p * re - q * im + 1.0 / (2 * j + 1) as f64, p * im + q * re);
            }
            (p, q) = (p * re - q * im, p * im + q * re);
            (u[k], v[k]) = (p, q);
            (x[k], y[k]) = (2.0 * (x[k] + x[k] * p - y[k] * q), 2.0 * (y[k] + x[k] * q + y[k] * p));
        }
    }
}

/// A closed polygon, counter-clockwise, over whose edges Cauchy's integral is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Contour {
    /// v_0 … v_{m−1}, v_0, by coordinate.
    points: [Vec<f64>; 2],
    /// |v_{k+1} − v_k|².
    squared_lengths: Vec<f64>,
}

impl Contour {
    /// The polygon with these vertices: simple, counter-clockwise, no two neighbours equal.
    pub fn new(polygon: &[DVec2]) -> Self {
        let closed = || polygon.iter().chain(polygon.first());
        let points = [closed().map(|p| p.x).collect(), closed().map(|p| p.y).collect()];
        let squared_lengths = closed().zip(polygon.iter().skip(1).chain(polygon.first()));
        let squared_lengths = squared_lengths.map(|(v, w)| v.distance_squared(*w)).collect();
        Self { points, squared_lengths }
    }

    /// The number of vertices, m.
    pub fn len(&self) -> usize {
        self.squared_lengths.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.squared_lengths.is_empty()
    }

    /// Writes the Cauchy–Green coordinates γ_k(z) into `gamma` (length m; x + iy), equation (15).
    ///
    /// Σγ_k = 1 and Σγ_k v_k = z up to rounding for z inside, however near to the boundary;
    /// on the boundary they are the limits from inside. Outside, both sums are 0. Cost O(m).
    pub fn coordinates(&self, z: DVec2, gamma: &mut Vec<DVec2>) {
        let m = self.len();
        gamma.clear();
        gamma.resize(m, DVec2::ZERO);
        self.for_blocks(z, |first, logs, count| {
            for k in 0..count {
                let half = 0.5 * DVec2::new(logs.log[0][k], logs.log[1][k]);
                let rest = DVec2::new(logs.rest[0][k], logs.rest[1][k]);
                gamma[first + k] += half + rest;
                gamma[(first + k + 1) % m] += half - rest;
            }
        });
        for value in gamma {
            *value = over_two_pi_i(*value);
        }
    }

    /// Calls `take(first, logs, count)` with L and E of the edges `first … first + count − 1`, in order.
    pub(super) fn for_blocks(&self, z: DVec2, mut take: impl FnMut(usize, &Logs, usize)) {
        let mut logs = Logs::new();
        for first in (0..self.len()).step_by(BLOCK) {
            let count = BLOCK.min(self.len() - first);
            self.block(z, first, count, &mut logs);
            take(first, &logs, count);
        }
    }

    /// L and E of a block; entries after its first `count` edges are meaningless.
    fn block(&self, z: DVec2, first: usize, count: usize, logs: &mut Logs) {
        let (x, y) = (&self.points[0][first..=first + count], &self.points[1][first..=first + count]);
        let squares = &self.squared_lengths[first..first + count];
        let (mut far, mut very_far) = (true, true);
        for k in 0..count {
            // differences first: no cancellation where z is near
            let (ax, ay, bx, by) = (x[k] - z.x, y[k] - z.y, x[k + 1] - z.x, y[k + 1] - z.y);
            let (sx, sy, dx, dy) = (ax + bx, ay + by, x[k + 1] - x[k], y[k + 1] - y[k]);
            let inverse = 1.0 / (sx * sx + sy * sy);
            logs.log[0][k] = (dx * sx + dy * sy) * inverse;
            logs.log[1][k] = (dy * sx - dx * sy) * inverse;
            let nearness = squares[k] * inverse;
            logs.nearness[k] = nearness;
            far &= nearness <= FAR;
            very_far &= nearness <= VERY_FAR;
        }
        if very_far {
            return logs.expand::<SHORT_SERIES>();
        }
        logs.expand::<SERIES>();
        if !far {
            for k in 0..count {
                if logs.nearness[k] > FAR {
                    let (log, rest) = self.near(z, first + k);
                    (logs.log[0][k], logs.log[1][k], logs.rest[0][k], logs.rest[1][k]) = (log.x, log.y, rest.x, rest.y);
                }
            }
        }
    }

    fn point(&self, k: usize) -> DVec2 {
        DVec2::new(self.points[0][k], self.points[1][k])
    }

    /// L and E of edge `k` seen from nearby.
    ///
    /// On the inner side of the edge the angle tends to +π. At a vertex, a → 0 on the edge that starts
    /// there and b → 0 on the one that ends there: a log a → 0, so Q = 1 on the former and
    /// P = −1 on the latter, while the logarithms of the small number cancel in P + Q' = L + L'
    /// = log |d|/|d'| + i(2π − α), α the interior angle: all angles together are 2π, and the
    /// other edges are seen under α. The edge that starts there takes the angle.
    fn near(&self, z: DVec2, k: usize) -> (DVec2, DVec2) {
        let (from, to) = (self.point(k), self.point(k + 1));
        let (a, b) = (from - z, to - z);
        if a == DVec2::ZERO {
            let log = DVec2::new(b.length().ln(), TAU - self.interior_angle(k));
            return (log, 0.5 * log - DVec2::X);
        }
        if b == DVec2::ZERO {
            let log = DVec2::new(-a.length().ln(), 0.0);
            return (log, -0.5 * log - DVec2::X);
        }
        let cross = orientation(from, to, z) + 0.0; // −0 would turn π into −π
        let log = DVec2::new(0.5 * (b.length_squared() / a.length_squared()).ln(), cross.atan2(a.dot(b)));
        let (sum, edge) = (a + b, to - from);
        let half = 0.5 / edge.length_squared();
        let ratio = DVec2::new(sum.dot(edge) * half, edge.perp_dot(sum) * half);
        (log, times(log, ratio) - DVec2::X)
    }

    /// The interior angle at vertex `k`, between 0 and 2π.
    fn interior_angle(&self, k: usize) -> f64 {
        let before = self.point(if k == 0 { self.len() - 1 } else { k - 1 });
        let (vertex, after) = (self.point(k), self.point(k + 1));
        let angle = orientation(before, vertex, after).atan2((after - vertex).dot(before - vertex));
        if angle < 0.0 { angle + TAU } else { angle }
    }
}

/// The product of two complex numbers.
pub(super) fn times(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

/// z/(2πi).
pub(super) fn over_two_pi_i(z: DVec2) -> DVec2 {
    DVec2::new(z.y, -z.x) / TAU
}
