//! What is around the app: the page, which is told of changes, and the screen, which it may fill.

use super::worker_handle::describe;
use crate::platform::PageEvent;
use wasm_bindgen::JsValue;
use web_sys::{CustomEvent, CustomEventInit, Document, Window};

/// Whether this page is shown in a frame of another one.
pub fn is_framed() -> bool {
    let around = |window: &Window| window.parent().ok().flatten();
    // where the browser does not say what is around the page, something is
    web_sys::window().is_some_and(|window| around(&window).is_none_or(|parent| parent != window))
}

/// Whether the page may fill the screen: phones of one maker do not let it, nor do frames without leave.
pub fn has_full_screen() -> bool {
    document().is_some_and(|document| document.fullscreen_enabled())
}

/// Fills the screen with the page, or no longer. The browser asks for a click or a key just before.
pub fn toggle_full_screen(_context: &egui::Context) {
    let Some(document) = document() else { return };
    if document.fullscreen_element().is_some() {
        document.exit_fullscreen();
    } else if let Some(page) = document.document_element()
        && let Err(error) = page.request_fullscreen()
    {
        log::error!("the screen could not be filled: {}", describe(&error));
    }
}

/// Tells the page's scripts, by an event of the window.
pub fn tell_page(event: PageEvent, detail: &str) {
    let name = match event {
        PageEvent::Ready => "riemap-ready",
        PageEvent::Session => "riemap-session",
        PageEvent::Error => "riemap-error",
    };
    let init = CustomEventInit::new();
    init.set_detail(&JsValue::from_str(detail));
    if let (Some(window), Ok(event)) = (web_sys::window(), CustomEvent::new_with_event_init_dict(name, &init)) {
        // An event of a known name is always dispatched.
        let _ = window.dispatch_event(&event);
    }
}

fn document() -> Option<Document> {
    web_sys::window()?.document()
}
