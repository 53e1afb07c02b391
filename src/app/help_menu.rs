//! The menu of what helps: gallery, figures, tour, keys; and what the app looks like and speaks.

use super::action::{Action, Actions};
use super::explore::ExploreAction;
use super::language::{Language, tr};
use super::locks::{Control, guarded, menu_entry};
use super::preferences::{Appearance, Preferences};
use super::room::{BELOW_BAR, menu_label, scroll_beyond};
use super::theme::{FINGER_HEIGHT, Palette};
use super::widgets::{Segment, chevron, segmented};
use egui::containers::menu::{MenuButton, MenuConfig};
use egui::{PopupCloseBehavior, Role, Ui, WidgetInfo, vec2};

const WIDTH: f32 = 230.0;

const APPEARANCES: [Segment<Appearance>; 3] = [
    Segment { value: Appearance::System, label: "System", tooltip: "Light or dark, as the system is" },
    Segment { value: Appearance::Light, label: "Light", tooltip: "Dark ink on a light ground" },
    Segment { value: Appearance::Dark, label: "Dark", tooltip: "Light ink on a dark ground" },
];

/// A button that opens the menu.
pub fn menu_button(ui: &mut Ui, preferences: Preferences, actions: &mut Actions) {
    let button = egui::Button::new(menu_label(tr("Help")));
    let stays_open = MenuConfig::new().close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    let (response, _) = MenuButton::from_button(button).config(stays_open).ui(ui, |ui| {
        ui.set_width(WIDTH);
        scroll_beyond(ui, BELOW_BAR, |ui| content(ui, preferences, actions));
    });
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr("Help")));
    chevron(ui, response.rect, false);
}

fn content(ui: &mut Ui, preferences: Preferences, actions: &mut Actions) {
    for (label, tooltip, action) in entries() {
        let button = egui::Button::new(tr(label)).min_size(vec2(WIDTH, FINGER_HEIGHT));
        let action = Action::Explore(action);
        if menu_entry(ui, true, button, tooltip, &action) {
            actions.push(action);
            ui.close();
        }
    }
    ui.separator();
    guarded(ui, Control::Theme, |ui| choices(ui, preferences, actions));
}

fn entries() -> [(&'static str, &'static str, ExploreAction); 4] {
    [
        ("Gallery…", "Maps worth seeing", ExploreAction::Gallery),
        ("The paper's figures…", "Its figures and tables, made anew", ExploreAction::Figures),
        ("Guided tour", "Six pictures: what a conformal map is, and what it is held by", ExploreAction::Tour(0)),
        ("Keys and gestures…", "What keys, mouse and fingers do", ExploreAction::Shortcuts),
    ]
}

fn choices(ui: &mut Ui, old: Preferences, actions: &mut Actions) {
    let weak = Palette::of(ui.visuals()).weak;
    ui.colored_label(weak, tr("Language"));
    let [english, german] =
        Language::ALL.map(|value| Segment { value: Some(value), label: value.name(), tooltip: value.name() });
    let system = Segment { value: None, label: "System", tooltip: "The language of the system, if it is one of these" };
    if let Some(language) = segmented(ui, &[system, english, german], old.language) {
        actions.push(Action::Prefer(Preferences { language, ..old }));
    }
    ui.add_space(4.0);
    ui.colored_label(weak, tr("Theme"));
    if let Some(appearance) = segmented(ui, &APPEARANCES, old.appearance) {
        actions.push(Action::Prefer(Preferences { appearance, ..old }));
    }
}
