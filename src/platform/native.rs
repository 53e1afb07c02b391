//! The desktop: a window, a thread for each preparation, the system's dialogs.
//!
//! A thread cannot be stopped from outside: a superseded preparation runs to its end and its responses are
//! dropped as stale; a formula stops at its next step. A panic in a thread is reported as an event and does not reach the app.

use super::{Event, Failure, Host, Kept, Mailbox, PageEvent};
use crate::conformal::Side;
use crate::language::{Message, key};
use crate::model::files::{FilePurpose, endings, gathered};
use crate::worker::{self, Advance, Finding, Request, Study};
use etcetera::BaseStrategy as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;

/// Opens the window and runs the app until the window is closed.
pub fn start<H: Host>() -> Result<(), String> {
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default().with_inner_size([1440.0, 900.0]).with_min_inner_size([360.0, 480.0]),
        dithering: false,
        ..Default::default()
    };
    let startup = H::startup();
    let creator: eframe::AppCreator<'static> = Box::new(|creation| Ok(Box::new(H::open(creation, startup)?)));
    eframe::run_native("riemap", options, creator)
        .map_err(|error| H::failure_words(&Failure::NoWindow(error.to_string())))
}

/// Runs preparations on threads.
pub struct Preparer {
    mailbox: Mailbox,
}

impl Preparer {
    /// A preparer whose responses are posted to `mailbox`.
    pub fn new(mailbox: Mailbox) -> Self {
        Self { mailbox }
    }

    /// Does nothing: threads need no rehearsal.
    #[allow(clippy::unused_self, reason = "in the browser there are workers")]
    pub fn warm(&mut self) {}

    /// Does nothing: a thread cannot be stopped; the responses of one that is given up are dropped as stale.
    #[allow(clippy::unused_self, reason = "in the browser there are workers")]
    pub fn stop(&mut self, _side: Side) {}

    /// Always true: a thread runs as soon as it is there.
    #[allow(clippy::unused_self, reason = "in the browser there are workers")]
    pub fn has_started(&self, _side: Side) -> bool {
        true
    }

    /// Starts a thread for `request`.
    pub fn request(&mut self, side: Side, request: Request) {
        let mailbox = self.mailbox.clone();
        let generation = Some(request.generation);
        let work = move || {
            let mut emit = |generation, response| mailbox.post(Event::Worker { side, generation, response });
            if catch_unwind(AssertUnwindSafe(|| worker::run(&request, &mut emit))).is_err() {
                mailbox.post(Event::WorkerDied { side, generation, reason: key::internal_error().into() });
            }
        };
        if let Err(error) = thread::Builder::new().name(format!("prepare the {side}")).spawn(work) {
            self.mailbox.post(Event::WorkerDied { side, generation, reason: error.to_string().into() });
        }
    }
}

/// Runs studies on threads.
pub struct StudyRunner {
    mailbox: Mailbox,
    /// Whether the last study is cancelled.
    is_cancelled: Arc<AtomicBool>,
}

impl StudyRunner {
    /// A runner whose findings are posted to `mailbox`.
    pub fn new(mailbox: Mailbox) -> Self {
        Self { mailbox, is_cancelled: Arc::default() }
    }

    /// Starts a thread for `study`.
    pub fn begin(&mut self, study: Study) {
        self.cancel();
        self.is_cancelled = Arc::default();
        let is_cancelled = Arc::clone(&self.is_cancelled);
        let mailbox = self.mailbox.clone();
        let post = {
            let study = study.clone();
            move |finding| mailbox.post(Event::Found { study: study.clone(), finding })
        };
        let work = {
            let post = post.clone();
            move || {
                let mut advance = Advance::default();
                let report = &mut |done| {
                    let goes_on = !is_cancelled.load(Ordering::Relaxed);
                    if goes_on && advance.selects(done) {
                        post(Finding::Progress(done));
                    }
                    goes_on
                };
                let found = catch_unwind(AssertUnwindSafe(|| study.run(report)));
                if let Some(finding) = found.unwrap_or_else(|_| Some(Finding::Failed(key::internal_error().into()))) {
                    post(finding);
                }
            }
        };
        if let Err(error) = thread::Builder::new().name(String::from("study")).spawn(work) {
            post(Finding::Failed(error.to_string().into()));
        }
    }

    /// Cancels the last study. One that cannot be stopped still posts its finding.
    pub fn cancel(&mut self) {
        self.is_cancelled.store(true, Ordering::Relaxed);
    }
}

/// Empty: a window has no address.
pub fn address_query() -> Vec<[String; 2]> {
    Vec::new()
}

/// Always true.
pub fn has_full_screen() -> bool {
    true
}

/// Switches between full screen and window.
pub fn toggle_full_screen(context: &egui::Context) {
    let is_full = context.input(|input| input.viewport().fullscreen).unwrap_or(false);
    context.send_viewport_cmd(egui::ViewportCommand::Fullscreen(!is_full));
}

/// Does nothing: there is no page around a window.
pub fn tell_page(_event: PageEvent, _detail: &str) {}

/// Posts an event when the device is lost, and prints the reason to stderr, since the window may show nothing any more.
pub fn watch_graphics(device: &wgpu::Device, mailbox: Mailbox) {
    device.set_device_lost_callback(move |reason, message| {
        // at the end of the program the device is destroyed, which is not an error
        if reason != wgpu::DeviceLostReason::Destroyed {
            eprintln!("riemap: the graphics device was lost: {message}");
            mailbox.post(Event::GraphicsLost(message));
        }
    });
}

/// Opens the file dialog, whose filter is called `label`; the content of the chosen file is posted to `mailbox`.
pub fn pick_file(purpose: FilePurpose, label: &str, mailbox: Mailbox) {
    let dialog = rfd::AsyncFileDialog::new().add_filter(label, &endings(purpose)).pick_file();
    thread::spawn(move || {
        if let Some(file) = pollster::block_on(dialog) {
            let bytes = std::fs::read(file.path()).map_err(|error| error.to_string());
            mailbox.post(Event::File { purpose, name: file.file_name(), bytes });
        }
    });
}

/// Opens the save dialog and writes the file. An error is posted to `mailbox`.
pub fn save_file(name: &str, bytes: Vec<u8>, mailbox: Mailbox) {
    let dialog = rfd::AsyncFileDialog::new().set_file_name(name).save_file();
    thread::spawn(move || {
        if let Some(file) = pollster::block_on(dialog)
            && let Err(error) = std::fs::write(file.path(), bytes)
        {
            mailbox.post(Event::NotSaved { name: file.file_name(), reason: error.to_string().into() });
        }
    });
}

/// Reads files that were dropped together and posts their content to `mailbox`.
pub fn read_dropped(files: Vec<egui::DroppedFileHandle>, side: Side, mailbox: Mailbox) {
    thread::spawn(move || {
        let read = |file: egui::DroppedFileHandle| {
            let name = file.path().file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            (name, file.bytes())
        };
        for (name, bytes) in gathered(files.into_iter().map(read).collect()) {
            mailbox.post(Event::File { purpose: FilePurpose::Dropped(side), name, bytes });
        }
    });
}

/// The position of the pointer while a file is dragged over the window.
pub fn drop_position(context: &egui::Context) -> Option<egui::Pos2> {
    context.input(|input| input.pointer.latest_pos())
}

/// `None`: a window has no address, and `riemap LINK` is not a command.
pub fn link() -> Option<String> {
    None
}

/// The link of a lesson in the address: there is none.
pub fn lesson_link() -> Option<String> {
    None
}

/// Does nothing: a window has no address.
pub fn show_link(_fragment: &str) {}

/// The only visit: a window has no history of addresses.
const VISIT: &str = "last";

/// The only visit, which every run continues.
pub fn visit() -> Option<String> {
    Some(VISIT.to_owned())
}

/// `None`: every session that is opened is a step of the same visit.
pub fn new_visit() -> Option<String> {
    None
}

/// Does nothing: a window has no history of addresses.
pub fn begin_visit(_id: &str) {}

/// The address of the web app with this fragment; on the desktop only the fragment, which `riemap render` accepts.
pub fn address_with(fragment: &str) -> String {
    format!("#{fragment}")
}

/// Whether the system has a dialog of its own that shares a link: not on a desktop.
pub fn can_share() -> bool {
    false
}

/// Passes a link to the system's dialog; there is none ([`can_share`]).
pub fn share(_address: &str, _mailbox: Mailbox) {}

/// Stores a text for [`remembered`]. Errors: the reason why it cannot be written.
pub fn remember(what: Kept, text: &str) -> Result<(), Message> {
    let path = kept_at(what).ok_or(key::no_folder())?;
    let written = path.parent().map_or(Ok(()), std::fs::create_dir_all).and_then(|()| std::fs::write(&path, text));
    written.map_err(|error| key::about(path.display().to_string(), error.to_string()))
}

/// The text that was stored last.
pub fn remembered(what: Kept) -> Option<String> {
    std::fs::read_to_string(kept_at(what)?).ok()
}

/// `None`: there is one visit only.
pub fn visit_of_text() -> Option<String> {
    None
}

/// The folder of what is kept.
pub fn kept_folder() -> Option<PathBuf> {
    let folders = etcetera::choose_base_strategy().ok()?;
    Some(folders.data_dir().join("riemap"))
}

fn kept_at(what: Kept) -> Option<PathBuf> {
    let name = match what {
        Kept::Session => "last.riemap",
        Kept::Preferences => "preferences.json",
        Kept::Lesson => "draft.lesson.txt",
    };
    Some(kept_folder()?.join(name))
}

/// The tags of the user's languages, the preferred one first.
pub fn languages() -> Vec<String> {
    sys_locale::get_locales().collect()
}

/// Does nothing: the system's accessibility interface reads the widgets.
pub fn say(_text: &str) {}

/// Does nothing, as [`say`].
pub fn describe(_text: &str) {}

/// Whether the screen is touched, before its first touch: unknown on the desktop, hence false.
pub fn has_fingers() -> bool {
    false
}

/// Whether the user has asked the system for less motion: unknown on the desktop, hence false.
pub fn wants_calm() -> bool {
    false
}

/// Does nothing: a window need not declare its language.
pub fn say_language(_code: &str) {}
