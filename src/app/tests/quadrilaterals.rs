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
            Action::Invariants(InvariantsAction::Marks(Side::Source, marks)),
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
    assert_eq!(harness.state().stats().overlays.grid_lines, [19 + 9, 0]);
    let onto = harness.state().model.onto_rectangle(Side::Source).unwrap().unwrap();
    let context = harness.ctx.clone();
    harness.state_mut().carry_out(&context, vec![Action::Session(onto)]);
    step_until(&mut harness, |app| app.stats().overlays.grid_lines == [19 + 9; 2]);
    // a grid that is hidden while it is computed is given up
    let cells = crate::conformal::GridCells::new([1000, 1000]).unwrap();
    let app = harness.state_mut();
    app.carry_out(&context, vec![Action::Grid(GridAction::Cells(Side::Source, cells))]);
    harness.step();
    assert!(harness.state().model.grid_progress(Side::Source).is_some());
    harness.state_mut().carry_out(&context, vec![Action::Grid(GridAction::Show(Side::Source, false))]);
    harness.step();
    assert_eq!(harness.state().stats().overlays.grid_lines, [0, 0]);
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
