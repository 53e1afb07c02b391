//! What is said about both sides: a message or an offer below the pictures, which make room for it, so that it covers
//! nothing; and a notice over them, which goes by itself.

use super::action::{Action, Actions};
use super::theme::Palette;
use super::widgets::{message_box, notice_box};
use super::{RiemapApp, offer};
use egui::{Frame, Margin, Panel, Rect, Ui, UiBuilder, pos2, vec2};

/// The width of a line that is easy to read.
const WIDEST: f32 = 720.0;
/// How much of the height that is left for the pictures a message takes at most.
const MOST_SHARE: f32 = 0.4;
/// The height that it leaves them if it can, and more for one that is edited.
const LEAST_PICTURES: f32 = 150.0;
const LEAST_EDITED: f32 = 230.0;
/// The size of a notice, and how far its upper edge lies above the pictures' lower one.
const NOTICE: [f32; 2] = [140.0, 34.0];
const NOTICE_ABOVE: f32 = 64.0;

/// Shows the message and the offer, if there are any; not before the pointer lets go of what it holds, for the pictures
/// shrink.
pub fn show(app: &mut RiemapApp, ui: &mut Ui, actions: &mut Actions) {
    offer::expire(ui, &mut app.offer);
    let is_needed = app.message.is_some() || app.offer.is_some();
    app.has_foot = is_needed && (app.has_foot || !ui.input(|input| input.pointer.any_down()));
    if !app.has_foot {
        return;
    }
    let palette = Palette::of(ui.visuals());
    let frame = Frame::new().fill(palette.panel).inner_margin(Margin::symmetric(10, 6));
    let (free, least) =
        (ui.available_height(), if app.editor.side().is_some() { LEAST_EDITED } else { LEAST_PICTURES });
    let most = (MOST_SHARE * free).min(free - least);
    Panel::bottom("message").resizable(false).frame(frame).show(ui, |ui| {
        ui.take_available_width();
        ui.set_max_width(ui.available_width().min(WIDEST));
        let message = app.message.as_ref();
        if message.and_then(|message| message_box(ui, message, None, most)).is_some() {
            actions.push(Action::DismissMessage);
        }
        if app.offer.is_some() {
            offer::show(ui, actions);
        }
    });
}

/// Shows what has gone well over the middle of the pictures, for a while.
pub fn notice(app: &RiemapApp, ui: &mut Ui) {
    let Some((text, until)) = app.notice else { return };
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
