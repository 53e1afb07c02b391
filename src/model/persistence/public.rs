//! What follows the session outside of the app: the address, and the copy for the next start.

use crate::language::{Message, key};
use crate::model::persistence::Settled;
use crate::session::{Session, file, link};

/// From this many points on a session is large: its copy is made at most once in [`COPY_SECONDS`].
/// 20,000 points take 2 ms to write on a desktop, and several times that in a browser, which also has to store them.
pub const LARGE_POINTS: usize = 20_000;
/// How often a large session is copied, in seconds: what a crash costs at most.
pub const COPY_SECONDS: f64 = 5.0;

/// What is owed to the address and to the copy.
#[derive(Debug, Default)]
pub struct Public {
    /// What the address shows, or a link that was opened and waits: unless a person has written something else there.
    address: Option<String>,
    owes_address: bool,
    owes_copy: bool,
    copied_at: Option<f64>,
    has_complained: bool,
}

impl Public {
    /// The session has changed; `by_person`: the copy follows too.
    pub fn note_change(&mut self, by_person: bool) {
        self.owes_address = true;
        self.owes_copy |= by_person;
    }

    /// The address shows `link`, and goes on to.
    pub fn stay_at(&mut self, link: Option<String>) {
        self.address = link;
        self.owes_address = false;
    }

    /// The address shows something that was refused: what it showed before; if nothing, it will follow the session.
    pub fn correct_address(&mut self) -> Option<String> {
        self.owes_address |= self.address.is_none();
        self.address.clone()
    }

    /// Pays what is owed, at a time in seconds.
    pub fn pay(&mut self, session: &Session, now: f64) -> Settled {
        let mut settled = Settled::default();
        if std::mem::take(&mut self.owes_address) {
            // Copy link says why there is none.
            settled.address = link::encode(session).ok().map(|encoded| encoded.fragment);
            self.address.clone_from(&settled.address);
        }
        if !self.owes_copy {
            return settled;
        }
        let is_large = session.loaded_points() > LARGE_POINTS;
        let due = self.copied_at.filter(|_| is_large).map_or(0.0, |at| at + COPY_SECONDS - now);
        if due > 0.0 {
            settled.copy_due = Some(due);
        } else {
            self.owes_copy = false;
            self.copied_at = Some(now);
            settled.copy = file::write_compact(session).ok();
        }
        settled
    }

    /// What to say about a copy that could not be kept: once is enough.
    pub fn not_kept(&mut self, reason: Message) -> Option<Message> {
        let is_news = !std::mem::replace(&mut self.has_complained, true);
        is_news.then(|| key::session_not_kept(reason))
    }
}
