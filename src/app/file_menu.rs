//! The menu of the session: new, open, save, link, undo, redo.

use super::action::{Action, Actions};
use super::keeping::Keeper;
use super::language::tr;
use super::locks::menu_entry;
use super::presentation;
use super::room::{BELOW_BAR, menu_label, scroll_beyond};
use super::theme::FINGER_HEIGHT;
use super::widgets::chevron;
use crate::platform;
use egui::containers::menu::MenuButton;
use egui::{Context, Event, Key, KeyboardShortcut, Modifiers, Role, Ui, WidgetInfo};

const UNDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Z);
const REDO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
const REDO_TOO: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::Y);
const SAVE: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::S);

const FULL_SCREEN: KeyboardShortcut = KeyboardShortcut::new(Modifiers::NONE, Key::F);
const EXPORT: KeyboardShortcut = KeyboardShortcut::new(Modifiers::COMMAND, Key::E);

const LINK_TOOLTIP: &str = "The address carries everything that is set: it opens the same picture in another browser";

const EXPORT_TOOLTIP: &str = "Pictures, animations, vector graphics, tables, meshes";

/// A button that opens the menu.
pub fn menu_button(ui: &mut Ui, keeper: &Keeper, actions: &mut Actions) {
    let (response, _) = MenuButton::from_button(egui::Button::new(menu_label(tr("File")))).ui(ui, |ui| {
        ui.set_width(190.0);
        scroll_beyond(ui, BELOW_BAR, |ui| content(ui, keeper, actions));
    });
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr("File")));
    chevron(ui, response.rect, false);
}

fn content(ui: &mut Ui, keeper: &Keeper, actions: &mut Actions) {
    for (entry, enabled, action) in entries(keeper, ui.ctx()) {
        let shortcut = entry.shortcut.map(|shortcut| ui.ctx().format_shortcut(&shortcut)).unwrap_or_default();
        let button =
            egui::Button::new(tr(entry.label)).shortcut_text(shortcut).min_size(egui::vec2(190.0, FINGER_HEIGHT));
        if menu_entry(ui, enabled, button, entry.tooltip, &action) {
            actions.push(action);
            ui.close();
        }
    }
}

struct Entry {
    label: &'static str,
    tooltip: &'static str,
    shortcut: Option<KeyboardShortcut>,
}

fn entries(keeper: &Keeper, context: &Context) -> Vec<(Entry, bool, Action)> {
    let entry = |label, tooltip, shortcut| Entry { label, tooltip, shortcut };
    let history = keeper.history();
    let mut entries = vec![
        (entry("Undo", "Take the last step back; a drag is one step", Some(UNDO)), history.can_undo(), Action::Undo),
        (entry("Redo", "Make it again", Some(REDO)), history.can_redo(), Action::Redo),
        (entry("New", "Begin with the first picture again; it can be undone", None), true, Action::New),
        (entry("Open…", "A session from a .riemap file", None), true, Action::OpenSession),
        (entry("Save…", "The session as a .riemap file", Some(SAVE)), true, Action::SaveSession),
        (entry("Copy link", LINK_TOOLTIP, None), true, Action::CopyLink),
        (entry("Export…", EXPORT_TOOLTIP, Some(EXPORT)), true, Action::OpenExport),
    ];
    if platform::has_full_screen() {
        let full = entry("Full screen", presentation::FULL_SCREEN_TOOLTIP, Some(FULL_SCREEN));
        entries.push((full, true, Action::ToggleFullScreen));
    }
    let size = if presentation::is_large(context) { "Desk size" } else { "Presentation size" };
    entries.push((entry(size, presentation::PRESENTATION_TOOLTIP, None), true, Action::TogglePresentation));
    entries
}

/// Turns the menu's keys into actions, unless a text is being written.
pub fn keys(ui: &Ui, actions: &mut Actions) {
    if ui.ctx().text_edit_focused() {
        return;
    }
    ui.input_mut(|input| {
        // the longer shortcut first: the shorter one would match it too
        for (shortcut, action) in [
            (REDO, Action::Redo),
            (UNDO, Action::Undo),
            (REDO_TOO, Action::Redo),
            (SAVE, Action::SaveSession),
            (EXPORT, Action::OpenExport),
        ] {
            if input.consume_shortcut(&shortcut) {
                actions.push(action);
            }
        }
        // a browser's own reaction to the keys is kept out
        let is_ours =
            |event: &Event| matches!(event, Event::Key { key: Key::S | Key::E, modifiers, .. } if modifiers.command);
        input.events.retain(|event| !is_ours(event));
    });
}
