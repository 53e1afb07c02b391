//! The choice among the boundary loops of a surface with several: its outline, and what is painted of the others.

use crate::app::input::action::{Action, Actions};
use crate::app::input::locks::{Control, guarded};
use crate::app::input::scrolling::has_changed;
use crate::app::theme::explained::explained_heading;
use crate::app::theme::widgets::{Segment, segmented};
use crate::app::theme::{ROW_HEIGHT, control_height};
use crate::conformal::Side;
use crate::language::{Value, key, say, tr};
use crate::model::Model;
use crate::model::boundary_loops::BoundaryLoop;
use crate::session::{Command, Holes};
use egui::{Button, Id, ScrollArea, Ui, vec2};

const HOLES: [Segment<Holes>; 2] = [
    Segment { value: Holes::Filled, label: key::holes_filled(), tooltip: key::holes_filled_tooltip() },
    Segment { value: Holes::Open, label: key::holes_open(), tooltip: key::holes_open_tooltip() },
];

/// The height of the list of loops, in points: more than five are scrolled.
const LIST: f32 = 5.5 * ROW_HEIGHT;

/// Shows the list of loops; nothing unless the side is a surface with several.
pub fn show(ui: &mut Ui, side: Side, model: &Model, actions: &mut Actions) {
    let loops = model.boundary_loops(side);
    let Some((_, state)) = model.surface(side).filter(|_| !loops.is_empty()) else { return };
    explained_heading(ui, tr(key::boundary_loops()), key::explain_boundary_loops());
    let list = ScrollArea::vertical().max_height(LIST).id_salt(("loops", side)).auto_shrink([false, true]);
    guarded(ui, Control::Outline, |ui| list.show(ui, |ui| choice(ui, side, model, &loops, actions)));
    ui.label(tr(key::holes()));
    let holes = guarded(ui, Control::Colours, |ui| segmented(ui, &HOLES, state.holes()));
    actions.extend(holes.map(|holes| Action::Session(Command::SetHoles { side, holes })));
}

fn choice(ui: &mut Ui, side: Side, model: &Model, loops: &[BoundaryLoop], actions: &mut Actions) {
    for BoundaryLoop { number, is_outline, length, places } in loops {
        let length = Value::number(format!("{length:.4}"));
        let words = say(&key::loop_in_list(u32::from(*number) + 1, length, places.len()));
        let row = Button::selectable(*is_outline, words).min_size(vec2(ui.available_width(), control_height(ui, 0.0)));
        let row = ui.add(row).on_hover_text(tr(key::choose_loop()));
        if *is_outline && has_changed(ui, Id::unique(("number of the outline", side)), number) {
            row.scroll_to_me(None);
        }
        if row.clicked() && !is_outline {
            actions.extend(model.choose_outline(side, *number).map(Action::Session));
        }
    }
}
