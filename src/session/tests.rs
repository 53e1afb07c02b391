//! What the commands do to a session.

use super::*;

fn preset(preset: Preset) -> OutlineSpec {
    OutlineSpec::Preset(preset)
}

#[test]
fn a_new_outline_resets_the_points_of_its_side_only() {
    let mut session = Session::default();
    for (side, x) in [(Side::Source, 0.1), (Side::Target, 0.2)] {
        session.apply(Command::MoveInterior { side, point: DVec2::new(x, 0.0) });
        session.apply(Command::MoveAnchor { side, fraction: x });
    }
    session.apply(Command::SetOutline { side: Side::Source, outline: preset(Preset::Star) });
    assert_eq!(session.source.outline, preset(Preset::Star));
    assert_eq!((session.interior[0], session.anchor[0]), (None, 0.0));
    assert_eq!((session.interior[1], session.anchor[1]), (Some(DVec2::new(0.2, 0.0)), 0.2));
}

#[test]
fn another_resolution_keeps_the_points() {
    let mut session = Session::default();
    session.apply(Command::MoveAnchor { side: Side::Target, fraction: 0.3 });
    let settings = PrepareSettings { sampling: Sampling::Adaptive { target: Some(99) }, ..Default::default() };
    session.apply(Command::SetSettings { side: Side::Target, settings });
    assert_eq!(session.target.settings, settings);
    assert_eq!(session.anchor[1], 0.3);
}

#[test]
fn anchors_are_taken_modulo_one() {
    let mut session = Session::default();
    session.apply(Command::MoveAnchor { side: Side::Source, fraction: -0.25 });
    assert_eq!(session.anchor[0], 0.75);
}

#[test]
fn swapping_twice_changes_nothing() {
    let mut session = Session::default();
    session.apply(Command::MoveInterior { side: Side::Source, point: DVec2::new(1.0, 2.0) });
    session.apply(Command::MoveAnchor { side: Side::Target, fraction: 0.5 });
    let before = session.clone();
    session.apply(Command::Swap);
    assert_eq!(session.source.outline, before.target.outline);
    assert_eq!(session.interior, [None, Some(DVec2::new(1.0, 2.0))]);
    session.apply(Command::Swap);
    assert_eq!(session, before);
}

#[test]
fn points_that_were_not_set_are_the_poles() {
    let session = Session::default();
    let poles = [DVec2::new(1.0, 0.0), DVec2::new(0.0, 1.0)];
    let constraints = session.constraints(poles);
    assert_eq!((constraints.source_point, constraints.target_point), (poles[0], poles[1]));
}

#[test]
fn a_session_survives_json() {
    let mut session = Session::default();
    session.apply(Command::SetTexture(TextureKind::Polar));
    session.apply(Command::SetDirection(Direction::Forward));
    session.apply(Command::SetExtension(Extension::CauchyGreen));
    session.apply(Command::MoveInterior { side: Side::Target, point: DVec2::new(0.1, -1.0 / 3.0) });
    session.apply(Command::SetColouring(Colouring::Area));
    session.apply(Command::SetWireframe(true));
    session.apply(Command::SetPlots(true));
    session.apply(Command::SetTextureSide(Side::Target));
    session.apply(Command::SetComparison(Comparison::Precomputed));
    let text = serde_json::to_string(&session).unwrap();
    assert_eq!(serde_json::from_str::<Session>(&text).unwrap(), session, "{text}");
}

#[test]
fn a_session_from_before_they_were_there_has_the_defaults() {
    let mut text = serde_json::to_value(Session::default()).unwrap();
    for field in ["colouring", "wireframe", "plots", "texture_side", "comparison"] {
        assert!(text.as_object_mut().unwrap().remove(field).is_some(), "{field}");
    }
    assert_eq!(serde_json::from_value::<Session>(text).unwrap(), Session::default());
}

fn with_surface() -> Session {
    let mut session = Session::default();
    session.apply(Command::SetSurface(SurfaceSpec::default()));
    session.apply(Command::MoveSurfacePoint(BarycentricPoint { triangle: 3, weights: [0.5, 0.25, 0.25] }));
    session.apply(Command::MoveSurfaceAnchor(1.25));
    session
}

#[test]
fn a_surface_keeps_its_points_through_other_settings_but_not_through_another_surface() {
    let mut session = with_surface();
    assert_eq!(session.surface.as_ref().unwrap().anchor, 0.25, "modulo one");
    let repaired = SurfaceSpec { repair: true, ..SurfaceSpec::default() };
    session.apply(Command::SetSurface(repaired));
    assert_eq!(session.surface.as_ref().unwrap().point.unwrap().triangle, 3);
    let shape = SurfaceShape::File { name: "cow.obj".into() };
    session.apply(Command::SetSurface(SurfaceSpec { shape, ..SurfaceSpec::default() }));
    assert_eq!(session.surface.as_ref().map(|surface| (surface.point, surface.anchor)), Some((None, 0.0)));
}

#[test]
fn an_outline_for_the_target_takes_the_place_of_a_surface() {
    let mut session = with_surface();
    session.apply(Command::SetOutline { side: Side::Source, outline: preset(Preset::Star) });
    assert!(session.surface.is_some());
    session.apply(Command::SetOutline { side: Side::Target, outline: preset(Preset::Star) });
    assert_eq!(session.surface, None);
}

#[test]
fn a_session_from_before_there_were_surfaces_still_reads() {
    let mut value = serde_json::to_value(with_surface()).unwrap();
    assert_eq!(serde_json::from_value::<Session>(value.clone()).unwrap(), with_surface());
    value.as_object_mut().unwrap().remove("surface");
    assert_eq!(serde_json::from_value::<Session>(value).unwrap(), Session::default());
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
        let mut text = serde_json::to_value(Session::default()).unwrap();
        text["comparison"] = name.into();
        assert_eq!(serde_json::from_value::<Session>(text).unwrap().comparison, comparison);
        assert_eq!(serde_json::to_value(comparison).unwrap(), name);
        assert_eq!(ways(comparison), shown, "{name}");
    }
}

#[test]
fn a_reshaped_outline_brings_its_points_along() {
    let mut session = Session::default();
    let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(DVec2::from).to_vec();
    let outline = OutlineSpec::Points { name: "triangle".into(), points };
    let interior = Some(DVec2::new(0.25, 0.25));
    session.apply(Command::ReshapeOutline { side: Side::Target, outline: outline.clone(), interior, anchor: 1.25 });
    assert_eq!((session.interior, session.anchor), ([None, interior], [0.0, 0.25]));
    assert_eq!(session.target.outline, outline);
    assert_eq!(session.source, Session::default().source);
}
