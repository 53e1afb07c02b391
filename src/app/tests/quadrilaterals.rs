//! Four marks of an outline in the app: its rectangle in one step, its grid, its file; and the window of map projections.

use super::*;
use crate::app::input::action::ProjectionAction;
use crate::app::input::preferences::Habit;
use crate::app::status::window_stats::ProjectionStats;
use crate::export::ProjectionFormat;
use crate::model::overlays::invariants::InvariantsAction;
use crate::model::overlays::orthogonal_grid::GridAction;

/// The app with an L as its source, four marks on it, and their modulus.
fn marked_app(size: [f32; 2]) -> Harness<'static, RiemapApp> {
    let mut harness = ready_app(size);
    let context = harness.ctx.clone();
    let outline = OutlineSpec::Preset(Preset::LShape);
    let marks = Some([0.0, 0.25, 0.625, 0.75]);
    let app = harness.state_mut();
    app.recall(Habit::Advanced(true));
    app.carry_out(
        &context,
        vec![
            Action::Session(Command::SetOutline { side: Side::Source, outline }),
            Action::Invariants(InvariantsAction::Open(Side::Source, true)),
            Action::Session(Command::SetMarks { side: Side::Source, marks }),
        ],
    );
    step_until(&mut harness, |app| app.model.is_ready() && app.model.onto_rectangle(Side::Source).is_some());
    harness
}

#[test]
fn the_rectangle_is_one_click_and_one_step_to_undo_away() {
    let mut harness = marked_app([1200.0, 3600.0]);
    harness.step();
    let before = harness.state().session().clone();
    let undo = harness.state().stats().screen.undo;
    let button = harness.get_by_label("Map onto its rectangle");
    button.focus();
    button.click_accesskit();
    let is_met = |app: &RiemapApp| {
        let fourth = app.model.fourth_miss(Side::Source).filter(|_| app.model.is_ready());
        fourth.is_some_and(|fourth| fourth < 1e-6 && app.model.pins().is_some_and(|pins| pins.pairs().len() == 3))
    };
    step_until(&mut harness, is_met);
    harness.step();
    harness.get_by_label_contains("mark 4 misses its own by ");
    let button = harness.get_by_label("Map onto its rectangle");
    assert!(button.accesskit_node().is_focused(), "the keyboard stays where it was");
    assert_eq!(harness.state().stats().screen.undo, undo + 1);
    let context = harness.ctx.clone();
    harness.state_mut().carry_out(&context, vec![Action::Undo]);
    step_until(&mut harness, |app| app.model.is_ready() && app.model.pins().is_none());
    assert_eq!(*harness.state().session(), before);
}

#[test]
fn a_grid_is_shown_with_its_accuracy_and_its_lattice_on_the_rectangle() {
    let mut harness = marked_app([1200.0, 3600.0]);
    harness.step();
    harness.get_by_label("Orthogonal grid").click();
    step_until(&mut harness, |app| app.model.grid(Side::Source).is_some());
    harness.step();
    harness.get_by_label_contains("Nodes right to ");
    let [n, m] = harness.state().model.overlay_state().orthogonal_grids.of(Side::Source).cells().unwrap().counts();
    let lines = (n + m - 2) as usize;
    assert_eq!(harness.state().stats().overlays.grid_lines, [lines, 0]);
    let onto = harness.state().model.onto_rectangle(Side::Source).unwrap().unwrap();
    let context = harness.ctx.clone();
    harness.state_mut().carry_out(&context, vec![Action::Session(onto)]);
    step_until(&mut harness, |app| app.stats().overlays.grid_lines == [lines; 2]);
    // a grid that is hidden while it is computed is given up
    let cells = crate::conformal::GridCells::new([1000, 1000]).unwrap();
    let app = harness.state_mut();
    app.carry_out(&context, vec![Action::Grid(GridAction::Cells(Side::Source, cells))]);
    let is_computing = |app: &RiemapApp| app.model.overlay_state().orthogonal_grids.is_computing();
    step_until(&mut harness, is_computing);
    assert!(harness.state().model.grid_progress(Side::Source).is_some_and(|done| done < 1.0));
    harness.state_mut().carry_out(&context, vec![Action::Grid(GridAction::Show(Side::Source, false))]);
    harness.step();
    assert!(!is_computing(harness.state()) && harness.state().stats().overlays.grid_lines == [0, 0]);
    // it begins anew when it is shown again
    harness.run_steps(20);
    harness.state_mut().carry_out(&context, vec![Action::Grid(GridAction::Show(Side::Source, true))]);
    assert_eq!(harness.state().model.grid_progress(Side::Source), Some(0.0));
}

/// The marks of the source, and where their squares are on the screen.
fn marks_of_source(harness: &Harness<'_, RiemapApp>) -> ([f64; 4], Vec<egui::Pos2>) {
    let app = harness.state();
    let places = app.stats().screen.handles.marks[0].iter().map(|&place| place.into()).collect();
    (app.session().marks(Side::Source).unwrap(), places)
}

#[test]
fn a_mark_is_dragged_along_its_outline_in_one_step_and_stays_between_its_neighbors() {
    let mut harness = marked_app([1200.0, 900.0]);
    harness.run_steps(20);
    let (before, places) = marks_of_source(&harness);
    let undo = harness.state().stats().screen.undo;
    let view = harness.state().pictures.views[Side::Source].clone();
    let samples = harness.state().model.domain(Side::Source).unwrap().samples().clone();
    let foot = |fraction: f64| view.to_screen(samples.position(samples.at_fraction(fraction)));
    // the pointer takes the square, and moves the foot
    let by = foot(before[1] + 0.05) - foot(before[1]);
    harness.drag_at(places[1]);
    harness.step();
    for share in [0.3, 0.6, 1.0] {
        harness.hover_at(places[1] + share * by);
        harness.step();
    }
    let words = harness.state().stats().screen.handles.caught;
    harness.drop_at(places[1] + by);
    harness.run_steps(20);
    let (after, _) = marks_of_source(&harness);
    assert!((after[1] - before[1] - 0.05).abs() < 2e-3, "{before:?}, {after:?}, {words:?}");
    assert_eq!([after[0], after[2], after[3]], [before[0], before[2], before[3]]);
    assert_eq!(harness.state().stats().screen.undo, undo + 1, "three moves are one step");
    assert!(accessibility::state(harness.state()).contains("Marks of the source at 0.0, 30."));
    // beyond the next mark it does not go
    let (_, places) = marks_of_source(&harness);
    harness.drag_at(places[1]);
    harness.step();
    harness.hover_at(places[1] + (foot(after[2] + 0.03) - foot(after[1])));
    harness.step();
    harness.drop_at(places[1] + (foot(after[2] + 0.03) - foot(after[1])));
    harness.run_steps(20);
    assert_eq!(marks_of_source(&harness).0, after);
    let context = harness.ctx.clone();
    harness.state_mut().carry_out(&context, vec![Action::Undo]);
    step_until(&mut harness, |app| app.session().marks(Side::Source) == Some(before));
    harness.state_mut().carry_out(&context, vec![Action::Redo]);
    step_until(&mut harness, |app| app.session().marks(Side::Source) == Some(after));
}

#[test]
fn a_mark_is_moved_by_keys() {
    let mut harness = marked_app([1200.0, 900.0]);
    harness.run_steps(20);
    let (before, _) = marks_of_source(&harness);
    harness.get_by_label("Mark 3 of the source").focus();
    harness.run_steps(3);
    harness.key_press(egui::Key::ArrowRight);
    harness.run_steps(3);
    harness.key_press_modifiers(egui::Modifiers::SHIFT, egui::Key::ArrowLeft);
    harness.run_steps(3);
    let (after, _) = marks_of_source(&harness);
    assert!((after[2] - before[2] - 0.009).abs() < 1e-12, "{before:?}, {after:?}");
}

#[test]
fn a_mark_is_moved_by_a_finger_and_not_where_comparisons_are_locked() {
    let mut harness = marked_app([1200.0, 900.0]);
    harness.run_steps(20);
    let (before, places) = marks_of_source(&harness);
    // a finger beside the square takes it
    let at = places[3] + egui::vec2(-14.0, 0.0);
    let touch = |phase, pos| egui::Event::Touch {
        device_id: egui::TouchDeviceId(0),
        id: egui::TouchId(0),
        phase,
        pos,
        force: None,
    };
    let button = |pos, pressed| egui::Event::PointerButton {
        pos,
        button: egui::PointerButton::Primary,
        pressed,
        modifiers: egui::Modifiers::NONE,
    };
    let down = [touch(egui::TouchPhase::Start, at), egui::Event::PointerMoved(at), button(at, true)];
    for event in down {
        harness.event(event);
    }
    harness.step();
    let to = at + egui::vec2(0.0, 20.0);
    for event in [touch(egui::TouchPhase::Move, to), egui::Event::PointerMoved(to)] {
        harness.event(event);
    }
    harness.step();
    for event in [touch(egui::TouchPhase::End, to), button(to, false)] {
        harness.event(event);
    }
    harness.step();
    let (moved, places) = marks_of_source(&harness);
    assert_ne!(moved[3], before[3]);
    // locked, it stays
    crate::app::input::locks::Locks::parse("comparison").0.install(&harness.ctx);
    harness.drag_at(places[1]);
    harness.step();
    harness.hover_at(places[1] + egui::vec2(0.0, 30.0));
    harness.step();
    harness.drop_at(places[1] + egui::vec2(0.0, 30.0));
    harness.run_steps(3);
    assert_eq!(marks_of_source(&harness).0, moved);
}

/// Waits for the map projection, which takes seconds.
fn until_mapped(harness: &mut Harness<'_, RiemapApp>) {
    for _ in 0..20 {
        if harness.state().windows.projection.found().is_none() {
            std::thread::sleep(std::time::Duration::from_secs(1));
            harness.step();
        }
    }
    step_until(harness, |app| app.windows.projection.found().is_some());
}

#[test]
fn the_island_is_mapped_in_its_window_and_ready_to_be_saved() {
    let mut harness = ready_app([1200.0, 900.0]);
    harness.get_by_label("File").click();
    harness.run_steps(4);
    harness.get_by_label_contains("Map projection…").click();
    harness.run_steps(3);
    assert_eq!(harness.state().stats().screen.windows.projection, Some(ProjectionStats::default()));
    harness.get_by_label("Show an island").click();
    until_mapped(&mut harness);
    harness.run_steps(2);
    harness.get_by_label("Save the map as CSV");
    harness.get_by_label_contains("Lines of equal scale");
    let shown = harness.state().stats().screen.windows.projection.unwrap();
    let [ratio, other] = [shown.scale_ratio, shown.stereographic_scale_ratio].map(Option::unwrap);
    assert!(1.0 < ratio && ratio < other, "{ratio} and {other}");
    let file = harness.state().windows.projection.file(ProjectionFormat::Svg).unwrap();
    assert_eq!(file.name, "island_projection.svg");
    harness.key_press(egui::Key::Escape);
    harness.run_steps(2);
    assert!(!harness.state().windows.projection.is_open());
    assert_eq!(harness.state().stats().screen.windows.projection, None);
}

#[test]
fn a_geojson_file_that_is_opened_as_an_outline_is_offered_as_a_map() {
    let mut harness = ready_app([1200.0, 800.0]);
    let text = br#"{"type":"Polygon","coordinates":[[[0,40],[20,40],[20,50],[0,50],[0,40]]]}"#;
    let app = harness.state_mut();
    app.take_file(crate::model::files::FilePurpose::Outline(Side::Source), "box.geojson", Ok(text.to_vec()));
    step_until(&mut harness, |app| app.messages.offer.is_some());
    harness.run_steps(2);
    harness.get_by_label("Show as a map").click();
    until_mapped(&mut harness);
    let shown = harness.state().stats().screen.windows.projection.unwrap();
    assert!((shown.scale_ratio.unwrap() - 1.00297).abs() < 1e-5, "{shown:?}");
    assert!(harness.state().messages.offer.is_none());
    // a file that is no region is refused in the window
    let context = harness.ctx.clone();
    let app = harness.state_mut();
    app.take_file(crate::model::files::FilePurpose::Region, "b.geojson", Ok(b"{\"type\":\"Circle\"}".to_vec()));
    step_until(&mut harness, |app| !app.errors().is_empty());
    let app = harness.state_mut();
    assert!(app.errors()[0].english().starts_with("b.geojson: "), "{:?}", app.errors());
    app.carry_out(&context, vec![Action::Projection(ProjectionAction::Close)]);
    assert!(app.errors().is_empty());
}
