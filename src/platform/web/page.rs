//! The page: canvas, loading indicator, messages when nothing can be drawn.

use super::{address, bridge, files, keys};
use crate::app::address_options::AddressOptions;
use crate::app::language::{tr, tr_message, tr_with};
use crate::app::{Groundwork, RiemapApp};
use crate::platform::{Event, FilePurpose, Mailbox};
use eframe::WebRunner;
use std::cell::RefCell;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::Closure;
use web_sys::{Document, HtmlCanvasElement};

const NO_GRAPHICS: &str = "riemap draws with WebGPU or WebGL 2, and this browser offers neither of them here. \
    A current Firefox, Chrome, Edge or Safari with hardware acceleration turned on will do.";

const STOPPED: &str = "riemap has stopped because of an error in itself. Reload the page to go on. ({0})";
const GRAPHICS_LOST: &str = "The browser has taken the graphics away from this page, as it does after a crash of \
    the graphics driver, or when the computer slept. The map is kept: reload the page to go on with it.";

thread_local! {
    static RUNNER: RefCell<Option<WebRunner>> = const { RefCell::new(None) };
}

/// Starts the app in the page's canvas.
pub fn start() {
    std::panic::set_hook(Box::new(|info| {
        console_error_panic_hook::hook(info);
        show_failure(&tr_with(STOPPED, &[info]));
    }));
    wasm_bindgen_futures::spawn_local(async {
        if let Err(message) = run().await {
            show_failure(&tr_message(&message));
        }
    });
}

async fn run() -> Result<(), String> {
    let document = document().ok_or("There is no page to draw in.")?;
    let canvas = document
        .get_element_by_id("canvas")
        .and_then(|element| element.dyn_into::<HtmlCanvasElement>().ok())
        .ok_or("The page has no canvas.")?;
    files::follow_drags(&document);
    watch_canvas(&canvas);
    keys::keep(&canvas);
    let runner = WebRunner::new();
    let groundwork = Groundwork::resume();
    address::follow(groundwork.mailbox());
    wake_when_cancelled(&canvas, groundwork.mailbox());
    let creator: eframe::AppCreator<'static> = Box::new(|creation| Ok(Box::new(RiemapApp::new(creation, groundwork)?)));
    runner.start(canvas, web_options(), creator).await.map_err(|error| {
        log::error!("{error:?}");
        format!("{} ({})", tr(NO_GRAPHICS), error.as_string().unwrap_or_default())
    })?;
    bridge::install(&runner);
    super::surroundings::tell_page(crate::platform::PageEvent::Ready, "");
    RUNNER.set(Some(runner));
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    Ok(())
}

/// Hands a file that was read to the app: between two frames, or by `mailbox` where it cannot be had.
pub fn hand_over(purpose: FilePurpose, name: String, bytes: Result<Vec<u8>, String>, mailbox: &Mailbox) {
    let runner = RUNNER.with_borrow(Clone::clone);
    match runner.as_ref().and_then(WebRunner::app_mut::<RiemapApp>) {
        Some(mut app) => app.take_file(purpose, &name, bytes),
        None => mailbox.post(Event::File { purpose, name, bytes }),
    }
}

/// `?backend=webgl` leaves WebGPU out, for comparison and for tests.
fn web_options() -> eframe::WebOptions {
    let mut setup = egui_wgpu::WgpuSetupCreateNew::without_display_handle();
    if address_options().webgl {
        setup.instance_descriptor.backends = wgpu::Backends::GL;
    }
    eframe::WebOptions {
        wgpu_options: egui_wgpu::WgpuConfiguration { wgpu_setup: setup.into(), ..Default::default() },
        // nothing here shades so gently that it would show
        dithering: false,
        ..Default::default()
    }
}

/// What the page's address asks for.
pub fn address_options() -> AddressOptions {
    let pairs = || {
        let query = web_sys::window()?.location().search().ok()?;
        let entries = web_sys::UrlSearchParams::new_with_str(&query).ok()?.entries();
        let pairs = entries.into_iter().flatten().map(|pair| js_sys::Array::from(&pair));
        Some(pairs.map(|pair| [pair.get(0), pair.get(1)].map(|text| text.as_string().unwrap_or_default())).collect())
    };
    let pairs: Vec<[String; 2]> = pairs().unwrap_or_default();
    AddressOptions::parse(pairs.iter().map(|[name, value]| (name.as_str(), value.as_str())))
}

/// Ends the app when the device is lost: WebGPU says so itself, of WebGL the canvas does.
pub fn watch_graphics(device: &wgpu::Device, _mailbox: Mailbox) {
    device.set_device_lost_callback(|_reason, message| {
        log::error!("the graphics device was lost: {message}");
        lose_graphics();
    });
}

fn watch_canvas(canvas: &HtmlCanvasElement) {
    let lost = Closure::<dyn FnMut()>::new(lose_graphics);
    // Listening for a named event does not fail.
    let _ = canvas.add_event_listener_with_callback("webglcontextlost", lost.as_ref().unchecked_ref());
    lost.forget();
}

/// A touch that is taken away lets go in a frame that nobody else asks for.
fn wake_when_cancelled(canvas: &HtmlCanvasElement, mailbox: Mailbox) {
    let cancelled = Closure::<dyn FnMut()>::new(move || mailbox.wake());
    let _ = canvas.add_event_listener_with_callback("touchcancel", cancelled.as_ref().unchecked_ref());
    cancelled.forget();
}

/// Stops drawing and says why. A frame may be under way: what it uses is given back after it.
fn lose_graphics() {
    show_failure(tr(GRAPHICS_LOST));
    wasm_bindgen_futures::spawn_local(async {
        if let Some(runner) = RUNNER.take() {
            runner.destroy();
        }
    });
}

/// Puts `message` in the place of the picture; the first one, which is the cause of those that follow.
fn show_failure(message: &str) {
    let Some(document) = document() else { return };
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    let [failure, text] = ["failure", "failure-text"].map(|id| document.get_element_by_id(id));
    if let (Some(failure), Some(text)) = (failure, text)
        && failure.has_attribute("hidden")
    {
        text.set_text_content(Some(message));
        let _ = failure.remove_attribute("hidden");
    }
}

fn document() -> Option<Document> {
    web_sys::window()?.document()
}
