//! Texts shown to users: keys with arguments, and their translations.
//!
//! An error, a note or a message is a [`Message`]: a key with arguments. A [`Label`] is a key without arguments. The
//! keys are functions of [`key`], so that an unknown key or a missing argument is a compile error. Errors of
//! the rooms below are converted to messages in `errors`; the rooms above convert their own.
//!
//! The translations are in `en` and `de`, in the format of Project Fluent (`.ftl`). [`tr`] and [`say`] look them up
//! when a text is shown; a translated text is never parsed. Texts from elsewhere, such as the
//! operating system, are arguments. Tests look up all keys in all languages.
//!
//! Without the feature `app` only the values exist: workers send them in their responses.

mod errors;
mod figures;
pub mod key;
mod message;
mod names;

pub use figures::{choices, ladder_method, ladder_shape, method, title};
pub use message::{Label, Message, Value};
pub use names::{preset, side_heading, surface_preset};

#[cfg(feature = "app")]
mod words;
#[cfg(feature = "app")]
pub use words::{Language, current, decimal, number, say, set, significant, tr};

#[cfg(all(test, feature = "app"))]
#[allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "tests")]
mod error_tests;
#[cfg(all(test, feature = "app"))]
#[allow(clippy::unwrap_used, reason = "tests")]
mod literals;
#[cfg(all(test, feature = "app"))]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
