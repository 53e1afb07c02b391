//! Drawing and reshaping: exact results where they are known, properties elsewhere.

use super::*;
use crate::geometry::{DVec2, PolygonError, SimplePolygon};
use crate::outline::Preset;
use std::f64::consts::TAU;

fn polygon(points: &[(f64, f64)]) -> SimplePolygon {
    SimplePolygon::try_from(points.iter().map(|&p| p.into()).collect::<Vec<DVec2>>()).unwrap()
}

fn circle(count: u32) -> Vec<DVec2> {
    (0..count).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(count))).collect()
}

fn square() -> Shape {
    Shape::new(&polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]))
}

/// A square with 40 vertices on each edge.
fn dense_square() -> Shape {
    let corners = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)].map(DVec2::from);
    let points = (0..160).map(|k| corners[k / 40].lerp(corners[(k / 40 + 1) % 4], (k % 40) as f64 / 40.0));
    Shape::new(&SimplePolygon::try_from(points.collect::<Vec<_>>()).unwrap())
}

fn area(vertices: &[DVec2]) -> f64 {
    SimplePolygon::try_from(vertices.to_vec()).unwrap().area()
}

/// The largest turn from edge to edge.
fn sharpest(vertices: &[DVec2]) -> f64 {
    let n = vertices.len();
    let turn = |k: usize| (vertices[(k + 1) % n] - vertices[k]).angle_to(vertices[(k + 2) % n] - vertices[(k + 1) % n]);
    (0..n).map(|k| turn(k).abs()).fold(0.0, f64::max)
}

#[test]
fn a_chain_is_simplified_to_its_corners_and_stays_within_the_tolerance() {
    let chain: Vec<DVec2> = (0..=20).map(|k| DVec2::new(f64::from(k), f64::from(10 - (k - 10i32).abs()))).collect();
    assert_eq!(simplified(&chain, 0.1), [0, 10, 20]);
    assert_eq!(simplified(&chain, 20.0), [0, 20]);
    assert_eq!(simplified(&[], 1.0), [0usize; 0]);
    let wave: Vec<DVec2> = (0..500).map(|k| DVec2::new(0.01 * f64::from(k), (0.03 * f64::from(k)).sin())).collect();
    let kept: Vec<DVec2> = simplified(&wave, 0.02).into_iter().map(|k| wave[k]).collect();
    let distance = |p: DVec2| {
        let to = |a: DVec2, b: DVec2| {
            p.distance(a + ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0) * (b - a))
        };
        kept.windows(2).map(|w| to(w[0], w[1])).fold(f64::INFINITY, f64::min)
    };
    let worst = wave.iter().map(|&p| distance(p)).fold(0.0, f64::max);
    assert!(worst <= 0.02 && kept.len() < 40, "{worst}, {} points", kept.len());
}

#[test]
fn every_vertex_of_a_plain_polygon_is_a_handle() {
    assert_eq!(square().handle_count(), 4);
    assert_eq!(square().handles().collect::<Vec<_>>(), square().vertices());
}

#[test]
fn a_dense_outline_has_a_manageable_number_of_handles_corners_among_them() {
    assert_eq!(dense_square().handle_count(), 4);
    for preset in Preset::ALL {
        let shape = Shape::new(preset.outline().polygon());
        let count = shape.handle_count();
        assert!((3..=60).contains(&count), "{preset:?}: {count}");
    }
}

#[test]
fn a_moved_corner_keeps_straight_edges_straight_and_the_other_half_in_its_place() {
    let to = DVec2::new(3.0, 2.5);
    let (dense, moved) = (dense_square(), dense_square().moved(2, to));
    for (k, (&old, &new)) in dense.vertices().iter().zip(moved.vertices()).enumerate() {
        let expected = match k {
            40..=80 => DVec2::new(2.0, 0.0).lerp(to, (k - 40) as f64 / 40.0),
            81..=120 => to.lerp(DVec2::new(0.0, 2.0), (k - 80) as f64 / 40.0),
            _ => old,
        };
        assert!(new.distance(expected) < 1e-14, "vertex {k}: {new}, expected {expected}");
    }
    assert_eq!(dense.moved(2, dense.handle(2).unwrap()), dense);
    assert_eq!(dense.moved(99, to), dense);
}

#[test]
fn a_moved_point_of_a_circle_leaves_it_smooth() {
    let shape = Shape::new(&SimplePolygon::try_from(circle(600)).unwrap());
    let before = sharpest(shape.vertices());
    let at = shape.handle(3).unwrap();
    let moved = shape.moved(3, 1.1 * at);
    assert!(moved.polygon().is_ok() && (moved.handle(3).unwrap() - 1.1 * at).length() < 1e-15);
    let after = sharpest(moved.vertices());
    assert!(after < 8.0 * before && after < 0.1, "turns by {before} before, {after} after");
}

#[test]
fn a_handle_is_inserted_on_the_boundary_and_can_be_taken_away_again() {
    let (shape, handle) = square().inserted(DVec2::new(0.5, -0.3));
    assert_eq!((handle, shape.handle(handle), shape.handle_count()), (1, Some(DVec2::new(0.5, 0.0)), 5));
    assert_eq!(shape.polygon().unwrap().area(), 4.0);
    assert_eq!(shape.inserted(DVec2::new(0.5, 0.1)), (shape.clone(), 1), "there is one already");
    assert_eq!(shape.removed(1).unwrap(), square());
    let (closing, last) = square().inserted(DVec2::new(0.0, 1.0));
    assert_eq!((last, closing.handle(last)), (4, Some(DVec2::new(0.0, 1.0))));
}

#[test]
fn a_removed_corner_leaves_a_straight_edge_and_three_handles_stay() {
    let triangle = square().removed(2).unwrap();
    assert_eq!(triangle.vertices(), [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)].map(DVec2::from));
    assert_eq!(triangle.removed(0), Err(DrawingError::LastHandles { least: 3 }));
    let dense = dense_square().removed(2).unwrap();
    assert!((area(dense.vertices()) - 2.0).abs() < 1e-13 && dense.handle_count() == 3);
    let first = square().removed(0).unwrap();
    assert_eq!(area(first.vertices()), 2.0);
}

#[test]
fn a_removed_handle_of_a_circle_leaves_it_smooth() {
    let shape = Shape::new(&SimplePolygon::try_from(circle(600)).unwrap());
    let removed = shape.removed(2).unwrap();
    assert_eq!(removed.handle_count(), shape.handle_count() - 1);
    assert!(sharpest(removed.vertices()) < 0.1, "{}", sharpest(removed.vertices()));
    // the cubic through two points of a circle, with its directions, stays near it
    let distance = removed.vertices().iter().map(|p| (p.length() - 1.0).abs()).fold(0.0, f64::max);
    assert!(distance < 0.1, "{distance}");
}

#[test]
fn smoothing_rounds_corners_and_keeps_the_area_and_a_circle() {
    let smooth = square().smoothed();
    assert!((area(smooth.vertices()) - 4.0).abs() < 1e-12);
    let perimeter = smooth.polygon().unwrap().perimeter();
    assert!(perimeter < 8.0 && sharpest(smooth.vertices()) < 0.3, "{perimeter}, {}", sharpest(smooth.vertices()));
    let round = Shape::new(&SimplePolygon::try_from(circle(720)).unwrap()).smoothed();
    let worst = round.vertices().iter().map(|p| (p.length() - 1.0).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-4, "a circle stays a circle: {worst}");
}

#[test]
fn the_mirror_image_is_exact_and_twice_is_none() {
    let house = Shape::new(&polygon(&[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (1.0, 3.0), (0.0, 1.0)]));
    let mirrored = house.mirrored();
    assert_eq!(mirrored.vertices(), [(4.0, 0.0), (4.0, 1.0), (3.0, 3.0), (0.0, 1.0), (0.0, 0.0)].map(DVec2::from));
    assert!(!mirrored.polygon().unwrap().was_clockwise(), "the mirror image is counter-clockwise again");
    assert_eq!(mirrored.mirrored(), house);
    assert_eq!(house.axis().image(DVec2::new(1.0, 3.0)), DVec2::new(3.0, 3.0));
    let dense = dense_square();
    let places: Vec<DVec2> = dense.mirrored().handles().collect();
    assert_eq!(places.len(), 4);
    assert!(dense.handles().all(|p| places.contains(&dense.axis().image(p))));
}

#[test]
fn a_boundary_point_stays_on_its_edge_while_another_vertex_moves() {
    let (old, new) = (square(), square().moved(2, DVec2::new(5.0, 5.0)));
    // the middle of the first edge
    let carried = carried_fraction(old.vertices(), new.vertices(), 0.125);
    let length = new.polygon().unwrap().perimeter();
    assert!((carried * length - 1.0).abs() < 1e-14, "{carried} of {length}");
    // with other vertices the nearest point is taken
    let (more, _) = old.inserted(DVec2::new(1.5, 0.0));
    assert!((carried_fraction(old.vertices(), more.vertices(), 0.125) - 0.125).abs() < 1e-15);
    let without = old.removed(2).unwrap();
    let carried = carried_fraction(old.vertices(), without.vertices(), 0.125);
    assert!((carried * without.polygon().unwrap().perimeter() - 1.0).abs() < 1e-14);
}

#[test]
fn a_crossing_is_named_with_its_place() {
    let crossed = square().moved(0, DVec2::new(3.0, 1.0));
    let error = crossed.polygon().unwrap_err();
    assert!(matches!(error, PolygonError::EdgesCross { .. }), "{error}");
    let at = error.place().unwrap();
    assert!((at.x - 2.0).abs() < 1e-12 && (0.5..1.5).contains(&at.y), "{at}");
    assert_eq!(PolygonError::ZeroArea.place(), None);
}

#[test]
fn a_curve_goes_through_its_points_and_is_nearly_a_circle_on_one() {
    let points = circle(8);
    let curve = closed_curve(&points, |_| false);
    assert!(points.iter().all(|p| curve.contains(p)));
    let worst = curve.iter().map(|p| (p.length() - 1.0).abs()).fold(0.0, f64::max);
    // the spline's derivative at the points is 2 sin 45° = 1.414 over a chord of 0.765: at most 1 % off
    assert!(worst < 0.02 && sharpest(&curve) < 0.1, "{worst}, {}", sharpest(&curve));
    let corners = closed_curve(&points, |_| true);
    assert_eq!(corners, points, "between corners nothing is bent");
    assert_eq!(closed_curve(&points[..2], |_| false), points[..2]);
    let repeated: Vec<DVec2> = points.iter().flat_map(|&p| [p, p]).chain([points[0]]).collect();
    assert_eq!(closed_curve(&repeated, |_| false), curve);
}

/// A circle drawn by hand: 200 points with noise of half a pixel.
fn shaky(turns: f64) -> Vec<DVec2> {
    let count = 200;
    let radius = |k: i32| 100.0 + 0.5 * f64::from(7 * k % 5 - 2) / 2.0;
    (0..count).map(|k| radius(k) * DVec2::from_angle(turns * TAU * f64::from(k) / f64::from(count))).collect()
}

#[test]
fn a_shaky_circle_becomes_a_smooth_one_also_when_its_ends_miss_each_other() {
    for turns in [0.97, 1.0, 1.06, 1.08] {
        let mut stroke = shaky(turns);
        if turns == 1.06 {
            // the end crosses the beginning
            stroke.iter_mut().enumerate().for_each(|(k, p)| p.x += 0.02 * (k as f64 - 100.0));
        } else if turns > 1.0 {
            // the end runs past the beginning, outside of it
            let n = stroke.len() as f64;
            stroke.iter_mut().enumerate().for_each(|(k, p)| *p *= 0.96 + 0.1 * k as f64 / n);
        }
        let outline = freehand(&stroke, 1.5).unwrap();
        let polygon = SimplePolygon::try_from(outline.clone()).unwrap();
        let expected = 1e4 * std::f64::consts::PI;
        let off = polygon.area() / expected - 1.0;
        assert!(off.abs() < 0.06, "{turns} turns: {off}");
        assert!(outline.len() < 1000, "{}", outline.len());
    }
}

#[test]
fn the_corners_of_a_drawn_square_stay_sharp() {
    let corners = [(0.0, 0.0), (300.0, 0.0), (300.0, 300.0), (0.0, 300.0), (0.0, 2.0)].map(DVec2::from);
    let stroke: Vec<DVec2> =
        (0..200).map(|k| corners[k / 50].lerp(corners[k / 50 + 1], (k % 50) as f64 / 50.0)).collect();
    let outline = freehand(&stroke, 1.5).unwrap();
    assert!(outline.len() <= 8, "straight edges have no inner points: {outline:?}");
    assert!((area(&outline) - 9e4).abs() < 500.0);
    for corner in &corners[..4] {
        assert!(outline.iter().any(|p| p.distance(*corner) < 8.0), "{corner}");
    }
}

#[test]
fn a_dot_is_no_outline_and_an_eight_is_found_to_cross_itself() {
    for stroke in [&[][..], &[DVec2::ONE], &shaky(1.0).iter().map(|p| 0.02 * *p).collect::<Vec<_>>()] {
        assert_eq!(freehand(stroke, 1.5), Err(DrawingError::TooShort));
    }
    let eight: Vec<DVec2> = (0..200)
        .map(|k| TAU * (0.12 + f64::from(k) / 200.0))
        .map(|t| 100.0 * DVec2::new(t.sin(), (2.0 * t).sin()))
        .collect();
    let outline = freehand(&eight, 1.5).unwrap();
    let error = SimplePolygon::try_from(outline).unwrap_err();
    assert!(error.place().unwrap().length() < 10.0, "{error}");
}
