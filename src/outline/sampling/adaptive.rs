//! Adaptive samples: with the density of [`Spacing`], near the target number, and forming a simple polygon.
//!
//! The base spacing H is chosen so that the spacing yields the target number;
//! corners (and the first vertex) are samples, and each piece between them gets
//! its share of the number. Where the chords would cut off too much of the area, or
//! cross each other, vertices of the outline are added as samples until they no longer do; in
//! the limit the chords are the outline itself.

use super::super::corners::CORNER_COSINE;
use super::arc::Arc;
use super::chords::{first_vertices_to_add, vertices_where_area_is_lost};
use super::spacing::{Spacing, Station, samples_between};
use super::uniform::apportion;
use crate::geometry::sort_by_number;
use std::ops::RangeInclusive;

/// Without a target, H starts at the perimeter divided by this, so a circle gets this many samples.
/// V-shape → blob has a mean image error of 9e-3 with 250, 1.5e-3 with 500.
const BASE_SAMPLES: f64 = 500.0;

/// Without a target, H is enlarged until no more than this many are needed: the
/// mesh of a spiky leaf then has about 5,000 vertices, prepared in 20 ms.
const ENOUGH_SAMPLES: f64 = 800.0;

/// Spacings are computed for at most this many samples; larger targets scale the result.
const LARGEST_FIELD: f64 = 1500.0;

/// The number of samples that the spacing yields may differ this much from the target.
const TOLERANCE: f64 = 0.1;

/// The largest number of steps in the search for H: three suffice for every outline tried.
const STEPS: usize = 5;

/// The first guess at d ln(number) / d ln(H): spiky outlines have −0.5, round ones −1.
const FIRST_SLOPE: f64 = -0.7;

/// H never exceeds the perimeter divided by this.
const LEAST_BASE_SAMPLES: f64 = 8.0;

/// All chords together cut off at most this share of the area, if that takes no more than [`MOST_ADDED`]: images then
/// cover 99.9 % of it. The turkey with its details has 1.0e-3 without this.
const CUT_OFF: f64 = 7e-4;

/// The largest share of samples added for that.
const MOST_ADDED: f64 = 0.04;

/// Rounds of adding vertices. Every round halves the chords
/// in question; 20 rounds resolve a chord over 10⁶ polygon edges.
const ROUNDS: usize = 24;

/// The arc lengths of the samples.
pub(super) fn positions(arc: &Arc, target: Option<u32>) -> Vec<f64> {
    let (length, sharp) = (arc.length(), arc.sharp_vertices(CORNER_COSINE));
    let search = |base: f64, most: f64, least: f64| spacing_between(arc, &sharp, base, least..=most);
    let (spacing, count) = match target {
        None => {
            let spacing = search(length / BASE_SAMPLES, ENOUGH_SAMPLES, 0.0);
            let count = spacing.count(length).clamp(BASE_SAMPLES, ENOUGH_SAMPLES);
            (spacing, count)
        }
        Some(target) => {
            let wanted = f64::from(target).min(LARGEST_FIELD);
            let base = length / wanted.max(LEAST_BASE_SAMPLES);
            (search(base, (1.0 + TOLERANCE) * wanted, (1.0 - TOLERANCE) * wanted), f64::from(target))
        }
    };
    let mut positions = place(&spacing, length, count.round() as usize);
    let most = ((1.0 + MOST_ADDED) * count) as usize;
    add_vertices(&mut positions, &|positions| {
        let mut more = vertices_where_area_is_lost(arc, positions, CUT_OFF);
        more.truncate(most.saturating_sub(positions.len()));
        more
    });
    add_vertices(&mut positions, &|positions| first_vertices_to_add(arc, positions));
    positions
}

/// Adds vertices of the outline in rounds, as long as `more` names some.
fn add_vertices(positions: &mut Vec<f64>, more: &dyn Fn(&[f64]) -> Vec<f64>) {
    for _ in 0..ROUNDS {
        let added = more(positions);
        if added.is_empty() {
            break;
        }
        positions.extend(added);
        positions.sort_unstable_by(f64::total_cmp);
        positions.dedup();
    }
}

/// Adjusts H, starting at `base`, until the spacing yields a number of samples in `wanted`.
///
/// ln(number) is nearly linear in ln H, with a slope between −1 (smooth) and
/// nearly 0 (corners only), so this is the secant method on it. [`place`] removes the remaining
/// difference by scaling.
fn spacing_between(arc: &Arc, sharp: &[usize], mut base: f64, wanted: RangeInclusive<f64>) -> Spacing {
    let length = arc.length();
    let mut spacing = Spacing::new(arc, sharp, base);
    let mut slope = FIRST_SLOPE;
    for _ in 0..STEPS {
        let count = spacing.count(length);
        if wanted.contains(&count) {
            break;
        }
        let aim = if count > *wanted.end() { 0.95 * wanted.end() } else { 1.05 * wanted.start() };
        let next = (base * (aim / count).powf(1.0 / slope)).min(length / LEAST_BASE_SAMPLES);
        if next == base {
            break;
        }
        spacing = Spacing::new(arc, sharp, next);
        slope = ((spacing.count(length) / count).ln() / (next / base).ln()).clamp(-1.0, -0.2);
        base = next;
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
        sort_by_number(&mut kept, |corner| corner.0);
        sort_by_number(&mut kept, |corner| -corner.1);
        kept.truncate(most);
        sort_by_number(&mut kept, |corner| corner.0);
    }
    kept.into_iter().map(|(s, _)| s).collect()
}
