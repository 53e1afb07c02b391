//! One square in every format; errors with their places; no input makes a reader panic.

use super::*;
use crate::geometry::DVec3;
use crate::mesh::{TriangleId, VertexId};
use crate::surface::{RepairNote, SurfaceMesh, SurfaceNote, TopologyError};

/// The unit square at height 2 as two triangles; the corner (1, 0) is lifted to 2.5.
fn corners() -> [[f32; 3]; 4] {
    [[0.0, 0.0, 2.0], [1.0, 0.0, 2.5], [1.0, 1.0, 2.0], [0.0, 1.0, 2.0]]
}

const OBJ: &str =
    "# \u{e9}\nv 0 0 2\nv 1 0 2.5 1 0 0\nv 1 1 2\nv 0 1 2\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\nf -4// -2 -1\n";
const OFF: &str = "COFF # kind\n4 2 5\n0 0 2 255 0 0\n1 0 2.5\n\n1 1 2\n0 1 2\n3 0 1 2\n3 0 2 3 255\n";
const PLY: &str = "ply\nformat ascii 1.0\ncomment none\nelement vertex 4\nproperty uchar red\nproperty float x\n\
    property double y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\n\
    property float quality\nelement edge 1\nproperty int a\nend_header\n9 0 0 2\n9 1 0 2.5\n9 1 1 2\n9 0 1 2\n\
    3 0 1 2 0.5\n3 0 2 3 0.5\n7\n";

fn binary_ply(big_endian: bool) -> Vec<u8> {
    let kind = if big_endian { "big" } else { "little" };
    let mut bytes = format!(
        "ply\nformat binary_{kind}_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n\
         property float z\nproperty list uchar short extra\nelement face 2\n\
         property list uchar uint vertex_index\nend_header\n"
    )
    .into_bytes();
    let order = |mut value: Vec<u8>| {
        if big_endian {
            value.reverse();
        }
        value
    };
    for corner in corners() {
        for value in corner {
            bytes.extend(order(value.to_le_bytes().to_vec()));
        }
        bytes.extend([2, 1, 2, 3, 4]);
    }
    for face in [[0_u32, 1, 2], [0, 2, 3]] {
        bytes.push(3);
        for v in face {
            bytes.extend(order(v.to_le_bytes().to_vec()));
        }
    }
    bytes
}

fn stl_text() -> String {
    let p = corners();
    let loops = [[0, 1, 2], [0, 2, 3]].map(|t| {
        let vertices = t.map(|v: usize| format!("vertex {} {} {}\n", p[v][0], p[v][1], p[v][2])).concat();
        format!("facet normal 0 0 1\nouter loop\n{vertices}endloop\nendfacet\n")
    });
    format!("solid square\n{}endsolid\n", loops.concat())
}

fn binary_stl() -> Vec<u8> {
    let mut bytes = vec![0; 80];
    bytes[..5].copy_from_slice(b"solid");
    bytes.extend(2_u32.to_le_bytes());
    for triangle in [[0, 1, 2], [0, 2, 3]] {
        bytes.extend([0; 12]);
        for value in triangle.map(|v: usize| corners()[v]).as_flattened() {
            bytes.extend(value.to_le_bytes());
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// Two nodes with one triangle each: the first mesh is moved by (0, 0, 2) in a child, the second is mirrored.
fn gltf_parts() -> (String, Vec<u8>) {
    let mut buffer = Vec::new();
    let [a, mut b, c, d] = corners();
    b[2] -= 2.0;
    let down = |p: [f32; 3]| [p[0], p[1], 0.0];
    let mirrored = |p: [f32; 3]| [-p[0], p[1], p[2]];
    for point in [down(a), b, down(c), mirrored(a), mirrored(c), mirrored(d)] {
        for value in point {
            buffer.extend(value.to_le_bytes());
        }
    }
    for index in [0_u16, 1, 2, 0, 2, 1] {
        buffer.extend(index.to_le_bytes());
    }
    let document = r#"{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 2]}],
        "nodes": [{"children": [1], "translation": [0, 0, 1]}, {"mesh": 0, "translation": [0, 0, 1]},
                  {"mesh": 1, "scale": [-1, 1, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2}]},
                   {"primitives": [{"attributes": {"POSITION": 1}, "indices": 3}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"},
            {"bufferView": 1, "byteOffset": 6, "componentType": 5123, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 72}, {"buffer": 0, "byteOffset": 72, "byteLength": 12}],
        "buffers": [{"byteLength": 84 URI}]}"#;
    (document.to_owned(), buffer)
}

fn glb() -> Vec<u8> {
    let (document, buffer) = gltf_parts();
    let mut document = document.replace("URI", "").into_bytes();
    document.resize(document.len().next_multiple_of(4), b' ');
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    bytes.extend((28 + document.len() as u32 + buffer.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &document), (b"BIN\0", &buffer)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

fn gltf() -> String {
    let (document, buffer) = gltf_parts();
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in buffer.chunks(3) {
        let bits = u32::from_be_bytes([0, three[0], three[1], three[2]]);
        (0..4).rev().for_each(|k| text.push(char::from(digits[(bits >> (6 * k)) as usize & 63])));
    }
    document.replace("URI", &format!(r#", "uri": "data:application/octet-stream;base64,{text}""#))
}

/// With colors at the vertices and at one face.
fn binary_off() -> Vec<u8> {
    let mut bytes = b"COFF BINARY\n".to_vec();
    let whole = |bytes: &mut Vec<u8>, numbers: &[i32]| bytes.extend(numbers.iter().flat_map(|n| n.to_be_bytes()));
    whole(&mut bytes, &[4, 2, 5]);
    for [x, y, z] in corners() {
        bytes.extend([x, y, z, 0.5, 0.5, 0.5, 1.0].iter().flat_map(|n: &f32| n.to_be_bytes()));
    }
    whole(&mut bytes, &[3, 0, 1, 2, 0, 3, 0, 2, 3, 1]);
    bytes.extend(0.25_f32.to_be_bytes());
    bytes
}

/// Every format with the same square in it.
fn files() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("a.obj", OBJ.into()),
        ("a.off", OFF.into()),
        ("b.off", binary_off()),
        ("a.ply", PLY.into()),
        ("b.ply", binary_ply(false)),
        ("c.PLY", binary_ply(true)),
        ("a.stl", stl_text().into()),
        ("b.stl", binary_stl()),
        ("a.glb", glb()),
        ("a.gltf", gltf().into()),
    ]
}

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
    let unknown = read_surface("a.step", b"ISO-10303").unwrap_err();
    assert_eq!(unknown, SurfaceError::UnknownFormat { extension: "step".to_owned() });
}

#[test]
fn polygons_are_cut_into_triangles() {
    let pentagon = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 \\\n 4 5\nf 1 2 3\n";
    let surface = read_surface("p.obj", pentagon.as_bytes()).unwrap();
    assert_eq!(surface.triangles.len(), 4);
    assert_eq!(surface.notes, [SurfaceNote::Triangulated { polygons: 1, faces: 2 }]);
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
fn marks_and_comments_before_the_first_vertex_take_nothing_away() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let plain = read_surface("a.obj", square.as_bytes()).unwrap();
    for before in ["\u{feff}", "# exported from C:\\models\\\n", "\u{feff}# C:\\\r\n"] {
        let read = read_surface("a.obj", format!("{before}{square}").as_bytes()).unwrap();
        assert_eq!((read.vertices, read.triangles), (plain.vertices.clone(), plain.triangles.clone()), "{before:?}");
    }
}

#[test]
fn a_text_stl_is_told_by_its_first_word_and_may_lack_its_last() {
    let facet = "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\n";
    let whole = format!("SOLID a\n{facet}ENDSOLID a\n");
    assert_eq!(read_surface("a.stl", whole.as_bytes()).unwrap().triangles.len(), 1);
    assert_eq!(read_surface("a", whole.as_bytes()).unwrap().triangles.len(), 1);
    assert!(read_surface("a.stl", whole.as_bytes()).unwrap().notes.is_empty());
    for head in ["SOLID\n", "solid\n", "  Solid # 1\r\n", "solid solid endsolid\n"] {
        for end in ["", "endsol", "\n\n"] {
            let surface = read_surface("a.stl", [head, facet, end].concat().as_bytes()).unwrap();
            assert_eq!((surface.triangles.len(), &*surface.notes), (1, &[SurfaceNote::Unended][..]), "{head}, {end}");
        }
    }
    let second = facet.replace("VERTEX 0 0 0", "VERTEX 1 1 0").replace("1 0 0\nVERTEX 0 1 0", "0 1 0\nVERTEX 1 0 0");
    let several = format!("solid a\n{facet}endsolid a\n\nsolid\n{second}ENDSOLID\n");
    let surface = read_surface("a.stl", several.as_bytes()).unwrap();
    assert_eq!((surface.vertices.len(), surface.triangles.len()), (4, 2));
    assert!(SurfaceMesh::new(&surface).is_ok());
    let cut = ["solid\n", &facet.replace("ENDLOOP\nENDFACET\n", "")].concat();
    assert!(read_surface("a.stl", cut.as_bytes()).unwrap_err().to_string().contains("endloop"));
}

/// The square in three formats whose lines may end in any way.
fn texts() -> [(&'static str, String); 4] {
    [("a.obj", OBJ.into()), ("a.off", OFF.into()), ("a.ply", PLY.into()), ("a.stl", stl_text())]
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
fn the_counts_of_an_off_stand_on_one_line_or_several() {
    let plain = read_surface("a.off", OFF.as_bytes()).unwrap();
    for head in [
        "COFF 4 2 5",
        "COFF\n4 2",
        "COFF\n4\n2\n5",
        "COFF 4\n2 5",
        "coff\n4 2\n5",
        "Coff\n4\n2",
        "4 2 0",
        "OFF4 2 5",
        "COFF4\n2 5",
    ] {
        let other = OFF.replace("COFF # kind\n4 2 5", head);
        assert_eq!(read_surface("a.off", other.as_bytes()).unwrap(), plain, "{head}");
    }
    let lower = OFF.replace("COFF", "off");
    assert_eq!(read_surface("surface", lower.as_bytes()).unwrap(), plain);
    for (head, error) in [
        ("OFF\n4", SurfaceError::missing(Place::Line(3), Item::FaceCount)),
        ("nOFF\n4 2 5", SurfaceError::unsupported(Place::Line(1), Unsupported::Dimensions("nOFF".into()))),
    ] {
        assert_eq!(read_surface("a.off", head.as_bytes()).unwrap_err(), error);
    }
}

#[test]
fn the_faces_of_a_ply_may_come_before_its_vertices() {
    let [head, faces] = ["element face 2\nproperty list uchar int vertex_indices\n", "3 0 1 2\n3 0 2 3\n"];
    let vertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
    let body = "0 0 2\n1 0 2.5\n1 1 2\n0 1 2\n";
    let text = |faces: &str| format!("ply\nformat ascii 1.0\n{head}{vertices}end_header\n{faces}{body}");
    let plain = read_surface("a.ply", PLY.as_bytes()).unwrap();
    assert_eq!(read_surface("a.ply", text(faces).as_bytes()).unwrap(), plain);
    let error = SurfaceError::IndexOutOfRange { place: Place::Line(11), index: 4, vertices: 4 };
    assert_eq!(read_surface("a.ply", text("3 0 1 2\n3 0 2 4\n").as_bytes()).unwrap_err(), error);
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
    let plain = read_surface("a.obj", OBJ.as_bytes()).unwrap();
    for encode in [u16::to_le_bytes, u16::to_be_bytes] {
        let bytes: Vec<u8> = ['\u{feff}'.to_string(), OBJ.into()].concat().encode_utf16().flat_map(encode).collect();
        assert_eq!(read_surface("a.obj", &bytes), Ok(plain.clone()));
    }
}

#[test]
fn faces_with_two_corners_are_dropped_and_counted() {
    let surface = read_surface("a.obj", [OBJ, "f 1 2\nf 3\n"].concat().as_bytes()).unwrap();
    assert_eq!(surface.triangles.len(), 2);
    assert!(surface.notes.contains(&SurfaceNote::DroppedFaces { count: 2 }), "{:?}", surface.notes);
}

/// Every triangle of STL has corners of its own, which are merged: faults name them as the file counts them.
#[test]
fn faults_have_the_vertices_of_the_file() {
    let corners = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1], [0, 0], [0, 1], [0, 2]];
    let facet = |corners: &[[i32; 2]]| {
        let vertices = corners.iter().map(|[x, y]| format!("vertex {x} {y} 0\n")).collect::<Vec<_>>().concat();
        format!("facet normal 0 0 1\nouter loop\n{vertices}endloop\nendfacet\n")
    };
    let text = format!("solid\n{}endsolid\n", corners.chunks(3).map(facet).collect::<Vec<_>>().concat());
    let surface = read_surface("a.stl", text.as_bytes()).unwrap();
    assert_eq!(surface.vertices.len(), 5);
    let corners = [0, 5, 8].map(VertexId::new);
    let flat = TopologyError::Degenerate { triangle: TriangleId::new(2), corners, count: 1 };
    assert_eq!(SurfaceMesh::new(&surface).unwrap_err(), flat);
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

#[test]
fn faces_of_off_go_on_in_the_next_lines() {
    let plain = read_surface("a.off", OFF.as_bytes()).unwrap();
    let broken = OFF.replace("3 0 1 2\n3 0 2 3 255\n", "3\n0 1 2\n3 0\n2 3 255\n");
    assert_eq!(read_surface("a.off", broken.as_bytes()).unwrap(), plain);
}

const STRIPS: &str = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
                      element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
                      0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

#[test]
fn strips_of_ply_are_turned_alternately_and_end_at_minus_1() {
    for (strips, expected) in [
        ("4 0 1 3 2\n", vec![[0, 1, 3], [3, 1, 2]]),
        ("7 0 1 3 -1 1 2 3\n", vec![[0, 1, 3], [1, 2, 3]]),
        // a corner that is repeated turns the triangles after it
        ("6 0 1 3 3 1 2\n", vec![[0, 1, 3], [1, 3, 2]]),
    ] {
        let surface = read_surface("a.ply", [STRIPS, strips].concat().as_bytes()).unwrap();
        assert_eq!(surface.triangles, expected, "{strips}");
    }
    let error = read_surface("a.ply", [STRIPS, "3 0 1 4\n"].concat().as_bytes()).unwrap_err();
    assert_eq!(error, SurfaceError::IndexOutOfRange { place: Place::Line(14), index: 4, vertices: 4 });
}

/// The header's list, then numbers that it does not name.
#[test]
fn rows_of_ply_may_be_longer_than_their_properties_and_stand_on_several_lines_or_on_one() {
    let plain = read_surface("a.ply", PLY.as_bytes()).unwrap();
    let longer = PLY.replace("3 0 1 2", "3 0 1 2 9 9 9").replace("3 0 2 3", "3 0 2 3 1 1 1");
    assert_ne!(longer, PLY);
    let surface = read_surface("a.ply", longer.as_bytes()).unwrap();
    assert_eq!((surface.vertices, surface.triangles), (plain.vertices.clone(), plain.triangles.clone()));
    let (head, body) = PLY.split_at(PLY.find("end_header\n").unwrap() + "end_header\n".len());
    for between in [" ", "\n"] {
        let body = body.split_ascii_whitespace().collect::<Vec<_>>().join(between);
        let surface = read_surface("a.ply", [head, &*body, "\n"].concat().as_bytes()).unwrap();
        assert_eq!((surface.vertices, surface.triangles), (plain.vertices.clone(), plain.triangles.clone()));
    }
}

#[test]
fn the_buffer_of_a_gltf_file_may_lie_beside_it_and_nowhere_else() {
    let (document, buffer) = gltf_parts();
    let with = |uri: &str| document.replace("URI", &format!(r#", "uri": "{uri}""#));
    let plain = read_surface("a.gltf", gltf().as_bytes()).unwrap();
    let mut asked = Vec::new();
    let mut beside = |name: &str| {
        asked.push(name.to_owned());
        (name == "the square.bin").then(|| buffer.clone())
    };
    assert_eq!(read_surface_beside("a.gltf", with("the%20square.bin").as_bytes(), &mut beside).unwrap(), plain);
    for away in ["../the square.bin", "/the square.bin", "http://a.b/the square.bin", "c:the square.bin"] {
        assert!(read_surface_beside("a.gltf", with(away).as_bytes(), &mut beside).is_err(), "{away}");
    }
    assert_eq!(asked, ["the square.bin"]);
}

#[test]
fn quantized_and_sparse_positions_are_read() {
    // a triangle in 8 and in 16 bits, and one of which two corners differ from 0
    let bytes: [i8; 12] = [0, 0, 0, 0, 127, 0, 0, 0, 0, -127, 0, 0];
    let shorts: [i16; 9] = [0, 0, 0, 32_767, 0, 0, 0, -32_768, 0];
    let floats: [f32; 6] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let mut buffer: Vec<u8> = bytes.iter().map(|&b| b as u8).collect();
    buffer.extend(shorts.iter().flat_map(|s| s.to_le_bytes()));
    buffer.extend([1, 0, 2, 0]);
    buffer.extend(floats.iter().flat_map(|x| x.to_le_bytes()));
    let data = {
        use base64::Engine as _;
        base64::engine::general_purpose::STANDARD.encode(&buffer)
    };
    let document = |accessor: &str| {
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "extensionsRequired": ["KHR_mesh_quantization"], "nodes": [{{"mesh": 0}}],
            "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}], "accessors": [{accessor}],
            "bufferViews": [{{"buffer": 0, "byteLength": 12, "byteStride": 4}}, {{"buffer": 0, "byteOffset": 12, "byteLength": 18}},
                {{"buffer": 0, "byteOffset": 30, "byteLength": 4}}, {{"buffer": 0, "byteOffset": 34, "byteLength": 24}}],
            "buffers": [{{"byteLength": 58, "uri": "data:;base64,{data}"}}]}}"#
        )
    };
    let corners = |accessor: &str| read_surface("a.gltf", document(accessor).as_bytes()).unwrap().vertices;
    let normalized = [DVec3::ZERO, DVec3::X, DVec3::NEG_Y];
    let bytes = r#"{"bufferView": 0, "componentType": 5120, "normalized": true, "count": 3, "type": "VEC3"}"#;
    assert_eq!(corners(bytes), normalized);
    assert_eq!(corners(&bytes.replace("true", "false")), normalized.map(|p| 127.0 * p));
    assert_eq!(corners(&bytes.replace("5120", "5122").replace("\"bufferView\": 0", "\"bufferView\": 1")), normalized);
    let sparse = r#"{"componentType": 5126, "count": 3, "type": "VEC3", "sparse": {"count": 2,
        "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}}}"#;
    assert_eq!(corners(sparse), [DVec3::ZERO, DVec3::X, DVec3::Y]);
    let beyond = document(&sparse.replace("\"count\": 3", "\"count\": 2"));
    assert!(read_surface("a.gltf", beyond.as_bytes()).unwrap_err().to_string().contains("accessors[0]"));
}
