//! Merges vertices at exactly the same position.

use crate::geometry::DVec3;
use crate::surface::{Surface, SurfaceNote};
use std::collections::HashMap;

/// Merges the vertices, which keep the order of their first occurrence. Cost O(n).
pub(super) fn weld(surface: &mut Surface) {
    let before = surface.vertices.len();
    let mut known: HashMap<[u64; 3], u32> = HashMap::with_capacity(before / 4);
    let mut places: Vec<DVec3> = Vec::new();
    let mut number = Vec::with_capacity(before);
    for &point in &surface.vertices {
        // −0 and 0 are the same position
        let key = (point + DVec3::ZERO).to_array().map(f64::to_bits);
        let vertex = *known.entry(key).or_insert_with(|| {
            places.push(point);
            places.len() as u32 - 1
        });
        number.push(vertex);
    }
    if places.len() == before {
        return;
    }
    surface.notes.push(SurfaceNote::Welded { before, after: places.len() });
    surface.vertices = places;
    for corner in surface.triangles.as_flattened_mut() {
        *corner = number[*corner as usize];
    }
}
