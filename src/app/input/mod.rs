//! What a person asks for: the actions, who may ask, and the gestures and keys that ask.
//!
//! | what | file |
//! |---|---|
//! | the requests of the person at the screen | `action` |
//! | the options of the page's address | `address_options` |
//! | controls that the page's address keeps as they are | `locks` |
//! | theme, language and size of words | `preferences`, `presentation` |
//! | the dots under the pointer | `handles` |
//! | keys | `keyboard`, `keyboard_navigation` |
//! | fingers | `touches` |

pub mod action;
pub mod address_options;
pub mod handles;
pub mod keyboard;
pub mod keyboard_navigation;
pub mod locks;
pub mod preferences;
pub mod presentation;
pub mod touches;
