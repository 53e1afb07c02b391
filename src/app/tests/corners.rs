//! The marks at the corners of a smooth outline, clicked.

use crate::app::tests::{ready_app, step_until};
use crate::app::*;
use crate::conformal::Side;
use crate::geometry::{DVec2, SimplePolygon};
use crate::session::{Command, OutlineSpec};
use egui_kittest::Harness;

const SIDE: Side = Side::Source;

/// A half disk of 100 points, whose corners are the vertices 0 and 99.
fn half_disk() -> OutlineSpec {
    let point = |k: u32| DVec2::from_angle(std::f64::consts::PI * f64::from(k) / 99.0);
    let polygon = SimplePolygon::try_from((0..100).map(point).collect::<Vec<_>>()).unwrap();
    OutlineSpec::points(String::from("half disk"), polygon)
}

fn corner_count(app: &RiemapApp) -> usize {
    app.model.corners(SIDE).filter(|(corner, _)| corner.is_corner).count()
}

fn switched(app: &RiemapApp) -> Vec<u32> {
    match &app.model.session().domain(SIDE).outline {
        OutlineSpec::Points { form, .. } => form.switched.clone(),
        OutlineSpec::Preset(_) => Vec::new(),
    }
}

fn click(harness: &mut Harness<'_, RiemapApp>, at: egui::Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.step();
    harness.drop_at(at);
    harness.step();
}

#[test]
fn a_click_on_the_mark_of_a_corner_makes_it_smooth_and_another_one_a_corner_again() {
    let mut harness = ready_app([1200.0, 800.0]);
    harness.state_mut().model.dispatch(Command::SetOutline { side: SIDE, outline: half_disk() }, 0.0);
    step_until(&mut harness, |app| app.stats().preparation.ready && corner_count(app) == 2);
    // the boundary point's dot is at the first corner, and covers its mark
    let app = harness.state();
    let (corner, place) = app.model.corners(SIDE).last().unwrap();
    assert_eq!(corner.vertex, 99);
    let at = app.pictures.views[SIDE].to_screen(place);
    click(&mut harness, at);
    step_until(&mut harness, |app| app.stats().preparation.ready && corner_count(app) == 1);
    assert_eq!(switched(harness.state()), [99]);
    click(&mut harness, at);
    step_until(&mut harness, |app| app.stats().preparation.ready && corner_count(app) == 2);
    assert_eq!(switched(harness.state()), [0; 0]);
}
