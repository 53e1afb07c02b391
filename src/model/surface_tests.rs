//! The model with a surface on the target's side.

use crate::conformal::{PrepareSettings, Side};
use crate::export::FileFormat;
use crate::mesh::{BarycentricPoint, Sizing, TriangleId};
use crate::model::export::{FileRequest, file};
use crate::model::side::user_error::UserError;
use crate::model::*;
use crate::outline::{Preset, Sampling};
use crate::session::{Command, OutlineSpec, SurfaceShape, SurfaceSpec, TextureKind};
use crate::surface::SurfacePreset;
use crate::worker::Request;

pub(super) fn spec(preset: SurfacePreset, boundary: u32) -> SurfaceSpec {
    SurfaceSpec { shape: SurfaceShape::Preset { preset, boundary }, ..SurfaceSpec::default() }
}

pub(super) fn planar() -> Model {
    let mut session = Session::default();
    let sampling = Sampling::Uniform { count: 100, keep_corners: false };
    let settings = PrepareSettings { sampling, sizing: Sizing::Graded(0.3), ..PrepareSettings::default() };
    for side in Side::BOTH {
        session.apply(Command::SetSettings { side, settings });
    }
    session.apply(Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Disk) });
    let mut model = Model::new(session);
    settle(&mut model);
    model
}

/// Answers all requests and updates the map.
pub(super) fn settle(model: &mut Model) -> Changes {
    // a side's outline waits for its worker until the surface is prepared
    while let requests @ [_, ..] = model.take_requests(f64::INFINITY).as_slice() {
        for (side, request) in requests {
            crate::worker::run(request, &mut |generation, response| model.accept(*side, generation, response));
        }
    }
    model.refresh(false)
}

/// The shown map, if it is a map of the surface on the target's side.
fn mapped_surface(model: &Model) -> Option<&ConformalMap> {
    let surface = model.surface(Side::Target)?.0.prepared()?;
    model.map().filter(|map| Arc::ptr_eq(map.side(Side::Target), surface))
}

/// The only pending request, which is about the target.
fn only_request(model: &mut Model) -> Request {
    let mut requests = model.take_requests(0.0);
    assert!(requests.len() == 1 && requests[0].0 == Side::Target, "{requests:?}");
    requests.remove(0).1
}

fn with_hemisphere() -> Model {
    let mut model = planar();
    model.dispatch(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 60) }, 0.0);
    settle(&mut model);
    model
}

#[test]
fn a_surface_replaces_the_targets_outline_when_it_is_prepared() {
    let mut model = planar();
    model.dispatch(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 60) }, 0.0);
    assert!(model.is_planar() && model.map().is_some(), "the last good map stays");
    let changes = settle(&mut model);
    assert!(changes.meshes && changes.map && changes.images);
    assert!(model.is_ready() && model.take_refit(Side::Target));
    let map = mapped_surface(&model).unwrap();
    assert_eq!(model.shown().unwrap().images.len(), map.mapped().vertex_count());
    assert_eq!(model.triangles().len(), map.mapped().triangles().len());
    // over the disk, by the stereographic projection: conformal up to the coarse mesh
    assert!(model.quality().unwrap().q_mean < 1.1 && model.quality().unwrap().flipped == 0);
}

#[test]
fn a_surfaces_points_move_the_map_and_a_bad_point_restores_the_last_good_ones() {
    let mut model = with_hemisphere();
    let before = model.shown().unwrap().images.to_vec();
    let good = BarycentricPoint::new(TriangleId::new(7), [0.25, 0.25, 0.5]);
    let good = model.surface(Side::Target).unwrap().0.interior_near(good).unwrap();
    model.dispatch(Command::MoveInterior { side: Side::Target, point: good.into() }, 0.0);
    let changes = model.refresh(true);
    assert!(changes.map && !changes.meshes);
    assert_ne!(model.shown().unwrap().images, before);
    let outside = BarycentricPoint::new(TriangleId::new(u32::MAX), [1.0, 0.0, 0.0]);
    model.dispatch(Command::MoveInterior { side: Side::Target, point: outside.into() }, 0.0);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: DVec2::splat(99.0).into() }, 0.0);
    model.refresh(true);
    assert_eq!(model.map_error().unwrap().0, Side::Source);
    assert_eq!(model.session().surface(Side::Target).unwrap().point, Some(good));
    model.dispatch(Command::MoveAnchor { side: Side::Target, fraction: 0.4 }, 0.0);
    assert!(model.refresh(true).map && model.map_error().is_none());
}

#[test]
fn handles_stay_off_the_loop() {
    let model = with_hemisphere();
    let (side, _) = model.surface(Side::Target).unwrap();
    let mesh = side.surface().unwrap().mesh();
    for (t, corners) in mesh.triangles().iter().enumerate() {
        for weights in [[1.0, 0.0, 0.0], [0.0, 0.5, 0.5], [0.2, 0.3, 0.5]] {
            let found = side.interior_near(BarycentricPoint::new(TriangleId::new(t as u32), weights)).unwrap();
            let on_loop: f64 = (0..3).filter(|&i| corners[i] < mesh.boundary_count()).map(|i| found.weights()[i]).sum();
            let inner = corners.iter().any(|&v| v >= mesh.boundary_count());
            assert!(!inner || on_loop < 0.9 + 1e-12, "triangle {t}: {found:?}");
            assert!((found.weights().iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn closing_a_surface_restores_the_planar_map() {
    let mut model = planar();
    let before = model.map().unwrap().images().to_vec();
    model.dispatch(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Saddle, 40) }, 0.0);
    settle(&mut model);
    assert!(mapped_surface(&model).is_some());
    model.dispatch(Command::CloseSurface(Side::Target), 0.0);
    assert!(model.refresh(false).meshes);
    assert_eq!(model.map().unwrap().images(), before);
    // choosing an outline also replaces the surface
    model.dispatch(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Saddle, 40) }, 0.0);
    settle(&mut model);
    model.dispatch(Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Heart) }, 0.0);
    settle(&mut model);
    assert!(model.is_planar() && model.map().is_some());
}

#[test]
fn a_bad_file_leaves_the_current_surface() {
    let mut model = with_hemisphere();
    model.want_surface_file(Side::Target, "bad.obj", b"v 0 0 nan".to_vec());
    settle(&mut model);
    assert!(model.surface_side(Side::Target).preparation.error.as_ref().unwrap().text.english().contains("bad.obj"));
    let preset = SurfaceShape::Preset { preset: SurfacePreset::Hemisphere, boundary: 60 };
    assert_eq!(model.surface(Side::Target).unwrap().1.spec.shape, preset);
    assert!(mapped_surface(&model).is_some() && model.is_ready());
}

#[test]
fn another_file_of_the_same_name_is_another_surface() {
    let mut model = planar();
    let square = |height: f64| {
        let [middle, corner] = [format!("v 0.5 0.5 {height}\n"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n".into()];
        format!("{middle}{corner}f 2 3 1\nf 3 4 1\nf 4 5 1\nf 5 2 1\n").into_bytes()
    };
    model.want_surface_file(Side::Target, "a.obj", square(0.0));
    settle(&mut model);
    model.dispatch(Command::MoveAnchor { side: Side::Target, fraction: 0.3 }, 0.0);
    model.refresh(false);
    model.want_surface_file(Side::Target, "a.obj", square(0.5));
    settle(&mut model);
    assert_eq!(model.session().surface(Side::Target).unwrap().anchor, 0.0);
    assert_eq!(model.surface_point(Side::Target).unwrap().z, 0.5, "the middle is its only interior vertex");
}

#[test]
fn opening_a_session_restores_its_surface_and_points() {
    let mut model = planar();
    let mut session = with_hemisphere().session().clone();
    let point = BarycentricPoint::new(TriangleId::new(5), [0.2, 0.3, 0.5]);
    session.apply(Command::MoveInterior { side: Side::Target, point: point.into() });
    model.dispatch(Command::Open(Box::new(session.clone())), 0.0);
    settle(&mut model);
    assert_eq!(model.session().surface(Side::Target), session.surface(Side::Target));
    model.dispatch(Command::Open(Box::new(session.and([Command::CloseSurface(Side::Target)]))), 0.0);
    settle(&mut model);
    assert!(model.is_planar() && model.map().is_some());
}

#[test]
fn the_pattern_of_the_disk_has_coordinates_on_the_surface() {
    let mut model = with_hemisphere();
    model.dispatch(Command::SetTexture(TextureKind::Conformal), 0.0);
    assert!(model.refresh(false).meshes);
    let (side, state) = model.surface(Side::Target).unwrap();
    let coordinates = model.shown_grid().of(Side::Target);
    let mesh = side.surface().unwrap().mesh();
    assert_eq!(coordinates.len(), mesh.vertices().len());
    let m = mesh.boundary_count() as usize;
    assert!(coordinates[..m].iter().all(|g| (g.length() - 1.0).abs() < 1e-12), "the loop lies on the circle");
    let x = side.point(state).unwrap();
    let corners = mesh.triangles()[x.triangle().index()];
    let at: DVec2 = corners.iter().zip(x.weights()).map(|(&v, w)| w * coordinates[v as usize]).sum();
    assert!(at.length() < 0.02, "g(x) = {at}");
    assert_eq!(
        model.overlay_state().grid.of(Side::Source).len(),
        model.domain(Side::Source).unwrap().mesh().vertices().len()
    );
}

#[test]
fn a_new_model_prepares_the_surface_of_its_session() {
    let session = with_hemisphere().session().clone();
    let mut model = Model::new(session.clone());
    assert!(model.is_planar());
    settle(&mut model);
    assert!(model.is_ready() && mapped_surface(&model).is_some());
    assert_eq!(model.session(), &session);
}

#[test]
fn opening_a_session_replaces_the_surface_and_the_hidden_outline() {
    let mut model = with_hemisphere();
    let with_surface = model.session().clone();
    model.dispatch(Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Star) }, 0.0);
    settle(&mut model);
    assert!(model.is_planar());
    model.dispatch(Command::Open(Box::new(with_surface.clone())), 0.0);
    settle(&mut model);
    assert_eq!(model.session(), &with_surface, "outline and surface are both back");
    assert!(mapped_surface(&model).is_some() && model.is_ready());
}

#[test]
fn a_side_has_one_request_at_a_time_and_the_surface_precedes_the_hidden_outline() {
    let mut model = planar();
    let outline = |preset| Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(preset) };
    model.dispatch(outline(Preset::Star), 0.0);
    let of_outline = only_request(&mut model);
    let surface = spec(SurfacePreset::Hemisphere, 30);
    let wanted =
        model.session().clone().and([outline(Preset::Square), Command::SetSurface { side: Side::Target, surface }]);
    model.dispatch(Command::Open(Box::new(wanted.clone())), 0.0);
    model.refresh(false);
    let of_surface = only_request(&mut model);
    assert!(!of_outline.is_of_surface() && of_surface.is_of_surface() && of_surface.generation > of_outline.generation);
    assert!(model.take_requests(f64::INFINITY).is_empty() && model.next_due().is_none(), "the outline waits");
    let answer = |model: &mut Model, request: &Request| {
        crate::worker::run(request, &mut |generation, response| model.accept(Side::Target, generation, response));
        model.refresh(false)
    };
    assert_eq!(answer(&mut model, &of_outline), Changes::default(), "it is not wanted any more");
    assert!(answer(&mut model, &of_surface).map && mapped_surface(&model).is_some() && !model.is_ready());
    let behind = only_request(&mut model);
    assert!(!behind.is_of_surface());
    assert_eq!(answer(&mut model, &behind), Changes::default(), "it is hidden");
    assert!(model.is_ready() && model.session() == &wanted);
    model.dispatch(Command::CloseSurface(Side::Target), 0.0);
    assert!(model.refresh(false).map && model.is_ready() && model.is_planar());
}

#[test]
fn choosing_the_current_outline_cancels_a_surface() {
    let mut model = planar();
    let outline = model.session().domain(Side::Target).outline.clone();
    model.dispatch(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Saddle, 40) }, 0.0);
    model.dispatch(Command::SetOutline { side: Side::Target, outline }, 0.0);
    settle(&mut model);
    assert!(model.is_planar() && model.is_ready());
}

#[test]
fn a_finer_surface_keeps_its_points_where_they_are() {
    let mut model = with_hemisphere();
    let point = BarycentricPoint::new(TriangleId::new(40), [0.2, 0.3, 0.5]);
    let point = model.surface(Side::Target).unwrap().0.interior_near(point).unwrap();
    model.dispatch(Command::MoveInterior { side: Side::Target, point: point.into() }, 0.0);
    model.dispatch(Command::MoveAnchor { side: Side::Target, fraction: 0.3 }, 0.0);
    model.refresh(false);
    let before = model.surface_point(Side::Target).unwrap();
    model.dispatch(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 90) }, 0.0);
    settle(&mut model);
    assert!(
        model.surface_point(Side::Target).unwrap().distance(before) < 0.05,
        "{} for {before}",
        model.surface_point(Side::Target).unwrap()
    );
    assert_eq!(model.session().surface(Side::Target).unwrap().anchor, 0.3);
}

#[test]
fn a_point_refused_by_the_first_map_is_replaced_by_the_default() {
    let mut model = planar();
    let mut session = model.session().clone();
    session.apply(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 60) });
    session.apply(Command::MoveInterior {
        side: Side::Target,
        point: BarycentricPoint::new(TriangleId::new(0), [-1.0, 1.0, 1.0]).into(),
    });
    model.dispatch(Command::Open(Box::new(session)), 0.0);
    settle(&mut model);
    model.refresh(false);
    assert!(model.is_ready() && mapped_surface(&model).is_some());
    assert_eq!(model.session().surface(Side::Target).unwrap().point, None);
}

/// A square with a vertex in its middle, as an OBJ file.
const SQUARE: &[u8] = b"v 0.5 0.5 0\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 2 3 1\nf 3 4 1\nf 4 5 1\nf 5 2 1\n";

/// Opens a session whose surface is in a file that is not here, "square.obj".
fn waiting_for_square(model: &mut Model) -> Session {
    let mut session = model.session().clone();
    let shape = SurfaceShape::File { name: "square.obj".into() };
    session.apply(Command::SetSurface { side: Side::Target, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } });
    session.apply(Command::MoveAnchor { side: Side::Target, fraction: 0.6 });
    model.dispatch(Command::Open(Box::new(session.clone())), 0.0);
    settle(model);
    session
}

#[test]
fn a_session_that_waits_for_its_file_applies_its_points_to_it() {
    let mut model = planar();
    let session = waiting_for_square(&mut model);
    assert!(model.is_planar() && model.surface_side(Side::Target).preparation.error.is_some());
    model.want_surface_file(Side::Target, "square.obj", SQUARE.to_vec());
    settle(&mut model);
    assert_eq!(model.session().surface(Side::Target), session.surface(Side::Target));
}

#[test]
fn the_source_shows_the_disk_pattern_too() {
    for texture in [TextureKind::Conformal, TextureKind::Tiling] {
        let mut model = with_hemisphere();
        model.dispatch(Command::SetTexture(texture), 0.0);
        model.refresh(false);
        let geometry = crate::model::pattern::geometry(&model, Side::Source).unwrap();
        assert_eq!(geometry.texture_coordinates, model.shown_grid().of(Side::Source));
        assert!(geometry.texture_coordinates.iter().all(|g| g.length() < 1.0 + 1e-9), "in the disk");
    }
}

#[test]
fn refining_changes_the_resolution_only_of_the_current_surface() {
    let mut model = with_hemisphere();
    model.dispatch(Command::MoveAnchor { side: Side::Target, fraction: 0.4 }, 0.0);
    for (asked, there) in [(SurfacePreset::Hemisphere, 30), (SurfacePreset::Saddle, 30)]
        .map(|(preset, boundary)| (spec(preset, boundary), spec(SurfacePreset::Hemisphere, boundary)))
    {
        model.dispatch(Command::RefineSurface { side: Side::Target, surface: asked.clone() }, 0.0);
        settle(&mut model);
        let state = model.session().surface(Side::Target).unwrap();
        assert_eq!((&state.spec, state.anchor), (&there, 0.4));
        let mut session = model.session().clone();
        session.apply(Command::RefineSurface { side: Side::Target, surface: asked });
        assert_eq!(session.surface(Side::Target).unwrap().spec, there);
    }
}

#[test]
fn refining_a_surface_leaves_later_requests() {
    let mut model = with_hemisphere();
    model.side_mut(Side::Target).error = Some(UserError::new("bow.csv: it crosses itself".into()));
    model.dispatch(Command::RefineSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 30) }, 0.0);
    assert!(model.side(Side::Target).error.is_some(), "another file's message");
    model.dispatch(Command::SetOutline { side: Side::Target, outline: OutlineSpec::Preset(Preset::Star) }, 0.0);
    model.dispatch(Command::RefineSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 36) }, 0.0);
    settle(&mut model);
    assert!(model.is_planar(), "the outline has taken its place");
    model.dispatch(Command::RefineSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 40) }, 0.0);
    settle(&mut model);
    assert!(model.is_planar(), "nor does it come back");
}

#[test]
fn refining_a_surface_uses_no_points_of_another_session() {
    let mut model = with_hemisphere();
    let here = model.session().surface(Side::Target).cloned().unwrap();
    let session = waiting_for_square(&mut model);
    let mut refined = here.spec.clone();
    refined.settings.intrinsic_delaunay = !refined.settings.intrinsic_delaunay;
    model.dispatch(Command::RefineSurface { side: Side::Target, surface: refined.clone() }, 0.0);
    settle(&mut model);
    let state = model.session().surface(Side::Target).cloned().unwrap();
    assert_eq!((&state.spec, state.anchor), (&refined, here.anchor));
    model.want_surface_file(Side::Target, "square.obj", SQUARE.to_vec());
    settle(&mut model);
    assert_eq!(
        model.session().surface(Side::Target),
        session.surface(Side::Target),
        "the file that was missing has its own"
    );
}

#[test]
fn a_session_whose_surface_is_refined_during_its_preparation_keeps_the_points_that_still_fit() {
    let mut model = with_hemisphere();
    let mut session = model.session().clone();
    session.apply(Command::SetSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 48) });
    session.apply(Command::MoveInterior {
        side: Side::Target,
        point: BarycentricPoint::new(TriangleId::new(3), [0.2, 0.3, 0.5]).into(),
    });
    session.apply(Command::MoveAnchor { side: Side::Target, fraction: 0.7 });
    model.dispatch(Command::Open(Box::new(session)), 0.0);
    model.dispatch(Command::RefineSurface { side: Side::Target, surface: spec(SurfacePreset::Hemisphere, 30) }, 0.0);
    settle(&mut model);
    let state = model.session().surface(Side::Target).cloned().unwrap();
    assert_eq!((state.spec, state.point, state.anchor), (spec(SurfacePreset::Hemisphere, 30), None, 0.7));
}

#[test]
fn a_file_is_exported_as_it_was_read_or_says_that_it_is_not() {
    let quads =
        "mtllib a.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n";
    let strips = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n";
    for (name, content, format, is_kept) in [
        ("quads.obj", quads, FileFormat::Obj, true),
        ("quads.obj", quads, FileFormat::Ply, true),
        ("strips.ply", strips, FileFormat::Obj, true),
        ("strips.ply", strips, FileFormat::Ply, false),
    ] {
        let mut model = planar();
        model.want_surface_file(Side::Target, name, content.as_bytes().to_vec());
        settle(&mut model);
        while !model.is_ready() {
            model.refresh(false);
        }
        let request = FileRequest { format, side: None, unit: true, corners: false };
        let written = file(&model, request, None).unwrap().unwrap();
        let note = written.note.map(|note| note.english());
        assert_eq!(note.is_none(), is_kept, "{name} {format:?}: {note:?}");
        assert!(note.is_none_or(|note| note.contains("strips-mapped.ply has bare triangles")));
        let text = String::from_utf8(written.bytes).unwrap();
        let has_quads = text.contains("usemtl red") && text.contains("f 1/1 2/2 5/5 4/4\n");
        assert_eq!(has_quads, (name, format) == ("quads.obj", FileFormat::Obj), "{text}");
    }
}
