//! Finished sentences, found again among the texts with placeholders.
//!
//! A text may be one with an entry; several sentences or the items of a list, each of them known; a template
//! with something in its places; what follows a name ("cow.obj: …"). What stands in the places is looked up
//! likewise. Of all these the one that leaves the least unknown is taken, of equal ones the template that says
//! the most itself: the answer does not depend on an order of entries.

use super::catalogue::Catalogue;
use super::template::{Part, Template, fill};
use std::borrow::Cow;

/// A translated sentence may have translated sentences in its places; deeper ones do not occur.
const DEPTH: u32 = 6;
/// Longer texts than any of riemap's own are left alone, and lists of more items: they are others' words.
const LONGEST: usize = 2000;
const MOST_ITEMS: usize = 16;
/// What stands between sentences and between the items of a list.
const BREAKS: [&str; 3] = [". ", "; ", ", "];

/// A finished text in the language of `catalogue`; of several sentences those that are known.
pub fn translate<'a>(catalogue: &Catalogue, text: &'a str) -> Cow<'a, str> {
    if text.len() > LONGEST {
        return Cow::Borrowed(text);
    }
    in_part(catalogue, text, DEPTH).map_or(Cow::Borrowed(text), |said| Cow::Owned(said.text))
}

/// A translation.
struct Said {
    text: String,
    /// How many bytes of it are as they were: no names in quotes, no numbers.
    unknown: usize,
}

impl Said {
    fn entry(catalogue: &Catalogue, text: &str) -> Option<Self> {
        catalogue.get(text).map(|found| Self { text: found.to_owned(), unknown: 0 })
    }

    /// As it is.
    fn unknown(text: &str) -> Self {
        Self { text: text.to_owned(), unknown: if text.parse::<f64>().is_ok() { 0 } else { text.len() } }
    }
}

/// The whole of it, or else the sentences that are known.
fn in_part(catalogue: &Catalogue, text: &str, depth: u32) -> Option<Said> {
    whole(catalogue, text, depth).or_else(|| sentences(catalogue, text, depth))
}

fn whole(catalogue: &Catalogue, text: &str, depth: u32) -> Option<Said> {
    let several = || BREAKS.iter().filter_map(|mark| items(catalogue, text, mark, depth));
    let least = || several().chain(single(catalogue, text, depth)).min_by_key(|said| said.unknown);
    Said::entry(catalogue, text).or_else(least)
}

/// One sentence, with or without its full stop.
fn single(catalogue: &Catalogue, text: &str, depth: u32) -> Option<Said> {
    if depth == 0 {
        return None;
    }
    let filled = || catalogue.templates().iter().filter_map(|template| filled(catalogue, template, text, depth));
    let least = || filled().chain(after_name(catalogue, text, depth)).min_by_key(|said| said.unknown);
    let stopped = || {
        let said = single(catalogue, text.strip_suffix('.')?, depth - 1)?;
        Some(Said { text: said.text + ".", ..said })
    };
    Said::entry(catalogue, text).or_else(least).or_else(stopped)
}

/// `text` as `template`, with what stands in its places.
fn filled(catalogue: &Catalogue, template: &Template, text: &str, depth: u32) -> Option<Said> {
    let said = |part: &Part<'_>| match (part.is_name, template.is_weak()) {
        (true, _) => Some(Said { text: part.text.to_owned(), unknown: 0 }),
        // "line {0}" is for a number or a word that is known, not for "line 3.obj"
        (false, true) => {
            Said::entry(catalogue, part.text).or(Some(Said::unknown(part.text))).filter(|s| s.unknown == 0)
        }
        (false, false) => in_part(catalogue, part.text, depth - 1).or(Some(Said::unknown(part.text))),
    };
    let parts: Vec<Said> = template.parts(text)?.iter().map(said).collect::<Option<_>>()?;
    let texts: Vec<&String> = parts.iter().map(|said| &said.text).collect();
    Some(Said { text: fill(template.value(), &texts), unknown: parts.iter().map(|said| said.unknown).sum() })
}

/// What is said about a file, or about a place in it; its name stays.
fn after_name(catalogue: &Catalogue, text: &str, depth: u32) -> Option<Said> {
    let (name, rest) = text.split_once(": ")?;
    let rest = single(catalogue, rest, depth - 1)?;
    let mut weak = catalogue.templates().iter().filter(|template| template.is_weak());
    let place = || weak.find_map(|template| filled(catalogue, template, name, 1));
    let name = Said::entry(catalogue, name).or_else(place).unwrap_or_else(|| Said::unknown(name));
    Some(Said { text: format!("{}: {}", name.text, rest.text), unknown: name.unknown + rest.unknown })
}

/// Several texts with `mark` between them, if each is known. One may have `mark` in itself: the longest beginning
/// of which nothing is unknown is taken, else the longest that is known in part.
fn items(catalogue: &Catalogue, text: &str, mark: &str, depth: u32) -> Option<Said> {
    let count = text.matches(mark).count();
    if count == 0 || count > MOST_ITEMS {
        return None;
    }
    let (mut result, mut rest) = (Said { text: String::new(), unknown: 0 }, text);
    loop {
        // all of what is left, if that is not all of the text
        let all = (rest.len() < text.len()).then_some(rest.len());
        let ends = all.into_iter().chain(rest.rmatch_indices(mark).map(|(at, _)| at));
        let known = ends.filter_map(|at| Some((at, item(catalogue, &rest[..at], depth)?)));
        let (end, said) = longest(known)?;
        result.text.push_str(&said.text);
        result.unknown += said.unknown;
        if end == rest.len() {
            return Some(result);
        }
        result.text.push_str(mark);
        rest = &rest[end + mark.len()..];
    }
}

/// The first that is known as a whole, else the first.
fn longest(known: impl Iterator<Item = (usize, Said)>) -> Option<(usize, Said)> {
    let mut first = None;
    for each in known {
        if each.1.unknown == 0 {
            return Some(each);
        }
        first = first.or(Some(each));
    }
    first
}

/// An item may lack the full stop that its entry has, or be the "…" of a list that goes on.
fn item(catalogue: &Catalogue, text: &str, depth: u32) -> Option<Said> {
    let stopped = || {
        let said = single(catalogue, &format!("{text}."), depth)?;
        Some(Said { text: said.text.trim_end_matches('.').to_owned(), ..said })
    };
    let ellipsis = (text == "…").then(|| Said { text: text.to_owned(), unknown: 0 });
    ellipsis.or_else(|| single(catalogue, text, depth)).or_else(stopped)
}

/// Sentence by sentence: those that are not known stay.
fn sentences(catalogue: &Catalogue, text: &str, depth: u32) -> Option<Said> {
    let said: Vec<Option<Said>> = text.split(". ").map(|sentence| item(catalogue, sentence, depth)).collect();
    if said.len() < 2 || said.iter().all(Option::is_none) {
        return None;
    }
    let said: Vec<Said> =
        text.split(". ").zip(said).map(|(text, said)| said.unwrap_or_else(|| Said::unknown(text))).collect();
    let texts: Vec<&str> = said.iter().map(|said| said.text.as_str()).collect();
    Some(Said { text: texts.join(". "), unknown: said.iter().map(|said| said.unknown).sum() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn german() -> Catalogue {
        Catalogue::parse(
            "msgid \"edges {0} and {1} cross near {2}\"\nmsgstr \"bei {2} kreuzen sich {0} und {1}\"\n\
             msgid \"The {0} has no map: {1}.\"\nmsgstr \"{0} ohne Abbildung: {1}.\"\n\
             msgid \"The link was copied, but {0}.\"\nmsgstr \"Der Link wurde kopiert, aber {0}.\"\n\
             msgid \"it has {0} points; more than {1}\"\nmsgstr \"er hat {0} Punkte; mehr als {1}\"\n\
             msgid \"the {0} \\\"{1}\\\" is not known\"\nmsgstr \"„{1}“ ({0}) ist unbekannt\"\n\
             msgid \"{0}: {1} is missing\"\nmsgstr \"{0}: {1} fehlt\"\n\
             msgid \"line {0}\"\nmsgstr \"Zeile {0}\"\n\
             msgid \"the last corner\"\nmsgstr \"die letzte Ecke\"\n\
             msgid \"source\"\nmsgstr \"Quelle\"\n",
        )
    }

    fn said(text: &str) -> String {
        translate(&german(), text).into_owned()
    }

    #[test]
    fn finished_sentences_are_recognised_with_what_stands_in_their_places() {
        assert_eq!(said("edges 3 and 14 cross near (0.4, 1)"), "bei (0.4, 1) kreuzen sich 3 und 14");
        assert_eq!(
            said("a.svg: The source has no map: edges 3 and 14 cross near 0."),
            "a.svg: Quelle ohne Abbildung: bei 0 kreuzen sich 3 und 14."
        );
        assert_eq!(said("a.ply: line 3: the last corner is missing"), "a.ply: Zeile 3: die letzte Ecke fehlt");
        assert_eq!(said("a: line 3: the last corner"), "a: Zeile 3: die letzte Ecke", "a place before a text");
    }

    #[test]
    fn what_leaves_the_least_unknown_is_taken() {
        assert_eq!(said("a: the source \"b\" is not known"), "a: „b“ (Quelle) ist unbekannt");
        assert_eq!(said("a: line 3: b is missing"), "a: Zeile 3: b fehlt", "the place is known, the thing is not");
        assert_eq!(said("a: The source has no map: b is missing."), "a: Quelle ohne Abbildung: b is missing.");
    }

    #[test]
    fn sentences_and_lists_are_taken_apart() {
        assert_eq!(
            said("The link was copied, but it has 9 points; more than 8; the last corner."),
            "Der Link wurde kopiert, aber er hat 9 Punkte; mehr als 8; die letzte Ecke."
        );
        assert_eq!(
            said("The source has no map: source. the last corner. Edges unknown."),
            "Quelle ohne Abbildung: Quelle. die letzte Ecke. Edges unknown.",
            "what is not known stays"
        );
        assert_eq!(said("source, line 3, …"), "Quelle, Zeile 3, …");
    }

    #[test]
    fn names_stay() {
        assert_eq!(said("the source \"source\" is not known"), "„source“ (Quelle) ist unbekannt");
        assert_eq!(said("line 5.obj: the last corner"), "line 5.obj: die letzte Ecke", "no number, no place");
    }

    #[test]
    fn what_has_no_entry_stays_as_it_is() {
        let endless = "edges ".repeat(1000);
        for text in ["", "something else", "a: b: c: d: e: f", "edges 3 and 14", "{0} and {1}", "line up", &endless] {
            assert!(matches!(translate(&german(), text), Cow::Borrowed(same) if same == text), "{text}");
        }
    }
}
