//! Lines, arcs and Bézier curves of SVG documents are kept.

use super::parse;
use crate::geometry::{DVec2, Piece};
use crate::outline::{CurveSource, Outline, OutlineCurve, Segment};

fn read(content: &str) -> (Outline, OutlineCurve) {
    let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\">{content}</svg>");
    let outline = parse("a.svg", text.as_bytes()).unwrap();
    let curve = outline.curve().unwrap();
    assert!(curve.is_smooth(), "{content}: {:?}", curve.stays_polygon());
    let start = curve.curve().pieces()[0].jet(0.0).position;
    assert!(start.distance(outline.polygon().vertices()[0]) < 1e-12, "{content} begins at {start}");
    (outline, curve)
}

fn is_arc(piece: &Piece) -> bool {
    matches!(piece, Piece::Arc { .. })
}

#[test]
fn circles_and_ellipses_are_one_arc() {
    for (content, area) in [
        ("<circle cx='50' cy='40' r='0.1'/>", 0.01),
        ("<ellipse cx='50' cy='40' rx='30' ry='10'/>", 300.0),
        ("<circle cx='5' cy='4' r='10' transform='rotate(30) scale(0.5 2)'/>", 100.0),
    ] {
        let (outline, curve) = read(content);
        let pieces = curve.curve().pieces();
        assert!(pieces.len() == 1 && is_arc(&pieces[0]) && curve.corner_count() == 0, "{content}: {pieces:?}");
        let polygon = outline.polygon().area() / std::f64::consts::PI;
        assert!((polygon / area - 1.0).abs() < 3e-4, "{content}: {polygon}");
    }
    let (_, curve) = read("<circle cx='50' cy='40' r='0.1'/>");
    // in single precision the center alone would be off by 2e-6
    assert!((curve.curve().perimeter() / (0.2 * std::f64::consts::PI) - 1.0).abs() < 1e-13);
}

#[test]
fn a_stadium_has_two_arcs_that_leave_lines_smoothly() {
    for content in [
        "<path d='M 10.1 10 H 20.3 A 5 5 0 0 1 20.3 20 H 10.1 A 5 5 0 0 1 10.1 10 Z'/>",
        "<path d='m10.1 10h10.2a5 5 0 010 10h-10.2a5 5 0 010-10z'/>",
        "<rect x='5.1' y='10' width='20.2' height='10' rx='5'/>",
    ] {
        let (_, curve) = read(content);
        let arcs: Vec<&Piece> = curve.curve().pieces().iter().filter(|piece| is_arc(piece)).collect();
        assert!(matches!(arcs.len(), 2 | 4) && curve.corner_count() == 0, "{content}: {:?}", curve.curve());
        for arc in arcs {
            for t in [0.0, 0.3, 1.0] {
                assert!((arc.jet(t).curvature() - 0.2).abs() < 1e-12, "{content}: {}", arc.jet(t).curvature());
            }
        }
        let exact = 2.0 * 10.2 + 10.0 * std::f64::consts::PI;
        assert!((curve.curve().perimeter() / exact - 1.0).abs() < 1e-14 * 10.0, "{content}");
    }
}

#[test]
fn arcs_by_end_points_go_the_way_that_their_flags_say() {
    // from (30, 0) to (0, 30) around the origin, or around (30, 30)
    for (flags, center, length) in [("0 1", 0.0, 0.25), ("0 0", 30.0, 0.25), ("1 1", 30.0, 0.75), ("1 0", 0.0, 0.75)] {
        let (outline, curve) = read(&format!("<path d='M 30 0 A 30 30 0 {flags} 0 30 Z'/>"));
        let Some(Segment::Arc { center: found, from, to, .. }) = arc_of(&outline) else { panic!("{outline:?}") };
        assert!(found.distance(DVec2::new(center, -center)) < 1e-13, "{flags}: {found}");
        assert!(((to - from).abs() / std::f64::consts::TAU - length).abs() < 1e-14, "{flags}");
        assert_eq!(curve.corner_count(), curve.curve().pieces().len());
    }
}

fn arc_of(outline: &Outline) -> Option<Segment> {
    let CurveSource::Segments(segments) = &outline.form().source else { return None };
    segments.iter().copied().find(|segment| matches!(segment, Segment::Arc { .. }))
}

#[test]
fn the_documents_numbers_are_kept_in_double_precision() {
    let (outline, _) = read("<path d='M 0.123456789012 1 C 1 2 3 3.000000001 4.1 1 L 2 0.000000123456 Z'/>");
    let vertices = outline.polygon().vertices();
    let has = |x: f64, y: f64| vertices.contains(&DVec2::new(x, -y));
    assert!(has(0.123_456_789_012, 1.0) && has(4.1, 1.0) && has(2.0, 0.000_000_123_456), "{vertices:?}");
    let CurveSource::Segments(segments) = &outline.form().source else { panic!() };
    assert_eq!(segments.len(), 3);
}

/// A rectangle in percent, whose numbers `usvg` has computed: lines and Bézier curves in single precision.
#[test]
fn rounding_to_single_precision_makes_no_corners() {
    let (_, curve) =
        read("<rect x='10.1%' y='7.3%' width='33.3%' height='51.7%' rx='7.7' ry='3.1' transform='rotate(17.3)'/>");
    assert!(curve.curve().pieces().iter().all(|piece| !is_arc(piece)), "the numbers are not the document's");
    assert_eq!(curve.corner_count(), 0, "{:?}", curve.curve().junctions());
    let (_, curve) = read("<rect x='10.1%' y='7.3%' width='33.3%' height='51.7%'/>");
    assert_eq!(curve.corner_count(), 4);
}

#[test]
fn retracted_handles_are_lines() {
    let (_, curve) = read("<path d='M 0 0 C 0 0 9 0 9 0 S 9 9 9 9 L 0 9 Z'/>");
    assert!(curve.curve().pieces().iter().all(Piece::is_straight) && curve.corner_count() == 4);
}

#[test]
fn a_curve_with_a_retracted_handle_has_the_direction_of_the_other_one() {
    // along x from (0, 0); at (9, 3) along the handle from (4, 0)
    for content in ["<path d='M0 0C4 0 9 3 9 3L9 8L0 8Z'/>", "<path d='M9 3C9 3 4 0 0 0L0 8L9 8Z'/>"] {
        let (_, curve) = read(content);
        let pieces = curve.curve().pieces();
        assert_eq!(curve.corner_count(), 4, "{content}: {pieces:?}");
        let tip = pieces.iter().flat_map(|piece| [piece.jet(0.0), piece.jet(1.0)]);
        let tip: Vec<f64> = tip
            .filter(|jet| jet.position == DVec2::new(9.0, -3.0) && jet.first.x != 0.0)
            .map(|jet| jet.first.y / jet.first.x)
            .collect();
        assert!(tip.len() == 1 && (tip[0] + 0.6).abs() < 1e-10, "{tip:?}");
        let lengths = pieces.iter().zip(curve.curve().lengths());
        let length: f64 = lengths.filter(|(piece, _)| !piece.is_straight()).map(|(_, length)| length).sum();
        assert!(length > 9.4 && length < 9.7, "{length}");
    }
}

/// Drawing programs make circles and pills of rectangles, between whose arcs rounding leaves lines of 1e-15.
#[test]
fn a_rectangle_with_corners_as_round_as_it_is_high_is_a_circle_or_a_pill() {
    for w in [2.0, 10.7, 18.0, 60.0_f64] {
        for (x, y) in [(3.0, 3.0), (3.3, 1.7)] {
            let circle = format!("<rect x='{x}' y='{y}' width='{w}' height='{w}' rx='{}'/>", 0.5 * w);
            let (_, curve) = read(&circle);
            let pieces = curve.curve().pieces();
            assert!(pieces.iter().all(is_arc) && curve.corner_count() == 0, "{circle}: {pieces:?}");
            let (_, curve) =
                read(&format!("<rect x='{x}' y='{y}' width='{}' height='{w}' rx='{}'/>", 2.0 * w, 0.5 * w));
            let lines = curve.curve().pieces().iter().filter(|piece| !is_arc(piece)).count();
            assert_eq!((lines, curve.corner_count()), (2, 0), "{w} at ({x}, {y})");
        }
    }
    // a radius beyond the half is the half
    let (_, curve) = read("<rect x='2.3' y='6.1' width='20' height='12.7' rx='50'/>");
    assert_eq!(curve.corner_count(), 0);
}

#[test]
fn a_page_has_its_size_in_any_unit() {
    for size in ["width='75pt' height='75pt'", "width='100' height='100'"] {
        let background = "<rect width='100%' height='100%' fill='#eee'/>";
        let text = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' {size}>{background}<rect x='20' y='30' width='40' height='40'/></svg>"
        );
        assert_eq!(parse("a.svg", text.as_bytes()).unwrap().polygon().area(), 1600.0, "{size}");
    }
    // without a size there is no page, and no background
    for size in ["", "width='100%' height='100%'"] {
        let text = format!(
            "<svg xmlns='http://www.w3.org/2000/svg' {size}><rect width='90' height='60'/><circle cx='30' cy='30' r='5'/></svg>"
        );
        assert_eq!(parse("a.svg", text.as_bytes()).unwrap().polygon().area(), 5400.0, "{size}");
    }
}
