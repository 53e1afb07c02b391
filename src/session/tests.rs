//! The effect of every command on a session.

use super::*;
use crate::conformal::InteriorPoint;
use crate::geometry::{DVec3, SimplePolygon};
use crate::mesh::{BarycentricPoint, TriangleId};
use crate::surface::SurfacePreset;
use crate::tiling::{TilingPattern, TilingStyle};

fn preset(preset: Preset) -> OutlineSpec {
    OutlineSpec::Preset(preset)
}

#[test]
fn a_new_outline_resets_the_points_of_its_side_only() {
    let mut session = Session::default();
    for (side, x) in [(Side::Source, 0.1), (Side::Target, 0.2)] {
        session.apply(Command::MoveInterior { side, point: DVec2::new(x, 0.0).into() });
        session.apply(Command::MoveAnchor { side, fraction: x });
    }
    session.apply(Command::SetOutline { side: Side::Source, outline: preset(Preset::Star) });
    assert_eq!(session.domain(Side::Source).outline, preset(Preset::Star));
    let points = |side| (session.side(side).interior, session.side(side).anchor);
    assert_eq!(points(Side::Source), (None, 0.0));
    assert_eq!(points(Side::Target), (Some(DVec2::new(0.2, 0.0)), 0.2));
}

#[test]
fn another_resolution_keeps_the_points() {
    let mut session = Session::default();
    session.apply(Command::MoveAnchor { side: Side::Target, fraction: 0.3 });
    let settings = PrepareSettings { sampling: Sampling::Adaptive { target: Some(99) }, ..Default::default() };
    session.apply(Command::SetSettings { side: Side::Target, settings });
    assert_eq!(session.domain(Side::Target).settings, settings);
    assert_eq!(session.side(Side::Target).anchor, 0.3);
}

#[test]
fn a_loaded_outline_begins_upright_and_a_preset_at_its_first_point() {
    // a house that is given from the lower right corner on, and a square, whose top is flat
    let house = [[2.0, 0.0], [2.0, 2.0], [1.0, 3.0], [0.0, 2.0], [0.0, 0.0]];
    let square = [[2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]];
    let rim = 6.0 + 2.0 * 2_f64.sqrt();
    for (points, expected) in [(&house[..], (2.0 + 2_f64.sqrt()) / rim), (&square[..], 3.0 / 8.0)] {
        let polygon =
            SimplePolygon::try_from(points.iter().map(|p| DVec2::from_array(*p)).collect::<Vec<_>>()).unwrap();
        let outline = OutlineSpec::points("house".into(), polygon);
        for side in Side::BOTH {
            let session = Session::with([Command::SetOutline { side, outline: outline.clone() }]);
            let anchor = session.side(side).anchor;
            assert!((anchor - expected).abs() < 1e-15, "{anchor}, expected {expected}");
        }
    }
    let preset = Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Heart) };
    assert_eq!(Session::with([preset]).side(Side::Source).anchor, 0.0);
}

#[test]
fn anchors_are_taken_modulo_one() {
    let mut session = Session::default();
    session.apply(Command::MoveAnchor { side: Side::Source, fraction: -0.25 });
    assert_eq!(session.side(Side::Source).anchor, 0.75);
}

#[test]
fn swapping_twice_changes_nothing() {
    let mut session = Session::default();
    session.apply(Command::MoveInterior { side: Side::Source, point: DVec2::new(1.0, 2.0).into() });
    session.apply(Command::MoveAnchor { side: Side::Target, fraction: 0.5 });
    session.apply(Command::SetSurface { side: Side::Target, surface: SurfaceSpec::default() });
    let before = session.clone();
    session.apply(Command::Swap);
    for side in Side::BOTH {
        assert_eq!(session.side(side), before.side(side.other()), "outline, surface and points go along");
    }
    session.apply(Command::Swap);
    assert_eq!(session, before);
}

#[test]
fn points_that_were_not_set_are_the_poles() {
    let session = Session::default();
    let poles = [DVec2::new(1.0, 0.0), DVec2::new(0.0, 1.0)];
    let constraints = session.constraints(poles.into());
    assert_eq!(constraints.points.into_array(), poles.map(InteriorPoint::from));
}

fn with_surface(side: Side) -> Session {
    let point = BarycentricPoint::new(TriangleId::new(3), [0.5, 0.25, 0.25]);
    Session::with([
        Command::SetSurface { side, surface: SurfaceSpec::default() },
        Command::MoveInterior { side, point: point.into() },
        Command::MoveAnchor { side, fraction: 1.25 },
    ])
}

#[test]
fn a_surface_keeps_its_points_through_other_settings_but_not_through_another_surface() {
    for side in Side::BOTH {
        let mut session = with_surface(side);
        assert_eq!(session.surface(side).unwrap().anchor, 0.25, "modulo one");
        assert_eq!(session.side(side).anchor, 0.0, "the outline's own stays");
        let surface = SurfaceSpec { repair: true, ..SurfaceSpec::default() };
        session.apply(Command::SetSurface { side, surface });
        assert_eq!(session.surface(side).unwrap().point.unwrap().triangle(), TriangleId::new(3));
        let finer = SurfaceSpec {
            shape: SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 33 },
            ..SurfaceSpec::default()
        };
        session.apply(Command::SetSurface { side, surface: finer });
        let points = session.surface(side).map(SurfaceState::points);
        assert_eq!(points, Some(SidePoints::Surface { interior: None, anchor: 0.25 }), "its triangles are others");
        let surface = SurfaceSpec { shape: SurfaceShape::File { name: "cow.obj".into() }, ..SurfaceSpec::default() };
        session.apply(Command::SetSurface { side, surface });
        let points = session.surface(side).map(SurfaceState::points);
        assert_eq!(points, Some(SidePoints::Surface { interior: None, anchor: 0.0 }));
    }
}

#[test]
fn an_outline_takes_the_place_of_a_surface_on_its_own_side() {
    for side in Side::BOTH {
        let mut session = with_surface(side);
        session.apply(Command::SetOutline { side: side.other(), outline: preset(Preset::Star) });
        assert!(session.surface(side).is_some());
        session.apply(Command::SetOutline { side, outline: preset(Preset::Star) });
        assert_eq!(session.surface(side), None);
    }
}

#[test]
fn a_reshaped_outline_and_its_points_wait_behind_a_surface() {
    for side in Side::BOTH {
        let mut session = with_surface(side);
        let surface = session.surface(side).cloned();
        session.apply(Command::ReshapeOutline {
            side,
            outline: preset(Preset::Star),
            interior: Some(DVec2::ZERO),
            anchor: 0.5,
        });
        session.apply(Command::PlacePoints { side, points: SidePoints::Outline { interior: None, anchor: 0.75 } });
        assert_eq!(session.surface(side), surface.as_ref());
        session.apply(Command::CloseSurface(side));
        assert_eq!(session.side(side).outline_points(), SidePoints::Outline { interior: None, anchor: 0.75 });
        assert_eq!(session.domain(side).outline, preset(Preset::Star));
    }
}

#[test]
fn commands_about_a_missing_surface_touch_nothing() {
    let point = BarycentricPoint::new(TriangleId::new(3), [0.5, 0.25, 0.25]);
    for side in Side::BOTH {
        let (mut session, other) = (with_surface(side.other()), SurfacePreset::Saddle);
        let before = session.clone();
        for command in [
            Command::MoveInterior { side, point: point.into() },
            Command::PlacePoints { side, points: SidePoints::Surface { interior: None, anchor: 0.5 } },
            Command::RefineSurface { side, surface: SurfaceSpec::default() },
            Command::CloseSurface(side),
            Command::RefineSurface {
                side: side.other(),
                surface: SurfaceSpec { shape: SurfaceShape::preset(other), ..SurfaceSpec::default() },
            },
        ] {
            assert_ne!(command.touches(), Touched::NOTHING);
            assert_eq!(session.apply(command.clone()), Touched::NOTHING, "{command:?}");
            assert_eq!(session, before, "{command:?}");
        }
    }
}

/// Every kind of command once, each changing the session it is applied to.
fn commands() -> Vec<Command> {
    let side = Side::Source;
    let point = BarycentricPoint::new(TriangleId::new(3), [0.5, 0.25, 0.25]);
    let fine = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 33 };
    vec![
        Command::SetOutline { side, outline: preset(Preset::Star) },
        Command::ReshapeOutline { side, outline: preset(Preset::Disk), interior: None, anchor: 0.0 },
        Command::SetSettings { side, settings: PrepareSettings::default() },
        Command::MoveInterior { side, point: DVec2::X.into() },
        Command::MoveAnchor { side, fraction: 0.5 },
        Command::PlacePoints { side, points: SidePoints::Outline { interior: None, anchor: 0.25 } },
        Command::SetSurface { side, surface: SurfaceSpec::default() },
        Command::MoveInterior { side, point: point.into() },
        Command::PlacePoints { side, points: SidePoints::Surface { interior: None, anchor: 0.5 } },
        Command::RefineSurface { side, surface: SurfaceSpec { shape: fine, ..SurfaceSpec::default() } },
        Command::SetDirection(Direction::Forward),
        Command::SetExtension(Extension::CauchyGreen),
        Command::SetTexture(TextureKind::Polar),
        Command::SetTextureScale(3.0),
        Command::SetTextureSide(Side::Target),
        Command::PlacePicture(PicturePlacement { size: 0.5, ..PicturePlacement::default() }),
        Command::SetTiling(TilingPattern { style: TilingStyle::Edges, ..TilingPattern::default() }),
        Command::SetColouring(Colouring::Area),
        Command::SetWireframe(true),
        Command::SetPlots(true),
        Command::SetComparison(Comparison::Both),
        Command::SetRegion(vec![Dab { middle: DVec3::new(0.1, 0.2, 0.0), radius: 0.3 }]),
        Command::SetSymmetries(true),
        Command::Swap,
        Command::CloseSurface(Side::Target),
        Command::Open(Box::default()),
    ]
}

/// The parts in which two sessions differ.
fn differences(a: &Session, b: &Session) -> Touched {
    let sides = |differ: fn(&SideState, &SideState) -> bool| Side::BOTH.iter().any(|&k| differ(a.side(k), b.side(k)));
    let of_surfaces = |differ: fn(&SurfaceState, &SurfaceState) -> bool| {
        let both = Side::BOTH.map(|side| (a.surface(side), b.surface(side)));
        both.iter().any(|pair| matches!(pair, (Some(a), Some(b)) if differ(a, b)))
    };
    let parts = [
        (sides(|a, b| a.interior != b.interior) || of_surfaces(|a, b| a.point != b.point), Touched::INTERIOR),
        (sides(|a, b| a.anchor != b.anchor) || of_surfaces(|a, b| a.anchor != b.anchor), Touched::BOUNDARY),
        (sides(|a, b| a.domain.outline != b.domain.outline), Touched::SHAPES),
        (sides(|a, b| a.surface.is_some() != b.surface.is_some()), Touched::SHAPES),
        (of_surfaces(|a, b| !a.spec.is_like(&b.spec)), Touched::SHAPES),
        (of_surfaces(|a, b| a.spec.is_like(&b.spec) && a.spec != b.spec), Touched::SETTINGS),
        (sides(|a, b| a.domain.settings != b.domain.settings), Touched::SETTINGS),
        (a.display.direction != b.display.direction || a.display.extension != b.display.extension, Touched::SETTINGS),
        (a.display.texture != b.display.texture || a.display.picture != b.display.picture, Touched::PATTERN),
        (a.display.tiling != b.display.tiling, Touched::PATTERN),
        (
            a.display.texture_side != b.display.texture_side || a.display.texture_scale != b.display.texture_scale,
            Touched::PATTERN,
        ),
        (a.display.colouring != b.display.colouring || a.display.wireframe != b.display.wireframe, Touched::COLOURS),
        (a.display.plots != b.display.plots, Touched::PLOTS),
        (a.display.comparison != b.display.comparison || a.region != b.region, Touched::COMPARISON),
        (a.display.symmetries != b.display.symmetries, Touched::COMPARISON),
    ];
    parts.into_iter().filter(|(differs, _)| *differs).fold(Touched::NOTHING, |all, (_, part)| all | part)
}

#[test]
fn a_command_changes_nothing_but_what_it_touches_and_says_the_same_before_and_after() {
    let mut session = Session::default();
    for command in commands() {
        let before = session.clone();
        let announced = session.touched_by(&command);
        assert_eq!(session.apply(command.clone()), announced, "{command:?}");
        let follows_its_shape = matches!(command, Command::ReshapeOutline { .. });
        let allowed = if follows_its_shape { announced | Touched::POINTS } else { announced };
        let changed = differences(&before, &session);
        assert!(changed.is_only(allowed), "{command:?} touches {announced:?}, but has changed {changed:?}");
        assert_ne!(session, before, "{command:?} changes nothing");
    }
    assert_eq!(session, Session::default());
}

#[test]
fn comparisons_keep_their_names_and_show_what_they_say() {
    let ways = |comparison: Comparison| DiskWay::ALL.map(|way| comparison.shows(way));
    for (name, comparison, shown) in [
        ("off", Comparison::Off, [false, false]),
        ("fresh", Comparison::Fresh, [true, false]),
        ("precomputed", Comparison::Precomputed, [false, true]),
        ("both", Comparison::Both, [true, true]),
    ] {
        assert_eq!(serde_json::from_value::<Comparison>(name.into()).unwrap(), comparison);
        assert_eq!(serde_json::to_value(comparison).unwrap(), name);
        assert_eq!(ways(comparison), shown, "{name}");
    }
}

#[test]
fn a_reshaped_outline_brings_its_points_along() {
    let mut session = Session::default();
    let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(DVec2::from).to_vec();
    let outline = OutlineSpec::points("triangle".into(), points.try_into().unwrap());
    let interior = Some(DVec2::new(0.25, 0.25));
    session.apply(Command::ReshapeOutline { side: Side::Target, outline: outline.clone(), interior, anchor: 1.25 });
    assert_eq!(session.side(Side::Target).outline_points(), SidePoints::Outline { interior, anchor: 0.25 });
    assert_eq!(session.domain(Side::Target).outline, outline);
    assert_eq!(session.side(Side::Source), Session::default().side(Side::Source));
}

fn pins() -> Pins {
    Pins::new([[0.1, 0.2], [0.4, 0.3], [0.8, 0.9]].map(PerSide::from)).unwrap()
}

#[test]
fn a_chain_goes_on_from_the_target() {
    let square = [0.1, 0.3, 0.6, 0.9];
    let mut session = Session::default().and([
        Command::MoveInterior { side: Side::Target, point: DVec2::new(0.2, 0.0).into() },
        Command::MoveAnchor { side: Side::Target, fraction: 0.2 },
        Command::SetMarks { side: Side::Target, marks: Some(square) },
        Command::SetPins(Some(pins())),
        Command::SetRegion(vec![Dab { middle: DVec3::ZERO, radius: 0.25 }]),
    ]);
    let target = session.side(Side::Target).clone();
    assert!(session.apply(Command::Continue).touches(Touched::ANOTHER_SHAPE | Touched::COMPARISON));
    for side in Side::BOTH {
        assert_eq!((session.side(side), session.marks(side)), (&target, Some(square)), "{side:?}");
    }
    assert_eq!((session.pins(), session.region()), (None, &[][..]), "they were those of the last link");
}

#[test]
fn a_mark_is_moved_in_order_only() {
    let (side, marks) = (Side::Source, [0.1, 0.3, 0.6, 0.9]);
    let mut session = Session::default();
    let moved = |mark, fraction| Command::MoveMark { mark, side, fraction };
    assert_eq!(session.apply(moved(1, 0.4)), Touched::NOTHING, "there are none");
    session.apply(Command::SetMarks { side, marks: Some(marks) });
    assert_eq!(session.apply(moved(1, 0.7)), Touched::NOTHING, "past the third");
    assert_eq!(session.apply(moved(4, 0.7)), Touched::NOTHING, "there is no fifth");
    assert_eq!(session.marks(side), Some(marks));
    assert_eq!(session.apply(moved(3, 1.05)), Touched::COMPARISON);
    assert_eq!(
        session.marks(side).map(|marks| marks.map(|mark| (1e9 * mark).round() / 1e9)),
        Some([0.1, 0.3, 0.6, 0.05])
    );
    session.apply(Command::Swap);
    assert!(session.marks(Side::Source).is_none() && session.marks(Side::Target).is_some());
    // marks that were typed in a wrong order can be put right one after another
    session.apply(Command::SetMarks { side, marks: Some([0.1, 0.6, 0.3, 0.9]) });
    assert_eq!(session.apply(moved(1, 0.2)), Touched::COMPARISON);
}

#[test]
fn pins_are_moved_in_order_only_and_follow_an_exchange_of_the_sides() {
    let mut session = Session::with([Command::SetPins(Some(pins()))]);
    let moved = |pin, fraction| Command::MovePin { pin, side: Side::Target, fraction };
    assert_eq!(session.apply(moved(1, 0.95)), Touched::NOTHING, "past the third pin");
    assert_eq!(session.apply(moved(7, 0.5)), Touched::NOTHING, "there is no such pin");
    assert_eq!(session.pins(), Some(&pins()));
    assert_eq!(session.apply(moved(1, 0.5)), Touched::POINTS);
    session.apply(Command::Swap);
    let pairs: Vec<[f64; 2]> = session.pins().unwrap().pairs().iter().map(|pair| pair.into_array()).collect();
    assert_eq!(pairs, [[0.2, 0.1], [0.5, 0.4], [0.9, 0.8]]);
}

#[test]
fn pins_go_with_the_shapes_on_which_they_are() {
    let pinned = Session::with([Command::SetPins(Some(pins()))]);
    let surface = |preset| SurfaceSpec { shape: SurfaceShape::preset(preset), ..SurfaceSpec::default() };
    let side = Side::Target;
    let hemisphere = Command::SetSurface { side, surface: surface(SurfacePreset::Hemisphere) };
    for command in [Command::SetOutline { side, outline: preset(Preset::Star) }, hemisphere.clone()] {
        assert_eq!(pinned.clone().and([command]).pins(), None);
    }
    let on_surface = pinned.and([hemisphere.clone(), Command::SetPins(Some(pins()))]);
    assert_eq!(on_surface.clone().and([hemisphere]).pins(), Some(&pins()), "the same surface");
    let head = Command::SetSurface { side, surface: surface(SurfacePreset::AnimalHead) };
    assert_eq!(on_surface.clone().and([head]).pins(), None);
    assert_eq!(on_surface.and([Command::CloseSurface(side)]).pins(), None);
}

/// Points that follow from pins are found again when a side is sharpened: that is no step of the user's.
#[test]
fn points_that_follow_from_pins_are_no_step_of_their_own() {
    let pinned = Session::with([Command::SetPins(Some(pins()))]);
    let mut history = History::new(pinned.clone());
    let found = Command::MoveInterior { side: Side::Source, point: DVec2::new(0.1, 0.2).into() };
    let again = pinned.and([found.clone()]);
    assert!(!history.settle(&again) && !history.can_undo());
    assert_eq!(history.now(), &again);
    assert!(history.settle(&again.clone().and([Command::SetPins(None)])), "without pins the points count");
    assert!(history.settle(&again.and([Command::SetPins(None), found, Command::SetWireframe(true)])));
}

#[test]
fn the_own_picture_goes_into_the_tiles_that_are_shown() {
    let plain = Session::default();
    assert!(!plain.shows_picture() && plain.clone().and([plain.to_show_picture()]).texture() == TextureKind::Image);
    let tiled = Session::with([Command::SetTexture(TextureKind::Tiling)]);
    let pictured = tiled.clone().and([tiled.to_show_picture()]);
    assert!(!tiled.shows_picture() && pictured.shows_picture());
    assert_eq!((pictured.texture(), pictured.tiling().style), (TextureKind::Tiling, TilingStyle::Picture));
    assert!(!pictured.and([Command::SetTexture(TextureKind::Checker)]).shows_picture(), "the style is kept, unseen");
}
