//! Samples equally spaced in arc length, with or without the outline's corners.

use super::super::corners::CORNER_COSINE;
use super::SamplingError;
use super::arc::Arc;
use crate::geometry::sort_by_number;

/// The arc lengths `k L / count`.
pub(super) fn equal(arc: &Arc, count: u32) -> Vec<f64> {
    (0..count).map(|k| arc.length() * (f64::from(k) / f64::from(count))).collect()
}

/// `count` arc lengths that contain the first vertex and every corner; the
/// pieces between corners are divided equally, each into nearly
/// `count · length / L` parts.
pub(super) fn with_corners(arc: &Arc, count: u32) -> Result<Vec<f64>, SamplingError> {
    let mut corners = arc.sharp_vertices(CORNER_COSINE);
    corners.insert(0, 0);
    if corners.len() > count as usize {
        return Err(SamplingError::MoreCornersThanSamples { corners: corners.len(), count });
    }
    let end = |i: usize| corners.get(i + 1).map_or(arc.length(), |&k| arc.at_vertex(k));
    let lengths: Vec<f64> = (0..corners.len()).map(|i| end(i) - arc.at_vertex(corners[i])).collect();
    let parts = apportion(&lengths, count as usize);
    let piece = |i: usize| {
        let (start, parts) = (arc.at_vertex(corners[i]), parts[i]);
        (0..parts).map(move |j| start + (end(i) - start) * (j as f64 / parts as f64))
    };
    Ok((0..corners.len()).flat_map(piece).collect())
}

/// Divides `count` parts among the pieces, at least one each, nearly in proportion
/// to their lengths (largest remainder; ties go to the first).
pub(super) fn apportion(lengths: &[f64], count: usize) -> Vec<usize> {
    let free = count.saturating_sub(lengths.len());
    let total: f64 = lengths.iter().sum();
    // one part of the quota is given in advance, the least that every piece gets
    let quota = |length: f64| (length / total * count as f64 - 1.0).max(0.0);
    let needed: f64 = lengths.iter().map(|&l| quota(l)).sum();
    let share: Vec<f64> = lengths.iter().map(|&l| quota(l) * (free as f64 / needed.max(f64::MIN_POSITIVE))).collect();
    let mut parts: Vec<usize> = share.iter().map(|s| 1 + s.floor() as usize).collect();
    let mut by_remainder: Vec<usize> = (0..lengths.len()).collect();
    sort_by_number(&mut by_remainder, |&i| -share[i].fract());
    let left = count.saturating_sub(parts.iter().sum());
    by_remainder.iter().cycle().take(left).for_each(|&i| parts[i] += 1);
    parts
}
