//! Opened files and pasted texts: a side's worker parses them, the model accepts the contents.
//!
//! One request parses an outline and prepares it. The app's part of the result (end the tour, open a session, show an
//! error) is an [`Arrived`], which the app takes after each response and each opened file.
//!
//! Files take effect in the order in which they were opened (file `queue`). A file that arrives cancels no other one; a
//! shape that the user chooses meanwhile cancels the files for its side (`Model::stop_reading`).

mod queue;

pub use queue::FileQueue;

use crate::conformal::Side;
use crate::language::{Message, key};
use crate::model::Model;
use crate::model::names;
use crate::model::side::ModelSide;
use crate::model::side::opened_file::{InFlight, OpenedFile, Origin};
use crate::model::side::user_error::{QuickFix, UserError};
use crate::outline::{Outline, Parts};
use crate::session::OutlineSpec;
use crate::session::file::Archive;
use crate::worker::{NamedFile, Response, Unread};
use std::sync::Arc;

/// The result of parsing a file or a pasted text.
#[derive(Debug)]
pub enum Arrived {
    /// An outline, which is now being prepared.
    Outline(ArrivedOutline),
    /// A surface, which is prepared and shown on its side.
    Surface,
    /// A session with its undo steps and its files, and the files that were opened after it; pass them to [`Model::open_later`] once it is open.
    Session(Box<Archive>, FileQueue),
    /// A session file could not be read.
    NoSession(Message),
    /// The text pasted for this side is not an outline.
    NoOutline(Side, Message),
}

/// An outline that was read from a file or a pasted text.
#[derive(Debug)]
pub struct ArrivedOutline {
    /// Its side.
    pub side: Side,
    /// Where the bytes came from.
    pub origin: Origin,
    /// Its file, if its coordinates may be longitudes and latitudes.
    pub geographic: Option<OpenedFile>,
    /// The number of shapes or features of the file, if there are several.
    pub of_several: Option<usize>,
}

/// A file that holds more than the outline that was read from it.
#[derive(Debug, Clone)]
pub(in crate::model) struct OpenedParts {
    opened: OpenedFile,
    parts: Parts,
    /// The outline that was read.
    outline: OutlineSpec,
}

/// The opened files that are not shown yet.
#[derive(Debug, Default)]
pub(super) struct Opening {
    /// Those that wait for the files before them.
    queue: FileQueue,
    /// The result of the last one, for the app.
    pub(super) arrived: Option<Arrived>,
}

impl Opening {
    /// Whether files for a side wait.
    pub(super) fn concerns(&self, side: Side) -> bool {
        self.queue.concerns(side)
    }
}

impl Model {
    /// Requests an outline file for a side.
    pub fn open_outline(&mut self, side: Side, name: &str, bytes: Vec<u8>) {
        self.read(side, Origin::OutlineFile, name, bytes);
    }

    /// Requests a pasted text as an outline for a side.
    pub fn open_pasted(&mut self, side: Side, text: &str) {
        self.read(side, Origin::PastedText, names::PASTED, text.as_bytes().to_vec());
    }

    /// Requests a session file, in the worker of an idle side if there is one.
    pub fn open_session_file(&mut self, name: &str, bytes: Vec<u8>) {
        self.read(Side::Source, Origin::SessionFile, name, bytes);
    }

    fn read(&mut self, side: Side, origin: Origin, name: &str, bytes: Vec<u8>) {
        let file = NamedFile { name: name.to_owned(), bytes: Arc::new(bytes) };
        self.read_opened(side, OpenedFile { origin, file, part: None });
    }

    /// Requests another shape or feature of the file from which a side's outline was read.
    pub fn open_part(&mut self, side: Side, number: usize) {
        if let Some(OpenedParts { opened, .. }) = self.opened_parts(side) {
            let opened = OpenedFile { origin: Origin::OutlineFile, part: Some(number), ..opened.clone() };
            self.read_opened(side, opened);
        }
    }

    /// The name of the file from which a side's outline was read and what else it holds, if that is something.
    pub fn parts(&self, side: Side) -> Option<(&str, &Parts)> {
        self.opened_parts(side).map(|OpenedParts { opened, parts, .. }| (opened.file.name.as_str(), parts))
    }

    /// Nothing once the outline is another one.
    fn opened_parts(&self, side: Side) -> Option<&OpenedParts> {
        let is_outline = self.session.surface(side).is_none();
        self.sides[side].parts.as_ref().filter(|parts| is_outline && parts.outline == self.side(side).wanted().outline)
    }

    fn read_opened(&mut self, side: Side, opened: OpenedFile) {
        match opened.too_large() {
            Some(unread) => self.refuse_file(side, opened, unread),
            None => self.read_in_turn(side, opened),
        }
    }

    /// Cancels the files for a side, and session files, because the user chose another shape.
    pub(super) fn stop_reading(&mut self, side: Side) {
        self.opening.queue.drop_for(side);
        for (at, state) in Side::BOTH.into_iter().zip(self.sides.as_mut().into_array()) {
            if at == side || state.reading.is_of(Origin::SessionFile) {
                state.reading.end();
            }
        }
    }

    /// Whether a file or pasted text is being read, or a surface from a file prepared.
    pub fn awaits_file(&self) -> bool {
        let awaits = |side: &ModelSide| side.reading.is_busy() || side.surface.preparation.awaits_file();
        !self.opening.queue.is_empty() || self.sides.iter().any(|(_, side)| awaits(side))
    }

    /// Whether a pasted text is being read for a side.
    pub fn reads_pasted(&self, side: Side) -> bool {
        self.sides[side].reading.is_of(Origin::PastedText) || self.opening.queue.has_pasted(side)
    }

    /// Takes the result of the last response, or of an opened file that was refused at once.
    pub fn take_arrived(&mut self) -> Option<Arrived> {
        self.opening.arrived.take()
    }

    /// Accepts a response about the file being read.
    pub(super) fn accept_read(&mut self, side: Side, generation: u64, response: Response) {
        let reading = &mut self.sides[side].reading;
        match reading.take_in(generation, response) {
            Some(Response::Outline(outline, parts)) => self.take_outline(side, *outline, parts),
            Some(Response::Session(archive)) => {
                reading.end();
                self.opening.arrived = Some(Arrived::Session(archive, std::mem::take(&mut self.opening.queue)));
            }
            Some(Response::Unread(unread)) => {
                if let Some(InFlight { opened, .. }) = reading.end().end() {
                    self.refuse_file(side, opened, unread);
                }
            }
            _ => {} // stale, or progress, which the request stores
        }
    }

    fn take_outline(&mut self, side: Side, outline: Outline, parts: Option<Parts>) {
        let request = self.sides[side].reading.end();
        let Some(InFlight { opened, settings }) = request.under_way() else { return };
        let (opened, settings) = (opened.clone(), *settings);
        let notes = outline.notes().to_vec();
        let arrived = ArrivedOutline {
            side,
            origin: opened.origin,
            geographic: outline.is_geographic().then(|| opened.clone()),
            of_several: parts.as_ref().map(|parts| parts.count),
        };
        let outline = OutlineSpec::from(outline);
        self.sides[side].parts = parts.map(|parts| OpenedParts { opened, parts, outline: outline.clone() });
        self.replace_outline(side, outline, notes);
        self.side_mut(side).take_over(&request, settings);
        self.opening.arrived = Some(Arrived::Outline(arrived));
    }

    /// Reports a file that could not be read; the repaired outline, if any, is its quick fix.
    fn refuse_file(&mut self, side: Side, opened: OpenedFile, Unread { text, repaired }: Unread) {
        self.report(side, opened, text, |_| repaired.map(QuickFix::Repaired));
    }

    /// Reports that the worker stopped while it read a file; for an outline, the quick fix reads the file again.
    pub(super) fn reader_died(&mut self, side: Side, reason: &Message) {
        if let Some(InFlight { opened, .. }) = self.sides[side].reading.end().end() {
            self.report(side, opened, key::reading_stopped(reason.clone()), |opened| Some(QuickFix::ReadAgain(opened)));
        }
    }

    /// Reports a file that cannot be used, where its origin belongs; only an outline file can have a quick fix.
    fn report(
        &mut self,
        side: Side,
        opened: OpenedFile,
        text: Message,
        quick_fix: impl FnOnce(OpenedFile) -> Option<QuickFix>,
    ) {
        let about = key::about(&opened.file.name, text.clone());
        match opened.origin {
            Origin::OutlineFile => {
                self.refuse(side, UserError { quick_fix: quick_fix(opened), ..UserError::new(about) });
            }
            Origin::PastedText => self.opening.arrived = Some(Arrived::NoOutline(side, text)),
            Origin::SessionFile => self.opening.arrived = Some(Arrived::NoSession(about)),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod queue_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests;
