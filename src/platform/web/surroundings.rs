//! The page around the app, which is told of changes, and full screen.

use super::worker_handle::describe;
use crate::language::key;
use crate::platform::{Event, Mailbox, PageEvent};
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::JsFuture;
use web_sys::{CustomEvent, CustomEventInit, Document, ShareData, Window};

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

/// Whether the system has a dialog of its own that shares a link.
pub fn can_share() -> bool {
    let navigator = web_sys::window().map(|window| window.navigator());
    navigator.is_some_and(|navigator| js_sys::Reflect::has(&navigator, &"share".into()).unwrap_or(false))
}

/// Passes a link to the system's dialog. That it was closed without a choice is no error.
pub fn share(address: &str, mailbox: Mailbox) {
    let Some(window) = web_sys::window() else { return };
    let link = ShareData::new();
    link.set_title(&window.document().map(|document| document.title()).unwrap_or_default());
    link.set_url(address);
    let answer = window.navigator().share_with_data(&link);
    wasm_bindgen_futures::spawn_local(async move {
        let Err(error) = JsFuture::from(answer).await else { return };
        let name = js_sys::Reflect::get(&error, &"name".into()).ok().and_then(|name| name.as_string());
        if name.as_deref() != Some("AbortError") {
            mailbox.post(Event::NoDialog(key::not_shared(describe(&error))));
        }
    });
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
