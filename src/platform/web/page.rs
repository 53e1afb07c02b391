//! The page: canvas, loading indicator, messages when nothing can be drawn.

use super::{address, bridge, files, keys};
use crate::app::{Groundwork, RiemapApp};
use wasm_bindgen::JsCast;
use web_sys::{Document, HtmlCanvasElement};

const NO_GRAPHICS: &str = "riemap draws with WebGPU or WebGL 2, and this browser offers neither of them here. \
    A current Firefox, Chrome, Edge or Safari with hardware acceleration turned on will do.";

/// Starts the app in the page's canvas.
pub fn start() {
    std::panic::set_hook(Box::new(|info| {
        console_error_panic_hook::hook(info);
        show_failure(&format!("riemap has stopped because of an error in itself. Reload the page to go on. ({info})"));
    }));
    wasm_bindgen_futures::spawn_local(async {
        if let Err(message) = run().await {
            show_failure(&message);
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
    keys::keep(&canvas);
    let runner = eframe::WebRunner::new();
    let groundwork = Groundwork::resume();
    address::follow(groundwork.mailbox());
    let creator: eframe::AppCreator<'static> = Box::new(|creation| Ok(Box::new(RiemapApp::new(creation, groundwork)?)));
    runner.start(canvas, web_options(), creator).await.map_err(|error| {
        log::error!("{error:?}");
        format!("{NO_GRAPHICS} ({})", error.as_string().unwrap_or_default())
    })?;
    bridge::install(&runner);
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    Ok(())
}

/// `?backend=webgl` leaves WebGPU out, for comparison and for tests.
fn web_options() -> eframe::WebOptions {
    let mut setup = egui_wgpu::WgpuSetupCreateNew::without_display_handle();
    if query("backend").is_some_and(|backend| backend.eq_ignore_ascii_case("webgl")) {
        setup.instance_descriptor.backends = wgpu::Backends::GL;
    }
    eframe::WebOptions {
        wgpu_options: egui_wgpu::WgpuConfiguration { wgpu_setup: setup.into(), ..Default::default() },
        ..Default::default()
    }
}

/// Whether the address asks for the paper's tables: `?bench`.
pub fn asks_for_bench() -> bool {
    query("bench").is_some()
}

/// A parameter of the page's address.
fn query(name: &str) -> Option<String> {
    let query = web_sys::window()?.location().search().ok()?;
    web_sys::UrlSearchParams::new_with_str(&query).ok()?.get(name)
}

/// Puts `message` in the place of the picture.
fn show_failure(message: &str) {
    let Some(document) = document() else { return };
    if let Some(loading) = document.get_element_by_id("loading") {
        loading.remove();
    }
    if let Some(failure) = document.get_element_by_id("failure") {
        failure.set_text_content(Some(message));
        let _ = failure.remove_attribute("hidden");
    }
}

fn document() -> Option<Document> {
    web_sys::window()?.document()
}
