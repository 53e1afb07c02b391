//! `riemap map --points`: the map at any points, there and back; its table, and errors in its input.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use support::program::{fails, file, folder, succeeds};

const HEADER: &str = "x,y,u,v,re,im,error,status";

/// The rows of a table: its numbers, NaN where there is none, and the status.
fn rows(path: &str) -> Vec<([f64; 7], String)> {
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some(HEADER));
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        assert_eq!(fields.len(), 8, "{line}");
        let number = |k: usize| if fields[k].is_empty() { f64::NAN } else { fields[k].parse().unwrap() };
        (std::array::from_fn(number), fields[7].to_owned())
    };
    lines.map(row).collect()
}

#[test]
fn a_moebius_map_of_the_disk_has_its_values_in_either_direction_of_the_mesh() {
    let folder = folder("moebius");
    let points = file(&folder, "in.csv", "x,y\n# a comment\n\n0.6,0.2\n0.0, 0.0\n0.999999,0\n1,0\n2,0\n");
    let out = folder.join("out.csv").display().to_string();
    for direction in ["forward", "backward"] {
        let arguments = ["map", "preset:disk", "preset:disk", "--kernel", "integral", "--direction", direction];
        let constraints = ["--source-point", "0.6,0.2", "--target-point", "0,-0.5", "--points", &points, "--out", &out];
        succeeds(&[&arguments[..], &constraints].concat());
        let rows = rows(&out);
        let found: Vec<&str> = rows.iter().map(|(_, status)| status.as_str()).collect();
        assert_eq!(found, ["inside", "inside", "inside", "boundary", "outside"]);
        // (1 − 5i + 6iz)/(6 + (−5 + i)z) at 0.6 + 0.2i, at 0, and at 1
        let exact = [[0.0, -0.5], [1.0 / 6.0, -5.0 / 6.0]];
        for ((numbers, _), [u, v]) in rows.iter().zip(exact) {
            let off = (numbers[2] - u).hypot(numbers[3] - v);
            assert!(off < 1e-12 && off <= numbers[6] && numbers[6] < 1e-10, "{numbers:?} is off by {off:e}");
        }
        // f′(0) = (6i · 6 − (1 − 5i)(−5 + i))/36 = 10i/36 − 0i
        let slope = rows[1].0;
        assert!((slope[4] - 0.0).hypot(slope[5] - 10.0 / 36.0) < 1e-11, "{slope:?}");
        let near = rows[2].0;
        assert!((near[2] - 1.0).hypot(near[3]) < 1e-5, "{near:?}");
        assert!((rows[3].0[2] - 1.0).hypot(rows[3].0[3]) < 1e-12, "{:?}", rows[3]);
        assert!(rows[4].0[2..].iter().all(|number| number.is_nan()), "{:?}", rows[4]);
    }
}

#[test]
fn errors_with_finite_elements_are_covered_either_way_and_not_by_far_too_much() {
    let folder = folder("finite elements");
    let row = |k: f64| {
        let r = 0.97 * (k / 300.0).sqrt();
        format!("{},{}", r * (2.4 * k).cos(), r * (2.4 * k).sin())
    };
    let rows_in: Vec<String> = (0..300).map(f64::from).map(row).collect();
    let points = file(&folder, "in.csv", &rows_in.join("\n"));
    let out = folder.join("out.csv").display().to_string();
    for inverse in [false, true] {
        let arguments =
            ["map", "preset:disk", "preset:disk", "--kernel", "adjoint", "--points", &points, "--out", &out];
        let constraints = ["--source-point", "0.6,0.2", "--target-point", "0,-0.5"];
        succeeds(&[&arguments[..], &constraints, if inverse { &["--inverse"] } else { &[] }].concat());
        let mut factors: Vec<f64> = Vec::new();
        for (numbers, status) in rows(&out) {
            assert_eq!(status, "inside");
            // f = (1 − 5i + 6iz)/(6 + (−5 + i)z), f⁻¹ = (1 − 5i − 6w)/((−5 + i)w − 6i)
            let [x, y] = [numbers[0], numbers[1]];
            let (top, bottom) = if inverse {
                ([1.0 - 6.0 * x, -5.0 - 6.0 * y], [-5.0 * x - y, x - 5.0 * y - 6.0])
            } else {
                ([1.0 - 6.0 * y, -5.0 + 6.0 * x], [6.0 - 5.0 * x - y, x - 5.0 * y])
            };
            let size = bottom[0] * bottom[0] + bottom[1] * bottom[1];
            let exact =
                [(top[0] * bottom[0] + top[1] * bottom[1]) / size, (top[1] * bottom[0] - top[0] * bottom[1]) / size];
            factors.push(numbers[6] / (numbers[2] - exact[0]).hypot(numbers[3] - exact[1]));
        }
        factors.sort_by(f64::total_cmp);
        let covered = factors.iter().filter(|&&factor| factor >= 1.0).count();
        println!("inverse {inverse}: {covered} of 300 covered, by {:.1} in the median", factors[150]);
        assert!(covered >= 285 && factors[150] < 100.0, "inverse {inverse}: {covered}, {}", factors[150]);
    }
}

#[test]
fn there_and_back_between_outlines_with_corners() {
    let folder = folder("there and back");
    let inside: Vec<[f64; 2]> =
        (0..200).map(f64::from).map(|k| [0.9 * (0.7 * k).sin(), 0.9 * (1.3 * k).cos()]).collect();
    let write = |points: &[[f64; 2]], name: &str| {
        let text: String = points.iter().map(|[x, y]| format!("{x};{y}")).collect::<Vec<_>>().join("\n");
        file(&folder, name, &text)
    };
    let points = write(&inside, "in.csv");
    let [there, back] = ["there.csv", "back.csv"].map(|name| folder.join(name).display().to_string());
    let common = ["map", "preset:square", "preset:l-shape", "--kernel", "integral", "--source-anchor", "@0.3"];
    succeeds(&[&common[..], &["--points", &points, "--out", &there]].concat());
    let first: Vec<_> = rows(&there).into_iter().filter(|(_, status)| status == "inside").collect();
    assert!(first.len() > 100, "{}", first.len());
    let images: Vec<[f64; 2]> = first.iter().map(|(row, _)| [row[2], row[3]]).collect();
    let images = write(&images, "images.csv");
    succeeds(&[&common[..], &["--points", &images, "--inverse", "--out", &back]].concat());
    for ((a, _), (b, status)) in first.iter().zip(rows(&back)) {
        assert_eq!(status, "inside");
        let off = (a[0] - b[2]).hypot(a[1] - b[3]);
        let estimate = b[6] + a[6] * b[4].hypot(b[5]);
        assert!(off < 1e-8 && off <= 2.0 * estimate, "{a:?} and {b:?}: off by {off:e}, estimated {estimate:e}");
        // f′ g′ = 1
        let [re, im] = [a[4] * b[4] - a[5] * b[5], a[4] * b[5] + a[5] * b[4]];
        assert!((re - 1.0).hypot(im) < 1e-6, "{re} + {im} i");
    }
}

#[test]
fn bad_input_is_named_with_its_line() {
    let folder = folder("bad input");
    let out = folder.join("out.csv").display().to_string();
    let run = |text: &str, status: i32, words: &[&str]| {
        let points = file(&folder, "in.csv", text);
        fails(&["map", "preset:disk", "preset:square", "--points", &points, "--out", &out], status, words)
    };
    run("x,y\n0,0\n1\n", 1, &["in.csv", "line 3", "1 number"]);
    run("0,0\n0.1,abc\n", 1, &["in.csv", "line 2", "abc"]);
    run("0,0\n0,nan\n", 1, &["in.csv", "line 2"]);
    run("0,0\n\n0,1,2\n", 1, &["in.csv", "line 3", "3 numbers"]);
    run("# nothing\n", 1, &["in.csv", "empty"]);
    assert!(!std::path::Path::new(&out).exists());
    let points = file(&folder, "in.csv", "0,0\n");
    fails(&["map", "preset:disk", "preset:disk", "--points", &points], 2, &["--points", ".csv"]);
    fails(&["map", "preset:disk", "preset:disk", "--inverse", "--out", &out], 2, &["--points"]);
    fails(&["map", "preset:disk", "preset:disk", "--points", "missing.csv", "--out", &out], 1, &["missing.csv"]);
    let surface = ["map", "preset:hemisphere", "preset:disk", "--points", &points, "--out", &out];
    fails(&surface, 2, &["preset:hemisphere is a surface"]);
}

#[test]
fn vertices_can_be_placed_exactly() {
    let folder = folder("exact");
    let out = folder.join("map.obj").display().to_string();
    let arguments =
        ["map", "preset:disk", "preset:square", "--kernel", "integral", "--extension", "exact", "--out", &out];
    let output = succeeds(&[&arguments[..], &["--json"]].concat());
    let summary: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(summary["quality"]["flipped"], 0);
    fails(&["map", "preset:hemisphere", "preset:disk", "--extension", "exact"], 2, &["surface"]);
}
