//! The page: canvas, loading indicator, failure messages; another canvas and device after the graphics were lost.

use super::{address, bridge, files, keys};
use crate::model::files::FilePurpose;
use crate::platform::{Event, Failure, Host, Mailbox};
use eframe::WebRunner;
use std::cell::{Cell, RefCell};
use std::rc::Rc;
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
struct Running {
    runner: WebRunner,
    take_file: TakeFile,
    /// Rebuilds the graphics.
    rebuild: fn(WebRunner, Mailbox),
    mailbox: Mailbox,
}

/// The most losses of the graphics, in [`LOSSES_WITHIN_MS`], after which they are rebuilt: more mean that the map itself
/// is what the device cannot draw.
const MOST_LOSSES: usize = 3;
/// The time in which losses are counted, in ms.
const LOSSES_WITHIN_MS: f64 = 60_000.0;
/// The waits before each attempt to get another device, in ms: after a reset a driver takes a moment.
const WAITS_MS: [i32; 5] = [0, 100, 500, 2000, 5000];
/// The attributes of the canvas that another one takes over; its style would violate the page's policy.
const CANVAS_ATTRIBUTES: [&str; 4] = ["id", "role", "aria-label", "aria-describedby"];

/// Words for a failure in the app's language.
type FailureWords = fn(&Failure) -> String;

thread_local! {
    static RUNNING: RefCell<Option<Running>> = const { RefCell::new(None) };
    /// The number of the graphics device, counted from 0; reports about a former one are ignored.
    static DEVICE: Cell<u32> = const { Cell::new(0) };
    /// When the graphics were lost.
    static LOSSES: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
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
    RUNNING.set(Some(Running { runner, take_file: take_file::<H>, rebuild: rebuild::<H>, mailbox }));
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    Ok(())
}

fn canvas(document: &Document) -> Result<HtmlCanvasElement, Failure> {
    let canvas = document.get_element_by_id("canvas").and_then(|element| element.dyn_into().ok());
    canvas.ok_or(Failure::NoCanvas)
}

/// Listens to what happens to a canvas.
fn attend(canvas: &HtmlCanvasElement, mailbox: Mailbox) {
    watch_canvas(canvas);
    keys::keep(canvas);
    wake_when_cancelled(canvas, mailbox);
}

/// Takes the app out of its runner and starts it again, on another canvas with another device.
fn rebuild<H: Host>(runner: WebRunner, mailbox: Mailbox) {
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

/// Rebuilds the graphics when the device is lost: WebGPU calls back, for WebGL the canvas gets an event.
pub fn watch_graphics(device: &wgpu::Device, _mailbox: Mailbox) {
    let number = DEVICE.get();
    device.set_device_lost_callback(move |_reason, message| {
        log::warn!("the graphics device was lost: {message}");
        lose_graphics(number);
    });
}

fn watch_canvas(canvas: &HtmlCanvasElement) {
    let number = DEVICE.get();
    let lost = Closure::<dyn FnMut()>::new(move || lose_graphics(number));
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

/// Rebuilds the graphics after the loss of the device of this number. A frame may be in progress: the app is taken out
/// of its runner after it. Before the app runs there is nothing to rebuild.
fn lose_graphics(number: u32) {
    if number != DEVICE.get() {
        return;
    }
    DEVICE.set(number + 1);
    match RUNNING.with_borrow(Clone::clone) {
        Some(Running { runner, rebuild, mailbox, .. }) => rebuild(runner, mailbox),
        None => show_failure(&Failure::GraphicsLost),
    }
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
