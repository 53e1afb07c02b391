//! A smooth curve through the points of a dense chain, with corners.
//!
//! Between corners the curve is the cubic spline through the points ([`Spline`]); points on a straight line between two
//! corners become a line. Guarantees: the curve passes through the points, stays within a quarter of each edge's length
//! from that edge, and does not cross itself; otherwise the reason is returned.

use std::sync::Arc;

use super::crossing::first_crossing;
use crate::geometry::{Curve, CurveError, DVec2, Junction, Piece, Spline, sort_by_number};

/// Why a chain of points stays a polygon although its curve was to be found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StaysPolygon {
    /// It has fewer than [`super::LEAST_SMOOTH`] points.
    #[error("it has only {count} points")]
    FewPoints {
        /// The number of points.
        count: usize,
    },
    /// Too many points are corners.
    #[error("{corners} of its {count} points are corners")]
    ManyCorners {
        /// The number of corners.
        corners: usize,
        /// The number of points.
        count: usize,
    },
    /// The spline would leave an edge by more than a quarter of its length, or turn back along it.
    #[error("the smooth curve through its points would leave the edge at ({}, {}) by more than a quarter of its length", .at.x, .at.y)]
    LeavesEdge {
        /// The edge's first point.
        at: DVec2,
    },
    /// The spline would cross itself, or so nearly that this cannot be told.
    #[error("the smooth curve through its points would cross itself near ({}, {})", .at.x, .at.y)]
    CrossesItself {
        /// The first point of one of the edges.
        at: DVec2,
    },
    /// The path crosses itself although its vertices are those of a simple polygon.
    #[error("its path crosses itself near ({}, {})", .at.x, .at.y)]
    PathCrossesItself {
        /// The first point of one of the parts that meet.
        at: DVec2,
    },
    /// The file's or the spline's pieces do not form a curve.
    #[error("its pieces form no curve: {0}")]
    NoCurve(#[from] CurveError),
}

/// Points that deviate less from the line between two corners, in lengths of that line, are on it: rounding.
const STRAIGHT: f64 = 1e-14;
/// The largest distance from an edge, in its lengths.
const LARGEST_DISTANCE: f64 = 0.25;

/// A piece between two vertices, the first one given.
struct Placed {
    vertex: usize,
    piece: Piece,
}

/// The curve through all vertices of a simple, counter-clockwise polygon; `corners` are ascending. Piece 0 begins at
/// vertex 0. Junctions at points that are no corners are called analytic: there the curve stands for a smooth one.
pub(super) fn smooth_curve(vertices: &[DVec2], corners: &[usize]) -> Result<Curve, StaysPolygon> {
    let mut placed = pieces(vertices, corners)?;
    sort_by_number(&mut placed, |placed| placed.vertex as f64);
    let cubics: Vec<[DVec2; 4]> = placed.iter().flat_map(|placed| cubics(&placed.piece)).collect();
    if let Some(leaving) = cubics.iter().find(|cubic| !stays_near(cubic)) {
        return Err(StaysPolygon::LeavesEdge { at: leaving[0] });
    }
    if let Some((_, j)) = first_crossing(&cubics) {
        return Err(StaysPolygon::CrossesItself { at: cubics[j][0] });
    }
    let starts: Vec<usize> = placed.iter().map(|placed| placed.vertex).collect();
    let mut curve = Curve::new(placed.into_iter().map(|placed| placed.piece).collect())?;
    for (k, vertex) in starts.iter().enumerate() {
        let is_smooth = curve.junctions()[k] == Junction::Smooth;
        if is_smooth && corners.binary_search(vertex).is_err() {
            curve = curve.analytic_at(k)?;
        }
    }
    Ok(curve)
}

/// The pieces, in any order: a line or a spline from corner to corner, divided where vertex 0 is between.
fn pieces(vertices: &[DVec2], corners: &[usize]) -> Result<Vec<Placed>, StaysPolygon> {
    let n = vertices.len();
    let no_spline = StaysPolygon::LeavesEdge { at: vertices[0] };
    let Some(&first) = corners.first() else {
        let spline = Arc::new(Spline::closed(vertices).ok_or(no_spline)?);
        return Ok(vec![Placed { vertex: 0, piece: Piece::Spline { spline, from: 0, to: n } }]);
    };
    let mut placed = Vec::new();
    for (k, &from) in corners.iter().enumerate() {
        let to = corners.get(k + 1).copied().unwrap_or(first + n);
        let points: Vec<DVec2> = (from..=to).map(|k| vertices[k % n]).collect();
        let spline = if is_straight(&points) {
            None
        } else {
            Some(Arc::new(Spline::open(&points).ok_or_else(|| no_spline.clone())?))
        };
        // vertex 0 stays a junction
        let cut = if from < n && n < to { n } else { to };
        for [a, b] in [[from, cut], [cut, to]].into_iter().filter(|[a, b]| a < b) {
            let piece = match &spline {
                None => Piece::Line([vertices[a % n], vertices[b % n]]),
                Some(spline) => Piece::Spline { spline: Arc::clone(spline), from: a - from, to: b - from },
            };
            placed.push(Placed { vertex: a % n, piece });
        }
    }
    Ok(placed)
}

/// The polynomials of a piece as Bézier curves.
fn cubics(piece: &Piece) -> Vec<[DVec2; 4]> {
    match *piece {
        Piece::Line([a, b]) => vec![line(a, b)],
        Piece::Spline { ref spline, from, to } => spline.cubics().skip(from).take(to - from).collect(),
        _ => Vec::new(),
    }
}

fn line(a: DVec2, b: DVec2) -> [DVec2; 4] {
    [a, a.lerp(b, 1.0 / 3.0), a.lerp(b, 2.0 / 3.0), b]
}

fn is_straight(points: &[DVec2]) -> bool {
    let [a, .., b] = points else { return true };
    let chord = *b - *a;
    let length2 = chord.length_squared();
    length2 > 0.0 && points.iter().all(|p| (*p - *a).perp_dot(chord).abs() <= STRAIGHT * length2)
}

/// Whether a cubic advances along its chord everywhere and stays within [`LARGEST_DISTANCE`] of it. A cubic's
/// distance from its chord is at most ¾ of its control points'.
fn stays_near([a, b, c, d]: &[DVec2; 4]) -> bool {
    let chord = *d - *a;
    let length2 = chord.length_squared();
    let [s, t] = [*b - *a, *c - *a].map(|p| p.dot(chord) / length2);
    let near = |p: DVec2| 0.75 * (p - *a).perp_dot(chord).abs() <= LARGEST_DISTANCE * length2;
    0.0 < s && s < t && t < 1.0 && near(*b) && near(*c)
}
