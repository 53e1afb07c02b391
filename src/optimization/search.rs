//! The search for the best map of a family, in steps.
//!
//! 1. **Scan**: maps that take points spread over one side's area to the other side's default point, under turns, in closed
//!    form on a few hundred triangles. 2. **Descent** from the best of them and from the start, by a downhill simplex in
//!    (turn, Re a, Im a) of a small Möbius map before T. 3. **Fit**: the best of these on many triangles. 4. **Polish**: the
//!    same on the map itself, whose criterion is measured as it is for the start. Last, whether the boundary points may
//!    stay as they were.
//!
//! Guaranteed: the result is never worse than the start, both measured on the map; the same input gives the same result, bit
//! for bit, however it is divided into steps. Not guaranteed: that no better map exists where the scan has no place near it.

use super::chart::Chart;
use super::family::{Family, Nodes, Staying};
use super::simplex::Simplex;
use super::{Criterion, OptimizeError};
use crate::conformal::{
    ConformalMap, Constraints, Direction, MapError, MapSettings, Moebius, PerSide, PreparedSide, Side,
};
use crate::geometry::DVec3;
use crate::laplace::Deadline;
use num_complex::Complex64;
use std::collections::VecDeque;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Triangles that stand for all in the scan, and in the fit; for symmetries, each of them is moved by all.
const FEW: usize = 500;
const MANY: usize = 5000;
const FEW_MOVED: usize = 120;
const MANY_MOVED: usize = 600;

/// Places of each side that are tried, and turns of each.
const PLACES: usize = 48;
const TURNS: u32 = 12;

/// Descents, from maps that differ by more than [`APART`] in the disk's distance.
const DESCENTS: usize = 6;
const APART: f64 = 0.5;

/// First and last size of the simplex in closed form; sizes are distances in the disk, where 1 moves the middle to 0.46.
const STEP: f64 = 0.3;
const SMALL: f64 = 1e-3;
/// The same for the map itself: near enough for four digits of the minimum, whose value changes with the square.
const POLISH_STEP: f64 = 0.08;
const POLISH_SMALL: f64 = 2e-3;

/// The most values of a descent.
const MOST_DESCENT: usize = 120;
/// The most values on the map itself of a mesh with [`USUAL`] vertices; on a larger one fewer, but [`LEAST_POLISH`].
const MOST_POLISH: usize = 150;
const LEAST_POLISH: usize = 80;
const USUAL: usize = 8000;

/// Boundary points that need not move stay, if that costs no more than this share of the criterion.
const NEGLIGIBLE: f64 = 1e-3;
/// Values that differ by less are equal: those of a disk onto a disk, which is 0 up to the mesh's error squared.
const ROUNDING: f64 = 1e-7;

/// What a search has found.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The best constraints; those of the start if nothing is better.
    pub constraints: Constraints,
    /// The criterion at the start, measured on the map.
    pub before: f64,
    /// The criterion of [`Self::constraints`], measured on the map.
    pub after: f64,
    /// What is minimized, of them.
    objective: f64,
}

/// What is done next.
#[derive(Debug)]
enum Stage {
    Begin,
    Chart(Option<Chart>),
    Scan(Scan),
    Descend(Descent),
    Fit(Descent),
    Polish(Descent),
    Keep(VecDeque<Constraints>),
    Done,
}

/// Maps still to be tried, and the best ones that were.
#[derive(Debug, Default)]
struct Scan {
    coming: VecDeque<Moebius>,
    tried: Vec<(f64, Moebius)>,
}

/// A descent from a map, and the maps from which others are still to be made.
#[derive(Debug)]
struct Descent {
    from: Moebius,
    /// Takes the point of the source's disk about which small maps turn, half way between the middles, to 0.
    middle: Moebius,
    simplex: Simplex,
    count: usize,
    coming: VecDeque<(f64, Moebius)>,
    best: (f64, Moebius),
}

/// A search under way.
#[derive(Debug)]
pub struct Optimization {
    map: ConformalMap,
    settings: MapSettings,
    /// The settings that were given; a criterion may need another direction.
    asked: MapSettings,
    criterion: Criterion,
    start: Constraints,
    stage: Stage,
    family: Option<(Family, Nodes)>,
    staying: Option<Staying>,
    found: Option<Found>,
    evaluations: usize,
    course: Vec<(usize, f64)>,
    /// The least value since closed form or measurement began.
    least: f64,
}

impl Optimization {
    /// A search among all conformal maps between the sides, which begins at the map with these constraints and settings.
    pub fn new(
        sides: PerSide<Arc<PreparedSide>>,
        criterion: Criterion,
        start: Constraints,
        settings: MapSettings,
    ) -> Self {
        let direction = criterion.mapped().map_or(settings.direction, Direction::mapping);
        Self {
            map: ConformalMap::unmapped(sides.source, sides.target),
            settings: MapSettings { direction, ..settings },
            asked: settings,
            criterion,
            start,
            stage: Stage::Begin,
            family: None,
            staying: None,
            found: None,
            evaluations: 0,
            course: Vec::new(),
            least: f64::INFINITY,
        }
    }

    /// The criterion.
    pub fn criterion(&self) -> &Criterion {
        &self.criterion
    }

    /// The constraints at which the search began.
    pub fn start(&self) -> &Constraints {
        &self.start
    }

    /// The settings at which the search began.
    pub fn start_settings(&self) -> MapSettings {
        self.asked
    }

    /// Constraints on the way from the start (t = 0) to the result (t = 1): points and boundary points move along the
    /// shortest ways in the disks. `None` before there is a result, and where a disk is folded.
    pub fn way(&self, t: f64) -> Option<Constraints> {
        let ((family, _), found) = self.family.as_ref().zip(self.found.as_ref())?;
        family.between(&self.start, &found.constraints, t)
    }

    /// How often the criterion was computed.
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// The least value so far, each time that it fell: the number of evaluations and the value. In closed form until the
    /// maps themselves are measured, where it may rise by the error of the closed form.
    pub fn course(&self) -> &[(usize, f64)] {
        &self.course
    }

    /// The result, once [`Self::advance`] is complete; before, the best that was measured on the map.
    pub fn found(&self) -> Option<&Found> {
        self.found.as_ref()
    }

    /// About which share of the work is done, from 0 to 1.
    pub fn progress(&self) -> f64 {
        let of = |begin: f64, end: f64, share: f64| begin + (end - begin) * share.clamp(0.0, 1.0);
        match &self.stage {
            Stage::Begin => 0.0,
            Stage::Chart(_) => 0.02,
            Stage::Scan(scan) => {
                let tried = scan.tried.len() as f64;
                of(0.05, 0.4, tried / (tried + scan.coming.len() as f64))
            }
            Stage::Descend(descent) => of(0.4, 0.6, 1.0 - (descent.coming.len() as f64 + 0.5) / DESCENTS as f64),
            Stage::Fit(descent) => of(0.6, 0.7, descent.count as f64 / MOST_DESCENT as f64),
            Stage::Polish(descent) => of(0.7, 0.98, descent.count as f64 / MOST_POLISH as f64),
            Stage::Keep(_) => 0.99,
            Stage::Done => 1.0,
        }
    }

    /// Continues until the search is complete (true) or the deadline has passed; does at least a part of one step.
    ///
    /// Errors: the map of the start, or of the sides' default points, cannot be computed; nothing lies in the region.
    pub fn advance(&mut self, deadline: Deadline) -> Result<bool, OptimizeError> {
        loop {
            if matches!(self.stage, Stage::Done) {
                return Ok(true);
            }
            self.step(deadline)?;
            if deadline.is_over() {
                return Ok(matches!(self.stage, Stage::Done));
            }
        }
    }

    /// One value, or a part of one that takes long.
    fn step(&mut self, deadline: Deadline) -> Result<(), OptimizeError> {
        self.stage = match std::mem::replace(&mut self.stage, Stage::Done) {
            Stage::Begin => self.begin(deadline)?,
            Stage::Chart(source) => self.chart(source)?,
            Stage::Scan(scan) => self.scan(scan),
            Stage::Descend(descent) => self.descend(descent),
            Stage::Fit(descent) => self.fit(descent),
            Stage::Polish(descent) => self.polish(descent, deadline),
            Stage::Keep(coming) => self.keep(coming, deadline),
            Stage::Done => Stage::Done,
        };
        Ok(())
    }

    /// Measures the start.
    fn begin(&mut self, deadline: Deadline) -> Result<Stage, OptimizeError> {
        if !self.map.advance(&self.start, self.settings, deadline)? {
            return Ok(Stage::Begin);
        }
        let value = self.criterion.measure(&self.map).ok_or(OptimizeError::EmptyRegion)?;
        let objective = self.criterion.objective(value, &self.map);
        self.found = Some(Found { constraints: self.start, before: value, after: value, objective });
        self.note(objective);
        Ok(Stage::Chart(None))
    }

    fn chart(&mut self, source: Option<Chart>) -> Result<Stage, MapError> {
        let Some(source) = source else {
            return Ok(Stage::Chart(Some(Chart::new(Side::Source, self.map.side(Side::Source))?)));
        };
        let target = Chart::new(Side::Target, self.map.side(Side::Target))?;
        let family = Family::new(PerSide::new(source, target), self.criterion.clone(), self.map.mapped_side());
        let scan = Scan { coming: candidates(&family, &self.start), tried: Vec::new() };
        let nodes = family.nodes(if self.criterion.symmetries().is_some() { FEW_MOVED } else { FEW });
        self.least = f64::INFINITY;
        self.family = Some((family, nodes));
        Ok(Stage::Scan(scan))
    }

    fn scan(&mut self, mut scan: Scan) -> Stage {
        if let Some(map) = scan.coming.pop_front() {
            let value = self.closed_form(&map);
            self.note(value);
            scan.tried.push((value, map));
            return Stage::Scan(scan);
        }
        let mut coming = apart(scan.tried);
        coming
            .pop_front()
            .map_or(Stage::Keep(VecDeque::new()), |best| Stage::Descend(Descent::new(best, STEP, SMALL, coming)))
    }

    fn descend(&mut self, mut descent: Descent) -> Stage {
        if let Some(map) = descent.question(MOST_DESCENT) {
            let value = self.closed_form(&map);
            self.note(value);
            descent.answer(value);
            return Stage::Descend(descent);
        }
        if let Some(next) = descent.coming.pop_front() {
            let Descent { best, coming, .. } = descent;
            return Stage::Descend(Descent { best, ..Descent::new(next, STEP, SMALL, coming) });
        }
        let best = descent.best.1;
        let many = if self.criterion.symmetries().is_some() { MANY_MOVED } else { MANY };
        let Some((family, nodes)) = &mut self.family else { return Stage::Done };
        *nodes = family.nodes(many);
        let value = self.closed_form(&best);
        Stage::Fit(Descent::new((value, best), 0.25 * STEP, SMALL, VecDeque::new()))
    }

    fn fit(&mut self, mut descent: Descent) -> Stage {
        if let Some(map) = descent.question(MOST_DESCENT) {
            let value = self.closed_form(&map);
            self.note(value);
            descent.answer(value);
            return Stage::Fit(descent);
        }
        let best = descent.best.1;
        self.staying = self.family.as_ref().map(|(family, _)| family.staying(&self.start, &best));
        self.least = f64::INFINITY;
        Stage::Polish(Descent::new((f64::INFINITY, best), POLISH_STEP, POLISH_SMALL, VecDeque::new()))
    }

    fn polish(&mut self, mut descent: Descent, deadline: Deadline) -> Stage {
        let most = (MOST_POLISH * USUAL / self.map.mapped().vertex_count().max(1)).clamp(LEAST_POLISH, MOST_POLISH);
        if let Some(map) = descent.question(most) {
            let family = self.family.as_ref().zip(self.staying);
            let constraints = family.and_then(|((family, _), staying)| family.constraints(&map, &staying));
            let value = match constraints {
                Some(constraints) => self.measured(&constraints, deadline),
                None => Some(f64::INFINITY),
            };
            if let Some(value) = value {
                descent.answer(value);
            }
            return Stage::Polish(descent);
        }
        Stage::Keep(self.kept(&descent.best.1))
    }

    /// Constraints of as good a map with the boundary points of the start, if one of the sides is a disk; and the start.
    fn kept(&self, map: &Moebius) -> VecDeque<Constraints> {
        let mut kept = VecDeque::new();
        if let Some(((family, _), staying)) = self.family.as_ref().zip(self.staying) {
            let maps = family.turned(map, self.start.anchors);
            let constraints = maps.into_iter().filter_map(|map| family.constraints(&map, &staying));
            kept.extend(constraints.map(|found| found.with_anchor(Side::Target, self.start.anchors.target)));
        }
        kept.push_back(self.start);
        kept
    }

    /// Tries constraints with boundary points that stay.
    fn keep(&mut self, mut coming: VecDeque<Constraints>, deadline: Deadline) -> Stage {
        let Some(&constraints) = coming.front() else { return Stage::Done };
        let Some(known) = self.found.clone() else { return Stage::Done };
        let Some(value) = self.measured(&constraints, deadline) else { return Stage::Keep(coming) };
        coming.pop_front();
        let is_start = constraints == self.start;
        let most = if is_start { known.objective + ROUNDING } else { known.objective * (1.0 + NEGLIGIBLE) + ROUNDING };
        let after = self.criterion.measure(&self.map).unwrap_or(f64::INFINITY);
        if value <= most && (is_start || after < known.before) || is_start && known.after > after {
            self.found = Some(Found { constraints, after, objective: value, ..known });
        }
        Stage::Keep(coming)
    }

    fn closed_form(&mut self, map: &Moebius) -> f64 {
        self.evaluations += 1;
        self.family.as_mut().map_or(f64::INFINITY, |(family, nodes)| family.value(nodes, map))
    }

    /// What is minimized, of the map with these constraints; infinite where there is none; `None` if the deadline comes first.
    fn measured(&mut self, constraints: &Constraints, deadline: Deadline) -> Option<f64> {
        let value = match self.map.advance(constraints, self.settings, deadline) {
            Ok(false) => return None,
            Ok(true) => self.criterion.measure(&self.map).unwrap_or(f64::INFINITY),
            Err(_) => f64::INFINITY,
        };
        let objective = if value.is_finite() { self.criterion.objective(value, &self.map) } else { value };
        self.note(objective);
        self.evaluations += 1;
        if let Some(found) = self.found.as_mut().filter(|found| objective < found.objective) {
            (found.constraints, found.after, found.objective) = (*constraints, value, objective);
        }
        Some(objective)
    }

    fn note(&mut self, value: f64) {
        if value < self.least {
            self.least = value;
            self.course.push((self.evaluations, value));
        }
    }
}

/// The start's map, and those that take places of either side to the other's default point.
fn candidates(family: &Family, start: &Constraints) -> VecDeque<Moebius> {
    let mut maps: VecDeque<_> = family.moebius(start).into_iter().collect();
    for side in Side::BOTH {
        for place in family.spread(side, PLACES) {
            let mut pair = PerSide::new(Complex64::ZERO, Complex64::ZERO);
            pair[side] = place;
            let turns = (0..TURNS).map(|k| TAU * f64::from(k) / f64::from(TURNS));
            maps.extend(turns.filter_map(|turn| Family::through(pair, turn)));
        }
    }
    maps
}

/// The best maps that are apart from each other, and the first one, best first.
fn apart(tried: Vec<(f64, Moebius)>) -> VecDeque<(f64, Moebius)> {
    let start = tried.first().copied();
    let mut sorted = tried;
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut chosen: Vec<(f64, Moebius)> = Vec::new();
    for candidate in sorted.into_iter().filter(|candidate| candidate.0.is_finite()) {
        if chosen.len() >= DESCENTS {
            break;
        }
        if chosen.iter().all(|known| known.1.distance(&candidate.1) > APART) {
            chosen.push(candidate);
        }
    }
    let is_new = |start: &(f64, Moebius)| start.0.is_finite() && !chosen.contains(start);
    let start = start.filter(is_new);
    chosen.into_iter().chain(start).collect()
}

impl Descent {
    fn new(from: (f64, Moebius), step: f64, small: f64, coming: VecDeque<(f64, Moebius)>) -> Self {
        let simplex = Simplex::new((DVec3::ZERO, from.0), step, small);
        let half = Moebius::half_way(from.1.inverse().image(Complex64::ZERO));
        let middle = Moebius::to_middle(half).unwrap_or(Moebius::turn(0.0));
        Self { from: from.1, middle, simplex, count: 0, coming, best: from }
    }

    /// The map with the small one at a place of the simplex within.
    fn map(&self, place: DVec3) -> Option<Moebius> {
        let DVec3 { x: turn, y, z } = place;
        let length = y.hypot(z);
        let a = if length > 0.0 { Complex64::new(y, z) * ((0.5 * length).tanh() / length) } else { Complex64::ZERO };
        let within = self.middle.inverse().after(&Moebius::small(turn, a)?).after(&self.middle);
        Some(self.from.after(&within))
    }

    /// The map whose value is wanted next; `None`: the simplex is small, or `most` values were taken.
    fn question(&self, most: usize) -> Option<Moebius> {
        if self.count >= most {
            return None;
        }
        self.map(self.simplex.question()?)
    }

    fn answer(&mut self, value: f64) {
        self.count += 1;
        let map = self.simplex.question().and_then(|place| self.map(place));
        if let Some(map) = map.filter(|_| value < self.best.0) {
            self.best = (value, map);
        }
        self.simplex.answer(value);
    }
}
