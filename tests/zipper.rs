//! The map through the disk: against exact solutions, against riemap's own measure, and where it fails.

#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use riemap::conformal::{
    ConformalMap, Constraints, Direction, HarmonicMeasure, KernelScratch, PrepareSettings, PreparedDomain, Side,
    poisson_kernel, prepare,
};
use riemap::exact::{Complex, blob, disk, vshape};
use riemap::geometry::DVec2;
use riemap::mesh::{Sizing, locate};
use riemap::outline::{BoundaryPoint, Preset, Sampling};
use riemap::zipper::{DiskComparison, DiskMap, DiskMeasure, ZipperError};
use std::f64::consts::TAU;

const START: BoundaryPoint = BoundaryPoint { edge: 0, fraction: 0.0 };
const BLOB_CENTRE: DVec2 = DVec2::new(2.677_813_229_026_218, 2.466_851_711_366_240_7);
const V_POINT: DVec2 = DVec2::new(0.96, 0.8432);
const V_CENTRE: DVec2 = DVec2::new(0.0, -1.0);

/// `count` parameters on a closed curve, uniform in arc length from `t = 0`.
fn uniform_parameters(curve: impl Fn(f64) -> DVec2, period: f64, count: usize) -> Vec<f64> {
    // 2^17 chords: their length is that of the curve up to 1e-9
    let fine = 1 << 17;
    let at = |k: usize| period * k as f64 / fine as f64;
    let mut lengths = vec![0.0];
    for k in 0..fine {
        lengths.push(lengths[k] + curve(at(k)).distance(curve(at(k + 1))));
    }
    let place = |j: usize| {
        let s = lengths[fine] * j as f64 / count as f64;
        let k = lengths.partition_point(|&length| length <= s) - 1;
        at(k) + (s - lengths[k]) / (lengths[k + 1] - lengths[k]) * (at(1) - at(0))
    };
    (0..count).map(place).collect()
}

/// Points on the exact V, uniform in arc length from 1 + i, with their measures seen from `x`.
fn exact_v(count: usize, x: DVec2) -> (Vec<DVec2>, Vec<f64>) {
    let points: Vec<DVec2> =
        uniform_parameters(vshape::boundary, 4.0, count).into_iter().map(vshape::boundary).collect();
    let omega = points.iter().map(|&y| vshape::harmonic_measure(x, y)).collect();
    (points, omega)
}

/// Points on the exact blob, uniform in arc length from g⁻¹(1), with their measures seen from g⁻¹(0).
fn exact_blob(count: usize) -> (Vec<DVec2>, Vec<f64>) {
    let omega = uniform_parameters(blob::boundary, 1.0, count);
    (omega.iter().map(|&w| blob::boundary(w)).collect(), omega)
}

/// Maximum and mean error of the measures at the vertices.
fn errors(measure: &DiskMeasure, exact: &[f64]) -> (f64, f64) {
    let errors: Vec<f64> = exact.iter().enumerate().map(|(k, w)| (measure.at_vertex(k) - w).abs()).collect();
    (errors.iter().copied().fold(0.0, f64::max), errors.iter().sum::<f64>() / errors.len() as f64)
}

fn fresh_errors(name: &str, (points, exact): &(Vec<DVec2>, Vec<f64>), x: DVec2) -> (f64, f64) {
    let start = std::time::Instant::now();
    let measure = DiskMeasure::fresh(points, x, START).unwrap();
    let ms = start.elapsed().as_secs_f64() * 1e3;
    let (max, mean) = errors(&measure, exact);
    let (collapsed, disordered) = (measure.collapsed(), measure.disordered());
    let m = points.len();
    println!("{name}, m = {m}: max {max:.2e}, mean {mean:.2e}, {collapsed} collapsed, {disordered} disordered, {ms:.1} ms");
    (max, mean)
}

#[test]
fn v_shape_measure_converges_to_the_exact_one() {
    for count in [250, 500, 1000, 2000] {
        let (max, mean) = fresh_errors("V", &exact_v(count, V_POINT), V_POINT);
    }
}

#[test]
fn blob_measure_converges_to_the_exact_one() {
    for count in [250, 500, 1000, 2000] {
        let (max, mean) = fresh_errors("blob", &exact_blob(count), BLOB_CENTRE);
    }
}
