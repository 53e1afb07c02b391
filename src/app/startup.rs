//! The part of the app that needs no screen: the session and the workers, started while the graphics initialize.

use crate::app::input::preferences::Preferences;
use crate::app::workers::Workers;
use crate::language::{self, Message, key};
use crate::model::persistence::visits::Visits;
use crate::model::persistence::{KeptCopies, Start};
use crate::model::{Model, persistence};
use crate::platform::{self, Kept, Mailbox};
use crate::session::file::{Archive, Attachment};
use crate::session::lesson::{self, Lesson};
use crate::session::link::MissingOutline;
use crate::session::{History, Session};

/// The parts of the app that need no screen: the session's state and the workers.
pub struct Startup {
    pub(super) model: Model,
    /// The undo steps of the last run, and its own picture.
    pub(super) steps: Option<History>,
    pub(super) picture: Option<Attachment>,
    pub(super) visits: Visits,
    /// Whether the session is the stored one of the last run, and is stored for the next.
    pub(super) resumes: bool,
    /// The outlines that the session's link contains by name only.
    pub(super) missing: Vec<MissingOutline>,
    pub(super) message: Option<Message>,
    /// The lesson that was being made, and its stored text.
    pub(super) draft: (Lesson, Option<String>),
    pub(super) preferences: Preferences,
    pub(super) workers: Workers,
}

impl Startup {
    /// Starts the preparations of `session`, which run while the graphics initialize.
    pub fn start(session: Session) -> Self {
        Self::with(Model::new(session))
    }

    fn with(mut model: Model) -> Self {
        let mut workers = Workers::start();
        workers.send_due(&mut model, 0.0);
        Self {
            model,
            steps: None,
            picture: None,
            visits: Visits::default(),
            resumes: false,
            missing: Vec::new(),
            message: None,
            draft: (Lesson::default(), None),
            preferences: Preferences::fixed(),
            workers,
        }
    }

    /// As [`Self::start`], with the session and the preferences from the address or the last run; an
    /// error of the session is shown.
    pub fn resume() -> Self {
        let preferences = Preferences::remembered();
        // the language of the screen is set first: it also applies to errors of the graphics
        language::set(preferences.with(&crate::app::host::address_options()).language());
        let (record, listed) = platform::first_kept();
        let text = platform::remembered(Kept::Session);
        let id = record.as_ref().map(|record| record.id.clone());
        let kept = KeptCopies {
            text: text.as_deref(),
            record: record.map(|record| record.archive()),
            text_is_elsewhere: platform::visit_of_text().is_some_and(|visit| Some(visit) != id),
            record_is_own: id.is_some() && platform::visit() == id,
        };
        let Start { mut archive, is_kept, missing, message } =
            persistence::first_session(platform::link().as_deref(), kept);
        // another tab has a visit of its own, so that none overwrites the other's
        let current = platform::visit().or_else(platform::new_visit);
        if let Some(id) = current.as_deref().filter(|_| platform::visit().is_none()) {
            platform::begin_visit(id);
        }
        let model = Model::of_archive(&mut archive);
        let Archive { history, picture, .. } = archive;
        let (steps, visits) = (is_kept.then_some(history), Visits::new(current, listed));
        let (draft, unread) = kept_lesson();
        let message = Message::joined(message.into_iter().chain(unread), key::sentence_and);
        Self { steps, picture, visits, missing, message, draft, resumes: true, preferences, ..Self::with(model) }
    }

    /// The sending end of the app's event channel.
    pub fn mailbox(&self) -> Mailbox {
        self.workers.mailbox.clone()
    }
}

/// The draft of the last run, or why it cannot be read.
fn kept_lesson() -> ((Lesson, Option<String>), Option<Message>) {
    let text = platform::remembered(Kept::Lesson);
    match text.as_deref().filter(|text| !text.is_empty()).map(|text| lesson::read_draft(text.as_bytes())) {
        None => ((Lesson::default(), text), None),
        Some(Ok(draft)) => ((draft, text), None),
        // its text is not taken for known, and so not replaced
        Some(Err(error)) => ((Lesson::default(), None), Some(key::lesson_refused(Message::from(&error)))),
    }
}
