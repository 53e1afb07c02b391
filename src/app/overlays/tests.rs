//! Comparisons and walks, checked against known results for the disk, the heart and the V-shape.

use crate::app::overlays::paint::legend;
use crate::app::plots::Plots;
use crate::conformal::{Direction, PerSide, PrepareSettings, Side};
use crate::geometry::DVec2;
use crate::language::Message;
use crate::mesh::Sizing;
use crate::model::overlays::disk_comparison::found::MARKS;
use crate::model::overlays::disk_comparison::{Found, MOVING_SAMPLES, RESTING_SAMPLES};
use crate::model::overlays::overlay::{Origin, Overlay};
use crate::model::overlays::walks::{BINS, WalkAction};
use crate::model::pattern::Moved;
use crate::model::{Model, pattern};
use crate::outline::{BoundaryPoint, Preset, Sampling};
use crate::session::{Command, Comparison, DiskWay, OutlineSpec, Session, TextureKind};
use crate::zipper::{DiskMeasure, ZipperError};

/// A model of two presets with `count` uniform samples each, mapped forward.
fn model(source: Preset, target: Preset, count: u32) -> Model {
    let mut session = Session::default();
    session.apply(Command::SetDirection(Direction::Forward));
    for (side, preset) in [(Side::Source, source), (Side::Target, target)] {
        session.apply(Command::SetOutline { side, outline: OutlineSpec::Preset(preset) });
        let sampling = Sampling::Uniform { count, keep_corners: false };
        let settings = PrepareSettings { sampling, sizing: Sizing::Graded(0.15), ..PrepareSettings::default() };
        session.apply(Command::SetSettings { side, settings });
    }
    let mut model = Model::new(session);
    for (side, request) in model.take_requests(f64::INFINITY) {
        crate::worker::run(&request, &mut |generation, response| model.accept(side, generation, response));
    }
    complete(&mut model);
    model
}

/// Updates the map until it is complete; one update may take several frames' time.
fn complete(model: &mut Model) {
    model.refresh(false);
    while model.is_pending() {
        model.refresh(false);
    }
}

fn compare(model: &mut Model, comparison: Comparison) {
    model.dispatch(Command::SetComparison(comparison), 0.0);
    complete(model);
}

/// Advances the overlays until nothing is left to do; returns the number of calls and the longest one in ms.
fn settle(model: &mut Model) -> (u32, f64) {
    let (mut now, mut calls, mut longest) = (0.0, 0, 0.0_f64);
    loop {
        let start = std::time::Instant::now();
        let next = model.advance_overlays(now);
        longest = longest.max(start.elapsed().as_secs_f64() * 1e3);
        calls += 1;
        assert!(calls < 10, "the overlays are never complete");
        let Some(delay) = next else { return (calls, longest) };
        now += delay + 1e-6;
    }
}

fn found(model: &Model, way: DiskWay) -> &Found {
    let disk = &model.overlay_state().disk_comparison;
    assert_eq!(disk.error(way), None);
    disk.found(way).unwrap()
}

#[test]
fn on_the_disk_both_ways_agree_and_no_point_is_lost() {
    for (comparison, way) in [(Comparison::Fresh, DiskWay::Fresh), (Comparison::Precomputed, DiskWay::Precomputed)] {
        let mut model = model(Preset::Disk, Preset::Disk, 300);
        let point = model.interior(Side::Source).unwrap() + DVec2::new(0.2, 0.1);
        model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
        compare(&mut model, comparison);
        settle(&mut model);
        let found = found(&model, way);
        assert_eq!((found.samples, found.collapsed, found.disordered), ([300; 2].into(), [0; 2].into(), [0; 2].into()));
        assert_eq!(found.directly_collapsed, [0; 2].into());
        assert_eq!(found.marks.len(), MARKS as usize);
        // the kernel's own discretization error with 300 samples
        assert!(found.difference < 2e-3, "{comparison:?}: {:e}", found.difference);
    }
}

/// Section 1.2 of the paper on its V-shape with 1000 samples and the interior point in one arm: the precomputed map
/// collapses more than half of the samples, the fresh one agrees with riemap's map to 0.02 of the boundary's length.
#[test]
fn on_the_v_the_precomputed_map_collapses_and_the_fresh_one_does_not() {
    let mut model = model(Preset::VShape, Preset::Heart, 1000);
    let point = DVec2::new(0.96, 0.8432);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
    compare(&mut model, Comparison::Precomputed);
    let (calls, longest) = settle(&mut model);
    let found_precomputed = found(&model, DiskWay::Precomputed).clone();
    let Found { collapsed, disordered, difference, .. } = &found_precomputed;
    println!(
        "precomputed: collapsed {collapsed:?}, disordered {disordered:?}, difference {difference:.3}; {calls} calls, at most {longest:.1} ms"
    );
    assert!(collapsed.source > 500 && collapsed.target == 0, "{collapsed:?}");
    assert!(disordered.source > 0 && *difference > 0.2, "{disordered:?}, {difference}");
    compare(&mut model, Comparison::Fresh);
    let (calls, longest) = settle(&mut model);
    let found = found(&model, DiskWay::Fresh);
    println!(
        "fresh: collapsed {:?}, difference {:.4}; {calls} calls, at most {longest:.1} ms",
        found.collapsed, found.difference
    );
    assert_eq!(found.samples, [RESTING_SAMPLES; 2].into());
    assert!(found.difference < 0.02, "{}", found.difference);
    compare(&mut model, Comparison::Off);
    settle(&mut model);
    assert!(
        model.overlay_state().disk_comparison.all_found().next().is_none()
            && model.overlay_state().overlays().measure.is_empty()
    );
}

#[test]
fn while_it_moves_few_samples_are_compared_and_all_when_it_rests() {
    let mut model = model(Preset::Heart, Preset::Cinquefoil, 500);
    compare(&mut model, Comparison::Fresh);
    settle(&mut model);
    assert_eq!(found(&model, DiskWay::Fresh).samples, [500; 2].into());
    let point = model.interior(Side::Source).unwrap() + DVec2::new(0.01, 0.0);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
    complete(&mut model);
    assert_eq!(model.advance_overlays(10.0), Some(0.0), "the coarse comparison is shown at once");
    let delay = model.advance_overlays(10.0).unwrap();
    assert!(delay > 0.0, "the full comparison is not delayed");
    // the side that did not move keeps its measure
    assert_eq!(found(&model, DiskWay::Fresh).samples, PerSide::new(MOVING_SAMPLES, 500));
    assert!(model.advance_overlays(10.0 + 0.5 * delay).is_some_and(|rest| rest > 0.0));
    model.advance_overlays(10.0 + delay + 1e-6);
    assert_eq!(found(&model, DiskWay::Fresh).samples, [500; 2].into());
    let overlays = model.overlay_state().overlays();
    assert_eq!((overlays.measure.len(), overlays.reparameterisation.len()), (2, 1));
}

#[test]
fn precomputed_maps_are_made_once_per_domain() {
    let mut model = model(Preset::Heart, Preset::Cinquefoil, 300);
    compare(&mut model, Comparison::Precomputed);
    assert_eq!(settle(&mut model).0, 4, "two maps, the comparison, its picture");
    let version = model.overlay_state().disk_comparison.version();
    let point = model.interior(Side::Target).unwrap() + DVec2::new(0.01, 0.0);
    model.dispatch(Command::MoveInterior { side: Side::Target, point: point.into() }, 0.0);
    complete(&mut model);
    assert_eq!(settle(&mut model).0, 2);
    assert_eq!(model.overlay_state().disk_comparison.version(), version + 1);
}

#[test]
fn both_ways_are_shown_together_and_each_as_if_it_were_alone() {
    let shown = |comparison| {
        let mut model = model(Preset::Heart, Preset::Cinquefoil, 500);
        compare(&mut model, comparison);
        settle(&mut model);
        model
    };
    let [both, fresh, precomputed] = [Comparison::Both, Comparison::Fresh, Comparison::Precomputed].map(shown);
    assert_eq!(found(&both, DiskWay::Fresh), found(&fresh, DiskWay::Fresh));
    assert_eq!(found(&both, DiskWay::Precomputed), found(&precomputed, DiskWay::Precomputed));
    assert!(fresh.overlay_state().disk_comparison.found(DiskWay::Precomputed).is_none());
    let overlays = both.overlay_state().overlays();
    let origins = |overlays: &[Overlay]| overlays.iter().map(|overlay| overlay.origin).collect::<Vec<_>>();
    let [below, above] = [DiskWay::Precomputed, DiskWay::Fresh].map(Origin::Disk);
    assert_eq!(origins(&overlays.reparameterisation), [below, above]);
    assert_eq!(origins(&overlays.measure), [below, below, above, above]);
    assert_ne!(Plots::overlay_ink(below, true), Plots::overlay_ink(above, true));
    assert_eq!(legend(Side::Target, &both, true).len(), 3, "this map's images, and each way's");
    assert_eq!(legend(Side::Target, &fresh, true).len(), 2);
}

#[test]
fn one_way_of_both_can_be_left_out_and_comes_back_at_once() {
    let mut model = model(Preset::Heart, Preset::Cinquefoil, 300);
    compare(&mut model, Comparison::Both);
    settle(&mut model);
    let before = found(&model, DiskWay::Precomputed).clone();
    compare(&mut model, Comparison::Fresh);
    settle(&mut model);
    assert!(model.overlay_state().disk_comparison.found(DiskWay::Precomputed).is_none());
    assert_eq!(model.overlay_state().overlays().reparameterisation.len(), 1);
    compare(&mut model, Comparison::Both);
    assert_eq!(model.advance_overlays(9.0), Some(0.0), "the overlays changed");
    assert_eq!(found(&model, DiskWay::Precomputed), &before, "its disk maps were kept");
}

/// The turkey with 1200 samples: the curve through every fourth of them excludes points near the boundary that the
/// curve through all of them contains.
#[test]
fn a_point_that_few_samples_exclude_is_refused_only_if_all_samples_exclude_it() {
    let mut model = model(Preset::Turkey, Preset::Disk, 1200);
    let domain = std::sync::Arc::clone(model.domain(Side::Source).unwrap());
    let anchor = BoundaryPoint::new(0, 0.0);
    let few = domain.samples().thinned(MOVING_SAMPLES);
    let beside = domain.samples().points().iter().filter_map(|&p| model.interior_near(Side::Source, p));
    let is_left_out =
        |x: &DVec2| matches!(DiskMeasure::fresh(few.points(), *x, anchor), Err(ZipperError::PointOutside { .. }));
    let left_out: Vec<DVec2> = beside.filter(is_left_out).take(12).collect();
    println!("{} points are left out by {MOVING_SAMPLES} samples", left_out.len());
    assert!(left_out.len() > 3, "{left_out:?}");
    compare(&mut model, Comparison::Fresh);
    settle(&mut model);
    for (k, &point) in left_out.iter().enumerate() {
        model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
        complete(&mut model);
        let now = 10.0 * (k + 1) as f64;
        model.advance_overlays(now);
        let all = DiskMeasure::fresh(domain.samples().points(), point, anchor);
        assert_eq!(
            model.overlay_state().disk_comparison.error(DiskWay::Fresh),
            None,
            "{point}: all samples give {:?}",
            all.err()
        );
        let samples = found(&model, DiskWay::Fresh).samples;
        settle(&mut model);
        let error = model.overlay_state().disk_comparison.error(DiskWay::Fresh);
        println!("{point}: {samples:?} while it moves, then {error:?}");
        assert_eq!(error.is_some(), all.is_err(), "only what all samples leave out is refused");
    }
}

#[test]
fn a_failed_comparison_is_reported_and_the_map_stays() {
    // 40 samples of a spiral: the curve of geodesics through them strays from the outline.
    let mut model = model(Preset::Spiral, Preset::Disk, 40);
    compare(&mut model, Comparison::Fresh);
    let domain = std::sync::Arc::clone(model.domain(Side::Source).unwrap());
    let tries = domain
        .mesh()
        .vertices()
        .iter()
        .filter_map(|&vertex| model.interior_near(Side::Source, vertex))
        .collect::<Vec<_>>();
    let failed = tries.into_iter().find_map(|point| {
        model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
        complete(&mut model);
        settle(&mut model);
        model.overlay_state().disk_comparison.error(DiskWay::Fresh).map(Message::english)
    });
    let error = failed.unwrap();
    assert!(error.starts_with("The way through the disk fails on the source: the point ("), "{error}");
    assert!(model.map().is_some() && model.overlay_state().disk_comparison.all_found().next().is_none());
}

/// A model whose walks have run for one second at this speed.
fn walked(speed: f64) -> Model {
    let mut model = model(Preset::Gingerbread, Preset::Heart, 300);
    model.act_on_walks(WalkAction::Speed(speed));
    model.act_on_walks(WalkAction::Toggle);
    for frame in 0..=60 {
        assert_eq!(model.advance_overlays(f64::from(frame) / 60.0), Some(0.0));
    }
    model
}

#[test]
fn walks_are_counted_at_their_speed_and_follow_the_measure() {
    // 25 walks per frame: few enough that the time limit of a frame is never reached
    let model = walked(1500.0);
    let walks = &model.overlay_state().walks;
    let count = walks.count();
    assert!((1499..=1500).contains(&count), "{count} walks in a second");
    let curve = walks.cumulative().unwrap();
    assert_eq!((curve.points.len(), curve.points[BINS]), (BINS + 1, [1.0, 1.0]));
    let largest = walks.bars().iter().map(|bar| bar.expected).fold(0.0, f64::max);
    assert_eq!(largest, 1.0);
    // Kolmogorov's statistic exceeds 1.63 once in 100 seeds; 3e-3 for the kernel's own error.
    let deviation = walks.deviation().unwrap();
    assert!(deviation < 1.63 / (count as f64).sqrt() + 3e-3, "{deviation}");
}

#[test]
fn the_bins_hold_every_walk_and_equal_seeds_walk_alike() {
    let [a, b] = [(); 2].map(|()| walked(100.0));
    let (a, b) = (&a.overlay_state().walks, &b.overlay_state().walks);
    let share: f64 = a.cumulative().unwrap().points.windows(2).map(|pair| pair[1][1] - pair[0][1]).sum();
    assert!((share - 1.0).abs() < 1e-12 && a.count() > 90, "{share} of {}", a.count());
    assert_eq!((a.count(), a.bars()), (b.count(), b.bars()));
}

#[test]
fn a_slow_walk_is_seen_from_its_start_to_the_boundary() {
    let mut model = walked(1.0);
    let start = model.interior(Side::Source).unwrap();
    let mut ended = 0;
    for frame in 61..600 {
        model.advance_overlays(f64::from(frame) / 60.0);
        let (circles, hit) = model.overlay_state().walks.path();
        assert_eq!(circles[0].centre, start);
        for pair in circles.windows(2) {
            let jump = pair[0].centre.distance(pair[1].centre);
            assert!((jump - pair[0].radius).abs() < 1e-12, "a jump of {jump} in a circle of {}", pair[0].radius);
        }
        if let Some(hit) = hit {
            let last = circles[circles.len() - 1];
            assert!(hit.distance(last.centre) <= last.radius + 1e-12);
            ended += 1;
        }
    }
    assert!(ended > 30, "{ended}");
}

#[test]
fn another_start_begins_anew_and_a_pause_keeps_the_counts() {
    let mut model = walked(500.0);
    let count = model.overlay_state().walks.count();
    model.act_on_walks(WalkAction::Toggle);
    assert_eq!((model.advance_overlays(2.0), model.overlay_state().walks.count()), (None, count));
    let point = model.interior(Side::Target).unwrap() + DVec2::new(0.02, 0.0);
    model.dispatch(Command::MoveInterior { side: Side::Target, point: point.into() }, 0.0);
    complete(&mut model);
    assert_eq!(model.advance_overlays(2.1), None);
    assert_eq!(model.overlay_state().walks.count(), count, "walks do not start at x₂");
    model.dispatch(Command::MoveAnchor { side: Side::Source, fraction: 0.3 }, 0.0);
    complete(&mut model);
    model.advance_overlays(2.2);
    assert_eq!(model.overlay_state().walks.count(), 0);
}

#[test]
fn walks_and_comparison_wait_while_a_coarse_map_stands_in() {
    let mut model = walked(500.0);
    compare(&mut model, Comparison::Fresh);
    model.advance_overlays(1.0);
    let (count, samples) = (model.overlay_state().walks.count(), found(&model, DiskWay::Fresh).samples);
    model.update_ms = 0.0;
    for step in 1..4 {
        let point = model.domain(Side::Target).unwrap().default_point() + DVec2::new(0.01 * f64::from(step), 0.0);
        model.dispatch(Command::MoveInterior { side: Side::Target, point: point.into() }, 0.0);
        model.refresh(true);
    }
    let is_coarse = |model: &Model| {
        !std::sync::Arc::ptr_eq(model.map().unwrap().domain(Side::Source).unwrap(), model.domain(Side::Source).unwrap())
    };
    assert!(is_coarse(&model));
    assert_eq!((model.advance_overlays(1.1), model.overlay_state().walks.count()), (None, count));
    assert_eq!(found(&model, DiskWay::Fresh).samples, samples);
    while model.is_pending() {
        assert_eq!((model.advance_overlays(1.1), is_coarse(&model)), (None, true));
        complete(&mut model);
    }
    assert!(!is_coarse(&model));
    assert_eq!(model.advance_overlays(1.2), Some(0.0));
    assert!(model.overlay_state().walks.count() >= count, "x₁ did not move");
}

#[test]
fn the_pattern_is_pushed_forward_or_pulled_back_either_way_the_map_goes() {
    let mut model = model(Preset::Heart, Preset::Disk, 120);
    for direction in [Direction::Backward, Direction::Forward] {
        for home in Side::BOTH {
            let before = (model.session().direction(), model.session().texture_side());
            model.dispatch(Command::SetDirection(direction), 0.0);
            model.dispatch(Command::SetTextureSide(home), 0.0);
            assert_eq!(model.refresh(false).meshes, before != (direction, home), "{direction:?}, {home}");
            let map = model.map().unwrap();
            let at_home = pattern::geometry(&model, home).unwrap();
            assert_eq!(at_home.positions, at_home.texture_coordinates);
            assert_eq!(pattern::moved(&model, home), None);
            // Away from the pattern's side, the texture coordinates are points of the other side.
            let away = pattern::geometry(&model, home.other()).unwrap();
            assert_eq!(away.check(), Ok(()));
            let mapped = direction.mapped_side();
            assert_eq!(away.triangles, map.mapped().triangles());
            let (own, images) = if mapped == home {
                (away.texture_coordinates, away.positions)
            } else {
                (away.positions, away.texture_coordinates)
            };
            assert_eq!(
                (own, images),
                (map.mapped().domain().unwrap().mesh().vertices(), map.images()),
                "{direction:?}, {home}"
            );
            let expected =
                if mapped == home { Moved::Positions(map.images()) } else { Moved::Coordinates(map.images()) };
            assert_eq!(pattern::moved(&model, home.other()), Some(expected));
        }
    }
}

#[test]
fn the_conformal_pattern_follows_a_drag_on_both_sides() {
    let mut model = model(Preset::Heart, Preset::Disk, 120);
    model.dispatch(Command::SetTexture(TextureKind::Conformal), 0.0);
    assert!(model.refresh(false).meshes);
    let before = PerSide::from_fn(|side| pattern::geometry(&model, side).unwrap().texture_coordinates.to_vec());
    for side in Side::BOTH {
        assert_eq!(pattern::geometry(&model, side).unwrap().check(), Ok(()));
        let farthest = before[side].iter().map(|g| g.length()).fold(0.0, f64::max);
        assert!((farthest - 1.0).abs() < 1e-9, "{side}: {farthest}");
    }
    let point = model.interior(Side::Source).unwrap() + DVec2::new(0.05, 0.0);
    model.dispatch(Command::MoveInterior { side: Side::Source, point: point.into() }, 0.0);
    assert!(model.refresh(false).images);
    let after = PerSide::from_fn(|side| pattern::geometry(&model, side).unwrap().texture_coordinates.to_vec());
    assert_ne!(before.source, after.source);
    assert_eq!(before.target, after.target, "the target's point did not move");
}
