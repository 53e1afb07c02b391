//! Actions of buttons that are laid out while painting, and events from outside of frames.

use super::ready_app;
use crate::app::input::action::{Action, EditAction};
use crate::app::input::locks::{Control, Locks};
use crate::conformal::Side;
use crate::language::key;
use crate::platform::Event;
use eframe::App;
use egui::{Event as InputEvent, Key, Modifiers, RawInput};
use egui_kittest::kittest::Queryable;

#[test]
fn an_action_asked_while_painting_is_carried_out_in_the_next_frame() {
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

#[test]
fn tab_folds_the_panels_by_the_next_frame_and_is_ignored_where_they_are_locked() {
    let tab =
        InputEvent::Key { key: Key::Tab, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::NONE };
    let events = vec![InputEvent::PointerMoved(egui::pos2(600.0, 400.0)), tab];
    for locked in [false, true] {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        if locked {
            Locks::default().with(Control::Panels).install(&context);
        }
        let mut input = RawInput { events: events.clone(), ..RawInput::default() };
        harness.state_mut().raw_input_hook(&context, &mut input);
        assert!(harness.state().screen.panels_open, "nothing changes before the frame");
        harness.run_steps(2);
        assert_eq!(harness.state().screen.panels_open, locked);
        assert_eq!(harness.query_by_label("Checker").is_some(), locked);
        assert_eq!(harness.state().stats().screen.errors, [""; 0]);
    }
}
