//! Text beside the canvas for screen readers.

/// Describes the control with the keyboard focus; read out at once.
pub fn say(text: &str) {
    put("spoken", text);
}

/// Describes the state of the picture; read out when nothing else is, and whenever the user asks for it.
pub fn describe(text: &str) {
    put("state", text);
}

/// A screen reader notices only changes, so a repeated text gets a silent space.
fn put(id: &str, text: &str) {
    let Some(element) = web_sys::window().and_then(|window| window.document()?.get_element_by_id(id)) else { return };
    let is_there = element.text_content().as_deref() == Some(text);
    element.set_text_content(Some(if is_there { format!("{text}\u{a0}") } else { text.to_owned() }.as_str()));
}
