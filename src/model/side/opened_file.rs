//! A file or a pasted text, opened as an outline or a session, that the side's worker parses.
//!
//! The request is sent at once and postpones the side's other requests; they are sent again if the file cannot be
//! used. The same request prepares an outline that was parsed.

use crate::conformal::PrepareSettings;
use crate::language::Message;
use crate::model::side::request::{Generations, PendingRequest};
use crate::outline::{self, OutlineError};
use crate::session::file::{self, FileError};
use crate::worker::{NamedFile, Request, Response, Task, Unread};

/// The source of the bytes, which decides where a failure is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// An outline file: beside its side.
    OutlineFile,
    /// A text pasted as an outline: in the paste window.
    PastedText,
    /// A session file: in the common message.
    SessionFile,
}

/// A file or text to parse.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenedFile {
    /// Its source.
    pub origin: Origin,
    /// Its name and content.
    pub file: NamedFile,
    /// The number of the shape or the feature of an outline's file that is meant; the largest if there is none.
    pub part: Option<usize>,
}

impl OpenedFile {
    /// Why the file need not be sent: its reader would refuse it for its size, after it was copied.
    pub fn too_large(&self) -> Option<Unread> {
        let bytes = self.file.bytes.len();
        let text = match self.origin {
            Origin::OutlineFile | Origin::PastedText => {
                (bytes > outline::MAX_BYTES).then(|| Message::from(&OutlineError::TooLarge { bytes }))
            }
            Origin::SessionFile => {
                let limit = file::largest(&self.file.bytes);
                (bytes > limit).then(|| Message::from(&FileError::TooLarge { limit }))
            }
        };
        text.map(|text| Unread { text, repaired: None })
    }

    fn task(&self, settings: PrepareSettings) -> Task {
        let file = self.file.clone();
        match self.origin {
            Origin::OutlineFile | Origin::PastedText => Task::OutlineFile { file, part: self.part, settings },
            Origin::SessionFile => Task::SessionFile(file),
        }
    }
}

/// What the worker parses.
#[derive(Debug)]
pub struct InFlight {
    /// The file.
    pub opened: OpenedFile,
    /// The settings with which an outline in it is prepared.
    pub settings: PrepareSettings,
}

/// The opened file that is due or in flight.
#[derive(Debug, Default)]
pub struct Reading {
    next: Option<OpenedFile>,
    pending_request: PendingRequest<InFlight>,
}

impl Reading {
    /// Requests that a file be parsed, when the previous one has been.
    pub fn want(&mut self, opened: OpenedFile) {
        debug_assert!(!self.is_busy(), "a file is read after the one before it");
        self.next = Some(opened);
    }

    /// Whether a file is due or in flight.
    pub fn is_busy(&self) -> bool {
        self.next.is_some() || self.pending_request.is_busy()
    }

    /// Whether a file of this origin is due or in flight.
    pub fn is_of(&self, origin: Origin) -> bool {
        let read = self.pending_request.under_way().map(|in_flight| &in_flight.opened);
        self.next.as_ref().or(read).is_some_and(|opened| opened.origin == origin)
    }

    /// Whether a request is due.
    pub fn is_due(&self) -> bool {
        self.next.is_some()
    }

    /// The request in flight.
    pub fn pending_request(&self) -> &PendingRequest<InFlight> {
        &self.pending_request
    }

    /// The request that is due, if any.
    pub fn take_request(&mut self, settings: PrepareSettings, generations: &mut Generations) -> Option<Request> {
        let opened = self.next.take()?;
        let task = opened.task(settings);
        Some(self.pending_request.send(InFlight { opened, settings }, task, generations))
    }

    /// Accepts a response; returns it unless it is stale or only reports a stage.
    pub fn take_in(&mut self, generation: u64, response: Response) -> Option<Response> {
        self.pending_request.take_in(generation, response)
    }

    /// Cancels the file; returns the request in flight, which an outline's preparation may take over.
    pub fn end(&mut self) -> PendingRequest<InFlight> {
        std::mem::take(self).pending_request
    }
}
