//! What the screen alone knows: which panels are open, how large and in which colours all is shown, for whom.

use super::input::preferences::Preferences;
use super::status::FrameMeter;

/// The state of the screen that no session carries.
pub struct Screen {
    pub panels_open: bool,
    /// On a phone: the sheet of controls or plots.
    pub sheet_open: bool,
    /// How much larger than usual everything is in this frame.
    pub zoom: f32,
    /// The theme of this frame.
    pub theme: egui::Theme,
    pub has_fingers: bool,
    pub preferences: Preferences,
    pub meter: FrameMeter,
}

impl Screen {
    /// Before the first frame.
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
