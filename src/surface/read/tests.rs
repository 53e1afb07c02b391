//! One square in every format; errors with their places; no input makes a reader panic.

mod gltf;
mod obj;
mod off;
mod ply;
mod samples;
mod stl;

use super::*;
use crate::geometry::DVec3;
use crate::mesh::{TriangleId, VertexId};
use crate::surface::{RepairNote, SurfaceMesh, SurfaceNote, TopologyError};
use samples::{OBJ, OFF, PLY, binary_ply, binary_stl, corners, files, gltf, gltf_parts, stl_text, texts};

#[test]
fn every_format_gives_the_same_square() {
    let expected: Vec<DVec3> = corners().iter().map(|p| DVec3::from_array(p.map(f64::from))).collect();
    for (name, bytes) in files() {
        let surface = read_surface(name, &bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(surface.vertices, expected, "{name}");
        let winding = surface.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| surface.vertices[v as usize]);
            (b - a).cross(c - a).z
        });
        assert!(winding.into_iter().all(|z| z > 0.9), "{name}: {:?}", surface.triangles);
        assert_eq!(surface.triangles.len(), 2, "{name}");
        let welded = surface.notes.contains(&SurfaceNote::Welded { before: 6, after: 4 });
        assert_eq!(welded, name.ends_with("stl") || name.contains("gl"), "{name}: {:?}", surface.notes);
    }
}

#[test]
fn the_first_bytes_decide_where_the_extension_does_not() {
    for (name, bytes) in files() {
        assert_eq!(read_surface("surface", &bytes), read_surface(name, &bytes), "{name}");
    }
    for before in ["g a\n", "s 1\n", "vt 0 0\n", "vn 0 0 1\n", "usemtl a\n", "mtllib a\n", "l 1 2\n", "# a\n\no a\n"] {
        let obj = [before, OBJ].concat();
        assert_eq!(read_surface("surface", obj.as_bytes()).unwrap().vertices.len(), 4, "{before}");
    }
    for before in ["# made by hand\n", ""] {
        for keyword in ["OFF", "NOFF", "STOFF", "coff"] {
            let off = [before, &OFF.replace("COFF", keyword)].concat();
            assert!(read_surface("surface", off.as_bytes()).is_ok(), "{before}{keyword}");
        }
    }
    // and where the extension is wrong
    for (name, bytes) in files() {
        let surface = read_surface(name, &bytes);
        // binary data of that name are binary STL, whatever words they begin with
        for other in ENDINGS.into_iter().filter(|other| *other != "stl" || name != "b.off") {
            assert_eq!(read_surface(&format!("a.{other}"), &bytes), surface, "{name} as {other}");
        }
    }
    let unknown = read_surface("a.step", b"ISO-10303").unwrap_err();
    assert_eq!(unknown, SurfaceError::UnknownFormat { extension: "step".to_owned() });
}

#[test]
fn errors_say_where() {
    let line = Place::Line;
    let cases: Vec<(&str, String, SurfaceError)> = vec![
        ("a.obj", "v 0 0 0\nv 0 1\n".into(), SurfaceError::missing(line(2), Item::Coordinate("z"))),
        ("a.obj", "v 0 zero 0\n".into(), SurfaceError::NotANumber { place: line(1), found: "zero".into() }),
        (
            "a.obj",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\nf 1 2 4\n".into(),
            SurfaceError::IndexOutOfRange { place: line(6), index: 4, vertices: 3 },
        ),
        ("a.obj", "v 0 0 0\nf 0 1 1\n".into(), SurfaceError::IndexOutOfRange { place: line(2), index: 0, vertices: 1 }),
        (
            "a.obj",
            "v 0 0 0\nf -2 1 1\n".into(),
            SurfaceError::IndexOutOfRange { place: line(2), index: -2, vertices: 1 },
        ),
        // a continued line keeps the numbers of the lines after it
        ("a.obj", "v 0 \\\n0 0\nv 1 0\n".into(), SurfaceError::missing(line(3), Item::Coordinate("z"))),
        ("a.obj", "v 0 0 0\nf 1 1\n".into(), SurfaceError::NoTriangles),
        ("a.obj", "v 0 0 0\n".into(), SurfaceError::NoTriangles),
        (
            "a.off",
            OFF.replace("3 0 2 3", "3 0 2 4"),
            SurfaceError::IndexOutOfRange { place: line(9), index: 4, vertices: 4 },
        ),
        ("a.off", OFF.replace("4 2 5", "4 3 5"), SurfaceError::missing(line(10), Item::Face)),
        ("a.off", "OFF BINARY\n".into(), SurfaceError::missing(Place::Byte(11), Item::VertexCount)),
        (
            "a.off",
            OFF.replace("3 0 1 2\n", "3 0 1\n"),
            SurfaceError::missing(line(8), Item::Corner { index: 3, count: 3 }),
        ),
        (
            "a.ply",
            PLY.replace("3 0 2 3", "3 0 2 9"),
            SurfaceError::IndexOutOfRange { place: line(20), index: 9, vertices: 4 },
        ),
        (
            "a.ply",
            PLY.replace("property double y", "property double w"),
            SurfaceError::missing(line(1), Item::VertexProperty("y")),
        ),
        ("a.stl", stl_text().replacen("endloop", "", 2), SurfaceError::missing(line(16), Item::Keyword("endloop"))),
    ];
    for (name, text, expected) in cases {
        assert_eq!(read_surface(name, text.as_bytes()).unwrap_err(), expected, "{text}");
    }
    let mut short = binary_stl();
    short.truncate(150);
    let expected = SurfaceError::missing(Place::Byte(146), Item::TriangleCorner { triangle: 1, count: 2 });
    assert_eq!(read_surface("a.stl", &short).unwrap_err(), expected);
    let separate = gltf_parts().0.replace("URI", r#", "uri": "square.bin""#);
    let message = read_surface("a.gltf", separate.as_bytes()).unwrap_err().to_string();
    assert!(message.starts_with("buffers[0]: the separate file \"square.bin\""), "{message}");
    let cyclic = gltf().replace(r#"{"mesh": 0, "tr"#, r#"{"children": [0], "mesh": 0, "tr"#);
    let message = read_surface("a.gltf", cyclic.as_bytes()).unwrap_err().to_string();
    assert_eq!(message, "nodes[0]: the node stands twice in the tree");
}

/// Knuth's MMIX generator.
fn next(state: &mut u64) -> usize {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 33) as usize
}

#[test]
fn damaged_files_are_errors_or_other_surfaces_but_never_a_panic() {
    let mut state = 4;
    for (name, bytes) in files() {
        for round in 0..3000 {
            let mut damaged = bytes.clone();
            for _ in 0..=next(&mut state) % 3 {
                let place = next(&mut state) % damaged.len();
                match next(&mut state) % 4 {
                    0 => damaged.truncate(place + 1),
                    1 => damaged[place] = next(&mut state) as u8,
                    2 => damaged[place] = b"0-9e.,[]{}\"\n "[next(&mut state) % 13],
                    _ => drop(damaged.remove(place)),
                }
                if damaged.is_empty() {
                    break;
                }
            }
            if let Ok(surface) = read_surface(name, &damaged) {
                let count = surface.vertices.len();
                let sound = surface.triangles.iter().flatten().all(|&v| (v as usize) < count);
                assert!(sound, "{name}, round {round}");
            }
        }
    }
}

#[test]
fn lines_end_in_line_feeds_carriage_returns_or_both() {
    for (name, text) in texts() {
        let plain = read_surface(name, text.as_bytes()).unwrap();
        for end in ["\r\n", "\r"] {
            let other = text.replace('\n', end);
            assert_eq!(read_surface(name, other.as_bytes()).unwrap(), plain, "{name}, {end:?}");
        }
    }
    // one line end of the other kind, at the end of the file or in its first line, changes nothing
    for (name, text) in texts() {
        let plain = read_surface(name, text.as_bytes()).unwrap();
        let astray = [text.replace('\n', "\r") + "\n", text.replacen('\n', " \r\n", 1), text.clone() + "\r"];
        for other in astray {
            assert_eq!(read_surface(name, other.as_bytes()).unwrap(), plain, "{other:?}");
        }
    }
    // a carriage return in a comment ends no line of a file that has line feeds
    let comment = OBJ.replacen('\n', "\rv 7 7 7\n", 1);
    assert_eq!(read_surface("a.obj", comment.as_bytes()).unwrap().vertices.len(), 4);
    let continued = "v 0 0 0\rv 1 0 \\\r0\rv 0 1 0\rf 1 2 4\r";
    let error = SurfaceError::IndexOutOfRange { place: Place::Line(5), index: 4, vertices: 3 };
    assert_eq!(read_surface("a.obj", continued.as_bytes()).unwrap_err(), error);
    let damaged = PLY.replace("3 0 2 3", "3 0 2 9").replace('\n', "\r");
    let error = SurfaceError::IndexOutOfRange { place: Place::Line(20), index: 9, vertices: 4 };
    assert_eq!(read_surface("a.ply", damaged.as_bytes()).unwrap_err(), error);
    let body = binary_ply(false);
    let at = body.windows(11).position(|word| word == b"end_header\n").unwrap() + 11;
    let header: Vec<u8> = body[..at].iter().map(|&b| if b == b'\n' { b'\r' } else { b }).collect();
    let plain = read_surface("b.ply", &body).unwrap();
    assert_eq!(read_surface("b.ply", &[&header, &body[at..]].concat()).unwrap(), plain);
}

#[test]
fn what_follows_after_all_that_was_counted_is_told() {
    let stl = binary_stl();
    let files: [(&str, Vec<u8>, Place); 6] = [
        ("a.off", OFF.into(), Place::Line(10)),
        ("a.ply", PLY.into(), Place::Line(22)),
        ("b.ply", binary_ply(false), Place::Byte(binary_ply(false).len())),
        ("c.ply", binary_ply(true), Place::Byte(binary_ply(true).len())),
        ("a.stl", stl.clone(), Place::Byte(stl.len())),
        ("d.ply", PLY.replace('\n', "\r").into(), Place::Line(22)),
    ];
    for (name, bytes, place) in files {
        let plain = read_surface(name, &bytes).unwrap();
        let is_told = |surface: &Surface| surface.notes.contains(&SurfaceNote::Surplus { place: place.clone() });
        assert_eq!(read_surface(name, &[&bytes, b"\n \r\n".as_slice()].concat()).unwrap(), plain, "{name}");
        if matches!(place, Place::Byte(_)) {
            for padding in [b"\0\0\0".as_slice(), b"\x1a", b"\r\n\x1a\0"] {
                assert_eq!(read_surface(name, &[&bytes, padding].concat()).unwrap(), plain, "{name}: {padding:?}");
            }
        }
        let longer = read_surface(name, &[&bytes, b"3 0 2 3 0.5".as_slice()].concat()).unwrap();
        assert!(is_told(&longer) && !is_told(&plain), "{name}: {:?}", longer.notes);
        assert_eq!((longer.vertices, longer.triangles), (plain.vertices, plain.triangles), "{name}");
    }
}

#[test]
fn text_in_utf16_is_read() {
    for (name, text) in texts() {
        let plain = read_surface(name, text.as_bytes()).unwrap();
        for encode in [u16::to_le_bytes, u16::to_be_bytes] {
            let bytes: Vec<u8> = format!("\u{feff}{text}").encode_utf16().flat_map(encode).collect();
            assert_eq!(read_surface(name, &bytes), Ok(plain.clone()), "{name}");
            assert_eq!(read_surface("surface", &bytes), Ok(plain.clone()), "{name}");
        }
    }
}

/// Coordinates that are no finite numbers matter only in triangles.
#[test]
fn vertices_at_no_finite_place_are_read() {
    let unused = ["v 5 nan 0\nv -inf 1e999 0\n", OBJ].concat().replace("f 1/1 2/1 3/1", "f 3/1 4/1 5/1");
    let ply = PLY.replace("vertex 4", "vertex 5").replace("3 0 1 2", "9 nan nan nan\n3 0 1 2");
    let off = OFF.replace("4 2 5", "5 2 5").replace("0 1 2\n3 0", "0 1 2\nNaN 0 inf\n3 0");
    for (name, text, count) in [("a.obj", unused, 2), ("a.ply", ply, 1), ("a.off", off, 1)] {
        let surface = read_surface(name, text.as_bytes()).unwrap();
        let disk = SurfaceMesh::new(&surface).unwrap();
        assert_eq!(disk.repairs(), [RepairNote::DroppedVertices { count }], "{name}");
        assert_eq!(disk.mesh().triangles().len(), 2, "{name}");
    }
    for (name, text) in [("a.obj", OBJ), ("a.ply", PLY), ("a.off", OFF), ("a.stl", &stl_text())] {
        let astray = text.replace("1 0 2.5", "1 nan 2.5");
        let error = SurfaceMesh::new(&read_surface(name, astray.as_bytes()).unwrap()).unwrap_err();
        assert_eq!(error, TopologyError::NotFinite { vertex: VertexId::new(1), count: 1 }, "{name}");
    }
}
