//! The shapes that an SVG drawing shows: what can be its outline.
//!
//! Filling closes every subpath, so that each filled subpath bounds a shape, with or without `z`; of paths that are only
//! stroked, the closed subpaths do. Which subpaths bound the filled part from outside, and which are its holes, follows
//! from winding numbers (SVG 2, section 13.4.2). Paths that paint nothing are no shapes, and a page's background is
//! none if something lies on it.

use std::slice::Iter;

use glam::DAffine2;
use svgtypes::ViewBox;
use usvg::roxmltree::Document;
use usvg::{FillRule, Group, Node, Path, Tree};

use super::ring::{edges, signed_area};
use super::svg_path::Subpath;
use super::{OutlineNote, Part, Parts};
use crate::geometry::{Bounds, DVec2};
use crate::outline::flattened;
use crate::outline::overlaps::for_each_overlap;

/// A part of the drawing that is painted, with the subpath around it.
#[derive(Debug, Clone)]
pub(super) struct Shape<'a> {
    pub path: &'a Path,
    /// Its number among the path's subpaths that have a segment.
    pub subpath: usize,
    /// The painted area.
    area: f64,
    /// The number of holes in it.
    holes: usize,
    /// Whether it is a rectangle that covers the page.
    is_background: bool,
}

impl Shape<'_> {
    pub fn name(&self) -> Option<&str> {
        Some(self.path.id()).filter(|id| !id.is_empty())
    }

    /// What is said when it is taken as number `number` of `count`.
    pub fn notes(&self, number: usize, count: usize) -> Vec<OutlineNote> {
        let of_several =
            (count > 1).then(|| OutlineNote::ShapeTaken { number, count, name: self.name().map(str::to_owned) });
        let holes = (self.holes > 0).then_some(OutlineNote::HolesIgnored { holes: self.holes });
        of_several.into_iter().chain(holes).chain([OutlineNote::Upwards]).collect()
    }
}

/// The part of the plane that a drawing shows, y downwards as in its file.
pub(super) struct Page {
    low: DVec2,
    /// `None` if the drawing does not say it.
    size: Option<DVec2>,
}

impl Page {
    /// From the `viewBox`, or else the width and height, in pixels.
    pub fn of(document: &Document, tree: &Tree) -> Self {
        if let Some(view) = view_box(document) {
            return Self { low: DVec2::new(view.x, view.y), size: Some(DVec2::new(view.w, view.h)) };
        }
        let is_length = |name| document.root_element().attribute(name).is_some_and(|length| !length.contains('%'));
        // of a drawing without a size, `usvg` gives that of what is drawn
        let is_known = is_length("width") && is_length("height");
        let size = || DVec2::new(tree.size().width().into(), tree.size().height().into());
        Self { low: DVec2::ZERO, size: is_known.then(size) }
    }
}

/// The part of the plane that a drawing says to show.
pub(super) fn view_box(document: &Document) -> Option<ViewBox> {
    document.root_element().attribute("viewBox")?.parse().ok()
}

/// The shapes of a drawing, in its order, without a background; at most as many as it has subpaths.
pub(super) fn shapes<'a>(tree: &'a Tree, page: &Page) -> Vec<Shape<'a>> {
    let all = paths(tree.root());
    let shown = |wanted: bool| all.iter().filter(move |(_, is_painted)| *is_painted == wanted);
    let of = |wanted| shown(wanted).flat_map(|&(path, _)| shapes_of(path, page)).collect();
    let mut shapes: Vec<Shape> = of(true);
    if shapes.is_empty() {
        // a drawing of which nothing is seen still has a shape that somebody drew
        shapes = of(false);
    }
    if let Some(last) = shapes.iter().rposition(|shape| !shape.is_background) {
        let mut place = 0..;
        shapes.retain(|shape| !(shape.is_background && place.next().is_some_and(|k: usize| k < last)));
    }
    shapes
}

/// The shape of the largest painted area among those for which `is_meant` holds, the first among equals.
pub(super) fn largest(shapes: &[Shape], is_meant: impl Fn(&Shape) -> bool) -> Option<usize> {
    let meant = (0..shapes.len()).rev().filter(|&k| is_meant(&shapes[k]));
    meant.max_by(|&i, &j| shapes[i].area.total_cmp(&shapes[j].area))
}

/// All shapes with their pictures, of which that of index `taken` is read.
pub(super) fn parts(shapes: &[Shape], taken: usize, page: &Page) -> Option<Parts> {
    let areas: Vec<f64> = shapes.iter().map(|shape| shape.area).collect();
    // the shapes of one path stand together
    let mut last: Option<(&Path, Vec<Vec<DVec2>>)> = None;
    Parts::of(&areas, taken + 1, |k| {
        let shape = &shapes[k];
        if last.as_ref().is_none_or(|(path, _)| !std::ptr::eq(*path, shape.path)) {
            last = Some((shape.path, chains_of(shape.path, page)));
        }
        let (_, chains) = last.as_ref()?;
        Some(Part::new(k + 1, shape.name(), &chains[shape.subpath]))
    })
}

fn chains_of(path: &Path, page: &Page) -> Vec<Vec<DVec2>> {
    let placement = placement(path, page);
    Subpath::of(path.data()).iter().map(|subpath| flattened(&subpath.placed(placement))).collect()
}

/// The number of paths of the drawing, painted or not.
pub(super) fn path_count(tree: &Tree) -> usize {
    paths(tree.root()).len()
}

/// All paths in the order of painting, and whether they paint anything.
fn paths(root: &Group) -> Vec<(&Path, bool)> {
    let mut found = Vec::new();
    let mut stack: Vec<(Iter<Node>, bool)> = vec![(root.children().iter(), true)];
    while let Some((level, is_shown)) = stack.last_mut() {
        let is_shown = *is_shown;
        match level.next() {
            None => drop(stack.pop()),
            Some(Node::Group(group)) => {
                stack.push((group.children().iter(), is_shown && group.opacity().get() > 0.0));
            }
            Some(Node::Path(path)) => found.push((&**path, is_shown && is_painted(path))),
            Some(_) => {}
        }
    }
    found
}

fn is_painted(path: &Path) -> bool {
    let opacities = [path.fill().map(usvg::Fill::opacity), path.stroke().map(usvg::Stroke::opacity)];
    path.is_visible() && opacities.into_iter().flatten().any(|opacity| opacity.get() > 0.0)
}

fn shapes_of<'a>(path: &'a Path, page: &Page) -> Vec<Shape<'a>> {
    let subpaths = Subpath::of(path.data());
    let placement = placement(path, page);
    let chains: Vec<Vec<DVec2>> = subpaths.iter().map(|subpath| flattened(&subpath.placed(placement))).collect();
    let is_filled = path.fill().is_some_and(|fill| fill.opacity().get() > 0.0) || path.stroke().is_none();
    let parts = if is_filled {
        filled(&chains, path.fill().map(usvg::Fill::rule).unwrap_or_default())
    } else {
        let width = path.stroke().map_or(0.0, |stroke| f64::from(stroke.width().get()));
        let scale = placement.matrix2.determinant().abs().sqrt();
        let closed = (0..chains.len()).filter(|&k| subpaths[k].is_closed() && signed_area(&chains[k]) != 0.0);
        closed.map(|subpath| Region { subpath, area: width * scale * perimeter(&chains[subpath]), holes: 0 }).collect()
    };
    let shape = |Region { subpath, area, holes }| {
        let is_background = covers(&chains[subpath], page);
        Shape { path, subpath, area, holes, is_background }
    };
    parts.into_iter().map(shape).collect()
}

/// Where a path lies in user space: `usvg` moves the page's upper left corner to the origin.
pub(super) fn placement(path: &Path, page: &Page) -> DAffine2 {
    let t = path.abs_transform();
    let placed = DAffine2::from_cols_array(&[t.sx, t.ky, t.kx, t.sy, t.tx, t.ty].map(f64::from));
    DAffine2::from_translation(page.low) * placed
}

struct Region {
    subpath: usize,
    area: f64,
    holes: usize,
}

/// The subpaths that bound the filled part from outside, with its area; those without area bound nothing.
fn filled(chains: &[Vec<DVec2>], rule: FillRule) -> Vec<Region> {
    let boxes: Vec<Bounds> = chains.iter().map(|chain| Bounds::of(chain.iter().copied())).collect();
    let areas: Vec<f64> = chains.iter().map(|chain| signed_area(chain)).collect();
    let mut outside = vec![0; chains.len()];
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); chains.len()];
    // where there are too many pairs to examine, the rest count as lying side by side
    let mut budget = BUDGET;
    for_each_overlap(&boxes, &mut |i, j| {
        let [inner, outer] = if areas[i].abs() < areas[j].abs() { [i, j] } else { [j, i] };
        let contains =
            boxes[outer].min().cmple(boxes[inner].min()).all() && boxes[outer].max().cmpge(boxes[inner].max()).all();
        let cost = SAMPLES * chains[outer].len();
        if contains && areas[inner].abs() < areas[outer].abs() && budget >= cost {
            budget -= cost;
            let turns = winding_around(&chains[outer], &chains[inner]);
            if turns != 0 {
                outside[inner] += turns;
                around[inner].push(outer);
            }
        }
    });
    let is_filled = |winding: i32| match rule {
        FillRule::NonZero => winding != 0,
        FillRule::EvenOdd => winding % 2 != 0,
    };
    let sides = |k: usize| [outside[k], outside[k] + areas[k].signum() as i32].map(is_filled);
    let with_area = || (0..chains.len()).filter(|&k| areas[k] != 0.0);
    let mut parts: Vec<Region> = (with_area().filter(|&k| sides(k) == [false, true]))
        .map(|subpath| Region { subpath, area: areas[subpath].abs(), holes: 0 })
        .collect();
    for hole in with_area().filter(|&k| sides(k) == [true, false]) {
        let container = parts.iter_mut().filter(|part| around[hole].contains(&part.subpath));
        if let Some(part) = container.min_by(|a, b| areas[a.subpath].abs().total_cmp(&areas[b.subpath].abs())) {
            part.area -= areas[hole].abs();
            part.holes += 1;
        }
    }
    parts
}

fn perimeter(chain: &[DVec2]) -> f64 {
    edges(chain).map(|[a, b]| a.distance(b)).sum()
}

/// How often the closed chain goes around a point, counter-clockwise.
fn winding(chain: &[DVec2], point: DVec2) -> i32 {
    let turn = |[a, b]: [DVec2; 2]| {
        let side = (b - a).perp_dot(point - a);
        match (a.y <= point.y, b.y <= point.y) {
            (true, false) if side > 0.0 => 1,
            (false, true) if side < 0.0 => -1,
            _ => 0,
        }
    };
    edges(chain).map(turn).sum()
}

/// The most steps along chains in one path, half a second.
const BUDGET: usize = 400_000_000;
/// The places of a chain at which it is looked for another one around it.
const SAMPLES: usize = 5;

/// How often a chain goes around most of another one; 0 if they cross or touch along an edge.
fn winding_around(outer: &[DVec2], inner: &[DVec2]) -> i32 {
    let n = inner.len();
    let middle = |k: usize| inner[k].midpoint(inner[(k + 1) % n]);
    let turns: Vec<i32> = (0..SAMPLES.min(n)).map(|k| winding(outer, middle(k * n / SAMPLES.min(n)))).collect();
    let first = turns.first().copied().unwrap_or(0);
    if turns.iter().all(|&turn| turn == first) { first } else { 0 }
}

/// What a background may leave uncovered, as a fraction of the page.
const UNCOVERED: f64 = 1e-3;

/// Whether the chain is a rectangle with horizontal and vertical sides that contains the page.
fn covers(chain: &[DVec2], page: &Page) -> bool {
    let Some(size) = page.size else { return false };
    let own = Bounds::of(chain.iter().copied());
    let margin = UNCOVERED * size;
    // of the chain, y points upwards
    let high = DVec2::new(page.low.x + size.x, -page.low.y);
    let contains = own.min().cmple(high - size + margin).all() && own.max().cmpge(high - margin).all();
    contains && signed_area(chain).abs() >= (1.0 - UNCOVERED) * own.size().element_product()
}
