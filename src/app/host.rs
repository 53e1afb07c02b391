//! The interface of the app for the platform that starts it and for the page around it.

use super::RiemapApp;
use crate::app::input::address_options::AddressOptions;
use crate::app::startup::Startup;
use crate::app::status::stats::Stats;
use crate::language::{key, say, tr};
use crate::model::files::FilePurpose;
use crate::platform::{self, Failure, Host, Mailbox};
use crate::session::Session;

/// Starts the app in a window or in the page's canvas, or, in a web worker, the engine that prepares sides.
///
/// Errors: there is no window, with a text for the user.
pub fn start() -> Result<(), String> {
    platform::start::<RiemapApp>()
}

/// The options in the page's address.
pub(super) fn address_options() -> AddressOptions {
    let pairs = platform::address_query();
    AddressOptions::parse(pairs.iter().map(|[name, value]| (name.as_str(), value.as_str())))
}

impl Host for RiemapApp {
    type Startup = Startup;
    type Stats = Stats;

    fn startup() -> Startup {
        Startup::resume()
    }

    fn mailbox(startup: &Startup) -> Mailbox {
        startup.mailbox()
    }

    fn open(
        creation: &eframe::CreationContext<'_>,
        startup: Startup,
    ) -> Result<Self, Box<dyn std::error::Error + Send + Sync>> {
        Self::new(creation, startup)
    }

    fn reopen(&mut self, creation: &eframe::CreationContext<'_>) {
        self.take_graphics(creation);
    }

    fn avoids_webgpu() -> bool {
        address_options().webgl
    }

    fn failure_words(failure: &Failure) -> String {
        match failure {
            Failure::NoPage => tr(key::no_page_to_draw_in()).into(),
            Failure::NoCanvas => tr(key::page_without_canvas()).into(),
            Failure::NoGraphics(cause) => format!("{} ({cause})", tr(key::no_graphics())),
            Failure::GraphicsLost => tr(key::graphics_lost()).into(),
            Failure::Stopped(cause) => say(&key::stopped(cause)),
            // in English, like all output on the terminal
            Failure::NoWindow(cause) => key::no_window(cause).english(),
        }
    }

    fn take_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>) {
        self.take_file(purpose, name, bytes);
    }

    fn stats(&self) -> Stats {
        self.stats()
    }

    fn session(&self) -> &Session {
        self.session()
    }

    fn link(&self) -> Option<String> {
        self.link()
    }

    fn open_session(&mut self, session: Session) {
        self.open_session(session);
    }

    fn open_link(&mut self, link: &str) -> Result<(), String> {
        self.try_link(link).map_err(|reason| reason.english())
    }
}
