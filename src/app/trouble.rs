//! What is said beside the input that caused it, and the way out that it offers.

use crate::outline::Outline;

/// What a click can do about a trouble.
#[derive(Debug, Clone, PartialEq)]
pub enum Remedy {
    /// Prepare the same once more.
    Retry,
    /// Take the outline as the reader repaired it.
    Repaired(Box<Outline>),
    /// Make the repairs of the surface that are safe.
    RepairSurface,
}

impl Remedy {
    /// What is written on its button.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Retry => "Try again",
            Self::Repaired(_) => "Use it repaired",
            Self::RepairSurface => "Repair it",
        }
    }
}

/// A message with its remedy, if there is one.
#[derive(Debug, Clone, PartialEq)]
pub struct Trouble {
    /// What is wrong, where, and what to do.
    pub text: String,
    /// What a click can do.
    pub remedy: Option<Remedy>,
}

impl Trouble {
    /// Without a remedy.
    pub fn new(text: String) -> Self {
        Self { text, remedy: None }
    }
}
