//! What outlives a frame: the steps that can be undone, the address that carries the session, the
//! copy that the next start finds.
//!
//! All of them take in the session when it has come to rest: nothing is held, nothing is being prepared.

use crate::platform;
use crate::session::{History, Session, file, link};

/// The keeper of sessions.
#[derive(Debug)]
pub struct Keeper {
    history: History,
    /// Why the address does not carry all of the session.
    left_out: Option<String>,
    /// No session has come to rest yet.
    is_new: bool,
    /// Whether the address and the kept copy follow, or the history alone.
    is_public: bool,
}

impl Keeper {
    /// Begins at `session`; `is_public`: the address and the copy for the next start follow it.
    pub fn new(session: Session, is_public: bool) -> Self {
        Self { history: History::new(session), left_out: None, is_new: true, is_public }
    }

    /// Undo and redo.
    pub fn history(&self) -> &History {
        &self.history
    }

    /// The session before.
    pub fn undo(&mut self) -> Option<Session> {
        self.history.undo().cloned()
    }

    /// The session after.
    pub fn redo(&mut self) -> Option<Session> {
        self.history.redo().cloned()
    }

    /// Why a link does not carry all of the session.
    pub fn left_out(&self) -> Option<&str> {
        self.left_out.as_deref()
    }

    /// Takes in a session that has come to rest; the first one is where the history begins.
    pub fn settle(&mut self, session: &Session) {
        let is_first = std::mem::take(&mut self.is_new);
        if is_first {
            self.history = History::new(session.clone());
        }
        if !(is_first || self.history.settle(session)) || !self.is_public {
            return;
        }
        // What is left out of the link is in the copy.
        if let Ok(text) = file::write(session) {
            platform::remember(&text);
        }
        match link::encode(session) {
            Ok(encoded) => {
                self.left_out = words(&encoded);
                platform::show_link(&encoded.fragment);
            }
            Err(error) => self.left_out = Some(error.to_string()),
        }
    }
}

/// What has to travel as a file, in words.
fn words(encoded: &link::Encoded) -> Option<String> {
    let all = encoded.left_out.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ");
    (!all.is_empty()).then_some(all)
}

/// The session to start with: that of the address, else the one that was kept, else the default; and what went wrong.
///
/// After a reload the address is that of the kept session, which has what a link may have to leave out.
pub fn first_session() -> (Session, Option<String>) {
    let kept = platform::remembered().and_then(|text| file::read(text.as_bytes()).ok());
    let Some(address) = platform::link() else { return (kept.unwrap_or_default(), None) };
    let is_its_own =
        |kept: &Session| link::encode(kept).is_ok_and(|encoded| address.trim_start_matches('#') == encoded.fragment);
    if let Some(kept) = kept.filter(is_its_own) {
        return (kept, None);
    }
    match link::decode(&address) {
        Ok(decoded) => {
            let missing = missing(&decoded);
            (decoded.session, missing)
        }
        Err(error) => (Session::default(), Some(format!("The link could not be opened: {error}"))),
    }
}

/// What a link says that it does not carry.
pub fn missing(decoded: &link::Decoded) -> Option<String> {
    let each = decoded.missing.iter().map(|missing| {
        format!("The link does not carry the {}'s outline \"{}\": open its file there.", missing.side, missing.name)
    });
    let all = each.collect::<Vec<_>>().join(" ");
    (!all.is_empty()).then_some(all)
}
