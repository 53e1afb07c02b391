//! The lines of a pattern on a mesh: level sets of two functions of the pattern's coordinates.
//!
//! The map is affine on a triangle, so that a straight line of the pattern is a straight segment there
//! (marching triangles). Circles and rays are level sets of nonlinear functions: triangles are first
//! subdivided until a line bends only a little within a piece. Segments with a common end
//! are joined; a line that returns to its start is closed. The tiles of hyperbolic tilings are carried one by one: `tiles`.

use super::polylines::{Line, Polylines};
use super::tiles::CarriedMesh;
use crate::geometry::DVec2;
use crate::tiling::Tiling;
use std::f64::consts::TAU;

/// The families of lines, in the pattern's coordinates of the vertices.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ruling {
    /// x and y at whole multiples of `spacing` from `origin`.
    Squares {
        /// A crossing of two lines.
        origin: DVec2,
        /// The side of a square.
        spacing: f64,
    },
    /// Circles about `pole` at whole multiples of `spacing`; 6 rays, as on polar graph paper, whose number is doubled
    /// at the radii 1, 2, 4, … times `spacing`.
    Polar {
        /// The center.
        pole: DVec2,
        /// The distance between circles.
        spacing: f64,
    },
    /// In the unit disk: rays, and circles with the same step in −ln of the radius.
    Conformal {
        /// The number of rays, a multiple of 4.
        rays: u32,
    },
    /// In the unit disk: the tiles of a tiling as closed lines; the second family are the mirrors in them, if wanted.
    Tiling {
        /// The tiling.
        tiling: Tiling,
        /// Whether the mirrors are drawn.
        mirrors: bool,
    },
}

/// A function's value at a corner: `value`, bit-identical in all triangles, plus the whole number `added` for this one.
#[derive(Debug, Clone, Copy)]
struct Value {
    value: f64,
    added: f64,
}

impl Value {
    fn whole(&self) -> f64 {
        self.value + self.added
    }

    /// Computed without rounding, so that neighbors agree on which side of a line their common corner lies.
    fn is_below(&self, level: f64) -> bool {
        self.value < level - self.added
    }
}

/// The two families of a ruling: x and y, or circles and rays.
pub const FAMILIES: usize = 2;

/// The corners of a triangle, each with its pattern coordinates and its position.
type Corners = [(DVec2, DVec2); 3];

/// The maximal number of doublings of the rays.
const DOUBLINGS: u32 = 6;
/// The number of rays nearest to the pole.
const FEWEST_RAYS: u32 = 6;
/// The maximal number of lines through a triangle: more could not be told apart. Collapsed and huge images have more.
const MOST_LEVELS: usize = 64;
/// The maximal length of a piece in cells: a circle with the radius of one cell then has 30 corners.
const PIECE: f64 = 0.2;
/// The radius down to which the circles of a conformal pattern stay round.
const WITHIN: f64 = 0.15;
/// The maximal number of pieces along an edge, and of triangles after subdivision.
const MOST_PIECES: usize = 8;
const MOST_TRIANGLES: usize = 2_000_000;
/// Cells of a conformal pattern smaller than this part of the disk's radius are omitted: the lines would run together.
const FINEST_CELL: f64 = 0.01;

impl Ruling {
    /// The lines of one family (0 or 1) on a mesh, given the `positions` and the pattern's `coordinates` of its
    /// vertices.
    pub fn lines(self, family: usize, positions: &[DVec2], coordinates: &[DVec2], triangles: &[[u32; 3]]) -> Vec<Line> {
        if let Self::Tiling { tiling, mirrors } = self {
            let mesh = CarriedMesh { positions, coordinates, triangles };
            return match family {
                0 => mesh.tiles(tiling),
                _ if mirrors => mesh.mirrors(tiling),
                _ => Vec::new(),
            };
        }
        let mut joints = Polylines::default();
        let pieces = self.pieces(coordinates, triangles);
        for triangle in triangles {
            let corners = triangle.map(|v| (coordinates[v as usize], positions[v as usize]));
            for_pieces(&corners, pieces, &mut |piece| self.cross(family, piece, &mut joints));
        }
        joints.lines()
    }

    /// The number of pieces of each edge, the same for all triangles, so that neighbors fit together.
    fn pieces(self, coordinates: &[DVec2], triangles: &[[u32; 3]]) -> usize {
        let cell = match self {
            Self::Squares { .. } | Self::Tiling { .. } => return 1,
            Self::Polar { spacing, .. } => spacing,
            Self::Conformal { rays } => WITHIN * TAU / f64::from(rays),
        };
        let edges = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let longest = edges.map(|(a, b)| coordinates[a as usize].distance(coordinates[b as usize])).fold(0.0, f64::max);
        let affordable = (MOST_TRIANGLES as f64 / triangles.len().max(1) as f64).sqrt() as usize;
        ((longest / (PIECE * cell)).ceil() as usize).clamp(1, MOST_PIECES.min(affordable.max(1)))
    }

    /// Adds the segments on which the family's function is an integer.
    fn cross(self, family: usize, piece: &Corners, joints: &mut Polylines) {
        let Some(values) = self.values(family, piece.map(|corner| corner.0)) else { return };
        let low = values.iter().map(Value::whole).fold(f64::INFINITY, f64::min);
        let high = values.iter().map(Value::whole).fold(f64::NEG_INFINITY, f64::max);
        if !(low.is_finite() && high.is_finite()) {
            return;
        }
        for level in (low.ceil() as i64..=high.floor() as i64).take(MOST_LEVELS) {
            if let Some(ends) = crossing(&values, piece, level as f64)
                && self.shows(family, level, ends[0].coordinate.midpoint(ends[1].coordinate))
            {
                joints.add(ends.map(|end| ((self.name(family, level), end.edge), end.place)));
            }
        }
    }

    /// The family's function at the corners of a triangle, in units of lines; angles are made continuous.
    /// `None` if the triangle contains the center.
    fn values(self, family: usize, corners: [DVec2; 3]) -> Option<[Value; 3]> {
        let plain = |value| Value { value, added: 0.0 };
        match self {
            Self::Squares { origin, spacing } => Some(corners.map(|p| plain((p - origin)[family] / spacing))),
            Self::Polar { pole, spacing } if family == 0 => Some(corners.map(|p| plain(p.distance(pole) / spacing))),
            Self::Polar { pole, .. } => angles(corners.map(|p| p - pole), FEWEST_RAYS << DOUBLINGS),
            Self::Conformal { rays } if family == 0 => {
                let per_radian = f64::from(rays) / TAU;
                Some(corners.map(|p| plain(-per_radian * p.length().ln())))
            }
            Self::Conformal { rays } => angles(corners, rays),
            Self::Tiling { .. } => None,
        }
    }

    /// Whether a line is drawn at a point: rays end where they come too close to each other, and the circle of
    /// radius 1 is the boundary, which is drawn separately.
    fn shows(self, family: usize, level: i64, at: DVec2) -> bool {
        match (self, family) {
            (Self::Polar { pole, spacing }, 1) => {
                let doublings = DOUBLINGS - level.trailing_zeros().min(DOUBLINGS);
                doublings == 0 || at.distance(pole) >= spacing * f64::from(1u32 << (doublings - 1))
            }
            (Self::Polar { .. }, _) => level > 0,
            (Self::Conformal { rays }, _) => {
                let is_fine = at.length() * TAU / f64::from(rays) < FINEST_CELL;
                !is_fine && (family == 1 || level > 0)
            }
            (Self::Squares { .. } | Self::Tiling { .. }, _) => true,
        }
    }

    /// The number of a line; rays whose angles differ by whole turns have the same number.
    fn name(self, family: usize, level: i64) -> i64 {
        match (self, family) {
            (Self::Polar { .. }, 1) => level.rem_euclid(i64::from(FEWEST_RAYS << DOUBLINGS)),
            (Self::Conformal { rays }, 1) => level.rem_euclid(i64::from(rays)),
            _ => level,
        }
    }
}

/// The angles of three points about the origin, with `rays` for a full turn; `None` if their triangle contains it.
fn angles(places: [DVec2; 3], rays: u32) -> Option<[Value; 3]> {
    let [a, b, c] = places;
    let turns = [a.perp_dot(b), b.perp_dot(c), c.perp_dot(a)];
    if turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0) {
        return None;
    }
    let whole = f64::from(rays);
    let values = places.map(|p| p.to_angle() / TAU * whole);
    // the difference between two corners is less than half a turn
    Some(values.map(|value| Value { value, added: -((value - values[0]) / whole).round() * whole }))
}

/// Subdivides a triangle into `n²` pieces.
fn for_pieces(corners: &Corners, n: usize, emit: &mut dyn FnMut(&Corners)) {
    if n == 1 {
        return emit(corners);
    }
    let at = |i: usize, j: usize| blend(corners, [n - i - j, i, j], n);
    for i in 0..n {
        for j in 0..n - i {
            emit(&[at(i, j), at(i + 1, j), at(i, j + 1)]);
            if i + j + 2 <= n {
                emit(&[at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
}

/// The point of a triangle with integer weights that sum to `n`. The corners are sorted by position, so that a
/// point of a shared edge is bit-identical in both triangles.
fn blend(corners: &Corners, weights: [usize; 3], n: usize) -> (DVec2, DVec2) {
    let mut order = [0, 1, 2];
    for k in [0, 1, 0] {
        if compare(corners[order[k + 1]].1, corners[order[k]].1).is_lt() {
            order.swap(k, k + 1);
        }
    }
    let sum = |of: &dyn Fn(usize) -> DVec2| {
        let weighted = order.iter().filter(|&&i| weights[i] > 0).map(|&i| weights[i] as f64 * of(i));
        weighted.fold(DVec2::ZERO, |sum, term| sum + term) / n as f64
    };
    (sum(&|i| corners[i].0), sum(&|i| corners[i].1))
}

fn compare(p: DVec2, q: DVec2) -> std::cmp::Ordering {
    p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
}

/// The point where a line leaves a piece of a triangle.
#[derive(Clone, Copy)]
struct End {
    /// The edge, by the bits of its ends: the computed position may differ by rounding between its two sides.
    edge: [u64; 4],
    coordinate: DVec2,
    place: DVec2,
}

/// The segment on which the linear function with these corner values equals `level`.
fn crossing(values: &[Value; 3], corners: &Corners, level: f64) -> Option<[End; 2]> {
    let mut ends = Vec::with_capacity(2);
    for i in 0..3 {
        let j = (i + 1) % 3;
        if values[i].is_below(level) != values[j].is_below(level) {
            let (i, j) = if compare(corners[i].1, corners[j].1).is_le() { (i, j) } else { (j, i) };
            let ((c, p), (d, q)) = (corners[i], corners[j]);
            let (from, to) = (values[i].whole(), values[j].whole());
            let share = ((level - from) / (to - from)).clamp(0.0, 1.0);
            let edge = [p.x, p.y, q.x, q.y].map(f64::to_bits);
            ends.push(End { edge, coordinate: c.lerp(d, share), place: p.lerp(q, share) });
        }
    }
    <[End; 2]>::try_from(ends).ok()
}
