//! What is written in the place of each face of a file.

use super::Numbers;
use crate::export::Flattened;
use crate::geometry::{DVec2, DVec3};
use crate::surface::{Surface, distinct, repeats};
use std::collections::BTreeMap;

/// What is written in the place of a face. Vertices have their numbers in the file, counted from 0.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Written {
    /// None of it is in the flattened surface.
    LeftOut,
    /// The face with these vertices at its corners, in its order; turned round if `is_turned`.
    Whole {
        /// One vertex for each corner of the face.
        corners: Vec<u32>,
        /// Whether a repair has reversed it.
        is_turned: bool,
    },
    /// Triangles in its place.
    Parts(Vec<[u32; 3]>),
}

/// The flattened triangles by the triangles of the surface from which they come.
pub(super) struct Faces<'a> {
    surface: &'a Surface,
    flattened: &'a Flattened,
    numbers: &'a Numbers<'a>,
    /// The flattened triangles, grouped by origin.
    order: Vec<u32>,
    /// Where the group of each triangle of the surface begins in `order`, and where the last one ends.
    starts: Vec<u32>,
    /// The triangles of the faces so far.
    passed: usize,
}

/// The vertices of a flattened triangle at the corners of the one from which it comes.
struct Same {
    corners: [u32; 3],
    is_turned: bool,
}

impl<'a> Faces<'a> {
    /// Cost O(triangles).
    pub(super) fn new(surface: &'a Surface, flattened: &'a Flattened, numbers: &'a Numbers<'a>) -> Self {
        let mut starts = vec![0; surface.triangles().len() + 1];
        flattened.origins().iter().for_each(|&origin| starts[origin as usize + 1] += 1);
        (1..starts.len()).for_each(|k| starts[k] += starts[k - 1]);
        let mut order: Vec<u32> = (0..flattened.triangles().len() as u32).collect();
        order.sort_by_key(|&k| flattened.origins()[k as usize]);
        Self { surface, flattened, numbers, order, starts, passed: 0 }
    }

    /// The texture coordinates of the file's vertices, then of the added ones; `None` for those left out.
    pub(super) fn coordinates(&self) -> Vec<Option<DVec2>> {
        let mut own = self.flattened.coordinates().to_vec();
        // a repair merges vertices at one place, which then have the same coordinates
        for t in 0..self.surface.triangles().len() {
            let Some(Same { corners, .. }) = self.same(t) else { continue };
            for (&given, vertex) in self.surface.triangles()[t].iter().zip(corners) {
                own[given as usize] = own[given as usize].or(own[vertex as usize]);
            }
        }
        self.numbers.spread(&own)
    }

    /// What is written in the place of the next face; `corners` are its vertices in the file. `None` if the surface has
    /// no such face.
    pub(super) fn next(&mut self, corners: &[u32]) -> Option<Written> {
        // as the reader counts: a quad that names a corner twice in a row is a triangle
        let different = if corners.len() > 3 { distinct(corners).len() } else { corners.len() };
        let Some(count) = different.checked_sub(2).filter(|&count| count > 0) else {
            return Some(Written::LeftOut);
        };
        let triangles = self.passed..self.passed + count;
        self.passed = triangles.end;
        if triangles.end >= self.starts.len() {
            return None;
        }
        let parts = &self.order[self.starts[triangles.start] as usize..self.starts[triangles.end] as usize];
        if parts.is_empty() {
            return Some(Written::LeftOut);
        }
        let whole = self.whole(corners, triangles);
        let part = |&k: &u32| self.flattened.triangles()[k as usize].map(|v| self.numbers.of(v));
        Some(whole.unwrap_or_else(|| Written::Parts(parts.iter().map(part).collect())))
    }

    /// Whether all faces of the surface were passed.
    pub(super) fn is_complete(&self) -> bool {
        self.passed + 1 == self.starts.len()
    }

    /// The face of these triangles, if none of them was changed.
    fn whole(&self, corners: &[u32], triangles: std::ops::Range<usize>) -> Option<Written> {
        let (mut vertices, mut turned) = (BTreeMap::new(), None);
        // the others have no area: corners of the face were merged
        for t in triangles.filter(|&t| !repeats(&self.surface.triangles()[t])) {
            let same = self.same(t)?;
            if *turned.get_or_insert(same.is_turned) != same.is_turned {
                return None;
            }
            for (&given, vertex) in self.surface.triangles()[t].iter().zip(same.corners) {
                if *vertices.entry(given).or_insert(vertex) != vertex {
                    return None;
                }
            }
        }
        let at = |&number: &u32| {
            let vertex = *vertices.get(&self.surface.vertex_in_file(number)?)?;
            Some(if self.numbers.is_added(vertex) { self.numbers.of(vertex) } else { number })
        };
        let corners = corners.iter().map(at).collect::<Option<_>>()?;
        Some(Written::Whole { corners, is_turned: turned? })
    }

    /// The flattened triangle that is triangle `t` of the surface, with its corners at the same places.
    fn same(&self, t: usize) -> Option<Same> {
        let &[k] = &self.order[self.starts[t] as usize..self.starts[t + 1] as usize] else { return None };
        let place = |v: u32| self.flattened.vertices()[v as usize];
        let given: [DVec3; 3] = self.surface.triangles()[t].map(|v| self.surface.vertices()[v as usize]);
        let [a, b, c] = self.flattened.triangles()[k as usize];
        let turns = [[a, b, c], [b, c, a], [c, a, b], [a, c, b], [c, b, a], [b, a, c]];
        let found = turns.iter().position(|corners| corners.map(place) == given)?;
        Some(Same { corners: turns[found], is_turned: found >= 3 })
    }
}
