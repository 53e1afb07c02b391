//! What sampling promises, on formulas and on outlines that people use.

use super::*;
use crate::mesh::{Sizing, mesh_domain};
use std::f64::consts::TAU;
use web_time::Instant;

fn polygon(points: Vec<DVec2>) -> SimplePolygon {
    SimplePolygon::try_from(points).unwrap()
}

fn disk(n: usize) -> SimplePolygon {
    polygon((0..n).map(|k| DVec2::from_angle(TAU * k as f64 / n as f64)).collect())
}

fn square() -> SimplePolygon {
    polygon([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(DVec2::from).to_vec())
}

/// The outlines of the test data, if they are there.
fn outlines() -> Vec<(String, SimplePolygon)> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/outlines");
    let Ok(entries) = std::fs::read_dir(&folder) else {
        println!("skipped: no outlines in {}", folder.display());
        return Vec::new();
    };
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
        .iter()
        .map(|path| {
            let json: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
            let mut points: Vec<DVec2> = serde_json::from_value::<Vec<[f64; 2]>>(json["points"].clone())
                .unwrap()
                .into_iter()
                .map(DVec2::from)
                .collect();
            let area: f64 = (0..points.len()).map(|k| points[k].perp_dot(points[(k + 1) % points.len()])).sum();
            if area < 0.0 {
                points[1..].reverse();
            }
            (path.file_stem().unwrap().to_string_lossy().into_owned(), polygon(points))
        })
        .collect()
}

#[test]
fn adaptive_samples_of_all_outlines_can_be_meshed() {
    let mut shapes = outlines();
    shapes.push(("disk".into(), disk(6000)));
    shapes.push(("square".into(), square()));
    for (name, shape) in shapes {
        for target in [None, Some(60), Some(300), Some(1000), Some(3000)] {
            let start = Instant::now();
            let samples = sample(&shape, Sampling::Adaptive { target }).unwrap();
            let time = start.elapsed();
            assert_eq!(samples.check_invariants(), Ok(()));
            let start = Instant::now();
            match mesh_domain(&samples.points, Sizing::default()) {
                Ok((mesh, report)) => println!(
                    "{name} ({}) {target:?}: m {} n {} +{} sample {time:.1?} mesh {:.1?}",
                    shape.vertices().len(),
                    samples.len(),
                    mesh.interior_count(),
                    report.added,
                    start.elapsed()
                ),
                Err(error) => println!("{name} {target:?} {}: {error}", samples.len()),
            }
        }
    }
}
