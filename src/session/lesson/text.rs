//! Lessons as text files, which a teacher can write in a text editor:
//!
//! ```text
//! riemap lesson 1
//! Title: Angles stay
//!
//! https://example.org/#s=1.eJx…
//! Drag the green dot.
//! The squares stay squares.
//!
//! https://example.org/#s=2.eJx…
//! A caption may have empty lines.
//! ```
//!
//! A step begins at a line that is a link alone: no space, no angle bracket, `#s=` in it. Its caption is all that
//! follows, up to the next step. Between the first line and the first step are fields, `Name: value`; fields of later
//! versions are skipped. Line ends of all systems are read, and a byte order mark.

use super::{Lesson, LessonError, MAX_STEPS, Step, VERSION, tidied_caption, tidied_line};
use crate::session::link;

/// The first words of a file, before its version.
const MAGIC: &str = "riemap lesson";
/// The largest file that is read: [`MAX_STEPS`] links and captions of the maximal length, with room for addresses.
pub const MAX_BYTES: usize = 1 << 20;
/// The field of the title.
const TITLE: &str = "Title";

/// Whether the bytes of a file begin as a lesson does, of any version.
pub fn is_file(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    bytes.get(..MAGIC.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(MAGIC.as_bytes()))
}

/// The text of a lesson, [tidied](Lesson::tidied); `address` makes the address of a page from its fragment.
///
/// Errors: a text is too long, or there are too many steps.
pub fn write(lesson: &Lesson, address: impl Fn(&str) -> String) -> Result<String, LessonError> {
    let lesson = lesson.tidied();
    lesson.check()?;
    let mut text = format!("{MAGIC} {VERSION}\n{TITLE}: {}\n", lesson.title);
    for step in &lesson.steps {
        text.extend(["\n", &address(&step.link), "\n", &step.caption, "\n"]);
    }
    Ok(text)
}

/// Reads a lesson with at least one step.
pub fn read(bytes: &[u8]) -> Result<Lesson, LessonError> {
    read_draft(bytes)?.complete()
}

/// Reads a lesson that may have no step yet.
pub fn read_draft(bytes: &[u8]) -> Result<Lesson, LessonError> {
    if bytes.len() > MAX_BYTES {
        return Err(LessonError::TooLarge);
    }
    let text = std::str::from_utf8(bytes).map_err(|_| LessonError::NotText)?;
    let mut lines = text.trim_start_matches('\u{feff}').lines().enumerate().map(|(k, line)| (k + 1, line.trim()));
    let first = lines.find(|(_, line)| !line.is_empty()).map_or("", |(_, line)| line);
    check_version(first)?;
    let (mut title, mut parts) = (String::new(), Vec::<Part<'_>>::new());
    for (line, text) in lines {
        match parts.last_mut() {
            _ if begins_step(text) => parts.push(Part { line, link: text, caption: String::new() }),
            Some(part) => part.caption.extend([text, "\n"]),
            None => read_field(line, text, &mut title)?,
        }
    }
    if parts.len() > MAX_STEPS {
        return Err(LessonError::TooManySteps);
    }
    let steps = parts.into_iter().enumerate().map(|(k, part)| part.step(k)).collect::<Result<_, _>>()?;
    let lesson = Lesson { title, steps };
    lesson.check()?;
    Ok(lesson)
}

/// A step as it stands in a file.
struct Part<'a> {
    line: usize,
    link: &'a str,
    caption: String,
}

impl Part<'_> {
    fn step(self, index: usize) -> Result<Step, LessonError> {
        let Self { line, link, caption } = self;
        Step::from_link(link, tidied_caption(&caption)).map_err(|error| LessonError::Step {
            step: index + 1,
            line: Some(line),
            error,
        })
    }
}

/// Whether a line is the link of a session alone, perhaps damaged.
pub(super) fn begins_step(line: &str) -> bool {
    line.contains('#') && !line.starts_with('<') && !line.contains(char::is_whitespace) && link::is_link(line)
}

fn check_version(first: &str) -> Result<(), LessonError> {
    if !is_file(first.as_bytes()) {
        return Err(LessonError::NoLesson);
    }
    let version = first[MAGIC.len()..].trim();
    if version == VERSION.to_string() {
        return Ok(());
    }
    Err(LessonError::Version { found: version.chars().take(9).collect() })
}

/// Reads a line before the first step: an empty one, the title, or a field of a later version.
fn read_field(line: usize, text: &str, title: &mut String) -> Result<(), LessonError> {
    if text.is_empty() {
        return Ok(());
    }
    // "https://…" without "#s=" is a link that lost its end
    let field = text.split_once(':').filter(|(_, value)| !value.starts_with("//"));
    let (name, value) = field.ok_or(LessonError::Line { line })?;
    if name.trim_end().eq_ignore_ascii_case(TITLE) {
        *title = tidied_line(value);
    }
    Ok(())
}
