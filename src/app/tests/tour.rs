//! The guided tour on the screen: the room of the pictures, the motions of its steps, the probe, and its end.

use crate::app::RiemapApp;
use crate::app::input::action::{Action, ExploreAction, ExportAction};
use crate::app::input::preferences::Preferences;
use crate::app::input::presentation;
use crate::app::tests::{ready_app, step_until};
use crate::app::windows::explore::tour::steps::steps;
use crate::conformal::Side;
use crate::family::Path;
use crate::language::{self, Language, Message, key, tr};
use crate::model::motion::PlayAction;
use crate::platform::Event;
use crate::session::{Command, Session};
use egui::{Key, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

/// A desktop, a laptop, a tablet, a phone upright and on its side.
const SCREENS: [[f32; 2]; 8] = [
    [1440.0, 900.0],
    [1280.0, 720.0],
    [720.0, 450.0],
    [820.0, 1180.0],
    [390.0, 844.0],
    [390.0, 664.0],
    [375.0, 553.0],
    [844.0, 390.0],
];
const STEPS: usize = 6;

type Screen = Harness<'static, RiemapApp>;

fn go(screen: &mut Screen, step: usize) {
    let context = screen.ctx.clone();
    screen.state_mut().carry_out(&context, vec![Action::Explore(ExploreAction::Tour(step))]);
    screen.run_steps(4);
}

/// Fails unless the pictures have three fifths of the screen's height, and the buttons are on the screen.
fn assert_room(screen: &Screen, what: &str) {
    let whole = screen.ctx.content_rect();
    let views = &screen.state().pictures.views;
    let pictures = views.source.rect.union(views.target.rect);
    assert!(pictures.height() >= 0.6 * whole.height(), "{what}: {pictures:?} of {whole:?}");
    for button in ["Back", "End"] {
        let rect = screen.get_by_label(button).rect();
        assert!(whole.contains_rect(rect) && !pictures.intersects(rect), "{what}: {button} at {rect:?}");
    }
}

#[test]
fn when_the_graphics_are_lost_the_tour_gives_back_the_own_session_and_the_map_is_said_to_be_kept() {
    let mut screen = ready_app([1440.0, 900.0]);
    let own = screen.state().model.session().clone();
    go(&mut screen, 1);
    assert_ne!(screen.state().model.session(), &own);
    let mailbox = screen.state().workers.mailbox.clone();
    mailbox.post(Event::GraphicsLost("unplugged".into()));
    step_until(&mut screen, |app| app.messages.common.is_some());
    assert_eq!(screen.state().model.session(), &own);
    let said = screen.state().messages.common.as_ref().map(Message::english);
    assert_eq!(
        said.as_deref(),
        Some("The graphics device was lost (unplugged). Start riemap again: the map and its undo steps are kept.")
    );
}

#[test]
fn pictures_have_three_fifths_of_the_height_in_every_step() {
    for size in SCREENS {
        let mut screen = ready_app(size);
        for step in 0..STEPS {
            go(&mut screen, step);
            assert_room(&screen, &format!("{size:?}, step {step}"));
        }
    }
    let mut screen = ready_app([1920.0, 1080.0]);
    presentation::toggle(&screen.ctx);
    for step in 0..STEPS {
        go(&mut screen, step);
        assert_room(&screen, &format!("presentation, step {step}"));
    }
}

/// A laptop's screen at 200 %, and a phone on its side.
const LOW: [[f32; 2]; 2] = [[720.0, 450.0], [844.0, 390.0]];

#[test]
fn on_low_screens_the_words_of_every_step_fit_above_one_row_of_buttons() {
    for language in [Language::English, Language::German] {
        for size in LOW {
            let mut screen = ready_app(size);
            screen.state_mut().screen.preferences = Preferences { language: Some(language), ..Preferences::fixed() };
            language::set(language);
            for (step, shown) in steps().iter().enumerate() {
                go(&mut screen, step);
                let what = format!("{language:?}, {size:?}, step {step}");
                let on = if step + 1 == STEPS { key::keep_picture() } else { key::next() };
                let again = [key::show_again(), key::stop_here(), key::show_step()];
                let again = again.into_iter().filter(|label| screen.query_by_label(tr(*label)).is_some());
                let labels = [key::back(), on, key::end()].into_iter().chain(again);
                let row: Vec<Rect> = labels.map(|label| screen.get_by_label(tr(label)).rect()).collect();
                assert!(row.iter().all(|rect| (rect.center().y - row[0].center().y).abs() < 2.0), "{what}: {row:?}");
                let words = screen.get_by_label(tr(shown.text)).rect();
                assert!(words.bottom() <= row[0].top(), "{what}: {words:?} above {row:?}");
            }
        }
    }
    language::set(Language::English);
}

#[test]
fn escape_ends_the_tour_and_brings_the_picture_from_before_back() {
    let mut screen = ready_app([1200.0, 800.0]);
    let mine = screen.state().session().clone().and([Command::SetTextureScale(13.0)]);
    screen.state_mut().show_session(mine.clone());
    go(&mut screen, 2);
    assert!(*screen.state().session() != mine);
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    assert!(!screen.state().windows.explore.is_touring());
    assert_eq!(*screen.state().session(), mine);
}

/// The constraints of a session that differ from those of another one: x₁, x₂, y₁.
fn moved(now: &Session, before: &Session) -> [bool; 3] {
    let interior = |side| now.side(side).interior != before.side(side).interior;
    let anchor = now.side(Side::Source).anchor() != before.side(Side::Source).anchor();
    [interior(Side::Source), interior(Side::Target), anchor]
}

#[test]
fn the_step_of_three_freedoms_moves_one_point_after_another_and_then_rests() {
    let mut screen = ready_app([700.0, 500.0]);
    let (player, model) = {
        let app = screen.state_mut();
        (&mut app.player, &app.model)
    };
    player.act(PlayAction::Along(Path::SourcePoint), model);
    player.act(PlayAction::Period(20.0), model);
    go(&mut screen, 2);
    step_until(&mut screen, |app| app.model.is_ready());
    let places = |screen: &Screen| {
        let app = screen.state();
        (Side::BOTH.map(|side| app.model.interior(side)), app.session().side(Side::Source).anchor())
    };
    let begun = places(&screen);
    let mut order = Vec::new();
    let mut before = screen.state().session().clone();
    for _ in 0..4000 {
        screen.step();
        let now = screen.state().session().clone();
        let points = moved(&now, &before);
        if points != [false; 3] && order.last() != Some(&points) {
            order.push(points);
        }
        before = now;
        if order.len() == 3 && !screen.state().player.is_playing() {
            break;
        }
    }
    assert_eq!(order, [[true, false, false], [false, true, false], [false, false, true]]);
    screen.run_steps(20);
    assert!(!screen.state().player.is_playing() && *screen.state().session() == before);
    let (ends, anchor) = places(&screen);
    for (end, start) in ends.into_iter().zip(begun.0) {
        let (end, start) = (end.unwrap(), start.unwrap());
        assert!(end.distance(start) < 1e-9, "once around: {end} is not {start}");
    }
    assert!((anchor - begun.1).abs() < 1e-9);
    screen.state_mut().explore(ExploreAction::LeaveTour { keeps: false });
    let player = &screen.state().player;
    assert_eq!((player.path(), player.period()), (Path::SourcePoint, 20.0), "the player has its settings back");
}

#[test]
fn a_dot_that_the_user_takes_ends_the_motion_of_the_step() {
    let mut screen = ready_app([1200.0, 800.0]);
    go(&mut screen, 0);
    step_until(&mut screen, |app| app.player.is_moving());
    let dot = egui::Pos2::from(screen.state().stats().screen.handles.x2.unwrap());
    screen.drag_at(dot);
    screen.run_steps(2);
    assert!(!screen.state().player.is_playing(), "at once");
    screen.drop_at(dot);
    screen.run_steps(30);
    assert!(!screen.state().player.is_playing());
}

#[test]
fn a_dot_that_is_taken_before_the_first_motion_keeps_it_from_beginning() {
    let mut screen = ready_app([1200.0, 800.0]);
    go(&mut screen, 0);
    let dot = egui::Pos2::from(screen.state().stats().screen.handles.x2.unwrap());
    screen.drag_at(dot);
    screen.step();
    screen.drop_at(dot);
    step_until(&mut screen, |app| app.model.is_ready());
    screen.run_steps(30);
    assert!(!screen.state().player.is_playing());
}

#[test]
fn the_card_stops_the_motion_and_shows_it_again() {
    let mut screen = ready_app([1200.0, 800.0]);
    go(&mut screen, 0);
    step_until(&mut screen, |app| app.player.is_moving());
    screen.run_steps(2);
    screen.get_by_label("Stop here").click();
    screen.run_steps(3);
    assert!(!screen.state().player.is_playing());
    screen.get_by_label("Again").click();
    step_until(&mut screen, |app| app.player.is_moving());
}

#[test]
fn escape_that_closes_a_menu_or_a_window_leaves_the_tour() {
    let mut screen = ready_app([1200.0, 800.0]);
    go(&mut screen, 1);
    screen.get_by_label("File").click();
    screen.run_steps(3);
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    assert!(screen.state().windows.explore.is_touring(), "the menu was closed");
    let context = screen.ctx.clone();
    screen.state_mut().carry_out(&context, vec![Action::Export(ExportAction::Open)]);
    screen.run_steps(3);
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    assert!(screen.state().windows.explore.is_touring(), "the window was closed");
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    assert!(!screen.state().windows.explore.is_touring());
}

#[test]
fn the_probe_is_dragged_and_its_image_follows() {
    let mut screen = ready_app([1200.0, 800.0]);
    go(&mut screen, 1);
    step_until(&mut screen, |app| app.pictures.probe.is_some() && app.model.is_ready());
    let (probe, before) = {
        let app = screen.state();
        (app.input.handles.probe.unwrap(), app.pictures.probe.clone().unwrap())
    };
    let at = screen.state().pictures.views.source.to_screen(probe.center);
    let camera = screen.state().pictures.views.source.camera();
    screen.drag_at(at);
    screen.step();
    screen.hover_at(at + egui::vec2(0.0, -30.0));
    screen.step();
    screen.drop_at(at + egui::vec2(0.0, -30.0));
    screen.run_steps(3);
    let app = screen.state();
    let there = app.pictures.views.source.to_screen(app.input.handles.probe.unwrap().center);
    assert!(there.distance(at + egui::vec2(0.0, -30.0)) < 1.0, "from {at} to {there}");
    assert_eq!(app.pictures.views.source.camera(), camera, "the picture stays");
    let after = app.pictures.probe.as_ref().unwrap();
    assert!(after.center.image.distance(before.center.image) > 0.01);
    go(&mut screen, 2);
    assert!(screen.state().input.handles.probe.is_none(), "another step has none");
}

#[test]
fn a_presentation_folds_the_controls_and_marks_the_pointer() {
    let mut screen = ready_app([1920.0, 1080.0]);
    assert!(screen.query_by_label("Checker").is_some());
    presentation::toggle(&screen.ctx);
    screen.run_steps(3);
    assert!(screen.query_by_label("Checker").is_none(), "the pictures have the width");
    let place = egui::pos2(400.0, 300.0);
    screen.hover_at(place);
    screen.run_steps(2);
    let is_ring = |shape: &egui::Shape| matches!(shape, egui::Shape::Circle(ring) if ring.center == place);
    assert_eq!(screen.output().shapes.iter().filter(|clipped| is_ring(&clipped.shape)).count(), 2, "rim and ring");
    presentation::toggle(&screen.ctx);
    screen.run_steps(3);
    assert!(screen.query_by_label("Checker").is_some());
}

#[test]
fn undo_in_the_tour_begins_the_step_anew_and_leaves_the_own_history_alone() {
    let mut screen = ready_app([1200.0, 800.0]);
    step_until(&mut screen, |app| app.persistence.history().can_undo() || app.model.is_ready());
    let context = screen.ctx.clone();
    let own = screen.state().session().clone().and([Command::SetTextureScale(13.0)]);
    screen.state_mut().carry_out(&context, vec![Action::Session(Command::SetTextureScale(13.0))]);
    step_until(&mut screen, |app| app.persistence.history().undo_count() == 1);
    go(&mut screen, 1);
    let begun = screen.state().session().clone();
    screen.state_mut().carry_out(&context, vec![Action::Session(Command::SetTextureScale(40.0))]);
    screen.run_steps(3);
    for action in [Action::Redo, Action::Undo] {
        screen.state_mut().carry_out(&context, vec![action]);
        screen.run_steps(3);
    }
    assert_eq!(screen.state().session(), &begun);
    screen.state_mut().explore(ExploreAction::LeaveTour { keeps: false });
    step_until(&mut screen, |app| app.model.is_ready());
    screen.run_steps(3);
    let app = screen.state();
    assert_eq!((app.session(), app.persistence.history().undo_count()), (&own, 1));
    assert!(!app.persistence.history().can_redo());
}

#[test]
fn arrow_keys_move_the_focused_probe_and_escape_leaves_it_before_the_tour() {
    let mut screen = ready_app([1200.0, 800.0]);
    go(&mut screen, 1);
    step_until(&mut screen, |app| app.pictures.probe.is_some() && app.model.is_ready());
    screen.get_by_label("circle with a cross, in the source").focus();
    screen.run_steps(3);
    let place = |screen: &Screen| {
        let app = screen.state();
        app.pictures.views.source.to_screen(app.input.handles.probe.unwrap().center)
    };
    let at = place(&screen);
    screen.key_press(Key::ArrowUp);
    screen.run_steps(3);
    screen.key_press_modifiers(egui::Modifiers::SHIFT, Key::ArrowUp);
    screen.run_steps(3);
    let there = place(&screen);
    assert!(there.distance(at - egui::vec2(0.0, 11.0)) < 0.1, "from {at} to {there}");
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    assert!(screen.state().windows.explore.is_touring());
    screen.key_press(Key::Escape);
    screen.run_steps(3);
    assert!(!screen.state().windows.explore.is_touring());
}

#[test]
fn where_no_motion_is_wanted_a_step_waits_until_the_user_asks_for_it() {
    let mut screen = ready_app([1200.0, 800.0]);
    screen.state_mut().windows.explore.is_calm = true;
    go(&mut screen, 0);
    step_until(&mut screen, |app| app.model.is_ready());
    let begun = screen.state().session().clone();
    // longer than the look at the picture before a motion
    screen.run_steps(200);
    assert!(!screen.state().player.is_playing() && *screen.state().session() == begun);
    screen.get_by_label("Show").click();
    step_until(&mut screen, |app| app.player.is_playing());
    go(&mut screen, 3);
    assert!(!screen.state().model.overlay_state().walks.is_running());
    screen.get_by_label("Show").click();
    screen.run_steps(3);
    assert!(screen.state().model.overlay_state().walks.is_running());
}

#[test]
fn where_the_plots_have_no_room_the_card_shows_them_on_request() {
    let mut screen = ready_app([390.0, 844.0]);
    go(&mut screen, 3);
    assert!(screen.query_by_label("Measure").is_none());
    let context = screen.ctx.clone();
    for shown in [true, false] {
        screen.state_mut().carry_out(&context, vec![Action::Explore(ExploreAction::CardPlots(shown))]);
        screen.run_steps(3);
        assert_eq!(screen.query_by_label("Measure").is_some(), shown);
        assert_room(&screen, "with plots on the card");
    }
}

#[test]
fn in_the_step_of_crowding_all_marks_meet_through_the_disk_and_stay_apart_without_it() {
    let mut screen = ready_app([1440.0, 900.0]);
    go(&mut screen, 4);
    step_until(&mut screen, |app| {
        let found = app.model.disk_comparison().is_some_and(|disk| disk.all_found().next().is_some());
        app.model.is_ready() && found
    });
    let model = &screen.state().model;
    let (_, found) = model.disk_comparison().unwrap().all_found().next().unwrap();
    assert_eq!(model.shown().unwrap().mapped_side(), Side::Source, "the words are about the marks on the blob");
    let spread = |places: &mut dyn Iterator<Item = f64>| {
        let (low, high) = places.fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at), high.max(at)));
        high - low
    };
    // fractions of the blob's length from y₂ on, which all marks come to
    let through_disk = spread(&mut found.marks.iter().map(|mark| (mark.through_disk + 0.5).fract()));
    let direct = spread(&mut found.marks.iter().map(|mark| mark.direct));
    assert!(through_disk < 1e-3 && direct > 0.9, "{through_disk} through the disk, {direct} directly");
}
