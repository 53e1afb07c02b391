//! Round trips of archives, and what is refused.

use super::container::{pack, unpack};
use super::*;
use crate::geometry::DVec2;
use crate::session::{Command, SurfaceShape, SurfaceSpec, scaled};

fn triangle(height: f64) -> OutlineSpec {
    let points = [(0.0, 0.0), (3.0, 0.0), (1.0 / 3.0, height)].map(DVec2::from).to_vec();
    OutlineSpec::points(format!("triangle {height}"), points.try_into().unwrap())
}

fn with_triangle(scale: f64, height: f64) -> Session {
    scaled(scale).and([Command::SetOutline { side: Side::Target, outline: triangle(height) }])
}

fn whole() -> Archive {
    let shape = SurfaceShape::File { name: "cow/1.obj".into() };
    let cow = Command::SetSurface { side: Side::Target, surface: SurfaceSpec { shape, ..SurfaceSpec::default() } };
    let past = vec![scaled(2.0), with_triangle(2.0, 1.0), with_triangle(3.0, 1.0)];
    let history = History::from_steps(past, with_triangle(3.0, 2.0).and([cow]), vec![with_triangle(4.0, 2.0)]);
    let file = |name: &str, bytes: &[u8]| Attachment { name: name.into(), bytes: Arc::new(bytes.to_vec()) };
    Archive { history, surfaces: vec![file("cow/1.obj", b"v 0 0 0")], picture: Some(file("a.png", &[1, 2, 3])) }
}

fn sessions(history: &History) -> Vec<Session> {
    history.past().iter().chain([history.now()]).chain(history.future()).cloned().collect()
}

fn parts_of(archive: &Archive) -> Vec<Part> {
    unpack(&archive.write().unwrap(), limit_of).unwrap()
}

#[test]
fn everything_is_read_back_bit_for_bit() {
    let archive = whole();
    let found = read_archive(&archive.write().unwrap()).unwrap();
    assert_eq!(sessions(&found.history), sessions(&archive.history));
    assert_eq!((&found.surfaces, &found.picture), (&archive.surfaces, &archive.picture));
    let outlines = parts_of(&archive).iter().filter(|part| part.path.starts_with(OUTLINES)).count();
    assert_eq!(outlines, 2, "each outline of the steps once");
    assert_eq!(super::super::read(&archive.write().unwrap()).as_ref(), Ok(archive.session()));
}

#[test]
fn files_of_the_old_formats_are_sessions_alone() {
    let session = with_triangle(3.0, 1.0);
    let found = read_archive(write(&session).unwrap().as_bytes()).unwrap();
    assert_eq!(found.session(), &session);
    assert!(!found.history.can_undo() && found.surfaces.is_empty() && found.picture.is_none());
}

#[test]
fn every_part_that_is_missing_is_named() {
    let parts = parts_of(&whole());
    for missing in &parts {
        let rest: Vec<Part> = parts.iter().filter(|part| *part != missing).cloned().collect();
        let error = read_archive(&pack(&rest).unwrap()).unwrap_err();
        assert_eq!(error, FileError::MissingPart(missing.path.clone()));
    }
}

#[test]
fn a_broken_part_is_named_with_the_reason() {
    let parts = parts_of(&whole());
    for path in [CONTENTS, SESSION, HISTORY, "outlines/1.json"] {
        let mut broken = parts.clone();
        broken.iter_mut().find(|part| part.path == path).unwrap().bytes = Arc::new(b"{\"riemap\": ".to_vec());
        let text = read_archive(&pack(&broken).unwrap()).unwrap_err().to_string();
        assert!(text.contains(path), "{text}");
    }
    let mut newer = parts;
    newer[0].bytes = Arc::new(br#"{"riemap": 4, "parts": []}"#.to_vec());
    assert_eq!(read_archive(&pack(&newer).unwrap()).unwrap_err(), FileError::Version { found: 4 });
}

#[test]
fn a_cut_or_changed_file_is_refused_or_unchanged() {
    let bytes = whole().write().unwrap();
    for end in (0..bytes.len()).step_by(7) {
        assert!(read_archive(&bytes[..end]).is_err(), "cut at {end}");
    }
    let expected = sessions(&whole().history);
    for at in (0..bytes.len()).step_by(5) {
        let mut changed = bytes.clone();
        changed[at] ^= 0x24;
        if let Ok(found) = read_archive(&changed) {
            assert_eq!(sessions(&found.history), expected, "changed at {at}");
        }
    }
}

#[test]
fn parts_of_later_versions_are_skipped() {
    let mut parts = parts_of(&whole());
    parts.push(Part { path: "notes/later.txt".into(), bytes: Arc::new(vec![b'x'; 100]) });
    assert!(read_archive(&pack(&parts).unwrap()).is_ok());
}
