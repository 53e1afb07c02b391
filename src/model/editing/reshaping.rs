//! An outline being reshaped: the handle being dragged, the last valid outline, and the place of a self-crossing.
//!
//! Independent of egui. Every change sends a whole new outline to the model. At the end of a drag the boundary point
//! and the interior point are the same as at its beginning, if the outline allows it.

use crate::conformal::Side;
use crate::drawing::{DrawingError, Shape, carried_fraction};
use crate::geometry::{Bounds, DVec2, PolygonError};
use crate::language::Message;
use crate::model::editing::live::Reshaped;
use crate::model::{Model, names};
use crate::session::OutlineSpec;

/// The input that drags a handle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hold {
    /// The pointer.
    Pointer,
    /// Arrow keys that are held down.
    Keys,
}

/// A handle being dragged.
#[derive(Debug)]
struct Grip {
    /// The valid outline when the drag began.
    from: Form,
    handle: usize,
    hold: Hold,
}

/// A change other than a drag.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Change {
    /// Inserts a handle on the boundary near a point.
    Insert(DVec2),
    /// Removes a handle.
    Remove(usize),
    /// Rounds the corners.
    Smooth,
    /// Mirrors the outline.
    Mirror,
}

/// Why the outline being edited is invalid.
#[derive(Debug, Clone, PartialEq)]
pub struct Crossing {
    /// The place in the plane.
    pub at: Option<DVec2>,
    /// The message.
    pub text: Message,
}

impl Crossing {
    /// Describes what is wrong with `chain`, with coordinates rounded to visible digits.
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
    /// Whether it is the mirror image of the one last sent.
    turned: bool,
}

/// The editing state of one side's outline.
#[derive(Debug)]
pub struct Reshaping {
    side: Side,
    /// The name of the outline after its first change.
    name: String,
    /// The outline last sent to the model.
    sent: OutlineSpec,
    /// The last valid outline.
    good: Form,
    grip: Option<Grip>,
    /// The shape drawn: the last valid one, or one that crosses itself.
    shape: Shape,
    crossing: Option<Crossing>,
    /// The handle to which keys and buttons apply.
    pub selected: Option<usize>,
}

impl Reshaping {
    /// Starts editing the outline of a side.
    pub fn new(side: Side, model: &Model) -> Self {
        let sent = model.side(side).wanted().outline.clone();
        let good = form(side, &sent, model);
        let (name, shape) = (names::edited(&sent), good.shape.clone());
        Self { side, name, sent, good, grip: None, shape, crossing: None, selected: None }
    }

    /// The side whose outline is edited.
    pub fn side(&self) -> Side {
        self.side
    }

    /// The shape being edited.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Why the shape is invalid, if it is.
    pub fn crossing(&self) -> Option<&Crossing> {
        self.crossing.as_ref()
    }

    /// The handle being dragged.
    pub fn grabbed(&self) -> Option<usize> {
        self.grip.as_ref().map(|grip| grip.handle)
    }

    /// The handle being dragged by `hold`.
    pub fn held_by(&self, hold: Hold) -> Option<usize> {
        self.grip.as_ref().filter(|grip| grip.hold == hold).map(|grip| grip.handle)
    }

    /// Starts again if the side's outline was replaced by other means; a drag of a handle of the old outline
    /// ends.
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

    /// Whether the side's outline was replaced by other means. A reset because a dragged outline failed does not count.
    fn is_replaced(&self, model: &Model) -> bool {
        let side = model.side(self.side);
        side.wanted().outline != self.sent && !(self.grip.is_some() && side.is_in_hand())
    }

    /// Starts dragging a handle; another drag is ended first.
    pub fn grab(&mut self, handle: usize, hold: Hold, model: &mut Model) {
        self.release(model);
        self.selected = Some(handle);
        self.remember_points(model);
        self.grip = Some(Grip { from: self.good.clone(), handle, hold });
    }

    /// Ends the drag without telling the model, which keeps the last outline sent.
    pub fn drop_handle(&mut self) {
        self.grip = None;
        self.shape = self.good.shape.clone();
        self.crossing = None;
    }

    /// Moves the dragged handle. While the outline is valid, the model follows with a coarse mesh.
    pub fn drag(&mut self, to: DVec2, model: &mut Model) {
        let Some(Grip { from, handle, .. }) = self.grip.as_ref().filter(|_| !self.is_replaced(model)) else { return };
        let (from, shape) = (from.clone(), from.shape.moved(*handle, to));
        if let Some(form) = self.tried(&from, shape) {
            self.good = form;
            self.send(model, true);
        }
    }

    /// Ends the drag. If the outline crosses itself, it returns to the last valid one; returns whether it did.
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

    /// Applies a change; a drag is ended first. Errors: why the change is impossible.
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
            form.turned = true;
        }
        self.shape = form.shape.clone();
        self.selected = selected;
        self.crossing = None;
        self.good = form;
        self.send(model, false);
        Ok(())
    }

    /// `from` with another shape; `None`, and a crossing, if that shape is not a valid outline.
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

    /// Updates the points, which may have been moved since the last change. Does nothing while that change is being
    /// prepared.
    fn remember_points(&mut self, model: &Model) {
        if model.side(self.side).is_busy() {
            return;
        }
        let (polygon, anchor) = (self.sent.polygon(), model.session().side(self.side).anchor());
        self.good.anchor = carried_fraction(polygon.vertices(), self.good.shape.vertices(), anchor);
        self.good.interior = model.interior(self.side);
    }

    fn send(&mut self, model: &mut Model, in_hand: bool) {
        let Form { interior, mut anchor, .. } = self.good;
        let turned = self.good.turned || self.good.shape.polygon().is_ok_and(|polygon| polygon.was_clockwise());
        self.good.turned = false;
        // cannot fail: the shape was checked when it became the last valid one
        let Ok(polygon) = self.good.shape.polygon() else { return };
        if polygon.was_clockwise() {
            anchor = (1.0 - anchor).rem_euclid(1.0);
        }
        if polygon.was_clockwise() && !in_hand {
            // turned inside out: from now on the shape has the opposite orientation
            self.shape = Shape::new(&polygon);
            self.good.anchor = carried_fraction(polygon.vertices(), self.shape.vertices(), anchor);
            self.good.shape = self.shape.clone();
            self.selected = None;
        }
        let form = self.sent.carried_form(&polygon);
        self.sent = OutlineSpec::points(self.name.clone(), polygon).with_form(form);
        model.reshape(self.side, self.sent.clone(), Reshaped { interior, anchor, in_hand, turned });
    }
}

/// The outline of a side with the side's points.
fn form(side: Side, outline: &OutlineSpec, model: &Model) -> Form {
    let polygon = outline.polygon();
    let shape = Shape::new(&polygon);
    let anchor = carried_fraction(polygon.vertices(), shape.vertices(), model.session().side(side).anchor());
    Form { shape, interior: model.interior(side), anchor, turned: false }
}

/// `from` with another shape and the boundary point on the same part of it. Errors: the shape is not a valid outline.
fn formed(from: &Form, shape: Shape) -> Result<Form, PolygonError> {
    shape.polygon()?;
    let anchor = carried_fraction(from.shape.vertices(), shape.vertices(), from.anchor);
    Ok(Form { shape, interior: from.interior, anchor, turned: false })
}
