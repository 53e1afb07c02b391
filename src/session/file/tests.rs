//! Both formats are read back as written; damaged files are refused.

use super::*;
use crate::conformal::PerSide;
use crate::geometry::PicturePlacement;
use crate::mesh::{BarycentricPoint, TriangleId};
use crate::session::{Command, SidePoints, SurfaceShape, SurfaceSpec, TextureKind};
use serde_json::{Value, json};

/// A session that format 1 holds.
fn drawn() -> Session {
    let points = [(0.1, 0.2), (1.0 / 3.0, 1e-12), (0.7, 0.9)].map(DVec2::from).to_vec();
    let polygon = SimplePolygon::try_from(points).unwrap();
    let outline = OutlineSpec::points("Drachen \"ü\"".into(), polygon);
    Session::with([
        Command::SetOutline { side: Side::Source, outline },
        // the golden text is older than upright beginnings
        Command::MoveAnchor { side: Side::Source, fraction: 0.0 },
        Command::MoveInterior { side: Side::Source, point: DVec2::new(0.4, 0.35).into() },
        Command::SetSurface { side: Side::Target, surface: SurfaceSpec::default() },
        Command::SetTextureScale(8.0), // the default when the format was made
    ])
}

/// A session that needs format 2: surfaces on both sides.
fn solid() -> Session {
    let shape = SurfaceShape::File { name: "cow.obj".into() };
    let point = BarycentricPoint::new(TriangleId::new(7), [0.25, 0.25, 0.5]);
    drawn().and([
        Command::SetSurface { side: Side::Source, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } },
        Command::PlacePoints {
            side: Side::Source,
            points: SidePoints::Surface { interior: Some(point), anchor: 0.625 },
        },
    ])
}

fn pinned() -> Session {
    let pins = crate::conformal::Pins::new([[0.1, 0.25], [1.0 / 3.0, 0.5], [0.8, 0.75]].map(PerSide::from)).unwrap();
    solid().and([Command::SetPins(Some(pins))])
}

fn with_symmetries() -> Session {
    Session::default().and([Command::SetSymmetries(true)])
}

fn with_marks() -> Session {
    Session::default().and([Command::SetMarks { side: Side::Target, marks: Some([0.1, 1.0 / 3.0, 0.7, 0.75]) }])
}

fn on_source_only() -> Session {
    solid().and([Command::CloseSurface(Side::Target)])
}

fn changed(session: &Session, change: impl FnOnce(&mut Value)) -> Result<Session, FileError> {
    let mut value: Value = serde_json::from_str(&write(session).unwrap()).unwrap();
    change(&mut value);
    read(value.to_string().as_bytes())
}

#[test]
fn what_is_written_is_read_bit_for_bit_in_the_oldest_format_that_holds_it() {
    for (session, format) in [
        (Session::default(), 1),
        (drawn(), 1),
        (solid(), 2),
        (on_source_only(), 2),
        (pinned(), 2),
        (with_symmetries(), 2),
        (with_marks(), 2),
    ] {
        let text = write(&session).unwrap();
        assert!(text.starts_with(&format!("{{\n  \"riemap\": {format},\n  \"version\": {format},\n")), "{text}");
        assert_eq!(read(text.as_bytes()), Ok(session.clone()));
        let compact = write_compact(&session).unwrap();
        assert!(compact.len() < text.len() && !compact.contains('\n'), "{compact}");
        assert_eq!(read(compact.as_bytes()), Ok(session.clone()));
        assert_eq!(read(format!("\u{feff}{text}").as_bytes()), Ok(session.clone()));
        let object = write_object(&session).unwrap();
        assert!(!object.contains("riemap"), "{object}");
        assert_eq!(read_object(&object), Ok(session));
    }
}

#[test]
fn the_placement_of_the_image_is_kept_and_files_without_it_have_the_whole_image() {
    let placed = PicturePlacement { middle: DVec2::new(0.1, 2.0), size: 0.5, turn: 1.0 };
    for session in [drawn(), solid()] {
        let text = write(&session).unwrap();
        assert!(!text.contains("picture") && read(text.as_bytes()).unwrap().picture().is_default());
        let session = session.and([Command::PlacePicture(placed)]);
        let text = write(&session).unwrap();
        assert!(text.contains("\"version\": 2") && text.contains("picture"), "{text}");
        assert_eq!(read(text.as_bytes()), Ok(session));
    }
}

/// A file of format 1 from before format 2 existed. It must never change.
const GOLDEN: &str = include_str!("golden_version1.riemap");

#[test]
fn a_file_of_format_1_opens_for_ever_and_is_written_as_before() {
    let before = crate::session::by_finite_elements(drawn());
    assert_eq!(read(GOLDEN.as_bytes()), Ok(before.clone()), "with finite elements, as it was");
    assert_eq!(write(&before).unwrap(), GOLDEN);
}

#[test]
fn older_files_have_defaults_and_newer_fields_are_skipped() {
    let older = changed(&drawn(), |value| {
        for field in ["colouring", "wireframe", "plots", "texture_side", "comparison", "surface"] {
            value.as_object_mut().unwrap().remove(field).unwrap();
        }
    });
    assert_eq!(older, Ok(drawn().and([Command::CloseSurface(Side::Target)])));
    for session in [drawn(), solid()] {
        assert_eq!(changed(&session, |value| value["tour"] = json!({ "step": 3 })), Ok(session.clone()));
        assert_eq!(changed(&session, |value| value["source"]["pins"] = json!([1, 2])), Ok(session.clone()));
    }
}

#[test]
fn other_versions_and_other_files_are_refused() {
    assert_eq!(changed(&drawn(), |value| value["riemap"] = 3.into()), Err(FileError::Version { found: 3 }));
    assert_eq!(changed(&drawn(), |value| value["riemap"] = 0.into()), Err(FileError::Version { found: 0 }));
    for session in [drawn(), solid()] {
        let other = changed(&session, |value| value["version"] = 3.into());
        assert!(matches!(other, Err(FileError::OutOfRange(_))), "{other:?}");
    }
    let bare = changed(&drawn(), |value| _ = value.as_object_mut().unwrap().remove("riemap"));
    assert_eq!(bare, Err(FileError::NoSession));
    assert_eq!(read(b"{}"), Err(FileError::NoSession));
    for text in [
        "",
        "[1, 2]",
        "null",
        "{\"riemap\": \"1\"}",
        "{\"riemap\": 1}",
        "{\"riemap\": 2}",
        "{\"riemap\": 1, \"source\": 3}",
    ] {
        assert!(matches!(read(text.as_bytes()), Err(FileError::Malformed(_))), "{text}");
    }
    for text in ["null", "{}", "{\"version\": 1}", "{\"version\": 2}"] {
        assert!(matches!(read_object(text), Err(FileError::Malformed(_))), "{text}");
    }
    assert!(matches!(read(b"{\"riemap\": 1, \"\xff\": 0}"), Err(FileError::Malformed(_))));
    assert!(matches!(read("[".repeat(100_000).as_bytes()), Err(FileError::Malformed(_))));
    assert_eq!(read(&vec![b' '; MAX_BYTES + 1]), Err(FileError::TooLarge { limit: MAX_BYTES }));
}

#[test]
fn numbers_and_outlines_are_checked() {
    let crossed = json!([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]);
    let bow_tie = json!({ "points": { "name": "bow tie", "points": crossed } });
    for session in [drawn(), solid()] {
        let found = changed(&session, |value| value["texture_scale"] = 1e6.into());
        assert!(matches!(found, Err(FileError::OutOfRange(_))), "{found:?}");
        for side in Side::BOTH {
            let found = changed(&session, |value| value[side.to_string()]["outline"] = bow_tie.clone());
            let Err(FileError::Outline { side: told, reason }) = found else { unreachable!("{found:?}") };
            assert_eq!(told, side);
            assert!(matches!(reason, PolygonError::EdgesCross { .. }), "{reason:?}");
        }
        let infinite = write(&session).unwrap().replace("0.35", "1e999");
        assert!(matches!(read(infinite.as_bytes()), Err(FileError::Malformed(_))), "{infinite}");
        let scaled = session.and([Command::SetTextureScale(f64::NAN)]);
        assert!(matches!(write(&scaled), Err(FileError::OutOfRange(_))));
    }
    let found = changed(&solid(), |value| value["source"]["surface"]["anchor"] = 2.0.into());
    assert!(matches!(found, Err(FileError::OutOfRange(_))), "{found:?}");
}

#[test]
fn points_that_run_clockwise_are_an_outline() {
    let clockwise = json!([[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]]);
    let found = changed(&drawn(), |value| value["source"]["outline"]["points"]["points"] = clockwise).unwrap();
    let expected = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(DVec2::from);
    assert_eq!(found.domain(Side::Source).outline.polygon().vertices(), expected);
}

#[test]
fn curves_of_outlines_are_kept_bit_for_bit() {
    let path = b"M 10.1 10 H 20.3 A 5 5 0 0 1 20.3 20 C 15 22 12 17 10.1 20 A 5 5 0 0 1 10.1 10 Z";
    let path: OutlineSpec = crate::outline::parse("stadium", path).unwrap().into();
    let points = OutlineSpec::points("heart".into(), Preset::Heart.outline().into_polygon());
    let form = CurveForm { switched: vec![7], ..CurveForm::default() };
    let session = Session::with([
        Command::SetOutline { side: Side::Source, outline: path },
        Command::SetOutline { side: Side::Target, outline: points.clone().with_form(form) },
    ]);
    let text = write(&session).unwrap();
    assert!(text.contains("\"version\": 2") && text.contains("\"curve\""), "{}", &text[..200]);
    assert_eq!(read(text.as_bytes()), Ok(session));
    // a file from before there were curves
    let old = Session::with([Command::SetOutline {
        side: Side::Target,
        outline: points.clone().with_form(CurveForm::polygon()),
    }]);
    let text = write(&old).unwrap();
    assert!(text.contains("\"version\": 1") && !text.contains("\"curve\""));
    let read_back = read(text.as_bytes()).unwrap();
    assert!(!read_back.domain(Side::Target).outline.curve().unwrap().is_smooth());
    assert_eq!(read_back, old);
}

#[test]
fn a_curve_beside_its_points_is_refused() {
    let path: OutlineSpec = crate::outline::parse("a", b"M 0 0 H 9 A 5 5 0 0 1 9 9 Z").unwrap().into();
    let session = Session::with([Command::SetOutline { side: Side::Source, outline: path }]);
    let text = write_compact(&session).unwrap();
    let moved = text
        .replace("\"line\":[[0.0,-0.0],[9.0,-0.0]]", "\"line\":[[0.0,1.0],[9.0,0.0]]")
        .replace("\"line\":[[9.0,-0.0],[0.0,-0.0]]", "\"line\":[[9.0,1.0],[0.0,0.0]]");
    assert_ne!(moved, text, "{text}");
    let error = read(moved.as_bytes()).unwrap_err();
    assert!(error.to_string().contains("does not pass through its points"), "{error}");
}

#[test]
fn marks_beyond_the_boundary_are_refused() {
    let outside = changed(&with_marks(), |value| value["target"]["marks"][2] = 1.5.into());
    assert!(matches!(outside, Err(FileError::OutOfRange(_))), "{outside:?}");
}

#[test]
fn pins_that_determine_no_map_are_refused() {
    let refused = |change: fn(&mut Value)| changed(&pinned(), change).unwrap_err().to_string();
    let same = refused(|value| value["pins"][1]["target"] = json!(0.25));
    assert!(same.contains("pins 1 and 2"), "{same}");
    let turned = refused(|value| value["pins"][1]["target"] = json!(0.9));
    assert!(turned.contains("order"), "{turned}");
    let few = refused(|value| value["pins"] = json!([]));
    assert!(few.contains("0 boundary pairs"), "{few}");
}

#[test]
fn a_tiling_is_kept_and_older_programs_read_the_conformal_grid() {
    use crate::tiling::{Tiling, TilingPattern, TilingStyle};
    let pattern = TilingPattern { tiling: Tiling::new(3, 7).unwrap(), style: TilingStyle::Edges };
    for session in [drawn(), solid()] {
        let session = session.and([Command::SetTexture(TextureKind::Tiling), Command::SetTiling(pattern)]);
        let text = write(&session).unwrap();
        assert_eq!(read(text.as_bytes()), Ok(session.clone()));
        let written: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(written["texture"], json!("conformal"), "older programs");
        assert_eq!(written["tiling"], json!({ "numbers": [3, 7], "style": "edges", "shown": true }));
        assert_eq!(read_object(&write_object(&session).unwrap()), Ok(session));
    }
    let session = solid().and([Command::SetTexture(TextureKind::Tiling), Command::SetTiling(pattern)]);
    let mut flat: Value = serde_json::from_str(&write(&session).unwrap()).unwrap();
    flat["tiling"]["numbers"] = json!([4, 4]);
    let refused = read(flat.to_string().as_bytes()).unwrap_err().to_string();
    assert!(refused.contains("lives in the plane"), "{refused}");
}
