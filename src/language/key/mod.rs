//! The keys of all words, as functions: of labels without arguments, of messages with them.
//!
//! A key is the name of its function. Its words stand under the same name in the files of each language.

/// Functions that make labels, and the list of them.
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

/// Functions that make messages from their arguments, and the list of their names.
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
