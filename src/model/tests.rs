//! Maps that take longer than a frame: what is shown meanwhile, and the result.

use crate::conformal::PrepareSettings;
use crate::laplace::SolverKind;
use crate::mesh::Sizing;
use crate::model::pattern;
use crate::model::*;
use crate::outline::{Preset, Sampling};
use crate::session::{Command, OutlineSpec, TextureKind};

const BOTH_SOLVERS: [SolverKind; 2] = [SolverKind::Direct, SolverKind::Pcg];

/// A model of two prepared domains whose updates are done at once.
fn prepared(solver: SolverKind, texture: TextureKind) -> Model {
    let mut session = Session::default();
    session.apply(Command::SetTexture(texture));
    let sampling = Sampling::Uniform { count: 300, keep_corners: false };
    let settings = PrepareSettings { sampling, sizing: Sizing::Graded(0.1), solver, ..PrepareSettings::default() };
    for side in Side::BOTH {
        session.apply(Command::SetSettings { side, settings });
    }
    let mut model = Model::new(session);
    model.update_ms = f64::INFINITY;
    prepare(&mut model);
    model.refresh(false);
    assert!(model.is_ready());
    model
}

fn prepare(model: &mut Model) {
    for (side, request) in model.take_requests(f64::INFINITY) {
        crate::worker::run(&request, &mut |generation, response| model.accept(side, generation, response));
    }
}

fn drag(model: &mut Model, step: f64) -> Changes {
    let point = model.domain(Side::Source).unwrap().default_point() + 0.01 * step * DVec2::new(1.0, -1.0);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
    model.refresh(true)
}

/// The full map's mesh, not the draft's.
fn is_full(model: &Model) -> bool {
    let map = model.map().unwrap();
    Side::BOTH.into_iter().all(|side| Arc::ptr_eq(map.domain(side).unwrap(), model.domain(side).unwrap()))
}

/// Positions, texture coordinates, triangles.
type Drawn = (Vec<DVec2>, Vec<DVec2>, Vec<[u32; 3]>);

/// What both viewports draw.
fn picture(model: &Model) -> [Drawn; 2] {
    Side::BOTH.map(|side| {
        let geometry = pattern::geometry(model, side).unwrap();
        assert_eq!(geometry.check(), Ok(()), "{side}");
        (geometry.positions.to_vec(), geometry.texture_coordinates.to_vec(), geometry.triangles.to_vec())
    })
}

/// Refreshes until the full map is shown, and returns how often; the picture stays until then and changes as a whole.
fn rest(model: &mut Model) -> usize {
    let (before, mut count) = (picture(model), 0);
    loop {
        let changes = model.refresh(false);
        count += 1;
        assert!(count < 100_000, "the full map never comes");
        if !model.is_pending() {
            assert!(changes.meshes && changes.images, "{changes:?}");
            return count;
        }
        if changes == Changes::default() {
            assert!(picture(model) == before, "refresh {count} changed the picture");
        }
        assert!(!model.is_ready() && (model.is_draft() || count < 3), "refresh {count}");
    }
}

#[test]
fn a_map_longer_than_a_frame_is_shown_after_several() {
    for solver in BOTH_SOLVERS {
        for texture in [TextureKind::Checker, TextureKind::Conformal, TextureKind::Tiling] {
            let mut model = prepared(solver, texture);
            model.update_ms = 0.0;
            for step in 1..4 {
                drag(&mut model, f64::from(step));
            }
            assert!(model.is_draft() && !is_full(&model) && !model.is_ready());
            assert_eq!(model.refresh(true), Changes::default(), "in a drag the full map waits");
            let count = rest(&mut model);
            assert!(count > 3 && model.is_ready() && is_full(&model) && !model.is_draft(), "{count} refreshes");
            let mut blocking = prepared(solver, texture);
            drag(&mut blocking, 3.0);
            assert!(picture(&model) == picture(&blocking), "{solver:?}, {texture:?}");
            assert_eq!(model.map().unwrap().images(), blocking.map().unwrap().images());
            assert_eq!(model.refresh(false), Changes::default());
        }
    }
}

#[test]
fn one_short_frame_shows_no_draft_of_a_direct_map() {
    let mut model = prepared(SolverKind::Direct, TextureKind::Checker);
    let before = picture(&model);
    model.update_ms = 0.0;
    assert_eq!(drag(&mut model, 1.0), Changes::default());
    assert!(!model.is_draft() && model.is_pending() && picture(&model) == before);
    // once the browser has compiled the code, one frame is long enough again
    model.update_ms = f64::INFINITY;
    assert!(model.refresh(true).images && model.is_ready());
    drag(&mut model, 2.0);
    model.update_ms = 0.0;
    assert_eq!(drag(&mut model, 3.0), Changes::default(), "not two in a row");
    let changes = drag(&mut model, 4.0);
    assert!(changes.meshes && changes.images && model.is_draft());
}

#[test]
fn a_new_drag_in_the_middle_starts_over() {
    for texture in [TextureKind::Checker, TextureKind::Conformal] {
        let mut model = prepared(SolverKind::Pcg, texture);
        model.update_ms = 0.0;
        // interrupted in the kernels, in the extension, in the disk coordinates
        for left in [1, 30, 90] {
            drag(&mut model, 1.0);
            for _ in 0..left {
                model.refresh(false);
            }
            assert!(drag(&mut model, 2.0).images && model.is_draft(), "the draft follows");
            rest(&mut model);
            let mut blocking = prepared(SolverKind::Pcg, texture);
            drag(&mut blocking, 2.0);
            assert!(picture(&model) == picture(&blocking), "{texture:?}, left after {left}");
        }
    }
}

#[test]
fn new_outlines_are_shown_coarsely_until_their_map_is_there() {
    for solver in BOTH_SOLVERS {
        for texture in [TextureKind::Checker, TextureKind::Conformal] {
            let star = Command::SetOutline { side: Side::Source, outline: OutlineSpec::Preset(Preset::Star) };
            let mut model = prepared(solver, texture);
            model.update_ms = 0.0;
            model.dispatch(star.clone(), 0.0);
            model.refresh(false);
            model.take_refit(Side::Source);
            assert!(model.is_draft() || !model.is_pending(), "nothing new was prepared");
            prepare(&mut model);
            let mut refits = 0;
            for _ in 0..2 {
                model.refresh(false);
                let refit = model.take_refit(Side::Source);
                assert_eq!(refit, model.is_draft() && refits == 0, "the view fits what is shown");
                refits += usize::from(refit);
            }
            assert!(refits == 1 && model.is_draft() && !is_full(&model));
            rest(&mut model);
            let mut blocking = prepared(solver, texture);
            blocking.dispatch(star, 0.0);
            prepare(&mut blocking);
            blocking.refresh(false);
            assert!(is_full(&model) && picture(&model) == picture(&blocking), "{solver:?}, {texture:?}");
        }
    }
}

#[test]
fn a_pattern_in_the_disk_waits_for_its_coordinates() {
    let mut model = prepared(SolverKind::Pcg, TextureKind::Checker);
    model.update_ms = 0.0;
    let generation = model.generation();
    model.dispatch(Command::SetTexture(TextureKind::Conformal), 0.0);
    assert!(model.refresh(false).meshes && model.is_draft() && model.pattern_home().is_none());
    rest(&mut model);
    assert!(model.generation() > generation && is_full(&model));
    assert!(picture(&model) == picture(&prepared(SolverKind::Pcg, TextureKind::Conformal)));
    // a direct map's first short frame keeps the previous pattern
    let mut model = prepared(SolverKind::Direct, TextureKind::Checker);
    let before = picture(&model);
    model.update_ms = 0.0;
    model.dispatch(Command::SetTexture(TextureKind::Conformal), 0.0);
    assert_eq!(model.refresh(false), Changes::default());
    assert!(model.pattern_home() == Some(Side::Source) && picture(&model) == before);
}

#[test]
fn after_an_error_the_last_good_map_and_its_points_are_there() {
    let mut model = prepared(SolverKind::Pcg, TextureKind::Checker);
    let (before, point) = (picture(&model), model.interior(Side::Source));
    model.update_ms = 0.0;
    drag(&mut model, 1.0);
    assert!(model.is_draft());
    model.dispatch(Command::MoveInterior { side: Side::Source, point: DVec2::splat(1e3).into() }, 0.0);
    assert!(model.refresh(false).meshes);
    assert_eq!(model.map_error().unwrap().0, Side::Source);
    assert!(model.is_ready() && picture(&model) == before && model.interior(Side::Source) == point);
    assert_eq!(model.refresh(false), Changes::default());
}

#[test]
fn a_measurement_in_pieces_is_the_one_at_once() {
    let mut model = prepared(SolverKind::Direct, TextureKind::Checker);
    // more triangles than are measured between two checks of the deadline
    let sampling = Sampling::Uniform { count: 700, keep_corners: false };
    let settings = PrepareSettings { sampling, sizing: Sizing::Uniform, ..PrepareSettings::default() };
    model.dispatch(Command::SetSettings { side: Side::Target, settings }, 0.0);
    prepare(&mut model);
    model.refresh(false);
    let (expected, triangles) = (model.quality(), model.triangles().to_vec());
    model.dispatch(Command::MoveAnchor { side: Side::Source, fraction: 0.2 }, 0.0);
    model.measurement.set_milliseconds(f64::INFINITY);
    model.refresh(false);
    assert!(model.is_quality_stale());
    model.update_ms = 0.0;
    model.measure_at_rest();
    assert!(model.is_quality_stale() && model.quality() == expected && model.triangles() == triangles);
    while model.is_quality_stale() {
        model.measure_at_rest();
    }
    let pieces = (model.quality(), model.triangles().to_vec(), model.measured_generation());
    model.measure();
    assert!(pieces == (model.quality(), model.triangles().to_vec(), model.generation()));
    assert_ne!(model.quality(), expected);
}
