//! How the two pictures share their place, and what of each is left free for words, legend and edit bar.

use super::view::{DESK_MARGINS, Margins, PHONE_MARGINS};
use super::{RiemapApp, editing, legend};
use crate::conformal::Side;
use egui::{Rect, pos2};

/// The viewport that has the legend of the colours.
pub const LEGEND_SIDE: Side = Side::Target;

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
/// edit bar have theirs below.
pub fn margins(app: &RiemapApp, side: Side, rect: Rect, narrow: bool, stacked: bool) -> Margins {
    let margins = if narrow { PHONE_MARGINS } else { DESK_MARGINS };
    if !stacked {
        return margins;
    }
    let bar = if app.editor.side() == Some(side) { editing::ROOM } else { 0.0 };
    Margins { bottom: margins.bottom.max(legend_height(app, side, rect, narrow)) + bar, ..margins }
}

/// The room that the legend of the colours takes at the lower edge of a picture.
pub fn legend_height(app: &RiemapApp, side: Side, rect: Rect, narrow: bool) -> f32 {
    if side == LEGEND_SIDE && app.cells.scale().is_some() { legend::height(rect, narrow) } else { 0.0 }
}
