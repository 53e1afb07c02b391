//! The preferences of the user on this device: language and theme, and what was seen and unfolded.
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
    /// What the user has seen and unfolded.
    #[serde(skip_serializing_if = "are_new")]
    pub habits: Habits,
}

/// What the user has seen and unfolded on this device; the default is that of the first visit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(default, rename_all = "kebab-case")]
pub struct Habits {
    /// The welcome was used or closed.
    pub welcomed: bool,
    /// A dot was dragged or focused: the hint to drag one is not shown again.
    pub dragged: bool,
    /// The advanced controls are unfolded.
    pub advanced: bool,
}

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde passes references")]
fn are_new(habits: &Habits) -> bool {
    *habits == Habits::default()
}

impl Habits {
    /// These habits after one more.
    #[must_use]
    pub fn and(mut self, habit: Habit) -> Self {
        match habit {
            Habit::Welcomed => self.welcomed = true,
            Habit::Dragged => self.dragged = true,
            Habit::Advanced(open) => self.advanced = open,
        }
        self
    }
}

/// A change of the [`Habits`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Habit {
    /// The welcome was used or closed.
    Welcomed,
    /// A dot was dragged or focused.
    Dragged,
    /// The advanced controls were unfolded or folded.
    Advanced(bool),
}

impl Preferences {
    /// English and the dark theme, independent of the system: for screenshots and tests.
    pub fn fixed() -> Self {
        let habits = Habits { welcomed: true, ..Habits::default() };
        Self { language: Some(Language::English), appearance: Appearance::Dark, habits }
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
        let (language, appearance) = (options.language.or(self.language), options.theme.unwrap_or(self.appearance));
        Self { language, appearance, ..self }
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
        let chosen =
            Preferences { language: Some(Language::German), appearance: Appearance::Dark, ..Preferences::default() };
        let text = serde_json::to_string(&chosen).unwrap();
        assert_eq!(text, r#"{"language":"de","appearance":"dark"}"#);
        assert_eq!(serde_json::from_str::<Preferences>(&text).unwrap(), chosen);
        assert_eq!(serde_json::from_str::<Preferences>("{}").unwrap(), Preferences::default());
        let habits = [Habit::Dragged, Habit::Advanced(true)].into_iter().fold(Habits::default(), Habits::and);
        let text = serde_json::to_string(&Preferences { habits, ..chosen }).unwrap();
        assert_eq!(serde_json::from_str::<Preferences>(&text).unwrap().habits, habits);
    }
}
