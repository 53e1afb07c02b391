//! Solutions agree with those of faer, in every lane, and with pruned sweeps.

use super::*;
use std::cell::Cell;

impl Symmetric {
    /// The largest residual, relative to the sum of the absolute terms of its row.
    fn backward_error(&self, x: &[f64], right: &[f64]) -> f64 {
        let mut sums: Vec<[f64; 2]> = right.iter().map(|b| [-b, b.abs()]).collect();
        let mut add = |row: usize, product: f64| {
            sums[row][0] += product;
            sums[row][1] += product.abs();
        };
        for (row, column, value) in self.triplets() {
            add(row, value * x[column]);
            if row != column {
                add(column, value * x[row]);
            }
        }
        sums.iter().filter(|sum| sum[1] > 0.0).map(|sum| sum[0].abs() / sum[1]).fold(0.0, f64::max)
    }
}

/// The solutions for 1, 2, … K times the right-hand side.
fn solved<const K: usize>(factor: &Factor, right: &[f64]) -> [Vec<f64>; K] {
    let mut x = vec![[0.0; K]; factor.len()];
    for (unknown, &value) in right.iter().enumerate() {
        x[factor.position(unknown as u32)] = std::array::from_fn(|lane| value * (lane + 1) as f64);
    }
    factor.solve(factor.everything(), factor.everything(), &mut x);
    std::array::from_fn(|lane| (0..right.len()).map(|unknown| x[factor.position(unknown as u32)][lane]).collect())
}

/// A right-hand side with both signs, and one with a single sign at a few vertices.
fn right_hand_sides(n: usize) -> [Vec<f64>; 2] {
    [(0..n).map(|k| (k as f64 * 0.7).sin()).collect(), (0..n).map(|k| f64::from(u8::from(k % 50 == 3))).collect()]
}

#[test]
fn random_meshes_are_solved_as_by_faer() {
    let worst = Cell::new([0.0_f64; 2]);
    let solves = |matrix: Symmetric| {
        let factor = matrix.factor().1.unwrap();
        let [mixed, spots] = right_hand_sides(matrix.len()).map(|right| {
            let ([x], expected) = (solved(&factor, &right), matrix.solution_by_faer(&right).unwrap());
            x.into_iter().zip(expected).collect::<Vec<_>>()
        });
        let scale = mixed.iter().fold(0.0_f64, |scale, (_, expected)| scale.max(expected.abs()));
        let in_norm = mixed.iter().map(|(x, expected)| (x - expected).abs() / scale).fold(0.0, f64::max);
        // for a single sign, the entries agree to relative accuracy however small they are
        let each = spots.iter().filter(|(x, expected)| x != expected);
        let each = each.map(|(x, expected)| ((x - expected) / expected).abs()).fold(0.0, f64::max);
        let [a, b] = worst.get();
        worst.set([a.max(in_norm), b.max(each)]);
        prop_assert!(in_norm < 1e-12 && each < 1e-12, "{:e} of the largest, {:e} of each", in_norm, each);
        Ok(())
    };
    runner(60).run(&meshes(), solves).unwrap();
    println!("[of the largest, of each]: {:?}", worst.get().map(|error| format!("{error:.1e}")));
}

/// The condition number is up to 10¹⁵ here: faer and the factor both give a small residual, not a small error.
#[test]
fn random_graphs_are_solved_as_well_as_by_faer() {
    let worst = Cell::new([0.0_f64; 2]);
    let solves = |matrix: Symmetric| {
        let factor = matrix.factor().1.unwrap();
        for right in right_hand_sides(matrix.len()) {
            let [x] = solved(&factor, &right);
            let expected = matrix.solution_by_faer(&right).unwrap();
            let errors = [x, expected].map(|x| matrix.backward_error(&x, &right));
            let [a, b] = worst.get();
            worst.set([a.max(errors[0]), b.max(errors[1])]);
            prop_assert!(errors[0] < 1e-14, "{:?}", errors);
        }
        Ok(())
    };
    runner(100).run(&graphs(1..300), solves).unwrap();
    println!("relative residuals, faer's: {:?}", worst.get().map(|error| format!("{error:.1e}")));
}

/// Each graph is one supernode, divided into chunks of all widths.
#[test]
fn complete_graphs_of_every_size_are_solved() {
    for n in 1..=70 {
        let edges: Vec<_> = (0..n).flat_map(|b| (0..b).map(move |a| (a, b, 1.0 / (1 + a + 2 * b) as f64))).collect();
        let matrix = Symmetric::laplacian((0..n).map(|k| f64::from(u8::from(k == n / 2))).collect(), &edges);
        let factor = matrix.factor().1.unwrap();
        for right in right_hand_sides(n) {
            let [x] = solved(&factor, &right);
            let error = matrix.backward_error(&x, &right);
            assert!(error < 1e-14, "n = {n}: {error:e}");
        }
    }
}

#[test]
fn lanes_are_solved_alike_and_pruned_sweeps_give_the_same_bits() {
    let picked = || prop::collection::vec(any::<Index>(), 1..5);
    let matrices = prop_oneof![graphs(1..200), meshes().prop_filter("it has inner vertices", |mesh| mesh.len() > 0)];
    let agree = |(matrix, given, wanted): (Symmetric, Vec<Index>, Vec<Index>)| {
        let (n, factor) = (matrix.len(), matrix.factor().1.unwrap());
        let [given, wanted] = [given, wanted].map(|picked| picked.iter().map(|index| index.index(n) as u32).collect());
        let (given, wanted): (Vec<u32>, Vec<u32>) = (given, wanted);
        let mut right = vec![0.0; n];
        given.iter().enumerate().for_each(|(k, &unknown)| right[unknown as usize] = 0.3 + k as f64);
        let [alone] = solved(&factor, &right);
        let ([first, second], eight) = (solved(&factor, &right), solved::<8>(&factor, &right));
        prop_assert!(first == alone && eight[0] == alone);
        // multiplication by two and four is exact
        prop_assert!(alone.iter().zip(&second).all(|(x, twice)| 2.0 * x == *twice) && eight[1] == second);
        prop_assert!(alone.iter().zip(&eight[3]).all(|(x, fourfold)| 4.0 * x == *fourfold));
        let [mut from, mut to] = [RootPaths::default(), RootPaths::default()];
        factor.root_paths(given.iter().copied(), &mut from);
        factor.root_paths(wanted.iter().copied(), &mut to);
        let mut pruned = vec![[0.0; 2]; n];
        for &unknown in &given {
            pruned[factor.position(unknown)] = [right[unknown as usize]; 2];
        }
        factor.solve(&from, &to, &mut pruned);
        for unknown in wanted {
            prop_assert_eq!(pruned[factor.position(unknown)], [alone[unknown as usize]; 2], "at {}", unknown);
        }
        Ok(())
    };
    runner(60).run(&(matrices, picked(), picked()), agree).unwrap();
}
