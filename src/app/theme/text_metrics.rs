//! Measures for layout: the width of texts and buttons, the height of scrolling lists.

use egui::{Color32, FontId, ScrollArea, TextStyle, Ui};

/// The least height of a scrolling list, in points: two rows of a touch screen.
const LEAST_LIST: f32 = 90.0;

/// The part of the screen's height that a menu of the top bar leaves free, in points: the bar above, a margin below.
pub const BELOW_BAR: f32 = 80.0;

/// Shows `content` in a window or a menu; it scrolls if it is higher than the screen less `besides`, the height in
/// points of everything above and below it.
pub fn scroll_beyond<R>(ui: &mut Ui, besides: f32, content: impl FnOnce(&mut Ui) -> R) -> R {
    let height = (ui.ctx().content_rect().height() - besides).max(LEAST_LIST);
    // without a least height egui limits a scroll area in a window or a menu to 400 points
    ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, content).inner
}

/// The width of a line of text, in points.
pub fn text_width(ui: &Ui, text: &str, font: FontId) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER).size().x
}

/// The width of a button with this text and of the gap beside it, in points.
pub fn button_width(ui: &Ui, text: &str) -> f32 {
    let spacing = ui.spacing();
    let text = text_width(ui, text, TextStyle::Button.resolve(ui.style()));
    text + 2.0 * spacing.button_padding.x + spacing.item_spacing.x
}

/// The text of a button that opens a menu, with spaces for the [chevron](crate::app::theme::widgets::chevron).
pub fn menu_label(label: &str) -> String {
    format!("{label}     ")
}
