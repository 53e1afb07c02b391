//! The opened files whose turn has not come: files take effect in the order in which they were opened.
//!
//! An outline waits until the file before it on its side is parsed, a surface too, since each replaces what the one
//! before it has brought. A session file waits for every file before it, and every file after it for the session. A
//! file that turns out to be bad therefore takes nothing from a good one before it.

use crate::conformal::Side;
use crate::language::Message;
use crate::model::Model;
use crate::model::side::check_size;
use crate::model::side::opened_file::{OpenedFile, Origin};
use crate::model::side::user_error::UserError;
use std::collections::VecDeque;

/// An opened file or text that waits for those before it.
#[derive(Debug)]
enum Waiting {
    /// It is parsed first. The side of a session file has no meaning.
    ToRead(Side, OpenedFile),
    /// It is a surface, whose preparation parses it.
    Surface { side: Side, name: String, bytes: Vec<u8> },
}

impl Waiting {
    fn is_session(&self) -> bool {
        matches!(self, Self::ToRead(_, opened) if opened.origin == Origin::SessionFile)
    }

    fn is_pasted(&self) -> bool {
        matches!(self, Self::ToRead(_, opened) if opened.origin == Origin::PastedText)
    }

    fn side(&self) -> Side {
        let (Self::ToRead(side, _) | Self::Surface { side, .. }) = self;
        *side
    }

    fn concerns(&self, side: Side) -> bool {
        self.is_session() || self.side() == side
    }
}

/// Opened files that wait for those before them, the oldest first.
#[derive(Debug, Default)]
pub struct FileQueue(VecDeque<Waiting>);

impl FileQueue {
    /// Whether no file waits.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a file for this side waits, or a session file.
    pub fn concerns(&self, side: Side) -> bool {
        self.0.iter().any(|waiting| waiting.concerns(side))
    }

    /// Whether a text pasted for this side waits.
    pub fn has_pasted(&self, side: Side) -> bool {
        self.0.iter().any(|waiting| waiting.is_pasted() && waiting.side() == side)
    }

    /// Drops the files for a side, and session files.
    pub fn drop_for(&mut self, side: Side) {
        self.0.retain(|waiting| !waiting.concerns(side));
    }
}

impl Model {
    /// Reads a file for a side when those before it are read.
    pub(in crate::model) fn read_in_turn(&mut self, side: Side, opened: OpenedFile) {
        self.queue.0.push_back(Waiting::ToRead(side, opened));
        self.read_on();
    }

    /// Begins to prepare a surface from a file that was opened for or dropped over a side, when the files before it are
    /// read: one of them may be the session that asks for it. A file that is too large is refused at once.
    pub fn open_surface_in_turn(&mut self, side: Side, name: &str, bytes: Vec<u8>) {
        if let Err(error) = check_size(name, bytes.len()) {
            return self.refuse(self.side_for_surface(side, name), UserError::new(Message::from(&error)));
        }
        self.queue.0.push_back(Waiting::Surface { side, name: name.to_owned(), bytes });
        self.read_on();
    }

    /// Goes on with the files that were opened after a session file, once its session is opened.
    pub fn open_later(&mut self, later: FileQueue) {
        self.queue.0.extend(later.0);
        self.read_on();
    }

    /// Begins with the files whose turn has come.
    pub(in crate::model) fn read_on(&mut self) {
        while let Some(waiting) = self.take_next() {
            match waiting {
                Waiting::ToRead(side, opened) => {
                    let side = if opened.origin == Origin::SessionFile { self.side_at_rest() } else { side };
                    self.sides[side].reading.want(opened);
                }
                Waiting::Surface { side, name, bytes } => {
                    let side = self.side_for_surface(side, &name);
                    self.want_surface_file(side, &name, bytes);
                }
            }
        }
    }

    /// A side whose worker has nothing to do, if there is one: on the other one, a file postpones a preparation.
    fn side_at_rest(&self) -> Side {
        Side::BOTH.into_iter().find(|&side| !self.sides[side].is_busy()).unwrap_or(Side::Source)
    }

    fn take_next(&mut self) -> Option<Waiting> {
        if self.is_turn_of(self.queue.0.front()?) { self.queue.0.pop_front() } else { None }
    }

    /// Whether a file that waits can be begun with: nothing is being read that it has to wait for.
    fn is_turn_of(&self, waiting: &Waiting) -> bool {
        let side = match waiting {
            Waiting::Surface { side, name, .. } => self.side_for_surface(*side, name),
            Waiting::ToRead(side, _) => *side,
        };
        let is_free = |at: Side| {
            let reading = &self.sides[at].reading;
            !reading.is_of(Origin::SessionFile) && !(reading.is_busy() && (at == side || waiting.is_session()))
        };
        Side::BOTH.into_iter().all(is_free)
    }

    /// Whether a file is to be begun with.
    pub(in crate::model) fn can_read_on(&self) -> bool {
        self.queue.0.front().is_some_and(|waiting| self.is_turn_of(waiting))
    }
}
