//! Dragged dots are caught by axes, their ends and corners, beside them they are free, and Alt frees them.

use crate::app::accessibility;
use crate::app::input::action::Action;
use crate::app::tests::{ready_app, step_until};
use crate::app::*;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::outline::Preset;
use crate::session::{Command, OutlineSpec};
use egui::{Event, Modifiers, vec2};
use egui_kittest::Harness;

const SIDE: Side = Side::Source;

fn app_with(commands: Vec<Command>) -> Harness<'static, RiemapApp> {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    harness.state_mut().carry_out(&context, commands.into_iter().map(Action::Session).collect());
    step_until(&mut harness, |app| {
        let found = app.stats().overlays.symmetries;
        app.stats().preparation.ready && (!app.model.session().symmetries() || found.iter().all(Option::is_some))
    });
    harness
}

/// The place of a point of the source on the screen.
fn place(harness: &Harness<'_, RiemapApp>, point: DVec2) -> egui::Pos2 {
    harness.state().pictures.views[SIDE].to_screen(point)
}

fn move_to(harness: &mut Harness<'_, RiemapApp>, at: egui::Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.step();
}

fn caught(harness: &Harness<'_, RiemapApp>) -> String {
    harness.state().stats().screen.handles.caught.unwrap_or_default()
}

#[test]
fn an_interior_point_is_caught_near_an_axis_and_free_beside_it_or_with_alt() {
    crate::language::set(crate::language::Language::English);
    let mut harness = app_with(vec![Command::SetSymmetries(true)]);
    let before = harness.state().stats().screen.undo;
    let axis = |harness: &Harness<'_, RiemapApp>| place(harness, DVec2::new(0.0, -0.25));
    let grabbed = place(&harness, harness.state().model.interior(SIDE).unwrap());
    let x = |harness: &Harness<'_, RiemapApp>| harness.state().model.interior(SIDE).unwrap().x;
    harness.drag_at(grabbed);
    harness.step();
    let near = axis(&harness) + vec2(6.0, 0.0);
    move_to(&mut harness, near);
    assert_eq!((x(&harness).abs() < 1e-15, caught(&harness).as_str()), (true, "x₁ is on the axis at 90°."));
    move_to(&mut harness, near + vec2(4.0, 0.0));
    assert!(x(&harness) > 0.0 && caught(&harness).is_empty(), "{} {}", x(&harness), caught(&harness));
    move_to(&mut harness, near - vec2(12.0, 0.0));
    assert_eq!((x(&harness).abs() < 1e-15, caught(&harness).is_empty()), (true, false));
    harness.event(Event::ModifiersChanged(Modifiers::ALT));
    move_to(&mut harness, near);
    assert!(x(&harness) > 1e-3 && caught(&harness).is_empty(), "{} {}", x(&harness), caught(&harness));
    harness.event(Event::ModifiersChanged(Modifiers::NONE));
    move_to(&mut harness, near + vec2(0.0, 1.0));
    harness.drop_at(near + vec2(0.0, 1.0));
    step_until(&mut harness, |app| app.stats().preparation.ready);
    let words = accessibility::state(harness.state());
    assert!(
        words.contains("x₁ is on the axis at 90°.") && words.contains("Symmetry of source: Axis at 90°"),
        "{words}"
    );
    assert_eq!(harness.state().stats().screen.undo, before + 1, "the drag is one step");
}

#[test]
fn a_boundary_point_is_caught_by_a_corner_also_where_no_symmetries_are_shown() {
    crate::language::set(crate::language::Language::English);
    let outline = OutlineSpec::Preset(Preset::Square);
    let mut harness = app_with(vec![Command::SetOutline { side: SIDE, outline }]);
    let grabbed = place(&harness, harness.state().model.anchor(SIDE).unwrap());
    harness.drag_at(grabbed);
    harness.step();
    let corner = place(&harness, DVec2::new(0.9, 0.9));
    move_to(&mut harness, corner + vec2(-6.0, 3.0));
    assert_eq!(harness.state().model.anchor(SIDE), Some(DVec2::new(0.9, 0.9)));
    assert_eq!(caught(&harness), "y₁ is in a corner.");
    move_to(&mut harness, corner + vec2(-11.0, 3.0));
    assert_ne!(harness.state().model.anchor(SIDE), Some(DVec2::new(0.9, 0.9)));
    assert_eq!(caught(&harness), "");
    let middle = place(&harness, DVec2::new(0.9, 0.0));
    move_to(&mut harness, middle + vec2(0.0, 3.0));
    assert_eq!(caught(&harness), "", "axes are not shown");
    let context = harness.ctx.clone();
    harness.state_mut().carry_out(&context, vec![Action::Session(Command::SetSymmetries(true))]);
    step_until(&mut harness, |app| app.stats().overlays.symmetries[0].is_some());
    move_to(&mut harness, middle + vec2(0.0, 4.0));
    assert_eq!(caught(&harness), "y₁ is at an end of the axis at 0°.");
    assert!(harness.state().model.anchor(SIDE).unwrap().distance(DVec2::new(0.9, 0.0)) < 1e-14);
}
