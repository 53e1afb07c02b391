//! The keys of all texts as functions: labels without arguments, messages with arguments.
//!
//! A key is the name of its function; the `.ftl` files of each language use the same name.

/// Defines a function for each label, and the list of all.
macro_rules! keys_of_labels {
    ($($key:ident),* $(,)?) => {
        $(
            #[doc = concat!("The label `", stringify!($key), "`.")]
            pub const fn $key() -> Label {
                Label::new(stringify!($key))
            }
        )*

        /// The labels of this file.
        #[cfg(test)]
        pub(super) const LABELS: &[Label] = &[$($key()),*];
    };
}

/// Defines a function for each message with its arguments, and the list of all names.
macro_rules! keys_of_messages {
    ($($key:ident($($argument:ident),+));* $(;)?) => {
        $(
            #[doc = concat!("The message `", stringify!($key), "`.")]
            pub fn $key($($argument: impl Into<Value>),+) -> Message {
                Message::new(stringify!($key), vec![$((stringify!($argument), $argument.into())),+])
            }
        )*

        /// The messages of this file with the names of their arguments.
        #[cfg(test)]
        pub(super) const MESSAGES: &[(&str, &[&str])] = &[$((stringify!($key), &[$(stringify!($argument)),+])),*];
    };
}

mod labels;
mod messages;

pub use labels::*;
pub use messages::*;

use super::{Label, Message, Value};

/// All labels.
#[cfg(test)]
pub fn all_labels() -> impl Iterator<Item = Label> {
    labels::LABELS.iter().chain(messages::LABELS).copied()
}

/// All messages with the names of their arguments.
#[cfg(test)]
pub fn all_messages() -> impl Iterator<Item = (&'static str, &'static [&'static str])> {
    labels::MESSAGES.iter().chain(messages::MESSAGES).copied()
}
