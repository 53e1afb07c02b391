//! Boundary vertices between others, so that the lengths of neighboring edges grow gradually.

/// The largest change of the edge length per arc length, that of adaptive samples.
const GRADATION: f64 = 0.3;

/// For each of the intervals between `ends` on a closed curve of `length`, the places of the vertices to insert,
/// ascending; none in the intervals that `keep` names. The length aimed at is at each end the geometric mean of its
/// two intervals, at least `finest`, lowered where a neighbor's is smaller by more than its distance allows.
pub(super) fn between(ends: &[f64], length: f64, finest: f64, keep: impl Fn(usize) -> bool) -> Vec<Vec<f64>> {
    let count = ends.len();
    let interval = |k: usize| if k + 1 < count { ends[k + 1] - ends[k] } else { length - ends[k] + ends[0] }.max(0.0);
    let mean = |k: usize| (interval(k) * interval((k + count - 1) % count)).sqrt();
    let mut sizes: Vec<f64> = (0..count).map(|k| mean(k).max(finest)).collect();
    // twice around: the limiting interval may lie on the other side of the start
    for k in 1..2 * count {
        let limit = sizes[(k - 1) % count] + GRADATION * interval((k - 1) % count);
        sizes[k % count] = sizes[k % count].min(limit);
    }
    for k in (0..2 * count - 1).rev() {
        sizes[k % count] = sizes[k % count].min(sizes[(k + 1) % count] + GRADATION * interval(k % count));
    }
    (0..count)
        .map(|k| if keep(k) { Vec::new() } else { divide(ends[k], interval(k), sizes[k], sizes[(k + 1) % count]) })
        .collect()
}

/// Divides an interval into parts that grow from `a` at its start and from `b` at its end.
fn divide(start: f64, length: f64, a: f64, b: f64) -> Vec<f64> {
    // the two growing sizes meet here
    let middle = (0.5 * (length + (b - a) / GRADATION)).clamp(0.0, length);
    let parts = |size: f64, length: f64| (GRADATION * length / size).ln_1p() / GRADATION;
    let (rising, falling) = (parts(a, middle), parts(b, length - middle));
    let count = (rising + falling).round().max(1.0);
    let grown = |size: f64, parts: f64| size * (GRADATION * parts).exp_m1() / GRADATION;
    (1..count as usize)
        .map(|j| {
            let part = (rising + falling) * j as f64 / count;
            if part < rising { start + grown(a, part) } else { start + length - grown(b, rising + falling - part) }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_grow_gradually_from_a_short_edge() {
        let ends = [0.0, 0.5, 0.5 + 1e-6, 1.0];
        let added = between(&ends, 2.0, 1e-9, |_| false);
        let mut all: Vec<f64> = ends.iter().copied().chain(added.into_iter().flatten()).collect();
        all.sort_unstable_by(f64::total_cmp);
        let edges: Vec<f64> = all.windows(2).map(|w| w[1] - w[0]).collect();
        // next to the short edge itself the length is the geometric mean
        let others: Vec<f64> = edges.iter().copied().filter(|&e| e > 2e-6).collect();
        let worst = others.windows(2).map(|w| (w[0] / w[1]).max(w[1] / w[0])).fold(0.0, f64::max);
        assert!(edges.iter().all(|&e| e > 0.0) && worst < 1.5, "{worst}");
        assert!(all.len() > 30 && all.len() < 100, "{}", all.len());
    }

    #[test]
    fn equal_edges_are_left_alone() {
        let ends: Vec<f64> = (0..20).map(f64::from).collect();
        assert!(between(&ends, 20.0, 1e-9, |_| false).iter().all(Vec::is_empty));
    }
}
