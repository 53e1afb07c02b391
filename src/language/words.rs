//! Translations: the `.ftl` files, parsed once, and the current language.

use super::{Label, Message, Value, key};
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentError, FluentResource, FluentValue};
use std::borrow::Cow;
use std::cell::Cell;
use std::sync::OnceLock;
use unic_langid::LanguageIdentifier;

/// A language of the app.
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
    /// All languages, in the order of the menu.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// The language's name in the language itself.
    pub fn own_name(self) -> Label {
        match self {
            Self::English => key::english(),
            Self::German => key::deutsch(),
        }
    }

    /// Its code (ISO 639-1).
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }

    /// The language of a tag such as `de-AT` or `en_US.UTF-8`; `None` if the app does not have it.
    pub fn of_tag(tag: &str) -> Option<Self> {
        let code = tag.split(['-', '_', '.']).next().unwrap_or_default();
        Self::ALL.into_iter().find(|language| language.code().eq_ignore_ascii_case(code))
    }

    /// The first of the user's languages that the app has; English if it has none of them.
    pub fn of_preferences(tags: impl IntoIterator<Item = String>) -> Self {
        tags.into_iter().find_map(|tag| Self::of_tag(&tag)).unwrap_or_default()
    }

    /// The contents of its `.ftl` files.
    pub(super) fn files(self) -> [&'static str; 2] {
        match self {
            Self::English => [include_str!("en/labels.ftl"), include_str!("en/messages.ftl")],
            Self::German => [include_str!("de/labels.ftl"), include_str!("de/messages.ftl")],
        }
    }

    /// The text of a label in this language.
    pub fn label(self, label: Label) -> &'static str {
        let words = |language: Self| language.look_up(label.key(), None, &mut Vec::new());
        match words(self).or_else(|| words(Self::English)) {
            Some(Cow::Borrowed(words)) => words,
            // cannot happen: a test looks up all labels
            Some(Cow::Owned(_)) | None => label.key(),
        }
    }

    /// The text of a message in this language.
    pub fn message(self, message: &Message) -> String {
        let mut arguments = FluentArgs::new();
        for (name, value) in message.arguments() {
            let value = match value {
                Value::Text(text) => FluentValue::from(text.as_ref()),
                Value::Number(number) => FluentValue::from(self.decimal(number)),
                Value::Count(count) => FluentValue::from(*count),
                Value::Message(message) => FluentValue::from(self.message(message)),
            };
            arguments.set(name, value);
        }
        // a test looks up all messages
        let words = |language: Self| language.look_up(message.key(), Some(&arguments), &mut Vec::new());
        words(self).or_else(|| words(Self::English)).map_or_else(|| message.key().to_owned(), Cow::into_owned)
    }

    /// A number with a decimal point, as people read it.
    fn decimal(self, number: &str) -> String {
        match self {
            Self::English => number.to_owned(),
            Self::German => number.replace('.', ","),
        }
    }

    /// The text of a key, `None` if there is none; errors in it are added to `errors`.
    pub(super) fn look_up(
        self,
        key: &str,
        arguments: Option<&FluentArgs<'_>>,
        errors: &mut Vec<FluentError>,
    ) -> Option<Cow<'static, str>> {
        let words = self.words();
        let pattern = words.get_message(key)?.value()?;
        Some(words.format_pattern(pattern, arguments, errors))
    }

    fn words(self) -> &'static Words {
        static ENGLISH: OnceLock<Words> = OnceLock::new();
        static GERMAN: OnceLock<Words> = OnceLock::new();
        let words = match self {
            Self::English => &ENGLISH,
            Self::German => &GERMAN,
        };
        words.get_or_init(|| self.read())
    }

    /// Parses the files. Tests check that they are well formed and have each key once.
    fn read(self) -> Words {
        let identifier: LanguageIdentifier = self.code().parse().unwrap_or_default();
        let mut words = FluentBundle::new_concurrent(vec![identifier]);
        // all languages here are written from left to right, so that names need no isolation marks
        words.set_use_isolating(false);
        for file in self.files() {
            words.add_resource_overriding(FluentResource::try_new(file.to_owned()).unwrap_or_else(|(file, _)| file));
        }
        words
    }
}

type Words = FluentBundle<FluentResource>;

impl Label {
    /// The English text, whatever the current language: for the page's scripts, and names they use.
    pub fn english(self) -> &'static str {
        Language::English.label(self)
    }
}

impl Message {
    /// The English text, whatever the current language: for the page's scripts and the command line.
    pub fn english(&self) -> String {
        Language::English.message(self)
    }
}

thread_local! {
    /// Per thread: the app draws on one thread, and each test has its own.
    static CURRENT: Cell<Language> = const { Cell::new(Language::English) };
}

/// The current language.
pub fn current() -> Language {
    CURRENT.get()
}

/// Sets the current language.
pub fn set(language: Language) {
    CURRENT.set(language);
}

/// The text of a label in the current language.
pub fn tr(label: Label) -> &'static str {
    current().label(label)
}

/// The text of a message in the current language.
pub fn say(message: &Message) -> String {
    current().message(message)
}

/// A number with `digits` decimals for people, with a decimal comma in German, where a point groups thousands.
pub fn number(value: f64, digits: usize) -> String {
    current().decimal(&format!("{value:.digits$}"))
}

/// A number that is not negative, right to this many digits, with an exponent below 1e-3 and from 1e5 on.
pub fn significant(value: f64, digits: usize) -> String {
    if (1e-3..1e5).contains(&value) {
        let before = value.log10().floor() as i32;
        number(value, (digits as i32 - before - 1).clamp(0, 15) as usize)
    } else if value == 0.0 {
        number(0.0, 0)
    } else {
        decimal(&format!("{value:.*e}", digits.saturating_sub(1)))
    }
}

/// A number with a decimal point, as people read it in the current language.
pub fn decimal(text: &str) -> String {
    current().decimal(text)
}
