//! Known symmetries: regular polygons, figures by formula, the built-in outlines, and noise about the tolerance.

use std::f64::consts::{PI, TAU};

use super::*;
use crate::outline::Preset;

fn polygon(points: impl IntoIterator<Item = [f64; 2]>) -> SimplePolygon {
    SimplePolygon::try_from(points.into_iter().map(DVec2::from_array).collect::<Vec<_>>()).unwrap()
}

/// r(θ) at `n` angles that crowd towards θ = 0.
fn polar(n: u32, radius: impl Fn(f64) -> f64) -> SimplePolygon {
    let angle = |k: u32| TAU * (f64::from(k) / f64::from(n)).powf(1.7);
    polygon((0..n).map(angle).map(|t| (radius(t) * DVec2::from_angle(t)).to_array()))
}

fn order(found: &Symmetries) -> u32 {
    match found.rotations {
        Rotations::Identity => 1,
        Rotations::Order { order, .. } => order,
        Rotations::Circle { .. } => 0,
    }
}

/// The axes' angles in degrees.
fn degrees(found: &Symmetries) -> Vec<f64> {
    found.axes.iter().map(|axis| axis.direction.to_angle().to_degrees()).collect()
}

fn assert_axes(found: &Symmetries, expected: &[f64], tolerance: f64) {
    let actual = degrees(found);
    let agree = actual.len() == expected.len() && actual.iter().zip(expected).all(|(a, b)| (a - b).abs() < tolerance);
    assert!(agree, "axes at {actual:?}, expected {expected:?}");
}

#[test]
fn squares_rectangles_and_regular_polygons_have_their_dihedral_groups() {
    let square = Symmetries::of(&polygon([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]));
    assert_eq!(order(&square), 4);
    assert_axes(&square, &[0.0, 45.0, 90.0, 135.0], 1e-10);
    assert!(square.center.distance(DVec2::ONE) < 1e-14 && (square.size - 2.0_f64.sqrt()).abs() < 1e-15);
    assert!(square.axes.iter().all(|axis| axis.deviation < 1e-14), "{square:?}");
    let rectangle = Symmetries::of(&polygon([[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [0.0, 2.0]]));
    assert_eq!(order(&rectangle), 2);
    assert_axes(&rectangle, &[0.0, 90.0], 1e-10);
    for n in 3..=20 {
        let corners = (0..n).map(|k| DVec2::from_angle(0.1 + TAU * f64::from(k) / f64::from(n)).to_array());
        let found = Symmetries::of(&polygon(corners));
        let mut expected: Vec<f64> =
            (0..n).map(|k| (0.1_f64.to_degrees() + 180.0 * f64::from(k) / f64::from(n)) % 180.0).collect();
        expected.sort_by(f64::total_cmp);
        assert_eq!(order(&found), n);
        assert_axes(&found, &expected, 1e-9);
    }
}

#[test]
fn turns_without_mirrors_and_mirrors_without_turns_are_told_apart() {
    let parallelogram = Symmetries::of(&polygon([[0.0, 0.0], [3.0, 0.0], [4.0, 1.0], [1.0, 1.0]]));
    assert_eq!((order(&parallelogram), parallelogram.axes.len()), (2, 0));
    assert!(parallelogram.center.distance(DVec2::new(2.0, 0.5)) < 1e-14);
    let kite = Symmetries::of(&polygon([[0.0, -3.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]]));
    assert_eq!(order(&kite), 1);
    assert_axes(&kite, &[90.0], 1e-10);
    let wheel = Symmetries::of(&polar(4000, |t| 1.0 + 0.2 * (7.0 * t).cos() + 0.1 * (14.0 * t).sin()));
    assert_eq!((order(&wheel), wheel.axes.len()), (7, 0));
    let scalene = Symmetries::of(&polygon([[0.0, 0.0], [3.0, 0.0], [1.0, 1.0]]));
    assert!(scalene.is_empty());
}

#[test]
fn unequally_spaced_points_do_not_matter() {
    let ellipse = |t: f64| 1.0 / (t.cos().powi(2) + 4.0 * t.sin().powi(2)).sqrt();
    let found = Symmetries::of(&polar(3000, ellipse));
    assert_eq!(order(&found), 2);
    assert_axes(&found, &[0.0, 90.0], 1e-3);
    let many = Symmetries::of(&polar(2500, |t| 1.0 + 0.03 * (24.0 * t).cos()));
    assert_eq!((order(&many), many.axes.len()), (24, 24));
}

#[test]
fn built_in_outlines_have_the_symmetries_that_they_were_drawn_with() {
    let expected: [(Preset, u32, &[f64]); 13] = [
        (Preset::Disk, 0, &[]),
        (Preset::Square, 4, &[0.0, 45.0, 90.0, 135.0]),
        (Preset::Gingerbread, 1, &[90.0]),
        (Preset::Heart, 1, &[90.0]),
        (Preset::Blob, 1, &[]),
        (Preset::VShape, 1, &[90.0]),
        (Preset::Cinquefoil, 5, &[18.0, 54.0, 90.0, 126.0, 162.0]),
        (Preset::MapleLeaf, 1, &[90.0]),
        (Preset::Hand, 1, &[]),
        (Preset::Turkey, 1, &[]),
        (Preset::LShape, 1, &[45.0]),
        (Preset::Star, 5, &[18.0, 54.0, 90.0, 126.0, 162.0]),
        (Preset::Spiral, 1, &[]),
    ];
    for (preset, turns, axes) in expected {
        let found = Symmetries::of(&preset.outline().into_polygon());
        assert_eq!(order(&found), turns, "{preset}");
        assert_axes(&found, axes, 1e-6);
    }
}

#[test]
fn copies_anywhere_in_any_size_have_the_same_symmetries() {
    let heart = Preset::Heart.outline().into_polygon();
    let turn = DVec2::from_angle(0.7);
    for (scale, shift) in [(1e-20, DVec2::ZERO), (3.0, DVec2::new(400.0, -70.0)), (1e25, DVec2::splat(2e25))] {
        let copy = polygon(heart.vertices().iter().map(|p| (scale * turn.rotate(*p) + shift).to_array()));
        let found = Symmetries::of(&copy);
        assert_axes(&found, &[90.0 + 0.7_f64.to_degrees()], 1e-9);
        assert!((found.axes[0].foot(shift) - shift).length() < 1e-12 * scale.max(shift.length()), "{found:?}");
    }
}

/// A rectangle with a narrow bump of this height on one side.
fn bumped(height: f64) -> SimplePolygon {
    polygon([[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [2.0, 2.0], [1.99, 2.0 + height], [1.98, 2.0], [0.0, 2.0]])
}

#[test]
fn a_bump_below_the_tolerance_is_listed_with_its_height_and_one_above_it_ends_the_symmetry() {
    let size = Symmetries::of(&bumped(0.01)).size;
    let below = Symmetries::of(&bumped(0.97 * SYMMETRY_TOLERANCE * size));
    assert_eq!((order(&below), below.axes.len()), (2, 2));
    for axis in &below.axes {
        assert!((axis.deviation / SYMMETRY_TOLERANCE - 0.97).abs() < 0.02, "{}", axis.deviation);
    }
    let above = Symmetries::of(&bumped(1.03 * SYMMETRY_TOLERANCE * size));
    assert!(above.is_empty(), "{above:?}");
}

#[test]
fn noise_on_one_half_changes_the_length_of_the_boundary_and_not_the_symmetry() {
    let rough = |height: f64| {
        polar(6000, |t| {
            let noise = if t < PI { height * (1.0 - 2.0 * ((t * 1e4).sin() * 1e4).rem_euclid(1.0)) } else { 0.0 };
            (1.0 + noise) / (t.cos().powi(2) + 2.0 * t.sin().powi(2)).sqrt()
        })
    };
    let found = Symmetries::of(&rough(0.5 * SYMMETRY_TOLERANCE));
    assert_eq!(order(&found), 2);
    assert_axes(&found, &[0.0, 90.0], 0.5);
    assert!(Symmetries::of(&rough(3.0 * SYMMETRY_TOLERANCE)).is_empty());
}

#[test]
fn axes_meet_the_outline_on_itself_and_corners_exactly() {
    let square = polygon([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
    let found = Symmetries::of(&square);
    let crossings: Vec<_> = found.axes.iter().map(|axis| axis.crossings(&square)).collect();
    assert_eq!(crossings[1], [(0, 0.0), (2, 0.0)], "the diagonal");
    assert!(crossings[0].iter().all(|&(edge, along)| edge % 2 == 1 && (along - 0.5).abs() < 1e-15), "{crossings:?}");
    let comb =
        polygon([[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [3.0, 3.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]]);
    let level = Axis { point: DVec2::new(0.0, 2.0), direction: DVec2::X, deviation: 0.0 };
    assert_eq!(level.crossings(&comb).len(), 4);
}
