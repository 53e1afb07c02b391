//! The controls that set the picture in motion.

use super::action::{Action, Actions};
use super::language::{tr, tr_with};
use super::model::Model;
use super::playing::{PERIODS, PlayAction, Player};
use super::widgets::{Segment, captioned_slider, group_heading, segmented_where};
use crate::family::Path;
use egui::{Event, Key, Ui};

/// What moves.
pub const PATHS: [Segment<Path>; 4] = [
    Segment {
        value: Path::SourcePoint,
        label: "x₁",
        tooltip: "The source's interior point goes around a circle that stays inside",
    },
    Segment {
        value: Path::TargetPoint,
        label: "x₂",
        tooltip: "The target's interior point goes around a circle that stays inside",
    },
    Segment {
        value: Path::Boundary,
        label: "y₁",
        tooltip: "The source's boundary point turns once; equal times are equal harmonic measures: the disk turns evenly",
    },
    Segment {
        value: Path::All,
        label: "All",
        tooltip: "All of them at once, through all maps of one domain onto the other",
    },
];

/// What cannot be moved along a circle.
pub const NO_PLANE: &str = "The target is a surface: its point is dragged by hand";

/// What a click on the button does.
const PLAY_TOOLTIP: &str = "Let the points move along a loop, or stop them where they are (space)";

/// The group "Motion".
pub fn show(ui: &mut Ui, model: &Model, player: &Player, actions: &mut Actions) {
    group_heading(ui, tr("Motion"));
    let refused = |path| (path == Path::TargetPoint && model.surface().is_some()).then(|| String::from(tr(NO_PLANE)));
    if let Some(path) = segmented_where(ui, &PATHS, player.path(), refused) {
        actions.push(Action::Play(PlayAction::Along(path)));
    }
    let shown = tr_with("{0} s for a turn", &[&format!("{:.0}", player.period())]);
    if let Some(seconds) = captioned_slider(ui, tr("Speed"), &shown, player.period(), PERIODS, true) {
        actions.push(Action::Play(PlayAction::Period(seconds)));
    }
    let label = if player.is_playing() { tr("Stop here") } else { tr("Play") };
    let button = ui.add_enabled(player.is_playing() || model.is_ready(), egui::Button::new(label));
    if button.on_hover_text(tr(PLAY_TOOLTIP)).clicked() {
        actions.push(Action::Play(PlayAction::Toggle));
    }
}

/// The space bar plays and pauses, unless a control has the keyboard.
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
