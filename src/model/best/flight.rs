//! The way of the points to the result of a search.

use crate::conformal::Constraints;
use crate::optimization::Optimization;

/// Fractions of a boundary's length are the same up to this, and up to whole numbers.
const SAME_FRACTION: f64 = 1e-9;

/// Seconds from the start to the result: long enough to follow the points by eye.
const SECONDS: f64 = 1.2;

/// Places of the way that are computed in advance.
const PLACES: u32 = 48;

/// Constraints from the start of a search to its result.
#[derive(Debug)]
pub struct Flight {
    way: Vec<Constraints>,
    begun: Option<f64>,
    /// Where the points were sent last, at first the start.
    last: Constraints,
}

/// Whether constraints are the same up to rounding of the boundary points.
pub fn is_same_place(a: &Constraints, b: &Constraints) -> bool {
    let off = |a: f64, b: f64| (a - b - (a - b).round()).abs();
    a.points == b.points
        && off(a.anchors.source, b.anchors.source).max(off(a.anchors.target, b.anchors.target)) < SAME_FRACTION
}

impl Flight {
    /// The way to the result of a search; only the result if motion is not wanted. `None` if the start stays.
    pub fn new(search: &Optimization, is_calm: bool) -> Option<Self> {
        let found = search.found()?.constraints;
        if found == *search.start() {
            return None;
        }
        let places = if is_calm { 0 } else { PLACES };
        let way = (0..places).map_while(|k| search.way(f64::from(k) / f64::from(PLACES)));
        Some(Self { way: way.chain([found]).collect(), begun: None, last: *search.start() })
    }

    /// Where the points are at a time, in seconds; the first call begins the motion.
    pub fn place(&mut self, now: f64) -> Constraints {
        let share = self.share(now);
        self.begun.get_or_insert(now);
        let last = self.way.len() - 1;
        self.last = self.way[((share * last as f64) as usize).min(last)];
        self.last
    }

    /// Whether the points are where they were sent; otherwise somebody else has moved them.
    pub fn is_undisturbed(&self, at: &Constraints) -> bool {
        is_same_place(&self.last, at)
    }

    /// Whether the points are at their end.
    pub fn has_landed(&self, now: f64) -> bool {
        self.way.len() == 1 || self.share(now) >= 1.0
    }

    /// The share of the way, slow at both ends.
    fn share(&self, now: f64) -> f64 {
        let t = self.begun.map_or(0.0, |begun| ((now - begun) / SECONDS).clamp(0.0, 1.0));
        t * t * (3.0 - 2.0 * t)
    }
}
