//! Images in the browser, decoded by the browser itself.

use crate::language::{Message, key};
use crate::model::files::FilePurpose;
use crate::platform::{Event, Mailbox};
use ::image::RgbaImage;
use js_sys::{Array, Uint8Array};
use std::sync::Arc;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{Blob, ImageBitmap, OffscreenCanvas, OffscreenCanvasRenderingContext2d};

/// Decodes a PNG or JPEG, scaled down until no side is longer than `max_side`, and posts it to `mailbox`.
pub fn decode_image(purpose: FilePurpose, name: String, file: Arc<Vec<u8>>, max_side: u32, mailbox: Mailbox) {
    wasm_bindgen_futures::spawn_local(async move {
        let pixels = decode(&file, max_side).await.map_err(key::no_image);
        mailbox.post(Event::Image { purpose, name, file, pixels });
    });
}

/// Decodes an image by drawing it on a hidden canvas.
async fn decode(bytes: &[u8], max_side: u32) -> Result<RgbaImage, Message> {
    let parts = Array::of1(&Uint8Array::from(bytes));
    let blob = Blob::new_with_u8_array_sequence(&parts)?;
    let window = web_sys::window().ok_or(key::no_page())?;
    let bitmap: ImageBitmap = JsFuture::from(window.create_image_bitmap_with_blob(&blob)?).await?.dyn_into()?;
    let largest = bitmap.width().max(bitmap.height()).max(1);
    let scale = (f64::from(max_side) / f64::from(largest)).min(1.0);
    let [width, height] = [bitmap.width(), bitmap.height()].map(|side| (f64::from(side) * scale).floor().max(1.0));
    let canvas = OffscreenCanvas::new(width as u32, height as u32)?;
    let context: OffscreenCanvasRenderingContext2d =
        canvas.get_context("2d")?.ok_or(key::no_canvas_for_image())?.dyn_into().map_err(JsValue::from)?;
    context.draw_image_with_image_bitmap_and_dw_and_dh(&bitmap, 0.0, 0.0, width, height)?;
    let pixels = context.get_image_data(0.0, 0.0, width, height)?.data().0;
    bitmap.close();
    RgbaImage::from_raw(width as u32, height as u32, pixels).ok_or_else(|| key::size_does_not_fit().into())
}
