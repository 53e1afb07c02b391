//! Opened files that wait for earlier ones: files take effect in the order in which they were opened.
//!
//! An outline or a surface waits until the previous file of its side is parsed, since it replaces that file's shape. A
//! session file waits for all earlier files, and all later files wait for the session. An invalid file therefore
//! never replaces a valid one before it.

use crate::conformal::Side;
use crate::language::{Message, key};
use crate::model::Model;
use crate::model::side::opened_file::{OpenedFile, Origin};
use crate::model::side::user_error::UserError;
use crate::surface::check_size;
use std::collections::VecDeque;

/// An opened file or text that waits for those before it.
#[derive(Debug)]
enum Waiting {
    /// A file to parse; the side is unused for a session file.
    ToRead(Side, OpenedFile),
    /// A surface file, which its preparation parses.
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
    /// Reads a file for a side after those before it.
    pub(in crate::model) fn read_in_turn(&mut self, side: Side, opened: OpenedFile) {
        self.opening.queue.0.push_back(Waiting::ToRead(side, opened));
        self.read_on();
    }

    /// Requests a surface from a file opened for or dropped over a side, after the files before it: one of them may be
    /// the session that needs it.
    pub fn open_surface_in_turn(&mut self, side: Side, name: &str, bytes: Vec<u8>) {
        self.opening.queue.0.push_back(Waiting::Surface { side, name: name.to_owned(), bytes });
        self.read_on();
    }

    /// Continues with the files that were opened after a session file, once its session is open.
    pub fn open_later(&mut self, later: FileQueue) {
        self.opening.queue.0.extend(later.0);
        self.read_on();
    }

    /// Starts the files that need not wait any longer.
    pub(in crate::model) fn read_on(&mut self) {
        while let Some(waiting) = self.take_next() {
            match waiting {
                Waiting::ToRead(side, opened) => {
                    let side = if opened.origin == Origin::SessionFile { self.side_at_rest() } else { side };
                    self.sides[side].reading.want(opened);
                }
                Waiting::Surface { side, name, bytes } => {
                    let side = self.side_for_surface(side, &name);
                    match check_size(bytes.len()) {
                        Ok(()) => self.want_surface_file(side, &name, bytes),
                        Err(error) => self.refuse(side, UserError::new(key::about(&name, Message::from(&error)))),
                    }
                }
            }
        }
    }

    /// A side whose worker is idle, the source if none is: on a busy side, the file postpones a preparation.
    fn side_at_rest(&self) -> Side {
        Side::BOTH.into_iter().find(|&side| !self.sides[side].is_busy()).unwrap_or(Side::Source)
    }

    fn take_next(&mut self) -> Option<Waiting> {
        if self.is_turn_of(self.opening.queue.0.front()?) { self.opening.queue.0.pop_front() } else { None }
    }

    /// Whether a waiting file can start: no file that it has to wait for is being read.
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

    /// Whether the first waiting file can start.
    pub(in crate::model) fn can_read_on(&self) -> bool {
        self.opening.queue.0.front().is_some_and(|waiting| self.is_turn_of(waiting))
    }
}
