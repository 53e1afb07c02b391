//! Surfaces of few triangles are computed on finer ones: what comes out at their vertices is the surface's map.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use serde_json::Value;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use support::program::{file, folder, succeeds};

/// A regular octagon as one polygon: six triangles, without inner vertices.
fn octagon() -> String {
    let corner = |k: u32| {
        let (sin, cos) = (f64::from(k) * TAU / 8.0).sin_cos();
        format!("v {cos} {sin} 0\n")
    };
    (0..8).map(corner).collect::<String>() + "f 1 2 3 4 5 6 7 8\n"
}

/// Four unit squares in a row, each the next one's neighbor, in a plane or folded along their common edges.
fn strip(folded: bool) -> String {
    let (mut x, mut z, mut text) = (0.0, 0.0, String::new());
    for k in 0..5 {
        let _ = write!(text, "v {x} 0 {z}\nv {x} 1 {z}\n");
        let (sin, cos) = if folded { (0.7 * f64::from(k)).sin_cos() } else { (0.0, 1.0) };
        (x, z) = (x + cos, z + sin);
    }
    for k in 0..4 {
        let a = 2 * k + 1;
        let _ = writeln!(text, "f {} {} {} {}", a, a + 2, a + 3, a + 1);
    }
    text
}

/// The angles in degrees, in (−180, 180], of the images of the file's vertices in the unit disk.
fn angles(csv: &str) -> Vec<f64> {
    let angle = |line: &str| {
        let row: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        let [u, v] = row.last_chunk().unwrap();
        assert!((u.hypot(*v) - 1.0).abs() < 1e-6, "{line}");
        v.atan2(*u).to_degrees()
    };
    csv.lines().skip(1).map(angle).collect()
}

fn close(found: &[f64], expected: &[f64], what: &str) {
    assert_eq!(found.len(), expected.len());
    for (a, b) in found.iter().zip(expected) {
        let off = (a - b + 180.0).rem_euclid(360.0) - 180.0;
        assert!(off.abs() < 0.01, "{what}: {found:?}, expected {expected:?}");
    }
}

fn flattened(name: &str, surface: &str, point: &str) -> Vec<f64> {
    let folder = folder(name);
    let surface = file(&folder, "surface.obj", surface);
    let out = folder.join("uv.csv").display().to_string();
    succeeds(&["flatten", &surface, "preset:disk", "--surface-point", point, "--uv", "true", "--out", &out]);
    angles(&std::fs::read_to_string(out).unwrap())
}

/// In the order of the file; the middle of the strip is x₂.
const STRIP: [f64; 10] = [0.0, -0.86, 4.53, -5.39, 89.57, -90.43, 174.61, -175.46, 179.14, 180.0];

#[test]
fn polygons_without_inner_vertices_have_their_angles() {
    let expected: Vec<f64> = (0..8).map(|k| 45.0 * f64::from(k)).collect();
    close(&flattened("octagon", &octagon(), "0,0,0"), &expected, "octagon");
    close(&flattened("strip", &strip(false), "2,0.5,0"), &STRIP, "strip");
}

/// Vertex 2 is the middle fold's lower end, vertex 3 the upper one, so that the middle of the edge is a point of the file.
#[test]
fn a_folded_strip_has_the_angles_of_the_flat_one() {
    let text = strip(true);
    let rows: Vec<Vec<f64>> = (text.lines().filter(|line| line.starts_with('v')))
        .map(|line| line.split(' ').skip(1).map(|x| x.parse().unwrap()).collect())
        .collect();
    let middle = format!("{},0.5,{}", rows[4][0], rows[4][2]);
    close(&flattened("folded", &text, &middle), &STRIP, "folded strip");
}

#[test]
fn map_has_the_same_angles_and_an_error_that_covers() {
    let folder = folder("map");
    let surface = file(&folder, "octagon.obj", &octagon());
    let output = succeeds(&["map", &surface, "preset:disk", "--source-point", "0,0,0", "--json"]);
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(summary["counts"]["triangles"], 6);
    assert!(summary["counts"]["computed_triangles"].as_u64().is_some_and(|count| count > 1000), "{summary}");
    let out = folder.join("map.json").display().to_string();
    succeeds(&["map", &surface, "preset:disk", "--source-point", "0,0,0", "--out", &out]);
    let map: Value = serde_json::from_str(&std::fs::read_to_string(out).unwrap()).unwrap();
    let number = |value: &Value| value.as_f64().unwrap();
    let error = number(&map["error_estimate"]["image"]);
    assert!((1e-9..1e-3).contains(&error), "{error:e}");
    for (k, row) in map["boundary_map"].as_array().unwrap().iter().enumerate() {
        let (sin, cos) = (k as f64 * TAU / 8.0).sin_cos();
        let off = (number(&row[3]) - cos).hypot(number(&row[4]) - sin);
        assert!(off <= error, "vertex {k} is off by {off:e}, ± {error:e}");
    }
}

#[test]
fn without_subdivision_the_triangles_are_those_of_the_file() {
    let folder = folder("own");
    let surface = file(&folder, "octagon.obj", &octagon());
    let output = succeeds(&["flatten", &surface, "preset:disk", "--no-subdivision", "--json"]);
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(summary["counts"]["computed_triangles"].is_null(), "{summary}");
}

/// A flat square of 10 × 10 squares, with its corners pinned to those of a square: the identity up to scale.
#[test]
fn a_flat_square_with_pinned_corners_stays_as_it_is() {
    let folder = folder("square");
    let mut text = String::new();
    for k in 0..121 {
        let _ = writeln!(text, "v {} {} 0", k % 11, k / 11);
    }
    for k in (0..110).filter(|k| k % 11 < 10).map(|k| k + 1) {
        let _ = writeln!(text, "f {} {} {} {}", k, k + 1, k + 12, k + 11);
    }
    let surface = file(&folder, "plane.obj", &text);
    let square = file(&folder, "square.json", "[[0,0],[10,0],[10,10],[0,10]]");
    let out = folder.join("uv.csv").display().to_string();
    let pins = ["--pin", "0:0,0", "--pin", "10:10,0", "--pin", "120:10,10", "--pin", "110:0,10"];
    let arguments = ["flatten", &*surface, &*square, "--uv", "true", "--out", &*out];
    succeeds(&[&arguments[..], &pins].concat());
    let csv = std::fs::read_to_string(out).unwrap();
    assert_eq!(csv.lines().count(), 122, "no vertex is added");
    for line in csv.lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        let off = (row[0] - row[3]).hypot(row[1] - row[4]);
        assert!(off < 1e-3, "{line}");
    }
}
