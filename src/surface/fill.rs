//! Filling holes: a fan around a new vertex in the middle of the loop; a loop of three becomes a triangle.

use super::repair::{ADDED, RepairNote, Repaired};
use super::survey::report;
use crate::geometry::DVec3;

/// Fills all `loops` but the first one. The new triangles come last.
pub(super) fn fill_holes(repaired: &mut Repaired, loops: &[Vec<u32>]) {
    let Some(holes) = loops.get(1..).filter(|holes| !holes.is_empty()) else { return };
    let reports = holes.iter().map(|hole| report(&repaired.surface, hole)).collect();
    let before = repaired.surface.triangles.len();
    for hole in holes {
        fill(repaired, hole);
    }
    let triangles = repaired.surface.triangles.len() - before;
    repaired.triangle_origins.resize(before + triangles, ADDED);
    repaired.notes.push(RepairNote::FilledHoles { holes: reports, triangles });
}

/// Fills one hole. The loop has the direction of its triangles, so the new triangles traverse it backwards.
fn fill(repaired: &mut Repaired, hole: &[u32]) {
    let surface = &mut repaired.surface;
    if let &[a, b, c] = hole {
        surface.triangles.push([c, b, a]);
        return;
    }
    let sum: DVec3 = hole.iter().map(|&v| surface.vertices[v as usize]).sum();
    let middle = surface.vertices.len() as u32;
    surface.vertices.push(sum / hole.len() as f64);
    repaired.vertex_origins.push(ADDED);
    let next = hole.iter().cycle().skip(1);
    surface.triangles.extend(hole.iter().zip(next).map(|(&u, &v)| [v, u, middle]));
}
