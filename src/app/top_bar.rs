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
use super::room::{button_width, menu_label, text_width};
use super::theme::{Palette, ROW_HEIGHT};
use super::{figures_menu, file_menu, help_menu, shapes, theme, words};
use crate::conformal::Side;
use crate::session::Command;
use egui::{Align, FontId, Layout, RichText, Ui, vec2};

/// What opens the plots.
const PLOTS_TOOLTIP: &str = "Poisson kernel, harmonic measure and reparameterisation along the boundaries (P)";

/// What the bar shows where there is room; all of it is also in a menu or in the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extra {
    Wordmark,
    Figures,
    Image,
    Gallery,
    FullScreen,
}

impl Extra {
    /// What the bar of a desk has room for, the first ones first.
    const ALL: [Self; 5] = [Self::Wordmark, Self::Figures, Self::Image, Self::Gallery, Self::FullScreen];
    /// What that of a phone has.
    const NARROW: [Self; 1] = [Self::Wordmark];

    fn width(self, ui: &Ui) -> f32 {
        match self {
            Self::Wordmark => text_width(ui, WORDMARK, wordmark_font()) + WORDMARK_GAP + ui.spacing().item_spacing.x,
            Self::Figures => button_width(ui, &menu_label(tr("Figures"))),
            Self::Image => button_width(ui, tr("Image…")),
            Self::Gallery => button_width(ui, tr("Gallery")),
            Self::FullScreen => FULL_SCREEN_WIDTH + ui.spacing().item_spacing.x,
        }
    }

    /// Those that fit beside what the bar always shows.
    fn fitting(ui: &Ui, narrow: bool) -> Vec<Self> {
        let menus = ["File", "Source", "Target", "Help"].map(|label| button_width(ui, &menu_label(tr(label))));
        let buttons = ["Panels", "Plots"].map(|label| if narrow { 0.0 } else { button_width(ui, tr(label)) });
        let mut room = ui.available_width() - menus.iter().chain(&buttons).sum::<f32>();
        let fits = |extra: &&Self| {
            let width = extra.width(ui);
            let fits = width <= room;
            room -= if fits { width } else { 0.0 };
            fits
        };
        (if narrow { &Self::NARROW[..] } else { &Self::ALL }).iter().filter(fits).copied().collect()
    }
}

const WORDMARK: &str = "riemap";
/// Free space beside it.
const WORDMARK_GAP: f32 = 10.0;
const FULL_SCREEN_WIDTH: f32 = 34.0;

fn wordmark_font() -> FontId {
    theme::bold(18.0)
}

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
        let extras = Extra::fitting(ui, narrow);
        if extras.contains(&Extra::Wordmark) {
            ui.label(RichText::new(WORDMARK).font(wordmark_font()).color(palette.text))
                .on_hover_text(tr("The conformal map between two outlines, by matching harmonic measure"));
            ui.add_space(WORDMARK_GAP);
        }
        file_menu::menu_button(ui, keeper, actions);
        for side in Side::BOTH {
            guarded(ui, Control::Outline, |ui| shapes::menu_button(ui, words::side(side), side, model, actions));
        }
        if extras.contains(&Extra::Image) {
            guarded(ui, Control::Pattern, |ui| {
                if ui.button(tr("Image…")).on_hover_text(tr("A PNG or JPEG as the texture")).clicked() {
                    actions.push(Action::OpenImage);
                }
            });
        }
        if extras.contains(&Extra::Figures) {
            figures_menu::menu_button(ui, actions);
        }
        if extras.contains(&Extra::Gallery) && ui.button(tr("Gallery")).on_hover_text(tr("Maps worth seeing")).clicked()
        {
            actions.push(Action::Explore(ExploreAction::Gallery));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            help_menu::menu_button(ui, preferences, actions);
            if extras.contains(&Extra::FullScreen) {
                let button = full_screen_button(ui, vec2(FULL_SCREEN_WIDTH, ROW_HEIGHT), palette.text);
                if button.is_some_and(|button| button.clicked()) {
                    actions.push(Action::ToggleFullScreen);
                }
            }
            if !narrow {
                of_panels(ui, model, actions);
            }
        });
    });
}

/// What opens the panels and the plots: on a phone the sheet does.
fn of_panels(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let panels = guarded(ui, Control::Panels, |ui| ui.button(tr("Panels")).on_hover_text(tr(PANELS_TOOLTIP)));
    if panels.clicked() {
        actions.push(Action::TogglePanels);
    }
    let open = model.session().plots;
    let button = egui::Button::selectable(open, tr("Plots")).frame_when_inactive(true);
    if guarded(ui, Control::Plots, |ui| ui.add(button).on_hover_text(tr(PLOTS_TOOLTIP))).clicked() {
        actions.push(Action::Session(Command::SetPlots(!open)));
    }
}
