//! All modes of the preparation give the same map: table and adjoint kernel, direct and iterative solver.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

mod support;

use riemap::conformal::{
    ConformalMap, Constraints, HarmonicTable, KernelMode, MapSettings, Memory, PrepareError, PrepareSettings,
    PreparedSide, Stage, TableError, Unprepared, poisson_kernel, prepare, prepare_within,
};
use riemap::geometry::SimplePolygon;
use riemap::laplace::SolverKind;
use riemap::mesh::{Sizing, locate};
use riemap::outline::{Preset, Sampling};
use riemap::worker::Transfer;
use support::domains::domain;

const COARSE: PrepareSettings =
    PrepareSettings::new(Sampling::Uniform { count: 150, keep_corners: true }, Sizing::Uniform);
const TABLE: PrepareSettings = COARSE.with_kernel(KernelMode::Table);
const PCG: PrepareSettings = COARSE.with_solver(SolverKind::Pcg);

fn outline<'a>(polygon: &'a SimplePolygon, settings: &'a PrepareSettings) -> Unprepared<'a> {
    Unprepared::Outline { polygon, settings }
}

/// The kernel at every `step`-th interior vertex, moved slightly towards the pole.
fn kernels(domain: &PreparedSide, step: usize) -> Vec<Vec<f64>> {
    let inside = domain.domain().unwrap().mesh().vertices()[domain.boundary_count()..].iter().step_by(step);
    let near = inside.filter_map(|v| {
        locate(domain.domain().unwrap().mesh(), v.lerp(domain.domain().unwrap().default_point(), 0.01), None)
    });
    near.map(|x| poisson_kernel(domain, x).unwrap()).collect()
}

/// The largest difference of two kernels relative to the maximum of the larger one.
fn difference(a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    assert_eq!(a.len(), b.len());
    let worst = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        let scale = a.iter().fold(0.0_f64, |m, v| m.max(*v));
        a.iter().zip(b).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs() / scale))
    };
    a.iter().zip(b).map(worst).fold(0.0, f64::max)
}

#[test]
fn kernels_from_the_table_equal_the_adjoint_ones() {
    for preset in [Preset::Disk, Preset::LShape, Preset::Cinquefoil, Preset::Star] {
        let (adjoint, table) = (domain(preset, COARSE), domain(preset, TABLE));
        assert!(adjoint.table().is_none() && table.table().is_some());
        let error = difference(&kernels(&adjoint, 17), &kernels(&table, 17));
        println!("{}: {error:.1e}", preset.name());
        assert!(error <= 1e-12, "{}: {error:e}", preset.name());
    }
}

#[test]
fn table_is_made_with_progress_in_per_cent() {
    let mut percents = Vec::new();
    let progress =
        &mut |stage| percents.extend(if let Stage::Table { percent } = stage { Some(percent) } else { None });
    prepare(Preset::Heart.outline().polygon(), &TABLE, progress).unwrap();
    assert!(percents.windows(2).all(|pair| pair[0] < pair[1]), "{percents:?}");
    assert!(percents.first() == Some(&0) && percents.last().is_some_and(|&p| p > 90), "{percents:?}");
}

#[test]
fn table_above_the_budget_is_refused_with_what_fits() {
    let polygon = Preset::Heart.outline().into_polygon();
    let whole = domain(Preset::Heart, TABLE);
    let (n, m) = (whole.interior_count(), whole.boundary_count());
    let bytes = HarmonicTable::bytes(n, m);
    let memory = Memory::default().with_table_bytes(bytes / 8);
    let error = prepare_within(memory, outline(&polygon, &TABLE), &mut |_| ()).unwrap_err();
    println!("{error}");
    let PrepareError::Table(TableError::TooLarge { bytes: stated, fitting_samples, .. }) = error else {
        panic!("{error}")
    };
    assert_eq!(stated, bytes);
    // n·m = O(m³): an eighth of the memory suffices for the table of half the samples
    let sampling = Sampling::Uniform { count: fitting_samples as u32, keep_corners: true };
    let fitting = prepare_within(memory, outline(&polygon, &TABLE.with_sampling(sampling)), &mut |_| ());
    assert!(fitting.is_ok() && fitting_samples.abs_diff(m / 2) <= 1, "{fitting_samples} of {m}: {:?}", fitting.err());
}

#[test]
fn the_advice_for_a_graded_mesh_fits() {
    let polygon = Preset::Heart.outline().into_polygon();
    let sampling = |count| Sampling::Uniform { count, keep_corners: true };
    let graded = |count| TABLE.with_sampling(sampling(count)).with_sizing(Sizing::Graded(0.1));
    let memory = Memory::default().with_table_bytes(2_000_000);
    let error = prepare_within(memory, outline(&polygon, &graded(600)), &mut |_| ()).unwrap_err();
    let PrepareError::Table(TableError::TooLarge { fitting_samples, .. }) = error else { panic!("{error}") };
    let fitting = prepare_within(memory, outline(&polygon, &graded(fitting_samples as u32)), &mut |_| ());
    assert!(fitting.is_ok(), "{fitting_samples}: {:?}", fitting.err());
}

#[test]
fn iterative_solver_gives_the_same_kernels_and_maps() {
    for preset in [Preset::Cinquefoil, Preset::Gingerbread] {
        agree_with_the_iterative_solver(preset);
    }
}

fn agree_with_the_iterative_solver(preset: Preset) {
    let both = [COARSE, PCG].map(|settings| {
        let (source, target) = (domain(preset, settings), domain(Preset::Heart, settings));
        assert_eq!(source.solver_kind(), settings.solver);
        let constraints = Constraints::new((source.default_point(), 0.1), (target.default_point(), 0.7));
        let kernels = kernels(&source, 97);
        let map = ConformalMap::new(source, target, &constraints, MapSettings::default()).unwrap();
        (kernels, map.images().to_vec())
    });
    // a residual of 1e-12 times the condition number of L̂, about n = 2000
    let kernel_error = difference(&both[0].0, &both[1].0);
    let image_error = both[0].1.iter().zip(&both[1].1).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    println!("{}: kernels {kernel_error:.1e}, images {image_error:.1e}", preset.name());
    assert!(kernel_error < 1e-9, "{kernel_error:e}");
    assert!(image_error < 1e-8, "{image_error:e}");
}

#[test]
fn factor_above_the_budget_gives_way_to_the_iterative_solver() {
    let polygon = Preset::Blob.outline().into_polygon();
    let memory = Memory::default().with_factor_bytes(10_000);
    let domain = prepare_within(memory, outline(&polygon, &COARSE), &mut |_| ()).unwrap();
    assert_eq!(domain.solver_kind(), SolverKind::Pcg);
}

#[test]
fn every_mode_survives_the_trip_through_flat_arrays() {
    for settings in [COARSE, TABLE, PCG] {
        let domain = domain(Preset::Square, settings);
        let back = Transfer::try_from(&*domain).unwrap().into_side().unwrap();
        assert_eq!(
            Transfer::try_from(&back).unwrap(),
            Transfer::try_from(&*domain).unwrap(),
            "to the bit, with its factor"
        );
        assert_eq!(back.solver_kind(), settings.solver);
        assert_eq!(back.table(), domain.table());
        assert_eq!(back.timings(), domain.timings());
        let broken = |damage: fn(&mut Transfer)| {
            let mut buffers = Transfer::try_from(&*domain).unwrap();
            damage(&mut buffers);
            buffers.into_side().is_none()
        };
        assert!(broken(|b| b.floats.truncate(5)), "arrays missing");
        assert!(broken(|b| b.floats.push(Vec::new())), "an array too many");
        assert!(broken(|b| b.floats.last_mut().unwrap().truncate(3)), "values of the solver missing");
    }
}
