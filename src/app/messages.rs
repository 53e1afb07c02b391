//! The messages that belong to neither side: an error, an offer, a notice. `message_bar` shows them.

use super::message_bar::MessageBar;
use super::panels::offer::Offer;
use crate::language::{Label, Message};

/// How long a notice is shown, in seconds: once it is noticed, two words are read in one second.
const NOTICE_SECONDS: f64 = 3.0;

/// A short text that confirms an action without a visible result.
#[derive(Debug, Clone, Copy)]
pub struct Notice {
    pub text: Label,
    /// The time at which it disappears, in seconds.
    pub until: f64,
}

impl Notice {
    /// A notice shown from `now` on, for `NOTICE_SECONDS`.
    pub fn new(text: Label, now: f64) -> Self {
        Self { text, until: now + NOTICE_SECONDS }
    }
}

/// The messages that belong to neither side.
#[derive(Default)]
pub struct Messages {
    /// The last error about an image, a saved file, a link or a locked control.
    pub common: Option<Message>,
    /// The picture that can be traced, or the file that can be shown as a map.
    pub offer: Option<Offer>,
    pub notice: Option<Notice>,
    /// The parts of the message and the offer that are shown below the pictures.
    pub bar: MessageBar,
}
