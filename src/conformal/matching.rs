//! Matching two harmonic measures along two boundaries (section 3.2, algorithm C.4).
//!
//! For every vertex k of the mapped boundary, the point of the other boundary
//! with the same harmonic measure. One pass, O(m + m'). The correspondence keeps
//! the cyclic order (weakly: where ω is flat in f64, points coincide). With far anchors another pass for each, and the
//! order up to the errors of the measures where their parts end.

use super::curved::{CurveMeasure, match_sharply, nearer};
use super::far_anchors::FarAnchor;
use super::subdivision::Cuts;
use super::{HarmonicMeasure, PerSide, Side};
use crate::geometry::{CurvePoint, DVec2};
use crate::outline::{BoundaryPoint, BoundarySamples};

/// The images of the mapped side's boundary vertices on the other boundary, in weakly cyclic order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BoundaryCorrespondence {
    points: Vec<BoundaryPoint>,
    /// The images on the other side's curve, and their positions, if its measure is from the boundary integral.
    exact: Vec<(CurvePoint, DVec2)>,
}

impl BoundaryCorrespondence {
    /// The images of the vertices `0 … m−1` of the mapped boundary.
    pub fn points(&self) -> &[BoundaryPoint] {
        &self.points
    }

    /// Sets the images, on the polygon of the other side's samples.
    pub(super) fn set(&mut self, points: Vec<BoundaryPoint>) {
        self.points = points;
        self.exact.clear();
    }

    /// The images `w_k` of the boundary vertices, equation (13): on the other side's curve, or on its samples' polygon.
    pub fn images<'a>(&'a self, samples: &'a BoundarySamples) -> impl Iterator<Item = DVec2> + 'a {
        let position = |(k, &point): (usize, _)| match self.exact.get(k) {
            Some(&(_, position)) => position,
            None => samples.position(point),
        };
        self.points.iter().enumerate().map(position)
    }

    /// The image of boundary vertex `k` on the other side's curve, with its position; `None` if the other side's
    /// measure is not from the boundary integral.
    pub fn on_curve(&self, k: usize) -> Option<(CurvePoint, DVec2)> {
        self.exact.get(k).copied()
    }

    /// Starts a correspondence of `m` vertices with images on a curve.
    pub(super) fn begin_exact(&mut self, m: usize, anchor: BoundaryPoint, on_curve: CurvePoint) {
        self.points.clear();
        self.points.resize(m, anchor);
        self.exact.clear();
        self.exact.resize(m, (on_curve, DVec2::ZERO));
    }

    /// Matches anew where both boundaries are far from both points. Targets by finite elements, whose measure is known
    /// in one direction only, are left as they are.
    pub(super) fn match_far(&mut self, far: &[FarAnchor], mapped: Side) {
        let mut nearest = vec![f64::INFINITY; if far.is_empty() { 0 } else { self.points.len() }];
        for FarAnchor { measures, limit } in far {
            let (source, target) = (&measures[mapped], &measures[mapped.other()]);
            let Some(target) = CurveMeasure::new(target) else { continue };
            let mut matched = Self::default();
            match_sharply(source, &target, &mut matched);
            for knot in 1..=source.vertex_count() {
                let (k, omega) = (source.vertex_at(knot), nearer(source, knot).0);
                if omega < limit.min(nearest[k]) {
                    nearest[k] = omega;
                    (self.points[k], self.exact[k]) = (matched.points[k], matched.exact[k]);
                }
            }
        }
    }

    /// The images of the `m` vertices of the mapped side's own mesh, on that of the other one.
    pub(super) fn at_own_vertices(&self, m: usize, cuts: PerSide<Cuts>, mapped: Side) -> Self {
        let (here, there) = (cuts[mapped], cuts[mapped.other()]);
        let vertices = || (0..m).map(|k| here.vertex(k, m));
        Self {
            points: vertices().map(|v| there.coarser_on_boundary(self.points[v])).collect(),
            exact: vertices().filter_map(|v| self.on_curve(v)).collect(),
        }
    }

    /// Sets the image of vertex `k`.
    pub(super) fn set_exact(&mut self, k: usize, point: BoundaryPoint, on_curve: CurvePoint, position: DVec2) {
        self.points[k] = point;
        self.exact[k] = (on_curve, position);
    }
}

/// Matches `source` to `target` into `result`; both run from 0 to 1. If the target's measure is from the boundary
/// integral, images lie on its curve.
pub fn match_measures(source: &HarmonicMeasure, target: &HarmonicMeasure, result: &mut BoundaryCorrespondence) {
    if let Some(target) = CurveMeasure::new(target) {
        return match_sharply(source, &target, result);
    }
    let m = source.vertex_count();
    result.exact.clear();
    let (a, b, density) = (source.at_knots(), target.at_knots(), target.density());
    let last = target.vertex_count();
    result.points.clear();
    result.points.resize(m, target.point(0, 0.0));
    let mut l = 0;
    for (j, &omega) in a.iter().enumerate().take(m + 1).skip(1) {
        while l < last && omega >= b[l + 1] {
            l += 1;
        }
        let vertex = source.vertex_at(j);
        let lambda = inverse_quadratic(omega - b[l], b[l + 1] - b[l], density[l], density[l + 1]);
        // the anchor's own vertex is at knot m; its image is the other anchor
        let at_anchor = j == m && source.at_vertex(vertex) == 0.0 && omega == 1.0;
        result.points[vertex] = if at_anchor { target.point(0, 0.0) } else { target.point(l, lambda) };
    }
}

/// The λ in [0, 1] at which the integral of a density running linearly from `p` to `q`
/// over an interval of measure `step` reaches `rest`.
///
/// With μ = rest/step, s = p + q, Δ = q − p, the equation p λ + Δ λ²/2 = μ s/2 has
/// the root λ = μ s / (p + √(p² + μ Δ s)), a form without cancellation. A flat
/// interval (step = 0) gives 0.
pub(super) fn inverse_quadratic(rest: f64, step: f64, p: f64, q: f64) -> f64 {
    if rest <= 0.0 || step <= 0.0 {
        return 0.0;
    }
    let mu = (rest / step).min(1.0);
    let scale = p.max(q); // ψ may be 1e-300: its square must not underflow
    if scale <= 0.0 {
        return 0.0;
    }
    let (p, q) = (p / scale, q / scale);
    let area = mu * (p + q);
    let root = (p * p + area * (q - p)).max(0.0).sqrt();
    if area == 0.0 { 0.0 } else { (area / (p + root)).clamp(0.0, 1.0) }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    /// The inverse function: the share of the measure before λ.
    fn share(lambda: f64, p: f64, q: f64) -> f64 {
        (2.0 * p * lambda + (q - p) * lambda * lambda) / (p + q)
    }

    #[test]
    fn inverse_quadratic_inverts_the_measure_of_an_interval() {
        let densities = [0.0, 1e-300, 1e-30, 1e-8, 0.5, 1.0 - 1e-15, 1.0, 1.0 + 1e-15, 3.0, 1e10];
        for &p in &densities {
            for &q in &densities {
                if p + q == 0.0 {
                    continue;
                }
                for mu in [0.0, 1e-12, 0.1, 0.5, 0.9, 1.0] {
                    let lambda = inverse_quadratic(mu, 1.0, p, q);
                    let error = (share(lambda, p / (p + q), q / (p + q)) - mu).abs();
                    assert!(error <= 4e-16, "p = {p:e}, q = {q:e}, μ = {mu}: λ = {lambda}, error {error:e}");
                }
            }
        }
    }

    #[test]
    fn flat_interval_maps_to_its_start() {
        assert_eq!(inverse_quadratic(0.3, 0.0, 0.0, 0.0), 0.0);
        assert_eq!(inverse_quadratic(0.3, 1.0, 0.0, 0.0), 0.0);
    }
}
