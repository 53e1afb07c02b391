//! Every key is translated in every language, and the code contains no other texts for users.

use super::key::{all_labels, all_messages};
use super::literals::{Literal, literals};
use super::*;
use crate::figures::{Detail, Figure, Method};
use crate::outline::Preset;
use crate::surface::SurfacePreset;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};

/// The variables that the files of a language use for each key.
fn variables(language: Language) -> BTreeMap<&'static str, BTreeSet<&'static str>> {
    let mut found: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
    let mut key = "";
    for line in language.files().into_iter().flat_map(str::lines).filter(|line| !line.starts_with('#')) {
        if let Some((name, _)) =
            line.split_once(" = ").filter(|_| line.starts_with(|first: char| first.is_alphabetic()))
        {
            key = name;
            assert!(found.insert(key, BTreeSet::new()).is_none(), "{key} is twice in {language:?}");
        }
        let names = line.split('$').skip(1).map(|rest| rest.split([' ', '}']).next().unwrap());
        if let Some(variables) = found.get_mut(key) {
            variables.extend(names);
        }
    }
    found
}

#[test]
fn every_key_has_words_with_its_arguments_in_every_language() {
    let labels = all_labels().map(|label| (label.key(), BTreeSet::new()));
    let messages = all_messages().map(|(key, arguments)| (key, arguments.iter().copied().collect()));
    let keys: BTreeMap<&str, BTreeSet<&str>> = labels.chain(messages).collect();
    assert_eq!(keys.len(), all_labels().count() + all_messages().count(), "a key is there twice");
    assert!(keys.len() > 800, "{} keys", keys.len());
    for language in Language::ALL {
        for file in language.files() {
            let errors = FluentResource::try_new(file.to_owned()).err().map(|(_, errors)| errors);
            assert!(errors.is_none(), "{language:?}: {errors:?}");
        }
        let words = variables(language);
        let unlike = keys.iter().filter(|(key, arguments)| words.get(*key) != Some(*arguments));
        let missing: Vec<&str> = unlike.map(|(key, _)| *key).collect();
        assert_eq!(missing, [""; 0], "without words, or with other arguments, in {language:?}");
        let unknown: Vec<_> = words.keys().filter(|key| !keys.contains_key(**key)).collect();
        assert_eq!(unknown, [&""; 0], "no keys of the code, but in {language:?}");
    }
}

#[test]
fn every_label_and_message_has_text_in_every_language() {
    for language in Language::ALL {
        for label in all_labels() {
            let words = language.look_up(label.key(), None, &mut Vec::new()).unwrap();
            assert!(matches!(words, Cow::Borrowed(_)), "{label:?} is made of parts in {language:?}");
        }
        for (key, names) in all_messages() {
            for count in [0, 1, 2, 71] {
                let mut arguments = FluentArgs::new();
                for name in names {
                    arguments.set(*name, FluentValue::from(count));
                }
                let mut errors = Vec::new();
                let words = language.look_up(key, Some(&arguments), &mut errors).unwrap();
                assert!(errors.is_empty() && !words.contains("{$"), "{key} in {language:?}: {words:?}, {errors:?}");
            }
        }
    }
}

/// Code whose literals are not shown to users: they are for developers, or are identifiers.
const NOT_SHOWN: [&str; 11] = [
    "assert",
    "log::",
    "eprintln!",
    "Id::unique(",
    "Id::new(",
    "Grid::new(",
    "grid(",
    ".name(",
    "Kept::",
    "match_media(",
    "#[error(",
];

/// Code directly before literals that are not shown to users.
const NOT_SHOWN_BY: [&str; 5] = [".split(", "== ", "reason = ", "name: String::from(", ".with("];

/// Whether a literal contains words of a language, as opposed to an identifier or a format.
fn is_prose(text: &str) -> bool {
    let is_word = |word: &str| {
        let word = word.trim_matches(|letter: char| letter.is_ascii_punctuation() && letter != '{' && letter != '}');
        word.len() > 1 && word.bytes().all(|letter| letter.is_ascii_lowercase())
    };
    let is_unit = |word: &str| word == "ms" || word == "px";
    let mut words = text.split_whitespace();
    text.split_whitespace().count() > 1 && !text.starts_with('<') && words.any(|word| is_word(word) && !is_unit(word))
}

#[test]
fn no_words_stand_in_the_code_of_the_screen() {
    let is_of_screen = |literal: &Literal| {
        let rooms = ["src/app/", "src/model/", "src/platform/", "src/worker/"];
        // the names that sessions store for shapes
        rooms.iter().any(|room| literal.file.starts_with(room)) && literal.file != "src/model/names.rs"
    };
    let is_shown = |Literal { before, text, .. }: &Literal| {
        is_prose(text)
            && !NOT_SHOWN.iter().any(|code| before.contains(code))
            && !NOT_SHOWN_BY.iter().any(|code| before.ends_with(code))
    };
    let all: Vec<Literal> = literals().into_iter().filter(is_of_screen).collect();
    assert!(all.len() > 300, "{} texts", all.len());
    let words: Vec<_> =
        all.iter().filter(|literal| is_shown(literal)).map(|Literal { file, text, .. }| (file, text)).collect();
    assert!(words.is_empty(), "{words:#?}");
}

#[test]
fn every_key_is_used() {
    let sources = sources();
    let is_used = |key: &str| sources.contains(&format!("key::{key}"));
    let keys = all_labels().map(Label::key).chain(all_messages().map(|(key, _)| key));
    let unused: Vec<&str> = keys.filter(|key| !is_used(key)).collect();
    assert_eq!(unused, [""; 0]);
}

/// All names that follow `key::` in the sources.
fn sources() -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    let mut folders = vec![std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("src")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let source = std::fs::read_to_string(&path).unwrap();
                let is_name = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_';
                let found = source.split("key::").skip(1).map(|rest| &rest[..rest.find(|c| !is_name(c)).unwrap_or(0)]);
                names.extend(found.map(|name| format!("key::{name}")));
            }
        }
    }
    names
}

#[test]
fn shapes_and_figures_have_the_names_of_their_rooms_in_english() {
    for shape in Preset::ALL {
        assert_eq!(preset(shape).english(), shape.title());
    }
    for shape in SurfacePreset::ALL {
        assert_eq!(surface_preset(shape).english(), crate::model::names::surface_preset(shape));
    }
    for method in [Method::Exact, Method::HarmonicMeasure, Method::FreshZipper, Method::PrecomputedZipper] {
        assert_eq!(super::method(method).english(), method.title());
    }
    for figure in Figure::ALL {
        assert_eq!(title(figure).english(), figure.title());
        let settled: Vec<&str> = choices(figure).into_iter().map(Label::english).collect();
        assert_eq!(settled, figure.choices());
        for scene in figure.scenes(Detail::Quick) {
            assert_eq!(Message::from(scene.label).english(), scene.label.to_string());
        }
    }
}

#[test]
fn languages_are_chosen_by_their_tags() {
    let of = |tags: &[&str]| Language::of_preferences(tags.iter().map(ToString::to_string));
    assert_eq!(of(&["de-AT", "en"]), Language::German);
    assert_eq!(of(&["fr-FR", "en-GB", "de"]), Language::English);
    assert_eq!(of(&["DE_de.UTF-8"]), Language::German);
    assert_eq!(of(&["ja", "den"]), Language::English, "the first language is the one of the code");
    assert_eq!(of(&[]), Language::English);
}

#[test]
fn the_screen_speaks_the_language_that_was_set() {
    assert_eq!(tr(key::open()), "Open…");
    set(Language::German);
    assert_eq!(tr(key::open()), "Öffnen…");
    assert_eq!(say(&key::of(3_u32, 7_u32)), "3 von 7");
    assert_eq!(key::open().english(), "Open…");
}

#[test]
fn counts_of_one_use_the_singular() {
    let walks = |count: usize| say(&key::walks(count, count));
    assert_eq!([0, 1, 2].map(walks), ["0 walks", "1 walk", "2 walks"]);
    set(Language::German);
    assert_eq!([0, 1, 2].map(walks), ["0 Irrfahrten", "1 Irrfahrt", "2 Irrfahrten"]);
}

#[test]
fn numbers_have_the_digits_that_they_are_given() {
    let place = key::place_line(1_234_567_usize);
    assert_eq!(place.english(), "line 1234567");
    assert_eq!(key::mesh_too_thin(0.1 + 0.2, -1e-30).english().matches("0.30000000000000004").count(), 1);
}

#[test]
fn a_message_crosses_from_a_worker_as_text() {
    let message = key::about("a.obj", key::topology_closed(2_u32));
    let text = serde_json::to_string(&message).unwrap();
    assert_eq!(serde_json::from_str::<Message>(&text).unwrap(), message);
    assert!(message.mentions(&key::topology_closed(2_u32)) && !message.mentions(&key::topology_closed(3_u32)));
}

#[test]
fn a_number_is_right_to_its_digits_however_small_or_large() {
    let english = [(1.5e-9, 3), (123.456, 4), (0.0, 3), (0.068_907, 3), (3.9436e23, 5)].map(|(x, n)| significant(x, n));
    assert_eq!(english, ["1.50e-9", "123.5", "0", "0.0689", "3.9436e23"]);
    assert_eq!(significant(f64::INFINITY, 3), "inf");
}
