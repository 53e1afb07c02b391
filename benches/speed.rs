//! Preparation and frame times, one thread, for the paper's settings and the defaults.
//!
//! `cargo bench` prints a criterion figure per preset and setting; the targets are
//! in the README's table.

#![allow(missing_docs, clippy::unwrap_used, reason = "a benchmark")]

use criterion::{Criterion, criterion_group, criterion_main};
use riemap::conformal::{ConformalMap, Constraints, Direction, PrepareSettings, PreparedDomain, prepare};
use riemap::geometry::DVec2;
use riemap::mesh::Sizing;
use riemap::outline::{Preset, Sampling};
use std::hint::black_box;
use std::sync::Arc;

fn paper(preset: Preset) -> Option<PrepareSettings> {
    let count = preset.paper_samples()?;
    Some(PrepareSettings { sampling: Sampling::Uniform { count, keep_corners: false }, sizing: Sizing::Uniform })
}

fn preparation(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("prepare");
    group.sample_size(10);
    for preset in Preset::ALL {
        let outline = preset.outline();
        let settings = [("default", Some(PrepareSettings::default())), ("paper", paper(preset))];
        for (name, settings) in settings.into_iter().filter_map(|(name, s)| Some((name, s?))) {
            group.bench_function(format!("{}/{name}", preset.name()), |bencher| {
                bencher.iter(|| prepare(black_box(&outline.polygon), &settings, &mut |_| ()).unwrap());
            });
        }
    }
    group.finish();
}

/// A drag of x₁: kernel, matching and extension of a backward map onto the preset.
fn frame(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("frame");
    group.sample_size(20);
    let disk = prepared(Preset::Disk, PrepareSettings::default());
    for preset in Preset::ALL {
        let settings = [("default", Some(PrepareSettings::default())), ("paper", paper(preset))];
        for (name, settings) in settings.into_iter().filter_map(|(name, s)| Some((name, s?))) {
            let target = prepared(preset, settings);
            let at = |x: f64| Constraints {
                source_point: disk.pole,
                target_point: target.pole + DVec2::new(x, 0.0),
                source_anchor: 0.0,
                target_anchor: 0.0,
            };
            let mut map = ConformalMap::new(disk.clone(), target.clone(), &at(0.0), Direction::Backward).unwrap();
            let mut step = 0.0;
            group.bench_function(format!("{}/{name}", preset.name()), |bencher| {
                bencher.iter(|| {
                    step = 1e-3 - step;
                    map.update(&at(step), Direction::Backward).unwrap();
                });
            });
        }
    }
    group.finish();
}

fn prepared(preset: Preset, settings: PrepareSettings) -> Arc<PreparedDomain> {
    Arc::new(prepare(&preset.outline().polygon, &settings, &mut |_| ()).unwrap())
}

criterion_group!(benches, preparation, frame);
criterion_main!(benches);
