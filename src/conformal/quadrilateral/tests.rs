//! Quadrilaterals whose rectangles are known.

use super::side::{SideEnd, sides};
use super::*;
use crate::geometry::{Piece, SimplePolygon};
use std::f64::consts::TAU;

fn polygon(points: &[[f64; 2]]) -> Curve {
    let points: Vec<DVec2> = points.iter().map(|p| DVec2::from_array(*p)).collect();
    Curve::from_polygon(&SimplePolygon::try_from(points).unwrap()).unwrap()
}

fn rectangle(length: f64) -> Curve {
    polygon(&[[0.0, 0.0], [length, 0.0], [length, 1.0], [0.0, 1.0]])
}

fn disk() -> Curve {
    Curve::new(vec![Piece::circular(DVec2::ZERO, 1.0, 0.0, TAU)]).unwrap()
}

/// The corners of a rectangle of this length and of height 1, from the first point on.
fn corners_of(length: f64) -> Marks {
    let perimeter = 2.0 * (length + 1.0);
    Marks::new([0.0, length / perimeter, (length + 1.0) / perimeter, (2.0 * length + 1.0) / perimeter]).unwrap()
}

fn grid(quadrilateral: &Quadrilateral, counts: [u32; 2]) -> OrthogonalGrid {
    quadrilateral.map().unwrap().grid(GridCells::new(counts).unwrap(), &mut |_| true).unwrap()
}

#[test]
fn a_side_and_its_inverse_belong_together() {
    for arcs in [[0.25; 4], [0.1, 0.4, 0.1, 0.4], [0.2, 0.3, 0.15, 0.35], [1e-9, 0.5, 1e-9, 0.499_999_998]] {
        for side in sides(arcs, modulus(arcs)) {
            for end in [SideEnd::Start, SideEnd::Finish] {
                for t in [1e-9, 1e-3, 0.1, 0.3, 0.4999] {
                    let found = side.share(end, side.measure(end, t)).unwrap();
                    // 1e-16 of the measure is 3e-16 of π K, in widths
                    assert!((found / t - 1.0).abs() < 1e-13, "{arcs:?} at {t}: {found}");
                }
            }
            // both halves meet in the middle
            let [start, finish] = [SideEnd::Start, SideEnd::Finish].map(|end| side.measure(end, 0.5));
            let whole: f64 =
                arcs.iter().copied().filter(|arc| (start + finish - arc).abs() < 1e-15 * (1.0 + arc)).sum();
            assert!(whole > 0.0, "{arcs:?}: {start} and {finish}");
        }
    }
}

#[test]
fn the_grid_of_a_rectangle_is_its_lattice() {
    for length in [1.0, 2.0, 0.3, 5.0, 10.0] {
        let quadrilateral = Quadrilateral::new(&rectangle(length), corners_of(length), DVec2::new(0.2, 0.6)).unwrap();
        let Estimate { value, error } = quadrilateral.modulus();
        println!("{length}: modulus off by {:e}, said to be {error:e}", value * length - 1.0);
        let grid = grid(&quadrilateral, [12, 7]);
        let mut worst = 0.0_f64;
        for (k, node) in grid.nodes().iter().enumerate() {
            let expected = DVec2::new(length * (k % 13) as f64 / 12.0, (k / 13) as f64 / 7.0);
            worst = worst.max(node.distance(expected));
        }
        let (said, deviation) = (grid.image_error(), grid.deviation().unwrap());
        println!("{length}: off by {worst:e}, said to be {said:e}; angles by {deviation:e} degrees");
        assert!((value * length - 1.0).abs() < 1e-9 && (value - length.recip()).abs() <= error);
        assert!(worst < 1e-8 && worst <= said, "{length}: off by {worst:e}, said to be {said:e}");
        assert!(deviation < 1e-4, "{length}: {deviation}");
    }
}

/// The largest distance of a grid's nodes from the lattice of a rectangle of this length and of height 1.
fn off_the_lattice(grid: &OrthogonalGrid, length: f64) -> f64 {
    let [n, m] = grid.cells().counts().map(f64::from);
    let width = grid.cells().counts()[0] as usize + 1;
    let off =
        |(k, node): (usize, &DVec2)| node.distance(DVec2::new(length * (k % width) as f64 / n, (k / width) as f64 / m));
    grid.nodes().iter().enumerate().map(off).fold(0.0, f64::max)
}

#[test]
fn long_rectangles_have_their_modulus_and_their_lattice() {
    for length in [11.0, 14.0, 18.0, 20.0, 30.0, 50.0] {
        for (x, y) in [(0.5, 0.6), (0.4 * length, 0.2)] {
            let started = std::time::Instant::now();
            let quadrilateral = Quadrilateral::new(&rectangle(length), corners_of(length), DVec2::new(x, y)).unwrap();
            let Estimate { value, error } = quadrilateral.modulus();
            let off = value * length - 1.0;
            println!("{length}: modulus off by {off:e}, said to be {:e}; {:?}", error * length, started.elapsed());
            assert!(off.abs() < 1e-11 && (value - length.recip()).abs() <= error && error * length < 1e-10);
            let grid = grid(&quadrilateral, [60, 7]);
            let (worst, said) = (off_the_lattice(&grid, length), grid.image_error());
            println!("{length}: off by {worst:e}, said to be {said:e}; {:?} {:?}", grid.deviation(), started.elapsed());
            assert!(worst < 1e-9 && worst <= said && said < 1e-8, "{length}: off by {worst:e}, said to be {said:e}");
        }
    }
}

/// A bent channel: from the end of a rectangle at one side of the bend to the one at the other, the moduli of whole and halves
/// differ by what the bend itself makes, which does not depend on the lengths.
#[test]
fn a_bend_adds_the_same_to_every_length() {
    let modulus_of = |a: f64, b: f64| {
        let bent = polygon(&[[0.0, 0.0], [a + 1.0, 0.0], [a + 1.0, b + 1.0], [a, b + 1.0], [a, 1.0], [0.0, 1.0]]);
        let perimeter = 2.0 * (a + b + 2.0);
        // (a + 1, b + 1), (a, b + 1), (0, 1) and the first point: far ends are sides 1 and 3
        let marks = [a + b + 2.0, a + b + 3.0, perimeter - 1.0, 0.0].map(|length| length / perimeter);
        Quadrilateral::new(&bent, Marks::new(marks).unwrap(), DVec2::new(0.5, 0.5)).unwrap().modulus()
    };
    // the L-shape of arms 1 from its corner's square: 2.5585231423420129 = 1 + 1 + bend
    let bend = 0.558_523_142_342_013;
    // the ends of arms of length 1 feel the bend by e^{−2π}: the limit is that of two arms of 6 and more
    let short = modulus_of(6.0, 6.0);
    println!("{} against {bend}", short.value - 12.0);
    for (a, b) in [(7.0, 12.0), (15.0, 4.0), (12.0, 9.0), (20.0, 13.0)] {
        let found = modulus_of(a, b);
        let added = found.value - a - b;
        println!("{a}, {b}: {added} ± {:e}", found.error);
        // the longest one is seen from points that the panels do not resolve
        let off = (added - (short.value - 12.0)).abs();
        assert!(
            off < 1e-9 && off <= found.error + short.error && found.error < 1e-9 * found.value,
            "{a}, {b}: {added}"
        );
    }
    assert!((short.value - 12.0 - bend).abs() < 1e-2);
}

/// Marks in one arm of a U, seen from the other arm under measures below rounding.
#[test]
fn the_middle_is_found_in_another_arm() {
    let u = [[0.0, 0.0], [3.0, 0.0], [3.0, 20.0], [2.0, 20.0], [2.0, 1.0], [1.0, 1.0], [1.0, 20.0], [0.0, 20.0]];
    let (curve, perimeter) = (polygon(&u), 2.0 * 23.0 + 2.0 * 19.0);
    // (3, 15), (3, 18), (2, 18) and (2, 15)
    let marks = Marks::new([18.0, 21.0, 26.0, 29.0].map(|length| length / perimeter)).unwrap();
    let quadrilateral = Quadrilateral::new(&curve, marks, DVec2::new(0.5, 15.0)).unwrap();
    let Estimate { value, error } = quadrilateral.modulus();
    // of the rectangle alone 1/3; what lies beyond its ends comes nearer
    assert!(value < 1.0 / 3.0 && value > 0.2 && error < 1e-10, "{value} ± {error:e}");
    // no node in the middle of the fourth side: that is the end of the other arm, whose measure is 1e-50
    let (odd, even) = (grid(&quadrilateral, [9, 5]), grid(&quadrilateral, [8, 4]));
    assert!(odd.deviation().unwrap() < 1e-6 && odd.image_error() < 1e-6, "{odd:?}");
    assert!(even.image_error() > 1.0, "the place of that node is said to be known: {even:?}");
}

#[test]
fn symmetric_marks_on_the_disk_give_a_square() {
    let marks = Marks::new([0.0, 0.25, 0.5, 0.75]).unwrap();
    let quadrilateral = Quadrilateral::new(&disk(), marks, DVec2::new(0.3, -0.5)).unwrap();
    let Estimate { value, error } = quadrilateral.modulus();
    assert!((value - 1.0).abs() < 1e-13 && error < 1e-12, "{value} ± {error:e}");
    let grid = grid(&quadrilateral, [8, 8]);
    // the middle lines are the diagonals, and the lattice's symmetries those of the grid
    assert!(grid.nodes()[4 + 9 * 4].length() < 1e-12, "{}", grid.nodes()[4 + 9 * 4]);
    for i in 0..=8 {
        for j in 0..=8 {
            let (node, turned) = (grid.nodes()[i + 9 * j], grid.nodes()[8 - j + 9 * i]);
            assert!(node.perp().distance(turned) < 1e-11, "({i}, {j}): {node} and {turned}");
        }
    }
    assert!(grid.deviation().unwrap() < 1e-5, "{:?}", grid.deviation());
}
