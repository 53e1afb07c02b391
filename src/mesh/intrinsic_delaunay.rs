//! Intrinsic Delaunay triangulation by edge flips (Fisher, Springborn, Schröder, Bobenko 2007).
//!
//! An inner edge whose opposite cotangents sum to less than 0 is flipped: its two triangles are laid
//! out in the plane, and the other diagonal replaces the edge. The surface stays the same, and
//! its Dirichlet energy falls with each flip (Rippa 1990), so that the flips terminate. Afterwards
//! all cotangent weights are non-negative, for any shape of the given triangles.

use super::intrinsic::{IntrinsicMesh, NO_TWIN};

/// A negative weight is taken as rounding if it is smaller than this, relative to the terms whose
/// difference a cotangent is: the squares of a grid reach 1e-16, edges that visibly need a flip 1e-3.
const ROUNDING: f64 = 1e-12;

/// Usually there are few flips per edge: 0.1 on scanned meshes, 2 on grids sheared by 7. This many are a failure.
const MOST_FLIPS_PER_EDGE: usize = 100;

/// The result of the flips.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct FlipReport {
    /// The number of edges flipped.
    pub flips: usize,
    /// The number of inner edges with a negative cotangent weight before the flips.
    pub negative_before: usize,
    /// The same number after the flips: 0 unless triangles are too flat to determine their angles.
    pub negative_after: usize,
}

impl IntrinsicMesh {
    /// The number of inner edges with a negative cotangent weight (beyond rounding). Cost O(n).
    pub fn negative_weights(&self) -> usize {
        let first = |&(t, i): &(usize, usize)| self.across(t, i).is_some_and(|other| (t, i) < other);
        let edges = (0..self.triangles.len()).flat_map(|t| (0..3).map(move |i| (t, i)));
        edges.filter(first).filter(|&(t, i)| self.is_negative(t, i)).count()
    }

    fn is_negative(&self, t: usize, i: usize) -> bool {
        self.weight(t, i).is_some_and(|(sum, scale)| sum < -ROUNDING * scale)
    }

    /// Flips edges until none has a negative weight. Cost O(flips + n).
    pub fn make_delaunay(&mut self) -> FlipReport {
        let halves = 3 * self.triangles.len();
        let mut pending: Vec<u32> = (0..halves as u32).collect();
        let mut queued = vec![true; halves];
        let mut report = FlipReport { negative_before: self.negative_weights(), ..FlipReport::default() };
        while let Some(half) = pending.pop() {
            queued[half as usize] = false;
            let (t, i) = (half as usize / 3, half as usize % 3);
            if !self.is_negative(t, i) {
                continue;
            }
            let Some(touched) = self.flip(t, i) else { continue };
            report.flips += 1;
            if report.flips > MOST_FLIPS_PER_EDGE * halves {
                break;
            }
            for half in touched {
                if !std::mem::replace(&mut queued[half as usize], true) {
                    pending.push(half);
                }
            }
        }
        report.negative_after = self.negative_weights();
        self.delaunay = report.negative_after == 0;
        report
    }

    /// Replaces the edge (x, y) between t = (p, x, y) and o = (q, y, x) by (p, q): t becomes (p, x, q),
    /// o becomes (p, q, y). Returns the four outer half-edges; `None`, with nothing changed, if
    /// both sides are one triangle or a new triangle would have no area.
    fn flip(&mut self, t: usize, i: usize) -> Option<[u32; 4]> {
        let (o, j) = self.across(t, i).filter(|&(o, _)| o != t)?;
        let around = [(o, (j + 1) % 3), (t, (i + 2) % 3), (o, (j + 2) % 3), (t, (i + 1) % 3)];
        let [xq, px, qy, yp] = around.map(|(t, i)| self.lengths[t][i]);
        let diagonal = self.diagonal(t, i, o, [xq, px, qy, yp])?;
        let corner = |t: usize, k: usize| self.triangles[t][k % 3];
        let ([p, x, y], q) = ([corner(t, i), corner(t, i + 1), corner(t, i + 2)], corner(o, j));
        (self.triangles[t], self.triangles[o]) = ([p, x, q], [p, q, y]);
        (self.lengths[t], self.lengths[o]) = ([xq, diagonal.length, px], [qy, yp, diagonal.length]);
        (self.double_areas[t], self.double_areas[o]) = (diagonal.double_areas[0], diagonal.double_areas[1]);
        let (a, b) = (3 * t as u32, 3 * o as u32);
        let places = [a, a + 2, b, b + 1];
        self.glue(around.map(|(t, i)| (3 * t + i) as u32), places);
        self.twins[t][1] = b + 2;
        self.twins[o][2] = a + 1;
        Some(places)
    }

    /// Moves four half-edges to new indices; some of them may be each other's twins.
    fn glue(&mut self, before: [u32; 4], after: [u32; 4]) {
        let twins = before.map(|half| self.twins[half as usize / 3][half as usize % 3]);
        for (twin, place) in twins.into_iter().zip(after) {
            let twin = before.iter().position(|&half| half == twin).map_or(twin, |k| after[k]);
            self.twins[place as usize / 3][place as usize % 3] = twin;
            if twin != NO_TWIN {
                self.twins[twin as usize / 3][twin as usize % 3] = place;
            }
        }
    }

    /// The other diagonal of the two triangles laid out in the plane: x at the origin, y on the axis, p above, q below.
    fn diagonal(&self, t: usize, i: usize, o: usize, [xq, px, qy, yp]: [f64; 4]) -> Option<Diagonal> {
        let base = self.lengths[t][i];
        let foot = |to_x: f64, to_y: f64| 0.5 * (base + (to_x - to_y) * ((to_x + to_y) / base));
        let (p, q) = (foot(px, yp), foot(xq, qy));
        let (above, below) = (self.double_areas[t] / base, self.double_areas[o] / base);
        let double_areas = [p * below + q * above, (base - p) * below + (base - q) * above];
        let length = (p - q).hypot(above + below);
        double_areas.iter().all(|&area| area > 0.0).then_some(Diagonal { length, double_areas })
    }
}

/// The new edge of a flip, and twice the areas of the new triangles.
struct Diagonal {
    length: f64,
    double_areas: [f64; 2],
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::{DVec2, DVec3};
    use crate::surface::{Surface, SurfaceMesh};

    fn intrinsic(vertices: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> IntrinsicMesh {
        let surface = Surface::new(vertices, triangles);
        IntrinsicMesh::of(SurfaceMesh::new(&surface).unwrap().mesh())
    }

    #[test]
    fn the_long_diagonal_of_a_rhombus_is_flipped() {
        let corners = [[-2.0, 0.0], [0.0, -1.0], [2.0, 0.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 7.0));
        let mut mesh = intrinsic(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
        // at the corners ±i the angle is 2 arctan 2, its cotangent (1 − 4)/4
        assert_eq!(mesh.negative_weights(), 1);
        assert!((mesh.cotangent(0, 1) + 0.75).abs() < 1e-15, "{}", mesh.cotangent(0, 1));
        let report = mesh.make_delaunay();
        assert_eq!(report, FlipReport { flips: 1, negative_before: 1, negative_after: 0 });
        assert!(mesh.check_invariants() && mesh.is_delaunay());
        let shared = mesh.lengths[0].iter().find(|length| mesh.lengths[1].contains(length) && **length < 2.1);
        assert_eq!(shared, Some(&2.0), "{:?}", mesh.lengths);
        assert!((mesh.area() - 4.0).abs() < 1e-15);
    }

    #[test]
    fn flips_keep_the_area_and_the_gluing_on_a_needle_mesh() {
        for (columns, rows, shear) in [(12_u32, 12_u32, 7.3), (30, 4, 0.4), (5, 40, 20.0)] {
            let place = |k: u32| {
                let (i, j) = (f64::from(k % columns), f64::from(k / columns));
                DVec3::new(i + shear * j, j, (0.3 * i).sin() * 2.0 + 0.1 * j * j)
            };
            let square = |k: u32| {
                let a = k / (columns - 1) * columns + k % (columns - 1);
                [[a, a + 1, a + columns + 1], [a, a + columns + 1, a + columns]]
            };
            let vertices = (0..columns * rows).map(place).collect();
            let mut mesh = intrinsic(vertices, (0..(columns - 1) * (rows - 1)).flat_map(square).collect());
            assert!(mesh.check_invariants());
            let area = mesh.area();
            let report = mesh.make_delaunay();
            println!("{columns}×{rows}, shear {shear}: {report:?}");
            assert!(report.flips > 0 && report.negative_before > 0 && report.negative_after == 0);
            assert!(mesh.check_invariants());
            assert!((mesh.area() - area).abs() < 1e-12 * area, "{} and {area}", mesh.area());
        }
    }

    #[test]
    fn a_delaunay_mesh_is_left_alone() {
        let rim: Vec<DVec2> = (0..40).map(|k| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 40.0)).collect();
        let planar = crate::mesh::mesh_domain(&rim, crate::mesh::Sizing::Uniform).unwrap().0;
        let mut mesh = intrinsic(planar.vertices.iter().map(|p| p.extend(0.0)).collect(), planar.triangles);
        let before = mesh.clone();
        assert_eq!(mesh.make_delaunay(), FlipReport::default());
        assert_eq!(mesh.triangles, before.triangles);
    }
}
