//! The app: panels, viewports, handles.
//!
//! A frame is the six lines of `RiemapApp::ui`: **input** lays out the panels and collects the user's requests as
//! [`Action`]s, **commands** carries them out in one place (`carry_out`), **events** handles what happened outside a
//! frame (workers, files; `incoming`), **update** brings the map up to date and uploads changes (`frame`), **paint**
//! paints the pictures (`pictures`), **announce** reports to the page and to a screen reader. The
//! actions of buttons in pictures and windows, which are laid out while painting, are carried out with those of the
//! next frame. The fields of a window (a pasted text, the settings of an export) and the cameras are changed in place.
//! If an update changes the panels' content, they are laid out again in a following frame. At rest nothing is computed
//! and nothing drawn.

mod accessibility;
mod announced;
mod arrangement;
mod carry_out;
mod editing;
mod facts;
mod frame;
mod host;
mod incoming;
pub mod input;
pub mod language;
mod layout;
mod lessons;
mod menus;
mod message_bar;
mod messages;
mod overlays;
mod panels;
mod pictures;
mod plots;
mod screen;
mod sessions;
mod startup;
mod status;
mod theme;
mod viewport;
mod visits;
mod window_work;
mod windows;
mod workers;

pub use host::start;
pub use input::action::{Action, Actions};
pub use startup::Startup;
pub use status::stats::Stats;

use crate::model::motion::Player;
use crate::model::persistence::Persistence;
use crate::model::{Changes, Model, pattern};
use crate::platform;
use crate::render::TextureStyle;
use crate::session::Session;
use announced::Announced;
use editing::Editor;
use input::Input;
use input::action::Report;
use input::address_options::AddressOptions;
use input::locks::{Control, Locks};
use input::presentation;
use messages::Messages;
use plots::Plots;
use screen::Screen;
use viewport::gpu::Gpu;
use viewport::pictures::Pictures;
use windows::Windows;
use windows::lesson::LessonEditor;
use workers::Workers;

/// The app.
pub struct RiemapApp {
    model: Model,
    workers: Workers,
    input: Input,
    pictures: Pictures,
    plots: Plots,
    editor: Editor,
    player: Player,
    windows: Windows,
    screen: Screen,
    messages: Messages,
    announced: Announced,
    persistence: Persistence,
    options: AddressOptions,
    /// When the map last changed, in seconds.
    last_change: f64,
}

impl RiemapApp {
    /// The app on a screen, continuing from `startup`.
    pub fn new(
        creation: &eframe::CreationContext<'_>,
        startup: Startup,
    ) -> Result<Self, Box<dyn std::error::Error + Send + Sync>> {
        theme::install(&creation.egui_ctx);
        let Startup { model, steps, picture, visits, resumes, missing, message, draft, preferences, workers } = startup;
        let options = host::address_options();
        let preferences = presentation::install(&creation.egui_ctx, preferences, &options);
        workers.mailbox.attach(&creation.egui_ctx);
        if let Some(state) = &creation.wgpu_render_state {
            platform::watch_graphics(&state.device, workers.mailbox.clone());
        }
        let mut persistence = if let Some(steps) = steps {
            Persistence::resume(steps, resumes)
        } else {
            let mut persistence = Persistence::new(model.session().clone(), resumes);
            persistence.open_link(missing, platform::link());
            persistence
        };
        persistence.visits = visits;
        let mut windows = Windows { lesson: LessonEditor::resume(draft.0, draft.1), ..Windows::default() };
        if options.bench {
            windows.reports.open(Report::Bench);
        }
        let mut app = Self {
            model,
            workers,
            input: Input::after(preferences.habits),
            pictures: Pictures { gpu: creation.wgpu_render_state.clone().map(Gpu::new), ..Pictures::default() },
            plots: Plots::default(),
            editor: Editor::default(),
            player: Player::default(),
            windows,
            screen: Screen::new(preferences, !options.embed, platform::has_fingers(), resumes),
            messages: Messages::of(presentation::with_user_errors(message, &options)),
            announced: Announced::default(),
            persistence,
            options,
            last_change: 0.0,
        };
        if let Some(picture) = picture {
            app.load_image(picture);
        }
        app.calm(&creation.egui_ctx);
        app.play_addressed();
        Ok(app)
    }

    /// Continues on the graphics device of `creation`, in place of one that was lost: everything on the screen is uploaded
    /// again; sides, map and undo steps are as they were. A picture that is being exported is abandoned, since its
    /// pixels were on the former device.
    fn take_graphics(&mut self, creation: &eframe::CreationContext<'_>) {
        let context = &creation.egui_ctx;
        theme::install(context);
        self.calm(context);
        self.options.locks.install(context);
        context.set_zoom_factor(self.screen.zoom);
        self.screen.preferences.apply(context);
        self.workers.mailbox.attach(context);
        if let Some(state) = &creation.wgpu_render_state {
            platform::watch_graphics(&state.device, self.workers.mailbox.clone());
        }
        self.windows.exporter.cancel();
        self.windows.explore.forget_thumbnails();
        self.input.handles.release();
        self.pictures.renew(creation.wgpu_render_state.clone().map(Gpu::new));
        self.show_changes(context, Changes { meshes: true, map: true, images: true });
    }

    /// Where the user wants no motion, nothing moves by itself: neither dots, sheets and surfaces nor the tour's points.
    fn calm(&mut self, context: &egui::Context) {
        self.windows.explore.is_calm = platform::wants_calm();
        if self.windows.explore.is_calm {
            theme::end_animations(context);
        }
    }

    /// The session that the map on the screen is computed from.
    pub fn session(&self) -> &Session {
        self.model.session()
    }

    /// Replaces the session; sides that both share are not prepared again. If sessions are locked, only
    /// the page around the app may do so: its session then becomes the first one of the history.
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
        pattern::style(&self.model, self.pictures.image.is_some(), dark)
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
        self.input.touches.take_in(&mut input.events);
        // egui would draw two frames as long as files stay in its input
        self.input.dropped.append(&mut input.dropped_files);
        let folds = self.input.keyboard.take_in(context, input);
        if folds % 2 == 1 && !Locks::of(context).holds(Control::Panels) {
            self.ask(context, vec![Action::TogglePanels]);
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
