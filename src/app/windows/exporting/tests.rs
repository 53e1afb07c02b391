//! Exports do not change the model, and the window reports what cannot be exported.

use crate::app::tests::{has_adapter, prepared_model, ready_app};
use crate::app::windows::exporting::Exporter;
use crate::conformal::PerSide;
use crate::export::FileFormat;
use crate::family::Path;
use crate::model::export::ReadyFile;
use crate::model::export::request::{ExportRequest, Kind};
use crate::model::scene::Offscreen;
use crate::model::{Abilities, Model};
use crate::offscreen::job::{Job, Progress, Scenery};
use crate::render::{FilmFormat, Studio, headless_device};
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
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
    if !has_adapter() {
        return;
    }
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
    if !has_adapter() {
        return;
    }
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
    if !has_adapter() {
        return;
    }
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
    if !has_adapter() {
        return;
    }
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
    assert_eq!(with_coordinates, [false, true, true, false]);
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
    assert!(harness.query_by_label("Duration").is_some());
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
