//! The screen's own state: open panels, zoom, theme, preferences. None of it is part of a session.

use super::input::preferences::Preferences;
use super::input::presentation::PRESENTATION_ZOOM;
use super::status::FrameMeter;

/// The state of the screen that is not part of a session.
#[allow(clippy::struct_excessive_bools, reason = "each is a state of its own: what is open, and what the device has")]
pub struct Screen {
    /// Whether the bars and the column of controls are shown.
    pub panels_open: bool,
    /// Whether the user has unfolded or folded the column of controls; used on wide screens only.
    pub column_asked: Option<bool>,
    /// Whether the sheet of controls or plots is open; used on narrow screens only.
    pub sheet_open: bool,
    /// egui's zoom factor in this frame.
    pub zoom: f32,
    /// The theme of this frame.
    pub theme: egui::Theme,
    pub has_fingers: bool,
    pub preferences: Preferences,
    /// Whether what the user has seen is stored for the next start.
    pub remembers: bool,
    pub meter: FrameMeter,
}

/// On a screen lower than this, in points, the column of controls is folded at first. Phones on their side (390) and a
/// laptop's window at 200 % (720 × 450, with 226 points left for each picture) have no width for it; the smallest laptop
/// screens (1280 × 720) have.
const LOW: f32 = 520.0;
/// On a screen narrower than this, in points, it is folded at first beside the panel of a lesson: together they would
/// leave a tablet (820) 288 points for the pictures.
const NARROW: f32 = 1000.0;

impl Screen {
    /// Whether the column of controls is unfolded, on a screen of this size and beside the panel of a lesson or not; in a
    /// presentation it is folded at first.
    pub fn column_open(&self, size: egui::Vec2, makes_lesson: bool) -> bool {
        let has_room = size.y >= LOW && (size.x >= NARROW || !makes_lesson);
        self.column_asked.unwrap_or(has_room && self.zoom < PRESENTATION_ZOOM)
    }

    /// The state before the first frame.
    pub fn new(preferences: Preferences, panels_open: bool, has_fingers: bool, remembers: bool) -> Self {
        Self {
            panels_open,
            column_asked: None,
            sheet_open: false,
            zoom: 1.0,
            theme: egui::Theme::Dark,
            has_fingers,
            preferences,
            remembers,
            meter: FrameMeter::default(),
        }
    }
}
