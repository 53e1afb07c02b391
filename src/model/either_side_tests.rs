//! The model with a surface on the source's side, or on both sides.

use crate::conformal::{Direction, Side};
use crate::export::FileFormat;
use crate::mesh::BarycentricPoint;
use crate::model::export::{FileRequest, file};
use crate::model::surface_tests::{planar, settle, spec};
use crate::model::*;
use crate::render::{Pattern, TextureStyle};
use crate::session::{Command, SurfaceShape, SurfaceSpec, SurfaceState, TextureKind, link};
use crate::surface::{SurfacePreset, read_surface};

fn with(surfaces: impl IntoIterator<Item = (Side, SurfacePreset)>) -> Model {
    let mut model = planar();
    for (side, preset) in surfaces {
        model.dispatch(Command::SetSurface { side, surface: spec(preset, 60) }, 0.0);
    }
    settle(&mut model);
    assert!(model.is_ready(), "{:?}", model.map_error());
    model
}

fn on_the_source() -> Model {
    with([(Side::Source, SurfacePreset::Hemisphere)])
}

fn on_both_sides() -> Model {
    with([(Side::Source, SurfacePreset::Hemisphere), (Side::Target, SurfacePreset::Paraboloid)])
}

/// An inner point of the triangle.
fn inner(model: &Model, side: Side, triangle: u32) -> BarycentricPoint {
    let point = BarycentricPoint::new(crate::mesh::TriangleId::new(triangle), [0.25, 0.25, 0.5]);
    model.surface(side).unwrap().0.interior_near(point).unwrap()
}

#[test]
fn a_surface_on_the_source_is_mapped_to_the_targets_outline_which_shows_the_pattern() {
    let model = on_the_source();
    let map = model.map().unwrap();
    assert_eq!((map.mapped_side(), model.session().direction()), (Side::Source, Direction::Backward));
    assert_eq!(model.pattern_home(), Some(Side::Target));
    assert_eq!(pattern::surface_coordinates(&model, Side::Source), Some(map.images()));
    let shown = pattern::geometry(&model, Side::Target).unwrap();
    assert_eq!(shown.positions, shown.texture_coordinates, "the plane shows its own pattern");
    assert!(pattern::geometry(&model, Side::Source).is_none() && pattern::moved(&model, Side::Source).is_none());
    let shown = model.shown().unwrap();
    assert_eq!((shown.places(Side::Source), shown.places(Side::Target)), (None, Some(map.images())));
    let quality = model.quality().unwrap();
    assert!(quality.q_mean < 1.1 && quality.flipped == 0, "{quality:?}");
}

#[test]
fn the_points_of_a_surface_on_the_source_move_the_map_and_opening_restores_them() {
    let mut model = on_the_source();
    let (before, session) = (model.shown().unwrap().images.to_vec(), model.session().clone());
    let point = inner(&model, Side::Source, 7);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
    assert!(model.refresh(true).map);
    model.dispatch(Command::MoveAnchor { side: Side::Source, fraction: 0.4 }, 0.0);
    assert!(model.refresh(true).map);
    assert_ne!(model.shown().unwrap().images, before);
    model.dispatch(Command::Open(Box::new(session)), 0.0);
    settle(&mut model);
    assert_eq!(model.shown().unwrap().images, before);
}

#[test]
fn between_two_surfaces_every_pattern_lies_in_the_disk() {
    let mut model = on_both_sides();
    for texture in
        [TextureKind::Checker, TextureKind::Grid, TextureKind::Polar, TextureKind::Conformal, TextureKind::Tiling]
    {
        model.dispatch(Command::SetTexture(texture), 0.0);
        model.refresh(false);
        let map = model.map().unwrap();
        assert!(map.is_through_disk() && model.is_ready() && model.pattern_home().is_none());
        let style = pattern::style(&model, false, true).unwrap();
        assert_eq!((style.bounds, style.pole), (TextureStyle::DISK, DVec2::ZERO));
        assert_eq!(style.pattern == Pattern::Conformal, texture == TextureKind::Conformal);
        assert_eq!(matches!(style.pattern, Pattern::Tiling { .. }), texture == TextureKind::Tiling);
        for side in Side::BOTH {
            assert_eq!(pattern::surface_coordinates(&model, side), map.disk(side), "{texture:?}");
            assert!(pattern::geometry(&model, side).is_none() && pattern::moved(&model, side).is_none());
            assert!(model.shown().unwrap().places(side).is_none());
        }
    }
}

#[test]
fn the_direction_says_which_of_two_surfaces_is_mapped_and_all_points_move_the_map() {
    let mut model = on_both_sides();
    let count = |model: &Model, side: Side| model.surface(side).unwrap().0.prepared().unwrap().vertex_count();
    for direction in [Direction::Forward, Direction::Backward] {
        model.dispatch(Command::SetDirection(direction), 0.0);
        assert!(model.refresh(false).meshes);
        let map = model.map().unwrap();
        assert_eq!(map.mapped_side(), direction.mapped_side());
        assert_eq!(model.shown().unwrap().images.len(), count(&model, direction.mapped_side()));
        assert_eq!(model.triangles().len(), map.mapped().triangles().len());
        let quality = model.quality().unwrap();
        assert!(quality.q_mean < 1.1 && quality.flipped == 0, "{direction:?}: {quality:?}");
    }
    for side in Side::BOTH {
        let before = model.map().unwrap().surface_images().unwrap().clone();
        let point = inner(&model, side, 9);
        model.dispatch(Command::MoveInterior { side, point: point.into() }, 0.0);
        let changes = model.refresh(true);
        assert!(changes.map && !changes.meshes);
        let moved = model.map().unwrap().surface_images().unwrap().clone();
        assert_ne!(moved, before);
        model.dispatch(Command::MoveAnchor { side, fraction: 0.3 }, 0.0);
        assert!(model.refresh(true).map);
        assert_ne!(*model.map().unwrap().surface_images().unwrap(), moved);
    }
}

#[test]
fn a_drag_updates_the_disk_coordinates_of_its_own_side_only() {
    let mut model = on_both_sides();
    for side in Side::BOTH {
        let read = |model: &Model| {
            let map = model.map().unwrap();
            Side::BOTH.map(|side| (map.disk_revision(side), map.disk(side).unwrap().to_vec()))
        };
        let before = read(&model);
        let point = inner(&model, side, 9);
        model.dispatch(Command::MoveInterior { side, point: point.into() }, 0.0);
        assert!(model.refresh(true).map);
        let after = read(&model);
        for (k, of) in Side::BOTH.into_iter().enumerate() {
            let is_renewed = after[k].0 != before[k].0;
            assert_eq!((is_renewed, after[k].1 != before[k].1), (of == side, of == side), "{of} of a drag on {side}");
        }
    }
}

#[test]
fn a_link_restores_surfaces_on_either_side_with_their_points() {
    for make in [on_the_source, on_both_sides] {
        let mut model = make();
        let point = inner(&model, Side::Source, 5);
        model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
        model.dispatch(Command::MoveAnchor { side: Side::Source, fraction: 0.25 }, 0.0);
        model.refresh(false);
        let fragment = link::encode(model.session()).unwrap().fragment;
        let session = link::decode(&fragment).unwrap().session;
        assert_eq!(&session, model.session());
        let mut opened = Model::new(session);
        settle(&mut opened);
        assert_eq!(opened.session(), model.session());
        assert_eq!(opened.map().unwrap().images(), model.map().unwrap().images());
    }
}

#[test]
fn swapping_exchanges_the_surfaces() {
    let mut model = on_the_source();
    model.dispatch(Command::MoveAnchor { side: Side::Source, fraction: 0.3 }, 0.0);
    model.refresh(false);
    let images = model.map().unwrap().images().to_vec();
    model.dispatch(Command::Swap, 0.0);
    assert!(model.take_requests(f64::INFINITY).is_empty(), "nothing is prepared again");
    assert!(model.refresh(false).meshes && model.is_ready());
    assert!(model.surface(Side::Source).is_none() && model.surface(Side::Target).unwrap().1.anchor == 0.3);
    assert_eq!(model.map().unwrap().mapped_side(), Side::Target);
    assert_eq!(model.map().unwrap().images(), images);
    // later preparations belong to the new side
    model.dispatch(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 80) }, 0.0);
    settle(&mut model);
    assert_eq!(model.surface(Side::Target).unwrap().1.spec.shape, spec(SurfacePreset::Hemisphere, 80).shape);
    assert!(model.is_ready());
}

#[test]
fn a_surface_file_belongs_to_the_side_it_is_dropped_on_unless_the_other_side_waits_for_it() {
    let mut model = planar();
    assert_eq!(Side::BOTH.map(|side| model.side_for_surface(side, "a.obj")), Side::BOTH);
    let shape = SurfaceShape::File { name: "a.obj".into() };
    let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
    let waiting = model.session().clone().and([Command::SetSurface { side: Side::Source, surface }]);
    model.dispatch(Command::Open(Box::new(waiting)), 0.0);
    assert!(model.surface_side(Side::Source).preparation.error.is_some(), "the file is asked for");
    assert_eq!(Side::BOTH.map(|side| model.side_for_surface(side, "a.obj")), [Side::Source; 2]);
    assert_eq!(Side::BOTH.map(|side| model.side_for_surface(side, "b.obj")), Side::BOTH);
}

/// Opens the file "a.obj" of a pyramid over the square on a side.
fn open_pyramid(model: &mut Model, side: Side, height: f64) {
    model.want_surface_file(side, "a.obj", pyramid(height));
    settle(model);
}

fn pyramid(height: f64) -> Vec<u8> {
    let [middle, corners] = [format!("v 0.5 0.5 {height}\n"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n".into()];
    format!("{middle}{corners}f 2 3 1\nf 3 4 1\nf 4 5 1\nf 5 2 1\n").into_bytes()
}

/// A session with surfaces on both sides from the file "a.obj", which is not loaded, and the source's anchor moved.
fn waiting_on_both_sides() -> (Model, Session) {
    let mut model = planar();
    let shape = SurfaceShape::File { name: "a.obj".into() };
    let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
    let set = Side::BOTH.map(|side| Command::SetSurface { side, surface: surface.clone() });
    let turn = Command::MoveAnchor { side: Side::Source, fraction: 0.3 };
    let session = model.session().clone().and(set).and([turn]);
    model.dispatch(Command::Open(Box::new(session.clone())), 0.0);
    settle(&mut model);
    assert!(model.is_planar() && Side::BOTH.iter().all(|&side| model.user_errors(side).count() == 1));
    (model, session)
}

fn surfaces(session: &Session) -> [Option<&SurfaceState>; 2] {
    Side::BOTH.map(|side| session.surface(side))
}

#[test]
fn undoing_a_swap_restores_a_surface_from_a_file() {
    let mut model = planar();
    open_pyramid(&mut model, Side::Target, 0.5);
    let (session, images) = (model.session().clone(), model.map().unwrap().images().to_vec());
    model.dispatch(Command::Swap, 0.0);
    settle(&mut model);
    let _ = Side::BOTH.map(|side| model.take_refit(side));
    model.dispatch(Command::Open(Box::new(session.clone())), 0.0);
    settle(&mut model);
    assert_eq!(Side::BOTH.map(|side| model.user_errors(side).count()), [0, 0]);
    assert_eq!(surfaces(model.session()), surfaces(&session));
    assert_eq!(model.map().unwrap().images(), images);
    assert!(model.take_refit(Side::Target), "its viewport has no camera yet");
}

#[test]
fn undoing_a_swap_of_two_files_of_one_name_restores_each_on_its_side() {
    let mut model = planar();
    open_pyramid(&mut model, Side::Target, 0.5);
    open_pyramid(&mut model, Side::Source, 0.25);
    let names = surfaces(model.session()).map(|state| state.unwrap().spec.shape.clone());
    assert_eq!(names, ["a (2).obj", "a.obj"].map(|name| SurfaceShape::File { name: name.into() }));
    let (session, images) = (model.session().clone(), model.map().unwrap().images().to_vec());
    let heights = |model: &Model| Side::BOTH.map(|side| model.surface_point(side).unwrap().z);
    assert_eq!(heights(&model), [0.25, 0.5], "the middle is the only interior vertex");
    model.dispatch(Command::Swap, 0.0);
    settle(&mut model);
    assert_eq!(heights(&model), [0.5, 0.25]);
    model.dispatch(Command::Open(Box::new(session)), 0.0);
    assert!(!model.take_requests(f64::INFINITY).iter().any(|(_, request)| request.is_of_surface()));
    settle(&mut model);
    assert_eq!(heights(&model), [0.25, 0.5]);
    assert_eq!(model.map().unwrap().images(), images);
}

#[test]
fn one_file_serves_both_sides_that_wait_for_it() {
    for dropped_on in Side::BOTH {
        let (mut model, session) = waiting_on_both_sides();
        assert_eq!(model.side_for_surface(dropped_on, "a.obj"), dropped_on);
        open_pyramid(&mut model, dropped_on, 0.5);
        assert_eq!(surfaces(model.session()), surfaces(&session));
        assert_eq!(Side::BOTH.map(|side| model.user_errors(side).count()), [0, 0]);
        assert!(model.is_ready());
    }
}

#[test]
fn a_session_does_not_wait_for_a_file_that_is_being_prepared() {
    let (mut model, session) = waiting_on_both_sides();
    model.dispatch(Command::CloseSurface(Side::Target), 0.0);
    assert_eq!(model.side_for_surface(Side::Target, "a.obj"), Side::Source);
    model.want_surface_file(Side::Source, "a.obj", pyramid(0.5));
    assert_eq!(model.side_for_surface(Side::Target, "a.obj"), Side::Target);
    // another file of that name is a different surface
    model.want_surface_file(Side::Target, "a.obj", pyramid(0.25));
    settle(&mut model);
    assert_eq!(model.session().surface(Side::Source), session.surface(Side::Source));
    let shape = SurfaceShape::File { name: "a (2).obj".into() };
    let other = SurfaceState::new(SurfaceSpec { shape, ..SurfaceSpec::default() });
    assert_eq!(model.session().surface(Side::Target), Some(&other));
}

#[test]
fn a_surface_that_is_still_prepared_gets_a_camera_when_it_is_shown_again() {
    let mut model = on_the_source();
    let session = model.session().clone();
    model.dispatch(Command::CloseSurface(Side::Source), 0.0);
    settle(&mut model);
    assert!(model.take_refit(Side::Source) && !model.take_refit(Side::Source));
    model.dispatch(Command::Open(Box::new(session)), 0.0);
    settle(&mut model);
    assert!(model.surface(Side::Source).is_some() && model.take_refit(Side::Source));
}

#[test]
fn one_search_tree_is_built_at_a_time() {
    let model = on_both_sides();
    let trees = || {
        let made = |side| model.surface(side).unwrap().0.surface().unwrap().tree_if_made().is_some();
        Side::BOTH.into_iter().filter(|&side| made(side)).count()
    };
    let mut built = vec![trees()];
    while model.sort_surface_at_rest() {
        built.push(trees());
    }
    assert_eq!(built, [0, 1, 2]);
}

#[test]
fn exported_images_between_two_surfaces_lie_on_the_other_surface() {
    let model = on_both_sides();
    let text = |format| {
        let written = file(&model, FileRequest { format, side: None, unit: true, corners: true }, None).unwrap();
        written.map(|file| String::from_utf8(file.bytes).unwrap())
    };
    let places = model.map().unwrap().surface_images().unwrap().places();
    let row = format!("vt {} {} {}\n", places[0].x, places[0].y, places[0].z);
    assert!(text(FileFormat::Obj).unwrap().contains(&row), "{row}");
    assert!(text(FileFormat::Csv).unwrap().contains("z2 (target units)"));
    assert_eq!(text(FileFormat::Svg).unwrap().matches("class=\"domain\"").count(), 2);
    let row = format!(" {} {} {}\n", places[0].x, places[0].y, places[0].z);
    assert!(text(FileFormat::Ply).unwrap().contains(&row), "{row}");
    let request = FileRequest { format: FileFormat::Glb, side: None, unit: true, corners: true };
    let written = file(&model, request, None).unwrap().unwrap();
    let (own, images) = (model.map().unwrap().mapped().vertex_count(), read_surface("a.glb", &written.bytes).unwrap());
    assert_eq!(images.vertices().len(), own);
}

#[test]
fn while_a_surface_is_refined_the_last_good_picture_of_both_sides_stays() {
    for (make, side) in [(on_both_sides as fn() -> Model, Side::Source), (on_both_sides, Side::Target)]
        .into_iter()
        .chain([(on_the_source as fn() -> Model, Side::Source)])
    {
        let mut model = make();
        let picture = |model: &Model| {
            Side::BOTH.map(|at| {
                let coordinates = pattern::surface_coordinates(model, at)?;
                assert_eq!(coordinates.len(), model.shown_surface(at).unwrap().mesh().vertices().len(), "{at}");
                Some(coordinates.to_vec())
            })
        };
        let (before, home) = (picture(&model), model.pattern_home());
        let mut surface = model.session().surface(side).unwrap().spec.clone();
        let SurfaceShape::Preset { boundary, .. } = &mut surface.shape else { unreachable!("a preset") };
        *boundary = 70;
        model.dispatch(Command::RefineSurface { side, surface: surface.clone() }, 0.0);
        model.update_ms = 0.0;
        for (side, request) in model.take_requests(f64::INFINITY) {
            crate::worker::run(&request, &mut |generation, response| model.accept(side, generation, response));
        }
        assert_eq!(model.session().surface(side).unwrap().spec, surface);
        model.dispatch(Command::SetTexture(TextureKind::Conformal), 0.0);
        let mut frames = 0;
        while !model.is_ready() {
            assert!(model.has_picture() && picture(&model) == before, "frame {frames} of {side}");
            assert_eq!(model.pattern_home(), home, "frame {frames} of {side}");
            model.refresh(false);
            frames += 1;
            assert!(frames < 10_000);
        }
        assert!(frames > 1, "{frames} frames");
        let count = |model: &Model| model.surface(side).unwrap().0.prepared().unwrap().vertex_count();
        assert_eq!(model.shown_surface(side).unwrap().mesh().vertices().len(), count(&model));
        model.update_ms = f64::INFINITY;
        model.refresh(false);
        assert_eq!(model.pattern_home(), None);
        assert_ne!(picture(&model)[usize::from(side == Side::Target)], before[usize::from(side == Side::Target)]);
    }
}
