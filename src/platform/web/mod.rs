//! The browser: one wasm binary for the page and its workers.
//!
//! [`start`] detects where it runs. In the page it starts the app in the canvas and installs
//! `window.riemap`; in a worker it listens for requests.

mod address;
mod bridge;
mod engine;
mod files;
mod graphics;
mod image;
mod keys;
mod live_region;
mod messages;
mod page;
mod preparer;
mod store;
mod study_runner;
mod surroundings;
mod worker_handle;

pub use address::{
    address_with, begin_visit, has_fingers, languages, lesson_link, link, new_visit, remember, remembered,
    say_language, show_link, visit, visit_of_text, wants_calm,
};
pub use files::{drop_position, pick_file, read_dropped, save_file};
pub use graphics::watch_graphics;
pub use image::decode_image;
pub use live_region::{describe, say};
pub use page::address_query;
pub use preparer::Preparer;
pub use store::{first_kept, keep, load_visit};
pub use study_runner::StudyRunner;
pub use surroundings::{can_share, has_full_screen, share, tell_page, toggle_full_screen};

use super::Host;
use wasm_bindgen::JsCast;
use web_sys::DedicatedWorkerGlobalScope;

/// Starts the app in a page, or the engine in a worker.
///
/// Returns at once; later errors are shown in the page.
#[allow(clippy::unnecessary_wraps, reason = "the desktop's start can fail")]
pub fn start<H: Host>() -> Result<(), String> {
    match js_sys::global().dyn_into::<DedicatedWorkerGlobalScope>() {
        Ok(scope) => engine::listen(&scope),
        Err(_) => page::start::<H>(),
    }
    Ok(())
}
