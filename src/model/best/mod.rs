//! The best map of the family: the criterion, the search in slices of frames, and the points' way to its result.
//!
//! A search belongs to the sides, constraints and direction at which it began; if one of them changes, it ends without a
//! result. Its result is one change of the session: the points move there along the disk's shortest ways (`flight`).
//! The region, painted with a brush, is part of the session; the criterion that is chosen is not.

mod criterion;
mod flight;
mod mask;
mod relief;
mod sides;

use crate::conformal::{Constraints, PerSide, PreparedSide, Side};
use crate::geometry::DVec3;
use crate::language::{Message, key};
use crate::laplace::Deadline;
use crate::model::Model;
use crate::optimization::{Criterion, Dab, MOST_DABS, Optimization};
pub use crate::optimization::{Least, Marks};
use crate::session::{Command, Touched};
use criterion::KnownSymmetries;
use flight::{Flight, is_same_place};
use mask::Mask;
pub use mask::Part;
use relief::Relief;
pub use relief::{Landscapes, Level};
use sides::{KnownShapes, KnownSides};
use std::sync::Arc;

/// The time of a frame for a search or a landscape, in ms: half of a frame at 60 Hz.
const SLICE_MS: f64 = 8.0;

/// The brush's radii, as shares of the source's size, and the first one.
pub const BRUSHES: std::ops::RangeInclusive<f64> = 0.02..=0.25;
const BRUSH: f64 = 0.08;

/// Dabs of a stroke are this far apart, in radii.
const APART: f64 = 0.4;

/// The criterion that is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Aim {
    /// Area distortion.
    #[default]
    Area,
    /// The ratio of scales.
    Scale,
    /// Area distortion in the painted region.
    Region,
    /// Kept symmetries of two outlines.
    Symmetry,
}

/// A user's request.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BestAction {
    /// Choose the criterion.
    Aim(Aim),
    /// Begin the search.
    Start,
    /// End the search without a result.
    Cancel,
    /// Take up or put down the brush.
    Paint(bool),
    /// Set the brush's radius, a share of the source's size.
    Brush(f64),
    /// Show or hide the landscape.
    Landscape(bool),
}

impl BestAction {
    /// The parts of the session that it changes in the end.
    pub fn leads_to(self) -> Touched {
        if self == Self::Start { Touched::POINTS } else { Touched::NOTHING }
    }
}

/// The result of the last search.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// The criterion.
    pub aim: Aim,
    /// Its value before and after.
    pub before: f64,
    /// As [`Self::before`].
    pub after: f64,
    /// How often it was computed.
    pub evaluations: usize,
    /// As [`Optimization::course`].
    pub course: Vec<Least>,
}

/// A search under way.
#[derive(Debug)]
struct Search {
    aim: Aim,
    optimization: Optimization,
}

/// The state of this part of the model.
#[derive(Debug)]
pub struct BestMap {
    aim: Aim,
    /// The sides of the last search.
    sides: Option<KnownSides>,
    /// The shapes of its sides; its result is theirs, also where sides are prepared anew for the points that were found.
    shapes: Option<KnownShapes>,
    search: Option<Search>,
    /// The result of the last search, and its constraints.
    outcome: Option<(Outcome, Constraints)>,
    error: Option<Message>,
    flight: Option<Flight>,
    is_painting: bool,
    brush: f64,
    relief: Relief,
    mask: Mask,
    symmetries: KnownSymmetries,
}

impl Default for BestMap {
    fn default() -> Self {
        Self {
            aim: Aim::default(),
            sides: None,
            shapes: None,
            search: None,
            outcome: None,
            error: None,
            flight: None,
            is_painting: false,
            brush: BRUSH,
            relief: Relief::default(),
            mask: Mask::default(),
            symmetries: KnownSymmetries::default(),
        }
    }
}

impl BestMap {
    /// The criterion that is chosen.
    pub fn aim(&self) -> Aim {
        self.aim
    }

    /// The share of the search under way that is done, and its course.
    pub fn progress(&self) -> Option<(f64, &[Least])> {
        self.search.as_ref().map(|search| (search.optimization.progress(), search.optimization.course()))
    }

    /// The result of the last search for this criterion.
    pub fn outcome(&self) -> Option<&Outcome> {
        self.outcome.as_ref().map(|(outcome, _)| outcome).filter(|outcome| outcome.aim == self.aim)
    }

    /// Why there is no result.
    pub fn error(&self) -> Option<&Message> {
        self.error.as_ref()
    }

    /// Whether a drag over the source paints the region.
    pub fn is_painting(&self) -> bool {
        self.is_painting && self.aim == Aim::Region
    }

    /// The brush's radius, a share of the source's size.
    pub fn brush(&self) -> f64 {
        self.brush
    }

    /// Whether the points are on their way to the result.
    pub fn is_moving(&self) -> bool {
        self.flight.is_some()
    }

    /// The parts of the source's triangles that lie in the region; empty without one, and if the source has another number
    /// of triangles.
    pub fn painted(&self, triangles: usize) -> &[Part] {
        self.mask.parts(triangles)
    }

    /// Whether the landscape is asked for.
    pub fn asks_for_landscape(&self) -> bool {
        self.relief.is_asked
    }

    /// Why there is no landscape.
    pub fn landscape_error(&self) -> Option<Message> {
        self.relief.error.as_ref().map(Message::from)
    }

    /// The landscape, once it is complete.
    pub fn landscape(&self) -> Option<&Landscapes> {
        self.relief.shown()
    }
}

impl Model {
    /// The state of the best map.
    pub fn best(&self) -> &BestMap {
        &self.best
    }

    /// Applies a request.
    pub fn act_on_best(&mut self, action: BestAction) {
        let best = &mut self.best;
        match action {
            BestAction::Aim(aim) => {
                (best.aim, best.search, best.error) = (aim, None, None);
            }
            BestAction::Start => self.start_search(),
            BestAction::Cancel => best.search = None,
            BestAction::Paint(paints) => best.is_painting = paints,
            BestAction::Brush(radius) => best.brush = radius.clamp(*BRUSHES.start(), *BRUSHES.end()),
            BestAction::Landscape(shown) => best.relief.is_asked = shown,
        }
    }

    /// Whether a search can begin: the map is there and nothing is being prepared.
    pub fn can_search(&self) -> bool {
        let is_given = match self.best.aim {
            Aim::Area | Aim::Scale => true,
            Aim::Region => !self.session.region().is_empty(),
            Aim::Symmetry => self.abilities().compares_outlines(),
        };
        is_given && self.is_sharp()
    }

    fn start_search(&mut self) {
        if !self.can_search() {
            return;
        }
        let (Some(sides), Some(start)) = (self.both_sides(), self.constraints()) else { return };
        let known = KnownSides::new(&sides);
        let settings = self.session.direction().into();
        let criterion = self.criterion();
        let best = &mut self.best;
        (best.outcome, best.error, best.is_painting) = (None, None, false);
        let criterion = match criterion {
            Ok(criterion) => criterion,
            Err(error) => return best.error = Some(Message::from(&error)),
        };
        let optimization = Optimization::new(sides, criterion, start, settings);
        best.search = Some(Search { aim: best.aim, optimization });
        (best.sides, best.shapes) = (Some(known), Some(KnownShapes::new(&self.session)));
    }

    fn both_sides(&self) -> Option<PerSide<Arc<PreparedSide>>> {
        PerSide::from_fn(|side| self.prepared(side).cloned()).both()
    }

    /// Spends a slice of a frame on the search and on the landscape; returns the commands that move the points, with
    /// `calm` at once, and whether another frame is needed.
    pub fn advance_best(&mut self, now: f64, is_calm: bool) -> (Vec<Command>, bool) {
        self.follow_region();
        self.advance_search(is_calm);
        let is_relief_pending = self.advance_relief();
        self.drop_disturbed();
        let Some(flight) = &mut self.best.flight else {
            return (Vec::new(), self.best.search.is_some() || is_relief_pending);
        };
        let place = flight.place(now);
        let has_landed = flight.has_landed(now);
        let mut commands: Vec<Command> = self.session.pins().map(|_| Command::SetPins(None)).into_iter().collect();
        let points = |side| crate::model::pinned::side_points(place.points[side], place.anchors[side]);
        commands.extend(Side::BOTH.map(|side| Command::PlacePoints { side, points: points(side) }));
        if has_landed {
            self.best.flight = None;
        }
        (commands, true)
    }

    /// Ends the motion of the points to a result, where they are; returns whether there was one.
    pub fn end_flight(&mut self) -> bool {
        self.best.flight.take().is_some()
    }

    /// Ends the motion of the points if the user moves them, undoes a step or changes a side meanwhile, and drops the result
    /// of another map.
    fn drop_disturbed(&mut self) {
        let has_its_shapes = self.best.shapes.as_ref().is_some_and(|shapes| shapes.are_of(&self.session));
        let (Some(at), true) = (self.constraints(), has_its_shapes) else {
            (self.best.flight, self.best.outcome) = (None, None);
            return;
        };
        if self.best.flight.as_ref().is_some_and(|flight| !flight.is_undisturbed(&at)) {
            self.best.flight = None;
        }
        if self.best.flight.is_none() {
            self.best.outcome = self.best.outcome.take().filter(|(_, found)| is_same_place(found, &at));
        }
    }

    fn has_sides_of_search(&self) -> bool {
        let now = self.both_sides().as_ref().map(KnownSides::new);
        now.is_some() && self.best.sides == now
    }

    fn advance_search(&mut self, is_calm: bool) {
        let Some(mut search) = self.best.search.take() else { return };
        if !self.is_of(&search) {
            self.best.error = Some(key::best_map_interrupted().into());
            return;
        }
        match search.optimization.advance(Deadline::in_ms(SLICE_MS)) {
            Ok(false) => self.best.search = Some(search),
            Ok(true) => {
                let Some(found) = search.optimization.found() else { return };
                let outcome = Outcome {
                    aim: search.aim,
                    before: found.before,
                    after: found.after,
                    evaluations: search.optimization.evaluations(),
                    course: search.optimization.course().to_vec(),
                };
                self.best.outcome = Some((outcome, found.constraints));
                self.best.flight = Flight::new(&search.optimization, is_calm);
            }
            Err(error) => self.best.error = Some(Message::from(&error)),
        }
    }

    /// Whether nothing has changed since a search began.
    fn is_of(&self, search: &Search) -> bool {
        let has_its_region = match search.optimization.criterion() {
            Criterion::Region(region) => region.dabs() == self.session.region(),
            _ => true,
        };
        has_its_region
            && self.has_sides_of_search()
            && self.constraints().as_ref() == Some(search.optimization.start())
            && search.optimization.start_settings().direction == self.session.direction()
    }

    /// The source's region with dabs at these places, `None` if they would change nothing; the plane lies at z = 0.
    pub fn region_with(&self, middles: impl IntoIterator<Item = DVec3>) -> Option<Vec<Dab>> {
        let radius = self.brush_radius()?;
        let mut region = self.session.region().to_vec();
        for middle in middles {
            let new = Dab { middle, radius }.rounded(); // as those that it is compared with
            let is_near = |dab: &Dab| dab.middle.distance(new.middle) < APART * new.radius && dab.radius >= new.radius;
            if region.len() < MOST_DABS && !region.iter().any(is_near) {
                region.push(new);
            }
        }
        (region.len() > self.session.region().len()).then_some(region)
    }

    /// x₁, where a dab can be painted without a pointer; the plane lies at z = 0.
    pub fn source_point_in_space(&self) -> Option<DVec3> {
        match self.session.surface(Side::Source) {
            Some(_) => self.surface_point(Side::Source),
            None => self.interior(Side::Source).map(|x| x.extend(0.0)),
        }
    }

    /// The brush's radius in the source's units.
    pub fn brush_radius(&self) -> Option<f64> {
        Some(self.best.brush * self.width_of_source()?)
    }

    /// The largest side of the box around the source.
    fn width_of_source(&self) -> Option<f64> {
        let prepared = self.prepared(Side::Source)?;
        let places = (0..prepared.boundary_count())
            .map(|k| prepared.boundary_place(crate::outline::BoundaryPoint::new(k as u32, 0.0)));
        let ends = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (low, high) = places.fold(ends, |(low, high), p| (low.min(p), high.max(p)));
        Some((high - low).max_element())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
