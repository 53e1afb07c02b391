//! From the second frame of a drag on nothing is allocated: every point, on either side, reuses existing buffers.

#![allow(clippy::unwrap_used, reason = "tests")]

mod support;

use riemap::conformal::{
    ConformalMap, Constraints, Direction, Extension, MapSettings, PrepareSettings, SurfaceSettings, prepare_surface,
};
use riemap::geometry::DVec2;
use riemap::mesh::{BarycentricPoint, TriangleId};
use riemap::outline::Preset;
use riemap::surface::{SurfaceMesh, SurfacePreset};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};
use std::alloc::System;
use std::sync::Arc;
use support::domains::domain;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// A single test, because all threads of the program share the allocator.
#[test]
fn a_drag_allocates_nothing_after_its_first_frames() {
    between_outlines();
    between_surfaces();
}

fn between_surfaces() {
    let [source, target] = [SurfacePreset::Hemisphere, SurfacePreset::HeightField].map(|preset| {
        let mesh = SurfaceMesh::new(&preset.surface(100).unwrap()).unwrap();
        Arc::new(prepare_surface(mesh, SurfaceSettings::default(), &mut |_| ()).unwrap())
    });
    let at = |t: f64| {
        let point = BarycentricPoint::new(TriangleId::new(900), [0.5 * t, 0.5 - 0.5 * t, 0.5]);
        Constraints::new((point, 0.3 * t), (target.default_point(), 0.9 * t))
    };
    let settings = MapSettings::default();
    let mut map = ConformalMap::new(Arc::clone(&source), Arc::clone(&target), &at(0.01), settings).unwrap();
    map.update(&at(0.02), settings).unwrap();
    let region = Region::new(ALLOCATOR);
    for step in 3..100 {
        map.update(&at(f64::from(step) / 100.0), settings).unwrap();
    }
    let change = region.change();
    assert_eq!((change.allocations, change.reallocations), (0, 0), "{change:?}");
}

fn between_outlines() {
    let [source, target] = [Preset::Cinquefoil, Preset::Heart].map(|preset| domain(preset, PrepareSettings::default()));
    let at = |t: f64| {
        Constraints::new(
            (
                source.domain().unwrap().default_point() + 0.1 * t * DVec2::new((9.0 * t).cos(), (9.0 * t).sin()),
                0.3 * t,
            ),
            (
                target.domain().unwrap().default_point() - 0.1 * t * DVec2::new((7.0 * t).cos(), (5.0 * t).sin()),
                0.9 * t,
            ),
        )
    };
    for direction in [Direction::Forward, Direction::Backward] {
        let settings = MapSettings::new(direction, Extension::Harmonic);
        let mut map = ConformalMap::new(Arc::clone(&source), Arc::clone(&target), &at(0.0), settings).unwrap();
        map.update(&at(0.01), settings).unwrap();
        let region = Region::new(ALLOCATOR);
        for step in 2..200 {
            map.update(&at(f64::from(step) / 200.0), settings).unwrap();
        }
        let change = region.change();
        assert_eq!((change.allocations, change.reallocations), (0, 0), "{direction:?}: {change:?}");
    }
}
