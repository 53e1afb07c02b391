//! The screen's own state: open panels, zoom, theme, preferences. None of it is part of a session.

use super::input::preferences::Preferences;
use super::status::FrameMeter;

/// The state of the screen that is not part of a session.
pub struct Screen {
    pub panels_open: bool,
    /// Whether the sheet of controls or plots is open; used on narrow screens only.
    pub sheet_open: bool,
    /// egui's zoom factor in this frame.
    pub zoom: f32,
    /// The theme of this frame.
    pub theme: egui::Theme,
    pub has_fingers: bool,
    pub preferences: Preferences,
    pub meter: FrameMeter,
}

impl Screen {
    /// The state before the first frame.
    pub fn new(preferences: Preferences, panels_open: bool, has_fingers: bool) -> Self {
        Self {
            panels_open,
            sheet_open: false,
            zoom: 1.0,
            theme: egui::Theme::Dark,
            has_fingers,
            preferences,
            meter: FrameMeter::default(),
        }
    }
}
