//! Nothing is allocated from the second frame of a drag on: every point, on either side, reuses what there is.

#![allow(clippy::unwrap_used, reason = "tests")]

use riemap::conformal::{
    ConformalMap, Constraints, Direction, Extension, MapSettings, PrepareSettings, PreparedDomain, prepare,
};
use riemap::geometry::DVec2;
use riemap::outline::Preset;
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};
use std::alloc::System;
use std::sync::Arc;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

fn domain(preset: Preset) -> Arc<PreparedDomain> {
    Arc::new(prepare(&preset.outline().polygon, &PrepareSettings::default(), &mut |_| ()).unwrap())
}

/// One test only: the allocator is shared by all threads of the program.
#[test]
fn a_drag_allocates_nothing_after_its_first_frames() {
    let (source, target) = (domain(Preset::Cinquefoil), domain(Preset::Heart));
    let at = |t: f64| Constraints {
        source_point: source.pole + 0.1 * t * DVec2::new((9.0 * t).cos(), (9.0 * t).sin()),
        target_point: target.pole - 0.1 * t * DVec2::new((7.0 * t).cos(), (5.0 * t).sin()),
        source_anchor: 0.3 * t,
        target_anchor: 0.9 * t,
    };
    for direction in [Direction::Forward, Direction::Backward] {
        let settings = MapSettings { direction, extension: Extension::Harmonic };
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
