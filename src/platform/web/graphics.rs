//! Another canvas and device after the graphics were lost: the app is taken out of its runner and continues with all that
//! it knows. After several losses in a short time the page says so instead.

use super::page::{Held, Running, attend, canvas, document, running, show_failure, web_options};
use crate::platform::{Failure, Host, Mailbox};
use eframe::WebRunner;
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::HtmlCanvasElement;

/// The most losses of the graphics, in [`LOSSES_WITHIN_MS`], after which they are rebuilt: more mean that the map itself
/// is what the device cannot draw.
const MOST_LOSSES: usize = 3;
/// The time in which losses are counted, in ms.
const LOSSES_WITHIN_MS: f64 = 60_000.0;
/// The waits before each attempt to get another device, in ms: after a reset a driver takes a moment.
const WAITS_MS: [i32; 5] = [0, 100, 500, 2000, 5000];
/// The attributes of the canvas that another one takes over; its style would violate the page's policy.
const CANVAS_ATTRIBUTES: [&str; 4] = ["id", "role", "aria-label", "aria-describedby"];

thread_local! {
    /// The number of the graphics device, counted from 0; reports about a former one are ignored.
    static DEVICE: Cell<u32> = const { Cell::new(0) };
    /// When the graphics were lost.
    static LOSSES: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
}

/// Rebuilds the graphics when the device is lost: WebGPU calls back, for WebGL the canvas gets an event. Calls on a lost
/// device fail before anyone is told of the loss, with an error that would be a panic; any such error counts as a loss.
pub fn watch_graphics(device: &wgpu::Device, _mailbox: Mailbox) {
    let number = DEVICE.get();
    device.set_device_lost_callback(move |_reason, message| {
        log::warn!("the graphics device was lost: {message}");
        lose_graphics(number);
    });
    device.on_uncaptured_error(Arc::new(move |error| {
        log::warn!("the graphics device failed: {error}");
        lose_graphics(number);
    }));
}

/// Listens to the loss of a canvas's context.
pub fn watch_canvas(canvas: &HtmlCanvasElement) {
    let number = DEVICE.get();
    let lost = Closure::<dyn FnMut()>::new(move || lose_graphics(number));
    // listening to a named event does not fail
    let _ = canvas.add_event_listener_with_callback("webglcontextlost", lost.as_ref().unchecked_ref());
    lost.forget();
}

/// Rebuilds the graphics after the loss of the device of this number. A frame may be in progress: the app is taken out
/// of its runner after it. Before the app runs there is nothing to rebuild.
fn lose_graphics(number: u32) {
    if number != DEVICE.get() {
        return;
    }
    DEVICE.set(number + 1);
    match running() {
        Some(Running { runner, rebuild, mailbox, .. }) => rebuild(runner, mailbox),
        None => show_failure(&Failure::GraphicsLost),
    }
}

/// Takes the app out of its runner and starts it again, on another canvas with another device.
pub fn rebuild<H: Host>(runner: WebRunner, mailbox: Mailbox) {
    wasm_bindgen_futures::spawn_local(async move {
        if let Err(failure) = reopened::<H>(&runner, mailbox).await {
            show_failure(&failure);
            runner.destroy();
        }
    });
}

async fn reopened<H: Host>(runner: &WebRunner, mailbox: Mailbox) -> Result<(), Failure> {
    if has_lost_too_often() {
        return Err(Failure::GraphicsLost);
    }
    let app = runner.app_mut::<Held<H>>().and_then(|mut held| held.0.take()).ok_or(Failure::GraphicsLost)?;
    let app = Rc::new(RefCell::new(Some(app)));
    for wait_ms in WAITS_MS {
        wait(wait_ms).await;
        let canvas = another_canvas().ok_or(Failure::NoCanvas)?;
        attend(&canvas, mailbox.clone());
        let app = Rc::clone(&app);
        let creator: eframe::AppCreator<'static> = Box::new(move |creation| {
            let mut app = app.take().ok_or("gone")?;
            app.reopen(creation);
            Ok(Box::new(Held(Some(app))))
        });
        match runner.start(canvas, web_options(H::avoids_webgpu()), creator).await {
            Ok(()) => return Ok(()),
            Err(error) => log::warn!("no graphics after a loss: {error:?}"),
        }
    }
    Err(Failure::GraphicsLost)
}

/// Notes a loss; returns whether there were too many in a short time.
fn has_lost_too_often() -> bool {
    let now = js_sys::Date::now();
    LOSSES.with_borrow_mut(|losses| {
        losses.retain(|at| now - at < LOSSES_WITHIN_MS);
        losses.push(now);
        losses.len() > MOST_LOSSES
    })
}

/// Puts another canvas in the place of the present one, whose context is lost for good.
fn another_canvas() -> Option<HtmlCanvasElement> {
    let document = document()?;
    let former = canvas(&document).ok()?;
    let canvas = document.create_element("canvas").ok()?.dyn_into::<HtmlCanvasElement>().ok()?;
    for name in CANVAS_ATTRIBUTES {
        if let Some(value) = former.get_attribute(name) {
            canvas.set_attribute(name, &value).ok()?;
        }
    }
    former.replace_with_with_node_1(&canvas).ok()?;
    Some(canvas)
}

/// Waits for a time in ms.
async fn wait(ms: i32) {
    let passed = js_sys::Promise::new(&mut |resolve, _| {
        let set = |window: web_sys::Window| window.set_timeout_with_callback_and_timeout_and_arguments_0(&resolve, ms);
        // without a window nothing is waited for
        if web_sys::window().map(set).is_none_or(|set| set.is_err()) {
            let _ = resolve.call0(&wasm_bindgen::JsValue::NULL);
        }
    });
    let _ = wasm_bindgen_futures::JsFuture::from(passed).await;
}
