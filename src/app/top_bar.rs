//! The bar along the top: the name, outlines for both sides, the image, the theme.

use super::action::{Action, Actions};
use super::header::PANELS_TOOLTIP;
use super::keeping::Keeper;
use super::model::Model;
use super::theme::{Palette, ROW_HEIGHT};
use super::{figures_menu, file_menu, shapes, theme, words};
use crate::conformal::Side;
use crate::session::Command;
use egui::{Align, Layout, Response, RichText, Role, Shape, Stroke, Ui, WidgetInfo, vec2};

/// What opens the plots.
const PLOTS_TOOLTIP: &str = "Poisson kernel, harmonic measure and reparameterisation along the boundaries (P)";

/// A bar that is less wide has room for its buttons only.
const WORDMARK_FROM: f32 = 356.0;

/// Shows the bar.
pub fn show(ui: &mut Ui, model: &Model, keeper: &Keeper, narrow: bool, actions: &mut Actions) {
    ui.horizontal_centered(|ui| {
        let palette = Palette::of(ui.visuals());
        if ui.available_width() >= WORDMARK_FROM {
            ui.label(RichText::new("riemap").font(theme::bold(18.0)).color(palette.text))
                .on_hover_text("The conformal map between two outlines, by matching harmonic measure");
            ui.add_space(if narrow { 2.0 } else { 10.0 });
        }
        file_menu::menu_button(ui, keeper, actions);
        for side in Side::BOTH {
            shapes::menu_button(ui, words::side(side), side, model, actions);
        }
        if !narrow && ui.button("Image…").on_hover_text("A PNG or JPEG as the texture").clicked() {
            actions.push(Action::OpenImage);
        }
        if !narrow {
            figures_menu::menu_button(ui, actions);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if theme_button(ui).clicked() {
                actions.push(Action::ToggleTheme);
            }
            if !narrow && ui.button("Panels").on_hover_text(PANELS_TOOLTIP).clicked() {
                actions.push(Action::TogglePanels);
            }
            if !narrow {
                let open = model.session().plots;
                if ui
                    .add(egui::Button::selectable(open, "Plots").frame_when_inactive(true))
                    .on_hover_text(PLOTS_TOOLTIP)
                    .clicked()
                {
                    actions.push(Action::Session(Command::SetPlots(!open)));
                }
            }
        });
    });
}

/// A disc, half light and half dark.
fn theme_button(ui: &mut Ui) -> Response {
    let palette = Palette::of(ui.visuals());
    let tooltip = if ui.visuals().dark_mode { "Light theme" } else { "Dark theme" };
    let response = ui.add(egui::Button::new("").min_size(vec2(34.0, ROW_HEIGHT))).on_hover_text(tooltip);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, tooltip));
    let center = response.rect.center();
    let half = (0..=16).map(|k| {
        let angle = std::f32::consts::PI * (k as f32 / 16.0 - 0.5);
        center + 6.0 * vec2(angle.cos(), angle.sin())
    });
    ui.painter().add(Shape::convex_polygon(half.collect(), palette.text, Stroke::NONE));
    ui.painter().circle_stroke(center, 6.0, Stroke::new(1.5, palette.text));
    response
}
