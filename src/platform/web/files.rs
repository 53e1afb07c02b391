//! Files from the dialog and from drag and drop, and to the downloads.

use super::page;
use crate::app::language::tr;
use crate::conformal::Side;
use crate::platform::{Event, FilePurpose, Mailbox, endings};
use js_sys::{Array, Uint8Array};
use std::cell::Cell;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, DragEvent, HtmlAnchorElement, Url};

thread_local! {
    static LAST_DRAG: Cell<Option<egui::Pos2>> = const { Cell::new(None) };
}

/// Lets the person choose a file, and hands it to the app.
pub fn pick_file(purpose: FilePurpose, mailbox: Mailbox) {
    let (label, extensions) = endings(purpose);
    let dialog = rfd::AsyncFileDialog::new().add_filter(tr(label), &extensions).pick_file();
    wasm_bindgen_futures::spawn_local(async move {
        if let Some(file) = dialog.await {
            let bytes = Ok(file.read().await);
            page::hand_over(purpose, file.file_name(), bytes, &mailbox);
        }
    });
}

/// Gives a file to the browser's downloads.
#[allow(clippy::needless_pass_by_value, reason = "on the desktop they go into a thread")]
pub fn save_file(name: &str, bytes: Vec<u8>, mailbox: Mailbox) {
    if let Err(error) = download(name, &bytes) {
        mailbox.post(Event::NotSaved { name: name.to_owned(), reason: super::worker_handle::describe(&error) });
    }
}

/// By a link to the bytes that is followed at once.
fn download(name: &str, bytes: &[u8]) -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or("there is no page")?;
    let parts = Array::of1(&Uint8Array::from(bytes));
    let address = Url::create_object_url_with_blob(&Blob::new_with_u8_array_sequence(&parts)?)?;
    let link = document.create_element("a")?.dyn_into::<HtmlAnchorElement>()?;
    link.set_href(&address);
    link.set_download(name);
    link.click();
    Url::revoke_object_url(&address)
}

/// Reads a dropped file and hands it to the app.
pub fn read_dropped(file: egui::DroppedFileHandle, side: Side, mailbox: Mailbox) {
    wasm_bindgen_futures::spawn_local(async move {
        let name = file.path().to_string_lossy().into_owned();
        let bytes = file.bytes_async().await;
        page::hand_over(FilePurpose::Dropped(side), name, bytes, &mailbox);
    });
}

/// Where the pointer is while a file is dragged over the page.
///
/// The browser sends no pointer events during such a drag; [`follow_drags`] notes its drag events.
pub fn drop_position(context: &egui::Context) -> Option<egui::Pos2> {
    LAST_DRAG.get().map(|place| place / context.zoom_factor())
}

/// Notes where files are dragged.
pub fn follow_drags(document: &web_sys::Document) {
    let note = Closure::<dyn FnMut(DragEvent)>::new(|event: DragEvent| {
        LAST_DRAG.set(Some(egui::pos2(event.client_x() as f32, event.client_y() as f32)));
        // Outside of the canvas the browser would open the file in place of the page.
        event.prevent_default();
    });
    for name in ["dragover", "drop"] {
        // In the capturing phase: the canvas stops these events from going up.
        let _ = document.add_event_listener_with_callback_and_bool(name, note.as_ref().unchecked_ref(), true);
    }
    note.forget();
}
