//! The offer to trace the outline of an image that has just become the texture.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::menu_entry;
use crate::app::theme::{ROW_HEIGHT, control_height};
use crate::conformal::Side;
use crate::language::{key, tr};
use crate::model::editing::tracing;
use crate::model::files;
use crate::model::files::Picture;
use crate::model::side::user_error::UserError;
use crate::outline::Outline;
use egui::{Button, Ui, vec2};

/// How long the offer is shown, in seconds: a sentence and two buttons are read in five.
const SECONDS: f64 = 12.0;

/// An image that can be traced.
pub struct Offer {
    side: Side,
    picture: Picture,
    /// The time at which the offer expires, in seconds; set when it is first shown.
    until: Option<f64>,
}

impl Offer {
    /// Keeps the image at the resolution of the tracing, at most [`tracing::MAX_SIDE`] pixels on its longer side.
    pub fn new(side: Side, picture: &Picture) -> Self {
        let (width, height) = picture.pixels.dimensions();
        let pixels = match width.max(height) {
            0..=tracing::MAX_SIDE => picture.pixels.clone(),
            largest => {
                let scaled = |length: u32| (length * tracing::MAX_SIDE / largest).max(1);
                image::imageops::thumbnail(&picture.pixels, scaled(width), scaled(height))
            }
        };
        Self { side, picture: Picture { name: picture.name.clone(), pixels }, until: None }
    }

    /// Traces the image; returns the side that the outline is for.
    pub fn accept(&self) -> (Side, Result<Outline, UserError>) {
        (self.side, files::traced(&self.picture))
    }
}

/// Removes an expired offer, but not while a pointer button is down: the pictures grow when the offer goes, which
/// would move what is being dragged.
pub fn expire(ui: &Ui, offer: &mut Option<Offer>) {
    let Some(standing) = offer else { return };
    let (now, held) = ui.input(|input| (input.time, input.pointer.any_down()));
    let left = *standing.until.get_or_insert(now + SECONDS) - now;
    if left > 0.0 {
        ui.ctx().request_repaint_after_secs(left as f32);
    } else if !held {
        *offer = None;
    }
}

/// Shows the offer.
pub fn show(ui: &mut Ui, actions: &mut Actions) {
    let height = control_height(ui, ROW_HEIGHT);
    ui.horizontal_wrapped(|ui| {
        ui.label(tr(key::picture_texture()));
        let trace = Button::new(tr(key::trace_outline())).min_size(vec2(0.0, height));
        let explained = key::trace_picture_tooltip();
        if menu_entry(ui, true, trace, explained, &Action::TraceImage) {
            actions.push(Action::TraceImage);
        }
        if ui.add(Button::new(tr(key::no())).min_size(vec2(40.0, height))).clicked() {
            actions.push(Action::DismissOffer);
        }
    });
}
