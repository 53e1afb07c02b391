//! Real errors, produced from user input: the English message equals the error's own text; the German message contains
//! no English words and the same numbers.

use super::{Language, Message, key};
use crate::boundary_integral::BoundaryIntegralError;
use crate::conformal::{Marks, PrepareSettings, QuadrilateralError, Side, rectangle_corners};
use crate::geometry::{DVec2, SimplePolygon};
use crate::mesh::{TriangleId, VertexId};
use crate::outline::{OutlineNote, PartChoice, Reading, Sampling, parse, parse_as, parse_geo_rings, sample};
use crate::projection::{ProjectionError, Region};
use crate::session::file::FileError;
use crate::session::lesson::{LessonError, StepError};
use crate::session::{Command, OutlineSpec, Session, file, link};
use crate::surface::{SurfaceError, SurfaceMesh, SurfaceNote, read_surface};
use serde_json::json;
use std::fmt::Display;

/// English words that no German sentence contains.
const ENGLISH: [&str; 24] = [
    "the", "is", "are", "of", "with", "and", "not", "this", "has", "be", "it", "its", "to", "must", "there", "where",
    "than", "that", "from", "point", "line", "outline", "surface", "side",
];

fn numbers(text: &str) -> Vec<&str> {
    let mut numbers: Vec<&str> =
        text.split(|letter: char| !letter.is_ascii_digit()).filter(|run| !run.is_empty()).collect();
    numbers.sort_unstable();
    numbers
}

/// The text without quoted names and, if the cause is from another source, without the parts in brackets.
fn own_words(text: &str, is_cause_foreign: bool) -> String {
    let mut words = String::new();
    let (mut quoted, mut bracketed) = (false, 0);
    for letter in text.chars() {
        match letter {
            '„' => quoted = true,
            '“' => quoted = false,
            '(' if is_cause_foreign => bracketed += 1,
            ')' if is_cause_foreign => bracketed -= 1,
            _ if !quoted && bracketed == 0 => words.push(letter),
            _ => {}
        }
    }
    words
}

fn check(message: &Message, is_cause_foreign: bool) {
    let (english, german) = (message.english(), Language::German.message(message));
    let words = own_words(&german, is_cause_foreign);
    let left = words.split(|letter: char| !letter.is_alphabetic()).find(|word| ENGLISH.contains(word));
    assert_eq!(left, None, "{english:?} became {german:?}");
    assert_ne!(german, english);
    assert_eq!(numbers(&german), numbers(&english), "{german}");
}

/// The message of an error; checks that in English it equals the error's own text.
fn message<E: Display>(error: &E) -> Message
where
    for<'a> Message: From<&'a E>,
{
    let message = Message::from(error);
    assert_eq!(message.english(), error.to_string());
    message
}

/// Checks that the German message has no English words except for the cause in brackets.
fn german_but_for_the_cause<E: Display>(error: &E)
where
    for<'a> Message: From<&'a E>,
{
    check(&message(error), true);
}

fn german<E: Display>(error: &E)
where
    for<'a> Message: From<&'a E>,
{
    check(&message(error), false);
}

#[test]
fn quadrilaterals_and_regions_without_a_map() {
    for marks in [[0.0, f64::NAN, 0.5, 0.75], [0.0, 0.0, 0.5, 0.75], [0.0, 0.5, 0.25, 0.75]] {
        german(&Marks::new(marks).unwrap_err());
    }
    for modulus in [1e8, 1e-8] {
        german(&rectangle_corners(modulus).unwrap_err());
    }
    german(&QuadrilateralError::NoMiddle);
    german(&QuadrilateralError::from(BoundaryIntegralError::TooManyUnknowns { needed: 5000, limit: 3072 }));
    let ring = |points: &[[f64; 2]]| points.iter().copied().map(DVec2::from).collect::<Vec<_>>();
    let regions: [&[&[[f64; 2]]]; 5] = [
        &[&[[0.0, 0.0], [1.0, 0.0], [1.0, 95.0]]],
        &[&[[0.0, 0.0], [400.0, 0.0], [1.0, 5.0]]],
        &[&[[0.0, 0.0], [1.0, 0.0], [0.0, 0.0]]],
        &[&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]],
        &[&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]]],
    ];
    for rings in regions {
        let rings: Vec<Vec<DVec2>> = rings.iter().map(|points| ring(points)).collect();
        match Region::new(&rings) {
            Err(error) => german(&error),
            Ok(region) => panic!("{rings:?} is a region of area {}", region.area()),
        }
    }
    german(&ProjectionError::NearlyWholeSphere { clearance: 0.25 });
    german(&ProjectionError::Cancelled);
    german(&ProjectionError::NoBoundary);
}

#[test]
fn files_that_are_no_outlines() {
    let files = [
        ("a.csv", "0,0\n1,0\n"),
        ("a.csv", "0,0\n1,0\n1,x y\n"),
        ("a.csv", "0,0\n1\n"),
        ("a.csv", "0,0\n1,0,2,3\n"),
        ("a.csv", "0,0\n1,\n"),
        ("a.csv", "0,0\n1,1e999\n"),
        ("a.csv", "0,0\n2,2\n2,0\n0,2\n"),
        ("a.csv", "0,0\n2,0\n0,0\n2,2\n"),
        ("a.csv", "0,0\n1,1\n2,2\n"),
        ("a.csv", "0,0\n2,0\n1,0\n1,3\n"),
        ("a.csv", "0,0\n1e300,0\n0,1\n"),
        ("a.csv", "0,0\n1e-300,0\n0,1e-300\n"),
        ("a.csv", "0,0\n1,0\nnot a row\n1,1\n"),
        ("a.json", "{\"x\": [1, 2], \"y\": [1]}"),
        ("a.txt", "0 0 1 0 1 1 2"),
        ("a.txt", " "),
        ("a.json", "[[0,0],[1,\"b\"],[1,1]]"),
        ("a.json", "[[0,0],[1],[1,1]]"),
        ("a.json", "[[0,0],[1,2,3],[1,1]]"),
        ("a.json", "[[0,0],null,[1,1]]"),
        ("a.json", "{\"points\": {}}"),
        ("a.json", "{\"pints\": []}"),
        ("a.json", "true"),
        ("a.json", "{\"type\": \"Polygon\", \"coordinates\": [[[0,0],[1,0],[1,1],[0,1]]]}"),
        ("a.json", "{\"type\": \"Polygon\", \"coordinates\": [3]}"),
        ("a.json", "{\"type\": \"Polygon\", \"coordinates\": [[]]}"),
        ("a.json", "{\"type\": \"MultiPolygon\", \"coordinates\": [3]}"),
        ("a.json", "{\"type\": \"Polygon\"}"),
        ("a.json", "{\"type\": \"Polygon\", \"coordinates\": 3}"),
        ("a.json", "{\"type\": \"Circle\"}"),
        ("a.json", "{\"type\": \"FeatureCollection\", \"features\": [{}]}"),
        ("a.json", "{\"type\": \"Point\"}"),
        (
            "a.svg",
            "<svg xmlns=\"http://www.w3.org/2000/svg\"><path fill=\"none\" stroke=\"red\" d=\"M 0 0 L 1 0 L 1 1\"/></svg>",
        ),
        ("a.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"),
    ];
    for (name, text) in files {
        let error = parse(name, text.as_bytes()).expect_err(text);
        german(&error);
        check(&key::about(name, message(&error)), false);
    }
    german(&parse("a.csv", b"0,0\n1,\xff\x01\n").unwrap_err());
    let part = |text: &str| {
        parse_as("a", text.as_bytes(), &Reading { repair: false, part: Some(PartChoice::Called("b")) }).unwrap_err()
    };
    let shapes = |ids: [&str; 2]| {
        let paths = ids.map(|id| format!("<path {id} d=\"M0 0h9v9z\"/>")).concat();
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{paths}</svg>")
    };
    german(&part("0,0\n1,0\n0,1\n"));
    german(&part(&shapes(["", ""])));
    german(&part(&shapes(["id=\"a\"", ""])));
    let metres = "{\"type\": \"Polygon\", \"crs\": {\"properties\": {\"name\": \"EPSG:25832\"}}, \"coordinates\": []}";
    german(&parse_geo_rings(metres.as_bytes(), &Reading::default()).unwrap_err());
    let nested = format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{}{}</svg>", "<g>".repeat(99), "</g>".repeat(99));
    german(&parse("a.svg", nested.as_bytes()).unwrap_err());
    for (name, text) in [("a.json", "[[0,0],"), ("a.svg", "<svg><g></svg>")] {
        german_but_for_the_cause(&parse(name, text.as_bytes()).unwrap_err());
    }
}

#[test]
fn notes_on_outlines() {
    let files = [
        "{\"type\": \"MultiPolygon\", \"coordinates\": [[[[0,0],[0,1],[1,0],[0,0]], [[0,0],[1,0],[0,1],[0,0]]], \
         [[[0,0],[9,0],[0,9],[0,0]], [[0,0],[1,0],[0,1],[0,0]], [[0,0],[1,0],[0,1],[0,0]]]]}",
        "[[0,0],[0,1],[1,1],[1,0],[0,0]]",
    ];
    let notes: Vec<_> =
        files.iter().flat_map(|text| parse("a.json", text.as_bytes()).unwrap().notes().to_vec()).collect();
    assert_eq!(notes.len(), 5, "{notes:?}");
    notes.iter().for_each(german);
    for name in [None, Some("body".to_owned())] {
        german(&OutlineNote::ShapeTaken { number: 2, count: 3, name });
    }
    for count in [1, 2] {
        german(&OutlineNote::RepeatedPointsDropped { count });
        german(&OutlineNote::ColumnsDropped { columns: count });
    }
}

#[test]
fn files_that_are_no_surfaces() {
    let head = "ply\nformat ascii 1.0\n";
    let vertices = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
    let asset = "{\"asset\": {\"version\": \"2.0\"}, ";
    let primitive = "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}], \"nodes\": [{\"mesh\": 0}]";
    let files = [
        ("a.obj", "v 0 0\n".into()),
        ("a.obj", "v 0 0 x\n".into()),
        ("a.obj", "v 0 0 0\nf 1 2 3\n".into()),
        ("a.obj", "v 0 0 0\nf 1 1\n".into()),
        ("a.off", "OFF\n-3 1 0\n".into()),
        ("a.off", "OFF\n3\n".into()),
        ("a.off", "OFF\n2 1 0\n0 0 0\n".into()),
        ("a.off", "OFF\n1 1 0\n0 0 0\n3 0 0\n".into()),
        ("a.off", "OFF BINARY\n".into()),
        ("a.off", "4OFF\n".into()),
        ("a.off", String::new()),
        ("a.stl", "solid a\nfacet\nouter loop\nvertex 0 0 0\n".into()),
        ("a.stl", "\0\0\0".into()),
        ("a.ply", "plx\n".into()),
        ("a.ply", format!("{head}{vertices}")),
        ("a.ply", "ply\nformat utf8 1.0\nend_header\n".into()),
        ("a.ply", "ply\nfoo\nend_header\n".into()),
        ("a.ply", "ply\nproperty float x\nend_header\n".into()),
        ("a.ply", "ply\nend_header\n".into()),
        ("a.ply", format!("{head}element vertex 1\nproperty real x\nend_header\n")),
        ("a.ply", format!("{head}element vertex 1\nproperty list float int a\nend_header\n")),
        ("a.ply", format!("{head}element vertex 1\nproperty float x\nend_header\n0\n")),
        ("a.ply", format!("{head}{vertices}end_header\n0 0\n")),
        ("a.ply", format!("{head}{vertices}element face 1\nend_header\n0 0 0\n")),
        ("a.ply", format!("{head}element tristrips 1\nproperty list int int vertex_indices\nend_header\n3 0 0 0\n")),
        ("a.glb", "glTX".into()),
        ("a.glb", "glTF\u{3}\0\0\0".into()),
        ("a.glb", "glTF\u{2}\0\0\0\0\0\0\0".into()),
        ("a.glb", "glTF\u{2}\0\0\0\0\0\0\0\u{9}\0\0\0".into()),
        ("a.gltf", format!("{asset}\"extensionsRequired\": [\"KHR_draco_mesh_compression\"]}}")),
        ("a.gltf", format!("{asset}\"scene\": 4}}")),
        ("a.gltf", format!("{asset}\"nodes\": [{{\"mesh\": 3}}]}}")),
        ("a.gltf", format!("{asset}\"scenes\": [{{\"nodes\": [0, 0]}}], \"nodes\": [{{}}]}}")),
        ("a.gltf", format!("{asset}\"buffers\": [{{}}]}}")),
        ("a.gltf", format!("{asset}\"buffers\": [{{\"uri\": \"b.bin\"}}]}}")),
        ("a.gltf", format!("{asset}\"buffers\": [{{\"uri\": \"data:,a\"}}]}}")),
        ("a.gltf", format!("{asset}\"buffers\": [{{\"uri\": \"data:;base64,A?\"}}]}}")),
        ("a.gltf", format!("{asset}{primitive}}}")),
        ("a.gltf", format!("{asset}{primitive}, \"accessors\": [{{\"sparse\": {{}}}}]}}")),
        ("a.gltf", format!("{asset}{primitive}, \"accessors\": [{{\"type\": \"VEC2\", \"componentType\": 5126}}]}}")),
        ("a.xyz", "nothing".into()),
    ];
    for (name, text) in &files {
        let error = read_surface(name, text.as_bytes()).map(|surface| surface.triangles().len()).expect_err(text);
        german(&error);
        check(&key::about(*name, message(&error)), false);
    }
    german_but_for_the_cause(&read_surface("a.gltf", b"{").unwrap_err());
    let (triangles, vertices) = (9_000_000, 4_500_000);
    german(&SurfaceError::TooMuchMemory { triangles, vertices, needed_mb: 5400, available_mb: 4000 });
}

#[test]
fn surfaces_that_are_no_disks() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    let surfaces = [
        (square, "f 1 2 2\n"),
        ("v 0 0 0\nv 1 0 0\nv 2 0 0\n", "f 1 2 3\n"),
        ("v 0 0 0\nv 1e99 0 0\nv 0 2 0\n", "f 1 2 3\n"),
        ("v 0 0 0\nv 1e-99 0 0\nv 0 1e-99 0\n", "f 1 2 3\n"),
        (square, "f 1 2 3\nf 1 3 4\nf 2 1 3\n"),
        ("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n", "f 1 2 3\nf 1 2 4\nf 2 1 5\n"),
        (square, "f 1 2 3\nf 1 4 3\n"),
        ("v 0 0 0\nv nan 0 0\nv 0 inf 0\n", "f 1 2 3\n"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\n", "f 1 2 3\nf 4 5 6\n"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\nv 0 -1 0\n", "f 1 2 3\nf 1 4 5\n"),
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n", "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"),
        (
            "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 1 1 0\nv 3 1 0\nv 1 3 0\n",
            "f 1 2 5\nf 1 5 4\nf 2 3 6\nf 2 6 5\nf 3 1 4\nf 3 4 6\n",
        ),
        // three kinds
        ("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 7 0 0\n", "f 1 2 3\nf 1 2 2\nf 4 5 6\n"),
    ];
    for (vertices, faces) in surfaces {
        let surface = read_surface("a.obj", format!("{vertices}{faces}").as_bytes()).unwrap();
        german(&SurfaceMesh::new(&surface).expect_err(faces));
        if let Ok(repaired) = SurfaceMesh::repaired(&surface) {
            repaired.repairs().iter().for_each(german);
        }
    }
    // a strip of 7 × 3 squares with three squares missing: four boundary loops
    let vertices = (0..32).map(|k| format!("v {} {} 0\n", k % 8, k / 8)).collect::<Vec<_>>().concat();
    let kept = (0..21).map(|k| (k % 7, k / 7)).filter(|place| ![(1, 1), (3, 1), (5, 1)].contains(place));
    let corners = |(x, y): (usize, usize)| [0, 1, 9, 8].map(|corner| 8 * y + x + corner + 1);
    let faces = kept.map(corners).map(|[a, b, c, d]| format!("f {a} {b} {c} {d}\n")).collect::<Vec<_>>().concat();
    let strip = read_surface("a.obj", format!("{vertices}{faces}").as_bytes()).unwrap();
    let error = SurfaceMesh::new(&strip).unwrap_err();
    assert!(error.to_string().contains("4 boundary loops"), "{error}");
    german(&error);
    let polygon = read_surface("a.obj", format!("{square}f 1 2 3 4\n").as_bytes()).unwrap();
    polygon.notes().iter().for_each(german);
    let longer = read_surface("a.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n").unwrap();
    assert_eq!(longer.notes().len(), 1);
    longer.notes().iter().for_each(german);
    german(&SurfaceNote::Unended);
}

#[test]
fn sessions_and_links_that_cannot_be_opened() {
    for text in ["{}", "{\"riemap\": 7}"] {
        german(&file::read(text.as_bytes()).unwrap_err());
    }
    for text in ["{\"riemap\": 1}", "[", "\u{1}"] {
        german_but_for_the_cause(&file::read(text.as_bytes()).unwrap_err());
    }
    let part = || String::from("surfaces/cow.obj");
    for error in [
        FileError::TooLarge { limit: 448 << 20 },
        FileError::MissingPart(part()),
        FileError::PartTooLarge { part: part(), limit: 384 << 20 },
        FileError::TooManyParts { limit: 1024 },
        FileError::InPart { part: part(), error: Box::new(FileError::NoSession) },
    ] {
        german(&error);
    }
    german_but_for_the_cause(&FileError::Damaged("cut".into()));
    german_but_for_the_cause(&FileError::BrokenPart { part: part(), reason: "cut".into() });
    for address in ["", "#s=1.AAAA", "#s=2.AAAA", "#s=3.AAAA", "#s=1.____", &format!("#s={}", "A".repeat(9000))] {
        let error = link::decode(address).unwrap_err();
        german(&error);
        let last = key::last_session_not_opened(message(&file::read(b"{}").unwrap_err()));
        check(&key::sentence_and(key::link_not_opened(message(&error)), last), false);
    }
    let shortened =
        link::ShortenedOutline { side: Side::Source, name: "leaf".into(), from: 900, to: 200, deviation: 0.001_3 };
    check(&message(&shortened), false);
    assert!(Language::German.message(&message(&shortened)).contains("um höchstens 0,13\u{a0}% seiner Größe"));
    let side = Side::Source;
    let coarse =
        PrepareSettings { sampling: Sampling::Uniform { count: 7, keep_corners: true }, ..PrepareSettings::default() };
    for command in [
        Command::SetTextureScale(1e9),
        Command::SetSettings { side, settings: coarse },
        Command::MoveInterior { side, point: DVec2::new(0.0, f64::INFINITY).into() },
    ] {
        let session = Session::with([command]);
        check(&key::session_not_saved(message(&file::write(&session).unwrap_err())), false);
        check(&key::no_link_to_session(message(&link::encode(&session).unwrap_err())), false);
    }
    let bow = json!({ "points": { "name": "the bow", "points": [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]] } });
    for (field, value) in [("/anchor/1", json!(-3.0)), ("/version", json!(2)), ("/target/outline", bow)] {
        let mut written =
            serde_json::from_str::<serde_json::Value>(&file::write(&Session::default()).unwrap()).unwrap();
        *written.pointer_mut(field).unwrap() = value;
        german(&file::read(written.to_string().as_bytes()).unwrap_err());
    }
    let spike = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.31 + 1e-9, 1.0), (0.31, 0.2), (0.31 - 1e-9, 1.0), (0.0, 1.0)];
    let polygon = SimplePolygon::try_from(spike.map(DVec2::from).to_vec()).unwrap();
    let session = Session::with(Side::BOTH.map(|side| {
        let outline = OutlineSpec::points(format!("a spike of the {side}"), polygon.clone());
        Command::SetOutline { side, outline }
    }));
    let rough = |k: u32| 1.0 + 0.01 * f64::from(k * 7919 % 1000) / 1000.0;
    let points: Vec<DVec2> =
        (0..20_000).map(|k| rough(k) * DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 20_000.0)).collect();
    let outline = OutlineSpec::points("a rough circle".into(), points.try_into().unwrap());
    let long = Session::with([Command::SetOutline { side: Side::Target, outline }]);
    let shortened = link::encode(&long).unwrap().shortened;
    assert_eq!(shortened.len(), 1);
    check(&key::link_copied_but(Message::from(&shortened[0])), false);
    let reason = key::browser_stores_nothing();
    check(&key::files_not_kept(reason), false);
    check(&key::only_session_kept(reason), false);
    let both = link::encode(&session).unwrap().left_out;
    assert_eq!(both.len(), 2);
    check(&key::link_copied_but(key::both_clauses(message(&both[0]), message(&both[1]))), false);
    for left_out in &both {
        let both = key::both_clauses(message(left_out), key::image_not_in_link());
        check(&key::link_copied_but(both), false);
    }
}

#[test]
fn errors_of_computation_and_export() {
    use crate::conformal::{HarmonicTable, Memory};
    use crate::render::{Film, FilmFormat, FilmSettings};
    let disk = crate::outline::Preset::Disk.outline().into_polygon();
    for count in [2, u32::MAX] {
        german(&sample(&disk, Sampling::Uniform { count, keep_corners: true }).unwrap_err());
    }
    german(&HarmonicTable::check(10_000_000, 10_000, Memory::default()).unwrap_err());
    let sound = FilmSettings { format: FilmFormat::Gif, size: [100, 80], frames: 20, seconds: 2.0 };
    for settings in [
        FilmSettings { frames: 1, ..sound },
        FilmSettings { seconds: 1e9, ..sound },
        FilmSettings { size: [70_000, 80], ..sound },
        FilmSettings { frames: 200, seconds: 1.0, ..sound },
    ] {
        german(&Film::new(settings).err().unwrap());
    }
}

/// Messages in singular and plural.
#[test]
fn counts_of_one() {
    use crate::conformal::MapNote;
    use crate::surface::{RepairNote, TopologyError};
    let sentences = |count: usize| {
        let corners = [4, 4, 7].map(VertexId::new);
        [
            message(&TopologyError::RepeatedCorner { triangle: TriangleId::new(5), corners, count }),
            message(&TopologyError::Degenerate { triangle: TriangleId::new(5), corners, count }),
            message(&TopologyError::Duplicates {
                triangle: TriangleId::new(5),
                corners,
                other: TriangleId::new(2),
                count,
            }),
            message(&TopologyError::NonManifoldEdge {
                edge: [2, 4].map(VertexId::new),
                triangles: [5, 7, 9].map(TriangleId::new).to_vec(),
                count,
            }),
            message(&TopologyError::Orientation {
                edge: [2, 4].map(VertexId::new),
                triangles: [5, 7].map(TriangleId::new),
                count,
            }),
            message(&TopologyError::NonManifoldVertex { vertex: VertexId::new(4), fans: 3, count }),
            message(&TopologyError::NotFinite { vertex: VertexId::new(4), count }),
            message(&TopologyError::Genus { genus: count }),
            message(&RepairNote::DroppedTriangles { count }),
            message(&RepairNote::DroppedDuplicates { count }),
            message(&RepairNote::MergedVertices { count }),
            message(&RepairNote::FlippedFlat { count }),
            message(&RepairNote::SplitVertices { count }),
            message(&RepairNote::Joined { count }),
            message(&RepairNote::Oriented { count }),
            message(&RepairNote::KeptLargest { components: 3, dropped: count }),
            message(&RepairNote::DroppedVertices { count }),
            message(&MapNote::NoMeasure { edges: count }),
            message(&MapNote::NegativeKernel { edges: count }),
        ]
    };
    for said in sentences(1) {
        let sentence = said.english();
        let words: Vec<&str> = sentence.split_whitespace().collect();
        assert!(!words.windows(2).any(|pair| pair[0] == "1" && pair[1].ends_with('s')), "{sentence}");
        assert!(![" vertices", "s were ", "s have "].iter().any(|plural| sentence.contains(plural)), "{sentence}");
        check(&said, false);
    }
    for said in sentences(6) {
        assert!(said.english().contains('6'), "{}", said.english());
        check(&said, false);
    }
}

#[test]
fn lessons_that_cannot_be_read_or_written() {
    let step = |line, error| LessonError::Step { step: 2, line, error };
    for error in [
        LessonError::TooLarge,
        LessonError::NotText,
        LessonError::NoLesson,
        LessonError::Version { found: "2".into() },
        LessonError::Line { line: 3 },
        LessonError::NoSteps,
        LessonError::TooManySteps,
        LessonError::LongTitle { length: 300 },
        LessonError::Link(link::LinkError::Damaged),
        LessonError::TooLongForLink,
        step(Some(5), StepError::Link(link::LinkError::NoSession)),
        step(None, StepError::MissingOutline { side: Side::Source, name: "the hand".into() }),
        step(None, StepError::SurfaceFile { name: "cow.obj".into() }),
        step(None, StepError::OwnPicture),
        step(None, StepError::LongCaption { length: 3000 }),
    ] {
        german(&error);
    }
}
