//! The languages of the screen: English in the code, German in a file of strings.
//!
//! As with GNU gettext the English text itself is the key: [`tr`] looks it up in
//! `de.po`, a plain file of pairs that the usual editors for translators open.
//! What has no entry stays English; tests look for such texts in the code and on the screen. Placeholders are
//! numbered, `{0}`, `{1}`: another language may order them differently.
//!
//! The core's errors are English sentences with numbers in them. Where one is
//! shown, [`tr_message`] finds the entries of `de_messages.po` that it is made of; words of others, such as the
//! system's, stay as they are. Tests collect the texts of the code, and fail for one without an entry.

mod catalogue;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::expect_used, reason = "tests")]
mod error_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod literals;
mod message;
#[cfg(test)]
mod message_tests;
mod template;

use catalogue::Catalogue;
use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::fmt::Display;
use std::sync::OnceLock;

/// A language that the screen speaks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
pub enum Language {
    /// English.
    #[default]
    #[serde(rename = "en")]
    English,
    /// German.
    #[serde(rename = "de")]
    German,
}

impl Language {
    /// All of them, as they are listed in the menu.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// Its own name for itself.
    pub fn name(self) -> &'static str {
        match self {
            Self::English => "English",
            Self::German => "Deutsch",
        }
    }

    /// Its code (ISO 639-1).
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }

    /// The language of a tag such as `de-AT` or `en_US.UTF-8`, if it is one of these.
    pub fn of_tag(tag: &str) -> Option<Self> {
        let code = tag.split(['-', '_', '.']).next().unwrap_or_default();
        Self::ALL.into_iter().find(|language| language.code().eq_ignore_ascii_case(code))
    }

    /// The first of a person's languages that the screen speaks; English if it speaks none of them.
    pub fn of_preferences(tags: impl IntoIterator<Item = String>) -> Self {
        tags.into_iter().find_map(|tag| Self::of_tag(&tag)).unwrap_or_default()
    }
}

thread_local! {
    /// The screen is drawn by one thread, and each test by its own.
    static CURRENT: Cell<Language> = const { Cell::new(Language::English) };
    /// What [`tr_message`] has found, or not: a text that is shown is looked up in every frame.
    static SAID: RefCell<HashMap<String, Option<String>>> = RefCell::new(HashMap::new());
}

/// The language that the screen speaks.
pub fn current() -> Language {
    CURRENT.get()
}

/// From now on the screen speaks `language`.
pub fn set(language: Language) {
    CURRENT.set(language);
}

/// `text` in the language of the screen.
pub fn tr(text: &'static str) -> &'static str {
    let Some(catalogue) = present() else { return text };
    let found = catalogue.get(text);
    #[cfg(test)]
    if found.is_none() {
        tests::MISSING.with_borrow_mut(|missing| missing.insert(text));
    }
    found.unwrap_or(text)
}

/// `template` in the language of the screen, with `parts` in the places of `{0}`, `{1}`…
pub fn tr_with(template: &'static str, parts: &[&dyn Display]) -> String {
    template::fill(tr(template), parts)
}

/// Of two templates the one for `count` things, the first for one of them, filled like [`tr_with`]'s.
pub fn tr_count(count: usize, [one, several]: [&'static str; 2], parts: &[&dyn Display]) -> String {
    tr_with(if count == 1 { one } else { several }, parts)
}

/// A number with `digits` after the decimal point or comma, for the ear: to a German one a point groups thousands.
pub fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    match current() {
        Language::English => text,
        Language::German => text.replace('.', ","),
    }
}

/// A text that was made elsewhere, such as an error of the core, in the language of the screen: sentence by
/// sentence, and as it is where there is no entry for it.
pub fn tr_message(text: &str) -> Cow<'_, str> {
    /// As many as a screen shows, and some.
    const MOST_SAID: usize = 200;
    let Some(catalogue) = present() else { return Cow::Borrowed(text) };
    SAID.with_borrow_mut(|said| {
        if said.len() > MOST_SAID {
            said.clear();
        }
        if !said.contains_key(text) {
            let found = match message::translate(catalogue, text) {
                Cow::Owned(found) => Some(found),
                Cow::Borrowed(_) => None,
            };
            said.insert(text.to_owned(), found);
        }
        said.get(text).cloned().flatten().map_or(Cow::Borrowed(text), Cow::Owned)
    })
}

fn present() -> Option<&'static Catalogue> {
    static GERMAN: OnceLock<Catalogue> = OnceLock::new();
    match current() {
        Language::English => None,
        Language::German => Some(
            GERMAN
                .get_or_init(|| Catalogue::parse(concat!(include_str!("de.po"), "\n", include_str!("de_messages.po")))),
        ),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
pub mod tests;
