//! The first visit: the welcome, the folded controls, and the explanations of terms.

use super::ready_app;
use crate::app::input::preferences::{Habit, Habits};
use crate::app::*;
use crate::conformal::Side;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;

fn newcomer(size: [f32; 2]) -> Harness<'static, RiemapApp> {
    let mut harness = ready_app(size);
    harness.state_mut().screen.preferences.habits = Habits::default();
    harness.run_steps(3);
    harness
}

#[test]
fn the_welcome_covers_no_picture_and_goes_when_it_is_used_or_closed() {
    for size in [[1440.0, 900.0], [820.0, 1180.0], [390.0, 844.0], [844.0, 390.0]] {
        for way in ["Draw your own", "Take the tour", "Close the welcome"] {
            let mut harness = newcomer(size);
            let button = harness.get_by_label(way).rect();
            assert!(harness.ctx.content_rect().contains_rect(button), "{size:?}: {way} at {button:?}");
            let views = &harness.state().pictures.views;
            for side in Side::BOTH {
                assert!(!views[side].rect.intersects(button), "{size:?}: {way} covers the {side:?}");
            }
            harness.get_by_label(way).click();
            harness.run_steps(4);
            assert!(harness.query_by_label("Draw your own").is_none(), "{size:?}: {way}");
            assert!(harness.state().screen.preferences.habits.welcomed);
        }
    }
}

#[test]
fn the_first_drag_is_remembered_and_the_hint_does_not_return() {
    let mut harness = newcomer([1200.0, 800.0]);
    let place = harness.state().stats().screen.handles.x1.unwrap();
    harness.drag_at(place.into());
    harness.run_steps(2);
    harness.drop_at(place.into());
    harness.run_steps(2);
    let habits = harness.state().screen.preferences.habits;
    assert!(habits.dragged && Input::after(habits).handles.ever_dragged);
    assert!(!Input::after(Habits::default()).handles.ever_dragged);
}

#[test]
fn methods_are_folded_until_they_are_asked_for_and_each_is_explained() {
    let mut harness = ready_app([1200.0, 900.0]);
    assert!(harness.query_by_label("Cholesky").is_none() && harness.query_by_label("Checker").is_some());
    harness.get_by_label("Advanced").click();
    harness.run_steps(3);
    assert!(harness.state().screen.preferences.habits.advanced && harness.query_by_label("Cholesky").is_some());
    let words = "Which side is cut into triangles";
    assert!(harness.query_by_label_contains(words).is_some_and(|button| button.rect().width() < 30.0));
    assert_eq!(harness.query_all_by_label_contains(words).count(), 1);
    harness.get_by_label_contains(words).click();
    harness.run_steps(3);
    assert_eq!(harness.query_all_by_label_contains(words).count(), 2, "the popup has the words too");
    harness.state_mut().recall(Habit::Advanced(false));
    harness.run_steps(3);
    assert!(harness.query_by_label("Cholesky").is_none());
}

#[test]
fn the_plots_stand_beside_the_pictures_where_these_need_no_more_width() {
    for (size, beside) in [([1920.0, 1080.0], true), ([1280.0, 720.0], true), ([1440.0, 900.0], false)] {
        let mut harness = ready_app(size);
        harness.key_press(egui::Key::P);
        harness.run_steps(4);
        let plot = harness.get_by_label("Poisson kernel").rect();
        let target = harness.state().pictures.views.target.rect;
        assert_eq!(plot.left() > target.right(), beside, "{size:?}: {plot:?} and {target:?}");
        assert_eq!(plot.top() > target.bottom(), !beside, "{size:?}: {plot:?} and {target:?}");
    }
}

#[test]
fn the_column_and_the_plots_fold_separately() {
    let mut harness = ready_app([1440.0, 900.0]);
    harness.get_by_label("Plots").click();
    harness.get_by_label("Panels").click();
    harness.run_steps(4);
    assert!(harness.query_by_label("Checker").is_none() && harness.query_by_label("Poisson kernel").is_some());
    assert!(harness.query_by_label("File").is_some(), "the bar stays");
    harness.get_by_label("Panels").click();
    harness.get_by_label("Plots").click();
    harness.run_steps(4);
    assert!(harness.query_by_label("Checker").is_some() && harness.query_by_label("Poisson kernel").is_none());
}
