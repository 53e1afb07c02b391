//! `riemap project`: caps, whose ratio of scales is known, other regions against stereographic projections, conformality of
//! the table's points, overlaps, and what is refused.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::export::ProjectionFormat;
use riemap::geometry::{DVec2, DVec3};
use riemap::worker::ProjectionTask;
use serde_json::{Value, json};
use std::f64::consts::TAU;
use std::path::Path;
use support::program::{fails, file, folder, names, riemap, succeeds};

/// sec²15°.
const CAP: f64 = 1.071_796_769_724_49;

/// A circle of angular radius `radius` in degrees about a center, counter-clockwise, as `count` points of longitude and
/// latitude.
fn cap(center: [f64; 2], radius: f64, count: u32) -> Vec<[f64; 2]> {
    let [longitude, latitude] = center.map(f64::to_radians);
    let middle = DVec3::new(latitude.cos() * longitude.cos(), latitude.cos() * longitude.sin(), latitude.sin());
    let east = DVec3::new(-longitude.sin(), longitude.cos(), 0.0);
    let north = middle.cross(east);
    let (sine, cosine) = radius.to_radians().sin_cos();
    let point = |k: u32| {
        let angle = TAU * f64::from(k) / f64::from(count);
        let p = cosine * middle + sine * (angle.cos() * east + angle.sin() * north);
        [p.y.atan2(p.x).to_degrees(), p.z.asin().to_degrees()]
    };
    (0..count).map(point).collect()
}

/// A file with one polygon for each ring.
fn geojson(rings: &[Vec<[f64; 2]>]) -> String {
    let closed = |ring: &Vec<[f64; 2]>| {
        let mut ring = ring.clone();
        ring.push(ring[0]);
        vec![ring]
    };
    let polygons: Vec<_> = rings.iter().map(closed).collect();
    json!({
        "type": "Feature",
        "properties": { "name": "Test" },
        "geometry": { "type": "MultiPolygon", "coordinates": polygons }
    })
    .to_string()
}

/// A projection's summary.
struct Made {
    json: Value,
    notes: String,
}

impl Made {
    fn new(folder: &Path, rings: &[Vec<[f64; 2]>], more: &[&str]) -> Self {
        let path = file(folder, "region.geojson", &geojson(rings));
        let output = succeeds(&[&["project", &path, "--json"], more].concat());
        let json = serde_json::from_slice(&output.stdout).unwrap();
        Self { json, notes: String::from_utf8(output.stderr).unwrap() }
    }

    fn number(&self, key: &str) -> f64 {
        self.json[key].as_f64().unwrap()
    }
}

#[test]
fn a_cap_has_its_ratio_of_scales_wherever_it_is() {
    let folder = folder("caps");
    for center in [[0.0, 0.0], [10.0, 50.0], [-100.0, -35.0], [0.0, 90.0], [40.0, -80.0], [175.0, 20.0], [-179.0, 70.0]]
    {
        let made = Made::new(&folder, &[cap(center, 30.0, 2000)], &[]);
        let [ours, theirs] = ["scale_ratio", "stereographic_scale_ratio"].map(|key| made.number(key));
        println!(
            "{center:?}: off by {:e}, stereographic {:e}, said {:e}",
            ours - CAP,
            theirs - CAP,
            made.number("scale_ratio_error")
        );
        // edges are straight in longitude and latitude: near a pole they bulge out of the circle by 1e-6 of its radius
        assert!((ours / CAP - 1.0).abs() < 3e-7, "{center:?}: {ours}");
        assert!((theirs / CAP - 1.0).abs() < 3e-7 && ours <= theirs + 1e-14, "{center:?}: {ours} and {theirs}");
        assert_eq!(made.json["overlaps"], false);
        assert_eq!(made.json["name"], "Test");
    }
    for radius in [0.01_f64, 1.0, 60.0, 89.0] {
        let expected = (0.5 * radius.to_radians()).cos().powi(-2);
        let made = Made::new(&folder, &[cap([30.0, 10.0], radius, 2000)], &[]);
        let ours = made.number("scale_ratio");
        println!("{radius}: {ours}, off by {:e}", ours / expected - 1.0);
        // a chord of 1e-6 of the radius, where the scale grows by 2 in a radian
        assert!((ours.ln() / expected.ln() - 1.0).abs() < 1e-5, "{radius}: {ours} instead of {expected}");
    }
}

/// Rings of different kinds.
fn regions() -> Vec<(&'static str, Vec<[f64; 2]>)> {
    let wavy = |k: u32| {
        let angle = TAU * f64::from(k) / 300.0;
        let radius = 8.0 + 2.0 * (5.0 * angle).cos();
        [20.0 + 1.6 * radius * angle.cos(), 55.0 + radius * angle.sin()]
    };
    vec![
        ("rectangle", vec![[5.0, 40.0], [25.0, 40.0], [25.0, 50.0], [5.0, 50.0]]),
        ("L", vec![[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [10.0, 10.0], [10.0, 20.0], [0.0, 20.0]]),
        ("long and thin", vec![[-72.0, -55.0], [-68.0, -55.0], [-69.0, -18.0], [-71.0, -18.0]]),
        (
            "horseshoe",
            vec![
                [0.0, 0.0],
                [30.0, 0.0],
                [30.0, 6.0],
                [6.0, 6.0],
                [6.0, 20.0],
                [30.0, 20.0],
                [30.0, 26.0],
                [0.0, 26.0],
            ],
        ),
        ("star", (0..300).map(wavy).collect()),
        ("triangle across the antimeridian", vec![[170.0, -10.0], [-165.0, -20.0], [-175.0, 15.0]]),
        ("wide", vec![[-100.0, -50.0], [100.0, -50.0], [100.0, 60.0], [-100.0, 60.0]]),
    ]
}

#[test]
fn no_region_has_a_larger_ratio_than_its_best_stereographic_projection() {
    let folder = folder("regions");
    for (name, ring) in regions() {
        let made = Made::new(&folder, &[ring], &[]);
        let [ours, theirs] = ["scale_ratio", "stereographic_scale_ratio"].map(|key| made.number(key));
        let error = made.number("scale_ratio_error");
        println!("{name}: {ours} ± {error:e}, stereographic {theirs}");
        assert!(ours > 1.0 && ours < theirs, "{name}: {ours} and {theirs}");
        assert!(error < 1e-3 * (ours - 1.0), "{name}: {ours} ± {error:e}");
        assert_eq!(made.json["overlaps"], false, "{name}");
    }
}

/// The rows of a table.
fn rows(text: &str) -> Vec<[DVec2; 2]> {
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("lon,lat,x,y"));
    let row = |line: &str| {
        let [a, b, x, y] =
            <[f64; 4]>::try_from(line.split(',').map(|n| n.parse().unwrap()).collect::<Vec<f64>>()).unwrap();
        [DVec2::new(a, b), DVec2::new(x, y)]
    };
    lines.map(row).collect()
}

#[test]
fn the_lattice_of_the_table_is_conformal() {
    let folder = folder("table");
    let csv = folder.join("p.csv").display().to_string();
    for (name, ring) in regions() {
        let made = Made::new(&folder, &[ring], &["--out", &csv]);
        let rows = rows(&std::fs::read_to_string(&csv).unwrap());
        let find = |p: DVec2| rows.iter().rev().find(|row| row[0].distance(p) < 1e-9).map(|row| row[1]);
        // the lattice is by latitude, then by longitude: its steps from the last rows
        let n = rows.len();
        let (mut checked, mut worst, mut least) = (0, 0.0_f64, f64::INFINITY);
        let step_x = (n - 200..n - 1).map(|k| (rows[k + 1][0].x - rows[k][0].x).abs()).fold(f64::INFINITY, f64::min);
        let latitude_steps = (n / 2..n).map(|k| (rows[k][0].y - rows[k - 1][0].y).abs());
        let step_y = latitude_steps.filter(|&step| step > 1e-3).fold(f64::INFINITY, f64::min);
        for k in (n / 2..n).step_by(7) {
            let at = rows[k][0];
            let [east, west, north, south] =
                [[step_x, 0.0], [-step_x, 0.0], [0.0, step_y], [0.0, -step_y]].map(|d| find(at + DVec2::from_array(d)));
            let (Some(east), Some(west), Some(north), Some(south)) = (east, west, north, south) else { continue };
            let along = (east - west) / (2.0 * step_x.to_radians() * at.y.to_radians().cos());
            let across = (north - south) / (2.0 * step_y.to_radians());
            worst = worst.max(across.distance(along.perp()) / along.length());
            least = least.min(along.length());
            checked += 1;
        }
        println!("{name}: {checked} points, off by {worst:e}, least scale {least}");
        // differences of second order on steps of up to 3°
        assert!(checked > 5 && worst < 3e-3, "{name}: {checked} points, off by {worst:e}");
        assert!(least > 0.995 / made.number("scale_ratio"), "{name}: {least}");
    }
}

#[test]
fn the_drawing_shows_outline_graticule_and_scales() {
    let folder = folder("drawing");
    let svg = folder.join("p.svg").display().to_string();
    Made::new(&folder, &[cap([10.0, 50.0], 30.0, 400)], &["--out", &svg]);
    let text = std::fs::read_to_string(&svg).unwrap();
    for class in ["region", "meridian", "parallel", "scale", "outline", "label"] {
        assert!(text.contains(&format!("class=\"{class}\"")), "no {class}");
    }
    assert!(text.contains("data-scale=\"0.98\"") && text.contains(">0.98</text>"), "no line of scale 0.98");
    assert!(text.starts_with("<svg") && text.ends_with("</svg>\n"));
    assert!(!text.contains("NaN") && !text.contains("inf"), "not finite");
}

#[test]
fn of_several_rings_the_largest_is_taken_and_parts_are_joined() {
    let folder = folder("rings");
    let box_of = |west: f64, east: f64| vec![[west, -10.0], [east, -10.0], [east, 10.0], [west, 10.0]];
    let whole = Made::new(&folder, &[box_of(170.0, 190.0)], &[]);
    let island = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    let made = Made::new(&folder, &[box_of(170.0, 180.0), island, box_of(-180.0, -170.0)], &[]);
    assert_eq!(made.json["rings"], json!([1, 3]));
    assert_eq!(made.json["rings_left_out"], 1);
    assert!(made.notes.contains("1 other boundary was left out") && made.notes.contains("2 rings were joined"));
    let [a, b] = [&made, &whole].map(|made| made.number("scale_ratio"));
    assert!((a - b).abs() < 1e-7, "{a} and {b}");
}

/// A strip along a wavy spiral around the north pole. A turn of longitude is less than one in the plane, so that waves
/// above each other on the sphere are beside each other there, and cross.
fn spiral() -> Vec<[f64; 2]> {
    let side = |offset: f64, turn: f64| {
        let latitude = 50.0 + 9.0 * turn + 10.0 * (3.0 * TAU * turn).sin();
        [(360.0 * turn + 180.0).rem_euclid(360.0) - 180.0, latitude + offset]
    };
    let turns: Vec<f64> = (0..=300).map(|k| 1.4 * f64::from(k) / 300.0).collect();
    let there = turns.iter().map(|&turn| side(-2.0, turn));
    there.chain(turns.iter().rev().map(|&turn| side(2.0, turn))).collect()
}

#[test]
fn a_map_that_overlaps_itself_is_reported() {
    let made = Made::new(&folder("overlap"), &[spiral()], &[]);
    println!("{}", made.json);
    assert_eq!(made.json["overlaps"], true);
    assert!(made.notes.contains("overlaps itself"), "{}", made.notes);
}

#[test]
fn bad_input_is_refused_with_its_cause() {
    let folder = folder("bad");
    let with = |text: &str, words: &[&str]| {
        let path = file(&folder, "bad.geojson", text);
        fails(&["project", &path], 1, words);
    };
    with(r#"{"type":"Point","coordinates":[1,2]}"#, &["no polygon"]);
    with(r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]}"#, &["ring 1 is not closed"]);
    with(&geojson(&[vec![[0.0, 0.0], [1.0, 95.0], [1.0, 1.0]]]), &["point 2 of ring 1", "latitude 95°"]);
    with(&geojson(&[vec![[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 3.0]]]), &["crosses itself", "longitude 1.2"]);
    with(&geojson(&[vec![[0.0, 0.0], [1.0, 1.0]]]), &["ring 1", "at least 3"]);
    with("[[0,0],[1,0],[1,1]]", &["GeoJSON"]);
    fails(&["project", "absent.geojson"], 1, &["absent.geojson"]);
    let good = file(&folder, "good.geojson", &geojson(&[cap([0.0, 0.0], 5.0, 30)]));
    fails(&["project", &good, "--out", "p.png"], 2, &["svg or csv"]);
    assert_eq!(names(&folder), ["bad.geojson", "good.geojson"]);
    let text = String::from_utf8(riemap(&["project", &good]).stdout).unwrap();
    assert!(text.contains("scale ratio") && text.contains("stereographic"), "{text}");
}

#[test]
fn the_app_writes_the_files_of_the_command_line() {
    let folder = folder("app");
    let path = folder.join("cap.geojson");
    std::fs::write(&path, geojson(&[cap([10.0, 50.0], 12.0, 60)])).unwrap();
    let path = path.display().to_string();
    let bytes = std::fs::read(&path).unwrap();
    let tasks =
        [(path.as_str(), ProjectionTask::of_file("cap.geojson", bytes)), ("preset:island", ProjectionTask::Island)];
    for (name, task) in tasks {
        let found = task.run(&mut |_| true).unwrap().unwrap();
        for (format, text) in ProjectionFormat::ALL.into_iter().zip(&found.files) {
            let out = folder.join(format!("p.{}", format.extension())).display().to_string();
            let printed = succeeds(&["project", name, "--out", &out, "--json"]);
            assert!(*text == std::fs::read_to_string(&out).unwrap(), "{name}: another {out}");
            let report: Value = serde_json::from_slice(&printed.stdout).unwrap();
            assert_eq!(report, serde_json::to_value(&found.report).unwrap());
        }
    }
    fails(&["project", "preset:atlantis"], 1, &["atlantis", "island"]);
}
