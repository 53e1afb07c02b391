//! Pairs of boxes that overlap, by a sweep over x.

use crate::geometry::{Bounds, sort_by_number};

/// Limit on pairs over the same x, 0.1 s; a coastline of 1,500 chords has 2e4 of them, the worst preset 1e5.
const BUDGET: usize = 20_000_000;

/// Calls `visit` for pairs of boxes that overlap. Returns false, with pairs left out, if there are too many over the
/// same x. Cost O(m c) with c boxes over the same x.
pub(super) fn for_each_overlap(boxes: &[Bounds], visit: &mut dyn FnMut(usize, usize)) -> bool {
    let (low, high) = (|k: u32| boxes[k as usize].min(), |k: u32| boxes[k as usize].max());
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    sort_by_number(&mut order, |&k| low(k).x);
    let mut active: Vec<u32> = Vec::new();
    let mut budget = BUDGET;
    for k in order {
        let (from, to) = (low(k), high(k));
        let Some(left) = budget.checked_sub(active.len()) else { return false };
        budget = left;
        active.retain(|&j| high(j).x >= from.x);
        for &j in active.iter().filter(|&&j| low(j).y <= to.y && high(j).y >= from.y) {
            visit(j as usize, k as usize);
        }
        active.push(k);
    }
    true
}
