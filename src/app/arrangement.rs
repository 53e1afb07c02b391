//! How the two pictures share their place, and what of each is left free for words, messages, legend and edit bar.

use super::view::{DESK_MARGINS, Margins, PHONE_MARGINS};
use super::{RiemapApp, editing, legend};
use crate::conformal::Side;
use crate::geometry::DVec2;
use egui::{Rect, Ui, pos2, vec2};

/// The viewport that has the legend of the colours.
pub const LEGEND_SIDE: Side = Side::Target;

/// Whether the pictures lie one above the other: where their place is upright. On a phone the screen decides, so that
/// the sheet of controls does not turn them.
pub fn is_stacked(ui: &Ui, narrow: bool) -> bool {
    let place = if narrow { ui.ctx().content_rect() } else { ui.max_rect() };
    place.width() < place.height()
}

/// Pictures lower than this have no row for the words of the dots.
const LOW: f32 = 260.0;

/// Whether a picture has little room: on a phone, or where it is low.
pub fn is_tight(rect: Rect, narrow: bool) -> bool {
    narrow || rect.height() < LOW
}

/// The places of source and target: one above the other, or side by side.
pub fn divide(rect: Rect, stacked: bool) -> [Rect; 2] {
    if stacked {
        let y = rect.center().y.round();
        [Rect::from_min_max(rect.min, pos2(rect.right(), y)), Rect::from_min_max(pos2(rect.left(), y), rect.max)]
    } else {
        let x = rect.center().x.round();
        [Rect::from_min_max(rect.min, pos2(x, rect.bottom())), Rect::from_min_max(pos2(x, rect.top()), rect.max)]
    }
}

/// Free space around the picture. Where the pictures lie one above the other, there is none beside them: legend and
/// edit bar have theirs below. Where they lie side by side, the edit bar has it if the outline would reach there.
pub fn margins(app: &RiemapApp, ui: &Ui, side: Side, rect: Rect, narrow: bool, stacked: bool) -> Margins {
    let usual = if is_tight(rect, narrow) { PHONE_MARGINS } else { DESK_MARGINS };
    let above_legend = Margins { bottom: usual.bottom.max(legend_height(app, side, rect, narrow)), ..usual };
    let without_bar = if stacked { above_legend } else { usual };
    if app.editor.side() != Some(side) {
        return without_bar;
    }
    let with_bar = Margins { bottom: above_legend.bottom + editing::bar_room(ui, side), ..usual };
    let reaches = app.model.extent(side).is_none_or(|extent| free_below(rect, extent, without_bar) < with_bar.bottom);
    if stacked || reaches { with_bar } else { without_bar }
}

/// How much is free below an outline of this extent that is fitted into `rect`.
fn free_below(rect: Rect, (low, high): (DVec2, DVec2), margins: Margins) -> f32 {
    let free = vec2(rect.width() - 2.0 * margins.sides, rect.height() - margins.top - margins.bottom);
    let extent = high - low;
    let height = (f64::from(free.x) * extent.y / extent.x).min(f64::from(free.y)) as f32;
    margins.bottom + 0.5 * (free.y - height)
}

/// Where messages have place in a picture: from below the title to above the edit bar.
pub fn message_room(app: &RiemapApp, ui: &Ui, side: Side, title: f32) -> Rect {
    let rect = app.views[side as usize].rect;
    let below = if app.editor.side() == Some(side) { editing::bar_room(ui, side) } else { 0.0 };
    rect.with_min_y(title).with_max_y((rect.bottom() - below).max(title))
}

/// The room that the legend of the colours takes at the lower edge of a picture.
pub fn legend_height(app: &RiemapApp, side: Side, rect: Rect, narrow: bool) -> f32 {
    if side == LEGEND_SIDE && app.cells.scale().is_some() { legend::height(rect, is_tight(rect, narrow)) } else { 0.0 }
}
