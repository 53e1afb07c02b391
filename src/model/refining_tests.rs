//! The refined map in the app: shown at rest, dropped by every change, and the same however it was come to.

use crate::conformal::{ConformalMap, Extension, KernelMode, PrepareSettings};
use crate::export::FileFormat;
use crate::language::Message;
use crate::mesh::Sizing;
use crate::model::export::{FileRequest, file};
use crate::model::scene::{Offscreen, is_complete};
use crate::model::*;
use crate::outline::{Preset, Sampling};
use crate::session::{Command, OutlineSpec, SidePoints, TextureKind};
use crate::worker::{self, Failure, Request, Response, Task};

fn session(presets: [Preset; 2]) -> Session {
    let settings = PrepareSettings::new(Sampling::Adaptive { target: Some(150) }, Sizing::Graded(0.3));
    let outlines = Side::BOTH.into_iter().zip(presets).flat_map(|(side, preset)| {
        let outline = OutlineSpec::Preset(preset);
        [Command::SetOutline { side, outline }, Command::SetSettings { side, settings }]
    });
    Session::with(outlines)
}

fn run((side, request): &(Side, Request), model: &mut Model) {
    worker::run(request, &mut |generation, response| model.accept(*side, generation, response));
}

/// A model whose full map is shown, and the request for the mesh of the refined one.
fn mapped(presets: [Preset; 2]) -> (Model, (Side, Request)) {
    let mut model = Model::new(session(presets));
    model.update_ms = f64::INFINITY;
    for request in model.take_requests(0.0) {
        run(&request, &mut model);
    }
    model.refresh(false);
    let mesh = mesh_of(&mut model);
    (model, mesh)
}

fn mesh_of(model: &mut Model) -> (Side, Request) {
    assert!(model.next_due().is_some(), "a frame is asked for");
    let [mesh] = <[_; 1]>::try_from(model.take_requests(0.0)).unwrap();
    assert!(matches!(mesh.1.task, Task::Mesh { .. }) && model.next_due().is_none());
    mesh
}

fn rest(model: &mut Model) {
    while let requests @ [_, ..] = model.take_requests(f64::INFINITY).as_slice() {
        for request in requests {
            run(request, model);
        }
        model.refresh(false);
    }
    assert!(model.is_ready() && model.map().unwrap().resolution().is_some());
}

fn at_rest(presets: [Preset; 2]) -> Model {
    let (mut model, mesh) = mapped(presets);
    run(&mesh, &mut model);
    model.refresh(false);
    rest(&mut model);
    model
}

fn move_x1(model: &mut Model, by: DVec2) {
    let point = model.domain(Side::Source).unwrap().default_point() + by;
    model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
}

fn share_of_flips(map: &ConformalMap) -> f64 {
    f64::from(map.quality().flipped) / map.mapped().triangles().len() as f64
}

#[test]
fn only_the_refined_map_is_ready_and_it_is_that_of_the_command_line() {
    let (mut model, mesh) = mapped([Preset::Disk, Preset::VShape]);
    assert!(model.is_mapped() && !model.is_ready() && model.is_refining() && model.unresolved_area().is_none());
    let full = model.map().unwrap();
    let count = full.mapped().triangles().len();
    let settings = model.session().domain(Side::Source).settings;
    let refined = full.refined(&settings, &mut |_| ()).unwrap().unwrap();
    run(&mesh, &mut model);
    assert!(!model.is_ready() && model.refines_in_refresh());
    let changes = model.refresh(false);
    assert_eq!(changes, Changes { meshes: true, map: true, images: true });
    assert!(model.is_ready() && is_complete(&model) && model.take_requests(f64::INFINITY).is_empty());
    let map = model.map().unwrap();
    assert!(map.images() == refined.images() && map.mapped().triangles().len() > count);
    assert!(share_of_flips(map) <= 1e-3 && model.unresolved_area().is_some(), "{}", share_of_flips(map));
    assert_eq!(model.quality().unwrap().flipped, map.quality().flipped, "measured is what is shown");
    assert_eq!(model.refresh(false), Changes::default());
}

#[test]
fn a_drag_shows_the_full_map_at_once_and_makes_a_mesh_only_at_rest() {
    let mut model = at_rest([Preset::Disk, Preset::VShape]);
    let refined = model.map().unwrap().images().to_vec();
    model.set_at_rest(false);
    for step in 1..4 {
        move_x1(&mut model, DVec2::splat(0.02 * f64::from(step)));
        let changes = model.refresh(true);
        assert!(changes.images && changes.meshes == (step == 1), "{step}");
        let map = model.map().unwrap();
        let full = model.domain(map.mapped_side()).unwrap();
        assert!(Arc::ptr_eq(map.mapped().domain().unwrap(), full) && !model.is_ready());
        assert!(model.take_requests(0.0).is_empty() && model.next_due().is_none(), "it moves");
    }
    move_x1(&mut model, DVec2::ZERO);
    model.refresh(true);
    model.set_at_rest(true);
    rest(&mut model);
    assert!(model.map().unwrap().images() == refined, "it does not depend on the way");
}

#[test]
fn a_stale_mesh_changes_nothing() {
    let (mut model, stale) = mapped([Preset::Disk, Preset::Star]);
    move_x1(&mut model, DVec2::splat(0.1));
    assert!(model.take_requests(0.0).is_empty(), "the map is behind");
    model.refresh(false);
    run(&stale, &mut model);
    assert_eq!(model.refresh(false), Changes::default());
    assert!(!model.is_ready());
    rest(&mut model);
    let mut other = at_rest([Preset::Disk, Preset::Star]);
    move_x1(&mut other, DVec2::splat(0.1));
    other.refresh(false);
    rest(&mut other);
    assert!(model.map().unwrap().images() == other.map().unwrap().images());
}

#[test]
fn any_other_request_supersedes_a_mesh_which_is_requested_again() {
    let (mut model, stale) = mapped([Preset::Disk, Preset::Star]);
    let outline = OutlineSpec::Preset(Preset::Heart);
    let side = stale.0;
    model.dispatch(Command::SetOutline { side, outline }, 0.0);
    let requests = model.take_requests(0.0);
    assert!(requests.len() == 1 && matches!(requests[0].1.task, Task::Outline { .. }), "at once");
    run(&stale, &mut model);
    assert!(!model.refines_in_refresh(), "it is stale");
    // an outline that is refused leaves the map as it was, still to be refined
    let failed = Response::Failed(Failure::new("no"));
    model.accept(side, requests[0].1.generation, failed);
    rest(&mut model);
    let fresh = at_rest([Preset::Disk, Preset::Star]);
    assert!(model.map().unwrap().images() == fresh.map().unwrap().images());
}

#[test]
fn a_mesh_that_cannot_be_made_leaves_the_full_map_with_the_reason() {
    for dies in [false, true] {
        let (mut model, (side, request)) = mapped([Preset::Disk, Preset::Star]);
        let text = Message::from("out of memory");
        if dies {
            model.worker_died(side, Some(request.generation), &text);
        } else {
            let failed = Response::Failed(Failure { text, repairable: false, sketch: None });
            model.accept(side, request.generation, failed);
        }
        model.refresh(false);
        assert!(model.is_ready() && model.take_requests(f64::INFINITY).is_empty());
        assert!(model.unrefined().unwrap().english().contains("memory") && model.user_errors(side).count() == 0);
        move_x1(&mut model, DVec2::splat(0.1));
        model.refresh(false);
        rest(&mut model);
    }
}

#[test]
fn a_refinement_longer_than_a_frame_takes_several_and_is_the_same() {
    for texture in [TextureKind::Checker, TextureKind::Conformal] {
        let presets = [Preset::Spiral, Preset::Hand];
        let at_once = at_rest(presets);
        let (mut model, mut mesh) = mapped(presets);
        model.dispatch(Command::SetTexture(texture), 0.0);
        model.refresh(false);
        model.update_ms = 0.0;
        loop {
            run(&mesh, &mut model);
            let mut count = 0;
            while model.refines_in_refresh() {
                model.refresh(false);
                count += 1;
            }
            assert!(count > 1, "{count}");
            if !model.is_refining() {
                break;
            }
            mesh = mesh_of(&mut model);
        }
        while model.is_pending() {
            model.refresh(false);
        }
        assert!(model.is_ready() && model.map().unwrap().images() == at_once.map().unwrap().images());
    }
}

#[test]
fn exact_images_in_a_crowded_domain_do_not_fold() {
    for presets in [[Preset::Disk, Preset::VShape], [Preset::VShape, Preset::Disk]] {
        let settings = session(presets).domain(Side::Source).settings.with_kernel(KernelMode::Integral);
        let sharp = Side::BOTH.map(|side| Command::SetSettings { side, settings });
        let mut model = Model::new(session(presets).and(sharp).and([Command::SetExtension(Extension::Exact)]));
        model.update_ms = f64::INFINITY;
        rest(&mut model);
        while model.extension_progress() < 1.0 {
            assert!(model.refresh(false).images);
        }
        let map = model.map().unwrap();
        assert!(
            share_of_flips(map) <= 1e-3,
            "{presets:?}: {} of {}",
            map.quality().flipped,
            map.mapped().triangles().len()
        );
    }
}

#[test]
fn exact_images_at_rest_are_those_of_a_moebius_map() {
    let (a, anchor) = (0.5, 0.0);
    let points = [a, 0.0].map(|x| SidePoints::Outline { interior: Some(DVec2::new(x, 0.0)), anchor });
    let [source, target] = [Side::Source, Side::Target].map(|side| (side, points[side as usize]));
    let place = |(side, points)| Command::PlacePoints { side, points };
    let commands = [place(source), place(target), Command::SetExtension(Extension::Exact)];
    let settings = session([Preset::Disk; 2]).domain(Side::Source).settings.with_kernel(KernelMode::Integral);
    let sharp = Side::BOTH.map(|side| Command::SetSettings { side, settings });
    let mut model = Model::new(session([Preset::Disk; 2]).and(sharp).and(commands));
    model.update_ms = f64::INFINITY;
    for _stage in ["finite elements", "integral equations"] {
        for request in model.take_requests(0.0) {
            run(&request, &mut model);
        }
        model.refresh(false);
    }
    assert!(model.is_sharp() && model.is_refining());
    assert_eq!(model.extension_progress(), 0.0, "the full map keeps its harmonic images");
    rest(&mut model);
    while model.extension_progress() < 1.0 {
        assert!(model.refresh(false).images);
    }
    let map = model.map().unwrap();
    // f = (z − a)/(1 − a z)
    let a = if map.mapped_side() == Side::Source { a } else { -a };
    let moebius =
        |z: DVec2| (z - DVec2::X * a).rotate(DVec2::new(1.0 - a * z.x, a * z.y)) / (DVec2::X - a * z).length_squared();
    let vertices = map.domain(map.mapped_side()).unwrap().mesh().vertices();
    let off = vertices.iter().zip(map.images()).map(|(&z, image)| image.distance(moebius(z)));
    let most = off.fold(0.0, f64::max);
    assert!(most < 1e-12, "{most:e}");
}

#[test]
fn uniform_samples_are_not_refined() {
    let uniform = PrepareSettings::new(Sampling::Uniform { count: 200, keep_corners: false }, Sizing::Graded(0.3));
    let commands = Side::BOTH.map(|side| Command::SetSettings { side, settings: uniform });
    let mut model = Model::new(session([Preset::Disk, Preset::Star]).and(commands));
    model.update_ms = f64::INFINITY;
    for request in model.take_requests(f64::INFINITY) {
        run(&request, &mut model);
    }
    model.refresh(false);
    assert!(model.is_ready() && model.take_requests(f64::INFINITY).is_empty() && model.unrefined().is_none());
    assert!(model.map().unwrap().resolution().is_none());
}

#[test]
fn files_and_pictures_are_those_of_the_map_at_rest() {
    let model = at_rest([Preset::Disk, Preset::VShape]);
    let request = FileRequest { format: FileFormat::Obj, side: None, unit: false, corners: true };
    let of_app = file(&model, request, None).unwrap().unwrap();
    let vertices = of_app.bytes.split(|&b| b == b'\n').filter(|line| line.starts_with(b"v ")).count();
    assert_eq!(vertices, model.map().unwrap().mapped().vertex_count());
    let mut copy = Offscreen::of(&model, 1.0);
    while !copy.advance().unwrap() {}
    assert!(copy.file(request, None).unwrap() == of_app, "a picture shows it too");
    let headless = Offscreen::new(model.session(), PerSide::new(None, None), 1.0).unwrap();
    assert!(headless.file(request, None).unwrap() == of_app);
    let mut film = Offscreen::moving(&model, 1.0);
    while !film.advance().unwrap() {}
    assert!(film.file(request, None).unwrap() != of_app, "all of a film is on the full mesh");
}
