//! Outlines that are too long for a link, with as many of their points as fit.
//!
//! Points go in the order of [`super::thinning`], on both sides up to the same level, the lowest with which the link
//! fits: found by bisection, for a session that has only these outlines, with [`RESERVE`] for the rest. So the result
//! depends on the outlines alone, and is kept for the next link with them. Corners of smooth outlines stay, as does the
//! first point, from which arc length is counted.

use super::thinning::levels;
use super::{MAX_LENGTH, fragment, prepared};
use crate::conformal::{PerSide, Pins, Side};
use crate::geometry::{DVec2, EdgeTree, SimplePolygon, sort_by_number};
use crate::outline::{CurveForm, Interpretation};
use crate::session::{Command, OutlineSpec, Session, SidePoints};
use std::cell::RefCell;

/// The characters that the settings, points and names of a session take at most besides the outlines.
const RESERVE: usize = 640;
/// Points of a smooth curve per vertex at which its distance from the outline is measured.
const PER_VERTEX: usize = 8;

/// An outline with fewer points.
#[derive(Debug, Clone)]
pub(super) struct Shortened {
    pub outline: OutlineSpec,
    /// The vertices that remain, ascending.
    kept: Vec<usize>,
    /// The largest distance between the two outlines, in sizes of the outline.
    pub deviation: f64,
}

/// The outlines of a session, and what remains of them.
type Known = (PerSide<OutlineSpec>, PerSide<Option<Shortened>>);

thread_local! {
    static LAST: RefCell<Option<Known>> = const { RefCell::new(None) };
}

/// The sides whose outlines are shortened so that the link fits; none if no level suffices.
pub(super) fn shortened(session: &Session) -> PerSide<Option<Shortened>> {
    let outlines = PerSide::from_fn(|side| session.domain(side).outline.clone());
    if let Some(known) = LAST.with_borrow(|last| last.as_ref().filter(|(known, _)| *known == outlines).cloned()) {
        return known.1;
    }
    let found = fitting(&outlines).unwrap_or_default();
    LAST.set(Some((outlines, found.clone())));
    found
}

/// The session with its outlines shortened; the points stay where they are, boundary points, pins and marks up to the
/// deviation.
pub(super) fn applied(session: &Session, shortened: &PerSide<Option<Shortened>>) -> Session {
    let polygons = PerSide::from_fn(|side| session.domain(side).outline.polygon());
    let carried = |side: Side, fraction: f64| {
        shortened[side].as_ref().map_or(fraction, |shorter| shorter.anchor(polygons[side].vertices(), fraction))
    };
    let reshaped = |side: Side| {
        let outline = shortened[side].as_ref()?.outline.clone();
        let points = session.side(side).outline_points();
        let interior = if let SidePoints::Outline { interior, .. } = points { interior } else { None };
        Some(Command::ReshapeOutline { side, outline, interior, anchor: carried(side, points.anchor()) })
    };
    let marked = |side: Side| {
        let marks = session.marks(side).map(|marks| marks.map(|mark| carried(side, mark)));
        marks.map(|marks| Command::SetMarks { side, marks: Some(marks) })
    };
    let pins = session.pins().map(|pins| {
        let pairs = pins.pairs().iter().map(|pair| PerSide::from_fn(|side| carried(side, pair[side])));
        // two pins may fall together on a shorter outline: then the points determine the map
        Command::SetPins(Pins::new(pairs).ok())
    });
    let sides = Side::BOTH.into_iter().flat_map(|side| [reshaped(side), marked(side)].into_iter().flatten());
    session.clone().and(sides.chain(pins).collect::<Vec<_>>())
}

fn fitting(outlines: &PerSide<OutlineSpec>) -> Option<PerSide<Option<Shortened>>> {
    let sides = outlines.as_ref().map(Thinned::new);
    let mut all: Vec<f64> = sides.iter().filter_map(|(_, side)| side.as_ref()).flat_map(Thinned::finite).collect();
    sort_by_number(&mut all, |level| *level);
    all.dedup();
    let at = |level: f64| sides.as_ref().map(|side| side.as_ref().and_then(|side| side.at(level)));
    let fits = |level: f64| fits(outlines, &at(level));
    let (mut short, mut long) = (all.len().checked_sub(1)?, 0);
    if !fits(all[short]) {
        return None;
    }
    while long < short {
        let middle = usize::midpoint(long, short);
        if fits(all[middle]) { short = middle } else { long = middle + 1 }
    }
    let found = at(all[short]);
    Some(PerSide::from_fn(|side| {
        let outline = found[side].clone()?;
        let thinned = sides[side].as_ref()?;
        let kept = thinned.kept(all[short]);
        let deviation = deviation(thinned.outline, &outline, &kept);
        Some(Shortened { outline, kept, deviation })
    }))
}

/// Whether a link with these outlines leaves room for the rest of a session.
fn fits(outlines: &PerSide<OutlineSpec>, shorter: &PerSide<Option<OutlineSpec>>) -> bool {
    let session = Side::BOTH.into_iter().fold(Session::default(), |session, side| {
        let outline = shorter[side].as_ref().unwrap_or(&outlines[side]);
        session.with_outline(side, outline.clone())
    });
    let prepared = PerSide::from_fn(|side| prepared(&session.domain(side).outline));
    let is_whole = prepared.iter().all(|(_, outline)| !outline.is_too_long());
    is_whole && fragment(&session, &prepared).is_some_and(|fragment| fragment.len() + RESERVE <= MAX_LENGTH)
}

/// An outline and the levels at which its vertices go.
struct Thinned<'a> {
    outline: &'a OutlineSpec,
    is_smooth: bool,
    corners: Vec<usize>,
    levels: Vec<f64>,
}

impl<'a> Thinned<'a> {
    /// `None` for a preset.
    fn new(outline: &'a OutlineSpec) -> Option<Self> {
        let OutlineSpec::Points { polygon, form, .. } = outline else { return None };
        let is_smooth = !outline.is_only_polygon() && outline.curve().is_ok_and(|curve| curve.is_smooth());
        let corners = if is_smooth { form.corners(polygon) } else { Vec::new() };
        let kept: Vec<usize> = corners.iter().copied().chain([0]).collect();
        let levels = levels(polygon.vertices(), &kept);
        Some(Self { outline, is_smooth, corners, levels })
    }

    fn finite(&self) -> impl Iterator<Item = f64> {
        self.levels.iter().copied().filter(|level| level.is_finite())
    }

    fn kept(&self, level: f64) -> Vec<usize> {
        (0..self.levels.len()).filter(|&k| self.levels[k] > level).collect()
    }

    /// The outline without the vertices up to a level; `None` if all stay.
    fn at(&self, level: f64) -> Option<OutlineSpec> {
        let OutlineSpec::Points { name, polygon, .. } = self.outline else { return None };
        let kept = self.kept(level);
        if kept.len() == self.levels.len() {
            return None;
        }
        let points: Vec<DVec2> = kept.iter().map(|&k| polygon.vertices()[k]).collect();
        let polygon = SimplePolygon::try_from(points).ok().filter(|polygon| !polygon.was_clockwise())?;
        let form = self.form(&polygon, &kept);
        Some(OutlineSpec::Points { name: name.clone(), polygon, form })
    }

    /// The form of the curve: smooth with the same corners, or the polygon.
    fn form(&self, polygon: &SimplePolygon, kept: &[usize]) -> CurveForm {
        if !self.is_smooth {
            let is_only = self.outline.is_only_polygon();
            return if is_only { CurveForm::of_polygon(polygon) } else { CurveForm::polygon() };
        }
        let smooth = CurveForm { interpretation: Interpretation::Smooth, ..CurveForm::default() };
        let corners: Vec<usize> = self.corners.iter().filter_map(|corner| kept.binary_search(corner).ok()).collect();
        let detected = smooth.corners(polygon);
        let differs = |k: &usize| corners.binary_search(k).is_ok() != detected.binary_search(k).is_ok();
        let switched = (0..kept.len()).filter(differs).map(|k| k as u32).collect();
        CurveForm { switched, ..smooth }
    }
}

impl Shortened {
    /// The number of points.
    pub fn len(&self) -> usize {
        self.kept.len()
    }

    /// The boundary point at this fraction of the length of the polygon `former`, as a fraction of the length of this
    /// one: at the same part of the way between two vertices that remain.
    fn anchor(&self, former: &[DVec2], fraction: f64) -> f64 {
        let step = |points: &[DVec2], k: usize| points[k].distance(points[(k + 1) % points.len()]);
        let total: f64 = (0..former.len()).map(|k| step(former, k)).sum();
        let place = fraction.rem_euclid(1.0) * total;
        let (mut walked, mut length, mut found) = (0.0, 0.0, 0.0);
        for (at, &k) in self.kept.iter().enumerate() {
            let next = self.kept.get(at + 1).copied().unwrap_or(former.len());
            let way: f64 = (k..next).map(|k| step(former, k)).sum();
            let edge = former[k].distance(former[next % former.len()]);
            if place >= walked {
                found = length + edge * ((place - walked) / way).min(1.0);
            }
            (walked, length) = (walked + way, length + edge);
        }
        found / length
    }
}

/// The largest distance between two outlines, in sizes of the former.
fn deviation(former: &OutlineSpec, shorter: &OutlineSpec, kept: &[usize]) -> f64 {
    let polygon = former.polygon();
    let size = polygon.bounds().size().max_element();
    let points = polygon.vertices();
    let smooth = shorter.curve().ok().filter(crate::outline::OutlineCurve::is_smooth);
    let largest = match smooth {
        Some(curve) => {
            let count = PER_VERTEX * kept.len();
            let curve = curve.curve();
            let at = |k: usize| curve.position(curve.point_at_fraction(k as f64 / count as f64));
            let dense: Vec<DVec2> = (0..count).map(at).collect();
            farthest(points, &dense).max(farthest(&dense, points))
        }
        None => cut_off(points, kept),
    };
    largest / size
}

/// The largest distance of `points` from a closed chain.
fn farthest(points: &[DVec2], chain: &[DVec2]) -> f64 {
    let tree = EdgeTree::new(chain);
    points.iter().map(|&p| tree.signed_distance(p).abs()).fold(0.0, f64::max)
}

/// The largest distance of a vertex that goes from the edge that replaces it. No point of the edge is farther from the
/// former outline, whose way from one end to the other passes beside each of them.
fn cut_off(points: &[DVec2], kept: &[usize]) -> f64 {
    let mut largest = 0.0_f64;
    for (at, &k) in kept.iter().enumerate() {
        let next = kept.get(at + 1).copied().unwrap_or(points.len() + kept[0]);
        let (a, b) = (points[k], points[next % points.len()]);
        for p in (k + 1..next).map(|k| points[k % points.len()]) {
            let t = ((p - a).dot(b - a) / a.distance_squared(b)).clamp(0.0, 1.0);
            largest = largest.max(p.distance(a.lerp(b, t)));
        }
    }
    largest
}
