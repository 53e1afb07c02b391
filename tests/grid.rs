//! `riemap grid`: known grids and moduli, right angles, the formats, and what is refused.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

mod support;

use riemap::conformal::GridCells;
use riemap::export::GridFormat;
use riemap::geometry::DVec2;
use riemap::outline::{CurveForm, Preset};
use riemap::worker::{GridContent, GridTask, StudiedOutline};
use serde_json::Value;
use std::f64::consts::TAU;
use std::path::Path;
use support::program::{fails, file, folder, names, succeeds};

const L: &str = "[[0,0],[2,0],[2,1],[1,1],[1,2],[0,2]]";
const SQUARE: &str = "[[0,0],[1,0],[1,1],[0,1]]";

/// A grid and its summary.
struct Made {
    json: Value,
    /// The rows of nodes of constant j.
    rows: Vec<Vec<DVec2>>,
}

impl Made {
    fn new(folder: &Path, outline: &str, marks: &str, cells: &str) -> Self {
        let path = folder.join("grid.csv").display().to_string();
        let arguments = ["grid", outline, "--marks", marks, "--cells", cells, "--out", &path, "--json"];
        let json = serde_json::from_slice(&succeeds(&arguments).stdout).unwrap();
        Self { json, rows: rows(&std::fs::read_to_string(path).unwrap()) }
    }

    fn number(&self, key: &str) -> f64 {
        self.json[key].as_f64().unwrap()
    }

    /// The modulus is right to `tolerance`, and its error says so.
    fn assert_modulus(&self, name: &str, expected: f64, tolerance: f64) {
        let [value, error] = ["value", "error"].map(|key| self.json["modulus"][key].as_f64().unwrap());
        let off = (value - expected).abs();
        assert!(off <= tolerance, "{name}: modulus {value} for {expected}, off by {off:e}");
        assert!(off <= error + f64::EPSILON && error <= 100.0 * tolerance, "{name}: off by {off:e}, said {error:e}");
    }

    /// The largest deviation from 90°, in degrees, of differences of fourth order along the rows and columns, at nodes at
    /// least `margin` steps from the boundary: beside the program's own measurement, one of the file.
    fn deviation(&self, margin: usize) -> f64 {
        let rows = &self.rows;
        let mut worst = 0.0_f64;
        for j in margin..rows.len() - margin {
            for i in margin..rows[j].len() - margin {
                let along = 8.0 * (rows[j][i + 1] - rows[j][i - 1]) - (rows[j][i + 2] - rows[j][i - 2]);
                let across = 8.0 * (rows[j + 1][i] - rows[j - 1][i]) - (rows[j + 2][i] - rows[j - 2][i]);
                worst = worst.max((along.angle_to(across).to_degrees() - 90.0).abs());
            }
        }
        worst
    }
}

/// The rows of a table `i,j,x,y`, in order.
fn rows(text: &str) -> Vec<Vec<DVec2>> {
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("i,j,x,y"));
    let mut rows: Vec<Vec<DVec2>> = Vec::new();
    for line in lines {
        let [i, j, x, y] = <[&str; 4]>::try_from(line.split(',').collect::<Vec<_>>()).unwrap();
        let (i, j): (usize, usize) = (i.parse().unwrap(), j.parse().unwrap());
        if i == 0 {
            rows.push(Vec::new());
        }
        assert_eq!((j + 1, i), (rows.len(), rows[j].len()), "{line}");
        rows[j].push(DVec2::new(x.parse().unwrap(), y.parse().unwrap()));
    }
    rows
}

#[test]
fn the_grid_of_a_rectangle_between_its_corners_is_the_lattice() {
    let folder = folder("lattice");
    let rectangle = file(&folder, "rectangle.json", "[[0,0],[2,0],[2,1],[0,1]]");
    let tall = file(&folder, "tall.json", "[[1,1],[2,1],[2,4],[1,4]]");
    let square = file(&folder, "square.json", SQUARE);
    let third = 1.0 / 3.0;
    for (path, marks, [low, size]) in [
        (&square, "0,0.25,0.5,0.75".to_owned(), [DVec2::ZERO, DVec2::ONE]),
        (&rectangle, format!("0,{third},0.5,{}", 0.5 + third), [DVec2::ZERO, DVec2::new(2.0, 1.0)]),
        (&tall, "0,0.125,0.5,0.625".to_owned(), [DVec2::ONE, DVec2::new(1.0, 3.0)]),
    ] {
        let made = Made::new(&folder, path, &marks, "10x6");
        made.assert_modulus(path, size.y / size.x, 1e-12);
        assert_eq!((made.rows.len(), made.rows[0].len()), (7, 11));
        let mut worst = 0.0_f64;
        for (j, row) in made.rows.iter().enumerate() {
            for (i, node) in row.iter().enumerate() {
                let expected = low + size * DVec2::new(i as f64 / 10.0, j as f64 / 6.0);
                worst = worst.max(node.distance(expected));
            }
        }
        let said = made.number("image_error");
        assert!(worst < 1e-12 && worst <= said && said < 1e-10, "{path}: off by {worst:e}, said to be {said:e}");
        assert!(made.number("angle_deviation") < 1e-8, "{}", made.json);
    }
}

#[test]
fn known_quadrilaterals_have_their_moduli() {
    let folder = folder("moduli");
    let l = file(&folder, "l.json", L);
    for (outline, marks, expected) in [
        (l.as_str(), "0.25,0.375,0.625,0.75", 2.558_523_142_342_013),
        (&l, "0,0.25,0.625,0.75", 3.0_f64.sqrt()),
        (&l, "0.25,0.625,0.75,0", 3.0_f64.sqrt().recip()),
        ("preset:disk", "0,0.175,0.35,0.625", 1.045_465_950_033_828_6),
        ("preset:disk", "0.05,0.3,0.55,0.8", 1.0),
        ("preset:square", "0.125,0.375,0.625,0.875", 1.0),
    ] {
        let made = Made::new(&folder, outline, marks, "4x4");
        made.assert_modulus(&format!("{outline}, {marks}"), expected, 1e-12);
        // a node next to a corner of 90°, as that at (0, 0), is known to the root of the measure's error
        assert!(made.number("image_error") < 1e-6, "{outline}: {}", made.json);
    }
}

#[test]
fn the_grid_of_symmetric_marks_on_the_disk_has_their_symmetry() {
    let made = Made::new(&folder("symmetric"), "preset:disk", "0,0.25,0.5,0.75", "8x8");
    let middle = made.rows[4][4];
    for (i, j) in (0..=8).flat_map(|i| (0..=8).map(move |j| (i, j))) {
        let (node, turned) = (made.rows[j][i] - middle, made.rows[i][8 - j] - middle);
        assert!(node.perp().distance(turned) < 1e-12, "({i}, {j}): {node} and {turned}");
    }
}

/// The distance of a point from the L.
fn off_l(p: DVec2) -> f64 {
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]].map(DVec2::from_array);
    let off = |k: usize| {
        let (a, b) = (corners[k], corners[(k + 1) % 6]);
        let t = ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        p.distance(a.lerp(b, t))
    };
    (0..6).map(off).fold(f64::INFINITY, f64::min)
}

#[test]
fn corners_are_the_marks_and_boundary_nodes_lie_on_the_outline() {
    let folder = folder("boundary");
    let l = file(&folder, "l.json", L);
    let made = Made::new(&folder, &l, "0.25,0.375,0.625,0.75", "12x5");
    let corners = [[2.0, 0.0], [2.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    assert_eq!(made.json["corners"], serde_json::json!(corners));
    let of_file = [made.rows[0][0], made.rows[0][12], made.rows[5][12], made.rows[5][0]];
    assert_eq!(of_file.map(|corner| corner.to_array()), corners);
    for (j, row) in made.rows.iter().enumerate() {
        for (i, &node) in row.iter().enumerate() {
            let is_on = i == 0 || j == 0 || i == 12 || j == 5;
            assert_eq!(off_l(node) < 1e-15, is_on, "({i}, {j}) at {node}: {:e}", off_l(node));
        }
    }
    // marks inside of sides, in another order
    let made = Made::new(&folder, "preset:disk", "0.9,0.05,0.3,0.65", "9x9");
    let row = made.rows[0].iter().chain(&made.rows[9]);
    let radius = made.rows[0][0].length();
    for node in row.chain(made.rows.iter().map(|row| &row[0])) {
        assert!((node.length() / radius - 1.0).abs() < 1e-14, "{node}");
    }
}

#[test]
fn lines_meet_at_right_angles() {
    let folder = folder("angles");
    for (preset, marks) in [
        ("disk", "0.02,0.3,0.45,0.8"),
        ("square", "0.1,0.2,0.6,0.9"),
        ("l-shape", "0.05,0.3,0.55,0.8"),
        ("blob", "0,0.25,0.5,0.75"),
        ("heart", "0.1,0.4,0.6,0.9"),
        ("cinquefoil", "0.1,0.35,0.6,0.85"),
        ("star", "0.1,0.2,0.6,0.9"),
        ("hand", "0,0.25,0.5,0.75"),
        ("v-shape", "0.1,0.2,0.6,0.9"),
        ("spiral", "0.3,0.32,0.34,0.36"),
    ] {
        let made = Made::new(&folder, &format!("preset:{preset}"), marks, "48x48");
        let (said, found, error) = (made.number("angle_deviation"), made.deviation(8), made.number("image_error"));
        println!("{preset}: {said:e} by the program, {found:e} by the file's nodes; nodes to {error:e}");
        assert!(said < 1e-6, "{preset}: off by {said:e} degrees");
        assert!(found < 0.1, "{preset}: off by {found:e} degrees");
        // in the tips of the V, which the corners leave behind, measures are almost nothing
        assert!(error < 1e-4, "{preset}: nodes to {error:e}");
    }
}

#[test]
fn every_format_holds_the_same_nodes() {
    let folder = folder("formats");
    let l = file(&folder, "l.json", L);
    let out = |name: &str| folder.join(name).display().to_string();
    let [csv, svg, obj, vtk] = ["g.csv", "g.svg", "g.obj", "g.VTK"].map(out);
    let arguments = ["grid", &l, "--marks", "0,0.25,0.5,0.75", "--cells", "7x4"];
    let output = succeeds(&[&arguments[..], &["--out", &csv, "--out", &svg, "--out", &obj, "--out", &vtk]].concat());
    let text = String::from_utf8(output.stdout).unwrap();
    for word in ["modulus", "7 x 4", "angles", "±"] {
        assert!(text.contains(word), "no {word:?} in {text}");
    }
    let read = |path: &str| std::fs::read_to_string(path).unwrap();
    let nodes: Vec<DVec2> = rows(&read(&csv)).concat();
    assert_eq!(nodes.len(), 8 * 5);
    let point = |line: &str| -> DVec2 {
        let numbers: Vec<f64> = line.split(' ').map(|word| word.parse().unwrap()).collect();
        assert_eq!((numbers.len(), numbers[2]), (3, 0.0), "{line}");
        DVec2::new(numbers[0], numbers[1])
    };
    let obj = read(&obj);
    let vertices: Vec<DVec2> = obj.lines().filter_map(|line| line.strip_prefix("v ")).map(point).collect();
    assert_eq!(vertices, nodes);
    let faces: Vec<Vec<usize>> = obj
        .lines()
        .filter_map(|line| line.strip_prefix("f "))
        .map(|line| line.split(' ').map(|word| word.parse().unwrap()).collect())
        .collect();
    assert_eq!(faces.len(), 7 * 4);
    let area = |face: &Vec<usize>| -> f64 {
        let places: Vec<DVec2> = face.iter().map(|k| vertices[k - 1]).collect();
        assert_eq!(places.len(), 4);
        0.5 * (places[2] - places[0]).perp_dot(places[3] - places[1])
    };
    assert!(faces.iter().all(|face| area(face) > 0.0), "a cell is not counter-clockwise");
    // but for chords across corners, the cells fill the L
    let total: f64 = faces.iter().map(area).sum();
    assert!((2.5..3.0).contains(&total), "{total}");
    let vtk = read(&vtk);
    let mut lines = vtk.lines();
    assert_eq!(lines.next(), Some("# vtk DataFile Version 3.0"));
    let head: Vec<&str> = lines.by_ref().skip(1).take(4).collect();
    assert_eq!(head, ["ASCII", "DATASET STRUCTURED_GRID", "DIMENSIONS 8 5 1", "POINTS 40 double"]);
    assert_eq!(lines.map(point).collect::<Vec<_>>(), nodes);
    let svg = read(&svg);
    // six lines of constant i and three of constant j inside of the outline, and four corners
    assert_eq!(svg.matches("<path").count(), 1 + 6 + 3);
    assert_eq!(svg.matches("class=\"corner\"").count(), 4);
    assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n"));
}

#[test]
fn one_cell_is_the_quadrilateral_itself() {
    let made = Made::new(&folder("one"), "preset:square", "0,0.25,0.5,0.75", "1x1");
    assert_eq!((made.rows.len(), made.rows[0].len()), (2, 2));
    assert!(made.json["angle_deviation"].is_null(), "{}", made.json);
}

#[test]
fn bad_input_is_refused_with_its_cause() {
    let folder = folder("bad");
    let out = folder.join("g.csv").display().to_string();
    let with = |outline: &str, marks: &str, cells: &str, status: i32, words: &[&str]| {
        fails(&["grid", outline, "--marks", marks, "--cells", cells, "--out", &out], status, words);
    };
    let marks = "0,0.25,0.5,0.75";
    with("preset:disk", "0,0.5,0.25,0.75", "4x4", 2, &["mark 2 lies beyond mark 3", "cyclic order"]);
    with("preset:disk", "0,0.75,0.5,0.25", "4x4", 2, &["mark 2 lies beyond mark 3"]);
    with("preset:disk", "0,0.25,0.25,0.75", "4x4", 2, &["marks 2 and 3 are the same point"]);
    with("preset:disk", "0,0.25,0.5,1", "4x4", 2, &["marks 4 and 1 are the same point"]);
    with("preset:disk", "0,0.25,nan,0.75", "4x4", 2, &["mark 3 is not a finite fraction"]);
    with("preset:disk", "0,0.25,0.5", "4x4", 2, &["S,S,S,S"]);
    for cells in ["0x4", "4x1001", "4", "4x4x4", "-1x2", "axb"] {
        with("preset:disk", marks, cells, 2, &["1 to 1000"]);
    }
    with("preset:kitten", marks, "4x4", 1, &["kitten", "blob"]);
    with("absent.json", marks, "4x4", 1, &["absent.json"]);
    for surface in ["preset:hemisphere", "absent.obj"] {
        with(surface, marks, "4x4", 1, &[surface, "is a surface", "outline"]);
    }
    let saw = |k: u32| (if k.is_multiple_of(2) { 1.0 } else { 0.8 }) * DVec2::from_angle(f64::from(k) * (TAU / 6000.0));
    let points: Vec<[f64; 2]> = (0..6000).map(|k| saw(k).to_array()).collect();
    let saw = file(&folder, "saw.json", &serde_json::to_string(&points).unwrap());
    let arguments = ["grid", &saw, "--interpret", "polygon", "--marks", marks, "--cells", "4x4", "--out", &out];
    fails(&arguments, 1, &["saw.json", "unknowns", "more than the limit"]);
    let svg = folder.join("g.png").display().to_string();
    let arguments = ["grid", "preset:disk", "--marks", marks, "--cells", "4x4", "--out"];
    fails(&[&arguments[..], &[&svg]].concat(), 2, &["csv, svg, obj or vtk"]);
    assert_eq!(names(&folder), ["saw.json"], "a partial file is left");
}

#[test]
fn the_app_writes_the_files_of_the_command_line() {
    let folder = folder("app");
    let marks = [0.1, 0.25, 0.625, 0.75];
    let cells = GridCells::new([7, 4]).unwrap();
    let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]].map(DVec2::from).to_vec();
    let outlines = [
        ("preset:blob".to_owned(), StudiedOutline::Preset(Preset::Blob)),
        (file(&folder, "l.json", L), StudiedOutline::Points { points, form: CurveForm::default() }),
    ];
    for (name, outline) in outlines {
        for format in GridFormat::ALL {
            let path = folder.join(format!("g.{}", format.extension())).display().to_string();
            succeeds(&["grid", &name, "--marks", "0.1,0.25,0.625,0.75", "--cells", "7x4", "--out", &path]);
            let task = GridTask::new(outline.clone(), marks, cells, Some(format));
            let Some(GridContent::File(text)) = task.run(&mut |_| true).unwrap().map(|found| found.content) else {
                panic!("no file")
            };
            assert!(text == std::fs::read_to_string(&path).unwrap(), "{name}: another {path}");
        }
    }
}
