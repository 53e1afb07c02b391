//! Session files (`.riemap`): a zip with everything, or a session alone as JSON with the marker `"riemap"` and the
//! number of its format.
//!
//! A session alone is everything except images and the triangles of surfaces that come from files. Numbers and outlines
//! are read back bit for bit. A missing field gets its default, so that files older than a setting can be read;
//! unknown fields are skipped.
//!
//! | format | holds | module |
//! |---|---|---|
//! | 1 | at most a surface on the target's side | `version1` |
//! | 2 | a surface on either side, or on both; the curves of loaded outlines | `version2` |
//! | 3 | a zip: a session of format 1 or 2, undo steps, surfaces, the own picture | `archive` |
//!
//! The app saves format 3. As JSON the oldest format that holds the session is written, so that older programs and the
//! scripts of pages that embed the app can read as much as possible. All formats will always be readable.

mod archive;
mod version1;
mod version2;

pub use archive::{Archive, Attachment, FORMAT, MAX_ARCHIVE_BYTES, Part, Steps, is_zip, largest, read_archive};

use super::{OutOfRange, OutlineSpec, Session};
use crate::conformal::{PinError, Side};
use crate::geometry::{DVec2, PolygonError, SimplePolygon};
use crate::outline::{CurveForm, Preset};
use serde::{Deserialize, Serialize};
use version1::Version1;
use version2::Version2;

/// The extension of session files, without the dot.
pub const EXTENSION: &str = "riemap";

/// The newest format of a session alone that is written and read.
pub const NEWEST: u32 = 2;

/// The largest session alone that is read: two outlines with the maximal number of points take 40 MB.
pub const MAX_BYTES: usize = 64 << 20;

/// Why a session cannot be written or a file cannot be read.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// It has more bytes than the limit.
    #[error("the file is too large for a session: {} MiB are the most", limit >> 20)]
    TooLarge {
        /// The limit: [`MAX_BYTES`] or [`MAX_ARCHIVE_BYTES`].
        limit: usize,
    },
    /// It begins like a zip and is none.
    #[error("the file is damaged: it was cut off or changed on its way ({0})")]
    Damaged(String),
    /// A part that it lists is not in it.
    #[error("the part \"{0}\" is missing in the file")]
    MissingPart(String),
    /// A part cannot be unpacked.
    #[error("the part \"{part}\" of the file is damaged: {reason}")]
    BrokenPart {
        /// The path of the part.
        part: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A part is larger than the parts of its kind may be, or than all parts together.
    #[error("the part \"{part}\" of the file is too large: {} MiB are the most", limit >> 20)]
    PartTooLarge {
        /// The path of the part.
        part: String,
        /// The limit in bytes.
        limit: usize,
    },
    /// It has more parts than a session can use.
    #[error("the file has too many parts: {limit} are the most")]
    TooManyParts {
        /// The limit.
        limit: usize,
    },
    /// A part is unpacked and cannot be read.
    #[error("the part \"{part}\" of the file cannot be read: {error}")]
    InPart {
        /// The path of the part.
        part: String,
        /// The reason.
        error: Box<FileError>,
    },
    /// It is not JSON, or not the JSON of a session.
    #[error(
        "this is not a session of riemap, or the file is damaged. Open another file, or the session's link instead ({0})"
    )]
    Malformed(String),
    /// It is JSON without the marker.
    #[error("the file is no session of riemap: there is no \"riemap\": {NEWEST} in it")]
    NoSession,
    /// It is of a format that this program does not know.
    #[error("the file is of format {found}, made by a newer riemap; this one reads format {FORMAT}")]
    Version {
        /// The number of its format.
        found: u32,
    },
    /// A number is not finite or outside the range of its control.
    #[error("the session cannot be used: {0}")]
    OutOfRange(#[from] OutOfRange),
    /// The pins determine no map.
    #[error("the session's pins cannot be used: {0}")]
    Pins(PinError),
    /// An outline is not a simple polygon.
    #[error("the session's outline of the {side} cannot be used: {reason}")]
    Outline {
        /// The side with the outline.
        side: Side,
        /// What is wrong with the outline.
        reason: PolygonError,
    },
}

/// The field that marks a file and says its format; parsed first.
#[derive(Deserialize)]
struct Marker {
    riemap: Option<u32>,
}

/// The field that says the format of an object without a marker.
#[derive(Deserialize)]
struct Unmarked {
    version: u32,
}

/// A session in one of the formats. A number in `riemap` marks a file.
#[derive(Serialize)]
#[serde(untagged)]
enum Written<'a> {
    First(version1::Written<'a>),
    Second(version2::Written<'a>),
}

impl<'a> Written<'a> {
    fn new(session: &'a Session, is_file: bool) -> Result<Self, FileError> {
        session.check()?;
        Ok(if version1::holds(session) {
            Self::First(version1::Written::new(session, is_file))
        } else {
            Self::Second(version2::Written::new(session, is_file))
        })
    }
}

/// The file of a session. Errors: a number outside the range of its control.
pub fn write(session: &Session) -> Result<String, FileError> {
    let written = Written::new(session, true)?;
    serde_json::to_string_pretty(&written).map(|text| text + "\n").map_err(|error| malformed(&error))
}

/// As [`write()`], on one line: half the time and length if an outline has many points.
pub fn write_compact(session: &Session) -> Result<String, FileError> {
    serde_json::to_string(&Written::new(session, true)?).map_err(|error| malformed(&error))
}

/// A session as JSON for a page's script: a file without its marker.
pub fn write_object(session: &Session) -> Result<String, FileError> {
    serde_json::to_string(&Written::new(session, false)?).map_err(|error| malformed(&error))
}

/// Reads the session of a file. Its numbers are in their ranges and its outlines are simple polygons.
pub fn read(bytes: &[u8]) -> Result<Session, FileError> {
    if is_zip(bytes) {
        return read_archive(bytes).map(|archive| archive.session().clone());
    }
    if bytes.len() > MAX_BYTES {
        return Err(FileError::TooLarge { limit: MAX_BYTES });
    }
    // As text, since serde_json's reader for bytes would add as much code again to the program.
    let text = std::str::from_utf8(bytes).map_err(|error| FileError::Malformed(error.to_string()))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    match parsed::<Marker>(text)?.riemap {
        Some(format @ 1..=NEWEST) => read_format(format, text),
        Some(found) => Err(FileError::Version { found }),
        None => Err(FileError::NoSession),
    }
}

/// Reads an object written by [`write_object`], with the guarantees of [`read`].
pub fn read_object(text: &str) -> Result<Session, FileError> {
    match parsed::<Unmarked>(text)?.version {
        2 => read_format(2, text),
        _ => read_format(1, text), // rejects all other versions
    }
}

fn read_format(format: u32, text: &str) -> Result<Session, FileError> {
    let session = if format == 1 {
        Session::try_from(parsed::<Version1>(text)?)?
    } else {
        Session::try_from(parsed::<Version2>(text)?)?
    };
    session.check()?;
    Ok(session)
}

fn parsed<'a, T: Deserialize<'a>>(text: &'a str) -> Result<T, FileError> {
    serde_json::from_str(text).map_err(|error| malformed(&error))
}

fn malformed(error: &serde_json::Error) -> FileError {
    FileError::Malformed(error.to_string())
}

/// An outline whose polygon is not checked yet.
#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum OutlineForm {
    Preset(Preset),
    Points {
        name: String,
        points: Vec<DVec2>,
        #[serde(default)]
        curve: Option<CurveForm>,
    },
}

impl OutlineForm {
    fn checked(self, side: Side) -> Result<OutlineSpec, FileError> {
        Ok(match self {
            Self::Preset(preset) => OutlineSpec::Preset(preset),
            Self::Points { name, points, curve } => {
                let polygon = SimplePolygon::try_from(points).map_err(|reason| FileError::Outline { side, reason })?;
                let form = curve.unwrap_or_else(|| CurveForm::of_polygon(&polygon));
                if !form.fits(&polygon) {
                    let reason = format!("the curve of the {side}'s outline does not pass through its points");
                    return Err(FileError::Malformed(reason));
                }
                OutlineSpec::Points { name, polygon, form }
            }
        })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
