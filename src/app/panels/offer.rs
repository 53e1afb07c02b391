//! The offer to trace the outline of an image: of one that has just become the texture, or, as a question that waits for
//! its answer, of one that was opened as an outline.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::menu_entry;
use crate::app::theme::{ROW_HEIGHT, control_height};
use crate::conformal::Side;
use crate::language::{key, say, tr};
use crate::model::editing::tracing;
use crate::model::files;
use crate::model::files::Picture;
use crate::model::side::user_error::UserError;
use crate::outline::Outline;
use crate::session::file::Attachment;
use egui::{Button, Ui, vec2};

/// How long the offer is shown, in seconds: a sentence and two buttons are read in five.
const SECONDS: f64 = 12.0;

/// An image that can be traced.
pub struct Offer {
    side: Side,
    /// The image at the resolution of the tracing.
    picture: Picture,
    /// The image and its file, if it is not in use yet: then the offer is a question.
    unused: Option<(Picture, Attachment)>,
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
        Self { side, picture: Picture { name: picture.name.clone(), pixels }, unused: None, until: None }
    }

    /// Asks whether the image is to be traced or to become the texture.
    pub fn question(side: Side, picture: Picture, file: Attachment) -> Self {
        let offer = Self::new(side, &picture);
        Self { unused: Some((picture, file)), ..offer }
    }

    /// The image and its file, if the offer is a question.
    pub fn into_unused(self) -> Option<(Picture, Attachment)> {
        self.unused
    }

    /// Traces the image; returns the side that the outline is for.
    pub fn accept(&self) -> (Side, Result<Outline, UserError>) {
        (self.side, files::traced(&self.picture))
    }
}

/// Removes an expired offer that is no question, but not while a pointer button is down: the pictures grow when the offer goes, which
/// would move what is being dragged.
pub fn expire(ui: &Ui, offer: &mut Option<Offer>) {
    let Some(standing) = offer.as_mut().filter(|offer| offer.unused.is_none()) else { return };
    let (now, held) = ui.input(|input| (input.time, input.pointer.any_down()));
    let left = *standing.until.get_or_insert(now + SECONDS) - now;
    if left > 0.0 {
        ui.ctx().request_repaint_after_secs(left as f32);
    } else if !held {
        *offer = None;
    }
}

/// Shows the offer, or the question with its three answers.
pub fn show(ui: &mut Ui, offer: &Offer, actions: &mut Actions) {
    let height = control_height(ui, ROW_HEIGHT);
    let button = |words| Button::new(tr(words)).min_size(vec2(40.0, height));
    let is_question = offer.unused.is_some();
    let (asked, trace, dismiss) = if is_question {
        (say(&key::picture_opened(&*offer.picture.name)), key::trace_silhouette(), key::cancel())
    } else {
        (tr(key::picture_texture()).to_owned(), key::trace_outline(), key::no())
    };
    ui.horizontal_wrapped(|ui| {
        ui.label(asked);
        if menu_entry(ui, true, button(trace), key::trace_picture_tooltip(), &Action::TraceImage) {
            actions.push(Action::TraceImage);
        }
        if is_question
            && menu_entry(ui, true, button(key::use_picture()), key::use_picture_tooltip(), &Action::UseImage)
        {
            actions.push(Action::UseImage);
        }
        if ui.add(button(dismiss)).clicked() {
            actions.push(Action::DismissOffer);
        }
    });
}
