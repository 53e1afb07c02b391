//! What comes in from outside of a frame: the workers' answers, files, links.

use super::RiemapApp;
use super::files::{self, Content, FileError, Picture};
use super::gpu::Gpu;
use super::language::tr;
use super::locks::{Control, REFUSAL};
use super::offer::Offer;
use super::presentation;
use super::tracing;
use super::trouble::Trouble;
use crate::conformal::Side;
use crate::platform::{self, Event, FilePurpose};
use crate::session::{Command, TextureKind};
use std::sync::Arc;

impl RiemapApp {
    /// What happened since the last frame.
    pub(super) fn take_events(&mut self) {
        while let Ok(event) = self.events.try_recv() {
            match event {
                Event::Worker { subject, generation, response } => self.model.accept(subject, generation, response),
                Event::WorkerDied { subject, reason } => self.model.worker_died(subject, &reason),
                Event::Found { study, finding } => self.reports.accept(study, finding),
                Event::File { purpose, name, bytes } => self.read_file(purpose, &name, bytes),
                Event::Link(address) => {
                    if self.may(Control::Session) {
                        self.open_link(&address);
                    }
                }
                Event::GraphicsLost(reason) => self.message = Some(presentation::graphics_lost(&reason)),
                Event::Image { purpose, name, pixels } => self.take_image(purpose, name, pixels),
                Event::NotSaved { name, reason } => self.message = Some(format!("{name} was not saved: {reason}")),
            }
        }
    }

    pub(super) fn read_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>) {
        self.explore.keep();
        self.keeper.touch();
        let limit = self.gpu.as_ref().map_or(2048, Gpu::max_texture_side);
        let content = files::read(purpose, name, bytes);
        if let Ok(content) = &content
            && !locked_by(content, purpose).iter().all(|&control| self.may(control))
        {
            return;
        }
        match content {
            Ok(Content::Image { name, bytes }) => {
                let limit = if matches!(purpose, FilePurpose::Trace(_)) { tracing::MAX_SIDE } else { limit };
                platform::decode_image(purpose, name, bytes, limit, self.mailbox.clone());
            }
            content => self.take(content),
        }
    }

    /// An image was decoded, or could not be.
    fn take_image(&mut self, purpose: FilePurpose, name: String, pixels: Result<image::RgbaImage, String>) {
        match (purpose, pixels) {
            (FilePurpose::Trace(side), Ok(pixels)) => self.take(files::traced(side, &Picture { name, pixels })),
            (FilePurpose::Trace(side), Err(reason)) => {
                self.model.side_mut(side).error = Some(Trouble::new(format!("{name}: {reason}")));
            }
            (_, Ok(pixels)) => {
                let side = if let FilePurpose::Dropped(side) = purpose { side } else { Side::Source };
                let picture = Picture { name, pixels };
                self.offer = Some(Offer::new(side, &picture));
                self.use_image(picture);
            }
            (_, Err(reason)) => self.message = Some(format!("{name}: {reason}")),
        }
    }

    /// Traces the picture that has just become the texture.
    pub(super) fn trace_image(&mut self) {
        if let Some(offer) = self.offer.take() {
            self.keeper.touch();
            self.take(offer.accept());
        }
    }

    fn take(&mut self, content: Result<Content, FileError>) {
        match content {
            Ok(Content::Outline(side, outline)) => self.model.want_loaded(side, outline),
            Ok(Content::Image { .. }) => {} // is decoded first
            Ok(Content::Session(session)) => self.open_session(*session),
            Ok(Content::Surface { name, bytes }) => self.model.want_surface_file(&name, bytes),
            Err(FileError::Outline(side, trouble)) => self.model.side_mut(side).error = Some(trouble),
            Err(FileError::Common(message)) => self.message = Some(message),
        }
    }

    /// Whether a control may be changed from outside of the panels; if not, that is said.
    fn may(&mut self, control: Control) -> bool {
        let locked = self.options.locks.holds(control);
        if locked {
            self.message = Some(format!("{}: {}.", tr(REFUSAL), control.name()));
        }
        !locked
    }

    pub(super) fn use_image(&mut self, picture: Picture) {
        let (width, height) = picture.pixels.dimensions();
        let used = self.gpu.as_ref().map_or(Ok(()), |gpu| gpu.set_image(picture.pixels.as_raw(), width, height));
        match used {
            Ok(()) => {
                self.image_name = Some(picture.name);
                self.image = Some(Arc::new(picture.pixels));
                self.message = None;
                self.model.dispatch(Command::SetTexture(TextureKind::Image), 0.0);
            }
            Err(error) => self.message = Some(format!("{}: {error}", picture.name)),
        }
    }

    /// Reads the files that were dropped, for the side that they were dropped over.
    pub(super) fn take_dropped(&self, context: &egui::Context) {
        let dropped = context.input(|input| input.raw.dropped_files.clone());
        let place = platform::drop_position(context);
        let over_target = place.is_some_and(|place| self.views[Side::Target as usize].rect.contains(place));
        let side = if over_target { Side::Target } else { Side::Source };
        for file in &dropped {
            platform::read_dropped(file, side, self.mailbox.clone());
        }
    }
}

/// What a file would change.
fn locked_by(content: &Content, purpose: FilePurpose) -> &'static [Control] {
    match content {
        Content::Outline(..) | Content::Surface { .. } => Control::OF_SHAPES,
        Content::Image { .. } if matches!(purpose, FilePurpose::Trace(_)) => Control::OF_SHAPES,
        Content::Image { .. } => &[Control::Pattern],
        Content::Session(_) => &[Control::Session],
    }
}
