//! The best map of the family, against the way through the disk: a disk map by harmonic measure, followed by the best
//! Möbius transformation, found by brute force (what Boundary First Flattening offers: Sawhney & Crane 2018, section 6).

#![allow(missing_docs, clippy::unwrap_used, clippy::panic, reason = "tests")]

#[path = "../support/mod.rs"]
mod support;

mod by_hand;
#[cfg(feature = "app")]
mod command_line;
#[cfg(feature = "io")]
mod eggs;
#[cfg(feature = "io")]
mod shared_data;
mod through_disk;

use riemap::conformal::{ConformalMap, Constraints, Direction, PerSide, PrepareSettings, PreparedSide};
use riemap::geometry::{DVec2, Symmetries};
use riemap::laplace::Deadline;
use riemap::optimization::{Criterion, Dab, Found, Least, Optimization, OptimizeError, Region, SharedSymmetries};
use riemap::outline::{Preset, Sampling};
use std::sync::Arc;
use std::time::Instant;

/// At least as good, up to the digits in which values of the criterion differ with the rounding of a map's points.
const AS_GOOD: f64 = 1.0 + 1e-5;

fn outline(preset: Preset) -> Arc<PreparedSide> {
    support::domains::domain(preset, PrepareSettings::default())
}

/// With a mesh that is enough to tell maps apart.
fn coarse(preset: Preset) -> Arc<PreparedSide> {
    let mut settings = PrepareSettings::default();
    settings.sampling = Sampling::Adaptive { target: Some(200) };
    support::domains::domain(preset, settings)
}

fn search(
    sides: &PerSide<Arc<PreparedSide>>,
    criterion: Criterion,
    start: &Constraints,
    direction: Direction,
) -> Result<(Found, usize), OptimizeError> {
    let begin = Instant::now();
    let mut search = Optimization::new(sides.clone(), criterion, *start, direction.into());
    assert!(search.advance(Deadline::NEVER)?);
    let found = search.found().unwrap().clone();
    println!(
        "{}: {:.6} → {:.6} after {} values, {:.0} ms: {:?}",
        search.criterion().name(),
        found.before,
        found.after,
        search.evaluations(),
        begin.elapsed().as_secs_f64() * 1e3,
        found.constraints
    );
    assert_course_leads_to(&found, search.course());
    Ok((found, search.evaluations()))
}

/// The course begins with the criterion of the start and ends with that of the result, up to what boundary points that stay
/// may cost.
fn assert_course_leads_to(found: &Found, course: &[Least]) {
    let [first, last] = [course.first(), course.last()].map(|each| each.unwrap().value);
    assert!(first == found.before && (last - found.after).abs() <= 1e-3 * found.after + 1e-6, "{found:?}, {last}");
}

fn best(sides: &PerSide<Arc<PreparedSide>>, criterion: Criterion, start: &Constraints, direction: Direction) -> Found {
    search(sides, criterion, start, direction).unwrap().0
}

fn measured(sides: &PerSide<Arc<PreparedSide>>, criterion: &Criterion, at: &Constraints, direction: Direction) -> f64 {
    let map = ConformalMap::new(Arc::clone(&sides.source), Arc::clone(&sides.target), at, direction.into());
    map.ok().and_then(|map| criterion.measure(&map)).unwrap_or(f64::INFINITY) // such a map may not exist
}

fn defaults(sides: &PerSide<Arc<PreparedSide>>) -> Constraints {
    Constraints::new((sides.source.default_point(), 0.0), (sides.target.default_point(), 0.0))
}

#[test]
fn outlines_onto_the_disk_are_mapped_as_well_as_by_the_best_moebius_transformation() {
    for preset in [Preset::Heart, Preset::LShape, Preset::Gingerbread] {
        let source = outline(preset);
        let mesh = source.domain().unwrap().mesh();
        let disk = through_disk::Disk::of(&source);
        let (baseline, a) = disk.best(|images| through_disk::distortion(mesh, images));
        let sides = PerSide::new(Arc::clone(&source), outline(Preset::Disk));
        let found = best(&sides, Criterion::Area, &defaults(&sides), Direction::Forward);
        println!("{preset:?}: {:.6}, through the disk {baseline:.6}", found.after);
        assert!(found.after <= baseline * 1.003 && found.after <= found.before);
        // the same transformation, measured as maps are: no error of meshes in between
        let x2 = through_disk::point_of(a, &sides.target);
        let at = Constraints::new((sides.source.default_point(), 0.0), (x2, 0.0));
        let same = measured(&sides, &Criterion::Area, &at, Direction::Forward);
        println!("{preset:?}: {same:.6}, measured on the map");
        assert!(same.is_finite() && found.after <= same * AS_GOOD);
    }
}

/// Onto other outlines: all three degrees of freedom on a grid, and from its three best maps down to where no step leads
/// lower, all measured on the map. The search takes none of these steps.
#[test]
fn no_start_leads_to_a_better_map() {
    for (presets, direction) in [
        ([Preset::Heart, Preset::LShape], Direction::Forward),
        ([Preset::Blob, Preset::Gingerbread], Direction::Backward),
    ] {
        let sides = PerSide::from(presets.map(coarse));
        for criterion in [Criterion::Area, Criterion::Scale] {
            let found = best(&sides, criterion.clone(), &defaults(&sides), direction);
            let again = measured(&sides, &criterion, &found.constraints, direction);
            assert!((again - found.after).abs() < 1e-9 * again, "{again} is measured, {} was said", found.after);
            let ends = by_hand::ends(&sides, &criterion, direction);
            println!("{presets:?}: steps from a grid end at {ends:?}");
            let least = ends.iter().copied().fold(f64::INFINITY, f64::min);
            // four digits, to which the map is polished
            assert!(least.is_finite() && found.after <= least * (1.0 + 1e-3), "{} found, {least} by hand", found.after);
        }
    }
}

/// A region's areas are kept better than by the map that is best for the whole, and the rest is worse.
#[test]
fn a_region_is_mapped_better_than_by_the_best_map_of_the_whole() {
    let sides = PerSide::from([Preset::Gingerbread, Preset::Disk].map(coarse));
    let middle = sides.source.default_point().in_plane().unwrap() + DVec2::new(0.0, -0.15);
    let dab = Dab { middle: middle.extend(0.0), radius: 0.2 };
    let region = Criterion::Region(Arc::new(Region::of_dabs(vec![dab])));
    for direction in [Direction::Forward, Direction::Backward] {
        let whole = best(&sides, Criterion::Area, &defaults(&sides), direction);
        let part = best(&sides, region.clone(), &defaults(&sides), direction);
        let of_whole = measured(&sides, &region, &whole.constraints, direction);
        println!("{direction:?}: {:.6} in the region, {of_whole:.6} by the map that is best for the whole", part.after);
        assert!(part.after <= 1.001 * of_whole && part.after <= part.before);
    }
    let nowhere = Dab { middle: DVec2::splat(1e3).extend(0.0), radius: 0.2 };
    let nowhere = Criterion::Region(Arc::new(Region::of_dabs(vec![nowhere])));
    assert_eq!(search(&sides, nowhere, &defaults(&sides), Direction::Forward), Err(OptimizeError::EmptyRegion));
}

/// However the work is divided, the result is the same to the bit.
#[test]
fn in_pieces_the_result_is_the_same() {
    let sides = PerSide::from([Preset::Heart, Preset::Blob].map(coarse));
    let start = defaults(&sides);
    let (whole, count) = search(&sides, Criterion::Area, &start, Direction::Backward).unwrap();
    let mut pieces = Optimization::new(sides, Criterion::Area, start, Direction::Backward.into());
    let (mut steps, mut progress) = (0, 0.0);
    while !pieces.advance(Deadline::in_ms(0.0)).unwrap() {
        assert!(pieces.progress() >= progress, "{} after {progress}", pieces.progress());
        (steps, progress) = (steps + 1, pieces.progress());
    }
    assert_eq!((pieces.found(), pieces.evaluations()), (Some(&whole), count));
    assert!(steps > count / 2 && whole.after <= whole.before, "{steps} steps");
    assert!(pieces.course().windows(2).all(|pair| pair[0].evaluations <= pair[1].evaluations));
}

/// Places of the V's tip round to the circle, where walks among triangles without area may not end. Walks that begin there
/// found no way out: no map had constraints, and the search took 13 s.
#[test]
fn in_a_crowded_domain_a_better_map_is_found() {
    let sides = PerSide::from([Preset::VShape, Preset::Blob].map(outline));
    let found = best(&sides, Criterion::Area, &defaults(&sides), Direction::Backward);
    assert!(found.after < 0.8 * found.before, "{found:?}");
}

/// A start that is the best map already stays as it is.
#[test]
fn the_best_map_is_not_made_worse() {
    let sides = PerSide::from([Preset::Heart, Preset::Disk].map(coarse));
    let first = best(&sides, Criterion::Area, &defaults(&sides), Direction::Forward);
    let again = best(&sides, Criterion::Area, &first.constraints, Direction::Forward);
    assert!(again.after <= again.before && again.before == first.after, "{first:?}, then {again:?}");
}

/// A star and a cinquefoil share five reflections and the fifth of a turn; the heart, mirrored upright, one with the star.
/// Started anywhere, the map keeps them, up to the error of finite elements, and is the most even one of those.
#[test]
fn shared_symmetries_are_kept() {
    for (presets, most) in [
        ([Preset::Star, Preset::Cinquefoil], 5e-3),
        ([Preset::Heart, Preset::Star], 5e-3),
        ([Preset::Disk, Preset::Square], 5e-3),
    ] {
        let polygons = PerSide::from(presets.map(|preset| preset.outline().polygon().clone()));
        let shared = SharedSymmetries::new(&polygons.as_ref().map(Symmetries::of)).unwrap();
        let symmetry = Criterion::Symmetry(Arc::new(shared));
        let sides = PerSide::from(presets.map(outline));
        let [x1, x2] = sides.as_ref().map(|side| side.default_point().in_plane().unwrap()).into_array();
        let start = Constraints::new((x1 + DVec2::new(0.11, 0.07), 0.13), (x2, 0.31));
        let found = best(&sides, symmetry, &start, Direction::Forward);
        println!("{presets:?}: {:.2e}", found.after);
        assert!(found.after < most && found.after < 0.2 * found.before);
    }
    let unlike = [Preset::LShape, Preset::Blob].map(|preset| Symmetries::of(preset.outline().polygon()));
    println!("{unlike:?}");
    assert_eq!(SharedSymmetries::new(&PerSide::from(unlike)), Err(OptimizeError::NoSharedSymmetry));
}
