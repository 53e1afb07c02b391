//! The best map in the model: the points move to it, a change ends the search, the region and the landscape follow.

use super::*;
use crate::conformal::{KernelMode, PrepareSettings};
use crate::model::surface_tests::{settle, spec};
use crate::optimization::Criterion;
use crate::outline::{Preset, Sampling};
use crate::session::{OutlineSpec, Session};
use crate::surface::SurfacePreset;

fn outline(side: Side, preset: Preset) -> Command {
    Command::SetOutline { side, outline: OutlineSpec::Preset(preset) }
}

fn model(commands: impl IntoIterator<Item = Command>) -> Model {
    let sampling = Sampling::Adaptive { target: Some(200) };
    let settings = PrepareSettings { sampling, kernel: KernelMode::Adjoint, ..PrepareSettings::default() };
    let session = Session::with(Side::BOTH.map(|side| Command::SetSettings { side, settings }));
    let shapes = [outline(Side::Source, Preset::LShape), outline(Side::Target, Preset::Disk)];
    let mut model = Model::new(session.and(shapes).and(commands));
    model.update_ms = f64::INFINITY;
    rest(&mut model);
    model
}

fn rest(model: &mut Model) {
    for _ in 0..4 {
        settle(model);
    }
    assert!(model.is_mapped() && model.is_sharp());
}

/// Frames until nothing goes on; returns how many commands moved the points.
fn run(model: &mut Model, is_calm: bool) -> usize {
    let mut moves = 0;
    for frame in 0u32.. {
        let (commands, goes_on) = model.advance_best(f64::from(frame) / 60.0, is_calm);
        moves += commands.len();
        for command in commands {
            model.dispatch(command, 0.0);
        }
        model.refresh(true);
        if !goes_on {
            break;
        }
        assert!(frame < 100_000, "it does not end");
    }
    moves
}

#[test]
fn the_points_move_to_the_best_map_in_small_steps_or_at_once() {
    for is_calm in [false, true] {
        let mut model = model([]);
        let before = model.session().clone();
        model.act_on_best(BestAction::Start);
        assert!(model.best().progress().is_some());
        let moves = run(&mut model, is_calm);
        let outcome = model.best().outcome().unwrap().clone();
        assert!(if is_calm { moves == 2 } else { moves > 100 }, "{moves} moves");
        assert!(outcome.after < 0.95 * outcome.before && outcome.evaluations > 100, "{outcome:?}");
        let measured = Criterion::Area.measure(model.map().unwrap()).unwrap();
        assert!((measured - outcome.after).abs() < 1e-9, "{measured} is shown, {} was said", outcome.after);
        let after = model.session();
        assert_ne!(after.side(Side::Source).interior(), before.side(Side::Source).interior());
    }
}

#[test]
fn a_search_is_cancelled_or_ended_by_a_change_and_nothing_moves() {
    let mut model = model([]);
    model.act_on_best(BestAction::Start);
    model.advance_best(0.0, false);
    model.act_on_best(BestAction::Cancel);
    let before = model.session().clone();
    assert_eq!((run(&mut model, false), model.best().outcome(), model.best().error()), (0, None, None));
    assert_eq!(model.session(), &before);
    model.act_on_best(BestAction::Start);
    model.dispatch(Command::MoveAnchor { side: Side::Target, fraction: 0.3 }, 0.0);
    assert_eq!((run(&mut model, false), model.best().outcome()), (0, None));
    assert_eq!(model.best().error(), Some(&key::best_map_interrupted().into()));
}

/// What the user does while the points move is not overwritten, and the result of another map is not shown on.
#[test]
fn points_that_move_to_the_best_map_stop_where_somebody_moves_them() {
    let mut model = model([]);
    model.act_on_best(BestAction::Start);
    let mut time = 0.0;
    while !model.best().is_moving() || time < 0.2 {
        time += if model.best().is_moving() { 0.05 } else { 0.0 };
        for command in model.advance_best(time, false).0 {
            model.dispatch(command, 0.0);
        }
        model.refresh(true);
    }
    assert!(model.best().outcome().is_some());
    model.dispatch(Command::MoveAnchor { side: Side::Target, fraction: 0.3 }, 0.0);
    let moved = model.session().clone();
    assert_eq!((run(&mut model, false), model.best().is_moving(), model.best().outcome()), (0, false, None));
    assert_eq!(model.session(), &moved);
}

/// The found point of a gingerbread man with even scales lies where its equation was not resolved.
#[test]
fn a_side_that_is_prepared_anew_for_the_found_point_keeps_the_result() {
    let mut model = Model::new(Session::default());
    model.update_ms = f64::INFINITY;
    let answer = |model: &mut Model| {
        for _ in 0..8 {
            settle(model);
            for (side, request) in model.take_requests(f64::INFINITY) {
                crate::worker::run(&request, &mut |generation, response| model.accept(side, generation, response));
            }
        }
        model.refresh(false);
        assert!(model.is_mapped() && model.is_sharp());
    };
    answer(&mut model);
    let before = model.prepared(Side::Source).cloned().unwrap();
    model.act_on_best(BestAction::Aim(Aim::Scale));
    model.act_on_best(BestAction::Start);
    run(&mut model, true);
    let outcome = model.best().outcome().cloned().unwrap();
    answer(&mut model);
    run(&mut model, true);
    assert!(!Arc::ptr_eq(&before, model.prepared(Side::Source).unwrap()), "it was prepared anew");
    assert_eq!(model.best().outcome(), Some(&outcome));
}

#[test]
fn pins_are_dropped_for_the_best_map() {
    let mut model = model([]);
    let pins = model.first_pins().unwrap().unwrap();
    model.dispatch(Command::SetPins(Some(pins)), 0.0);
    rest(&mut model);
    model.act_on_best(BestAction::Start);
    run(&mut model, true);
    assert!(model.pins().is_none() && model.best().outcome().is_some());
}

#[test]
fn a_region_is_painted_dab_by_dab_and_its_areas_are_kept() {
    let mut model = model([]);
    model.act_on_best(BestAction::Aim(Aim::Region));
    assert!(!model.can_search(), "nothing is painted");
    let at = |x: f64| DVec3::new(x, -0.5, 0.0);
    for x in [-0.5, 0.0, 0.5] {
        let region = model.region_with([at(x)]).unwrap();
        model.dispatch(Command::SetRegion(region), 0.0);
        assert_eq!(model.region_with([at(x)]), None, "painted already");
    }
    assert_eq!(model.session().region().len(), 3);
    model.advance_best(0.0, false);
    let count = model.prepared(Side::Source).unwrap().triangles().len();
    let mut painted: Vec<usize> = model.best().painted(count).iter().map(|part| part.triangle).collect();
    painted.dedup();
    let share = painted.len() as f64 / count as f64;
    assert!(share > 0.005 && share < 0.5, "{share} of the triangles");
    model.act_on_best(BestAction::Start);
    run(&mut model, true);
    let outcome = model.best().outcome().unwrap();
    assert!(outcome.aim == Aim::Region && outcome.after < outcome.before, "{outcome:?}");
    model.dispatch(outline(Side::Source, Preset::Heart), 0.0);
    assert_eq!(model.session().region().len(), 3, "the outline may be refused");
    assert!(model.requested().region().is_empty());
    rest(&mut model);
    assert!(model.session().region().is_empty(), "it was painted on another outline");
}

#[test]
fn on_a_surface_a_dab_is_a_ball_and_the_search_begins_at_its_points() {
    let surface = spec(SurfacePreset::Hemisphere, 60);
    let mut model = model([Command::SetSurface { side: Side::Source, surface }]);
    model.act_on_best(BestAction::Aim(Aim::Region));
    let region = model.region_with([DVec3::new(0.6, 0.0, 0.8)]).unwrap();
    model.dispatch(Command::SetRegion(region), 0.0);
    model.advance_best(0.0, false);
    let count = model.prepared(Side::Source).unwrap().triangles().len();
    assert!(!model.best().painted(count).is_empty() && model.best().painted(count + 1).is_empty());
    model.act_on_best(BestAction::Start);
    run(&mut model, true);
    let outcome = model.best().outcome().unwrap();
    assert!(outcome.after < 0.5 * outcome.before, "{outcome:?}");
    model.act_on_best(BestAction::Landscape(true));
    run(&mut model, true);
    assert!(model.best().landscape().is_none(), "only over an outline");
}

#[test]
fn the_landscape_stays_while_its_point_moves_and_follows_the_rest() {
    let mut model = model([]);
    model.act_on_best(BestAction::Landscape(true));
    run(&mut model, false);
    let lowest = |model: &Model| model.best().landscape().unwrap().marks().unwrap().lowest;
    let place = lowest(&model);
    let landscape = model.best().landscape().unwrap();
    assert!(landscape.levels().len() > 5 && landscape.ranks().iter().all(|rank| (0.0..=1.0).contains(rank)));
    model.dispatch(Command::MoveInterior { side: Side::Source, point: place.into() }, 0.0);
    rest(&mut model);
    assert!(!model.advance_best(0.0, false).1 && lowest(&model) == place, "x₁ is not part of it");
    let x2 = model.interior(Side::Target).unwrap() + crate::geometry::DVec2::new(0.4, 0.0);
    model.dispatch(Command::MoveInterior { side: Side::Target, point: x2.into() }, 0.0);
    rest(&mut model);
    assert!(model.advance_best(0.0, false).1, "x₂ is");
    run(&mut model, false);
    assert_ne!(lowest(&model), place);
}
