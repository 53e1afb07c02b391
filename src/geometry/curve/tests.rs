//! Curves: derivatives, offsets from both ends, junctions, lengths, the inside, and what is refused.

use super::*;
use std::f64::consts::FRAC_PI_2;

fn half_disk() -> Curve {
    let arc = Piece::circular(DVec2::ZERO, 1.0, 0.0, PI);
    Curve::new(vec![arc, Piece::Line([DVec2::new(-1.0, 0.0), DVec2::new(1.0, 0.0)])]).unwrap()
}

/// e^{is}(1 + 0.3 cos 3s), a closed curve by formula.
fn clover(s: f64) -> Jet {
    let (radius, slope, bend) = (1.0 + 0.3 * (3.0 * s).cos(), -0.9 * (3.0 * s).sin(), -2.7 * (3.0 * s).cos());
    let spoke = DVec2::from_angle(s);
    Jet {
        position: radius * spoke,
        first: slope * spoke + radius * spoke.perp(),
        second: (bend - radius) * spoke + 2.0 * slope * spoke.perp(),
    }
}

fn pieces() -> [Piece; 4] {
    let p = DVec2::new;
    [
        Piece::Line([p(0.3, 0.1), p(2.0, -1.0)]),
        Piece::Arc { center: p(1.0, 2.0), axes: [p(2.0, 0.1), p(-0.2, 0.7)], from: 0.4, to: -1.3 },
        Piece::Cubic([p(0.0, 0.0), p(0.4, 1.0), p(1.5, 1.2), p(2.0, 0.3)]),
        Piece::Formula { function: clover, from: 0.2, to: 1.9 },
    ]
}

#[test]
fn derivatives_are_those_of_the_position() {
    let step = 1e-5;
    for piece in pieces() {
        for t in [0.1, 0.5, 0.83] {
            let (a, here, b) = (piece.jet(t - step), piece.jet(t), piece.jet(t + step));
            let first = (b.position - a.position) / (2.0 * step);
            let second = (b.first - a.first) / (2.0 * step);
            assert!(first.distance(here.first) < 1e-8 && second.distance(here.second) < 1e-7, "{piece:?} at {t}");
        }
    }
}

#[test]
fn offsets_from_both_ends_keep_their_digits() {
    for piece in pieces() {
        let (start, end) = (piece.jet(0.0), piece.jet(1.0));
        for t in [1e-3, 1e-9, 1e-14, 1e-100] {
            // z(t) − z(0) = z′(0) t + z″(0) t²/2 up to t³
            let near = piece.from_start(t).position;
            let taylor = t * (start.first + 0.5 * t * start.second);
            assert!(near.distance(taylor) < t * (1e-14 + 60.0 * t * t), "{piece:?} from its start: {near}, {taylor}");
            let near = piece.from_end(t).position;
            let taylor = t * (0.5 * t * end.second - end.first);
            assert!(near.distance(taylor) < t * (1e-14 + 60.0 * t * t), "{piece:?} from its end: {near}, {taylor}");
        }
        for t in [0.01, 0.02, 0.5, 0.9] {
            let whole = piece.jet(t);
            assert!((start.position + piece.from_start(t).position).distance(whole.position) < 1e-14);
            let from_end = piece.from_end(1.0 - t);
            assert!((end.position + from_end.position).distance(whole.position) < 1e-14);
            assert!(from_end.first.distance(whole.first) < 1e-13);
        }
    }
}

#[test]
fn junctions_have_their_kinds_and_angles() {
    let curve = half_disk();
    for junction in curve.junctions() {
        assert!(matches!(junction, Junction::Corner { angle } if (angle - FRAC_PI_2).abs() < 1e-15), "{junction:?}");
    }
    let p = DVec2::new;
    // a stadium: two lines and two half circles
    let stadium = Curve::new(vec![
        Piece::Line([p(-1.0, -1.0), p(1.0, -1.0)]),
        Piece::circular(p(1.0, 0.0), 1.0, -FRAC_PI_2, FRAC_PI_2),
        Piece::Line([p(1.0, 1.0), p(-1.0, 1.0)]),
        Piece::circular(p(-1.0, 0.0), 1.0, FRAC_PI_2, 3.0 * FRAC_PI_2),
    ]);
    assert_eq!(stadium.unwrap().junctions(), [Junction::Smooth; 4]);
    let circle = Curve::new(vec![Piece::circular(DVec2::ZERO, 2.0, 0.0, TAU)]).unwrap();
    assert_eq!(circle.junctions(), [Junction::Analytic]);
    let l = [(0., 0.), (1., 0.), (2., 0.), (2., 1.), (1., 1.), (1., 2.), (0., 2.)].map(DVec2::from).to_vec();
    let l = Curve::from_polygon(&SimplePolygon::try_from(l).unwrap()).unwrap();
    assert_eq!(l.junctions()[1], Junction::Analytic);
    assert!(matches!(l.junctions()[4], Junction::Corner { angle } if (angle - 1.5 * PI).abs() < 1e-15));
    assert!(matches!(l.analytic_at(0), Err(CurveError::NotAnalytic { piece: 0 })));
}

#[test]
fn lengths_and_fractions_agree() {
    let curve = half_disk();
    assert!((curve.perimeter() - PI - 2.0).abs() < 1e-14);
    let clover = Curve::new(vec![Piece::Formula { function: clover, from: 0.0, to: TAU }]).unwrap();
    for curve in [&curve, &clover] {
        for k in 0..20 {
            let fraction = f64::from(k) / 20.0;
            let point = curve.point_at_fraction(fraction);
            let before: f64 = curve.lengths()[..point.piece()].iter().sum();
            let found = before + curve.pieces()[point.piece()].length_to(point.from_start());
            assert!((found / curve.perimeter() - fraction).abs() < 1e-13, "{fraction}: {found}");
        }
    }
    assert_eq!(curve.point_at_fraction(-0.25), curve.point_at_fraction(0.75));
}

#[test]
fn the_inside_is_where_the_curve_winds_around() {
    let curve = half_disk();
    for (x, y, inside) in
        [(0.0, 0.5, true), (0.0, -1e-6, false), (0.0, 1e-6, true), (0.7, 0.72, false), (3.0, 0.0, false)]
    {
        assert_eq!(curve.contains(DVec2::new(x, y)), inside, "({x}, {y})");
    }
    assert!(curve.contains(DVec2::from_angle(1.0) * (1.0 - 1e-9)));
    assert!(!curve.contains(DVec2::from_angle(1.0) * (1.0 + 1e-9)));
    assert!(!curve.contains(DVec2::NAN));
}

#[test]
fn what_is_no_closed_curve_is_refused_with_its_place() {
    let p = DVec2::new;
    let line = |a: (f64, f64), b: (f64, f64)| Piece::Line([a.into(), b.into()]);
    let error = |pieces: Vec<Piece>| Curve::new(pieces).unwrap_err();
    assert_eq!(error(vec![]), CurveError::Empty);
    let nan = vec![line((0., 0.), (1., 0.)), line((1., 0.), (f64::NAN, 1.))];
    assert_eq!(error(nan), CurveError::NotFinite { piece: 1 });
    assert_eq!(error(vec![line((0., 0.), (0., 0.))]), CurveError::NoLength { piece: 0 });
    let open = vec![line((0., 0.), (1., 0.)), line((1., 0.), (1., 1.)), line((1., 1.), (0., 0.5))];
    assert!(matches!(error(open), CurveError::Open { piece: 0, gap } if (gap - 0.5).abs() < 1e-15));
    let clockwise = vec![line((0., 0.), (1., 1.)), line((1., 1.), (1., 0.)), line((1., 0.), (0., 0.))];
    assert_eq!(error(clockwise), CurveError::Clockwise);
    let stalled = Piece::Cubic([p(0.0, 0.0), p(0.0, 0.0), p(1.0, 1.0), p(1.0, 2.0)]);
    assert!(matches!(error(vec![stalled, line((1., 2.), (0., 0.))]), CurveError::NoTangent { piece: 0, .. }));
    let [arc, tangent] =
        [Piece::circular(p(0.0, 1.0), 1.0, -FRAC_PI_2, FRAC_PI_2), Piece::Line([p(0.0, 2.0), p(-4.0, 0.0)])];
    let back = Piece::Line([p(-4.0, 0.0), p(0.0, 0.0)]);
    assert!(Curve::new(vec![arc, tangent, back]).is_ok());
    let fold =
        vec![line((0., 0.), (2., 0.)), line((2., 0.), (1., 0.)), line((1., 0.), (0., 1.)), line((0., 1.), (0., 0.))];
    assert!(matches!(error(fold), CurveError::Cusp { piece: 1, .. }));
}
