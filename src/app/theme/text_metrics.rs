//! How much room there is: how wide texts and buttons are, how high lists may be.

use egui::{Color32, FontId, ScrollArea, TextStyle, Ui};

/// The least height of a list that scrolls: two rows for a finger.
const LEAST_LIST: f32 = 90.0;

/// What of the screen's height a menu of the bar along the top leaves: the bar above it, a margin below.
pub const BELOW_BAR: f32 = 80.0;

/// A list in a window or a menu, as high as the screen allows besides what else stands above and below it (`besides`,
/// in points); what is longer scrolls.
pub fn scroll_beyond<R>(ui: &mut Ui, besides: f32, content: impl FnOnce(&mut Ui) -> R) -> R {
    let height = (ui.ctx().content_rect().height() - besides).max(LEAST_LIST);
    // without a least height egui ends what scrolls in a window or a menu after 400 points
    ScrollArea::vertical().max_height(height).min_scrolled_height(height).show(ui, content).inner
}

/// How wide a line of text is.
pub fn text_width(ui: &Ui, text: &str, font: FontId) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER).size().x
}

/// What a button with this text takes of a row, the gap beside it included.
pub fn button_width(ui: &Ui, text: &str) -> f32 {
    let spacing = ui.spacing();
    let text = text_width(ui, text, TextStyle::Button.resolve(ui.style()));
    text + 2.0 * spacing.button_padding.x + spacing.item_spacing.x
}

/// What is written on a button that opens a menu: spaces make room for the [chevron](crate::app::theme::widgets::chevron).
pub fn menu_label(label: &str) -> String {
    format!("{label}     ")
}
