//! Session files with everything (`.riemap`, format 3): a zip whose parts are
//!
//! | part | content |
//! |---|---|
//! | `contents.json` | the format's number and the paths of all other parts |
//! | `session.json` | the session as a document of format 1 or 2 |
//! | `history.json` | the undo steps, as small sessions |
//! | `outlines/K.json` | the loaded outlines of the undo steps, each once, counted from 0 |
//! | `surfaces/NAME` | the files of surfaces, as they were opened |
//! | `picture/NAME` | the file of the own picture |
//!
//! A part that `contents.json` lists must be there; a surface that is not listed is asked for, as with a link. Parts of
//! other paths are skipped. The same parts, unpacked, are kept from one run to the next.

mod container;
mod steps;

pub use container::{MAX_BYTES as MAX_ARCHIVE_BYTES, is_zip};
pub use steps::Steps;

use super::{FileError, MAX_BYTES, OutlineForm, malformed, parsed, write};
use crate::conformal::Side;
use crate::session::{History, OutlineSpec, Session};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The number of this format.
pub const FORMAT: u32 = 3;

const CONTENTS: &str = "contents.json";
const SESSION: &str = "session.json";
const HISTORY: &str = "history.json";
const OUTLINES: &str = "outlines/";
const SURFACES: &str = "surfaces/";
const PICTURE: &str = "picture/";

/// The most bytes of the file of a surface.
const MAX_SURFACE_BYTES: usize = 384 << 20;
/// The most bytes of the file of a picture: uncompressed, 16 million pixels.
const MAX_PICTURE_BYTES: usize = 64 << 20;

/// A part of an archive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// Its path in the archive.
    pub path: String,
    /// Its content.
    pub bytes: Arc<Vec<u8>>,
}

impl Part {
    /// Whether it is the file of a surface or a picture.
    pub fn is_file(&self) -> bool {
        self.path.starts_with(SURFACES) || self.path.starts_with(PICTURE)
    }

    /// The documents among parts, with a table of contents of their own.
    pub fn without_files(parts: Vec<Self>) -> Vec<Self> {
        let documents: Vec<Self> = parts.into_iter().filter(|part| !part.is_file() && part.path != CONTENTS).collect();
        [contents(&documents)].into_iter().chain(documents).collect()
    }
}

/// The table of contents of these parts.
fn contents(parts: &[Part]) -> Part {
    let contents = Contents { riemap: FORMAT, parts: parts.iter().map(|part| part.path.clone()).collect() };
    // a number and strings, which always serialize
    let text = serde_json::to_string(&contents).unwrap_or_default();
    Part { path: CONTENTS.to_owned(), bytes: Arc::new(text.into_bytes()) }
}

/// A file of a surface or a picture, under the name with which it was opened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Attachment {
    /// The name of the file.
    pub name: String,
    /// Its content.
    pub bytes: Arc<Vec<u8>>,
}

/// A session with its undo history and the files that it uses.
#[derive(Debug, Clone)]
pub struct Archive {
    /// The session, which is the present one, and its undo steps.
    pub history: History,
    /// The files of its surfaces.
    pub surfaces: Vec<Attachment>,
    /// The file of the own picture.
    pub picture: Option<Attachment>,
}

#[derive(Serialize, Deserialize)]
struct Contents {
    riemap: u32,
    parts: Vec<String>,
}

/// The path of the outline of this number.
fn outline_path(number: usize) -> String {
    format!("{OUTLINES}{number}.json")
}

impl From<Session> for Archive {
    /// The session alone.
    fn from(session: Session) -> Self {
        Self { history: History::new(session), surfaces: Vec::new(), picture: None }
    }
}

impl Archive {
    /// The present session.
    pub fn session(&self) -> &Session {
        self.history.now()
    }

    /// All parts, `contents.json` first. Errors: a number outside the range of its control.
    pub fn parts(&self) -> Result<Vec<Part>, FileError> {
        let text = |path: &str, text: String| Part { path: path.to_owned(), bytes: Arc::new(text.into_bytes()) };
        let mut parts = vec![text(SESSION, write(self.session())?)];
        if self.history.can_undo() || self.history.can_redo() {
            let steps = Steps::of(&self.history, false)?;
            for (number, outline) in steps.outlines.iter().enumerate() {
                let json = serde_json::to_string(outline).map_err(|error| malformed(&error))?;
                parts.push(text(&outline_path(number), json));
            }
            parts.push(text(HISTORY, steps.text));
        }
        let file = |folder: &str, file: &Attachment| Part {
            path: format!("{folder}{}", file.name),
            bytes: Arc::clone(&file.bytes),
        };
        parts.extend(self.surfaces.iter().map(|surface| file(SURFACES, surface)));
        parts.extend(self.picture.iter().map(|picture| file(PICTURE, picture)));
        parts.insert(0, contents(&parts));
        Ok(parts)
    }

    /// The archive with these parts. Errors name the part that is missing or cannot be read.
    pub fn from_parts(parts: &[Part]) -> Result<Self, FileError> {
        let part = |path: &str| parts.iter().find(|part| part.path == path);
        let needed = |path: &str| part(path).ok_or_else(|| FileError::MissingPart(path.to_owned()));
        let contents: Contents = in_part(needed(CONTENTS)?, |text| parsed(text))?;
        if contents.riemap != FORMAT {
            return Err(FileError::Version { found: contents.riemap });
        }
        for path in contents.parts.iter().filter(|path| limit_of(path) > 0) {
            needed(path)?;
        }
        let session = in_part(needed(SESSION)?, |text| super::read(text.as_bytes()))?;
        let history = match part(HISTORY) {
            Some(history) => in_part(history, |text| steps(parts, text)?.history(Some(session)))?,
            None => History::new(session),
        };
        let files = |folder: &'static str| {
            parts.iter().filter_map(move |part| {
                let name = part.path.strip_prefix(folder)?.to_owned();
                Some(Attachment { name, bytes: Arc::clone(&part.bytes) })
            })
        };
        Ok(Self { history, surfaces: files(SURFACES).collect(), picture: files(PICTURE).next() })
    }

    /// The bytes of a session file. Errors: as [`Self::parts`].
    pub fn write(&self) -> Result<Vec<u8>, FileError> {
        container::pack(&self.parts()?)
    }
}

/// Reads a session file of any format; those of format 1 and 2 hold a session alone.
pub fn read_archive(bytes: &[u8]) -> Result<Archive, FileError> {
    if !is_zip(bytes) {
        return super::read(bytes).map(Archive::from);
    }
    if bytes.len() > MAX_ARCHIVE_BYTES {
        return Err(FileError::TooLarge { limit: MAX_ARCHIVE_BYTES });
    }
    Archive::from_parts(&container::unpack(bytes, limit_of)?)
}

/// The size above which a file is refused without reading it: archives may be larger than documents.
pub fn largest(bytes: &[u8]) -> usize {
    if is_zip(bytes) { MAX_ARCHIVE_BYTES } else { MAX_BYTES }
}

/// The most bytes of the part of a path; 0 if it is skipped.
fn limit_of(path: &str) -> usize {
    match path {
        CONTENTS => 1 << 20,
        SESSION | HISTORY => MAX_BYTES,
        _ if path.starts_with(OUTLINES) => MAX_BYTES,
        _ if path.starts_with(SURFACES) => MAX_SURFACE_BYTES,
        _ if path.starts_with(PICTURE) => MAX_PICTURE_BYTES,
        _ => 0,
    }
}

/// The steps with the outlines of the parts, as far as they are numbered without a gap.
fn steps(parts: &[Part], text: &str) -> Result<Steps, FileError> {
    let mut outlines = Vec::new();
    while let Some(part) = parts.iter().find(|part| part.path == outline_path(outlines.len())) {
        outlines.push(in_part(part, outline)?);
    }
    Ok(Steps { outlines, text: text.to_owned() })
}

fn outline(text: &str) -> Result<OutlineSpec, FileError> {
    // the side is in the message of an outline that is not simple; which step uses it is not known here
    parsed::<OutlineForm>(text)?.checked(Side::Source)
}

/// Reads the text of a part; an error names the part.
fn in_part<T>(part: &Part, read: impl FnOnce(&str) -> Result<T, FileError>) -> Result<T, FileError> {
    let of_part = |error: FileError| match error {
        FileError::MissingPart(_) | FileError::Version { .. } | FileError::BrokenPart { .. } => error,
        other => FileError::InPart { part: part.path.clone(), error: Box::new(other) },
    };
    let text = std::str::from_utf8(&part.bytes)
        .map_err(|error| FileError::BrokenPart { part: part.path.clone(), reason: error.to_string() })?;
    read(text).map_err(of_part)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
