//! The page around the app, which is told of changes, and full screen.

use super::worker_handle::describe;
use crate::platform::PageEvent;
use wasm_bindgen::JsValue;
use web_sys::{CustomEvent, CustomEventInit, Document, Window};

/// Whether this page is shown in a frame of another page; true if the browser does not tell.
pub fn is_framed() -> bool {
    let around = |window: &Window| window.parent().ok().flatten();
    // if the browser does not tell what is around the page, assume a frame
    web_sys::window().is_some_and(|window| around(&window).is_none_or(|parent| parent != window))
}

/// Whether the page may fill the screen: not on some phones, and in frames only with permission.
pub fn has_full_screen() -> bool {
    document().is_some_and(|document| document.fullscreen_enabled())
}

/// Switches full screen. The browser requires a click or a key press shortly before.
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

/// Dispatches an event on the window, for the page's scripts.
pub fn tell_page(event: PageEvent, detail: &str) {
    let name = match event {
        PageEvent::Ready => "riemap-ready",
        PageEvent::Session => "riemap-session",
        PageEvent::Error => "riemap-error",
    };
    let init = CustomEventInit::new();
    init.set_detail(&JsValue::from_str(detail));
    if let (Some(window), Ok(event)) = (web_sys::window(), CustomEvent::new_with_event_init_dict(name, &init)) {
        // dispatching an event with a known name does not fail
        let _ = window.dispatch_event(&event);
    }
}

fn document() -> Option<Document> {
    web_sys::window()?.document()
}
