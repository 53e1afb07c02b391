//! The address and the stored copy, which follow the session.

use crate::language::Message;
use crate::model::persistence::Settled;
use crate::session::{Session, file, link};

/// Sessions with more points are large and copied at most once in [`COPY_SECONDS`].
/// 20,000 points take 2 ms to write on a desktop, and several times as long in a browser, which also has to store them.
pub const LARGE_POINTS: usize = 20_000;
/// The time between copies of a large session, in seconds: the most work that a crash can lose.
pub const COPY_SECONDS: f64 = 5.0;

/// Steps share their outlines mostly: those of this many steps take about as long to write as one outline.
const STEPS_TO_ONE: usize = 8;

/// The updates of address and copy that are pending.
#[derive(Debug, Default)]
pub struct Public {
    /// The fragment last written, or that of an opened link that is kept; the user may have edited the address since.
    address: Option<String>,
    owes_address: bool,
    owes_copy: bool,
    copied_at: Option<f64>,
    has_complained: bool,
}

impl Public {
    /// Notes that the session has changed; after a change `by_person` the copy is updated too.
    pub fn note_change(&mut self, by_person: bool) {
        self.owes_address = true;
        self.owes_copy |= by_person;
    }

    /// Keeps `link` in the address.
    pub fn stay_at(&mut self, link: Option<String>) {
        self.address = link;
        self.owes_address = false;
    }

    /// The fragment of the session that settled last, or of the opened link that is kept; `None` if there is no link.
    pub fn address(&self) -> Option<&str> {
        self.address.as_deref()
    }

    /// The fragment to restore after an edited one was refused; if there is none, the address follows the session.
    pub fn correct_address(&mut self) -> Option<String> {
        self.owes_address |= self.address.is_none();
        self.address.clone()
    }

    /// Carries out pending updates at a time in seconds.
    pub fn pay(&mut self, session: &Session, points_of_steps: usize, now: f64) -> Settled {
        let mut settled = Settled::default();
        if std::mem::take(&mut self.owes_address) {
            // if there is no link, the command "Copy link" reports why
            settled.address = link::encode(session).ok().map(|encoded| encoded.fragment);
            self.address.clone_from(&settled.address);
        }
        if !self.owes_copy {
            return settled;
        }
        let is_large = session.loaded_points().max(points_of_steps / STEPS_TO_ONE) > LARGE_POINTS;
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

    /// The pending copy, whether it is due or not.
    pub fn overdue_copy(&mut self, session: &Session) -> Option<String> {
        std::mem::take(&mut self.owes_copy).then(|| file::write_compact(session).ok())?
    }

    /// The message that something could not be stored; only the first time.
    pub fn not_kept(&mut self, message: Message) -> Option<Message> {
        let is_news = !std::mem::replace(&mut self.has_complained, true);
        is_news.then_some(message)
    }
}
