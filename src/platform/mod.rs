//! Everything that differs between web and desktop: start-up, workers, dialogs, dropped files.
//!
//! The only room with `cfg(target_arch)`. `web` and `native` offer the same
//! names: [`start`], [`Preparer`], [`StudyRunner`], [`pick_file`], [`read_dropped`], [`decode_image`], [`save_file`],
//! [`drop_position`], [`address_query`], [`link`], [`show_link`], [`address_with`], [`remember`], [`remembered`],
//! [`visit`], [`visit_of_text`], [`new_visit`], [`begin_visit`], [`keep`], [`first_kept`], [`load_visit`],
//! [`languages`], [`say_language`], [`say`], [`describe`], [`has_fingers`], [`has_full_screen`],
//! [`toggle_full_screen`], [`can_share`], [`share`], [`tell_page`], [`watch_graphics`]. Whatever happens between frames arrives in order as an
//! [`Event`] in the app's mailbox and wakes the app; only files, on the web, are passed to the app directly.

#[cfg(target_arch = "wasm32")]
mod web;
#[cfg(target_arch = "wasm32")]
pub use web::{
    Preparer, StudyRunner, address_query, address_with, begin_visit, can_share, decode_image, describe, drop_position,
    first_kept, has_fingers, has_full_screen, keep, languages, lesson_link, link, load_visit, new_visit, pick_file,
    read_dropped, remember, remembered, save_file, say, say_language, share, show_link, start, tell_page,
    toggle_full_screen, visit, visit_of_text, wants_calm, watch_graphics,
};

#[cfg(not(target_arch = "wasm32"))]
mod native;
#[cfg(not(target_arch = "wasm32"))]
mod native_image;
#[cfg(not(target_arch = "wasm32"))]
pub use native::{
    Preparer, StudyRunner, address_query, address_with, begin_visit, can_share, describe, drop_position, has_fingers,
    has_full_screen, languages, lesson_link, link, new_visit, pick_file, read_dropped, remember, remembered, save_file,
    say, say_language, share, show_link, start, tell_page, toggle_full_screen, visit, visit_of_text, wants_calm,
    watch_graphics,
};
#[cfg(not(target_arch = "wasm32"))]
mod native_store;
#[cfg(not(target_arch = "wasm32"))]
pub use native_image::decode_image;
#[cfg(not(target_arch = "wasm32"))]
pub use native_store::{first_kept, keep, load_visit};

mod host;

pub use host::{Failure, Host};

use crate::conformal::Side;
use crate::language::Message;
use crate::model::files::FilePurpose;
use crate::model::persistence::visits::{Kept as KeptVisit, Listed};
use crate::worker::{Finding, Response, Study};
use std::sync::{Arc, Mutex, PoisonError, mpsc};

/// What is stored from one run to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kept {
    /// The session.
    Session,
    /// The user's preferences.
    Preferences,
    /// The draft of a lesson.
    Lesson,
}

/// Something that happened between frames.
#[derive(Debug)]
pub enum Event {
    /// A worker responded.
    Worker {
        /// The side that it prepares.
        side: Side,
        /// The generation of the request.
        generation: u64,
        /// The response.
        response: Response,
    },
    /// A worker stopped without a response; it is restarted with the next request.
    WorkerDied {
        /// The side that it prepared.
        side: Side,
        /// The generation of the request that it was working on; `None` means the one in flight.
        generation: Option<u64>,
        /// The reason, as far as it is known.
        reason: Message,
    },
    /// A study has a result, or goes on.
    Found {
        /// The study.
        study: Study,
        /// The result.
        finding: Finding,
    },
    /// The fragment of the page's address has changed.
    Link(String),
    /// Another tab has stored this.
    StoredElsewhere(Kept),
    /// The user went back or forward to this visit in the browser's history.
    GoneTo(String),
    /// A kept visit was read; `None` if it is not kept any more.
    Visited {
        /// The id that was asked for.
        id: String,
        /// The id under which this tab goes on: another one if another tab has that visit.
        own: String,
        /// The visit.
        kept: Option<KeptVisit>,
    },
    /// A visit was stored: the visits that are kept now, and why its files are not; or why nothing is.
    Kept(Result<(Vec<Listed>, Option<Message>), Message>),
    /// The graphics device was lost; with the reason.
    GraphicsLost(String),
    /// An image was decoded, or could not be.
    Image {
        /// What the image is for.
        purpose: FilePurpose,
        /// The file's name.
        name: String,
        /// The file's content.
        file: Arc<Vec<u8>>,
        /// RGBA, alpha not premultiplied, 8 bits per channel, no larger than requested; or the reason of the failure.
        pixels: Result<image::RgbaImage, Message>,
    },
    /// The dialog for a file could not be shown, and why.
    NoDialog(Message),
    /// A file could not be written.
    NotSaved {
        /// The file's name.
        name: String,
        /// The reason.
        reason: Message,
    },
    /// A file was read, or could not be.
    File {
        /// What the file is for.
        purpose: FilePurpose,
        /// The file's name, without folders.
        name: String,
        /// The content, or the reason of the failure.
        bytes: Result<Vec<u8>, String>,
    },
}

impl Event {
    /// Whether the event only reports the next stage of a preparation.
    pub fn is_stage(&self) -> bool {
        matches!(self, Self::Worker { response: Response::Progress(_), .. })
    }
}

/// The events that the page around the app receives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PageEvent {
    /// The app accepts requests.
    Ready,
    /// The session has changed and settled.
    Session,
    /// An error message is shown, with this text.
    Error,
}

/// The delay in seconds with which one more frame is requested: without a delay egui draws two.
pub const ONE_FRAME: f32 = 0.001;

/// The delay in seconds after which the stage of a preparation is shown.
pub const STAGES_SHOWN_AFTER: f32 = 0.3;

/// The sending end of the app's event queue; posting wakes the app.
#[derive(Clone)]
pub struct Mailbox {
    sender: mpsc::Sender<Event>,
    context: Arc<Mutex<Option<egui::Context>>>,
}

impl Mailbox {
    /// A mailbox and its receiving end.
    pub fn new() -> (Self, mpsc::Receiver<Event>) {
        let (sender, receiver) = mpsc::channel();
        (Self { sender, context: Arc::default() }, receiver)
    }

    /// Makes posting wake `context`, in place of a former one; earlier events wait in the mailbox.
    pub fn attach(&self, context: &egui::Context) {
        *self.context.lock().unwrap_or_else(PoisonError::into_inner) = Some(context.clone());
    }

    fn context(&self) -> Option<egui::Context> {
        self.context.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Posts `event`; ignored if the app has ended. A stage of a preparation does not request a frame at once: most
    /// preparations end before anyone could read it.
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

    /// Requests a frame.
    pub fn wake(&self) {
        if let Some(context) = self.context() {
            context.request_repaint_after_secs(ONE_FRAME);
        }
    }

    /// Requests a frame that shows the stage, in case the preparation takes that long.
    pub fn wake_for_stages(&self) {
        if let Some(context) = self.context() {
            context.request_repaint_after_secs(STAGES_SHOWN_AFTER);
        }
    }
}

/// The name of the graphics backend in the status line.
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
