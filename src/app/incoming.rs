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
            Some(Arrived::Outline(origin, geographic)) => {
                self.begin_change(Touched::ANOTHER_SHAPE);
                self.messages.offer = geographic.map(Offer::to_project).or(self.messages.offer.take());
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
            FileKind::Region => self.project(ProjectionTask::File { name: name.to_owned(), bytes }),
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
                self.messages.offer = Some(Offer::question(side, picture, file));
                return;
            }
            _ => {}
        }
        if purpose == FilePurpose::OfSession {
            return self.show_image(picture, file);
        }
        let side = if let FilePurpose::Dropped(side) = purpose { side } else { Side::Source };
        self.messages.offer = Some(Offer::new(side, &picture));
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
        let place = platform::drop_position(context);
        let over_target = place.is_some_and(|place| self.pictures.views[Side::Target].rect.contains(place));
        let side = if over_target { Side::Target } else { Side::Source };
        for file in self.input.dropped.drain(..) {
            platform::read_dropped(file, side, self.workers.mailbox.clone());
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::app::Session;
    use crate::app::input::action::{Action, ExploreAction};
    use crate::app::tests::{ready_app, step_until};
    use crate::session::{Command, TextureKind};
    use crate::worker::{self, SurfaceSource, Task};
    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable;

    /// A small surface as an OBJ file.
    fn surface_file() -> Vec<u8> {
        let Task::Surface { source: SurfaceSource::File(file), .. } = worker::rehearsal().task else {
            panic!("the rehearsal reads a file")
        };
        file.bytes.to_vec()
    }

    #[test]
    fn a_surface_is_prepared_before_the_next_frame_and_seen_before_its_triangles_are_sorted() {
        let mut harness = ready_app([1200.0, 800.0]);
        let app = harness.state_mut();
        app.take_file(FilePurpose::Outline(Side::Target), "head.obj", Ok(surface_file()));
        let preparation = &app.model.surface_side(Side::Target).preparation;
        assert!(preparation.pending_request().seconds_under_way().is_some(), "its progress is shown from now on");
        assert_eq!(app.model.next_due(), None, "nothing is left for a frame to ask for");
        step_until(&mut harness, |app| !app.model.is_planar() && app.model.map().is_some());
        let is_sorted = |app: &RiemapApp| {
            app.model.surface_side(Side::Target).surface().is_some_and(|surface| surface.tree_if_made().is_some())
        };
        assert!(!is_sorted(harness.state()), "the first frame of a surface does not wait for that");
        step_until(&mut harness, is_sorted);
    }

    /// The app in a state in which it requests no frame.
    fn app_at_rest() -> Harness<'static, RiemapApp> {
        let mut harness = ready_app([1200.0, 800.0]);
        harness.try_run().unwrap();
        assert!(!harness.ctx.has_requested_repaint());
        harness
    }

    #[test]
    fn another_picture_ends_the_tour_and_a_file_without_one_does_not() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let begin = |app: &mut RiemapApp| {
            app.carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
            assert!(app.windows.explore.is_touring());
        };
        let app = harness.state_mut();
        begin(app);
        app.take_file(FilePurpose::Outline(Side::Source), "bow.csv", Ok(b"0,0\n1,1\n1,0\n0,1\n".to_vec()));
        step_until(&mut harness, |app| !app.errors().is_empty());
        let app = harness.state_mut();
        assert!(app.windows.explore.is_touring());
        app.open_session(Session::default());
        assert!(!app.windows.explore.is_touring());
        begin(app);
        app.take_file(FilePurpose::Outline(Side::Source), "square.csv", Ok(b"0,0\n1,0\n1,1\n0,1\n".to_vec()));
        assert!(app.windows.explore.is_touring(), "it is being read");
        step_until(&mut harness, |app| !app.windows.explore.is_touring());
    }

    #[test]
    fn a_repaired_outline_ends_the_tour() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let app = harness.state_mut();
        app.carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
        let spike = b"0,0\n2,0\n2,1\n3,1\n2,1\n2,2\n0,2\n".to_vec();
        app.take_file(FilePurpose::Outline(Side::Source), "spike.csv", Ok(spike));
        step_until(&mut harness, |app| !app.errors().is_empty());
        let app = harness.state_mut();
        assert!(app.windows.explore.is_touring());
        app.carry_out(&context, vec![Action::QuickFix(Side::Source)]);
        assert!(!app.windows.explore.is_touring() && app.errors().is_empty());
    }

    #[test]
    fn a_session_that_is_read_is_opened_and_ends_the_tour() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let app = harness.state_mut();
        let session = app.session().clone().and([Command::SetTextureScale(21.0)]);
        app.carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
        let bytes = crate::session::file::write(&session).unwrap().into_bytes();
        app.take_file(FilePurpose::Dropped(Side::Target), "a.riemap", Ok(bytes));
        step_until(&mut harness, |app| app.session().texture_scale() == 21.0 && app.model.is_ready());
        assert!(!harness.state().windows.explore.is_touring());
    }

    #[test]
    fn a_surface_ends_the_tour_when_it_is_there_and_a_broken_one_does_not() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        harness.state_mut().carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
        let mut take = |name: &str, bytes: Vec<u8>| {
            harness.state_mut().take_file(FilePurpose::Outline(Side::Target), name, Ok(bytes));
            step_until(&mut harness, |app| !app.model.surface_side(Side::Target).preparation.is_busy());
            (harness.state().windows.explore.is_touring(), harness.state().errors().len())
        };
        assert_eq!(take("broken.obj", b"v 0 0 0\nf 1 2 3\n".to_vec()), (true, 1));
        assert_eq!(take("head.obj", surface_file()), (false, 0));
    }

    #[test]
    fn a_surface_that_is_on_its_way_is_not_lost_when_the_tour_is_ended() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let app = harness.state_mut();
        app.carry_out(&context, vec![Action::Explore(ExploreAction::Tour(0))]);
        app.take_file(FilePurpose::Outline(Side::Target), "head.obj", Ok(surface_file()));
        app.carry_out(&context, vec![Action::Explore(ExploreAction::LeaveTour { keeps: false })]);
        assert!(!app.windows.explore.is_touring() && app.model.surface_side(Side::Target).preparation.is_busy());
        step_until(&mut harness, |app| !app.model.is_planar());
    }

    #[test]
    fn what_was_wrong_with_a_target_outline_is_past_when_a_surface_takes_its_place() {
        let mut harness = ready_app([1200.0, 800.0]);
        let app = harness.state_mut();
        app.take_file(FilePurpose::Outline(Side::Target), "bow.csv", Ok(b"0,0\n1,1\n1,0\n0,1\n".to_vec()));
        step_until(&mut harness, |app| app.errors().len() == 1);
        let app = harness.state_mut();
        app.take_file(FilePurpose::Outline(Side::Target), "head.obj", Ok(surface_file()));
        assert!(app.errors().is_empty(), "{:?}", app.errors());
        // and in the reverse order
        app.take_file(FilePurpose::Outline(Side::Target), "broken.obj", Ok(b"v 0 0 0\nf 1 2 3\n".to_vec()));
        step_until(&mut harness, |app| !app.model.surface_side(Side::Target).preparation.pending_request().is_busy());
        let app = harness.state_mut();
        app.take_file(FilePurpose::Outline(Side::Target), "bow.csv", Ok(b"0,0\n1,1\n1,0\n0,1\n".to_vec()));
        step_until(&mut harness, |app| !app.model.is_preparing(Side::Target));
        let errors = harness.state().errors();
        assert!(errors.len() == 1 && errors[0].english().starts_with("bow.csv"), "{errors:?}");
    }

    #[test]
    fn a_picture_opened_as_an_outline_waits_for_the_answer_what_it_is_for() {
        let png = |pixels: image::RgbaImage| {
            let mut bytes = std::io::Cursor::new(Vec::new());
            pixels.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
            bytes.into_inner()
        };
        let ink = |x: u32, y: u32| if (60..180).contains(&x) && (90..150).contains(&y) { 0 } else { 255 };
        let bytes =
            png(image::RgbaImage::from_fn(300, 240, |x, y| image::Rgba([ink(x, y), ink(x, y), ink(x, y), 255])));
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let before = harness.state().session().clone();
        let mut ask = |action: Action| {
            harness.state_mut().take_file(FilePurpose::Outline(Side::Source), "box.png", Ok(bytes.clone()));
            step_until(&mut harness, |app| app.messages.offer.is_some());
            assert_eq!(harness.state().session(), &before, "nothing changes before the answer");
            harness.state_mut().carry_out(&context, vec![action]);
            step_until(&mut harness, |app| !app.model.is_preparing(Side::Source));
            assert!(harness.state().messages.offer.is_none());
            harness.state().session().clone()
        };
        assert_eq!(ask(Action::DismissOffer), before);
        let textured = ask(Action::UseImage);
        assert_eq!(
            (textured.texture(), textured.domain(Side::Source)),
            (TextureKind::Image, before.domain(Side::Source))
        );
        assert_eq!(harness.state().pictures.image.as_ref().map(|image| image.file.name.as_str()), Some("box.png"));
        let app = harness.state_mut();
        app.open_session(before.clone());
        app.take_file(FilePurpose::Outline(Side::Source), "box.png", Ok(bytes));
        step_until(&mut harness, |app| app.messages.offer.is_some());
        harness.step();
        harness.get_by_label("Trace its silhouette").click();
        step_until(&mut harness, |app| app.session().domain(Side::Source) != before.domain(Side::Source));
    }

    #[test]
    fn a_message_that_hides_which_file_is_missing_gives_way_to_that() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let app = harness.state_mut();
        // a spike finer than a link can tell
        let spike =
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.31 + 1e-9, 1.0), (0.31, 0.2), (0.31 - 1e-9, 1.0), (0.0, 1.0)];
        let points = spike.map(crate::geometry::DVec2::from).to_vec();
        let mut session = app.session().clone();
        let outline = crate::session::OutlineSpec::points("big".into(), points.try_into().unwrap());
        session.apply(Command::SetOutline { side: Side::Source, outline });
        app.try_link(&crate::session::link::encode(&session).unwrap().fragment).unwrap();
        let asked = app.messages.common.clone();
        assert!(asked.as_ref().is_some_and(|asked| asked.english().contains("\"big\"")));
        app.open_link("#s=1.nonsense");
        assert_ne!(app.messages.common, asked);
        app.carry_out(&context, vec![Action::DismissMessage]);
        assert_eq!(app.messages.common, asked);
        app.carry_out(&context, vec![Action::DismissMessage]);
        assert_eq!(app.messages.common, None);
        app.open_link("#s=1.nonsense");
        app.carry_out(&context, vec![Action::DismissMessage]);
        assert_eq!(app.messages.common, None, "it has been closed");
    }

    #[test]
    fn a_file_that_cannot_be_used_asks_for_a_frame_that_says_so() {
        let mut harness = app_at_rest();
        harness.state_mut().take_file(FilePurpose::Session, "a.riemap", Ok(vec![1, 2]));
        assert!(harness.ctx.has_requested_repaint());
        step_until(&mut harness, |app| !app.errors().is_empty());
        harness.step();
        harness.get_by_label_contains("a.riemap: ");
    }

    #[test]
    fn after_what_has_come_in_the_panels_get_another_frame_and_stages_wait() {
        let mut harness = app_at_rest();
        let mailbox = harness.state().workers.mailbox.clone();
        let mut asks_for_a_frame = |event| {
            let context = egui::Context::default();
            for _ in 0..3 {
                context.run_ui(egui::RawInput::default(), |_| {}).textures_delta.clear();
            }
            assert!(!context.has_requested_repaint());
            mailbox.post(event);
            harness.state_mut().take_events(&context);
            context.has_requested_repaint()
        };
        assert!(asks_for_a_frame(Event::NotSaved { name: "a.png".into(), reason: "no room".into() }));
        let response = worker::Response::Progress(crate::conformal::Stage::Read);
        assert!(!asks_for_a_frame(Event::Worker { side: Side::Target, generation: 0, response }));
    }
}
