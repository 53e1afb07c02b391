//! Point lists become smooth curves between their corners, or stay polygons.

use super::*;
use crate::exact::{blob, vshape};
use crate::geometry::{CurvePoint, Jet, Piece};
use crate::test_random::runner;
use proptest::prelude::*;
use std::f64::consts::TAU;

fn polygon(points: Vec<DVec2>) -> SimplePolygon {
    SimplePolygon::try_from(points).unwrap()
}

fn smooth(points: Vec<DVec2>) -> (SimplePolygon, OutlineCurve) {
    let polygon = polygon(points);
    let curve = CurveForm::default().curve(&polygon).unwrap();
    (polygon, curve)
}

/// The parameters of a piece between its knots.
fn intervals(piece: &Piece) -> Vec<[f64; 2]> {
    let Piece::Spline { spline, from, to } = piece else { return vec![[0.0, 1.0]] };
    let inner = spline.knots_between([*from, *to], [0.0, 1.0]).map(|(t, _)| t);
    let ends: Vec<f64> = std::iter::once(0.0).chain(inner).chain([1.0]).collect();
    ends.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

/// `count` points of a closed curve of period 1, and the largest errors of the smooth curve through them, in position
/// and curvature, in units of size 1.
fn errors(name: &str, count: u32, size: f64, curve: impl Fn(f64) -> Jet) -> [f64; 2] {
    let at = |k: u32| f64::from(k) / f64::from(count);
    let (_, found) = smooth((0..count).map(|k| curve(at(k)).position).collect());
    assert!(found.is_smooth() && found.corner_count() == 0, "{name}: {:?}", found.stays_polygon());
    let (mut position, mut curvature) = (0f64, 0f64);
    let piece = &found.curve().pieces()[0];
    for (k, [a, b]) in (0..count).zip(intervals(piece)) {
        let jet = piece.jet(0.5 * (a + b));
        // the parameter of the nearest point, by Gauss and Newton's method
        let mut s = at(k) + 0.5 / f64::from(count);
        for _ in 0..10 {
            let here = curve(s);
            s -= (here.position - jet.position).dot(here.first) / here.first.length_squared();
        }
        let here = curve(s);
        position = position.max(here.position.distance(jet.position) / size);
        curvature = curvature.max((here.curvature() - jet.curvature()).abs() * size);
    }
    println!("{name}, {count} points: position {position:.1e}, curvature {curvature:.1e}");
    [position, curvature]
}

#[test]
fn six_thousand_points_of_smooth_outlines_give_the_curve_to_many_digits() {
    let ellipse = |s: f64| {
        let (sin, cos) = (TAU * s).sin_cos();
        Jet {
            position: DVec2::new(4.0 * cos, sin),
            first: TAU * DVec2::new(-4.0 * sin, cos),
            second: -TAU * TAU * DVec2::new(4.0 * cos, sin),
        }
    };
    let circle = |s: f64| {
        let spoke = DVec2::from_angle(TAU * s);
        Jet { position: spoke, first: TAU * spoke.perp(), second: -TAU * TAU * spoke }
    };
    let [position, curvature] = errors("circle", 6000, 1.0, circle);
    assert!(position < 1e-14 && curvature < 2e-6, "{position:e}, {curvature:e}");
    let [position, curvature] = errors("ellipse 4:1", 6000, 1.0, ellipse);
    assert!(position < 1e-12 && curvature < 2e-4, "{position:e}, {curvature:e}");
    let [position, _] = errors("blob by its parameter", 6000, 8.0, blob::boundary_jet);
    assert!(position < 1e-9, "{position:e}");
    let v = |s: f64| {
        let t = 4.0 * s.rem_euclid(1.0);
        let (jet, rate) = match t {
            0.0..1.0 => (vshape::around_right_tip(t), 4.0),
            1.0..3.0 => (vshape::around_left_tip(2.0 - t), -4.0),
            _ => (vshape::around_right_tip(t - 4.0), 4.0),
        };
        Jet { first: rate * jet.first, second: 16.0 * jet.second, ..jet }
    };
    let [position, _] = errors("V by its parameter", 6000, 2.0, v);
    assert!(position < 1e-9, "{position:e}");
}

/// The polygons of the presets, read as lists of points.
#[test]
fn the_corners_of_the_presets_are_found_again() {
    let expected = [
        (Preset::Disk, 0),
        (Preset::Gingerbread, 0),
        (Preset::Heart, 2),
        (Preset::Blob, 0),
        (Preset::VShape, 0),
        (Preset::Cinquefoil, 5),
        (Preset::MapleLeaf, 29),
        (Preset::Hand, 0),
        (Preset::Turkey, 29),
        (Preset::Spiral, 0),
    ];
    for (preset, corners) in expected {
        let polygon = preset.outline().into_polygon();
        let found = CurveForm::default().corners(&polygon).len();
        let curve = CurveForm::default().curve(&polygon).unwrap();
        println!("{preset}: {found} corners, smooth: {}, {:?}", curve.is_smooth(), curve.stays_polygon());
        assert_eq!(found, corners, "{preset}");
        assert!(curve.is_smooth(), "{preset}: {:?}", curve.stays_polygon());
        let exact = preset.curve().unwrap().perimeter();
        let error = curve.curve().perimeter() / exact - 1.0;
        // where arcs meet lines the curvature jumps
        assert!(error.abs() < 2e-6, "{preset}: {error:e}");
    }
}

fn square(per_side: u32) -> Vec<DVec2> {
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
    let along = |k: usize| {
        (0..per_side).map(move |j| corners[k].lerp(corners[(k + 1) % 4], f64::from(j) / f64::from(per_side)))
    };
    (0..4).flat_map(along).collect()
}

#[test]
fn a_densely_drawn_square_is_four_lines() {
    let mut points = square(32);
    points.rotate_left(7);
    let (polygon, found) = smooth(points);
    assert!(found.is_smooth() && found.corner_count() == 4);
    let pieces = found.curve().pieces();
    assert_eq!(pieces.len(), 5, "the first vertex is inside of a side");
    assert!(pieces.iter().all(Piece::is_straight));
    assert_eq!(found.curve().position(CurvePoint::new(0, 0.0)), polygon.vertices()[0]);
}

#[test]
fn short_lists_are_polygons_unless_asked_otherwise() {
    let circle = |n: u32| polygon((0..n).map(|k| DVec2::from_angle(TAU * f64::from(k) / f64::from(n))).collect());
    let of = |interpretation, n| CurveForm { interpretation, ..CurveForm::default() }.curve(&circle(n)).unwrap();
    assert_eq!(of(Interpretation::Auto, 63).stays_polygon(), Some(&StaysPolygon::FewPoints { count: 63 }));
    assert!(of(Interpretation::Auto, 64).is_smooth());
    assert!(of(Interpretation::Smooth, 20).is_smooth());
    let straight = of(Interpretation::Polygon, 64);
    assert!(!straight.is_smooth() && straight.stays_polygon().is_none() && straight.curve().pieces().len() == 64);
    // the corners of an octagon are corners
    let octagon = of(Interpretation::Smooth, 8);
    assert_eq!(octagon.stays_polygon(), Some(&StaysPolygon::ManyCorners { corners: 8, count: 8 }));
    assert_eq!(octagon.corner_count(), 8);
}

#[test]
fn a_switched_vertex_is_a_corner_or_none() {
    let mut form = CurveForm { switched: vec![0, 40], ..CurveForm::default() };
    let square = polygon(square(32));
    assert_eq!(form.corners(&square), [32, 40, 64, 96]);
    form.switched = vec![7, 5000];
    assert_eq!(form.corners(&square), [0, 7, 32, 64, 96]);
}

/// Two lobes joined by a neck whose sides bend towards each other: chords lie farther apart than their curve.
#[test]
fn where_the_smooth_curve_would_cross_itself_the_polygon_stays() {
    let lobes = |overlap: f64| {
        let x = |k: u32| -1.0 + (f64::from(k) + 0.5) / 120.0;
        let side = move |x: f64| 0.25 - (0.25 + overlap) * (-(x * x) / 0.02).exp();
        let lower = (0..240).map(move |k| DVec2::new(x(k), -side(x(k))));
        let upper = (0..240).rev().map(move |k| DVec2::new(x(k), side(x(k))));
        CurveForm::default().curve(&polygon(lower.chain(upper).collect())).unwrap()
    };
    assert!(lobes(-1e-4).is_smooth());
    let crossing = lobes(1e-4);
    assert!(!crossing.is_smooth());
    let Some(StaysPolygon::CrossesItself { at }) = crossing.stays_polygon() else {
        panic!("{:?}", crossing.stays_polygon())
    };
    assert!(at.length() < 0.05, "{at}");
}

/// Beside the turkey's tail, an edge of 0.38 meets edges of 0.01 at 16°: taken for a smooth point, that is a bulge.
#[test]
fn a_spline_that_leaves_an_edge_is_refused() {
    let polygon = Preset::Turkey.outline().into_polygon();
    let notch = DVec2::new(-0.383, 0.613);
    let vertices = polygon.vertices();
    let corners = CurveForm::default().corners(&polygon);
    let nearest =
        corners.into_iter().min_by(|&i, &j| vertices[i].distance(notch).total_cmp(&vertices[j].distance(notch)));
    let form = CurveForm { switched: vec![nearest.unwrap() as u32], ..CurveForm::default() };
    let found = form.curve(&polygon).unwrap();
    let Some(StaysPolygon::LeavesEdge { at }) = found.stays_polygon() else { panic!("{:?}", found.stays_polygon()) };
    assert!(!found.is_smooth() && at.distance(notch) < 0.02, "{at}");
}

/// The distance from a segment.
fn distance(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
    p.distance(a.lerp(b, t))
}

fn wavy(waves: &[(f64, f64)], corners: u32, n: u32) -> Vec<DVec2> {
    let radius = |angle: f64| {
        let smooth: f64 = waves
            .iter()
            .enumerate()
            .map(|(k, (a, b))| a * ((k + 1) as f64 * angle).cos() + b * ((k + 1) as f64 * angle).sin())
            .sum();
        let teeth = if corners == 0 { 0.0 } else { 0.2 * (0.5 * f64::from(corners) * angle).sin().abs() };
        1.0 + 0.08 * smooth + teeth
    };
    // uneven steps
    let angle = |k: u32| {
        let s = TAU * f64::from(k) / f64::from(n);
        s + 0.3 * s.sin()
    };
    (0..n).map(|k| radius(angle(k)) * DVec2::from_angle(angle(k))).collect()
}

/// Random star-shaped outlines: whatever becomes smooth interpolates its points, stays near its edges and is simple.
#[test]
fn smooth_curves_interpolate_stay_near_and_do_not_cross() {
    let outlines = (prop::collection::vec((-1.0..1.0, -1.0..1.0), 1..7), 0..5u32, 64..400u32);
    runner(200)
        .run(&outlines, |(waves, corners, n)| {
            let Ok(polygon) = SimplePolygon::try_from(wavy(&waves, corners, n)) else { return Ok(()) };
            let found = CurveForm::default().curve(&polygon).unwrap();
            let vertices = polygon.vertices();
            if !found.is_smooth() {
                prop_assert!(found.stays_polygon().is_some());
                return Ok(());
            }
            let mut dense = Vec::new();
            let mut starts = 0;
            let parts =
                found.curve().pieces().iter().flat_map(|piece| intervals(piece).into_iter().map(move |t| (piece, t)));
            for (piece, [from, to]) in parts {
                let [a, b] = [from, to].map(|t| piece.jet(t).position);
                let at_start = vertices.iter().find(|v| v.distance(a) < 1e-14);
                prop_assert!(at_start.is_some(), "an interval begins at {a}, which is no vertex");
                starts += 1;
                for j in 0..8 {
                    let p = piece.jet(from + (to - from) * f64::from(j) / 8.0).position;
                    prop_assert!(distance(p, a, b) <= 0.25 * a.distance(b) * (1.0 + 1e-12));
                    dense.push(p);
                }
            }
            prop_assert_eq!(starts, vertices.len(), "curved: an interval for each vertex");
            let dense = SimplePolygon::try_from(dense);
            prop_assert!(dense.is_ok_and(|polygon| !polygon.was_clockwise()));
            Ok(())
        })
        .unwrap();
}
