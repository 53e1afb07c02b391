//! Messages that belong to both sides: a message or an offer below the pictures, which shrink so that nothing is
//! covered; and a notice over the pictures, which disappears after some seconds.

use crate::app::RiemapApp;
use crate::app::input::action::{Action, Actions};
use crate::app::messages::Notice;
use crate::app::panels::offer;
use crate::app::theme::Palette;
use crate::app::theme::widgets::{message_box, notice_box};
use crate::language::Message;
use egui::{Context, Frame, Margin, Panel, Rect, Ui, UiBuilder, pos2, vec2};

/// The largest width of a message: lines that are easy to read.
const WIDEST: f32 = 720.0;
/// The largest share of the height left for the pictures that message and offer may take: in a frame of 320 points the
/// pictures keep 175, on a phone five lines fit.
const MOST_SHARE: f32 = 0.4;
/// The height that they leave to the pictures if possible, and the larger one while an outline is edited.
const LEAST_PICTURES: f32 = 150.0;
const LEAST_EDITED: f32 = 230.0;
/// The size of a notice, and the distance of its upper edge from the lower edge of the pictures.
const NOTICE: [f32; 2] = [140.0, 34.0];
const NOTICE_ABOVE: f32 = 64.0;

/// The height of the offer, and of the frame around message and offer.
const OFFER: f32 = 46.0;
const FRAME: f32 = 12.0;

/// The content in this frame. It neither appears nor grows while a pointer button is down, because the pictures shrink.
#[derive(Debug, Default)]
pub struct MessageBar {
    message: Option<Message>,
    has_offer: bool,
}

impl MessageBar {
    /// Whether a message is shown.
    pub fn has_message(&self) -> bool {
        self.message.is_some()
    }

    fn take_in(&mut self, message: Option<&Message>, has_offer: bool, held: bool) {
        if !held || message.is_none() {
            self.message = message.cloned();
        }
        self.has_offer = has_offer && (self.has_offer || !held);
    }
}

/// Determines the message and the offer of this frame.
pub fn begin(app: &mut RiemapApp, ui: &Ui) {
    offer::expire(ui, &mut app.messages.offer);
    app.messages.go_on();
    let held = ui.input(|input| input.pointer.any_down());
    app.messages.bar.take_in(app.messages.common.as_ref(), app.messages.offer.is_some(), held);
}

/// Requests another frame if the content has changed since; while a pointer button is down, its release does so.
pub fn end(app: &RiemapApp, context: &Context) {
    let has_changed =
        app.messages.bar.message != app.messages.common || app.messages.bar.has_offer != app.messages.offer.is_some();
    if has_changed && !context.input(|input| input.pointer.any_down()) {
        context.request_repaint();
    }
}

/// Shows the message and the offer.
pub fn show(app: &RiemapApp, ui: &mut Ui, actions: &mut Actions) {
    let MessageBar { message, has_offer } = &app.messages.bar;
    if message.is_none() && !has_offer {
        return;
    }
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new().fill(palette.panel).inner_margin(Margin::symmetric(10, 6));
    let (free, least) =
        (ui.available_height(), if app.editor.side().is_some() { LEAST_EDITED } else { LEAST_PICTURES });
    let besides = FRAME + if *has_offer { OFFER } else { 0.0 };
    let most = (MOST_SHARE * free).min(free - least) - besides;
    Panel::bottom("message").resizable(false).frame(frame).show(ui, |ui| {
        ui.take_available_width();
        ui.set_max_width(ui.available_width().min(WIDEST));
        if message.as_ref().and_then(|message| message_box(ui, message, None, most)).is_some() {
            actions.push(Action::DismissMessage);
        }
        if let Some(offer) = app.messages.offer.as_ref().filter(|_| *has_offer) {
            offer::show(ui, offer, &app.model, actions);
        }
    });
}

/// Shows the notice, the confirmation of an action, over the middle of the pictures until it expires.
pub fn notice(app: &RiemapApp, ui: &mut Ui) {
    let Some(Notice { text, until }) = app.messages.notice else { return };
    let left = until - ui.input(|input| input.time);
    if left <= 0.0 {
        return;
    }
    ui.ctx().request_repaint_after_secs(left as f32);
    let (area, size) = (ui.max_rect(), vec2(NOTICE[0], NOTICE[1]));
    let place = pos2(area.center().x - 0.5 * size.x, area.bottom() - NOTICE_ABOVE);
    let place = Rect::from_min_size(place, size);
    ui.scope_builder(UiBuilder::new().max_rect(place), |ui| notice_box(ui, text));
}
