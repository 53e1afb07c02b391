//! An error shown beside the input that caused it, and its quick fix.

use crate::language::{Label, Message, key};
use crate::model::side::opened_file::OpenedFile;
use crate::outline::Outline;
use crate::worker::Sketch;
use std::sync::Arc;

/// An action that may resolve a user error.
#[derive(Debug, Clone, PartialEq)]
pub enum QuickFix {
    /// Prepare the same once more.
    Retry,
    /// Read the same file once more.
    ReadAgain(OpenedFile),
    /// Take the outline as the reader repaired it.
    Repaired(Box<Outline>),
    /// Make the repairs of the surface that are safe.
    RepairSurface,
}

impl QuickFix {
    /// The label of its button.
    pub fn label(&self) -> Label {
        match self {
            Self::Retry | Self::ReadAgain(_) => key::try_again(),
            Self::Repaired(_) => key::use_repaired(),
            Self::RepairSurface => key::repair(),
        }
    }
}

/// A message with its quick fix, if there is one.
#[derive(Debug, Clone, PartialEq)]
pub struct UserError {
    /// What is wrong, where, and what to do.
    pub text: Message,
    /// The action that the button offers.
    pub quick_fix: Option<QuickFix>,
    /// What is refused, with its faults marked.
    pub sketch: Option<Arc<Sketch>>,
}

impl UserError {
    /// Without a quick fix.
    pub fn new(text: Message) -> Self {
        Self { text, quick_fix: None, sketch: None }
    }
}
