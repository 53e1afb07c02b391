//! The content of a session's link before it is packed, for lessons, which pack several together.

use super::{LinkError, MAX_LENGTH, envelope, framed, state_of};
use serde::{Deserialize, Serialize};

/// The version of a link's format, and the bytes that its payload holds.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(in crate::session) struct State {
    version: String,
    bytes: Vec<u8>,
}

impl State {
    /// The content of a link. Errors: there is none, or it is damaged.
    pub fn of(link: &str) -> Result<Self, LinkError> {
        let state = state_of(link).ok_or(LinkError::NoSession)?;
        let (version, payload) = state.split_once('.').unwrap_or((state, ""));
        Ok(Self { version: version.to_owned(), bytes: envelope::unpack(payload)? })
    }

    /// The link with this content. Errors: it is longer than a link may be.
    pub fn link(&self) -> Result<String, LinkError> {
        framed(&self.version, &self.bytes).ok_or(LinkError::TooLong { length: MAX_LENGTH + 1 })
    }
}
