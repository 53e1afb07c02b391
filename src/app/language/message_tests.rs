//! What is said anywhere in the program has an entry, and every entry is said.

use super::catalogue::Catalogue;
use super::literals::{Literal, literals};
use super::{Language, set, tr_message};
use std::collections::BTreeSet;

/// Not shown by the app: the command line, and what goes into files.
const ELSEWHERE: [&str; 3] = ["src/bin/", "src/cli/", "src/export/"];

/// Code whose texts are not shown: they are for developers, or name things.
const NOT_SHOWN: [&str; 9] =
    ["assert", "log::", "eprintln!", "Id::unique(", "Grid::new(", "grid(", ".name(", "Kept::", "match_media("];

/// The same, where it is the last of the code.
const NOT_SHOWN_BY: [&str; 3] = [".split(", "== ", ".with("];

/// Code whose texts are shown even if they are a single word: the parts that sentences are made of.
const PARTS_BY: [&str; 3] = ["codes!(", "what: ", "too_deep("];

fn german() -> Catalogue {
    Catalogue::parse(concat!(include_str!("de.po"), "\n", include_str!("de_messages.po")))
}

/// Whether a text has words of a language, rather than a name or a format.
fn is_prose(text: &str) -> bool {
    let is_word = |word: &str| {
        let word = word.trim_matches(|letter: char| letter.is_ascii_punctuation() && letter != '{' && letter != '}');
        word.len() > 1 && word.bytes().all(|letter| letter.is_ascii_lowercase())
    };
    let is_unit = |word: &str| word == "ms" || word == "px";
    let mut words = text.split_whitespace();
    text.split_whitespace().count() > 1 && !text.starts_with('<') && words.any(|word| is_word(word) && !is_unit(word))
}

fn is_shown(literal: &Literal) -> bool {
    let Literal { file, before, text } = literal;
    let of_attribute = before.ends_with("reason = ") && before.contains("#[");
    let of_gpu = file.starts_with("src/render/") && ["label", "device,", "encoder,"].iter().any(|c| before.contains(c));
    let is_part = PARTS_BY.iter().any(|code| before.ends_with(code));
    (is_prose(text) || is_part)
        && !ELSEWHERE.iter().any(|folder| file.starts_with(folder))
        && !NOT_SHOWN.iter().any(|code| before.contains(code))
        && !NOT_SHOWN_BY.iter().any(|code| before.ends_with(code))
        && !of_attribute
        && !of_gpu
}

#[test]
fn every_text_of_the_program_has_an_entry() {
    let german = german();
    let shown: Vec<Literal> = literals().into_iter().filter(is_shown).collect();
    assert!(shown.len() > 600, "{} texts", shown.len());
    let is_missing = |literal: &&Literal| german.get(&literal.text).is_none() && german.get(&literal.key()).is_none();
    let missing: BTreeSet<String> =
        shown.iter().filter(is_missing).map(|literal| format!("{}: {:?}", literal.file, literal.key())).collect();
    assert!(missing.is_empty(), "no entry in de.po or de_messages.po: {missing:#?}");
}

#[test]
fn every_error_is_found_by_its_entry() {
    set(Language::German);
    let is_error = |before: &str| before.trim_end().ends_with("#[error(") || before.contains("counted!(");
    let errors = literals().into_iter().filter(|literal| is_error(&literal.before));
    let mut count = 0;
    for error in errors.filter(is_shown) {
        let (key, mut filled) = (error.key(), error.key());
        for place in 0..10 {
            filled = filled.replace(&format!("{{{place}}}"), &format!("{}", 71 + place));
        }
        assert_ne!(tr_message(&filled), filled, "{key}");
        let numbers = |text: &str| (0..10).filter(|place| text.contains(&format!("{}", 71 + place))).count();
        assert_eq!(numbers(&tr_message(&filled)), numbers(&filled), "{key}");
        count += 1;
    }
    assert!(count > 100, "{count} errors");
}

#[test]
fn every_message_with_an_entry_is_said_and_has_only_one() {
    let said: BTreeSet<String> = literals().into_iter().flat_map(|literal| [literal.key(), literal.text]).collect();
    let screen = Catalogue::parse(include_str!("de.po"));
    for (key, _) in Catalogue::parse(include_str!("de_messages.po")).pairs() {
        assert!(said.contains(key), "nothing says {key:?} any more");
        assert!(screen.get(key).is_none(), "{key:?} is in de.po too");
    }
}

#[test]
fn the_scenes_of_the_figures_speak_german() {
    set(Language::German);
    let letters = |text: &str| text.bytes().filter(u8::is_ascii_lowercase).count();
    for figure in crate::figures::Figure::ALL {
        let scenes = figure.scenes(crate::figures::Detail::Quick);
        for scene in scenes.iter().filter(|scene| letters(&scene.label) > 3) {
            assert_ne!(tr_message(&scene.label), scene.label);
        }
    }
}
