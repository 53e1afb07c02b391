//! What comes in from outside of a frame: the workers' answers, files, links.

use super::RiemapApp;
use super::files::{self, Content, FileError};
use super::gpu::Gpu;
use super::language::tr;
use super::locks::{Control, REFUSAL};
use super::presentation;
use crate::conformal::Side;
use crate::platform::{self, Event, FilePurpose};
use crate::session::{Command, TextureKind};

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
                Event::Image { name, pixels: Ok(pixels) } => self.use_image(&name, &pixels),
                Event::Image { name, pixels: Err(reason) } => self.message = Some(format!("{name}: {reason}")),
                Event::NotSaved { name, reason } => self.message = Some(format!("{name} was not saved: {reason}")),
            }
        }
    }

    pub(super) fn read_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>) {
        self.keeper.touch();
        let limit = self.gpu.as_ref().map_or(2048, Gpu::max_texture_side);
        let content = files::read(purpose, name, bytes);
        if let Ok(content) = &content
            && !self.may(locked_by(content))
        {
            return;
        }
        match content {
            Ok(Content::Outline(side, outline)) => self.model.want_loaded(side, outline),
            Ok(Content::Image { name, bytes }) => platform::decode_image(name, bytes, limit, self.mailbox.clone()),
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

    fn use_image(&mut self, name: &str, pixels: &image::RgbaImage) {
        let (width, height) = pixels.dimensions();
        let used = self.gpu.as_ref().map_or(Ok(()), |gpu| gpu.set_image(pixels.as_raw(), width, height));
        match used {
            Ok(()) => {
                self.image_name = Some(name.to_owned());
                self.message = None;
                self.model.dispatch(Command::SetTexture(TextureKind::Image), 0.0);
            }
            Err(error) => self.message = Some(format!("{name}: {error}")),
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
fn locked_by(content: &Content) -> Control {
    match content {
        Content::Outline(..) | Content::Surface { .. } => Control::Outline,
        Content::Image { .. } => Control::Pattern,
        Content::Session(_) => Control::Session,
    }
}
