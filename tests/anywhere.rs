//! f and f′ at any point of either side, compared with exact maps: Möbius maps of the disk, square and disk, V-shape →
//! blob, z + 0.12 z⁵; there and back between presets; next to the boundary and to corners of either side.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use riemap::conformal::{
    ConformalMap, Constraints, Direction, InteriorImage, InteriorMap, KernelMode, NoInteriorMap, PrepareSettings,
    PreparedSide, Side, SurfaceSettings, prepare, prepare_curve, prepare_surface,
};
use riemap::exact::{Complex, blob, complex, point, square, vshape};
use riemap::geometry::{Curve, DVec2, Piece};
use riemap::outline::Preset;
use riemap::surface::{SurfaceMesh, SurfacePreset};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Distances from the boundary.
const DISTANCES: [f64; 7] = [0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9];

fn curved(preset: Preset, near: &[DVec2]) -> Arc<PreparedSide> {
    let (outline, curve) = (preset.outline(), preset.curve().unwrap());
    let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
    let side = prepare_curve((outline.polygon(), &curve), near, &settings, &mut |_| ()).unwrap();
    assert_eq!(side.unsharpened(), None, "{preset}");
    Arc::new(side)
}

fn map_of(sides: [&Arc<PreparedSide>; 2], constraints: &Constraints) -> ConformalMap {
    ConformalMap::new(sides[0].clone(), sides[1].clone(), constraints, Direction::Forward.into()).unwrap()
}

/// Errors of a map at points, and how its estimate covers them.
#[derive(Default)]
struct Comparison {
    errors: Vec<f64>,
    slopes: Vec<f64>,
    ratios: Vec<f64>,
}

impl Comparison {
    /// Adds a point with its exact image and derivative; a NaN is not compared.
    fn add(&mut self, map: &InteriorMap<'_>, z: DVec2, exact: [Complex; 2]) {
        let InteriorImage::Inside(found) = map.image(z) else { unreachable!("{z} is inside: {:?}", map.image(z)) };
        let error = (complex(found.value) - exact[0]).norm();
        self.errors.push(error);
        self.slopes.push((complex(found.derivative) - exact[1]).norm() / exact[1].norm());
        self.ratios.push(found.error / error);
    }

    /// Prints the largest errors; returns those of image and derivative, after checking the estimate.
    fn finish(mut self, name: &str) -> [f64; 2] {
        let largest = |values: &[f64]| values.iter().copied().filter(|v| v.is_finite()).fold(0.0, f64::max);
        let found = [largest(&self.errors), largest(&self.slopes)];
        let covered = self.ratios.iter().filter(|ratio| **ratio >= 1.0 || ratio.is_nan()).count();
        self.ratios.sort_by(f64::total_cmp);
        let (count, median) = (self.ratios.len(), self.ratios[self.ratios.len() / 2]);
        println!(
            "{name}: image off by {:.1e}, derivative by {:.1e}; {covered} of {count} covered, the estimate is {median:.0} times the error",
            found[0], found[1]
        );
        assert!(covered as f64 >= 0.95 * count as f64, "{name}: {covered} of {count} are covered");
        // measures of sides with corners are better than what is known about them, 4e-13
        assert!(median < 1e4, "{name}: the estimate is {median} times too large");
        found
    }
}

#[test]
fn moebius_maps_of_the_disk_are_right_everywhere() {
    let (a, b) = (DVec2::new(0.6, 0.2), DVec2::new(-0.3, -0.5));
    let unit = curved(Preset::Disk, &[a, b]);
    let map = map_of([&unit, &unit], &Constraints::new((a, 0.0), (b, 0.0)));
    for (from, x, y) in [(Side::Source, a, b), (Side::Target, b, a)] {
        let (x, y) = (complex(x), complex(y));
        let interior = map.interior_map(from).unwrap();
        println!("{} nodes", interior.node_count());
        let turn = |c: Complex| (Complex::ONE - c.conj()) / (Complex::ONE - c);
        let to_zero = |z: Complex| turn(x) * (z - x) / (Complex::ONE - x.conj() * z);
        let exact = |z: Complex| {
            let u = to_zero(z) / turn(y);
            (u + y) / (Complex::ONE + y.conj() * u)
        };
        let slope = |z: Complex| {
            let u = to_zero(z) / turn(y);
            let du = turn(x) / turn(y) * (1.0 - x.norm_sqr()) / (Complex::ONE - x.conj() * z).powi(2);
            du * (1.0 - y.norm_sqr()) / (Complex::ONE + y.conj() * u).powi(2)
        };
        let mut comparison = Comparison::default();
        for k in 0..300 {
            for d in DISTANCES {
                let z = (1.0 - d) * Complex::cis(0.7 * f64::from(k));
                comparison.add(&interior, point(z), [exact(z), slope(z)]);
            }
        }
        let [image, derivative] = comparison.finish("Möbius");
        assert!(image < 1e-12 && derivative < 1e-10, "{image:e}, {derivative:e}");
    }
}

/// z + 0.12 z⁵ of the unit disk, as one analytic curve.
fn fifth_power() -> Curve {
    fn jet(s: f64) -> riemap::geometry::Jet {
        let [one, five] = [Complex::cis(TAU * s), Complex::cis(5.0 * TAU * s)];
        let i = Complex::I * TAU;
        riemap::geometry::Jet {
            position: point(one + 0.12 * five),
            first: point(i * (one + 0.6 * five)),
            second: point(i * i * (one + 3.0 * five)),
        }
    }
    Curve::new(vec![Piece::Formula { function: jet, from: 0.0, to: 1.0 }]).unwrap().analytic_at(0).unwrap()
}

#[test]
fn the_fifth_power_and_its_inverse_are_right_everywhere() {
    let curve = fifth_power();
    let count = 600;
    let vertices: Vec<DVec2> =
        (0..count).map(|k| curve.pieces()[0].jet(f64::from(k) / f64::from(count)).position).collect();
    let polygon = riemap::geometry::SimplePolygon::try_from(vertices).unwrap();
    let settings = PrepareSettings::default().with_kernel(KernelMode::Integral);
    let flower = Arc::new(prepare_curve((&polygon, &curve), &[DVec2::ZERO], &settings, &mut |_| ()).unwrap());
    assert_eq!(flower.unsharpened(), None);
    let unit = curved(Preset::Disk, &[DVec2::ZERO]);
    let map = map_of([&unit, &flower], &Constraints::new((DVec2::ZERO, 0.0), (DVec2::ZERO, 0.0)));
    let f = |z: Complex| z + 0.12 * z.powi(5);
    let slope = |z: Complex| Complex::ONE + 0.6 * z.powi(4);
    let [there, back] = Side::BOTH.map(|side| map.interior_map(side).unwrap());
    let (mut forward, mut backward) = (Comparison::default(), Comparison::default());
    for k in 0..200 {
        for d in DISTANCES {
            let z = (1.0 - d) * Complex::cis(0.7 * f64::from(k));
            forward.add(&there, point(z), [f(z), slope(z)]);
            backward.add(&back, point(f(z)), [z, slope(z).inv()]);
        }
    }
    let [forward, backward] = [forward.finish("disk → z + 0.12 z⁵"), backward.finish("z + 0.12 z⁵ → disk")];
    assert!(forward[0] < 1e-12 && backward[0] < 2e-12, "{forward:?}, {backward:?}");
    assert!(forward[1] < 1e-9 && backward[1] < 1e-9, "{forward:?}, {backward:?}");
}

#[test]
fn square_to_disk_and_back_are_right_at_corners() {
    let (quad, unit) = (curved(Preset::Square, &[DVec2::ZERO]), curved(Preset::Disk, &[DVec2::ZERO]));
    let corner = quad.domain().unwrap().samples().points().iter().fold(0.0f64, |most, p| most.max(p.x));
    println!("half side {corner}");
    let fraction = quad.curve_boundary().unwrap().nearest_fraction(DVec2::new(corner, 0.0), 0.01);
    let map = map_of([&quad, &unit], &Constraints::new((DVec2::ZERO, fraction), (DVec2::ZERO, 0.0)));
    let [there, back] = Side::BOTH.map(|side| map.interior_map(side).unwrap());
    println!("{} and {} nodes", there.node_count(), back.node_count());
    let (mut forward, mut backward) = (Comparison::default(), Comparison::default());
    for k in 0..400 {
        let angle = 0.1 + 0.7 * f64::from(k);
        let ray = DVec2::from_angle(angle);
        let rim = ray / ray.abs().max_element();
        for d in DISTANCES {
            let z = (1.0 - d) * rim;
            if DVec2::ONE.distance(z.abs()) < 0.01 {
                continue; // the closed form is 0/0 at a corner
            }
            let w = square::to_disk(complex(z));
            forward.add(&there, corner * z, [w, Complex::new(f64::NAN, 0.0)]);
            backward.add(&back, point(w), [corner * complex(z), Complex::new(f64::NAN, 0.0)]);
        }
    }
    let [forward, backward] = [forward.finish("square → disk"), backward.finish("disk → square")];
    assert!(forward[0] < 1e-12, "{forward:?}");
    assert!(backward[0] < 1e-11, "{backward:?}");
}

/// The map of the V onto the disk with `x` → 0, up to a rotation: with c = h₂(z) artanh r,
/// r sinh(c − c₀)/(cosh(c − c̄₀) − (1 − r²) cosh c cosh c̄₀), in which nothing cancels in the tips either.
fn v_to_disk(x: DVec2, z: DVec2) -> Complex {
    let epsilon = (-12.5 * PI).exp();
    let length = 0.5 * ((2.0 - epsilon) / epsilon).ln();
    let strip = |z: DVec2| {
        let root = (8.0 * Complex::I * complex(z) - 7.0).sqrt();
        0.25 * length * Complex::I * (1.0 - root)
    };
    let (c, at) = (strip(z), strip(x));
    let back = at.conj();
    (c - at).sinh() / ((c - back).cosh() - epsilon * (2.0 - epsilon) * c.cosh() * back.cosh())
}

#[test]
fn v_shape_to_blob_is_right_in_the_tips() {
    let (x, center) = (DVec2::new(0.96, 0.8432), blob::from_disk(Complex::ZERO));
    let (v, round) = (curved(Preset::VShape, &[x]), curved(Preset::Blob, &[point(center)]));
    let starts = [&v, &round].map(|side| side.curve_boundary().unwrap().curve().pieces()[0].jet(0.0).position);
    assert!(starts[1].distance(blob::boundary(0.0)) < 1e-14);
    let map = map_of([&v, &round], &Constraints::new((x, 0.0), (point(center), 0.0)));
    let start = std::time::Instant::now();
    let there = map.interior_map(Side::Source).unwrap();
    println!("{} nodes in {:?}", there.node_count(), start.elapsed());
    let turn = v_to_disk(x, starts[0]).conj();
    let turn = turn / turn.norm();
    let mut comparison = Comparison::default();
    for k in 0..200 {
        let jet = if k % 2 == 0 { vshape::around_right_tip } else { vshape::around_left_tip };
        let jet = jet(f64::from(k) / 100.0 - 1.0);
        let inward = if k % 2 == 0 { jet.first.perp() } else { -jet.first.perp() };
        for d in DISTANCES.into_iter().filter(|&d| d < 0.03) {
            let z = jet.position + d * inward.normalize();
            let w = blob::from_disk(v_to_disk(x, z) * turn);
            comparison.add(&there, z, [w, Complex::new(f64::NAN, 0.0)]);
        }
    }
    let [image, _] = comparison.finish("V-shape → blob");
    assert!(image < 1e-10, "{image:e}");
}

#[test]
fn there_and_back_is_the_identity() {
    for (source, target) in [
        (Preset::Heart, Preset::Disk),
        (Preset::Square, Preset::LShape),
        (Preset::Disk, Preset::Blob),
        (Preset::LShape, Preset::VShape),
    ] {
        let [a, b] = [source, target].map(|preset| curved(preset, &[]));
        let map = map_of([&a, &b], &Constraints::new((a.default_point(), 0.3), (b.default_point(), 0.6)));
        let start = std::time::Instant::now();
        let [there, back] = Side::BOTH.map(|side| map.interior_map(side).unwrap());
        let nodes = [there.node_count(), back.node_count()];
        println!("{source} → {target}: {nodes:?} nodes in {:?}", start.elapsed());
        let start = std::time::Instant::now();
        let (mut count, mut largest, mut largest_slope, mut uncovered) = (0, 0.0f64, 0.0f64, 0);
        for triangle in a.triangles() {
            let mesh = a.domain().unwrap().mesh().vertices();
            let z = triangle.iter().map(|&v| mesh[v as usize]).sum::<DVec2>() / 3.0;
            let InteriorImage::Inside(image) = there.image(z) else { continue };
            let InteriorImage::Inside(again) = back.image(image.value) else {
                println!("{z} → {image:?} is not inside");
                continue;
            };
            let off = again.value.distance(z);
            let expected = again.error + image.error * again.derivative.length();
            count += 1;
            uncovered += usize::from(off > expected);
            largest = largest.max(off);
            let product = complex(image.derivative) * complex(again.derivative);
            largest_slope = largest_slope.max((product - 1.0).norm());
        }
        println!(
            "  {count} points in {:?}: off by {largest:.1e}, {uncovered} more than estimated, derivatives {largest_slope:.1e}",
            start.elapsed()
        );
        assert!(uncovered * 20 < count, "{uncovered} of {count}");
    }
}

#[test]
fn surfaces_are_refused() {
    let surface = SurfaceMesh::new(&SurfacePreset::ALL[0].surface(60).unwrap()).unwrap();
    let surface = Arc::new(prepare_surface(surface, SurfaceSettings::default(), &mut |_| ()).unwrap());
    let unit = curved(Preset::Disk, &[]);
    let constraints = Constraints::new((surface.default_point(), 0.0), (unit.default_point(), 0.0));
    let map = map_of([&surface, &unit], &constraints);
    assert_eq!(map.interior_map(Side::Target).unwrap_err(), NoInteriorMap::Surface { side: Side::Source });
}

#[test]
fn finite_elements_give_images_within_their_estimate() {
    let outline = Preset::Square.outline();
    let plain = Arc::new(prepare(outline.polygon(), &PrepareSettings::default(), &mut |_| ()).unwrap());
    let unit = curved(Preset::Disk, &[DVec2::ZERO]);
    let corner = plain.domain().unwrap().samples().points().iter().fold(0.0f64, |most, p| most.max(p.x));
    let fraction = plain.domain().unwrap().samples().nearest(DVec2::new(corner, 0.0));
    let anchor = plain.fraction_at(fraction);
    let constraints = Constraints::new((DVec2::ZERO, anchor), (DVec2::ZERO, 0.0));
    let map = map_of([&plain, &unit], &constraints);
    let [there, back] = Side::BOTH.map(|side| map.interior_map(side).unwrap());
    assert!(there.is_polygonal() && back.is_polygonal());
    let (mut forward, mut backward) = (Comparison::default(), Comparison::default());
    for k in 0..200 {
        let z = 0.98 * f64::from(k) / 200.0 * DVec2::from_angle(0.7 * f64::from(k));
        let step = 1e-5;
        let f = |z: DVec2| square::to_disk(complex(z));
        let slope = (f(z + DVec2::X * step) - f(z - DVec2::X * step)) / (2.0 * step * corner);
        forward.add(&there, corner * z, [f(z), slope]);
        backward.add(&back, point(f(z)), [corner * complex(z), slope.inv()]);
    }
    let [forward, backward] = [forward.finish("finite elements"), backward.finish("finite elements, inverse")];
    assert!(forward[0] < 5e-3 && backward[0] < 5e-3, "{forward:?}, {backward:?}");
    assert!(forward[1] < 0.05 && backward[1] < 0.05, "{forward:?}, {backward:?}");
    assert_eq!(there.image(DVec2::splat(10.0)), InteriorImage::Outside);
    let on = plain.domain().unwrap().samples().points()[3];
    assert!(matches!(there.image(on), InteriorImage::Boundary { .. }));
}

#[test]
fn exact_images_replace_the_harmonic_ones() {
    let (quad, unit) = (curved(Preset::Square, &[DVec2::ZERO]), curved(Preset::Disk, &[DVec2::ZERO]));
    let mut map = map_of([&unit, &quad], &Constraints::new((DVec2::ZERO, 0.0), (DVec2::ZERO, 0.125)));
    let before = map.images().to_vec();
    assert_eq!(map.extend_exactly(&mut |_| ()), Ok(0));
    let boundary = unit.boundary_count();
    assert_eq!(before[..boundary], map.images()[..boundary]);
    let vertices = unit.domain().unwrap().mesh().vertices();
    let back = map.interior_map(Side::Target).unwrap();
    let mut largest = 0.0f64;
    for (z, w) in vertices.iter().zip(map.images()).skip(boundary) {
        let InteriorImage::Inside(again) = back.image(*w) else { unreachable!("{w} is inside") };
        largest = largest.max(again.value.distance(*z));
    }
    let moved = before.iter().zip(map.images()).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
    println!("interior vertices there and back: {largest:.1e}; moved from the harmonic images by {moved:.1e}");
    assert!(largest < 1e-10 && moved > 1e-6, "{largest:e}, {moved:e}");
}
