//! The best map on the screen: one button finds it, one undo takes it back; the landscape moves x₁, the brush paints.

use super::*;
use crate::app::tests::panels::click_in_panel;
use crate::model::best::{Aim, BestAction};
use egui::{Key, Modifiers, Pos2};

fn places(harness: &Harness<'_, RiemapApp>) -> [Pos2; 2] {
    let handles = harness.state().stats().screen.handles;
    [handles.x1.unwrap().into(), handles.x2.unwrap().into()]
}

fn drag(harness: &mut Harness<'_, RiemapApp>, from: Pos2, to: Pos2) {
    harness.drag_at(from);
    harness.step();
    for k in 1..=4u8 {
        harness.hover_at(from.lerp(to, f32::from(k) / 4.0));
        harness.step();
    }
    harness.drop_at(to);
    harness.run_steps(3);
}

#[test]
fn its_controls_ask_for_what_they_say() {
    let model = prepared_model();
    for (label, action) in [
        ("Scales", BestAction::Aim(Aim::Scale)),
        ("Region", BestAction::Aim(Aim::Region)),
        ("Symmetry", BestAction::Aim(Aim::Symmetry)),
        ("Find it", BestAction::Start),
        ("Landscape over x₁", BestAction::Landscape(true)),
    ] {
        assert_eq!(click_in_panel(&model, label), [Action::Best(action)], "{label}");
    }
}

#[test]
fn it_is_found_by_one_button_and_taken_back_by_one_undo() {
    let mut harness = ready_app([1200.0, 1100.0]);
    let before = harness.state().session().clone();
    let undo = harness.state().stats().screen.undo;
    harness.get_by_label("Find it").click();
    harness.step();
    harness.step();
    harness.get_by_label("Cancel");
    step_until(&mut harness, |app| app.stats().overlays.best.result.is_some());
    step_until(&mut harness, |app| !app.stats().overlays.best.moving && app.stats().screen.undo > undo);
    let stats = harness.state().stats();
    let [first, best] = stats.overlays.best.result.unwrap();
    assert!(best < 0.9 * first, "{first} → {best}");
    assert_eq!(stats.screen.undo, undo + 1);
    assert!(accessibility::state(harness.state()).contains("Area distortion"));
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    step_until(&mut harness, |app| app.stats().screen.undo == undo);
    assert_eq!(harness.state().session(), &before);
}

/// From its first frame on, when the points are still where they were.
#[test]
fn one_undo_ends_the_motion_to_it_and_takes_back_nothing_before() {
    let mut harness = ready_app([1200.0, 1100.0]);
    harness.state_mut().model.dispatch(Command::MoveAnchor { side: Side::Source, fraction: 0.25 }, 0.0);
    step_until(&mut harness, |app| app.stats().screen.undo == 1 && app.model.can_search());
    let before = harness.state().session().clone();
    for moved in [false, true] {
        harness.get_by_label("Find it").click();
        step_until(&mut harness, |app| app.model.best().is_moving() && (!moved || app.session() != &before));
        // nothing on the way is recorded as a step
        assert!(!harness.state().can_step()[1]);
        harness.state_mut().redo();
        assert_eq!(harness.state().stats().screen.undo, 1);
        harness.state_mut().undo();
        step_until(&mut harness, |app| app.model.can_search() && app.stats().screen.undo == 1);
        assert!(harness.state().session() == &before && !harness.state().model.best().is_moving());
    }
}

#[test]
fn a_click_on_the_landscape_moves_its_point_and_a_drag_of_the_brush_paints() {
    let mut harness = ready_app([1200.0, 1100.0]);
    harness.get_by_label("Landscape over x₁").click();
    step_until(&mut harness, |app| app.stats().overlays.best.lowest.is_some());
    let [x1, _] = places(&harness);
    let there = x1 + egui::vec2(0.0, 45.0);
    drag(&mut harness, there, there + egui::vec2(8.0, 0.0));
    let [moved, _] = places(&harness);
    assert!(moved.distance(there + egui::vec2(8.0, 0.0)) < 3.0, "{moved} from {x1}, not at {there}");
    harness.get_by_label("Region").click();
    harness.run_steps(3);
    harness.get_by_label("Paint with the brush").click();
    harness.run_steps(3);
    drag(&mut harness, x1 - egui::vec2(30.0, 0.0), x1 + egui::vec2(30.0, 0.0));
    let painted = harness.state().stats().overlays.best.region;
    let [still, _] = places(&harness);
    assert!(painted > 1 && still == moved, "{painted} dabs, x₁ at {still}");
    harness.get_by_label("Clear the region").click();
    harness.run_steps(3);
    assert_eq!(harness.state().stats().overlays.best.region, 0);
    harness.step();
    // the landscape is still asked for, and says what it lacks
    harness.get_by_label("Paint a region of the source first");
}
