//! The options in the page's URL besides the session, such as `?embed&lock=outline,view&theme=light`.
//!
//! | option | meaning |
//! |---|---|
//! | `embed` | only the two pictures, without bars and panels |
//! | `lock=…` | names of the controls that are locked, separated by commas (`locks`) |
//! | `present` | zoom factor 1.5 |
//! | `theme=dark`, `theme=light` | replaces the user's theme |
//! | `lang=en`, `lang=de` | replaces the user's language |
//! | `bench` | opens the window with the paper's tables |
//! | `backend=webgl` | WebGPU is not used |
//!
//! Unknown options are ignored, because a host may add its own; unknown values of these options are
//! reported in `user_errors`.

use crate::app::input::locks::{Control, Locks};
use crate::app::input::preferences::Appearance;
use crate::language::{Language, Message, key};
use std::collections::{BTreeMap, BTreeSet};

/// The parsed options; the default is that of a URL without options.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of its own, there or not")]
pub struct AddressOptions {
    /// Only the pictures, without bars and panels.
    pub embed: bool,
    /// Zoom factor 1.5.
    pub present: bool,
    /// Opens the window with the paper's tables.
    pub bench: bool,
    /// WebGPU is not used.
    pub webgl: bool,
    /// The locked controls.
    pub locks: Locks,
    /// The theme, if the URL names one.
    pub theme: Option<Appearance>,
    /// The language, if the URL names one.
    pub language: Option<Language>,
    /// One message for each option with unknown values.
    pub user_errors: Vec<Message>,
}

const THEMES: [(&str, Appearance); 2] = [("light", Appearance::Light), ("dark", Appearance::Dark)];

impl AddressOptions {
    /// Parses pairs of name and value, percent-decoded, in the order of the URL.
    pub fn parse<'a>(pairs: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let mut options = Self::default();
        let mut unknown = Unknown::default();
        for (name, value) in pairs {
            for value in options.read(name, value) {
                unknown.entry(name).or_default().insert(value);
            }
        }
        options.user_errors = unknown.iter().map(|(name, values)| user_error(name, values)).collect();
        options
    }

    /// Applies one option; returns the parts of its value that are unknown.
    fn read<'a>(&mut self, name: &str, value: &'a str) -> Vec<&'a str> {
        let mut is_understood = true;
        match name {
            "embed" => self.embed = true,
            "present" => self.present = true,
            "bench" => self.bench = true,
            "lock" => {
                let (locks, unknown) = Locks::parse(value);
                self.locks = self.locks.and(locks);
                return unknown;
            }
            "backend" => {
                self.webgl = value.eq_ignore_ascii_case("webgl");
                is_understood = self.webgl;
            }
            "theme" => {
                self.theme = THEMES.into_iter().find(|(theme, _)| value == *theme).map(|(_, theme)| theme);
                is_understood = self.theme.is_some();
            }
            "lang" => {
                self.language = Language::ALL.into_iter().find(|language| value == language.code());
                is_understood = self.language.is_some();
            }
            _ => {}
        }
        if is_understood { Vec::new() } else { vec![value] }
    }
}

/// The unknown values by option, without repetitions.
type Unknown<'a> = BTreeMap<&'a str, BTreeSet<&'a str>>;

/// The most unknown values that a message lists, and the most characters of each: a URL may be of any length.
const MOST_NAMED: usize = 3;
const MOST_LETTERS: usize = 24;

/// The message about the unknown values of an option, one sentence.
fn user_error(name: &str, values: &BTreeSet<&str>) -> Message {
    let said = values.iter().take(MOST_NAMED).map(|value| shortened(value)).collect::<Vec<_>>().join(",");
    let (asked, known) = (format!("{name}={said}"), known(name).join(", "));
    match values.len().saturating_sub(MOST_NAMED) {
        0 => key::address_unknown(asked, name, known),
        more => key::address_unknown_and_more(asked, more, name, known),
    }
}

/// The values that an option accepts.
fn known(name: &str) -> Vec<&'static str> {
    match name {
        "lock" => Control::ALL.map(Control::name).into(),
        "theme" => THEMES.map(|(theme, _)| theme).into(),
        "lang" => Language::ALL.map(Language::code).into(),
        _ => vec!["webgl"],
    }
}

fn shortened(value: &str) -> String {
    match value.char_indices().nth(MOST_LETTERS) {
        Some((end, _)) => format!("{}…", &value[..end]),
        None => value.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::{say, set};

    #[test]
    fn all_options_can_be_combined() {
        let pairs = [("embed", ""), ("lock", "outline,view"), ("present", ""), ("theme", "light"), ("lang", "de")];
        let options = AddressOptions::parse(pairs);
        assert!(options.embed && options.present && !options.bench && !options.webgl);
        assert!(options.locks.holds(Control::Outline) && options.locks.holds(Control::View));
        assert_eq!((options.theme, options.language), (Some(Appearance::Light), Some(Language::German)));
        assert!(options.user_errors.is_empty());
    }

    #[test]
    fn an_address_without_options_asks_for_nothing_and_others_options_are_left_alone() {
        assert_eq!(AddressOptions::parse([]), AddressOptions::default());
        assert_eq!(AddressOptions::parse([("utm_source", "mail")]), AddressOptions::default());
    }

    #[test]
    fn unknown_values_are_reported_with_the_known_ones() {
        let options = AddressOptions::parse([("lock", "outline,vieuw"), ("theme", "blue"), ("backend", "webgpu")]);
        assert!(options.locks.holds(Control::Outline) && options.theme.is_none() && !options.webgl);
        let user_errors: Vec<String> = options.user_errors.iter().map(Message::english).collect();
        let [backend, lock, theme] = user_errors.as_slice() else {
            unreachable!("{:?}", options.user_errors);
        };
        assert!(lock.contains("lock=vieuw") && lock.contains("boundary"), "{lock}");
        assert!(theme.contains("theme=blue") && theme.contains("light, dark"), "{theme}");
        assert!(backend.contains("backend=webgpu"), "{backend}");
        set(Language::German);
        let theme = say(&options.user_errors[2]);
        assert_eq!(theme, "In der Adresse steht „theme=blue“, aber theme kennt nur: light, dark.");
    }

    #[test]
    fn unknown_values_are_reported_in_one_short_sentence_per_option() {
        let names: Vec<String> = (0..30).map(|k| format!("{k:02}{}", "ü".repeat(1000))).collect();
        let (list, twice) = (names.join(","), [&*names[0], &*names[0]].join(","));
        let options = AddressOptions::parse([("lock", &*list), ("lock", "vieuw"), ("lock", &*twice)]);
        let user_errors: Vec<String> = options.user_errors.iter().map(Message::english).collect();
        let [lock] = user_errors.as_slice() else {
            unreachable!("{:?}", options.user_errors);
        };
        assert!(lock.contains("01üü") && lock.contains("…\" and 28 more, but lock knows only: interior, "), "{lock}");
        assert!(lock.chars().count() < 300 && lock.matches("interior").count() == 1, "{lock}");
        set(Language::German);
        let german = say(&options.user_errors[0]);
        assert!(
            german.starts_with("In der Adresse steht „lock=00ü")
                && german.contains("“ und 28 weitere, aber lock kennt nur: interior, boundary, outline,"),
            "{german}"
        );
    }

    #[test]
    fn several_locks_add_up() {
        let options = AddressOptions::parse([("lock", "view"), ("lock", "pattern")]);
        assert!(options.locks.holds(Control::View) && options.locks.holds(Control::Pattern));
    }
}
