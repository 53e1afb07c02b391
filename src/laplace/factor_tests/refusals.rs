//! Matrices that are not positive definite are refused, with the vertex of the first pivot that is not positive.

use super::*;
use proptest::test_runner::TestCaseError;
use std::cell::Cell;

impl Symmetric {
    /// The pivots of plain elimination in the given order, up to and including the first that is not positive.
    fn pivots(&self, order: &[u32]) -> Vec<f64> {
        let n = self.len();
        let mut place = vec![0; n];
        order.iter().enumerate().for_each(|(k, &old)| place[old as usize] = k);
        let mut dense = vec![vec![0.0; n]; n];
        for (row, column, value) in self.triplets() {
            let (row, column) = (place[row].max(place[column]), place[row].min(place[column]));
            dense[row][column] += value;
        }
        let mut pivots = Vec::new();
        for k in 0..n {
            pivots.push(dense[k][k]);
            if dense[k][k].is_nan() || dense[k][k] <= 0.0 {
                break;
            }
            let column: Vec<f64> = (0..n).map(|i| if i > k { dense[i][k] } else { 0.0 }).collect();
            for i in k + 1..n {
                for j in k + 1..=i {
                    dense[i][j] -= column[i] * column[j] / pivots[k];
                }
            }
        }
        pivots
    }
}

fn assert_refused(matrix: &Symmetric, vertex: usize) {
    let error = matrix.factor().1.unwrap_err();
    assert_eq!(error, LaplaceError::NotPositiveDefinite { vertex });
    assert!(error.to_string().contains(&format!("not positive definite at interior vertex {vertex}:")), "{error}");
}

/// For a tree with equal weights every pivot is exact: in a component without boundary the last one is 0.
#[test]
fn a_part_without_boundary_is_singular_and_refused_at_one_of_its_vertices() {
    let tree = |size: usize| prop::collection::vec(any::<Index>(), size);
    let sizes = (1..40_usize, 1..40_usize).prop_flat_map(move |(a, b)| (tree(a), tree(b)));
    let refused = |(grounded, loose): (Vec<Index>, Vec<Index>)| {
        let edges = |tree: &[Index], first: usize| -> Vec<_> {
            tree.iter().enumerate().skip(1).map(|(k, at)| (first + at.index(k), first + k, 1.0)).collect()
        };
        let mut grounds = vec![0.0; grounded.len()];
        grounds[0] = 1.0;
        let sound = Symmetric::laplacian(grounds.clone(), &edges(&grounded, 0));
        prop_assert!(sound.factor().1.is_ok());
        grounds.resize(grounded.len() + loose.len(), 0.0);
        let both = [edges(&grounded, 0), edges(&loose, grounded.len())].concat();
        match Symmetric::laplacian(grounds, &both).factor().1 {
            Err(LaplaceError::NotPositiveDefinite { vertex }) => prop_assert!(vertex >= grounded.len(), "{}", vertex),
            other => prop_assert!(false, "{:?}", other.map(|factor| factor.len())),
        }
        Ok(())
    };
    runner(100).run(&sizes, refused).unwrap();
}

/// A Laplacian minus a multiple of the identity is refused at the first pivot of plain elimination that is not
/// positive.
#[test]
fn what_is_indefinite_is_refused_at_its_first_pivot_that_is_not_positive() {
    let counts = Cell::new([0_usize; 2]);
    let weights = prop::collection::vec((any::<Index>(), any::<Index>(), 0.1..10.0_f64), 20..200);
    let inputs = (2..70_usize, weights, 0.0..2.5_f64);
    let agrees = |(n, weights, shift): (usize, Vec<(Index, Index, f64)>, f64)| {
        let edges = weights.iter().map(|(a, b, weight)| (a.index(n), b.index(n), *weight)).filter(|(a, b, _)| a != b);
        let mut matrix = Symmetric::laplacian(vec![1.0; n], &edges.collect::<Vec<_>>());
        matrix.diagonal.iter_mut().for_each(|value| *value -= shift);
        let (ordering, factor) = matrix.factor();
        let pivots = matrix.pivots(&ordering.forward);
        prop_assume!(pivots.iter().all(|pivot| pivot.abs() > 1e-9));
        let expected = pivots.iter().position(|&pivot| pivot <= 0.0).map(|k| ordering.forward[k] as usize);
        let found = match factor {
            Ok(_) => None,
            Err(LaplaceError::NotPositiveDefinite { vertex }) => Some(vertex),
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        };
        prop_assert_eq!(found, expected);
        prop_assert_eq!(matrix.solution_by_faer(&vec![1.0; n]).is_some(), found.is_none());
        let [sound, refused] = counts.get();
        counts.set(if found.is_none() { [sound + 1, refused] } else { [sound, refused + 1] });
        Ok(())
    };
    runner(200).run(&inputs, agrees).unwrap();
    let [sound, refused] = counts.get();
    println!("{sound} positive definite, {refused} not");
    assert!(sound > 20 && refused > 20, "{sound} and {refused}");
}

#[test]
fn what_is_no_number_or_zero_or_too_large_is_refused_where_it_is() {
    let sound = Symmetric::laplacian(
        (0..30).map(|k| f64::from(u8::from(k % 7 == 0))).collect(),
        &(1..30).flat_map(|k| [(k / 2, k, 1.0), (k - 1, k, 0.5)]).collect::<Vec<_>>(),
    );
    for vertex in [0, 11, 29] {
        for value in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
            let mut matrix = sound.clone();
            matrix.diagonal[vertex] = value;
            assert_refused(&matrix, vertex);
        }
    }
    for (entry, value) in [(3, f64::NAN), (40, f64::INFINITY), (57, 1e200), (12, -1e200)] {
        let mut matrix = sound.clone();
        matrix.entries[entry].2 = value;
        let (a, b, _) = matrix.entries[entry];
        // the pivot of the earlier vertex does not depend on this entry
        let later = matrix.factor().0.inverse[a].cmp(&matrix.factor().0.inverse[b]);
        assert_refused(&matrix, if later.is_lt() { b } else { a });
    }
    assert_refused(&Symmetric { diagonal: vec![1.0, 0.0, 2.0], entries: Vec::new() }, 1);
}
