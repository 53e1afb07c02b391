//! The side panel: what its controls ask for, and how it names its state.

use super::*;
use crate::app::input::preferences::Habit;
use crate::app::panels::side_panel;
use crate::app::panels::side_panel::Column;
use crate::model::overlays::walks::WalkAction;
use crate::session::{Colouring, Comparison, Holes, SurfaceShape, SurfaceSpec, SurfaceState, TextureKind};
use crate::tiling::{Tiling, TilingPattern, TilingStyle};

/// The column with its advanced controls.
const UNFOLDED: Column<'static> = Column { image_name: None, advanced: true, uv: false, in_sheet: false };

/// Clicks on `label` in the side panel and returns the emitted actions.
pub fn click_in_panel(model: &Model, label: &str) -> Actions {
    let mut actions = Actions::new();
    let mut harness = Harness::builder().with_size([260.0, 2400.0]).with_context_setup(theme::install).build_ui(|ui| {
        side_panel::show(ui, model, &Player::default(), UNFOLDED, &mut actions);
    });
    harness.get_by_label(label).click();
    harness.run();
    drop(harness);
    actions
}

#[test]
fn forward_is_one_click_away() {
    let model = prepared_model();
    assert_eq!(click_in_panel(&model, "Forward"), [Action::Session(Command::SetDirection(Direction::Forward))]);
}

#[test]
fn a_click_on_the_selected_choice_emits_no_action() {
    let model = prepared_model();
    assert_eq!(click_in_panel(&model, "Backward"), []);
}

#[test]
fn textures_are_chosen_by_name_and_the_image_asks_for_a_file_first() {
    let model = prepared_model();
    assert_eq!(click_in_panel(&model, "Polar"), [Action::Session(Command::SetTexture(TextureKind::Conformal))]);
    assert_eq!(click_in_panel(&model, "Image"), [Action::OpenImage]);
}

#[test]
fn comparisons_walks_and_polar_grids_are_one_click_away() {
    let mut model = prepared_model();
    for (label, action) in [
        ("In the target", Action::Session(Command::SetTextureSide(Side::Target))),
        ("Fresh", Action::Session(Command::SetComparison(Comparison::Fresh))),
        ("Precomputed", Action::Session(Command::SetComparison(Comparison::Precomputed))),
        ("Both", Action::Session(Command::SetComparison(Comparison::Both))),
        ("Start", Action::Walks(WalkAction::Toggle)),
    ] {
        assert_eq!(click_in_panel(&model, label), [action]);
    }
    model.dispatch(Command::SetTexture(TextureKind::Conformal), 0.0);
    assert_eq!(click_in_panel(&model, "Euclidean"), [Action::Session(Command::SetTexture(TextureKind::Polar))]);
    model.dispatch(Command::SetTexture(TextureKind::Polar), 0.0);
    assert_eq!(click_in_panel(&model, "Conformal"), [Action::Session(Command::SetTexture(TextureKind::Conformal))]);
    assert_eq!(click_in_panel(&model, "Polar"), [], "a Euclidean polar grid is polar");
}

#[test]
fn the_plots_name_what_is_drawn_over_them_and_the_walks_repaint_only_while_they_run() {
    let mut harness = ready_app([1200.0, 1700.0]);
    harness.state_mut().recall(Habit::Advanced(true));
    harness.key_press(egui::Key::P);
    harness.run_steps(2);
    harness.get_by_label("Both").click();
    harness.run_steps(30);
    let stats = harness.state().stats();
    for compared in [stats.overlays.comparison.fresh.unwrap(), stats.overlays.comparison.precomputed.unwrap()] {
        assert!(compared.difference < 0.05 && compared.disordered == [0, 0], "{compared:?}");
    }
    assert_eq!(stats.overlays.walks, (0, None));
    harness.get_by_label("Start").click();
    harness.run_steps(200);
    let (walks, deviation) = harness.state().stats().overlays.walks;
    assert!(walks > 0 && deviation.is_some(), "{walks} walks");
    assert!(harness.try_run().is_err(), "walks go on");
    harness.get_by_label("Pause").click();
    harness.run_steps(2);
    let (paused, _) = harness.state().stats().overlays.walks;
    harness.try_run().unwrap();
    assert_eq!(harness.state().stats().overlays.walks.0, paused);
}

#[test]
fn corners_can_be_kept_on_either_side() {
    let model = prepared_model();
    let mut actions = Actions::new();
    let mut harness = Harness::builder().with_size([260.0, 2400.0]).with_context_setup(theme::install).build_ui(|ui| {
        side_panel::show(ui, &model, &Player::default(), UNFOLDED, &mut actions);
    });
    let target = harness.get_all_by_label("Keep corners").last().unwrap();
    target.click();
    harness.run();
    drop(harness);
    let settings = PrepareSettings {
        sampling: Sampling::Uniform { count: 120, keep_corners: true },
        sizing: Sizing::Graded(0.3),
        ..PrepareSettings::default()
    };
    assert_eq!(actions, [Action::Session(Command::SetSettings { side: Side::Target, settings })]);
}

#[test]
fn the_selected_segment_says_so_to_assistive_technology() {
    let model = prepared_model();
    let mut actions = Actions::new();
    let harness = Harness::builder().with_size([260.0, 2400.0]).with_context_setup(theme::install).build_ui(|ui| {
        side_panel::show(ui, &model, &Player::default(), UNFOLDED, &mut actions);
    });
    let toggled = |label| harness.get_by_label(label).accesskit_node().toggled();
    assert_eq!(toggled("Checker"), Some(egui::accesskit::Toggled::True));
    assert_eq!(toggled("Grid"), Some(egui::accesskit::Toggled::False));
}

#[test]
fn colourings_and_the_mesh_are_one_click_away() {
    let model = prepared_model();
    for (label, command) in [
        ("Angle", Command::SetColouring(Colouring::Angle)),
        ("Area", Command::SetColouring(Colouring::Area)),
        ("Mesh", Command::SetWireframe(true)),
    ] {
        assert_eq!(click_in_panel(&model, label), [Action::Session(command)]);
    }
}

/// A square of 4 × 4 cells with a hole of one cell in the place of the target, repaired.
fn holed_model() -> Model {
    let shape = SurfaceShape::File { name: "holed.obj".into() };
    let state = SurfaceState::new(SurfaceSpec::new(shape).with_repair(true));
    let vertices = (0..25).map(|k| format!("v {} {} 0\n", k % 5, k / 5));
    let corners = (0..16).filter(|&cell| cell != 5).map(|cell| 1 + cell / 4 * 5 + cell % 4);
    let faces = corners.map(|a| format!("f {a} {} {} {}\n", a + 1, a + 6, a + 5));
    let bytes = vertices.chain(faces).collect::<String>().into_bytes();
    let session = Session::default().and([Command::SetSurface { side: Side::Target, surface: state.spec().clone() }]);
    crate::model::scene::Offscreen::new(&session, [None, Some(bytes)].into(), 1.0).unwrap().into_model()
}

#[test]
fn boundary_loops_open_holes_and_the_uv_grid_are_one_click_away() {
    let model = holed_model();
    let chosen = model.choose_outline(Side::Target, 1).unwrap();
    assert_eq!(click_in_panel(&model, "2: length 4.0000, 4 vertices"), [Action::Session(chosen)]);
    assert_eq!(click_in_panel(&model, "1: length 16.0000, 16 vertices"), [], "that is the outline");
    let open = Command::SetHoles { side: Side::Target, holes: Holes::Open };
    assert_eq!(click_in_panel(&model, "Open"), [Action::Session(open)]);
    assert_eq!(click_in_panel(&model, "UV grid"), [Action::ShowUv(true)]);
}

#[test]
fn a_tiling_has_two_numbers_and_styles_and_no_number_of_cells() {
    let mut model = prepared_model();
    assert_eq!(click_in_panel(&model, "Tiles"), [Action::Session(Command::SetTexture(TextureKind::Tiling))]);
    model.dispatch(Command::SetTexture(TextureKind::Tiling), 0.0);
    let styled = |style| Action::Session(Command::SetTiling(TilingPattern { style, ..TilingPattern::default() }));
    assert_eq!(click_in_panel(&model, "Mirrors"), [styled(TilingStyle::Triangles)]);
    assert_eq!(click_in_panel(&model, "Edges"), [styled(TilingStyle::Edges)]);
    let harness = Harness::builder().with_size([260.0, 2400.0]).with_context_setup(theme::install).build_ui(|ui| {
        side_panel::show(ui, &model, &Player::default(), UNFOLDED, &mut Actions::new());
    });
    assert!(
        harness.query_by_label_contains("cells across").is_none() && harness.query_by_label("In the target").is_none()
    );
    assert_eq!(harness.query_all_by_label("Image").count(), 2, "as the pattern, and in the tiles");
}

/// On the way from {7, 3} to {4, 5} lies {4, 3}, the cube: the picture keeps its tiling until the pair is one.
#[test]
fn numbers_without_a_hyperbolic_tiling_are_explained_and_change_nothing() {
    let mut model = prepared_model();
    model.dispatch(Command::SetTexture(TextureKind::Tiling), 0.0);
    let show = |ui: &mut egui::Ui, model: &mut Model| {
        let mut actions = Actions::new();
        side_panel::show(ui, model, &Player::default(), UNFOLDED, &mut actions);
        for action in actions {
            if let Action::Session(command) = action {
                model.dispatch(command, 0.0);
            }
        }
    };
    let panel = Harness::builder().with_size([260.0, 2400.0]).with_context_setup(theme::install);
    let mut harness = panel.build_ui_state(show, model);
    let numbers = |harness: &Harness<'_, Model>| harness.state().session().tiling().tiling;
    let typed = |harness: &mut Harness<'_, Model>, name: &str, text: &str| {
        let is_named = |label: Option<String>| label.is_some_and(|label| label.starts_with(name));
        let sliders: Vec<_> = harness.get_all_by_role(egui::accesskit::Role::Slider).collect();
        sliders.iter().find(|slider| is_named(slider.accesskit_node().label())).unwrap().click();
        drop(sliders);
        harness.run();
        harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
        harness.event(egui::Event::Text(text.to_owned()));
        harness.run();
        harness.key_press(egui::Key::Enter);
        harness.run();
    };
    typed(&mut harness, "Sides", "4");
    assert_eq!(numbers(&harness), Tiling::default());
    let is_said = |harness: &Harness<'_, Model>, words: &str| harness.query_all_by_label_contains(words).count() > 0;
    assert!(is_said(&harness, "{4, 3} lives on the sphere: it is the cube"));
    typed(&mut harness, "At a corner", "4");
    assert_eq!(numbers(&harness), Tiling::default());
    assert!(is_said(&harness, "{4, 4} lives in the plane"));
    typed(&mut harness, "At a corner", "5");
    assert_eq!(numbers(&harness), Tiling::new(4, 5).unwrap());
    assert!(!is_said(&harness, "the picture keeps its tiling"));
}
