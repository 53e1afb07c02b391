//! The spacing h(s) of adaptive samples, as a function of arc length.
//!
//! h(s) is the least of: the base spacing H; the longest chord from which the outline
//! deviates by at most 3.75 % of its length ([`SAGITTA`]; on a circle of radius R
//! that is h = 0.3 R, at a corner the floor H/50); a quarter of the width of the
//! domain across s. It is then lowered so that |dh/ds| ≤ 0.3. Deviations are measured on
//! windows as long as the spacing in question, so that wiggles much smaller than
//! the spacing do not count and wiggles of its size do.
//! Cost O(L/H), whatever the number of polygon vertices.

use super::super::corners::CORNER_COSINE;
use super::arc::Arc;
use super::width::limit_by_width;
use crate::geometry::{DVec2, sort_by_number};

/// The finest spacing is H divided by this. At a re-entrant right angle the
/// density has the singularity r^(−1/3): with 50 its share of the error is below
/// that of the smooth parts at m = 250, with 10 it is not.
const FLOOR: f64 = 50.0;

/// Largest `|dh/ds|`: neighbouring edges differ by less than a factor of 1.35.
const GRADATION: f64 = 0.3;

/// Deviation from a chord relative to its length: h²/(8R) / h at h = 0.3 R.
const SAGITTA: f64 = 0.3 / 8.0;

/// The outline is tabulated at steps of H/64, so that windows are whole numbers of steps.
pub(super) const STEPS: usize = 64;

/// Stations are this many steps apart.
const STATION: usize = 4;

/// A place on the outline, by arc length, and the spacing there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Station {
    pub s: f64,
    pub h: f64,
}

/// The outline tabulated at equal steps of arc length.
pub(super) struct Table {
    /// The last [`STEPS`] points, then all points, then the first [`STEPS`] again.
    padded: Vec<DVec2>,
    /// The number of steps around.
    pub count: usize,
    /// The arc length of one step.
    pub step: f64,
}

impl Table {
    /// Tabulates with steps of about `base/64`, so that their number is a multiple of [`STATION`].
    fn new(arc: &Arc, base: f64) -> Self {
        let stations = (arc.length() / base * (STEPS / STATION) as f64).ceil().max(32.0);
        let count = stations as usize * STATION;
        let step = arc.length() / count as f64;
        let mut edge = 0;
        let mut points = Vec::with_capacity(count);
        for i in 0..count {
            let s = i as f64 * step;
            edge = arc.advance(edge, s);
            points.push(arc.point_on(edge, s));
        }
        let around = (0..count + 2 * STEPS).map(|i| points[(i + count * STEPS - STEPS) % count]);
        Self { padded: around.collect(), count, step }
    }

    /// The point at step `i`, up to [`STEPS`] beyond either end.
    pub fn at(&self, i: isize) -> DVec2 {
        self.padded[(i + STEPS as isize) as usize]
    }

    /// The largest distance from the chord over `2 half` steps around step `i`, at up to seven places.
    fn deviation(&self, i: usize, half: usize) -> f64 {
        let window = &self.padded[i + STEPS - half..=i + STEPS + half];
        let (a, b) = (window[0], window[2 * half]);
        let chord = b - a;
        let length2 = chord.length_squared();
        let stride = (half / 4).max(1);
        let mut worst = 0.0f64;
        for &p in window[1..2 * half].iter().skip(stride - 1).step_by(stride) {
            let offset = p - a;
            let along = offset.dot(chord);
            // the foot is beyond the ends of the chord: the outline has folded back
            let d2 = if along < 0.0 || along > length2 {
                offset.length_squared().min((p - b).length_squared())
            } else {
                let cross = offset.perp_dot(chord);
                cross * cross / length2
            };
            worst = worst.max(d2);
        }
        worst.sqrt()
    }
}

/// The spacing all around, and the corners that have to be samples.
pub(super) struct Spacing {
    /// The stations in order of arc length, the first at 0.
    pub stations: Vec<Station>,
    /// Arc lengths and exterior angles of the corners.
    pub corners: Vec<(f64, f64)>,
}

impl Spacing {
    /// The spacing with base spacing `base`; `sharp` are the vertices that may be corners.
    pub fn new(arc: &Arc, sharp: &[usize], base: f64) -> Self {
        let table = Table::new(arc, base);
        let floor = base / FLOOR;
        let mut at_stations: Vec<f64> =
            (0..table.count).step_by(STATION).map(|i| by_curvature(&table, i, base).max(floor)).collect();
        limit_by_width(&table, STATION, base, floor, &mut at_stations);
        let corners = corners(arc, sharp, floor);
        let regular = at_stations.iter().enumerate().map(|(k, &h)| Station { s: (k * STATION) as f64 * table.step, h });
        let mut stations: Vec<Station> = regular.chain(corners.iter().map(|&(s, _)| Station { s, h: floor })).collect();
        sort_by_number(&mut stations, |station| station.s);
        limit_gradation(&mut stations, arc.length());
        Self { stations, corners }
    }

    /// `∫ ds/h`: the number of samples that this spacing yields.
    pub fn count(&self, length: f64) -> f64 {
        let n = self.stations.len();
        (0..n).map(|k| samples_between(self.stations[k], self.station_after(k, length))).sum()
    }

    /// The station after `k`; after the last one, the first at `length`.
    pub fn station_after(&self, k: usize, length: f64) -> Station {
        self.stations.get(k + 1).copied().unwrap_or(Station { s: length, h: self.stations[0].h })
    }
}

/// `∫ ds/h` for h linear between two stations.
pub(super) fn samples_between(a: Station, b: Station) -> f64 {
    let (ds, ratio) = (b.s - a.s, b.h / a.h);
    // ln(ratio)/(ratio − 1) loses its digits near 1, where the mean is as good
    if (ratio - 1.0).abs() < 1e-4 { 2.0 * ds / (a.h + b.h) } else { ds * ratio.ln() / (b.h - a.h) }
}

/// The spacing that the shape of the outline around step `i` allows, at most `base`.
fn by_curvature(table: &Table, i: usize, base: f64) -> f64 {
    let mut half = STEPS / 2;
    let mut coarser = None;
    loop {
        let h = 2.0 * half as f64 * table.step;
        let deviation = table.deviation(i, half);
        if deviation <= SAGITTA * h {
            // between this window and the next coarser one the deviation grows like h²
            return coarser.map_or(base, |(h2, d2): (f64, f64)| (SAGITTA * h2 * h2 / d2).clamp(h, h2)).min(base);
        }
        coarser = Some((h, deviation));
        half /= 2;
        if half == 0 {
            return (SAGITTA * h * h / deviation).min(h);
        }
    }
}

/// Vertices where the outline turns sharply both at the vertex and over twice the floor
/// around it (so sharp wiggles below the floor are not corners). Of corners closer
/// to each other than a quarter of the floor the first is taken.
fn corners(arc: &Arc, sharp: &[usize], floor: f64) -> Vec<(f64, f64)> {
    let length = arc.length();
    let mut corners: Vec<(f64, f64)> = Vec::new();
    for &k in sharp {
        let (s, p) = (arc.at_vertex(k), arc.vertices()[k]);
        let before = arc.point((s - floor).rem_euclid(length));
        let after = arc.point((s + floor).rem_euclid(length));
        let turn = (p - before).angle_to(after - p).abs();
        let last = corners.last().map_or(0.0, |c| c.0);
        if turn.cos() < CORNER_COSINE && s - last > 0.25 * floor && length - s > 0.25 * floor {
            corners.push((s, turn));
        }
    }
    corners
}

/// Lowers the spacing until it changes by at most [`GRADATION`] per arc length.
fn limit_gradation(stations: &mut [Station], length: f64) {
    let n = stations.len();
    let mut relax = |from: usize, to: usize| {
        let ds = (stations[to].s - stations[from].s).abs();
        let ds = ds.min(length - ds);
        stations[to].h = stations[to].h.min(stations[from].h + GRADATION * ds);
    };
    // twice around: the limiting station may lie on the other side of the first point
    (0..2 * n).for_each(|k| relax(k % n, (k + 1) % n));
    (0..2 * n).rev().for_each(|k| relax((k + 1) % n, k % n));
}
