//! Motion of the points: they follow their path, stop where they are, and the whole motion is one undo step.

use crate::app::RiemapApp;
use crate::app::tests::{prepared_model, ready_app};
use crate::conformal::Side;
use crate::family::Path;
use crate::model::Model;
use crate::model::motion::{PlayAction, Player};
use crate::session::{Command, OutlineSpec, SurfaceShape, SurfaceSpec};
use crate::surface::SurfacePreset;
use egui::{Key, Modifiers};
use egui_kittest::Harness;

/// Advances the player by `frames` frames of 0.05 s each, starting at time `from`; returns the time at the end.
fn play_for(player: &mut Player, model: &mut Model, from: f64, frames: u32) -> f64 {
    for k in 1..=frames {
        for command in player.advance(model, from + f64::from(k) / 20.0) {
            model.dispatch(command, 0.0);
        }
        model.refresh(false);
    }
    from + f64::from(frames) / 20.0
}

#[test]
fn a_turn_ends_where_it_began_and_a_pause_leaves_the_points() {
    let mut model = prepared_model();
    let mut player = Player::default();
    player.act(PlayAction::Period(2.0), &model);
    let begun = model.interior(Side::Source).unwrap();
    player.act(PlayAction::Along(Path::All), &model);
    assert!(!player.is_playing(), "choosing a path does not start the motion");
    player.act(PlayAction::Toggle, &model);
    let half = play_for(&mut player, &mut model, 0.0, 21);
    let there = model.interior(Side::Source).unwrap();
    assert!(there.distance(begun) > 0.01 && model.map_error().is_none());
    player.act(PlayAction::Toggle, &model);
    play_for(&mut player, &mut model, half, 10);
    assert_eq!(model.interior(Side::Source), Some(there), "it is paused");
    player.act(PlayAction::Toggle, &model);
    play_for(&mut player, &mut model, 100.0, 21);
    let back = model.interior(Side::Source).unwrap();
    assert!(back.distance(begun) < 1e-9, "the same loop to its end: {back} is not {begun}");
}

#[test]
fn points_that_were_moved_begin_another_loop() {
    let mut model = prepared_model();
    let mut player = Player::default();
    player.act(PlayAction::Along(Path::SourcePoint), &model);
    player.act(PlayAction::Toggle, &model);
    play_for(&mut player, &mut model, 0.0, 9);
    player.pause();
    let point = model.interior(Side::Source).unwrap() + glam::DVec2::new(0.02, 0.01);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
    model.refresh(false);
    player.act(PlayAction::Toggle, &model);
    play_for(&mut player, &mut model, 50.0, 2);
    let moved = model.interior(Side::Source).unwrap();
    assert!(moved != point && moved.distance(point) < 0.05, "from {point} on, not from before: {moved}");
}

#[test]
fn another_outline_ends_the_motion() {
    let mut model = prepared_model();
    let mut player = Player::default();
    player.act(PlayAction::Toggle, &model);
    play_for(&mut player, &mut model, 0.0, 3);
    show_star(&mut model);
    play_for(&mut player, &mut model, 1.0, 3);
    assert!(!player.is_playing());
}

/// A model whose time per frame is too short to update its map.
fn slow_model() -> Model {
    let mut model = prepared_model();
    model.update_ms = 0.0;
    model
}

#[test]
fn another_motion_waits_for_a_slow_map_and_then_goes_on() {
    let mut model = slow_model();
    let mut player = Player::default();
    player.act(PlayAction::Along(Path::SourcePoint), &model);
    player.act(PlayAction::Toggle, &model);
    for now in [0.05, 0.1, 0.15] {
        for command in player.advance(&model, now) {
            model.dispatch(command, 0.0);
        }
    }
    model.refresh(true);
    assert!(player.is_moving() && !model.is_ready(), "the map is behind the points");
    let anchor = model.session().side(Side::Source).anchor();
    player.act(PlayAction::Along(Path::Boundary), &model);
    assert!(player.is_playing() && !player.is_moving());
    let there = model.interior(Side::Source);
    assert_eq!(player.advance(&model, 0.2), [], "the new motion waits for the map");
    for _ in 0..100_000 {
        if model.is_ready() {
            break;
        }
        model.refresh(player.is_moving());
    }
    assert!(model.is_ready(), "the map never becomes ready");
    play_for(&mut player, &mut model, 100.0, 4);
    assert!(player.is_moving());
    assert_eq!(model.interior(Side::Source), there, "the old motion is over");
    assert_ne!(model.session().side(Side::Source).anchor(), anchor);
}

#[test]
fn a_motion_that_waits_is_given_up_when_the_outline_becomes_another_one_or_it_is_paused() {
    for pauses in [false, true] {
        let mut model = slow_model();
        let mut player = Player::default();
        player.act(PlayAction::Toggle, &model);
        let point = model.interior(Side::Source).unwrap() + glam::DVec2::new(0.02, 0.01);
        model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
        model.refresh(true);
        player.act(PlayAction::Along(Path::SourcePoint), &model);
        assert!(player.is_playing() && !player.is_moving());
        if pauses {
            player.act(PlayAction::Toggle, &model);
        } else {
            show_star(&mut model);
        }
        model.update_ms = 1e9;
        play_for(&mut player, &mut model, 1.0, 3);
        assert!(!player.is_playing() && model.is_ready(), "pauses: {pauses}");
    }
}

#[test]
fn another_surface_ends_the_motion() {
    let surface = |boundary| {
        let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary };
        Command::SetSurface { side: Side::Target, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } }
    };
    let mut model = prepared_model();
    model.dispatch(surface(40), 0.0);
    carry_out_requests(&mut model);
    model.refresh(false);
    let mut player = Player::default();
    player.act(PlayAction::Along(Path::Boundary), &model);
    player.act(PlayAction::Toggle, &model);
    let now = play_for(&mut player, &mut model, 0.0, 3);
    assert!(player.is_moving());
    model.dispatch(surface(60), 0.0);
    carry_out_requests(&mut model);
    play_for(&mut player, &mut model, now, 2);
    assert!(!player.is_playing());
}

fn carry_out_requests(model: &mut Model) {
    for (side, request) in model.take_requests(f64::INFINITY) {
        crate::worker::run(&request, &mut |generation, response| model.accept(side, generation, response));
    }
}

fn show_star(model: &mut Model) {
    let outline = OutlineSpec::Preset(crate::outline::Preset::Star);
    model.dispatch(Command::SetOutline { side: Side::Source, outline }, 0.0);
    carry_out_requests(model);
}

fn y1(harness: &Harness<'_, RiemapApp>) -> [f32; 2] {
    harness.state().stats().screen.handles.y1.unwrap()
}

#[test]
fn space_plays_and_pauses_and_the_motion_is_one_undo_step() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.run_steps(3);
    let (start, session) = (y1(&harness), harness.state().session().clone());
    harness.key_press(Key::Space);
    harness.run_steps(8);
    let stats = harness.state().stats();
    assert!(stats.screen.playing && stats.screen.undo == 0 && y1(&harness) != start);
    harness.key_press(Key::Space);
    harness.run_steps(6);
    let there = y1(&harness);
    harness.run_steps(4);
    assert!(!harness.state().stats().screen.playing && y1(&harness) == there);
    assert_eq!(harness.state().stats().screen.undo, 1);
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    harness.run_steps(6);
    assert_eq!(harness.state().session(), &session);
}

#[test]
fn dragging_a_dot_pauses_the_motion() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.key_press(Key::Space);
    harness.run_steps(4);
    assert!(harness.state().stats().screen.playing);
    let [x, y] = harness.state().stats().screen.handles.x2.unwrap();
    harness.drag_at(egui::pos2(x, y));
    harness.run_steps(2);
    assert!(!harness.state().stats().screen.playing);
    harness.drop_at(egui::pos2(x, y));
    harness.run_steps(2);
}
