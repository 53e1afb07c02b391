//! What is played on the card: the guided tour, or a lesson.

use super::steps::steps;
use crate::family::Path;
use crate::language::tr;
use crate::session::Session;
use crate::session::lesson::Lesson;
use std::sync::Arc;

/// A sequence of steps.
#[derive(Debug, Clone)]
pub enum Course {
    /// The guided tour.
    Guided,
    /// A lesson.
    Lesson(Arc<Lesson>),
}

/// A step with its words, in the language of the screen or of the lesson.
#[derive(Debug, Clone, Copy)]
pub struct Stop<'a> {
    pub title: &'a str,
    pub text: &'a str,
    pub session: &'a Session,
    /// Whether the random walks run.
    pub walks: bool,
    /// The points that move one after another, each once around.
    pub motions: &'static [Path],
    /// Whether a circle with a cross is carried along.
    pub probes: bool,
}

impl Course {
    /// The number of steps.
    pub fn len(&self) -> usize {
        match self {
            Self::Guided => steps().len(),
            Self::Lesson(lesson) => lesson.steps.len(),
        }
    }

    /// Whether it is a lesson.
    pub fn is_lesson(&self) -> bool {
        matches!(self, Self::Lesson(_))
    }

    /// A step, counted from 0; `None` if there is no such step.
    pub fn stop(&self, step: usize) -> Option<Stop<'_>> {
        match self {
            Self::Guided => steps().get(step).map(|step| Stop {
                title: tr(step.title),
                text: tr(step.text),
                session: &step.session,
                walks: step.walks,
                motions: step.motions,
                probes: step.probes,
            }),
            Self::Lesson(lesson) => lesson.steps.get(step).map(|step| Stop {
                title: &lesson.title,
                text: &step.caption,
                session: step.session(),
                walks: false,
                motions: &[],
                probes: false,
            }),
        }
    }
}
