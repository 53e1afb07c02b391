//! The parts of the source's triangles that lie in the painted region, for the picture: triangles at its edge are cut.

use crate::conformal::{PreparedSide, Side, SideGeometry};
use crate::geometry::DVec3;
use crate::model::Model;
use crate::optimization::{Dab, Region};
use std::sync::{Arc, Weak};

/// A triangle whose corners all lie outside belongs to the region if at least this share of it does.
const HALF: f64 = 0.5;

/// Halvings by which the end of the region on an edge is found.
const HALVINGS: u32 = 12;

/// A triangle within a triangle of the source, by barycentric coordinates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// The index of the triangle of the source.
    pub triangle: usize,
    /// The corners; each is the combination of the triangle's corners with these weights.
    pub corners: [DVec3; 3],
}

/// What of the triangles belongs to a region, and what that was computed for.
#[derive(Debug, Default)]
pub(super) struct Mask {
    side: Weak<PreparedSide>,
    region: Arc<Region>,
    parts: Vec<Part>,
}

impl Mask {
    /// The parts, if the source has this many triangles: the shown one may be another one for a moment.
    pub fn parts(&self, triangles: usize) -> &[Part] {
        let is_there = self.side.upgrade().is_some_and(|side| side.triangles().len() == triangles);
        if is_there { &self.parts } else { &[] }
    }

    /// The region, if it is of these dabs.
    pub fn region(&self, dabs: &[Dab]) -> Option<&Arc<Region>> {
        Some(&self.region).filter(|region| region.dabs() == dabs)
    }

    fn new(side: &Arc<PreparedSide>, region: Arc<Region>) -> Self {
        let places: Vec<DVec3> = match side.geometry() {
            SideGeometry::Plane(domain) => domain.mesh().vertices().iter().map(|x| x.extend(0.0)).collect(),
            SideGeometry::Space(surface) => surface.mesh().vertices().to_vec(),
        };
        let is_inside: Vec<bool> = places.iter().map(|&place| region.contains(place)).collect();
        let parts = side.triangles().iter().enumerate().flat_map(|(triangle, corners)| {
            let (at, inside) = (corners.map(|v| places[v as usize]), corners.map(|v| is_inside[v as usize]));
            parts_of(at, inside, &region).into_iter().flatten().map(move |corners| Part { triangle, corners })
        });
        Self { parts: parts.collect(), side: Arc::downgrade(side), region }
    }
}

/// The parts of a triangle with these corners that lie inside, with a straight edge between the ends of the region on its
/// edges.
fn parts_of(at: [DVec3; 3], is_inside: [bool; 3], region: &Region) -> [Option<[DVec3; 3]>; 2] {
    let corner = [DVec3::X, DVec3::Y, DVec3::Z];
    let next = |k: usize| [(k + 1) % 3, (k + 2) % 3];
    let end = |from: usize, to: usize| corner[from].lerp(corner[to], end_of(region, at[from], at[to]));
    match is_inside.iter().filter(|inside| **inside).count() {
        0 => [(region.share(at) >= HALF).then_some(corner), None],
        1 => {
            let k = is_inside.iter().position(|inside| *inside).unwrap_or(0);
            let [i, j] = next(k);
            [Some([corner[k], end(k, i), end(k, j)]), None]
        }
        2 => {
            let k = is_inside.iter().position(|inside| !*inside).unwrap_or(0);
            let [i, j] = next(k);
            [Some([corner[i], corner[j], end(j, k)]), Some([corner[i], end(j, k), end(i, k)])]
        }
        _ => [Some(corner), None],
    }
}

/// How far from a place inside to one outside the region reaches, as a share of the way.
fn end_of(region: &Region, inside: DVec3, outside: DVec3) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        *(if region.contains(inside.lerp(outside, middle)) { &mut low } else { &mut high }) = middle;
    }
    low
}

impl Model {
    /// The painted region, with the tree of its dabs: built once while it stays the same.
    pub(super) fn painted_region(&self) -> Arc<Region> {
        let dabs = self.session.region();
        self.best.mask.region(dabs).cloned().unwrap_or_else(|| Arc::new(Region::of_dabs(dabs.to_vec())))
    }

    /// Computes the mask anew if region or source have changed.
    pub(super) fn follow_region(&mut self) {
        let region = self.session.region();
        if region.is_empty() {
            self.best.mask = Mask::default();
            return;
        }
        let Some(side) = self.prepared(Side::Source) else { return };
        if self.best.mask.side.as_ptr() != Arc::as_ptr(side) || self.best.mask.region(region).is_none() {
            self.best.mask = Mask::new(side, self.painted_region());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The share of a triangle of legs 1 that its parts cover, where dabs of these middles and radius are painted.
    fn covered(middles: &[DVec3], radius: f64) -> f64 {
        let region = Region::of_dabs(middles.iter().map(|&middle| Dab { middle, radius }).collect());
        let at = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let parts = parts_of(at, at.map(|place| region.contains(place)), &region);
        parts.into_iter().flatten().map(|[a, b, c]| a.dot(b.cross(c))).sum()
    }

    #[test]
    fn triangles_are_cut_where_the_region_ends() {
        let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-3, "{found}, not {expected}");
        near(covered(&[DVec3::ZERO], 0.5), 0.25);
        near(covered(&[DVec3::X, DVec3::Y], 0.5), 1.0 - 0.25);
        near(covered(&[DVec3::ZERO], 2.0), 1.0);
        near(covered(&[DVec3::splat(0.3)], 0.01), 0.0);
        near(covered(&[DVec3::new(0.33, 0.33, 0.0)], 0.4), 1.0);
    }
}
