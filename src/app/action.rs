//! What the panels ask for: commands to the session, and what concerns the screen alone.

use super::editing::EditAction;
use super::explore::ExploreAction;
use super::playing::PlayAction;
use super::preferences::Preferences;
use super::reports::Report;
use super::teaching::walks::WalkAction;
use crate::conformal::Side;
use crate::session::Command;
use crate::worker::Subject;

/// A wish of the person at the screen. All of them go through one queue and are carried out in one place.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// A change of the session.
    Session(Command),
    /// Take the last step back.
    Undo,
    /// Make it again.
    Redo,
    /// Begin with the first picture.
    New,
    /// Show the dialog for a session.
    OpenSession,
    /// Save the session as a file.
    SaveSession,
    /// Put the session's address into the clipboard.
    CopyLink,
    /// Show the dialog for an outline.
    OpenOutline(Side),
    /// Show the dialog for a picture to trace for this side.
    OpenTrace(Side),
    /// Trace the picture that has just become the texture.
    TraceImage,
    /// Leave it the texture.
    DismissOffer,
    /// Show the dialog for the texture image.
    OpenImage,
    /// Show all of a side's outline.
    Fit(Side),
    /// Draw or reshape an outline by hand.
    Edit(EditAction),
    /// Take a pasted text as the source's outline.
    PasteText(String),
    /// Do what the message about a subject offers.
    Remedy(Subject),
    /// Close the message about a subject.
    Dismiss(Subject),
    /// Show a window of measurements, and begin them.
    OpenReport(Report),
    /// Close the message about the image or a file.
    DismissMessage,
    /// Show the window of exports.
    OpenExport,
    /// Save what is chosen there, or begin to make it.
    SaveExport,
    /// Give up what is being made.
    CancelExport,
    /// Set the points in motion, or stop them.
    Play(PlayAction),
    /// Start, pause or clear the random walks, or change their speed.
    Walks(WalkAction),
    /// Open the gallery, the tour or the list of keys, or go on in the tour.
    Explore(ExploreAction),
    /// Look and speak like this, now and the next time.
    Prefer(Preferences),
    /// Fold the panels away, or bring them back.
    TogglePanels,
    /// The whole screen, or a window again.
    ToggleFullScreen,
    /// Everything half as large again, or not.
    TogglePresentation,
}

/// The queue.
pub type Actions = Vec<Action>;
