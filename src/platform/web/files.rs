//! Files from the dialog and from drag and drop, and downloads.

use super::page;
use crate::conformal::Side;
use crate::language::{Message, key};
use crate::model::files::{FilePurpose, endings, gathered};
use crate::platform::{Event, Mailbox};
use js_sys::{Array, Promise, Uint8Array};
use std::cell::Cell;
use wasm_bindgen::prelude::Closure;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, DragEvent, File, HtmlAnchorElement, HtmlInputElement, Url};

thread_local! {
    static LAST_DRAG: Cell<Option<egui::Pos2>> = const { Cell::new(None) };
}

/// Opens the file dialog and passes the chosen file to the app. The browser's dialog shows no label.
///
/// The browser opens its dialog only within seconds of a click or a key press, and ignores later requests without an
/// error; so the time is checked first. The input element is not added to the page, so that it needs no style, which
/// the page's content security policy would forbid.
pub fn pick_file(purpose: FilePurpose, _label: &str, mailbox: Mailbox) {
    wasm_bindgen_futures::spawn_local(async move {
        match picked(purpose).await {
            Ok(Some(file)) => page::hand_over(purpose, file.name(), content(&file).await, &mailbox),
            Ok(None) => (),
            Err(reason) => mailbox.post(Event::NoDialog(reason)),
        }
    });
}

/// The chosen file, or `None` if the dialog is cancelled. Errors: the dialog cannot be opened, as a full sentence.
async fn picked(purpose: FilePurpose) -> Result<Option<File>, Message> {
    if !may_open_dialog() {
        return Err(key::dialog_too_late().into());
    }
    shown_dialog(purpose).await.map_err(key::no_dialog)
}

/// Whether the last click or key press is recent enough for a dialog; `true` in browsers without `userActivation`.
fn may_open_dialog() -> bool {
    web_sys::window().is_none_or(|window| {
        let activation = window.navigator().user_activation();
        activation.is_undefined() || activation.is_active()
    })
}

async fn shown_dialog(purpose: FilePurpose) -> Result<Option<File>, Message> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or(key::no_page())?;
    let input = document.create_element("input")?.dyn_into::<HtmlInputElement>().map_err(JsValue::from)?;
    input.set_type("file");
    let accepted: Vec<String> = endings(purpose).iter().map(|extension| format!(".{extension}")).collect();
    input.set_accept(&accepted.join(","));
    let closed = Promise::new(&mut |resolve, _| {
        input.set_onchange(Some(&resolve));
        input.set_oncancel(Some(&resolve));
        input.click();
    });
    JsFuture::from(closed).await?;
    Ok(input.files().and_then(|files| files.get(0)))
}

/// The bytes of a file, or the reason why it cannot be read.
async fn content(file: &File) -> Result<Vec<u8>, String> {
    let bytes = JsFuture::from(file.array_buffer()).await.map_err(|error| super::worker_handle::describe(&error))?;
    Ok(Uint8Array::new(&bytes).to_vec())
}

/// Downloads a file.
#[allow(clippy::needless_pass_by_value, reason = "on the desktop they go into a thread")]
pub fn save_file(name: &str, bytes: Vec<u8>, mailbox: Mailbox) {
    if let Err(error) = download(name, &bytes) {
        mailbox.post(Event::NotSaved { name: name.to_owned(), reason: error });
    }
}

/// Follows a temporary link to the bytes.
fn download(name: &str, bytes: &[u8]) -> Result<(), Message> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or(key::no_page())?;
    let parts = Array::of1(&Uint8Array::from(bytes));
    let address = Url::create_object_url_with_blob(&Blob::new_with_u8_array_sequence(&parts)?)?;
    let link = document.create_element("a")?.dyn_into::<HtmlAnchorElement>().map_err(JsValue::from)?;
    link.set_href(&address);
    link.set_download(name);
    link.click();
    Ok(Url::revoke_object_url(&address)?)
}

/// Reads files that were dropped together and passes them to the app.
pub fn read_dropped(files: Vec<egui::DroppedFileHandle>, side: Side, mailbox: Mailbox) {
    wasm_bindgen_futures::spawn_local(async move {
        let mut read = Vec::with_capacity(files.len());
        for file in files {
            let name = file.path().to_string_lossy().into_owned();
            read.push((name, file.bytes_async().await));
        }
        for (name, bytes) in gathered(read) {
            page::hand_over(FilePurpose::Dropped(side), name, bytes, &mailbox);
        }
    });
}

/// The position of the pointer while a file is dragged over the page.
///
/// The browser sends no pointer events during such a drag; [`follow_drags`] records its drag events.
pub fn drop_position(context: &egui::Context) -> Option<egui::Pos2> {
    LAST_DRAG.get().map(|place| place / context.zoom_factor())
}

/// Records the positions of dragged files.
pub fn follow_drags(document: &web_sys::Document) {
    let note = Closure::<dyn FnMut(DragEvent)>::new(|event: DragEvent| {
        LAST_DRAG.set(Some(egui::pos2(event.client_x() as f32, event.client_y() as f32)));
        // outside of the canvas the browser would open the file instead of the page
        event.prevent_default();
    });
    for name in ["dragover", "drop"] {
        // in the capturing phase, since the canvas stops the propagation of these events
        let _ = document.add_event_listener_with_callback_and_bool(name, note.as_ref().unchecked_ref(), true);
    }
    note.forget();
}
