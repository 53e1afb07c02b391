//! The interface of the app that the platform starts: its start, its failure messages, and what
//! the page around it may read and set.

use super::Mailbox;
use crate::model::files::FilePurpose;
use crate::session::Session;

/// Why nothing can be drawn. [`Host::failure_words`] gives the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Failure {
    /// There is no page to draw in.
    NoPage,
    /// The page has no canvas.
    NoCanvas,
    /// The browser offers neither WebGPU nor WebGL 2; with the browser's reason.
    NoGraphics(String),
    /// The graphics device was lost.
    GraphicsLost,
    /// The app panicked; with the place and the message.
    Stopped(String),
    /// The window could not be opened; with the reason.
    NoWindow(String),
}

/// An app that the platform can start.
pub trait Host: eframe::App + Sized + 'static {
    /// State created before there is a screen, while the graphics start.
    type Startup: 'static;
    /// The record returned by `riemap.stats()`.
    type Stats: serde::Serialize;

    /// Begins the work that needs no screen.
    fn startup() -> Self::Startup;

    /// The mailbox for the app's events.
    fn mailbox(startup: &Self::Startup) -> Mailbox;

    /// Creates the app once the graphics are ready.
    fn open(
        creation: &eframe::CreationContext<'_>,
        startup: Self::Startup,
    ) -> Result<Self, Box<dyn std::error::Error + Send + Sync>>;

    /// Continues on another graphics device after the former one was lost.
    fn reopen(&mut self, creation: &eframe::CreationContext<'_>);

    /// Whether WebGPU is not to be used.
    fn avoids_webgpu() -> bool;

    /// The text of a failure, in the app's language.
    fn failure_words(failure: &Failure) -> String;

    /// Loads a file, between two frames.
    fn take_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>);

    /// The numbers shown in the status line and panels.
    fn stats(&self) -> Self::Stats;

    /// The current session.
    fn session(&self) -> &Session;

    /// The fragment of a link to this session; `None` if no link holds all of it.
    fn link(&self) -> Option<String>;

    /// Replaces the session.
    fn open_session(&mut self, session: Session);

    /// Opens a link or its fragment. Errors: the reason of the rejection, as text.
    fn open_link(&mut self, link: &str) -> Result<(), String>;
}
