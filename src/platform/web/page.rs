//! The page: canvas, loading indicator, failure messages.

use super::{address, bridge, files, graphics, keys};
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

/// The app in its runner; it is taken out while the graphics are rebuilt.
pub struct Held<H>(pub Option<H>);

impl<H: Host> eframe::App for Held<H> {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        if let Some(app) = &mut self.0 {
            app.ui(ui, frame);
        }
    }

    fn raw_input_hook(&mut self, context: &egui::Context, input: &mut egui::RawInput) {
        if let Some(app) = &mut self.0 {
            app.raw_input_hook(context, input);
        }
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        self.0.as_ref().map_or([0.0; 4], |app| app.clear_color(visuals))
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self)
    }
}

/// The app that runs in the page.
#[derive(Clone)]
pub struct Running {
    pub runner: WebRunner,
    take_file: TakeFile,
    /// Rebuilds the graphics.
    pub rebuild: fn(WebRunner, Mailbox),
    pub mailbox: Mailbox,
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
    let canvas = canvas(&document)?;
    files::follow_drags(&document);
    let runner = WebRunner::new();
    super::store::read_first().await;
    let startup = H::startup();
    let mailbox = H::mailbox(&startup);
    address::follow(mailbox.clone());
    attend(&canvas, mailbox.clone());
    let creator: eframe::AppCreator<'static> =
        Box::new(|creation| Ok(Box::new(Held(Some(H::open(creation, startup)?)))));
    runner.start(canvas, web_options(H::avoids_webgpu()), creator).await.map_err(|error| {
        log::error!("{error:?}");
        Failure::NoGraphics(error.as_string().unwrap_or_default())
    })?;
    bridge::install::<H>(&runner);
    super::surroundings::tell_page(crate::platform::PageEvent::Ready, "");
    RUNNING.set(Some(Running { runner, take_file: take_file::<H>, rebuild: graphics::rebuild::<H>, mailbox }));
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    Ok(())
}

/// The page's canvas.
pub fn canvas(document: &Document) -> Result<HtmlCanvasElement, Failure> {
    let canvas = document.get_element_by_id("canvas").and_then(|element| element.dyn_into().ok());
    canvas.ok_or(Failure::NoCanvas)
}

/// Listens to what happens to a canvas.
pub fn attend(canvas: &HtmlCanvasElement, mailbox: Mailbox) {
    graphics::watch_canvas(canvas);
    keys::keep(canvas);
    wake_when_cancelled(canvas, mailbox);
}

fn take_file<H: Host>(runner: &WebRunner, purpose: FilePurpose, (name, bytes): FileBytes) -> Option<FileBytes> {
    let held = runner.app_mut::<Held<H>>();
    match held.and_then(|held| std::cell::RefMut::filter_map(held, |held| held.0.as_mut()).ok()) {
        Some(mut app) => {
            app.take_file(purpose, &name, bytes);
            None
        }
        None => Some((name, bytes)),
    }
}

/// The app that runs in the page.
pub fn running() -> Option<Running> {
    RUNNING.with_borrow(Clone::clone)
}

/// Passes a file to the app between two frames, or through `mailbox` if the app is not available now.
pub fn hand_over(purpose: FilePurpose, name: String, bytes: Result<Vec<u8>, String>, mailbox: &Mailbox) {
    let left = match running() {
        Some(Running { runner, take_file, .. }) => take_file(&runner, purpose, (name, bytes)),
        None => Some((name, bytes)),
    };
    if let Some((name, bytes)) = left {
        mailbox.post(Event::File { purpose, name, bytes });
    }
}

/// `?backend=webgl` disables WebGPU, for comparison and for tests.
pub fn web_options(avoids_webgpu: bool) -> eframe::WebOptions {
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

/// Shows a failure instead of the picture. Only the first one, since later failures follow from it.
pub fn show_failure(failure: &Failure) {
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

/// The page's document.
pub fn document() -> Option<Document> {
    web_sys::window()?.document()
}
