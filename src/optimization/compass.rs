//! The compass search in the plane (Kolda, Lewis & Torczon, SIAM Review 45 (2003)), as questions and answers.
//!
//! The four places at a distance along the axes are tried. The first that is better than the middle becomes the middle; after
//! four that are not the distance is halved. Guaranteed: the best place is never worse than the first one.

use crate::geometry::DVec2;

/// The directions, in the order in which they are tried.
const DIRECTIONS: [DVec2; 4] = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];

/// A search, at first for the value of its first place.
#[derive(Debug, Clone)]
pub struct Compass {
    best: (DVec2, f64),
    step: f64,
    smallest: f64,
    direction: usize,
    /// Directions that were no better since the middle or the distance changed.
    failed: usize,
    is_first_known: bool,
}

impl Compass {
    /// Begins at `first` with the distance `step`; ends at the distance `smallest`.
    pub fn new(first: DVec2, step: f64, smallest: f64) -> Self {
        Self { best: (first, f64::INFINITY), step, smallest, direction: 0, failed: 0, is_first_known: false }
    }

    /// The place whose value is wanted next; `None`: the distance is small.
    pub fn question(&self) -> Option<DVec2> {
        let offset = if self.is_first_known { self.step * DIRECTIONS[self.direction] } else { DVec2::ZERO };
        (self.step > self.smallest).then_some(self.best.0 + offset)
    }

    /// Takes the value at the place of the question; whether it is the best so far.
    pub fn answer(&mut self, value: f64) -> bool {
        let is_better = value < self.best.1;
        match self.question() {
            Some(place) if is_better => (self.best, self.failed) = ((place, value), 0),
            _ if !self.is_first_known => {}
            _ => {
                self.direction = (self.direction + 1) % DIRECTIONS.len();
                self.failed += 1;
            }
        }
        if self.failed == DIRECTIONS.len() {
            (self.step, self.failed) = (0.5 * self.step, 0);
        }
        self.is_first_known = true;
        is_better
    }

    /// The best place so far.
    pub fn best(&self) -> DVec2 {
        self.best.0
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn lowest(f: impl Fn(DVec2) -> f64, first: DVec2) -> (DVec2, usize) {
        let mut compass = Compass::new(first, 0.3, 1e-4);
        let mut count = 0;
        while let Some(place) = compass.question() {
            let better = f(place) < f(compass.best()) || count == 0;
            assert_eq!(compass.answer(f(place)), better, "{place}");
            count += 1;
            assert!(count < 1000, "it does not end");
        }
        (compass.best(), count)
    }

    #[test]
    fn a_skew_valley_is_followed_to_its_bottom() {
        let bottom = DVec2::new(0.31, -0.72);
        let skew = |p: DVec2| {
            let d = p - bottom;
            d.x * d.x + d.x * d.y + 2.0 * d.y * d.y
        };
        let (place, count) = lowest(skew, DVec2::ZERO);
        assert!(place.distance(bottom) < 5e-4 && count < 150, "{place} after {count}");
    }

    #[test]
    fn places_without_a_value_are_avoided() {
        let wall = |p: DVec2| if p.x < 0.1 { f64::INFINITY } else { p.length() };
        let (place, _) = lowest(wall, DVec2::new(0.4, 0.3));
        assert!(place.distance(DVec2::new(0.1, 0.0)) < 1e-3, "{place}");
    }
}
