//! The file menu: undo, redo, new, open, save, link, lesson, map projection, export, full screen, presentation; and its shortcuts.

use crate::app::input::action::{Action, Actions, ExportAction, LessonAction, ProjectionAction, ShareAction};
use crate::app::input::locks::menu_entry;
use crate::app::input::presentation;
use crate::app::theme::text_metrics::{BELOW_BAR, scroll_beyond};
use crate::app::theme::widgets::drop_down;
use crate::app::theme::{FINGER_HEIGHT, suits_fingers};
use crate::language::{Label, key, say, tr};
use crate::model::persistence::Persistence;
use crate::model::persistence::visits::Visits;
use crate::platform;
use egui::{Context, Event, Frame, Key, KeyboardShortcut, Margin, Modifiers, PopupCloseBehavior, Ui};
use web_time::SystemTime;

const UNDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Z);
const REDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
const REDO_TOO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Y);
const SAVE: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::S);

const FULL_SCREEN: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::F);
const EXPORT: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::E);

/// The width that is kept free for the scroll bar, which would lie over the keys, in points.
const SCROLL_BAR: i8 = 8;

/// The kept sessions that are listed: more would not fit under the other entries.
const MOST_RECENT: usize = 4;

const LINK_TOOLTIP: Label = key::link_tooltip();

const EXPORT_TOOLTIP: Label = key::export_tooltip();

/// A button that opens the menu.
pub fn menu_button(ui: &mut Ui, persistence: &Persistence, can_step: [bool; 2], actions: &mut Actions) {
    drop_down(ui, tr(key::file()), PopupCloseBehavior::CloseOnClick, |ui| {
        ui.set_width(190.0 + f32::from(SCROLL_BAR));
        let beside_bar = Frame::new().inner_margin(Margin { right: SCROLL_BAR, ..Margin::ZERO });
        scroll_beyond(ui, BELOW_BAR, |ui| beside_bar.show(ui, |ui| content(ui, persistence, can_step, actions)));
    });
}

fn content(ui: &mut Ui, persistence: &Persistence, can_step: [bool; 2], actions: &mut Actions) {
    for (entry, enabled, action) in entries(can_step, ui.ctx()) {
        let shortcut = entry.shortcut.filter(|_| !suits_fingers(ui));
        let shortcut = shortcut.map(|shortcut| ui.ctx().format_shortcut(&shortcut)).unwrap_or_default();
        let button =
            egui::Button::new(tr(entry.label)).shortcut_text(shortcut).min_size(egui::vec2(190.0, FINGER_HEIGHT));
        if menu_entry(ui, enabled, button, entry.tooltip, &action) {
            actions.push(action);
            ui.close();
        }
    }
    recent(ui, &persistence.visits, actions);
}

/// The sessions that were opened before and are kept, each with its age.
fn recent(ui: &mut Ui, visits: &Visits, actions: &mut Actions) {
    for (k, listed) in visits.others().take(MOST_RECENT).enumerate() {
        if k == 0 {
            ui.separator();
            ui.label(egui::RichText::new(tr(key::recent_sessions())).small());
        }
        let button = egui::Button::new(listed.title.as_str())
            .shortcut_text(age(listed.at_ms))
            .truncate()
            .min_size(egui::vec2(190.0, FINGER_HEIGHT));
        let action = Action::OpenKept(listed.id.clone());
        if menu_entry(ui, true, button, key::recent_tooltip(), &action) {
            actions.push(action);
            ui.close();
        }
    }
}

/// How long ago a time in ms since 1970 is.
fn age(at_ms: f64) -> String {
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    let minutes = ((now.as_secs_f64() - at_ms / 1000.0) / 60.0).max(0.0) as u32;
    say(&match minutes {
        0..60 => key::age_minutes(minutes),
        60..1440 => key::age_hours(minutes / 60),
        _ => key::age_days(minutes / 1440),
    })
}

struct Entry {
    label: Label,
    tooltip: Label,
    shortcut: Option<KeyboardShortcut>,
}

fn entries([can_undo, can_redo]: [bool; 2], context: &Context) -> Vec<(Entry, bool, Action)> {
    let entry = |label, tooltip, shortcut| Entry { label, tooltip, shortcut };
    let mut entries = vec![
        (entry(key::undo(), key::undo_tooltip(), Some(UNDO)), can_undo, Action::Undo),
        (entry(key::redo(), key::redo_tooltip(), Some(REDO)), can_redo, Action::Redo),
        (entry(key::new_session(), key::new_session_tooltip(), None), true, Action::New),
        (entry(key::open(), key::open_session_tooltip(), None), true, Action::OpenSession),
        (entry(key::save_session(), key::save_session_tooltip(), Some(SAVE)), true, Action::SaveSession),
        (entry(key::share_link(), LINK_TOOLTIP, None), true, Action::Share(ShareAction::Open)),
        (entry(key::make_lesson(), key::make_lesson_tooltip(), None), true, Action::Lesson(LessonAction::Open)),
        (
            entry(key::map_projection(), key::map_projection_tooltip(), None),
            true,
            Action::Projection(ProjectionAction::Open),
        ),
        (entry(key::open_export(), EXPORT_TOOLTIP, Some(EXPORT)), true, Action::Export(ExportAction::Open)),
    ];
    if platform::has_full_screen() {
        let full = entry(key::full_screen(), presentation::FULL_SCREEN_TOOLTIP, Some(FULL_SCREEN));
        entries.push((full, true, Action::ToggleFullScreen));
    }
    let size = if presentation::is_large(context) { key::desk_size() } else { key::presentation_size() };
    entries.push((entry(size, presentation::PRESENTATION_TOOLTIP, None), true, Action::TogglePresentation));
    entries
}

/// Turns the menu's shortcuts into actions, unless a text field has the focus.
pub fn keys(ui: &Ui, actions: &mut Actions) {
    if ui.ctx().text_edit_focused() {
        return;
    }
    ui.input_mut(|input| {
        // the longer shortcut first: its keys would match the shorter one too
        for (shortcut, action) in [
            (REDO, Action::Redo),
            (UNDO, Action::Undo),
            (REDO_TOO, Action::Redo),
            (SAVE, Action::SaveSession),
            (EXPORT, Action::Export(ExportAction::Open)),
        ] {
            if input.consume_shortcut(&shortcut) {
                actions.push(action);
            }
        }
        // drops the remaining events of these keys, such as their releases: nothing else may react to them
        let is_ours =
            |event: &Event| matches!(event, Event::Key { key: Key::S | Key::E, modifiers, .. } if modifiers.command);
        input.events.retain(|event| !is_ours(event));
    });
}
