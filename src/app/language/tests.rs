//! The files of strings hold what the screen says, and nothing else.

use super::catalogue::Catalogue;
use super::literals::literals;
use super::*;
use std::collections::BTreeSet;

thread_local! {
    /// The texts that [`tr`] had no entry for, in this test.
    pub static MISSING: std::cell::RefCell<BTreeSet<&'static str>> = const { std::cell::RefCell::new(BTreeSet::new()) };
}

fn placeholders(text: &str) -> BTreeSet<String> {
    (0..10).map(|k| format!("{{{k}}}")).filter(|hole| text.contains(hole.as_str())).collect()
}

#[test]
fn a_translation_has_the_places_of_its_text() {
    for file in [include_str!("de.po"), include_str!("de_messages.po")] {
        let catalogue = Catalogue::parse(file);
        assert_eq!(catalogue.pairs().count() + 1, file.matches("msgid ").count(), "an entry is empty or twice there");
        for (key, value) in catalogue.pairs() {
            assert_eq!(placeholders(key), placeholders(value), "{key}");
        }
    }
}

#[test]
fn the_screen_says_every_text_that_is_translated() {
    let said: BTreeSet<String> = literals().into_iter().map(|literal| literal.text).collect();
    for (key, _) in Catalogue::parse(include_str!("de.po")).pairs() {
        assert!(said.contains(key), "nothing says {key:?} any more");
    }
}

#[test]
fn every_literal_that_is_to_be_translated_has_an_entry() {
    let catalogue = Catalogue::parse(include_str!("de.po"));
    let is_translated = |before: &str| {
        let name = before.trim_end().strip_suffix('(').unwrap_or_default();
        let name = name.rsplit(|letter: char| !letter.is_alphanumeric() && letter != '_').next();
        name == Some("tr") || name == Some("tr_with") || before.contains("tr_count(")
    };
    let found: BTreeSet<String> =
        literals().into_iter().filter(|literal| is_translated(&literal.before)).map(|literal| literal.text).collect();
    assert!(found.len() > 80, "{} literals", found.len());
    let missing: Vec<&String> = found.iter().filter(|text| catalogue.get(text).is_none()).collect();
    assert!(missing.is_empty(), "no entry in de.po: {missing:#?}");
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
    assert_eq!(tr("Open…"), "Open…");
    set(Language::German);
    assert_eq!(tr("Open…"), "Öffnen…");
    assert_eq!(tr_with("{0} of {1}", &[&3, &7]), "3 von 7");
    assert_eq!(tr("no text of the screen"), "no text of the screen");
    assert!(MISSING.with_borrow(|missing| missing.contains("no text of the screen")));
}

#[test]
fn one_thing_is_said_of_in_the_singular() {
    let walks = |count: usize| tr_count(count, ["{0} walk", "{0} walks"], &[&count]);
    assert_eq!([0, 1, 2].map(walks), ["0 walks", "1 walk", "2 walks"]);
    set(Language::German);
    assert_eq!([0, 1, 2].map(walks), ["0 Irrfahrten", "1 Irrfahrt", "2 Irrfahrten"]);
}

#[test]
fn errors_of_the_core_are_said_in_the_language_of_the_screen() {
    use crate::geometry::{DVec2, SimplePolygon};
    set(Language::German);
    let bow = [(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)].map(DVec2::from).to_vec();
    let error = SimplePolygon::try_from(bow).unwrap_err().to_string();
    let said = tr_message(&error);
    assert!(said.starts_with("der Umriss kreuzt sich bei (0.5, 0.5)"), "{said}");
    assert_eq!(tr_message("a.obj: the file is empty"), "a.obj: die Datei ist leer");
    let wrapped = format!("The link could not be opened: {}", crate::session::link::decode("#s=1.AAAA").unwrap_err());
    assert!(tr_message(&wrapped).starts_with("Der Link ließ sich nicht öffnen: der Link "), "{}", tr_message(&wrapped));
}
