//! Douglas and Peucker's simplification: a small subset of points that stays close to a chain.

use crate::geometry::DVec2;

/// The points of an open chain that remain: its ends, and those needed to keep every other one within
/// `tolerance` of the remaining chain. Ascending indices; cost O(n²) at worst, usually O(n log n).
pub fn simplified(chain: &[DVec2], tolerance: f64) -> Vec<usize> {
    let Some(last) = chain.len().checked_sub(1) else { return Vec::new() };
    let mut kept = vec![0, last];
    let mut spans = vec![(0, last)];
    while let Some((from, to)) = spans.pop() {
        if let Some((distance, k)) = farthest(chain, from, to)
            && distance > tolerance
        {
            kept.push(k);
            spans.extend([(from, k), (k, to)]);
        }
    }
    kept.sort_unstable();
    kept.dedup();
    kept
}

/// As [`simplified`], for a closed chain; at least three points remain of a chain that is not flat.
///
/// The chain is cut at the first point and the one farthest from it; a corner at the cut stays a corner, and
/// the first point remains even on a smooth piece.
pub fn simplified_ring(ring: &[DVec2], tolerance: f64) -> Vec<usize> {
    let Some(&first) = ring.first() else { return Vec::new() };
    let far = (0..ring.len()).max_by(|&i, &j| first.distance(ring[i]).total_cmp(&first.distance(ring[j]))).unwrap_or(0);
    let back: Vec<DVec2> = ring[far..].iter().copied().chain([first]).collect();
    let mut kept = simplified(&ring[..=far], tolerance);
    kept.extend(simplified(&back, tolerance).into_iter().map(|k| (k + far) % ring.len()));
    kept.sort_unstable();
    kept.dedup();
    if kept.len() < 3
        && let Some((_, k)) = farthest(ring, 0, far)
            .into_iter()
            .chain(farthest(&back, 0, back.len() - 1).map(|(d, k)| (d, k + far)))
            .max_by(|a, b| a.0.total_cmp(&b.0))
    {
        kept.push(k % ring.len());
        kept.sort_unstable();
        kept.dedup();
    }
    kept
}

/// The point strictly between two of a chain that is farthest from their segment, and its distance.
fn farthest(chain: &[DVec2], from: usize, to: usize) -> Option<(f64, usize)> {
    let (a, d) = (chain[from], chain[to] - chain[from]);
    let distance = |k: usize| {
        let along = (chain[k] - a).dot(d) / d.length_squared();
        let t = if along.is_finite() { along.clamp(0.0, 1.0) } else { 0.0 };
        chain[k].distance(a + t * d)
    };
    (from + 1..to).map(|k| (distance(k), k)).max_by(|p, q| p.0.total_cmp(&q.0))
}
