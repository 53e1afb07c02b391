//! A file, or a pasted text, that a person has opened as an outline or as a session: the side's worker reads it.
//!
//! It is read at once, before anything else that the side waits for; what the worker had to do instead goes on when
//! there is nothing in the file. An outline that is found is prepared by the same request.

use crate::conformal::PrepareSettings;
use crate::model::side::request::{Generations, PendingRequest};
use crate::worker::{NamedFile, Request, Response, Task};

/// Where the bytes come from, and beside what is said that they cannot be used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A file for an outline: beside its side.
    OutlineFile,
    /// A pasted text for an outline: in the window for it.
    PastedText,
    /// A session's file: of neither side.
    SessionFile,
}

/// What is to be read.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenedFile {
    /// Where it comes from.
    pub origin: Origin,
    /// Its name and content.
    pub file: NamedFile,
}

impl OpenedFile {
    fn task(&self, settings: PrepareSettings) -> Task {
        let file = self.file.clone();
        match self.origin {
            Origin::OutlineFile | Origin::PastedText => Task::OutlineFile { file, settings },
            Origin::SessionFile => Task::SessionFile(file),
        }
    }
}

/// What the worker reads.
#[derive(Debug)]
pub struct InFlight {
    /// The file.
    pub opened: OpenedFile,
    /// How an outline in it is prepared.
    pub settings: PrepareSettings,
}

/// The file that is to be read, or is being read; the newest one.
#[derive(Debug, Default)]
pub struct Reading {
    next: Option<OpenedFile>,
    pending_request: PendingRequest<InFlight>,
}

impl Reading {
    /// Wants a file to be read, in place of another one.
    pub fn want(&mut self, opened: OpenedFile) {
        self.pending_request.end();
        self.next = Some(opened);
    }

    /// Whether a file is to be read or being read.
    pub fn is_busy(&self) -> bool {
        self.next.is_some() || self.pending_request.is_busy()
    }

    /// Whether that is one of this origin.
    pub fn is_of(&self, origin: Origin) -> bool {
        let read = self.pending_request.under_way().map(|in_flight| &in_flight.opened);
        self.next.as_ref().or(read).is_some_and(|opened| opened.origin == origin)
    }

    /// Whether a request is to be made, at once.
    pub fn is_due(&self) -> bool {
        self.next.is_some()
    }

    /// What is with the worker.
    pub fn pending_request(&self) -> &PendingRequest<InFlight> {
        &self.pending_request
    }

    /// The request that is due, if any.
    pub fn take_request(&mut self, settings: PrepareSettings, generations: &mut Generations) -> Option<Request> {
        let opened = self.next.take()?;
        let task = opened.task(settings);
        Some(self.pending_request.send(InFlight { opened, settings }, task, generations))
    }

    /// Takes in an answer of the worker: that which says what is in the file comes back.
    pub fn take_in(&mut self, generation: u64, response: Response) -> Option<Response> {
        self.pending_request.take_in(generation, response)
    }

    /// No file is read any more; that which was, and its request, for an outline's preparation to take over.
    pub fn end(&mut self) -> PendingRequest<InFlight> {
        std::mem::take(self).pending_request
    }
}
