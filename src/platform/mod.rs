//! What differs between the web and the desktop: start-up, workers, dialogs, dropped files.
//!
//! The only room with `cfg(target_arch)`. `web` and `native` offer the same
//! names: [`start`], [`Preparer`], [`StudyRunner`], [`pick_file`], [`read_dropped`], [`decode_image`], [`save_file`],
//! [`drop_position`], [`address_query`], [`link`], [`show_link`], [`address_with`], [`remember`], [`remembered`],
//! [`languages`], [`say_language`], [`say`], [`describe`], [`has_fingers`], [`has_full_screen`], [`toggle_full_screen`], [`tell_page`],
//! [`watch_graphics`]. What happens outside of a frame arrives as an [`Event`] in the app's mailbox, in order, and
//! wakes the app; only files, on the web, are handed to the app itself, between two frames.

#[cfg(target_arch = "wasm32")]
mod web;
#[cfg(target_arch = "wasm32")]
pub use web::{
    Preparer, StudyRunner, address_query, address_with, decode_image, describe, drop_position, has_fingers,
    has_full_screen, languages, link, pick_file, read_dropped, remember, remembered, save_file, say, say_language,
    show_link, start, tell_page, toggle_full_screen, watch_graphics,
};

#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(not(target_arch = "wasm32"))]
mod native_image;
#[cfg(not(target_arch = "wasm32"))]
pub use native::{
    Preparer, StudyRunner, address_query, address_with, describe, drop_position, has_fingers, has_full_screen,
    languages, link, pick_file, read_dropped, remember, remembered, save_file, say, say_language, show_link, start,
    tell_page, toggle_full_screen, watch_graphics,
};
#[cfg(not(target_arch = "wasm32"))]
pub use native_image::decode_image;

mod host;

pub use host::{Failure, Host};

use crate::conformal::Side;
use crate::language::Message;
use crate::model::files::FilePurpose;
use crate::worker::{Finding, Response, Study};
use std::sync::{Arc, OnceLock, mpsc};

/// What is kept from one time to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kept {
    /// The session.
    Session,
    /// What the person prefers.
    Preferences,
}

/// Something that happened outside of a frame.
#[derive(Debug)]
pub enum Event {
    /// A worker answered.
    Worker {
        /// About which side.
        side: Side,
        /// Of the request that it answers.
        generation: u64,
        /// The answer.
        response: Response,
    },
    /// A worker stopped without an answer; it is started again with the next request.
    WorkerDied {
        /// The side that it was to prepare.
        side: Side,
        /// What is known about it.
        reason: Message,
    },
    /// A row of a study is done.
    Found {
        /// Which one; `None`: whichever is under way.
        study: Option<Study>,
        /// What came out.
        finding: Finding,
    },
    /// The page's address has another fragment.
    Link(String),
    /// Nothing can be drawn any more, and why.
    GraphicsLost(String),
    /// An image was decoded, or could not be.
    Image {
        /// What it is meant to be.
        purpose: FilePurpose,
        /// The file's name.
        name: String,
        /// Straight RGBA, 8 bits each, no larger than was asked for; or why there is none.
        pixels: Result<image::RgbaImage, Message>,
    },
    /// A file could not be written.
    NotSaved {
        /// Its name.
        name: String,
        /// Why.
        reason: Message,
    },
    /// A file was read, or could not be.
    File {
        /// What it is meant to be.
        purpose: FilePurpose,
        /// Its name, without folders.
        name: String,
        /// Its content, or why there is none.
        bytes: Result<Vec<u8>, String>,
    },
}

impl Event {
    /// Whether a preparation has only come to its next stage.
    pub fn is_stage(&self) -> bool {
        matches!(self, Self::Worker { response: Response::Progress(_), .. })
    }
}

/// What the page around the app is told of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PageEvent {
    /// The app takes requests.
    Ready,
    /// The session has changed and come to rest.
    Session,
    /// An error is shown, with these words.
    Error,
}

/// The delay, in seconds, that asks for one more frame: without one egui draws two.
pub const ONE_FRAME: f32 = 0.001;

/// How long a stage of a preparation waits to be shown, in seconds.
pub const STAGES_SHOWN_AFTER: f32 = 0.3;

/// Where events are posted.
#[derive(Clone)]
pub struct Mailbox {
    sender: mpsc::Sender<Event>,
    context: Arc<OnceLock<egui::Context>>,
}

impl Mailbox {
    /// A mailbox and its reading end.
    pub fn new() -> (Self, mpsc::Receiver<Event>) {
        let (sender, receiver) = mpsc::channel();
        (Self { sender, context: Arc::default() }, receiver)
    }

    /// From now on posting wakes `context`; what came earlier waits in the mailbox.
    pub fn attach(&self, context: &egui::Context) {
        self.context.get_or_init(|| context.clone());
    }

    /// Posts `event`. When the app is gone, nobody is left to read it. A stage of a preparation waits for the next
    /// frame, or for a while: most preparations end before anyone could read how far they are.
    pub fn post(&self, event: Event) {
        let is_stage = event.is_stage();
        if self.sender.send(event).is_err() {
            return;
        }
        if is_stage {
            self.wake_for_stages();
        } else {
            self.wake();
        }
    }

    /// Asks for a frame.
    pub fn wake(&self) {
        if let Some(context) = self.context.get() {
            context.request_repaint_after_secs(ONE_FRAME);
        }
    }

    /// Asks for a frame that shows how far a preparation is, should it take so long.
    pub fn wake_for_stages(&self) {
        if let Some(context) = self.context.get() {
            context.request_repaint_after_secs(STAGES_SHOWN_AFTER);
        }
    }
}

/// What is drawn with, in the words of the status line.
pub fn backend_name(backend: wgpu::Backend) -> String {
    let name = match backend {
        wgpu::Backend::BrowserWebGpu => "WebGPU",
        wgpu::Backend::Gl if cfg!(target_arch = "wasm32") => "WebGL2",
        wgpu::Backend::Gl => "OpenGL",
        wgpu::Backend::Vulkan => "Vulkan",
        wgpu::Backend::Metal => "Metal",
        wgpu::Backend::Dx12 => "Direct3D 12",
        wgpu::Backend::Noop => "nothing",
    };
    String::from(name)
}
