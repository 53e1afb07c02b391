//! `riemap flatten` from OBJ to OBJ and from PLY to PLY: what came in goes out, with texture coordinates.

#![cfg(feature = "app")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

mod support;

use riemap::surface::{Surface, SurfaceMesh, read_surface};
use std::fmt::Write as _;
use std::path::Path;
use support::program::{folder, succeeds};

/// Quads with colors, a normal, groups, materials and old texture coordinates.
const QUADS: &str = "mtllib paint.mtl\no patch\ng left\nusemtl red\n\
    v 0 0 0 1 0 0\nv 1 0 0.1 0 1 0\nv 2 0 0 0 0 1\nv 0 1 0.1 1 1 0\nv 1 1 0.3 1 1 1\nv 2 1 0.1 0 1 1\n\
    v 0 2 0 1 0 1\nv 1 2 0.1 0 0 0\nv 2 2 0 .5 .5 .5\nvn 0 0 1\nvt 0 0\nvt 1 1\ns 1\n\
    f 1/1/1 2/1/1 5/2/1 4/1/1 # first\nf 4/1/1 5/1/1 8/2/1 7/2/1\n# second part\ng right\nusemtl blue\n\
    f 2/1/1 3/1/1 6/2/1 5/2/1\nf 5/1/1 6/1/1 9/2/1 8/2/1\n";

/// Flattens a file and returns what is written in its own format.
fn flattened(folder: &Path, name: &str, bytes: &[u8], more: &[&str]) -> Vec<u8> {
    let (given, out) = (folder.join(name), folder.join(format!("flat-{name}")));
    std::fs::write(&given, bytes).unwrap();
    let [given, out] = [given, out].map(|path| path.display().to_string());
    succeeds(&[&["flatten", &*given], more, &["--out", &*out]].concat());
    std::fs::read(out).unwrap()
}

fn text(folder: &Path, name: &str, text: &str, more: &[&str]) -> String {
    String::from_utf8(flattened(folder, name, text.as_bytes(), more)).unwrap()
}

/// The lines that are not texture coordinates, faces or riemap's.
fn kept(text: &str) -> Vec<&str> {
    let is_kept = |line: &&str| !["vt ", "f ", "# riemap", "# vertex"].iter().any(|start| line.starts_with(start));
    text.lines().filter(is_kept).collect()
}

fn starting<'a>(text: &'a str, start: &str) -> Vec<&'a str> {
    text.lines().filter(|line| line.starts_with(start)).collect()
}

/// The numbers of a line after its keyword.
fn numbers(line: &str) -> Vec<f64> {
    line.split(' ').skip(1).map(|x| x.parse().unwrap()).collect()
}

fn surface(text: &str) -> Surface {
    read_surface("a.obj", text.as_bytes()).unwrap()
}

fn area(surface: &Surface) -> f64 {
    let corners = surface.triangles().iter().map(|t| t.map(|v| surface.vertices()[v as usize]));
    corners.map(|[a, b, c]| 0.5 * (b - a).cross(c - a).length()).sum()
}

#[test]
fn everything_but_texture_coordinates_stays_in_an_obj() {
    let folder = folder("obj");
    let written = text(&folder, "quads.obj", QUADS, &["preset:disk"]);
    assert_eq!(kept(&written), kept(QUADS));
    let faces = [
        "f 1/1/1 2/2/1 5/5/1 4/4/1 # first",
        "f 4/4/1 5/5/1 8/8/1 7/7/1",
        "f 2/2/1 3/3/1 6/6/1 5/5/1",
        "f 5/5/1 6/6/1 9/9/1 8/8/1",
    ];
    assert_eq!(starting(&written, "f "), faces);
    let coordinates: Vec<Vec<f64>> = starting(&written, "vt ").into_iter().map(numbers).collect();
    assert_eq!(coordinates.len(), 9);
    assert!(coordinates.iter().flatten().all(|x| (0.0..=1.0).contains(x)), "{coordinates:?}");
    // the rim's vertices lie on the circle
    let radius = |uv: &Vec<f64>| (uv[0] - 0.5).hypot(uv[1] - 0.5);
    let on_rim = coordinates.iter().filter(|uv| (radius(uv) - 0.5).abs() < 0.02).count();
    assert_eq!(on_rim, 8, "{coordinates:?}");
    // once more: the same file
    assert_eq!(text(&folder, "again.obj", &written, &["preset:disk"]), written);
}

#[test]
fn faces_at_new_vertices_become_triangles_and_the_others_stay() {
    let written = text(&folder("corners"), "quads.obj", QUADS, &["preset:square", "--surface-anchor", "@0.03"]);
    let (before, after) = (surface(QUADS), surface(&written));
    let added = starting(&written, "# vertex ").len();
    assert!(added >= 4, "{written}");
    let is_own = |line: &&str| !kept(QUADS).contains(line);
    assert_eq!(kept(&written).into_iter().filter(is_own).count(), added, "{written}");
    assert!(starting(&written, "f ").iter().all(|face| face.contains("/1 ")), "{written}");
    // colors at new vertices are in between
    for vertex in &starting(&written, "v ")[9..] {
        let [_, _, _, color @ ..] = &numbers(vertex)[..] else { unreachable!("{vertex}") };
        assert!(color.len() == 3 && color.iter().all(|part| (0.0..=1.0).contains(part)), "{vertex}");
    }
    assert_eq!(after.vertices()[..9], *before.vertices());
    assert_eq!((after.vertices().len(), starting(&written, "vt ").len()), (9 + added, 9 + added));
    assert!((area(&before) - area(&after)).abs() < 1e-12 && SurfaceMesh::new(&after).is_ok(), "{written}");
}

#[test]
fn a_surface_over_an_outline_stays_as_it_was_read_in_map_too() {
    let folder = folder("map");
    let [given, out] = ["quads.obj", "map.obj"].map(|name| folder.join(name).display().to_string());
    std::fs::write(&given, QUADS).unwrap();
    for sides in [[&*given, "preset:disk"], ["preset:disk", &*given]] {
        succeeds(&[&["map"], &sides[..], &["--out", &*out]].concat());
        let written = std::fs::read_to_string(&out).unwrap();
        assert_eq!(kept(&written), kept(QUADS));
        assert_eq!(starting(&written, "f ")[1], "f 4/4/1 5/5/1 8/8/1 7/7/1", "{written}");
    }
}

/// Two objects, each with its vertices, which are merged where both meet: the faces of the first come before the vertices of
/// the second.
#[test]
fn no_face_names_a_vertex_that_comes_later() {
    let mut objects = String::new();
    for (title, x) in [("o one\n", 0), ("o two # second\n", 2)] {
        objects += title;
        for (i, j) in (0..9).map(|k| (x + k % 3, k / 3)) {
            let _ = writeln!(objects, "v {i} {j} 0.{}", i * j);
        }
        objects += "f -9 -8 -5 -6\nf -8 -7 -4 -5\nf -6 -5 -2 -3\nf -5 -4 -1 -2\nl -9 -8\n";
    }
    let more = ["preset:square", "--surface-anchor", "@0.03"];
    let written = text(&folder("objects"), "objects.obj", &objects, &more);
    let (mut so_far, after) = (0, surface(&written));
    for line in written.lines() {
        so_far += usize::from(line.starts_with("v "));
        if let Some(corners) = line.strip_prefix("f ") {
            let largest = corners.split(' ').map(|corner| corner.split('/').next().unwrap().parse::<usize>().unwrap());
            assert!(largest.max().unwrap() <= so_far, "{line} in {written}");
        }
    }
    assert_eq!(starting(&written, "l "), ["l 1 2", "l 10 11"]);
    assert!((area(&surface(&objects)) - area(&after)).abs() < 1e-12, "{written}");
    assert!(written.lines().any(|line| line == "o two # second"), "{written}");
}

#[test]
fn a_vertex_that_is_split_at_normals_stays_so() {
    // the two quads have vertices of their own at x = 1
    let split = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 0\nv 2 0 1\nv 2 1 1\nv 1 1 0\nvn 0 0 1\nvn 1 0 1\n\
        f 1//1 2//1 3//1 4//1\nf 5//2 6//2 7//2 8//2\n";
    let written = text(&folder("split"), "split.obj", split, &["preset:disk"]);
    assert_eq!(kept(&written), kept(split));
    assert_eq!(starting(&written, "f "), ["f 1/1/1 2/2/1 3/3/1 4/4/1", "f 5/5/2 6/6/2 7/7/2 8/8/2"]);
    let coordinates = starting(&written, "vt ");
    assert_eq!((coordinates.len(), coordinates[1], coordinates[2]), (8, coordinates[4], coordinates[7]));
}

#[test]
fn left_out_and_repaired_faces_are_where_they_were() {
    // a quad turned round, a part of its own, a doubled triangle, a face with two corners
    let more = "v 9 9 9\nv 8 8 8\nv 8 9 8\n";
    let mut given = QUADS.replace("vn 0", &format!("{more}vn 0")).replace("f 4/1/1 5/1/1 8/2/1 7/2/1", "f 7 8 5 4");
    given += "g small\nf 10/1/1 11/1/1 12/1/1\ng doubled\nf 2/1/1 3/1/1 6/2/1\nf 1/1 2/2\n";
    let written = text(&folder("repaired"), "repaired.obj", &given, &["preset:disk", "--repair"]);
    assert_eq!(kept(&written), kept(&given));
    let faces = starting(&written, "f ");
    assert_eq!(faces[..2], ["f 1/1/1 2/2/1 5/5/1 4/4/1 # first", "f 4/4 5/5 8/8 7/7"]);
    assert_eq!(faces[4..], ["f 10//1 11//1 12//1", "f 2//1 3//1 6//1", "f 1 2"]);
    assert_eq!(starting(&written, "vt ")[9..], ["vt 0 0"; 3]);
}

/// A ring of squares whose ends meet in a corner only: the vertex there becomes two.
#[test]
fn a_vertex_where_parts_meet_becomes_two() {
    let mut given = String::new();
    for k in 0..16 {
        let _ = writeln!(given, "v {} {} 0", k % 4, k / 4);
    }
    for k in [0, 1, 2, 6, 10, 9, 4] {
        let _ = writeln!(given, "f {} {} {} {}", k + 1, k + 2, k + 6, k + 5);
    }
    let written = text(&folder("pinched"), "pinched.obj", &given, &["preset:disk", "--repair"]);
    let (before, after) = (surface(&given), surface(&written));
    assert_eq!((before.vertices().len(), after.vertices().len()), (16, 17));
    assert_eq!(starting(&written, "f ").len(), 7);
    assert!(starting(&written, "f ").iter().all(|face| face.split(' ').count() == 5), "{written}");
    assert!(after.vertices()[16] == after.vertices()[9], "{written}");
    assert!((area(&before) - area(&after)).abs() < 1e-12);
}

/// [`QUADS`] as PLY, with a normal, a color, texture coordinates, a material for each face, and an edge.
fn ply(encoding: &str) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat {encoding} 1.0\ncomment made by hand\nelement vertex 9\nproperty float x\nproperty float y\n\
         property float z\nproperty float nx\nproperty uchar red\nproperty float u\nproperty float v\nelement face 4\n\
         property uchar material\nproperty list uchar short vertex_indices\nproperty list uchar float texcoord\n\
         element edge 1\nproperty int vertex1\nproperty int vertex2\nobj_info last\nend_header\n"
    )
    .into_bytes();
    let mut row = |values: &[(f64, usize)]| match encoding {
        "ascii" => {
            let words: Vec<String> = values.iter().map(|(value, _)| value.to_string()).collect();
            bytes.extend(format!("{}\n", words.join(" ")).into_bytes());
        }
        _ => values.iter().for_each(|&(value, kind)| {
            let mut little = match kind {
                1 => vec![value as u8],
                2 => (value as i16).to_le_bytes().to_vec(),
                4 => (value as i32).to_le_bytes().to_vec(),
                _ => (value as f32).to_le_bytes().to_vec(),
            };
            if encoding == "binary_big_endian" {
                little.reverse();
            }
            bytes.extend(little);
        }),
    };
    for (k, p) in surface(QUADS).vertices().iter().enumerate() {
        let z = f64::from(p.z as f32);
        row(&[(p.x, 0), (p.y, 0), (z, 0), (0.25, 0), (10.0 * k as f64, 1), (0.5, 0), (0.25, 0)]);
    }
    for (material, corners) in [[0, 1, 4, 3], [3, 4, 7, 6], [1, 2, 5, 4], [4, 5, 8, 7]].into_iter().enumerate() {
        let [a, b, c, d] = corners.map(|v| (f64::from(v), 2));
        row(&[(material as f64, 1), (4.0, 1), a, b, c, d, (1.0, 1), (0.5, 0)]);
    }
    row(&[(0.0, 4), (1.0, 4)]);
    bytes
}

fn header(bytes: &[u8]) -> String {
    let end = bytes.windows(11).position(|word| word == b"end_header\n").unwrap();
    String::from_utf8(bytes[..end].to_vec()).unwrap()
}

#[test]
fn properties_and_polygons_stay_in_a_ply() {
    let folder = folder("ply");
    let ascii = String::from_utf8(flattened(&folder, "ascii.ply", &ply("ascii"), &["preset:disk"])).unwrap();
    let expected = "ply\nformat ascii 1.0\ncomment made by hand\nobj_info last\n\
        comment riemap: s t are texture coordinates; vertices that are not of the file follow its own\n\
        element vertex 9\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n\
        property uchar red\nproperty double s\nproperty double t\nelement face 4\nproperty uchar material\n\
        property list uchar short vertex_indices\nelement edge 1\nproperty int vertex1\nproperty int vertex2\n";
    assert_eq!(header(ascii.as_bytes()), expected);
    let rows: Vec<&str> = ascii.lines().skip_while(|line| *line != "end_header").skip(1).collect();
    assert!(rows[5].starts_with("2 1 0.10000000149011612 0.25 50 "), "{}", rows[5]);
    assert_eq!(rows[9..], ["0 4 0 1 4 3", "1 4 3 4 7 6", "2 4 1 2 5 4", "3 4 4 5 8 7", "0 1"]);
    assert_eq!(flattened(&folder, "again.ply", ascii.as_bytes(), &["preset:disk"]), ascii.as_bytes());
    for encoding in ["binary_little_endian", "binary_big_endian"] {
        let written = flattened(&folder, "binary.ply", &ply(encoding), &["preset:disk"]);
        assert_eq!(header(&written), expected.replace("ascii", encoding));
        let body = &written[header(&written).len() + 11..];
        assert_eq!(body.len(), 9 * (4 * 4 + 1 + 2 * 8) + 4 * (1 + 1 + 4 * 2) + 2 * 4, "{encoding}");
        let place = |bytes: [u8; 8]| match encoding {
            "binary_big_endian" => f64::from_be_bytes(bytes),
            _ => f64::from_le_bytes(bytes),
        };
        for (k, row) in rows[..9].iter().enumerate() {
            let at = 33 * k + 17;
            let uv = [0, 8].map(|by| place(body[at + by..at + by + 8].try_into().unwrap()));
            assert_eq!(uv.to_vec(), numbers(row)[4..], "{encoding}: {row}");
        }
    }
}

#[test]
fn a_new_vertex_of_a_ply_has_the_properties_of_what_it_divides() {
    let more = ["preset:square", "--surface-anchor", "@0.03"];
    let written = String::from_utf8(flattened(&folder("ply-corners"), "quads.ply", &ply("ascii"), &more)).unwrap();
    let divisions = starting(&written, "comment vertex ");
    assert!(divisions.len() >= 4, "{written}");
    let rows: Vec<&str> = written.lines().skip_while(|line| *line != "end_header").skip(1).collect();
    for (division, row) in divisions.iter().zip(&rows[9..]) {
        let words: Vec<&str> = division.split(' ').collect();
        let number = |k: usize| words[k].parse::<f64>().unwrap();
        let values: Vec<f64> = row.split(' ').map(|x| x.parse().unwrap()).collect();
        assert_eq!(values[3], 0.25, "{row}");
        if words[3] == "divides" {
            let (a, b, at) = (number(6), number(7), number(9));
            assert_eq!(values[4], (10.0 * (a + at * (b - a))).round(), "{division}: {row}");
        }
    }
    let given = read_surface("a.ply", &ply("ascii")).unwrap();
    let after = read_surface("a.ply", written.as_bytes()).unwrap();
    assert!((area(&given) - area(&after)).abs() < 1e-7 && SurfaceMesh::new(&after).is_ok());
    assert_eq!(after.vertices()[..9], *given.vertices());
}

#[test]
fn a_vertex_at_no_place_is_no_hindrance() {
    let folder = folder("no-place");
    let given = QUADS.replace("vn 0 0 1\n", "v nan nan nan\nvn 0 0 1\n");
    let written = text(&folder, "nowhere.obj", &given, &["preset:disk"]);
    assert_eq!((starting(&written, "usemtl").len(), starting(&written, "f ").len()), (2, 4), "{written}");
}

#[test]
fn a_row_of_vertices_at_a_pole_stays_in_its_faces() {
    let folder = folder("pole");
    // a cap of one ring of 8 columns: the faces at the pole are quadrilaterals with two corners there
    let place = |ring: u32, column: u32| {
        let angle = f64::from(column % 8) / 8.0 * std::f64::consts::TAU;
        let radius = f64::from(ring) / 2.0;
        format!("v {:?} {:?} {:?}\n", radius * angle.cos(), radius * angle.sin(), -radius)
    };
    let vertices: String = (0..3).flat_map(|ring| (0..9).map(move |column| place(ring, column))).collect();
    let face = |ring: u32, column: u32| {
        let first = 1 + 9 * ring + column;
        format!("f {} {} {} {}\n", first, first + 9, first + 10, first + 1)
    };
    let faces: String = (0..2).flat_map(|ring| (0..8).map(move |column| face(ring, column))).collect();
    let written = text(&folder, "cap.obj", &(vertices + &faces), &["preset:disk"]);
    let corners: Vec<usize> = starting(&written, "f ").iter().map(|line| line.split(' ').count() - 1).collect();
    assert_eq!(corners, [4; 16], "{written}");
    assert_eq!(starting(&written, "vt ").len(), 27);
}

#[test]
fn bare_triangles_come_with_a_note() {
    let folder = folder("strips");
    let strips = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n";
    let [given, out] = ["strips.ply", "flat.ply"].map(|name| folder.join(name).display().to_string());
    std::fs::write(&given, strips).unwrap();
    let output = succeeds(&["flatten", &given, "preset:disk", "--out", &out]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("flat.ply: bare triangles"));
    assert_eq!(read_surface(&out, &std::fs::read(&out).unwrap()).unwrap().triangles().len(), 2);
}
