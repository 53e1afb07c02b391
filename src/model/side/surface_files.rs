//! The surface files that were opened for either side, kept so that undo can return to them.

use crate::session::SurfaceShape;
use crate::worker::{NamedFile, SurfaceSource};
use std::sync::Arc;

/// The most bytes of opened files that are kept.
const MOST_KEPT_BYTES: usize = 256 << 20;

/// Opened files, the last one at the end. Invariants: no two have one name; all but the last have
/// `MOST_KEPT_BYTES` together at most.
#[derive(Debug, Default)]
pub struct SurfaceFiles {
    files: Vec<NamedFile>,
}

impl SurfaceFiles {
    /// Keeps a file. A different file of the same name is renamed: "head (2).obj".
    pub fn keep(&mut self, name: &str, bytes: impl Into<Arc<Vec<u8>>>) -> NamedFile {
        let bytes = bytes.into();
        let numbered = |number: usize| match (number, name.rsplit_once('.')) {
            (1, _) => name.to_owned(),
            (_, Some((stem, ending))) => format!("{stem} ({number}).{ending}"),
            (_, None) => format!("{name} ({number})"),
        };
        let is_free = |name: &String| self.files.iter().all(|known| known.name != *name || known.bytes == bytes);
        let name = (1..=self.files.len() + 1).map(numbered).find(is_free).unwrap_or_else(|| name.to_owned());
        let file = match self.files.iter().position(|known| known.name == name) {
            Some(known) => self.files.remove(known),
            None => NamedFile { name, bytes },
        };
        self.files.push(file.clone());
        let mut kept: usize = self.files.iter().map(|file| file.bytes.len()).sum();
        while kept > MOST_KEPT_BYTES && self.files.len() > 1 {
            kept -= self.files.remove(0).bytes.len();
        }
        file
    }

    /// The kept files whose names `is_used`, the last opened at the end.
    pub fn used(&self, is_used: impl Fn(&str) -> bool) -> impl Iterator<Item = &NamedFile> {
        self.files.iter().filter(move |file| is_used(&file.name))
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
