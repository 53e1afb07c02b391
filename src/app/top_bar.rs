//! The bar along the top: the name, outlines for both sides, the image, the theme.

use super::action::{Action, Actions};
use super::model::{Model, SIDES};
use super::theme::Palette;
use super::{shapes, theme, words};
use egui::{Align, Layout, RichText, Ui};

/// Shows the bar.
pub fn show(ui: &mut Ui, model: &Model, narrow: bool, actions: &mut Actions) {
    ui.horizontal_centered(|ui| {
        let palette = Palette::of(ui.visuals());
        ui.label(RichText::new("riemap").font(theme::bold(18.0)).color(palette.text))
            .on_hover_text("The conformal map between two outlines, by matching harmonic measure");
        ui.add_space(if narrow { 2.0 } else { 10.0 });
        for side in SIDES {
            shapes::menu_button(ui, words::side(side), side, &model.side(side).wanted().outline, actions);
        }
        if !narrow && ui.button("Image…").on_hover_text("A PNG or JPEG as the texture").clicked() {
            actions.push(Action::OpenImage);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let (icon, tooltip) = if ui.visuals().dark_mode { ("☀", "Light theme") } else { ("🌙", "Dark theme") };
            if ui.button(icon).on_hover_text(tooltip).clicked() {
                actions.push(Action::ToggleTheme);
            }
            if !narrow && ui.button("Panels").on_hover_text("Fold the panels away, or bring them back (Tab)").clicked()
            {
                actions.push(Action::TogglePanels);
            }
        });
    });
}
