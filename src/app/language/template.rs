//! Texts with placeholders: filled, and found again in finished texts.

use std::cmp::Reverse;
use std::fmt::Display;

/// With less of its own than this a template is weak: "line {0}" fits too much.
const STRONG: usize = 8;

/// `template` with `parts` in the places of `{0}`, `{1}`…
pub fn fill<T: Display + ?Sized>(template: &str, parts: &[&T]) -> String {
    let mut result = String::with_capacity(template.len() + 8 * parts.len());
    for piece in pieces(template) {
        match piece {
            Piece::Text(text) => result.push_str(text),
            Piece::Hole(k) => {
                if let Some(part) = parts.get(k) {
                    result.push_str(&part.to_string());
                }
            }
        }
    }
    result
}

/// A text with placeholders that can be found in finished texts. In their order the one that says the most
/// itself is the first.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Template {
    /// How many bytes are its own.
    own: Reverse<usize>,
    pieces: Vec<Piece<String>>,
    value: String,
}

/// What stands in a place of a finished text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part<'t> {
    /// The text.
    pub text: &'t str,
    /// It stands in quotes: a name, which is the same in every language.
    pub is_name: bool,
}

impl Template {
    /// `None`: it has no placeholders, or no word besides them.
    pub fn new(key: &str, value: &str) -> Option<Self> {
        let pieces: Vec<Piece<String>> = pieces(key).map(Piece::owned).collect();
        let own: String = pieces.iter().filter_map(Piece::text).collect();
        let has_words = own.chars().filter(|letter| letter.is_alphabetic()).count() > 1;
        let is_one = has_words && pieces.iter().any(|piece| piece.text().is_none());
        is_one.then(|| Self { own: Reverse(own.len()), pieces, value: value.into() })
    }

    /// Whether it says so little itself that what stands in its places has to be known.
    pub fn is_weak(&self) -> bool {
        self.own.0 < STRONG
    }

    /// The translation.
    pub fn value(&self) -> &str {
        &self.value
    }

    /// What stands in its places, by number, if `text` is this template filled. Of several ways a place at the
    /// beginning is taken as long as can be ("a.ply: line 3" before ": …"), the others as short as can be.
    pub fn parts<'t>(&self, text: &'t str) -> Option<Vec<Part<'t>>> {
        let mut found = Vec::new();
        let fits = match self.pieces.as_slice() {
            [Piece::Hole(k), Piece::Text(own), rest @ ..] => {
                text.rmatch_indices(own).any(|(at, _)| fits_after(*k, own, at, rest, text, &mut found))
            }
            pieces => fits(pieces, text, &mut found),
        };
        let names = holes_in_quotes(&self.pieces);
        let mut parts: Vec<(usize, Part<'t>)> =
            found.into_iter().zip(names).map(|((k, text), is_name)| (k, Part { text, is_name })).collect();
        parts.sort_by_key(|(k, _)| *k);
        fits.then(|| parts.into_iter().map(|(_, part)| part).collect())
    }
}

/// Whether `text` is `pieces` filled; what stands in the places is added to `found`.
fn fits<'t>(pieces: &[Piece<String>], text: &'t str, found: &mut Vec<(usize, &'t str)>) -> bool {
    match pieces {
        [] => text.is_empty(),
        [Piece::Text(own), rest @ ..] => text.strip_prefix(own.as_str()).is_some_and(|text| fits(rest, text, found)),
        [Piece::Hole(k)] => {
            found.push((*k, text));
            true
        }
        [Piece::Hole(k), Piece::Text(own), rest @ ..] => {
            text.match_indices(own).any(|(at, _)| fits_after(*k, own, at, rest, text, found))
        }
        [Piece::Hole(_), Piece::Hole(_), ..] => false, // nothing says where the first ends
    }
}

/// The same for place `k` and its `own` text, which is at `at`, and the `rest`.
fn fits_after<'t>(
    k: usize,
    own: &str,
    at: usize,
    rest: &[Piece<String>],
    text: &'t str,
    found: &mut Vec<(usize, &'t str)>,
) -> bool {
    let before = found.len();
    found.push((k, &text[..at]));
    let fits = fits(rest, &text[at + own.len()..], found);
    if !fits {
        found.truncate(before);
    }
    fits
}

/// Of each place whether a quotation mark stands before it.
fn holes_in_quotes(pieces: &[Piece<String>]) -> impl Iterator<Item = bool> {
    let before = std::iter::once(None).chain(pieces.iter().map(Some));
    let holes = before.zip(pieces).filter(|(_, piece)| piece.text().is_none());
    holes.map(|(before, _)| before.and_then(Piece::text).is_some_and(|text| text.ends_with('"')))
}

#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
enum Piece<T> {
    Text(T),
    Hole(usize),
}

impl Piece<&str> {
    fn owned(self) -> Piece<String> {
        match self {
            Self::Text(text) => Piece::Text(text.into()),
            Self::Hole(k) => Piece::Hole(k),
        }
    }
}

impl Piece<String> {
    fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self { Some(text) } else { None }
    }
}

fn pieces(template: &str) -> impl Iterator<Item = Piece<&str>> {
    let mut rest = template;
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        if let Some((k, after)) = hole(rest) {
            rest = after;
            return Some(Piece::Hole(k));
        }
        let later = rest.char_indices().skip(1).find(|(at, _)| hole(&rest[*at..]).is_some());
        let (text, after) = rest.split_at(later.map_or(rest.len(), |(at, _)| at));
        rest = after;
        Some(Piece::Text(text))
    })
}

/// The number of the placeholder that `text` begins with, and what follows it.
fn hole(text: &str) -> Option<(usize, &str)> {
    let (number, after) = text.strip_prefix('{')?.split_once('}')?;
    Some((number.parse().ok()?, after))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn texts<'t>(key: &str, text: &'t str) -> Option<Vec<&'t str>> {
        let parts = Template::new(key, "").unwrap().parts(text)?;
        Some(parts.into_iter().map(|part| part.text).collect())
    }

    #[test]
    fn places_are_filled_by_number() {
        assert_eq!(fill("{1} before {0}, {0}; {x} {", &[&1, &2]), "2 before 1, 1; {x} {");
        assert_eq!(fill::<i32>("{0} missing", &[]), " missing");
    }

    #[test]
    fn what_stands_in_the_places_is_found() {
        assert_eq!(texts("point {0} at ({1}, {2})", "point 3 at (0.4, 1)"), Some(vec!["3", "0.4", "1"]));
        assert_eq!(texts("{1} after {0}", "a after b"), Some(vec!["b", "a"]), "by number");
        assert_eq!(texts("point {0} is lost", "point 3 is found"), None);
        assert_eq!(texts("{0}: {1} is lost", "a: b: c is lost"), Some(vec!["a: b", "c"]), "long at the beginning");
        assert_eq!(texts("lost: {0}: {1}", "lost: a: b: c"), Some(vec!["a", "b: c"]), "short elsewhere");
        assert_eq!(texts("{0} is lost", "what is lost is lost"), Some(vec!["what is lost"]), "the end counts");
        assert_eq!(texts("{0}{1} is lost", "ab is lost"), None, "nothing says where the first ends");
    }

    #[test]
    fn names_stand_in_quotes() {
        let parts = Template::new("the {0} \"{1}\" is lost", "").unwrap();
        let names: Vec<bool> =
            parts.parts("the disk \"disk\" is lost").unwrap().iter().map(|part| part.is_name).collect();
        assert_eq!(names, [false, true]);
    }

    #[test]
    fn a_template_has_a_place_and_a_word() {
        for key in ["no place", "{0}: {1}", "{0} x"] {
            assert_eq!(Template::new(key, ""), None, "{key}");
        }
        assert!(
            Template::new("line {0}", "").unwrap().is_weak() && !Template::new("triangle {0}", "").unwrap().is_weak()
        );
    }
}
