//! Outline and session files, parsed in a worker.
//!
//! An [`Outline`]'s polygon is validated here and not again: it is transferred to the page as flat arrays
//! ([`FlatOutline`], [`FlatArchive`]), whose polygons are known to be simple.

use crate::geometry::{DVec2, SimplePolygon};
use crate::language::Message;
use crate::outline::{Contents, Outline, PartChoice, Reading, parse_as, parse_contents};
use crate::session::OutlineSpec;
use crate::session::file::{self, Archive, Attachment, Steps};
use std::sync::Arc;

/// A file's name and its content.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedFile {
    /// Its name; the ending determines the format of an outline or a surface.
    pub name: String,
    /// Its content.
    pub bytes: Arc<Vec<u8>>,
}

/// Why a file could not be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Unread {
    /// The reason, for the user.
    pub text: Message,
    /// The outline after safe repairs, if they make it valid.
    pub repaired: Option<Box<Outline>>,
}

impl NamedFile {
    /// Parses an outline: the part of this number, or the largest. Errors: the reason, with the repaired outline if safe
    /// repairs make it valid.
    pub fn outline(&self, part: Option<usize>) -> Result<Contents, Unread> {
        let how = Reading { repair: false, part: part.map(PartChoice::Number) };
        parse_contents(&self.name, &self.bytes, &how).map_err(|error| Unread {
            text: Message::from(&error),
            repaired: parse_as(&self.name, &self.bytes, &Reading { repair: true, ..how }).ok().map(Box::new),
        })
    }

    /// Reads a session with what its file holds besides. Errors: the reason.
    pub fn archive(&self) -> Result<Archive, Unread> {
        file::read_archive(&self.bytes).map_err(|error| Unread { text: Message::from(&error), repaired: None })
    }
}

/// An outline in transferable form: its coordinates as one array, the rest as JSON.
#[derive(Debug, Clone, PartialEq)]
pub struct FlatOutline {
    /// The vertices' coordinates: x and y of the first, of the second, …
    pub points: Vec<f64>,
    /// Name, notes, and the form of its curve.
    pub text: String,
}

impl From<&Outline> for FlatOutline {
    fn from(outline: &Outline) -> Self {
        // strings and plain enums, which always serialize
        let text = serde_json::to_string(&(outline.name(), outline.notes(), outline.form())).unwrap_or_default();
        Self { points: outline.polygon().vertices().iter().flat_map(DVec2::to_array).collect(), text }
    }
}

impl FlatOutline {
    /// The outline; `None` if the text is malformed. The points must be those of a simple polygon, as [`Self::from`]
    /// makes them.
    pub fn outline(&self) -> Option<Outline> {
        let (name, notes, form): (String, _, _) = serde_json::from_str(&self.text).ok()?;
        let polygon = SimplePolygon::known_simple(self.points.chunks_exact(2).map(DVec2::from_slice).collect());
        Some(Outline::new(name, polygon).with_form(form).with_notes(notes))
    }
}

/// A session with its undo steps and its files in transferable form: loaded outlines as flat arrays, the rest as JSON.
#[derive(Debug, Clone, PartialEq)]
pub struct FlatArchive {
    /// The loaded outlines of all steps, each once.
    pub outlines: Vec<FlatOutline>,
    /// The steps, as `Steps` writes them.
    pub text: String,
    /// The files of surfaces.
    pub surfaces: Vec<Attachment>,
    /// The file of the own picture.
    pub picture: Option<Attachment>,
}

impl FlatArchive {
    /// Flattens an archive; `None` if its numbers are out of range, which is never the case for one from a file.
    pub fn of(archive: Archive) -> Option<Self> {
        let Archive { history, surfaces, picture } = archive;
        let Steps { outlines, text } = Steps::of(&history, true).ok()?;
        let flat = |outline: OutlineSpec| match outline {
            OutlineSpec::Points { name, polygon, form } => {
                Some(FlatOutline::from(&Outline::new(name, polygon).with_form(form)))
            }
            OutlineSpec::Preset(_) => None, // has no number
        };
        Some(Self { outlines: outlines.into_iter().filter_map(flat).collect(), text, surfaces, picture })
    }

    /// The archive; `None` if the text is malformed.
    pub fn archive(self) -> Option<Archive> {
        let Self { outlines, text, surfaces, picture } = self;
        let outlines = outlines.iter().map(|outline| Some(outline.outline()?.into())).collect::<Option<Vec<_>>>()?;
        Some(Archive { history: Steps { outlines, text }.history(None).ok()?, surfaces, picture })
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::{Direction, Side};
    use crate::session::{Command, History, Session, SurfaceSpec};

    fn named(name: &str, text: &str) -> NamedFile {
        NamedFile { name: name.into(), bytes: Arc::new(text.into()) }
    }

    #[test]
    fn an_outline_crosses_as_it_was_read_with_its_notes() {
        let outline = named("a.csv", "0,0\n0,2\n2,2\n2,0\n0,0\n").outline(None).unwrap().outline;
        assert!(outline.notes().len() == 2, "reversed and closed: {:?}", outline.notes());
        assert_eq!(FlatOutline::from(&outline).outline().unwrap(), outline);
        assert_eq!(FlatOutline { points: Vec::new(), text: "{".into() }.outline(), None);
    }

    #[test]
    fn a_spike_can_be_cut_off_and_a_crossing_cannot() {
        let spike = named("a.json", "[[0,0],[2,0],[2,1],[3,1],[2,1],[2,2],[0,2]]").outline(None).unwrap_err();
        assert_eq!(spike.repaired.unwrap().name(), "a");
        // which part is meant is not for a machine to say
        assert_eq!(named("a.json", "[[0,0],[2,2],[2,0],[0,3]]").outline(None).unwrap_err().repaired, None);
    }

    #[test]
    fn a_session_crosses_bit_for_bit_with_its_loaded_outlines_points_surface_steps_and_files() {
        let outline = named("a.csv", "0,0\n0.1,0\n0.3,0.7\n").outline(None).unwrap().outline;
        let before = Session::with([Command::SetOutline { side: Side::Target, outline: outline.into() }]);
        let session = before.clone().and([
            Command::MoveInterior { side: Side::Target, point: DVec2::new(0.13, 1.0 / 7.0).into() },
            Command::MoveAnchor { side: Side::Target, fraction: 1.0 / 3.0 },
            Command::SetSurface { side: Side::Target, surface: SurfaceSpec::default() },
            Command::MoveAnchor { side: Side::Target, fraction: 0.7 },
            Command::SetDirection(Direction::Forward),
        ]);
        let mut history = History::new(before.clone());
        history.settle(&session);
        let surfaces = vec![Attachment { name: "a.obj".into(), bytes: Arc::new(b"v".to_vec()) }];
        let archive = Archive { history, surfaces: surfaces.clone(), picture: None };
        let bytes = archive.write().unwrap();
        let flat = FlatArchive::of(archive).unwrap();
        assert_eq!(flat.outlines.len(), 1);
        let crossed = flat.archive().unwrap();
        assert_eq!((crossed.session(), crossed.history.past()), (&session, &[before][..]));
        assert_eq!(crossed.surfaces, surfaces);
        let file = NamedFile { name: "a.riemap".into(), bytes: Arc::new(bytes) };
        assert_eq!(file.archive().unwrap().session(), &session);
        let old = named("a.riemap", &file::write(&session).unwrap());
        assert_eq!(old.archive().unwrap().session(), &session);
        assert!(named("a.riemap", "{}").archive().is_err());
    }
}
