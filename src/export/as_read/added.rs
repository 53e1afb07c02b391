//! The vertices of a flattened surface that are not of its file, and the vertices from whose properties theirs follow.

use super::Numbers;
use crate::export::{Division, Flattened};
use crate::geometry::DVec3;
use crate::surface::Surface;
use std::collections::HashMap;

/// An added vertex.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct AddedVertex {
    place: DVec3,
    /// Vertices of the file with their weights, which add up to 1.
    weights: Vec<(u32, f64)>,
}

/// All added vertices in order: copies that a repair has made, then those that divide edges and triangles.
pub(super) struct Added(Vec<AddedVertex>);

impl Added {
    pub(super) fn new(flattened: &Flattened, surface: &Surface, numbers: &Numbers<'_>) -> Self {
        let given = surface.vertices().len();
        let copies = given..flattened.vertices().len() - flattened.divisions().len();
        let mut at = HashMap::new();
        if !copies.is_empty() {
            let bits = |place: &DVec3| place.to_array().map(f64::to_bits);
            (0..).zip(surface.vertices()).for_each(|(v, place)| _ = at.entry(bits(place)).or_insert(v));
        }
        // a copy is at exactly the place of a vertex
        let original = |vertex: u32| {
            let place = flattened.vertices()[vertex as usize].to_array().map(f64::to_bits);
            let known = if numbers.is_added(vertex) { at.get(&place).copied() } else { Some(vertex) };
            // one that is not known is none, of which nothing is written
            known.map_or(u32::MAX, |vertex| numbers.of(vertex))
        };
        let copied = copies.map(|vertex| vec![(original(vertex as u32), 1.0)]);
        let divided = flattened.divisions().iter().map(|division| match *division {
            Division::Edge([a, b], fraction) => vec![(original(a), 1.0 - fraction), (original(b), fraction)],
            Division::Triangle(t) => surface.triangles()[t as usize].map(|v| (numbers.of(v), 1.0 / 3.0)).to_vec(),
        });
        let weights: Vec<Vec<(u32, f64)>> = copied.chain(divided).collect();
        let vertices = flattened.vertices()[given..].iter().zip(weights);
        Self(vertices.map(|(&place, weights)| AddedVertex { place, weights }).collect())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn get(&self, k: usize) -> Option<&AddedVertex> {
        self.0.get(k)
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &AddedVertex> {
        self.0.iter()
    }
}

impl AddedVertex {
    pub(super) fn place(&self) -> DVec3 {
        self.place
    }

    /// The vertices of the file whose mean it is, with their weights.
    pub(super) fn weights(&self) -> &[(u32, f64)] {
        &self.weights
    }

    /// The vertex of the file with the largest weight.
    pub(super) fn nearest(&self) -> Option<u32> {
        self.weights.iter().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(vertex, _)| *vertex)
    }

    /// The `rows` of the file's vertices that it is the mean of, with their weights; `None` if one is missing.
    pub(super) fn weighted<'a, T>(&self, rows: &'a [T]) -> Option<Vec<(&'a T, f64)>> {
        self.weights.iter().map(|&(vertex, weight)| Some((rows.get(vertex as usize)?, weight))).collect()
    }
}
