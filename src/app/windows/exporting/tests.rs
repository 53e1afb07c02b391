//! Exports do not change the model, and the window reports what cannot be exported.

use crate::app::RiemapApp;
use crate::app::input::action::{Action, ExportAction};
use crate::app::tests::{need_adapter, prepared_model, ready_app, step_until};
use crate::app::windows::exporting::Exporter;
use crate::app::windows::exporting::window::{MapState, Surroundings};
use crate::conformal::{PerSide, Side};
use crate::export::{FileFormat, FormulaFormat};
use crate::family::Path;
use crate::language::key;
use crate::model::export::ReadyFile;
use crate::model::export::request::{ExportRequest, Kind};
use crate::model::scene::Offscreen;
use crate::model::{Abilities, Model};
use crate::offscreen::job::{Job, Progress, Scenery};
use crate::rational::Reached;
use crate::render::{FilmFormat, Studio, headless_device};
use crate::session::{Command, SurfaceShape, SurfaceSpec};
use crate::surface::SurfacePreset;
use crate::worker::{Finding, FormulaTask, FoundFormula};
use egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use image::AnimationDecoder;
use image::codecs::gif::GifDecoder;
use image::codecs::png::PngDecoder;
use std::io::Cursor;

fn scenery() -> Scenery {
    Scenery { image: None, cameras: PerSide::default(), dark: true }
}

fn request(kind: Kind) -> ExportRequest {
    ExportRequest { kind, size: [240, 120], frames: 4, seconds: 1.0, ..ExportRequest::default() }
}

/// Runs the job as the app does, frame by frame, and returns its file.
fn made(model: &Model, request: &ExportRequest) -> ReadyFile {
    let (device, queue, _) = headless_device().unwrap();
    let mut job = Job::begin(model, request, scenery(), (&device, &queue)).unwrap();
    let mut last = 0.0;
    for _ in 0..100_000 {
        match job.work((&device, &queue)).unwrap() {
            Progress::Done(file) => return file,
            Progress::GoesOn => {
                assert!(job.progress() >= last, "the progress goes back from {last} to {}", job.progress());
                last = job.progress();
            }
        }
    }
    unreachable!("the job never ends")
}

#[test]
fn a_picture_is_that_of_the_command_line_and_the_model_stays() {
    need_adapter();
    let model = prepared_model();
    let (session, generation) = (model.session().clone(), model.generation());
    let request = ExportRequest { transparent: true, ..request(Kind::Picture) };
    let file = made(&model, &request);
    assert_eq!(file.name, "riemap.png");
    let picture = image::load_from_memory(&file.bytes).unwrap().into_rgba8();
    let shot = request.shot(true);
    let offscreen = Offscreen::new(&session, PerSide::default(), shot.pixels_per_point()).unwrap();
    let expected = Studio::new()
        .unwrap()
        .shoot(|renderer, device, queue| offscreen.draw(renderer, (device, queue), &shot, None, PerSide::default()));
    assert_eq!(picture, expected.unwrap());
    assert_eq!(picture.get_pixel(0, 0).0[3], 0, "the background is transparent");
    assert_eq!((model.session(), model.generation()), (&session, generation));
}

#[test]
fn an_animation_has_its_pictures_and_the_model_stays() {
    need_adapter();
    let model = prepared_model();
    let session = model.session().clone();
    for (format, path) in [(FilmFormat::Png, Path::All), (FilmFormat::Gif, Path::SourcePoint)] {
        let file = made(&model, &ExportRequest { path, ..request(Kind::Film(format)) });
        let bytes = Cursor::new(&file.bytes);
        let frames = match format {
            FilmFormat::Png => PngDecoder::new(bytes).unwrap().apng().unwrap().into_frames().collect_frames(),
            FilmFormat::Gif => GifDecoder::new(bytes).unwrap().into_frames().collect_frames(),
        };
        let frames = frames.unwrap();
        assert_eq!(frames.len(), 4);
        assert!(frames.windows(2).all(|pair| pair[0].buffer() != pair[1].buffer()), "{format:?}: equal frames");
    }
    assert_eq!(model.session(), &session);
}

#[test]
fn a_cancelled_export_is_dropped_and_can_be_restarted() {
    need_adapter();
    let model = prepared_model();
    let (device, queue, _) = headless_device().unwrap();
    let mut exporter = Exporter::default();
    for _ in 0..2 {
        exporter.begin(Job::begin(&model, &request(Kind::Film(FilmFormat::Gif)), scenery(), (&device, &queue)));
        assert!(exporter.is_busy() && exporter.work((&device, &queue)).is_none());
        assert_eq!(exporter.count().unwrap()[1], 4);
        exporter.cancel();
        assert!(!exporter.is_busy() && exporter.work((&device, &queue)).is_none());
    }
}

#[test]
fn invalid_animations_are_refused_with_a_message() {
    need_adapter();
    let (device, queue, _) = headless_device().unwrap();
    let request = ExportRequest { frames: 1, ..request(Kind::Film(FilmFormat::Gif)) };
    let refused = Job::begin(&prepared_model(), &request, scenery(), (&device, &queue)).err();
    assert!(refused.unwrap().english().contains("1 frame:"));
}

#[test]
fn planar_maps_and_surfaces_have_their_own_formats() {
    let all = [[false, false], [false, true], [true, false], [true, true]];
    let all = all.map(|[source, target]| Abilities::between(PerSide::new(source, target)));
    let with_coordinates = all.map(|abilities| Kind::all(abilities).contains(&Kind::File(FileFormat::Glb)));
    assert_eq!(with_coordinates, [false, true, true, true]);
    for abilities in all {
        let labels: Vec<_> = Kind::all(abilities).iter().map(|kind| kind.label().english()).collect();
        assert!(labels.contains(&"PNG") && labels.contains(&"GIF") && labels.contains(&"SVG"), "{labels:?}");
    }
}

/// This harness has no graphics device: the window reports the error, and nothing hangs.
#[test]
fn the_window_opens_by_key_reports_errors_and_closes() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run_steps(4);
    for label in ["PNG", "SVG", "CSV", "OBJ", "Animated PNG", "GIF", "Transparent"] {
        assert!(harness.query_all_by_label(label).count() >= 1, "{label}");
    }
    harness.get_by_label("GIF").click();
    harness.run_steps(3);
    assert!(harness.query_all_by_label("Duration").count() >= 1);
    harness.get_by_label("PNG").click();
    harness.run_steps(3);
    harness.get_by_label("Save").click();
    harness.run_steps(3);
    assert!(harness.query_by_label("There is no graphics device to draw with.").is_some());
    harness.key_press(Key::Escape);
    harness.run_steps(3);
    assert_eq!(harness.state().stats().screen.windows.export, None);
}

#[test]
fn the_label_of_the_size_is_beside_the_first_line_of_choices() {
    for size in [[1440.0, 900.0], [720.0, 450.0], [390.0, 844.0]] {
        let abilities = Abilities::between(PerSide::new(false, false));
        let around = Surroundings { map: MapState::Ready, abilities, max_side: 8192, no_formula: None };
        let show = move |ui: &mut egui::Ui, exporter: &mut Exporter| {
            exporter.show(ui.ctx(), &around, &mut crate::app::input::action::Actions::new());
        };
        let mut exporter = Exporter::default();
        exporter.open();
        let harness = Harness::builder().with_size(size).with_context_setup(crate::app::theme::install);
        let mut harness = harness.build_ui_state(show, exporter);
        harness.run();
        let middle = |label: &str| harness.get_by_label(label).rect().center().y;
        assert!((middle("Size") - middle("800 × 450")).abs() < 1.5, "{size:?}");
        assert!(middle("1080 × 1080") > middle("800 × 450") + 20.0, "{size:?}: the choices take several lines");
    }
}

#[test]
fn on_a_phone_a_button_as_large_as_a_fingertip_closes_the_window() {
    let mut harness = ready_app([390.0, 844.0]);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run_steps(4);
    let button = harness.get_by_label("Close").rect();
    assert!(button.width().min(button.height()) >= 39.9, "{button:?}");
    let noted = harness.state().stats().screen.windows.export.unwrap()["Close"];
    assert!(egui::Pos2::from(noted).distance(button.center()) < 0.5, "{noted:?}, {button:?}");
    harness.get_by_label("Close").click();
    harness.run_steps(3);
    assert_eq!(harness.state().stats().screen.windows.export, None);
}

/// The app with the window open and a formula chosen.
fn formula_window() -> Harness<'static, RiemapApp> {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::E);
    harness.run_steps(4);
    harness.get_by_label("Formula").click();
    harness.run_steps(3);
    harness
}

fn progress(harness: &Harness<'_, RiemapApp>) -> Option<f64> {
    harness.state().stats().screen.windows.formula.progress
}

#[test]
fn a_formula_begins_in_its_worker_goes_on_and_is_cancelled() {
    let mut harness = formula_window();
    for label in ["Format", "Digits", "JSON", "Python", "Julia", "JavaScript", "GLSL"] {
        assert!(harness.query_all_by_label(label).count() >= 1, "{label}");
    }
    let session = harness.state().model.session().clone();
    harness.get_by_label("Save").click();
    harness.run_steps(2);
    step_until(&mut harness, |app| app.stats().screen.windows.formula.progress.is_some_and(|done| done > 0.0));
    assert!(harness.query_by_label("Save").is_none() && progress(&harness).unwrap() < 1.0);
    harness.get_by_label("Cancel").click();
    harness.run_steps(3);
    assert!(progress(&harness).is_none() && harness.query_by_label("Save").is_some());
    let task = harness.state().model.formula_task(FormulaFormat::Json, 8).unwrap();
    let exporter = &mut harness.state_mut().windows.exporter;
    assert!(exporter.accept_formula(&task, Finding::Failed("late".into())).is_none());
    harness.run_steps(3);
    let stats = harness.state().stats();
    assert!(stats.screen.windows.formula.reached.is_empty() && stats.screen.errors.is_empty(), "{stats:?}");
    assert_eq!(harness.state().model.session(), &session);
}

fn found(source: u32, target: u32) -> Finding {
    let reached = |digits| Reached {
        degree: 12,
        poles: 11,
        digits,
        error: 3.21e-7,
        boundary_error: 1e-5,
        is_boundary_exact: digits != 6,
    };
    let reached = PerSide::new(reached(source), reached(target));
    Finding::Formula(Box::new(FoundFormula { text: "the file".into(), reached }))
}

#[test]
fn a_finished_formula_is_a_file_and_the_window_says_what_it_reached() {
    let mut harness = formula_window();
    let task = harness.state().model.formula_task(FormulaFormat::Python, 8).unwrap();
    let sides = PerSide::from_fn(|side| harness.state().model.session().side(side).clone());
    let exporter = &mut harness.state_mut().windows.exporter;
    exporter.begin_formula(task.clone(), sides.clone());
    assert!(exporter.is_busy() && !exporter.is_drawing());
    let other = FormulaTask::new(&prepared_model().session().clone(), FormulaFormat::Glsl, 5).unwrap();
    assert!(exporter.accept_formula(&other, found(8, 8)).is_none(), "a finding about another task");
    assert!(exporter.accept_formula(&task, Finding::Progress(0.4)).is_none());
    assert_eq!(exporter.formula_progress(), Some(0.4));
    harness.run_steps(2);
    assert!(harness.query_by_label("40\u{a0}%").is_some());
    let file = harness.state_mut().windows.exporter.accept_formula(&task, found(6, 0)).unwrap();
    assert_eq!((file.name.as_str(), file.bytes.as_slice()), ("riemap_formula.py", b"the file".as_slice()));
    harness.run_steps(3);
    let expected = [
        "riemap_formula.py",
        "f: degree 12; poles: 11, none inside; largest error: 3.2e-7; digits: 6",
        "f reaches 6 of 8 digits",
        "The boundary values of f may be off by 1.0e-5",
        "the inverse of f is left out: no rational function was found that has one digit",
    ];
    assert_eq!(harness.state().stats().screen.windows.formula.reached, expected);
    for text in expected {
        assert!(harness.query_by_label(text).is_some(), "{text}");
    }
    assert_eq!(harness.state().windows.exporter.made_formula(&task), Some(file));
    let context = harness.ctx.clone();
    let moved = Command::MoveAnchor { side: Side::Source, fraction: 0.3 };
    harness.state_mut().carry_out(&context, vec![Action::Session(moved)]);
    harness.run_steps(2);
    let earlier = "This is the formula of an earlier map: save again for the one that is shown";
    assert_eq!(harness.state().stats().screen.windows.formula.reached[1], earlier);
    let task = FormulaTask::new(harness.state().model.session(), FormulaFormat::Python, 8).unwrap();
    let exporter = &mut harness.state_mut().windows.exporter;
    assert_eq!(exporter.made_formula(&task), None);
    exporter.begin_formula(task.clone(), sides);
    assert!(exporter.accept_formula(&task, Finding::Failed(key::no_map().into())).is_none() && !exporter.is_busy());
    assert_eq!(exporter.errors().count(), 1);
}

#[test]
fn single_precision_has_five_digits_and_the_others_keep_theirs() {
    let request = |formula| ExportRequest { formula, ..ExportRequest::default() };
    let digits = FormulaFormat::ALL.map(|format| request(format).digits());
    assert_eq!(digits, [8, 8, 8, 8, 5]);
}

#[test]
fn a_formula_of_a_surface_is_refused_with_the_reason() {
    let mut harness = formula_window();
    let surface = SurfaceSpec::new(SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 60 });
    let context = harness.ctx.clone();
    let set = Action::Session(Command::SetSurface { side: Side::Target, surface });
    harness.state_mut().carry_out(&context, vec![set]);
    step_until(&mut harness, |app| app.model.is_ready() && app.model.surface(Side::Target).is_some());
    harness.run_steps(3);
    assert!(harness.query_by_label_contains("the target is a surface; a formula is for two outlines").is_some());
    assert!(harness.query_by_label("Digits").is_none() && harness.get_by_label("Save").accesskit_node().is_disabled());
    harness.state_mut().carry_out(&context, vec![Action::Export(ExportAction::Save)]);
    assert!(!harness.state().windows.exporter.is_busy());
    assert_eq!(harness.state().windows.exporter.errors().count(), 1);
}
