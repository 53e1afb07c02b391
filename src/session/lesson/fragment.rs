//! Lessons in one link: `lesson=1.` and, packed as a session's link is, the states of the steps' links with their
//! captions. All are deflated together, so that an outline that several steps show takes its space once.

use super::{Lesson, LessonError, MAX_STEPS, Step, StepError, VERSION, tidied_caption, tidied_line};
use crate::session::link::{self, LinkError, MAX_LENGTH, State};
use serde::{Deserialize, Serialize};

/// The prefix of a lesson among the parts of a fragment.
const KEY: &str = "lesson=";

#[derive(Serialize, Deserialize)]
struct Wired {
    title: String,
    steps: Vec<WiredStep>,
}

#[derive(Serialize, Deserialize)]
struct WiredStep {
    state: State,
    caption: String,
}

/// The part of an address after `#` that plays the lesson, [tidied](Lesson::tidied).
///
/// Errors: it has no step, a text is too long, or the whole is longer than [`MAX_LENGTH`].
pub fn encode(lesson: &Lesson) -> Result<String, LessonError> {
    let lesson = lesson.tidied().complete()?;
    lesson.check()?;
    let wired = |(k, step): (usize, &Step)| {
        let state = State::of(&step.link).map_err(|error| LessonError::of_step(k, error.into()))?;
        Ok(WiredStep { state, caption: step.caption.clone() })
    };
    let steps = lesson.steps.iter().enumerate().map(wired).collect::<Result<_, LessonError>>()?;
    let bytes = postcard::to_allocvec(&Wired { title: lesson.title, steps }).ok();
    let payload = bytes.and_then(|bytes| link::pack(&bytes)).ok_or(LessonError::TooLongForLink)?;
    let fragment = format!("{KEY}{VERSION}.{payload}");
    if fragment.len() > MAX_LENGTH { Err(LessonError::TooLongForLink) } else { Ok(fragment) }
}

/// Whether a text contains the part that [`decode`] reads.
pub fn is_link(text: &str) -> bool {
    lesson_of(text).is_some()
}

/// Decodes a link: a whole address, its fragment with or without `#`, or one part of the fragment.
pub fn decode(text: &str) -> Result<Lesson, LessonError> {
    let lesson = lesson_of(text).ok_or(LessonError::NoLesson)?;
    if lesson.len() > MAX_LENGTH {
        return Err(LessonError::Link(LinkError::TooLong { length: lesson.len() }));
    }
    let (version, payload) = lesson.split_once('.').unwrap_or((lesson, ""));
    if version != VERSION.to_string() {
        return Err(unknown_version(version));
    }
    let bytes = link::unpack(payload).map_err(LessonError::Link)?;
    let Wired { title, steps } = link::whole(&bytes).map_err(LessonError::Link)?;
    if steps.len() > MAX_STEPS {
        return Err(LessonError::TooManySteps);
    }
    let step = |(k, WiredStep { state, caption }): (usize, WiredStep)| {
        let link = state.link().map_err(StepError::from);
        let step = link.and_then(|link| Step::from_link(&link, tidied_caption(&caption)));
        step.map_err(|error| LessonError::of_step(k, error))
    };
    let steps = steps.into_iter().enumerate().map(step).collect::<Result<_, _>>()?;
    let lesson = Lesson { title: tidied_line(&title), steps };
    lesson.check()?;
    lesson.complete()
}

fn unknown_version(version: &str) -> LessonError {
    let is_number = !version.is_empty() && version.bytes().all(|byte| byte.is_ascii_digit());
    if is_number {
        LessonError::Version { found: version.chars().take(9).collect() }
    } else {
        LessonError::Link(LinkError::Damaged)
    }
}

/// The text after `lesson=` in the fragment; without `#` the whole text is the fragment.
fn lesson_of(link: &str) -> Option<&str> {
    let link = link.trim();
    let fragment = link.split_once('#').map_or(link, |(_, fragment)| fragment);
    fragment.split('&').find_map(|part| part.strip_prefix(KEY))
}
