//! How the two pictures divide their area, and the room in each for titles, messages, legend and edit bar.

use super::{RiemapApp, editing};
use crate::app::panels::{header, sign_legend};
use crate::app::viewport::legend;
use crate::app::viewport::view::{DESK_MARGINS, Margins, PHONE_MARGINS, free_below};
use crate::conformal::{PerSide, Side};
use crate::model::Model;
use egui::{Rect, Ui};

/// The side whose viewport shows the legend of the colors: between two surfaces the mapped one, which alone is colored.
pub fn legend_side(model: &Model) -> Side {
    let map = model.shown().filter(|map| map.is_through_disk);
    map.map_or(Side::Target, |map| map.mapped_side())
}

/// Below this height, pictures have no row for the legend of the dots.
const LOW: f32 = 260.0;

/// The layout of the screen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Arrangement {
    /// The phone layout: the controls are in a sheet.
    pub narrow: bool,
    /// Whether the pictures lie one above the other, or side by side.
    pub stacked: bool,
}

impl Arrangement {
    /// The layout for the area that is left before a message takes its part: neither a message nor the sheet of a
    /// phone changes the direction of the division.
    pub fn new(ui: &Ui, narrow: bool) -> Self {
        let place = if narrow { ui.ctx().content_rect() } else { ui.available_rect_before_wrap() };
        Self { narrow, stacked: place.width() < place.height() }
    }

    /// Whether a picture has little room: on a phone, or if its height is small.
    pub fn is_tight(self, rect: Rect) -> bool {
        self.narrow || rect.height() < LOW
    }

    /// The areas of source and target.
    pub fn divide(self, rect: Rect) -> PerSide<Rect> {
        if self.stacked {
            let y = rect.center().y.round();
            PerSide::new(rect.with_max_y(y), rect.with_min_y(y))
        } else {
            let x = rect.center().x.round();
            PerSide::new(rect.with_max_x(x), rect.with_min_x(x))
        }
    }

    /// Free space around the picture. In stacked pictures, and around surfaces, legend and edit bar have a margin of
    /// their own at the bottom. In pictures side by side, the edit bar has one only if the outline would reach into its
    /// area.
    pub fn margins(self, app: &RiemapApp, ui: &Ui, side: Side, rect: Rect) -> Margins {
        let usual = if self.is_tight(rect) { PHONE_MARGINS } else { DESK_MARGINS };
        let usual = Margins { top: usual.top.max(header::height_with_notes(ui, side, &app.model, rect)), ..usual };
        let above_legend = Margins { bottom: usual.bottom.max(self.legend_height(app, side, rect)), ..usual };
        if app.model.surface(side).is_some() {
            return above_legend;
        }
        let without_bar = if self.stacked { above_legend } else { usual };
        if app.editor.side() != Some(side) {
            return without_bar;
        }
        let with_bar = Margins { bottom: above_legend.bottom + editing::bar_height(ui, side), ..usual };
        let extent = app.model.extent(side);
        let reaches = extent.is_none_or(|extent| free_below(rect, extent, without_bar) < with_bar.bottom);
        if self.stacked || reaches { with_bar } else { without_bar }
    }

    /// The area whose lower edge carries the edit bar: above the legends of colors and dots.
    pub fn edit_area(self, app: &RiemapApp, side: Side, rect: Rect) -> Rect {
        let words = if self.is_tight(rect) { 0.0 } else { sign_legend::LEGEND_HEIGHT };
        rect.with_max_y(rect.bottom() - self.legend_height(app, side, rect).max(words))
    }

    /// The area for messages: between the title and the edit bar.
    pub fn message_area(self, app: &RiemapApp, ui: &Ui, side: Side, title: f32) -> Rect {
        let rect = app.pictures.views[side].rect;
        let low = if app.editor.side() == Some(side) {
            self.edit_area(app, side, rect).bottom() - editing::bar_height(ui, side)
        } else {
            rect.bottom()
        };
        rect.with_min_y(title).with_max_y(low.max(title))
    }

    /// The height of the legend of the colors at the lower edge of a picture; 0 without a legend.
    fn legend_height(self, app: &RiemapApp, side: Side, rect: Rect) -> f32 {
        let colors_triangles = side == legend_side(&app.model) && app.pictures.cells.scale().is_some();
        let has_outline = app.model.abilities().has_outline(Side::Source);
        // while it is computed anew, the picture stays where it is
        let colors_landscape = side == Side::Source && has_outline && app.model.best().asks_for_landscape();
        if colors_triangles || colors_landscape { legend::height(rect, self.is_tight(rect)) } else { 0.0 }
    }
}
