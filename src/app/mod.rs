//! The app: panels, viewports, handles.
//!
//! A frame is the six lines of `RiemapApp::ui`: **input** lays out the panels and collects what the person asks for as
//! [`Action`]s, **commands** carries them out in one place (`carry_out`), **events** takes in what happened outside of a
//! frame (workers, files; `incoming`), **update** brings the map up to date and uploads what changed (`frame`), **paint**
//! paints the pictures (`pictures`), **announce** tells the page and those who hear the screen. Panels that have more to
//! say after an update do so in a frame that follows. At rest nothing is computed and nothing drawn.

mod accessibility;
mod announced;
mod arrangement;
mod carry_out;
mod editing;
mod export_work;
mod facts;
mod frame;
mod host;
mod incoming;
pub mod input;
pub mod language;
mod layout;
mod menus;
mod message_bar;
mod overlays;
mod panels;
mod pictures;
mod plots;
mod sessions;
mod startup;
mod status;
mod theme;
mod viewport;
mod windows;

pub use host::start;
pub use input::action::{Action, Actions};
pub use startup::Startup;
pub use status::stats::Stats;

use crate::language::{Label, Message};
use crate::model::motion::Player;
use crate::model::persistence::Persistence;
use crate::model::{Model, pattern};
use crate::platform::{self, Event, Mailbox, Preparer, StudyRunner};
use crate::render::TextureStyle;
use crate::session::Session;
use announced::Announced;
use editing::Editor;
use image::RgbaImage;
use input::action::Report;
use input::address_options::AddressOptions;
use input::handles::HandleState;
use input::keyboard::Keyboard;
use input::locks::Control;
use input::preferences::Preferences;
use input::presentation;
use input::touches::Touches;
use message_bar::MessageBar;
use panels::offer::Offer;
use plots::Plots;
use status::FrameMeter;
use std::sync::{Arc, mpsc};
use viewport::cells::CellUploads;
use viewport::gpu::Gpu;
use viewport::surface::OrbitView;
use viewport::view::View;
use windows::explore::Explore;
use windows::exporting::Exporter;
use windows::reports::Reports;

/// Below this width (in points) the controls become a sheet.
pub const PHONE_WIDTH: f32 = 700.0;

/// How long a notice is shown, in seconds: two words are read in one, once they have been seen.
const NOTICE_SECONDS: f64 = 3.0;

/// What those who hear the screen are told about: the map, whether it is there, messages, the tour; how; a notice.
type News = ((u64, bool, Vec<Message>, Option<usize>), Preferences, Option<u64>);

/// The app.
pub struct RiemapApp {
    model: Model,
    preparer: Preparer,
    mailbox: Mailbox,
    events: mpsc::Receiver<Event>,
    /// Files that were dropped since the last frame.
    dropped: Vec<egui::DroppedFileHandle>,
    gpu: Option<Gpu>,
    views: [View; 2],
    /// How the surface is seen that may stand in the target's place.
    orbit: OrbitView,
    cells: CellUploads,
    plots: Plots,
    handles: HandleState,
    editor: Editor,
    meter: FrameMeter,
    options: AddressOptions,
    panels_open: bool,
    sheet_open: bool,
    keyboard: Keyboard,
    touches: Touches,
    /// How many times a control was said, and which theme is shown: for [`Stats`].
    spoken: u64,
    theme: egui::Theme,
    has_fingers: bool,
    /// What there was to tell when the picture was described.
    described: Option<News>,
    explore: Explore,
    persistence: Persistence,
    announced: Announced,
    reports: Reports,
    study_runner: StudyRunner,
    player: Player,
    exporter: Exporter,
    image_name: Option<String>,
    /// The picture that can be traced now.
    offer: Option<Offer>,
    /// The texture of that name.
    image: Option<Arc<RgbaImage>>,
    /// What is wrong and belongs to neither side: an image, a file that was to be saved, a link, what is locked.
    message: Option<Message>,
    /// What is there to read below the pictures.
    message_bar: MessageBar,
    /// What has gone well and cannot be seen, and when it need not be said any more.
    notice: Option<(Label, f64)>,
    preferences: Preferences,
    last_change: f64,
    /// How much larger than usual everything is.
    zoom: f32,
}

impl RiemapApp {
    /// Goes on from `startup` on a screen.
    pub fn new(
        creation: &eframe::CreationContext<'_>,
        startup: Startup,
    ) -> Result<Self, Box<dyn std::error::Error + Send + Sync>> {
        theme::install(&creation.egui_ctx);
        let Startup { model, resumes, missing, message, preferences, preparer, mailbox, events } = startup;
        let options = host::address_options();
        let preferences = presentation::install(&creation.egui_ctx, preferences, &options);
        mailbox.attach(&creation.egui_ctx);
        if let Some(state) = &creation.wgpu_render_state {
            platform::watch_graphics(&state.device, mailbox.clone());
        }
        let mut persistence = Persistence::new(model.session().clone(), resumes);
        persistence.open_link(missing, platform::link());
        let (mut reports, study_runner) = (Reports::default(), StudyRunner::new(mailbox.clone()));
        if options.bench {
            reports.open(Report::Bench);
        }
        Ok(Self {
            model,
            preparer,
            mailbox,
            events,
            dropped: Vec::new(),
            gpu: creation.wgpu_render_state.clone().map(Gpu::new),
            views: [View::default(), View::default()],
            orbit: OrbitView::default(),
            cells: CellUploads::default(),
            plots: Plots::default(),
            handles: HandleState::default(),
            editor: Editor::default(),
            meter: FrameMeter::default(),
            panels_open: !options.embed,
            sheet_open: false,
            keyboard: Keyboard::default(),
            touches: Touches::default(),
            spoken: 0,
            theme: egui::Theme::Dark,
            has_fingers: platform::has_fingers(),
            described: None,
            explore: Explore::default(),
            persistence,
            announced: Announced::default(),
            reports,
            study_runner,
            player: Player::default(),
            exporter: Exporter::default(),
            image_name: None,
            offer: None,
            image: None,
            message: presentation::with_user_errors(message, &options),
            message_bar: MessageBar::default(),
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

    /// Shows another session in place of this one; what it shares is not prepared again. Where sessions are locked, only
    /// the page around the app may do so: its session is the one to begin with, and no undo leads behind it.
    pub fn open_session(&mut self, session: Session) {
        self.end_tour();
        if self.options.locks.holds(Control::Session) {
            self.persistence.begin_anew();
        } else {
            self.persistence.touch();
        }
        self.show_session(session);
    }

    fn texture_style(&self, dark: bool) -> Option<TextureStyle> {
        pattern::style(&self.model, self.image_name.is_some(), dark)
    }
}

impl eframe::App for RiemapApp {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        let context = ui.ctx().clone();
        let (arrangement, actions) = self.take_input(ui, frame.info().cpu_usage);
        self.carry_out(&context, actions);
        self.take_events(&context);
        self.advance(&context);
        self.paint(ui, arrangement);
        self.announce(ui);
    }

    fn raw_input_hook(&mut self, context: &egui::Context, input: &mut egui::RawInput) {
        self.touches.take_in(&mut input.events);
        // egui would draw two frames for what stays in here
        self.dropped.append(&mut input.dropped_files);
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
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
