//! The preferences of the user on this device: language and theme.
//!
//! They are not part of a session, so opening a link changes neither language nor theme.

use crate::app::input::address_options::AddressOptions;
use crate::language::{self, Language, Message};
use crate::platform::{self, Kept};
use egui::ThemePreference;

/// The choice of theme.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Appearance {
    /// The theme of the system.
    #[default]
    System,
    /// The light theme.
    Light,
    /// The dark theme.
    Dark,
}

impl Appearance {
    /// All variants, in the order of the menu.
    pub const ALL: [Self; 3] = [Self::System, Self::Light, Self::Dark];

    fn preference(self) -> ThemePreference {
        match self {
            Self::System => ThemePreference::System,
            Self::Light => ThemePreference::Light,
            Self::Dark => ThemePreference::Dark,
        }
    }
}

/// The preferences; a preference that was not chosen follows the system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(default, rename_all = "kebab-case")]
pub struct Preferences {
    /// The chosen language; `None` follows the system.
    pub language: Option<Language>,
    /// The chosen theme.
    pub appearance: Appearance,
}

impl Preferences {
    /// English and the dark theme, independent of the system: for screenshots and tests.
    pub fn fixed() -> Self {
        Self { language: Some(Language::English), appearance: Appearance::Dark }
    }

    /// The stored preferences; the defaults where none are stored or the stored text cannot be read.
    pub fn remembered() -> Self {
        platform::remembered(Kept::Preferences).and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
    }

    /// Stores the preferences for the next start. A failure is only logged: the user chooses again next time.
    pub fn remember(self) {
        let kept = serde_json::to_string(&self).map_err(|error| Message::from(error.to_string()));
        if let Err(reason) = kept.and_then(|text| platform::remember(Kept::Preferences, &text)) {
            log::info!("the preferences are not kept: {}", reason.english());
        }
    }

    /// These preferences, overridden by the options of the page's URL.
    #[must_use]
    pub fn with(self, options: &AddressOptions) -> Self {
        Self { language: options.language.or(self.language), appearance: options.theme.unwrap_or(self.appearance) }
    }

    /// The chosen language, or the first supported one of the system.
    pub fn language(self) -> Language {
        self.language.unwrap_or_else(|| Language::of_preferences(platform::languages()))
    }

    /// Sets language and theme of the app; the language is also reported to the page.
    pub fn apply(self, context: &egui::Context) {
        language::set(self.language());
        platform::say_language(self.language().code());
        // where the system reports no theme, egui chooses the dark one
        context.set_theme(self.appearance.preference());
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn stored_preferences_are_read_back_and_missing_ones_are_the_defaults() {
        let chosen = Preferences { language: Some(Language::German), appearance: Appearance::Dark };
        let text = serde_json::to_string(&chosen).unwrap();
        assert_eq!(text, r#"{"language":"de","appearance":"dark"}"#);
        assert_eq!(serde_json::from_str::<Preferences>(&text).unwrap(), chosen);
        assert_eq!(serde_json::from_str::<Preferences>("{}").unwrap(), Preferences::default());
    }
}
