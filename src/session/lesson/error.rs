//! Why a step cannot be made, and why a lesson cannot be read or written.

use super::{MAX_BYTES, MAX_CAPTION, MAX_STEPS, MAX_TITLE, VERSION};
use crate::conformal::Side;
use crate::session::link::{LeftOut, LinkError, MAX_LENGTH};

/// Why a session or a link cannot be a step.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StepError {
    /// The link cannot be opened.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// No link holds the outline.
    #[error(transparent)]
    LeftOut(LeftOut),
    /// The link only names an outline.
    #[error("its link only names the outline \"{name}\" of the {side}, which travels as a file")]
    MissingOutline {
        /// The side of the session that has the outline.
        side: Side,
        /// The name of the outline.
        name: String,
    },
    /// It shows a surface from a file.
    #[error("the surface \"{name}\" comes from a file, which no link holds")]
    SurfaceFile {
        /// The name of the file.
        name: String,
    },
    /// Its pattern is the user's own picture.
    #[error("its pattern is an own picture, which no link holds")]
    OwnPicture,
    /// Its caption is too long.
    #[error("the caption has {length} characters where {MAX_CAPTION} are the most")]
    LongCaption {
        /// The number of characters.
        length: usize,
    },
}

/// Why a lesson cannot be read or written.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LessonError {
    /// The file has more bytes than a lesson can have.
    #[error("the file is too large for a lesson: {} KiB are the most", MAX_BYTES >> 10)]
    TooLarge,
    /// The file is not UTF-8.
    #[error("the file is not plain text (UTF-8)")]
    NotText,
    /// It has another first line, or the link has no lesson.
    #[error("this is not a lesson: its first line is not \"riemap lesson {VERSION}\"")]
    NoLesson,
    /// It is of a version that this program does not know.
    #[error("the lesson is of version {found}, made by a newer riemap; this one opens version {VERSION}")]
    Version {
        /// Its version, or the beginning of what is written there instead.
        found: String,
    },
    /// A line before the first step is neither empty nor a field such as "Title: …".
    #[error("line {line}: expected \"Title: …\" or the link of the first step, with #s=… in it")]
    Line {
        /// The number of the line, from 1.
        line: usize,
    },
    /// There is no step in it.
    #[error("the lesson has no step: a step is a line with a link, with #s=… in it, and its caption below")]
    NoSteps,
    /// It has more steps than a lesson can have.
    #[error("the lesson has more than {MAX_STEPS} steps")]
    TooManySteps,
    /// The title is too long.
    #[error("the title has {length} characters where {MAX_TITLE} are the most")]
    LongTitle {
        /// The number of characters.
        length: usize,
    },
    /// A step cannot be used.
    #[error("step {step}{}: {error}", line.map(|line| format!(" (line {line})")).unwrap_or_default())]
    Step {
        /// The number of the step, from 1.
        step: usize,
        /// The line of its link, from 1; `None` outside of files.
        line: Option<usize>,
        /// The cause.
        error: StepError,
    },
    /// The link was cut off or changed.
    #[error(transparent)]
    Link(LinkError),
    /// All steps together are too long for a link.
    #[error("the lesson is too long for a link, which has {MAX_LENGTH} characters at most: save it as a file")]
    TooLongForLink,
}

impl LessonError {
    /// The error of the step with this index, outside of a file.
    pub(super) fn of_step(index: usize, error: StepError) -> Self {
        Self::Step { step: index + 1, line: None, error }
    }
}
