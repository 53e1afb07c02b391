//! Carries a boundary point along when the outline changes.

use crate::geometry::DVec2;

/// The fraction of the length of the closed chain `new` that corresponds to `fraction` of `old`.
///
/// If both have the same number of vertices, the vertices correspond to each other, and the point stays at
/// the same part of the same edge. Otherwise it is moved to the nearest point of `new`.
pub fn carried_fraction(old: &[DVec2], new: &[DVec2], fraction: f64) -> f64 {
    let (edge, part) = place(old, fraction);
    if old.len() == new.len() {
        return fraction_at(new, edge, part);
    }
    let at = old[edge].lerp(old[(edge + 1) % old.len()], part);
    let (edge, part) = nearest(new, at);
    fraction_at(new, edge, part)
}

/// The edge of a closed chain nearest to `at`, and the part of it before the nearest point.
pub(super) fn nearest(chain: &[DVec2], at: DVec2) -> (usize, f64) {
    let on_edge = |k: usize| {
        let (a, d) = (chain[k], chain[(k + 1) % chain.len()] - chain[k]);
        let part = ((at - a).dot(d) / d.length_squared()).clamp(0.0, 1.0);
        ((a + part * d).distance_squared(at), k, part)
    };
    let best = (0..chain.len()).map(on_edge).min_by(|p, q| p.0.total_cmp(&q.0));
    best.map_or((0, 0.0), |(_, edge, part)| (edge, part))
}

fn lengths(chain: &[DVec2]) -> Vec<f64> {
    (0..chain.len()).map(|k| chain[k].distance(chain[(k + 1) % chain.len()])).collect()
}

fn place(chain: &[DVec2], fraction: f64) -> (usize, f64) {
    let lengths = lengths(chain);
    let mut left = fraction.rem_euclid(1.0) * lengths.iter().sum::<f64>();
    for (edge, &length) in lengths.iter().enumerate() {
        if left < length {
            return (edge, left / length);
        }
        left -= length;
    }
    (0, 0.0)
}

fn fraction_at(chain: &[DVec2], edge: usize, part: f64) -> f64 {
    let lengths = lengths(chain);
    let before: f64 = lengths[..edge].iter().sum();
    let fraction = (before + part * lengths[edge]) / lengths.iter().sum::<f64>();
    if fraction.is_finite() { fraction.rem_euclid(1.0) } else { 0.0 }
}
