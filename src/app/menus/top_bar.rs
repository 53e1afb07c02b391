//! The top bar: name, file menu, outlines of both sides, image, figures, gallery, panels, plots, full screen, help.

use crate::app::input::action::{Action, Actions, ExploreAction};
use crate::app::input::locks::{Control, guarded};
use crate::app::input::preferences::Preferences;
use crate::app::input::presentation::full_screen_button;
use crate::app::language::words;
use crate::app::menus::{figures_menu, file_menu, help_menu};
use crate::app::panels::header::PANELS_TOOLTIP;
use crate::app::panels::shapes;
use crate::app::theme;
use crate::app::theme::text_metrics::{button_width, menu_label, text_width};
use crate::app::theme::{Palette, ROW_HEIGHT};
use crate::conformal::Side;
use crate::language::{Label, key, tr};
use crate::model::Model;
use crate::model::persistence::Persistence;
use crate::session::Command;
use egui::{Align, FontId, Layout, RichText, Ui, vec2};

/// The tooltip of the button that opens and closes the plots.
const PLOTS_TOOLTIP: Label = key::plots_tooltip();

/// The parts of the bar that are left out where there is no room; each is also in a menu or in the panel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extra {
    Wordmark,
    Figures,
    Image,
    Gallery,
    FullScreen,
}

impl Extra {
    /// The parts on a desktop, by decreasing priority.
    const ALL: [Self; 5] = [Self::Wordmark, Self::Figures, Self::Image, Self::Gallery, Self::FullScreen];
    /// The parts on a phone.
    const NARROW: [Self; 1] = [Self::Wordmark];

    fn width(self, ui: &Ui) -> f32 {
        match self {
            Self::Wordmark => text_width(ui, WORDMARK, wordmark_font()) + WORDMARK_GAP + ui.spacing().item_spacing.x,
            Self::Figures => button_width(ui, &menu_label(tr(key::figures()))),
            Self::Image => button_width(ui, tr(key::choose_image())),
            Self::Gallery => button_width(ui, tr(key::gallery())),
            Self::FullScreen => FULL_SCREEN_WIDTH + ui.spacing().item_spacing.x,
        }
    }

    /// The parts that fit beside the permanent part of the bar, chosen by priority.
    fn fitting(ui: &Ui, narrow: bool) -> Vec<Self> {
        let menus = [key::file(), key::source_heading(), key::target_heading(), key::help()]
            .map(|label| button_width(ui, &menu_label(tr(label))));
        let buttons = [key::panels(), key::plots()].map(|label| if narrow { 0.0 } else { button_width(ui, tr(label)) });
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
/// Free space right of the wordmark.
const WORDMARK_GAP: f32 = 10.0;
const FULL_SCREEN_WIDTH: f32 = 34.0;

fn wordmark_font() -> FontId {
    theme::bold(18.0)
}

/// Shows the bar.
pub fn show(
    ui: &mut Ui,
    model: &Model,
    persistence: &Persistence,
    preferences: Preferences,
    narrow: bool,
    actions: &mut Actions,
) {
    ui.horizontal_centered(|ui| {
        let palette = Palette::of(ui.visuals());
        let extras = Extra::fitting(ui, narrow);
        if extras.contains(&Extra::Wordmark) {
            ui.label(RichText::new(WORDMARK).font(wordmark_font()).color(palette.text))
                .on_hover_text(tr(key::riemap_tooltip()));
            ui.add_space(WORDMARK_GAP);
        }
        file_menu::menu_button(ui, persistence, actions);
        for side in Side::BOTH {
            guarded(ui, Control::Outline, |ui| shapes::menu_button(ui, words::side(side), side, model, actions));
        }
        if extras.contains(&Extra::Image) {
            guarded(ui, Control::Pattern, |ui| {
                if ui.button(tr(key::choose_image())).on_hover_text(tr(key::choose_image_tooltip())).clicked() {
                    actions.push(Action::OpenImage);
                }
            });
        }
        if extras.contains(&Extra::Figures) {
            figures_menu::menu_button(ui, actions);
        }
        if extras.contains(&Extra::Gallery)
            && ui.button(tr(key::gallery())).on_hover_text(tr(key::open_gallery_tooltip())).clicked()
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

/// The buttons of the panels and the plots; on a phone the sheet replaces them.
fn of_panels(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    let panels = guarded(ui, Control::Panels, |ui| ui.button(tr(key::panels())).on_hover_text(tr(PANELS_TOOLTIP)));
    if panels.clicked() {
        actions.push(Action::TogglePanels);
    }
    let open = model.session().plots();
    let button = egui::Button::selectable(open, tr(key::plots())).frame_when_inactive(true);
    if guarded(ui, Control::Plots, |ui| ui.add(button).on_hover_text(tr(PLOTS_TOOLTIP))).clicked() {
        actions.push(Action::Session(Command::SetPlots(!open)));
    }
}
