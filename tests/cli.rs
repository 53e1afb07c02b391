//! The command line: outputs, exit status, and one clear line for bad input.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::geometry::DVec2;
use serde_json::Value;
use support::program::{fails, file, folder, names, riemap, succeeds};

#[test]
fn map_writes_every_format() {
    let folder = folder("formats");
    let out = |name: &str| folder.join(name).display().to_string();
    let files = ["map.json", "map.csv", "map.obj", "map.svg", "map.png"].map(out);
    let mut arguments = vec!["map", "preset:square", "preset:heart", "--json", "--samples", "200", "--size", "320x160"];
    for file in &files {
        arguments.extend(["--out", file]);
    }
    let output = succeeds(&arguments);
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    let document: Value = serde_json::from_str(&std::fs::read_to_string(&files[0]).unwrap()).unwrap();
    for key in ["quality", "timing_ms", "counts"] {
        assert_eq!(summary[key], document[key], "{key}");
    }
    for stage in ["sample", "mesh", "assemble", "order", "factor", "kernel", "match", "extend"] {
        assert!(summary["timing_ms"][stage].as_f64().unwrap() >= 0.0, "{stage}");
    }
    let counts = &summary["counts"];
    let (m, n) = (counts["m"].as_u64().unwrap(), counts["n"].as_u64().unwrap());
    assert_eq!(counts["triangles"].as_u64().unwrap(), m + 2 * n - 2);
    let length = |key: &str| document[key].as_array().unwrap().len() as u64;
    assert_eq!((length("vertices"), length("images")), (m + n, m + n));
    assert_eq!((length("boundary_map"), length("harmonic_measure")), (m, m));
    assert_eq!(document["target"]["boundary"].as_array().unwrap().len() as u64, m);
    let csv = std::fs::read_to_string(&files[1]).unwrap();
    assert_eq!(csv.lines().count() as u64, m + 1);
    let obj = std::fs::read_to_string(&files[2]).unwrap();
    assert_eq!(obj.lines().filter(|line| line.starts_with("vt ")).count() as u64, m + n);
    assert!(std::fs::read_to_string(&files[3]).unwrap().starts_with("<svg"));
    let picture = image::open(&files[4]).unwrap().to_rgb8();
    assert_eq!(picture.dimensions(), (320, 160));
    let colours: std::collections::BTreeSet<[u8; 3]> = picture.pixels().map(|pixel| pixel.0).collect();
    assert!(colours.len() > 50, "only {} colours", colours.len());
}

#[test]
fn forward_maps_the_source_and_the_interior_point_lands_on_its_image() {
    let folder = folder("forward");
    let out = folder.join("map.json").display().to_string();
    let arguments = [
        "map",
        "preset:disk",
        "preset:disk",
        "--direction",
        "forward",
        "--source-point",
        "0.3,-0.2",
        "--target-point",
        "-0.1,0.4",
        "--source-anchor",
        "1,0",
        "--target-anchor",
        "@0.25",
        "--out",
        &out,
    ];
    succeeds(&arguments);
    let document: Value = serde_json::from_str(&std::fs::read_to_string(&out).unwrap()).unwrap();
    let point = |v: &Value| [v[0].as_f64().unwrap(), v[1].as_f64().unwrap()];
    let nearest = |p: [f64; 2]| {
        let vertices = document["vertices"].as_array().unwrap().iter().map(&point).enumerate();
        vertices.min_by(|a, b| distance(a.1, p).total_cmp(&distance(b.1, p))).unwrap().0
    };
    let image = point(&document["images"][nearest([0.3, -0.2])]);
    assert!(distance(image, [-0.1, 0.4]) < 0.1, "the image of x₁ is near {image:?}");
    let image = point(&document["images"][nearest([1.0, 0.0])]);
    assert!(distance(image, [0.0, 1.0]) < 1e-2, "the image of y₁ is {image:?}");
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The same document with other images, also of the boundary, where f̂ does not interpolate.
#[test]
fn cauchy_green_extension_maps_the_boundary_too() {
    let folder = folder("cauchy-green");
    let [harmonic, cauchy] = ["harmonic", "cauchy-green"].map(|extension| {
        let out = folder.join(format!("{extension}.json")).display().to_string();
        let arguments =
            ["map", "preset:star", "preset:disk", "--samples", "300", "--extension", extension, "--out", out.as_str()];
        succeeds(&arguments);
        serde_json::from_str::<Value>(&std::fs::read_to_string(&out).unwrap()).unwrap()
    });
    let keys = |document: &Value| document.as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(&harmonic), keys(&cauchy));
    for key in ["vertices", "triangles", "harmonic_measure"] {
        assert_eq!(harmonic[key], cauchy[key], "{key}");
    }
    let images = |document: &Value| -> Vec<[f64; 2]> {
        let images = document["images"].as_array().unwrap().iter();
        images.map(|p| [p[0].as_f64().unwrap(), p[1].as_f64().unwrap()]).collect()
    };
    let (a, b) = (images(&harmonic), images(&cauchy));
    let m = cauchy["counts"]["m"].as_u64().unwrap() as usize;
    let distances: Vec<f64> = a.iter().zip(&b).map(|(p, q)| distance(*p, *q)).collect();
    let mean = distances.iter().sum::<f64>() / distances.len() as f64;
    assert!(mean > 1e-7 && mean < 2e-2, "mean difference {mean:e}");
    let boundary = cauchy["boundary_map"].as_array().unwrap();
    assert!((0..m).all(|k| boundary[k][2].as_f64() == Some(b[k][0])), "the boundary's images are f̂(v_k)");
    assert!(distances[..m].iter().any(|&d| d > 1e-6), "f̂ does not interpolate");
}

#[test]
fn prepare_prints_counts_and_timings() {
    let output = riemap(&["prepare", "preset:l-shape", "--sampling", "uniform", "--samples", "120", "--json"]);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["counts"]["m"], 120);
    assert!(report["timing_ms"]["factor"].as_f64().unwrap() > 0.0);
}

#[test]
fn bad_input_exits_1_with_one_line() {
    let folder = folder("bad");
    let crossing = file(&folder, "crossing.json", "[[0,0],[2,2],[2,0],[0,2]]");
    let nan = file(&folder, "nan.csv", "0,0\n1,nan\n1,1\n");
    let short = file(&folder, "short.txt", "0 0\n1 1\n");
    let prose = file(&folder, "prose.json", "this is no outline");
    let flat = file(&folder, "flat.json", "[[0,0],[1,1],[2,2]]");
    fails(&["prepare", &crossing], 1, &["cross"]);
    fails(&["prepare", &nan], 1, &["nan.csv"]);
    fails(&["prepare", &short], 1, &["3"]);
    fails(&["prepare", &prose], 1, &["line 1", "this is no outline"]);
    fails(&["prepare", &flat], 1, &[]);
    fails(&["prepare", "absent.json"], 1, &["absent.json"]);
    fails(&["prepare", "preset:kitten"], 1, &["kitten", "gingerbread"]);
    for outside in ["3,0", "1e200,1e200", "1,0", "1.000001,0"] {
        fails(&["map", "preset:disk", "preset:square", "--source-point", outside], 1, &["source point"]);
    }
    fails(&["map", "preset:square", "preset:disk", "--source-point", "0.9,0"], 1, &["source point"]);
    let clockwise = file(&folder, "clockwise.json", "[[0,0],[0,1],[1,1],[1,0]]");
    fails(&["map", &clockwise, "preset:disk", "--source-point", "3,0"], 1, &["source point"]);
}

#[test]
fn repair_cuts_off_what_meets_itself_and_says_so() {
    let folder = folder("repair");
    let path = file(&folder, "spike.json", "[[0,0],[2,0],[1,0],[1,1],[0,1]]");
    fails(&["prepare", &path], 1, &["back"]);
    let output = riemap(&["prepare", &path, "--repair"]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && stderr.contains("cut off"), "{stderr}");
}

#[test]
fn bad_usage_exits_2() {
    fails(&["map", "preset:disk"], 2, &["TARGET"]);
    fails(&["map", "preset:disk", "preset:disk", "--out", "map.docx"], 2, &["extension"]);
    fails(&["map", "preset:disk", "preset:disk", "--source-point", "here"], 2, &["X,Y in an outline", "X,Y,Z"]);
    fails(&["map", "preset:disk", "preset:disk", "--source-anchor", "here"], 2, &["X,Y of an outline", "X,Y,Z"]);
    fails(&["map", "preset:disk", "preset:nonsense"], 1, &["\"nonsense\"", "blob", "surfaces: ", "hemisphere"]);
    let same = ["map", "preset:hemisphere:20", "preset:hemisphere:20"];
    fails(&[&same[..], &["--samples", "100"]].concat(), 2, &["--samples is for outlines"]);
    fails(&[&same[..], &["--target-anchor", "1,2"]].concat(), 2, &["preset:hemisphere:20 (target) is a surface"]);
    fails(&["prepare", "preset:disk", "--sizing", "graded:-1"], 2, &["graded"]);
    fails(&["map", "preset:disk", "preset:disk", "--extension", "conic"], 2, &["conic", "cauchy-green"]);
    fails(&["prepare", "preset:disk", "--samples", "many"], 2, &["samples"]);
    fails(&["paint"], 2, &["paint"]);
}

#[test]
fn nothing_is_left_behind_when_an_output_cannot_be_written() {
    let folder = folder("partial");
    let good = folder.join("map.csv").display().to_string();
    let bad = folder.join("no/such/folder/map.json").display().to_string();
    fails(&["map", "preset:disk", "preset:square", "--samples", "50", "--out", &good, "--out", &bad], 1, &["no/such"]);
    assert_eq!(names(&folder), Vec::<String>::new());
    fails(&["map", "preset:disk", "preset:square", "--source-point", "9,9", "--out", &good], 1, &[]);
    assert_eq!(names(&folder), Vec::<String>::new());
    fails(&["map", "preset:disk", "preset:square", "--out", &good, "--out", &good], 2, &["twice"]);
    assert_eq!(names(&folder), Vec::<String>::new());
    let occupied = folder.join("folder.json");
    std::fs::create_dir(&occupied).unwrap();
    let occupied_name = occupied.display().to_string();
    fails(&["map", "preset:disk", "preset:square", "--out", &good, "--out", &occupied_name], 1, &["folder"]);
    std::fs::remove_dir(&occupied).unwrap();
    assert_eq!(names(&folder), Vec::<String>::new());
}

#[test]
fn clockwise_outline_is_accepted_and_said() {
    let folder = folder("clockwise");
    let path = file(&folder, "square.json", "[[0,0],[0,1],[1,1],[1,0]]");
    let output = riemap(&["prepare", &path, "--json"]);
    assert!(output.status.success());
    assert!(String::from_utf8(output.stderr).unwrap().contains("clockwise"));
}

#[test]
fn an_outline_is_interpreted_as_asked() {
    for (interpret, kind, corners) in [("auto", "smooth", 2), ("smooth", "smooth", 2), ("polygon", "polygon", 996)] {
        let output = succeeds(&["prepare", "preset:heart", "--samples", "60", "--interpret", interpret, "--json"]);
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(report["interpretation"]["interpretation"], kind, "{interpret}");
        assert_eq!(report["interpretation"]["corners"], corners, "{interpret}");
    }
}

#[test]
fn the_integral_kernel_says_what_it_used_and_how_accurate_it_is() {
    let folder = folder("integral");
    let files = ["map.json", "map.csv"].map(|name| folder.join(name).display().to_string());
    let arguments = [
        "map",
        "preset:l-shape",
        "preset:disk",
        "--direction",
        "forward",
        "--refine",
        "off",
        "--json",
        "--out",
        &files[0],
        "--out",
        &files[1],
    ];
    let summary: Value = serde_json::from_slice(&succeeds(&arguments).stdout).unwrap();
    assert_eq!(summary["kernel"], serde_json::json!({ "source": "integral", "target": "integral" }));
    assert!(summary["unknowns"]["source"].as_u64().unwrap() > summary["unknowns"]["target"].as_u64().unwrap());
    let [omega, image] = ["omega", "image"].map(|key| summary["error_estimate"][key].as_f64().unwrap());
    assert!(omega > 0.0 && omega < 1e-10 && image > 0.0 && image < 1e-9, "{omega:e}, {image:e}");
    assert_eq!(summary["finite_element_share"], serde_json::json!({ "source": 0.0, "target": 0.0 }));
    assert_eq!(summary["coinciding_edges"], 0);
    let document: Value = serde_json::from_str(&std::fs::read_to_string(&files[0]).unwrap()).unwrap();
    let csv = std::fs::read_to_string(&files[1]).unwrap();
    assert!(csv.lines().next().unwrap().ends_with(",error (target units)"), "{}", csv.lines().next().unwrap());
    let errors: Vec<f64> = csv.lines().skip(1).map(|row| row.rsplit(',').next().unwrap().parse().unwrap()).collect();
    assert_eq!(errors.iter().copied().fold(0.0, f64::max), image);
    assert_eq!(document["boundary_error"].as_array().unwrap().len(), errors.len());
    for row in csv.lines().skip(1) {
        let row: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let (s2, x2, y2) = (row[1], row[4], row[5]);
        let (sin, cos) = (std::f64::consts::TAU * s2).sin_cos();
        let radius = x2.hypot(y2);
        assert!((x2 - radius * cos).hypot(y2 - radius * sin) < 1e-14, "{row:?}");
    }
}

#[test]
fn errors_of_finite_elements_are_estimated_by_comparison_if_numbers_are_asked_for() {
    let estimate = |arguments: &[&str]| {
        let summary: Value = serde_json::from_slice(&succeeds(arguments).stdout).unwrap();
        assert_eq!(summary["kernel"]["source"], "adjoint", "{arguments:?}");
        assert_eq!(summary["unknowns"]["source"], Value::Null);
        ["omega", "image"].map(|key| summary["error_estimate"][key].as_f64().unwrap())
    };
    let plain = ["map", "preset:l-shape", "preset:square", "--json", "--kernel", "adjoint"];
    let [omega, image] = estimate(&plain);
    // the image next to the re-entrant corner is off by 4.9e-2, in comparison with the integral equation
    assert!((1e-6..1e-2).contains(&omega) && (5e-2..5e-1).contains(&image), "{omega:e}, {image:e}");
    let few = [&plain[..], &["--samples", "100"]].concat();
    assert!(estimate(&few)[0] > omega, "fewer samples are estimated to be better");
    // a surface, with the integral equation on the other side
    let [omega, _] = estimate(&["map", "preset:hemisphere:60", "preset:disk", "--json"]);
    assert!((1e-6..1e-1).contains(&omega), "{omega:e}");
    // not where they are not asked for, and not with too many vertices
    let text = succeeds(&["map", "preset:disk", "preset:square", "--kernel", "adjoint", "--samples", "100"]).stdout;
    assert!(!String::from_utf8(text).unwrap().contains("estimated error"));
    let many = ["map", "preset:disk", "preset:disk", "--json", "--kernel", "adjoint", "--samples", "1500"];
    let summary: Value = serde_json::from_slice(&succeeds(&many).stdout).unwrap();
    assert_eq!(summary["error_estimate"], Value::Null);
    assert!(summary["error_estimate_missing"].as_str().unwrap().contains("too many"), "{summary}");
}

#[test]
fn where_the_integral_kernel_does_not_fit_finite_elements_are_used_and_said() {
    let folder = folder("unsharpened");
    let point = |k: u32| {
        let radius = if k.is_multiple_of(2) { 1.0 } else { 0.8 };
        let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 4200.0).sin_cos();
        format!("[{},{}]", radius * cos, radius * sin)
    };
    let points: Vec<String> = (0..4200).map(point).collect();
    let path = file(&folder, "coast.json", &format!("[{}]", points.join(",")));
    let output = succeeds(&["map", &path, "preset:disk", "--json"]);
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(summary["kernel"], serde_json::json!({ "source": "adjoint", "target": "integral" }));
    let reason = &summary["finite_element_reason"];
    assert!(reason["source"].as_str().unwrap().contains("unknowns") && reason["target"].is_null(), "{reason}");
    let text = String::from_utf8(succeeds(&["map", &path, "preset:disk"]).stdout).unwrap();
    let line = text.lines().find(|line| line.starts_with("source: finite elements")).unwrap();
    assert!(line.contains("unknowns"), "{line}");
    let two = ["map", "preset:hemisphere", "preset:hemisphere", "--kernel", "integral"];
    fails(&two, 2, &["for outlines", "surfaces"]);
    fails(
        &["map", "preset:disk", "preset:disk", "--kernel", "integral", "--source-point", "1.1,0"],
        1,
        &["not inside"],
    );
}

/// Places within r of a right angle crowd within r² on the other side: the anchor was off by 2e-4, corners by 2e-7.
#[test]
fn corners_and_anchors_are_exact_whichever_side_is_mapped() {
    let folder = folder("corners");
    let square = file(&folder, "square.csv", "0,0\n1,0\n1,1\n0,1\n");
    let path = folder.join("map.csv").display().to_string();
    // x, y of the square and of the disk in a row: s1, s2, x1, y1, x2, y2
    for (pair, [on_square, on_disk]) in [([&square[..], "preset:disk"], [2, 4]), (["preset:disk", &square[..]], [4, 2])]
    {
        succeeds(&["map", pair[0], pair[1], "--out", &path]);
        let text = std::fs::read_to_string(&path).unwrap();
        let number = |text: &str| text.parse::<f64>().unwrap();
        let rows: Vec<Vec<f64>> = text.lines().skip(1).map(|line| line.split(',').map(number).collect()).collect();
        let place = |row: &[f64], at: usize| DVec2::new(row[at], row[at + 1]);
        assert_eq!((place(&rows[0], on_square), place(&rows[0], on_disk)), (DVec2::ZERO, DVec2::X), "{pair:?}");
        for (k, corner) in [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].into_iter().enumerate() {
            let row = rows.iter().find(|row| place(row, on_square).distance(corner) < 1e-10).unwrap();
            let image = DVec2::from_angle(std::f64::consts::FRAC_PI_2 * k as f64);
            let off = place(row, on_disk).distance(image);
            assert!(off < 1e-10, "{pair:?}: the image of {corner} is off by {off:e}");
        }
    }
}
