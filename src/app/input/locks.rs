//! Controls that the page's URL locks: `?lock=outline,view`.
//!
//! The user cannot change a locked control: its actions are refused where all actions are carried out
//! ([`Locks::refused`]), dots and pictures do not follow the pointer, and its widgets are grayed with the
//! reason as tooltip. Locks do not apply to the page that embeds the app.

use crate::app::input::action::Action;
use crate::app::input::handles::HandleKind;
use crate::language::{Label, key, tr};
use crate::session::Touched;
use egui::{Button, Context, Id, Sense, Ui};

/// The controls that can be locked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// The interior points.
    Interior,
    /// The boundary points.
    Boundary,
    /// The choice and the shape of outlines and surfaces.
    Outline,
    /// Panning, zooming and orbiting the pictures.
    View,
    /// The texture: its kind, scale, side and image.
    Pattern,
    /// The coloring of the triangles, and the wireframe.
    Colours,
    /// Direction, extension, kernel, solver, sampling and meshing.
    Method,
    /// Opening and closing the plots.
    Plots,
    /// Comparisons through the disk, random walks and measurements.
    Comparison,
    /// Starting over and opening another session.
    Session,
    /// Theme and language.
    Theme,
    /// Hiding and showing the panels.
    Panels,
}

impl Control {
    /// All variants, in the order of the documentation.
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

    /// The name in the URL.
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

    /// Whether it is part of the session, so that opening another session would change it.
    fn is_part_of_session(self) -> bool {
        !matches!(self, Self::View | Self::Theme | Self::Panels)
    }

    /// The control that an action on the screen belongs to, one that does not change the session; `None` if no lock
    /// applies.
    fn of_screen(action: &Action) -> Option<Self> {
        match action {
            Action::Fit(_) => Some(Self::View),
            Action::OpenReport(_) | Action::Walks(_) | Action::Invariants(_) | Action::Grid(_) => {
                Some(Self::Comparison)
            }
            Action::Prefer(_) => Some(Self::Theme),
            Action::TogglePanels | Action::ToggleColumn => Some(Self::Panels),
            _ => None,
        }
    }

    /// The controls whose locks refuse a change of these parts of the session; a refusal names the first locked one.
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
    /// Parses a list such as `outline,view`; also returns the unknown names.
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

    /// This set with one more control.
    #[must_use]
    pub fn with(self, control: Control) -> Self {
        Self(self.0 | 1 << control as u16)
    }

    /// The union of both sets.
    #[must_use]
    pub fn and(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Whether `control` is locked. [`Control::Session`] is locked as soon as any part of the session is.
    pub fn holds(self, control: Control) -> bool {
        let named = |control: Control| self.0 & 1 << control as u16 != 0;
        let implied = || {
            control == Control::Session && Control::ALL.into_iter().any(|part| part.is_part_of_session() && named(part))
        };
        named(control) || implied()
    }

    /// The first lock that refuses `action`; `None` if it may be carried out.
    pub fn refused(self, action: &Action) -> Option<Control> {
        Control::of_touched(action.leads_to()).chain(Control::of_screen(action)).find(|&control| self.holds(control))
    }

    /// The first locked control among those that change these parts of the session.
    pub fn keeps(self, touched: Touched) -> Option<Control> {
        Control::of_touched(touched).find(|&control| self.holds(control))
    }

    /// Whether the dots of this kind are locked.
    pub fn holds_handle(self, kind: HandleKind) -> bool {
        let moved = match kind {
            HandleKind::Interior => Touched::INTERIOR,
            HandleKind::Boundary => Touched::BOUNDARY,
            HandleKind::Pin(_) => Touched::POINTS, // the interior points follow
            HandleKind::Mark(_) => Touched::COMPARISON,
        };
        self.keeps(moved).is_some()
    }

    /// Stores the locks in `context`, where [`Self::of`] finds them.
    pub fn install(self, context: &Context) {
        context.data_mut(|data| data.insert_temp(id(), self.0));
    }

    /// The locks stored in `context`; none if none were stored.
    pub fn of(context: &Context) -> Self {
        Self(context.data(|data| data.get_temp(id())).unwrap_or_default())
    }
}

fn id() -> Id {
    Id::unique("locked controls")
}

/// The tooltip of a locked control.
pub const REFUSAL: Label = key::locked();

/// Shows widgets, disabled and with the reason as tooltip while `control` is locked.
pub fn guarded<R>(ui: &mut Ui, control: Control, show: impl FnOnce(&mut Ui) -> R) -> R {
    let locked = Locks::of(ui.ctx()).holds(control);
    shown(ui, locked, show)
}

/// As [`guarded`], for widgets that are disabled while a part of the session that they change is locked.
pub fn guarded_by<R>(ui: &mut Ui, touched: Touched, show: impl FnOnce(&mut Ui) -> R) -> R {
    let locked = Locks::of(ui.ctx()).keeps(touched).is_some();
    shown(ui, locked, show)
}

fn shown<R>(ui: &mut Ui, locked: bool, show: impl FnOnce(&mut Ui) -> R) -> R {
    let shown = ui.add_enabled_ui(!locked, show);
    if locked {
        let id = shown.response.id.with("why it is locked");
        ui.interact(shown.response.rect, id, Sense::hover()).on_hover_text(tr(REFUSAL));
    }
    shown.inner
}

/// Shows a menu entry, disabled and with the reason as tooltip while `action` is refused; returns whether it was
/// clicked.
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
    use crate::app::input::action::EditAction;
    use crate::conformal::Side;
    use crate::model::editing::Change;
    use crate::session::{Command, SurfaceSpec, TextureKind};

    #[test]
    fn names_are_parsed_and_unknown_ones_are_reported() {
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
