//! Fields of numbers, which are dragged or typed: the one place that knows how people write decimals.
//!
//! Shown with the decimal mark of the current language; typed with a point or a comma in every language, so that a
//! number pad and a number copied from elsewhere work. Text that is no finite number leaves the value as it was.

use crate::language::decimal;
use egui::emath::{self, Numeric};
use egui::{DragValue, Response, WidgetInfo};

/// A field of the number; the caller sets range, speed, decimals and units.
pub fn number_field<N: Numeric>(value: &mut N) -> DragValue<'_> {
    DragValue::new(value)
        .custom_formatter(|value, decimals| decimal(&emath::format_with_decimals_in_range(value, decimals)))
        .custom_parser(typed)
}

/// Tells a screen reader the name of a field: egui's fields tell their numbers alone.
pub fn spoken(response: Response, name: &str, value: f64) -> Response {
    response.widget_info(|| WidgetInfo::slider(true, value, name));
    response
}

/// The number that a text means. Spaces are left out and the minus sign may be a dash, as in egui's own fields.
fn typed(text: &str) -> Option<f64> {
    let plain = |letter: char| match letter {
        '−' => '-',
        ',' => '.',
        other => other,
    };
    let text: String = text.chars().filter(|letter| !letter.is_whitespace()).map(plain).collect();
    text.parse().ok().filter(|number: &f64| number.is_finite())
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "parsed numbers are exact")]
mod tests {
    use super::*;
    use crate::app::theme;
    use crate::language::{self, Language};
    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable;

    /// What the field shows, and the number after a text was typed into it.
    fn shown_then_typed(language: Language, text: &str) -> (Option<String>, f64) {
        language::set(language);
        let field = |ui: &mut egui::Ui, value: &mut f64| {
            let name = ui.label("a number");
            ui.add(number_field(value).range(-2.0..=2.0).max_decimals(3)).labelled_by(name.id);
        };
        let mut harness = Harness::builder().with_context_setup(theme::install).build_ui_state(field, 1.25);
        let shown = harness.get_by_role(egui::accesskit::Role::SpinButton).value();
        harness.get_by_role(egui::accesskit::Role::SpinButton).click();
        harness.run();
        harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
        harness.event(egui::Event::Text(text.to_owned()));
        harness.run();
        harness.key_press(egui::Key::Enter);
        harness.run();
        (shown, *harness.state())
    }

    #[test]
    fn decimals_are_shown_with_the_mark_of_the_language_and_taken_with_either() {
        for (language, shown) in [(Language::German, "1,25"), (Language::English, "1.25")] {
            for (text, number) in [("0,5", 0.5), ("0.5", 0.5), ("−1,75", -1.75), ("3,5", 2.0), ("0,5,5", 1.25)] {
                assert_eq!(shown_then_typed(language, text), (Some(shown.to_owned()), number), "{language:?} {text}");
            }
        }
    }

    #[test]
    fn what_is_no_finite_number_is_refused() {
        for text in ["", ",", "1.000,5", "1,2.3", "nan", "inf", "1e999", "a half"] {
            assert_eq!(typed(text), None, "{text:?}");
        }
        assert_eq!(typed(" 1 000,5 "), Some(1000.5));
        assert_eq!(typed("1,5e-3"), Some(1.5e-3));
    }
}
