//! Opened sessions: each is a visit with an id, which an entry of the browser's history refers to.
//!
//! Opening a link, a file or a picture of the gallery begins another visit; going back in the browser's history returns
//! to the former one with its undo steps. A visit that was left stays in memory, as far as there is room; the platform
//! keeps the last ones from run to run.

use crate::conformal::Side;
use crate::language::{self, tr};
use crate::session::file::{Archive, Attachment, FileError, Part};
use crate::session::{History, OutlineSpec, Session, SurfaceShape};
use std::collections::VecDeque;

/// The visits that stay in memory: people go back a few steps; the platform keeps more.
const MOST_LEFT: usize = 8;

/// An opened session as it is kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Visit {
    /// Its id.
    pub id: String,
    /// The fragment of its link, if there is one.
    pub link: Option<String>,
    /// The names of its outlines or surfaces.
    pub title: String,
    /// Its parts, as in a session file.
    pub parts: Vec<Part>,
}

/// A visit as it is read back.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// Its id.
    pub id: String,
    /// Its parts.
    pub parts: Vec<Part>,
}

/// A kept visit in a list.
#[derive(Debug, Clone, PartialEq)]
pub struct Listed {
    /// Its id.
    pub id: String,
    /// The names of its outlines or surfaces.
    pub title: String,
    /// When it was kept, in ms since 1970.
    pub at_ms: f64,
}

impl Visit {
    /// The visit `id` of an archive. Errors: a number outside the range of its control.
    pub fn new(id: &str, link: Option<String>, archive: &Archive) -> Result<Self, FileError> {
        Ok(Self { id: id.to_owned(), link, title: title(archive.session()), parts: archive.parts()? })
    }

    /// Whether it has files besides the documents.
    pub fn has_files(&self) -> bool {
        self.parts.iter().any(Part::is_file)
    }

    /// Its documents without the files; surfaces are then asked for.
    #[must_use]
    pub fn without_files(mut self) -> Self {
        self.parts = Part::without_files(self.parts);
        self
    }
}

impl Kept {
    /// The session with its steps and files. Errors name the part that is missing or broken.
    pub fn archive(&self) -> Result<Archive, FileError> {
        Archive::from_parts(&self.parts)
    }
}

/// The names of both sides.
fn title(session: &Session) -> String {
    let name = |side| {
        let surface = session.surface(side).map(|surface| match &surface.spec.shape {
            SurfaceShape::Preset { preset, .. } => tr(language::surface_preset(*preset)).to_owned(),
            SurfaceShape::File { name } => name.clone(),
        });
        surface.unwrap_or_else(|| match &session.domain(side).outline {
            OutlineSpec::Preset(preset) => tr(language::preset(*preset)).to_owned(),
            OutlineSpec::Points { name, .. } => name.clone(),
        })
    };
    Side::BOTH.map(name).join(" \u{2192} ")
}

/// A visit that was left.
#[derive(Debug, Clone)]
pub struct Left {
    /// Its undo steps.
    pub steps: History,
    /// Its own picture.
    pub picture: Option<Attachment>,
}

/// The visit that is shown, and those that were left.
#[derive(Debug, Default)]
pub struct Visits {
    current: Option<String>,
    /// The visit that is being read and will be shown; until then nothing is stored.
    awaited: Option<String>,
    left: VecDeque<(String, Left)>,
    /// The kept visits, the newest first.
    pub listed: Vec<Listed>,
}

impl Visits {
    /// Visits of which `current` is shown.
    pub fn new(current: Option<String>, listed: Vec<Listed>) -> Self {
        Self { current, awaited: None, left: VecDeque::new(), listed }
    }

    /// The id of the visit that is shown; `None` if none are kept.
    pub fn current(&self) -> Option<&str> {
        self.current.as_deref()
    }

    /// Leaves the visit that is shown, as `left`, for `next`.
    pub fn leave_for(&mut self, next: String, left: Left) {
        self.awaited = None;
        if let Some(former) = self.current.replace(next) {
            self.keep_left(former, left);
        }
    }

    /// Leaves the visit that is shown, as `left`, for one that is read first.
    pub fn leave_to_read(&mut self, next: String, left: Left) {
        self.awaited = Some(next);
        if let Some(former) = self.current.take() {
            self.keep_left(former, left);
        }
    }

    /// Goes on with the visit that was read, under an id of its own if another tab has the former one. False if the user has
    /// gone elsewhere since.
    pub fn take_read(&mut self, id: &str, own: String) -> bool {
        let is_awaited = self.awaited.take_if(|awaited| awaited == id).is_some();
        if is_awaited {
            self.current = Some(own);
        }
        is_awaited
    }

    /// Whether the visit is shown or being read.
    pub fn is_at(&self, id: &str) -> bool {
        [&self.current, &self.awaited].into_iter().flatten().any(|known| known == id)
    }

    fn keep_left(&mut self, former: String, left: Left) {
        self.left.retain(|(id, _)| *id != former);
        self.left.push_back((former, left));
        if self.left.len() > MOST_LEFT {
            self.left.pop_front();
        }
    }

    /// A visit that was left, if it is in memory.
    pub fn left(&self, id: &str) -> Option<&Left> {
        self.left.iter().find(|(left, _)| left == id).map(|(_, left)| left)
    }

    /// The kept visits other than the one that is shown, the newest first.
    pub fn others(&self) -> impl Iterator<Item = &Listed> {
        self.listed.iter().filter(|listed| Some(listed.id.as_str()) != self.current())
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::session::scaled;

    #[test]
    fn a_visit_that_was_left_can_be_gone_back_to_with_its_steps() {
        let mut visits = Visits::new(Some("a".into()), Vec::new());
        let mut history = History::new(scaled(4.0));
        history.settle(&scaled(2.0));
        let left = |steps: &History| Left { steps: steps.clone(), picture: None };
        visits.leave_for("b".into(), left(&history));
        assert_eq!(visits.current(), Some("b"));
        visits.leave_for("a".into(), left(&History::new(scaled(7.0))));
        assert_eq!(visits.left("a").unwrap().steps.past(), history.past());
        assert_eq!(visits.left("b").unwrap().steps.now(), &scaled(7.0));
        for k in 0..20 {
            visits.leave_for(format!("{k}"), left(&history));
        }
        assert!(visits.left("b").is_none() && visits.left("18").is_some(), "the last ones stay");
    }

    /// Another tab may have the visit: until its own id is known, the session of the former visit must not be stored as it.
    #[test]
    fn a_visit_that_is_read_is_no_visit_until_it_is_there() {
        let left = || Left { steps: History::new(scaled(4.0)), picture: None };
        let mut visits = Visits::new(Some("a".into()), Vec::new());
        visits.leave_to_read("b".into(), left());
        assert!(visits.current().is_none() && visits.is_at("b") && visits.left("a").is_some());
        assert!(visits.take_read("b", "copy of b".into()));
        assert_eq!(visits.current(), Some("copy of b"));
        visits.leave_to_read("c".into(), left());
        visits.leave_for("d".into(), left());
        assert!(!visits.take_read("c", "c".into()), "the user has gone on");
        assert_eq!(visits.current(), Some("d"));
    }

    #[test]
    fn a_kept_visit_is_the_archive_again() {
        let mut history = History::new(scaled(4.0));
        history.settle(&scaled(2.0));
        let archive = Archive { history, surfaces: Vec::new(), picture: None };
        let visit = Visit::new("a", None, &archive).unwrap();
        assert_eq!(visit.title, "Gingerbread man \u{2192} Heart");
        let found = Kept { id: "a".into(), parts: visit.parts }.archive().unwrap();
        assert_eq!((found.session(), found.history.past()), (&scaled(2.0), &[scaled(4.0)][..]));
    }
}
