//! Filling a hole whose loop is a simple polygon when seen along its normal: the constrained Delaunay triangulation of that
//! polygon, lifted back to the loop's vertices.
//!
//! Guaranteed: seen along the normal, triangles neither overlap nor lie upside down, for a loop of any shape and length;
//! none is flat; none has an edge that the surface has already: such a chord is divided at its middle. Cost O(n log n).

use super::survey::is_flat;
use crate::geometry::{DVec2, DVec3};
use crate::mesh::polygon_triangles;

/// Coordinates below this share of the loop's extent are 0: the triangulation takes no smaller ones.
const TINY: f64 = 1e-30;

/// The triangles of a filling.
pub(super) struct Filling {
    /// Numbers of the loop's vertices, then of [`Self::added`]; against the direction of the loop.
    pub triangles: Vec<[usize; 3]>,
    /// Vertices on chords.
    pub added: Vec<DVec3>,
}

/// The filling of a closed chain whose area vector is `-normal`; `is_edge` says which pairs of its vertices the surface joins.
/// `None` if the chain is not simple when seen along `normal`, or a triangle is flat.
pub(super) fn flat_filling(places: &[DVec3], normal: DVec3, is_edge: &dyn Fn(usize, usize) -> bool) -> Option<Filling> {
    let n = places.len();
    // against the direction of the chain the polygon is counter-clockwise
    let outline = seen_along(places, normal)?;
    let reversed: Vec<DVec2> = outline.into_iter().rev().collect();
    let triangles = polygon_triangles(&reversed).ok().filter(|triangles| triangles.len() + 2 == n)?;
    let triangles = triangles.into_iter().map(|corners| corners.map(|k| n - 1 - k as usize));
    let mut filling = Filling { triangles: triangles.collect(), added: Vec::new() };
    filling.divide_chords(places, is_edge);
    let place = |k: usize| places.get(k).or_else(|| filling.added.get(k - n)).copied();
    let is_sound = |corners: &[usize; 3]| match corners.map(place) {
        [Some(a), Some(b), Some(c)] => !is_flat([a, b, c]),
        _ => false,
    };
    filling.triangles.iter().all(is_sound).then_some(filling)
}

/// The chain in a plane across `normal`, in units of its extent; `None` without a normal.
fn seen_along(places: &[DVec3], normal: DVec3) -> Option<Vec<DVec2>> {
    let (x, y) = normal.try_normalize()?.any_orthonormal_pair();
    // so that x, y, normal are right-handed
    let (x, y) = if x.cross(y).dot(normal) > 0.0 { (x, y) } else { (y, x) };
    let middle = places.iter().sum::<DVec3>() / places.len() as f64;
    let extent = places.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
    let flushed = |s: f64| if s.abs() < TINY { 0.0 } else { s };
    let project = |p: &DVec3| {
        let offset = (*p - middle) / extent;
        DVec2::new(flushed(offset.dot(x)), flushed(offset.dot(y)))
    };
    (extent > 0.0).then(|| places.iter().map(project).collect())
}

impl Filling {
    /// Divides at their middles the chords that are edges of the surface.
    fn divide_chords(&mut self, places: &[DVec3], is_edge: &dyn Fn(usize, usize) -> bool) {
        let n = places.len();
        let is_chord = |i: usize, j: usize| (i + 1) % n != j && (j + 1) % n != i;
        let of_triangle = |t: &[usize; 3]| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]];
        let chords: Vec<[usize; 2]> = self.triangles.iter().flat_map(of_triangle).collect();
        // each chord has two triangles, which traverse it both ways
        for [i, j] in chords.into_iter().filter(|&[i, j]| i < j && is_chord(i, j) && is_edge(i, j)) {
            let middle = n + self.added.len();
            self.added.push(places[i].midpoint(places[j]));
            for t in 0..self.triangles.len() {
                let corners = self.triangles[t];
                if let Some(k) = (0..3)
                    .find(|&k| corners[k] != i && corners[k] != j)
                    .filter(|_| corners.contains(&i) && corners.contains(&j))
                {
                    let [apex, from, to] = [0, 1, 2].map(|step| corners[(k + step) % 3]);
                    self.triangles[t] = [apex, from, middle];
                    self.triangles.push([apex, middle, to]);
                }
            }
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn a_chord_that_the_surface_has_already_is_divided() {
        // a square of four vertices and a fifth one in a notch, whose Delaunay triangulation has the chord from 1 to 4
        let places = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.5], [0.0, 2.0]].map(|[x, y]| DVec3::new(x, -y, 0.0));
        let free = flat_filling(&places, DVec3::Z, &|_, _| false).unwrap();
        assert_eq!((free.triangles.len(), free.added.len()), (3, 0));
        let chord = (1, 3);
        let filling = flat_filling(&places, DVec3::Z, &|i, j| (i.min(j), i.max(j)) == chord).unwrap();
        assert_eq!((filling.triangles.len(), filling.added.len()), (5, 1));
        assert!(!filling.triangles.iter().any(|t| t.contains(&1) && t.contains(&3)), "{:?}", filling.triangles);
        let place = |k: usize| if k < 5 { places[k] } else { filling.added[k - 5] };
        let area = |[a, b, c]: [DVec3; 3]| 0.5 * (b - a).cross(c - a).z;
        let area: f64 = filling.triangles.iter().map(|t| area(t.map(place))).sum();
        assert!((area - 2.5).abs() < 1e-12, "{area}");
    }

    #[test]
    fn a_chain_that_crosses_itself_has_no_filling() {
        let places = [[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        assert!(flat_filling(&places, DVec3::Z, &|_, _| false).is_none());
    }
}
