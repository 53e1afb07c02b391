//! `--optimise` of `riemap map` and `riemap flatten`.

use super::support::program::{fails, file, folder, succeeds};
use serde_json::Value;

fn summary(arguments: &[&str]) -> Value {
    serde_json::from_slice(&succeeds(arguments).stdout).unwrap()
}

fn improved(summary: &Value) -> [f64; 2] {
    let best = &summary["optimised"];
    let [before, after] = ["before", "after"].map(|key| best[key].as_f64().unwrap());
    println!("{best}");
    assert!(after <= before && best["evaluations"].as_u64() > Some(100) && best["milliseconds"].as_f64() > Some(0.0));
    [before, after]
}

#[test]
fn the_best_map_and_its_constraints_are_printed_and_give_the_same_map() {
    let named = ["map", "preset:l-shape", "preset:disk", "--kernel", "adjoint", "--refine", "off", "--json"];
    let first = summary(&[&named[..], &["--optimise", "area"]].concat());
    let [before, after] = improved(&first);
    assert!(first["optimised"]["criterion"] == "area" && after < 0.9 * before);
    let point = |key: &str| format!("{},{}", first[key][0], first[key][1]);
    let anchor = |key: &str| format!("@{}", first[key]);
    let given = [
        format!("--source-point={}", point("source_point")),
        format!("--target-point={}", point("target_point")),
        format!("--source-anchor={}", anchor("source_anchor")),
        format!("--target-anchor={}", anchor("target_anchor")),
    ];
    let given: Vec<&str> = given.iter().map(String::as_str).collect();
    let again = summary(&[&named[..], &given].concat());
    assert_eq!(again["quality"], first["quality"]);
    assert!(again.get("optimised").is_none());
}

#[test]
fn a_surface_is_flattened_with_less_distortion() {
    let named =
        ["flatten", "preset:saddle:60", "preset:square", "--json", "--optimize", "scale", "--surface-point", "70"];
    let summary = summary(&named);
    let [before, after] = improved(&summary);
    assert!(after < before && summary["outline_point"].as_array().unwrap().len() == 2, "{summary}");
}

#[test]
fn a_region_is_read_from_a_file_and_what_is_wrong_with_it_is_said() {
    let folder = folder("region");
    let region = |name: &str, text: &str| format!("region:{}", file(&folder, name, text));
    let two = region("two.json", "[[[0.1,-0.9],[0.5,-0.9],[0.5,-0.5]],[[-0.9,0.1],[-0.5,0.1],[-0.5,0.5]]]");
    let named = ["map", "preset:l-shape", "preset:disk", "--kernel", "adjoint", "--refine", "off", "--json"];
    improved(&summary(&[&named[..], &["--optimise", &two]].concat()));
    let refused = |region: &str, status: i32, words: &[&str]| {
        fails(&[&named[..], &["--optimise", region]].concat(), status, words);
    };
    refused(&region("crossed.json", "[[[0,0],[1,1],[1,0],[0,1]]]"), 1, &["crossed.json", "polygon 1", "cross"]);
    refused(&region("text.json", "[[[0,0],[1,"), 1, &["text.json"]);
    refused(&region("far.json", "[[[10,10],[11,10],[11,11]]]"), 1, &["holds no triangle"]);
    refused("region:/nowhere/at/all.json", 1, &["cannot read /nowhere/at/all.json"]);
    refused("region:", 2, &["area, scale, region:FILE or symmetry"]);
    refused("beauty", 2, &["area, scale, region:FILE or symmetry"]);
}

#[test]
fn pins_and_surfaces_conflict_with_it() {
    let pins = ["--pin", "@0.1:@0.8", "--pin", "@0.4:@0.5", "--pin", "@0.8:@0.1"];
    fails(
        &[&["map", "preset:disk", "preset:heart", "--optimise", "area"][..], &pins].concat(),
        2,
        &["--pin", "--optimise"],
    );
    let on_surface = ["map", "preset:saddle:60", "preset:disk", "--optimise", "region:none.json"];
    fails(&on_surface, 2, &["the source is a surface"]);
    fails(&["flatten", "preset:saddle:60", "preset:disk", "--optimise", "symmetry"], 2, &["those of two outlines"]);
    let unlike = ["map", "preset:l-shape", "preset:blob", "--kernel", "adjoint", "--optimise", "symmetry"];
    println!("{}", fails(&unlike, 1, &["no symmetry in common"]));
}
