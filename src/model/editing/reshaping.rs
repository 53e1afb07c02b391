//! An outline that is being reshaped: what is in hand, what was good last, where it crosses itself.
//!
//! No egui in here. Every change is a whole new outline for the model; what the boundary point and
//! the interior point were at the beginning of a drag they are again at its end, if the outline allows it.

use crate::conformal::Side;
use crate::drawing::{DrawingError, Shape, carried_fraction};
use crate::geometry::{Bounds, DVec2, PolygonError};
use crate::language::Message;
use crate::model::editing::live::Reshaped;
use crate::model::{Model, names};
use crate::session::OutlineSpec;

/// What has a handle in hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hold {
    /// The pointer.
    Pointer,
    /// Arrow keys that are down.
    Keys,
}

/// A handle in hand.
#[derive(Debug)]
struct Grip {
    /// What was good when it was grabbed.
    from: Form,
    handle: usize,
    hold: Hold,
}

/// A change of the outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// A handle more, on the boundary near a place.
    Insert(DVec2),
    /// A handle less.
    Remove(usize),
    /// Corners become round.
    Smooth,
    /// The mirror image.
    Mirror,
}

/// Why the outline in hand is none.
#[derive(Debug, Clone, PartialEq)]
pub struct Crossing {
    /// Where in the plane.
    pub at: Option<DVec2>,
    /// What is wrong.
    pub text: Message,
}

impl Crossing {
    /// What is wrong with `chain`, its place in no more digits than can be seen.
    pub fn of(error: &PolygonError, chain: &[DVec2]) -> Self {
        let size = Bounds::of(chain.iter().copied()).size().max_element();
        let digits = (3.0 - size.log10().floor()).clamp(0.0, 12.0);
        let scale = 10_f64.powi(if digits.is_finite() { digits as i32 } else { 0 });
        let short = |at: DVec2| (scale * at).round() / scale;
        let said = match *error {
            PolygonError::EdgesCross { first, second, at } => PolygonError::EdgesCross { first, second, at: short(at) },
            PolygonError::EdgesTouch { first, second, at } => PolygonError::EdgesTouch { first, second, at: short(at) },
            ref other => other.clone(),
        };
        Self { at: error.place(), text: Message::from(&said) }
    }
}

/// An outline with its two points.
#[derive(Debug, Clone)]
struct Form {
    shape: Shape,
    interior: Option<DVec2>,
    anchor: f64,
}

/// The outline of one side under the hand.
#[derive(Debug)]
pub struct Reshaping {
    side: Side,
    /// What it is called from its first change on.
    name: String,
    /// The outline that the model was asked for last.
    sent: OutlineSpec,
    /// The last good form.
    good: Form,
    grip: Option<Grip>,
    /// What is drawn: the good one, or one that crosses itself.
    shape: Shape,
    crossing: Option<Crossing>,
    /// The handle that keys and buttons mean.
    pub selected: Option<usize>,
}

impl Reshaping {
    /// Takes up the outline of a side.
    pub fn new(side: Side, model: &Model) -> Self {
        let sent = model.side(side).wanted().outline.clone();
        let good = form(side, &sent, model);
        let (name, shape) = (names::edited(&sent), good.shape.clone());
        Self { side, name, sent, good, grip: None, shape, crossing: None, selected: None }
    }

    /// Whose outline it is.
    pub fn side(&self) -> Side {
        self.side
    }

    /// The outline in hand.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Why it is none, if it is none.
    pub fn crossing(&self) -> Option<&Crossing> {
        self.crossing.as_ref()
    }

    /// The handle in hand.
    pub fn grabbed(&self) -> Option<usize> {
        self.grip.as_ref().map(|grip| grip.handle)
    }

    /// The handle in hand, if that is what `hold` has.
    pub fn held_by(&self, hold: Hold) -> Option<usize> {
        self.grip.as_ref().filter(|grip| grip.hold == hold).map(|grip| grip.handle)
    }

    /// Takes up the side's outline anew if it has become another one by other means; a handle of the old one that was
    /// in hand is let go.
    pub fn follow(&mut self, model: &Model) {
        if !self.is_replaced(model) {
            return;
        }
        let wanted = &model.side(self.side).wanted().outline;
        self.good = form(self.side, wanted, model);
        self.grip = None;
        self.name = names::edited(wanted);
        self.sent = wanted.clone();
        self.shape = self.good.shape.clone();
        self.crossing = None;
        self.selected = None;
    }

    /// Whether another outline than that in hand is wanted: not one that failed on the way of a hand.
    fn is_replaced(&self, model: &Model) -> bool {
        let side = model.side(self.side);
        side.wanted().outline != self.sent && !(self.grip.is_some() && side.is_in_hand())
    }

    /// Takes a handle in hand; what was in another one is let go.
    pub fn grab(&mut self, handle: usize, hold: Hold, model: &mut Model) {
        self.release(model);
        self.selected = Some(handle);
        self.remember_points(model);
        self.grip = Some(Grip { from: self.good.clone(), handle, hold });
    }

    /// Lets go without a word to the model: what it has been told stays.
    pub fn drop_handle(&mut self) {
        self.grip = None;
        self.shape = self.good.shape.clone();
        self.crossing = None;
    }

    /// Moves the handle in hand; the model follows coarsely while the outline is one.
    pub fn drag(&mut self, to: DVec2, model: &mut Model) {
        let Some(Grip { from, handle, .. }) = self.grip.as_ref().filter(|_| !self.is_replaced(model)) else { return };
        let (from, shape) = (from.clone(), from.shape.moved(*handle, to));
        if let Some(form) = self.tried(&from, shape) {
            self.good = form;
            self.send(model, true);
        }
    }

    /// Lets the handle go. Where the outline crossed itself, the last good one stays; returns whether it did.
    pub fn release(&mut self, model: &mut Model) -> bool {
        if self.grip.take().is_none() {
            return false;
        }
        let crossed = self.crossing.take().is_some();
        self.shape = self.good.shape.clone();
        if model.side(self.side).is_in_hand() {
            self.send(model, false);
        }
        crossed
    }

    /// Makes a change at once; a handle in hand is let go first. Errors: why it was not made.
    pub fn change(&mut self, change: Change, model: &mut Model) -> Result<(), DrawingError> {
        self.release(model);
        self.remember_points(model);
        let from = self.good.clone();
        let selected;
        let mut interior = from.interior;
        let shape = match change {
            Change::Insert(at) => {
                let (shape, handle) = from.shape.inserted(at);
                selected = Some(handle);
                shape
            }
            Change::Remove(handle) => {
                selected = None;
                from.shape.removed(handle)?
            }
            Change::Smooth => {
                selected = None;
                from.shape.smoothed()
            }
            Change::Mirror => {
                selected = None;
                interior = interior.map(|point| from.shape.axis().image(point));
                from.shape.mirrored()
            }
        };
        let mut form = formed(&from, shape)?;
        form.interior = interior;
        if change == Change::Mirror {
            form.anchor = (1.0 - from.anchor).rem_euclid(1.0);
        }
        self.shape = form.shape.clone();
        self.selected = selected;
        self.crossing = None;
        self.good = form;
        self.send(model, false);
        Ok(())
    }

    /// The form with another shape; `None` and a crossing if that is no outline.
    fn tried(&mut self, from: &Form, shape: Shape) -> Option<Form> {
        self.shape = shape.clone();
        match formed(from, shape) {
            Ok(form) => {
                self.crossing = None;
                Some(form)
            }
            Err(error) => {
                self.crossing = Some(Crossing::of(&error, self.shape.vertices()));
                None
            }
        }
    }

    /// The points may have been moved since the last change; while that is prepared, they are its own.
    fn remember_points(&mut self, model: &Model) {
        if model.side(self.side).is_busy() {
            return;
        }
        let (polygon, anchor) = (self.sent.polygon(), model.session().side(self.side).anchor);
        self.good.anchor = carried_fraction(polygon.vertices(), self.good.shape.vertices(), anchor);
        self.good.interior = model.interior(self.side);
    }

    fn send(&mut self, model: &mut Model, in_hand: bool) {
        let Form { interior, mut anchor, .. } = self.good;
        // the outline was found to be one when it became the good one
        let Ok(polygon) = self.good.shape.polygon() else { return };
        if polygon.was_clockwise() {
            anchor = (1.0 - anchor).rem_euclid(1.0);
        }
        if polygon.was_clockwise() && !in_hand {
            // turned inside out: from now on the other way round
            self.shape = Shape::new(&polygon);
            self.good.anchor = carried_fraction(polygon.vertices(), self.shape.vertices(), anchor);
            self.good.shape = self.shape.clone();
            self.selected = None;
        }
        self.sent = OutlineSpec::Points { name: self.name.clone(), polygon };
        model.reshape(self.side, self.sent.clone(), Reshaped { interior, anchor, in_hand });
    }
}

/// An outline of a side with the points that the side has.
fn form(side: Side, outline: &OutlineSpec, model: &Model) -> Form {
    let polygon = outline.polygon();
    let shape = Shape::new(&polygon);
    let anchor = carried_fraction(polygon.vertices(), shape.vertices(), model.session().side(side).anchor);
    Form { shape, interior: model.interior(side), anchor }
}

/// The form with another shape, the boundary point on the same part of it. Errors: the shape is no outline.
fn formed(from: &Form, shape: Shape) -> Result<Form, PolygonError> {
    shape.polygon()?;
    let anchor = carried_fraction(from.shape.vertices(), shape.vertices(), from.anchor);
    Ok(Form { shape, interior: from.interior, anchor })
}
