//! What is said to a person: values, and their words in each language.
//!
//! An error, a note or a message is a [`Message`]: a key with arguments. A [`Label`] is a key without any. The keys
//! are functions of [`key`], so that one that does not exist, or lacks an argument, does not compile. The errors of the
//! rooms below become messages in `errors`; the rooms above convert their own.
//!
//! The words stand in `en` and `de`, in the format of Project Fluent (`.ftl`), and are found by [`tr`] and [`say`] when
//! something is shown. Nothing that is put into words is taken apart again. Texts of others, such as the
//! system's, are arguments. Tests go through all keys in all languages.
//!
//! Without the feature `app` there are the values alone: the worker's answers carry them.

mod errors;
mod figures;
pub mod key;
mod message;
mod names;

pub use figures::{choices, method, title};
pub use message::{Label, Message, Value};
pub use names::{preset, side_heading, surface_preset};

#[cfg(feature = "app")]
mod words;
#[cfg(feature = "app")]
pub use words::{Language, current, number, say, set, tr};

#[cfg(all(test, feature = "app"))]
#[allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "tests")]
mod error_tests;
#[cfg(all(test, feature = "app"))]
#[allow(clippy::unwrap_used, reason = "tests")]
mod literals;
#[cfg(all(test, feature = "app"))]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
