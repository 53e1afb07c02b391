//! Interior points of the uniform mesher: a hexagonal lattice clipped to the polygon.
//!
//! The lattice triangles have area `√3/4 a²`. A lattice point is kept when it is
//! inside the polygon (scanline), at least `CLEARANCE · a` away from every
//! edge, and outside the isosceles triangle with base angles of 30° over every
//! edge (matters for edges much longer than `a` only: points closer than that would make
//! an angle above 120° on the edge). Deep inside, the lattice triangles are
//! Delaunay already, so they are emitted directly ([`HexLattice::core_triangles`])
//! and only the band between them and the boundary needs a triangulator.
//! Cost: O(boundary length / a + kept points).

use super::row_spans::{RowSpans, Span, intersect, normalise, subtract};
use crate::geometry::DVec2;

/// Distance kept from the boundary, in lattice spacings. It has to exceed 1/2:
/// then no edge passes between two kept neighbours, so a lattice triangle with
/// three kept corners lies inside the domain.
pub(super) const CLEARANCE: f64 = 0.6;

/// `√3/2`, the distance between rows in spacings.
const ROW: f64 = 0.866_025_403_784_438_6;

/// The lattice points inside a polygon, with consecutive numbers row by row.
pub(super) struct HexLattice {
    origin: DVec2,
    spacing: f64,
    points: RowSpans,
    /// Corners of the triangles that are emitted directly.
    core: RowSpans,
    /// Points whose six triangles are all emitted directly.
    hidden: RowSpans,
}

impl HexLattice {
    /// Clips the lattice with spacing `spacing` to the counter-clockwise polygon.
    pub fn clip(polygon: &[DVec2], spacing: f64) -> Self {
        let (low, high) = bounds(polygon);
        // row 0 lies outside the polygon, so that erosion needs no special case
        let origin = DVec2::new(low.x, low.y - 0.5 * ROW * spacing);
        let rows = ((high.y - origin.y) / (ROW * spacing)).floor() as usize + 2;
        let mut clip = Clip { origin, spacing, crossings: vec![Vec::new(); rows], killed: vec![Vec::new(); rows] };
        for (k, &a) in polygon.iter().enumerate() {
            clip.edge(a, polygon[(k + 1) % polygon.len()]);
        }
        let points = clip.points();
        let core = points.eroded().eroded();
        let hidden = core.eroded();
        Self { origin, spacing, points, core, hidden }
    }

    /// The number of lattice points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// All lattice points in the order of their numbers.
    pub fn positions(&self) -> Vec<DVec2> {
        let mut positions = Vec::with_capacity(self.len());
        for r in 0..self.points.rows() {
            let (start, step) = self.row_start(r);
            for span in self.points.row(r) {
                positions.extend((span.start..span.end).map(|c| DVec2::new(start.x + step * f64::from(c), start.y)));
            }
        }
        positions
    }

    /// The row nearest to a point, for numbering further points coherently.
    pub fn row_of(&self, p: DVec2) -> u32 {
        ((p.y - self.origin.y) / (ROW * self.spacing) + 0.5).max(0.0) as u32
    }

    /// The counter-clockwise triangles deep inside, by numbers of lattice points.
    pub fn core_triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = Vec::with_capacity(2 * self.core.len());
        let (mut shifted, mut pairs, mut up, mut down) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for r in 0..self.core.rows().saturating_sub(1) {
            let (row, above) = (self.core.row(r), self.core.row(r + 1));
            shifted.clear();
            shifted.extend(row.iter().map(|s| Span { start: s.start, end: s.end - 1 }));
            intersect(&shifted, above, &mut up);
            // (r, c+1), (r+1, c+1), (r+1, c)
            shifted.clear();
            shifted.extend(row.iter().map(|s| Span { start: s.start - 1, end: s.end - 1 }));
            pairs.clear();
            pairs.extend(above.iter().map(|s| Span { start: s.start, end: s.end - 1 }));
            intersect(&shifted, &pairs, &mut down);
            self.emit(r, &up, &down, &mut triangles);
        }
        triangles
    }

    fn emit(&self, r: usize, up: &[Span], down: &[Span], triangles: &mut Vec<[u32; 3]>) {
        for span in up {
            if let (Some(a), Some(b)) = (self.points.index(r, span.start), self.points.index(r + 1, span.start)) {
                triangles.extend((0..span.len() as u32).map(|k| [a + k, a + k + 1, b + k]));
            }
        }
        for span in down {
            if let (Some(a), Some(b)) = (self.points.index(r, span.start + 1), self.points.index(r + 1, span.start)) {
                triangles.extend((0..span.len() as u32).map(|k| [a + k, b + k + 1, b + k]));
            }
        }
    }

    /// The numbers of the points outside the core or on its rim.
    pub fn band(&self) -> Vec<u32> {
        let mut band = Vec::new();
        let mut spans = Vec::new();
        for r in 0..self.points.rows() {
            subtract(self.points.row(r), self.hidden.row(r), &mut spans);
            for span in &spans {
                if let Some(first) = self.points.index(r, span.start) {
                    band.extend(first..first + span.len() as u32);
                }
            }
        }
        band
    }

    /// The lattice edges with a core triangle on exactly one side.
    pub fn core_edges(&self) -> Vec<[u32; 2]> {
        let mut edges = Vec::new();
        let mut rim = Vec::new();
        for r in 1..self.core.rows() {
            subtract(self.core.row(r), self.hidden.row(r), &mut rim);
            for c in rim.iter().flat_map(|span| span.start..span.end) {
                self.core_edges_at(r, c, &mut edges);
            }
        }
        edges
    }

    /// Adds the core's edges among the three that start at `(r, c)`; both ends of such an edge are on the rim.
    fn core_edges_at(&self, r: usize, c: i32, edges: &mut Vec<[u32; 2]>) {
        let core = |r: usize, c: i32| self.core.index(r, c).is_some();
        // each with the two points that complete its triangles
        let candidates = [
            ((r, c + 1), (r + 1, c), (r - 1, c + 1)),
            ((r + 1, c), (r + 1, c - 1), (r, c + 1)),
            ((r + 1, c - 1), (r, c - 1), (r + 1, c)),
        ];
        for (end, left, right) in candidates {
            let is_rim = core(end.0, end.1) && core(left.0, left.1) != core(right.0, right.1);
            let ends = (self.points.index(r, c), self.points.index(end.0, end.1));
            if let (true, (Some(a), Some(b))) = (is_rim, ends) {
                edges.push([a, b]);
            }
        }
    }

    fn row_start(&self, r: usize) -> (DVec2, f64) {
        let shift = DVec2::new(0.5 * r as f64, ROW * r as f64);
        (self.origin + self.spacing * shift, self.spacing)
    }
}

/// The scanline's result: crossings and excluded columns for each row.
struct Clip {
    origin: DVec2,
    spacing: f64,
    /// Columns (as real numbers) where the boundary crosses the row.
    crossings: Vec<Vec<f64>>,
    killed: Vec<Vec<Span>>,
}

impl Clip {
    /// In lattice units: `x` in spacings, `y` in spacings.
    fn local(&self, p: DVec2) -> DVec2 {
        (p - self.origin) / self.spacing
    }

    fn edge(&mut self, a: DVec2, b: DVec2) {
        let (a, b) = (self.local(a), self.local(b));
        self.cross(a, b);
        let direction = (b - a).normalize_or_zero();
        let outward = CLEARANCE * DVec2::new(direction.y, -direction.x);
        self.kill_disk(a);
        self.kill_convex(&[a + outward, b + outward, b - outward, a - outward]);
        let apex = 0.5 * (a + b) + (b - a).perp() * (0.5 / 3f64.sqrt());
        if apex.distance(0.5 * (a + b)) > CLEARANCE {
            self.kill_convex(&[a, b, apex]);
        }
    }

    /// Marks where the edge crosses rows; rows at `y ∈ [min, max)` count.
    fn cross(&mut self, a: DVec2, b: DVec2) {
        let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
        let mut r = (low.y / ROW).ceil().max(0.0) as usize;
        while (r as f64) * ROW < high.y && r < self.crossings.len() {
            let y = r as f64 * ROW;
            let x = low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
            self.crossings[r].push(x - 0.5 * r as f64);
            r += 1;
        }
    }

    fn kill_disk(&mut self, p: DVec2) {
        self.kill_rows(p.y - CLEARANCE, p.y + CLEARANCE, |y| {
            let half = (CLEARANCE * CLEARANCE - (y - p.y) * (y - p.y)).max(0.0).sqrt();
            (p.x - half, p.x + half)
        });
    }

    fn kill_convex(&mut self, corners: &[DVec2]) {
        let (low, high) = bounds(corners);
        self.kill_rows(low.y, high.y, |y| {
            let mut range = (f64::INFINITY, f64::NEG_INFINITY);
            for (k, &p) in corners.iter().enumerate() {
                let q = corners[(k + 1) % corners.len()];
                if (p.y <= y) != (q.y <= y) {
                    let x = p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
                    range = (range.0.min(x), range.1.max(x));
                }
            }
            range
        });
    }

    /// Excludes the columns in the closed range that `range` gives for each row of `low ≤ y ≤ high`.
    fn kill_rows(&mut self, low: f64, high: f64, range: impl Fn(f64) -> (f64, f64)) {
        let first = (low / ROW).ceil().max(0.0) as usize;
        let last = (high / ROW).floor().max(-1.0) as isize;
        for r in first..self.killed.len().min((last + 1).max(0) as usize) {
            let (from, to) = range(r as f64 * ROW);
            let span = columns(from - 0.5 * r as f64, to - 0.5 * r as f64);
            if span.start < span.end {
                self.killed[r].push(span);
            }
        }
    }

    fn points(mut self) -> RowSpans {
        let (mut inside, rows) = (Vec::new(), self.crossings.len());
        RowSpans::build(rows, |r, out| {
            let (crossings, killed) = (&mut self.crossings[r], &mut self.killed[r]);
            crossings.sort_unstable_by(f64::total_cmp);
            inside.clear();
            inside.extend(crossings.chunks_exact(2).map(|pair| columns(pair[0], pair[1])));
            normalise(&mut inside);
            normalise(killed);
            subtract(&inside, killed, out);
        })
    }
}

/// The integers in `[from, to]`.
fn columns(from: f64, to: f64) -> Span {
    if from <= to { Span { start: from.ceil() as i32, end: to.floor() as i32 + 1 } } else { Span { start: 0, end: 0 } }
}

/// The lower left and upper right corner of the bounding box.
pub(super) fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let start = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    points.iter().fold(start, |(low, high), &p| (low.min(p), high.max(p)))
}
