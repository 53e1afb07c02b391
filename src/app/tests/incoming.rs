//! What comes from outside of a frame: files, pictures, links, and which frames they ask for.

use super::*;
use crate::app::input::action::ExploreAction;
use crate::model::files::FilePurpose;
use crate::platform::Event;
use crate::session::TextureKind;
use crate::worker::{self, SurfaceSource, Task};

/// A small surface as an OBJ file.
fn surface_file() -> Vec<u8> {
    let Task::Surface { source: SurfaceSource::File(file), .. } = worker::rehearsal().task else {
        unreachable!("the rehearsal reads a file")
    };
    file.bytes.to_vec()
}

/// A black box on white, as a PNG file.
fn picture_of_a_box() -> Vec<u8> {
    let ink = |x: u32, y: u32| if (60..180).contains(&x) && (90..150).contains(&y) { 0 } else { 255 };
    let picture = image::GrayImage::from_fn(300, 240, |x, y| image::Luma([ink(x, y)]));
    let mut bytes = std::io::Cursor::new(Vec::new());
    picture.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    bytes.into_inner()
}

#[test]
fn a_surface_is_prepared_before_the_next_frame_and_seen_before_its_triangles_are_sorted() {
    let mut harness = ready_app([1200.0, 800.0]);
    let app = harness.state_mut();
    app.take_file(FilePurpose::Outline(Side::Target), "head.obj", Ok(surface_file()));
    let preparation = &app.model.surface_side(Side::Target).preparation;
    assert!(preparation.pending_request().seconds_under_way().is_some(), "its progress is shown from now on");
    assert_eq!(app.model.next_due(), None, "nothing is left for a frame to ask for");
    step_until(&mut harness, |app| !app.model.is_planar() && app.model.map().is_some());
    let is_sorted = |app: &RiemapApp| {
        app.model.surface_side(Side::Target).surface().is_some_and(|surface| surface.tree_if_made().is_some())
    };
    assert!(!is_sorted(harness.state()), "the first frame of a surface does not wait for that");
    step_until(&mut harness, is_sorted);
}

/// The app in a state in which it requests no frame.
fn app_at_rest() -> Harness<'static, RiemapApp> {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.try_run().unwrap();
    assert!(!harness.ctx.has_requested_repaint());
    harness
}

#[test]
fn another_picture_ends_the_tour_and_a_file_without_one_does_not() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    let begin = |app: &mut RiemapApp| {
        app.carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
        assert!(app.windows.explore.is_touring());
    };
    let app = harness.state_mut();
    begin(app);
    app.take_file(FilePurpose::Outline(Side::Source), "bow.csv", Ok(b"0,0\n1,1\n1,0\n0,1\n".to_vec()));
    step_until(&mut harness, |app| !app.errors().is_empty());
    let app = harness.state_mut();
    assert!(app.windows.explore.is_touring());
    app.open_session(Session::default());
    assert!(!app.windows.explore.is_touring());
    begin(app);
    app.take_file(FilePurpose::Outline(Side::Source), "square.csv", Ok(b"0,0\n1,0\n1,1\n0,1\n".to_vec()));
    assert!(app.windows.explore.is_touring(), "it is being read");
    step_until(&mut harness, |app| !app.windows.explore.is_touring());
}

#[test]
fn a_repaired_outline_ends_the_tour() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    let app = harness.state_mut();
    app.carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
    let spike = b"0,0\n2,0\n2,1\n3,1\n2,1\n2,2\n0,2\n".to_vec();
    app.take_file(FilePurpose::Outline(Side::Source), "spike.csv", Ok(spike));
    step_until(&mut harness, |app| !app.errors().is_empty());
    let app = harness.state_mut();
    assert!(app.windows.explore.is_touring());
    app.carry_out(&context, vec![Action::QuickFix(Side::Source)]);
    assert!(!app.windows.explore.is_touring() && app.errors().is_empty());
}

#[test]
fn a_session_that_is_read_is_opened_and_ends_the_tour() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    let app = harness.state_mut();
    let session = app.session().clone().and([Command::SetTextureScale(21.0)]);
    app.carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
    let bytes = crate::session::file::write(&session).unwrap().into_bytes();
    app.take_file(FilePurpose::Dropped(Side::Target), "a.riemap", Ok(bytes));
    step_until(&mut harness, |app| app.session().texture_scale() == 21.0 && app.model.is_ready());
    assert!(!harness.state().windows.explore.is_touring());
}

#[test]
fn a_surface_ends_the_tour_when_it_is_there_and_a_broken_one_does_not() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    harness.state_mut().carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
    let mut take = |name: &str, bytes: Vec<u8>| {
        harness.state_mut().take_file(FilePurpose::Outline(Side::Target), name, Ok(bytes));
        step_until(&mut harness, |app| !app.model.surface_side(Side::Target).preparation.is_busy());
        (harness.state().windows.explore.is_touring(), harness.state().errors().len())
    };
    assert_eq!(take("broken.obj", b"v 0 0 0\nf 1 2 3\n".to_vec()), (true, 1));
    assert_eq!(take("head.obj", surface_file()), (false, 0));
}

#[test]
fn a_surface_that_is_on_its_way_is_not_lost_when_the_tour_is_ended() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    let app = harness.state_mut();
    app.carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
    app.take_file(FilePurpose::Outline(Side::Target), "head.obj", Ok(surface_file()));
    app.carry_out(&context, vec![Action::Explore(ExploreAction::LeaveTour { keeps: false })]);
    assert!(!app.windows.explore.is_touring() && app.model.surface_side(Side::Target).preparation.is_busy());
    step_until(&mut harness, |app| !app.model.is_planar());
}

#[test]
fn what_was_wrong_with_a_target_outline_is_past_when_a_surface_takes_its_place() {
    let mut harness = ready_app([1200.0, 800.0]);
    let app = harness.state_mut();
    app.take_file(FilePurpose::Outline(Side::Target), "bow.csv", Ok(b"0,0\n1,1\n1,0\n0,1\n".to_vec()));
    step_until(&mut harness, |app| app.errors().len() == 1);
    let app = harness.state_mut();
    app.take_file(FilePurpose::Outline(Side::Target), "head.obj", Ok(surface_file()));
    assert!(app.errors().is_empty(), "{:?}", app.errors());
    // and in the reverse order
    app.take_file(FilePurpose::Outline(Side::Target), "broken.obj", Ok(b"v 0 0 0\nf 1 2 3\n".to_vec()));
    step_until(&mut harness, |app| !app.model.surface_side(Side::Target).preparation.pending_request().is_busy());
    let app = harness.state_mut();
    app.take_file(FilePurpose::Outline(Side::Target), "bow.csv", Ok(b"0,0\n1,1\n1,0\n0,1\n".to_vec()));
    step_until(&mut harness, |app| !app.model.is_preparing(Side::Target));
    let errors = harness.state().errors();
    assert!(errors.len() == 1 && errors[0].english().starts_with("bow.csv"), "{errors:?}");
}

#[test]
fn a_picture_opened_as_an_outline_waits_for_the_answer_what_it_is_for() {
    let bytes = picture_of_a_box();
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    let before = harness.state().session().clone();
    let mut ask = |action: Action| {
        harness.state_mut().take_file(FilePurpose::Outline(Side::Source), "box.png", Ok(bytes.clone()));
        step_until(&mut harness, |app| app.messages.offer.is_some());
        assert_eq!(harness.state().session(), &before, "nothing changes before the answer");
        harness.state_mut().carry_out(&context, vec![action]);
        step_until(&mut harness, |app| !app.model.is_preparing(Side::Source));
        assert!(harness.state().messages.offer.is_none());
        harness.state().session().clone()
    };
    assert_eq!(ask(Action::DismissOffer), before);
    let textured = ask(Action::UseImage);
    assert_eq!((textured.texture(), textured.domain(Side::Source)), (TextureKind::Image, before.domain(Side::Source)));
    assert_eq!(harness.state().pictures.image.as_ref().map(|image| image.file.name.as_str()), Some("box.png"));
    let app = harness.state_mut();
    app.open_session(before.clone());
    app.take_file(FilePurpose::Outline(Side::Source), "box.png", Ok(bytes));
    step_until(&mut harness, |app| app.messages.offer.is_some());
    harness.step();
    harness.get_by_label("Trace its silhouette").click();
    step_until(&mut harness, |app| app.session().domain(Side::Source) != before.domain(Side::Source));
}

#[test]
fn a_question_waits_for_its_answer_whatever_else_is_opened() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    let bytes = picture_of_a_box();
    harness.state_mut().take_file(FilePurpose::Outline(Side::Source), "box.png", Ok(bytes.clone()));
    step_until(&mut harness, |app| app.messages.offer.is_some());
    let before = harness.state().session().clone();
    let region = br#"{"type":"Polygon","coordinates":[[[0,40],[20,40],[20,50],[0,50],[0,40]]]}"#;
    harness.state_mut().take_file(FilePurpose::Outline(Side::Target), "box.geojson", Ok(region.to_vec()));
    step_until(&mut harness, |app| app.session().domain(Side::Target) != before.domain(Side::Target));
    harness.state_mut().take_file(FilePurpose::Outline(Side::Target), "box.png", Ok(bytes));
    step_until(&mut harness, |app| app.messages.waiting() == 2);
    harness.run_steps(2);
    harness.get_by_label("Trace its silhouette");
    assert!(harness.query_by_label("Show as a map").is_none());
    harness.state_mut().carry_out(&context, vec![Action::DismissOffer]);
    harness.run_steps(3);
    harness.get_by_label("Show as a map");
    assert!(harness.query_by_label("Trace its silhouette").is_none());
    harness.state_mut().carry_out(&context, vec![Action::DismissOffer]);
    harness.run_steps(3);
    harness.get_by_label("Trace its silhouette");
}

#[test]
fn a_message_that_hides_which_file_is_missing_gives_way_to_that() {
    let mut harness = ready_app([1200.0, 800.0]);
    let context = harness.ctx.clone();
    let app = harness.state_mut();
    // a spike finer than a link can tell
    let spike = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.31 + 1e-9, 1.0), (0.31, 0.2), (0.31 - 1e-9, 1.0), (0.0, 1.0)];
    let points = spike.map(crate::geometry::DVec2::from).to_vec();
    let mut session = app.session().clone();
    let outline = crate::session::OutlineSpec::points("big".into(), points.try_into().unwrap());
    session.apply(Command::SetOutline { side: Side::Source, outline });
    app.try_link(&crate::session::link::encode(&session).unwrap().fragment).unwrap();
    let asked = app.messages.common.clone();
    assert!(asked.as_ref().is_some_and(|asked| asked.english().contains("\"big\"")));
    app.open_link("#s=1.nonsense");
    assert_ne!(app.messages.common, asked);
    app.carry_out(&context, vec![Action::DismissMessage]);
    assert_eq!(app.messages.common, asked);
    app.carry_out(&context, vec![Action::DismissMessage]);
    assert_eq!(app.messages.common, None);
    app.open_link("#s=1.nonsense");
    app.carry_out(&context, vec![Action::DismissMessage]);
    assert_eq!(app.messages.common, None, "it has been closed");
}

#[test]
fn a_file_that_cannot_be_used_asks_for_a_frame_that_says_so() {
    let mut harness = app_at_rest();
    harness.state_mut().take_file(FilePurpose::Session, "a.riemap", Ok(vec![1, 2]));
    assert!(harness.ctx.has_requested_repaint());
    step_until(&mut harness, |app| !app.errors().is_empty());
    harness.step();
    harness.get_by_label_contains("a.riemap: ");
}

#[test]
fn after_what_has_come_in_the_panels_get_another_frame_and_stages_wait() {
    let mut harness = app_at_rest();
    let mailbox = harness.state().workers.mailbox.clone();
    let mut asks_for_a_frame = |event| {
        let context = egui::Context::default();
        for _ in 0..3 {
            context.run_ui(egui::RawInput::default(), |_| {}).textures_delta.clear();
        }
        assert!(!context.has_requested_repaint());
        mailbox.post(event);
        harness.state_mut().take_events(&context);
        context.has_requested_repaint()
    };
    assert!(asks_for_a_frame(Event::NotSaved { name: "a.png".into(), reason: "no room".into() }));
    let response = worker::Response::Progress(crate::conformal::Stage::Read);
    assert!(!asks_for_a_frame(Event::Worker { side: Side::Target, generation: 0, response }));
}
