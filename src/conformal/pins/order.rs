//! The order of pins around the two boundaries.

use super::{PinError, Side};
use crate::conformal::PerSide;

/// Fractions of a boundary's length that differ by less are one place.
const SAME: f64 = 1e-12;

/// Checks that the pins differ on each side and run around both in one order.
pub fn check(pairs: &[PerSide<f64>]) -> Result<(), PinError> {
    for side in Side::BOTH {
        let same = |i: usize, j: usize| is_same(pairs[i][side], pairs[j][side]);
        let pairs_of = (0..pairs.len()).flat_map(|j| (0..j).map(move |i| [i, j]));
        if let Some(pins) = pairs_of.into_iter().find(|&[i, j]| same(i, j)) {
            return Err(PinError::Coinciding { pins: pins.map(|k| k + 1), side });
        }
    }
    // two cyclic orders differ if those of three pins do, one of which may be the first
    let others = (1..pairs.len()).flat_map(|k| (1..k).map(move |j| [0, j, k]));
    for pins in others {
        let [source, target] = Side::BOTH.map(|side| is_counter_clockwise(pins.map(|k| pairs[k][side])));
        if source != target {
            let counter_clockwise = if source { Side::Source } else { Side::Target };
            return Err(PinError::Order { pins: pins.map(|k| k + 1), counter_clockwise });
        }
    }
    Ok(())
}

/// Whether two fractions are one place.
pub fn is_same(a: f64, b: f64) -> bool {
    let gap = (a - b).rem_euclid(1.0);
    gap.min(1.0 - gap) < SAME
}

/// Whether three places of a boundary are met in this order on the way around it counter-clockwise.
pub fn is_counter_clockwise([a, b, c]: [f64; 3]) -> bool {
    (b - a).rem_euclid(1.0) < (c - a).rem_euclid(1.0)
}

/// The three pins that are farthest from each other, by the smallest gap on either side.
pub fn spread(pairs: &[PerSide<f64>]) -> [usize; 3] {
    let gap = |i: usize, j: usize| {
        let along = Side::BOTH.map(|side| (pairs[i][side] - pairs[j][side]).rem_euclid(1.0));
        along.into_iter().map(|gap| gap.min(1.0 - gap)).fold(1.0, f64::min)
    };
    let count = pairs.len();
    let triples = (0..count).flat_map(|i| (i + 1..count).flat_map(move |j| (j + 1..count).map(move |k| [i, j, k])));
    let least = |&[i, j, k]: &[usize; 3]| gap(i, j).min(gap(j, k)).min(gap(i, k));
    triples.max_by(|a, b| least(a).total_cmp(&least(b))).unwrap_or([0, 1, 2])
}
