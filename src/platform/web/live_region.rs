//! Sentences beside the canvas, for those who hear the page.

/// The control that has the keyboard: read out at once.
pub fn say(text: &str) {
    put("spoken", text);
}

/// The state of the picture: read out when nothing else is, and whenever a person asks for it.
pub fn describe(text: &str) {
    put("state", text);
}

/// Only a change is an event to a screen reader: what is said twice gets a space that is not heard.
fn put(id: &str, text: &str) {
    let Some(element) = web_sys::window().and_then(|window| window.document()?.get_element_by_id(id)) else { return };
    let is_there = element.text_content().as_deref() == Some(text);
    element.set_text_content(Some(if is_there { format!("{text}\u{a0}") } else { text.to_owned() }.as_str()));
}
