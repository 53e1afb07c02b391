//! The bar along the top: the name, outlines for both sides, the image, help.

use super::action::{Action, Actions};
use super::explore::ExploreAction;
use super::header::PANELS_TOOLTIP;
use super::keeping::Keeper;
use super::language::tr;
use super::locks::{Control, guarded};
use super::model::Model;
use super::preferences::Preferences;
use super::presentation::full_screen_button;
use super::theme::{Palette, ROW_HEIGHT};
use super::{figures_menu, file_menu, help_menu, shapes, theme, words};
use crate::conformal::Side;
use crate::session::Command;
use egui::{Align, Layout, RichText, Ui, vec2};

/// What opens the plots.
const PLOTS_TOOLTIP: &str = "Poisson kernel, harmonic measure and reparameterisation along the boundaries (P)";

/// A bar that is less wide has room for its buttons only.
const WORDMARK_FROM: f32 = 430.0;

/// Shows the bar.
pub fn show(
    ui: &mut Ui,
    model: &Model,
    keeper: &Keeper,
    preferences: Preferences,
    narrow: bool,
    actions: &mut Actions,
) {
    ui.horizontal_centered(|ui| {
        let palette = Palette::of(ui.visuals());
        if ui.available_width() >= WORDMARK_FROM {
            ui.label(RichText::new("riemap").font(theme::bold(18.0)).color(palette.text))
                .on_hover_text(tr("The conformal map between two outlines, by matching harmonic measure"));
            ui.add_space(if narrow { 2.0 } else { 10.0 });
        }
        file_menu::menu_button(ui, keeper, actions);
        for side in Side::BOTH {
            guarded(ui, Control::Outline, |ui| shapes::menu_button(ui, words::side(side), side, model, actions));
        }
        if !narrow {
            guarded(ui, Control::Pattern, |ui| {
                if ui.button(tr("Image…")).on_hover_text(tr("A PNG or JPEG as the texture")).clicked() {
                    actions.push(Action::OpenImage);
                }
            });
        }
        if !narrow {
            figures_menu::menu_button(ui, actions);
            if ui.button(tr("Gallery")).on_hover_text(tr("Maps worth seeing")).clicked() {
                actions.push(Action::Explore(ExploreAction::Gallery));
            }
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            help_menu::menu_button(ui, preferences, actions);
            let full = if narrow { None } else { full_screen_button(ui, vec2(34.0, ROW_HEIGHT), palette.text) };
            if full.is_some_and(|button| button.clicked()) {
                actions.push(Action::ToggleFullScreen);
            }
            if !narrow {
                let panels =
                    guarded(ui, Control::Panels, |ui| ui.button(tr("Panels")).on_hover_text(tr(PANELS_TOOLTIP)));
                if panels.clicked() {
                    actions.push(Action::TogglePanels);
                }
                let open = model.session().plots;
                let button = egui::Button::selectable(open, tr("Plots")).frame_when_inactive(true);
                if guarded(ui, Control::Plots, |ui| ui.add(button).on_hover_text(tr(PLOTS_TOOLTIP))).clicked() {
                    actions.push(Action::Session(Command::SetPlots(!open)));
                }
            }
        });
    });
}
