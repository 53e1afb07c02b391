//! The mapped mesh refined where the map needs it, so that images fill the other domain without folds.
//!
//! A side is meshed before its maps are known. Where much of the other boundary has little harmonic measure (a limb, a
//! tip, everything when x lies in a tip), it is the image of a few edges, even of one: the images of these edges are
//! chords that leave the other domain, and triangles next to them are flipped. Here the mapped boundary gets a vertex
//! wherever the other one has one, at the same measure, and vertices in between so that the lengths of edges grow
//! gradually; the mesh follows (it is graded from the boundary). The boundary map is not computed anew but is the one
//! that is already known, at more points: ω is piecewise quadratic between the samples, so the vertices of the other
//! boundary have exact preimages, and the image of the mapped boundary is the other polygon itself.
//!
//! Guaranteed: the images of the boundary are in cyclic order, and they are the boundary of the other (sampled) domain
//! except for the [cuts](ResolvedBoundary::cuts): parts whose preimages are smaller than 1e-6 of the mapped domain, cut
//! off by chords. Not guaranteed: that such a chord lies inside the domain where none of those tried does, and that no
//! triangle flips (the extension is piecewise linear).
//!
//! | file | what |
//! |---|---|
//! | `rim` | a boundary with its measure in both directions |
//! | `merge` | the vertices of both boundaries, in order of the measure |
//! | `cut` | chords that cut off what is not resolved |
//! | `grade` | vertices in between |
//! | `map` | the map on the refined mesh |

mod cut;
mod grade;
mod map;
mod merge;
mod rim;

use super::{ConformalMap, MapError, MeshedDomain, PrepareError, PrepareSettings, PreparedSide, Side, Stage};
use crate::geometry::DVec2;
use crate::outline::{BoundaryPoint, BoundarySamples};
use merge::{FINEST, Merged};
use rim::Rim;
use std::sync::Arc;

/// Images smaller than this, relative to the extent of the other domain, are not graded any further: the measure, of
/// which 1e-16 is told apart, leaves them too few digits.
const FINEST_IMAGE: f64 = 1e-10;

/// A share of flipped triangles above which the refinement is repeated: a tenth of what a picture may have.
const FOLDS: f64 = 1e-4;

/// The boundary of a mapped domain with vertices at which the other domain's boundary is resolved.
#[derive(Debug, Clone, PartialEq)]
pub struct ResolvedBoundary {
    /// The vertices, on the edges of the mapped domain's samples, which are among them.
    pub(super) samples: BoundarySamples,
    /// The vertices as points of the mapped domain's samples.
    pub(super) places: Vec<BoundaryPoint>,
    /// The images.
    pub(super) images: Vec<BoundaryPoint>,
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
        let (a, b) = (Rim::new(mapped, map.measure(side))?, Rim::new(other, map.measure(side.other()))?);
        let merged = Merged::new(&a, &b);
        let (places, images) = filled(&merged, &a, &b);
        let points: Vec<DVec2> = places.iter().map(|&place| mapped.position(place)).collect();
        let m = points.len();
        let edge_lengths = (0..m).map(|k| points[k].distance(points[(k + 1) % m])).collect();
        let fractions = places.iter().map(|&place| mapped.fraction_at(place)).collect();
        let samples = BoundarySamples::checked(points, edge_lengths, fractions)?;
        let count = other.len();
        let cuts: Vec<Vec<DVec2>> = (merged.cuts.iter())
            .map(|&[from, to]| (0..=(to + count - from) % count).map(|k| other.points()[(from + k) % count]).collect())
            .collect();
        let unresolved: f64 = cuts.iter().map(|cut| area(cut)).sum();
        let unresolved_area = (unresolved / area(other.points())).clamp(0.0, 1.0);
        Some(Self { samples, places, images, cuts, unresolved_area })
    }

    /// The samples of the refined boundary.
    pub fn samples(&self) -> &BoundarySamples {
        &self.samples
    }

    /// What is needed to prepare the domain `coarse` with these samples.
    pub(super) fn resampled(&self, coarse: &MeshedDomain) -> Resampled {
        Resampled {
            samples: self.samples.clone(),
            coarse_count: coarse.samples().len(),
            default_point: coarse.default_point(),
        }
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

/// All vertices of the resolved boundary, from the mapped domain's first sample on, and their images.
fn filled(merged: &Merged, mapped: &Rim<'_>, other: &Rim<'_>) -> (Vec<BoundaryPoint>, Vec<BoundaryPoint>) {
    let knots = &merged.knots;
    let added = added(merged, mapped, other);
    let first = knots.iter().position(|knot| knot.own == Some(0)).unwrap_or(0);
    let count = other.samples.len();
    let image_at = |image: f64| {
        let edge = image.floor();
        BoundaryPoint::new(((edge as usize + merged.first) % count) as u32, image - edge)
    };
    let (mut places, mut images) = (Vec::new(), Vec::new());
    let mut on = (0u32, 0.0);
    for (k, knot) in (first..knots.len()).chain(0..first).map(|k| (k, &knots[k])) {
        on = knot.own.map_or(on, |own| (own, knot.at));
        let place = |at: f64, own: bool| {
            let along = (at - on.1).rem_euclid(merged.length) / mapped.samples.edge_lengths()[on.0 as usize];
            BoundaryPoint::new(on.0, if own { 0.0 } else { along.clamp(0.0, 1.0 - f64::EPSILON) })
        };
        places.push(place(knot.at, knot.own.is_some()));
        images.push(image_at(knot.image));
        let next = knots.get(k + 1).map_or(knots[0].image + count as f64, |knot| knot.image);
        let mut before = knot.image;
        for &at in &added[k] {
            let here = place(at, false);
            let image = other.point(other.place(mapped.at((at + merged.start).rem_euclid(merged.length))));
            let passed = ((image.edge() as usize + count - merged.first) % count) as f64 + image.fraction();
            before = passed.clamp(before, next);
            places.push(here);
            images.push(image_at(before));
        }
    }
    (places, images)
}

/// The arc lengths on the mapped boundary, from the start, of the vertices to insert after each knot: so many that
/// neither the edges nor their images grow faster than gradually.
fn added(merged: &Merged, mapped: &Rim<'_>, other: &Rim<'_>) -> Vec<Vec<f64>> {
    let knots = &merged.knots;
    let ends: Vec<f64> = knots.iter().map(|knot| knot.at).collect();
    let own = grade::between(&ends, merged.length, FINEST * mapped.extent(), |k| knots[k].is_cut);
    let first = other.length_to(merged.first);
    let images: Vec<f64> = (knots.iter())
        .map(|knot| {
            let edge = (knot.image.floor() as usize + merged.first) % other.samples.len();
            let at = other.length_to(edge) + knot.image.fract() * other.samples.edge_lengths()[edge];
            // the images ascend from that of the start
            (at - first).rem_euclid(other.length())
        })
        .collect();
    let there = grade::between(&images, other.length(), FINEST_IMAGE * other.extent(), |k| knots[k].is_cut);
    let back = |at: f64| {
        let place = mapped.length_of(mapped.place(other.at((at + first).rem_euclid(other.length()))));
        (place - merged.start).rem_euclid(merged.length)
    };
    let mut added = own;
    for (k, images) in there.into_iter().enumerate().filter(|(_, images)| !images.is_empty()) {
        let end = ends.get(k + 1).copied().unwrap_or(merged.length + ends[0]);
        let least = 0.2 * FINEST * mapped.extent();
        let mut before = ends[k];
        let inside = images.into_iter().map(back).filter(|&at| {
            let fits = at > before + least && at < end - least;
            before = if fits { at } else { before };
            fits
        });
        let inside: Vec<f64> = inside.collect();
        if inside.len() > added[k].len() {
            added[k] = inside;
        }
    }
    added
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
pub(crate) struct Resampled {
    pub(super) samples: BoundarySamples,
    pub(super) coarse_count: usize,
    pub(super) default_point: DVec2,
}

/// Meshes and factors a domain with a refined boundary; `settings` are those of the unrefined domain. Kernels are
/// computed by adjoint solves.
///
/// Errors: as [`super::prepare`].
pub(super) fn prepare_resampled(
    resampled: &Resampled,
    settings: &PrepareSettings,
    progress: &mut dyn FnMut(Stage),
) -> Result<PreparedSide, PrepareError> {
    super::prepare::prepare_meshed(resampled, settings, progress)
}

impl ConformalMap {
    /// The map on a mesh refined for it, which [`ResolvedBoundary`] describes; `None` where that does not exist.
    /// `settings` are those of the mapped domain. Takes as long as two to three preparations of it.
    ///
    /// Where triangles still flip, the refinement is repeated from the measure on the refined mesh: with a limb in a
    /// re-entrant corner of nearly 360°, the images fold if the measure decays 5 % too fast along the limb, as it does
    /// on a mesh of four edges across. The better one of both maps is returned.
    pub fn refined(
        &self,
        settings: &PrepareSettings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<Option<Self>, ResolveError> {
        let Some(first) = self.refined_from(self, settings, progress)? else { return Ok(None) };
        if !first.is_folded() {
            return Ok(Some(first));
        }
        // a second pass that fails, or is no better, leaves the first one
        let measured = first.remeasured().ok().flatten();
        let second = measured.and_then(|measured| self.refined_from(&measured, settings, progress).ok().flatten());
        Ok(Some(second.filter(|second| second.folds() < first.folds()).unwrap_or(first)))
    }

    /// The map refined for the measures of `measured`, a map under the same constraints.
    fn refined_from(
        &self,
        measured: &Self,
        settings: &PrepareSettings,
        progress: &mut dyn FnMut(Stage),
    ) -> Result<Option<Self>, ResolveError> {
        let (Some(boundary), Some(coarse)) = (ResolvedBoundary::of(measured), self.mapped().domain()) else {
            return Ok(None);
        };
        let refined = prepare_resampled(&boundary.resampled(coarse), settings, progress)?;
        Ok(Some(measured.resolved(Arc::new(boundary), Arc::new(refined), self.settings)?))
    }

    /// The same map on the same meshes, with the measures of these meshes; `None` before the first update.
    pub(crate) fn remeasured(&self) -> Result<Option<Self>, MapError> {
        let Some(constraints) = self.constraints() else { return Ok(None) };
        let [source, target] = Side::BOTH.map(|side| Arc::clone(self.side(side)));
        Self::new(source, target, &constraints, self.direction().into()).map(Some)
    }

    /// Whether so many triangles are flipped that [`Self::refined`] repeats the refinement.
    pub(crate) fn is_folded(&self) -> bool {
        self.folds() > FOLDS
    }

    /// The share of the triangles that are flipped.
    pub(crate) fn folds(&self) -> f64 {
        f64::from(self.quality().flipped) / self.mapped().triangles().len().max(1) as f64
    }

    /// The resolved boundary of the mapped mesh, if it was refined for this map and the map has not changed since.
    pub fn resolution(&self) -> Option<&ResolvedBoundary> {
        self.resolution.as_deref()
    }
}
