//! `window.riemap`: an interface to the app for tests and for pages that embed it.
//!
//! * `riemap.stats()` → [`Host::Stats`] as an object,
//! * `riemap.session()` → the session as an object,
//! * `riemap.link()` → the fragment of an address that opens this session, or `null` if no link holds all its outlines,
//! * `riemap.open_session(object)` → `null`, or why the object is not a valid session; the map is updated
//!   once its domains are prepared,
//! * `riemap.open_link(text)` → the same for a link or its fragment; a lesson's is played,
//! * `riemap.load_outline("source" | "target", file_name, text)` → `true` if the side is known,
//! * `riemap.load_file("source" | "target", file_name, bytes)` → the same, for any file that can be dropped.
//!
//! After a panic they return `undefined`.

use super::page::Held;
use crate::conformal::Side;
use crate::model::files::FilePurpose;
use crate::platform::Host;
use crate::session::Session;
use crate::session::file::{self, FileError};
use eframe::WebRunner;
use js_sys::{Object, Reflect};
use serde::Serialize;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::Closure;

/// Adds the object to the page's window.
pub fn install<H: Host>(runner: &WebRunner) {
    let object = Object::new();
    let app = runner.clone();
    let stats = Closure::<dyn Fn() -> JsValue>::new(move || with_app::<H>(&app, |app| to_js(&app.stats())));
    let app = runner.clone();
    let session = Closure::<dyn Fn() -> JsValue>::new(move || with_app::<H>(&app, |app| session_to_js(app.session())));
    let app = runner.clone();
    let own_link = Closure::<dyn Fn() -> JsValue>::new(move || {
        with_app::<H>(&app, |app| app.link().map_or(JsValue::NULL, |fragment| format!("#{fragment}").into()))
    });
    let app = runner.clone();
    let load =
        Closure::<dyn Fn(String, String, String) -> JsValue>::new(move |side: String, name: String, text: String| {
            let Some(side) = side_named(&side) else { return JsValue::FALSE };
            with_app::<H>(&app, |app| {
                app.take_file(FilePurpose::Outline(side), &name, Ok(text.into_bytes()));
                JsValue::TRUE
            })
        });
    let app = runner.clone();
    let open = Closure::<dyn Fn(JsValue) -> JsValue>::new(move |value: JsValue| {
        with_app::<H>(&app, |app| match session_of(&value) {
            Ok(session) => {
                app.open_session(session);
                JsValue::NULL
            }
            Err(reason) => reason.into(),
        })
    });
    let app = runner.clone();
    let file = Closure::<dyn Fn(String, String, Vec<u8>) -> JsValue>::new(move |side: String, name: String, bytes| {
        let Some(side) = side_named(&side) else { return JsValue::FALSE };
        with_app::<H>(&app, |app| {
            app.take_file(FilePurpose::Outline(side), &name, Ok(bytes));
            JsValue::TRUE
        })
    });
    let app = runner.clone();
    let link = Closure::<dyn Fn(String) -> JsValue>::new(move |text: String| {
        with_app::<H>(&app, |app| app.open_link(&text).map_or_else(JsValue::from, |()| JsValue::NULL))
    });
    put(&object, "link", &own_link.into_js_value());
    put(&object, "open_link", &link.into_js_value());
    put(&object, "load_file", &file.into_js_value());
    put(&object, "open_session", &open.into_js_value());
    put(&object, "stats", &stats.into_js_value());
    put(&object, "session", &session.into_js_value());
    put(&object, "load_outline", &load.into_js_value());
    put(&js_sys::global(), "riemap", &object.into());
}

fn with_app<H: Host>(runner: &WebRunner, read: impl FnOnce(&mut H) -> JsValue) -> JsValue {
    let held = runner.app_mut::<Held<H>>();
    held.and_then(|mut held| held.0.as_mut().map(read)).unwrap_or(JsValue::UNDEFINED)
}

fn to_js(value: &impl Serialize) -> JsValue {
    let text = serde_json::to_string(value).unwrap_or_default();
    js_sys::JSON::parse(&text).unwrap_or(JsValue::UNDEFINED)
}

fn session_to_js(session: &Session) -> JsValue {
    let text = file::write_object(session).unwrap_or_default();
    js_sys::JSON::parse(&text).unwrap_or(JsValue::UNDEFINED)
}

/// Parses a session, or says why it is invalid. A value without JSON form is read as empty text and rejected.
fn session_of(value: &JsValue) -> Result<Session, String> {
    let text = js_sys::JSON::stringify(value).ok().and_then(|text| text.as_string());
    file::read_object(&text.unwrap_or_default()).map_err(|error| match error {
        FileError::Malformed(reason) => reason, // without the prefix, which speaks of a file
        other => other.to_string(),
    })
}

fn side_named(name: &str) -> Option<Side> {
    match name {
        "source" => Some(Side::Source),
        "target" => Some(Side::Target),
        _ => None,
    }
}

fn put(object: &Object, key: &str, value: &JsValue) {
    // setting a property of a plain object or of the window does not fail
    let _ = Reflect::set(object, &key.into(), value);
}
