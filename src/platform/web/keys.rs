//! Keys that the app uses and the browser would take away.

use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::{EventTarget, KeyboardEvent};

/// Keeps F6 from leading out of the page: the app begins to walk through its controls with it. With Shift or
/// Ctrl it is left to the browser, as the way out.
pub fn keep(canvas: &EventTarget) {
    let pressed = Closure::<dyn FnMut(KeyboardEvent)>::new(|event: KeyboardEvent| {
        if event.key() == "F6" && !event.shift_key() && !event.ctrl_key() {
            event.prevent_default();
        }
    });
    // Listening for a named event does not fail.
    let _ = canvas.add_event_listener_with_callback("keydown", pressed.as_ref().unchecked_ref());
    pressed.forget();
}
