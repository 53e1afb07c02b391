//! Best maps that are known exactly (disk, ellipse), and the landscape against maps that are measured.

use super::*;
use crate::conformal::{
    ConformalMap, Constraints, Direction, MapSettings, PerSide, PrepareSettings, PreparedSide, Side, prepare,
};
use crate::geometry::{DVec2, SimplePolygon, Symmetries};
use crate::laplace::Deadline;
use crate::outline::Preset;
use std::sync::Arc;

fn prepared(preset: Preset) -> Arc<PreparedSide> {
    Arc::new(prepare(preset.outline().polygon(), &PrepareSettings::default(), &mut |_| {}).unwrap())
}

fn ellipse() -> Arc<PreparedSide> {
    let point = |k: u32| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 400.0) * DVec2::new(2.0, 1.0);
    let polygon = SimplePolygon::try_from((0..400).map(point).collect::<Vec<_>>()).unwrap();
    Arc::new(prepare(&polygon, &PrepareSettings::default(), &mut |_| {}).unwrap())
}

fn plane(side: &PreparedSide) -> DVec2 {
    side.default_point().in_plane().unwrap()
}

fn optimized(
    sides: &PerSide<Arc<PreparedSide>>,
    criterion: Criterion,
    start: Constraints,
    direction: Direction,
) -> Found {
    let mut search = Optimization::new(sides.clone(), criterion, start, direction.into());
    let time = std::time::Instant::now();
    assert!(search.advance(Deadline::NEVER).unwrap());
    let found = search.found().unwrap().clone();
    println!(
        "{}: {:.6} → {:.6} after {} values, {} ms: {:?}",
        search.criterion().name(),
        found.before,
        found.after,
        search.evaluations(),
        time.elapsed().as_millis(),
        found.constraints
    );
    found
}

/// Of all maps of a disk onto itself those without distortion are the turns.
#[test]
fn the_best_map_of_a_disk_onto_itself_is_a_turn() {
    let disk = prepared(Preset::Disk);
    let middle = plane(&disk);
    let radius = disk.domain().unwrap().samples().points()[0].distance(middle);
    let start = Constraints::new((middle + DVec2::new(0.4, -0.2) * radius, 0.1), (middle, 0.0));
    let sides = PerSide::new(Arc::clone(&disk), disk);
    let found = optimized(&sides, Criterion::Area, start, Direction::Forward);
    assert!(found.before > 0.5 && found.after < 1e-5, "{found:?}");
    let found = optimized(&sides, Criterion::Scale, start, Direction::Backward);
    assert!(found.before > 2.0 && found.after < 1.01, "{found:?}");
}

/// An ellipse is symmetric about its center, so that the best map onto a disk takes center to center.
#[test]
fn the_best_map_of_an_ellipse_onto_a_disk_is_that_from_its_center() {
    let sides = PerSide::new(ellipse(), prepared(Preset::Disk));
    let start = Constraints::new((DVec2::new(1.2, 0.3), 0.1), (plane(&sides.target), 0.4));
    let found = optimized(&sides, Criterion::Area, start, Direction::Forward);
    let map = ConformalMap::new(
        Arc::clone(&sides.source),
        Arc::clone(&sides.target),
        &found.constraints,
        MapSettings::from(Direction::Forward),
    )
    .unwrap();
    let off = map.image_of(DVec2::ZERO).unwrap().distance(plane(&sides.target));
    assert!(found.after < 0.5 * found.before && off < 0.02, "the center is off by {off}: {found:?}");
    // the turn does not matter, up to the mesh's error
    let unturned = Constraints { anchors: start.anchors, ..found.constraints };
    let map =
        ConformalMap::new(Arc::clone(&sides.source), Arc::clone(&sides.target), &unturned, Direction::Forward.into())
            .unwrap();
    let value = Criterion::Area.measure(&map).unwrap();
    assert!(
        (value - found.after).abs() < 1e-3 * found.after,
        "{value} with the boundary points of the start: {found:?}"
    );
}

/// Onto a disk with x₂ in its middle, the landscape is lowest where the best map has x₁, and each value is that of the map.
#[test]
fn the_landscape_is_lowest_where_the_best_map_has_its_point() {
    let sides = PerSide::new(ellipse(), prepared(Preset::Disk));
    let start = Constraints::new((DVec2::new(1.2, 0.3), 0.1), (plane(&sides.target), 0.4));
    let mut landscape = Landscape::new(&sides, Criterion::Area, start, Side::Source).unwrap();
    while !landscape.advance(Deadline::in_ms(1.0)) {}
    let Marks { lowest, least, .. } = landscape.marks().unwrap();
    assert!(lowest.length() < 0.05, "{lowest}");
    let vertices = landscape.domain().mesh().vertices();
    let inner = vertices.iter().zip(landscape.values()).filter(|(x, _)| x.length() < 0.5).step_by(50);
    for (&x, &value) in inner {
        let at = start.with_point(Side::Source, x);
        let [source, target] = [&sides.source, &sides.target].map(Arc::clone);
        let map = ConformalMap::new(source, target, &at, MapSettings::from(Direction::Forward)).unwrap();
        let measured = Criterion::Area.measure(&map).unwrap();
        assert!((measured - value).abs() < 0.1 * measured, "at {x}: {value}, measured {measured}");
    }
    let line = landscape.level_line(1.5 * least);
    let ends = |x: DVec2| line.iter().flatten().filter(|y| y.distance(x) < 1e-12).count();
    assert!(line.len() > 20 && line.iter().all(|[a, b]| ends(*a) == 2 && ends(*b) == 2), "a closed line");
}

/// The search and the landscape over x₁ with the other points of its result say the same of the same map, though the one is
/// of the map itself and the other in closed form.
#[test]
fn the_landscape_s_least_value_is_that_of_the_best_map() {
    for (presets, criterion, most) in [
        ([Preset::Gingerbread, Preset::Heart], Criterion::Area, 0.01),
        ([Preset::LShape, Preset::Star], Criterion::Area, 0.01),
        ([Preset::Heart, Preset::Disk], Criterion::Scale, 0.03),
    ] {
        let sides = PerSide::from(presets.map(prepared));
        let start = Constraints::new((sides.source.default_point(), 0.0), (sides.target.default_point(), 0.0));
        let found = optimized(&sides, criterion.clone(), start, Direction::Forward);
        let mut landscape = Landscape::new(&sides, criterion, found.constraints, Side::Source).unwrap();
        assert!(landscape.advance(Deadline::NEVER));
        let Marks { lowest, least, middle, worst } = landscape.marks().unwrap();
        println!("{presets:?}: {least} at {lowest}");
        assert!((least - found.after).abs() < most * found.after, "{least}, but {found:?}");
        assert!(least < middle && middle < worst);
    }
}

/// A search whose criterion is not what it minimizes: its course is of the criterion all the same.
#[test]
fn the_course_of_a_search_by_symmetry_goes_from_the_first_mismatch_to_the_last() {
    let presets = [Preset::Heart, Preset::Disk];
    let symmetries = PerSide::from(presets.map(|preset| Symmetries::of(preset.outline().polygon())));
    let criterion = Criterion::Symmetry(Arc::new(SharedSymmetries::new(&symmetries).unwrap()));
    let sides = PerSide::from(presets.map(prepared));
    let x1 = plane(&sides.source) + DVec2::new(0.1, 0.05);
    let start = Constraints::new((x1, 0.1), (plane(&sides.target), 0.0));
    let mut search = Optimization::new(sides, criterion, start, Direction::Forward.into());
    assert!(search.advance(Deadline::NEVER).unwrap());
    let (found, course) = (search.found().unwrap(), search.course());
    let [first, last] = [course.first(), course.last()].map(|each| each.unwrap().value);
    assert_eq!(first, found.before);
    assert!((last - found.after).abs() < 1e-5 && found.after < 0.05 * found.before, "{last}, {found:?}");
}
