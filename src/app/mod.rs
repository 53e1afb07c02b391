//! The app: panels, viewports, handles.
//!
//! A frame: show the panels and collect what the person wants as [`Action`]s,
//! carry those out in one place (`carry_out`), take in what happened outside of it
//! (workers, files), show the message below the pictures, the same for the pictures, bring
//! the map up to date, upload what changed, paint. Panels that have more to say then do so in a frame that follows.
//! At rest nothing is computed and nothing drawn.

mod action;
pub mod address_options;
mod announced;
mod arrangement;
mod carry_out;
mod cells;
mod colouring;
mod dots;
mod draft;
mod editing;
mod errand;
mod explore;
pub mod exporting;
mod facts;
mod figures_menu;
mod file_menu;
mod files;
mod foot;
mod frame;
mod gpu;
mod gpu_extension;
mod groundwork;
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
mod pictures;
mod play_panel;
mod playing;
mod plots;
mod preferences;
mod prepare_state;
mod presentation;
mod reports;
mod room;
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
mod touches;
mod tracing;
mod trouble;
mod view;
mod viewport;
mod widgets;
pub(crate) mod words;

pub use action::{Action, Actions};
pub use groundwork::Groundwork;
pub use model::Model;
pub use stats::{Processor, Stats};

use crate::platform::{self, Event, Laboratory, Mailbox, Preparer};
use crate::render::TextureStyle;
use crate::session::Session;
use address_options::AddressOptions;
use announced::Announced;
use cells::Cells;
use editing::{EditAction, Editor};
use explore::Explore;
use exporting::Exporter;
use foot::Foot;
use gpu::Gpu;
use handles::HandleState;
use image::RgbaImage;
use keeping::Keeper;
use keyboard::Keyboard;
use locks::{Control, Locks};
use offer::Offer;
use playing::Player;
use plots::Plots;
use preferences::Preferences;
use reports::{Report, Reports};
use status::FrameMeter;
use std::sync::{Arc, mpsc};
use surface::OrbitView;
use touches::Touches;
use view::View;

/// Below this width (in points) the controls become a sheet.
pub const PHONE_WIDTH: f32 = 700.0;

/// How long a notice is shown, in seconds: two words are read in one, once they have been seen.
const NOTICE_SECONDS: f64 = 3.0;

/// What those who hear the screen are told about: the map, whether it is there, messages, the tour; how; a notice.
type News = ((u64, bool, Vec<String>, Option<usize>), Preferences, Option<u64>);

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
    cells: Cells,
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
    /// What is wrong and belongs to neither side: an image, a file that was to be saved, a link, what is locked.
    message: Option<String>,
    /// What is there to read below the pictures.
    foot: Foot,
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
        keeper.open_link(missing, platform::link());
        let (mut reports, laboratory) = (Reports::default(), Laboratory::new(mailbox.clone()));
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
            cells: Cells::default(),
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
            foot: Foot::default(),
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
            self.keeper.begin_anew();
        } else {
            self.keeper.touch();
        }
        self.show_session(session);
    }

    fn texture_style(&self, dark: bool) -> Option<TextureStyle> {
        textured::style(&self.model, self.image_name.is_some(), dark)
    }
}

impl eframe::App for RiemapApp {
    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
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
mod colour_vision_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod fitting_tests;
#[cfg(test)]
mod language_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod locks_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
