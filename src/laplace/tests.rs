//! The Laplacian and its factor on a grid with a known matrix: the five-point stencil.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use super::*;
use crate::geometry::DVec2;
use crate::mesh::{NO_TRIANGLE, TriMesh};

/// The unit square, k×k cells, each divided along the same diagonal; boundary first, counter-clockwise.
fn grid(k: u32) -> TriMesh {
    let ring: Vec<(u32, u32)> = (0..k)
        .map(|i| (i, 0))
        .chain((0..k).map(|i| (k, i)))
        .chain((0..k).map(|i| (k - i, k)))
        .chain((0..k).map(|i| (0, k - i)))
        .collect();
    let inside = (1..k).flat_map(|j| (1..k).map(move |i| (i, j)));
    let places: Vec<(u32, u32)> = ring.iter().copied().chain(inside).collect();
    let index = |i: u32, j: u32| places.iter().position(|&p| p == (i, j)).unwrap_or_default() as u32;
    let mut triangles = Vec::new();
    for j in 0..k {
        for i in 0..k {
            let (a, b, c, d) = (index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    let across = |t: usize, a: u32, b: u32| {
        let found =
            triangles.iter().enumerate().position(|(s, other)| s != t && other.contains(&a) && other.contains(&b));
        found.map_or(NO_TRIANGLE, |s| s as u32)
    };
    let neighbours = triangles
        .iter()
        .enumerate()
        .map(|(t, &[a, b, c])| [across(t, b, c), across(t, c, a), across(t, a, b)])
        .collect();
    let vertices = places.iter().map(|&(i, j)| DVec2::new(f64::from(i), f64::from(j)) / f64::from(k)).collect();
    TriMesh::known_sound(vertices, 4 * k, triangles, neighbours)
}

fn factored(mesh: &TriMesh) -> (DirichletLaplacian, Factor) {
    let laplacian = DirichletLaplacian::assemble(mesh).unwrap();
    let ordering = Ordering::minimum_degree(&laplacian).unwrap();
    let factor = Factor::new(&laplacian, ordering, u64::MAX).unwrap();
    (laplacian, factor)
}

/// L̂ x, from the stored upper triangle.
fn multiply(laplacian: &DirichletLaplacian, x: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; x.len()];
    for (j, column) in laplacian.interior.outer_iterator().enumerate() {
        for (i, &value) in column.iter() {
            product[i] += value * x[j];
            if i != j {
                product[j] += value * x[i];
            }
        }
    }
    product
}

#[test]
fn square_grid_gives_the_five_point_stencil() {
    let (laplacian, _) = factored(&grid(6));
    for (j, column) in laplacian.interior.outer_iterator().enumerate() {
        for (i, &value) in column.iter() {
            let expected = if i == j { 4.0 } else { -1.0 };
            // the diagonals of the cells are edges between cocircular points: exactly 0
            assert!(value == 0.0 || (value - expected).abs() < 1e-14, "entry ({i}, {j}) = {value}");
        }
    }
    assert_eq!(laplacian.coupling().data().iter().filter(|v| (**v + 1.0).abs() < 1e-14).count(), 4 * 5);
}

#[test]
fn solution_has_no_residual() {
    let (laplacian, factor) = factored(&grid(23));
    let n = factor.len();
    let right: Vec<f64> = (0..n).map(|i| (i as f64 * 0.7).sin()).collect();
    let mut x = vec![[0.0, 0.0]; n];
    for (unknown, &value) in right.iter().enumerate() {
        x[factor.position(unknown as u32)] = [value, -2.0 * value];
    }
    factor.solve(factor.everything(), factor.everything(), &mut x);
    let lane = |k: usize| (0..n).map(|u| x[factor.position(u as u32)][k]).collect::<Vec<_>>();
    for (first, second) in lane(0).iter().zip(lane(1)) {
        assert!((2.0 * first + second).abs() < 1e-12, "the two lanes disagree: {first}, {second}");
    }
    for (left, right) in multiply(&laplacian, &lane(0)).iter().zip(&right) {
        assert!((left - right).abs() < 1e-12, "residual {}", left - right);
    }
}

#[test]
fn pruned_solve_equals_the_full_one_where_it_is_asked() {
    let (_, factor) = factored(&grid(17));
    let n = factor.len();
    let (mut given, mut wanted) = (RootPaths::default(), RootPaths::default());
    for unknown in [0, n / 2, n - 1] {
        let mut full = vec![[0.0]; n];
        full[factor.position(unknown as u32)] = [1.0];
        let mut pruned = full.clone();
        factor.solve(factor.everything(), factor.everything(), &mut full);
        factor.root_paths([unknown as u32], &mut given);
        factor.root_paths([3, 40, 41], &mut wanted);
        factor.solve(&given, &wanted, &mut pruned);
        for asked in [3, 40, 41] {
            let place = factor.position(asked);
            assert_eq!(full[place], pruned[place], "unknown {unknown}, asked at {asked}");
        }
    }
}

#[test]
fn factor_survives_the_trip_through_flat_arrays() {
    let (_, factor) = factored(&grid(9));
    assert_eq!(Factor::from_buffers(factor.to_buffers()).as_ref(), Some(&factor));
    let broken = |damage: fn(&mut FactorBuffers)| {
        let mut buffers = factor.to_buffers();
        damage(&mut buffers);
        Factor::from_buffers(buffers)
    };
    assert_eq!(broken(|b| b.forward[0] = b.forward[1]), None, "not a permutation");
    assert_eq!(broken(|b| b.rows.fill(u32::MAX)), None, "rows outside the matrix");
    assert_eq!(broken(|b| b.values.truncate(3)), None, "values missing");
    assert_eq!(broken(|b| b.chunks.truncate(5)), None, "columns missing");
}

#[test]
fn conjugate_gradients_agree_with_the_factor() {
    let (laplacian, factor) = factored(&grid(31));
    let pcg = Pcg::new(&laplacian).unwrap();
    assert!(pcg.check_invariants());
    let n = factor.len();
    let mut exact: Vec<[f64; 2]> = vec![[0.0; 2]; n];
    let mut x = exact.clone();
    for (unknown, lanes) in x.iter_mut().enumerate() {
        *lanes = [(unknown as f64).cos(), f64::from(u8::from(unknown == 7))];
        exact[factor.position(unknown as u32)] = *lanes;
    }
    factor.solve(factor.everything(), factor.everything(), &mut exact);
    pcg.solve(&mut x).unwrap();
    for (unknown, lanes) in x.iter().enumerate() {
        for (value, exact) in lanes.iter().zip(exact[factor.position(unknown as u32)]) {
            // the relative residual of 1e-12 times the condition number of about 31²
            assert!((value - exact).abs() < 1e-9, "unknown {unknown}: {value} and {exact}");
        }
    }
}

#[test]
fn conjugate_gradients_say_that_they_did_not_converge() {
    let (laplacian, _) = factored(&grid(5));
    let pcg = Pcg::new(&laplacian).unwrap();
    let mut x = vec![[f64::NAN]; pcg.len()];
    assert!(pcg.solve(&mut x).unwrap_err().residual.is_nan());
}

#[test]
fn a_factor_above_the_budget_is_refused_with_its_size() {
    let (laplacian, factor) = factored(&grid(20));
    let ordering = Ordering::minimum_degree(&laplacian).unwrap();
    let entries = factor.to_buffers().values.len() as u64;
    match Factor::new(&laplacian, ordering, 1000) {
        Err(LaplaceError::TooLarge { unknowns, bytes }) => {
            assert_eq!(unknowns, factor.len());
            assert!(bytes > 1000 && bytes.abs_diff(8 * entries) < 4 * entries, "{bytes} bytes for {entries} entries");
        }
        other => panic!("{other:?}"),
    }
}

/// The number of calls of a solve that is interrupted wherever it can be.
fn interrupted<const K: usize>(solver: &Solver, run: &mut SolveRun, given: &RootPaths, x: &mut [[f64; K]]) -> usize {
    let (deadline, mut calls) = (Deadline::in_ms(0.0), 1);
    while !solver.advance(run, given, solver.everything(), x, deadline).unwrap() {
        calls += 1;
    }
    calls
}

#[test]
fn an_interrupted_solve_is_the_same_to_the_bit() {
    let (laplacian, factor) = factored(&grid(51));
    let n = factor.len();
    for (solver, fewest) in [(Solver::Direct(factor), 4), (Solver::pcg(&laplacian).unwrap(), 40)] {
        let mut run = SolveRun::default();
        for shift in [0.3, 0.7] {
            let right = |k: usize| (k as f64 * shift).sin();
            let mut whole: Vec<[f64; 2]> = (0..n).map(|k| [right(k), right(k + 3)]).collect();
            let mut pieces = whole.clone();
            solver.solve(solver.everything(), solver.everything(), &mut whole).unwrap();
            let calls = interrupted(&solver, &mut run, solver.everything(), &mut pieces);
            assert_eq!(whole, pieces, "{:?}", solver.kind());
            assert!(calls >= fewest, "{:?}: {calls} calls", solver.kind());
        }
    }
}

#[test]
fn a_solve_can_be_left_for_another_one() {
    let (laplacian, factor) = factored(&grid(51));
    let n = factor.len();
    for solver in [Solver::Direct(factor), Solver::pcg(&laplacian).unwrap()] {
        let (mut run, everything) = (SolveRun::default(), solver.everything());
        let mut left: Vec<[f64; 1]> = (0..n).map(|k| [k as f64]).collect();
        assert_eq!(solver.advance(&mut run, everything, everything, &mut left, Deadline::in_ms(0.0)), Ok(false));
        run.restart();
        let mut whole: Vec<[f64; 1]> = (0..n).map(|k| [(k as f64).cos()]).collect();
        let mut pieces = whole.clone();
        solver.solve(everything, everything, &mut whole).unwrap();
        interrupted(&solver, &mut run, everything, &mut pieces);
        assert_eq!(whole, pieces, "{:?}", solver.kind());
    }
}

/// Three blocks of rows and part of a fourth: a chain with the diagonal 3, preconditioned by its diagonal.
fn long_chain() -> Solver {
    let n = 3 * 32_768 + 1000;
    let entries = |first: f64, below: f64, diagonal: f64| {
        std::iter::once(first).chain((1..n).flat_map(move |_| [below, diagonal])).collect::<Vec<f64>>()
    };
    let starts = std::iter::once(0).chain((0..n).map(|row| 2 * row + 1)).collect();
    let columns = std::iter::once(0).chain((1..n).flat_map(|row| [row - 1, row])).collect();
    let reciprocal = 3.0_f64.sqrt().recip();
    let buffers =
        PcgBuffers { starts, columns, matrix: entries(3.0, -1.0, 3.0), factor: entries(reciprocal, 0.0, reciprocal) };
    Solver::from(Pcg::from_buffers(buffers).unwrap())
}

#[test]
fn large_iterations_are_interrupted_block_by_block() {
    let solver = long_chain();
    let n = solver.len();
    let right = |k: usize| (k as f64 * 0.3).sin();
    let mut whole: Vec<[f64; 1]> = (0..n).map(|k| [right(k)]).collect();
    let mut pieces = whole.clone();
    solver.solve(solver.everything(), solver.everything(), &mut whole).unwrap();
    let calls = interrupted(&solver, &mut SolveRun::default(), solver.everything(), &mut pieces);
    assert_eq!(whole, pieces);
    // 6 stages of 4 blocks each; with a condition number of 5 it takes about 30 iterations
    assert!(calls > 20 * 6 * 4, "{calls} calls");
    for k in 0..n {
        let [before, after] =
            [k.checked_sub(1), Some(k + 1)].map(|j| j.and_then(|j| whole.get(j)).map_or(0.0, |x| x[0]));
        let residual = 3.0 * whole[k][0] - before - after - right(k);
        assert!(residual.abs() < 1e-10, "row {k}: {residual:e}");
    }
}
