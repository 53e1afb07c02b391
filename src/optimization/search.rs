//! The search for the best map of a family, in steps.
//!
//! 1. **Scan**: maps that take points spread over one side's area to the other side's default point, under turns, in closed
//!    form on a few hundred triangles. 2. **Descent** from the best of them and from the start (`descent`). 3. **Fit**: the
//!    same from the best ends that are apart, on many triangles. 4. **Comparison** of the maps at the ends of the fits, whose
//!    criterion is measured as it is for the start. 5. **Polish** of the best: a descent on the map itself. Last, whether the
//!    boundary points may stay as they were.
//!
//! Guaranteed: the result is never worse than the start, both measured on the map, and as sound (`soundness`) where a surface
//! is mapped; the same input gives the same result, bit for bit, however it is divided into steps. Not guaranteed: that no
//! better map exists where the scan has no place near it.

use super::chart::Chart;
use super::criterion::Value;
use super::descent::{Descent, Descents, MOST_DESCENT};
use super::family::{Family, Nodes, Staying};
use super::soundness::Soundness;
use super::{Criterion, OptimizeError};
use crate::conformal::{
    ConformalMap, Constraints, Direction, MapError, MapSettings, Moebius, PerSide, PreparedSide, Side,
};
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

/// Fits, from ends of descents that differ as much: on a cow's head the end that is best on few triangles is the worse valley.
const FITS: usize = 3;

/// First size of the simplex in descents and in fits.
const STEP: f64 = 0.3;
const FIT_STEP: f64 = 0.25 * STEP;
/// First and last size for the map itself: near enough for four digits of the minimum, whose value changes with the square.
const POLISH_STEP: f64 = 0.08;
const POLISH_SMALL: f64 = 2e-3;

/// The most values on the map itself of a mesh with [`USUAL`] vertices; on a larger one fewer, but [`LEAST_POLISH`].
const MOST_POLISH: usize = 150;
const LEAST_POLISH: usize = 80;
const USUAL: usize = 8000;

/// Boundary points that need not move stay, if that costs no more than this share of the criterion: on a mesh of a face it
/// costs 1.2e-4 and the map would be worse than by the best Möbius transformation, on a cow's head 2e-6.
const NEGLIGIBLE: f64 = 1e-4;
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
    Descend(Descents),
    Fit(Descents),
    Compare(Comparison),
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

/// Ends of descents that are still to be measured as maps, and the best one that was.
#[derive(Debug)]
struct Comparison {
    coming: VecDeque<Moebius>,
    best: (f64, Moebius),
}

/// A map of a search that is better than those before it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Least {
    /// How often the criterion was computed before.
    pub evaluations: usize,
    /// The criterion.
    pub value: f64,
    /// Whether it is that of the map itself, or else in closed form.
    pub is_measured: bool,
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
    /// The limits of what a surface's map may be; none where an outline is mapped.
    soundness: Option<Soundness>,
    evaluations: usize,
    course: Vec<Least>,
    /// What is minimized, of the best map since closed form or measurement began.
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
            soundness: None,
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

    /// The criterion of the best map so far, each time that a better one was found: of the start's map, then in closed form,
    /// then of the maps themselves, where it may rise by the error of the closed form. Among maps that keep symmetries almost
    /// equally well, one with more even areas is better though its mismatch is a little larger.
    pub fn course(&self) -> &[Least] {
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
            Stage::Descend(descents) => of(0.4, 0.55, descents.share()),
            Stage::Fit(descents) => of(0.55, 0.69, descents.share()),
            Stage::Compare(_) => 0.7,
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
            Stage::Descend(descents) => self.descend(descents),
            Stage::Fit(descents) => self.fit(descents),
            Stage::Compare(comparison) => self.compare(comparison, deadline),
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
        self.soundness = self.map.mapped().is_surface().then(|| Soundness::of(&self.map.quality()));
        self.note(Value { criterion: value, objective }, true);
        Ok(Stage::Chart(None))
    }

    fn chart(&mut self, source: Option<Chart>) -> Result<Stage, MapError> {
        let Some(source) = source else {
            return Ok(Stage::Chart(Some(Chart::new(Side::Source, self.map.side(Side::Source))?)));
        };
        let target = Chart::new(Side::Target, self.map.side(Side::Target))?;
        let family = Family::new(PerSide::new(source, target), self.criterion.clone(), self.map.mapped_side());
        let scan = Scan { coming: candidates(&family, &self.start), tried: Vec::new() };
        let nodes = if self.criterion.symmetries().is_some() { FEW_MOVED } else { FEW };
        let nodes = family.limited_nodes(nodes, &self.start);
        self.least = f64::INFINITY;
        self.family = Some((family, nodes));
        Ok(Stage::Scan(scan))
    }

    fn scan(&mut self, mut scan: Scan) -> Stage {
        if let Some(map) = scan.coming.pop_front() {
            let value = self.closed_form(&map);
            scan.tried.push((value, map));
            return Stage::Scan(scan);
        }
        let start = scan.tried.first().copied();
        Descents::new(apart(scan.tried, DESCENTS, start), STEP).map_or(Stage::Keep(VecDeque::new()), Stage::Descend)
    }

    fn descend(&mut self, mut descents: Descents) -> Stage {
        if self.advance_descents(&mut descents, STEP) {
            return Stage::Descend(descents);
        }
        let many = if self.criterion.symmetries().is_some() { MANY_MOVED } else { MANY };
        let Some((family, nodes)) = &mut self.family else { return Stage::Done };
        *nodes = family.limited_nodes(many, &self.start);
        // among more triangles the values are others
        let best = apart(descents.ended, FITS, None).into_iter().map(|(_, map)| (f64::INFINITY, map));
        Descents::new(best.collect(), FIT_STEP).map_or(Stage::Keep(VecDeque::new()), Stage::Fit)
    }

    fn fit(&mut self, mut descents: Descents) -> Stage {
        if self.advance_descents(&mut descents, FIT_STEP) {
            return Stage::Fit(descents);
        }
        self.least = f64::INFINITY;
        let ends = apart(descents.ended, FITS, None);
        let Some(&best) = ends.front() else { return Stage::Keep(VecDeque::new()) };
        // where no end is a sound map, the start's valley is searched
        let family = self.family.as_ref().filter(|_| self.soundness.is_some());
        let start = family.and_then(|(family, _)| family.moebius(&self.start));
        Stage::Compare(Comparison {
            coming: ends.into_iter().map(|(_, map)| map).chain(start).collect(),
            best: (f64::INFINITY, best.1),
        })
    }

    /// Takes one value of a descent, or goes to the next one; false after the last.
    fn advance_descents(&mut self, descents: &mut Descents, step: f64) -> bool {
        if let Some(map) = descents.now.question(MOST_DESCENT) {
            let value = self.closed_form(&map);
            descents.now.answer(value);
            return true;
        }
        descents.next(step)
    }

    /// Measures the map of one end.
    fn compare(&mut self, mut ends: Comparison, deadline: Deadline) -> Stage {
        let Some(&map) = ends.coming.front() else {
            self.staying = self.family.as_ref().map(|(family, _)| family.staying(&self.start, &ends.best.1));
            return Stage::Polish(Descent::new((f64::INFINITY, ends.best.1), POLISH_STEP, POLISH_SMALL));
        };
        let family = self.family.as_ref().map(|(family, _)| family);
        let at = family.and_then(|family| family.constraints(&map, &family.staying(&self.start, &map)));
        let Some(value) = at.map_or(Some(f64::INFINITY), |at| self.measured(&at, deadline)) else {
            return Stage::Compare(ends);
        };
        ends.coming.pop_front();
        if value < ends.best.0 {
            ends.best = (value, map);
        }
        Stage::Compare(ends)
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
        if !self.is_sound() {
            return Stage::Keep(coming);
        }
        if value <= most && (is_start || after < known.before) || is_start && known.after > after {
            self.found = Some(Found { constraints, after, objective: value, ..known });
        }
        Stage::Keep(coming)
    }

    /// What is minimized, in closed form; infinite where there is no map.
    fn closed_form(&mut self, map: &Moebius) -> f64 {
        let value = self.family.as_mut().map_or(Value::NONE, |(family, nodes)| family.value(nodes, map));
        self.evaluations += 1;
        self.note(value, false);
        value.objective
    }

    /// What is minimized, of the map with these constraints; infinite where there is none; `None` if the deadline comes first.
    fn measured(&mut self, constraints: &Constraints, deadline: Deadline) -> Option<f64> {
        let value = match self.map.advance(constraints, self.settings, deadline) {
            Ok(false) => return None,
            Ok(true) => self.criterion.measure(&self.map).unwrap_or(f64::INFINITY),
            Err(_) => f64::INFINITY,
        };
        self.evaluations += 1;
        if !value.is_finite() {
            return Some(value);
        }
        let objective = self.criterion.objective(value, &self.map);
        let penalty = self.soundness.map_or(0.0, |limits| limits.penalty(&self.map.quality(), objective));
        if penalty > 0.0 {
            return Some(objective + penalty);
        }
        self.note(Value { criterion: value, objective }, true);
        if let Some(found) = self.found.as_mut().filter(|found| objective < found.objective) {
            (found.constraints, found.after, found.objective) = (*constraints, value, objective);
        }
        Some(objective)
    }

    /// Whether the map that was measured last is within the limits of the start.
    fn is_sound(&self) -> bool {
        self.soundness.is_none_or(|limits| limits.holds(&self.map.quality()))
    }

    fn note(&mut self, value: Value, is_measured: bool) {
        if value.objective < self.least {
            self.least = value.objective;
            self.course.push(Least { evaluations: self.evaluations, value: value.criterion, is_measured });
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

/// The best maps that are apart from each other, up to `most`, best first, and last `besides`, unless it is among them.
fn apart(tried: Vec<(f64, Moebius)>, most: usize, besides: Option<(f64, Moebius)>) -> VecDeque<(f64, Moebius)> {
    let mut sorted = tried;
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut chosen: VecDeque<(f64, Moebius)> = VecDeque::new();
    for candidate in sorted.into_iter().filter(|candidate| candidate.0.is_finite()) {
        if chosen.len() >= most {
            break;
        }
        if chosen.iter().all(|known| known.1.distance(&candidate.1) > APART) {
            chosen.push_back(candidate);
        }
    }
    let besides = besides.filter(|map| map.0.is_finite() && !chosen.contains(map));
    chosen.extend(besides);
    chosen
}
