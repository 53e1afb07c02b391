//! Preparation and frame times on one thread, with the paper's settings and with the defaults; the integral kernel's
//! factor and measure, also on coasts of up to 1,536 corners; a drag of a pin;
//! Cauchy–Green time per term (vertex × sample) on `RAYON_NUM_THREADS` threads.
//!
//! `cargo bench` prints criterion's results for each preset and setting; the targets are
//! in the README's table.

#![allow(missing_docs, clippy::unwrap_used, reason = "a benchmark")]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use riemap::boundary_integral::{BoundaryIntegral, Settings};
use riemap::conformal::{
    BoundaryValues, CauchyGreen, ConformalMap, Constraints, Contour, Direction, KernelMode, MapSettings, PerSide, Pins,
    PrepareSettings, PreparedSide, Side, prepare, prepare_curve,
};
use riemap::figures::coast;
use riemap::geometry::{Curve, DVec2};
use riemap::mesh::Sizing;
use riemap::outline::{Preset, Sampling};
use std::hint::black_box;
use std::ops::ControlFlow;
use std::sync::Arc;

fn paper(preset: Preset) -> Option<PrepareSettings> {
    let count = preset.paper_samples()?;
    Some(PrepareSettings::new(Sampling::Uniform { count, keep_corners: false }, Sizing::Uniform))
}

fn preparation(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("prepare");
    group.sample_size(10);
    for preset in Preset::ALL {
        let outline = preset.outline();
        let settings = [("default", Some(PrepareSettings::default())), ("paper", paper(preset))];
        for (name, settings) in settings.into_iter().filter_map(|(name, s)| Some((name, s?))) {
            group.bench_function(format!("{}/{name}", preset.name()), |bencher| {
                bencher.iter(|| prepare(black_box(outline.polygon()), &settings, &mut |_| ()).unwrap());
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
            let at = |x: f64| {
                Constraints::new(
                    (disk.default_point(), 0.0),
                    (target.domain().unwrap().default_point() + DVec2::new(x, 0.0), 0.0),
                )
            };
            let mut map = ConformalMap::new(disk.clone(), target.clone(), &at(0.0), MapSettings::default()).unwrap();
            let mut step = 0.0;
            group.bench_function(format!("{}/{name}", preset.name()), |bencher| {
                bencher.iter(|| {
                    step = 1e-3 - step;
                    map.update(&at(step), MapSettings::default()).unwrap();
                });
            });
        }
    }
    group.finish();
}

/// A drag of x₂, and of one of three pins, with each kernel: the points that follow, and the map.
fn pins(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("pins");
    group.sample_size(20);
    let sampling = Sampling::Adaptive { target: Some(700) };
    for [source, target] in
        [[Preset::Gingerbread, Preset::Heart], [Preset::VShape, Preset::Blob], [Preset::LShape, Preset::Star]]
    {
        for kernel in [KernelMode::Integral, KernelMode::Adjoint] {
            let settings = PrepareSettings::new(sampling, Sizing::Graded(0.1)).with_kernel(kernel);
            let side = |preset: Preset| {
                let curve = preset.curve().unwrap();
                Arc::new(prepare_curve((preset.outline().polygon(), &curve), &[], &settings, &mut |_| ()).unwrap())
            };
            let sides = PerSide::new(side(source), side(target));
            let at = Constraints::new((sides.source.default_point(), 0.0), (sides.target.default_point(), 0.0));
            let settings = MapSettings::from(Direction::Forward);
            let mut map = ConformalMap::new(sides.source.clone(), sides.target.clone(), &at, settings).unwrap();
            let first = Pins::of(&map).unwrap();
            let mut near = at.points;
            // no place comes twice: the last harmonic measures are kept
            let mut steps = (1u32..).map(|k| 2e-3 * f64::from(k).sin());
            let mut next = || steps.next().unwrap_or_default();
            let name = format!("{}-{}/{kernel:?}", source.name(), target.name());
            let x = at.points.target.in_plane().unwrap();
            group.bench_function(format!("{name}/points"), |bencher| {
                bencher.iter(|| {
                    let moved = at.with_point(Side::Target, x + DVec2::new(next(), 0.0));
                    map.update(&moved, settings).unwrap();
                });
            });
            group.bench_function(format!("{name}/pins"), |bencher| {
                bencher.iter(|| {
                    let pins = first.moved(1, Side::Target, first.pairs()[1].target + next()).unwrap();
                    let found = pins.constraints(PerSide::new(&sides.source, &sides.target), Some(near)).unwrap();
                    near = found.points;
                    map.update(&found, settings).unwrap();
                });
            });
        }
    }
    group.finish();
}

/// Integral kernel: panels and factor of each preset's exact curve, and the measure from another point.
fn boundary_integral(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("boundary-integral");
    group.sample_size(10);
    for preset in Preset::ALL {
        let (curve, x) = (preset.curve().unwrap(), preset.outline().polygon().pole_of_inaccessibility(1e-3));
        let settings = Settings::default().with_points(&[x]);
        let prepared = BoundaryIntegral::prepare(&curve, &settings).unwrap();
        let name = format!("{}/{} unknowns", preset.name(), prepared.unknowns());
        group.bench_function(format!("{name}/factor"), |bencher| {
            bencher.iter(|| BoundaryIntegral::prepare(black_box(&curve), &settings).unwrap());
        });
        group.bench_function(format!("{name}/measure"), |bencher| {
            bencher.iter(|| prepared.harmonic_measure(black_box(x)).unwrap());
        });
    }
    group.finish();
}

/// Factors of a smooth coast, and of one that fills space, and how they grow with the unknowns.
fn coasts(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("coast");
    group.sample_size(10);
    for (name, roughness) in [("smooth", 0.1), ("space-filling", 0.35)] {
        let mut sizes = Vec::new();
        for levels in [4, 6, 8] {
            let curve = Curve::from_polygon(&coast(levels, roughness).unwrap()).unwrap();
            let prepared = BoundaryIntegral::prepare(&curve, &Settings::default()).unwrap();
            sizes.push((prepared.unknowns() as f64, prepared.duration_ms()));
            group.bench_function(format!("{name}/{} unknowns/factor", prepared.unknowns()), |bencher| {
                bencher.iter(|| BoundaryIntegral::prepare(black_box(&curve), &Settings::default()).unwrap());
            });
        }
        for pair in sizes.windows(2) {
            let [(few, short), (many, long)] = [pair[0], pair[1]];
            let exponent = (long / short).ln() / (many / few).ln();
            println!("{name}: from {few} to {many} unknowns time grows with the power {exponent:.2}");
        }
    }
    group.finish();
}

/// Elements are terms: a thread with 1 Gelem/s takes 1 ns per term.
fn cauchy_green(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("cauchy-green");
    group.sample_size(10);
    let side = prepared(Preset::Heart, PrepareSettings::default());
    let domain = side.domain().unwrap();
    let (m, count) = (side.boundary_count(), side.vertex_count());
    group.throughput(Throughput::Elements((m * count) as u64));
    let values = BoundaryValues::new(domain.samples().points().iter().map(|v| v.perp()));
    let mut images = vec![DVec2::ZERO; count];
    for (name, budget) in [("stored", usize::MAX), ("on-the-fly", 0)] {
        let mut coordinates = CauchyGreen::new(domain.clone(), budget);
        coordinates.advance(0, &values, &mut images, &mut |_| ControlFlow::Continue(()));
        group.bench_function(name, |bencher| bencher.iter(|| coordinates.apply(0..count, &values, &mut images)));
    }
    let (contour, mut gamma) = (Contour::new(domain.samples().points()), Vec::new());
    group.bench_function("coordinates", |bencher| {
        bencher.iter(|| domain.mesh().vertices().iter().for_each(|&z| contour.coordinates(black_box(z), &mut gamma)));
    });
    group.finish();
}

fn prepared(preset: Preset, settings: PrepareSettings) -> Arc<PreparedSide> {
    Arc::new(prepare(preset.outline().polygon(), &settings, &mut |_| ()).unwrap())
}

criterion_group!(benches, preparation, frame, pins, boundary_integral, coasts, cauchy_green);
criterion_main!(benches);
