//! The help menu: gallery, figures, tour, list of keys; theme and language.

use crate::app::input::action::{Action, Actions, ExploreAction};
use crate::app::input::locks::{Control, guarded, menu_entry};
use crate::app::input::preferences::{Appearance, Preferences};
use crate::app::theme::text_metrics::{BELOW_BAR, scroll_beyond};
use crate::app::theme::widgets::{Segment, drop_down, segmented};
use crate::app::theme::{FINGER_HEIGHT, Palette};
use crate::language::{Label, Language, key, tr};
use egui::{PopupCloseBehavior, Ui, vec2};

const WIDTH: f32 = 230.0;

const APPEARANCES: [Segment<Appearance>; 3] = [
    Segment { value: Appearance::System, label: key::system(), tooltip: key::system_tooltip() },
    Segment { value: Appearance::Light, label: key::light(), tooltip: key::light_tooltip() },
    Segment { value: Appearance::Dark, label: key::dark(), tooltip: key::dark_tooltip() },
];

/// A button that opens the menu.
pub fn menu_button(ui: &mut Ui, preferences: Preferences, actions: &mut Actions) {
    drop_down(ui, tr(key::help()), PopupCloseBehavior::CloseOnClickOutside, |ui| {
        ui.set_width(WIDTH);
        scroll_beyond(ui, BELOW_BAR, |ui| content(ui, preferences, actions));
    });
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

fn entries() -> [(Label, Label, ExploreAction); 4] {
    [
        (key::open_gallery(), key::open_gallery_tooltip(), ExploreAction::Gallery),
        (key::open_paper_figures(), key::open_paper_figures_tooltip(), ExploreAction::Figures),
        (key::guided_tour(), key::guided_tour_tooltip(), ExploreAction::Tour(0)),
        (key::open_keys_and_gestures(), key::open_keys_and_gestures_tooltip(), ExploreAction::Shortcuts),
    ]
}

fn choices(ui: &mut Ui, old: Preferences, actions: &mut Actions) {
    let weak = Palette::of(ui.visuals()).weak;
    ui.colored_label(weak, tr(key::language()));
    let [english, german] =
        Language::ALL.map(|value| Segment { value: Some(value), label: value.own_name(), tooltip: value.own_name() });
    let system = Segment { value: None, label: key::system(), tooltip: key::system_language_tooltip() };
    if let Some(language) = segmented(ui, &[system, english, german], old.language) {
        actions.push(Action::Prefer(Preferences { language, ..old }));
    }
    ui.add_space(4.0);
    ui.colored_label(weak, tr(key::theme()));
    if let Some(appearance) = segmented(ui, &APPEARANCES, old.appearance) {
        actions.push(Action::Prefer(Preferences { appearance, ..old }));
    }
}
