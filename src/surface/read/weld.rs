//! Merges vertices that a program has split: at normals and texture seams, or for each face.
//!
//! Vertices at exactly the same position are merged if the surface is a disk then. Else, if it is a disk as it is, it stays:
//! what looks like a seam is a cut. In both cases vertices of its boundary within a billionth of its size are merged too, if it
//! stays a disk: they are the sides of a slit. Else vertices within that distance are merged if that makes it a disk. Where
//! nothing does, those at the same position are merged in formats that repeat them for each face, and in others if the
//! surface has fewer parts or loops then.
//!
//! Triangles whose corners are merged keep their numbers; [`SurfaceMesh::new`](crate::surface::SurfaceMesh::new) leaves them out.

use crate::geometry::DVec3;
use crate::surface::edges::EdgeTable;
use crate::surface::survey::{Connectivity, components, connectivity, repeats};
use crate::surface::{Surface, SurfaceNote};
use std::collections::HashMap;

/// Vertices within this part of the surface's extent may be one vertex.
const NEAR: f64 = 1e-9;

/// The surface with what its program has split merged, and a note; `repeats` says whether the format repeats a vertex for each
/// face. Cost O(n log d), n triangles with up to d at a vertex.
pub(super) fn welded(surface: Surface, repeats: bool) -> Surface {
    let exact = merged(&surface, 0.0, None);
    let found = exact.as_ref().and_then(disk);
    let exact = match (exact, found) {
        (Some(exact), Some(found)) => return healed(&exact, &found).unwrap_or(exact),
        (exact, _) => exact,
    };
    if let Some(found) = disk(&surface) {
        return match (healed(&surface, &found), exact) {
            (Some(healed), _) => healed,
            (None, Some(exact)) => left_apart(surface, exact.vertices.len()),
            (None, None) => surface,
        };
    }
    let most = collapsed(exact.as_ref().unwrap_or(&surface));
    let near = merged(&surface, NEAR * extent(&surface), None);
    if let Some(near) = near.filter(|near| collapsed(near) <= most && disk(near).is_some()) {
        return near;
    }
    match exact {
        Some(exact) if repeats || parts(&exact) < parts(&surface) => exact,
        _ => surface,
    }
}

/// A disk with this connectivity whose boundary's vertices are merged where they are near each other; `None` if that changes
/// nothing, leaves no disk, or takes a triangle's area.
fn healed(surface: &Surface, found: &Connectivity) -> Option<Surface> {
    let mut is_open = vec![false; surface.vertices.len()];
    found.loops.iter().flatten().for_each(|&vertex| is_open[vertex as usize] = true);
    let near = merged(surface, NEAR * extent(surface), Some(&is_open))?;
    (collapsed(&near) <= collapsed(surface) && disk(&near).is_some()).then_some(near)
}

/// The surface with a note that so many places are left of its vertices.
fn left_apart(mut surface: Surface, places: usize) -> Surface {
    surface.notes.push(SurfaceNote::LeftApart { vertices: surface.vertices.len() - places });
    surface
}

/// The connectivity of the surface without triangles that name a vertex twice, if that is a disk. Its vertices keep their numbers.
fn disk(surface: &Surface) -> Option<Connectivity> {
    let of_disk = |surface: &Surface| connectivity(surface).ok().filter(|found| found.check_disk(surface).is_ok());
    if collapsed(surface) == 0 {
        return of_disk(surface);
    }
    let triangles = surface.triangles.iter().copied().filter(|corners| !repeats(corners)).collect();
    of_disk(&Surface::new(surface.vertices.clone(), triangles))
}

/// The number of triangles that name a vertex twice.
fn collapsed(surface: &Surface) -> usize {
    surface.triangles.iter().filter(|corners| repeats(corners)).count()
}

/// The numbers of components and of boundary loops; largest where they cannot be counted. Faults of single triangles leave the
/// components; where an edge has more than two triangles, merging has joined what does not belong together.
fn parts(surface: &Surface) -> (usize, usize) {
    if let Ok(found) = connectivity(surface) {
        return (found.sizes.len(), found.loops.len());
    }
    let triangles: Vec<_> = surface.triangles.iter().copied().filter(|corners| !repeats(corners)).collect();
    let edges = EdgeTable::new(&triangles, surface.vertices.len());
    let is_crowded = edges.edges().any(|edge| edge.len() > 2);
    (if is_crowded { usize::MAX } else { components(&edges, triangles.len()).1.len() }, usize::MAX)
}

/// The larger side of the box around the vertices of triangles; 0 if an index is out of range.
fn extent(surface: &Surface) -> f64 {
    let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let corners = surface.triangles.as_flattened().iter();
    let places = corners.filter_map(|&v| surface.vertices.get(v as usize)).filter(|p| p.is_finite());
    let (low, high) = places.fold(ends, |(low, high), &p| (low.min(p), high.max(p)));
    (high - low).max_element().max(0.0)
}

/// The surface with vertices of triangles within `distance` of an earlier one merged into it, if given only those `among` them;
/// `None` if there are none. They keep the order of their first occurrence. Cost O(n).
fn merged(surface: &Surface, distance: f64, among: Option<&[bool]>) -> Option<Surface> {
    let before = surface.vertices.len();
    let mut is_corner = vec![false; before];
    for &vertex in surface.triangles.as_flattened() {
        *is_corner.get_mut(vertex as usize)? = among.is_none_or(|among| among.get(vertex as usize) == Some(&true));
    }
    let mut known = Places { distance, cells: HashMap::new(), met: Vec::with_capacity(before) };
    // places that are no numbers are near to none
    let number = |(&point, &is_corner): (&DVec3, &bool)| {
        if is_corner && point.is_finite() { known.number(point) } else { known.add(point) }
    };
    let numbers: Vec<u32> = surface.vertices.iter().zip(&is_corner).map(number).collect();
    let places = known.met;
    if places.len() == before {
        return None;
    }
    let mut notes = surface.notes.clone();
    notes.retain(|note| !matches!(note, SurfaceNote::Welded { .. }));
    notes.push(SurfaceNote::Welded { before: surface.count_in_file(), after: places.len() });
    let triangles = surface.triangles.iter().map(|corners| corners.map(|v| numbers[v as usize])).collect();
    let in_file = (0..surface.count_in_file() as u32).filter_map(|number| surface.vertex_in_file(number));
    let merged = in_file.map(|vertex| numbers[vertex as usize]).collect();
    Some(Surface { vertices: places, triangles, notes, merged: Some(merged) })
}

/// Places that were met, by cells.
struct Places {
    distance: f64,
    cells: HashMap<[u64; 3], Vec<u32>>,
    met: Vec<DVec3>,
}

impl Places {
    /// The number of the place at a point, or of a new one.
    fn number(&mut self, point: DVec3) -> u32 {
        let near = self.cells_near(point).into_iter().filter_map(|cell| self.cells.get(&cell)).flatten();
        let known = near.copied().find(|&k| self.met[k as usize].distance(point) <= self.distance);
        known.unwrap_or_else(|| {
            let number = self.add(point);
            self.cells.entry(self.cell(point)).or_default().push(number);
            number
        })
    }

    /// The number of a new place, into which no other is merged.
    fn add(&mut self, point: DVec3) -> u32 {
        self.met.push(point);
        self.met.len() as u32 - 1
    }

    /// The cell of a point: four distances wide, or the point alone.
    fn cell(&self, point: DVec3) -> [u64; 3] {
        let cell = if self.distance > 0.0 { (point / (4.0 * self.distance)).floor() } else { point };
        // −0 and 0 are the same
        (cell + DVec3::ZERO).to_array().map(f64::to_bits)
    }

    /// The cells that the box around a point reaches, each once.
    fn cells_near(&self, point: DVec3) -> Vec<[u64; 3]> {
        if self.distance <= 0.0 {
            return vec![self.cell(point)];
        }
        let [low, high] = [-self.distance, self.distance].map(|by| self.cell(point + DVec3::splat(by)));
        let mut cells: Vec<[u64; 3]> = (0..8_u32)
            .map(|corner| std::array::from_fn(|axis| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] }))
            .collect();
        cells.sort_unstable();
        cells.dedup();
        cells
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::surface::{RepairNote, SurfaceMesh, SurfacePreset};

    fn hemisphere() -> Surface {
        SurfacePreset::Hemisphere.surface(40).unwrap()
    }

    /// Every triangle with corners of its own, moved by up to `off`.
    fn soup(surface: &Surface, off: f64) -> Surface {
        let corners = surface.triangles.as_flattened().iter().enumerate();
        let moved = |(k, &v): (usize, &u32)| {
            surface.vertices[v as usize] + off * DVec3::new((k % 3) as f64 - 1.0, (k % 5) as f64 - 2.0, 0.0) / 3.0
        };
        let triangles = (0..surface.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        Surface::new(corners.map(moved).collect(), triangles)
    }

    #[test]
    fn soup_is_a_disk_again_exactly_or_nearly() {
        let whole = hemisphere();
        for off in [0.0, 1e-10, 3e-10] {
            let joined = welded(soup(&whole, off), false);
            assert!(SurfaceMesh::new(&joined).is_ok(), "{off:e}: {:?}", joined.notes);
            assert_eq!(joined.vertices.len(), whole.vertices.len(), "{off:e}");
            let before = 3 * whole.triangles.len();
            assert_eq!(joined.notes, [SurfaceNote::Welded { before, after: whole.vertices.len() }]);
        }
        let apart = welded(soup(&whole, 1e-7), false);
        assert_eq!(apart.vertices.len(), 3 * whole.triangles.len(), "too far apart");
    }

    /// A closed surface that is cut open along a path stays open, and says so.
    #[test]
    fn a_cut_that_makes_a_disk_stays() {
        // a tetrahedron cut along two edges from vertex 0: vertices 0 and 4 are at the same place
        let places = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]];
        let places = places.map(DVec3::from_array).to_vec();
        let cut = Surface::new(places, vec![[0, 2, 1], [0, 3, 2], [1, 2, 3], [4, 1, 3]]);
        assert!(disk(&cut).is_some() && disk(&merged(&cut, 0.0, None).unwrap()).is_none());
        for repeats in [false, true] {
            let kept = welded(cut.clone(), repeats);
            assert_eq!((kept.vertices.len(), &*kept.notes), (5, &[SurfaceNote::LeftApart { vertices: 1 }][..]));
        }
    }

    /// A cap of 9 columns and 3 rings as programs make it: the last column repeats the first one up to `noise`, and the pole is a
    /// row of vertices if `poles`, with faces that have no area there.
    fn cap(noise: f64, poles: bool) -> Surface {
        let place = |ring: u32, column: u32| {
            let angle = f64::from(column % 9) / 9.0 * std::f64::consts::TAU;
            let off = if column == 9 && ring > 0 { noise } else { 0.0 };
            let radius = f64::from(ring) / 3.0;
            DVec3::new(radius * angle.cos(), radius * angle.sin() - off, radius * radius)
        };
        let vertices = (0..4).flat_map(|ring| (0..10).map(move |column| place(ring, column))).collect();
        let number = |ring: u32, column: u32| if ring == 0 && !poles { 0 } else { 10 * ring + column };
        let quad = |(ring, column): (u32, u32)| {
            let [a, b] = [0, 1].map(|next| number(ring, column + next));
            let [c, d] = [1, 0].map(|next| number(ring + 1, column + next));
            [[a, c, b], [a, d, c]]
        };
        let cells = (0..3).flat_map(|ring| (0..9).map(move |column| (ring, column)));
        let triangles = cells.flat_map(quad).filter(|corners| poles || !repeats(corners)).collect();
        Surface::new(vertices, triangles)
    }

    #[test]
    fn a_seam_up_to_rounding_and_a_pole_of_many_vertices_are_healed() {
        for (noise, poles) in [(0.0, false), (2e-16, false), (1e-10, false), (0.0, true), (2e-16, true)] {
            let surface = welded(cap(noise, poles), false);
            let mesh = SurfaceMesh::new(&surface).unwrap_or_else(|error| panic!("{noise:e}, {poles}: {error}"));
            let counts = (mesh.mesh().boundary_count(), mesh.mesh().vertices().len(), mesh.mesh().triangles().len());
            assert_eq!(counts, (9, 28, 45), "{noise:e}, {poles}");
            let dropped = RepairNote::DroppedTriangles { count: 9 };
            assert_eq!(mesh.repairs().contains(&dropped), poles, "{:?}", mesh.repairs());
            // every vertex of the file is the one at its place
            let at = |number: u32| surface.vertices[surface.vertex_in_file(number).unwrap() as usize];
            assert!((0..40).all(|k| at(k).distance(cap(noise, poles).vertices[k as usize]) <= noise));
        }
        let open = welded(cap(1e-6, false), false);
        assert_eq!(SurfaceMesh::new(&open).unwrap().mesh().boundary_count(), 9 + 6, "a wide slit stays");
    }

    #[test]
    fn what_is_no_disk_either_way_is_merged_where_that_joins_parts() {
        let whole = hemisphere();
        let twice = Surface::new(
            [&*whole.vertices, &[DVec3::new(9.0, 0.0, 0.0), DVec3::new(9.0, 1.0, 0.0), DVec3::new(9.0, 0.0, 1.0)]]
                .concat(),
            [&*whole.triangles, &[[0, 1, 2].map(|k| k + whole.vertices.len() as u32)]].concat(),
        );
        assert_eq!(welded(twice.clone(), false), twice, "nothing is split");
        let joined = welded(soup(&twice, 0.0), false);
        assert_eq!(joined.vertices.len(), twice.vertices.len());
        // with a triangle without area, which a repair drops
        let mut flat = soup(&whole, 0.0);
        let last = flat.vertices.len() as u32;
        flat.vertices.extend([flat.vertices[0], flat.vertices[1], flat.vertices[0]]);
        flat.triangles.push([last, last + 1, last + 2]);
        let joined = welded(flat, false);
        assert_eq!(joined.vertices.len(), whole.vertices.len());
        assert_eq!(SurfaceMesh::repaired(&joined).unwrap().mesh().triangles().len(), whole.triangles.len());
    }
}
