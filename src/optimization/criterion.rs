//! What the best map of a family minimizes, measured on a map.

use super::statistics::{Scales, thinned};
use super::symmetry::Images;
use super::{Region, SharedSymmetries};
use crate::conformal::{ConformalMap, Places, Side, SideGeometry, TriangleDistortion};
use crate::geometry::{DVec2, DVec3};
use crate::laplace::Deadline;
use crate::mesh::TriangleId;
use std::f64::consts::LN_2;
use std::sync::Arc;

/// Of maps that keep symmetries equally well the one with the most even areas is sought: this much of the root of their
/// variance is added to the mismatch, which grows faster next to a map without mismatch.
const EVENNESS: f64 = 0.01;

/// Triangles at which the mismatch is measured.
const MEASURED: usize = 500;

/// What is minimized over all conformal maps of the source onto the target.
///
/// σ₁, σ₂ are the singular values of the map of a triangle of the mapped mesh, |f′| = √(σ₁σ₂). A triangle whose image is a
/// segment has as |f′| the ratio of lengths; one whose image is a point has none, and counts as the farthest of the others.
#[derive(Debug, Clone, PartialEq)]
pub enum Criterion {
    /// The mean of (ln σ₁σ₂)² after the best common scale, weighted by the triangles' areas in the mapped mesh: 0 where
    /// all areas have one scale.
    Area,
    /// The ratio of the largest to the least |f′| over 98 % of the mapped mesh's area: a hundredth is left out at either
    /// end, since |f′| is 0 or infinite in corners, where no mesh says how far it goes. 1 is the least possible.
    Scale,
    /// As [`Self::Area`] within a region of the source, weighted by areas of the source.
    Region(Arc<Region>),
    /// How far the map is from keeping the symmetries of the outlines: see [`SharedSymmetries`]. Of maps that keep them
    /// equally well the one with the least [`Self::Area`] is sought.
    Symmetry(Arc<SharedSymmetries>),
}

/// Of one map: the criterion, and what a search minimizes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Value {
    pub criterion: f64,
    pub objective: f64,
}

impl Value {
    /// Where there is no map.
    pub const NONE: Self = Self { criterion: f64::INFINITY, objective: f64::INFINITY };
}

impl Criterion {
    /// The name, as on the command line.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Area => "area",
            Self::Scale => "scale",
            Self::Region(_) => "region",
            Self::Symmetry(_) => "symmetry",
        }
    }

    /// The region, if there is one.
    pub(super) fn region(&self) -> Option<&Region> {
        if let Self::Region(region) = self { Some(region) } else { None }
    }

    /// The symmetries, if they are the criterion.
    pub(super) fn symmetries(&self) -> Option<&SharedSymmetries> {
        if let Self::Symmetry(shared) = self { Some(shared) } else { None }
    }

    /// The side whose mesh has to be mapped, if it is not all the same.
    pub(super) fn mapped(&self) -> Option<Side> {
        self.symmetries().map(SharedSymmetries::side)
    }

    /// The value for these scales, of [`Self::Symmetry`] its addition to the mismatch; `None` without weight.
    pub(super) fn of(&self, scales: &mut Scales) -> Option<f64> {
        match self {
            Self::Area | Self::Region(_) => scales.variance(),
            Self::Scale => scales.spread(),
            Self::Symmetry(_) => scales.variance().map(|variance| EVENNESS * variance.sqrt()),
        }
    }

    /// The value for a map that is complete; `None` if no triangle of it lies in the region.
    pub fn measure(&self, map: &ConformalMap) -> Option<f64> {
        if let Some(shared) = self.symmetries() { mismatch(shared, map) } else { self.of_scales(map) }
    }

    /// What the search minimizes, given the measured value.
    pub(super) fn objective(&self, measured: f64, map: &ConformalMap) -> f64 {
        let addition = self.symmetries().and_then(|_| self.of_scales(map));
        measured + addition.unwrap_or(0.0)
    }

    fn of_scales(&self, map: &ConformalMap) -> Option<f64> {
        let mut all = Vec::new();
        map.advance_distortions(&mut all, Deadline::NEVER);
        let numbered: Vec<(usize, TriangleDistortion)> = all.into_iter().enumerate().collect();
        let mapped = Triangles::of(map);
        let mut scales = Scales::default();
        for (t, found) in map.given(&numbered) {
            let scale = if found.collapsed { mapped.ratio_of_lengths(*t) } else { Some(0.5 * LN_2 * found.area_log2) };
            let Some(scale) = scale else {
                scales.miss(self.region().map_or(found.area, |region| mapped.weight_unseen(region, *t, found.area)));
                continue;
            };
            let weight = match self.region() {
                None => found.area,
                Some(region) if mapped.side == Side::Source => found.area * region.share(mapped.corners(*t)),
                Some(region) => found.area * (2.0 * scale).exp() * region.share(mapped.images(*t)),
            };
            scales.push(scale, weight);
        }
        self.of(&mut scales)
    }
}

/// The mismatch of a map between outlines, at triangles that stand for all.
fn mismatch(shared: &SharedSymmetries, map: &ConformalMap) -> Option<f64> {
    let mesh = map.domain(shared.side()).filter(|_| map.mapped_side() == shared.side())?.mesh();
    let weighted = (0..mesh.triangles().len()).map(|t| {
        let [a, b, c] = mesh.corner_places(TriangleId::new(t as u32));
        (t, 0.5 * (b - a).perp_dot(c - a))
    });
    let middle =
        |places: &[DVec2], t: usize| mesh.triangles()[t].iter().map(|&v| places[v as usize]).sum::<DVec2>() / 3.0;
    let chosen: Vec<_> = thinned(weighted.collect(), MEASURED)
        .into_iter()
        .map(|(t, weight)| (middle(mesh.vertices(), t), middle(map.images(), t), weight))
        .collect();
    let motions: Vec<_> = shared.motions().collect();
    shared.mismatch(|k| {
        let image = |&(at, place, weight): &(DVec2, DVec2, f64)| {
            Some(Images { place, moved: map.image_of(motions[k].moved(at))?, weight })
        };
        chosen.iter().filter_map(image).collect()
    })
}

/// The triangles of the mapped mesh with their images, in space; the plane lies at z = 0.
struct Triangles<'a> {
    map: &'a ConformalMap,
    side: Side,
    /// The distance within which images cannot be told apart.
    resolution: f64,
}

impl<'a> Triangles<'a> {
    fn of(map: &'a ConformalMap) -> Self {
        Self { map, side: map.mapped_side(), resolution: map.image_resolution() }
    }

    fn places(&self, places: Places<'_>, t: usize) -> [DVec3; 3] {
        self.map.mapped().triangles()[t].map(|v| match places {
            Places::Plane(places) => places[v as usize].extend(0.0),
            Places::Space(places) => places[v as usize],
        })
    }

    fn corners(&self, t: usize) -> [DVec3; 3] {
        let places = match self.map.mapped().geometry() {
            SideGeometry::Plane(domain) => Places::Plane(domain.mesh().vertices()),
            SideGeometry::Space(surface) => Places::Space(surface.mesh().vertices()),
        };
        self.places(places, t)
    }

    fn images(&self, t: usize) -> [DVec3; 3] {
        self.places(self.map.image_places(), t)
    }

    /// ln of the ratio of the root mean squares of the edges' lengths; `None` where the image is a point.
    fn ratio_of_lengths(&self, t: usize) -> Option<f64> {
        let squares = |[a, b, c]: [DVec3; 3]| a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
        let images = squares(self.images(t));
        (images > self.resolution * self.resolution).then(|| 0.5 * (images / squares(self.corners(t))).ln())
    }

    /// The weight, in a region of the source, of a triangle of this area whose image is a point: none in the source if the
    /// triangle is the target's.
    fn weight_unseen(&self, region: &Region, t: usize, area: f64) -> f64 {
        if self.side == Side::Source { area * region.share(self.corners(t)) } else { 0.0 }
    }
}
