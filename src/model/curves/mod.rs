//! The curves of the plots: Poisson kernel, harmonic measure, reparameterization.
//!
//! The abscissa is the arc length from the anchor divided by the boundary's length, as in
//! the paper's Figure 6; the kernel is therefore ψ·ℓ, which is 1 for the uniform measure and has
//! the integral 1. Curves are polylines through the boundary vertices. Independent of egui.

mod boundary_map;
mod exact;

pub use exact::{ExactCurves, KeptExact};

use crate::conformal::{PerSide, Side};
use crate::model::curves::boundary_map::{BoundaryMap, Loop};
use crate::outline::{BoundaryPoint, BoundarySamples};

/// A named polyline with increasing x.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The name in the legend.
    pub name: String,
    /// `[x, y]`, x not decreasing.
    pub points: Vec<[f64; 2]>,
}

impl Curve {
    /// The value at `x`, linear between the points, constant beyond them. Cost O(log m).
    pub fn at(&self, x: f64) -> f64 {
        interpolate(&self.points, x, |p| p[0], |p| p[1])
    }

    /// The x at which a non-decreasing curve has the value `y`; the smallest one where it is flat.
    pub fn inverse_at(&self, y: f64) -> f64 {
        interpolate(&self.points, y, |p| p[1], |p| p[0])
    }
}

/// A boundary's samples, and the anchor at which it is cut open, as a fraction of arc length.
pub type Cut<'a> = (&'a BoundarySamples, f64);

impl Curve {
    /// ω̃ over the arc length from the anchor, given the values at the m vertices after it.
    pub fn measure((samples, anchor): Cut, from_anchor: &[f64]) -> Self {
        let ordinates = std::iter::once(0.0).chain(from_anchor.iter().copied()).chain(std::iter::once(1.0));
        let points = Anchored::new(samples.into(), anchor).abscissae().zip(ordinates).map(|(x, y)| [x, y]).collect();
        Self { name: String::from("measure"), points }
    }

    /// r̃ from `mapped` to `other`, given the images of the vertices.
    pub fn reparameterisation(mapped: Cut, other: Cut, images: &[BoundaryPoint]) -> Self {
        let [mapped, other] = [mapped, other].map(|(samples, anchor)| Anchored::new(samples.into(), anchor));
        let ordinates = reparameterisation(&mapped, &other, images);
        Self {
            name: String::from("reparameterisation"),
            points: mapped.abscissae().zip(ordinates).map(|(x, y)| [x, y]).collect(),
        }
    }
}

/// Linear interpolation of `to` over the non-decreasing `from`.
fn interpolate(points: &[[f64; 2]], at: f64, from: impl Fn(&[f64; 2]) -> f64, to: impl Fn(&[f64; 2]) -> f64) -> f64 {
    let next = points.partition_point(|p| from(p) < at);
    let (Some(b), Some(a)) = (points.get(next), next.checked_sub(1).map(|k| &points[k])) else {
        return points.get(next).or(points.last()).map_or(0.0, to);
    };
    // here from(a) < at ≤ from(b)
    let part = (at - from(a)) / (from(b) - from(a));
    to(a) + part * (to(b) - to(a))
}

/// The curves of the three plots.
#[derive(Debug, Clone, PartialEq)]
pub struct Curves {
    /// ψ·ℓ of source and target.
    pub kernel: PerSide<Curve>,
    /// ω̃ of source and target.
    pub measure: PerSide<Curve>,
    /// r̃: arc length on the other side over arc length on the mapped side.
    pub reparameterisation: Curve,
    /// The side that r̃ starts from.
    pub mapped: Side,
    /// The anchors, as fractions of arc length.
    pub anchors: PerSide<f64>,
}

impl Curves {
    /// The curves of a map with these anchors, given as fractions of arc length.
    pub fn new<'a>(map: impl Into<BoundaryMap<'a>>, anchors: PerSide<f64>) -> Self {
        let BoundaryMap { mapped, loops, kernels, measures, images } = map.into();
        let anchored = PerSide::from_fn(|side| Anchored::new(loops[side], anchors[side]));
        let curve = |side: Side, ordinates: Vec<f64>| {
            let points = anchored[side].abscissae().zip(ordinates).map(|(x, y)| [x, y]).collect();
            Curve { name: side.to_string(), points }
        };
        let kernel = PerSide::from_fn(|side| curve(side, anchored[side].density(kernels[side])));
        let measure = PerSide::from_fn(|side| curve(side, measures[side].at_knots().to_vec()));
        let other = &anchored[mapped.other()];
        let first = curve(mapped, reparameterisation(&anchored[mapped], other, images));
        let reparameterisation = Curve { name: String::from("this map"), ..first };
        Self { kernel, measure, reparameterisation, mapped, anchors: anchored.map(|side| side.origin) }
    }

    /// The point of the other side with the same harmonic measure as the point at `x`.
    pub fn partner(&self, side: Side, x: f64) -> f64 {
        self.measure[side.other()].inverse_at(self.measure[side].at(x))
    }

    /// Converts a fraction of the outline's arc length to the abscissa from the anchor.
    pub fn along(&self, side: Side, fraction: f64) -> f64 {
        (fraction - self.anchors[side]).rem_euclid(1.0)
    }

    /// The inverse of [`Self::along`].
    pub fn fraction(&self, side: Side, x: f64) -> f64 {
        (x + self.anchors[side]).rem_euclid(1.0)
    }
}

/// A boundary cut open at its anchor; its knots are those of [`crate::conformal::HarmonicMeasure`].
struct Anchored<'a> {
    around: Loop<'a>,
    anchor: BoundaryPoint,
    /// The anchor's fraction of arc length.
    origin: f64,
}

impl<'a> Anchored<'a> {
    fn new(around: Loop<'a>, fraction: f64) -> Self {
        let anchor = BoundaryPoint::at_fraction(around.fractions, fraction);
        Self { around, anchor, origin: anchor.fraction_in(around.fractions) }
    }

    /// The m vertices after the anchor; the last one is the anchor itself if that is a vertex.
    fn vertices(&self) -> impl Iterator<Item = usize> {
        let (first, m) = (self.anchor.edge() as usize, self.around.fractions.len());
        (1..=m).map(move |j| (first + j) % m)
    }

    fn is_vertex(&self, k: usize) -> bool {
        self.anchor.fraction() == 0.0 && self.anchor.edge() as usize == k
    }

    /// The arc lengths of the m + 2 knots: the anchor, the vertices, the anchor again.
    fn abscissae(&self) -> impl Iterator<Item = f64> {
        let place = |k: usize| {
            if self.is_vertex(k) { 1.0 } else { (self.around.fractions[k] - self.origin).rem_euclid(1.0) }
        };
        std::iter::once(0.0).chain(self.vertices().map(place)).chain(std::iter::once(1.0))
    }

    /// ψ·ℓ at the knots.
    fn density(&self, psi: &[f64]) -> Vec<f64> {
        let length: f64 = self.around.edge_lengths.iter().sum();
        let (k, f) = (self.anchor.edge() as usize, self.anchor.fraction());
        let at_anchor = length * ((1.0 - f) * psi[k] + f * psi[(k + 1) % psi.len()]);
        let inner = self.vertices().map(|k| length * psi[k]);
        std::iter::once(at_anchor).chain(inner).chain(std::iter::once(at_anchor)).collect()
    }
}

/// r̃ at the knots of `mapped`: the arc lengths of the vertices' images from the other anchor.
fn reparameterisation(mapped: &Anchored, other: &Anchored, images: &[BoundaryPoint]) -> Vec<f64> {
    let mut result = vec![0.0];
    let mut so_far = 0.0_f64;
    for k in mapped.vertices() {
        let behind = images[k].fraction_in(other.around.fractions) - other.origin;
        // an image next to the anchor may lie on either side of it, by rounding or because ω̃ is flat
        let place = if mapped.is_vertex(k) { 1.0 } else { behind.rem_euclid(1.0) };
        let place = if so_far > 0.5 && place < so_far - 0.5 { 1.0 } else { place };
        let place = if so_far == 0.0 && place > 1.0 - 1e-12 { 0.0 } else { place };
        so_far = so_far.max(place);
        result.push(so_far);
    }
    result.push(1.0);
    result
}

/// Reduces a curve to at most four points in each of `columns` equal parts of [0, 1]: the first, the lowest, the
/// highest and the last; to the first alone where it is monotone. Drawn that many pixels wide, the curve looks the same.
pub fn decimate(points: &[[f64; 2]], columns: usize) -> Vec<[f64; 2]> {
    if points.len() <= columns {
        return points.to_vec();
    }
    let column = |p: &[f64; 2]| (p[0] * columns as f64) as usize;
    let mut result = Vec::with_capacity(4 * columns + 4);
    for part in points.chunk_by(|a, b| column(a) == column(b)) {
        let by_value = |&i: &usize, &j: &usize| part[i][1].total_cmp(&part[j][1]);
        let last = part.len() - 1;
        let low = (0..=last).min_by(by_value).unwrap_or(0);
        let high = (0..=last).max_by(by_value).unwrap_or(0);
        let mut kept = [0, low.min(high), low.max(high), last].to_vec();
        kept.dedup();
        // a monotone part continues in the next column: pieces shorter than a pixel would be drawn with uneven width
        let is_monotone = kept == [0, last];
        result.extend(kept.into_iter().take(if is_monotone { 1 } else { 4 }).map(|i| part[i]));
    }
    if let Some(last) = points.last().filter(|last| result.last() != Some(last)) {
        result.push(*last);
    }
    result
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
