//! Zoom for presentations, full screen, and the options of the page's URL at startup.

use crate::app::input::action::{Action, Actions};
use crate::app::input::address_options::AddressOptions;

use crate::app::input::preferences::Preferences;
use crate::language::{Label, Message, key, tr};
use crate::platform;
use egui::{Color32, Context, Event, Id, Key, LayerId, Order, Response, Role, Stroke, Ui, WidgetInfo, vec2};

/// The zoom factor of a presentation; it applies to dots and strokes too.
pub const PRESENTATION_ZOOM: f32 = 1.5;

/// The radius and the width of the ring around the pointer in a presentation, in points.
const POINTER_RING: (f32, f32) = (16.0, 3.0);

/// The ink of this ring: seen on both themes and on every pattern.
const RING_INK: Color32 = Color32::from_rgb(255, 214, 10);

/// The tooltip of the full-screen button.
pub const FULL_SCREEN_TOOLTIP: Label = key::full_screen_tooltip();
/// The tooltip of the menu entry that switches the zoom.
pub const PRESENTATION_TOOLTIP: Label = key::presentation_tooltip();

/// Applies locks, zoom and preferences at startup; the URL's options override the user's. Returns the preferences.
pub fn install(context: &Context, chosen: Preferences, options: &AddressOptions) -> Preferences {
    options.locks.install(context);
    if options.present {
        context.set_zoom_factor(PRESENTATION_ZOOM);
    }
    let preferences = chosen.with(options);
    preferences.apply(context);
    preferences
}

/// The message of the startup, followed by the errors in the page's URL.
pub fn with_user_errors(message: Option<Message>, options: &AddressOptions) -> Option<Message> {
    let all = message.into_iter().chain(options.user_errors.iter().cloned());
    Message::joined(all, key::both_sentences)
}

/// Whether the zoom is that of a presentation.
pub fn is_large(context: &Context) -> bool {
    context.zoom_factor() >= PRESENTATION_ZOOM
}

/// Switches between the presentation's zoom and zoom 1.
pub fn toggle(context: &Context) {
    context.set_zoom_factor(if is_large(context) { 1.0 } else { PRESENTATION_ZOOM });
}

/// Draws a ring around the pointer in a presentation, so that a class can follow it; fingers have none.
pub fn mark_pointer(context: &Context) {
    let place = context.input(|input| input.pointer.latest_pos().filter(|_| !input.any_touches()));
    let Some(place) = place.filter(|_| is_large(context)) else { return };
    let painter = context.layer_painter(LayerId::new(Order::Tooltip, Id::unique("pointer ring")));
    let (radius, width) = POINTER_RING;
    painter.circle_stroke(place, radius, Stroke::new(width + 2.0, Color32::from_black_alpha(90)));
    painter.circle_stroke(place, radius, Stroke::new(width, RING_INK));
}

/// F toggles full screen, unless a control has the keyboard focus.
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

/// Shows a button with four corners as its icon; `None` where the system has no full screen.
pub fn full_screen_button(ui: &mut Ui, size: egui::Vec2, ink: egui::Color32) -> Option<Response> {
    if !platform::has_full_screen() {
        return None;
    }
    let response = ui.add(egui::Button::new("").min_size(size)).on_hover_text(tr(FULL_SCREEN_TOOLTIP));
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, tr(key::full_screen())));
    let (half, arm, stroke) = (5.5, 3.5, Stroke::new(1.5, ink));
    for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        let corner = response.rect.center() + half * vec2(x, y);
        ui.painter().line(vec![corner - vec2(arm * x, 0.0), corner, corner - vec2(0.0, arm * y)], stroke);
    }
    Some(response)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::input::locks::{Control, Locks};

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
    fn errors_in_the_url_follow_the_first_message() {
        let options = AddressOptions::parse([("theme", "blue")]);
        let text = with_user_errors(Some("First.".into()), &options).map(|text| text.english()).unwrap_or_default();
        assert!(text.starts_with("First. The address says \"theme=blue\""), "{text}");
        assert_eq!(with_user_errors(None, &AddressOptions::default()), None);
    }
}
