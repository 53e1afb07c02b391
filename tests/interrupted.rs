//! A map computed in pieces is bit-identical to the map computed at once, and no intermediate state is visible.

#![allow(clippy::unwrap_used, reason = "tests")]

mod support;

use riemap::conformal::{
    ConformalMap, Constraints, Direction, Extension, KernelMode, MapError, MapSettings, PrepareSettings, PreparedSide,
    Side, SurfaceSettings, prepare_surface,
};
use riemap::geometry::DVec2;
use riemap::laplace::{Deadline, SolverKind};
use riemap::outline::{Preset, Sampling};
use riemap::surface::{SurfaceMesh, SurfacePreset};
use std::sync::Arc;
use support::domains;

const MODES: [(SolverKind, KernelMode); 3] = [
    (SolverKind::Direct, KernelMode::Adjoint),
    (SolverKind::Pcg, KernelMode::Adjoint),
    (SolverKind::Direct, KernelMode::Table),
];

fn domain(preset: Preset, (solver, kernel): (SolverKind, KernelMode)) -> Arc<PreparedSide> {
    let sampling = Sampling::Adaptive { target: Some(300) };
    let settings = PrepareSettings::default().with_sampling(sampling).with_solver(solver).with_kernel(kernel);
    domains::domain(preset, settings)
}

fn constraints(source: &PreparedSide, target: &PreparedSide, t: f64) -> Constraints {
    Constraints::new(
        (source.domain().unwrap().default_point() + t * DVec2::new(0.02, 0.03), 0.3 * t),
        (target.domain().unwrap().default_point() - t * DVec2::new(0.03, 0.01), 0.9 * t),
    )
}

/// Everything that a map exposes.
fn seen(map: &ConformalMap) -> impl PartialEq + std::fmt::Debug + use<> {
    let sides = Side::BOTH.map(|side| (map.kernel(side).to_vec(), map.measure(side).clone()));
    (sides, map.correspondence().clone(), map.images().to_vec(), map.direction(), map.extension())
}

/// Advances by the smallest steps and asserts that nothing changes before the last one. Returns the number of steps.
fn step_by_step(map: &mut ConformalMap, constraints: &Constraints, settings: MapSettings) -> usize {
    let (before, mut steps) = (seen(map), 1);
    while !map.advance(constraints, settings, Deadline::in_ms(0.0)).unwrap() {
        assert_eq!(seen(map), before, "step {steps}");
        steps += 1;
    }
    steps
}

#[test]
fn a_map_in_pieces_is_the_map_at_once_and_never_torn() {
    for mode in MODES {
        let (source, target) = (domain(Preset::Heart, mode), domain(Preset::Star, mode));
        let mut whole = ConformalMap::unmapped(Arc::clone(&source), Arc::clone(&target));
        let mut pieces = ConformalMap::unmapped(Arc::clone(&source), Arc::clone(&target));
        for (t, direction, extension) in [
            (0.0, Direction::Backward, Extension::Harmonic),
            (1.0, Direction::Backward, Extension::Harmonic),
            (1.0, Direction::Forward, Extension::Harmonic),
            (2.0, Direction::Forward, Extension::CauchyGreen),
        ] {
            let (at, settings) = (constraints(&source, &target, t), MapSettings::new(direction, extension));
            whole.update(&at, settings).unwrap();
            let steps = step_by_step(&mut pieces, &at, settings);
            assert!(steps > 3, "{mode:?}, {t}: {steps} steps");
            assert_eq!(seen(&pieces), seen(&whole), "{mode:?}, {t}");
            assert_eq!(step_by_step(&mut pieces, &at, settings), 1, "it is done");
        }
    }
}

#[test]
fn other_constraints_start_over_and_bad_ones_change_nothing() {
    for mode in &MODES[..2] {
        let (source, target) = (domain(Preset::Heart, *mode), domain(Preset::Star, *mode));
        let settings = MapSettings::default();
        let at = |t: f64| constraints(&source, &target, t);
        let mut map = ConformalMap::new(Arc::clone(&source), Arc::clone(&target), &at(0.0), settings).unwrap();
        let first = seen(&map);
        // abandoned after 1, 2, … steps: in the kernels, in the extension
        for left in 1..8 {
            for _ in 0..left {
                map.advance(&at(1.0), settings, Deadline::in_ms(0.0)).unwrap();
            }
            step_by_step(&mut map, &at(2.0), settings);
            let fresh = ConformalMap::new(Arc::clone(&source), Arc::clone(&target), &at(2.0), settings).unwrap();
            assert_eq!(seen(&map), seen(&fresh), "left after {left} steps");
            map.advance(&at(1.0), settings, Deadline::in_ms(0.0)).unwrap();
            let outside = at(1.0).with_point(Side::Source, DVec2::splat(1e3));
            let error = map.advance(&outside, settings, Deadline::NEVER);
            assert!(matches!(error, Err(MapError::PointOutside { side: Side::Source, .. })), "{error:?}");
            assert_eq!(seen(&map), seen(&fresh));
            map.update(&at(0.0), settings).unwrap();
            assert_eq!(seen(&map), first);
        }
    }
}

#[test]
fn a_surface_in_pieces_is_the_surface_at_once() {
    for solver in [SolverKind::Direct, SolverKind::Pcg] {
        let source = domain(Preset::Disk, (SolverKind::Direct, KernelMode::Adjoint));
        let surface = SurfaceMesh::new(&SurfacePreset::ALL[0].surface(120).unwrap()).unwrap();
        let settings = SurfaceSettings::default().with_solver(solver);
        let surface = Arc::new(prepare_surface(surface, settings, &mut |_| ()).unwrap());
        let at = |anchor: f64| {
            Constraints::new(
                (source.domain().unwrap().default_point() + DVec2::splat(0.1 * anchor), 0.0),
                (surface.default_point(), anchor),
            )
        };
        let mut map =
            ConformalMap::new(Arc::clone(&source), Arc::clone(&surface), &at(0.0), MapSettings::default()).unwrap();
        let (before, mut steps) = (map.images().to_vec(), 1);
        map.advance(&at(0.5), MapSettings::default(), Deadline::in_ms(0.0)).unwrap();
        while !map.advance(&at(0.2), MapSettings::default(), Deadline::in_ms(0.0)).unwrap() {
            assert_eq!(map.images(), before);
            steps += 1;
        }
        let whole =
            ConformalMap::new(Arc::clone(&source), Arc::clone(&surface), &at(0.2), MapSettings::default()).unwrap();
        assert!(steps > 2 && map.images() == whole.images(), "{solver:?}: {steps} steps");
        for side in Side::BOTH {
            assert_eq!((map.kernel(side), map.measure(side)), (whole.kernel(side), whole.measure(side)));
        }
        assert_eq!(map.correspondence(), whole.correspondence());
    }
}
