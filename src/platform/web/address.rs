//! The page's address and the browser's storage: sessions in links, and what is stored between visits.

use super::store;
use super::surroundings::is_framed;
use crate::language::{Message, key};
use crate::platform::{Event, Kept, Mailbox};
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{PopStateEvent, Window};

/// The key in local storage.
fn storage_key(what: Kept) -> &'static str {
    match what {
        Kept::Session => "riemap session",
        Kept::Preferences => "riemap preferences",
        Kept::Lesson => "riemap lesson",
    }
}

/// The key in local storage of the id of the visit whose session was stored last: each tab stores its own.
const VISIT_OF_TEXT: &str = "riemap-visit";

/// The fragment of the address if it contains a session.
pub fn link() -> Option<String> {
    fragment().filter(|fragment| crate::session::link::is_link(fragment))
}

/// The fragment of the address if it contains a lesson.
pub fn lesson_link() -> Option<String> {
    fragment().filter(|fragment| crate::session::lesson::is_link(fragment))
}

fn fragment() -> Option<String> {
    web_sys::window()?.location().hash().ok()
}

/// The property of a history entry's state that holds the id of its visit.
const VISIT: &str = "riemap";

/// The id of the visit that this entry of the browser's history shows.
pub fn visit() -> Option<String> {
    let state = web_sys::window()?.history().ok()?.state().ok()?;
    visit_of(&state)
}

fn visit_of(state: &JsValue) -> Option<String> {
    // reading a property of null or of a number fails
    js_sys::Reflect::get(state, &VISIT.into()).ok()?.as_string()
}

fn state_of(id: &str) -> JsValue {
    let state = js_sys::Object::new();
    // setting a plain property of a new object does not fail
    let _ = js_sys::Reflect::set(&state, &VISIT.into(), &id.into());
    state.into()
}

/// An id for a new visit; `None` if sessions are not kept here.
pub fn new_visit() -> Option<String> {
    let random = (js_sys::Math::random() * 1e9) as u64;
    keeps_sessions().then(|| format!("{:x}-{random:x}", js_sys::Date::now() as u64))
}

/// Makes this entry of the browser's history show a visit, or, if it shows another one already, a new entry.
pub fn begin_visit(id: &str) {
    store::hold(id);
    show_visit(id, visit().is_some());
}

/// Gives the visit that this entry of the browser's history shows another id.
pub fn rename_visit(id: &str) {
    show_visit(id, false);
}

fn show_visit(id: &str, in_new_entry: bool) {
    let show = |window: Window| {
        let history = window.history().ok()?;
        if in_new_entry {
            history.push_state_with_url(&state_of(id), "", None).ok()
        } else {
            history.replace_state_with_url(&state_of(id), "", None).ok()
        }
    };
    if web_sys::window().and_then(show).is_none() {
        log::warn!("the browser's history could not be changed");
    }
}

/// Replaces the fragment of the address without adding an entry to the browser's history.
pub fn show_link(fragment: &str) {
    let replace = |window: Window| {
        let history = window.history().ok()?;
        let state = history.state().unwrap_or(JsValue::NULL);
        history.replace_state_with_url(&state, "", Some(&format!("#{fragment}"))).ok()
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

/// Sessions with a longer text are stored in the database only.
const MOST_TEXT: usize = 1 << 20;

/// Stores a text for [`remembered`]. Errors: the browser stores nothing for the page, or not that much.
pub fn remember(what: Kept, text: &str) -> Result<(), Message> {
    if !is_kept(what) {
        return Ok(());
    }
    let storage = |window: Window| window.local_storage().ok()?;
    let storage = web_sys::window().and_then(storage).ok_or(key::browser_stores_nothing())?;
    if what == Kept::Session && text.len() > MOST_TEXT {
        // an old copy must not be taken for the newest
        let _ = storage.remove_item(storage_key(what));
        return Err(key::too_long_to_store(text.len()));
    }
    storage.set_item(storage_key(what), text).map_err(|_| key::too_long_to_store(text.len()))?;
    if what == Kept::Session {
        // without it the text is taken for that of the record found
        let _ = match visit() {
            Some(id) => storage.set_item(VISIT_OF_TEXT, &id),
            None => storage.remove_item(VISIT_OF_TEXT),
        };
    }
    Ok(())
}

/// The visit whose session was stored last as a text; `None` if it is not known.
pub fn visit_of_text() -> Option<String> {
    web_sys::window()?.local_storage().ok()??.get_item(VISIT_OF_TEXT).ok()?
}

/// Whether sessions are kept here.
pub fn keeps_sessions() -> bool {
    is_kept(Kept::Session)
}

/// Whether the text is stored at all. The session of an embedded page, and its lesson, are neither stored nor restored, whatever the
/// options, since it is not the user's own work. The same holds for an embedded page opened in its own window.
fn is_kept(what: Kept) -> bool {
    let is_embedded = || super::address_query().iter().any(|[name, _]| name == "embed");
    what == Kept::Preferences || !(is_framed() || is_embedded())
}

/// The text that was stored last.
pub fn remembered(what: Kept) -> Option<String> {
    if !is_kept(what) {
        return None;
    }
    web_sys::window()?.local_storage().ok()??.get_item(storage_key(what)).ok()?
}

/// Posts the address whenever the user changes its fragment, and the visit when the user goes back or forward to one.
pub fn follow(mailbox: Mailbox) {
    let Some(window) = web_sys::window() else { return };
    let gone = {
        let mailbox = mailbox.clone();
        Closure::<dyn FnMut(PopStateEvent)>::new(move |event: PopStateEvent| {
            if let Some(id) = visit_of(&event.state()) {
                mailbox.post(Event::GoneTo(id));
            }
        })
    };
    let stored = {
        let mailbox = mailbox.clone();
        Closure::<dyn FnMut(JsValue)>::new(move |event: JsValue| {
            let key = js_sys::Reflect::get(&event, &"key".into()).ok().and_then(|key| key.as_string());
            if key.as_deref() == Some(storage_key(Kept::Lesson)) {
                mailbox.post(Event::StoredElsewhere(Kept::Lesson));
            }
        })
    };
    let changed = Closure::<dyn FnMut()>::new(move || {
        // an entry that shows a visit is not a new address: `popstate` has told
        if let Some(fragment) = lesson_link().or_else(link).filter(|_| visit().is_none()) {
            mailbox.post(Event::Link(fragment));
        }
    });
    // listening to a named event does not fail
    let _ = window.add_event_listener_with_callback("storage", stored.as_ref().unchecked_ref());
    let _ = window.add_event_listener_with_callback("popstate", gone.as_ref().unchecked_ref());
    let _ = window.add_event_listener_with_callback("hashchange", changed.as_ref().unchecked_ref());
    stored.forget();
    gone.forget();
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

/// Whether the user has asked the system for less motion.
pub fn wants_calm() -> bool {
    let query = |window: Window| window.match_media("(prefers-reduced-motion: reduce)").ok()?;
    web_sys::window().and_then(query).is_some_and(|query| query.matches())
}
