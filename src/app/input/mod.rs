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
//! | canceled touches | `touches` |

pub mod action;
pub mod address_options;
pub mod handles;
pub mod keyboard;
pub mod keyboard_navigation;
pub mod locks;
pub mod preferences;
pub mod presentation;
pub mod touches;

/// What a hand holds and has used, from one frame to the next.
#[derive(Default)]
pub struct Input {
    /// Files that were dropped since the last frame.
    pub dropped: Vec<egui::DroppedFileHandle>,
    /// Who gets the next key.
    pub keyboard: keyboard::Keyboard,
    /// Which finger is the pointer.
    pub touches: touches::Touches,
    /// The dots under the pointer, in a hand or with the keyboard.
    pub handles: handles::HandleState,
}
