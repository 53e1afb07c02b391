//! What the platform asks of the app that it starts: how it begins, what it says when nothing can be drawn, and what
//! the page around it may read and set.

use super::Mailbox;
use crate::model::files::FilePurpose;
use crate::session::Session;

/// Why nothing is drawn, or not any more. Put into words by [`Host::failure_words`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Failure {
    /// There is no page to draw in.
    NoPage,
    /// The page has no canvas.
    NoCanvas,
    /// The browser offers neither WebGPU nor WebGL 2; with what it says of that.
    NoGraphics(String),
    /// The graphics device was lost.
    GraphicsLost,
    /// The app panicked; with where and why.
    Stopped(String),
    /// The desktop's window could not be opened, and why.
    NoWindow(String),
}

/// An app that the platform can start.
pub trait Host: eframe::App + Sized + 'static {
    /// What is made before there is a screen: it runs while the graphics start.
    type Startup: 'static;
    /// The record that `riemap.stats()` gives.
    type Stats: serde::Serialize;

    /// Begins what needs no screen.
    fn startup() -> Self::Startup;

    /// Where events for the app are posted.
    fn mailbox(startup: &Self::Startup) -> Mailbox;

    /// The app on a screen.
    fn open(
        creation: &eframe::CreationContext<'_>,
        startup: Self::Startup,
    ) -> Result<Self, Box<dyn std::error::Error + Send + Sync>>;

    /// Whether WebGPU is to be left out.
    fn avoids_webgpu() -> bool;

    /// A failure in the language of the screen.
    fn failure_words(failure: &Failure) -> String;

    /// Takes in a file between two frames.
    fn take_file(&mut self, purpose: FilePurpose, name: &str, bytes: Result<Vec<u8>, String>);

    /// The numbers on the screen.
    fn stats(&self) -> Self::Stats;

    /// The session that is shown.
    fn session(&self) -> &Session;

    /// The fragment of an address that opens this session; `None` where none carries all of it.
    fn link(&self) -> Option<String>;

    /// Shows another session.
    fn open_session(&mut self, session: Session);

    /// Opens a link or its fragment. Errors: why it is refused, in words.
    fn open_link(&mut self, link: &str) -> Result<(), String>;
}
