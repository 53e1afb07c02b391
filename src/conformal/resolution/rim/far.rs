//! Parts of a boundary that are far from both points, with measures from anchors inside of them.

use super::{Omega, Rim};
use crate::conformal::HarmonicMeasure;
use crate::outline::BoundarySamples;

/// A part of the boundary that is far from both points, with the measure from an anchor inside of it.
pub struct FarPart<'a> {
    pub rim: Rim<'a>,
    /// The lengths from the main anchor to this one, and to the ends of the part.
    pub anchor: f64,
    ends: [f64; 2],
}

impl<'a> Rim<'a> {
    /// The rim of a domain, with its measures from far anchors and the limits up to which they are used; `None` if the
    /// measure is not that of a kernel.
    pub fn new(
        samples: &'a BoundarySamples,
        measure: &'a HarmonicMeasure,
        far: impl Iterator<Item = (&'a HarmonicMeasure, f64)>,
    ) -> Option<Self> {
        let mut rim = Self::near(samples, measure)?;
        for (measure, limit) in far {
            let far = Self::near(samples, measure)?;
            let anchor = rim.length_to(measure.anchor().edge() as usize);
            let end = |late| anchor + far.length_from(Omega { far: None, late, value: limit });
            let ends = [end(true), end(false)];
            rim.far.push(FarPart { rim: far, anchor, ends });
        }
        Some(rim)
    }

    /// Whether an interval has no measure that can be told from none.
    pub(super) fn is_flat(&self, j: usize) -> bool {
        let vertex = self.measure.vertex_at(j);
        let is_far = |far: &&FarPart<'_>| far.contains(self.lengths[j]) && far.contains(self.lengths[j + 1]);
        let mut far = self.far.iter().filter(is_far).peekable();
        if far.peek().is_none() {
            return self.law.is_flat(self.interval(j));
        }
        far.all(|FarPart { rim, .. }| match rim.measure.knot_of(vertex) {
            // the anchor's own vertex is followed by the first interval
            _ if vertex == rim.measure.vertex_at(0) => rim.is_flat(0),
            knot => rim.is_flat(knot),
        })
    }

    /// The far part that contains the length `s` from the anchor: that of the nearest far anchor.
    pub(super) fn far_at(&self, s: f64) -> Option<usize> {
        let near = (0..self.far.len()).filter(|&k| self.far[k].contains(s));
        let omega = |k: usize| self.far[k].rim.near_at((s - self.far[k].anchor).rem_euclid(self.length())).value;
        near.min_by(|&a, &b| omega(a).total_cmp(&omega(b)))
    }
}

impl FarPart<'_> {
    fn contains(&self, s: f64) -> bool {
        s >= self.ends[0] && s <= self.ends[1]
    }
}
