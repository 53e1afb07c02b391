//! Files and pasted texts that a person has opened: read by a side's worker, and what is in them.
//!
//! An outline takes its place in the model as soon as it is read; its inside is prepared by the same request. What
//! the app has to do about a file (the tour ends, a session is opened) is an [`Arrived`], which it takes after each
//! answer of a worker.

use crate::conformal::Side;
use crate::language::{Message, key};
use crate::model::Model;
use crate::model::names;
use crate::model::side::opened_file::{InFlight, OpenedFile, Origin};
use crate::model::side::user_error::{QuickFix, UserError};
use crate::outline::Outline;
use crate::session::Session;
use crate::worker::{NamedFile, Response, Unread};
use std::sync::Arc;

/// What has come of a file, or of a pasted text.
#[derive(Debug)]
pub enum Arrived {
    /// An outline: it is being prepared.
    Outline(Origin),
    /// A surface: it is prepared, and stands on its side.
    Surface,
    /// A session.
    Session(Box<Session>),
    /// A session's file is none.
    NoSession(Message),
    /// A pasted text is no outline for this side.
    NoOutline(Side, Message),
}

impl Model {
    /// Begins to read an outline's file for a side.
    pub fn open_outline(&mut self, side: Side, name: &str, bytes: Vec<u8>) {
        self.read(side, Origin::OutlineFile, name, bytes);
    }

    /// Begins to read a pasted text as an outline for a side.
    pub fn open_pasted(&mut self, side: Side, text: &str) {
        self.read(side, Origin::PastedText, names::PASTED, text.as_bytes().to_vec());
    }

    /// Begins to read a session's file.
    pub fn open_session_file(&mut self, name: &str, bytes: Vec<u8>) {
        self.read(Side::Source, Origin::SessionFile, name, bytes);
    }

    fn read(&mut self, side: Side, origin: Origin, name: &str, bytes: Vec<u8>) {
        let file = NamedFile { name: name.to_owned(), bytes: Arc::new(bytes) };
        self.read_again(side, OpenedFile { origin, file });
    }

    pub(super) fn read_again(&mut self, side: Side, opened: OpenedFile) {
        self.sides[side].reading.want(opened);
    }

    /// Something else is wanted on a side: a file that is read for it is not, nor is a session.
    pub(super) fn stop_reading(&mut self, side: Side) {
        for (at, state) in Side::BOTH.into_iter().zip(self.sides.as_mut().into_array()) {
            if at == side || state.reading.is_of(Origin::SessionFile) {
                state.reading.end();
            }
        }
    }

    /// Whether something from a file, or a pasted text, is on its way to a side.
    pub fn awaits_file(&self) -> bool {
        self.sides.iter().any(|(_, side)| side.reading.is_busy() || side.surface.preparation.awaits_file())
    }

    /// Whether a pasted text is being read for a side.
    pub fn reads_pasted(&self, side: Side) -> bool {
        self.sides[side].reading.is_of(Origin::PastedText)
    }

    /// What has come of a file with the last answer.
    pub fn take_arrived(&mut self) -> Option<Arrived> {
        self.arrived.take()
    }

    /// Takes in an answer about a file that is read.
    pub(super) fn accept_read(&mut self, side: Side, generation: u64, response: Response) {
        let reading = &mut self.sides[side].reading;
        match reading.take_in(generation, response) {
            Some(Response::Outline(outline)) => self.take_outline(side, *outline),
            Some(Response::Session(session)) => {
                reading.end();
                self.arrived = Some(Arrived::Session(session));
            }
            Some(Response::Unread(unread)) => {
                if let Some(InFlight { opened, .. }) = reading.end().end() {
                    self.refuse(side, &opened, unread);
                }
            }
            _ => {} // a stage, which the request remembers
        }
    }

    fn take_outline(&mut self, side: Side, outline: Outline) {
        let request = self.sides[side].reading.end();
        let Some(InFlight { opened, settings }) = request.under_way() else { return };
        let (origin, settings) = (opened.origin, *settings);
        self.want_loaded(side, outline);
        self.side_mut(side).take_over(&request, settings);
        self.arrived = Some(Arrived::Outline(origin));
    }

    /// What is said of a file, in the place for it. The good state stays, and what was under way goes on.
    fn refuse(&mut self, side: Side, opened: &OpenedFile, Unread { text, repaired }: Unread) {
        let name = &opened.file.name;
        match opened.origin {
            Origin::OutlineFile => {
                self.dismiss(side);
                let quick_fix = repaired.map(QuickFix::Repaired);
                self.side_mut(side).error = Some(UserError { text: key::about(name, text), quick_fix });
            }
            Origin::PastedText => self.arrived = Some(Arrived::NoOutline(side, text)),
            Origin::SessionFile => self.arrived = Some(Arrived::NoSession(key::about(name, text))),
        }
    }

    /// The worker is gone that was reading: the file can be read again.
    pub(super) fn reader_died(&mut self, side: Side, reason: &Message) {
        if let Some(InFlight { opened, .. }) = self.sides[side].reading.end().end() {
            let text = key::about(&opened.file.name, key::preparation_stopped(reason.clone()));
            self.side_mut(side).error = Some(UserError { text, quick_fix: Some(QuickFix::ReadAgain(opened)) });
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests;
