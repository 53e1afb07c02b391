//! What the panels ask for: commands to the session, and what concerns the screen alone.

use crate::app::input::preferences::Preferences;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::model::editing::{Change, Hold, Pen};
use crate::model::motion::PlayAction;
use crate::model::overlays::walks::WalkAction;
use crate::session::Command;

/// A request of the person at the screen. All of them go through one queue and are carried out in one place.
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
    /// Do what the message about a side offers.
    QuickFix(Side),
    /// Close the messages about a side.
    Dismiss(Side),
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

/// A step of a person who edits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EditAction {
    /// Reshape the outline of a side; once more: no more.
    Toggle(Side),
    /// Draw another one for a side.
    Draw(Side, Pen),
    /// The stroke goes on, or a point was clicked.
    Point(DVec2),
    /// Take the last point back.
    TakeBack,
    /// The stroke came to nothing.
    Clear,
    /// Close what is drawn.
    Close,
    /// No more.
    Leave,
    /// Take a handle in hand.
    Grab(usize, Hold),
    /// Move it.
    Drag(DVec2),
    /// Let it go.
    Release,
    /// Mean this handle, or none.
    Select(Option<usize>),
    /// Make a change at once.
    Change(Change),
    /// The message has been read.
    Dismiss,
    /// Open the window for pasted text, for a side.
    OpenPaste(Side),
    /// Take what is written in it.
    TakePasted,
    /// Close it.
    ClosePaste,
}

/// What the menu opens.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExploreAction {
    /// The gallery.
    Gallery,
    /// The paper's figures.
    Figures,
    /// The list of keys and gestures.
    Shortcuts,
    /// The tour, or its step of this number.
    Tour(usize),
    /// Ends the tour with the picture that is shown, or with the one from before.
    LeaveTour {
        /// The one that is shown.
        keeps: bool,
    },
}

/// What a window is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Report {
    /// Tables 1 and 2.
    Bench,
    /// Figure 15.
    Convergence,
}
