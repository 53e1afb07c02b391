//! The page: canvas, loading indicator, failure messages.

use super::{address, bridge, files, keys};
use crate::model::files::FilePurpose;
use crate::platform::{Event, Failure, Host, Mailbox};
use eframe::WebRunner;
use std::cell::{Cell, RefCell};
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::{Document, HtmlCanvasElement};

/// Passes a file to the running app; returns it if the app cannot take it now.
type TakeFile = fn(&WebRunner, FilePurpose, FileBytes) -> Option<FileBytes>;

/// A file's name, and its content or the reason why it cannot be read.
type FileBytes = (String, Result<Vec<u8>, String>);

/// The app that runs in the page.
#[derive(Clone)]
struct Running {
    runner: WebRunner,
    take_file: TakeFile,
}

/// Words for a failure in the app's language.
type FailureWords = fn(&Failure) -> String;

thread_local! {
    static RUNNING: RefCell<Option<Running>> = const { RefCell::new(None) };
    /// [`Host::failure_words`] of the app.
    static FAILURE_WORDS: Cell<Option<FailureWords>> = const { Cell::new(None) };
}

/// Starts the app in the page's canvas.
pub fn start<H: Host>() {
    FAILURE_WORDS.set(Some(H::failure_words));
    std::panic::set_hook(Box::new(|info| {
        console_error_panic_hook::hook(info);
        show_failure(&Failure::Stopped(info.to_string()));
    }));
    wasm_bindgen_futures::spawn_local(async {
        if let Err(failure) = run::<H>().await {
            show_failure(&failure);
        }
    });
}

async fn run<H: Host>() -> Result<(), Failure> {
    let document = document().ok_or(Failure::NoPage)?;
    let canvas = document
        .get_element_by_id("canvas")
        .and_then(|element| element.dyn_into::<HtmlCanvasElement>().ok())
        .ok_or(Failure::NoCanvas)?;
    files::follow_drags(&document);
    watch_canvas(&canvas);
    keys::keep(&canvas);
    let runner = WebRunner::new();
    let startup = H::startup();
    address::follow(H::mailbox(&startup));
    wake_when_cancelled(&canvas, H::mailbox(&startup));
    let creator: eframe::AppCreator<'static> = Box::new(|creation| Ok(Box::new(H::open(creation, startup)?)));
    runner.start(canvas, web_options(H::avoids_webgpu()), creator).await.map_err(|error| {
        log::error!("{error:?}");
        Failure::NoGraphics(error.as_string().unwrap_or_default())
    })?;
    bridge::install::<H>(&runner);
    super::surroundings::tell_page(crate::platform::PageEvent::Ready, "");
    RUNNING.set(Some(Running { runner, take_file: take_file::<H> }));
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    Ok(())
}

fn take_file<H: Host>(runner: &WebRunner, purpose: FilePurpose, (name, bytes): FileBytes) -> Option<FileBytes> {
    match runner.app_mut::<H>() {
        Some(mut app) => {
            app.take_file(purpose, &name, bytes);
            None
        }
        None => Some((name, bytes)),
    }
}

/// Passes a file to the app between two frames, or through `mailbox` if the app is not available now.
pub fn hand_over(purpose: FilePurpose, name: String, bytes: Result<Vec<u8>, String>, mailbox: &Mailbox) {
    let left = match RUNNING.with_borrow(Clone::clone) {
        Some(Running { runner, take_file, .. }) => take_file(&runner, purpose, (name, bytes)),
        None => Some((name, bytes)),
    };
    if let Some((name, bytes)) = left {
        mailbox.post(Event::File { purpose, name, bytes });
    }
}

/// `?backend=webgl` disables WebGPU, for comparison and for tests.
fn web_options(avoids_webgpu: bool) -> eframe::WebOptions {
    let mut setup = egui_wgpu::WgpuSetupCreateNew::without_display_handle();
    if avoids_webgpu {
        setup.instance_descriptor.backends = wgpu::Backends::GL;
    }
    eframe::WebOptions {
        wgpu_options: egui_wgpu::WgpuConfiguration { wgpu_setup: setup.into(), ..Default::default() },
        // no gradient is fine enough to need it
        dithering: false,
        ..Default::default()
    }
}

/// The decoded names and values of the address's query, in order.
pub fn address_query() -> Vec<[String; 2]> {
    let pairs = || {
        let query = web_sys::window()?.location().search().ok()?;
        let entries = web_sys::UrlSearchParams::new_with_str(&query).ok()?.entries();
        let pairs = entries.into_iter().flatten().map(|pair| js_sys::Array::from(&pair));
        Some(pairs.map(|pair| [pair.get(0), pair.get(1)].map(|text| text.as_string().unwrap_or_default())).collect())
    };
    pairs().unwrap_or_default()
}

/// Ends the app when the device is lost: WebGPU calls back, for WebGL the canvas gets an event.
pub fn watch_graphics(device: &wgpu::Device, _mailbox: Mailbox) {
    device.set_device_lost_callback(|_reason, message| {
        log::error!("the graphics device was lost: {message}");
        lose_graphics();
    });
}

fn watch_canvas(canvas: &HtmlCanvasElement) {
    let lost = Closure::<dyn FnMut()>::new(lose_graphics);
    // listening to a named event does not fail
    let _ = canvas.add_event_listener_with_callback("webglcontextlost", lost.as_ref().unchecked_ref());
    lost.forget();
}

/// Requests a frame when a touch is cancelled: the drag ends in that frame, and nothing else requests one.
fn wake_when_cancelled(canvas: &HtmlCanvasElement, mailbox: Mailbox) {
    let cancelled = Closure::<dyn FnMut(web_sys::Event)>::new(move |event: web_sys::Event| {
        spare_prevention(&event);
        mailbox.wake();
    });
    let _ = canvas.add_event_listener_with_callback("touchcancel", cancelled.as_ref().unchecked_ref());
    cancelled.forget();
}

/// Makes `preventDefault` of an event that cannot be prevented act as `stopPropagation`. Otherwise the browser logs a
/// warning for each call, and eframe, whose listener comes later, calls it for each `touchcancel`.
fn spare_prevention(event: &web_sys::Event) {
    if !event.cancelable()
        && let Ok(stop) = js_sys::Reflect::get(event, &"stopPropagation".into())
    {
        // a property of a browser object can be set
        let _ = js_sys::Reflect::set(event, &"preventDefault".into(), &stop);
    }
}

/// Stops drawing and shows the reason. A frame may be in progress, so the app is destroyed after it.
fn lose_graphics() {
    show_failure(&Failure::GraphicsLost);
    wasm_bindgen_futures::spawn_local(async {
        if let Some(Running { runner, .. }) = RUNNING.take() {
            runner.destroy();
        }
    });
}

/// Shows a failure instead of the picture. Only the first one, since later failures follow from it.
fn show_failure(failure: &Failure) {
    let (Some(document), Some(words)) = (document(), FAILURE_WORDS.get()) else { return };
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    let [place, text] = ["failure", "failure-text"].map(|id| document.get_element_by_id(id));
    if let (Some(place), Some(text)) = (place, text)
        && place.has_attribute("hidden")
    {
        text.set_text_content(Some(&words(failure)));
        let _ = place.remove_attribute("hidden");
    }
}

fn document() -> Option<Document> {
    web_sys::window()?.document()
}
