//! How the app is shown: in a frame, on the whole screen, large for a room, in the theme that the address asks for.

use super::RiemapApp;
use super::action::{Action, Actions};
use super::address_options::AddressOptions;
use super::language::tr;
use super::locks::{Control, Locks};
use super::preferences::Preferences;
use crate::platform;
use egui::{Context, Event, Key, Response, Role, Stroke, Ui, WidgetInfo, vec2};

/// How much larger everything is in a presentation, dots and strokes too.
const PRESENTATION_ZOOM: f32 = 1.5;

/// What the button says.
pub const FULL_SCREEN_TOOLTIP: &str = "The whole screen, or a window again (F)";
/// What the menu says.
pub const PRESENTATION_TOOLTIP: &str = "Text, controls, dots and lines half as large again, to be read from afar";

/// Begins as the address asks for, and beyond that as the person has chosen for this device.
pub fn install(context: &Context, chosen: Preferences, options: &AddressOptions) -> Preferences {
    options.locks.install(context);
    if options.present {
        context.set_zoom_factor(PRESENTATION_ZOOM);
    }
    let preferences = chosen.with(options);
    preferences.apply(context);
    preferences
}

/// The first message, and what is wrong with the address.
pub fn with_troubles(message: Option<String>, options: &AddressOptions) -> Option<String> {
    let all: Vec<String> = message.into_iter().chain(options.troubles.iter().cloned()).collect();
    (!all.is_empty()).then(|| all.join(" "))
}

/// Whether everything is larger.
pub fn is_large(context: &Context) -> bool {
    context.zoom_factor() >= PRESENTATION_ZOOM
}

/// Goes to the presentation's size and back.
pub fn toggle(context: &Context) {
    context.set_zoom_factor(if is_large(context) { 1.0 } else { PRESENTATION_ZOOM });
}

/// F is for the whole screen, unless a control has the keyboard.
pub fn keys(ui: &Ui, actions: &mut Actions) {
    let is_f = |event: &Event| {
        let Event::Key { key, pressed, repeat, modifiers, .. } = event else { return false };
        *key == Key::F && *pressed && !*repeat && !modifiers.any()
    };
    let free = ui.memory(|memory| memory.focused().is_none());
    if free && platform::has_full_screen() && ui.input(|input| input.events.iter().any(is_f)) {
        actions.push(Action::ToggleFullScreen);
    }
}

/// Four corners; nothing where the system has no full screen.
pub fn full_screen_button(ui: &mut Ui, size: egui::Vec2, ink: egui::Color32) -> Option<Response> {
    if !platform::has_full_screen() {
        return None;
    }
    let response = ui.add(egui::Button::new("").min_size(size)).on_hover_text(tr(FULL_SCREEN_TOOLTIP));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr("Full screen")));
    let (half, arm, stroke) = (5.5, 3.5, Stroke::new(1.5, ink));
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        let corner = response.rect.center() + half * vec2(x, y);
        ui.painter().line(vec![corner - vec2(arm * x, 0.0), corner, corner - vec2(0.0, arm * y)], stroke);
    }
    Some(response)
}

/// What to do when nothing can be drawn any more.
pub fn graphics_lost(reason: &str) -> String {
    format!("The graphics device was lost ({reason}). Start riemap again: the map is kept.")
}

impl RiemapApp {
    /// Folds the panels away or brings them back; a page around the app has none.
    pub(super) fn fold_panels(&mut self, context: &Context) {
        let locked = Locks::of(context).holds(Control::Panels);
        self.panels_open = if locked { self.panels_open } else { !self.panels_open && !self.options.embed };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_address_decides_size_theme_and_locks() {
        let context = Context::default();
        let options = AddressOptions::parse([("present", ""), ("theme", "light"), ("lock", "view")]);
        let preferences = install(&context, Preferences::fixed(), &options);
        assert_eq!(preferences.language, Preferences::fixed().language);
        context.run_ui(egui::RawInput::default(), |_| {}).textures_delta.clear();
        assert!(is_large(&context) && context.theme() == egui::Theme::Light);
        assert!(Locks::of(&context).holds(Control::View) && !Locks::of(&context).holds(Control::Pattern));
    }

    #[test]
    fn a_presentation_can_be_left_again() {
        let context = Context::default();
        for expected in [true, false] {
            toggle(&context);
            context.run_ui(egui::RawInput::default(), |_| {}).textures_delta.clear();
            assert_eq!(is_large(&context), expected);
        }
    }

    #[test]
    fn troubles_of_the_address_follow_the_first_message() {
        let options = AddressOptions::parse([("theme", "blue")]);
        let text = with_troubles(Some(String::from("First.")), &options).unwrap_or_default();
        assert!(text.starts_with("First. The address says \"theme=blue\""), "{text}");
        assert_eq!(with_troubles(None, &AddressOptions::default()), None);
    }
}
