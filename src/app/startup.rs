//! The part of the app that needs no screen: the session and the workers, started while the graphics initialize.

use crate::app::input::preferences::Preferences;
use crate::app::workers::Workers;
use crate::language::{self, Message};
use crate::model::persistence::Start;
use crate::model::{Model, persistence};
use crate::platform::{self, Kept, Mailbox};
use crate::session::Session;
use crate::session::link::MissingOutline;

/// The parts of the app that need no screen: the session's state and the workers.
pub struct Startup {
    pub(super) model: Model,
    /// Whether the session is the stored one of the last run, and is stored for the next.
    pub(super) resumes: bool,
    /// The outlines that the session's link contains by name only.
    pub(super) missing: Vec<MissingOutline>,
    pub(super) message: Option<Message>,
    pub(super) preferences: Preferences,
    pub(super) workers: Workers,
}

impl Startup {
    /// Starts the preparations of `session`, which run while the graphics initialize.
    pub fn start(session: Session) -> Self {
        let (mut model, mut workers) = (Model::new(session), Workers::start());
        workers.send_due(&mut model, 0.0);
        Self { model, resumes: false, missing: Vec::new(), message: None, preferences: Preferences::fixed(), workers }
    }

    /// As [`Self::start`], with the session and the preferences from the address or the last run; an
    /// error of the session is shown.
    pub fn resume() -> Self {
        let preferences = Preferences::remembered();
        // the language of the screen is set first: it also applies to errors of the graphics
        language::set(preferences.with(&crate::app::host::address_options()).language());
        let Start { session, missing, message } =
            persistence::first_session(platform::link().as_deref(), platform::remembered(Kept::Session).as_deref());
        Self { missing, message, resumes: true, preferences, ..Self::start(session) }
    }

    /// The sending end of the app's event channel.
    pub fn mailbox(&self) -> Mailbox {
        self.workers.mailbox.clone()
    }
}
