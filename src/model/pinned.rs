//! Pins: boundary pairs that determine the map in place of the points, which follow from them.
//!
//! Before a map is requested, the points that the pins determine are placed in the session; everything else then reads
//! them there. Pins that determine no map are said, and the last good ones come back. On large surfaces the points are
//! searched over several frames; meanwhile the last good map stays, and pins that are moved on wait for the end of the
//! search, so that a drag is followed.

use crate::conformal::{
    ConformalMap, Constraints, InteriorPoint, PerSide, PinError, PinSearch, Pins, PreparedSide, Side,
};
use crate::drawing::carried_fraction;
use crate::language::{Message, key};
use crate::laplace::Deadline;
use crate::model::Model;
use crate::model::pins_seen::PinsSeen;
use crate::model::side::Next;
use crate::session::{Command, OutlineSpec, SidePoints, Touched};
use std::sync::{Arc, Weak};

/// What is known of the pins beside the session.
#[derive(Debug, Default)]
pub(super) struct Pinned {
    /// The pins of a session whose shapes are still being prepared.
    incoming: Option<Pins>,
    /// The pins of the last map that was computed without error.
    last_good: Option<Pins>,
    followed: Option<Followed>,
    /// The search for the points, of these pins or of former ones.
    search: Option<Search>,
    /// Whether the points are not yet those of the pins.
    is_behind: bool,
    /// Why the last ones determine no map.
    error: Option<(Side, Message)>,
    /// Whether that is a move of the pin in hand, which the end of the drag undoes.
    is_refused_in_hand: bool,
    /// Whether a dot is in hand.
    is_held: bool,
    pub(super) seen: PinsSeen,
}

/// The part of a frame's time for the map in which points of surfaces are searched: 8 ms. Between outlines a search takes
/// about as long as the map itself, so that a drag does not wait for a second frame.
const PART_OF_FRAME: f64 = 0.4;

/// A search on these sides.
#[derive(Debug)]
struct Search {
    search: PinSearch,
    sides: PerSide<Weak<PreparedSide>>,
}

/// What has become of the points in a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Following {
    /// They are those of the pins, or there are no pins.
    Done,
    /// They are those of pins that have been moved on meanwhile.
    MovedOn,
    /// They are searched.
    Searching,
}

/// Points that were computed from pins.
#[derive(Debug, Clone)]
struct Followed {
    pins: Pins,
    sides: PerSide<Weak<PreparedSide>>,
    points: PerSide<SidePoints>,
}

/// Whether the sides are the same ones.
fn are_same_sides(known: &PerSide<Weak<PreparedSide>>, sides: PerSide<&Arc<PreparedSide>>) -> bool {
    Side::BOTH.into_iter().all(|side| known[side].as_ptr() == Arc::as_ptr(sides[side]))
}

impl Pinned {
    /// The state of a session with these pins, whose shapes are still to be prepared.
    pub fn coming(pins: Option<Pins>) -> Self {
        Self { incoming: pins, ..Self::default() }
    }

    /// The state of a copy of a model with these prepared sides and points.
    #[must_use]
    pub fn twin(&self) -> Self {
        Self { followed: self.followed.clone(), last_good: self.last_good.clone(), ..Self::default() }
    }

    /// Sets the pins of a session whose shapes are still to be prepared; `None` also where other shapes come.
    pub fn expect(&mut self, pins: Option<Pins>) {
        *self = Self::coming(pins);
    }

    /// Follows an exchange of the sides.
    pub fn swap(&mut self) {
        let exchanged = |pins: &Option<Pins>| pins.as_ref().map(Pins::exchanged);
        *self = Self {
            incoming: exchanged(&self.incoming),
            last_good: exchanged(&self.last_good),
            followed: None,
            error: self.error.take(),
            ..Self::default()
        };
    }

    /// Whether the points are not yet those of the pins.
    pub fn is_behind(&self) -> bool {
        self.is_behind
    }

    /// The pins of a session whose shapes are still being prepared.
    pub fn incoming(&self) -> Option<&Pins> {
        self.incoming.as_ref()
    }

    /// The side beside which the error is shown, and the error.
    pub fn error(&self) -> Option<&(Side, Message)> {
        self.error.as_ref()
    }

    /// Closes the message beside a side.
    pub fn dismiss(&mut self, side: Side) {
        self.error = self.error.take().filter(|(at, _)| *at != side);
    }

    /// The pins of the last map that was computed without error.
    pub fn last_good(&self) -> Option<&Pins> {
        self.last_good.as_ref()
    }

    /// Records the pins of a map that was computed without error.
    fn note_good(&mut self, pins: Option<Pins>) {
        if self.last_good != pins {
            self.last_good = pins;
        }
    }

    /// Ends a search: the last good pins are back.
    pub fn give_up(&mut self) {
        (self.search, self.is_behind) = (None, false);
    }

    /// Notes whether a dot is in hand; when it is let go, the message that it cannot go where it was dragged ends.
    pub fn hold(&mut self, is_held: bool) {
        if !is_held && std::mem::take(&mut self.is_refused_in_hand) {
            self.error = None;
        }
        self.is_held = is_held;
    }

    fn refuse(&mut self, error: &PinError, beside: Side) {
        self.is_refused_in_hand = false;
        self.error = Some((error.side().unwrap_or(beside), Message::from(error)));
    }
}

impl Model {
    /// The boundary pairs that determine the map; `None`: the points do.
    pub fn pins(&self) -> Option<&Pins> {
        self.session.pins()
    }

    /// Three boundary pairs of the present map, or why there are none; `None` while it is computed.
    pub fn first_pins(&self) -> Option<Result<Pins, PinError>> {
        self.full_map().map(Pins::of)
    }

    /// The pins and one more: a boundary point of a side, as a fraction of the length, and its present image. `None`
    /// without pins or map, or where there is one already.
    pub fn pins_with(&self, side: Side, fraction: f64) -> Option<Pins> {
        let image = self.full_map()?.boundary_image(side, fraction);
        let mut pair = PerSide::new(image, image);
        pair[side] = fraction;
        self.pins()?.and(pair).ok()
    }

    /// The pins and one in the middle of the source's longest arc between them, with its present image. `None` without pins
    /// or map, or where their images cannot be told apart.
    pub fn pins_with_one_more(&self) -> Option<Pins> {
        let mut places: Vec<f64> = self.pins()?.pairs().iter().map(|pair| pair.source).collect();
        places.sort_by(f64::total_cmp);
        let next = places.iter().cycle().skip(1);
        let arcs = places.iter().zip(next).map(|(a, b)| (*a, (b - a).rem_euclid(1.0)));
        let (start, length) = arcs.max_by(|a, b| a.1.total_cmp(&b.1))?;
        self.pins_with(Side::Source, start + 0.5 * length)
    }

    /// The map of the session's sides that is shown, not the coarse one; `None` while it is computed.
    pub(super) fn full_map(&self) -> Option<&ConformalMap> {
        self.fine.map().or(self.shown.map.as_ref()).filter(|_| !self.is_pending())
    }

    /// Notes whether a dot is dragged.
    pub fn hold_dot(&mut self, is_held: bool) {
        self.pinned.hold(is_held);
    }

    /// Lets pins determine the map, or the points again.
    pub(super) fn set_pins(&mut self, pins: Option<Pins>) {
        self.pinned.error = None;
        self.session.apply(Command::SetPins(pins));
        self.changed.points = true;
    }

    /// Moves a pin; out of order it stays, and the reason is said.
    pub(super) fn move_pin(&mut self, pin: usize, side: Side, fraction: f64) -> Touched {
        let pins = self.session.pins().filter(|pins| pin < pins.pairs().len());
        match pins.map(|pins| pins.moved(pin, side, fraction)) {
            Some(Ok(pins)) => {
                self.set_pins(Some(pins));
                Touched::POINTS
            }
            Some(Err(error)) => {
                self.pinned.refuse(&error, side);
                self.pinned.is_refused_in_hand = self.pinned.is_held;
                Touched::NOTHING
            }
            None => Touched::NOTHING,
        }
    }

    /// Carries a side's pins along to a reshaped outline. One that was turned over has none: they would run the other way
    /// around, which is said.
    pub(super) fn carry_pins(&mut self, side: Side, outline: &OutlineSpec, is_turned: bool) {
        let Some(pins) = self.session.pins() else { return };
        if is_turned {
            self.session.apply(Command::SetPins(None));
            self.pinned.error = Some((side, key::pins_turned().into()));
            return;
        }
        let (old, new) = (self.session.domain(side).outline.polygon(), outline.polygon());
        let moved = pins.pairs().iter().map(|&(mut pair)| {
            pair[side] = carried_fraction(old.vertices(), new.vertices(), pair[side]);
            pair
        });
        let carried = Pins::new(moved).inspect_err(|error| self.pinned.error = Some((side, error.into())));
        self.session.apply(Command::SetPins(carried.ok()));
    }

    /// Takes the pins of an opened session as soon as its shapes are there; returns whether they came now.
    pub(super) fn take_pins(&mut self) -> bool {
        let is_coming = |side: Side| {
            let side = &self.sides[side];
            side.incoming_points.is_some() || !matches!(side.next, Next::Same) || side.surface.preparation.is_busy()
        };
        if self.pinned.incoming.is_none() || Side::BOTH.into_iter().any(is_coming) {
            return false;
        }
        let pins = self.pinned.incoming.take();
        self.session.apply(Command::SetPins(pins));
        true
    }

    /// Places the points that follow from the pins, or searches them for a part of a frame. Pins that determine no map are
    /// replaced by those of the present points, or dropped if there are none.
    pub(super) fn follow_pins(&mut self) -> Following {
        let following = self.search_points();
        self.pinned.is_behind = following != Following::Done;
        following
    }

    fn search_points(&mut self) -> Following {
        let sides = PerSide::from_fn(|side| self.prepared(side).cloned()).both();
        let search = self.pinned.search.take();
        let (Some(pins), Some(sides)) = (self.session.pins().cloned(), sides) else { return Following::Done };
        if self.followed(&sides).is_some_and(|known| known.pins == pins) {
            return Following::Done;
        }
        let mut search = match search.filter(|search| are_same_sides(&search.sides, sides.as_ref())) {
            Some(search) => search,
            None => self.new_search(pins.clone(), &sides),
        };
        let part = if self.abilities().compares_outlines() { 1.0 } else { PART_OF_FRAME };
        let deadline = Deadline::in_ms(part * self.update_ms);
        let Some(found) = search.search.advance(sides.as_ref().map(Arc::as_ref), deadline) else {
            self.pinned.search = Some(search);
            return Following::Searching;
        };
        let is_latest = *search.search.pins() == pins;
        match found {
            Ok(constraints) => {
                self.place_points(&constraints, search.search.pins().clone(), &sides);
                if is_latest { Following::Done } else { Following::MovedOn }
            }
            Err(_) if !is_latest => Following::Searching,
            Err(error) => {
                let present = self.followed(&sides).map(|known| known.pins.clone());
                self.pinned.refuse(&error, Side::Target);
                self.session.apply(Command::SetPins(present));
                Following::Done
            }
        }
    }

    /// Records the pins of the map that has just been computed without error: while the session's are searched for, those
    /// that its points follow from.
    pub(super) fn note_good_pins(&mut self) {
        let pins = if self.pinned.is_behind {
            let sides = PerSide::from_fn(|side| self.prepared(side).cloned()).both();
            sides.and_then(|sides| Some(self.followed(&sides)?.pins.clone()))
        } else {
            self.session.pins().cloned()
        };
        self.pinned.note_good(pins);
    }

    /// The pins that the present points follow from.
    fn followed(&self, sides: &PerSide<Arc<PreparedSide>>) -> Option<&Followed> {
        let present = PerSide::from_fn(|side| self.session.side(side).points());
        let followed = self.pinned.followed.as_ref().filter(|known| known.points == present);
        followed.filter(|known| are_same_sides(&known.sides, sides.as_ref()))
    }

    fn new_search(&self, pins: Pins, sides: &PerSide<Arc<PreparedSide>>) -> Search {
        let near = PerSide::from_fn(|side| self.point(side)).both();
        let near = near.unwrap_or_else(|| sides.as_ref().map(|side| side.default_point()));
        Search { search: PinSearch::new(pins, near), sides: sides.as_ref().map(Arc::downgrade) }
    }

    fn place_points(&mut self, constraints: &Constraints, pins: Pins, sides: &PerSide<Arc<PreparedSide>>) {
        for side in Side::BOTH {
            let points = side_points(constraints.points[side], constraints.anchors[side]);
            self.session.apply(Command::PlacePoints { side, points });
        }
        let points = PerSide::from_fn(|side| self.session.side(side).points()); // anchors modulo 1
        self.pinned.error = None;
        self.pinned.followed = Some(Followed { pins, sides: sides.as_ref().map(Arc::downgrade), points });
    }
}

/// The points of a side with these constraints.
pub(super) fn side_points(point: InteriorPoint, anchor: f64) -> SidePoints {
    match point {
        InteriorPoint::Plane(x) => SidePoints::Outline { interior: Some(x), anchor },
        InteriorPoint::Surface(point) => SidePoints::Surface { interior: Some(point), anchor },
    }
}
