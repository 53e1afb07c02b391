//! `riemap map` with surfaces on either side or on both: files, options, errors.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use serde_json::Value;
use std::path::PathBuf;
use support::program::{fails, folder, succeeds};

/// The map as JSON; checks that every other format is written too.
fn written(name: &str, sides: [&str; 2], more: &[&str]) -> (Value, PathBuf) {
    let folder = folder(name);
    let out = |name: &str| folder.join(name).display().to_string();
    let files = ["map.json", "map.csv", "map.obj", "map.svg", "map.png"].map(out);
    let mut arguments = vec!["map", sides[0], sides[1], "--json", "--size", "320x160"];
    arguments.extend(more);
    for file in &files {
        arguments.extend(["--out", file]);
    }
    let output = succeeds(&arguments);
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    let document: Value = serde_json::from_str(&std::fs::read_to_string(&files[0]).unwrap()).unwrap();
    for key in ["quality", "timing_ms", "counts"] {
        assert_eq!(summary[key], document[key], "{key}");
    }
    assert_eq!(image::open(&files[4]).unwrap().to_rgb8().dimensions(), (320, 160));
    assert!(std::fs::read_to_string(&files[3]).unwrap().contains("class=\"mesh\""));
    (document, folder)
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|n| n.as_f64().unwrap()).collect()
}

#[test]
fn with_one_surface_it_is_mapped_whichever_side_it_has() {
    let sides = ["preset:hemisphere:60", "preset:disk"];
    for (name, sides) in [("surface-source", sides), ("surface-target", [sides[1], sides[0]])] {
        for direction in ["forward", "backward"] {
            let (document, folder) = written(name, sides, &["--direction", direction, "--samples", "200"]);
            assert_eq!(document["counts"]["m"], 60);
            assert!(document["quality"]["q_mean"].as_f64().unwrap() < 1.06, "{}", document["quality"]);
            let (vertices, images) = (document["vertices"].as_array().unwrap(), document["images"].as_array().unwrap());
            assert_eq!(vertices.len(), document["vertex_origins"].as_array().unwrap().len());
            for (p, q) in vertices.iter().zip(images) {
                let (p, q) = (numbers(p), numbers(q));
                assert_eq!((p.len(), q.len()), (3, 2));
                assert!(q[0].hypot(q[1]) < 1.001, "{q:?}");
            }
            let csv = std::fs::read_to_string(folder.join("map.csv")).unwrap();
            assert_eq!(csv.lines().next().unwrap().split(',').count(), 2 + 3 + 2 + 1 + 1);
            let obj = std::fs::read_to_string(folder.join("map.obj")).unwrap();
            let surface = riemap::surface::read_surface("map.obj", obj.as_bytes()).unwrap();
            assert!(surface.vertices().iter().all(|p| (p.length() - 1.0).abs() < 1e-9), "v lies on the surface");
        }
    }
}

#[test]
fn between_two_surfaces_the_images_lie_on_the_other_one() {
    let (document, folder) = written(
        "two-surfaces",
        ["preset:hemisphere:60", "preset:paraboloid:80"],
        &["--direction", "forward", "--source-point", "0,0,1", "--target-point", "0,0,0", "--target-anchor", "@0.25"],
    );
    assert_eq!(document["quality"]["flipped"], 0);
    let images: Vec<_> = document["images"].as_array().unwrap().iter().map(numbers).collect();
    for q in &images {
        let lift = q[2] - q[0].hypot(q[1]).powi(2);
        assert!((-1e-9..0.01).contains(&lift), "{q:?}");
    }
    // surfaces of revolution, axis to axis: the first boundary vertex is mapped a quarter of the rim further
    assert!((images[0][0]).abs() < 1e-2 && (images[0][1] - 1.0).abs() < 1e-2, "{:?}", images[0]);
    let vertices: Vec<_> = document["vertices"].as_array().unwrap().iter().map(numbers).collect();
    for (p, q) in vertices.iter().zip(&images).filter(|(p, _)| p[0].hypot(p[1]) > 0.1) {
        let turn = (p[0] * q[1] - p[1] * q[0]).atan2(p[0] * q[0] + p[1] * q[1]);
        assert!((turn - std::f64::consts::FRAC_PI_2).abs() < 0.05, "{p:?} → {q:?}: {turn}");
    }
    let obj = std::fs::read_to_string(folder.join("map.obj")).unwrap();
    let coordinates = obj.lines().find(|line| line.starts_with("vt ")).unwrap();
    assert_eq!(coordinates.split(' ').count(), 4, "{coordinates}");
    // written as a file, it can be read again
    let file = folder.join("map.obj").display().to_string();
    succeeds(&["map", &file, "preset:hemisphere:60", "--json"]);
}

/// A bumpy sheet whose vertices are numbered from the last to the first, after one in no face.
fn sheet() -> (String, Vec<String>) {
    let place = |k: i32| format!("{} {} {}", k % 5, k / 5, f64::from(k * k % 7) / 9.0);
    let places: Vec<String> = std::iter::once(String::from("9 9 9")).chain((0..25).rev().map(place)).collect();
    let vertices: Vec<String> = places.iter().map(|place| format!("v {place}\n")).collect();
    let number = |k: usize| 26 - k;
    let face = |k: usize| format!("f {} {} {} {}\n", number(k), number(k + 1), number(k + 6), number(k + 5));
    let faces: Vec<String> = (0..20).filter(|k| k % 5 < 4).map(face).collect();
    (vertices.concat() + &faces.concat(), places)
}

#[test]
fn files_of_a_mapped_surface_are_in_the_order_of_its_own() {
    let folder = folder("order");
    let (text, places) = sheet();
    let file = support::program::file(&folder, "sheet.obj", &text);
    let out = ["map.obj", "map.ply", "map.glb"].map(|name| folder.join(name).display().to_string());
    let outs: Vec<&str> = out.iter().flat_map(|path| ["--out", path]).collect();
    let rows = |k: usize, start: &str| -> Vec<String> {
        let text = std::fs::read_to_string(&out[k]).unwrap();
        text.lines().filter_map(|line| line.strip_prefix(start)).map(str::to_owned).collect()
    };
    let dome = "preset:hemisphere:60";
    for (sides, direction, own) in [
        ([&*file, dome], "forward", "vt "),
        ([dome, &*file], "backward", "v "),
        ([&*file, "preset:disk"], "forward", "v "),
    ] {
        succeeds(&[&["map", sides[0], sides[1], "--repair", "--direction", direction], &*outs].concat());
        assert_eq!(rows(0, own), places, "{sides:?}");
        // over an outline the file's quadrilaterals stay
        let faces = if sides[1] == "preset:disk" { 16 } else { 32 };
        assert_eq!((rows(0, "v ").len(), rows(0, "vt ").len(), rows(0, "f ").len()), (26, 26, faces));
        let read = |path: &String| riemap::surface::read_surface(path, &std::fs::read(path).unwrap()).unwrap();
        let [obj, ply, glb] = [&out[0], &out[1], &out[2]].map(read);
        assert_eq!((obj.vertices(), obj.triangles()), (ply.vertices(), ply.triangles()), "{sides:?}");
        let off =
            |p: &riemap::geometry::DVec3| glb.vertices().iter().map(|q| q.distance(*p)).fold(f64::INFINITY, f64::min);
        assert!(obj.vertices().iter().all(|p| off(p) < 1e-6), "{sides:?}");
        if own == "vt " {
            assert!(obj.vertices().iter().all(|p| (p.length() - 1.0).abs() < 0.02), "v lies on the dome");
            let ends: Vec<String> = rows(1, "").into_iter().rev().skip(32).take(26).collect();
            assert!(ends.iter().rev().zip(&places).all(|(row, place)| row.ends_with(place.as_str())), "{ends:?}");
        }
    }
    for name in ["map.ply", "map.glb"] {
        let out = folder.join(name).display().to_string();
        fails(&["map", "preset:disk", "preset:square", "--out", &out], 2, &["between outlines", "obj"]);
    }
}

#[test]
fn every_column_of_an_odd_picture_is_drawn() {
    let file = folder("odd-width").join("map.png").display().to_string();
    succeeds(&["map", "preset:hemisphere:40", "preset:saddle:40", "--size", "161x90", "--out", &file]);
    let picture = image::open(&file).unwrap().to_rgba8();
    assert_eq!(picture.dimensions(), (161, 90));
    assert!(picture.pixels().all(|pixel| pixel.0[3] == 255));
}

#[test]
fn arguments_that_do_not_fit_a_side_give_one_line() {
    let (surface, outline) = ("preset:saddle:40", "preset:disk");
    for (arguments, status, words) in [
        (vec![surface, outline, "--source-point", "0.1,0.2"], 2, vec!["--source-point", "preset:saddle:40", "surface"]),
        (vec![surface, outline, "--target-point", "0,0,1"], 2, vec!["--target-point", "preset:disk", "outline"]),
        (vec![surface, outline, "--target-anchor", "7"], 2, vec!["--target-anchor", "outline"]),
        (vec![outline, surface, "--target-anchor", "0.5,0.5"], 2, vec!["--target-anchor", "surface"]),
        (vec![outline, surface, "--target-point", "100000"], 1, vec!["--target-point", "no vertex 100000"]),
        (vec![outline, surface, "--target-point", "0"], 1, vec!["preset:saddle:40", "lies on the boundary"]),
        (vec![surface, surface, "--source-anchor", "100000"], 1, vec!["--source-anchor", "not on the boundary"]),
        (vec![outline, outline, "--source-point", "3"], 2, vec!["--source-point", "outline"]),
        (vec![outline, outline, "--target-point", "0:1,1,1"], 2, vec!["--target-point", "outline"]),
        (vec![surface, outline, "--source-samples", "100"], 2, vec!["preset:saddle:40 is a surface"]),
        (vec![surface, outline, "--extension", "cauchy-green"], 2, vec!["--extension", "surface"]),
        (vec!["preset:nothing", surface], 1, vec!["nothing"]),
        (vec!["no-such-file.obj", surface], 1, vec!["no-such-file.obj"]),
    ] {
        fails(&[&["map"], &arguments[..]].concat(), status, &words);
    }
}

/// Each square of the sheet with vertices of its own, as programs split them: the file's rows stay.
#[test]
fn files_between_two_surfaces_keep_vertices_that_the_reader_merges() {
    let folder = folder("split");
    let corner = |k: usize, (i, j): (usize, usize)| {
        let (x, y) = (k % 4 + i, k / 4 + j);
        format!("v {x} {y} {}\n", ((x * x + 3 * y) % 7) as f64 / 9.0)
    };
    let square = |k: usize| [(0, 0), (1, 0), (1, 1), (0, 1)].map(|at| corner(k, at)).concat();
    let vertices: String = (0..16).map(square).collect();
    let face = |k: usize| format!("f {} {} {} {}\n", 4 * k + 1, 4 * k + 2, 4 * k + 3, 4 * k + 4);
    let faces: Vec<String> = (0..16).map(face).collect();
    let file = support::program::file(&folder, "split.obj", &(vertices.clone() + &faces.concat()));
    let out = folder.join("map.obj").display().to_string();
    let output = succeeds(&["map", "preset:hemisphere:60", &file, "--direction", "backward", "--out", &out]);
    let text = std::fs::read_to_string(&out).unwrap();
    let rows: Vec<&str> = text.lines().filter(|line| line.starts_with("v ")).collect();
    assert_eq!(rows, vertices.lines().collect::<Vec<_>>());
    assert!(text.contains("\nf 1/1 2/2 3/3\n") || text.contains("\nf 2/2 3/3 1/1\n"), "{text}");
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("maps between two surfaces"), "{said}");
}
