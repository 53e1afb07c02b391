//! Gallery, list of figures, guided tour and list of shortcuts.

mod gallery;
mod shortcuts;
mod thumbnail;
mod tour;
mod window;

use crate::app::input::action::{Action, Actions, ExploreAction};
use crate::app::menus::figures_menu;
use crate::language::tr;
use crate::model::Model;
use crate::model::motion::Player;
use crate::session::Session;
use egui::{Context, Pos2, TextureHandle, Ui};
use tour::{Motions, Tour};
use window::{BESIDES, Window};

/// The open window, at most one, and the tour.
#[derive(Default)]
pub struct Explore {
    window: Option<Window>,
    /// The center of the window's close button.
    close: Option<Pos2>,
    tour: Option<Tour>,
    /// Whether the window or step that was just opened still has to get the keyboard focus.
    focus_due: bool,
    /// The gallery's thumbnails rendered so far, in its order; `None` where rendering failed.
    thumbnails: Vec<Option<TextureHandle>>,
}

/// What the app must change after an [`ExploreAction`]; `None` leaves a part unchanged.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Consequences {
    /// The session to open.
    pub session: Option<Session>,
    /// Whether the random walks are to run.
    pub walks: Option<bool>,
}

impl Explore {
    /// Carries out the action. `present` is the session on the screen, `is_walking` whether its random walks run; when
    /// the tour starts both are kept for its end. A step that does not exist changes nothing.
    pub fn act(&mut self, action: ExploreAction, present: &Session, is_walking: bool) -> Consequences {
        match action {
            ExploreAction::Gallery => self.open(Window::Gallery),
            ExploreAction::Figures => self.open(Window::Figures),
            ExploreAction::Shortcuts => self.open(Window::Shortcuts),
            ExploreAction::Close => self.window = None,
            ExploreAction::Tour(step) => return self.go_to(step, present, is_walking),
            ExploreAction::LeaveTour { keeps } => {
                let Some(Tour { before, walked, .. }) = self.tour.take() else { return Consequences::default() };
                return Consequences { session: (!keeps).then_some(before), walks: Some(walked) };
            }
        }
        Consequences::default()
    }

    fn open(&mut self, window: Window) {
        (self.window, self.focus_due) = (Some(window), true);
    }

    fn go_to(&mut self, step: usize, present: &Session, is_walking: bool) -> Consequences {
        let Some(stop) = tour::steps().get(step) else { return Consequences::default() };
        self.window = None;
        self.focus_due = true;
        let begun = self.tour.take().map(|tour| (tour.before, tour.walked));
        let (before, walked) = begun.unwrap_or_else(|| (present.clone(), is_walking));
        self.tour = Some(Tour { step, before, walked, motions: Motions::new(stop.motions) });
        Consequences { session: Some(stop.session.clone()), walks: Some(stop.walks) }
    }

    /// The step of the tour that is shown, counted from 0.
    pub fn step(&self) -> Option<usize> {
        self.tour.as_ref().map(|tour| tour.step)
    }

    /// Whether the tour is in progress.
    pub fn is_touring(&self) -> bool {
        self.tour.is_some()
    }

    /// Title and text of the tour's step.
    pub fn words(&self) -> Option<[&'static str; 2]> {
        let stop = tour::steps().get(self.step()?)?;
        Some([stop.title, stop.text].map(tr))
    }

    /// Begins and ends the motions of the tour's step; returns the seconds after which it wants to be asked again.
    pub fn conduct(&mut self, player: &mut Player, model: &Model, now: f64) -> Option<f64> {
        self.tour.as_mut()?.motions.conduct(player, model, now)
    }

    /// Ends the motions of the tour's step.
    pub fn end_motions(&mut self, player: &mut Player, model: &Model) {
        self.tour.iter_mut().for_each(|tour| tour.motions.end(player, model));
    }

    /// Whether the tour's step carries a circle with a cross along.
    pub fn probes(&self) -> bool {
        self.step().and_then(|step| tour::steps().get(step)).is_some_and(|stop| stop.probes)
    }

    /// Shows the card of the tour's step beside or below the pictures; if it `yields` to a message, it is hidden on a
    /// low screen. Escape ends the tour where no window is open. Returns whether the card took the keyboard focus that
    /// was due.
    pub fn show_tour(&self, ui: &mut Ui, yields: bool, actions: &mut Actions) -> bool {
        let Some(step) = self.step() else { return false };
        if self.window.is_none() && ui.input(|input| input.key_pressed(egui::Key::Escape)) {
            actions.push(Action::Explore(ExploreAction::LeaveTour { keeps: false }));
        }
        if yields && tour::card::is_low(ui) {
            return false;
        }
        // a window that opens over the tour gets the focus
        let takes_focus = self.window.is_none() && self.focus_due;
        tour::card::show(ui, step, takes_focus, actions);
        takes_focus
    }

    /// Forgets the thumbnails, because the device is gone that held them; they are rendered again.
    pub fn forget_thumbnails(&mut self) {
        self.thumbnails.clear();
    }

    /// Records that the tour has taken the keyboard focus.
    pub fn end_focus(&mut self) {
        self.focus_due = false;
    }

    /// Shows the open window, and closes it if the user does.
    pub fn show(&mut self, context: &Context, actions: &mut Actions) {
        let Some(open) = self.window else { return };
        let takes_focus = std::mem::take(&mut self.focus_due);
        let thumbnails = &mut self.thumbnails;
        self.close = open.show(context, takes_focus && open != Window::Gallery, |ui| match open {
            Window::Gallery => gallery::show(ui, thumbnails, takes_focus, actions),
            Window::Figures => figures_menu::list(ui, BESIDES, actions),
            Window::Shortcuts => shortcuts::show(ui),
        });
        if self.close.is_none() {
            actions.push(Action::Explore(ExploreAction::Close));
        }
    }

    /// The name of the open window, and the center of its close button.
    pub fn close(&self) -> Option<(&'static str, Pos2)> {
        Some((self.window?.name(), self.close?))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use egui_kittest::kittest::{NodeT, Queryable};

    #[test]
    fn the_tour_goes_on_from_step_to_step_and_gives_the_picture_from_before_back() {
        let mine = Session::with([crate::session::Command::SetTextureScale(13.0)]);
        let mut explore = Explore::default();
        for step in 0..tour::steps().len() {
            let shown = explore.act(ExploreAction::Tour(step), &mine, true).session;
            assert!(shown.is_some_and(|shown| shown != mine), "step {step}");
        }
        assert_eq!(
            explore.act(ExploreAction::Tour(99), &mine, false),
            Consequences::default(),
            "there is no such step"
        );
        let left = explore.act(ExploreAction::LeaveTour { keeps: false }, &Session::default(), false);
        assert_eq!(left, Consequences { session: Some(mine), walks: Some(true) });
        assert!(explore.tour.is_none());
    }

    #[test]
    fn leaving_the_tour_can_keep_its_session() {
        let mut explore = Explore::default();
        explore.act(ExploreAction::Tour(2), &Session::default(), false);
        assert_eq!(explore.act(ExploreAction::LeaveTour { keeps: true }, &Session::default(), false).session, None);
    }

    #[test]
    fn an_opened_window_announces_the_focused_button() {
        for action in [ExploreAction::Gallery, ExploreAction::Shortcuts, ExploreAction::Tour(1)] {
            let mut harness = crate::app::tests::ready_app([1200.0, 800.0]);
            harness.run_steps(3);
            let before = harness.state().stats().screen.spoken;
            harness.state_mut().explore(action);
            harness.run_steps(3);
            assert_eq!(harness.state().stats().screen.spoken, before + 1, "{action:?}");
        }
    }

    #[test]
    fn a_window_that_opens_during_the_tour_has_the_keyboard() {
        let mut harness = crate::app::tests::ready_app([1200.0, 800.0]);
        for action in [ExploreAction::Tour(1), ExploreAction::Shortcuts] {
            harness.state_mut().explore(action);
            harness.run_steps(3);
        }
        assert!(harness.get_by_label("Close").accesskit_node().is_focused());
    }

    #[test]
    fn on_a_phone_the_windows_have_a_working_close_button() {
        for action in [ExploreAction::Gallery, ExploreAction::Shortcuts] {
            let mut harness = crate::app::tests::ready_app([390.0, 844.0]);
            harness.state_mut().windows.explore.act(action, &Session::default(), false);
            harness.run_steps(6);
            let close = harness.state().stats().screen.windows.close;
            let at = Pos2::from(*close.values().next().unwrap());
            harness.drag_at(at);
            harness.step();
            harness.drop_at(at);
            harness.run_steps(3);
            assert!(harness.state().stats().screen.windows.close.is_empty(), "{action:?} is closed at {at}");
        }
    }
}
