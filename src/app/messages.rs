//! What there is to say about both sides: a message, an offer, a notice; `message_bar` shows them.

use super::message_bar::MessageBar;
use super::panels::offer::Offer;
use crate::language::{Label, Message};

/// How long a notice is shown, in seconds: two words are read in one, once they have been seen.
const NOTICE_SECONDS: f64 = 3.0;

/// What has gone well and cannot be seen.
#[derive(Debug, Clone, Copy)]
pub struct Notice {
    pub text: Label,
    /// When it need not be said any more, in seconds.
    pub until: f64,
}

impl Notice {
    /// A notice that begins `now`.
    pub fn new(text: Label, now: f64) -> Self {
        Self { text, until: now + NOTICE_SECONDS }
    }
}

/// The messages that belong to neither side.
#[derive(Default)]
pub struct Messages {
    /// What is wrong and belongs to neither side: an image, a file that was to be saved, a link, what is locked.
    pub common: Option<Message>,
    /// The picture that can be traced now.
    pub offer: Option<Offer>,
    pub notice: Option<Notice>,
    /// What of the message and the offer is shown below the pictures.
    pub bar: MessageBar,
}
