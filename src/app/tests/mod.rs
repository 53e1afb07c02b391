//! The panels and the whole app, driven by clicks, drags and keys.

mod best;
mod colour_vision;
mod corners;
mod first_visit;
mod fitting;
mod frame;
mod incoming;
mod language;
mod lessons;
mod locks;
mod panels;
mod playing;
mod quadrilaterals;
mod surfaces;
mod symmetry;
mod tour;

use super::*;
use crate::app::language::words;
use crate::app::status::stats::ScreenStats;
use crate::conformal::{Direction, Extension, PrepareSettings, Side};
use crate::mesh::Sizing;
use crate::model::Processor;
use crate::outline::{Preset, Sampling};
use crate::session::{Command, OutlineSpec};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};

/// A model with both domains prepared at a coarse resolution.
pub fn prepared_model() -> Model {
    let mut session = Session::default();
    let sampling = Sampling::Uniform { count: 120, keep_corners: false };
    for side in Side::BOTH {
        session.apply(Command::SetSettings {
            side,
            settings: PrepareSettings { sampling, sizing: Sizing::Graded(0.3), ..PrepareSettings::default() },
        });
    }
    let mut model = Model::new(session);
    finish_preparations(&mut model);
    model
}

fn finish_preparations(model: &mut Model) {
    // a side's outline is requested only after its surface is prepared, so ask until no request is left
    while let requests @ [_, ..] = model.take_requests(f64::INFINITY).as_slice() {
        for (side, request) in requests {
            crate::worker::run(request, &mut |generation, response| model.accept(*side, generation, response));
        }
    }
    model.refresh(false);
}

/// Steps until a worker's response has taken effect.
pub fn step_until(harness: &mut Harness<'_, RiemapApp>, is_there: impl Fn(&RiemapApp) -> bool) {
    for _ in 0..600 {
        harness.step();
        if is_there(harness.state()) {
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert!(is_there(harness.state()), "after 600 frames: {:?}", harness.state().stats());
}

#[test]
fn the_map_exists_once_both_sides_are_prepared() {
    let model = prepared_model();
    assert!(model.is_ready() && model.generation() == 1);
    let quality = model.quality().unwrap();
    assert!(quality.q_mean >= 1.0 && quality.q_mean.is_finite(), "Q {}", quality.q_mean);
}

#[test]
fn while_a_side_is_prepared_the_last_map_stays_and_its_handles_work() {
    let mut model = prepared_model();
    model.dispatch(Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Star) }, 1.0);
    assert!(!model.is_ready() && model.map().is_some());
    assert_eq!(model.session().domain(Side::Source).outline, OutlineSpec::Preset(Preset::Gingerbread));
    let point = model.interior(Side::Target).unwrap() + glam::DVec2::new(0.05, 0.0);
    model.dispatch(Command::MoveInterior { side: Side::Target, point: point.into() }, 1.0);
    assert!(model.refresh(false).images);
    finish_preparations(&mut model);
    assert_eq!(model.session().domain(Side::Source).outline, OutlineSpec::Preset(Preset::Star));
    assert_eq!(model.interior(Side::Target), Some(point));
    assert!(model.is_ready());
}

#[test]
fn a_point_outside_is_refused_and_the_map_stays() {
    let mut model = prepared_model();
    let before = model.interior(Side::Source);
    let generation = model.generation();
    let point = glam::DVec2::new(1e3, 0.0);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
    model.refresh(false);
    assert_eq!(model.interior(Side::Source), before);
    assert_eq!(model.generation(), generation);
    assert_eq!(model.map_error().unwrap().0, Side::Source);
}

#[test]
fn the_handle_of_a_pointer_outside_is_inside() {
    let model = prepared_model();
    for angle in 0..16 {
        let far = 10.0 * glam::DVec2::from_angle(std::f64::consts::TAU * f64::from(angle) / 16.0);
        let near = model.interior_near(Side::Source, far).unwrap();
        let mut moved = prepared_model();
        moved.dispatch(Command::MoveInterior { side: Side::Source, point: near.into() }, 0.0);
        assert!(moved.refresh(false).images, "no map at {near}: {:?}", moved.map_error());
    }
}

#[test]
fn swapping_exchanges_the_prepared_domains_without_preparing_again() {
    let mut model = prepared_model();
    let source = std::sync::Arc::clone(model.domain(Side::Source).unwrap());
    model.dispatch(Command::Swap, 0.0);
    assert!(model.refresh(false).meshes && model.is_ready());
    assert!(std::sync::Arc::ptr_eq(&source, model.domain(Side::Target).unwrap()));
}

#[test]
fn cauchy_green_images_are_filled_in_frame_by_frame() {
    let mut model = prepared_model();
    let harmonic = model.map().unwrap().images().to_vec();
    model.dispatch(Command::SetExtension(Extension::CauchyGreen), 0.0);
    let mut frames = 0;
    while model.refresh(false).images {
        frames += 1;
        assert!(frames < 1000, "the extension never ends");
    }
    let map = model.map().unwrap();
    assert!(frames > 0 && map.extension_progress() == 1.0);
    assert_ne!(map.images(), harmonic);
    model.dispatch(Command::SetExtension(Extension::Harmonic), 0.0);
    assert!(model.refresh(false).images && !model.refresh(false).images);
    assert_eq!(model.map().unwrap().images(), harmonic);
}

/// Fails where there is no graphics adapter.
pub fn need_adapter() {
    let found = crate::render::headless_device().err();
    assert!(
        found.is_none(),
        "a graphics adapter is needed, in software too (`cargo xtask test` installs one): {found:?}"
    );
}

#[test]
fn a_drag_shows_cauchy_green_at_once_and_refines_the_map_at_rest() {
    need_adapter();
    let mut session = prepared_model().session().clone();
    session.apply(Command::SetExtension(Extension::CauchyGreen));
    let startup = Startup::start(session);
    let mut harness = Harness::builder()
        .with_size([1200.0, 800.0])
        .wgpu()
        .build_eframe(|creation| RiemapApp::new(creation, startup).unwrap());
    let settle = |harness: &mut Harness<'_, RiemapApp>| {
        let mut steps = (0..600).map(|_| {
            harness.step();
            std::thread::sleep(std::time::Duration::from_millis(5));
            harness.state().stats()
        });
        let is_settled = |stats: &Stats| {
            stats.preparation.ready
                && stats.map.extension_progress == 1.0
                && stats.quality.measured_generation == stats.map.generation
        };
        steps.find(is_settled).unwrap()
    };
    let before = settle(&mut harness);
    assert_eq!(before.screen.cauchy_green, Some(Processor::Gpu));
    let [x, y] = before.screen.handles.x1.unwrap();
    harness.drag_at(egui::pos2(x, y));
    harness.step();
    for step in 1..4 {
        harness.hover_at(egui::pos2(x + 4.0 * step as f32, y));
        harness.step();
        let stats = harness.state().stats();
        assert_eq!(
            (stats.screen.cauchy_green, stats.map.extension_progress),
            (Some(Processor::Gpu), 0.0),
            "step {step}"
        );
    }
    harness.drop_at(egui::pos2(x + 12.0, y));
    let after = settle(&mut harness);
    assert!(after.map.generation > before.map.generation && after.quality.q_mean != before.quality.q_mean);
    let words = words::cauchy_green(Processor::Gpu, 1.0);
    assert!(harness.query_by_label_contains(&words).is_some(), "{words} is not on the screen");
}

#[test]
fn the_mapped_point_goes_to_the_other_sides_point() {
    for direction in [Direction::Forward, Direction::Backward] {
        let mut model = prepared_model();
        model.dispatch(Command::SetDirection(direction), 0.0);
        model.refresh(false);
        let stats = Stats::new(&model, ScreenStats::default());
        let (image, expected) = (stats.map.image_of_mapped_point.unwrap(), stats.map.expected.unwrap());
        let error = glam::DVec2::from(image).distance(expected.into());
        // with 120 samples and triangles that grow by 0.3 per distance, the triangle around x is about 0.1 across
        assert!(error < 0.05, "{direction:?}: f(x) = {image:?}, expected {expected:?}, error {error:e}");
    }
}

#[test]
fn opening_a_session_brings_its_domains_points_and_looks() {
    let mut model = prepared_model();
    let scene = crate::figures::Figure::Moebius.scenes(crate::figures::Detail::Quick).remove(0);
    model.dispatch(Command::Open(Box::new(scene.session.clone())), 0.0);
    model.refresh(false);
    assert!(model.map().is_some(), "the last good map stays meanwhile");
    finish_preparations(&mut model);
    assert_eq!(*model.session(), scene.session);
    // the same domains with other points need no preparation
    let point = glam::DVec2::new(0.1, -0.3);
    let moved = scene.session.and([Command::MoveInterior { side: Side::Source, point: point.into() }]);
    model.dispatch(Command::Open(Box::new(moved.clone())), 0.0);
    assert!(model.take_requests(f64::INFINITY).is_empty());
    assert!(model.refresh(false).images);
    assert_eq!(*model.session(), moved);
    assert!(model.map_error().is_none());
}

#[test]
fn opening_a_figure_of_a_surface_brings_the_surface() {
    use crate::figures::{Detail, Figure};
    for figure in [Figure::LShapes, Figure::Head, Figure::Face] {
        let mut model = prepared_model();
        let scene = figure.scenes(Detail::Quick).remove(1);
        model.dispatch(Command::Open(Box::new(scene.session.clone())), 0.0);
        finish_preparations(&mut model);
        assert_eq!(*model.session(), scene.session, "{figure:?}");
        let map = model.map().filter(|_| !model.is_planar()).unwrap();
        assert!(map.quality().q_mean < 1.3 && model.map_error().is_none(), "{figure:?}: {:?}", map.quality());
    }
}

/// The app with its first map on the screen.
pub fn ready_app(size: [f32; 2]) -> Harness<'static, RiemapApp> {
    let mut harness = Harness::builder()
        .with_size(size)
        .build_eframe(|creation| RiemapApp::new(creation, Startup::start(Session::default())).unwrap());
    for _ in 0..600 {
        harness.step();
        if harness.state().stats().preparation.ready {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let stats = harness.state().stats();
    assert!(stats.preparation.ready, "{stats:?}");
    // gestures and dots are read before a frame's update: they are there from the next one on
    harness.step();
    harness
}

#[test]
fn distortions_belong_to_the_map_on_the_screen() {
    let mut model = prepared_model();
    assert_eq!(model.measured_generation(), model.generation());
    for direction in [Direction::Forward, Direction::Backward] {
        model.dispatch(Command::SetDirection(direction), 0.0);
        model.refresh(false);
        assert_eq!(model.triangles().len(), model.map().unwrap().mapped().triangles().len());
        assert_eq!(model.measured_generation(), model.generation(), "another mesh is measured at once");
    }
    let flipped = model.triangles().iter().filter(|triangle| triangle.flipped).count();
    assert_eq!(flipped, model.quality().unwrap().flipped as usize);
}

#[test]
fn the_key_p_opens_the_plots_and_closes_them() {
    for size in [[1200.0, 800.0], [390.0, 844.0]] {
        let mut harness = ready_app(size);
        assert!(!harness.state().stats().overlays.plots && harness.query_by_label("Harmonic measure").is_none());
        harness.key_press(egui::Key::P);
        harness.step();
        assert!(harness.state().stats().overlays.plots);
        if size[0] > theme::PHONE_WIDTH {
            for title in ["Poisson kernel", "Harmonic measure", "Reparameterization"] {
                harness.get_by_label(title);
            }
        }
        harness.key_press(egui::Key::P);
        harness.step();
        assert!(!harness.state().stats().overlays.plots && harness.query_by_label("Harmonic measure").is_none());
    }
}

#[test]
fn on_a_phone_the_sheet_has_one_plot_at_a_time() {
    let mut harness = ready_app([390.0, 844.0]);
    harness.get_by_label("Plots").click();
    harness.run_steps(40);
    harness.get_by_label("Poisson kernel");
    harness.get_by_label("Measure").click();
    harness.run_steps(4);
    harness.get_by_label("Harmonic measure");
    assert!(harness.query_by_label("Poisson kernel").is_none());
    harness.get_by_label("Controls").click();
    harness.run_steps(4);
    assert!(harness.query_by_label("Harmonic measure").is_none() && !harness.state().stats().overlays.plots);
}

#[test]
fn pointing_at_a_boundary_marks_it_and_its_partner() {
    let mut harness = ready_app([1200.0, 800.0]);
    assert_eq!(harness.state().stats().screen.plots.marked_boundary, None);
    let app = harness.state();
    let samples = app.model.domain(Side::Source).unwrap().samples();
    let place = app.pictures.views[Side::Source].to_screen(samples.position(samples.at_fraction(0.31)));
    harness.hover_at(place);
    harness.run_steps(3);
    let [source, target] = harness.state().stats().screen.plots.marked_boundary.unwrap();
    // A pixel is about 1/3000 of the outline's length.
    assert!((source - 0.31).abs() < 2e-3, "pointed at 0.31, marked {source}");
    let map = harness.state().model.map().unwrap();
    let boundary =
        |side: Side, fraction| map.domain(side).unwrap().samples().position(map.side(side).at_fraction(fraction));
    // Backward, the target's boundary vertex nearest to its mark is mapped to the source's mark.
    let samples = map.domain(Side::Target).unwrap().samples();
    let image = map.images()[samples.at_fraction(target).edge() as usize];
    let error = image.distance(boundary(Side::Source, source));
    assert!(error < 0.03, "f⁻¹ of the partner is {error} away");
    harness.hover_at(egui::pos2(600.0, 20.0));
    harness.run_steps(3);
    assert_eq!(harness.state().stats().screen.plots.marked_boundary, None);
}

#[test]
fn pointing_at_a_plot_marks_the_boundary() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.key_press(egui::Key::P);
    harness.run_steps(2);
    let title = harness.get_by_label("Reparameterization").rect();
    harness.hover_at(title.center_bottom() + egui::vec2(60.0, 60.0));
    harness.run_steps(3);
    let [_, target] = harness.state().stats().screen.plots.marked_boundary.unwrap();
    assert!(target > 0.05 && target < 0.6, "a third of the way along the axis: {target}");
    // The headers show the values at the mark instead of the sides' names.
    assert!(harness.query_by_label("source").is_none() && harness.query_by_label("target").is_none());
    harness.hover_at(egui::pos2(600.0, 20.0));
    harness.run_steps(3);
    assert_eq!(harness.state().stats().screen.plots.marked_boundary, None);
    // kernel and measure have a curve for each side, the reparameterization has one
    assert_eq!(harness.query_all_by_label("source").count(), 2);
}

#[test]
fn the_app_prepares_shows_and_answers_to_a_drag() {
    let mut harness = ready_app([1200.0, 800.0]);
    let before = harness.state().stats();
    harness.get_by_label("scroll to zoom · drop a file anywhere");
    let [x, y] = before.screen.handles.x1.unwrap();
    harness.drag_at(egui::pos2(x, y));
    harness.step();
    harness.hover_at(egui::pos2(x + 12.0, y + 9.0));
    harness.step();
    harness.drop_at(egui::pos2(x + 12.0, y + 9.0));
    harness.step();
    let after = harness.state().stats();
    assert!(after.map.generation > before.map.generation);
    let [u, v] = after.screen.handles.x1.unwrap();
    assert!((u - x - 12.0).abs() < 0.6 && (v - y - 9.0).abs() < 0.6, "from {x}, {y} to {u}, {v}");
}

#[test]
fn on_a_phone_everything_that_is_pressed_is_as_large_as_a_fingertip() {
    let mut harness = ready_app([390.0, 844.0]);
    harness.state_mut().screen.sheet_open = true;
    harness.run_steps(20);
    let mut checked = 0;
    for node in harness.root().children_recursive() {
        let accessible = node.accesskit_node();
        let is_pressed = matches!(
            accessible.role(),
            egui::Role::Button | egui::Role::RadioButton | egui::Role::CheckBox | egui::Role::Slider
        );
        if is_pressed && let Some(bounds) = accessible.bounding_box() {
            let (width, height) = (bounds.x1 - bounds.x0, bounds.y1 - bounds.y0);
            assert!(width.min(height) >= 39.9, "{:?}: {width} × {height}", accessible.label());
            checked += 1;
        }
    }
    assert!(checked > 20, "only {checked} controls");
}
