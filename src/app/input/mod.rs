//! User input: the actions, the locks that refuse them, and the gestures and keys that produce them.
//!
//! | content | file |
//! |---|---|
//! | the requests of the user | `action` |
//! | the options in the page's URL | `address_options` |
//! | controls that the page's URL locks | `locks` |
//! | theme, language and zoom | `preferences`, `presentation` |
//! | hit test and drag state of the four dots | `handles` |
//! | keyboard focus, Tab and arrow keys | `keyboard`, `keyboard_navigation` |
//! | scrolling to news, and back to what has moved | `scrolling` |
//! | what catches a dragged dot | `snapping` |
//! | canceled touches | `touches` |
//! | whether gestures move the texture's picture | `picture_placing` |

pub mod action;
pub mod address_options;
pub mod handles;
pub mod keyboard;
pub mod keyboard_navigation;
pub mod locks;
pub mod picture_placing;
pub mod preferences;
pub mod presentation;
pub mod scrolling;
pub mod snapping;
pub mod touches;

/// The state of the input devices from one frame to the next, and the actions that wait.
#[derive(Default)]
pub struct Input {
    /// Files that were dropped since the last frame.
    pub dropped: Vec<egui::DroppedFileHandle>,
    /// Decides which keys fold the panels and which move the focus.
    pub keyboard: keyboard::Keyboard,
    /// The touch that egui treats as the pointer.
    pub touches: touches::Touches,
    /// The dots: hovered, dragged, or with the keyboard focus.
    pub handles: handles::HandleState,
    /// Actions that came after the last frame's were carried out: from buttons that are painted late, and from keys
    /// before the frame. The next frame carries them out first.
    pub asked: action::Actions,
}

impl Input {
    /// The state at the start of a user with these habits.
    pub fn after(habits: preferences::Habits) -> Self {
        let mut input = Self::default();
        input.handles.ever_dragged = habits.dragged;
        input
    }
}
