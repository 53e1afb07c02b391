//! Actions of buttons that are laid out while painting, and events from outside of frames.

use super::ready_app;
use crate::app::input::action::{Action, EditAction};
use crate::conformal::Side;
use crate::language::key;
use crate::platform::Event;
use egui_kittest::kittest::Queryable;

#[test]
fn an_action_asked_while_painting_is_carried_out_at_the_start_of_the_next_frame() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.run_steps(3);
    harness.get_all_by_label("Edit").next().unwrap().click();
    harness.step();
    let app = harness.state();
    assert_eq!(app.input.asked, [Action::Edit(EditAction::Toggle(Side::Source))]);
    assert!(app.editor.side().is_none() && harness.ctx.has_requested_repaint());
    harness.step();
    let app = harness.state();
    assert!(app.input.asked.is_empty() && app.editor.side() == Some(Side::Source));
}

#[test]
fn a_file_dialog_that_does_not_open_gives_a_message() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.state().workers.mailbox.post(Event::NoDialog(key::dialog_too_late().into()));
    harness.run_steps(2);
    harness.get_by_label_contains("Press the button again.");
}
