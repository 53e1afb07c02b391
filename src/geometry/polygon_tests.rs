//! Which point lists are simple polygons, and which errors the others give, with their places.

use std::f64::consts::TAU;

use approx::assert_relative_eq;
use proptest::prelude::*;

use super::*;
use crate::geometry::MAX_POINTS;

fn points(coordinates: &[(f64, f64)]) -> Vec<DVec2> {
    coordinates.iter().map(|&(x, y)| DVec2::new(x, y)).collect()
}

fn polygon(coordinates: &[(f64, f64)]) -> Result<SimplePolygon, PolygonError> {
    SimplePolygon::try_from(points(coordinates))
}

/// A star-shaped chain with radius `r(angle / TAU)`.
fn radial(n: u32, r: impl Fn(f64) -> f64) -> Vec<DVec2> {
    (0..n).map(|k| f64::from(k) / f64::from(n)).map(|t| r(t) * DVec2::from_angle(TAU * t)).collect()
}

/// Reference answer: compares every pair of edges with the same exact predicate.
fn is_simple_by_all_pairs(v: &[DVec2]) -> bool {
    use crate::geometry::{Side, on_segment, side};
    let n = v.len();
    let edge = |k: usize| (v[k], v[(k + 1) % n]);
    for e in 0..n {
        let (a, b) = edge(e);
        let (_, c) = edge((e + 1) % n);
        if on_segment(a, b, c) || on_segment(b, c, a) {
            return false;
        }
        for f in e + 2..n {
            if (f + 1) % n == e {
                continue;
            }
            let (c, d) = edge(f);
            let touches = on_segment(a, b, c) || on_segment(a, b, d) || on_segment(c, d, a) || on_segment(c, d, b);
            let sides = |a, b, c, d| (side(a, b, c), side(a, b, d));
            let split = |s| matches!(s, (Side::Left, Side::Right) | (Side::Right, Side::Left));
            if touches || (split(sides(a, b, c, d)) && split(sides(c, d, a, b))) {
                return false;
            }
        }
    }
    true
}

#[test]
fn clockwise_points_are_reversed_and_the_first_stays_first() {
    let p = polygon(&[(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)]).unwrap();
    assert!(p.was_clockwise());
    assert_eq!(p.vertices(), points(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]));
    assert!(!polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]).unwrap().was_clockwise());
}

#[test]
fn too_few_and_too_many_points_are_named_with_their_count() {
    assert_eq!(polygon(&[(0.0, 0.0), (1.0, 0.0)]), Err(PolygonError::TooFewPoints { count: 2 }));
    assert_eq!(polygon(&[]), Err(PolygonError::TooFewPoints { count: 0 }));
    let many = radial(MAX_POINTS as u32 + 1, |_| 1.0);
    let error = SimplePolygon::try_from(many).unwrap_err();
    assert_eq!(error, PolygonError::TooManyPoints { count: 200_001 });
    assert!(error.to_string().contains("at most 200000"), "{error}");
}

#[test]
fn coordinates_that_cannot_be_computed_with_are_named() {
    let nan = polygon(&[(0.0, 0.0), (1.0, f64::NAN), (0.0, 1.0)]).unwrap_err();
    assert!(matches!(nan, PolygonError::NotFinite { index: 1, .. }), "{nan}");
    let infinite = polygon(&[(0.0, 0.0), (1.0, 0.0), (0.0, f64::INFINITY)]).unwrap_err();
    assert!(infinite.to_string().contains("point 3 is not finite"), "{infinite}");
    let huge = polygon(&[(0.0, 0.0), (1e150, 0.0), (0.0, 1e150)]).unwrap_err();
    assert!(matches!(huge, PolygonError::TooFarOut { index: 1, .. }), "{huge}");
    let tiny = polygon(&[(0.0, 0.0), (1e-150, 0.0), (0.0, 1e-150)]).unwrap_err();
    assert_eq!(tiny, PolygonError::TooSmall { extent: 1e-150 });
}

#[test]
fn shapes_at_both_ends_of_the_range_are_measured_without_overflow() {
    for scale in [1e-29, 1e29] {
        let p = SimplePolygon::try_from(radial(100, |_| scale)).unwrap();
        assert_relative_eq!(p.perimeter() / scale, TAU, max_relative = 1e-3);
        assert_relative_eq!(p.area() / scale / scale, TAU / 2.0, max_relative = 1e-2);
        assert!(p.contains(p.pole_of_inaccessibility(1e-3 * scale)));
    }
}

#[test]
fn repeated_points_are_named_wherever_they_are() {
    let at = DVec2::new(1.0, 0.0);
    let consecutive = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    assert_eq!(consecutive, Err(PolygonError::RepeatedPoint { first: 1, second: 2, at }));
    let apart = polygon(&[(1.0, 0.0), (2.0, 2.0), (0.0, 2.0), (1.0, 0.0), (-1.0, -1.0)]);
    assert_eq!(apart, Err(PolygonError::RepeatedPoint { first: 0, second: 3, at }));
    let signed_zeros = polygon(&[(0.0, 1.0), (1.0, 1.0), (-0.0, 1.0)]);
    assert!(matches!(signed_zeros, Err(PolygonError::RepeatedPoint { first: 0, second: 2, .. })));
    let all_the_same = polygon(&[(1.0, 0.0); 3]);
    assert_eq!(all_the_same, Err(PolygonError::RepeatedPoint { first: 0, second: 1, at }));
}

#[test]
fn collinear_points_enclose_no_area() {
    assert_eq!(polygon(&[(0.0, 0.0), (3.0, 1.5), (1.0, 0.5)]), Err(PolygonError::ZeroArea));
    assert!(polygon(&[(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (0.0, 1.0)]).is_ok(), "a straight vertex is no fault");
}

#[test]
fn a_figure_eight_is_told_with_its_edges_and_the_crossing() {
    let error = polygon(&[(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]).unwrap_err();
    assert_eq!(error, PolygonError::EdgesCross { first: 0, second: 2, at: DVec2::new(1.0, 1.0) });
    assert_eq!(
        error.to_string(),
        "the outline crosses itself near (1, 1): the edge after point 1 and the edge after point 3"
    );
}

#[test]
fn touching_counts_as_crossing() {
    let on_edge = polygon(&[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 0.0), (0.0, 2.0)]).unwrap_err();
    assert!(matches!(on_edge, PolygonError::EdgesTouch { at, .. } if at == DVec2::new(2.0, 0.0)), "{on_edge}");
    let overlap = polygon(&[(0.0, 0.0), (4.0, 0.0), (4.0, 1.0), (3.0, 0.0), (1.0, 0.0), (0.0, 1.0)]).unwrap_err();
    assert!(matches!(overlap, PolygonError::EdgesTouch { at, .. } if at.y == 0.0), "{overlap}");
}

#[test]
fn a_spike_without_width_is_told_with_its_tip() {
    let tip = DVec2::new(3.0, 3.0);
    let longer = polygon(&[(0.0, 2.0), (1.0, 1.0), (3.0, 3.0), (0.5, 0.5), (0.0, 0.0)]);
    assert_eq!(longer, Err(PolygonError::FoldsBack { index: 2, at: tip }));
    let back_and_forth = polygon(&[(0.0, 0.0), (3.0, 3.0), (2.0, 2.0), (8.0, 8.0), (0.0, 8.0)]);
    assert_eq!(back_and_forth, Err(PolygonError::FoldsBack { index: 1, at: tip }));
}

#[test]
fn vertical_edges_are_no_special_case() {
    let comb = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (2.0, 2.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    assert!(polygon(&comb).is_ok());
    let pierced = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (2.0, 2.0), (2.0, 0.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    assert!(matches!(polygon(&pierced), Err(PolygonError::EdgesTouch { at, .. }) if at == DVec2::new(2.0, 0.0)));
    let pierced = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (2.0, 2.0), (2.0, -1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)];
    // Both edges at (2, −1) cross the bottom: at (2, 0) and at (1.5, 0).
    assert!(matches!(polygon(&pierced), Err(PolygonError::EdgesCross { first: 0, at, .. }) if at.y == 0.0));
}

#[test]
fn a_gap_of_one_rounding_unit_is_seen() {
    let gap = 2.0 + 4.0 * f64::EPSILON;
    let open = [(0.0, 0.0), (4.0, 2.0), (4.0, 4.0), (2.0, 1.0 + f64::EPSILON), (0.0, 4.0)];
    assert!(polygon(&open).is_ok());
    let closed = [(0.0, 0.0), (4.0, 2.0), (4.0, 4.0), (gap, 1.0 + f64::EPSILON), (0.0, 4.0)];
    assert!(polygon(&closed).is_err());
}

#[test]
fn area_and_perimeter_of_a_right_triangle() {
    let p = polygon(&[(1.0, 1.0), (4.0, 1.0), (1.0, 5.0)]).unwrap();
    assert_eq!((p.area(), p.perimeter()), (6.0, 12.0));
    assert_eq!(p.bounds(), Bounds { min: DVec2::new(1.0, 1.0), max: DVec2::new(4.0, 5.0) });
    assert_eq!(p.bounds().center(), DVec2::new(2.5, 3.0));
}

#[test]
fn contains_is_strict_on_vertices_and_edges() {
    let p = polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]).unwrap();
    for (x, y) in [(0.5, 0.5), (0.5, 1.0), (1.5, 0.5), (0.999, 1.0)] {
        assert!(p.contains(DVec2::new(x, y)), "({x}, {y})");
    }
    for (x, y) in [(0.0, 0.0), (1.0, 1.0), (1.5, 1.0), (1.0, 1.5), (0.0, 1.0), (1.5, 1.5), (-1.0, 1.0), (3.0, 2.0)] {
        assert!(!p.contains(DVec2::new(x, y)), "({x}, {y})");
    }
}

#[test]
fn pole_of_a_rectangle_and_of_an_l() {
    let rectangle = polygon(&[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)]).unwrap();
    let pole = rectangle.pole_of_inaccessibility(1e-3);
    assert!((pole.y - 1.0).abs() <= 1e-3 && pole.x > 0.99 && pole.x < 3.01, "{pole}");
    // Inscribed circle in the corner of the L: tangent to x = 0, y = 0 and through (1, 1).
    let l = polygon(&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]).unwrap();
    let pole = l.pole_of_inaccessibility(1e-6);
    assert_relative_eq!(pole.x, 2.0 - 2f64.sqrt(), epsilon = 1e-3);
    assert_relative_eq!(pole.y, 2.0 - 2f64.sqrt(), epsilon = 1e-3);
}

#[test]
fn the_pole_is_inside_for_any_tolerance_and_any_sliver() {
    let slivers = [
        vec![(0.0, 0.0), (1.0, 1.0), (1.0, 1.0 + 1e-12)],
        vec![(0.0, 0.0), (1e6, 0.0), (1e6, 1e-9)],
        vec![(0.0, 0.0), (1e-9, 1e6), (0.0, 1e6)],
        vec![(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0), (0.0, 0.999), (0.999, 0.999), (0.999, 0.001)],
    ];
    for coordinates in slivers {
        let p = polygon(&coordinates).unwrap();
        for tolerance in [1e-300, 1e-3, 1e9, f64::NAN, f64::INFINITY, -1.0] {
            let pole = p.pole_of_inaccessibility(tolerance);
            assert!(p.contains(pole), "{coordinates:?}, tolerance {tolerance}: {pole}");
        }
    }
}

/// Shapes with 200,000 points that defeat grids or one-axis sweeps.
fn hard_shapes(n: u32) -> Vec<(&'static str, Vec<DVec2>)> {
    let star =
        (0..n).map(|k| (if k % 2 == 0 { 1.0 } else { 0.5 }) * DVec2::from_angle(TAU * f64::from(k) / f64::from(n)));
    let needles =
        (0..n).map(|k| (if k % 2 == 0 { 1.0 } else { 1e-3 }) * DVec2::from_angle(TAU * f64::from(k) / f64::from(n)));
    let comb = |angle: f64| -> Vec<DVec2> {
        let teeth = (0..n).map(|k| DVec2::new(f64::from(k) / f64::from(n), f64::from(k % 2) * 0.9 + 0.1));
        let close = [DVec2::new(1.0, 0.0), DVec2::ZERO];
        teeth.chain(close).take(n as usize + 2).map(|p| DVec2::from_angle(angle).rotate(p)).collect()
    };
    vec![
        ("star", star.collect()),
        ("needles", needles.collect()),
        ("comb", comb(0.0)),
        ("comb on its side", comb(TAU / 4.0)),
        ("slanted comb", comb(TAU / 8.0)),
        ("disk", radial(n, |_| 1.0)),
    ]
}

#[test]
fn hard_shapes_of_200_000_points_are_checked_in_under_a_second() {
    for (name, shape) in hard_shapes(199_998) {
        let start = web_time::Instant::now();
        let checked = SimplePolygon::try_from(shape);
        let elapsed_ms = start.elapsed().as_secs_f64() * 1e3;
        println!("{name}: {elapsed_ms:.0} ms");
        assert!(checked.is_ok(), "{name}: {:?}", checked.err());
        // Measured: 40 to 200 ms; a quadratic check would need minutes.
        assert!(elapsed_ms < 3000.0, "{name} took {elapsed_ms} ms");
    }
}

proptest! {
    /// Small integer grids are full of touching, overlapping and vertical edges.
    #[test]
    fn the_sweep_agrees_with_all_pairs(coordinates in prop::collection::vec((0..6i32, 0..6i32), 3..9)) {
        let v: Vec<DVec2> = coordinates.iter().map(|&(x, y)| DVec2::new(x.into(), y.into())).collect();
        let distinct = (0..v.len()).all(|i| (0..i).all(|j| v[i] != v[j]));
        let result = SimplePolygon::try_from(v.clone());
        prop_assert_eq!(result.is_ok(), distinct && is_simple_by_all_pairs(&v), "{:?}", result);
        if let Ok(p) = result {
            prop_assert!(p.area() > 0.0);
            prop_assert!(p.contains(p.pole_of_inaccessibility(0.01)));
        }
    }

    #[test]
    fn the_sweep_agrees_with_all_pairs_on_noisy_circles(
        noise in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64), 5..40),
        amplitude in 0.0..0.6f64,
    ) {
        let n = noise.len() as f64;
        let v: Vec<DVec2> = noise.iter().enumerate()
            .map(|(k, &(x, y))| DVec2::from_angle(TAU * k as f64 / n) + amplitude * DVec2::new(x, y))
            .collect();
        let result = SimplePolygon::try_from(v.clone());
        prop_assert_eq!(result.is_ok(), is_simple_by_all_pairs(&v), "{:?}", result);
        if let Ok(p) = result {
            prop_assert!(p.contains(p.pole_of_inaccessibility(0.01)));
            prop_assert!(p.vertices().iter().all(|&x| !p.contains(x)));
        }
    }
}
