//! Controls that the page's address keeps as they are: `?lock=outline,view`.
//!
//! A locked control is inert for the person at the screen: its actions are refused where all actions
//! are carried out ([`Locks::refused`]), dots and pictures do not follow the pointer, and what is on
//! the screen is grey and says why. The page around a frame is not bound by them.

use crate::app::input::action::{Action, EditAction, ExploreAction};
use crate::app::input::handles::HandleKind;
use crate::language::{Label, key, tr};
use crate::model::editing::Change;
use crate::session::Touched;
use egui::{Button, Context, Id, Sense, Ui};

/// What can be locked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// The interior points.
    Interior,
    /// The boundary points.
    Boundary,
    /// Outlines and surfaces.
    Outline,
    /// Moving, zooming and turning the pictures.
    View,
    /// The texture, its scale, side and image.
    Pattern,
    /// What the meshes are painted with, and their edges.
    Colours,
    /// Direction, extension, kernel, solver, sampling and meshing.
    Method,
    /// Opening and closing the plots.
    Plots,
    /// Comparisons, random walks and measurements.
    Comparison,
    /// Beginning anew, and opening another session.
    Session,
    /// Theme and language.
    Theme,
    /// Folding the panels.
    Panels,
}

impl Control {
    /// All of them, in the order in which they are documented.
    pub const ALL: [Self; 12] = [
        Self::Interior,
        Self::Boundary,
        Self::Outline,
        Self::View,
        Self::Pattern,
        Self::Colours,
        Self::Method,
        Self::Plots,
        Self::Comparison,
        Self::Session,
        Self::Theme,
        Self::Panels,
    ];

    /// What another outline or surface changes: it has two points of its own.
    pub const OF_SHAPES: &[Self] = &[Self::Outline, Self::Interior, Self::Boundary];

    /// Its name in the address.
    pub fn name(self) -> &'static str {
        match self {
            Self::Interior => "interior",
            Self::Boundary => "boundary",
            Self::Outline => "outline",
            Self::View => "view",
            Self::Pattern => "pattern",
            Self::Colours => "colours",
            Self::Method => "method",
            Self::Plots => "plots",
            Self::Comparison => "comparison",
            Self::Session => "session",
            Self::Theme => "theme",
            Self::Panels => "panels",
        }
    }

    /// Whether it is a part of the session, which another session would change too.
    fn is_part_of_session(self) -> bool {
        !matches!(self, Self::View | Self::Theme | Self::Panels)
    }

    /// What an action besides a command belongs to; `None`: nothing that can be locked.
    fn of(action: &Action) -> Option<Self> {
        Some(match action {
            Action::New
            | Action::OpenSession
            | Action::Explore(ExploreAction::Gallery | ExploreAction::Figures | ExploreAction::Tour(_)) => {
                Self::Session
            }
            Action::OpenOutline(_)
            | Action::OpenTrace(_)
            | Action::TraceImage
            | Action::Edit(_)
            | Action::PasteText(_) => Self::Outline,
            Action::Play(_) => Self::Interior,
            Action::OpenImage => Self::Pattern,
            Action::Fit(_) => Self::View,
            Action::OpenReport(_) | Action::Walks(_) => Self::Comparison,
            Action::Prefer(_) => Self::Theme,
            Action::TogglePanels => Self::Panels,
            Action::Session(_)
            | Action::Undo
            | Action::Redo
            | Action::SaveSession
            | Action::CopyLink
            | Action::Dismiss(_)
            | Action::QuickFix(_)
            | Action::DismissMessage
            | Action::DismissOffer
            | Action::OpenExport
            | Action::SaveExport
            | Action::CancelExport
            | Action::Explore(ExploreAction::Shortcuts | ExploreAction::LeaveTour { .. })
            | Action::ToggleFullScreen
            | Action::TogglePresentation => return None,
        })
    }

    /// What keeps a change of these parts of the session, in the order in which a refusal names it.
    pub fn of_touched(touched: Touched) -> impl Iterator<Item = Self> {
        let is_another_session = touched == Touched::EVERYTHING;
        let parts = [
            (Self::Outline, Touched::SHAPES),
            (Self::Interior, Touched::INTERIOR),
            (Self::Boundary, Touched::BOUNDARY),
            (Self::Method, Touched::SETTINGS),
            (Self::Pattern, Touched::PATTERN),
            (Self::Colours, Touched::COLOURS),
            (Self::Plots, Touched::PLOTS),
            (Self::Comparison, Touched::COMPARISON),
        ];
        let parts = parts.into_iter().filter(move |(_, part)| !is_another_session && touched.touches(*part));
        is_another_session.then_some(Self::Session).into_iter().chain(parts.map(|(control, _)| control))
    }
}

/// A set of locked controls.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Locks(u16);

impl Locks {
    /// Reads `outline,view`; the names that are none come back too.
    pub fn parse(list: &str) -> (Self, Vec<&str>) {
        let (mut locks, mut unknown) = (Self::default(), Vec::new());
        for name in list.split(',').map(str::trim).filter(|name| !name.is_empty()) {
            match Control::ALL.into_iter().find(|control| control.name() == name) {
                Some(control) => locks = locks.with(control),
                None => unknown.push(name),
            }
        }
        (locks, unknown)
    }

    /// These and one more.
    #[must_use]
    pub fn with(self, control: Control) -> Self {
        Self(self.0 | 1 << control as u16)
    }

    /// These and those.
    #[must_use]
    pub fn and(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Whether `control` is locked. Another session is refused as soon as a part of this one is kept.
    pub fn holds(self, control: Control) -> bool {
        let named = |control: Control| self.0 & 1 << control as u16 != 0;
        let implied = || {
            control == Control::Session && Control::ALL.into_iter().any(|part| part.is_part_of_session() && named(part))
        };
        named(control) || implied()
    }

    /// The lock that keeps `action` from being carried out.
    pub fn refused(self, action: &Action) -> Option<Control> {
        if let Action::Session(command) = action {
            return Control::of_touched(command.touches()).find(|&control| self.holds(control));
        }
        let also: &[Control] = match action {
            Action::Play(_) => &[Control::Boundary],
            Action::OpenOutline(_)
            | Action::OpenTrace(_)
            | Action::TraceImage
            | Action::PasteText(_)
            | Action::Edit(
                EditAction::Draw(..)
                | EditAction::Close
                | EditAction::OpenPaste(_)
                | EditAction::TakePasted
                | EditAction::Change(Change::Mirror),
            ) => Control::OF_SHAPES,
            _ => &[],
        };
        if let Some(&held) = also.iter().find(|&&control| self.holds(control)) {
            return Some(held);
        }
        Control::of(action).filter(|&control| self.holds(control))
    }

    /// Keeps the dots of this kind where they are.
    pub fn holds_handle(self, kind: HandleKind) -> bool {
        self.holds(match kind {
            HandleKind::Interior => Control::Interior,
            HandleKind::Boundary => Control::Boundary,
        })
    }

    /// Makes them known to everything that is shown in `context`.
    pub fn install(self, context: &Context) {
        context.data_mut(|data| data.insert_temp(id(), self.0));
    }

    /// The ones of `context`.
    pub fn of(context: &Context) -> Self {
        Self(context.data(|data| data.get_temp(id())).unwrap_or_default())
    }
}

fn id() -> Id {
    Id::unique("locked controls")
}

/// What is said about a locked control.
pub const REFUSAL: Label = key::locked();

/// Shows controls, grey and with the reason while they are locked.
pub fn guarded<R>(ui: &mut Ui, control: Control, show: impl FnOnce(&mut Ui) -> R) -> R {
    guarded_by(ui, &[control], show)
}

/// Shows controls that any of these locks.
pub fn guarded_by<R>(ui: &mut Ui, controls: &[Control], show: impl FnOnce(&mut Ui) -> R) -> R {
    let locks = Locks::of(ui.ctx());
    let locked = controls.iter().any(|&control| locks.holds(control));
    let shown = ui.add_enabled_ui(!locked, show);
    if locked {
        let id = shown.response.id.with("why it is locked");
        ui.interact(shown.response.rect, id, Sense::hover()).on_hover_text(tr(REFUSAL));
    }
    shown.inner
}

/// An entry of a menu, grey and with the reason while what it does is locked; whether it was clicked.
pub fn menu_entry(ui: &mut Ui, enabled: bool, button: Button<'_>, tooltip: Label, action: &Action) -> bool {
    let locked = Locks::of(ui.ctx()).refused(action).is_some();
    let response = ui.add_enabled(enabled && !locked, button).on_hover_text(tr(tooltip));
    if locked {
        return response.on_disabled_hover_text(tr(REFUSAL)).clicked();
    }
    response.clicked()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformal::Side;
    use crate::model::editing::Change;
    use crate::session::{Command, SurfaceSpec, TextureKind};

    #[test]
    fn names_are_read_and_what_is_none_is_reported() {
        let (locks, unknown) = Locks::parse("outline, view,,colour");
        assert!(locks.holds(Control::Outline) && locks.holds(Control::View) && !locks.holds(Control::Colours));
        assert_eq!(unknown, ["colour"]);
        for control in Control::ALL {
            assert_eq!(Locks::parse(control.name()), (Locks::default().with(control), Vec::new()));
        }
    }

    #[test]
    fn a_locked_pattern_stays_while_dots_move() {
        let locks = Locks::default().with(Control::Pattern);
        let texture = Action::Session(Command::SetTexture(TextureKind::Grid));
        let moved = Action::Session(Command::MoveAnchor { side: Side::Source, fraction: 0.5 });
        assert_eq!(locks.refused(&texture), Some(Control::Pattern));
        assert_eq!(locks.refused(&moved), None);
        assert_eq!(Locks::default().refused(&texture), None);
    }

    #[test]
    fn a_whole_session_cannot_get_around_a_lock() {
        let open = Action::Session(Command::Open(Box::default()));
        for control in Control::ALL {
            let locks = Locks::default().with(control);
            let expected = !matches!(control, Control::View | Control::Theme | Control::Panels);
            assert_eq!(locks.refused(&open).is_some(), expected, "{control:?}");
            assert_eq!(locks.refused(&Action::New).is_some(), expected, "{control:?}");
        }
    }

    #[test]
    fn no_new_outline_brings_points_of_its_own_where_points_are_locked() {
        use crate::model::editing::Pen;
        for control in [Control::Interior, Control::Boundary] {
            let locks = Locks::default().with(control);
            for action in [
                Action::OpenOutline(Side::Source),
                Action::PasteText(String::from("M 0 0")),
                Action::Edit(EditAction::Draw(Side::Target, Pen::Lines)),
                Action::TraceImage,
                Action::Session(Command::CloseSurface(Side::Target)),
                Action::Session(Command::SetSurface { side: Side::Target, surface: SurfaceSpec::default() }),
                Action::Edit(EditAction::Change(Change::Mirror)),
            ] {
                assert_eq!(locks.refused(&action), Some(control), "{action:?}");
            }
            let reshaped = Action::Edit(EditAction::Change(Change::Smooth));
            assert_eq!(locks.refused(&reshaped), None, "its points stay");
        }
    }

    #[test]
    fn the_resolution_of_a_surface_belongs_to_the_method() {
        let refined = Action::Session(Command::RefineSurface { side: Side::Target, surface: SurfaceSpec::default() });
        for control in Control::ALL {
            let expected = (control == Control::Method).then_some(control);
            assert_eq!(Locks::default().with(control).refused(&refined), expected);
        }
    }

    #[test]
    fn a_locked_dot_cannot_be_held() {
        let locks = Locks::default().with(Control::Interior);
        assert!(locks.holds_handle(HandleKind::Interior) && !locks.holds_handle(HandleKind::Boundary));
    }
}
