//! The page's address and the browser's storage: sessions in links, and what is stored between visits.

use super::surroundings::is_framed;
use crate::language::{Message, key};
use crate::platform::{Event, Kept, Mailbox};
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::Window;

/// The key in local storage.
fn storage_key(what: Kept) -> &'static str {
    match what {
        Kept::Session => "riemap session",
        Kept::Preferences => "riemap preferences",
    }
}

/// The fragment of the address if it contains a session.
pub fn link() -> Option<String> {
    let fragment = web_sys::window()?.location().hash().ok()?;
    crate::session::link::is_link(&fragment).then_some(fragment)
}

/// Replaces the fragment of the address without adding an entry to the browser's history.
pub fn show_link(fragment: &str) {
    let replace = |window: Window| {
        window.history().ok()?.replace_state_with_url(&JsValue::NULL, "", Some(&format!("#{fragment}"))).ok()
    };
    if web_sys::window().and_then(replace).is_none() {
        log::warn!("the address could not be changed");
    }
}

/// The address of this page with another fragment.
pub fn address_with(fragment: &str) -> String {
    let address = web_sys::window().and_then(|window| window.location().href().ok()).unwrap_or_default();
    let page = address.split('#').next().unwrap_or_default();
    format!("{page}#{fragment}")
}

/// Stores a text for [`remembered`]. Errors: the browser stores nothing for the page, or not that much.
pub fn remember(what: Kept, text: &str) -> Result<(), Message> {
    if !is_kept(what) {
        return Ok(());
    }
    let storage = |window: Window| window.local_storage().ok()?;
    let storage = web_sys::window().and_then(storage).ok_or(key::browser_stores_nothing())?;
    storage.set_item(storage_key(what), text).map_err(|_| key::too_long_to_store(text.len()))
}

/// Whether the text is stored at all. The session of an embedded page is neither stored nor restored, whatever the
/// options, since it is not the user's own work. The same holds for an embedded page opened in its own window.
fn is_kept(what: Kept) -> bool {
    let is_embedded = || super::address_query().iter().any(|[name, _]| name == "embed");
    what != Kept::Session || !(is_framed() || is_embedded())
}

/// The text that was stored last.
pub fn remembered(what: Kept) -> Option<String> {
    if !is_kept(what) {
        return None;
    }
    web_sys::window()?.local_storage().ok()??.get_item(storage_key(what)).ok()?
}

/// Posts the address whenever the user changes its fragment.
pub fn follow(mailbox: Mailbox) {
    let changed = Closure::<dyn FnMut()>::new(move || {
        if let Some(fragment) = link() {
            mailbox.post(Event::Link(fragment));
        }
    });
    if let Some(window) = web_sys::window() {
        // listening to a named event does not fail
        let _ = window.add_event_listener_with_callback("hashchange", changed.as_ref().unchecked_ref());
    }
    changed.forget();
}

/// The tags of the user's languages, the preferred one first.
pub fn languages() -> Vec<String> {
    let navigator = web_sys::window().map(|window| window.navigator());
    let tags = navigator.map(|navigator| navigator.languages());
    tags.into_iter().flatten().filter_map(|tag| tag.as_string()).collect()
}

/// Declares the page's language, by which screen readers choose the pronunciation.
pub fn say_language(code: &str) {
    let page = web_sys::window().and_then(|window| window.document()?.document_element());
    if page.is_none_or(|page| page.set_attribute("lang", code).is_err()) {
        log::warn!("the page's language could not be set");
    }
}

/// Whether the screen can be touched, before its first touch.
pub fn has_fingers() -> bool {
    let query = |window: Window| window.match_media("(any-pointer: coarse)").ok()?;
    web_sys::window().and_then(query).is_some_and(|query| query.matches())
}
