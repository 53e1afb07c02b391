//! Smoothing: a discrete heat flow of the coordinates of the uniformly sampled outline.

use crate::geometry::DVec2;

/// Points of the smoothed outline: with 400 the polygon of a circle turns by 0.016 from edge to edge.
const POINTS: usize = 400;

/// Passes of the kernel (¼, ½, ¼): a Gaussian of standard deviation √(passes/2) samples, here 1 % of the length.
const PASSES: usize = 32;

/// The outline with its coordinates, as functions of arc length, convolved with a Gaussian of
/// 1 % of the length, and scaled about its centroid to preserve the area. A circle and the middle of a straight edge
/// do not change; corners become round. The result may cross itself where the outline is very narrow.
pub(super) fn smoothed(vertices: &[DVec2]) -> Vec<DVec2> {
    let (area, _) = area_and_centroid(vertices);
    let mut points = resampled(vertices, POINTS);
    for _ in 0..PASSES {
        let n = points.len();
        points = (0..n).map(|k| 0.25 * (points[(k + n - 1) % n] + points[(k + 1) % n]) + 0.5 * points[k]).collect();
    }
    let (shrunk, centroid) = area_and_centroid(&points);
    let scale = (area / shrunk).sqrt();
    if scale.is_finite() {
        for p in &mut points {
            *p = centroid + scale * (*p - centroid);
        }
    }
    points
}

/// `count` points equally spaced in arc length, starting at the first vertex.
fn resampled(vertices: &[DVec2], count: usize) -> Vec<DVec2> {
    let n = vertices.len();
    let lengths: Vec<f64> = (0..n).map(|k| vertices[k].distance(vertices[(k + 1) % n])).collect();
    let step = lengths.iter().sum::<f64>() / count as f64;
    let (mut edge, mut before) = (0, 0.0);
    let mut points = Vec::with_capacity(count);
    for k in 0..count {
        let s = k as f64 * step;
        while edge + 1 < n && before + lengths[edge] <= s {
            before += lengths[edge];
            edge += 1;
        }
        let t = ((s - before) / lengths[edge]).clamp(0.0, 1.0);
        points.push(vertices[edge].lerp(vertices[(edge + 1) % n], t));
    }
    points
}

/// The signed area and the centroid of the enclosed part of the plane.
fn area_and_centroid(vertices: &[DVec2]) -> (f64, DVec2) {
    let Some(&origin) = vertices.first() else { return (0.0, DVec2::ZERO) };
    let (mut twice, mut moment) = (0.0, DVec2::ZERO);
    for (k, &a) in vertices.iter().enumerate() {
        let (a, b) = (a - origin, vertices[(k + 1) % vertices.len()] - origin);
        let part = a.perp_dot(b);
        twice += part;
        moment += part * (a + b);
    }
    (0.5 * twice, origin + moment / (3.0 * twice))
}
