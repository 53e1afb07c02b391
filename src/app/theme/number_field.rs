//! Fields of numbers, which are dragged or typed: the one place that knows how people write decimals.
//!
//! Shown with the decimal mark of the current language and a minus sign; typed with a point or a comma in every language, so that a
//! number pad and a number copied from elsewhere work, also with blanks and the unit. The value changes when the field is
//! left, not with every key: half a number is no value. Escape, and text that is no finite number, leave it as it was; so
//! does a text that was not changed, although it may show fewer decimals.

use crate::language::decimal;
use egui::emath::{self, Numeric};
use egui::{DragValue, Id, Key, Response, Ui, Widget, WidgetInfo};
use std::cell::{Cell, RefCell};
use std::ops::RangeInclusive;
use std::rc::Rc;

/// A field of the number; the caller sets range, speed, decimals and units.
pub fn number_field<N: Numeric>(value: &mut N) -> NumberField<'_> {
    let exact = value.to_f64();
    let (shown, is_abandoned) = (Rc::new(RefCell::new(String::new())), Rc::new(Cell::new(false)));
    let (unchanged, refuses) = (Rc::clone(&shown), Rc::clone(&is_abandoned));
    let field = DragValue::new(value)
        .update_while_editing(false)
        .custom_formatter(move |value, decimals| {
            let text = decimal(&emath::format_with_decimals_in_range(value, decimals)).replacen('-', "−", 1);
            shown.borrow_mut().clone_from(&text);
            text
        })
        .custom_parser(move |text| match *unchanged.borrow() == text {
            _ if refuses.get() => None,
            true => Some(exact),
            false => typed(text),
        });
    NumberField { field, is_abandoned }
}

/// egui's field with a way out: there, a field that is left by Escape takes its text one frame later nevertheless, since
/// it is told for two frames that it was left.
pub struct NumberField<'a> {
    field: DragValue<'a>,
    /// Whether the text is to be refused.
    is_abandoned: Rc<Cell<bool>>,
}

impl NumberField<'_> {
    /// The numbers that it takes; others become the nearest of them.
    pub fn range<N: Numeric>(self, range: RangeInclusive<N>) -> Self {
        Self { field: self.field.range(range), ..self }
    }

    /// The change of the number for each point of a drag.
    pub fn speed(self, speed: f64) -> Self {
        Self { field: self.field.speed(speed), ..self }
    }

    /// The most decimals that are shown.
    pub fn max_decimals(self, decimals: usize) -> Self {
        Self { field: self.field.max_decimals(decimals), ..self }
    }

    /// What is shown before the number.
    pub fn prefix(self, prefix: impl Into<String>) -> Self {
        Self { field: self.field.prefix(prefix.into()), ..self }
    }

    /// What is shown after the number.
    pub fn suffix(self, suffix: impl Into<String>) -> Self {
        Self { field: self.field.suffix(suffix.into()), ..self }
    }
}

impl Widget for NumberField<'_> {
    fn ui(self, ui: &mut Ui) -> Response {
        let (escaped, now) = (Id::unique("escape in a field of a number"), ui.ctx().cumulative_pass_nr());
        if ui.input(|input| input.key_pressed(Key::Escape)) {
            ui.data_mut(|data| data.insert_temp(escaped, now));
        }
        let last: Option<u64> = ui.data(|data| data.get_temp(escaped));
        self.is_abandoned.set(last.is_some_and(|last| now <= last + 1));
        ui.add(self.field)
    }
}

/// Tells a screen reader the name of a field: egui's fields tell their numbers alone.
pub fn spoken(response: Response, name: &str, value: f64) -> Response {
    response.widget_info(|| WidgetInfo::slider(true, value, name));
    response
}

/// The number that a text means. Spaces and the unit of a percentage or an angle are left out, and the minus sign may be a
/// dash, as in egui's own fields.
fn typed(text: &str) -> Option<f64> {
    let plain = |letter: char| match letter {
        '−' => '-',
        ',' => '.',
        other => other,
    };
    let text: String = text.chars().filter(|letter| !letter.is_whitespace()).map(plain).collect();
    text.trim_end_matches(['%', '°']).parse().ok().filter(|number: &f64| number.is_finite())
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "parsed numbers are exact")]
mod tests {
    use super::*;
    use crate::app::theme;
    use crate::language::{self, Language};
    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable;

    /// A field of a number from −2 to 2 with three decimals.
    fn field_of(value: f64) -> Harness<'static, f64> {
        let field = |ui: &mut egui::Ui, value: &mut f64| {
            let name = ui.label("a number");
            ui.add(number_field(value).range(-2.0..=2.0).max_decimals(3)).labelled_by(name.id);
        };
        Harness::builder().with_context_setup(theme::install).build_ui_state(field, value)
    }

    fn click(harness: &mut Harness<'static, f64>) {
        harness.get_by_role(egui::accesskit::Role::SpinButton).click();
        harness.run();
    }

    fn replace_text(harness: &mut Harness<'static, f64>, text: &str) {
        harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
        harness.event(egui::Event::Text(text.to_owned()));
        harness.run();
    }

    /// What the field shows, and the number after a text was typed into it.
    fn shown_then_typed(language: Language, text: &str) -> (Option<String>, f64) {
        language::set(language);
        let mut harness = field_of(1.25);
        let shown = harness.get_by_role(egui::accesskit::Role::SpinButton).value();
        click(&mut harness);
        replace_text(&mut harness, text);
        harness.key_press(egui::Key::Enter);
        harness.run();
        (shown, *harness.state())
    }

    #[test]
    fn the_value_changes_when_the_field_is_left_and_escape_leaves_it() {
        for (key, expected) in [(egui::Key::Enter, -0.5), (egui::Key::Escape, 1.25)] {
            let mut harness = field_of(1.25);
            click(&mut harness);
            for text in ["-", "-0", "-0,", "-0,5"] {
                replace_text(&mut harness, text);
                assert_eq!(*harness.state(), 1.25, "while {text:?} is typed");
            }
            harness.key_press(key);
            harness.run();
            assert_eq!(*harness.state(), expected, "{key:?}");
            click(&mut harness);
            harness.key_press(egui::Key::Enter);
            harness.run();
            assert_eq!(*harness.state(), expected, "what was abandoned does not come back");
        }
    }

    #[test]
    fn a_field_that_is_only_visited_keeps_the_decimals_that_it_does_not_show() {
        let mut harness = field_of(0.123_456_7);
        click(&mut harness);
        harness.key_press(egui::Key::Enter);
        harness.run();
        assert_eq!(*harness.state(), 0.123_456_7);
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
    fn negative_numbers_are_shown_with_a_minus_sign_and_taken_with_a_hyphen_too() {
        for text in ["-0.5", "−0.5"] {
            let mut harness = field_of(-1.25);
            assert_eq!(harness.get_by_role(egui::accesskit::Role::SpinButton).value().as_deref(), Some("−1.25"));
            click(&mut harness);
            replace_text(&mut harness, text);
            harness.key_press(egui::Key::Enter);
            harness.run();
            assert_eq!(*harness.state(), -0.5, "{text}");
        }
    }

    #[test]
    fn what_is_no_finite_number_is_refused() {
        for text in ["", "-", "%", ",", "1.000,5", "1,2.3", "nan", "inf", "1e999", "a half"] {
            assert_eq!(typed(text), None, "{text:?}");
        }
        assert_eq!(typed(" 1\u{202f}000,5 "), Some(1000.5));
        assert_eq!([typed("12,5\u{a0}%"), typed("-30°")], [Some(12.5), Some(-30.0)]);
        assert_eq!(typed("1,5e-3"), Some(1.5e-3));
    }
}
