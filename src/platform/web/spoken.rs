//! Sentences beside the canvas, for those who hear the page.

/// The control that has the keyboard: read out at once.
pub fn say(text: &str) {
    put("spoken", text);
}

/// The state of the picture: read out when nothing else is, and whenever a person asks for it.
pub fn describe(text: &str) {
    put("state", text);
}

/// Only a change is an event to a screen reader.
fn put(id: &str, text: &str) {
    let element = web_sys::window().and_then(|window| window.document()?.get_element_by_id(id));
    if let Some(element) = element.filter(|element| element.text_content().as_deref() != Some(text)) {
        element.set_text_content(Some(text));
    }
}
