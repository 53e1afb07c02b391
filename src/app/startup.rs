//! What needs no screen: the session and the workers, begun while the graphics start.

use crate::app::input::preferences::Preferences;
use crate::app::workers::Workers;
use crate::language::{self, Message};
use crate::model::persistence::Start;
use crate::model::{Model, persistence};
use crate::platform::{self, Kept, Mailbox};
use crate::session::Session;
use crate::session::link::MissingOutline;

/// What needs no screen: the session's state and the workers.
pub struct Startup {
    pub(super) model: Model,
    /// Whether the session goes on where the last one ended, and is kept for the next.
    pub(super) resumes: bool,
    /// The outlines that the session's link only names.
    pub(super) missing: Vec<MissingOutline>,
    pub(super) message: Option<Message>,
    pub(super) preferences: Preferences,
    pub(super) workers: Workers,
}

impl Startup {
    /// Begins with the preparations of `session`: they run while the graphics start.
    pub fn start(session: Session) -> Self {
        let (mut model, mut workers) = (Model::new(session), Workers::start());
        workers.send_due(&mut model, 0.0);
        Self { model, resumes: false, missing: Vec::new(), message: None, preferences: Preferences::fixed(), workers }
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
        self.workers.mailbox.clone()
    }
}
