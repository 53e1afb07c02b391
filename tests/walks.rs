//! Random walks compared with harmonic measure. The seeds are fixed, so that no test fails by chance.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::{HarmonicMeasure, HitCounts, MAX_JUMPS, PrepareSettings, PreparedSide, Walker, poisson_kernel};
use riemap::exact::{complex, disk};
use riemap::geometry::DVec2;
use riemap::mesh::locate;
use riemap::outline::{BoundaryPoint, Preset};
use std::f64::consts::TAU;
use support::domains::domain;

const WALKS: u32 = 40_000;
const BINS: usize = 32;
const START: BoundaryPoint = BoundaryPoint::new(0, 0.0);

/// χ² with 31 degrees of freedom exceeds this value for one in 1000 seeds.
const CHI_SQUARE: f64 = 61.1;

fn measure(domain: &PreparedSide, x: DVec2, anchor: BoundaryPoint) -> HarmonicMeasure {
    let located = locate(domain.domain().unwrap().mesh(), x, None).unwrap();
    let psi = poisson_kernel(domain, located).unwrap();
    HarmonicMeasure::new(domain.domain().unwrap().samples(), &psi, anchor)
}

/// Asserts that every bin is within 4.5 √(N p (1 − p)) of N p (exceeded once in 5,000 for all bins), plus an
/// allowance for the error of the measure.
fn assert_counts_follow(counts: &HitCounts, expected: &[f64], measure_error: f64) {
    let total = counts.total() as f64;
    for (bin, (&count, &share)) in counts.counts().iter().zip(expected).enumerate() {
        let bound = 4.5 * (total * share * (1.0 - share)).sqrt() + total * measure_error + 1.0;
        let off = (count as f64 - total * share).abs();
        assert!(off <= bound, "bin {bin}: {count} hits, expected {:.1} ± {bound:.1}", total * share);
    }
}

#[test]
fn walks_from_the_centre_of_the_disk_hit_evenly() {
    let disk = domain(Preset::Disk, PrepareSettings::default());
    let mut counts =
        HitCounts::by_arc_length(disk.domain().unwrap().samples(), &measure(&disk, DVec2::ZERO, START), BINS);
    let mut walker = Walker::new(disk.domain().unwrap().samples().points(), DVec2::ZERO, 20_261).unwrap();
    for _ in 0..WALKS {
        counts.record(walker.walk());
    }
    let even = [1.0 / BINS as f64; BINS];
    assert_counts_follow(&counts, &even, 0.0);
    let mean = f64::from(WALKS) / BINS as f64;
    let chi_square: f64 = counts.counts().iter().map(|&c| (c as f64 - mean).powi(2) / mean).sum();
    println!("disk, centre: χ² = {chi_square:.1}, with the measure's own shares {:.1}", counts.chi_square());
    assert!(chi_square < CHI_SQUARE, "{chi_square}");
}

#[test]
fn walks_from_a_point_of_the_disk_follow_the_closed_form() {
    let (disk, x) = (domain(Preset::Disk, PrepareSettings::default()), DVec2::new(0.6, 0.2));
    let anchor = disk.domain().unwrap().samples().nearest(DVec2::X);
    let mut counts = HitCounts::by_arc_length(disk.domain().unwrap().samples(), &measure(&disk, x, anchor), BINS);
    let mut walker = Walker::new(disk.domain().unwrap().samples().points(), x, 5).unwrap();
    for _ in 0..WALKS {
        counts.record(walker.walk());
    }
    let exact = |bin: usize| disk::harmonic_measure(complex(x), TAU * bin as f64 / BINS as f64);
    let expected: Vec<f64> = (0..BINS).map(|bin| exact(bin + 1) - exact(bin)).collect();
    assert_counts_follow(&counts, &expected, 0.0);
    // a part of the boundary with little measure from x, and one next to x
    assert!(expected[BINS / 2] < 0.01 && expected[1] > 0.1, "{expected:.3?}");
    let own: f64 = counts.expected().iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(own < 1e-3, "the kernel's shares are {own:e} off");
}

#[test]
fn walks_in_presets_follow_the_kernel() {
    for preset in [Preset::Gingerbread, Preset::LShape, Preset::Cinquefoil, Preset::Star] {
        let domain = domain(preset, PrepareSettings::default());
        let x = domain
            .domain()
            .unwrap()
            .nearest_inside(domain.domain().unwrap().default_point() + DVec2::new(0.07, -0.05), 0.01);
        let anchor = domain.at_fraction(0.37);
        let measure = measure(&domain, x, anchor);
        let mut by_length = HitCounts::by_arc_length(domain.domain().unwrap().samples(), &measure, BINS);
        let mut by_measure = HitCounts::by_measure(&measure, BINS);
        let mut walker = Walker::new(domain.domain().unwrap().samples().points(), x, 11).unwrap();
        let start = std::time::Instant::now();
        let hits: Vec<BoundaryPoint> = (0..WALKS).map(|_| walker.walk()).collect();
        let us = start.elapsed().as_secs_f64() * 1e6 / f64::from(WALKS);
        for hit in hits {
            by_length.record(hit);
            by_measure.record(hit);
        }
        let (name, m) = (preset.name(), domain.boundary_count());
        println!(
            "{name}, m = {m}: {us:.2} µs a walk; χ² = {:.1} by length, {:.1} by measure",
            by_length.chi_square(),
            by_measure.chi_square()
        );
        // the measure under the default settings is accurate to 1e-3
        assert_counts_follow(&by_length, by_length.expected(), 1e-3);
        assert_counts_follow(&by_measure, by_measure.expected(), 1e-3);
        let sum: f64 = by_length.expected().iter().sum();
        assert!((sum - 1.0).abs() < 1e-12, "{name}: {sum}");
    }
}

#[test]
fn walks_end_everywhere() {
    for preset in Preset::ALL {
        let domain = domain(preset, PrepareSettings::default());
        let mut walker =
            Walker::new(domain.domain().unwrap().samples().points(), domain.domain().unwrap().default_point(), 1)
                .unwrap();
        let (mut jumps, mut longest, walks) = (0_u64, 0, 5000);
        let start = std::time::Instant::now();
        for _ in 0..walks {
            let mut before = 0;
            while let riemap::conformal::WalkStep::Jump(_) = walker.step() {
                before = walker.jumps();
            }
            jumps += u64::from(before);
            longest = longest.max(before);
        }
        let us = start.elapsed().as_secs_f64() * 1e6 / f64::from(walks);
        let mean = jumps as f64 / f64::from(walks);
        println!("{}: {mean:.1} jumps on average, {longest} at most, {us:.2} µs a walk", preset.name());
        assert!(longest < MAX_JUMPS / 4, "{}: a walk of {longest} jumps", preset.name());
    }
}
