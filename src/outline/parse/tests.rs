//! Outlines are read from every format; files that hold none give an error with its place.

use proptest::prelude::*;

use super::*;
use crate::geometry::{DVec2, MAX_POINTS, PolygonError};

fn read(file_name: &str, text: &str) -> Result<Outline, OutlineError> {
    parse(file_name, text.as_bytes())
}

fn vertices(outline: &Outline) -> Vec<(f64, f64)> {
    outline.polygon.vertices().iter().map(|p| (p.x, p.y)).collect()
}

fn message(file_name: &str, text: &str) -> String {
    read(file_name, text).unwrap_err().to_string()
}

/// An SVG of 100 × 100 with this content.
fn svg(content: &str) -> String {
    format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">{content}</svg>"#)
}

const TRIANGLE: [(f64, f64); 3] = [(0.0, 0.0), (4.0, 0.0), (0.0, 3.0)];

#[test]
fn the_same_triangle_in_every_format() {
    let files = [
        ("t.json", "[[0,0],[4,0],[0,3]]"),
        ("t.json", r#"{"points": [[0, 0], [4, 0], [0, 3.0]], "source": null}"#),
        ("t.json", r#"{"type":"Polygon","coordinates":[[[0,0],[4,0],[0,3],[0,0]]]}"#),
        ("t.csv", "x,y\n0,0\n4,0\n0,3\n"),
        ("t.csv", "0;0\r\n4;0\r\n0;3"),
        ("t.tsv", "\"x\"\t\"y\"\n0\t0\n4\t0\n0\t3"),
        ("t.txt", "# a triangle\n\n  0 0\n4.0e0   0 # right\n0 , 3\n"),
        ("t", "\u{feff}0 0\n4 0\n0 3"),
        ("t.txt", "[[0,0],[4,0],[0,3]]"),
        ("t.json", r#"{"x": [0, 4, 0], "y": [0, 0, 3]}"#),
        ("t.json", r#"[{"x": 0, "y": 0}, {"x": 4, "y": 0}, {"x": 0, "y": 3}]"#),
        ("t.csv", "\"0,0\";\"0\"\n\"4,0\";\"0,0\"\n0;3,00"),
        ("t.csv", "\"0\",\"0\"\n\"4\",\"0\"\n\"0\",\"3\""),
        ("t.txt", "0,0\t0,0\n4,0\t0,0\n0,0\t3,0"),
        ("t.dat", "M12 made with 3 points\n0 0\n4 0\n0 3\nend of file\n"),
        ("t.dat", "NACA 2412\n0.0 0.0\n4.0 0.0\n0.0 3.0\n"),
        ("t.csv", "% from 2026\n> part\nx [mm], y [mm]\n0, 0\n4, 0\n0, 3\n"),
        ("t.csv", "Nr;X;Y\n1;0;0\n2;4;0\n3;0;3\n"),
        ("t.csv", ",x,y\n0,0,0\n1,4,0\n2,0,3\n"),
        ("t.xyz", "0 0 7\n4 0 7\n0 3 7\n"),
        ("t.txt", "3\n0 0\n4 0\n0 3\n"),
        ("t.wkt", "POLYGON ((0 0, 4 0, 0 3, 0 0))"),
        ("t.wkt", "SRID=25832;MULTIPOLYGON Z (((9 9 1, 9 8 1, 8 9 1, 9 9 1)), ((0 0 5, 4 0 5,\n 0 3 5, 0 0 5)))"),
        ("t.d", "M 0 0 L 4 0 0 -3 Z"),
        ("t.SVG", r#"<svg xmlns="http://www.w3.org/2000/svg"><path d="M0 0 h4 L0 -3 z"/></svg>"#),
    ];
    for (name, text) in files {
        let outline = read(name, text).unwrap_or_else(|e| panic!("{name}: {text}: {e}"));
        assert_eq!(vertices(&outline), TRIANGLE, "{text}");
        assert_eq!(outline.name, "t");
        // GeoJSON's coordinates are degrees, which a plane does not have
        let notes: &[OutlineNote] = match text {
            _ if text.contains("Polygon") => &[OutlineNote::Geographic],
            _ if ["t.d", "t.SVG"].contains(&name) => &[OutlineNote::Upwards],
            _ if text.contains("MULTI") => &[OutlineNote::LargestOf { rings: 2 }],
            _ => &[],
        };
        assert_eq!(outline.notes, notes, "{text}");
    }
}

#[test]
fn a_name_in_the_file_goes_before_the_files_own() {
    let outline = read("folder/a.b.json", r#"{"name": "Leaf", "points": [[0,0],[1,0],[0,1]]}"#).unwrap();
    assert_eq!(outline.name, "Leaf");
    assert_eq!(read(r"C:\folder\a.b.json", "[[0,0],[1,0],[0,1]]").unwrap().name, "a.b");
    assert_eq!(read(".json", "[[0,0],[1,0],[0,1]]").unwrap().name, ".json");
    let feature = r#"{"type":"Feature","properties":{"name":"Isle"},
        "geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1],[0,0]]]}}"#;
    assert_eq!(read("x.geojson", feature).unwrap().name, "Isle");
}

#[test]
fn what_was_changed_is_said() {
    let clockwise = read("c.csv", "0 0\n0 1\n1 1\n1 0\n0 0").unwrap();
    assert_eq!(clockwise.notes, [OutlineNote::ClosingPointDropped, OutlineNote::Reversed]);
    assert_eq!(vertices(&clockwise), [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let said: Vec<String> = clockwise.notes.iter().map(ToString::to_string).collect();
    assert_eq!(
        said,
        ["The last point repeated the first one and was dropped.", "The points ran clockwise and were reversed."]
    );
}

#[test]
fn geojson_gives_the_largest_outer_ring_of_all_features() {
    let text = r#"{"type":"FeatureCollection","features":[
        {"type":"Feature","properties":null,"geometry":null},
        {"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1,2]}},
        {"type":"Feature","properties":{"name":"two"},"geometry":{"type":"GeometryCollection","geometries":[
            {"type":"MultiPolygon","coordinates":[
                [[[0,0],[1,0],[1,1],[0,0]]],
                [[[0,0,5],[9,0,5],[9,9,5],[0,0,5]],[[5,1],[6,1],[6,2],[5,1]]]]}]}},
        {"type":"Feature","properties":{"name":"three"},
            "geometry":{"type":"Polygon","coordinates":[[[0,0],[2,0],[2,2],[0,0]]]}}]}"#;
    let outline = read("world.geojson", text).unwrap();
    assert_eq!(vertices(&outline), [(0.0, 0.0), (9.0, 0.0), (9.0, 9.0)]);
    let notes = [OutlineNote::LargestOf { rings: 3 }, OutlineNote::HolesIgnored { holes: 1 }, OutlineNote::Geographic];
    assert_eq!(outline.notes, notes);
    assert_eq!(outline.name, "two");
    assert!(outline.is_geographic());
    // latitudes end at the poles, and another format has no longitudes
    let far = r#"{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,91],[0,0]]]}"#;
    let others = [read("far.geojson", far).unwrap(), read("a.json", "[[0,0],[9,0],[9,9]]").unwrap()];
    assert!(others.iter().all(|outline| !outline.is_geographic()));
}

#[test]
fn faults_of_geojson_are_named() {
    let open = r#"{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1]]]}"#;
    assert_eq!(message("x.json", open), "ring 1 is not closed: it starts at (0, 0) and ends at (1, 1)");
    let single = r#"{"type":"Polygon","coordinates":[[[0,0]]]}"#;
    assert!(matches!(read("x.json", single), Err(OutlineError::RingNotClosed { .. })));
    let line = r#"{"type":"LineString","coordinates":[[0,0],[1,0]]}"#;
    assert_eq!(message("x.json", line), "this GeoJSON holds no polygon (its type is LineString)");
    for (text, fault) in [
        (r#"{"type":"Polygon"}"#, "\"coordinates\" is missing"),
        (r#"{"type":"Polygon","coordinates":7}"#, "\"coordinates\" is a number, not a list"),
        (r#"{"type":"Polygon","coordinates":[[]]}"#, "ring 1 has no points"),
        (r#"{"type":"Polygon","coordinates":[{}]}"#, "a ring is an object, not a list"),
        (r#"{"type":"Topology"}"#, "\"Topology\" is no GeoJSON type"),
        (r#"{"type":"Polygon","coordinates":[[[0,0],[1],[0,0]]]}"#, "point 2 has 1 number"),
    ] {
        assert!(message("x.json", text).contains(fault), "{}", message("x.json", text));
    }
}

#[test]
fn faults_of_json_are_named_with_line_and_column() {
    assert_eq!(
        read("x.json", "[[0, 0],\n [1, 0],\n [0, oops]]"),
        Err(OutlineError::Json { line: 3, column: 6, message: "expected value".to_owned() })
    );
    let huge = read("x.json", "[[0,0],\n[1e999,0],[0,1]]").unwrap_err();
    assert!(matches!(huge, OutlineError::NumberOutOfRange { line: 2, .. }), "{huge}");
    assert_eq!(message("x.json", "[[0,0],[1,0],[1,2,3]]"), "point 3 has 3 numbers; a point is [x, y]");
    assert_eq!(message("x.json", "[[0,0],7]"), "point 2 is a number; a point is [x, y]");
    assert_eq!(
        message("x.json", "[[0,0],[1,\"2\"]]"),
        "point 2 has a text where a number should be; a point is [x, y]"
    );
    assert!(message("x.json", "{\"points\": 1}").contains("\"points\" is a number"));
    assert!(message("x.json", "{}").contains("an object without \"points\""));
    assert!(message("x.json", "null").contains("null"));
    assert!(message("x.json", &"[".repeat(100_000)).contains("recursion limit"));
}

#[test]
fn points_are_read_as_languages_print_them() {
    for text in [
        "[(0, 0), (4, 0), (0, 3)]",
        "(0, 0)\n(4, 0)\n(0, 3)\n",
        "[[0. 0.]\n [4. 0.]\n [0. 3.]]\n",
        "{{0, 0}, {4, 0}, {0, 3}}",
        "0.0D+00 0.0d0\n4.D0 0\n0 3.0D0\n",
        "0,0,\n4,0,\n0,3,\n",
        "lat,lon\n0,0\n0,4\n3,0\n",
        "Northing [m];Easting [m]\n0;0\n0;4\n3;0\n",
    ] {
        assert_eq!(vertices(&read("x.txt", text).unwrap()), TRIANGLE, "{text}");
    }
    for text in [
        "[[0,0],[4,0],[0,3]",
        "[(0, 0), (4, 0), (0, 3, 1)]",
        "[(0, 0), (4, 0), (0, NaN)]",
        "[(0, 0), (4, 0]), x",
        "[(0, 0, [4, 0], [4, 4], [0, 4])]",
        "((0,0),(4,0),(4,4)), ((0,4),(-1,4),(-1,0))",
        "[[[0. 0.] [4. 0.]] [[0. 3.] [1. 1.]]]",
    ] {
        assert!(read("x.txt", text).is_err(), "{text}");
    }
    assert!(read("x.csv", "0,0\n4,\n0,3\n").is_err(), "a number is missing");
}

#[test]
fn faults_of_tables_are_named_with_line_and_column() {
    let fault = |text: &str| message("x.csv", text);
    assert_eq!(fault("x,y\n1,2\n3,é4"), "\"é4\" at line 3, column 3 is not a number");
    assert_eq!(fault("1,2\n3"), "line 2 has 1 number; a point is two");
    assert_eq!(fault("x,y\n0,0\n1\n"), "line 3 has 1 number; a point is two");
    assert_eq!(fault("0,0\n4,0\n4,4\n−1,4"), "\"−1\" at line 4, column 1 is not a number");
    assert_eq!(fault("0.O,0\n4,0\n4,4"), "\"0.O\" at line 1, column 1 is not a number");
    assert_eq!(fault("0,0\n4,0\n4,4\nO,4"), "\"O\" at line 4, column 1 is not a number");
    assert_eq!(fault("0,5, 1,5\n2,5, 1,5\n0,5, 7,5"), "line 1 has 4 numbers; a point is two");
    assert_eq!(fault("0,5 1,5\n2,5 1,5\n0,5 7,5"), "line 1 has 4 numbers; a point is two");
    assert_eq!(fault("1,2\n3,4,5"), "line 2 has 3 numbers; a point is two");
    assert_eq!(fault("1,2\nnot a row\n3,4"), "line 2 is not understood: \"not a row\"");
    assert_eq!(fault("1,2\n\n  1e999 3"), "the number at line 3, column 3 is out of range");
    assert_eq!(fault("1,NaN"), "\"NaN\" at line 1, column 3 is not a number");
    assert_eq!(fault("1,,2"), "a number is missing at line 1, column 3");
    assert_eq!(fault("1,,"), "a number is missing at line 1, column 3");
    assert_eq!(fault(",2"), "a number is missing at line 1, column 1");
    assert_eq!(fault("1,2\nx,y\n3,4"), "\"x\" at line 2, column 1 is not a number");
    assert_eq!(fault("width 3"), "\"width\" at line 1, column 1 is not a number");
    assert_eq!(fault("# nothing\n"), "the file is empty");
}

#[test]
fn bytes_that_are_no_text_are_refused() {
    assert_eq!(parse("x.json", b""), Err(OutlineError::Empty));
    assert_eq!(parse("x.svg", b" \n\t"), Err(OutlineError::Empty));
    assert_eq!(parse("x.csv", b"0 0\n1 \xff\x01"), Err(OutlineError::NotUtf8 { offset: 6 }));
    // a title in Latin-1
    let named = parse("x.csv", b"L\xe4nge\n0 0\n1 0\n0 1").unwrap();
    assert_eq!(vertices(&named), [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    let utf16: Vec<u8> = "\u{feff}0\t0\r\n1\t0\r\n0\t1\r\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(vertices(&parse("x.txt", &utf16).unwrap()), vertices(&named));
    let large = vec![b' '; MAX_BYTES + 1];
    assert_eq!(parse("x.csv", &large), Err(OutlineError::TooLarge { bytes: MAX_BYTES + 1 }));
    assert!(OutlineError::TooLarge { bytes: 1 }.to_string().contains("64 MiB"));
}

#[test]
fn faults_of_the_polygon_come_through() {
    let crossing = read("x.json", "[[0,0],[2,2],[2,0],[0,2]]");
    assert!(matches!(crossing, Err(OutlineError::Polygon(PolygonError::EdgesCross { .. }))));
    let many: String = (0..=MAX_POINTS).map(|k| format!("{k} {}\n", k * k)).collect();
    assert!(message("x.csv", &many).contains("at most 200000 points"));
    for text in ["1e150 0\n0 1e150\n0 0", "1e-150 0\n0 1e-150\n0 0", "1e308 0\n0 -1e308\n-1e308 0"] {
        let error = read("x.csv", text).unwrap_err();
        let polygon =
            matches!(error, OutlineError::Polygon(PolygonError::TooFarOut { .. } | PolygonError::TooSmall { .. }));
        assert!(polygon, "{error}");
    }
}

#[test]
fn svg_shapes_are_outlines_too() {
    let rectangle = read("r.svg", &svg(r#"<rect x="10" y="20" width="30" height="40"/>"#)).unwrap();
    let bounds = rectangle.polygon.bounds();
    assert_eq!((bounds.min(), bounds.max()), (DVec2::new(10.0, -60.0), DVec2::new(40.0, -20.0)));
    assert_eq!(rectangle.polygon.vertices().len(), 4);
    let circle = read("c.svg", &svg(r#"<circle cx="50" cy="50" r="40"/>"#)).unwrap().polygon;
    let radii = circle.vertices().iter().map(|p| p.distance(DVec2::new(50.0, -50.0)));
    let error = radii.map(|r| (r / 40.0 - 1.0).abs()).fold(0.0, f64::max);
    // The cubic arcs of a circle are off by 2.7e-4, single precision by 1e-7.
    assert!(error < 3e-4, "{error}");
    assert!(circle.vertices().len() > 100);
}

#[test]
fn every_path_command_ends_where_it_should() {
    let text = "M10 10 l10 0 L30 20 h10 H50 v10 V40 c0 5 5 10 10 10 C70 50 70 60 70 60 s5 5 5 10 S60 80 60 80 \
                q-10 5 -10 0 Q40 90 30 80 t-10 -5 T10 60 a5 5 0 0 1 0 -10 A5 5 0 0 0 10 40 z";
    let outline = read("p.svg", &svg(&format!(r#"<path d="{text}"/>"#))).unwrap();
    for corner in
        [(10.0, -10.0), (50.0, -40.0), (60.0, -50.0), (70.0, -60.0), (60.0, -80.0), (20.0, -75.0), (10.0, -40.0)]
    {
        let nearest = outline.polygon.vertices().iter().map(|p| p.distance(corner.into())).fold(f64::MAX, f64::min);
        assert!(nearest < 1e-4, "{corner:?} is {nearest} away");
    }
}

#[test]
fn svg_transforms_styles_and_uses_are_resolved() {
    let text = svg(r##"<style>.a { fill: url(#g) }</style>
        <defs><linearGradient id="g"><stop offset="0"/></linearGradient>
        <path id="t" d="M0 0 L4 0 L0 -3 Z"/></defs>
        <g transform="translate(10 5) scale(2)"><use class="a" href="#t" x="1"/></g>"##);
    assert_eq!(vertices(&read("t.svg", &text).unwrap()), [(12.0, -5.0), (20.0, -5.0), (12.0, 1.0)]);
    let mirrored = svg(r#"<path transform="scale(-1 1)" fill="none" stroke="red" d="M0 0 L4 0 L0 -3 Z"/>"#);
    let mirrored = read("t.svg", &mirrored).unwrap();
    assert_eq!(vertices(&mirrored), [(0.0, 0.0), (0.0, 3.0), (-4.0, 0.0)]);
    assert_eq!(mirrored.notes, [OutlineNote::Upwards, OutlineNote::Reversed]);
}

#[test]
fn a_closing_point_may_differ_by_rounding_and_repeated_points_are_dropped() {
    let circle: String = (0..=100)
        .map(|k| std::f64::consts::TAU * f64::from(k) / 100.0)
        .map(|t| format!("{:?},{:?}\n", 3.0 + t.cos(), 3.0 + t.sin()))
        .collect();
    let outline = read("circle.csv", &circle).unwrap();
    assert_eq!((outline.polygon.vertices().len(), &outline.notes[..]), (100, &[OutlineNote::ClosingPointDropped][..]));
    let doubled = read("l.csv", "0,0\n4,0\n4,0\n4,0\n0,3\n").unwrap();
    assert_eq!(vertices(&doubled), TRIANGLE);
    assert_eq!(doubled.notes, [OutlineNote::RepeatedPointsDropped { count: 2 }]);
    let third = read("l.csv", "x,y,z\n0,0,1\n4,0,2\n0,3,5\n").unwrap();
    assert_eq!(
        (vertices(&third), &third.notes[..]),
        (TRIANGLE.to_vec(), &[OutlineNote::ColumnsDropped { columns: 1 }][..])
    );
}

#[test]
fn airfoils_run_from_the_trailing_edge_over_the_top_in_both_orders() {
    let selig = "Test section 9% thick\n1.0 0.0\n0.5 0.06\n0.0 0.0\n0.5 -0.03\n";
    let lednicer = "Test section\n 3. 3.\n\n0.0 0.0\n0.5 0.06\n1.0 0.0\n\n0.0 0.0\n0.5 -0.03\n1.0 0.0\n";
    let outline = read("a.dat", selig).unwrap();
    assert_eq!(outline.polygon.vertices().len(), 4);
    assert_eq!(vertices(&read("a.dat", lednicer).unwrap()), vertices(&outline));
    // a pentagon whose first point could be two counts
    assert_eq!(read("a.dat", "2,2\n0,2\n0,0\n1,-1\n2,0\n").unwrap().polygon.vertices().len(), 5);
}

#[test]
fn the_shape_of_the_largest_painted_area_is_taken_and_another_on_request() {
    let text = svg(r#"<rect width="100" height="100" fill="white"/><path d="M0 0 L50 50"/>
        <path fill="none" d="M0 0h100v100h-100z"/><g opacity="0"><path d="M0 0h80v80h-80z"/></g>
        <path id="frame" fill-rule="evenodd" d="M1 1h98v98h-98z M3 3h94v94h-94z"/>
        <path id="open" d="M20 20h40v30h-40"/>
        <path d="M0 0 h1 v1 z M70 70 h20 v-9 h-20 z M12 12h.01v0z"/>"#);
    let outline = read("x.svg", &text).unwrap();
    assert_eq!((outline.polygon.area(), outline.name()), (1200.0, "open"));
    let taken = OutlineNote::ShapeTaken { number: 2, count: 4, name: Some("open".into()) };
    assert_eq!(outline.notes, [taken, OutlineNote::Upwards, OutlineNote::Reversed]);
    let part =
        |part| parse_as("x.svg", text.as_bytes(), &Reading { repair: false, part: Some(PartChoice::Called(part)) });
    assert_eq!(part("4").unwrap().polygon.area(), 180.0);
    let frame = part("frame").unwrap();
    assert_eq!(frame.polygon.area(), 98.0 * 98.0);
    assert!(frame.notes.contains(&OutlineNote::HolesIgnored { holes: 1 }), "{:?}", frame.notes);
    let missing = part("7").unwrap_err().to_string();
    assert_eq!(missing, "there is no part \"7\": they are numbered from 1 to 4 and named frame, open");
    let crossing = svg(r#"<path d="M2 5h2v2h-2z M3 6h20v20h-20z"/>"#);
    assert_eq!(read("x.svg", &crossing).unwrap().polygon.area(), 400.0);
    let twice = svg(r#"<path d="M0 5L5 0L10 5L5 10z M0 5L5 0L10 5L5 10z"/>"#);
    assert_eq!(read("x.svg", &twice).unwrap().polygon.area(), 50.0);
    let body = svg(r#"<path id="body" d="M0 0h1v1h-1z M10 10h50v50h-50z"/><path d="M0 0h60v60h-60z"/>"#);
    let body =
        parse_as("x.svg", body.as_bytes(), &Reading { repair: false, part: Some(PartChoice::Called("body")) }).unwrap();
    assert_eq!(body.polygon.area(), 2500.0);
    let parts = parse_contents("x.svg", text.as_bytes(), &Reading::default()).unwrap().parts.unwrap();
    let named: Vec<_> = parts.all.iter().map(|part| (part.number, part.name.as_deref())).collect();
    assert_eq!(named, [(1, Some("frame")), (2, Some("open")), (3, None), (4, None)]);
    assert_eq!((parts.taken, parts.count), (2, 4));
    // a triangle in the square from −1 to 1, y upwards: its right angle was below
    assert_eq!(parts.all[2].picture, [[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]]);
    let single = parse_contents("x.svg", svg(r#"<path d="M0 0h1v1z"/>"#).as_bytes(), &Reading::default());
    assert_eq!(single.unwrap().parts, None);
    let back_at_start = read("x.svg", &svg(r#"<path d="M0 0 L4 0 L0 -3 L0 0"/>"#)).unwrap();
    assert_eq!(vertices(&back_at_start), TRIANGLE);
}

#[test]
fn a_background_alone_is_a_shape_and_clips_are_none() {
    let square = r#"<rect width="100" height="100" fill="white"/>"#;
    let clip = r#"<defs><clipPath id="c"><rect width="99" height="99"/></clipPath></defs>"#;
    assert_eq!(read("x.svg", &svg(square)).unwrap().polygon.area(), 10_000.0);
    let clipped = svg(&format!(r#"{clip}<g clip-path="url(#c)">{square}<path d="M4 4h14v6h-8v10H4z"/></g>"#));
    assert_eq!(read("x.svg", &clipped).unwrap().polygon.area(), 14.0 * 6.0 + 6.0 * 10.0);
    // lines that are only stroked bound a shape where they are closed
    let lines = svg(r#"<g fill="none" stroke="black"><path d="M0 0L99 99"/><path d="M9 9h9v9z"/></g>"#);
    assert_eq!(read("x.svg", &lines).unwrap().polygon.area(), 40.5);
}

#[test]
fn coordinates_are_those_of_user_space() {
    let drawing = |attributes: &str| {
        let path = r#"<g transform="translate(-0.1 0)"><path d="M0.1 0 L4.1 0 L0.1 -3 Z"/></g>"#;
        read("x.svg", &format!(r#"<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{path}</svg>"#)).unwrap()
    };
    for attributes in ["", "width='210mm' height='297mm' viewBox='0 0 210 297'", "viewBox='-12 -7.3 24 24' width='8'"] {
        let found = vertices(&drawing(attributes));
        let off = found.iter().zip(TRIANGLE).map(|(p, q)| (p.0 - q.0).abs().max((p.1 - q.1).abs())).fold(0.0, f64::max);
        assert!(off < 1e-15, "{attributes}: {found:?}");
    }
}

#[test]
fn faults_of_svg_are_named() {
    assert_eq!(message("x.svg", &svg("")), "this SVG has no path: convert texts to paths");
    let line = svg(r#"<path fill="none" stroke="red" d="M0 0 L4 0 L0 3"/>"#);
    assert_eq!(message("x.svg", &line), "no path of this SVG is closed (1 open)");
    let broken = message("x.svg", "<svg xmlns='http://www.w3.org/2000/svg'>\n<path</svg>");
    assert!(broken.starts_with("this SVG cannot be read") && broken.contains("2:"), "{broken}");
    assert!(message("x.svg", "<html/>").starts_with("this SVG cannot be read"));
    let deep = svg(&format!("{}{}", "<g>".repeat(50_000), "</g>".repeat(50_000)));
    assert!(message("x.svg", &deep).contains("nested too deeply"));
    let chain: String = (1..2000).map(|k| format!(r##"<g id="a{k}"><use href="#a{}"/></g>"##, k + 1)).collect();
    assert!(message("x.svg", &svg(&chain)).contains("nested too deeply"));
}

#[test]
fn nesting_within_the_limits_does_not_exhaust_a_small_stack() {
    let level = |k: usize, inner: &str| {
        format!(r#"<g id="a{k}">{}{inner}{}</g>"#, "<g opacity=\"0.5\">".repeat(60), "</g>".repeat(60))
    };
    let mut content = level(0, r#"<path d="M0 0 L4 0 L0 -3 Z"/>"#);
    for k in 1..4 {
        content += &level(k, &format!(r##"<use href="#a{}"/>"##, k - 1));
    }
    let text = svg(&format!("<defs>{content}</defs><use href=\"#a3\"/>"));
    let worker = std::thread::Builder::new().stack_size(1 << 20).spawn(move || read("x.svg", &text)).unwrap();
    assert_eq!(vertices(&worker.join().unwrap().unwrap()), TRIANGLE);
}

#[test]
fn tables_of_spreadsheets_and_old_programs_are_read() {
    for text in [
        ",0,1\n0,0,0\n1,9,0\n2,0,9\n", // pandas' names of columns beside its index
        "x;y\n0;0\n9;0\n0;9\n;\n;\n",  // empty rows
        "x,y\r0,0\r9,0\r0,9\r",        // lines as on old Macs
        "0,0\n,\n9,0\n0,9\n",
    ] {
        assert_eq!(parse("x.csv", text.as_bytes()).unwrap().polygon().area(), 40.5, "{text:?}");
    }
    let utf16: Vec<u8> = "0,0\n9,0\n0,9\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(parse("x.csv", &utf16).unwrap().polygon().area(), 40.5);
}

/// Decimal commas between commas, and thousands with points: what could be read otherwise is refused.
#[test]
fn numbers_that_may_be_others_are_refused() {
    for text in [
        "x,y\n0,50,0,50\n4,25,0,60\n4,75,3,50\n0,80,3,10\n",
        "0,50,0,50\n4,25,0,60\n4,75,3,50\n0,80,3,10\n",
        "x;y\n1.000,10;0,5\n4.000,20;0,6\n4.000,75;3000,5\n1.000,80;3000,1\n",
        "x;y\n1,0;0,5\n4,2;0,6\n1.004,75;3000,5\n1,8;3000,1\n",
    ] {
        let refused = parse("x.csv", text.as_bytes()).map(|outline| outline.polygon().vertices().to_vec());
        assert!(
            matches!(refused, Err(OutlineError::NumbersOnLine { .. } | OutlineError::NotANumber { .. })),
            "{refused:?}"
        );
    }
    // four columns with names are four columns, and so are those between other separators
    for text in ["0 10 0 50\n4 10 0 60\n4 75 3 50\n0 80 3 10\n", "0;10;0;50\n4;10;0;60\n4;75;3;50\n0;80;3;10\n"] {
        assert_eq!(parse("x.csv", text.as_bytes()).unwrap().polygon().vertices().len(), 4, "{text:?}");
    }
    let named = "x,y,a,b\n0,10,0,50\n4,10,0,60\n4,75,3,50\n0,80,3,10\n";
    assert_eq!(parse("x.csv", named.as_bytes()).unwrap().polygon().vertices().len(), 4);
}

#[test]
fn loops_spikes_and_knots_are_cut_off_when_asked() {
    let mended = |text: &str| parse_as("x.csv", text.as_bytes(), &Reading { repair: true, part: None });
    let repaired = |text: &str| mended(text).unwrap();
    // A small loop at (4, 0); a spike at (0, 3).
    let outline = repaired("0 0\n4 0\n5 0\n5 1\n4 0\n0 3\n0 9\n");
    assert_eq!(vertices(&outline), TRIANGLE);
    assert_eq!(outline.notes, [OutlineNote::Repaired { dropped: 4 }]);
    let first_is_in_the_small_loop = repaired("1 1\n0 0\n9 0\n0 9\n0 0\n0 1\n");
    assert_eq!(first_is_in_the_small_loop.polygon.area(), 40.5);
    let crossing = mended("0 0\n2 2\n2 0\n0 2");
    assert!(matches!(crossing, Err(OutlineError::Polygon(PolygonError::EdgesCross { .. }))));
    // a small knot in a long edge is not the shape
    let knot = repaired("0,0\n4,0\n4,3\n2.05,3\n1.95,3.2\n2.05,3.2\n1.95,3\n0,3\n");
    assert!((knot.polygon.area() - 12.0).abs() < 0.01 && matches!(knot.notes[..], [OutlineNote::Repaired { .. }]));
    // a vertex of one part lies on an edge of another
    let touching = repaired("0 0\n9 0\n9 9\n5 9\n4 0\n3 9\n0 9\n");
    assert_eq!(touching.polygon.area(), 40.5);
    assert_eq!(repaired("0 0\n4 0\n0 3").notes, []);
}

#[test]
fn rings_on_the_sphere_are_closed_up_to_a_turn_and_mended() {
    let cap = r#"{"type":"Polygon","coordinates":[[[-180,-60],[-60,-60],[60,-60],[180,-60]]]}"#;
    assert_eq!(parse_geo_rings(cap.as_bytes(), &Reading::default()).unwrap()[0].points.len(), 3);
    let knot = r#"{"type":"Polygon","coordinates":[[[170,40],[-170,40],[-170,44],[173,44],[174,45],[172,45],[173,44],[170,44],[170,40]]]}"#;
    let how = Reading { repair: true, part: None };
    let rings = parse_geo_rings(knot.as_bytes(), &how).unwrap();
    assert!(rings[0].cut.is_some() && rings[0].points.len() < 8, "{:?}", rings[0]);
    assert!(SimplePolygon::try_from(rings[0].points.clone()).is_ok());
    assert_eq!(parse_geo_rings(cap.as_bytes(), &how).unwrap()[0].cut, None);
}

#[test]
fn features_are_chosen_and_metres_are_no_degrees() {
    let feature = |name: &str, size: u32| {
        format!(
            r#"{{"type":"Feature","properties":{{"name":"{name}"}},"geometry":{{"type":"Polygon","coordinates":[[[0,0],[{size},0],[0,{size}],[0,0]]]}}}}"#
        )
    };
    let world = |crs: &str| {
        format!(r#"{{"type":"FeatureCollection"{crs},"features":[{},{}]}}"#, feature("a", 2), feature("b", 4))
    };
    let area = |part| {
        let outline = parse_as("x.json", world("").as_bytes(), &Reading { repair: false, part }).unwrap();
        (outline.polygon.area(), outline.name().to_owned())
    };
    assert_eq!(
        [area(None), area(Some(PartChoice::Called("a"))), area(Some(PartChoice::Number(2)))],
        [(8.0, "b".into()), (2.0, "a".into()), (8.0, "b".into())]
    );
    let parts = parse_contents("x.json", world("").as_bytes(), &Reading::default()).unwrap().parts.unwrap();
    let named: Vec<_> = parts.all.iter().map(|part| (part.number, part.name.as_deref())).collect();
    assert_eq!((parts.taken, named), (2, vec![(1, Some("a")), (2, Some("b"))]));
    let how = Reading { repair: false, part: Some(PartChoice::Called("b")) };
    assert_eq!(parse_geo_rings(world("").as_bytes(), &how).unwrap().len(), 1);
    let named = |name: &str| {
        let crs = format!(r#","crs":{{"type":"name","properties":{{"name":"{name}"}}}}"#);
        parse_geo_rings(world(&crs).as_bytes(), &Reading::default()).map(|rings| rings.len())
    };
    assert_eq!(named("urn:ogc:def:crs:OGC:1.3:CRS84"), Ok(2));
    for degrees in
        ["EPSG:4326", "http://www.opengis.net/def/crs/OGC/1.3/CRS84", "http://www.opengis.net/def/crs/EPSG/0/4326"]
    {
        assert_eq!(named(degrees), Ok(2), "{degrees}");
    }
    assert_eq!(named("urn:ogc:def:crs:EPSG::25832"), Err(OutlineError::ReferenceSystem { name: "EPSG:25832".into() }));
}

const EXTENSIONS: [&str; 5] = ["json", "svg", "csv", "geojson", ""];

/// A small valid file of each format, to be mutated.
fn valid_files() -> [String; 5] {
    [
        r#"{"name":"a","points":[[0,0],[4,0.5],[1e-3,3],[-1,1]]}"#.to_owned(),
        svg(
            r##"<g transform="rotate(30 1 2)"><path id="p" d="M1 2 C3 4 5 6 7 9 q1 1 2 -3 A 3 4 10 1 0 5 1 Z"/><use href="#p"/></g>"##,
        ),
        "x,y\n0,0\n4;0.5 # c\n1e-3\t3\n".to_owned(),
        r#"{"type":"MultiPolygon","coordinates":[[[[0,0],[4,0],[0,3],[0,0]]],[[[0,0],[1,0],[0,1],[0,0]]]]}"#.to_owned(),
        "M0 0 L4 0 0 -3 Z".to_owned(),
    ]
}

proptest! {
    #[test]
    fn no_bytes_make_a_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..300), kind in 0..5usize) {
        let _ = parse(&format!("x.{}", EXTENSIONS[kind]), &bytes);
    }

    #[test]
    fn no_text_makes_a_reader_panic(text in "[\\[\\]{}<>/=\"a-zM0-9eE+.,; \n#:-]{0,200}", kind in 0..5usize) {
        let _ = read(&format!("x.{}", EXTENSIONS[kind]), &text);
    }

    #[test]
    fn no_mutation_of_a_valid_file_makes_a_reader_panic(
        kind in 0..5usize,
        edits in prop::collection::vec((any::<prop::sample::Index>(), 0..4u8, any::<u8>()), 1..6),
    ) {
        let mut bytes = valid_files()[kind].clone().into_bytes();
        let file_name = format!("x.{}", EXTENSIONS[kind]);
        prop_assert!(parse(&file_name, &bytes).is_ok());
        for (at, edit, byte) in edits {
            let at = at.index(bytes.len());
            let digits = b"0123456789eE.-+[]{},\" #Mz";
            match edit {
                0 => bytes[at] = byte,
                1 => bytes[at] = digits[byte as usize % digits.len()],
                2 => bytes.insert(at, digits[byte as usize % digits.len()]),
                _ => drop(bytes.drain(at..(at + byte as usize % 8).min(bytes.len()))),
            }
            if bytes.is_empty() {
                break;
            }
        }
        let _ = parse_as(&file_name, &bytes, &Reading { repair: true, part: None });
        if let Ok(outline) = parse(&file_name, &bytes) {
            prop_assert!(outline.polygon.area() >= 0.0);
        }
    }

    #[test]
    fn points_written_are_points_read(radii in prop::collection::vec(0.1..1e6f64, 3..50)) {
        let n = radii.len() as f64;
        let points: Vec<DVec2> = radii.iter().enumerate()
            .map(|(k, r)| *r * DVec2::from_angle(std::f64::consts::TAU * k as f64 / n))
            .collect();
        prop_assume!(SimplePolygon::try_from(points.clone()).is_ok());
        let json: Vec<[f64; 2]> = points.iter().map(|p| [p.x, p.y]).collect();
        let csv: String = points.iter().map(|p| format!("{},{}\n", p.x, p.y)).collect();
        for outline in [read("x.json", &serde_json::to_string(&json).unwrap()), read("x.csv", &csv)] {
            let read_back = outline.unwrap();
            // serde_json's fast float reader may be off by one unit in the last place.
            let error = read_back.polygon.vertices().iter().zip(&points).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
            prop_assert!(error < 1e-9, "{error}");
        }
    }
}

#[test]
fn points_on_one_line_are_read_as_those_of_an_svg_polygon() {
    let expected = [(0.0, 0.0), (2.0, 0.0), (1.0, 3.5)].map(DVec2::from);
    for text in ["0,0 2,0 1,3.5", " 0 0 2 0 1 3.5\n", "0;0;2;0;1;3.5;0;0"] {
        assert_eq!(parse("pasted", text.as_bytes()).unwrap().polygon.vertices(), expected, "{text}");
    }
    let odd = parse("pasted", b"0,0 2,0 1").unwrap_err();
    assert_eq!(odd, OutlineError::OddNumbers { count: 5 });
    assert!(parse("pasted", b"0,0 2,0 1,x").is_err());
}

/// Icons and other outlines found in practice.
mod shared_data {
    use super::*;
    use crate::test_data::shared_outlines;

    #[test]
    #[ignore = "needs ../shared/data"]
    fn icons_and_coast_lines_are_read() {
        for path in shared_outlines() {
            let (name, bytes) = (path.to_string_lossy(), std::fs::read(&path).unwrap());
            // The hand has small loops, 2 % of its size, which meet themselves.
            let touches =
                matches!(parse(&name, &bytes), Err(OutlineError::Polygon(PolygonError::RepeatedPoint { .. })));
            assert_eq!(touches, name.ends_with("noto_hand-with-fingers-splayed.json"), "{name}");
            let outline = parse_as(&name, &bytes, &Reading { repair: true, part: None }).unwrap();
            let expected: &[OutlineNote] = if touches { &[OutlineNote::Repaired { dropped: 11 }] } else { &[] };
            assert!(outline.notes.starts_with(expected), "{name}: {:?}", outline.notes);
            println!("{}: {} points, notes {:?}", outline.name, outline.polygon.vertices().len(), outline.notes);
            let pole = outline.polygon.pole_of_inaccessibility(1e-3);
            assert!(outline.polygon.contains(pole));
        }
    }
}
