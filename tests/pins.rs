//! Maps through three boundary pairs: Möbius maps of the disk, maps made anew from three of their boundary images, on
//! outlines and surfaces, crowded pairs, and pins that determine no map.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::{
    ConformalMap, Constraints, Direction, InteriorImage, InteriorPoint, KernelMode, PerSide, PinError, PinSearch, Pins,
    PrepareSettings, PreparedSide, Side, SurfaceSettings, prepare_curve, prepare_surface,
};
use riemap::exact::{Complex, complex};

use riemap::geometry::DVec2;
use riemap::laplace::Deadline;
use riemap::outline::Preset;
use riemap::surface::{SurfaceMesh, SurfacePreset};
use std::f64::consts::TAU;
use std::sync::Arc;
use support::program::{fails, succeeds};

fn outline(preset: Preset, kernel: KernelMode) -> Arc<PreparedSide> {
    near(preset, kernel, &[])
}

fn near(preset: Preset, kernel: KernelMode, points: &[DVec2]) -> Arc<PreparedSide> {
    let (outline, curve) = (preset.outline(), preset.curve().unwrap());
    let settings = PrepareSettings::default().with_kernel(kernel);
    Arc::new(prepare_curve((outline.polygon(), &curve), points, &settings, &mut |_| ()).unwrap())
}

fn surface(preset: SurfacePreset) -> Arc<PreparedSide> {
    let mesh = SurfaceMesh::new(&preset.surface(100).unwrap()).unwrap();
    Arc::new(prepare_surface(mesh, SurfaceSettings::default(), &mut |_| ()).unwrap())
}

fn pins<const N: usize>(pairs: [[f64; 2]; N]) -> Result<Pins, PinError> {
    Pins::new(pairs.map(PerSide::from))
}

fn pinned(sides: &[Arc<PreparedSide>; 2], pins: &Pins) -> (ConformalMap, Constraints) {
    let constraints = pins.constraints(PerSide::new(&sides[0], &sides[1]), None).unwrap();
    (mapped(sides, &constraints), constraints)
}

fn mapped(sides: &[Arc<PreparedSide>; 2], constraints: &Constraints) -> ConformalMap {
    ConformalMap::new(sides[0].clone(), sides[1].clone(), constraints, Direction::Forward.into()).unwrap()
}

fn largest(misses: Vec<f64>) -> f64 {
    misses.into_iter().fold(0.0, f64::max)
}

/// The fraction of the target's boundary onto which a fraction of the source's is mapped.
fn image(map: &ConformalMap, s: f64) -> f64 {
    map.boundary_image(Side::Source, s)
}

#[test]
fn between_disks_it_is_the_moebius_map_through_the_pins() {
    let disk = outline(Preset::Disk, KernelMode::Integral);
    let sides = [disk.clone(), disk];
    for (a, rotation) in
        [(Complex::new(0.3, -0.2), 0.4), (Complex::new(-0.8, 0.1), 3.0), (Complex::new(0.0, 0.99), 0.0)]
    {
        let moebius = |z: Complex| Complex::from_polar(1.0, rotation) * (z - a) / (1.0 - a.conj() * z);
        let pair = |s: f64| [s, moebius(Complex::from_polar(1.0, TAU * s)).arg().rem_euclid(TAU) / TAU];
        // the preset's first point is at angle 0
        let (map, constraints) = pinned(&sides, &pins([0.1, 0.45, 0.8].map(pair)).unwrap());
        let [x1, x2] = constraints.points.into_array().map(|point| complex(point.in_plane().unwrap()));
        let off = (moebius(x1) - x2).norm();
        let missed = largest(pins([0.1, 0.45, 0.8].map(pair)).unwrap().misses(&map));
        let moved = [0.02, 0.3, 0.6].map(|s| (image(&map, s) - pair(s)[1]).abs());
        println!("a = {a}: x off by {off:.1e}, pins by {missed:.1e}, others by {moved:?}");
        assert!(off < 1e-10 && missed < 1e-11 && moved.into_iter().all(|off| off.min(1.0 - off) < 1e-10));
    }
}

/// Three boundary images of a map determine it.
#[test]
fn a_map_made_anew_from_three_of_its_boundary_images_is_the_same() {
    use Preset::{Heart, LShape, Square, Star};
    for presets in [[LShape, Heart], [Square, Star], [Heart, LShape]] {
        let mut sides = presets.map(|preset| outline(preset, KernelMode::Integral));
        let defaults = sides.each_ref().map(|side| side.default_point());
        let map = mapped(&sides, &Constraints::new((defaults[0], 0.2), (defaults[1], 0.7)));
        let again = pins([0.05, 0.35, 0.6].map(|s| [s, image(&map, s)])).unwrap();
        let (_, constraints) = pinned(&sides, &again);
        for (k, point) in constraints.points.into_array().into_iter().enumerate() {
            let x = point.in_plane().unwrap();
            if !sides[k].equation().unwrap().resolves(x) {
                sides[k] = near(presets[k], KernelMode::Integral, &[x]);
            }
        }
        let (anew, constraints) = pinned(&sides, &again);
        let x1 = constraints.points.source.in_plane().unwrap();
        let InteriorImage::Inside(found) = map.interior_map(Side::Source).unwrap().image(x1) else { unreachable!() };
        let off = found.value.distance(constraints.points.target.in_plane().unwrap());
        let moved = (0..40).map(|k| f64::from(k) / 40.0);
        let moved = moved.map(|s| (image(&map, s) - image(&anew, s)).abs()).map(|off| off.min(1.0 - off));
        let moved = moved.fold(0.0, f64::max);
        let missed = largest(again.misses(&anew));
        println!("{presets:?}: x off by {off:.1e}, boundary by {moved:.1e} of its length, pins by {missed:.1e}");
        assert!(off < 1e-9 && moved < 1e-9 && missed < 1e-9);
    }
}

#[test]
fn finite_elements_meet_pins_too() {
    let sides = [Preset::LShape, Preset::Heart].map(|preset| outline(preset, KernelMode::Adjoint));
    let (map, _) = pinned(&sides, &pins([[0.1, 0.3], [0.4, 0.5], [0.8, 0.9]]).unwrap());
    let missed = largest(pins([[0.1, 0.3], [0.4, 0.5], [0.8, 0.9]]).unwrap().misses(&map));
    println!("missed by {missed:.1e}");
    assert!(missed < 1e-6);
}

#[test]
fn a_surface_s_map_made_anew_is_the_same() {
    let hemisphere = surface(SurfacePreset::Hemisphere);
    let disk = outline(Preset::Disk, KernelMode::Integral);
    for sides in [[hemisphere.clone(), disk.clone()], [disk, hemisphere.clone()], [hemisphere.clone(), hemisphere]] {
        let defaults = sides.each_ref().map(|side| side.default_point());
        let map = mapped(&sides, &Constraints::new((defaults[0], 0.1), (defaults[1], 0.4)));
        let again = pins([0.05, 0.35, 0.6].map(|s| [s, image(&map, s)])).unwrap();
        let (anew, constraints) = pinned(&sides, &again);
        let moved = (0..40).map(|k| f64::from(k) / 40.0);
        let moved = moved.map(|s| (image(&map, s) - image(&anew, s)).abs()).map(|off| off.min(1.0 - off));
        let moved = moved.fold(0.0, f64::max);
        let missed = largest(again.misses(&anew));
        println!("{constraints:?}: boundary off by {moved:.1e} of its length, pins by {missed:.1e}");
        assert!(moved < 1e-6 && missed < 1e-6);
    }
}

/// The map through pins, with the sides prepared for the points that come out.
fn resolved(presets: [Preset; 2], pins: &Pins) -> (ConformalMap, Constraints) {
    let mut sides = presets.map(|preset| outline(preset, KernelMode::Integral));
    for _ in 0..2 {
        let found = pins.constraints(PerSide::new(&sides[0], &sides[1]), None).unwrap();
        for (k, point) in found.points.into_array().into_iter().enumerate() {
            let x = point.in_plane().unwrap();
            if !sides[k].equation().unwrap().resolves(x) {
                sides[k] = near(presets[k], KernelMode::Integral, &[x]);
            }
        }
    }
    pinned(&sides, pins)
}

/// On either side, down to parts that no vertex of the mesh sees; the part has almost no measure from default points.
#[test]
fn pins_within_a_short_part_are_met() {
    use Preset::{Disk, Heart, LShape, Square, VShape};
    for presets in [[Heart, Disk], [Square, Disk], [LShape, Heart], [Disk, VShape]] {
        for gap in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6] {
            let pairs = [[0.33, 0.1], [0.33 + gap, 0.4], [0.33 + 3.0 * gap, 0.8]];
            for turned in [false, true] {
                let swap = |[s, t]: [f64; 2]| if turned { [t, s] } else { [s, t] };
                let pins = pins(pairs.map(swap)).unwrap();
                let presets = if turned { [presets[1], presets[0]] } else { presets };
                let (map, constraints) = resolved(presets, &pins);
                let missed = largest(pins.misses(&map));
                println!("{presets:?} {gap:e}: missed by {missed:.1e} from {:?}", constraints.points);
                assert!(missed < 1e-6);
            }
        }
    }
}

/// A pin in a part of which the other points' measures are below rounding is met whichever is given first.
#[test]
fn pins_in_crowded_parts_are_met_in_every_order() {
    use Preset::{LShape, Square, Star, Turkey, VShape};
    for (presets, [a, b, c]) in [
        ([LShape, VShape], [[0.3837, 0.9385], [0.8569, 0.1292], [0.9546, 0.5125]]),
        ([Square, VShape], [[0.0092, 0.969], [0.0223, 0.6865], [0.6495, 0.8812]]),
        ([Star, Turkey], [[0.1, 0.2], [0.4, 0.5], [0.8, 0.9]]),
    ] {
        for order in [[a, b, c], [b, c, a], [c, a, b], [c, b, a]] {
            let pins = pins(order).unwrap();
            let (map, _) = resolved(presets, &pins);
            let missed = largest(pins.misses(&map));
            println!("{presets:?} from {:?}: missed by {missed:.1e}", order[0]);
            assert!(missed < 1e-8);
        }
    }
}

#[test]
fn clockwise_pins_on_both_sides_are_in_order() {
    let sides = [Preset::Square, Preset::Disk].map(|preset| outline(preset, KernelMode::Integral));
    let clockwise = pins([[0.8, 0.6], [0.4, 0.3], [0.1, 0.9]]).unwrap();
    let (map, _) = pinned(&sides, &clockwise);
    assert!(largest(clockwise.misses(&map)) < 1e-10);
}

#[test]
fn pins_that_determine_no_map_are_refused_by_name() {
    let order = pins([[0.1, 0.1], [0.4, 0.8], [0.8, 0.4]]).unwrap_err();
    assert_eq!(order, PinError::Order { pins: [1, 2, 3], counter_clockwise: Side::Source });
    let same = pins([[0.1, 0.1], [0.4, 1.1], [0.8, 0.4]]).unwrap_err();
    assert_eq!(same, PinError::Coinciding { pins: [1, 2], side: Side::Target });
    let nowhere = pins([[0.1, 0.1], [0.4, 0.4], [f64::NAN, 0.8]]).unwrap_err();
    assert_eq!(nowhere, PinError::NotFinite { pin: 3, side: Side::Source });
    for error in [order, same, nowhere] {
        println!("{error}");
    }
}

#[test]
fn points_are_inside_of_their_sides() {
    let sides = [Preset::MapleLeaf, Preset::Gingerbread].map(|preset| outline(preset, KernelMode::Adjoint));
    for k in 0..12 {
        let s = f64::from(k) / 12.0;
        let pairs = [[s, 0.3], [s + 0.1, 0.35], [s + 0.5, 0.9]];
        let (_, constraints) = pinned(&sides, &pins(pairs).unwrap());
        for (side, point) in Side::BOTH.into_iter().zip(constraints.points.into_array()) {
            let InteriorPoint::Plane(x) = point else { unreachable!("outlines are planar") };
            assert!(sides[usize::from(side == Side::Target)].contains(x), "{side}: {x}");
        }
    }
}

#[test]
fn the_command_line_takes_three_pins_and_says_what_came_out() {
    let map = ["map", "preset:l-shape", "preset:heart", "--json"];
    let with = |pins: &[&'static str]| {
        let pins = pins.iter().flat_map(|&pin| ["--pin", pin]);
        map.into_iter().chain(pins).collect::<Vec<_>>()
    };
    let output = succeeds(&with(&["0,0:@0.3", "@0.05:@0.55", "@0.4:@0.9"]));
    let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let pins = summary["pins"].as_array().unwrap();
    assert_eq!((pins.len(), &pins[2]["source"], &pins[0]["target"]), (3, &0.4.into(), &0.3.into()));
    assert!(pins.iter().all(|pin| pin["miss"].as_f64().unwrap() < 1e-9), "{pins:?}");
    assert_eq!((&summary["source_anchor"], &summary["target_anchor"]), (&0.8125.into(), &0.3.into()));
    assert_eq!(summary["source_point"].as_array().unwrap().len(), 2);

    fails(&with(&["@0.1:@0.8", "@0.4:@0.5", "@0.8:@0.1"]), 1, &["a conformal map keeps the order"]);
    fails(&with(&["@0.1:@0.8", "@0.4:@0.5"]), 2, &["three pairs determine a map", "2 are"]);
    fails(&with(&["@0.1:@0.8", "@0.4:1,2,3", "@0.8:@0.1"]), 2, &["preset:heart", "an outline: vK, X,Y or @S"]);
}

/// Pins that a map meets are met by the map through any three of them.
#[test]
fn pins_of_one_map_are_all_met() {
    let sides = [Preset::LShape, Preset::Heart].map(|preset| outline(preset, KernelMode::Integral));
    let points = sides.each_ref().map(|side| side.default_point());
    let map = mapped(&sides, &Constraints::new((points[0], 0.3), (points[1], 0.6)));
    let seven = pins([0.02, 0.11, 0.3, 0.31, 0.55, 0.7, 0.93].map(|s| [s, image(&map, s)])).unwrap();
    let (anew, constraints) = pinned(&sides, &seven);
    let missed = largest(seven.misses(&anew));
    println!("{constraints:?}: missed by {missed:.1e}");
    assert!(missed < 1e-8);
}

/// The sum of squares is least: no map whose three degrees of freedom are changed a little misses less.
#[test]
fn pins_that_no_map_meets_are_missed_least() {
    let sides = [Preset::Square, Preset::Blob].map(|preset| outline(preset, KernelMode::Integral));
    let five = pins([[0.0, 0.1], [0.25, 0.3], [0.5, 0.55], [0.6, 0.62], [0.75, 0.95]]).unwrap();
    let (map, constraints) = pinned(&sides, &five);
    let sum = |map: &ConformalMap| five.misses(map).into_iter().map(|miss| miss * miss).sum::<f64>();
    let least = sum(&map);
    let x2 = constraints.points.target.in_plane().unwrap();
    for (change, anchor) in [
        (DVec2::new(1e-3, 0.0), 0.0),
        (DVec2::new(-1e-3, 0.0), 0.0),
        (DVec2::new(0.0, 1e-3), 0.0),
        (DVec2::new(0.0, -1e-3), 0.0),
        (DVec2::ZERO, 1e-3),
        (DVec2::ZERO, -1e-3),
    ] {
        let moved = constraints.with_point(Side::Target, x2 + change);
        let moved = moved.with_anchor(Side::Target, constraints.anchors.target + anchor);
        let other = sum(&mapped(&sides, &moved));
        println!("{change} {anchor}: {other:.9} against {least:.9}");
        assert!(other > least);
    }
}

/// The order of pins is checked among all of them.
#[test]
fn many_pins_need_one_order() {
    let crossed = pins([[0.1, 0.1], [0.3, 0.3], [0.5, 0.7], [0.6, 0.5]]).unwrap_err();
    assert_eq!(crossed, PinError::Order { pins: [1, 3, 4], counter_clockwise: Side::Source });
    assert_eq!(pins([[0.1, 0.1], [0.3, 0.3]]).unwrap_err(), PinError::Count { count: 2 });
}

/// Interrupted as often as it can be, the search finds the same constraints, bit for bit, or the same refusal.
#[test]
fn a_search_in_slices_is_the_search_at_once() {
    let square = outline(Preset::Square, KernelMode::Adjoint);
    let curve = outline(Preset::LShape, KernelMode::Integral);
    let dome = surface(SurfacePreset::Hemisphere);
    let three = pins([[0.1, 0.05], [0.4, 0.3], [0.8, 0.8]]).unwrap();
    let four = pins([[0.1, 0.05], [0.4, 0.3], [0.6, 0.65], [0.8, 0.8]]).unwrap();
    for (sides, pins) in [
        ([square.clone(), dome.clone()], three.clone()),
        ([dome.clone(), dome], four.clone()),
        ([square, curve.clone()], four),
        ([curve.clone(), curve], three),
    ] {
        let sides = PerSide::new(&*sides[0], &*sides[1]);
        let near = sides.map(PreparedSide::default_point);
        let whole = pins.constraints(sides, Some(near)).unwrap();
        let mut search = PinSearch::new(pins, near);
        let mut slices = 1;
        let found = loop {
            match search.advance(sides, Deadline::in_ms(0.0)) {
                Some(found) => break found.unwrap(),
                None => slices += 1,
            }
        };
        println!("{slices} slices");
        assert!(slices > 2 && found == whole, "{slices} slices: {found:?} instead of {whole:?}");
    }
}
