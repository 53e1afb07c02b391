//! Keys that the app uses although the browser has a function for them.

use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::{EventTarget, KeyboardEvent};

/// Prevents F6 from leaving the page: with it the app starts keyboard navigation through its controls. With Shift or
/// Ctrl it keeps the browser's function, as the way out.
pub fn keep(canvas: &EventTarget) {
    let pressed = Closure::<dyn FnMut(KeyboardEvent)>::new(|event: KeyboardEvent| {
        if event.key() == "F6" && !event.shift_key() && !event.ctrl_key() {
            event.prevent_default();
        }
    });
    // listening to a named event does not fail
    let _ = canvas.add_event_listener_with_callback("keydown", pressed.as_ref().unchecked_ref());
    pressed.forget();
}
