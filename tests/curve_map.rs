//! The boundary map between two curves at any point: Möbius maps of the disk, there and back, and next to corners.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use riemap::conformal::{
    ConformalMap, Constraints, Direction, KernelMode, PrepareSettings, PreparedSide, Side, prepare, prepare_curve,
};
use riemap::exact::{Complex, complex, disk, point};
use riemap::geometry::{CurvePoint, DVec2, Junction};
use riemap::outline::Preset;
use std::sync::Arc;

fn curved(preset: Preset, near: &[DVec2]) -> Arc<PreparedSide> {
    let (outline, curve) = (preset.outline(), preset.curve().unwrap());
    let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
    let side = prepare_curve((outline.polygon(), &curve), near, &settings, &mut |_| ()).unwrap();
    assert_eq!(side.unsharpened(), None, "{preset}");
    Arc::new(side)
}

fn map_of(sides: [&Arc<PreparedSide>; 2], constraints: &Constraints, direction: Direction) -> ConformalMap {
    ConformalMap::new(sides[0].clone(), sides[1].clone(), constraints, direction.into()).unwrap()
}

/// The inverse of [`disk::moebius`] with b = 1: 0 → `a` and 1 → 1.
fn from_disk(a: Complex, z: Complex) -> Complex {
    let u = z * (a - Complex::ONE) / (Complex::ONE - a.conj());
    (a - u) / (Complex::ONE - a.conj() * u)
}

#[test]
fn moebius_maps_of_the_disk_are_exact_at_any_point_both_ways() {
    let (a, b) = (DVec2::new(0.6, 0.2), DVec2::new(-0.3, -0.5));
    let unit = curved(Preset::Disk, &[a, b]);
    for direction in [Direction::Forward, Direction::Backward] {
        let map = map_of([&unit, &unit], &Constraints::new((a, 0.0), (b, 0.0)), direction);
        for (from, x, y) in [(Side::Source, a, b), (Side::Target, b, a)] {
            let curves = map.curve_map(from).unwrap();
            let (mut largest, mut uncovered) = (0.0f64, 0);
            let count = 997;
            for k in 0..count {
                let (piece, t) =
                    (k % curves.from_curve().pieces().len(), f64::from(k as u32) / f64::from(count as u32));
                let place = CurvePoint::new(piece, t);
                let z = complex(curves.from_curve().position(place));
                let exact = from_disk(complex(y), disk::moebius(complex(x), Complex::ONE, z));
                let off = curves.onto_curve().position(curves.image(place)).distance(point(exact));
                uncovered += usize::from(off > curves.error(place));
                largest = largest.max(off);
            }
            println!("{direction:?} from {from:?}: off by {largest:.1e}, {uncovered} of {count} not covered");
            assert!(largest < 1e-12 && uncovered * 20 < count, "{largest:e}, {uncovered}");
        }
    }
}

#[test]
fn there_and_back_is_the_identity_as_far_as_both_ends_are_conditioned() {
    for (source, target) in
        [(Preset::Heart, Preset::Disk), (Preset::Square, Preset::LShape), (Preset::Disk, Preset::Blob)]
    {
        let [a, b] = [source, target].map(|preset| curved(preset, &[]));
        let map =
            map_of([&a, &b], &Constraints::new((a.default_point(), 0.3), (b.default_point(), 0.6)), Direction::Forward);
        let [there, back] = Side::BOTH.map(|side| map.curve_map(side).unwrap());
        let count = there.from_curve().pieces().len();
        let mut largest = 0.0f64;
        for k in 0..400u32 {
            let place = CurvePoint::new(k as usize % count, f64::from(k) / 400.0);
            let image = there.image(place);
            let off = there.from_curve().position(back.image(image)).distance(there.from_curve().position(place));
            let (forward, backward) = there.measure_at(place);
            assert!((forward + backward - 1.0).abs() < 1e-11, "{source}: {forward} and {backward}");
            assert!(off <= back.error(image), "{source} → {target} at {place:?}: {off:e} for {:e}", back.error(image));
            largest = largest.max(off);
        }
        println!("{source} → {target} → {source}: off by {largest:.1e}");
    }
}

#[test]
fn breaks_are_in_order_and_hold_every_junction() {
    let side = curved(Preset::LShape, &[]);
    let constraints = Constraints::new((side.default_point(), 0.0), (side.default_point(), 0.0));
    let map = map_of([&side, &side], &constraints, Direction::Forward);
    let curves = map.curve_map(Side::Source).unwrap();
    let breaks = curves.from_breaks();
    assert_eq!(breaks, curves.onto_breaks());
    assert_eq!(breaks[0], CurvePoint::new(0, 0.0));
    for pair in breaks.windows(2) {
        let is_later = pair[1].piece() > pair[0].piece()
            || (pair[1].piece() == pair[0].piece()
                && (pair[1].from_start() > pair[0].from_start() || pair[1].to_end() < pair[0].to_end()));
        assert!(is_later, "{pair:?}");
    }
    for piece in 0..curves.from_curve().pieces().len() {
        let is_analytic = curves.from_curve().junctions()[piece] == Junction::Analytic;
        assert!(breaks.contains(&CurvePoint::new(piece, 0.0)), "the start of piece {piece}");
        let nearest = breaks.iter().filter(|b| b.piece() == piece && b.from_start() > 0.0);
        let nearest = nearest.map(CurvePoint::from_start).fold(1.0, f64::min);
        assert!(is_analytic || nearest < 1e-5, "towards the start of piece {piece}: {nearest}");
    }
}

/// Next to an anchor in a corner the measures are powers of the distance, as far as f64 reaches.
#[test]
fn next_to_an_anchor_in_a_corner_points_keep_apart() {
    let square = curved(Preset::Square, &[]);
    let disk = curved(Preset::Disk, &[]);
    // the curve begins in the middle of an edge
    let constraints = Constraints::new((DVec2::ZERO, 0.125), (DVec2::ZERO, 0.0));
    let map = map_of([&square, &disk], &constraints, Direction::Forward);
    let curves = map.curve_map(Side::Source).unwrap();
    let distances = || (4..=140).map(|k| 10f64.powi(-k));
    let after: Vec<f64> = distances().map(|t| curves.measure_at(CurvePoint::new(1, t)).0).collect();
    let before: Vec<f64> = distances().map(|t| curves.measure_at(CurvePoint::before_end(0, t)).1).collect();
    for (k, pair) in after.windows(2).chain(before.windows(2)).enumerate() {
        let ratio = pair[0] / pair[1];
        assert!((ratio / 100.0 - 1.0).abs() < 1e-5, "step {k}: {ratio}");
    }
    let back = map.curve_map(Side::Target).unwrap();
    for t in distances() {
        // the disk's anchor is where its parameter begins, and what is left of it there can be told apart
        let image = curves.image(CurvePoint::new(1, t));
        let again = back.image(image).from_start();
        assert!(image.from_start() > 0.0 && (again / t - 1.0).abs() < 1e-7, "{again:e} for {t:e} through {image:?}");
    }
    assert_eq!((map.continued_share(Side::Source), map.coinciding_edges()), (0.0, 0));
}

#[test]
fn finite_elements_have_no_map_of_curves() {
    let plain = Arc::new(prepare(Preset::Disk.outline().polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap());
    let sharp = curved(Preset::Disk, &[]);
    let constraints = Constraints::new((DVec2::ZERO, 0.0), (DVec2::ZERO, 0.0));
    let map = map_of([&plain, &sharp], &constraints, Direction::Forward);
    assert!(map.curve_map(Side::Source).is_none() && map.curve_map(Side::Target).is_none());
}
