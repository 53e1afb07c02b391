//! Pins in the model: the points follow, the map stays or changes with them, and errors are said.

use crate::conformal::{KernelMode, Pins, PrepareSettings, Side};
use crate::model::editing::{Change, Reshaping};
use crate::model::surface_tests::{planar, settle, spec};
use crate::model::*;
use crate::outline::{Preset, Sampling};
use crate::session::{Command, OutlineSpec};
use crate::surface::SurfacePreset;

/// Two outlines by formulas, with the integral kernel or with finite elements.
fn model(kernel: KernelMode) -> Model {
    let sampling = Sampling::Adaptive { target: Some(200) };
    let settings = PrepareSettings { sampling, kernel, ..PrepareSettings::default() };
    let session = Session::with(Side::BOTH.map(|side| Command::SetSettings { side, settings })).and([
        Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::LShape) },
        Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Blob) },
    ]);
    let mut model = Model::new(session);
    rest(&mut model);
    model
}

/// Answers all requests until there are none.
fn rest(model: &mut Model) {
    model.update_ms = f64::INFINITY;
    for _ in 0..8 {
        settle(model);
        for (side, request) in model.take_requests(f64::INFINITY) {
            crate::worker::run(&request, &mut |generation, response| model.accept(side, generation, response));
        }
    }
    model.refresh(false);
    assert!(model.is_mapped());
}

fn pin(model: &mut Model) -> Pins {
    let pins = model.first_pins().unwrap().unwrap();
    model.dispatch(Command::SetPins(Some(pins.clone())), 0.0);
    rest(model);
    pins
}

/// The largest distance between the images of a few boundary points and those of before, as a share of the length.
fn moved(model: &Model, before: &[f64]) -> f64 {
    let off = |a: f64, b: f64| {
        let gap = (a - b).rem_euclid(1.0);
        gap.min(1.0 - gap)
    };
    images(model).iter().zip(before).map(|(a, b)| off(*a, *b)).fold(0.0, f64::max)
}

fn images(model: &Model) -> Vec<f64> {
    let map = model.map().unwrap();
    (0..20).map(|k| map.boundary_image(Side::Source, f64::from(k) / 20.0)).collect()
}

#[test]
fn the_first_pins_keep_the_map() {
    for (kernel, most) in [(KernelMode::Integral, 1e-9), (KernelMode::Adjoint, 2e-3)] {
        let mut model = model(kernel);
        let before = images(&model);
        pin(&mut model);
        let off = moved(&model, &before);
        assert!(off <= most, "{kernel:?}: {off:.1e}");
        let misses = model.pin_misses().unwrap();
        assert!(misses.iter().all(|miss| *miss <= most), "{kernel:?}: {misses:?}");
    }
}

#[test]
fn a_dragged_pin_is_met_and_can_be_let_go() {
    let mut model = model(KernelMode::Integral);
    let pins = pin(&mut model);
    let before = images(&model);
    let fraction = pins.pairs()[1].target + 0.05;
    for step in [0.2, 0.6, 1.0] {
        let fraction = fraction - 0.05 * (1.0 - step);
        model.dispatch(Command::MovePin { pin: 1, side: Side::Target, fraction }, 0.0);
        model.refresh(true);
    }
    rest(&mut model);
    let misses = model.pin_misses().unwrap();
    assert!(misses.iter().all(|miss| *miss < 1e-9), "{misses:?}");
    let after = images(&model);
    assert!(moved(&model, &before) > 0.01);
    // the points that came out determine the same map
    model.dispatch(Command::SetPins(None), 0.0);
    rest(&mut model);
    assert_eq!(moved(&model, &after), 0.0);
    model.dispatch(Command::SetPins(Some(pins)), 0.0);
    let point = model.point(Side::Source).unwrap();
    model.dispatch(Command::MoveInterior { side: Side::Source, point }, 0.0);
    assert_eq!(model.pins(), None, "a point that is moved determines the map");
}

#[test]
fn pins_out_of_order_are_said_and_the_map_stays() {
    let mut model = model(KernelMode::Adjoint);
    let pins = pin(&mut model);
    let before = images(&model);
    let beyond = pins.pairs()[2].target + 0.01;
    model.dispatch(Command::MovePin { pin: 1, side: Side::Target, fraction: beyond }, 0.0);
    assert!(model.map_error().unwrap().1.english().contains("order"), "{:?}", model.map_error());
    model.refresh(true);
    assert_eq!((model.pins(), moved(&model, &before)), (Some(&pins), 0.0));
    model.dispatch(Command::MovePin { pin: 1, side: Side::Target, fraction: pins.pairs()[1].target + 0.01 }, 0.0);
    rest(&mut model);
    assert_eq!(model.map_error(), None, "in order again");
}

#[test]
fn one_more_pin_has_its_present_image() {
    let mut model = model(KernelMode::Integral);
    pin(&mut model);
    let before = images(&model);
    let four = model.pins_with(Side::Target, 0.111).unwrap();
    assert_eq!(four.pairs().len(), 4);
    model.dispatch(Command::SetPins(Some(four)), 0.0);
    rest(&mut model);
    assert!(moved(&model, &before) < 1e-8, "{:.1e}", moved(&model, &before));
    assert_eq!(model.pins_with_one_more().unwrap().pairs().len(), 5);
}

#[test]
fn a_session_with_pins_opens_with_its_map_and_another_outline_drops_them() {
    let mut first = model(KernelMode::Adjoint);
    let pins = pin(&mut first);
    let after = images(&first);
    let mut second = planar();
    second.dispatch(Command::Open(Box::new(first.session().clone())), 0.0);
    assert_eq!(&second.requested(), first.session());
    rest(&mut second);
    assert_eq!((second.pins(), moved(&second, &after)), (Some(&pins), 0.0));
    let mut third = Model::new(first.session().clone());
    rest(&mut third);
    assert_eq!((third.pins(), moved(&third, &after)), (Some(&pins), 0.0));
    second.dispatch(Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Star) }, 0.0);
    rest(&mut second);
    assert_eq!(second.pins(), None);
}

#[test]
fn pins_hold_a_surface_at_three_corners() {
    let mut model = held_dome();
    for (pin, fraction) in [0.05, 0.3, 0.8].into_iter().enumerate() {
        model.dispatch(Command::MovePin { pin, side: Side::Target, fraction }, 0.0);
        rest(&mut model);
    }
    let misses = model.pin_misses().unwrap();
    assert!(misses.iter().all(|miss| *miss < 1e-6), "{misses:?}");
    assert_eq!(model.map_error(), None);
}

/// A disk over a hemisphere, held by three pins.
fn held_dome() -> Model {
    let mut model = planar();
    let (side, surface) = (Side::Target, spec(SurfacePreset::Hemisphere, 120));
    model.dispatch(Command::SetSurface { side, surface }, 0.0);
    rest(&mut model);
    pin(&mut model);
    model
}

#[test]
fn points_that_follow_from_pins_are_searched_over_frames_while_the_last_map_stays() {
    let (mut model, mut at_once) = (held_dome(), held_dome());
    let drag = |fraction| Command::MovePin { pin: 1, side: Side::Target, fraction };
    let [first, last] = [0.02, 0.05].map(|by| drag(model.pins().unwrap().pairs()[1].target + by));
    let (before, points) = (images(&model), model.session().side(Side::Target).points());
    // without time each frame does one step, however short
    (model.update_ms, at_once.update_ms) = (0.0, f64::INFINITY);
    model.dispatch(first, 0.0);
    for frame in 0..3 {
        model.refresh(true);
        assert_eq!(
            (model.session().side(Side::Target).points(), moved(&model, &before)),
            (points, 0.0),
            "frame {frame}"
        );
        assert!(model.is_pending(), "frame {frame}");
    }
    // moved on meanwhile: the search under way ends, then the one for the last place begins
    model.dispatch(last.clone(), 0.0);
    let frames = (0..10_000)
        .take_while(|_| {
            model.is_pending() && {
                model.refresh(true);
                true
            }
        })
        .count();
    assert!(!model.is_pending() && frames > 3, "{frames} frames");
    at_once.dispatch(last, 0.0);
    rest(&mut at_once);
    let off = moved(&model, &images(&at_once));
    println!("{frames} frames; {off:.1e}");
    assert!(off < 1e-6 && moved(&model, &before) > 1e-3, "{off:.1e}");
    assert!(model.pin_misses().unwrap().iter().all(|miss| *miss < 1e-6), "{:?}", model.pin_misses());
}

/// What comes while points are searched for ends the search, and nothing waits for it.
#[test]
fn an_undo_or_another_surface_ends_a_search_for_points() {
    let before = held_dome().session().clone();
    let another = Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 90) };
    for command in [Command::Open(Box::new(before.clone())), another, Command::SetPins(None)] {
        let mut model = held_dome();
        let fraction = model.pins().unwrap().pairs()[1].target + 0.04;
        model.update_ms = 0.0;
        model.dispatch(Command::MovePin { pin: 1, side: Side::Target, fraction }, 0.0);
        model.refresh(true);
        assert!(model.is_searching_points() && model.full_map().is_none());
        assert_eq!(model.advance_overlays(0.0), None, "overlays wait");
        model.dispatch(command.clone(), 0.0);
        rest(&mut model);
        assert!(!model.is_searching_points() && model.full_map().is_some(), "{command:?}");
        match command {
            Command::Open(_) => assert_eq!(model.session(), &before),
            Command::SetPins(_) => assert_eq!(model.session().side(Side::Target), before.side(Side::Target)),
            _ => assert_eq!(model.map_error(), None),
        }
    }
}

#[test]
fn a_copy_of_the_model_has_the_same_points_to_the_last_bit() {
    let mut model = model(KernelMode::Adjoint);
    pin(&mut model);
    let four = model.pins_with(Side::Target, 0.111).unwrap();
    model.dispatch(Command::SetPins(Some(four)), 0.0);
    rest(&mut model);
    let mut twin = model.twin();
    twin.update_ms = f64::INFINITY;
    twin.refresh(false);
    assert_eq!(twin.session(), model.session());
}

/// Also when the next pins are refused before the map of the ones before is there.
#[test]
fn refused_pins_leave_those_of_the_present_points() {
    let mut model = model(KernelMode::Adjoint);
    pin(&mut model);
    model.dispatch(Command::MovePin { pin: 1, side: Side::Target, fraction: 0.5 }, 0.0);
    model.refresh(true);
    let present = model.session().clone();
    // no vertex of the mesh sees the first two pins apart
    let first = model.pins().unwrap().pairs()[0].source;
    let close = first + 1e-11;
    for _ in 0..3 {
        model.dispatch(Command::MovePin { pin: 1, side: Side::Source, fraction: close }, 0.0);
        model.refresh(true);
        if model.map_error().is_some() {
            assert_eq!(model.session(), &present);
        }
    }
    assert!(model.pins().is_some());
}

#[test]
fn a_reshaped_outline_carries_its_pins_and_a_mirrored_one_lets_them_go() {
    let mut model = model(KernelMode::Adjoint);
    pin(&mut model);
    let before = model.pins().unwrap().clone();
    let mut reshaping = Reshaping::new(Side::Source, &model);
    reshaping.change(Change::Smooth, &mut model).unwrap();
    rest(&mut model);
    let carried = model.pins().unwrap();
    assert_eq!(carried.pairs()[0].target, before.pairs()[0].target);
    assert!(model.pin_misses().unwrap().iter().all(|miss| *miss < 1e-3), "{:?}", model.pin_misses());
    reshaping.change(Change::Mirror, &mut model).unwrap();
    rest(&mut model);
    assert_eq!(model.pins(), None);
}

#[test]
fn a_pin_that_cannot_go_where_it_is_dragged_is_said_until_it_is_let_go() {
    let mut model = model(KernelMode::Adjoint);
    let pins = pin(&mut model);
    let beyond = Command::MovePin { pin: 0, side: Side::Source, fraction: pins.pairs()[1].source + 0.01 };
    model.hold_dot(true);
    model.dispatch(beyond.clone(), 0.0);
    model.hold_dot(true);
    assert!(model.map_error().is_some() && model.pins() == Some(&pins));
    model.hold_dot(false);
    assert_eq!(model.map_error(), None, "the pin is where it was");
    model.dispatch(beyond, 0.0);
    model.hold_dot(false);
    assert!(model.map_error().is_some(), "by a key it is said until the next change");
}

#[test]
fn misses_and_places_are_those_of_the_present_pins() {
    let mut model = model(KernelMode::Adjoint);
    let pins = pin(&mut model);
    let domain = std::sync::Arc::clone(model.domain(Side::Target).unwrap());
    let place = |at: f64| domain.samples().position(domain.samples().at_fraction(at)).extend(0.0);
    let expected: Vec<_> = pins.pairs().iter().map(|pair| place(pair.target)).collect();
    assert_eq!(model.pin_places(Side::Target), expected);
    assert_eq!((model.pin_misses().map(<[f64]>::len), model.missed_pins()), (Some(3), None));
    model.dispatch(Command::SetPins(model.pins_with_one_more()), 0.0);
    assert_eq!(model.pin_misses(), None, "not those of before");
    rest(&mut model);
    assert_eq!((model.pin_misses().unwrap().len(), model.missed_pins().unwrap().len()), (4, 4));
    model.dispatch(Command::SetPins(None), 0.0);
    rest(&mut model);
    assert!(model.pin_misses().is_none() && model.pin_places(Side::Target).is_empty());
}

#[test]
fn drawings_show_the_pins_with_their_numbers_in_place_of_the_points() {
    use crate::export::FileFormat;
    use crate::model::export::{FileRequest, file};
    let mut model = model(KernelMode::Adjoint);
    let drawn = |model: &Model| {
        let request = FileRequest { format: FileFormat::Svg, side: None, unit: false, corners: false };
        String::from_utf8(file(model, request, None).unwrap().unwrap().bytes).unwrap()
    };
    let count = |text: &str, class: &str| text.matches(&format!("class=\"{class}\"")).count();
    let before = drawn(&model);
    assert_eq!(["pin", "interior", "boundary"].map(|class| count(&before, class)), [0, 2, 2]);
    pin(&mut model);
    let after = drawn(&model);
    assert_eq!(["pin", "interior", "boundary"].map(|class| count(&after, class)), [6, 0, 0]);
    assert_eq!(after.matches(">3</text>").count(), 2);
}
