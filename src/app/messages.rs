//! The messages that belong to neither side: an error, an offer, a notice. `message_bar` shows them.

use super::message_bar::MessageBar;
use super::panels::offer::Offer;
use crate::language::{Label, Message};
use std::collections::VecDeque;

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
    /// What is offered and asked once the question that stands is answered, in order.
    later: VecDeque<Offer>,
    /// The parts of the message and the offer that are shown below the pictures.
    pub bar: MessageBar,
}

impl Messages {
    /// Only this message, if there is one.
    pub fn of(common: Option<Message>) -> Self {
        Self { common, ..Self::default() }
    }

    /// Offers something in the place of another offer; while a question waits for its answer, after that.
    pub fn suggest(&mut self, offer: Offer) {
        if self.offer.as_ref().is_some_and(Offer::is_question) {
            self.later.push_back(offer);
        } else {
            self.offer = Some(offer);
        }
    }

    /// The number of offers and questions that wait.
    #[cfg(test)]
    pub fn waiting(&self) -> usize {
        self.later.len()
    }

    /// Makes the offer that has waited the present one, where there is none.
    pub fn go_on(&mut self) {
        if self.offer.is_none() {
            self.offer = self.later.pop_front();
        }
    }
}
