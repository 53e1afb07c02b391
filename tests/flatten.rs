//! `riemap flatten`: files, options, errors.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::outline::Preset;
use riemap::surface::read_surface;
use serde_json::Value;
use std::fmt::Write as _;
use support::program::{self, file, folder, riemap, succeeds};

fn flatten<'a>(arguments: &[&'a str]) -> Vec<&'a str> {
    [&["flatten"], arguments].concat()
}

fn json(arguments: &[&str]) -> Value {
    serde_json::from_slice(&succeeds(&flatten(arguments)).stdout).unwrap()
}

fn fails(arguments: &[&str], status: i32) -> String {
    program::fails(&flatten(arguments), status, &[])
}

/// A 4×4 grid with a bump; its vertices are in scrambled order, after an unused one.
fn grid() -> String {
    let number = |i: usize, j: usize| (7 * (5 * j + i)) % 25 + 2;
    let mut vertices = vec!["v 9 9 9\n".to_owned(); 26];
    let mut faces = String::new();
    for j in 0..5 {
        for i in 0..5 {
            let z = if i == 2 && j == 2 { 1.0 } else { 0.0 };
            vertices[number(i, j) - 1] = format!("v {i} {j} {z}\n");
            if i < 4 && j < 4 {
                let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
                let _ = writeln!(faces, "f {a} {b} {c} {d}");
            }
        }
    }
    vertices.concat() + &faces
}

#[test]
fn every_format_keeps_the_file_s_vertices_and_reads_back() {
    let folder = folder("flatten-formats");
    let surface = file(&folder, "grid.obj", &grid());
    let given = read_surface("grid.obj", grid().as_bytes()).unwrap();
    let out = ["uv.obj", "uv.ply", "uv.glb", "uv.csv", "uv.svg"].map(|name| folder.join(name).display().to_string());
    let mut arguments = vec![&*surface, "preset:disk", "--repair", "--samples", "100", "--json"];
    for path in &out {
        arguments.extend(["--out", path]);
    }
    let summary = json(&arguments);
    assert_eq!(summary["counts"]["m"], 16);
    assert_eq!(summary["counts"]["n"], 9);
    assert_eq!(summary["repairs"][0], "1 vertex in no triangle was dropped");
    // 9 interior vertices; the corners of the square are mapped to a circle
    assert!(summary["quality"]["q_mean"].as_f64().unwrap() < 2.0, "{}", summary["quality"]);
    assert!(summary["timing_ms"]["surface"]["factor"].as_f64().is_some());
    for path in &out[..2] {
        let written = read_surface(path, &std::fs::read(path).unwrap()).unwrap();
        assert_eq!((written.vertices(), written.triangles()), (given.vertices(), given.triangles()), "{path}");
    }
    // GLB is f32 and its vertices are welded in the order of the faces: compare the positions of corners
    let written = read_surface("uv.glb", &std::fs::read(&out[2]).unwrap()).unwrap();
    assert_eq!(written.vertices().len(), given.vertices().len());
    let text = |k: usize| std::fs::read_to_string(&out[k]).unwrap();
    let coordinates = |line: &str| -> Vec<f64> { line.split(' ').skip(1).map(|x| x.parse().unwrap()).collect() };
    let uv: Vec<_> = text(0).lines().filter(|line| line.starts_with("vt ")).map(coordinates).collect();
    assert_eq!(uv.len(), 26);
    assert!(uv.iter().flatten().all(|x| (0.0..=1.0).contains(x)));
    assert!(uv.iter().any(|p| p[0] == 0.0) && uv.iter().any(|p| p[0] == 1.0));
    let lines = text(3);
    assert_eq!(lines.lines().nth(1), Some("9,9,9,,"));
    assert_eq!(lines.lines().count(), 27);
    assert_eq!(text(4).matches('Z').count(), given.triangles().len());
}

#[test]
fn a_picture_has_the_size_that_is_asked_for_and_shows_surface_and_layout() {
    let folder = folder("flatten-picture");
    let out = folder.join("uv.png").display().to_string();
    let arguments = ["preset:hemisphere:40", "preset:disk", "--samples", "80", "--size", "320x160", "--out", &out];
    let output = riemap(&flatten(&arguments));
    let stderr = String::from_utf8_lossy(&output.stderr);
    if stderr.contains("no graphics adapter") && std::env::var_os("CI").is_none() {
        return println!("skipped: {stderr}");
    }
    assert!(output.status.success(), "{stderr}");
    let picture = image::open(&out).unwrap().to_rgba8();
    assert_eq!(picture.dimensions(), (320, 160));
    // the middle of both halves differs from the background, which the corners show
    let ground = *picture.get_pixel(0, 0);
    assert_ne!(picture.get_pixel(80, 80), &ground);
    assert_ne!(picture.get_pixel(240, 80), &ground);
    assert_eq!(picture.get_pixel(319, 159), &ground);
}

#[test]
fn points_are_named_in_three_ways() {
    let folder = folder("flatten-points");
    let surface = file(&folder, "grid.obj", &grid().replacen("v 9 9 9", "v 0 0 0", 1));
    let base = [&*surface, "preset:square", "--repair", "--samples", "80", "--json"];
    let with = |more: &[&str]| json(&[&base, more].concat());
    // (2, 2) has the number (7·12) % 25 + 2 = 11 in the file, counted from 1
    let by_vertex = with(&["--surface-point", "10"]);
    assert_eq!(by_vertex["surface_point"]["position"], serde_json::json!([2.0, 2.0, 1.0]));
    assert_eq!(with(&["--surface-point", "2,2,1.5"])["quality"], by_vertex["quality"]);
    let inside = with(&["--surface-point", "3:1,2,1"]);
    assert_eq!(inside["surface_point"]["weights"], serde_json::json!([0.25, 0.5, 0.25]));
    assert_eq!(inside["surface_point"]["triangle"], 3);
    // (4, 0) has the number 7·4 % 25 + 2 = 5
    let anchored = with(&["--surface-anchor", "4"]);
    assert_eq!(with(&["--surface-anchor", "4.3,-1,0"])["surface_anchor"], anchored["surface_anchor"]);
    let far = |place: &str| with(&["--surface-anchor", place])["surface_anchor"].clone();
    assert_eq!(far("1e8,2e8,0"), far("7e307,1.4e308,0"), "in one direction");
    let fraction = anchored["surface_anchor"].as_f64().unwrap().to_string();
    assert_eq!(with(&["--surface-anchor", &format!("@{fraction}")])["quality"], anchored["quality"]);
    let given = with(&["--no-intrinsic-delaunay"]);
    assert_eq!(given["flips"]["flips"], 0);
    assert_eq!(with(&["--uv", "true"])["uv"]["scale"], 1.0);
}

#[test]
fn presets_of_surfaces_are_flattened() {
    for preset in ["hemisphere", "paraboloid", "saddle", "bent-strip", "half-torus", "height-field"] {
        let summary = json(&[&format!("preset:{preset}"), "preset:disk", "--samples", "300", "--json"]);
        println!("{preset}: {}", summary["quality"]);
        assert_eq!(summary["quality"]["collapsed"], 0, "{preset}");
        assert_eq!(summary["notes"], serde_json::json!([]), "{preset}");
        assert!(summary["quality"]["q_mean"].as_f64().unwrap() < 1.1, "{preset}: {}", summary["quality"]);
    }
}

#[test]
fn errors_name_their_cause() {
    let folder = folder("flatten-errors");
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let bad = file(&folder, "bad.obj", &format!("{square}f 1 2 3\nf 1 3 7\n"));
    assert!(fails(&[&bad, "preset:disk"], 1).contains("bad.obj: line 6: a face names vertex 7"));
    let turned = file(&folder, "turned.obj", &format!("{square}f 1 2 3\nf 1 4 3\n"));
    assert!(fails(&[&turned, "preset:disk"], 1).contains("different orientation"));
    let strip = file(&folder, "strip.obj", &format!("{square}v 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n"));
    // on finer triangles there is an inner way
    assert!(!json(&[&strip, "preset:disk", "--json"])["notes"].to_string().contains("fall together"));
    let notes = json(&[&strip, "preset:disk", "--no-subdivision", "--json"])["notes"].to_string();
    assert!(notes.contains("the ends of 1 boundary edge fall together: no inner way leads there"), "{notes}");
    let output = succeeds(&flatten(&[&turned, "preset:disk", "--repair"]));
    assert!(String::from_utf8_lossy(&output.stderr).contains("1 triangle was turned round"));
    assert!(fails(&["preset:cube", "preset:disk"], 1).contains("hemisphere"));
    assert!(fails(&["preset:saddle:5", "preset:disk"], 1).contains("12 to 4000"));
    assert!(fails(&["nothing.obj", "preset:disk"], 1).contains("cannot read nothing.obj"));
    let grid = file(&folder, "grid.obj", &grid());
    let at = |point: &str| fails(&[&grid, "preset:disk", "--repair", "--surface-point", point], 1);
    assert!(at("32:1,1,1").contains("no triangle 32: its 16 faces were cut into 32, counted from 0"));
    assert!(at("26").contains("no vertex 26: it has 26, counted from 0"));
    assert!(at("0").contains("vertex 0 was dropped by the repair"));
    let saddle = ["preset:saddle:40", "preset:disk"];
    let with = |more: &[&str], status| fails(&[&saddle, more].concat(), status);
    assert!(with(&["--surface-point", "0"], 1).contains("on the boundary"));
    assert!(with(&["--surface-point", "99999"], 1).contains("no vertex 99999"));
    assert!(with(&["--surface-point", "99999:1,1,1"], 1).contains("no triangle 99999"));
    assert!(with(&["--surface-anchor", "77"], 1).contains("not on the boundary"));
    let outside = with(&["--outline-point", "7,8"], 1);
    assert!(outside.contains("--outline-point: (7, 8) is not inside the outline") && !outside.contains("source"));
    assert!(with(&["--surface-point", "1,2"], 2).contains("expected a vertex"));
    assert!(with(&["--surface-point", "1:1,-1,2"], 2).contains("expected a vertex"));
    assert!(with(&["--out", "a.bmp"], 2).contains("obj, ply, glb, csv, svg or png"));
}

#[test]
fn weights_belong_to_the_corners_of_the_file_though_a_repair_turns_the_triangle() {
    let folder = folder("turned-corners");
    // a fan whose third triangle (0, 3, 4) has the opposite orientation
    let text = "v 0 0 0\nv 1 0 0\nv 0.5 1 0\nv -0.5 1 0\nv -1 0 0\nv -0.5 -1 0\nv 0.5 -1 0\n\
                f 1 2 3\nf 1 3 4\nf 1 5 4\nf 1 5 6\nf 1 6 7\nf 1 7 2\n";
    let surface = file(&folder, "fan.obj", text);
    let summary = json(&[&surface, "preset:disk", "--repair", "--surface-point", "2:0.5,0.2,0.3", "--json"]);
    let number = |value: &Value| value.as_f64().unwrap();
    let [x, y] = [0, 1].map(|i| number(&summary["surface_point"]["position"][i]));
    // 0.5 · (0, 0) + 0.2 · (−1, 0) + 0.3 · (−0.5, 1)
    assert!((x + 0.35).abs() < 1e-15 && (y - 0.3).abs() < 1e-15, "({x}, {y})");
    assert_eq!([0, 1, 2].map(|i| number(&summary["surface_point"]["weights"][i])), [0.5, 0.2, 0.3]);
}

#[test]
fn a_glb_keeps_the_shape_of_what_is_far_away_large_or_small() {
    let folder = folder("glb-frames");
    for (name, offset, scale) in [("far", 1e9, 1.0), ("large", 0.0, 1e40), ("small", 0.0, 1e-50), ("usual", 0.0, 1.0)] {
        let vertices: Vec<[f64; 3]> =
            (0..25).map(|k| [f64::from(k % 5), f64::from(k / 5), f64::from(k * k % 7) / 9.0]).collect();
        let placed: Vec<[f64; 3]> = vertices.iter().map(|p| p.map(|x| offset + scale * x)).collect();
        let mut text = String::new();
        for [x, y, z] in &placed {
            let _ = writeln!(text, "v {x:e} {y:e} {z:e}");
        }
        for k in (0..20).filter(|k| k % 5 < 4) {
            let _ = writeln!(text, "f {} {} {} {}", k + 1, k + 2, k + 7, k + 6);
        }
        let (surface, out) = (file(&folder, "grid.obj", &text), folder.join(format!("{name}.glb")));
        let out = out.to_str().unwrap();
        json(&[&surface, "preset:disk", "--out", out, "--json"]);
        let read = read_surface(out, &std::fs::read(out).unwrap()).unwrap();
        assert_eq!(read.vertices().len(), 25, "{name}");
        for (p, q) in placed.iter().zip(read.vertices()) {
            let distance = (0..3).map(|i| (p[i] - q[i]).abs()).fold(0.0, f64::max);
            assert!(distance < 2e-6 * scale, "{name}: {p:?} became {q}");
        }
    }
}

#[test]
fn new_vertices_at_corners_follow_those_of_the_file_and_say_what_they_divide() {
    let folder = folder("corners");
    let surface = file(&folder, "grid.obj", &grid());
    let given = read_surface("grid.obj", grid().as_bytes()).unwrap();
    let base = ["preset:square", "--repair", "--samples", "200", "--uv", "true", "--surface-anchor", "@0.03", "--json"];
    let out = ["uv.obj", "uv.ply", "uv.csv"].map(|name| folder.join(name).display().to_string());
    let outs: Vec<&str> = out.iter().flat_map(|path| ["--out", path]).collect();
    let summary = json(&[&[&*surface], &base[..], &outs].concat());
    let corners = &summary["corners"];
    let divisions = corners["divisions"].as_array().unwrap();
    assert_eq!((&corners["hit"], &corners["folded"]), (&4.into(), &0.into()));
    assert!(!divisions.is_empty());
    let text = |k: usize| std::fs::read_to_string(&out[k]).unwrap();
    for (path, k) in [(&out[0], 0), (&out[1], 1)] {
        let written = read_surface(path, text(k).as_bytes()).unwrap();
        assert_eq!(written.vertices()[..26], *given.vertices(), "{path}");
        assert_eq!(written.vertices().len(), 26 + divisions.len(), "{path}");
        assert_eq!(
            text(k).matches("divides the edge").count() + text(k).matches("is the middle").count(),
            divisions.len()
        );
        for (place, division) in written.vertices()[26..].iter().zip(divisions) {
            let Some(edge) = division["edge"].as_array() else { continue };
            let [a, b] = [0, 1].map(|i| given.vertices()[edge[0][i].as_u64().unwrap() as usize]);
            assert_eq!(*place, a.lerp(b, edge[1].as_f64().unwrap()), "{path}");
        }
    }
    let obj = text(0);
    for corner in Preset::Square.outline().corner_places() {
        let line = format!("vt {} {}", corner.x, corner.y);
        assert_eq!(obj.lines().filter(|found| *found == line).count(), 1, "{line}");
    }
    assert!(text(2).starts_with("x,y,z,u,v,edge from,edge to,at\n9,9,9,,,,,\n"), "{}", text(2));
    let free = json(&[&[&*surface], &base[..], &["--corners", "free", "--out", &out[2]]].concat());
    assert!(free["corners"].is_null());
    assert!(text(2).starts_with("x,y,z,u,v\n9,9,9,,\n") && text(2).lines().count() == 27);
    let output = succeeds(&flatten(&[&surface, "preset:square", "--repair"]));
    assert!(String::from_utf8_lossy(&output.stdout).contains("4 corners are hit, with"));
}

#[test]
fn any_boundary_loop_becomes_the_outline() {
    let folder = folder("loops");
    // a frame of eight squares around a hole
    let mut text = String::new();
    for k in 0..16 {
        let _ = writeln!(text, "v {} {} 0", k % 4, k / 4);
    }
    for k in (0..11).filter(|k| k % 4 < 3 && *k != 5) {
        let _ = writeln!(text, "f {} {} {} {}", k + 1, k + 2, k + 6, k + 5);
    }
    let surface = file(&folder, "frame.obj", &text);
    let with = |more: &[&str]| json(&[&[&*surface, "preset:disk", "--repair", "--json"], more].concat());
    assert_eq!(with(&[])["counts"]["m"], 12);
    assert_eq!(with(&["--boundary-loop", "1"])["counts"]["m"], 12);
    assert_eq!(with(&["--boundary-loop", "2"])["counts"]["m"], 4);
    let missing = fails(&[&surface, "preset:disk", "--repair", "--boundary-loop", "3"], 1);
    assert!(missing.contains("2 boundary loops") && missing.contains("not 3"), "{missing}");
    fails(&[&surface, "preset:disk", "--boundary-loop", "2"], 2);
    fails(&[&surface, "preset:disk", "--repair", "--boundary-loop", "0"], 2);
}

/// A flat sheet over its own outline with its corners pinned: the identity, up to the error of the sheet's finite elements.
#[test]
fn pins_on_the_corners_of_a_sheet_make_its_layout_the_sheet_itself() {
    let folder = folder("flatten-pins");
    let (cells, mut sheet) = (20, String::new());
    let at = |i: usize| 2.0 * i as f64 / cells as f64 - 1.0;
    for j in 0..=cells {
        (0..=cells).for_each(|i| writeln!(sheet, "v {} {} 0", at(i), at(j)).unwrap());
    }
    for (i, j) in (0..cells * cells).map(|cell| (cell % cells, cell / cells)) {
        let a = (cells + 1) * j + i + 1;
        writeln!(sheet, "f {a} {} {} {}", a + 1, a + cells + 2, a + cells + 1).unwrap();
    }
    let surface = file(&folder, "sheet.obj", &sheet);
    let outline = file(&folder, "square.json", "[[-1,-1],[1,-1],[1,1],[-1,1]]");
    let out = folder.join("sheet.csv").display().to_string();
    let mut arguments = vec![&*surface, &*outline, "--uv", "true", "--corners", "free", "--json", "--out", &*out];
    for pin in ["-1,-1,0:-1,-1", "1,-1,0:1,-1", "1,1,0:1,1", "-1,1,0:-1,1"] {
        arguments.extend(["--pin", pin]);
    }
    let summary = json(&arguments);
    assert!(summary["timing_ms"]["outline"]["integral"].as_f64().unwrap() > 0.0, "the outline's kernel is sharp");
    assert_eq!(summary["pins"].as_array().unwrap().len(), 4);
    assert!(summary["pins"].as_array().unwrap().iter().all(|pin| pin["miss"].as_f64().unwrap() < 1e-2), "{summary}");
    let text = std::fs::read_to_string(&out).unwrap();
    let row = |line: &str| -> Vec<f64> { line.split(',').map(|x| x.parse().unwrap()).collect() };
    let off = text.lines().skip(1).map(row).map(|p| (p[0] - p[3]).hypot(p[1] - p[4])).fold(0.0, f64::max);
    println!("the layout is off by {off:.1e}");
    assert!(off < 1e-2, "{off}");
    let text = fails(&[&surface, &outline, "--pin", "@0:@0"], 2);
    assert!(text.contains("--pin: three pairs determine a map"), "{text}");
    let text = fails(&[&surface, &outline, "--pin", "0,0:@0", "--pin", "@0.3:@0.3", "--pin", "@0.6:@0.6"], 2);
    assert!(text.contains("--pin: P is a surface's"), "{text}");
}
