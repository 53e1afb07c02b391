//! Events from outside of a frame: the workers' responses, files, links.

use super::RiemapApp;
use crate::app::input::locks::Control;
use crate::app::panels::offer::Offer;
use crate::app::viewport::gpu::Gpu;
use crate::app::viewport::pictures::TextureImage;
use crate::conformal::Side;
use crate::language::{Message, key};
use crate::model::editing::tracing;
use crate::model::files;
use crate::model::files::{FileKind, FilePurpose, Picture};
use crate::model::opening::Arrived;
use crate::model::side::opened_file::Origin;
use crate::model::side::user_error::UserError;
use crate::outline::Outline;
use crate::platform::{self, Event, Kept};
use crate::session::file::Attachment;
use crate::session::{Touched, lesson};
use crate::worker::{Finding, ProjectionTask, Response, Study};
use std::sync::Arc;

/// The delay of the frame that updates the panels after the pictures, in seconds: sooner than anyone reads them.
pub(super) const WORDS_FOLLOW_AFTER: f32 = 0.05;

impl RiemapApp {
    /// Processes the events since the last frame, and requests a frame that updates the panels; not for stages, which
    /// they do not show. That frame is delayed: with a software renderer, it would otherwise postpone the display of
    /// the pictures.
    pub(super) fn take_events(&mut self, context: &egui::Context) {
        while let Ok(event) = self.workers.events.try_recv() {
            if !event.is_stage() {
                context.request_repaint_after_secs(WORDS_FOLLOW_AFTER);
            }
            match event {
                Event::Worker { side, generation, response } => self.take_answer(side, generation, response),
                Event::WorkerDied { side, generation, reason } => self.take_death(side, generation, &reason),
                Event::Found { study, finding } => self.take_finding(&study, finding),
                Event::File { purpose, name, bytes } => self.open_file(purpose, &name, bytes),
                Event::Link(address) => {
                    if self.may(Touched::EVERYTHING) {
                        self.open_link(&address);
                    } else {
                        self.correct_address();
                    }
                }
                Event::GoneTo(id) => self.go_to_visit(id),
                Event::StoredElsewhere(Kept::Lesson) => _ = self.meet_other_draft(),
                // each tab has a session and preferences of its own
                Event::StoredElsewhere(Kept::Session | Kept::Preferences) => {}
                Event::Visited { id, own, kept } => self.take_visit(&id, own, kept),
                Event::Kept(result) => self.take_kept(result),
                Event::GraphicsLost(reason) => self.take_loss_of_graphics(&reason),
                Event::Image { purpose, name, file, pixels } => {
                    self.take_image(purpose, Attachment { name, bytes: file }, pixels);
                }
                Event::NoDialog(reason) => self.messages.common = Some(reason),
                Event::NotSaved { name, reason } => self.messages.common = Some(key::not_saved(name, reason)),
            }
        }
    }

    /// Takes the finding of a study.
    fn take_finding(&mut self, study: &Study, finding: Finding) {
        match study {
            Study::Invariants(_) => self.model.accept_invariants(match finding {
                Finding::Invariants(found) => Ok(*found),
                Finding::Failed(reason) => Err(reason),
                _ => Err(key::another_answer().into()),
            }),
            Study::Symmetry(_) => self.model.accept_symmetries(match finding {
                Finding::Symmetry(found) => Ok(*found),
                Finding::Failed(reason) => Err(reason),
                _ => Err(key::another_answer().into()),
            }),
            Study::Formula(task) => self.take_formula(task, finding),
            Study::Grid(task) => match self.model.accept_grid(task, finding) {
                Some(Ok(file)) => platform::save_file(&file.name, file.bytes, self.workers.mailbox.clone()),
                Some(Err(reason)) => self.messages.common = Some(reason),
                None => {}
            },
            Study::Projection(task) => self.windows.projection.accept(task, finding),
            _ => self.windows.reports.accept(study, finding),
        }
    }

    /// A worker died: the first time its request is sent again.
    fn take_death(&mut self, side: Side, generation: Option<u64>, reason: &Message) {
        if !self.workers.repeat(side, generation) {
            self.model.worker_died(side, generation, reason);
            self.take_arrived();
        }
    }

    /// Replaces workers that hang.
    pub(super) fn replace_silent_workers(&mut self) {
        for (side, generation) in self.workers.stop_silent() {
            self.take_death(side, Some(generation), &key::worker_silent().into());
        }
    }

    /// The one place that takes the workers' responses; the model drops stale ones.
    fn take_answer(&mut self, side: Side, generation: u64, response: Response) {
        self.workers.hear(side, generation, &response);
        self.model.accept(side, generation, response);
        self.take_arrived();
    }

    /// Takes the result of an opened file from the model.
    pub(super) fn take_arrived(&mut self) {
        match self.model.take_arrived() {
            None => {}
            Some(Arrived::Outline(arrived)) => {
                self.begin_change(Touched::ANOTHER_SHAPE);
                let origin = arrived.origin;
                if let Some(offer) = Offer::besides(arrived) {
                    self.messages.suggest(offer);
                }
                if origin == Origin::PastedText {
                    self.editor.end_paste(&mut self.model, &mut self.pictures.views);
                }
            }
            // the change began when the file was opened
            Some(Arrived::Surface) => self.end_tour(),
            Some(Arrived::Session(archive, later)) => {
                self.messages.common = None;
                self.open_archive(*archive);
                self.model.open_later(later);
            }
            Some(Arrived::NoSession(message)) => self.messages.common = Some(message),
            Some(Arrived::NoOutline(side, message)) => self.editor.refuse_paste(side, message),
        }
    }

    /// Processes a file between two frames: sends it to the worker that parses it.
    pub fn take_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>) {
        self.open_file(purpose, name, bytes);
        if self.workers.send_due(&mut self.model, f64::NEG_INFINITY) {
            // a frame would show little news, and use the processor that the worker needs
            self.workers.mailbox.wake_for_stages();
        } else {
            self.workers.mailbox.wake();
        }
    }

    /// Starts reading a file; its changes take effect when its content arrives.
    fn open_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>) {
        let kind = match &bytes {
            Ok(bytes) if lesson::is_file(bytes) => FileKind::Lesson,
            _ => FileKind::of(purpose, name),
        };
        if !self.may(kind.touches()) {
            return;
        }
        let bytes = match bytes {
            Ok(bytes) => bytes,
            Err(cause) => return self.refuse_file(kind, UserError::new(key::about(name, key::file_unreadable(cause)))),
        };
        match kind {
            FileKind::Outline(side) => self.model.open_outline(side, name, bytes),
            FileKind::Session => {
                self.model.open_session_file(name, bytes);
                self.take_arrived();
            }
            FileKind::Lesson => self.take_lesson(purpose, name, &bytes),
            FileKind::Region => self.project(ProjectionTask::of_file(name, bytes)),
            FileKind::Surface(side) => {
                self.persistence.touch();
                self.model.open_surface_in_turn(side, name, bytes);
            }
            FileKind::Texture | FileKind::Trace(_) | FileKind::Picture(_) => {
                self.messages.common = None;
                let limit = match kind {
                    FileKind::Trace(_) => tracing::MAX_SIDE,
                    _ => self.pictures.gpu.as_ref().map_or(2048, Gpu::max_texture_side),
                };
                platform::decode_image(purpose, name.to_owned(), Arc::new(bytes), limit, self.workers.mailbox.clone());
            }
        }
    }

    /// Shows the error of a file at the side that it was opened for.
    fn refuse_file(&mut self, kind: FileKind, error: UserError) {
        match kind.side() {
            Some(side) => self.model.refuse(side, error),
            None => self.messages.common = Some(error.text),
        }
    }

    /// Processes a decoded image, or the error of its decoding.
    fn take_image(&mut self, purpose: FilePurpose, file: Attachment, pixels: Result<image::RgbaImage, Message>) {
        let name = file.name.clone();
        let kind = FileKind::of(purpose, &name);
        let pixels = match pixels {
            Ok(pixels) => pixels,
            Err(reason) => {
                return self.refuse_file(kind, UserError::new(key::about(name, reason)));
            }
        };
        let picture = Picture { name, pixels };
        match kind {
            FileKind::Trace(side) => return self.take_traced(side, files::traced(&picture)),
            FileKind::Picture(side) => {
                self.messages.suggest(Offer::question(side, picture, file));
                return;
            }
            _ => {}
        }
        if purpose == FilePurpose::OfSession {
            return self.show_image(picture, file);
        }
        let side = if let FilePurpose::Dropped(side) = purpose { side } else { Side::Source };
        self.messages.suggest(Offer::new(side, &picture));
        self.end_tour(); // the texture replaces the tour's picture
        self.use_image(picture, file);
    }

    /// Traces the picture that was last opened.
    pub(super) fn trace_image(&mut self) {
        if let Some((side, traced)) = self.messages.offer.take().and_then(|offer| offer.accept()) {
            self.take_traced(side, traced);
        }
    }

    /// Makes the picture that was opened as an outline the texture.
    pub(super) fn use_offered_image(&mut self) {
        if let Some((picture, file)) = self.messages.offer.take().and_then(Offer::into_unused) {
            self.end_tour();
            self.use_image(picture, file);
        }
    }

    fn take_traced(&mut self, side: Side, traced: Result<Outline, UserError>) {
        match traced {
            Ok(outline) => {
                self.begin_change(Touched::ANOTHER_SHAPE);
                self.model.want_loaded(side, outline);
            }
            Err(error) => self.model.refuse(side, error),
        }
    }

    /// Whether no lock keeps a file or a link from changing these parts of the session; if one does, a message says so.
    pub(super) fn may(&mut self, touched: Touched) -> bool {
        let held = self.options.locks.keeps(touched);
        if let Some(control) = held {
            self.refuse(control);
        }
        held.is_none()
    }

    /// Shows the message that a control is locked.
    pub(super) fn refuse(&mut self, control: Control) {
        self.messages.common = Some(key::address_keeps(control.name()));
    }

    /// Makes a picture the texture, or puts it into the tiles that are shown.
    pub(super) fn use_image(&mut self, picture: Picture, file: Attachment) {
        self.show_image(picture, file);
        if self.pictures.image.is_some() {
            let touched = self.model.dispatch(self.model.session().to_show_picture(), 0.0);
            self.begin_change(touched);
            self.persistence.owe_copy();
        }
    }

    /// Makes a picture the one that is shown where the texture is an image; the session does not change.
    fn show_image(&mut self, picture: Picture, file: Attachment) {
        let (width, height) = picture.pixels.dimensions();
        let used =
            self.pictures.gpu.as_ref().map_or(Ok(()), |gpu| gpu.set_image(picture.pixels.as_raw(), width, height));
        match used {
            Ok(()) => {
                self.pictures.image = Some(TextureImage { file, pixels: Arc::new(picture.pixels) });
            }
            Err(error) => self.messages.common = Some(key::about(picture.name, Message::from(&error))),
        }
    }

    /// Reads the dropped files for the side over which they were dropped.
    pub(super) fn take_dropped(&mut self, context: &egui::Context) {
        if self.input.dropped.is_empty() {
            return;
        }
        let place = platform::drop_position(context);
        let over_target = place.is_some_and(|place| self.pictures.views[Side::Target].rect.contains(place));
        let side = if over_target { Side::Target } else { Side::Source };
        platform::read_dropped(std::mem::take(&mut self.input.dropped), side, self.workers.mailbox.clone());
    }
}
