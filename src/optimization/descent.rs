//! Descents of the downhill simplex over Möbius maps, as questions and answers: in (turn, Re a, Im a) of a small map before
//! the one at the start. Sizes are distances in the disk, where 1 moves the middle to 0.46.

use super::simplex::Simplex;
use crate::conformal::Moebius;
use crate::geometry::DVec3;
use num_complex::Complex64;
use std::collections::VecDeque;

/// The last size of the simplex in closed form.
const SMALL: f64 = 1e-3;

/// The most values of a descent in closed form.
pub const MOST_DESCENT: usize = 120;

/// Descents from several maps, one after the other.
#[derive(Debug)]
pub struct Descents {
    pub now: Descent,
    coming: VecDeque<(f64, Moebius)>,
    pub ended: Vec<(f64, Moebius)>,
}

/// A descent from a map.
#[derive(Debug)]
pub struct Descent {
    from: Moebius,
    /// Takes the point of the source's disk about which small maps turn, half way between the middles, to 0.
    middle: Moebius,
    simplex: Simplex,
    pub count: usize,
    pub best: (f64, Moebius),
}

impl Descents {
    /// From these maps; `None` without any.
    pub fn new(mut from: VecDeque<(f64, Moebius)>, step: f64) -> Option<Self> {
        let first = from.pop_front()?;
        Some(Self { now: Descent::new(first, step, SMALL), coming: from, ended: Vec::new() })
    }

    /// Ends the descent and begins the next one; false if it was the last.
    pub fn next(&mut self, step: f64) -> bool {
        self.ended.push(self.now.best);
        let next = self.coming.pop_front().map(|from| Descent::new(from, step, SMALL));
        let Some(next) = next else { return false };
        self.now = next;
        true
    }

    /// The share that is done.
    pub fn share(&self) -> f64 {
        let now = self.now.count.min(MOST_DESCENT) as f64 / MOST_DESCENT as f64;
        let all = self.ended.len() + 1 + self.coming.len();
        (self.ended.len() as f64 + now) / all as f64
    }
}

impl Descent {
    /// From a map with its value, which is asked for if it is infinite.
    pub fn new(from: (f64, Moebius), step: f64, small: f64) -> Self {
        let simplex = Simplex::new((DVec3::ZERO, from.0), step, small);
        let half = Moebius::half_way(from.1.inverse().image(Complex64::ZERO));
        let middle = Moebius::to_middle(half).unwrap_or(Moebius::turn(0.0));
        Self { from: from.1, middle, simplex, count: 0, best: from }
    }

    /// The map with the small one at a place of the simplex within.
    fn map(&self, place: DVec3) -> Option<Moebius> {
        let DVec3 { x: turn, y, z } = place;
        let length = y.hypot(z);
        let a = if length > 0.0 { Complex64::new(y, z) * ((0.5 * length).tanh() / length) } else { Complex64::ZERO };
        let within = self.middle.inverse().after(&Moebius::small(turn, a)?).after(&self.middle);
        Some(self.from.after(&within))
    }

    /// The map whose value is wanted next; `None`: the simplex is small, or `most` values were taken.
    pub fn question(&self, most: usize) -> Option<Moebius> {
        if self.count >= most {
            return None;
        }
        self.map(self.simplex.question()?)
    }

    /// Takes the value of that map.
    pub fn answer(&mut self, value: f64) {
        self.count += 1;
        let map = self.simplex.question().and_then(|place| self.map(place));
        if let Some(map) = map.filter(|_| value < self.best.0) {
            self.best = (value, map);
        }
        self.simplex.answer(value);
    }
}
