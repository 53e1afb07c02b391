//! A path of an SVG document in double precision, from the numbers that the document has.
//!
//! `usvg` rounds coordinates to single precision and turns arcs into Bézier curves. Here the element from which it made a
//! path is found again, by comparison of all points: `path`, `rect`, `polygon`, `polyline`, `circle`, `ellipse`. Arcs by the
//! endpoint parametrization of SVG 2, appendix B.2.4 and B.2.5.

use std::f64::consts::TAU;

use glam::DAffine2;
use svgtypes::{PathParser, PathSegment as Command, PointsParser};
use usvg::roxmltree::{Document, Node};
use usvg::tiny_skia_path::{Path, PathSegment};

use super::super::Segment;
use super::super::corners::turn_between;
use super::svg_path::Subpath;
use crate::geometry::DVec2;

/// The subpaths of the document's element that has the points of `path`, and where the document places it: as `placement`
/// up to rounding, which else is taken. `None` if there is no such element.
pub(super) fn subpaths(document: &Document, path: &Path, placement: DAffine2) -> Option<(Vec<Subpath>, DAffine2)> {
    let elements = document.descendants().filter(Node::is_element);
    let same = |element| shape(element).filter(|subpaths| is_same(subpaths, path)).map(|found| (element, found));
    let mut first = None;
    for (element, mut found) in elements.filter_map(same) {
        found.retain(|subpath| !subpath.segments().is_empty());
        if let Some(exact) = transform(element).filter(|exact| agree(exact, &placement, path)) {
            return Some((found, exact));
        }
        first.get_or_insert((found, placement));
    }
    first
}

/// Whether a text is the data of a path that draws something.
pub(super) fn is_path_data(text: &str) -> bool {
    of_data(text).is_some_and(|subpaths| subpaths.iter().any(|subpath| !subpath.segments().is_empty()))
}

/// The product of the transforms of an element and those around it; `None` where one cannot be read.
fn transform(element: Node) -> Option<DAffine2> {
    let own = |node: Node| match node.attribute("transform") {
        None => Some(DAffine2::IDENTITY),
        Some(text) => {
            let t: svgtypes::Transform = text.parse().ok()?;
            Some(DAffine2::from_cols_array(&[t.a, t.b, t.c, t.d, t.e, t.f]))
        }
    };
    element.ancestors().filter(Node::is_element).try_fold(DAffine2::IDENTITY, |inner, node| Some(own(node)? * inner))
}

/// Whether two placements of a path differ by rounding to single precision only.
fn agree(exact: &DAffine2, rounded: &DAffine2, path: &Path) -> bool {
    let bounds = path.bounds();
    let [low, high] = [(bounds.left(), bounds.top()), (bounds.right(), bounds.bottom())]
        .map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    let corners = [low, DVec2::new(low.x, high.y), DVec2::new(high.x, low.y), high];
    let size =
        rounded.translation.length() + corners.map(|p| rounded.transform_vector2(p).length()).iter().sum::<f64>();
    corners.iter().all(|&p| exact.transform_point2(p).distance(rounded.transform_point2(p)) <= ROUNDING * size)
}

fn shape(element: Node) -> Option<Vec<Subpath>> {
    match element.tag_name().name() {
        "path" => of_data(element.attribute("d")?),
        "polygon" | "polyline" => of_points(element.attribute("points")?, element.tag_name().name() == "polygon"),
        "rect" => rectangle(element).map(|subpath| vec![subpath]),
        "circle" => {
            let radius = number(element, "r")?;
            Some(vec![ellipse(center(element)?, DVec2::splat(radius))])
        }
        "ellipse" => Some(vec![ellipse(center(element)?, DVec2::new(number(element, "rx")?, number(element, "ry")?))]),
        _ => None,
    }
}

/// A number without a unit; 0 is the default of a center.
fn number(element: Node, name: &str) -> Option<f64> {
    element.attribute(name)?.trim().parse().ok().filter(|x: &f64| x.is_finite())
}

fn center(element: Node) -> Option<DVec2> {
    let at = |name| if element.has_attribute(name) { number(element, name) } else { Some(0.0) };
    Some(DVec2::new(at("cx")?, at("cy")?))
}

/// From the upper left corner to the right, as `usvg` draws; rounded corners are quarters of ellipses.
fn rectangle(element: Node) -> Option<Subpath> {
    let at = |name| if element.has_attribute(name) { number(element, name) } else { Some(0.0) };
    let (low, size) =
        (DVec2::new(at("x")?, at("y")?), DVec2::new(number(element, "width")?, number(element, "height")?));
    let high = low + size;
    let given = ["rx", "ry"].map(|name| element.has_attribute(name).then(|| number(element, name)));
    let (rx, ry) = match given {
        [None, None] => (0.0, 0.0),
        [Some(r), None] | [None, Some(r)] => (r?, r?),
        [Some(rx), Some(ry)] => (rx?, ry?),
    };
    let r = DVec2::new(rx, ry).min(0.5 * size);
    let mut subpath = Subpath::at(DVec2::new(low.x + r.x, low.y));
    let sides = [(high.x - r.x, low.y), (high.x, high.y - r.y), (low.x + r.x, high.y), (low.x, low.y + r.y)];
    if r.min_element() <= 0.0 {
        for (x, y) in [(high.x, low.y), (high.x, high.y), (low.x, high.y)] {
            subpath.line(DVec2::new(x, y));
        }
    } else {
        let (inner_low, inner_high) = (low + r, high - r);
        let centers = [(inner_high.x, inner_low.y), inner_high.into(), (inner_low.x, inner_high.y), inner_low.into()];
        for (k, (side, center)) in sides.into_iter().zip(centers).enumerate() {
            subpath.line(side.into());
            let from = TAU * (k as f64 - 1.0) / 4.0;
            let axes = [DVec2::new(r.x, 0.0), DVec2::new(0.0, r.y)];
            subpath.push(Segment::Arc { center: center.into(), axes, from, to: from + TAU / 4.0 });
        }
    }
    subpath.close();
    Some(subpath)
}

/// The whole from the rightmost point downwards, as `usvg` draws its four quarters.
fn ellipse(center: DVec2, radii: DVec2) -> Subpath {
    let axes = [DVec2::new(radii.x, 0.0), DVec2::new(0.0, radii.y)];
    let mut subpath = Subpath::at(center + axes[0]);
    subpath.push(Segment::Arc { center, axes, from: 0.0, to: TAU });
    subpath.close();
    subpath
}

fn of_points(points: &str, is_closed: bool) -> Option<Vec<Subpath>> {
    let mut points = PointsParser::from(points).map(|(x, y)| DVec2::new(x, y));
    let mut subpath = Subpath::at(points.next()?);
    points.for_each(|p| subpath.line(p));
    if is_closed {
        subpath.close();
    }
    Some(vec![subpath])
}

/// What the smooth commands continue: the control point before, of a cubic or of a quadratic curve.
#[derive(Clone, Copy)]
enum Before {
    Cubic(DVec2),
    Quadratic(DVec2),
    Other,
}

fn of_data(data: &str) -> Option<Vec<Subpath>> {
    let mut subpaths: Vec<Subpath> = Vec::new();
    let mut before = Before::Other;
    for command in PathParser::from(data) {
        let command = command.ok()?;
        if let Command::MoveTo { abs, x, y } = command {
            let origin = if abs { DVec2::ZERO } else { subpaths.last().map_or(DVec2::ZERO, current) };
            subpaths.push(Subpath::at(origin + DVec2::new(x, y)));
            before = Before::Other;
            continue;
        }
        let last = subpaths.last_mut()?;
        if last.is_closed_explicitly() && !matches!(command, Command::ClosePath { .. }) {
            // drawing on after closing begins a new subpath
            let start = last.start();
            subpaths.push(Subpath::at(start));
        }
        before = draw(subpaths.last_mut()?, command, before);
    }
    Some(subpaths)
}

/// Where the next command begins: the start of a closed subpath, otherwise its end.
fn current(subpath: &Subpath) -> DVec2 {
    if subpath.is_closed() { subpath.start() } else { subpath.end() }
}

fn draw(subpath: &mut Subpath, command: Command, before: Before) -> Before {
    let at = subpath.end();
    let point = |abs: bool, x: f64, y: f64| DVec2::new(x, y) + if abs { DVec2::ZERO } else { at };
    match command {
        Command::MoveTo { .. } => {}
        Command::LineTo { abs, x, y } => subpath.line(point(abs, x, y)),
        Command::HorizontalLineTo { abs, x } => subpath.line(DVec2::new(if abs { x } else { at.x + x }, at.y)),
        Command::VerticalLineTo { abs, y } => subpath.line(DVec2::new(at.x, if abs { y } else { at.y + y })),
        Command::CurveTo { abs, x1, y1, x2, y2, x, y } => {
            let control = point(abs, x2, y2);
            subpath.cubic(point(abs, x1, y1), control, point(abs, x, y));
            return Before::Cubic(control);
        }
        Command::SmoothCurveTo { abs, x2, y2, x, y } => {
            let first = if let Before::Cubic(control) = before { 2.0 * at - control } else { at };
            let control = point(abs, x2, y2);
            subpath.cubic(first, control, point(abs, x, y));
            return Before::Cubic(control);
        }
        Command::Quadratic { abs, x1, y1, x, y } => {
            let control = point(abs, x1, y1);
            subpath.quadratic(control, point(abs, x, y));
            return Before::Quadratic(control);
        }
        Command::SmoothQuadratic { abs, x, y } => {
            let control = if let Before::Quadratic(control) = before { 2.0 * at - control } else { at };
            subpath.quadratic(control, point(abs, x, y));
            return Before::Quadratic(control);
        }
        Command::EllipticalArc { abs, rx, ry, x_axis_rotation, large_arc, sweep, x, y } => {
            let to = point(abs, x, y);
            match arc([at, to], DVec2::new(rx, ry).abs(), x_axis_rotation.to_radians(), [large_arc, sweep]) {
                Some(arc) => subpath.push(arc),
                None => subpath.line(to),
            }
        }
        Command::ClosePath { .. } => subpath.close(),
    }
    Before::Other
}

/// The elliptic arc between two points; `None` if it is a line.
fn arc([a, b]: [DVec2; 2], radii: DVec2, rotation: f64, [large, sweep]: [bool; 2]) -> Option<Segment> {
    if radii.min_element() <= 0.0 || a == b || !radii.is_finite() {
        return None;
    }
    let turn = DVec2::from_angle(rotation);
    // in the frame of the unit circle, whose center is on the perpendicular of the chord
    let half = turn.conjugate().rotate(0.5 * (a - b)) / radii;
    let scale = half.length().max(1.0);
    let (half, radii) = (half / scale, radii * scale);
    let height = (1.0 / half.length_squared() - 1.0).max(0.0).sqrt();
    let middle = if large == sweep { -height } else { height } * DVec2::new(half.y, -half.x);
    let [start, end] = [half - middle, -half - middle];
    let mut angle = turn_between(start, end);
    if sweep && angle < 0.0 {
        angle += TAU;
    } else if !sweep && angle > 0.0 {
        angle -= TAU;
    }
    let center = a.midpoint(b) + turn.rotate(radii * middle);
    let axes = [turn.rotate(DVec2::new(radii.x, 0.0)), turn.rotate(DVec2::new(0.0, radii.y))];
    let from = start.to_angle();
    Some(Segment::Arc { center, axes, from, to: from + angle })
}

trait Conjugate {
    fn conjugate(self) -> Self;
}

impl Conjugate for DVec2 {
    fn conjugate(self) -> Self {
        Self::new(self.x, -self.y)
    }
}

/// Coordinates of single precision differ from the document's by less, relative to the largest.
const ROUNDING: f64 = 1e-6;
/// The most Bézier curves of one arc.
const MOST_OF_ARC: usize = 8;

/// Whether `usvg` made `path` of these subpaths.
fn is_same(subpaths: &[Subpath], path: &Path) -> bool {
    let ends = || subpaths.iter().flat_map(|s| s.segments().iter().map(Segment::end).chain([s.start()]));
    let size = ends().fold(0.0, |size: f64, p| size.max(p.abs().max_element()));
    let near = |p: usvg::tiny_skia_path::Point, q: DVec2| {
        DVec2::new(f64::from(p.x), f64::from(p.y)).distance(q) <= ROUNDING * size
    };
    let mut made = path.segments().peekable();
    for subpath in subpaths.iter().filter(|subpath| !subpath.segments().is_empty()) {
        if !matches!(made.next(), Some(PathSegment::MoveTo(p)) if near(p, subpath.start())) {
            return false;
        }
        for segment in subpath.segments() {
            let is_same = match (segment, made.next()) {
                (Segment::Line([_, q]), Some(PathSegment::LineTo(p)))
                | (Segment::Cubic([.., q]), Some(PathSegment::QuadTo(_, p))) => near(p, *q),
                (Segment::Cubic([_, b, c, q]), Some(PathSegment::CubicTo(s, t, p))) => {
                    near(s, *b) && near(t, *c) && near(p, *q)
                }
                (arc @ Segment::Arc { from, to, .. }, Some(PathSegment::CubicTo(.., p))) => {
                    let is_whole = (to - from).abs() == TAU;
                    let mut here = p;
                    let mut count = 1;
                    while count < MOST_OF_ARC && (!near(here, arc.end()) || (is_whole && count < 2)) {
                        let Some(PathSegment::CubicTo(.., next)) = made.next() else { return false };
                        (here, count) = (next, count + 1);
                    }
                    near(here, arc.end())
                }
                _ => false,
            };
            if !is_same {
                return false;
            }
        }
        while matches!(made.peek(), Some(PathSegment::Close)) {
            made.next();
        }
    }
    made.next().is_none()
}
