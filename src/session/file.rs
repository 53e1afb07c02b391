//! Sessions as files: `.riemap`, the JSON of a [`Session`] with the marker `"riemap": 1`.
//!
//! Everything is in it but for images and the triangles of surfaces from files. Numbers and outlines
//! come back bit for bit. A file from before a setting was there reads with that setting's default;
//! fields that are not known are skipped.

use super::{OutOfRange, OutlineSpec, Session};
use crate::conformal::Side;
use crate::geometry::PolygonError;
use serde::{Deserialize, Serialize};

/// What the names of such files end with, after a dot.
pub const EXTENSION: &str = "riemap";

/// The format that is written and read.
const FORMAT: u32 = 1;

/// The largest file that is read: two outlines of the most points that one may have take 40 MB.
pub const MAX_BYTES: usize = 64 << 20;

/// Why a file is not written or read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FileError {
    /// More than [`MAX_BYTES`].
    #[error("the file is too large for a session: {} MiB are the most", MAX_BYTES >> 20)]
    TooLarge,
    /// It is no JSON, or not a session's.
    #[error("the file is no session of riemap: {0}")]
    Malformed(String),
    /// It is JSON without the marker.
    #[error("the file is no session of riemap: there is no \"riemap\": {FORMAT} in it")]
    NoSession,
    /// It is of another version.
    #[error("the file is of format {found}, made by a newer riemap; this one reads format {FORMAT}")]
    Version {
        /// Its version.
        found: u32,
    },
    /// A number is not finite, or beyond what its control allows.
    #[error("the session cannot be used: {0}")]
    OutOfRange(#[from] OutOfRange),
    /// An outline is not a simple polygon.
    #[error("the session's outline of the {side} cannot be used: {reason}")]
    Outline {
        /// Whose it is.
        side: Side,
        /// What is wrong with it.
        reason: PolygonError,
    },
}

#[derive(Serialize)]
struct Written<'a> {
    riemap: u32,
    #[serde(flatten)]
    session: &'a Session,
}

/// What is looked at first.
#[derive(Deserialize)]
struct Marker {
    riemap: Option<u32>,
}

/// The file of a session. Errors: numbers that the session's controls do not allow.
pub fn write(session: &Session) -> Result<String, FileError> {
    session.check()?;
    let written = Written { riemap: FORMAT, session };
    serde_json::to_string_pretty(&written).map(|text| text + "\n").map_err(|error| malformed(&error))
}

/// As [`write()`], on one line: half of the time and of the length where an outline has many points.
pub fn write_compact(session: &Session) -> Result<String, FileError> {
    session.check()?;
    serde_json::to_string(&Written { riemap: FORMAT, session }).map_err(|error| malformed(&error))
}

/// Whether the numbers of a session are in their ranges and its outlines simple polygons.
pub fn check(session: &Session) -> Result<(), FileError> {
    session.check()?;
    for side in Side::BOTH {
        if let outline @ OutlineSpec::Points { .. } = &session.domain(side).outline {
            outline.polygon().map_err(|reason| FileError::Outline { side, reason })?;
        }
    }
    Ok(())
}

/// The session of a file. Its numbers are in their ranges, its outlines simple polygons.
pub fn read(bytes: &[u8]) -> Result<Session, FileError> {
    if bytes.len() > MAX_BYTES {
        return Err(FileError::TooLarge);
    }
    // Read as text, like everything else: the readers for bytes would be as large once more.
    let text = std::str::from_utf8(bytes).map_err(|error| FileError::Malformed(error.to_string()))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let marker: Marker = serde_json::from_str(text).map_err(|error| malformed(&error))?;
    match marker.riemap {
        Some(FORMAT) => {}
        Some(found) => return Err(FileError::Version { found }),
        None => return Err(FileError::NoSession),
    }
    let session: Session = serde_json::from_str(text).map_err(|error| malformed(&error))?;
    check(&session)?;
    Ok(session)
}

fn malformed(error: &serde_json::Error) -> FileError {
    FileError::Malformed(error.to_string())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::DVec2;
    use crate::session::{Command, SurfaceSpec};
    use serde_json::{Value, json};

    fn drawn() -> Session {
        let mut session = Session::default();
        let points = [(0.1, 0.2), (1.0 / 3.0, 1e-12), (0.7, 0.9)].map(DVec2::from).to_vec();
        let outline = OutlineSpec::Points { name: "Drachen \"ü\"".into(), points };
        session.apply(Command::SetOutline { side: Side::Source, outline });
        session.apply(Command::MoveInterior { side: Side::Source, point: DVec2::new(0.4, 0.35) });
        session.apply(Command::SetSurface(SurfaceSpec::default()));
        session
    }

    fn changed(change: impl FnOnce(&mut Value)) -> Result<Session, FileError> {
        let mut value: Value = serde_json::from_str(&write(&drawn()).unwrap()).unwrap();
        change(&mut value);
        read(value.to_string().as_bytes())
    }

    #[test]
    fn what_is_written_is_read_bit_for_bit() {
        for session in [Session::default(), drawn()] {
            let text = write(&session).unwrap();
            assert!(text.starts_with("{\n  \"riemap\": 1,\n"), "{text}");
            assert_eq!(read(text.as_bytes()), Ok(session.clone()));
            let compact = write_compact(&session).unwrap();
            assert!(compact.len() < text.len() && !compact.contains('\n'), "{compact}");
            assert_eq!(read(compact.as_bytes()), Ok(session.clone()));
            assert_eq!(read(format!("\u{feff}{text}").as_bytes()), Ok(session));
        }
    }

    #[test]
    fn older_files_have_defaults_and_newer_fields_are_skipped() {
        let older = changed(|value| {
            for field in ["colouring", "wireframe", "plots", "texture_side", "comparison", "surface"] {
                value.as_object_mut().unwrap().remove(field).unwrap();
            }
        });
        assert_eq!(older, Ok(Session { surface: None, ..drawn() }));
        assert_eq!(changed(|value| value["tour"] = json!({ "step": 3 })), Ok(drawn()));
    }

    #[test]
    fn other_versions_and_other_files_are_refused() {
        assert_eq!(changed(|value| value["riemap"] = 2.into()), Err(FileError::Version { found: 2 }));
        let bare = changed(|value| _ = value.as_object_mut().unwrap().remove("riemap"));
        assert_eq!(bare, Err(FileError::NoSession));
        assert_eq!(read(b"{}"), Err(FileError::NoSession));
        for text in ["", "[1, 2]", "null", "{\"riemap\": \"1\"}", "{\"riemap\": 1}", "{\"riemap\": 1, \"source\": 3}"] {
            assert!(matches!(read(text.as_bytes()), Err(FileError::Malformed(_))), "{text}");
        }
        assert!(matches!(read(b"{\"riemap\": 1, \"\xff\": 0}"), Err(FileError::Malformed(_))));
        assert!(matches!(read("[".repeat(100_000).as_bytes()), Err(FileError::Malformed(_))));
        assert_eq!(read(&vec![b' '; MAX_BYTES + 1]), Err(FileError::TooLarge));
    }

    #[test]
    fn numbers_and_outlines_are_checked() {
        assert!(matches!(changed(|value| value["texture_scale"] = 1e6.into()), Err(FileError::OutOfRange(_))));
        let crossed = json!([[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]);
        let found = changed(|value| value["source"]["outline"]["points"]["points"] = crossed);
        assert!(matches!(found, Err(FileError::Outline { side: Side::Source, .. })), "{found:?}");
        let crossed = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)].map(DVec2::from).to_vec();
        let mut bow_tie = drawn();
        bow_tie.target.outline = OutlineSpec::Points { name: "bow tie".into(), points: crossed };
        assert_eq!((check(&drawn()), bow_tie.check()), (Ok(()), Ok(())));
        assert!(matches!(check(&bow_tie), Err(FileError::Outline { side: Side::Target, .. })));
        let infinite = write(&drawn()).unwrap().replace("0.35", "1e999");
        assert!(matches!(read(infinite.as_bytes()), Err(FileError::Malformed(_))), "{infinite}");
        let mut session = drawn();
        session.texture_scale = f64::NAN;
        assert!(matches!(write(&session), Err(FileError::OutOfRange(_))));
    }
}
