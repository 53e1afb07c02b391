//! The offer to trace the outline of an image: of one that has just become the texture, or, as a question that waits for
//! its answer, of one that was opened as an outline; and the offers to take another shape of an outline's file, and to
//! show it as a map of the globe.

use super::shapes::parts;
use crate::app::input::action::{Action, Actions, ProjectionAction};
use crate::app::input::locks::menu_entry;
use crate::app::theme::{ROW_HEIGHT, control_height};
use crate::conformal::Side;
use crate::language::{Label, key, say, tr};
use crate::model::Model;
use crate::model::editing::tracing;
use crate::model::files;
use crate::model::files::Picture;
use crate::model::opening::ArrivedOutline;
use crate::model::side::opened_file::OpenedFile;
use crate::model::side::user_error::UserError;
use crate::outline::Outline;
use crate::session::file::Attachment;
use egui::{Button, Popup, Ui, vec2};

/// How long the offer is shown, in seconds: two sentences and three buttons are read in eight, and with a keyboard it takes
/// as many to reach them.
const SECONDS: f64 = 20.0;

/// An offer below the pictures.
pub struct Offer {
    offered: Offered,
    /// The time at which the offer expires, in seconds; set when it is first shown.
    until: Option<f64>,
}

enum Offered {
    /// An image can be traced.
    Tracing {
        side: Side,
        /// The image at the resolution of the tracing.
        picture: Picture,
        /// The image and its file, if it is not in use yet: then the offer is a question.
        unused: Option<(Picture, Attachment)>,
    },
    /// The file of a side's outline can be shown as a map of the globe, or holds several shapes.
    Read(ArrivedOutline),
}

impl From<Offered> for Offer {
    fn from(offered: Offered) -> Self {
        Self { offered, until: None }
    }
}

impl Offer {
    /// Keeps the image at the resolution of the tracing, at most [`tracing::MAX_SIDE`] pixels on its longer side.
    pub fn new(side: Side, picture: &Picture) -> Self {
        Offered::Tracing { side, picture: reduced(picture), unused: None }.into()
    }

    /// Asks whether the image is to be traced or to become the texture.
    pub fn question(side: Side, picture: Picture, file: Attachment) -> Self {
        Offered::Tracing { side, picture: reduced(&picture), unused: Some((picture, file)) }.into()
    }

    /// Offers what the file of an outline gives besides: a map of the globe, or other shapes; nothing if it does not.
    pub fn besides(arrived: ArrivedOutline) -> Option<Self> {
        (arrived.geographic.is_some() || arrived.of_several.is_some()).then(|| Offered::Read(arrived).into())
    }

    /// The image and its file, if the offer is a question.
    pub fn into_unused(self) -> Option<(Picture, Attachment)> {
        if let Offered::Tracing { unused, .. } = self.offered { unused } else { None }
    }

    /// The file that can be shown as a map.
    pub fn into_region(self) -> Option<OpenedFile> {
        if let Offered::Read(arrived) = self.offered { arrived.geographic } else { None }
    }

    /// Traces the image, if the offer is one to do so; returns the side that the outline is for.
    pub fn accept(&self) -> Option<(Side, Result<Outline, UserError>)> {
        let Offered::Tracing { side, picture, .. } = &self.offered else { return None };
        Some((*side, files::traced(picture)))
    }

    /// Whether it waits for its answer, however long that takes.
    pub fn is_question(&self) -> bool {
        matches!(self.offered, Offered::Tracing { unused: Some(_), .. })
    }
}

/// The image at the resolution of the tracing.
fn reduced(picture: &Picture) -> Picture {
    let (width, height) = picture.pixels.dimensions();
    let pixels = match width.max(height) {
        0..=tracing::MAX_SIDE => picture.pixels.clone(),
        largest => {
            let scaled = |length: u32| (length * tracing::MAX_SIDE / largest).max(1);
            image::imageops::thumbnail(&picture.pixels, scaled(width), scaled(height))
        }
    };
    Picture { name: picture.name.clone(), pixels }
}

/// Removes an expired offer that is no question, but not while a pointer button is down: the pictures grow when the offer goes, which
/// would move what is being dragged.
pub fn expire(ui: &Ui, offer: &mut Option<Offer>) {
    let Some(standing) = offer.as_mut().filter(|offer| !offer.is_question()) else { return };
    let (now, held) = ui.input(|input| (input.time, input.pointer.any_down()));
    let left = *standing.until.get_or_insert(now + SECONDS) - now;
    if left > 0.0 {
        ui.ctx().request_repaint_after_secs(left as f32);
    } else if !held && !Popup::is_any_open(ui.ctx()) {
        *offer = None;
    }
}

/// Shows the offer with its answers.
pub fn show(ui: &mut Ui, offer: &Offer, model: &Model, actions: &mut Actions) {
    let (asked, answers, dismiss) = words(offer);
    let height = control_height(ui, ROW_HEIGHT);
    let button = |words| Button::new(tr(words)).min_size(vec2(40.0, height));
    ui.horizontal_wrapped(|ui| {
        ui.label(asked);
        for (label, tooltip, action) in answers {
            if menu_entry(ui, true, button(label), tooltip, &action) {
                actions.push(action);
            }
        }
        if let Offered::Read(ArrivedOutline { side, .. }) = offer.offered {
            parts::menu_button(ui, side, model, actions);
        }
        if ui.add(button(dismiss)).clicked() {
            actions.push(Action::DismissOffer);
        }
    });
}

/// The label of an answer, its tooltip, and what it does.
type Answer = (Label, Label, Action);

/// The question, its answers, and the label of the one that declines.
fn words(offer: &Offer) -> (String, Vec<Answer>, Label) {
    let trace = |label: Label| (label, key::trace_picture_tooltip(), Action::TraceImage);
    match &offer.offered {
        Offered::Tracing { picture, unused: Some(_), .. } => {
            let answers = vec![
                trace(key::trace_silhouette()),
                (key::use_picture(), key::use_picture_tooltip(), Action::UseImage),
            ];
            (say(&key::picture_opened(&*picture.name)), answers, key::cancel())
        }
        Offered::Tracing { .. } => {
            (tr(key::picture_texture()).to_owned(), vec![trace(key::trace_outline())], key::no())
        }
        Offered::Read(ArrivedOutline { geographic, of_several, .. }) => {
            let project = || {
                let action = Action::Projection(ProjectionAction::Offered);
                (key::project_it(), key::project_it_tooltip(), action)
            };
            let several = of_several.map(|count| say(&key::file_has_parts(count)));
            let map = geographic.as_ref().map(|_| tr(key::looks_geographic()).to_owned());
            let asked: Vec<String> = several.into_iter().chain(map).collect();
            (asked.join(" "), geographic.iter().map(|_| project()).collect(), key::no())
        }
    }
}
