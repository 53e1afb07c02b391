//! The mapped mesh refined where the map needs it, so that images fill the other domain without folds.
//!
//! A side is meshed before its maps are known. Where much of the other boundary has little harmonic measure (a limb, a
//! tip, everything when x lies in a tip), it is the image of a few edges, even of one: the images of these edges are
//! chords that leave the other domain, and triangles next to them are flipped. Here the mapped boundary gets a vertex
//! wherever the other one has one, at the same measure, and vertices in between so that the lengths of edges grow
//! gradually; the mesh follows (it is graded from the boundary). The boundary map is not computed anew but is the one
//! that is already known, at more points: ω can be inverted between the samples too, so the vertices of the other
//! boundary have exact preimages. With a boundary integral the new vertices and the images lie on the curves, so that
//! the image of the mapped boundary is the other curve as it is drawn; else on the samples' polygons.
//!
//! Guaranteed: the images of the boundary are in cyclic order, and they are the boundary of the other (sampled) domain
//! except for the [cuts](ResolvedBoundary::cuts): parts whose preimages are smaller than 1e-6 of the mapped domain, cut
//! off by chords. Not guaranteed: that such a chord lies inside the domain where none of those tried does, and that no
//! triangle flips (the extension is piecewise linear).
//!
//! | file | what |
//! |---|---|
//! | `rim` | a boundary with its measure in both directions |
//! | `law` | the measure between two knots, by finite elements or by the boundary integral |
//! | `corner` | the former next to a corner |
//! | `merge` | the vertices of both boundaries, in order of the measure |
//! | `cut` | chords that cut off what is not resolved |
//! | `fill`, `grade` | vertices in between |
//! | `map` | the map on the refined mesh |
//! | `straightened` | images next to re-entrant corners |
//! | `refining` | all of it in steps, repeated where triangles flip |
//! | `refined` | the same without a pause |

mod corner;
mod cut;
mod fill;
mod grade;
mod law;
mod map;
mod merge;
mod refined;
mod refining;
mod rim;
mod straightened;

pub use refining::Refining;

use super::{ConformalMap, MapError, PrepareError, PrepareSettings, PreparedSide, Side, Stage};
use crate::geometry::DVec2;
use crate::outline::{BoundaryPoint, BoundarySamples};
use fill::{Filled, filled, outline};
use merge::Merged;
use rim::Rim;

/// The boundary of a mapped domain with vertices at which the other domain's boundary is resolved.
#[derive(Debug, Clone, PartialEq)]
pub struct ResolvedBoundary {
    /// The vertices, on the edges of the mapped domain's samples, which are among them.
    pub(super) samples: BoundarySamples,
    /// The vertices as points of the mapped domain's samples.
    pub(super) places: Vec<BoundaryPoint>,
    /// The images.
    pub(super) images: Vec<BoundaryPoint>,
    /// The measure from the anchor to each vertex.
    pub(super) measures: Vec<f64>,
    /// Whether a part of the other domain is cut off after each vertex.
    is_cut: Vec<bool>,
    /// The other domain's boundary through the images, and in the cuts through its samples.
    outline: Vec<DVec2>,
    cuts: Vec<Vec<DVec2>>,
    unresolved_area: f64,
}

impl ResolvedBoundary {
    /// The boundary that resolves the images of `map`; `None` for surfaces, whose meshes are given, before the map's
    /// first update, and where the measures are not finite. Cost O(m log m).
    pub fn of(map: &ConformalMap) -> Option<Self> {
        let side = map.mapped_side();
        let [mapped, other] = [side, side.other()].map(|side| map.domain(side).map(|domain| domain.samples()));
        let (mapped, other) = (mapped?, other?);
        let found = map.far_of_finite_elements();
        let far = found.as_ref().unwrap_or(&map.far);
        let far = |side: Side| far.iter().map(move |far| (&far.measures[side], far.limit));
        let a = Rim::new(mapped, map.measure(side), far(side))?;
        let b = Rim::new(other, map.measure(side.other()), far(side.other()))?;
        let merged = Merged::new(&a, &b);
        let Filled { places, images, measures, is_cut } = filled(&merged, &a, &b);
        let outline = outline(&b, &images, &is_cut);
        let points = places.iter().map(|&place| a.position(place)).collect();
        let samples = BoundarySamples::on_curve(points, places.iter().map(|&place| a.fraction(place)).collect())?;
        let count = other.len();
        let cuts: Vec<Vec<DVec2>> = (merged.cuts.iter())
            .map(|&[from, to]| (0..=(to + count - from) % count).map(|k| other.points()[(from + k) % count]).collect())
            .collect();
        let unresolved = cuts.iter().fold(0.0, |sum, cut| sum + area(cut).max(0.0));
        let unresolved_area = (unresolved / area(other.points())).clamp(0.0, 1.0);
        Some(Self { samples, places, images, measures, is_cut, outline, cuts, unresolved_area })
    }

    /// The samples of the refined boundary.
    pub fn samples(&self) -> &BoundarySamples {
        &self.samples
    }

    /// Whether vertex `k` is an end of a part that is cut off.
    pub(super) fn is_at_cut(&self, k: usize) -> bool {
        self.is_cut[k] || self.is_cut[(k + self.is_cut.len() - 1) % self.is_cut.len()]
    }

    /// Whether an image of vertex `k` lies between the images of its neighbors; inside of a cut, which these share, none
    /// does.
    pub(super) fn is_in_order(&self, k: usize, image: BoundaryPoint) -> bool {
        let count = self.images.len();
        let [before, after] = [self.images[(k + count - 1) % count], self.images[(k + 1) % count]];
        let is_before = |a: BoundaryPoint, b: BoundaryPoint| (a.edge(), a.fraction()) <= (b.edge(), b.fraction());
        // cyclic: of the three comparisons around, two hold
        let around = [is_before(before, image), is_before(image, after), is_before(after, before)];
        before != after && around.into_iter().filter(|&holds| holds).count() >= 2
    }

    /// The other domain's boundary as it is drawn: through the images, and in the cuts through its samples.
    pub fn outline(&self) -> &[DVec2] {
        &self.outline
    }

    /// The parts of the other domain that are not covered, as counter-clockwise polygons.
    pub fn cuts(&self) -> &[Vec<DVec2>] {
        &self.cuts
    }

    /// The area of these parts as a fraction of the other domain's area.
    pub fn unresolved_area(&self) -> f64 {
        self.unresolved_area
    }
}

/// The larger side of the box around the points.
fn extent(points: &[DVec2]) -> f64 {
    let ends = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    let (low, high) = points.iter().fold(ends, |(low, high), &p| (low.min(p), high.max(p)));
    (high - low).max_element()
}

/// The area of a counter-clockwise polygon.
fn area(polygon: &[DVec2]) -> f64 {
    let Some(&origin) = polygon.first() else { return 0.0 };
    0.5 * polygon.windows(2).map(|w| (w[0] - origin).perp_dot(w[1] - origin)).sum::<f64>()
}

/// Why the mapped mesh could not be refined.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ResolveError {
    /// The boundary with more vertices could not be meshed or its Laplacian not be factored.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The map on the refined mesh could not be computed.
    #[error(transparent)]
    Map(#[from] MapError),
}

/// The samples of a refined boundary with what else is needed to prepare the domain.
#[derive(Debug, Clone, PartialEq)]
pub struct Resampled {
    pub(super) samples: BoundarySamples,
    pub(super) coarse_count: usize,
    pub(super) default_point: DVec2,
}

impl Resampled {
    /// From points of the boundary and their fractions of its length, and the number of samples and the default point of
    /// the domain before; `None` if the points are not samples of a boundary.
    pub fn from_parts(
        (points, fractions): (Vec<DVec2>, Vec<f64>),
        (coarse_count, default_point): (usize, DVec2),
    ) -> Option<Self> {
        Some(Self { samples: BoundarySamples::on_curve(points, fractions)?, coarse_count, default_point })
    }

    /// The samples.
    pub fn samples(&self) -> &BoundarySamples {
        &self.samples
    }

    /// The number of samples and the default point of the domain before.
    pub fn coarse(&self) -> (usize, DVec2) {
        (self.coarse_count, self.default_point)
    }

    /// Meshes and factors the domain; `settings` are those of the unrefined domain. Kernels are computed by adjoint
    /// solves.
    ///
    /// Errors: as [`super::prepare`].
    pub fn prepare(
        &self,
        settings: &PrepareSettings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<PreparedSide, PrepareError> {
        super::prepare::prepare_meshed(self, settings, progress)
    }
}
