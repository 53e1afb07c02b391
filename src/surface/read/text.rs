//! Lines and words of a text file; comments may contain bytes that are not UTF-8.

use super::{Fault, Item, Place, SurfaceError};
use crate::geometry::DVec3;

/// A line that is neither blank nor only a comment.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line<'a> {
    /// Line number, from 1.
    pub number: usize,
    bytes: &'a [u8],
}

/// The number of bytes from which the kind of line end is determined.
const BEGINNING: usize = 1 << 16;

/// The byte that ends the lines of a text: a carriage return if more of them stand alone than there are line feeds
/// (a few stray ones of either kind do no harm); otherwise a line feed, with or without a carriage return before it.
pub(super) fn line_end(text: &[u8]) -> u8 {
    let beginning = &text[..text.len().min(BEGINNING)];
    let count = |wanted: &dyn Fn(usize) -> bool| (0..beginning.len()).filter(|&k| wanted(k)).count();
    let returns = count(&|k| beginning[k] == b'\r' && text.get(k + 1) != Some(&b'\n'));
    let feeds = count(&|k| beginning[k] == b'\n');
    if returns > feeds { b'\r' } else { b'\n' }
}

/// A word as a number; NaN and infinity are numbers here, also as some programs write them, `-nan(ind)` and `1.#INF`.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    let is_none = || text.contains(".#") || text.to_ascii_lowercase().contains("nan(");
    text.parse().ok().or_else(|| is_none().then_some(f64::NAN))
}

/// The lines of `bytes` that contain more than blanks and a comment (from `#` on, but for `1.#INF`).
pub(super) fn lines(bytes: &[u8]) -> impl Iterator<Item = Line<'_>> {
    let end = line_end(bytes);
    let numbered = bytes.split(move |&b| b == end).enumerate();
    numbered.map(|(k, line)| Line::of(k + 1, line)).filter(|line| !line.bytes.is_empty())
}

/// The part of a line before its comment, which no "." precedes: "1.#QNAN" is a number.
pub(super) fn without_comment(line: &[u8]) -> &[u8] {
    let begins = |k: &usize| line[*k] == b'#' && (*k == 0 || line[*k - 1] != b'.');
    &line[..(0..line.len()).find(begins).unwrap_or(line.len())]
}

impl<'a> Line<'a> {
    /// The line without its comment, and without blanks around it.
    pub(super) fn of(number: usize, line: &'a [u8]) -> Self {
        Self { number, bytes: without_comment(line).trim_ascii() }
    }

    pub(super) fn place(&self) -> Place {
        Place::Line(self.number)
    }

    pub(super) fn words(&self) -> impl Iterator<Item = &'a [u8]> + use<'a> {
        self.bytes.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
    }

    /// The next three words as a position, which may be NaN or infinite.
    pub(super) fn point(&self, words: &mut impl Iterator<Item = &'a [u8]>) -> Result<DVec3, SurfaceError> {
        let mut coordinates = [0.0; 3];
        for (value, name) in coordinates.iter_mut().zip(["x", "y", "z"]) {
            let missing = || SurfaceError::missing(self.place(), Item::Coordinate(name));
            *value = self.number_in(words.next().ok_or_else(missing)?)?;
        }
        Ok(DVec3::from_array(coordinates))
    }

    /// A word as a number; NaN and infinity are numbers here.
    pub(super) fn number_in(&self, word: &[u8]) -> Result<f64, SurfaceError> {
        number(word).ok_or_else(|| SurfaceError::NotANumber { place: self.place(), found: shown(word) })
    }

    /// A word as a whole number.
    pub(super) fn integer_in(&self, word: &[u8]) -> Result<i64, SurfaceError> {
        let number = std::str::from_utf8(word).ok().and_then(|text| text.parse().ok());
        number.ok_or_else(|| SurfaceError::NotANumber { place: self.place(), found: shown(word) })
    }

    /// The next word as a count.
    pub(super) fn count(&self, words: &mut impl Iterator<Item = &'a [u8]>, what: Item) -> Result<usize, SurfaceError> {
        let word = words.next().ok_or_else(|| SurfaceError::missing(self.place(), what))?;
        let negative = || SurfaceError::malformed(self.place(), Fault::Count { what, found: shown(word) });
        usize::try_from(self.integer_in(word)?).map_err(|_| negative())
    }
}

/// The first characters of a word, for messages.
pub(super) fn shown(word: &[u8]) -> String {
    String::from_utf8_lossy(word).chars().filter(|c| !c.is_control()).take(24).collect()
}
