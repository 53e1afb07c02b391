//! An outline being reshaped: its vertices, some of which are handles.
//!
//! Moving a handle moves the boundary between its neighbors by a weight that decreases from 1 to 0 along
//! arc length. Where the boundary is smooth the weight has slope 0, so that it stays smooth; next to corners it is
//! linear, so that straight edges stay straight.

use super::carry::nearest;
use super::handles::{handles, is_sharp};
use super::simplify::simplified_ring;
use super::smooth::smoothed;
use super::{DrawingError, hermite};
use crate::geometry::{Bounds, DVec2, PolygonError, SimplePolygon};

/// The smallest number of handles, those of a triangle.
const LEAST_HANDLES: usize = 3;

/// An outline with more vertices is thinned: a thousand vertices cost 1 ms for every move of a handle.
const DENSE: usize = 500;

/// The tolerance of thinning, as a part of the size: a thirtieth of a pixel in a picture a thousand pixels wide.
const INVISIBLE: f64 = 3e-5;

/// A closed chain of vertices, some of them handles.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    vertices: Vec<DVec2>,
    /// Indices of the handles' vertices, ascending.
    handles: Vec<usize>,
}

impl Shape {
    /// Chooses the handles: all vertices of a polygon that has few, otherwise the most significant ones.
    /// If there are very many vertices, those without visible effect are removed; the first one stays.
    pub fn new(polygon: &SimplePolygon) -> Self {
        let vertices = polygon.vertices();
        if vertices.len() <= DENSE {
            return Self::of(vertices.to_vec());
        }
        let kept = simplified_ring(vertices, INVISIBLE * polygon.bounds().size().max_element());
        let thinned = Self::of(kept.into_iter().map(|k| vertices[k]).collect());
        // in a channel narrower than the tolerance the thinned sides could meet
        if thinned.polygon().is_ok() { thinned } else { Self::of(vertices.to_vec()) }
    }

    fn of(vertices: Vec<DVec2>) -> Self {
        Self { handles: handles(&vertices), vertices }
    }

    /// The vertices, in order.
    pub fn vertices(&self) -> &[DVec2] {
        &self.vertices
    }

    /// The number of handles.
    pub fn handle_count(&self) -> usize {
        self.handles.len()
    }

    /// The positions of the handles, in order.
    pub fn handles(&self) -> impl ExactSizeIterator<Item = DVec2> + '_ {
        self.handles.iter().map(|&k| self.vertices[k])
    }

    /// The position of a handle.
    pub fn handle(&self, handle: usize) -> Option<DVec2> {
        self.handles.get(handle).map(|&k| self.vertices[k])
    }

    /// The outline, counter-clockwise. Errors: why the vertices do not form a simple polygon.
    pub fn polygon(&self) -> Result<SimplePolygon, PolygonError> {
        SimplePolygon::try_from(self.vertices.clone())
    }

    /// The shape with a handle moved to `to`; the boundary up to its neighbors follows. A handle that
    /// does not exist changes nothing.
    #[must_use]
    pub fn moved(&self, handle: usize, to: DVec2) -> Self {
        let mut moved = self.clone();
        let Some(at) = self.handle(handle) else { return moved };
        moved.vertices[self.handles[handle]] = to;
        for forward in [true, false] {
            for (k, weight) in self.weights(handle, forward) {
                moved.vertices[k] += weight * (to - at);
            }
        }
        moved
    }

    /// The vertices strictly between a handle and the next one, with their weights.
    fn weights(&self, handle: usize, forward: bool) -> Vec<(usize, f64)> {
        let n = self.vertices.len();
        let (from, to) = (self.handles[handle], self.neighbour(handle, forward));
        let step = |k: usize| if forward { (k + 1) % n } else { (k + n - 1) % n };
        let (mut k, mut s, mut between) = (from, 0.0, Vec::new());
        loop {
            let next = step(k);
            s += self.vertices[k].distance(self.vertices[next]);
            k = next;
            if k == to || k == from {
                break;
            }
            between.push((k, s));
        }
        let ends = [from, to].map(|k| is_sharp(&self.vertices, k));
        between.into_iter().map(|(k, at)| (k, weight(at / s, ends))).collect()
    }

    /// The vertex of the neighboring handle.
    fn neighbour(&self, handle: usize, forward: bool) -> usize {
        let count = self.handles.len();
        self.handles[(handle + if forward { 1 } else { count - 1 }) % count]
    }

    /// The shape with one more handle, at the boundary point nearest to `at`, and that handle's number.
    /// If there is already a handle at that point, its number is returned.
    pub fn inserted(&self, at: DVec2) -> (Self, usize) {
        let mut shape = self.clone();
        let (edge, part) = nearest(&self.vertices, at);
        let next = (edge + 1) % self.vertices.len();
        // at an end of the edge there already is a vertex
        let vertex = match part {
            0.0 => edge,
            1.0 => next,
            _ => {
                shape.vertices.insert(edge + 1, self.vertices[edge].lerp(self.vertices[next], part));
                shape.handles.iter_mut().for_each(|k| *k += usize::from(*k > edge));
                edge + 1
            }
        };
        let handle = match shape.handles.binary_search(&vertex) {
            Ok(handle) => handle,
            Err(place) => {
                shape.handles.insert(place, vertex);
                place
            }
        };
        (shape, handle)
    }

    /// The shape without a handle: its neighbors are joined by a cubic that continues
    /// the boundary where it is smooth; between two corners that is a straight edge.
    pub fn removed(&self, handle: usize) -> Result<Self, DrawingError> {
        if self.handles.len() <= LEAST_HANDLES || handle >= self.handles.len() {
            return Err(DrawingError::LastHandles { least: LEAST_HANDLES });
        }
        let n = self.vertices.len();
        let (from, to) = (self.neighbour(handle, false), self.neighbour(handle, true));
        let (a, b) = (self.vertices[from], self.vertices[to]);
        let along = |k: usize, l: usize| a.distance(b) * (self.vertices[l] - self.vertices[k]).normalize_or_zero();
        let start = (!is_sharp(&self.vertices, from)).then(|| along((from + n - 1) % n, from));
        let end = (!is_sharp(&self.vertices, to)).then(|| along(to, (to + 1) % n));
        // from `to` around to `from`, then the new curve
        let mut kept = vec![to];
        while kept.last() != Some(&from) {
            kept.push((kept[kept.len() - 1] + 1) % n);
        }
        let new_index = |old: usize| kept.iter().position(|&k| k == old);
        let handles = self.handles.iter().filter_map(|&k| new_index(k)).collect();
        let mut vertices: Vec<DVec2> = kept.iter().map(|&k| self.vertices[k]).collect();
        vertices.extend(hermite::inner_points(a, b, [start, end]));
        let mut shape = Self { vertices, handles };
        shape.handles.sort_unstable();
        shape.begin_near(self.vertices[0]);
        Ok(shape)
    }

    /// Smooths the shape by a heat flow of the coordinates over 1 % of its length,
    /// preserving the area. The handles are chosen again.
    #[must_use]
    pub fn smoothed(&self) -> Self {
        Self::of(smoothed(&self.vertices))
    }

    /// The mirror image about the vertical line through the middle, with the vertices in reverse order;
    /// the first one stays first.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let axis = self.axis();
        let n = self.vertices.len();
        let mut vertices: Vec<DVec2> = self.vertices.iter().map(|&p| axis.image(p)).collect();
        vertices[1..].reverse();
        let mut handles: Vec<usize> = self.handles.iter().map(|&k| (n - k) % n).collect();
        handles.sort_unstable();
        Self { vertices, handles }
    }

    /// The vertical line through the middle of the bounding box.
    pub fn axis(&self) -> Axis {
        Axis { x: Bounds::of(self.vertices.iter().copied()).center().x }
    }

    /// Rotates the numbering so that the first vertex is the one nearest to `start`.
    fn begin_near(&mut self, start: DVec2) {
        let distance = |k: &usize| self.vertices[*k].distance_squared(start);
        let n = self.vertices.len();
        let first = (0..n).min_by(|i, j| distance(i).total_cmp(&distance(j))).unwrap_or(0);
        self.vertices.rotate_left(first);
        self.handles.iter_mut().for_each(|k| *k = (*k + n - first) % n);
        self.handles.sort_unstable();
    }
}

/// A vertical line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    x: f64,
}

impl Axis {
    /// The mirror image of a point.
    pub fn image(self, p: DVec2) -> DVec2 {
        DVec2::new(2.0 * self.x - p.x, p.y)
    }
}

/// A weight that decreases from 1 at `t = 0` to 0 at 1, with slope 0 at ends that are not sharp.
fn weight(t: f64, sharp: [bool; 2]) -> f64 {
    match sharp {
        [true, true] => 1.0 - t,
        [false, true] => 1.0 - t * t,
        [true, false] => (1.0 - t) * (1.0 - t),
        [false, false] => (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t),
    }
}
