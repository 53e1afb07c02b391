//! Lessons: a title, and an ordered list of steps, each a session with a caption. A step shows exactly what its link
//! shows: what a link cannot hold is refused when the step is made or read, with the cause.
//!
//! | content | file |
//! |---|---|
//! | the text file, for a text editor | `text` |
//! | the link, `#lesson=1.…` | `fragment` |
//! | why a step or a lesson cannot be used | `error` |
//!
//! Guarantees: for any input, reading gives a lesson within the limits of this file or an error that names the line or
//! the step; it does not panic. Reading what was written gives the same lesson, [tidied](Lesson::tidied).

mod error;
mod fragment;
mod text;

pub use error::{LessonError, StepError};
pub use fragment::{decode, encode, is_link};
pub use text::{MAX_BYTES, is_file, read, read_draft, write};

use super::link::{self, Decoded, ShortenedOutline};
use super::{Session, SurfaceShape};
use crate::conformal::Side;

/// The version of files and links that is written and read.
pub const VERSION: u32 = 1;
/// The extension of files, without the dot: text editors open them.
pub const EXTENSION: &str = "txt";
/// The most steps: more than two hours of class show.
pub const MAX_STEPS: usize = 60;
/// The most characters of a title, which has one line on the card.
pub const MAX_TITLE: usize = 120;
/// The most characters of a caption: four cards of a presentation.
pub const MAX_CAPTION: usize = 2000;

/// A title and steps, as they are edited; the texts may be untidy.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Lesson {
    /// The title, in one line.
    pub title: String,
    /// The steps, in order.
    pub steps: Vec<Step>,
}

/// A session and the words about it.
///
/// Invariant: `link`, the part of an address after `#`, decodes to `session`, without a file besides.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    session: Session,
    link: String,
    /// What there is to see, in plain text of any number of lines.
    pub caption: String,
}

impl Step {
    /// The step that shows what the link of `session` shows, and the outlines that have fewer points there.
    ///
    /// Errors: the session needs something that a link does not hold.
    pub fn of(session: &Session, caption: String) -> Result<(Self, Vec<ShortenedOutline>), StepError> {
        let encoded = link::encode(session).map_err(link::LinkError::from)?;
        if let Some(outline) = encoded.left_out.into_iter().next() {
            return Err(StepError::LeftOut(outline));
        }
        Ok((Self::from_link(&encoded.fragment, caption)?, encoded.shortened))
    }

    /// The step that shows a link. Errors: the link cannot be opened, or not without a file besides; a long caption.
    pub fn from_link(link: &str, caption: String) -> Result<Self, StepError> {
        let Decoded { session, missing } = link::decode(link)?;
        if let Some(outline) = missing.into_iter().next() {
            return Err(StepError::MissingOutline { side: outline.side, name: outline.name });
        }
        for side in Side::BOTH {
            if let Some(SurfaceShape::File { name }) = session.surface(side).map(|surface| &surface.spec.shape) {
                return Err(StepError::SurfaceFile { name: name.clone() });
            }
        }
        if session.shows_picture() {
            return Err(StepError::OwnPicture);
        }
        let length = caption.chars().count();
        if length > MAX_CAPTION {
            return Err(StepError::LongCaption { length });
        }
        Ok(Self { session, link: link::alone(link), caption })
    }

    /// The session.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// The part of an address that shows the session.
    pub fn link(&self) -> &str {
        &self.link
    }
}

impl Lesson {
    /// The lesson as files and links hold it: no free space around lines, no empty lines around captions, no control
    /// characters. In a caption a line that is the link of a session alone has angle brackets, since it would begin a
    /// step in a file.
    #[must_use]
    pub fn tidied(&self) -> Self {
        let step = |step: &Step| Step { caption: tidied_caption(&step.caption), ..step.clone() };
        Self { title: tidied_line(&self.title.replace('\n', " ")), steps: self.steps.iter().map(step).collect() }
    }

    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.title.trim().is_empty() && self.steps.is_empty()
    }

    /// Checks that the texts are within their limits, and that there are not too many steps.
    fn check(&self) -> Result<(), LessonError> {
        let length = self.title.chars().count();
        if length > MAX_TITLE {
            return Err(LessonError::LongTitle { length });
        }
        if self.steps.len() > MAX_STEPS {
            return Err(LessonError::TooManySteps);
        }
        let long = self.steps.iter().map(|step| step.caption.chars().count()).enumerate();
        match long.into_iter().find(|(_, length)| *length > MAX_CAPTION) {
            Some((k, length)) => Err(LessonError::of_step(k, StepError::LongCaption { length })),
            None => Ok(()),
        }
    }

    /// The lesson if it has a step.
    fn complete(self) -> Result<Self, LessonError> {
        if self.steps.is_empty() { Err(LessonError::NoSteps) } else { Ok(self) }
    }
}

fn tidied_line(line: &str) -> String {
    line.chars().filter(|character| !character.is_control()).collect::<String>().trim().to_owned()
}

fn tidied_caption(caption: &str) -> String {
    let line = |line: &str| {
        let line = tidied_line(line);
        if text::begins_step(&line) { format!("<{line}>") } else { line }
    };
    let lines: Vec<String> = caption.split('\n').map(line).collect();
    lines.join("\n").trim_matches('\n').to_owned()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
