//! The controls of the motion of the points: path, speed, start and stop.

use crate::app::input::action::{Action, Actions};
use crate::app::theme::explained::group_heading;
use crate::app::theme::widgets::{Segment, captioned_slider, segmented_where};
use crate::family::Path;
use crate::language::{Label, key, say, tr};
use crate::model::Model;
use crate::model::motion::{PERIODS, PlayAction, Player};
use egui::{Event, Key, Ui};

/// The paths: which points move.
pub const PATHS: [Segment<Path>; 4] = [
    Segment { value: Path::SourcePoint, label: key::x1(), tooltip: key::x1_tooltip() },
    Segment { value: Path::TargetPoint, label: key::x2(), tooltip: key::x2_tooltip() },
    Segment { value: Path::Boundary, label: key::y1(), tooltip: key::y1_tooltip() },
    Segment { value: Path::All, label: key::all(), tooltip: key::all_tooltip() },
];

/// The tooltip of the button that starts and stops.
const PLAY_TOOLTIP: Label = key::play_tooltip();

/// The group "Motion".
pub fn show(ui: &mut Ui, model: &Model, player: &Player, actions: &mut Actions) {
    group_heading(ui, tr(key::play()));
    let refused = |path| model.abilities().refused_path(path).map(|reason| String::from(tr(reason.label())));
    if let Some(path) = segmented_where(ui, &PATHS, player.path(), refused) {
        actions.push(Action::Play(PlayAction::Along(path)));
    }
    let shown = say(&key::seconds_for_turn(format!("{:.0}", player.period())));
    if let Some(seconds) = captioned_slider(ui, tr(key::speed()), &shown, player.period(), PERIODS, true) {
        actions.push(Action::Play(PlayAction::Period(seconds)));
    }
    let label = if player.is_playing() { tr(key::stop_here()) } else { tr(key::play()) };
    let button = ui.add_enabled(player.is_playing() || model.is_mapped(), egui::Button::new(label));
    if button.on_hover_text(tr(PLAY_TOOLTIP)).clicked() {
        actions.push(Action::Play(PlayAction::Toggle));
    }
}

/// The space bar starts and stops the motion, unless a control has the keyboard focus.
pub fn keys(ui: &Ui, actions: &mut Actions) {
    let is_space = |event: &Event| {
        let Event::Key { key, pressed, repeat, modifiers, .. } = event else { return false };
        *key == Key::Space && *pressed && !*repeat && !modifiers.any()
    };
    let free = ui.memory(|memory| memory.focused().is_none());
    if free && ui.input(|input| input.events.iter().any(is_space)) {
        actions.push(Action::Play(PlayAction::Toggle));
    }
}
