//! Texts with placeholders: filled, and recognised in finished sentences.

use super::catalogue::Catalogue;
use std::borrow::Cow;
use std::fmt::Display;

/// A translated sentence may have translated sentences in its places; deeper ones do not occur.
const DEPTH: u32 = 4;

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

/// A finished sentence in the language of `catalogue`: the whole of it, or what follows a name ("cow.obj: …").
pub fn translate<'a>(catalogue: &Catalogue, text: &'a str) -> Cow<'a, str> {
    whole(catalogue, text, DEPTH).map_or(Cow::Borrowed(text), Cow::Owned)
}

fn whole(catalogue: &Catalogue, text: &str, depth: u32) -> Option<String> {
    if depth == 0 {
        return None;
    }
    if let Some(found) = catalogue.get(text) {
        return Some(found.to_owned());
    }
    let inside = |part: &str| whole(catalogue, part, depth - 1).unwrap_or_else(|| part.to_owned());
    let fitting = catalogue.templates().iter().find_map(|template| Some((template, holes(&template.key, text)?)));
    if let Some((template, parts)) = fitting {
        let parts: Vec<String> = parts.into_iter().map(inside).collect();
        return Some(fill(&template.value, &parts.iter().collect::<Vec<_>>()));
    }
    let (name, rest) = text.split_once(": ")?;
    Some(format!("{name}: {}", whole(catalogue, rest, depth - 1)?))
}

/// How many letters of a template stand for themselves; `None`: it has no placeholders, or too little
/// besides them to be recognised by.
pub fn literal(template: &str) -> Option<usize> {
    const RECOGNISABLE: usize = 8;
    if !template.contains('{') {
        return None;
    }
    let own: usize = pieces(template).map(|piece| if let Piece::Text(text) = piece { text.len() } else { 0 }).sum();
    (own >= RECOGNISABLE).then_some(own)
}

/// What stands in the places of `template`, by number, if `text` is that template filled.
fn holes<'t>(template: &str, text: &'t str) -> Option<Vec<&'t str>> {
    let (mut rest, mut found, mut open) = (text, Vec::new(), None);
    let mut pieces = pieces(template).peekable();
    while let Some(piece) = pieces.next() {
        match (piece, open.take()) {
            (Piece::Hole(k), _) => open = Some(k),
            (Piece::Text(own), None) => rest = rest.strip_prefix(own)?,
            (Piece::Text(own), Some(k)) => {
                let at = if pieces.peek().is_some() { rest.find(own) } else { rest.strip_suffix(own).map(str::len) }?;
                found.push((k, &rest[..at]));
                rest = &rest[at + own.len()..];
            }
        }
    }
    match open {
        Some(k) => found.push((k, rest)),
        None if !rest.is_empty() => return None,
        None => {}
    }
    found.sort_by_key(|(k, _)| *k);
    Some(found.into_iter().map(|(_, part)| part).collect())
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Piece<'a> {
    Text(&'a str),
    Hole(usize),
}

fn pieces(template: &str) -> impl Iterator<Item = Piece<'_>> {
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
mod tests {
    use super::*;

    fn german() -> Catalogue {
        Catalogue::parse(
            "msgid \"edges {0} and {1} cross near {2}\"\nmsgstr \"bei {2} kreuzen sich {0} und {1}\"\n\
             msgid \"The {0} has no map: {1}.\"\nmsgstr \"{0} ohne Abbildung: {1}.\"\n\
             msgid \"source\"\nmsgstr \"Quelle\"\n",
        )
    }

    #[test]
    fn places_are_filled_by_number() {
        assert_eq!(fill("{1} before {0}, {0}; {x} {", &[&1, &2]), "2 before 1, 1; {x} {");
        assert_eq!(fill::<i32>("{0} missing", &[]), " missing");
    }

    #[test]
    fn finished_sentences_are_recognised_with_what_stands_in_their_places() {
        let german = german();
        assert_eq!(translate(&german, "edges 3 and 14 cross near (0.4, 1)"), "bei (0.4, 1) kreuzen sich 3 und 14");
        assert_eq!(
            translate(&german, "a.svg: The source has no map: edges 3 and 14 cross near 0."),
            "a.svg: Quelle ohne Abbildung: bei 0 kreuzen sich 3 und 14."
        );
    }

    #[test]
    fn what_has_no_entry_stays_as_it_is() {
        for text in ["", "something else", "a: b: c: d: e: f", "edges 3 and 14", "{0} and {1}"] {
            assert!(matches!(translate(&german(), text), Cow::Borrowed(same) if same == text));
        }
    }
}
