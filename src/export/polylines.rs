//! Joins segments to polylines by the keys of their ends.
//!
//! Deterministic: lines depend only on the segments and their order.

use crate::geometry::DVec2;
use std::collections::HashMap;

/// A polyline on the mesh.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Line {
    /// Its points; a closed line does not repeat the first.
    pub points: Vec<DVec2>,
    /// Whether the last is joined to the first.
    pub is_closed: bool,
}

/// The key of a segment's end: the number of the line and the mesh edge that the end lies on.
pub type Joint = (i64, [u64; 4]);

/// Segments, indexed by their ends.
#[derive(Debug, Default)]
pub struct Polylines {
    segments: Vec<[(Joint, DVec2); 2]>,
    at: HashMap<Joint, Vec<usize>>,
}

impl Polylines {
    /// Adds a segment; each end has a key and a position.
    pub fn add(&mut self, ends: [(Joint, DVec2); 2]) {
        for (joint, _) in ends {
            self.at.entry(joint).or_default().push(self.segments.len());
        }
        self.segments.push(ends);
    }

    /// Joins the segments: first the lines with free ends, then the closed ones.
    pub fn lines(&self) -> Vec<Line> {
        let mut used = vec![false; self.segments.len()];
        let mut lines = Vec::new();
        for open in [true, false] {
            for k in 0..self.segments.len() {
                let begins = self.segments[k].iter().position(|end| !open || self.at[&end.0].len() == 1);
                if let Some(end) = begins.filter(|_| !used[k]) {
                    lines.push(self.follow(k, end, &mut used));
                }
            }
        }
        lines
    }

    /// Follows the line that starts at one end of segment `k`.
    fn follow(&self, k: usize, end: usize, used: &mut [bool]) -> Line {
        let start = self.segments[k][end].0;
        let mut points = vec![self.segments[k][end].1];
        let mut next = Some((k, 1 - end));
        let mut reached = start;
        while let Some((k, end)) = next {
            used[k] = true;
            let (joint, p) = self.segments[k][end];
            points.push(p);
            reached = joint;
            let free = self.at[&joint].iter().find(|&&other| !used[other]);
            next = free.map(|&other| (other, usize::from(self.segments[other][0].0 == joint)));
        }
        let is_closed = reached == start && points.len() > 3;
        if is_closed {
            points.pop();
        }
        Line { points, is_closed }
    }
}
