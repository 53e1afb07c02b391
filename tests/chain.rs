//! `riemap map A B C …`: there and back is the identity, from disk to disk a Möbius map, and link by link the same as at
//! once; figures of each link, surfaces in a chain, and what is refused.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::exact::Complex;
use riemap::geometry::DVec2;
use serde_json::Value;
use support::program::{fails, file, folder, succeeds};

/// The summary of a chain with further arguments.
fn summary(arguments: &[&str]) -> Value {
    let output = succeeds(&[&["map"], arguments, &["--json"]].concat());
    serde_json::from_slice(&output.stdout).unwrap()
}

fn link_by_link(summary: &Value) -> [f64; 2] {
    ["boundary", "interior"].map(|part| summary["link_by_link"][part].as_f64().unwrap())
}

/// The images of points under a chain, and its summary.
fn images(name: &str, points: &[DVec2], arguments: &[&str]) -> (Vec<DVec2>, Value) {
    let folder = folder(name);
    let rows: Vec<String> = points.iter().map(|p| format!("{},{}\n", p.x, p.y)).collect();
    let (given, table) = (file(&folder, "in.csv", &rows.concat()), folder.join("out.csv"));
    let options = ["--points", &given, "--out", table.to_str().unwrap()];
    let summary = summary(&[arguments, &options].concat());
    let text = std::fs::read_to_string(table).unwrap();
    let image = |row: &str| {
        let cells: Vec<f64> = row.split(',').skip(2).take(2).map(|cell| cell.parse().unwrap()).collect();
        DVec2::new(cells[0], cells[1])
    };
    (text.lines().skip(1).map(image).collect(), summary)
}

#[test]
fn there_and_back_is_the_identity() {
    let points = [DVec2::new(0.0, 0.3), DVec2::new(-0.6, 0.25), DVec2::new(0.2, -0.7)];
    let chain = ["preset:gingerbread", "preset:heart", "preset:gingerbread", "--source-point", "0.1,-0.2"];
    let targets = ["--target-point", "-0.1,0.3", "--target-point", "0.1,-0.2", "--target-anchor", "@0.3"];
    let (images, summary) = images("identity", &points, &[chain.as_slice(), &targets].concat());
    for (point, image) in points.iter().zip(images) {
        assert!(point.distance(image) < 1e-11, "{point} goes to {image}");
    }
    let [boundary, interior] = link_by_link(&summary);
    assert!(boundary < 1e-8 && interior < 1e-9, "link by link: {boundary:e}, {interior:e}");
    let links = summary["links"].as_array().unwrap();
    assert_eq!(links.len(), 2);
    assert_eq!((&links[0]["target"], &links[1]["source"]), (&links[1]["source"], &Value::from("preset:heart")));
    assert_eq!(links[0]["target_point"], links[1]["source_point"]);
    for link in links {
        let (q, flipped) = (link["q_mean"].as_f64().unwrap(), link["flipped"].as_u64().unwrap());
        assert!((1.0..1.3).contains(&q) && flipped < 20, "{link}");
        assert!(link["error_estimate"]["image"].as_f64().unwrap() < 1e-6, "{link}");
    }
}

#[test]
fn from_the_disk_over_the_square_to_the_disk_it_is_a_moebius_map() {
    let points = [DVec2::ZERO, DVec2::new(0.7, -0.2), DVec2::new(-0.3, 0.85), DVec2::new(0.1, 0.95)];
    let chain = ["preset:disk", "preset:square", "preset:disk", "--source-point", "0.3,0.2"];
    let targets = ["--target-point", "0.4,-0.1", "--target-point", "-0.5,0.1"];
    let anchors = ["--source-anchor", "@0.1", "--target-anchor", "@0.6", "--target-anchor", "@0.45"];
    let (found, summary) = images("moebius", &points, &[chain.as_slice(), &targets, &anchors].concat());
    let number = |p: DVec2| Complex::new(p.x, p.y);
    let to_center = |z: Complex, a: Complex| (z - a) / (Complex::new(1.0, 0.0) - a.conj() * z);
    let [a, b] = [Complex::new(0.3, 0.2), Complex::new(-0.5, 0.1)];
    let at = |turn: f64| number(DVec2::from_angle(std::f64::consts::TAU * turn));
    let turn = to_center(at(0.45), b) / to_center(at(0.1), a);
    for (point, image) in points.into_iter().zip(found) {
        let expected = to_center(turn * to_center(number(point), a), -b);
        let off = (number(image) - expected).norm();
        assert!(off < 1e-12, "{point}: off by {off:e}");
    }
    let [boundary, interior] = link_by_link(&summary);
    assert!(boundary < 1e-7 && interior < 1e-11, "link by link: {boundary:e}, {interior:e}");
}

#[test]
fn a_chain_is_the_map_from_its_first_to_its_last_side() {
    let over = ["preset:l-shape", "preset:star", "preset:blob"];
    let points = ["--source-point", "-0.4,-0.4", "--source-anchor", "@0.2"];
    let chain = summary(&[over.as_slice(), &points].concat());
    let at_once = summary(&[&["preset:l-shape", "preset:blob", "--direction", "forward"], points.as_slice()].concat());
    for key in ["quality", "counts", "unresolved_area", "error_estimate"] {
        assert_eq!(chain[key], at_once[key], "{key}");
    }
    assert!(at_once["links"].is_null() && at_once["link_by_link"].is_null());
    let [boundary, interior] = link_by_link(&chain);
    assert!(boundary < 1e-5 && interior < 1e-8, "link by link: {boundary:e}, {interior:e}");
}

#[test]
fn finite_elements_and_surfaces_make_chains_too() {
    let finite = summary(&["preset:square", "preset:heart", "preset:disk", "--kernel", "adjoint"]);
    let [boundary, interior] = link_by_link(&finite);
    // measures from one outline to the next are the same numbers; inside, linear values are integrated
    assert!(boundary < 1e-12 && interior < 0.02, "{boundary:e}, {interior:e}");
    let over = summary(&["preset:square", "preset:hemisphere:60", "preset:disk"]);
    assert!(over["link_by_link"]["interior"].is_null());
    assert!(over["link_by_link"]["boundary"].as_f64().unwrap() < 0.1, "{over}");
    assert_eq!(over["links"][0]["target_point"], over["links"][1]["source_point"]);
    assert!(over["links"][0]["target_point"]["triangle"].is_number(), "{over}");
}

#[test]
fn what_does_not_fit_a_chain_is_refused() {
    let chain = ["map", "preset:disk", "preset:square", "preset:heart"];
    let refused = |options: &[&str], words: &[&str]| fails(&[chain.as_slice(), options].concat(), 2, words);
    refused(&["--pin", "@0:@0", "--pin", "@0.3:@0.3", "--pin", "@0.6:@0.6"], &["--pin", "one target"]);
    let three = ["--target-anchor", "@0", "--target-anchor", "@0.1", "--target-anchor", "@0.2"];
    refused(&three, &["--target-anchor is given 3 times for 2 targets"]);
    let twice = ["map", "preset:disk", "preset:square", "--target-point", "0,0", "--target-point", "0.1,0"];
    fails(&twice, 2, &["--target-point is given 2 times for 1 target"]);
    refused(&["--target-point", "0,0", "--target-point", "0,0,0"], &["preset:heart", "an outline"]);
}

#[test]
fn the_composition_is_written_like_a_single_map() {
    let folder = folder("written");
    let out = ["json", "csv", "obj", "svg"].map(|extension| folder.join(format!("x.{extension}")));
    let mut arguments = vec!["map", "preset:disk", "preset:square", "preset:star", "--samples", "100"];
    arguments.extend(out.iter().flat_map(|path| ["--out", path.to_str().unwrap()]));
    let words = String::from_utf8(succeeds(&arguments).stdout).unwrap();
    assert!(words.contains("preset:square → preset:star: mean Q = 1."), "{words}");
    assert!(words.contains("link by link, images differ by"), "{words}");
    let json: Value = serde_json::from_slice(&std::fs::read(&out[0]).unwrap()).unwrap();
    assert_eq!(json["links"].as_array().unwrap().len(), 2);
    assert_eq!(json["vertices"].as_array().unwrap().len(), json["images"].as_array().unwrap().len());
    let csv = std::fs::read_to_string(&out[1]).unwrap();
    assert!(csv.lines().count() > 100, "{csv}");
}
