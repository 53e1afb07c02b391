//! The surface files that were opened for either side, kept so that undo can return to them.

use crate::language::{Message, key};
use crate::session::SurfaceShape;
use crate::worker::{NamedFile, SurfaceSource};
use std::sync::Arc;

/// The most bytes of opened files that are kept.
const MOST_KEPT_BYTES: usize = 256 << 20;

/// The most bytes of a file that is opened in the app: what can be kept of opened files, so that undo can return to any
/// one of them. Binary STL, 50 bytes a triangle, reaches it with 5.4 million triangles, more than can be read; a
/// browser holds the file twice, in the page and in the worker, within the 4 GiB of 32-bit addresses.
pub const MAX_BYTES: usize = MOST_KEPT_BYTES;

/// A surface file is larger than [`MAX_BYTES`].
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{name}: the file has {bytes} bytes; surfaces up to {} MiB can be read", MAX_BYTES >> 20)]
pub struct SurfaceFileTooLarge {
    /// The file's name.
    pub name: String,
    /// Its size.
    pub bytes: usize,
}

impl From<&SurfaceFileTooLarge> for Message {
    fn from(SurfaceFileTooLarge { name, bytes }: &SurfaceFileTooLarge) -> Self {
        key::about(name, key::surface_file_too_large(*bytes, MAX_BYTES >> 20))
    }
}

/// Checks the size of a file before it is kept and copied to a worker.
pub fn check_size(name: &str, bytes: usize) -> Result<(), SurfaceFileTooLarge> {
    if bytes > MAX_BYTES { Err(SurfaceFileTooLarge { name: name.to_owned(), bytes }) } else { Ok(()) }
}

/// Opened files, the last one at the end. Invariants: no two have one name; all but the last have
/// `MOST_KEPT_BYTES` together at most.
#[derive(Debug, Default)]
pub struct SurfaceFiles {
    files: Vec<NamedFile>,
}

impl SurfaceFiles {
    /// Keeps a file. A different file of the same name is renamed: "head (2).obj".
    pub fn keep(&mut self, name: &str, bytes: Vec<u8>) -> NamedFile {
        let numbered = |number: usize| match (number, name.rsplit_once('.')) {
            (1, _) => name.to_owned(),
            (_, Some((stem, ending))) => format!("{stem} ({number}).{ending}"),
            (_, None) => format!("{name} ({number})"),
        };
        let is_free = |name: &String| self.files.iter().all(|known| known.name != *name || *known.bytes == bytes);
        let name = (1..=self.files.len() + 1).map(numbered).find(is_free).unwrap_or_else(|| name.to_owned());
        let file = match self.files.iter().position(|known| known.name == name) {
            Some(known) => self.files.remove(known),
            None => NamedFile { name, bytes: Arc::new(bytes) },
        };
        self.files.push(file.clone());
        let mut kept: usize = self.files.iter().map(|file| file.bytes.len()).sum();
        while kept > MOST_KEPT_BYTES && self.files.len() > 1 {
            kept -= self.files.remove(0).bytes.len();
        }
        file
    }

    /// The source of a shape's triangles; `None` if it is a file that is not kept.
    pub fn source(&self, shape: &SurfaceShape) -> Option<SurfaceSource> {
        match shape {
            SurfaceShape::Preset { preset, boundary } => {
                Some(SurfaceSource::Preset { preset: *preset, boundary: *boundary })
            }
            SurfaceShape::File { name: wanted } => {
                self.files.iter().find(|file| file.name == *wanted).cloned().map(SurfaceSource::File)
            }
        }
    }
}
