//! What comes in from outside of a frame: the workers' answers, files, links.

use super::RiemapApp;
use crate::app::input::locks::Control;
use crate::app::input::presentation;
use crate::app::panels::offer::Offer;
use crate::app::viewport::gpu::Gpu;
use crate::app::viewport::pictures::TextureImage;
use crate::conformal::Side;
use crate::language::{Message, key};
use crate::model::editing::tracing;
use crate::model::files;
use crate::model::files::{Content, FileError, FilePurpose, Picture};
use crate::model::side::user_error::UserError;
use crate::platform::{self, Event};
use crate::session::{Command, SurfaceShape, SurfaceSpec, TextureKind};
use std::sync::Arc;

/// When what the panels say follows the pictures, in seconds: sooner than anyone reads.
pub(super) const WORDS_FOLLOW_AFTER: f32 = 0.05;

impl RiemapApp {
    /// What happened since the last frame; the panels follow in another one, but for stages, of which they say
    /// nothing. That frame waits a little: where the processor draws, it would keep the pictures from the screen.
    pub(super) fn take_events(&mut self, context: &egui::Context) {
        while let Ok(event) = self.workers.events.try_recv() {
            if !event.is_stage() {
                context.request_repaint_after_secs(WORDS_FOLLOW_AFTER);
            }
            match event {
                Event::Worker { side, generation, response } => {
                    let before = self.surface_file(side);
                    self.model.accept(side, generation, response);
                    if self.surface_file(side).is_some_and(|file| before != Some(file)) {
                        self.end_tour();
                    }
                }
                Event::WorkerDied { side, reason } => self.model.worker_died(side, &reason),
                Event::Found { study, finding } => self.windows.reports.accept(study, finding),
                Event::File { purpose, name, bytes } => self.read_file(purpose, &name, bytes),
                Event::Link(address) => {
                    if self.may(Control::Session) {
                        self.open_link(&address);
                    } else {
                        self.correct_address();
                    }
                }
                Event::GraphicsLost(reason) => self.messages.common = Some(presentation::graphics_lost(&reason)),
                Event::Image { purpose, name, pixels } => self.take_image(purpose, name, pixels),
                Event::NoDialog(reason) => self.messages.common = Some(reason),
                Event::NotSaved { name, reason } => self.messages.common = Some(key::not_saved(name, reason)),
            }
        }
    }

    /// Takes in a file between two frames.
    pub fn take_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>) {
        self.read_file(purpose, name, bytes);
        let requests = self.model.take_requests(f64::NEG_INFINITY);
        if requests.is_empty() {
            self.workers.mailbox.wake();
        } else {
            // a frame would show little that is new, and take the processor from the worker
            self.workers.mailbox.wake_for_stages();
        }
        for (side, request) in requests {
            self.workers.preparer.request(side, request);
        }
    }

    fn read_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>) {
        let limit = self.pictures.gpu.as_ref().map_or(2048, Gpu::max_texture_side);
        let content = files::read(purpose, name, bytes);
        if !locked_by(&content, purpose).iter().all(|&control| self.may(control)) {
            return;
        }
        match content {
            Ok(Content::Outline(..) | Content::Session(_)) => self.begin_change(),
            // it takes the tour's place when it is there: it is read by its worker
            Ok(Content::Surface { .. }) => self.persistence.touch(),
            Ok(Content::Image { .. }) | Err(_) => {}
        }
        match content {
            Ok(Content::Image { name, bytes }) => {
                self.messages.common = None;
                let limit = if matches!(purpose, FilePurpose::Trace(_)) { tracing::MAX_SIDE } else { limit };
                platform::decode_image(purpose, name, bytes, limit, self.workers.mailbox.clone());
            }
            content => self.take(content),
        }
    }

    /// The surface that stands on a side, if it came from a file.
    fn surface_file(&self, side: Side) -> Option<SurfaceSpec> {
        let (_, state) = self.model.surface(side)?;
        matches!(state.spec.shape, SurfaceShape::File { .. }).then(|| state.spec.clone())
    }

    /// What the person has brought changes the session.
    pub(super) fn begin_change(&mut self) {
        self.end_tour();
        self.persistence.touch();
    }

    /// An image was decoded, or could not be.
    fn take_image(&mut self, purpose: FilePurpose, name: String, pixels: Result<image::RgbaImage, Message>) {
        if pixels.is_ok() {
            self.begin_change();
        }
        match (purpose, pixels) {
            (FilePurpose::Trace(side), Ok(pixels)) => self.take(files::traced(side, &Picture { name, pixels })),
            (FilePurpose::Trace(side), Err(reason)) => {
                self.model.side_mut(side).error = Some(UserError::new(key::about(name, reason)));
            }
            (_, Ok(pixels)) => {
                let side = if let FilePurpose::Dropped(side) = purpose { side } else { Side::Source };
                let picture = Picture { name, pixels };
                self.messages.offer = Some(Offer::new(side, &picture));
                self.use_image(picture);
            }
            (_, Err(reason)) => self.messages.common = Some(key::about(name, reason)),
        }
    }

    /// Traces the picture that has just become the texture.
    pub(super) fn trace_image(&mut self) {
        if let Some(offer) = self.messages.offer.take() {
            self.persistence.touch();
            self.take(offer.accept());
        }
    }

    fn take(&mut self, content: Result<Content, FileError>) {
        match content {
            Ok(Content::Outline(side, outline)) => self.model.want_loaded(side, outline),
            Ok(Content::Image { .. }) => {} // is decoded first
            Ok(Content::Session(session)) => {
                self.messages.common = None;
                self.open_session(*session);
            }
            Ok(Content::Surface { side, name, bytes }) => {
                let side = self.model.side_for_surface(side, &name);
                self.model.want_surface_file(side, &name, bytes);
            }
            Err(FileError::Outline(side, user_error)) => {
                self.model.dismiss(side);
                self.model.side_mut(side).error = Some(user_error);
            }
            Err(FileError::Common(message)) => self.messages.common = Some(message),
        }
    }

    /// Whether a control may be changed from outside of the panels; if not, that is said.
    fn may(&mut self, control: Control) -> bool {
        let locked = self.options.locks.holds(control);
        if locked {
            self.refuse(control);
        }
        !locked
    }

    /// Says that a control is locked.
    pub(super) fn refuse(&mut self, control: Control) {
        self.messages.common = Some(key::address_keeps(control.name()));
    }

    pub(super) fn use_image(&mut self, picture: Picture) {
        let (width, height) = picture.pixels.dimensions();
        let used =
            self.pictures.gpu.as_ref().map_or(Ok(()), |gpu| gpu.set_image(picture.pixels.as_raw(), width, height));
        match used {
            Ok(()) => {
                let Picture { name, pixels } = picture;
                self.pictures.image = Some(TextureImage { name, pixels: Arc::new(pixels) });
                self.model.dispatch(Command::SetTexture(TextureKind::Image), 0.0);
            }
            Err(error) => self.messages.common = Some(key::about(picture.name, Message::from(&error))),
        }
    }

    /// Reads the files that were dropped, for the side that they were dropped over.
    pub(super) fn take_dropped(&mut self, context: &egui::Context) {
        let place = platform::drop_position(context);
        let over_target = place.is_some_and(|place| self.pictures.views[Side::Target].rect.contains(place));
        let side = if over_target { Side::Target } else { Side::Source };
        for file in self.input.dropped.drain(..) {
            platform::read_dropped(file, side, self.workers.mailbox.clone());
        }
    }
}

/// What a file would change, or could if it were repaired.
fn locked_by(content: &Result<Content, FileError>, purpose: FilePurpose) -> &'static [Control] {
    match content {
        Ok(Content::Outline(..) | Content::Surface { .. }) | Err(FileError::Outline(..)) => Control::OF_SHAPES,
        Ok(Content::Image { .. }) if matches!(purpose, FilePurpose::Trace(_)) => Control::OF_SHAPES,
        Ok(Content::Image { .. }) => &[Control::Pattern],
        Ok(Content::Session(_)) => &[Control::Session],
        Err(FileError::Common(_)) => &[],
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::app::Session;
    use crate::app::input::action::{Action, ExploreAction};
    use crate::app::tests::ready_app;
    use crate::worker::{self, SurfaceSource, Task};
    use egui_kittest::Harness;
    use egui_kittest::kittest::Queryable;
    use std::time::Duration;

    /// A small surface as an OBJ file.
    fn surface_file() -> Vec<u8> {
        let Task::Surface { source: SurfaceSource::File { bytes, .. }, .. } = worker::rehearsal().task else {
            panic!("the rehearsal reads a file")
        };
        bytes.to_vec()
    }

    fn step_until(harness: &mut Harness<'_, RiemapApp>, is_there: impl Fn(&RiemapApp) -> bool) {
        for _ in 0..600 {
            harness.step();
            if is_there(harness.state()) {
                return;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        assert!(is_there(harness.state()), "after 600 frames: {:?}", harness.state().stats());
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

    /// The app when no frame is asked for any more.
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
        assert!(app.windows.explore.is_touring() && !app.errors().is_empty());
        app.open_session(Session::default());
        assert!(!app.windows.explore.is_touring());
        begin(app);
        app.take_file(FilePurpose::Outline(Side::Source), "square.csv", Ok(b"0,0\n1,0\n1,1\n0,1\n".to_vec()));
        assert!(!app.windows.explore.is_touring());
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
        step_until(&mut harness, |app| app.surface_file(Side::Target).is_some());
    }

    #[test]
    fn what_was_wrong_with_a_target_outline_is_past_when_a_surface_takes_its_place() {
        let mut harness = ready_app([1200.0, 800.0]);
        let app = harness.state_mut();
        app.take_file(FilePurpose::Outline(Side::Target), "bow.csv", Ok(b"0,0\n1,1\n1,0\n0,1\n".to_vec()));
        assert_eq!(app.errors().len(), 1);
        app.take_file(FilePurpose::Outline(Side::Target), "head.obj", Ok(surface_file()));
        assert!(app.errors().is_empty(), "{:?}", app.errors());
        // and the other way round
        app.take_file(FilePurpose::Outline(Side::Target), "broken.obj", Ok(b"v 0 0 0\nf 1 2 3\n".to_vec()));
        step_until(&mut harness, |app| !app.model.surface_side(Side::Target).preparation.pending_request().is_busy());
        let app = harness.state_mut();
        app.take_file(FilePurpose::Outline(Side::Target), "bow.csv", Ok(b"0,0\n1,1\n1,0\n0,1\n".to_vec()));
        let errors = app.errors();
        assert!(errors.len() == 1 && errors[0].english().starts_with("bow.csv"), "{errors:?}");
    }

    #[test]
    fn a_message_that_hides_which_file_is_missing_gives_way_to_that() {
        let mut harness = ready_app([1200.0, 800.0]);
        let context = harness.ctx.clone();
        let app = harness.state_mut();
        // too many of no order for a link
        let jagged = |k: u32| 1.0 + 0.2 * f64::from(k * 7919 % 1000) / 1000.0;
        let points: Vec<_> =
            (0..6000).map(|k| jagged(k) * crate::geometry::DVec2::from_angle(f64::from(k) * 1e-3)).collect();
        let mut session = app.session().clone();
        let outline = crate::session::OutlineSpec::Points { name: "big".into(), polygon: points.try_into().unwrap() };
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
