//! The lines of a pattern on a mesh: level sets of two functions of the pattern's coordinates.
//!
//! On a triangle the map is affine, so a straight line of the pattern is a straight segment there
//! (marching triangles). Circles and rays are level sets of functions that are not linear: triangles are
//! cut into smaller ones first, until a piece turns by little. Segments that share an end
//! are joined; a line that comes back to its beginning is closed.

use super::polylines::{Line, Polylines};
use crate::geometry::DVec2;
use std::f64::consts::TAU;

/// Which lines, by the coordinates that a vertex looks the pattern up with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ruling {
    /// x and y at whole multiples of `spacing` from `origin`.
    Squares {
        /// Where two lines cross.
        origin: DVec2,
        /// The side of a square.
        spacing: f64,
    },
    /// Circles about `pole` at whole multiples of `spacing`; rays as on polar graph paper: 6, doubled at
    /// the radii 1, 2, 4, … times `spacing`.
    Polar {
        /// The centre.
        pole: DVec2,
        /// From circle to circle.
        spacing: f64,
    },
    /// In the unit disk: so many rays, and circles at the same steps of −ln of the radius.
    Conformal {
        /// The number of rays, a multiple of 4.
        rays: u32,
    },
}

/// A function's value at a corner, the same to the bit in all triangles, and a whole number that is added in this one.
#[derive(Debug, Clone, Copy)]
struct Value {
    value: f64,
    added: f64,
}

impl Value {
    fn whole(&self) -> f64 {
        self.value + self.added
    }

    /// Without rounding: neighbours agree on which side of a line their common corner is.
    fn is_below(&self, level: f64) -> bool {
        self.value < level - self.added
    }
}

/// The two families of a ruling: x and y, or circles and rays.
pub const FAMILIES: usize = 2;

/// The corners of a triangle: the pattern's coordinates, and the places.
type Corners = [(DVec2, DVec2); 3];

/// Rays of polar graph paper are doubled so many times at most.
const DOUBLINGS: u32 = 6;
/// Rays nearest to the pole.
const FEWEST_RAYS: u32 = 6;
/// More lines than this through one triangle cannot be told apart: a collapsed or huge image has them.
const MOST_LEVELS: usize = 64;
/// A piece of a triangle is not longer than this in cells: a circle of one cell's radius then has 30 corners.
const PIECE: f64 = 0.2;
/// How far from the centre the circles of a conformal pattern are still round.
const WITHIN: f64 = 0.15;
/// The most pieces along an edge, and on the whole mesh.
const MOST_PIECES: usize = 8;
const MOST_TRIANGLES: usize = 2_000_000;
/// Cells of a conformal pattern that are smaller than this part of the disk's radius are left out: the lines run together.
const FINEST_CELL: f64 = 0.01;

impl Ruling {
    /// The lines of one family (0 or 1) on a mesh whose vertices lie at `positions` and look the pattern up at `coordinates`.
    pub fn lines(self, family: usize, positions: &[DVec2], coordinates: &[DVec2], triangles: &[[u32; 3]]) -> Vec<Line> {
        let mut joints = Polylines::default();
        let pieces = self.pieces(coordinates, triangles);
        for triangle in triangles {
            let corners = triangle.map(|v| (coordinates[v as usize], positions[v as usize]));
            for_pieces(&corners, pieces, &mut |piece| self.cross(family, piece, &mut joints));
        }
        joints.lines()
    }

    /// Into how many pieces the edges of triangles are cut, all alike: neighbours meet.
    fn pieces(self, coordinates: &[DVec2], triangles: &[[u32; 3]]) -> usize {
        let cell = match self {
            Self::Squares { .. } => return 1,
            Self::Polar { spacing, .. } => spacing,
            Self::Conformal { rays } => WITHIN * TAU / f64::from(rays),
        };
        let edges = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
        let longest = edges.map(|(a, b)| coordinates[a as usize].distance(coordinates[b as usize])).fold(0.0, f64::max);
        let affordable = (MOST_TRIANGLES as f64 / triangles.len().max(1) as f64).sqrt() as usize;
        ((longest / (PIECE * cell)).ceil() as usize).clamp(1, MOST_PIECES.min(affordable.max(1)))
    }

    /// Adds the segments on which the family's function is a whole number.
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

    /// The family's function at the corners of a triangle, in lines; angles without a jump between them.
    /// `None` where the triangle holds the centre.
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
        }
    }

    /// Whether a line is drawn at a place: rays end where they come too near to each other, and the circle of
    /// radius 1 is the boundary, which has a stroke of its own.
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
            (Self::Squares { .. }, _) => true,
        }
    }

    /// A line's name: rays whose angles differ by whole turns are one.
    fn name(self, family: usize, level: i64) -> i64 {
        match (self, family) {
            (Self::Polar { .. }, 1) => level.rem_euclid(i64::from(FEWEST_RAYS << DOUBLINGS)),
            (Self::Conformal { rays }, 1) => level.rem_euclid(i64::from(rays)),
            _ => level,
        }
    }
}

/// The angles of three places about the origin in shares of a turn times `rays`; `None` if they surround it.
fn angles(places: [DVec2; 3], rays: u32) -> Option<[Value; 3]> {
    let [a, b, c] = places;
    let turns = [a.perp_dot(b), b.perp_dot(c), c.perp_dot(a)];
    if turns.iter().all(|&turn| turn >= 0.0) || turns.iter().all(|&turn| turn <= 0.0) {
        return None;
    }
    let whole = f64::from(rays);
    let values = places.map(|p| p.to_angle() / TAU * whole);
    // from corner to corner it is less than half a turn
    Some(values.map(|value| Value { value, added: -((value - values[0]) / whole).round() * whole }))
}

/// Cuts a triangle into `n²` ones; a corner is its pattern's coordinates and its place.
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

/// A point of a triangle by whole weights that sum to `n`. The corners are taken in the order of their
/// places, whatever the triangle: a point of a shared edge is the same, to the bit, from both sides.
fn blend(corners: &Corners, weights: [usize; 3], n: usize) -> (DVec2, DVec2) {
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| compare(corners[i].1, corners[j].1));
    let sum = |of: &dyn Fn(usize) -> DVec2| {
        let weighted = order.iter().filter(|&&i| weights[i] > 0).map(|&i| weights[i] as f64 * of(i));
        weighted.fold(DVec2::ZERO, |sum, term| sum + term) / n as f64
    };
    (sum(&|i| corners[i].0), sum(&|i| corners[i].1))
}

fn compare(p: DVec2, q: DVec2) -> std::cmp::Ordering {
    p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y))
}

/// Where a line leaves a piece of a triangle.
#[derive(Clone, Copy)]
struct End {
    /// The edge, by its ends to the bit: the place itself may differ by rounding between its two sides.
    edge: [u64; 4],
    coordinate: DVec2,
    place: DVec2,
}

/// Where the linear function with these values at the corners equals `level`.
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
