//! The app: panels, viewports, handles.
//!
//! A frame: take in what happened outside of it (workers, files), show the
//! panels and collect what the person wants as [`Action`]s, carry those out in
//! one place (`carry_out`), bring the map up to date, upload what
//! changed, paint. At rest nothing is computed and nothing drawn.

mod action;
pub mod address_options;
mod announced;
mod cells;
mod colouring;
mod dots;
mod draft;
mod editing;
mod explore;
pub mod exporting;
mod figures_menu;
mod file_menu;
mod files;
mod gpu;
mod gpu_extension;
mod handles;
mod header;
mod help_menu;
mod incoming;
mod keeping;
mod keyboard;
pub mod language;
mod layout;
mod legend;
mod locks;
mod looping;
mod method;
mod model;
mod nudge;
mod offer;
mod play_panel;
mod playing;
mod plots;
mod preferences;
mod prepare_state;
mod presentation;
mod reports;
mod sessions;
mod shapes;
mod side_panel;
mod spoken;
mod stats;
mod status;
pub mod still;
mod surface;
mod teaching;
mod textured;
mod theme;
mod top_bar;
mod tracing;
mod trouble;
mod view;
mod viewport;
mod widgets;
mod words;

pub use action::{Action, Actions};
pub use model::Model;
pub use stats::{Processor, Stats};

use crate::conformal::{Extension, Side};
use crate::platform::{self, Event, FilePurpose, Laboratory, Mailbox, Preparer};
use crate::render::TextureStyle;
use crate::session::Session;
use crate::session::link::MissingOutline;
use address_options::AddressOptions;
use announced::Announced;
use cells::Cells;
use editing::{EditAction, Editor};
use explore::{Explore, ExploreAction};
use exporting::Exporter;
use gpu::Gpu;
use handles::HandleState;
use image::RgbaImage;
use keeping::{Keeper, Start};
use keyboard::Keyboard;
use locks::Locks;
use model::{Changes, Refines};
use offer::Offer;
use playing::Player;
use plots::Plots;
use preferences::Preferences;
use reports::{Report, Reports};
use stats::{HandlePositions, ScreenFacts};
use status::FrameMeter;
use std::sync::{Arc, mpsc};
use surface::OrbitView;
use teaching::walks::WalkAction;
use view::View;

/// Below this width (in points) the viewports are stacked and the controls become a sheet.
pub const PHONE_WIDTH: f32 = 700.0;

/// How long the map must rest before an expensive quality is computed, in seconds.
const REST_SECONDS: f64 = 0.15;

/// How long a notice is shown, in seconds: two words are read in one, once they have been seen.
const NOTICE_SECONDS: f64 = 3.0;

/// What those who hear the screen are told about: the map, whether it is there, messages, the tour; how; a notice.
type News = ((u64, bool, usize, Option<usize>), Preferences, Option<u64>);

/// What needs no screen: the session's state and the workers.
pub struct Groundwork {
    model: Model,
    /// Whether the session goes on where the last one ended, and is kept for the next.
    resumes: bool,
    /// The outlines that the session's link only names.
    missing: Vec<MissingOutline>,
    message: Option<String>,
    preferences: Preferences,
    preparer: Preparer,
    mailbox: Mailbox,
    events: mpsc::Receiver<Event>,
}

impl Groundwork {
    /// Begins with the preparations of `session`: they run while the graphics start.
    pub fn start(session: Session) -> Self {
        let (mailbox, events) = Mailbox::new();
        let (mut model, mut preparer) = (Model::new(session), Preparer::new(mailbox.clone()));
        for (subject, request) in model.take_requests(0.0) {
            preparer.request(subject, request);
        }
        Self {
            model,
            resumes: false,
            missing: Vec::new(),
            message: None,
            preferences: Preferences::fixed(),
            preparer,
            mailbox,
            events,
        }
    }

    /// As [`Self::start`], with the session and the preferences that the address or the last time has left; what went
    /// wrong with the session is shown.
    pub fn resume() -> Self {
        let Start { session, missing, message } = keeping::first_session();
        Self { missing, message, resumes: true, preferences: Preferences::remembered(), ..Self::start(session) }
    }

    /// Where events for the app are posted.
    pub fn mailbox(&self) -> Mailbox {
        self.mailbox.clone()
    }
}

/// The app.
pub struct RiemapApp {
    model: Model,
    preparer: Preparer,
    mailbox: Mailbox,
    events: mpsc::Receiver<Event>,
    gpu: Option<Gpu>,
    views: [View; 2],
    /// How the surface is seen that may stand in the target's place.
    orbit: OrbitView,
    cells: Cells,
    plots: Plots,
    handles: HandleState,
    editor: Editor,
    meter: FrameMeter,
    options: AddressOptions,
    panels_open: bool,
    sheet_open: bool,
    keyboard: Keyboard,
    /// How many times a control was said, and which theme is shown: for [`Stats`].
    spoken: u64,
    theme: egui::Theme,
    has_fingers: bool,
    /// What there was to tell when the picture was described.
    described: Option<News>,
    explore: Explore,
    keeper: Keeper,
    announced: Announced,
    reports: Reports,
    laboratory: Laboratory,
    player: Player,
    exporter: Exporter,
    image_name: Option<String>,
    /// The picture that can be traced now.
    offer: Option<Offer>,
    /// The texture of that name.
    image: Option<Arc<RgbaImage>>,
    /// What is wrong with an image or a file that was to be saved.
    message: Option<String>,
    /// What has gone well and cannot be seen, and when it need not be said any more.
    notice: Option<(&'static str, f64)>,
    preferences: Preferences,
    last_change: f64,
    /// How much larger than usual everything is.
    zoom: f32,
}

impl RiemapApp {
    /// Goes on from `groundwork` on a screen.
    pub fn new(
        creation: &eframe::CreationContext<'_>,
        groundwork: Groundwork,
    ) -> Result<Self, Box<dyn std::error::Error + Send + Sync>> {
        theme::install(&creation.egui_ctx);
        let Groundwork { model, resumes, missing, message, preferences, preparer, mailbox, events } = groundwork;
        let options = platform::address_options();
        let preferences = presentation::install(&creation.egui_ctx, preferences, &options);
        mailbox.attach(&creation.egui_ctx);
        if let Some(state) = &creation.wgpu_render_state {
            platform::watch_graphics(&state.device, mailbox.clone());
        }
        let mut keeper = Keeper::new(model.session().clone(), resumes);
        keeper.open_link(missing);
        let (mut reports, laboratory) = (Reports::default(), Laboratory::new(mailbox.clone()));
        if options.bench {
            reports.open(Report::Bench);
        }
        Ok(Self {
            model,
            preparer,
            mailbox,
            events,
            gpu: creation.wgpu_render_state.clone().map(Gpu::new),
            views: [View::default(), View::default()],
            orbit: OrbitView::default(),
            cells: Cells::default(),
            plots: Plots::default(),
            handles: HandleState::default(),
            editor: Editor::default(),
            meter: FrameMeter::default(),
            panels_open: !options.embed,
            sheet_open: false,
            keyboard: Keyboard::default(),
            spoken: 0,
            theme: egui::Theme::Dark,
            has_fingers: platform::has_fingers(),
            described: None,
            explore: Explore::default(),
            keeper,
            announced: Announced::default(),
            reports,
            laboratory,
            player: Player::default(),
            exporter: Exporter::default(),
            image_name: None,
            offer: None,
            image: None,
            message: presentation::with_troubles(message, &options),
            options,
            notice: None,
            preferences,
            last_change: 0.0,
            zoom: 1.0,
        })
    }

    /// What the map on the screen is made from.
    pub fn session(&self) -> &Session {
        self.model.session()
    }

    /// The numbers on the screen.
    pub fn stats(&self) -> Stats {
        let place = |side: Side, point: Option<glam::DVec2>| {
            point.map(|point| self.views[side as usize].to_screen(point)).map(|place| self.css_pixels(place))
        };
        let in_space = |point: Option<glam::DVec3>| self.orbit.to_screen(point?).map(|place| self.css_pixels(place));
        let [x2, y2] = match self.model.surface() {
            Some(_) => [self.model.surface_point(), self.model.surface_anchor()].map(in_space),
            None => [self.model.interior(Side::Target), self.model.anchor(Side::Target)]
                .map(|point| place(Side::Target, point)),
        };
        let handles = HandlePositions {
            x1: place(Side::Source, self.model.interior(Side::Source)),
            x2,
            y1: place(Side::Source, self.model.anchor(Side::Source)),
            y2,
        };
        let backend = self.gpu.as_ref().map(Gpu::backend).unwrap_or_default();
        let screen = ScreenFacts {
            backend,
            handles,
            errors: self.errors(),
            notes: self.notes(),
            undo: self.keeper.history().undo_count(),
            dark: self.theme == egui::Theme::Dark,
            spoken: self.spoken,
            playing: self.player.is_playing(),
            export: self.exporter.places().cloned(),
            export_count: self.exporter.count(),
            marked_boundary: self.plots.marked(),
            exact_difference: self.plots.exact().map(|exact| exact.difference),
            cauchy_green: self.cauchy_green(),
            editing: editing::stats(&self.editor, &self.views),
        };
        stats::collect(&self.model, screen)
    }

    /// Shows another session in place of this one; what it shares is not prepared again.
    pub fn open_session(&mut self, session: Session) {
        self.keeper.touch();
        self.show_session(session);
    }

    /// Takes in an outline or a surface as if its file had been opened.
    pub fn load_file(&mut self, side: Side, name: &str, bytes: Vec<u8>) {
        self.read_file(FilePurpose::Outline(side), name, Ok(bytes));
        self.mailbox.wake();
    }

    /// A place on the screen as the page measures it.
    fn css_pixels(&self, place: egui::Pos2) -> [f32; 2] {
        [place.x * self.zoom, place.y * self.zoom]
    }

    fn errors(&self) -> Vec<String> {
        let sides = Side::BOTH.into_iter().filter_map(|side| Some(self.model.side(side).error.as_ref()?.text.clone()));
        let surface = self.model.surface_side().preparation.error.iter().map(|trouble| trouble.text.clone());
        let map = self.model.map_error().map(|(_, text)| text.to_owned());
        sides.chain(surface).chain(map).chain(self.message.clone()).collect()
    }

    fn notes(&self) -> Vec<String> {
        let outlines = Side::BOTH.into_iter().flat_map(|side| &self.model.side(side).notes).map(ToString::to_string);
        outlines.chain(self.model.surface_notes()).collect()
    }

    /// The one place where wishes become changes.
    fn carry_out(&mut self, context: &egui::Context, actions: Actions) {
        let now = context.input(|input| input.time);
        let locks = Locks::of(context);
        for action in actions.into_iter().filter(|action| locks.refused(action).is_none()) {
            match action {
                Action::Session(command) => {
                    if command.moves_points() {
                        self.player.pause();
                    }
                    if command.replaces_shapes() {
                        self.explore.keep();
                    }
                    self.keeper.touch();
                    self.model.dispatch(command, now);
                }
                Action::Undo => self.step(Keeper::undo),
                Action::Redo => self.step(Keeper::redo),
                Action::New => self.open_session(Session::default()),
                Action::OpenSession => platform::pick_file(FilePurpose::Session, self.mailbox.clone()),
                Action::SaveSession => self.save_session(),
                Action::CopyLink => self.copy_link(context),
                Action::OpenOutline(side) => platform::pick_file(FilePurpose::Outline(side), self.mailbox.clone()),
                Action::OpenTrace(side) => platform::pick_file(FilePurpose::Trace(side), self.mailbox.clone()),
                Action::TraceImage => self.trace_image(),
                Action::DismissOffer => self.offer = None,
                Action::OpenImage => platform::pick_file(FilePurpose::Image, self.mailbox.clone()),
                Action::Fit(Side::Target) if self.model.surface().is_some() => self.orbit.fit(),
                Action::Fit(side) => self.views[side as usize].fit(),
                Action::Edit(action) => {
                    if matches!(action, EditAction::Close | EditAction::TakePasted) {
                        self.explore.keep();
                    }
                    self.keeper.touch();
                    self.editor.act(action, &mut self.model, &mut self.views);
                }
                Action::PasteText(text) => {
                    self.explore.keep();
                    self.keeper.touch();
                    self.editor.take_text(text, &mut self.model, &mut self.views);
                }
                Action::Remedy(subject) => self.model.remedy(subject),
                Action::Dismiss(subject) => self.model.dismiss(subject),
                Action::OpenReport(report) => self.reports.open(report),
                Action::DismissMessage => self.message = None,
                Action::OpenExport => self.exporter.open(),
                Action::SaveExport => self.save_export(context),
                Action::CancelExport => self.exporter.cancel(),
                Action::Play(action) => self.player.act(action, &self.model),
                Action::Walks(action) => self.model.act_on_walks(action),
                Action::Explore(action) => self.explore(action),
                Action::Prefer(preferences) => self.prefer(context, preferences),
                Action::TogglePanels => self.fold_panels(context),
                Action::ToggleFullScreen => platform::toggle_full_screen(context),
                Action::TogglePresentation => presentation::toggle(context),
            }
        }
    }

    fn explore(&mut self, action: ExploreAction) {
        let is_walking = self.model.teaching().walks.is_running();
        let explore::Consequences { session, walks } = self.explore.act(action, self.model.session(), is_walking);
        if let Some(session) = session {
            self.show_session(session);
        }
        if walks.is_some_and(|run| run != self.model.teaching().walks.is_running()) {
            self.model.act_on_walks(WalkAction::Toggle);
        }
    }

    fn prefer(&mut self, context: &egui::Context, preferences: Preferences) {
        self.preferences = preferences;
        preferences.apply(context);
        preferences.remember();
    }

    /// Sends what is due to the workers, updates the map, uploads.
    fn advance(&mut self, context: &egui::Context) {
        let now = context.input(|input| input.time);
        self.editor.follow(&mut self.model, &mut self.views);
        if let Some(study) = self.reports.take_study() {
            self.laboratory.begin(study);
        }
        let is_held = self.handles.grip.is_some();
        if is_held {
            self.player.pause();
        }
        self.play(context, now);
        // A dot that is held still rests.
        let moves = self.player.is_playing() || (is_held && now - self.last_change < REST_SECONDS);
        let changes = self.model.refresh(moves);
        if changes != Changes::default() {
            self.last_change = now;
            self.show_changes(context, changes);
        }
        // after the map: what is in a hand is prepared anew as soon as the picture shows it, in the same frame
        for (subject, request) in self.model.take_requests(now) {
            self.preparer.request(subject, request);
        }
        if let Some(due) = self.model.next_due() {
            context.request_repaint_after_secs((due - now).max(0.0) as f32);
        }
        let resting = now - self.last_change >= REST_SECONDS;
        if resting {
            let refined = self.model.refine_at_rest();
            if refined.images {
                self.show_changes(context, refined);
            }
        }
        if self.model.is_pending() {
            context.request_repaint_after_secs(if moves { REST_SECONDS as f32 } else { 0.0 });
        }
        for side in Side::BOTH {
            if self.model.take_refit(side) {
                self.views[side as usize].fit();
                if side == Side::Target {
                    self.look_at_surface();
                }
                context.request_repaint();
            }
        }
        let complete = self.model.extension_progress() == 1.0;
        if self.model.is_quality_stale() || !complete {
            if resting && complete {
                self.model.measure_at_rest();
                context.request_repaint();
            } else {
                context.request_repaint_after_secs(REST_SECONDS as f32);
            }
        }
        if let Some(delay) = self.model.teach(now) {
            context.request_repaint_after_secs(delay as f32);
        }
        self.work_on_export(context);
        self.describe(context, now);
        self.keep(context);
        self.cells.update(&self.model, self.gpu.as_ref(), context.pixels_per_point());
        self.plots.update(&self.model);
    }

    /// Moves the points that are in motion.
    fn play(&mut self, context: &egui::Context, now: f64) {
        for command in self.player.advance(&self.model, now) {
            self.keeper.touch();
            self.model.dispatch(command, now);
        }
        if self.player.is_playing() {
            context.request_repaint();
        }
    }

    /// Tells those who hear the screen what is on it, whenever something else is and has come to rest.
    fn describe(&mut self, context: &egui::Context, now: f64) {
        let rested = now - self.last_change;
        if rested < REST_SECONDS {
            // a drag collects no news
            context.request_repaint_after_secs((REST_SECONDS - rested) as f32);
            return;
        }
        let news = (self.model.generation(), self.model.is_ready(), self.errors().len(), self.explore.step());
        let news = (news, self.preferences, self.notice.as_ref().map(|(_, until)| until.to_bits()));
        if self.described.as_ref() == Some(&news) {
            return;
        }
        platform::describe(&spoken::state(self));
        self.described = Some(news);
    }

    /// Another surface is seen from where it shows the most.
    fn look_at_surface(&mut self) {
        let seen = self.model.surface();
        if let Some(camera) = seen.and_then(|(surface, state)| surface.first_view(state, self.orbit.aspect())) {
            self.orbit.look(camera);
        }
    }

    /// Uploads, and asks for another frame: the status line was laid out before the change.
    fn show_changes(&mut self, context: &egui::Context, changes: Changes) {
        context.request_repaint();
        if let Some(gpu) = &mut self.gpu
            && !gpu.upload(&self.model, changes)
        {
            self.message =
                Some(String::from("This surface is too large for the graphics device: it is mapped but not shown."));
        }
        let extended = self.gpu.as_ref().is_some_and(|gpu| gpu.extends(&self.model));
        self.model.set_refines(if extended { Refines::AtRest } else { Refines::InRefresh });
    }

    /// Where the Cauchy–Green extension in the picture comes from, if it is asked for.
    fn cauchy_green(&self) -> Option<Processor> {
        let on_gpu = self.gpu.as_ref().is_some_and(|gpu| gpu.extends(&self.model));
        let asked = self.model.session().extension == Extension::CauchyGreen;
        asked.then_some(if on_gpu { Processor::Gpu } else { Processor::Cpu })
    }

    fn texture_style(&self, dark: bool) -> Option<TextureStyle> {
        textured::style(&self.model, self.image_name.is_some(), dark)
    }
}

impl eframe::App for RiemapApp {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        self.take_events();
        self.take_dropped(ui.ctx());
        self.zoom = ui.ctx().zoom_factor();
        let compute = self.model.shown().map_or(0.0, |map| {
            let timings = map.timings;
            timings.kernel + timings.matching + timings.extend
        });
        let since_last = ui.input(|input| input.unstable_dt);
        self.meter.tick(since_last, frame.info().cpu_usage, compute);
        self.theme = ui.ctx().theme();
        layout::show(self, ui);
        self.announce();
        let spoken = ui.output(|output| output.events.last().map(|event| spoken::control(event.widget_info())));
        if let Some(spoken) = spoken {
            platform::say(&spoken);
            self.spoken += 1;
        }
    }

    fn raw_input_hook(&mut self, context: &egui::Context, input: &mut egui::RawInput) {
        let folds = self.keyboard.take_in(context, input);
        if folds % 2 == 1 {
            self.fold_panels(context);
        }
    }

    fn clear_color(&self, visuals: &egui::Visuals) -> [f32; 4] {
        theme::Palette::of(visuals).canvas.to_normalized_gamma_f32()
    }

    #[cfg(target_arch = "wasm32")]
    fn as_any_mut(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self)
    }
}

#[cfg(test)]
mod colour_vision_tests;
#[cfg(test)]
mod language_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod locks_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
