//! The dots x₁, y₁, x₂, y₂, or the pins in their place, and the marks: hit test, drag, focus and pulse; and the probe.
//!
//! A drag keeps the offset from the pointer to the dot, so that the dot does not jump when it is grabbed.
//! The nearest dot within [`GRAB_RADIUS`] is hit; a tie goes to the interior point.

use crate::app::input::snapping::Catch;
use crate::app::theme::{BOUNDARY_COLOUR, INTERIOR_COLOUR};
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::language::{key, say};
use crate::model::Probe;
use egui::{Color32, Pos2, Vec2};
use std::borrow::Cow;

/// The radius of a dot on the screen, in points, without its ring.
pub const DOT_RADIUS: f32 = 9.0;
/// The radius of the area that grabs a dot: 44 points across, a finger's width.
pub const GRAB_RADIUS: f32 = 22.0;
/// The duration of the pulse of a dragged dot's partner, in seconds.
pub const PULSE_SECONDS: f64 = 0.7;

/// What is dragged on a side: its two dots, or its pins; and the squares of the marks of its quadrilateral.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HandleKind {
    /// The interior point x, green.
    Interior,
    /// The boundary point y, magenta.
    Boundary,
    /// A pin, counted from 0: a boundary point with its number.
    Pin(u8),
    /// A mark of the quadrilateral, counted from 0.
    Mark(u8),
}

impl HandleKind {
    /// The color of the dots of this kind, and of a mark's pulse.
    pub fn colour(self) -> Color32 {
        match self {
            Self::Interior => INTERIOR_COLOUR,
            Self::Boundary | Self::Pin(_) | Self::Mark(_) => BOUNDARY_COLOUR,
        }
    }
}

/// The number, from 1, of the pin or of the mark with this index.
pub fn number(index: u8) -> u32 {
    u32::from(index) + 1
}

/// One of the dots.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Handle {
    /// The side that it belongs to.
    pub side: Side,
    /// Interior point, boundary point or pin.
    pub kind: HandleKind,
}

impl Handle {
    /// The dot of the same kind on the other side: the map sends one to the other.
    #[must_use]
    pub fn partner(self) -> Self {
        Self { side: self.side.other(), ..self }
    }

    /// The symbol with the side as index, such as "x₁" or "y₂"; the number of a pin, from 1; the name of a mark.
    pub fn symbol(self) -> Cow<'static, str> {
        Cow::Borrowed(match (self.kind, self.side) {
            (HandleKind::Interior, Side::Source) => "x₁",
            (HandleKind::Interior, Side::Target) => "x₂",
            (HandleKind::Boundary, Side::Source) => "y₁",
            (HandleKind::Boundary, Side::Target) => "y₂",
            (HandleKind::Pin(k), _) => return Cow::Owned(number(k).to_string()),
            (HandleKind::Mark(k), _) => return Cow::Owned(say(&key::mark(number(k)))),
        })
    }
}

/// The dots of a side on the screen; the first of two that are equally far from a press is hit, and painted last.
pub type Places = Vec<(HandleKind, Pos2)>;

/// The dot that a press at `pointer` grabs, with its place.
pub fn hit(side: Side, places: &Places, pointer: Pos2) -> Option<(Handle, Pos2)> {
    places
        .iter()
        .map(|&(kind, place)| ((Handle { side, kind }, place), place.distance(pointer)))
        .filter(|(_, distance)| *distance <= GRAB_RADIUS)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(dot, _)| dot)
}

/// A dot that is being dragged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grip {
    /// The dragged dot.
    pub handle: Handle,
    /// From the pointer to the dot's center when the drag began.
    pub offset: Vec2,
}

/// A point of a planar picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pointed {
    /// The picture's side.
    pub side: Side,
    /// The point, rounded to what a pixel resolves.
    pub point: DVec2,
    /// The decimals to which it is rounded.
    pub decimals: usize,
    /// Whether it stays while no pointer hovers over the picture: it was clicked or tapped.
    pub stays: bool,
}

/// Drag, focus, hover and pulse state of the dots.
#[derive(Debug, Clone, Default)]
pub struct HandleState {
    /// The dragged dot.
    pub grip: Option<Grip>,
    /// The dot that has the keyboard focus.
    pub focused: Option<Handle>,
    /// The viewport that has the keyboard focus.
    pub focused_view: Option<Side>,
    /// The dot under the pointer.
    pub hovered: Option<Handle>,
    /// The point of a domain under the pointer, or the one that was clicked last.
    pub pointed: Option<Pointed>,
    /// The circle whose image is shown.
    pub probe: Option<Probe>,
    /// While this circle is dragged: from the pointer to its center when the drag began.
    pub probe_grip: Option<Vec2>,
    /// Whether this circle has the keyboard focus.
    pub is_probe_focused: bool,
    /// The corners that may catch the dragged boundary dot, once they are needed.
    pub corners: Option<Vec<DVec2>>,
    /// What has caught the dot that was dragged last, until another one is grabbed.
    pub caught: Option<(Handle, Catch)>,
    /// The pulsing dot and the start of its pulse, in seconds.
    pulse: Option<(Handle, f64)>,
    /// Whether a dot was ever dragged or focused; from then on the hint is not shown.
    pub ever_dragged: bool,
}

impl HandleState {
    /// Starts dragging `handle`, and the pulse of its partner.
    pub fn grab(&mut self, handle: Handle, position: Pos2, pointer: Pos2, now: f64) {
        self.grip = Some(Grip { handle, offset: position - pointer });
        (self.corners, self.caught) = (None, None);
        self.pulse = Some((handle.partner(), now));
        self.ever_dragged = true;
    }

    /// Ends the drag, of a dot or of the circle.
    pub fn release(&mut self) {
        self.grip = None;
        self.probe_grip = None;
    }

    /// What has caught the dot that is being dragged.
    pub fn held_catch(&self) -> Option<(Handle, Catch)> {
        self.caught.filter(|(handle, _)| self.is_held(*handle))
    }

    /// Whether `handle` is drawn larger: hovered, dragged or focused.
    pub fn is_raised(&self, handle: Handle) -> bool {
        self.hovered == Some(handle) || self.is_held(handle) || self.focused == Some(handle)
    }

    /// Whether `handle` is being dragged.
    pub fn is_held(&self, handle: Handle) -> bool {
        self.grip.is_some_and(|grip| grip.handle == handle)
    }

    /// The progress of the pulse of `handle`, from 0 to 1; `None` if it does not pulse.
    pub fn pulse_of(&self, handle: Handle, now: f64) -> Option<f32> {
        let (pulsing, since) = self.pulse?;
        let progress = (now - since) / PULSE_SECONDS;
        (pulsing == handle && progress < 1.0).then_some(progress.max(0.0) as f32)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]
    use super::*;
    use egui::pos2;

    fn both() -> Places {
        vec![(HandleKind::Interior, pos2(100.0, 100.0)), (HandleKind::Boundary, pos2(130.0, 100.0))]
    }

    fn kind_at(places: &Places, x: f32) -> Option<HandleKind> {
        hit(Side::Source, places, pos2(x, 100.0)).map(|(handle, _)| handle.kind)
    }

    #[test]
    fn the_nearer_dot_is_hit_where_the_areas_overlap() {
        assert_eq!(kind_at(&both(), 112.0), Some(HandleKind::Interior));
        assert_eq!(kind_at(&both(), 118.0), Some(HandleKind::Boundary));
    }

    #[test]
    fn a_finger_beside_the_dot_still_grabs_it_but_no_farther_than_44_points_across() {
        assert!(kind_at(&both(), 100.0 - 21.0).is_some());
        assert!(kind_at(&both(), 100.0 - 23.0).is_none());
    }

    #[test]
    fn a_missing_dot_cannot_be_grabbed() {
        assert_eq!(kind_at(&Places::new(), 100.0), None);
    }

    #[test]
    fn coinciding_dots_give_the_interior_one() {
        let same = both().into_iter().map(|(kind, _)| (kind, pos2(5.0, 100.0))).collect();
        assert_eq!(kind_at(&same, 6.0), Some(HandleKind::Interior));
    }

    #[test]
    fn a_grabbed_dot_keeps_its_offset_and_its_partner_pulses_once() {
        let handle = Handle { side: Side::Source, kind: HandleKind::Interior };
        let mut state = HandleState::default();
        state.grab(handle, pos2(10.0, 10.0), pos2(13.0, 9.0), 2.0);
        assert_eq!(state.grip.unwrap().offset, egui::vec2(-3.0, 1.0));
        assert!(state.pulse_of(handle.partner(), 2.1).is_some());
        assert!(state.pulse_of(handle, 2.1).is_none());
        assert!(state.pulse_of(handle.partner(), 2.0 + PULSE_SECONDS).is_none());
        state.release();
        assert!(state.grip.is_none() && state.ever_dragged);
    }
}
