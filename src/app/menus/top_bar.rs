//! The top bar: name, file menu, outlines of both sides where the pictures have no room for them, undo and redo,
//! gallery, figures; at the right share, export, plots, panels, full screen, help.

use crate::app::input::action::{Action, Actions, ExploreAction, ExportAction, ShareAction};
use crate::app::input::locks::{Control, guarded};
use crate::app::input::preferences::Preferences;
use crate::app::input::presentation::full_screen_button;
use crate::app::language::words;
use crate::app::menus::{figures_menu, file_menu, help_menu};
use crate::app::panels::shapes;
use crate::app::theme;
use crate::app::theme::icons::{ICON_WIDTH, Icon, icon_button};
use crate::app::theme::text_metrics::{button_width, text_width};
use crate::app::theme::widgets::drop_down_width;
use crate::app::theme::{Palette, ROW_HEIGHT, control_height};
use crate::conformal::Side;
use crate::language::{Label, key, tr};
use crate::model::Model;
use crate::model::persistence::Persistence;
use crate::session::Command;
use egui::{Align, Button, FontId, Layout, Response, RichText, Ui, vec2};

/// The parts of the bar that are left out where there is no room; each is also in a menu.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Extra {
    Wordmark,
    Share,
    Export,
    Gallery,
    Figures,
    FullScreen,
}

impl Extra {
    /// The parts on a desktop, by decreasing priority.
    const ALL: [Self; 6] = [Self::Wordmark, Self::Share, Self::Export, Self::Gallery, Self::FullScreen, Self::Figures];
    /// The parts on a phone.
    const NARROW: [Self; 2] = [Self::Share, Self::Wordmark];

    fn width(self, ui: &Ui, narrow: bool) -> f32 {
        let gap = ui.spacing().item_spacing.x;
        match self {
            Self::Wordmark => text_width(ui, WORDMARK, wordmark_font()) + WORDMARK_GAP + gap,
            Self::Share if narrow => control_height(ui, ICON_WIDTH) + gap,
            Self::Share => button_width(ui, tr(key::share())),
            Self::Export => button_width(ui, tr(key::export())),
            Self::Gallery => button_width(ui, tr(key::gallery())),
            Self::Figures => drop_down_width(ui, tr(key::figures())),
            Self::FullScreen => FULL_SCREEN_WIDTH + gap,
        }
    }
}

const WORDMARK: &str = "riemap";
/// Free space right of the wordmark.
const WORDMARK_GAP: f32 = 10.0;
const FULL_SCREEN_WIDTH: f32 = 34.0;
/// The gap between buttons and the space inside of them on a phone, in points.
const PHONE_GAP: f32 = 4.0;
const PHONE_PADDING: f32 = 8.0;

fn wordmark_font() -> FontId {
    theme::bold(18.0)
}

/// What the bar shows.
#[derive(Clone, Copy)]
pub struct TopBar<'a> {
    pub model: &'a Model,
    pub persistence: &'a Persistence,
    /// Whether there is something to undo and to redo.
    pub can_step: [bool; 2],
    pub preferences: Preferences,
    /// Whether the layout is a phone's.
    pub narrow: bool,
    /// Whether the menus of both sides' shapes are in the bar, because the pictures have no room for them.
    pub has_shapes: bool,
}

impl TopBar<'_> {
    /// Shows the bar.
    pub fn show(self, ui: &mut Ui, actions: &mut Actions) {
        ui.horizontal_centered(|ui| {
            if self.narrow {
                ui.spacing_mut().item_spacing.x = PHONE_GAP;
                ui.spacing_mut().button_padding.x = PHONE_PADDING;
            }
            let extras = self.fitting(ui);
            if extras.contains(&Extra::Wordmark) {
                let ink = Palette::of(ui.visuals()).text;
                ui.label(RichText::new(WORDMARK).font(wordmark_font()).color(ink))
                    .on_hover_text(tr(key::riemap_tooltip()));
                ui.add_space(WORDMARK_GAP);
            }
            self.left(ui, &extras, actions);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| self.right(ui, &extras, actions));
        });
    }

    /// The parts that fit beside the permanent part of the bar, chosen by priority.
    fn fitting(self, ui: &Ui) -> Vec<Extra> {
        let shapes = [key::source_heading(), key::target_heading()];
        let menus = [key::file(), key::help()].into_iter().chain(shapes.into_iter().filter(|_| self.has_shapes));
        let menus: f32 = menus.map(|label| drop_down_width(ui, tr(label))).sum();
        let icons = 2.0 * (control_height(ui, ICON_WIDTH) + ui.spacing().item_spacing.x);
        let panels = [key::panels(), key::plots()].map(|label| button_width(ui, tr(label)));
        let panels: f32 = panels.into_iter().filter(|_| !self.narrow).sum();
        let mut room = ui.available_width() - menus - icons - panels;
        let fits = |extra: &&Extra| {
            let width = extra.width(ui, self.narrow);
            let fits = width <= room;
            room -= if fits { width } else { 0.0 };
            fits
        };
        (if self.narrow { &Extra::NARROW[..] } else { &Extra::ALL }).iter().filter(fits).copied().collect()
    }

    fn left(self, ui: &mut Ui, extras: &[Extra], actions: &mut Actions) {
        file_menu::menu_button(ui, self.persistence, self.can_step, actions);
        for side in Side::BOTH.into_iter().filter(|_| self.has_shapes) {
            guarded(ui, Control::Outline, |ui| shapes::menu_button(ui, words::side(side), side, self.model, actions));
        }
        let [can_undo, can_redo] = self.can_step;
        for (icon, enabled, name, tooltip, action) in [
            (Icon::Undo, can_undo, key::undo(), key::undo_tooltip(), Action::Undo),
            (Icon::Redo, can_redo, key::redo(), key::redo_tooltip(), Action::Redo),
        ] {
            if icon_button(ui, icon, enabled, tr(name), tr(tooltip)).clicked() {
                actions.push(action);
            }
        }
        if extras.contains(&Extra::Gallery)
            && ui.button(tr(key::gallery())).on_hover_text(tr(key::open_gallery_tooltip())).clicked()
        {
            actions.push(Action::Explore(ExploreAction::Gallery));
        }
        if extras.contains(&Extra::Figures) {
            figures_menu::menu_button(ui, actions);
        }
    }

    fn right(self, ui: &mut Ui, extras: &[Extra], actions: &mut Actions) {
        help_menu::menu_button(ui, self.preferences, actions);
        if extras.contains(&Extra::FullScreen) {
            let ink = Palette::of(ui.visuals()).text;
            let button = full_screen_button(ui, vec2(FULL_SCREEN_WIDTH, ROW_HEIGHT), ink);
            if button.is_some_and(|button| button.clicked()) {
                actions.push(Action::ToggleFullScreen);
            }
        }
        if !self.narrow {
            self.folds(ui, actions);
        }
        if extras.contains(&Extra::Export)
            && ui.button(tr(key::export())).on_hover_text(tr(key::export_tooltip())).clicked()
        {
            actions.push(Action::Export(ExportAction::Open));
        }
        if extras.contains(&Extra::Share) && self.share(ui).clicked() {
            actions.push(Action::Share(ShareAction::Open));
        }
    }

    fn share(self, ui: &mut Ui) -> Response {
        let (name, tooltip) = (tr(key::share()), tr(key::link_tooltip()));
        if self.narrow {
            return icon_button(ui, Icon::Share, true, name, tooltip);
        }
        ui.button(name).on_hover_text(tooltip)
    }

    /// The buttons that fold the column of controls and the plots; on a phone the sheet replaces them.
    fn folds(self, ui: &mut Ui, actions: &mut Actions) {
        let fold = |ui: &mut Ui, control: Control, button: Button<'_>, tooltip: Label| {
            guarded(ui, control, |ui| ui.add(button).on_hover_text(tr(tooltip))).clicked()
        };
        if fold(ui, Control::Panels, Button::new(tr(key::panels())), key::column_tooltip()) {
            actions.push(Action::ToggleColumn);
        }
        let open = self.model.session().plots();
        let plots = Button::selectable(open, tr(key::plots())).frame_when_inactive(true);
        if fold(ui, Control::Plots, plots, key::plots_tooltip()) {
            actions.push(Action::Session(Command::SetPlots(!open)));
        }
    }
}
