//! Adaptive samples: as dense as [`Spacing`] asks, as many as wanted, and simple.
//!
//! The base spacing H is chosen so that the spacing asks for the wanted number;
//! corners (and the first vertex) are samples, and each piece between them gets
//! its share of the number. Where the chords would cross each other, vertices of
//! the outline are added as samples until they do not; in the limit the chords are
//! the outline itself.

use super::arc::Arc;
use super::chords::first_vertices_to_add;
use super::spacing::{Spacing, Station, samples_between};
use super::uniform::apportion;

/// Without a target, H starts at the perimeter divided by this: what a circle gets.
const BASE_SAMPLES: f64 = 250.0;

/// Without a target, H is enlarged until no more than this many are needed: the
/// mesh of a spiky leaf then has about 5,000 vertices, prepared in 30 ms.
const ENOUGH_SAMPLES: f64 = 700.0;

/// Spacings are computed for at most this many samples, and scaled beyond.
const LARGEST_FIELD: f64 = 1500.0;

/// H never exceeds the perimeter divided by this.
const LEAST_BASE_SAMPLES: f64 = 8.0;

/// Rounds of adding vertices where chords cross. Every round halves the chords
/// in question; 20 take a chord of 10⁶ polygon edges apart.
const ROUNDS: usize = 24;

/// The arc lengths of the samples.
pub(super) fn positions(arc: &Arc, target: Option<u32>) -> Vec<f64> {
    let length = arc.length();
    let (spacing, count) = match target {
        None => {
            let spacing = Spacing::new(arc, length / BASE_SAMPLES);
            let count = spacing.count(length);
            if count > ENOUGH_SAMPLES {
                (spacing_for(arc, ENOUGH_SAMPLES, spacing), ENOUGH_SAMPLES)
            } else {
                (spacing, count.max(BASE_SAMPLES))
            }
        }
        Some(target) => {
            let wanted = f64::from(target).min(LARGEST_FIELD);
            let start = Spacing::new(arc, length / wanted.max(LEAST_BASE_SAMPLES));
            (spacing_for(arc, wanted, start), f64::from(target))
        }
    };
    let mut positions = place(&spacing, length, count.round() as usize);
    for _ in 0..ROUNDS {
        let more = first_vertices_to_add(arc, &positions);
        if more.is_empty() {
            break;
        }
        positions.extend(more);
        positions.sort_unstable_by(f64::total_cmp);
        positions.dedup();
    }
    positions
}

/// Adjusts H, from the spacing `start` on, until the spacing asks for about `wanted` samples.
///
/// The number is nearly α/H + β, with β for the corners, so a step in proportion falls
/// short: it is repeated. What is left, [`place`] makes up for by scaling.
fn spacing_for(arc: &Arc, wanted: f64, start: Spacing) -> Spacing {
    let length = arc.length();
    let mut spacing = start;
    let mut base = length / wanted.max(LEAST_BASE_SAMPLES);
    for _ in 0..5 {
        let ratio = spacing.count(length) / wanted;
        if (0.9..1.1).contains(&ratio) {
            break;
        }
        let next = (base * ratio.clamp(0.3, 4.0)).min(length / LEAST_BASE_SAMPLES);
        if next == base {
            break;
        }
        base = next;
        spacing = Spacing::new(arc, base);
    }
    spacing
}

/// `count` arc lengths with the density 1/h, among them 0 and the corners.
fn place(spacing: &Spacing, length: f64, count: usize) -> Vec<f64> {
    let mut fixed = sharpest(&spacing.corners, count / 2);
    fixed.insert(0, 0.0);
    let stations = &spacing.stations;
    let mut cumulative = vec![0.0];
    for k in 0..stations.len() {
        cumulative.push(cumulative[k] + samples_between(stations[k], spacing.station_after(k, length)));
    }
    let at_station = |s: f64| cumulative[stations.partition_point(|station| station.s < s)];
    let ends: Vec<f64> = fixed.iter().map(|&s| at_station(s)).chain([cumulative[stations.len()]]).collect();
    let parts = apportion(&ends.windows(2).map(|w| w[1] - w[0]).collect::<Vec<_>>(), count);
    let mut positions = Vec::with_capacity(count);
    let mut k = 0;
    for (i, &s) in fixed.iter().enumerate() {
        positions.push(s);
        for j in 1..parts[i] {
            let wanted = ends[i] + (ends[i + 1] - ends[i]) * (j as f64 / parts[i] as f64);
            while cumulative[k + 1] <= wanted {
                k += 1;
            }
            positions.push(invert(stations[k], spacing.station_after(k, length), wanted - cumulative[k]));
        }
    }
    positions
}

/// The arc length at which `∫ ds/h` from station `a` is `part`, for h linear up to `b`.
fn invert(a: Station, b: Station, part: f64) -> f64 {
    let slope = (b.h - a.h) / (b.s - a.s);
    let grown = if slope.abs() < 1e-9 { part } else { (slope * part).exp_m1() / slope };
    (a.s + a.h * grown).min(b.s)
}

/// The arc lengths of the `most` sharpest corners, in order.
fn sharpest(corners: &[(f64, f64)], most: usize) -> Vec<f64> {
    let mut kept = corners.to_vec();
    if kept.len() > most {
        kept.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.total_cmp(&b.0)));
        kept.truncate(most);
        kept.sort_by(|a, b| a.0.total_cmp(&b.0));
    }
    kept.into_iter().map(|(s, _)| s).collect()
}
