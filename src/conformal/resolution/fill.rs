//! All vertices of the resolved boundary: those of both sides, and more in between.

use super::grade;
use super::merge::{FINEST, Merged, nearest_lap};
use super::rim::Rim;
use crate::geometry::DVec2;
use crate::outline::BoundaryPoint;

/// Images smaller than this, relative to the extent of the other domain, are not graded any further: the measure, of
/// which 1e-16 is told apart, leaves them too few digits.
const FINEST_IMAGE: f64 = 1e-10;

/// The vertices of the resolved boundary, as points of both sides' samples, and the measure before each.
#[derive(Default)]
pub(super) struct Filled {
    pub places: Vec<BoundaryPoint>,
    pub images: Vec<BoundaryPoint>,
    pub measures: Vec<f64>,
    /// Whether a part of the other domain is cut off after the vertex.
    pub is_cut: Vec<bool>,
}

/// All vertices of the resolved boundary, from the mapped domain's first sample on.
pub(super) fn filled(merged: &Merged, mapped: &Rim<'_>, other: &Rim<'_>) -> Filled {
    let knots = &merged.knots;
    let added = added(merged, mapped, other);
    let first = knots.iter().position(|knot| knot.own == Some(0)).unwrap_or(0);
    let count = other.samples.len();
    let image_at = |image: f64| {
        let edge = image.floor();
        BoundaryPoint::new(((edge as usize + merged.first) % count) as u32, image - edge)
    };
    let mut filled = Filled::default();
    let mut on = (0u32, 0.0);
    for (k, knot) in (first..knots.len()).chain(0..first).map(|k| (k, &knots[k])) {
        on = knot.own.map_or(on, |own| (own, knot.at));
        let place = |at: f64, own: bool| {
            let along = (at - on.1).rem_euclid(merged.length) / mapped.edge(on.0 as usize);
            BoundaryPoint::new(on.0, if own { 0.0 } else { along.clamp(0.0, 1.0 - f64::EPSILON) })
        };
        let length = |at: f64| (at + merged.start).rem_euclid(merged.length);
        let measure = |at: f64| mapped.before(length(at));
        filled.push(place(knot.at, knot.own.is_some()), image_at(knot.image), measure(knot.at), knot.is_cut);
        let next = knots.get(k + 1).map_or(knots[0].image + count as f64, |knot| knot.image);
        let mut before = knot.image;
        for &at in &added[k] {
            let image = other.point(other.length_of(mapped.at(length(at))));
            let passed = ((image.edge() as usize + count - merged.first) % count) as f64 + image.fraction();
            before = nearest_lap(passed, [before, next], count);
            filled.push(place(at, false), image_at(before), measure(at), false);
        }
    }
    filled
}

impl Filled {
    fn push(&mut self, place: BoundaryPoint, image: BoundaryPoint, measure: f64, is_cut: bool) {
        self.is_cut.push(is_cut);
        self.places.push(place);
        self.images.push(image);
        self.measures.push(measure);
    }
}

/// The other domain's boundary through the images, and in the cuts through its samples.
pub(super) fn outline(other: &Rim<'_>, images: &[BoundaryPoint], is_cut: &[bool]) -> Vec<DVec2> {
    let count = other.samples.len();
    let mut outline = Vec::new();
    for (k, &image) in images.iter().enumerate() {
        outline.push(other.position(image));
        if is_cut[k] {
            let next = images[(k + 1) % images.len()];
            // samples strictly between the ends, which are samples themselves
            let passed = (next.edge() as usize + count - image.edge() as usize) % count;
            outline.extend((1..passed).map(|i| other.samples.points()[(image.edge() as usize + i) % count]));
        }
    }
    outline
}

/// The lengths on the mapped boundary, from the start, of the vertices to insert after each knot: so many that neither
/// the edges nor their images grow faster than gradually.
fn added(merged: &Merged, mapped: &Rim<'_>, other: &Rim<'_>) -> Vec<Vec<f64>> {
    let knots = &merged.knots;
    let ends: Vec<f64> = knots.iter().map(|knot| knot.at).collect();
    let own = grade::between(&ends, merged.length, FINEST * mapped.extent(), |k| knots[k].is_cut);
    let first = other.length_to(merged.first);
    let images: Vec<f64> = (knots.iter())
        .map(|knot| {
            let edge = (knot.image.floor() as usize + merged.first) % other.samples.len();
            let at = other.length_to(edge) + knot.image.fract() * other.edge(edge);
            // the images ascend from that of the start
            (at - first).rem_euclid(other.length())
        })
        .collect();
    let there = grade::between(&images, other.length(), FINEST_IMAGE * other.extent(), |k| knots[k].is_cut);
    let back = |at: f64| {
        let place = mapped.length_of(other.at((at + first).rem_euclid(other.length())));
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
