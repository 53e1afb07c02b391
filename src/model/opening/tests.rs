//! Files parsed by a side's worker: the model's requests and its handling of the responses.

use super::*;
use crate::conformal::PrepareSettings;
use crate::mesh::Sizing;
use crate::outline::{Preset, Sampling};
use crate::session::Session;
use crate::session::{Command, OutlineSpec, SurfaceShape, SurfaceSpec, file};
use crate::surface::SurfacePreset;
use crate::worker::{Request, Task, run};

const SIDE: Side = Side::Target;
pub(super) const TRIANGLE: &[u8] = b"0,0\n0,1\n1,0\n";
pub(super) const BOW: &[u8] = b"0,0\n1,1\n1,0\n0,1\n";

fn settings(count: u32) -> PrepareSettings {
    let sampling = Sampling::Uniform { count, keep_corners: false };
    PrepareSettings { sampling, sizing: Sizing::Graded(0.3), ..PrepareSettings::default() }
}

pub(super) fn planar() -> Model {
    let coarse = Side::BOTH.map(|side| Command::SetSettings { side, settings: settings(80) });
    let mut model = Model::new(Session::with(coarse));
    model.update_ms = f64::INFINITY; // no frame has to be shown in time
    settle(&mut model);
    model
}

/// Answers a request; returns the result of a file.
pub(super) fn answer(model: &mut Model, side: Side, request: &Request) -> Option<Arrived> {
    let mut arrived = None;
    run(request, &mut |generation, response| {
        model.accept(side, generation, response);
        arrived = arrived.take().or_else(|| model.take_arrived());
    });
    arrived
}

/// Answers all requests; returns the result of a file.
fn settle(model: &mut Model) -> Option<Arrived> {
    let (mut arrived, mut is_settled) = (None, false);
    while !is_settled {
        is_settled = true;
        while let requests @ [_, ..] = model.take_requests(f64::INFINITY).as_slice() {
            is_settled = false;
            for (side, request) in requests {
                arrived = arrived.or(answer(model, *side, request));
            }
        }
        model.refresh(false);
    }
    arrived
}

fn only_request(model: &mut Model) -> Request {
    let mut requests = model.take_requests(0.0);
    assert!(requests.len() == 1, "{requests:?}");
    requests.remove(0).1
}

fn hemisphere() -> Command {
    let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 30 };
    Command::SetSurface { side: SIDE, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } }
}

fn name(model: &Model) -> &str {
    names::outline(&model.session().domain(SIDE).outline)
}

#[test]
fn one_request_reads_an_outline_and_prepares_it() {
    let mut model = planar();
    model.open_outline(SIDE, "a.csv", TRIANGLE.to_vec());
    assert!(model.is_preparing(SIDE) && model.awaits_file() && model.next_due() == Some(f64::NEG_INFINITY));
    let request = only_request(&mut model);
    assert!(matches!(request.task, Task::OutlineFile { .. }) && model.next_due().is_none());
    assert!(matches!(
        answer(&mut model, SIDE, &request),
        Some(Arrived::Outline(ArrivedOutline { origin: Origin::OutlineFile, geographic: None, of_several: None, .. }))
    ));
    assert!(model.take_requests(f64::INFINITY).is_empty() && !model.is_preparing(SIDE));
    assert_eq!((name(&model), model.notes(SIDE).count()), ("a", 1), "it was clockwise");
}

#[test]
fn another_shape_of_a_file_is_taken_while_its_outline_is_shown() {
    let mut model = planar();
    let paths = ["M0 0h4v4h-4z", "M9 0h2v1z"].map(|d| format!("<path id=\"{}\" d=\"{d}\"/>", &d[1..2]));
    let drawing = format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{}</svg>", paths.concat());
    model.open_outline(SIDE, "a.svg", drawing.into_bytes());
    let Some(Arrived::Outline(arrived)) = settle(&mut model) else { panic!("an outline") };
    assert_eq!((arrived.side, arrived.of_several), (SIDE, Some(2)));
    let taken = |model: &Model| model.parts(SIDE).map(|(file, parts)| (file.to_owned(), parts.taken));
    assert_eq!((name(&model), taken(&model)), ("0", Some(("a.svg".into(), 1))));
    assert_eq!(taken(&model).is_some(), model.parts(Side::Source).is_none());
    model.open_part(SIDE, 2);
    settle(&mut model);
    assert_eq!((name(&model), taken(&model)), ("9", Some(("a.svg".into(), 2))));
    model.dispatch(Command::SetOutline { side: SIDE, outline: OutlineSpec::Preset(Preset::Disk) }, 0.0);
    settle(&mut model);
    assert_eq!(taken(&model), None);
    model.open_part(SIDE, 1);
    assert!(!model.awaits_file());
}

#[test]
fn an_outline_from_a_file_replaces_the_surface_when_it_is_prepared() {
    let mut model = planar();
    model.dispatch(hemisphere(), 0.0);
    settle(&mut model);
    assert!(!model.is_planar());
    model.open_outline(SIDE, "a.csv", TRIANGLE.to_vec());
    settle(&mut model);
    assert!(model.is_planar() && model.is_ready() && name(&model) == "a");
}

#[test]
fn a_file_without_an_outline_does_not_interrupt_the_preparation_under_way() {
    let mut model = planar();
    model.dispatch(hemisphere(), 0.0);
    let superseded = only_request(&mut model);
    model.open_outline(SIDE, "bow.csv", BOW.to_vec());
    let reading = only_request(&mut model);
    assert!(model.take_requests(f64::INFINITY).is_empty(), "the surface waits");
    answer(&mut model, SIDE, &superseded);
    assert!(model.is_planar(), "its worker was taken from it");
    assert!(answer(&mut model, SIDE, &reading).is_none());
    let errors: Vec<_> = model.user_errors(SIDE).map(|error| error.text.english()).collect();
    assert!(errors.len() == 1 && errors[0].starts_with("bow.csv: "), "{errors:?}");
    assert!(settle(&mut model).is_none());
    assert!(!model.is_planar() && model.user_errors(SIDE).count() == 1, "the message is about another thing");
}

#[test]
fn an_outline_chosen_while_a_file_is_read_replaces_it() {
    let star = || Command::SetOutline { side: SIDE, outline: OutlineSpec::Preset(Preset::Star) };
    let opened = || Command::Open(Box::new(Session::with([star()])));
    for choose in [star(), hemisphere(), opened()] {
        let mut model = planar();
        model.open_outline(SIDE, "a.csv", TRIANGLE.to_vec());
        let stale = only_request(&mut model);
        model.dispatch(choose.clone(), 0.0);
        assert!(answer(&mut model, SIDE, &stale).is_none(), "{choose:?}");
        settle(&mut model);
        assert!(name(&model) != "a" && model.is_ready(), "{choose:?}");
    }
}

#[test]
fn settings_changed_while_a_file_is_read_apply_to_its_outline() {
    let mut model = planar();
    model.open_outline(SIDE, "a.csv", TRIANGLE.to_vec());
    let request = only_request(&mut model);
    model.dispatch(Command::SetSettings { side: SIDE, settings: settings(60) }, 0.0);
    answer(&mut model, SIDE, &request);
    settle(&mut model);
    assert_eq!((name(&model), model.session().domain(SIDE).settings), ("a", settings(60)));
    assert_eq!(model.domain(SIDE).unwrap().samples().points().len(), 60);
}

#[test]
fn an_outline_with_a_spike_offers_a_repair() {
    let mut model = planar();
    model.open_outline(SIDE, "spike.csv", b"0,0\n2,0\n2,1\n3,1\n2,1\n2,2\n0,2\n".to_vec());
    assert!(settle(&mut model).is_none());
    assert!(matches!(model.side(SIDE).error.as_ref().unwrap().quick_fix, Some(QuickFix::Repaired(_))));
    model.quick_fix(SIDE);
    settle(&mut model);
    assert!(name(&model) == "spike" && model.side(SIDE).error.is_none());
}

#[test]
fn a_file_whose_worker_stopped_can_be_read_again() {
    let mut model = planar();
    model.open_outline(SIDE, "a.csv", TRIANGLE.to_vec());
    only_request(&mut model);
    model.worker_died(SIDE, None, &"out of memory".into());
    let said = model.side(SIDE).error.as_ref().unwrap().text.english();
    assert!(said.starts_with("a.csv: ") && said.contains("out of memory") && !model.is_preparing(SIDE), "{said}");
    model.quick_fix(SIDE);
    settle(&mut model);
    assert!(name(&model) == "a" && model.side(SIDE).error.is_none());
}

#[test]
fn an_invalid_pasted_text_is_reported_on_its_side() {
    let mut model = planar();
    model.open_pasted(SIDE, "no outline");
    assert!(model.reads_pasted(SIDE) && !model.reads_pasted(Side::Source));
    assert!(matches!(settle(&mut model), Some(Arrived::NoOutline(SIDE, _))));
    assert!(model.side(SIDE).error.is_none() && !model.reads_pasted(SIDE));
    model.open_pasted(SIDE, "M 0 0 h 4 v 1 z");
    assert!(matches!(
        settle(&mut model),
        Some(Arrived::Outline(ArrivedOutline { origin: Origin::PastedText, geographic: None, of_several: None, .. }))
    ));
    assert_eq!(name(&model), names::PASTED);
}

#[test]
fn a_session_file_is_handed_to_the_app_and_changes_nothing() {
    let mut model = planar();
    let before = model.session().clone();
    let wanted = before.clone().and([Command::SetTextureScale(21.0)]);
    model.open_session_file("a.riemap", file::write(&wanted).unwrap().into_bytes());
    let Some(Arrived::Session(archive, _)) = settle(&mut model) else { panic!("no session") };
    assert_eq!((archive.session(), model.session()), (&wanted, &before));
    model.open_session_file("a.riemap", vec![1, 2]);
    let Some(Arrived::NoSession(why)) = settle(&mut model) else { panic!("a session") };
    assert!(why.english().starts_with("a.riemap: ") && model.is_ready());
}

#[test]
fn a_file_that_is_too_large_is_refused_before_it_is_copied() {
    let mut model = planar();
    let large = || vec![b' '; file::MAX_BYTES.max(crate::outline::MAX_BYTES) + 1];
    model.open_outline(SIDE, "a.csv", large());
    let said = model.side(SIDE).error.as_ref().unwrap().text.english();
    assert!(said.starts_with("a.csv: the file has") && !model.awaits_file(), "{said}");
    model.open_session_file("a.riemap", large());
    let Some(Arrived::NoSession(why)) = model.take_arrived() else { panic!("it is read") };
    assert!(why.english().starts_with("a.riemap: the file is too large"), "{}", why.english());
    model.open_pasted(SIDE, &String::from_utf8(large()).unwrap());
    assert!(matches!(model.take_arrived(), Some(Arrived::NoOutline(SIDE, _))) && !model.reads_pasted(SIDE));
    assert!(model.take_requests(f64::INFINITY).is_empty());
}

#[test]
fn a_stopped_worker_is_reported_on_the_side_of_the_file() {
    let mut model = planar();
    model.open_pasted(SIDE, "M 0 0 h 4 v 1 z");
    only_request(&mut model);
    model.worker_died(SIDE, None, &"out of memory".into());
    let Some(Arrived::NoOutline(SIDE, why)) = model.take_arrived() else { panic!("not in the paste window") };
    assert_eq!(why, key::reading_stopped(Message::from("out of memory")));
    model.open_session_file("a.riemap", vec![1, 2]);
    let side = model.take_requests(0.0)[0].0;
    model.worker_died(side, None, &"out of memory".into());
    let Some(Arrived::NoSession(why)) = model.take_arrived() else { panic!("not in the common message") };
    assert!(why.english().starts_with("a.riemap: "), "{}", why.english());
    assert!(Side::BOTH.iter().all(|side| model.user_errors(*side).count() == 0) && model.is_ready());
}

#[test]
fn a_worker_that_stops_on_a_superseded_request_ends_no_other() {
    let mut model = planar();
    model.dispatch(hemisphere(), 0.0);
    let superseded = only_request(&mut model).generation;
    model.open_outline(SIDE, "a.csv", TRIANGLE.to_vec());
    let request = only_request(&mut model);
    model.worker_died(SIDE, Some(superseded), &"out of memory".into());
    assert!(model.user_errors(SIDE).count() == 0 && model.awaits_file());
    answer(&mut model, SIDE, &request);
    settle(&mut model);
    assert_eq!(name(&model), "a");
}

#[test]
fn a_session_file_is_read_by_the_idle_worker() {
    let mut model = planar();
    model.dispatch(Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Star) }, 0.0);
    only_request(&mut model);
    model.open_session_file("a.riemap", vec![1, 2]);
    let requests = model.take_requests(0.0);
    assert!(matches!(requests.as_slice(), [(Side::Target, _)]), "{requests:?}");
}
