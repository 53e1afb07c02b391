//! Which map: the one that a point and a boundary point determine, or the one through boundary pairs ("pins").

use crate::app::input::action::{Action, Actions};
use crate::app::theme::explained::explained_heading;
use crate::app::theme::widgets::{Segment, segmented_where};
use crate::app::theme::{BOUNDARY_COLOUR, ROW_HEIGHT, control_height};
use crate::conformal::Pins;
use crate::language::{Message, Value, key, say, tr};
use crate::model::Model;
use crate::session::Command;
use egui::{Align, Button, Layout, RichText, Role, ScrollArea, Ui, Vec2, WidgetInfo};

const WAYS: [Segment<bool>; 2] = [
    Segment { value: false, label: key::by_points(), tooltip: key::by_points_tooltip() },
    Segment { value: true, label: key::by_pins(), tooltip: key::by_pins_tooltip() },
];

/// The height of the list of pins, in rows: more than five are scrolled.
const ROWS: f32 = 5.5;

/// The size of the button that removes a pin, in points.
const CROSS: f32 = 20.0;

/// Shows the choice and, with pins, their list; nothing before the first map.
pub fn show(ui: &mut Ui, model: &Model, actions: &mut Actions) {
    if model.map().is_none() {
        return;
    }
    explained_heading(ui, tr(key::which_map()), key::explain_which_map());
    let first = if model.pins().is_none() { model.first_pins() } else { None };
    let refused = |by_pins: bool| match &first {
        Some(Err(error)) if by_pins => Some(say(&Message::from(error))),
        _ => None,
    };
    match segmented_where(ui, &WAYS, model.pins().is_some(), refused) {
        Some(false) => actions.push(Action::Session(Command::SetPins(None))),
        Some(true) => {
            actions.extend(first.and_then(Result::ok).map(|pins| Action::Session(Command::SetPins(Some(pins)))));
        }
        None => {}
    }
    if let Some(pins) = model.pins() {
        list(ui, model, pins, actions);
    }
}

fn list(ui: &mut Ui, model: &Model, pins: &Pins, actions: &mut Actions) {
    let misses = model.pin_misses();
    let most = ROWS * (control_height(ui, ROW_HEIGHT) + ui.spacing().item_spacing.y);
    let area = ScrollArea::vertical().max_height(most).min_scrolled_height(most).id_salt("pins");
    area.auto_shrink([false, true]).show(ui, |ui| {
        for pin in 0..pins.pairs().len() {
            ui.push_id(pin, |ui| row(ui, pins, pin, misses.map(|misses| misses[pin]), actions));
        }
    });
    let one_more = model.pins_with_one_more();
    let button = ui.add_enabled(one_more.is_some(), Button::new(tr(key::add_pin())));
    let button = button.on_hover_text(tr(key::add_pin_tooltip())).on_disabled_hover_text(tr(key::no_more_pins()));
    if button.clicked() {
        actions.extend(one_more.map(|pins| Action::Session(Command::SetPins(Some(pins)))));
    }
}

/// The misses that are written without an exponent.
const PLAIN_MISSES: std::ops::Range<f64> = 1e-3..1e3;

/// A miss in words, to two digits; "…" while the map is computed.
pub fn missed(miss: Option<f64>) -> Value {
    match miss {
        None => Value::from("…"),
        Some(0.0) => Value::from("0"),
        Some(miss) if PLAIN_MISSES.contains(&miss) => {
            let decimals = (1.0 - miss.log10().floor()).max(0.0) as usize;
            Value::number(format!("{miss:.decimals$}"))
        }
        Some(miss) => Value::number(format!("{miss:.1e}")),
    }
}

fn row(ui: &mut Ui, pins: &Pins, pin: usize, miss: Option<f64>, actions: &mut Actions) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(format!("{}", pin + 1)).color(BOUNDARY_COLOUR).strong());
        ui.label(say(&key::pin_misses_by(missed(miss)))).on_hover_text(tr(key::pin_misses_tooltip()));
        if let Ok(fewer) = pins.without(pin) {
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let name = say(&key::remove_pin(pin + 1));
                let cross = Button::new("×").min_size(Vec2::splat(control_height(ui, CROSS)));
                let cross = ui.add(cross).on_hover_text(name.as_str());
                cross.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
                if cross.clicked() {
                    actions.push(Action::Session(Command::SetPins(Some(fewer))));
                }
            });
        }
    });
}
