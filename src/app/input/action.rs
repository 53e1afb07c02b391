//! The requests that panels, gestures and keys emit: session commands, and actions that concern only the screen.

use crate::app::input::preferences::{Habit, Preferences};
use crate::conformal::Side;
use crate::export::ProjectionFormat;
use crate::figures::LadderShape;
use crate::geometry::DVec2;
use crate::model::best::BestAction;
use crate::model::editing::{Change, Hold, Pen};
use crate::model::motion::PlayAction;
use crate::model::overlays::invariants::InvariantsAction;
use crate::model::overlays::orthogonal_grid::GridAction;
use crate::model::overlays::walks::WalkAction;
use crate::session::{Command, Touched};

/// A request of the user. All requests go through one queue and are carried out in one place.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// A change of the session.
    Session(Command),
    /// Undo.
    Undo,
    /// Redo.
    Redo,
    /// Start over with the default session.
    New,
    /// Open the kept session of this visit.
    OpenKept(String),
    /// Show the dialog that opens a session file.
    OpenSession,
    /// Save the session as a file.
    SaveSession,
    /// Copy the session's URL to the clipboard.
    CopyLink,
    /// An action of the window that shares the link.
    Share(ShareAction),
    /// Show the dialog that opens an outline file for this side.
    OpenOutline(Side),
    /// Take the shape or the feature of this number of the file from which a side's outline was read.
    OpenPart(Side, usize),
    /// Show the dialog that opens an image whose outline is traced for this side.
    OpenTrace(Side),
    /// Trace the outline of the image that was opened last.
    TraceImage,
    /// Make the image that was opened as an outline the texture.
    UseImage,
    /// Show or hide the texture coordinates over the outline of a surface's layout.
    ShowUv(bool),
    /// Decline the offer to trace the image.
    DismissOffer,
    /// Show the dialog that opens a texture image.
    OpenImage,
    /// Fit a side's whole outline into its view.
    Fit(Side),
    /// Draw or reshape an outline by hand.
    Edit(EditAction),
    /// Read a pasted text as an outline: for the side of the paste window if it is open, else for the source.
    PasteText(String),
    /// Apply the quick fix that the message about a side offers.
    QuickFix(Side),
    /// Close the messages about a side.
    Dismiss(Side),
    /// Show a window of measurements, and start measuring.
    OpenReport(Report),
    /// Show another outline or horizontal axis in the plot of accuracy, and measure what is not measured yet.
    ShowLadder(LadderShown),
    /// Close the report window and drop its remaining measurements.
    CloseReport,
    /// Close the message that belongs to neither side.
    DismissMessage,
    /// Change which invariants are computed.
    Invariants(InvariantsAction),
    /// Show, change or save an orthogonal grid.
    Grid(GridAction),
    /// An action of the window of map projections.
    Projection(ProjectionAction),
    /// An action of the export window.
    Export(ExportAction),
    /// Start or stop the motion of the points, or change its path or period.
    Play(PlayAction),
    /// Choose a criterion, search for the best map, paint its region, show the landscape.
    Best(BestAction),
    /// Start, pause or clear the random walks, or change their speed.
    Walks(WalkAction),
    /// Open the gallery, the figures or the list of shortcuts; start, advance or leave the tour.
    Explore(ExploreAction),
    /// An action of the panel in which a lesson is made.
    Lesson(LessonAction),
    /// Apply these preferences and store them for the next start.
    Prefer(Preferences),
    /// Store what the user has seen or unfolded.
    Recall(Habit),
    /// Hide or show all panels and bars.
    TogglePanels,
    /// Hide or show the column of controls.
    ToggleColumn,
    /// Open or close the phone's sheet of controls and plots.
    OpenSheet(bool),
    /// An action of the plots' switches.
    Plots(PlotsAction),
    /// Enter or leave full screen.
    ToggleFullScreen,
    /// Switch between the usual zoom and 1.5 times that zoom.
    TogglePresentation,
}

impl Action {
    /// The parts of the session that the action changes, or that the commands change in which it ends.
    pub fn leads_to(&self) -> Touched {
        match self {
            Self::Session(command) => command.touches(),
            Self::Edit(action) => action.leads_to(),
            Self::New
            | Self::OpenKept(_)
            | Self::OpenSession
            | Self::Explore(
                ExploreAction::Gallery
                | ExploreAction::Figures
                | ExploreAction::Tour(_)
                | ExploreAction::Step(_)
                | ExploreAction::Again,
            )
            | Self::Lesson(LessonAction::Show(_) | LessonAction::Play) => Touched::EVERYTHING,
            Self::OpenOutline(_) | Self::OpenPart(..) | Self::OpenTrace(_) | Self::TraceImage | Self::PasteText(_) => {
                Touched::ANOTHER_SHAPE
            }
            Self::OpenImage | Self::UseImage => Touched::PATTERN,
            Self::Play(_) => Touched::POINTS,
            Self::Best(action) => action.leads_to(),
            Self::Undo
            | Self::Redo
            | Self::SaveSession
            | Self::CopyLink
            | Self::Share(_)
            | Self::ShowUv(_)
            | Self::DismissOffer
            | Self::Fit(_)
            | Self::QuickFix(_)
            | Self::Dismiss(_)
            | Self::OpenReport(_)
            | Self::ShowLadder(_)
            | Self::CloseReport
            | Self::DismissMessage
            | Self::Export(_)
            | Self::Walks(_)
            | Self::Invariants(_)
            | Self::Grid(_)
            | Self::Projection(_)
            | Self::Explore(
                ExploreAction::Shortcuts
                | ExploreAction::Close
                | ExploreAction::CardPlots(_)
                | ExploreAction::LeaveTour { .. },
            )
            | Self::Lesson(_)
            | Self::Prefer(_)
            | Self::Recall(_)
            | Self::TogglePanels
            | Self::ToggleColumn
            | Self::OpenSheet(_)
            | Self::Plots(_)
            | Self::ToggleFullScreen
            | Self::TogglePresentation => Touched::NOTHING,
        }
    }
}

/// The requests of a frame, in the order in which they were made.
pub type Actions = Vec<Action>;

/// A step of drawing, reshaping or pasting an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EditAction {
    /// Start reshaping the outline of a side; stop if it is being reshaped.
    Toggle(Side),
    /// Start drawing a new outline for a side.
    Draw(Side, Pen),
    /// Append a point: a sample of the stroke, or a click.
    Point(DVec2),
    /// Remove the last point.
    TakeBack,
    /// Remove all points: the stroke was canceled.
    Clear,
    /// Close the drawn outline and use it.
    Close,
    /// Stop editing.
    Leave,
    /// Start dragging a handle, with the pointer or the arrow keys.
    Grab(usize, Hold),
    /// Move the dragged handle to this point of the plane.
    Drag(DVec2),
    /// Stop dragging the handle.
    Release,
    /// Select this handle, or none.
    Select(Option<usize>),
    /// Apply a change that is not a drag: insert or remove a handle, smooth, mirror.
    Change(Change),
    /// Close the message about the edited outline.
    Dismiss,
    /// Open the paste window for a side.
    OpenPaste(Side),
    /// Use the text in the paste window as the outline.
    TakePasted,
    /// Close the paste window.
    ClosePaste,
}

impl EditAction {
    /// The parts of the session that the commands touch in which the action ends: another outline, or another form of
    /// the present one, which carries its points along. Mirroring moves the points.
    pub fn leads_to(self) -> Touched {
        match self {
            Self::Draw(..) | Self::Close | Self::OpenPaste(_) | Self::TakePasted => Touched::ANOTHER_SHAPE,
            Self::Change(Change::Mirror) => Touched::SHAPES | Touched::POINTS,
            _ => Touched::SHAPES,
        }
    }
}

/// The actions of the gallery, the figures, the list of shortcuts and the tour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExploreAction {
    /// Open the gallery.
    Gallery,
    /// Open the list of the paper's figures.
    Figures,
    /// Open the list of keys and gestures.
    Shortcuts,
    /// Close the window of the gallery, the figures or the shortcuts.
    Close,
    /// Go to this step of the guided tour, counted from 0; starts the tour if it is not running.
    Tour(usize),
    /// Go to this step of the tour or the lesson in progress.
    Step(usize),
    /// Show the step in progress once more, with its motions.
    Again,
    /// Show the plots on the card in place of the words, or the words again.
    CardPlots(bool),
    /// End the tour or the lesson.
    LeaveTour {
        /// Whether the session of the last step stays; otherwise the session from before the tour is restored.
        keeps: bool,
    },
}

/// The actions of the panel in which a lesson is made. Steps are counted from 0; one that does not exist changes nothing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LessonAction {
    /// Show the panel.
    Open,
    /// Hide it; the draft stays.
    Close,
    /// Set the title.
    Title(String),
    /// Set the caption of a step.
    Caption(usize, String),
    /// Append the present picture as a step.
    Add,
    /// Put the present picture in place of a step's.
    Renew(usize),
    /// Show the picture of a step.
    Show(usize),
    /// Exchange a step and the next one.
    Swap(usize),
    /// Delete a step.
    Delete(usize),
    /// Take the last change of the draft back.
    Undo,
    /// Make the change again that was taken back last.
    Redo,
    /// Play the draft.
    Play,
    /// Save the draft as a file.
    Save,
    /// Copy the link that plays the draft.
    CopyLink,
    /// Show the dialog that opens a lesson's file in place of the draft.
    OpenFile,
}

impl LessonAction {
    /// Whether the action takes or replaces the session, which then must be at rest.
    pub fn concerns_session(&self) -> bool {
        matches!(self, Self::Add | Self::Renew(_) | Self::Show(_) | Self::Play)
    }
}

/// The kinds of plots.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum PlotKind {
    /// The Poisson kernels of both sides.
    #[default]
    Kernel,
    /// The harmonic measures of both sides.
    Measure,
    /// The boundary reparameterisation.
    Reparameterization,
}

/// The actions of the plots' switches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlotsAction {
    /// Select the plot that is shown where there is room for one.
    Show(PlotKind),
    /// Switch the kernel's y axis between logarithmic and linear.
    ToggleLogarithm,
}

/// The actions of the export window.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExportAction {
    /// Show the window.
    Open,
    /// Save the chosen file, or start rendering it.
    Save,
    /// Cancel the export under way.
    Cancel,
    /// Close the message in the window.
    DismissError,
    /// Cancel the export under way and close the window.
    Close,
}

/// The actions of the window of map projections.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProjectionAction {
    /// Show the window.
    Open,
    /// Show the dialog that opens a region's file.
    OpenFile,
    /// Map the island by formula.
    Island,
    /// Map the file that was opened as an outline.
    Offered,
    /// Save the map.
    Save(ProjectionFormat),
    /// Show the feature of this number of the region's file, or all.
    Feature(Option<usize>),
    /// Show the region of the file after repairs.
    Repair,
    /// Cancel the computation.
    Cancel,
    /// Cancel the computation and close the window.
    Close,
}

/// The actions of the window that shares the link.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShareAction {
    /// Show the window.
    Open,
    /// Pass the link to the system's dialog.
    Send,
    /// Close the window.
    Close,
}

/// The kinds of report windows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Report {
    /// Tables 1 and 2.
    Bench,
    /// The accuracy of all methods, and Figure 15.
    Convergence,
}

/// What the plot of accuracy shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LadderShown {
    /// The outline.
    pub shape: LadderShape,
    /// What errors are plotted against.
    pub axis: LadderAxis,
}

impl Default for LadderShown {
    fn default() -> Self {
        Self { shape: LadderShape::VShape, axis: LadderAxis::Unknowns }
    }
}

/// The horizontal axis of the plot of accuracy.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LadderAxis {
    /// Unknowns of the linear system.
    Unknowns,
    /// Points on the boundary.
    Points,
    /// The time for an outline and a point.
    Milliseconds,
}
