//! The boundary integral in the app: finite elements first, then the factored equation; what is at rest is final.

use crate::conformal::{KernelMode, PrepareSettings, Unsharpened};
use crate::geometry::SimplePolygon;
use crate::language::Message;
use crate::mesh::Sizing;
use crate::model::scene::Offscreen;
use crate::model::*;
use crate::outline::{Preset, Sampling};
use crate::session::{Command, OutlineSpec, SurfaceSpec};
use crate::worker::{self, Request, Response, Task};

fn settings() -> PrepareSettings {
    PrepareSettings::new(Sampling::Adaptive { target: Some(150) }, Sizing::Graded(0.3))
        .with_kernel(KernelMode::Integral)
}

fn session(presets: [Preset; 2]) -> Session {
    let outlines = Side::BOTH.into_iter().zip(presets).flat_map(|(side, preset)| {
        let outline = OutlineSpec::Preset(preset);
        [Command::SetOutline { side, outline }, Command::SetSettings { side, settings: settings() }]
    });
    Session::with(outlines)
}

fn started(session: Session) -> Model {
    let mut model = Model::new(session);
    model.update_ms = f64::INFINITY;
    model
}

fn answer(model: &mut Model, requests: &[(Side, Request)]) {
    for (side, request) in requests {
        worker::run(request, &mut |generation, response| model.accept(*side, generation, response));
    }
    model.refresh(false);
}

fn is_equation((_, request): &(Side, Request)) -> bool {
    matches!(request.task, Task::Equation { .. })
}

/// Answers the requests for the refined map, which are the last ones.
fn refine(model: &mut Model) {
    while let requests @ [_, ..] = model.take_requests(f64::INFINITY).as_slice() {
        assert!(requests.iter().all(|(_, request)| matches!(request.task, Task::Mesh { .. })));
        answer(model, requests);
    }
}

fn settled(session: Session) -> Model {
    let mut model = started(session);
    while let requests @ [_, ..] = model.take_requests(f64::INFINITY).as_slice() {
        answer(&mut model, requests);
    }
    model
}

#[test]
fn finite_elements_are_shown_first_and_only_the_sharpened_map_is_ready() {
    let mut model = started(session([Preset::Square, Preset::LShape]));
    let first = model.take_requests(0.0);
    assert!(first.len() == 2 && !first.iter().any(is_equation));
    answer(&mut model, &first);
    assert!(model.is_mapped() && !model.is_ready() && model.error_bounds().is_none());
    assert_eq!(model.side_kernel(Side::Source), Some(SideKernel::Sharpening));
    let by_elements = model.map().unwrap().images().to_vec();
    let second = model.take_requests(0.0);
    assert!(second.len() == 2 && second.iter().all(is_equation) && model.take_requests(0.0).is_empty());
    answer(&mut model, &second);
    refine(&mut model);
    assert!(model.is_ready());
    for side in Side::BOTH {
        assert!(matches!(model.side_kernel(side), Some(SideKernel::Integral { unknowns }) if unknowns > 100));
    }
    let bounds = model.error_bounds().unwrap();
    assert!(bounds.omega < 1e-10 && bounds.image < 1e-3, "{bounds:?}");
    assert!(model.map().unwrap().images() != by_elements);
}

#[test]
fn the_map_at_rest_is_the_same_however_it_was_come_to() {
    let wanted = session([Preset::Blob, Preset::Square]);
    let model = settled(wanted.clone());
    let mut other = settled(session([Preset::Square, Preset::Square]));
    other.dispatch(Command::Open(Box::new(wanted.clone())), 0.0);
    while let requests @ [_, ..] = other.take_requests(f64::INFINITY).as_slice() {
        answer(&mut other, requests);
    }
    assert_eq!(model.map().unwrap().images(), other.map().unwrap().images());
    let mut copy = Offscreen::of(&model, 1.0);
    assert!((0..1000).any(|_| copy.advance().unwrap()), "a copy awaits nothing");
}

#[test]
fn a_dragged_point_keeps_the_equation_and_one_beside_the_boundary_gets_its_own_at_rest() {
    let mut model = settled(session([Preset::Square, Preset::Disk]));
    let domain = model.domain(Side::Source).unwrap();
    let center = domain.default_point();
    let beside = domain.nearest_inside(domain.samples().points()[20], 1e-3);
    model.set_at_rest(false);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: (center + DVec2::splat(0.01)).into() }, 0.0);
    assert!(model.refresh(true).map && model.is_sharp() && model.take_requests(0.0).is_empty());
    model.dispatch(Command::MoveInterior { side: Side::Source, point: beside.into() }, 0.0);
    assert!(model.refresh(true).map && !model.is_sharp() && model.take_requests(0.0).is_empty(), "it moves");
    model.set_at_rest(true);
    let requests = model.take_requests(0.0);
    assert!(requests.len() == 1 && is_equation(&requests[0]) && requests[0].0 == Side::Source);
    answer(&mut model, &requests);
    refine(&mut model);
    assert!(model.is_ready());
    let swept = model.prepared(Side::Source).unwrap().boundary_integral().unwrap().harmonic_measure(beside).unwrap();
    assert!(swept.error_estimate() < 1e-9, "{:e}", swept.error_estimate());
}

#[test]
fn a_point_next_to_the_edge_stays_when_a_side_is_prepared_again() {
    let mut model = settled(session([Preset::Disk, Preset::Square]));
    // inside of the circle, and outside of the polygon of 150 samples
    let beside = DVec2::from_angle(1.0) * 0.999_9;
    model.dispatch(Command::MoveInterior { side: Side::Source, point: beside.into() }, 0.0);
    let coarser = settings().with_kernel(KernelMode::Adjoint);
    model.dispatch(Command::SetSettings { side: Side::Target, settings: coarser }, 0.0);
    while let requests @ [_, ..] = model.take_requests(f64::INFINITY).as_slice() {
        answer(&mut model, requests);
    }
    assert!(model.is_ready());
    assert_eq!(model.interior(Side::Source), Some(beside));
    let opened = settled(model.session().clone());
    assert!(opened.is_ready() && opened.user_errors(Side::Source).count() == 0);
    assert_eq!(opened.session(), model.session(), "it stays when it is opened");
    let [there, here] = [&opened, &model].map(|model| model.map().unwrap().images()[0]);
    assert!(there.distance(here) < 1e-9, "{there} and {here}");
}

#[test]
fn another_outline_supersedes_the_equation_of_the_one_before() {
    let mut model = started(session([Preset::Square, Preset::LShape]));
    let first = model.take_requests(0.0);
    answer(&mut model, &first);
    let stale = model.take_requests(0.0);
    let outline = OutlineSpec::Preset(Preset::Heart);
    model.dispatch(Command::SetOutline { side: Side::Source, outline: outline.clone() }, 0.0);
    let requests = model.take_requests(0.0);
    assert!(requests.len() == 1 && !is_equation(&requests[0]), "at once, not behind the factor");
    answer(&mut model, &stale);
    assert!(!model.is_ready() && model.prepared(Side::Source).unwrap().awaits_equation());
    answer(&mut model, &requests);
    let equations = model.take_requests(0.0);
    assert!(equations.len() == 1 && is_equation(&equations[0]));
    answer(&mut model, &equations);
    refine(&mut model);
    assert!(model.is_ready() && model.session().domain(Side::Source).outline == outline);
}

#[test]
fn finite_elements_stay_where_they_were_chosen_and_where_the_equation_is_too_large() {
    let adjoint = Side::BOTH.map(|side| Command::SetSettings { side, settings: PrepareSettings::default() });
    let mut model = started(session([Preset::Square, Preset::Disk]).and(adjoint));
    let first = model.take_requests(0.0);
    answer(&mut model, &first);
    refine(&mut model);
    assert!(model.is_ready());
    assert_eq!(model.side_kernel(Side::Source), Some(SideKernel::FiniteElements(KernelMode::Adjoint)));
    let corner = |k: u32| {
        let (angle, radius) = (f64::from(k) * std::f64::consts::TAU / 600.0, 1.0 + 0.1 * f64::from(k % 2));
        radius * DVec2::from_angle(angle)
    };
    let polygon = SimplePolygon::try_from((0..600).map(corner).collect::<Vec<_>>()).unwrap();
    let gear = OutlineSpec::points(String::from("gear"), polygon);
    let model = settled(session([Preset::Square, Preset::Disk]).and([
        Command::SetOutline { side: Side::Target, outline: gear },
        Command::SetSettings { side: Side::Target, settings: settings() },
    ]));
    assert!(model.is_ready() && model.error_bounds().is_none());
    let Some(SideKernel::Stays(reason)) = model.side_kernel(Side::Target) else { panic!("it has 600 corners") };
    assert!(reason.english().contains("unknowns"), "{}", reason.english());
}

#[test]
fn a_worker_that_stops_over_an_equation_leaves_finite_elements_with_the_reason() {
    let mut model = started(session([Preset::Square, Preset::Disk]));
    let first = model.take_requests(0.0);
    answer(&mut model, &first);
    let equations = model.take_requests(0.0);
    model.worker_died(Side::Source, Some(equations[0].1.generation), &Message::from("out of memory"));
    model.accept(Side::Target, equations[1].1.generation, Response::Equation(Box::new(Err(Unsharpened::Apart))));
    model.refresh(false);
    refine(&mut model);
    assert!(model.is_ready());
    for (side, word) in [(Side::Source, "memory"), (Side::Target, "follow")] {
        let Some(SideKernel::Stays(reason)) = model.side_kernel(side) else { panic!("{side}") };
        assert!(reason.english().contains(word), "{side}: {}", reason.english());
    }
}

#[test]
fn an_outline_beside_a_surface_is_sharpened_and_the_surface_is_not() {
    let surface = Command::SetSurface { side: Side::Target, surface: SurfaceSpec::default() };
    let model = settled(session([Preset::Square, Preset::Disk]).and([surface]));
    assert!(model.is_ready() && model.map_error().is_none(), "{:?}", model.map_error());
    assert!(matches!(model.side_kernel(Side::Source), Some(SideKernel::Integral { .. })));
    assert_eq!(model.side_kernel(Side::Target), Some(SideKernel::FiniteElements(KernelMode::Adjoint)));
}

#[test]
fn exchanged_sides_are_sharpened() {
    let mut model = started(session([Preset::Square, Preset::Disk]));
    let first = model.take_requests(0.0);
    answer(&mut model, &first);
    let stale = model.take_requests(0.0);
    model.dispatch(Command::Swap, 0.0);
    model.refresh(false);
    let equations = model.take_requests(0.0);
    answer(&mut model, &stale);
    assert!(equations.len() == 2 && !model.is_ready());
    answer(&mut model, &equations);
    refine(&mut model);
    assert!(model.is_ready() && Side::BOTH.iter().all(|side| model.prepared(*side).unwrap().equation().is_some()));
}
