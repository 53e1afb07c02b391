//! The loops stay inside the domains, close, and have constant speed.

use super::*;
use crate::conformal::{
    ConformalMap, Constraints, MapSettings, PrepareSettings, Side, SurfaceSettings, prepare, prepare_surface,
};
use crate::outline::Preset;
use crate::surface::{SurfaceMesh, SurfacePreset};
use std::f64::consts::PI;

fn map(presets: [Preset; 2]) -> (ConformalMap, Constraints) {
    let [source, target] = presets
        .map(|preset| Arc::new(prepare(preset.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap()));
    let constraints = Constraints::new((source.default_point(), 0.3), (target.default_point(), 0.0));
    (ConformalMap::new(source, target, &constraints, MapSettings::default()).unwrap(), constraints)
}

fn start<'a>(map: &'a ConformalMap, constraints: &Constraints) -> Start<'a> {
    Start::new(PerSide::from_fn(|side| (map.side(side), constraints.points[side])), map.measure(Side::Source))
}

#[test]
fn loops_begin_and_end_at_the_points_that_are_there() {
    let (map, constraints) = map([Preset::Gingerbread, Preset::Heart]);
    for path in Path::ALL {
        let way = Loop::new(path, &start(&map, &constraints)).unwrap();
        for t in [0.0, 1.0, -3.0] {
            let place = way.at(t);
            assert_eq!(place, way.at(0.0));
            for (found, begun) in place.interior.into_array().into_iter().zip(constraints.points.into_array()) {
                assert!(found.is_none_or(|found| found.distance(begun.in_plane().unwrap()) < 1e-12));
            }
            assert!(place.anchor.is_none_or(|s| (s - constraints.anchors.source).abs() < 1e-9), "{place:?}");
        }
        let near = way.at(1.0 - 1e-9);
        assert_eq!(near.interior.map(|p| p.is_some()), way.at(0.0).interior.map(|p| p.is_some()));
        let gaps = near
            .interior
            .into_array()
            .into_iter()
            .zip(way.at(0.0).interior.into_array())
            .filter_map(|(a, b)| Some(a?.distance(b?)));
        assert!(gaps.fold(0.0, f64::max) < 1e-6, "no jump at the end");
    }
}

/// For points anywhere in every preset, so that the map is defined along the whole circle.
#[test]
fn circles_stay_inside_with_a_quarter_of_their_radius_to_spare() {
    for preset in Preset::ALL {
        let domain = prepare(preset.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap();
        let size = domain
            .domain()
            .unwrap()
            .samples()
            .points()
            .iter()
            .map(|p| p.distance(domain.domain().unwrap().default_point()))
            .fold(0.0, f64::max);
        let places =
            domain.domain().unwrap().mesh().vertices()[domain.boundary_count()..].iter().copied().step_by(197).take(6);
        for point in places.chain([domain.domain().unwrap().default_point()]) {
            let circle = Circle::through(point, domain.domain().unwrap().samples());
            let radius = circle.radius();
            assert!(radius > 0.0, "{preset}: no circle through {point}");
            for k in 0..60 {
                let p = circle.at(f64::from(k) / 60.0);
                assert!(
                    crate::mesh::locate(domain.domain().unwrap().mesh(), p, None).is_some(),
                    "{preset}: {p} is outside"
                );
                let clearance = domain
                    .domain()
                    .unwrap()
                    .samples()
                    .position(domain.domain().unwrap().samples().nearest(p))
                    .distance(p);
                assert!(clearance >= 0.249 * radius, "{preset}: {clearance} beside a circle of {radius}");
            }
            assert!(radius < size);
        }
    }
}

#[test]
fn the_largest_circle_through_the_centre_of_a_disk_is_known() {
    let disk = prepare(Preset::Disk.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap();
    // 1 − r = 1.25 r
    let radius = Circle::through(DVec2::ZERO, disk.domain().unwrap().samples()).radius();
    assert!((radius - 4.0 / 9.0).abs() < 0.01, "{radius}");
}

/// From the center of a disk, harmonic measure is the angle.
#[test]
fn the_boundary_point_of_a_disk_turns_at_constant_speed() {
    let (map, constraints) = map([Preset::Disk, Preset::Square]);
    let constraints = constraints.with_point(Side::Source, DVec2::ZERO);
    let map = ConformalMap::new(
        Arc::clone(map.side(Side::Source)),
        Arc::clone(map.side(Side::Target)),
        &constraints,
        MapSettings::default(),
    )
    .unwrap();
    let way = Loop::new(Path::Boundary, &start(&map, &constraints)).unwrap();
    for k in 0..12 {
        let t = f64::from(k) / 12.0;
        let error = way.at(t).anchor.unwrap() - (0.3 + t).rem_euclid(1.0);
        assert!(error.abs() < 1e-3, "{t}: {error}");
    }
}

/// Turning y₁ by the measure t rotates the disk by 2πt: after half a loop the map is rotated by half a turn.
#[test]
fn halfway_around_the_disk_the_map_is_turned_by_half_a_turn() {
    let (map, constraints) = map([Preset::Disk, Preset::Disk]);
    let centred = constraints.with_point(Side::Source, DVec2::ZERO).with_point(Side::Target, DVec2::ZERO);
    let [source, target] = Side::BOTH.map(|side| Arc::clone(map.side(side)));
    let mut map = ConformalMap::new(source, target, &centred, MapSettings::default()).unwrap();
    let before = map.images()[0].to_angle();
    let way = Loop::new(Path::Boundary, &start(&map, &centred)).unwrap();
    let turned = centred.with_anchor(Side::Source, way.at(0.5).anchor.unwrap());
    map.update(&turned, MapSettings::default()).unwrap();
    let turn = (map.images()[0].to_angle() - before).rem_euclid(2.0 * PI);
    assert!((turn - PI).abs() < 1e-2, "{turn}");
}

#[test]
fn a_surface_has_no_planar_point_to_move() {
    let (map, constraints) = map([Preset::Disk, Preset::Square]);
    let hemisphere = SurfaceMesh::new(&SurfacePreset::Hemisphere.surface(40).unwrap()).unwrap();
    let surface = Arc::new(prepare_surface(hemisphere, SurfaceSettings::default(), &mut |_| ()).unwrap());
    let mut start = start(&map, &constraints);
    start.sides.target = (&surface, surface.default_point());
    assert!(Loop::new(Path::TargetPoint, &start).is_none());
    let place = Loop::new(Path::All, &start).unwrap().at(0.2);
    assert!(place.interior.source.is_some() && place.interior.target.is_none() && place.anchor.is_some());
}
