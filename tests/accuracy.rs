//! `riemap accuracy`: the files and the words that it writes.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use support::program::{fails, folder, succeeds};

#[test]
fn the_ladder_is_written_as_table_and_figure_and_said() {
    let folder = folder("accuracy");
    let [csv, svg] = ["accuracy.csv", "accuracy.svg"].map(|name| folder.join(name).to_str().unwrap().to_owned());
    let output =
        succeeds(&["accuracy", "--quick", "--shape", "l-shape", "--shape", "disk", "--out", &csv, "--out", &svg]);
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("L-shape: exact values at the corners only"), "{said}");
    let table = std::fs::read_to_string(&csv).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0][..5], ["shape", "method", "m", "unknowns", "omega_max"]);
    let omega = |shape: &str, method: &str| -> f64 {
        let row = rows.iter().rfind(|row| row[..2] == [shape, method]).unwrap();
        row[4].parse().unwrap()
    };
    for shape in ["disk", "l-shape"] {
        assert!(omega(shape, "integral") < 1e-12, "{shape}: {table}");
        assert!((1e-8..1e-2).contains(&omega(shape, "adjoint-default")), "{shape}: {table}");
    }
    assert!(!table.contains("blob"), "only the outlines asked for: {table}");
    let figure = std::fs::read_to_string(&svg).unwrap();
    assert!(figure.starts_with("<svg") && !figure.contains("NaN") && !figure.contains("inf"), "a point at infinity");
}

#[test]
fn json_has_the_machine_and_a_row_for_each_resolution() {
    let output = succeeds(&["accuracy", "--quick", "--shape", "disk", "--json"]);
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(report["machine"]["threads"], 1);
    let rows = report["rows"].as_array().unwrap();
    assert_eq!(rows.len(), 12, "{report}");
    assert!(rows.iter().all(|row| row["shape"] == "disk" && row["omega"]["max"].is_f64()), "{report}");
}

#[test]
fn other_formats_are_refused_before_anything_is_measured() {
    fails(&["accuracy", "--out", "accuracy.png"], 2, &["csv", "svg"]);
}
