//! What a person has chosen for this device, whatever is on the screen: language and theme.
//!
//! Not part of a session: a link does not change how another person's app looks or speaks.

use crate::app::input::address_options::AddressOptions;
use crate::language::{self, Language, Message};
use crate::platform::{self, Kept};
use egui::ThemePreference;

/// Which of the themes is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Appearance {
    /// The one that the system shows.
    #[default]
    System,
    /// The light one.
    Light,
    /// The dark one.
    Dark,
}

impl Appearance {
    /// All of them, as they are listed in the menu.
    pub const ALL: [Self; 3] = [Self::System, Self::Light, Self::Dark];

    fn preference(self) -> ThemePreference {
        match self {
            Self::System => ThemePreference::System,
            Self::Light => ThemePreference::Light,
            Self::Dark => ThemePreference::Dark,
        }
    }
}

/// The choices; what is not chosen follows the system.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(default, rename_all = "kebab-case")]
pub struct Preferences {
    /// The language of the screen.
    pub language: Option<Language>,
    /// The theme.
    pub appearance: Appearance,
}

impl Preferences {
    /// English on the dark ground, whatever the system is like: a picture that is the same everywhere.
    pub fn fixed() -> Self {
        Self { language: Some(Language::English), appearance: Appearance::Dark }
    }

    /// Those of the last time. What cannot be read is as good as not chosen.
    pub fn remembered() -> Self {
        platform::remembered(Kept::Preferences).and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
    }

    /// Keeps them for the next time. A device that keeps nothing asks again: no reason to disturb anybody.
    pub fn remember(self) {
        let kept = serde_json::to_string(&self).map_err(|error| Message::from(error.to_string()));
        if let Err(reason) = kept.and_then(|text| platform::remember(Kept::Preferences, &text)) {
            log::info!("the preferences are not kept: {}", reason.english());
        }
    }

    /// With what an address asks for in their place.
    #[must_use]
    pub fn with(self, options: &AddressOptions) -> Self {
        Self { language: options.language.or(self.language), appearance: options.theme.unwrap_or(self.appearance) }
    }

    /// The language of the screen.
    pub fn language(self) -> Language {
        self.language.unwrap_or_else(|| Language::of_preferences(platform::languages()))
    }

    /// From now on the screen looks and speaks like this.
    pub fn apply(self, context: &egui::Context) {
        language::set(self.language());
        platform::say_language(self.language().code());
        // the dark one where the system shows none: egui's own choice
        context.set_theme(self.appearance.preference());
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_read_again_and_what_is_missing_is_the_systems() {
        let chosen = Preferences { language: Some(Language::German), appearance: Appearance::Dark };
        let text = serde_json::to_string(&chosen).unwrap();
        assert_eq!(text, r#"{"language":"de","appearance":"dark"}"#);
        assert_eq!(serde_json::from_str::<Preferences>(&text).unwrap(), chosen);
        assert_eq!(serde_json::from_str::<Preferences>("{}").unwrap(), Preferences::default());
    }
}
