//! The editor in the whole app, driven by pointer and keys.

use super::*;
use crate::app::RiemapApp;
use crate::app::status::stats::Stats;
use crate::app::tests::{ready_app, step_until};
use crate::model::editing::Pen;
use crate::session::OutlineSpec;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

const SIDE: Side = Side::Source;

/// Waits until the map of the requested session is shown.
fn settle(harness: &mut Harness<'_, RiemapApp>) -> Stats {
    harness.run_steps(2);
    for _ in 0..600 {
        if harness.state().stats().preparation.ready {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(10));
        harness.step();
    }
    harness.run_steps(2);
    let stats = harness.state().stats();
    assert!(stats.preparation.ready, "{stats:?}");
    stats
}

#[test]
fn a_drag_in_the_picture_is_one_undo_step() {
    let mut harness = ready_app([1200.0, 800.0]);
    let before = harness.state().session().clone();
    harness.get_all_by_label("Edit").next().unwrap().click();
    harness.run_steps(3);
    let editing = harness.state().stats().screen.editing.unwrap();
    assert_eq!(editing.side, Side::Source);
    let [x, y] = editing.handles[0];
    harness.drag_at(egui::pos2(x, y));
    harness.step();
    for step in 1..6 {
        harness.hover_at(egui::pos2(x + 2.0 * step as f32, y - 3.0 * step as f32));
        harness.step();
    }
    harness.drop_at(egui::pos2(x + 10.0, y - 15.0));
    harness.step();
    let after = settle(&mut harness);
    let [u, v] = after.screen.editing.as_ref().unwrap().handles[0];
    assert!((u - x - 10.0).abs() < 0.6 && (v - y + 15.0).abs() < 0.6, "from {x}, {y} to {u}, {v}");
    assert_eq!(after.screen.undo, 1, "a drag is one step");
    assert_ne!(harness.state().session().domain(Side::Source).outline, before.domain(Side::Source).outline);
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    harness.step();
    settle(&mut harness);
    assert_eq!(*harness.state().session(), before);
    harness.key_press(egui::Key::Escape);
    harness.run_steps(3);
    assert!(harness.state().stats().screen.editing.is_none());
}

/// A held arrow key repeats in every frame, and many repeats arrive while one map is prepared.
#[test]
fn a_handle_held_by_keys_is_followed_coarsely_and_is_one_undo_step() {
    let mut harness = ready_app([1200.0, 800.0]);
    let before = harness.state().session().clone();
    harness.get_all_by_label("Edit").next().unwrap().click();
    harness.run_steps(3);
    harness.key_press(egui::Key::N);
    harness.run_steps(2);
    let editing = harness.state().stats().screen.editing.unwrap();
    let handle = editing.selected.unwrap();
    let [x, y] = editing.handles[handle];
    for repeat in 1..=5 {
        harness.key_down(egui::Key::ArrowRight);
        harness.step();
        let side = harness.state().model.side(SIDE);
        assert!(side.is_in_hand(), "after {repeat} repeats");
    }
    assert_eq!(harness.state().stats().screen.undo, 0);
    harness.key_up(egui::Key::ArrowRight);
    harness.step();
    assert!(!harness.state().model.side(SIDE).is_in_hand(), "released");
    let after = settle(&mut harness);
    let [u, v] = after.screen.editing.as_ref().unwrap().handles[handle];
    assert!((u - x - 20.0).abs() < 0.6 && (v - y).abs() < 0.6, "from {x}, {y} to {u}, {v}");
    assert_eq!(after.screen.undo, 1, "a hold is one step");
    assert_eq!(harness.state().session().domain(Side::Source).settings, before.domain(Side::Source).settings);
    // down and up within a frame
    let key = |pressed| egui::Event::Key {
        key: egui::Key::ArrowUp,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: egui::Modifiers::NONE,
    };
    harness.input_mut().events.extend([key(true), key(false)]);
    harness.step();
    assert!(!harness.state().model.side(SIDE).is_in_hand());
    assert_eq!(settle(&mut harness).screen.undo, 2);
}

#[test]
fn a_long_text_pasted_into_the_field_is_not_shown_in_it() {
    let mut harness = ready_app([1200.0, 800.0]);
    let app = harness.state_mut();
    app.editor.act(EditAction::OpenPaste(SIDE), &mut app.model, &mut app.pictures.views);
    harness.run_steps(3);
    assert!(harness.ctx.text_edit_focused(), "the empty field has the keyboard");
    for (text, shown) in [(String::from("M 0 0"), 5), ("no outline ".repeat(10_000), 0)] {
        harness.event(egui::Event::Paste(text));
        harness.run_steps(2);
        step_until(&mut harness, |app| !app.model.is_preparing(SIDE));
        assert_eq!(harness.state().editor.paste.as_ref().unwrap().text().len(), shown);
    }
    let message = harness.state().stats().screen.editing.unwrap().message.unwrap();
    assert!(message.contains("110000 bytes"), "{message}");
}

#[test]
fn the_message_about_a_crossing_does_not_hide_it() {
    let mut harness = ready_app([390.0, 844.0]);
    let act = |harness: &mut Harness<'_, RiemapApp>, action| {
        let app = harness.state_mut();
        app.editor.act(action, &mut app.model, &mut app.pictures.views);
    };
    let rect = harness.state().pictures.views.source.rect;
    for (place, is_below) in [(rect.center() - vec2(0.0, 60.0), true), (rect.center_bottom() - vec2(0.0, 110.0), false)]
    {
        act(&mut harness, EditAction::Draw(SIDE, Pen::Lines));
        harness.run_steps(3); // the picture makes room for the bar
        for by in [vec2(-40.0, -20.0), vec2(40.0, 20.0), vec2(40.0, -20.0), vec2(-40.0, 20.0)] {
            let point = harness.state().pictures.views.source.to_world(place + by);
            act(&mut harness, EditAction::Point(point));
        }
        act(&mut harness, EditAction::Close);
        harness.run_steps(5);
        let crossing = egui::Pos2::from(harness.state().stats().screen.editing.unwrap().crossing.unwrap());
        assert!(crossing.distance(place) < 1.0, "{crossing:?} is not {place:?}");
        let message = harness.get_by_label_contains("crosses itself").rect();
        assert!(!message.expand(paint::RING).contains(place), "{message:?} lies over {place:?}");
        assert_eq!(message.center().y > rect.center().y, is_below);
    }
}

/// Pans the source's picture so that `place` is under the center of the first "Edit" button.
fn move_under_the_button(harness: &mut Harness<'_, RiemapApp>, place: egui::Pos2) -> egui::Pos2 {
    let button = harness.get_all_by_label("Edit").next().unwrap().rect().center();
    harness.state_mut().pictures.views.source.pan(button - place);
    harness.run_steps(2);
    button
}

#[test]
fn a_press_on_a_button_does_not_reach_the_picture_below() {
    let mut harness = ready_app([1200.0, 800.0]);
    let x1 = |harness: &Harness<'_, RiemapApp>| egui::Pos2::from(harness.state().stats().screen.handles.x1.unwrap());
    let place = x1(&harness);
    let button = move_under_the_button(&mut harness, place);
    assert!(x1(&harness).distance(button) < 1.0);
    let before = harness.state().session().clone();
    harness.drag_at(button);
    harness.step();
    assert!(harness.state().input.handles.grip.is_none(), "no dot is dragged");
    harness.hover_at(button + vec2(0.0, 60.0));
    harness.run_steps(2);
    assert!(x1(&harness).distance(button) < 1.0, "the picture does not move");
    harness.drop_at(button + vec2(0.0, 60.0));
    harness.run_steps(2);
    assert_eq!(*harness.state().session(), before);
    assert!(harness.state().stats().screen.editing.is_none(), "released elsewhere: no click");
    harness.key_press(egui::Key::D);
    harness.run_steps(2);
    let open = harness.get_all_by_label("Fit").next().unwrap().rect().center();
    harness.drag_at(open);
    for step in 1..8 {
        harness.hover_at(open + vec2(-8.0 * step as f32, 12.0 * step as f32));
        harness.step();
    }
    let editing = harness.state().stats().screen.editing.unwrap();
    assert!(editing.draws && editing.handles.is_empty(), "nothing is drawn from a button on: {editing:?}");
    harness.drop_at(open + vec2(-64.0, 96.0));
    harness.run_steps(2);
}

/// With software rendering frames are slow: a stroke may fall into two frames, or into one.
#[test]
fn a_quick_stroke_is_an_outline_whatever_frames_it_falls_into() {
    let press = |pos, pressed| {
        let (button, modifiers) = (egui::PointerButton::Primary, egui::Modifiers::NONE);
        egui::Event::PointerButton { pos, button, pressed, modifiers }
    };
    for frames in [1, 2, 3] {
        let mut harness = ready_app([1200.0, 800.0]);
        let before = harness.state().session().domain(Side::Source).outline.clone();
        let middle = harness.state().pictures.views.source.rect.center();
        harness.hover_at(middle);
        harness.step();
        harness.key_press(egui::Key::D);
        harness.run_steps(2);
        let around: Vec<egui::Pos2> =
            (0..48).map(|k| middle + 120.0 * egui::Vec2::angled(std::f32::consts::TAU * k as f32 / 48.0)).collect();
        let mut events = vec![egui::Event::PointerMoved(around[0]), press(around[0], true)];
        events.extend(around.iter().map(|&place| egui::Event::PointerMoved(place)));
        events.push(press(around[47], false));
        let cuts = [0, 2, 25];
        let ends = [if frames == 1 { 51 } else { 2 }, if frames == 2 { 51 } else { 25 }, 51];
        for (from, to) in cuts.into_iter().zip(ends).take(frames) {
            harness.input_mut().events.extend_from_slice(&events[from..to]);
            harness.step();
        }
        let stats = settle(&mut harness);
        assert!(stats.screen.editing.is_none(), "{frames} frames: {:?}", stats.screen.editing);
        assert_ne!(harness.state().session().domain(Side::Source).outline, before, "{frames} frames");
    }
}

#[test]
fn a_stroke_whose_touch_is_cancelled_is_discarded() {
    let mut harness = ready_app([1200.0, 800.0]);
    let middle = harness.state().pictures.views.source.rect.center();
    harness.hover_at(middle);
    harness.key_press(egui::Key::D);
    harness.run_steps(2);
    let touch = |phase, pos| egui::Event::Touch {
        device_id: egui::TouchDeviceId(0),
        id: egui::TouchId(1),
        phase,
        pos,
        force: None,
    };
    let (button, modifiers) = (egui::PointerButton::Primary, egui::Modifiers::NONE);
    let press = egui::Event::PointerButton { pos: middle, button, pressed: true, modifiers };
    // as `raw_input_hook` does
    let mut touches = crate::app::input::touches::Touches::default();
    let mut take_in = |mut events: Vec<egui::Event>| {
        touches.take_in(&mut events);
        events
    };
    harness.input_mut().events.extend(take_in(vec![touch(egui::TouchPhase::Start, middle), press]));
    harness.step();
    harness.input_mut().events.push(egui::Event::PointerMoved(middle + vec2(40.0, 0.0)));
    harness.step();
    assert!(harness.state().stats().screen.editing.unwrap().handles.len() > 1);
    harness.input_mut().events.extend(take_in(vec![touch(egui::TouchPhase::Cancel, middle)]));
    harness.run_steps(2);
    let editing = harness.state().stats().screen.editing.unwrap();
    assert!(editing.draws && editing.handles.is_empty() && editing.message.is_none(), "{editing:?}");
}

#[test]
fn a_file_opened_during_a_drag_replaces_the_dragged_outline() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.get_all_by_label("Edit").next().unwrap().click();
    harness.run_steps(3);
    let handle = egui::Pos2::from(harness.state().stats().screen.editing.unwrap().handles[0]);
    harness.drag_at(handle);
    harness.step();
    harness.hover_at(handle + vec2(6.0, 0.0));
    harness.step();
    assert!(harness.state().model.side(SIDE).is_in_hand());
    let bytes = b"0,0\n2,0\n2,1\n0,1\n".to_vec();
    harness.state_mut().take_file(crate::model::files::FilePurpose::Outline(SIDE), "box.csv", Ok(bytes));
    for step in 2..5 {
        harness.hover_at(handle + vec2(6.0 * step as f32, 0.0));
        harness.step();
    }
    harness.drop_at(handle + vec2(24.0, 0.0));
    harness.step();
    let stats = settle(&mut harness);
    let outline = harness.state().session().domain(Side::Source).outline.clone();
    assert!(
        matches!(&outline, OutlineSpec::Points { name, polygon, .. } if name == "box" && polygon.vertices().len() == 4),
        "{outline:?}"
    );
    assert_eq!(stats.screen.editing.unwrap().handles.len(), 4, "the handles are those of the new outline");
    assert_eq!(stats.screen.undo, 1);
}

#[test]
fn a_stroke_that_was_no_outline_is_not_taken_back_point_by_point() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.hover_at(harness.state().pictures.views.source.rect.center());
    harness.key_press(egui::Key::D);
    harness.run_steps(2);
    let app = harness.state_mut();
    let middle = app.pictures.views.source.rect.center();
    for k in 0..48 {
        let angle = std::f32::consts::TAU * (k as f32 + 0.3) / 48.0;
        let point = app.pictures.views.source.to_world(middle + vec2(120.0 * angle.sin(), 80.0 * (2.0 * angle).sin()));
        app.editor.act(EditAction::Point(point), &mut app.model, &mut app.pictures.views);
    }
    app.editor.act(EditAction::Close, &mut app.model, &mut app.pictures.views);
    assert!(app.editor.crossing().is_some());
    harness.key_press(egui::Key::Backspace);
    harness.run_steps(3);
    let editing = harness.state().stats().screen.editing.unwrap();
    assert!(editing.draws && editing.handles.len() == 48 && editing.message.is_some(), "{editing:?}");
}
