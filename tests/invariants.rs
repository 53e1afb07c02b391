//! `riemap invariants`: exact values, the file's order of sides, and what is refused.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use serde_json::Value;
use support::program::{fails, file, folder, succeeds};

const L: &str = "[[0,0],[2,0],[2,1],[1,1],[1,2],[0,2]]";

fn json(arguments: &[&str]) -> Value {
    let arguments = [&["invariants"], arguments, &["--json"]].concat();
    serde_json::from_slice(&succeeds(&arguments).stdout).unwrap()
}

/// The value of a number that is right to `tolerance` and whose error says so.
fn assert_number(name: &str, number: &Value, expected: f64, tolerance: f64) {
    let [value, error] = ["value", "error"].map(|key| number[key].as_f64().unwrap());
    let off = (value - expected).abs();
    assert!(off <= tolerance * expected, "{name}: {value} for {expected}, off by {off:e}");
    assert!(off <= error + f64::EPSILON * expected, "{name}: off by {off:e}, said to be {error:e}");
    assert!(error <= 100.0 * tolerance * expected, "{name}: said to be off by {error:e}");
}

#[test]
fn the_l_shape_has_its_values_in_the_files_order() {
    let folder = folder("l-shape");
    let given = file(&folder, "l.json", L);
    let turned = file(&folder, "turned.json", "[[0,0],[0,2],[1,2],[1,1],[2,1],[2,0]]");
    let shifted = file(&folder, "shifted.json", "[[2,1],[1,1],[1,2],[0,2],[0,0],[2,0],[2,1]]");
    let [long, inner] = [0.394_497_233_238_905_2, 0.092_199_674_737_061_53];
    let end = 0.5 - long - inner;
    let sides = [long, end, inner, inner, end, long];
    for (path, first) in [(&given, 0), (&turned, 0), (&shifted, 2)] {
        let found = json(&[path, "--point", "0.5,0.5"]);
        let measures = found["harmonic_measure"].as_array().unwrap();
        assert_eq!(measures.len(), 6, "{path}");
        for (k, measure) in measures.iter().enumerate() {
            assert_number(&format!("{path}, side {k}"), measure, sides[(first + k) % 6], 1e-12);
        }
        assert_number("R", &found["conformal_radius"], 0.653_579_438_242_370_7, 1e-13);
        assert_number("capacity", &found["capacity"], 1.084_890_390_444_781, 1e-13);
        assert!(found["modulus"].is_null() && found["hyperbolic_distance"].is_null());
    }
    // unequal sides of a clockwise file: side k runs from point k to point k + 1
    let clockwise = file(&folder, "clockwise.json", "[[0,0],[0,1],[3,1],[3,0]]");
    let found = json(&[&clockwise, "--point", "0.5,0.5"]);
    let measure = |k: usize| found["harmonic_measure"][k]["value"].as_f64().unwrap();
    assert!(measure(0) > 0.2 && measure(2) < 0.01, "{found}");
    assert!((measure(1) - measure(3)).abs() < 1e-14, "{found}");
}

#[test]
fn marks_give_arcs_and_a_modulus() {
    let folder = folder("marks");
    let l = file(&folder, "l.json", L);
    let found = json(&[&l, "--point", "0.5,0.5", "--marks", "0.25,0.375,0.625,0.75"]);
    assert_eq!(found["harmonic_measure"].as_array().unwrap().len(), 4);
    assert_number("between the arms' ends", &found["modulus"], 2.558_523_142_342_013, 1e-12);
    let found = json(&[&l, "--point", "1.5,0.5", "--marks", "0,0.25,0.625,0.75"]);
    assert_number("between two sides", &found["modulus"], 3.0_f64.sqrt(), 1e-12);
    let disk = |marks: &str| json(&["preset:disk", "--point", "0,0", "--marks", marks]);
    let found = disk("0,0.175,0.35,0.625");
    assert_number("four arcs of the disk", &found["modulus"], 1.045_465_950_033_828_6, 1e-12);
    for (k, share) in [0.175, 0.175, 0.275, 0.375].into_iter().enumerate() {
        assert_number("an arc of the disk", &found["harmonic_measure"][k], share, 1e-13);
    }
    // cyclic order: the last mark may be the smallest
    let conjugate = disk("0.175,0.35,0.625,0")["modulus"]["value"].as_f64().unwrap();
    assert!((conjugate * 1.045_465_950_033_828_6 - 1.0).abs() < 1e-12, "{conjugate}");
}

#[test]
fn a_second_point_gives_a_hyperbolic_distance() {
    let found = json(&["preset:disk", "--point", "0,0", "--second-point=-0.5,0"]);
    assert_number("distance in the disk", &found["hyperbolic_distance"], 3.0_f64.ln(), 1e-13);
    let there = json(&["preset:l-shape", "--point=-0.5,-0.5", "--second-point", "0.5,-0.4"]);
    let back = json(&["preset:l-shape", "--point", "0.5,-0.4", "--second-point=-0.5,-0.5"]);
    let [a, b] = [there, back].map(|found| found["hyperbolic_distance"]["value"].as_f64().unwrap());
    assert!((a - b).abs() < 1e-11 * a, "{a} and {b}");
}

#[test]
fn the_distance_of_a_point_from_itself_is_zero() {
    let found = json(&["preset:disk", "--point", "0.3,0", "--second-point", "0.3,0"]);
    assert_eq!(found["hyperbolic_distance"], serde_json::json!({ "value": 0.0, "error": 0.0 }));
}

#[test]
fn dense_points_and_paths_are_taken_as_curves() {
    let folder = folder("curves");
    let ellipse: Vec<String> = (0..600)
        .map(|k| f64::from(k) / 600.0 * std::f64::consts::TAU)
        .map(|t| format!("{},{}", 2.0 * t.cos(), t.sin()))
        .collect();
    let ellipse = file(&folder, "ellipse.csv", &ellipse.join("\n"));
    let found = json(&[&ellipse, "--point", "0,0"]);
    // (a + b)/2
    let capacity = found["capacity"]["value"].as_f64().unwrap();
    assert!((capacity - 1.5).abs() < 1e-7, "{capacity}");
    assert_eq!(found["harmonic_measure"].as_array().unwrap().len(), 1, "there are no corners");
    // three quarters of a circle and a quarter, either way round
    for (name, sweep, order) in [("ccw", 0, [0.25, 0.75]), ("cw", 1, [0.75, 0.25])] {
        // the y axis of pictures points down
        let large = |share: f64| i32::from(share > 0.5);
        let [first, second] = order.map(large);
        let path = format!("M4 0A4 4 0 {first} {sweep} 0 -4A4 4 0 {second} {sweep} 4 0Z");
        let svg = format!("<svg xmlns='http://www.w3.org/2000/svg'><path d='{path}'/></svg>");
        let disk = file(&folder, &format!("{name}.svg"), &svg);
        let found = json(&[&disk, "--point", "0,0"]);
        let radius = found["conformal_radius"]["value"].as_f64().unwrap();
        assert!((radius - 4.0).abs() < 1e-4, "{name}: {radius}");
        let measures = found["harmonic_measure"].as_array().unwrap();
        assert_eq!(measures.len(), 2, "{name}: {measures:?}");
        for (measure, share) in measures.iter().zip(order) {
            assert!((measure["value"].as_f64().unwrap() - share).abs() < 1e-5, "{name}: {measures:?}");
        }
    }
}

#[test]
fn small_measures_keep_their_digits() {
    let folder = folder("rectangle");
    let path = file(&folder, "rectangle.csv", "0,0\n10,0\n10,1\n0,1\n");
    let found = json(&[&path, "--point", "5,0.5"]);
    for side in [1, 3] {
        assert_number("an end", &found["harmonic_measure"][side], 0.5 * 3.837_587_979_251_226e-7, 1e-9);
    }
}

#[test]
fn numbers_are_also_printed_as_text() {
    let output = succeeds(&["invariants", "preset:square", "--point", "0,0", "--marks", "0,0.25,0.5,0.75"]);
    let text = String::from_utf8(output.stdout).unwrap();
    for word in ["conformal radius", "capacity", "modulus", "harmonic measure, arc 4", "±"] {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
}

#[test]
fn bad_input_is_refused_with_its_cause() {
    let folder = folder("bad");
    let l = file(&folder, "l.json", L);
    fails(&["invariants", &l, "--point", "1.5,1.5"], 1, &["--point", "(1.5, 1.5) is not inside"]);
    let far = ["invariants", &l, "--point", "0.5,0.5", "--second-point", "9,9"];
    fails(&far, 1, &["--second-point", "(9, 9) is not inside"]);
    fails(&["invariants", "absent.json", "--point", "0,0"], 1, &["absent.json"]);
    fails(&["invariants", "preset:kitten", "--point", "0,0"], 1, &["kitten", "blob"]);
    let comb: Vec<String> = (0..2500).map(|k| format!("[{k},0],[{k}.5,3]")).collect();
    let comb = file(&folder, "comb.json", &format!("[{},[2500,5],[0,5]]", comb.join(",")));
    fails(&["invariants", &comb, "--point", "200,4", "--interpret", "polygon"], 1, &["unknowns", "limit"]);
    fails(&["invariants", &l, "--second-point", "1,1"], 2, &["--point"]);
    let with = |marks: &'static str| ["invariants", "preset:disk", "--point", "0,0", "--marks", marks];
    fails(&with("0,0.5"), 2, &["S,S,S,S"]);
    fails(&with("0,0.5,0.25,0.75"), 2, &["cyclic order"]);
    fails(&with("0,0.25,0.25,0.75"), 2, &["same point"]);
    fails(&with("0,0.25,nan,0.75"), 2, &["finite"]);
}

#[test]
fn marks_are_named_by_vertex_in_the_order_of_either_direction() {
    let folder = folder("invariants-vertices");
    let points = ["0,0", "2.5,0", "2.5,1.25", "1.5,1.25", "1.5,2.75", "0,2.75"];
    let clockwise: Vec<&str> = points.iter().rev().copied().collect();
    let files = [file(&folder, "l.csv", &points.join("\n")), file(&folder, "clockwise.csv", &clockwise.join("\n"))];
    let marks = [["v0", "v2", "v3", "v5"], ["v5", "v3", "v2", "v0"]];
    let mut arcs = Vec::new();
    for (name, marks) in files.iter().zip(marks) {
        let mut arguments = vec!["invariants", name, "--point", "1,1", "--json"];
        for mark in marks {
            arguments.extend(["--mark", mark]);
        }
        let found: Value = serde_json::from_slice(&succeeds(&arguments).stdout).unwrap();
        let modulus = found["modulus"]["value"].as_f64().unwrap();
        assert!((modulus - 0.878_571_593_945_8).abs() < 1e-12, "{name}: {modulus}");
        let of_arc = |arc: &Value| (arc["value"].as_f64().unwrap() * 1e12).round();
        arcs.push(found["harmonic_measure"].as_array().unwrap().iter().map(of_arc).collect::<Vec<f64>>());
    }
    assert_eq!(arcs[0], arcs[1]);
    let missing = fails(
        &["invariants", &files[0], "--point", "1,1", "--mark", "v6", "--mark", "v1", "--mark", "v2", "--mark", "v3"],
        1,
        &[],
    );
    assert!(missing.contains("v6: the outline has 6 points"), "{missing}");
}

/// Capacity and modulus are those of the outline, whatever is seen from a point.
#[test]
fn capacity_and_modulus_need_no_point() {
    let marks = ["preset:square", "--marks", "0,0.25,0.5,0.75"];
    let alone = json(&marks);
    for key in ["harmonic_measure", "conformal_radius", "hyperbolic_distance", "unknowns"] {
        assert!(alone[key].is_null(), "{key}: {alone}");
    }
    for point in ["0,0", "0.3,-0.2"] {
        let seen = json(&[&marks[..], &["--point", point]].concat());
        assert_eq!([&seen["capacity"], &seen["modulus"]], [&alone["capacity"], &alone["modulus"]], "{point}");
    }
    assert_number("modulus", &alone["modulus"], 1.0, 1e-12);
    let text = String::from_utf8(succeeds(&["invariants", "preset:disk"]).stdout).unwrap();
    assert!(text.starts_with("capacity ") && text.trim_end().lines().count() == 1, "{text}");
}
