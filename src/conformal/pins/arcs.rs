//! The harmonic measures of two arcs as discrete harmonic functions on the mesh: one solve for all points at once.
//!
//! u = (u₁, u₂) maps the mesh into the triangle u₁, u₂ ≥ 0, u₁ + u₂ ≤ 1 (the third arc has the rest), one to one where the
//! functions are exact. Here they have the errors of finite elements: they begin what [`super::newton`] ends. The
//! boundary values are the shares of the arcs in the piecewise linear functions of the vertices, so that u is the measure
//! by the linear interpolation of the discrete Poisson kernel.

use super::difference;
use super::slices::{INTERRUPTED, Slices};
use crate::conformal::{InteriorPoint, Places, PreparedSide};
use crate::geometry::DVec2;
use crate::laplace::NotConverged;
use crate::mesh::{BarycentricPoint, TriangleId};
use std::sync::Arc;

/// The measures (u₁, u₂) of the first two arcs at every vertex.
pub struct Arcs {
    values: Arc<Vec<DVec2>>,
}

impl Arcs {
    /// The arcs from each of three fractions of the boundary, which ascend counter-clockwise, to the next; a step of
    /// `slices`.
    pub fn new(side: &PreparedSide, marks: [f64; 3], slices: &Slices) -> Result<Self, NotConverged> {
        let fractions = side.fractions();
        let m = fractions.len();
        let values = (0..m).map(|k| {
            let at = fractions[k];
            let before = (at - fractions[(k + m - 1) % m]).rem_euclid(1.0);
            let after = (fractions[(k + 1) % m] - at).rem_euclid(1.0);
            let share = |arc: usize| hat_within([before, after], [marks[arc] - at, marks[arc + 1] - at]);
            DVec2::new(share(0), share(1))
        });
        slices.functions(side, values).unwrap_or(Err(INTERRUPTED)).map(|values| Self { values })
    }

    /// The point at which the interpolated functions have these values; where rounding or finite elements leave none,
    /// the nearest interior vertex.
    pub fn point(&self, side: &PreparedSide, wanted: DVec2) -> Option<InteriorPoint> {
        let triangles = side.triangles();
        let weights = |corners: [u32; 3]| weights_of(corners.map(|v| self.values[v as usize]), wanted);
        let found = triangles.iter().enumerate().find_map(|(k, &corners)| Some((k, weights(corners)?)));
        let on_boundary = |corners: [u32; 3], weights: [f64; 3]| {
            (0..3).all(|i| weights[i] == 0.0 || (corners[i] as usize) < side.boundary_count())
        };
        let found = found.filter(|&(k, weights)| !on_boundary(triangles[k], weights));
        let Some((k, weights)) = found else { return self.nearest(side, wanted) };
        Some(match side.vertices() {
            Places::Plane(places) => {
                (0..3).map(|i| weights[i] * places[triangles[k][i] as usize]).sum::<DVec2>().into()
            }
            Places::Space(_) => BarycentricPoint::new(TriangleId::new(k as u32), weights).into(),
        })
    }

    /// The interior vertex that sees the first two arcs most nearly under these measures; `None` of a mesh without one.
    pub fn nearest(&self, side: &PreparedSide, wanted: DVec2) -> Option<InteriorPoint> {
        let inside = side.boundary_count()..self.values.len();
        let off = |&v: &usize| difference(self.values[v], wanted);
        let vertex = inside.min_by(|a, b| off(a).total_cmp(&off(b)))?;
        Some(match side.vertices() {
            Places::Plane(places) => places[vertex].into(),
            Places::Space(_) => at_vertex(side.triangles(), vertex as u32)?.into(),
        })
    }
}

/// The share of the piecewise linear function of a vertex, which rises over the length `before` and falls over `after`
/// the vertex, that lies in the arc from one place to another, counted from the vertex and modulo 1.
fn hat_within([before, after]: [f64; 2], [from, to]: [f64; 2]) -> f64 {
    let integral = |t: f64| {
        let rising = (t + before).clamp(0.0, before);
        let falling = t.clamp(0.0, after);
        0.5 * rising * rising / before + falling * (1.0 - 0.5 * falling / after)
    };
    let from = from.rem_euclid(1.0);
    let to = from + (to - from).rem_euclid(1.0);
    // the function is there again a whole boundary further on
    let within: f64 = [0.0, 1.0, 2.0].map(|turn| integral(to - turn) - integral(from - turn)).iter().sum();
    within / (0.5 * (before + after))
}

/// The weights of a triangle's corners that give `wanted`; `None` if one is negative.
fn weights_of([a, b, c]: [DVec2; 3], wanted: DVec2) -> Option<[f64; 3]> {
    let whole = (b - a).perp_dot(c - a);
    let weights = [[b, c], [c, a], [a, b]].map(|[p, q]| (p - wanted).perp_dot(q - wanted) / whole);
    // not a number where the triangle has no area
    weights.iter().all(|&weight| weight >= 0.0).then_some(weights)
}

/// A vertex as a point of one of its triangles.
fn at_vertex(triangles: &[[u32; 3]], vertex: u32) -> Option<BarycentricPoint> {
    let place = |corners: &[u32; 3]| corners.iter().position(|&v| v == vertex);
    let (k, i) = triangles.iter().enumerate().find_map(|(k, corners)| Some((k, place(corners)?)))?;
    let mut weights = [0.0; 3];
    weights[i] = 1.0;
    Some(BarycentricPoint::new(TriangleId::new(k as u32), weights))
}
