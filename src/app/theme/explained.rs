//! Explanations of terms in plain words: as a tooltip under a mouse, and as a popup after a click, a tap, or Space.

use crate::app::theme::{Palette, bold, control_height};
use crate::language::{Label as Words, tr};
use egui::{Align, Button, CornerRadius, Layout, Popup, Response, RichText, Role, Ui, Vec2, WidgetInfo};

/// The size of a button "?" for a mouse, in points.
const QUESTION: f32 = 20.0;
/// The width of a popup's words: lines that are easy to read, and narrower than a phone.
const WORDS: f32 = 280.0;

/// The heading of a group of controls, in small capitals.
pub fn group_heading(ui: &mut Ui, text: &str) {
    ui.add_space(6.0);
    heading(ui, text);
}

/// A [`group_heading`] with a button "?" at its right end, which explains the term.
pub fn explained_heading(ui: &mut Ui, text: &str, explanation: Words) {
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().interact_size.y = control_height(ui, QUESTION);
        heading(ui, text);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| question(ui, text, explanation));
    });
}

fn heading(ui: &mut Ui, text: &str) {
    let weak = Palette::of(ui.visuals()).weak;
    ui.label(RichText::new(text.to_uppercase()).font(bold(11.0)).color(weak).extra_letter_spacing(0.8));
}

/// A round button "?" that explains a term; those who hear the screen hear the explanation with the button.
fn question(ui: &mut Ui, term: &str, explanation: Words) {
    let side = control_height(ui, QUESTION);
    let sign = RichText::new("?").small().color(Palette::of(ui.visuals()).weak);
    let round = CornerRadius::same((0.5 * side) as u8);
    ui.spacing_mut().button_padding = Vec2::ZERO;
    let button = ui.add(Button::new(sign).min_size(Vec2::splat(side)).corner_radius(round));
    let words = tr(explanation);
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("? {term}: {words}")));
    explain(&button, words);
}

/// Shows the words under a hovering pointer, and in a popup after the widget is clicked, until the next click.
pub fn explain(response: &Response, words: &str) {
    // it opens and closes in `show`, which is therefore called in every frame
    let popup = Popup::from_toggle_button_response(response).show(|ui| {
        ui.set_max_width(WORDS);
        ui.label(words);
    });
    if popup.is_none() {
        response.clone().on_hover_text(words);
    }
}
