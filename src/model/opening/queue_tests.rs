//! Files opened in quick succession take effect in the order in which they were opened, whichever worker answers first.

use super::tests::{BOW, TRIANGLE, answer, planar};
use super::*;
use crate::language::Language;
use crate::outline::Preset;
use crate::session::{Command, OutlineSpec, SurfaceShape, SurfaceSpec, file};

const SQUARE: &[u8] = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
const SCALE: f64 = 21.0;

/// A session file with stars on both sides and a texture scale of its own.
fn stars(model: &Model, further: impl IntoIterator<Item = Command>) -> Vec<u8> {
    let star = |side| Command::SetOutline { side, outline: OutlineSpec::Preset(Preset::Star) };
    let session = model.session().clone().and(Side::BOTH.map(star)).and([Command::SetTextureScale(SCALE)]);
    file::write(&session.and(further)).unwrap().into_bytes()
}

/// Answers all requests, those of `first` before those of the other side, and opens sessions as the app does; returns
/// the messages about session files.
fn settle(model: &mut Model, first: Side) -> Vec<Message> {
    let mut refused = Vec::new();
    loop {
        let mut requests = model.take_requests(f64::INFINITY);
        if requests.is_empty() {
            break;
        }
        requests.sort_by_key(|(side, _)| *side != first);
        for (side, request) in requests {
            match answer(model, side, &request) {
                Some(Arrived::Session(archive, later)) => {
                    model.dispatch(Command::Open(Box::new(archive.session().clone())), 0.0);
                    model.open_later(later);
                }
                Some(Arrived::NoSession(message)) => refused.push(message),
                _ => {}
            }
        }
    }
    model.refresh(false);
    assert!(model.is_ready() && !model.awaits_file());
    refused
}

fn outlines(model: &Model) -> [String; 2] {
    Side::BOTH.map(|side| names::outline(&model.session().domain(side).outline).to_owned())
}

#[test]
fn a_session_opened_after_outlines_replaces_them() {
    for first in Side::BOTH {
        let mut model = planar();
        let session = stars(&model, []);
        for side in Side::BOTH {
            model.open_outline(side, "a.csv", TRIANGLE.to_vec());
        }
        model.open_session_file("s.riemap", session);
        assert!(settle(&mut model, first).is_empty());
        assert_eq!((outlines(&model), model.session().texture_scale()), (["Star"; 2].map(String::from), SCALE));
    }
}

#[test]
fn an_outline_opened_after_a_session_replaces_that_of_the_session() {
    for (first, side) in Side::BOTH.into_iter().zip([Side::Target, Side::Source]) {
        let mut model = planar();
        let session = stars(&model, []);
        model.open_session_file("s.riemap", session);
        model.open_outline(side, "a.csv", TRIANGLE.to_vec());
        assert!(model.is_preparing(side));
        assert!(settle(&mut model, first).is_empty());
        let expected = Side::BOTH.map(|at| String::from(if at == side { "a" } else { "Star" }));
        assert_eq!((outlines(&model), model.session().texture_scale()), (expected, SCALE));
    }
}

#[test]
fn a_surface_opened_after_its_session_comes_with_the_points_of_the_session() {
    let mut model = planar();
    let shape = SurfaceShape::File { name: "square.obj".into() };
    let session = stars(
        &model,
        [
            Command::SetSurface { side: Side::Target, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } },
            Command::MoveAnchor { side: Side::Target, fraction: 0.6 },
        ],
    );
    model.open_session_file("s.riemap", session);
    model.open_surface_in_turn(Side::Source, "square.obj", SQUARE.to_vec());
    settle(&mut model, Side::Source);
    let surface = model.session().surface(Side::Target).unwrap();
    assert_eq!((names::surface(&surface.spec.shape), surface.anchor), ("square.obj", 0.6));
    assert!(model.session().surface(Side::Source).is_none() && model.user_errors(Side::Target).count() == 0);
}

#[test]
fn an_invalid_file_does_not_replace_a_valid_one_before_it() {
    let mut model = planar();
    model.open_outline(Side::Target, "a.csv", TRIANGLE.to_vec());
    model.open_session_file("s.riemap", vec![1, 2]);
    model.open_outline(Side::Target, "bow.csv", BOW.to_vec());
    model.open_outline(Side::Source, "b.csv", TRIANGLE.to_vec());
    let refused = settle(&mut model, Side::Source);
    assert!(refused.len() == 1 && refused[0].english().starts_with("s.riemap: "), "{refused:?}");
    assert_eq!(outlines(&model), ["b", "a"]);
    let errors: Vec<_> = model.user_errors(Side::Target).map(|error| error.text.english()).collect();
    assert!(errors.len() == 1 && errors[0].starts_with("bow.csv: "), "{errors:?}");
}

#[test]
fn the_last_of_two_valid_files_for_a_side_is_shown() {
    let mut model = planar();
    model.open_outline(Side::Target, "a.csv", TRIANGLE.to_vec());
    model.open_surface_in_turn(Side::Target, "square.obj", SQUARE.to_vec());
    model.open_outline(Side::Target, "b.csv", TRIANGLE.to_vec());
    settle(&mut model, Side::Target);
    assert!(model.is_planar() && outlines(&model)[1] == "b");
    model.open_outline(Side::Target, "a.csv", TRIANGLE.to_vec());
    model.open_surface_in_turn(Side::Target, "square.obj", SQUARE.to_vec());
    settle(&mut model, Side::Target);
    assert!(!model.is_planar());
}

#[test]
fn choosing_a_shape_cancels_the_waiting_files_of_its_side_only() {
    let mut model = planar();
    let session = stars(&model, []);
    model.open_session_file("s.riemap", session);
    model.open_pasted(Side::Target, "M 0 0 h 4 v 1 z");
    model.open_outline(Side::Source, "b.csv", TRIANGLE.to_vec());
    assert!(model.reads_pasted(Side::Target));
    model.dispatch(Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Heart) }, 0.0);
    assert!(!model.reads_pasted(Side::Target) && model.next_due().is_some());
    settle(&mut model, Side::Source);
    assert_eq!(outlines(&model), ["b", "Heart"]);
    assert!(model.session().texture_scale() != SCALE);
}

#[test]
fn a_surface_file_that_is_too_large_is_refused_before_it_is_copied() {
    use crate::surface::MAX_BYTES;
    let mut model = planar();
    // its message is about the file opened last, although the outline before it is read later
    model.open_outline(Side::Target, "b.csv", TRIANGLE.to_vec());
    model.open_surface_in_turn(Side::Target, "huge.obj", vec![0; MAX_BYTES + 1]); // zeroed pages, never written
    settle(&mut model, Side::Target);
    assert_eq!(outlines(&model)[1], "b");
    let said: Vec<_> = model.user_errors(Side::Target).map(|error| error.text.clone()).collect();
    assert_eq!(said.len(), 1);
    for language in Language::ALL {
        let words = language.message(&said[0]);
        assert!(["huge.obj", "536870913", "512 MiB"].iter().all(|part| words.contains(part)), "{words}");
    }
    assert!(!model.awaits_file() && model.take_requests(f64::INFINITY).is_empty() && model.is_ready());
    model.open_surface_in_turn(Side::Target, "square.obj", SQUARE.to_vec());
    settle(&mut model, Side::Target);
    assert!(!model.is_planar() && model.user_errors(Side::Target).count() == 0);
}
