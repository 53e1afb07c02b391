//! What needs no screen: the session and the workers, begun while the graphics start.

use crate::app::input::preferences::Preferences;
use crate::language::{self, Message};
use crate::model::persistence::Start;
use crate::model::{Model, persistence};
use crate::platform::{self, Event, Kept, Mailbox, Preparer};
use crate::session::Session;
use crate::session::link::MissingOutline;
use std::sync::mpsc;

/// What needs no screen: the session's state and the workers.
pub struct Startup {
    pub(super) model: Model,
    /// Whether the session goes on where the last one ended, and is kept for the next.
    pub(super) resumes: bool,
    /// The outlines that the session's link only names.
    pub(super) missing: Vec<MissingOutline>,
    pub(super) message: Option<Message>,
    pub(super) preferences: Preferences,
    pub(super) preparer: Preparer,
    pub(super) mailbox: Mailbox,
    pub(super) events: mpsc::Receiver<Event>,
}

impl Startup {
    /// Begins with the preparations of `session`: they run while the graphics start.
    pub fn start(session: Session) -> Self {
        let (mailbox, events) = Mailbox::new();
        let (mut model, mut preparer) = (Model::new(session), Preparer::new(mailbox.clone()));
        for (side, request) in model.take_requests(0.0) {
            preparer.request(side, request);
        }
        Self {
            model,
            resumes: false,
            missing: Vec::new(),
            message: None,
            preferences: Preferences::fixed(),
            preparer,
            mailbox,
            events,
        }
    }

    /// As [`Self::start`], with the session and the preferences that the address or the last time has left; what went
    /// wrong with the session is shown.
    pub fn resume() -> Self {
        let preferences = Preferences::remembered();
        // the screen's own begins with it: graphics that cannot start are said in it too
        language::set(preferences.with(&crate::app::host::address_options()).language());
        let Start { session, missing, message } =
            persistence::first_session(platform::link().as_deref(), platform::remembered(Kept::Session).as_deref());
        Self { missing, message, resumes: true, preferences, ..Self::start(session) }
    }

    /// Where events for the app are posted.
    pub fn mailbox(&self) -> Mailbox {
        self.mailbox.clone()
    }
}
