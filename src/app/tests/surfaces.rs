//! Surfaces on either side of the screen: shown, dragged, chosen from the menu, swapped.

use super::panels::click_in_panel;
use super::*;
use crate::app::arrangement::legend_side;
use crate::conformal::PerSide;
use crate::session::{Colouring, SurfaceShape, SurfaceSpec};
use crate::surface::SurfacePreset;
use egui::{Vec2, pos2, vec2};

/// Waits for the workers until `is_there`.
fn step_until(harness: &mut Harness<'_, RiemapApp>, is_there: impl Fn(&Stats) -> bool) {
    for _ in 0..600 {
        harness.step();
        if is_there(&harness.state().stats()) {
            harness.run_steps(3); // dots are where the map is from the next frame on
            return;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert!(is_there(&harness.state().stats()), "after 600 frames: {:?}", harness.state().stats());
}

/// The app with surfaces on these sides.
fn app_with<const N: usize>(surfaces: [(Side, SurfacePreset); N]) -> Harness<'static, RiemapApp> {
    let mut harness = ready_app([1200.0, 800.0]);
    for (side, preset) in surfaces {
        let shape = SurfaceShape::Preset { preset, boundary: 60 };
        let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
        let context = harness.ctx.clone();
        let set = Action::Session(Command::SetSurface { side, surface });
        harness.state_mut().carry_out(&context, vec![set]);
    }
    let wanted = surfaces.map(|(side, _)| side);
    for _ in 0..600 {
        harness.step();
        let app = harness.state();
        if app.model.is_ready() && wanted.iter().all(|&side| app.model.surface(side).is_some()) {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    harness.run_steps(3);
    let app = harness.state();
    assert!(app.model.is_ready() && app.stats().screen.errors.is_empty(), "{:?}", app.stats());
    assert!(Side::BOTH.into_iter().all(|side| app.model.surface(side).is_some() == wanted.contains(&side)));
    harness
}

/// Drags a dot, and waits for the map.
fn drag(harness: &mut Harness<'_, RiemapApp>, [x, y]: [f32; 2], by: Vec2) {
    let generation = harness.state().stats().map.generation;
    let from = pos2(x, y);
    harness.drag_at(from);
    harness.step();
    for step in 1..=4 {
        harness.hover_at(from + by * (step as f32 / 4.0));
        harness.step();
    }
    harness.drop_at(from + by);
    step_until(harness, |stats| stats.preparation.ready && stats.map.generation > generation);
}

fn distance(a: Option<[f32; 2]>, b: Option<[f32; 2]>) -> f32 {
    let [a, b] = [a, b].map(|place| Vec2::from(place.unwrap()));
    (a - b).length()
}

#[test]
fn a_surface_on_the_source_is_dragged_like_one_on_the_target() {
    for side in Side::BOTH {
        let mut harness = app_with([(side, SurfacePreset::Hemisphere)]);
        let point = |harness: &Harness<'_, RiemapApp>| {
            let handles = harness.state().stats().screen.handles;
            match side {
                Side::Source => [handles.x1, handles.y1],
                Side::Target => [handles.x2, handles.y2],
            }
        };
        let [x, y] = point(&harness);
        drag(&mut harness, x.unwrap(), vec2(30.0, 20.0));
        let [u, v] = point(&harness);
        assert!((distance(x, u) - vec2(30.0, 20.0).length()).abs() < 1.0, "{side}: from {x:?} to {u:?}");
        assert_eq!(y, v, "the boundary point stays");
        assert!(harness.state().session().surface(side).unwrap().point.is_some());
        drag(&mut harness, v.unwrap(), vec2(-30.0, 10.0));
        assert!(
            distance(point(&harness)[1], v) > 10.0 && harness.state().session().side(side).points().anchor() != 0.0
        );
        let quality = harness.state().model.quality().unwrap();
        assert!(quality.q_mean < 1.2 && quality.flipped == 0, "{side}: {quality:?}");
        // a key moves it too
        let name = if side == Side::Source {
            "x₁, interior point of the source"
        } else {
            "x₂, interior point of the target"
        };
        harness.get_by_label(name).focus();
        harness.run_steps(3);
        let [x, _] = point(&harness);
        harness.key_press(egui::Key::ArrowRight);
        harness.run_steps(4);
        assert!((distance(point(&harness)[0], x) - 10.0).abs() < 0.5, "{side}");
    }
}

#[test]
fn two_surfaces_are_turned_one_by_one_and_dragged_on_both_sides() {
    let mut harness = app_with([(Side::Source, SurfacePreset::Hemisphere), (Side::Target, SurfacePreset::Paraboloid)]);
    let before = harness.state().stats();
    for (handle, by) in [(before.screen.handles.x1, vec2(25.0, 20.0)), (before.screen.handles.x2, vec2(-20.0, 25.0))] {
        drag(&mut harness, handle.unwrap(), by);
    }
    let dragged = harness.state().stats();
    assert!(distance(before.screen.handles.x1, dragged.screen.handles.x1) > 20.0);
    assert!(distance(before.screen.handles.x2, dragged.screen.handles.x2) > 20.0);
    assert!(dragged.quality.q_mean.unwrap() < 1.3 && dragged.quality.flipped == Some(0), "{:?}", dragged.quality);
    let [image, expected] = [dragged.map.image_of_mapped_point, dragged.map.expected].map(Option::unwrap);
    assert!((glam::DVec2::from(image) - glam::DVec2::from(expected)).length() < 0.03, "{image:?}");
    // beside the dots a drag turns the surface under the pointer, and the other one stays
    let [x, y] = dragged.screen.handles.x1.unwrap();
    harness.drag_at(pos2(x + 60.0, y + 60.0));
    harness.step();
    harness.hover_at(pos2(x + 20.0, y + 50.0));
    harness.step();
    harness.drop_at(pos2(x + 20.0, y + 50.0));
    harness.run_steps(30);
    let turned = harness.state().stats();
    assert!(distance(dragged.screen.handles.x1, turned.screen.handles.x1) > 5.0);
    assert_eq!(dragged.screen.handles.x2, turned.screen.handles.x2);
    assert_eq!(dragged.map.boundary_checksum, turned.map.boundary_checksum);
}

#[test]
fn the_legend_of_the_colors_stands_beside_what_is_colored() {
    let surfaces = [(Side::Source, SurfacePreset::Hemisphere), (Side::Target, SurfacePreset::Paraboloid)];
    let mut both = app_with(surfaces);
    let one = app_with([surfaces[0]]);
    assert_eq!(legend_side(&one.state().model), Side::Target, "the plane beside the surface is colored too");
    for direction in [Direction::Forward, Direction::Backward] {
        let commands = [Command::SetColouring(Colouring::Angle), Command::SetDirection(direction)];
        let context = both.ctx.clone();
        both.state_mut().carry_out(&context, commands.map(Action::Session).to_vec());
        both.run_steps(60);
        let app = both.state();
        assert!(app.model.is_ready() && app.pictures.cells.scale().is_some());
        assert_eq!(legend_side(&app.model), direction.mapped_side());
    }
}

#[test]
fn undo_takes_back_a_drag_on_a_source_s_surface_and_swapping_exchanges_the_sides() {
    let mut harness = app_with([(Side::Source, SurfacePreset::Hemisphere)]);
    harness.run_steps(60);
    let before = harness.state().session().clone();
    let x = harness.state().stats().screen.handles.x1.unwrap();
    drag(&mut harness, x, vec2(30.0, 20.0));
    harness.run_steps(60);
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    step_until(&mut harness, |stats| stats.preparation.ready);
    assert_eq!(harness.state().session(), &before);
    harness.get_by_label("Swap").click();
    harness.run_steps(2);
    step_until(&mut harness, |stats| stats.preparation.ready);
    let session = harness.state().session();
    assert_eq!(session.surface(Side::Target), before.surface(Side::Source));
    assert!(session.surface(Side::Source).is_none());
}

#[test]
fn the_panel_has_the_controls_of_each_surface_and_the_direction_between_two() {
    let mut model = prepared_model();
    let set = |side| {
        let shape = SurfaceShape::Preset { preset: SurfacePreset::Saddle, boundary: 40 };
        Command::SetSurface { side, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } }
    };
    model.dispatch(set(Side::Source), 0.0);
    finish_preparations(&mut model);
    let back = [Action::Session(Command::CloseSurface(Side::Source))];
    assert_eq!(click_in_panel(&model, "Back to the plane"), back);
    model.dispatch(set(Side::Target), 0.0);
    finish_preparations(&mut model);
    assert!(model.is_through_disk());
    assert_eq!(click_in_panel(&model, "Forward"), [Action::Session(Command::SetDirection(Direction::Forward))]);
}

/// The app with surfaces on these sides, drawn on an adapter.
fn drawn_app_with(surfaces: &[(Side, SurfacePreset)]) -> Harness<'static, RiemapApp> {
    let mut session = prepared_model().session().clone();
    for &(side, preset) in surfaces {
        let shape = SurfaceShape::Preset { preset, boundary: 60 };
        session.apply(Command::SetSurface { side, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } });
    }
    let startup = Startup::start(session);
    let mut harness = Harness::builder()
        .with_size([1200.0, 800.0])
        .wgpu()
        .build_eframe(|creation| RiemapApp::new(creation, startup).unwrap());
    step_until(&mut harness, |stats| stats.preparation.ready);
    harness
}

/// The middle of each side's viewport, without titles and legends, once it is drawn at full resolution.
fn middles(harness: &mut Harness<'_, RiemapApp>) -> PerSide<Vec<[u8; 4]>> {
    for _ in 0..2 {
        harness.run_steps(60);
        harness.render().unwrap(); // in software the first picture after a change is coarse
    }
    let image = harness.render().unwrap();
    PerSide::from_fn(|side| {
        let rect = harness.state().pictures.views[side].rect;
        let [from, to] = [rect.lerp_inside(Vec2::splat(0.25)), rect.lerp_inside(Vec2::splat(0.75))];
        let rows = (from.y as u32..to.y as u32).flat_map(|y| (from.x as u32..to.x as u32).map(move |x| (x, y)));
        rows.map(|(x, y)| image.get_pixel(x, y).0).collect()
    })
}

/// The share of pixels in which two pictures differ.
fn change(one: &[[u8; 4]], other: &[[u8; 4]]) -> f64 {
    assert_eq!(one.len(), other.len());
    one.iter().zip(other).filter(|(a, b)| a != b).count() as f64 / one.len() as f64
}

/// The share of pixels that are neither red nor blue, as the middle of the diverging scale; light scales all channels
/// alike.
fn neutral(pixels: &[[u8; 4]]) -> f64 {
    let is_neutral = |[red, green, blue, _]: &&[u8; 4]| {
        let brightest = f64::from(*red.max(green).max(blue)).max(1.0);
        (f64::from(*red) - f64::from(*blue)).abs() < 0.15 * brightest
    };
    pixels.iter().filter(is_neutral).count() as f64 / pixels.len() as f64
}

#[test]
fn the_colors_of_triangles_are_on_the_mapped_surface_and_beside_one_in_the_plane() {
    need_adapter();
    let surfaces = [(Side::Source, SurfacePreset::AnimalHead), (Side::Target, SurfacePreset::HalfTorus)];
    let [forward, backward] = [Direction::Forward, Direction::Backward];
    let cases = [
        (&surfaces[..], forward, vec![forward.mapped_side()]),
        (&surfaces[..], backward, vec![backward.mapped_side()]),
        (&surfaces[..1], forward, Side::BOTH.to_vec()),
        (&surfaces[1..], forward, Side::BOTH.to_vec()),
    ];
    for (number, (surfaces, direction, colored)) in cases.into_iter().enumerate() {
        let mut harness = drawn_app_with(surfaces);
        let context = harness.ctx.clone();
        let set = |command, harness: &mut Harness<'_, RiemapApp>| {
            harness.state_mut().carry_out(&context, vec![Action::Session(command)]);
            middles(harness)
        };
        let textured = set(Command::SetDirection(direction), &mut harness);
        let areas = set(Command::SetColouring(Colouring::Area), &mut harness);
        for side in Side::BOTH {
            let (change, neutral) = (change(&textured[side], &areas[side]), neutral(&areas[side]));
            eprintln!("case {number}, {side}: {change:.3} of the pixels change, {neutral:.3} are neutral");
            if colored.contains(&side) {
                // a mesh without codes has the color of the scale's end
                assert!(change > 0.3 && neutral > 0.1, "case {number}, {side}");
            } else {
                assert_eq!(change, 0.0, "case {number}, {side}");
            }
        }
    }
}

#[test]
fn the_picture_of_the_other_surface_stays_while_one_is_refined() {
    need_adapter();
    let mut harness =
        drawn_app_with(&[(Side::Source, SurfacePreset::Hemisphere), (Side::Target, SurfacePreset::Saddle)]);
    let before = middles(&mut harness);
    let app = harness.state_mut();
    app.model.update_ms = 0.0;
    let shape = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 90 };
    let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
    let context = harness.ctx.clone();
    let refine = Action::Session(Command::RefineSurface { side: Side::Source, surface: surface.clone() });
    harness.state_mut().carry_out(&context, vec![refine]);
    let is_refined = |app: &RiemapApp| app.session().surface(Side::Source).unwrap().spec == surface;
    super::step_until(&mut harness, is_refined);
    assert!(!harness.state().model.is_ready(), "its map takes several frames");
    let image = harness.render().unwrap();
    let middle = |harness: &Harness<'_, RiemapApp>, side: Side| harness.state().pictures.views[side].rect.center();
    let places = Side::BOTH.map(|side| middle(&harness, side));
    harness.state_mut().model.update_ms = f64::INFINITY;
    step_until(&mut harness, |stats| stats.preparation.ready);
    let after = middles(&mut harness);
    assert!(change(&before.target, &after.target) < 0.01);
    assert!(change(&before.source, &after.source) < 0.7);
    let canvas = theme::Palette::of(&harness.ctx.global_style().visuals).canvas;
    for place in places {
        let pixel = image.get_pixel(place.x as u32, place.y as u32).0;
        assert_ne!(pixel, canvas.to_array(), "the viewport at {place} is blank");
    }
}
