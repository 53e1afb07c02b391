//! Gallery, list of figures, guided tour and lessons, and list of shortcuts.

mod gallery;
mod shortcuts;
mod thumbnail;
pub mod tour;
mod window;

use crate::app::input::action::{Action, Actions, ExploreAction};
use crate::app::menus::figures_menu;
use crate::app::plots::BoundaryPlace;
use crate::model::Model;
use crate::model::motion::Player;
use crate::session::Session;
use crate::session::lesson::Lesson;
use egui::{Context, Pos2, TextureHandle, Ui};
use std::sync::Arc;
use tour::card::{Card, CardPlots, Motion};
use tour::{Course, Motions, Stop, Tour};
use window::{BESIDES, Window};

/// The open window, at most one, and the tour.
#[derive(Default)]
pub struct Explore {
    window: Option<Window>,
    /// The center of the window's close button.
    close: Option<Pos2>,
    tour: Option<Tour>,
    /// Whether the card shows the plots in place of the words, where there is no room for them elsewhere.
    pub card_plots: bool,
    /// Whether nothing is to move before the user asks for it (`prefers-reduced-motion`).
    pub is_calm: bool,
    /// Whether the window or step that was just opened still has to get the keyboard focus.
    focus_due: bool,
    /// The gallery's thumbnails rendered so far, in its order; `None` where rendering failed.
    thumbnails: Vec<Option<TextureHandle>>,
}

/// What the card of a step has found out.
#[derive(Debug, Clone, Copy, Default)]
pub struct CardShown {
    /// The place under the pointer in its plots.
    pub pointed: Option<BoundaryPlace>,
    /// Whether it took the keyboard focus that was due.
    pub took_focus: bool,
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
            ExploreAction::Tour(step) => return self.go_to(Course::Guided, step, present, is_walking),
            ExploreAction::Step(step) => {
                let course = self.tour.as_ref().map(|tour| tour.course.clone());
                return course.map(|course| self.go_to(course, step, present, is_walking)).unwrap_or_default();
            }
            ExploreAction::Again => return self.show_again(),
            ExploreAction::CardPlots(shown) => self.card_plots = shown,
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

    /// Plays a lesson from its first step; `present` and `is_walking` as for [`Self::act`].
    pub fn play(&mut self, lesson: Arc<Lesson>, present: &Session, is_walking: bool) -> Consequences {
        self.go_to(Course::Lesson(lesson), 0, present, is_walking)
    }

    fn go_to(&mut self, course: Course, step: usize, present: &Session, is_walking: bool) -> Consequences {
        let Some(stop) = course.stop(step) else { return Consequences::default() };
        self.window = None;
        self.focus_due = true;
        let walks = stop.walks && !self.is_calm;
        let consequences = Consequences { session: Some(stop.session.clone()), walks: Some(walks) };
        let motions = Motions::new(if self.is_calm { &[] } else { stop.motions });
        let begun = self.tour.take().map(|tour| (tour.before, tour.walked));
        let (before, walked) = begun.unwrap_or_else(|| (present.clone(), is_walking));
        let is_waiting = self.is_calm;
        self.tour = Some(Tour { course, step, before, walked, motions, is_waiting });
        consequences
    }

    /// Shows the step once more, and what it does by itself.
    fn show_again(&mut self) -> Consequences {
        let Some(tour) = &mut self.tour else { return Consequences::default() };
        let Some(stop) = tour.course.stop(tour.step) else { return Consequences::default() };
        let consequences = Consequences { session: Some(stop.session.clone()), walks: Some(stop.walks) };
        let motions = Motions::new(stop.motions);
        (tour.motions, tour.is_waiting) = (motions, false);
        consequences
    }

    fn stop(&self) -> Option<Stop<'_>> {
        self.tour.as_ref().and_then(|tour| tour.course.stop(tour.step))
    }

    /// The session from before the tour or lesson in progress.
    pub fn before(&self) -> Option<&Session> {
        self.tour.as_ref().map(|tour| &tour.before)
    }

    /// Whether a lesson is in progress.
    pub fn plays_lesson(&self) -> bool {
        self.tour.as_ref().is_some_and(|tour| tour.course.is_lesson())
    }

    /// The step of the tour or lesson that is shown, counted from 0.
    pub fn step(&self) -> Option<usize> {
        self.tour.as_ref().map(|tour| tour.step)
    }

    /// Whether a window is open.
    pub fn is_open(&self) -> bool {
        self.window.is_some()
    }

    /// Whether the tour or a lesson is in progress.
    pub fn is_touring(&self) -> bool {
        self.tour.is_some()
    }

    /// Title and text of the step.
    pub fn words(&self) -> Option<[&str; 2]> {
        self.stop().map(|stop| [stop.title, stop.text])
    }

    /// Begins and ends the motions of the tour's step, unless the user `holds` a point; returns the seconds until the
    /// next one is due.
    pub fn conduct(&mut self, player: &mut Player, model: &Model, holds: bool, now: f64) -> Option<f64> {
        self.tour.as_mut()?.motions.conduct(player, model, holds, now)
    }

    /// Ends the motions of the tour's step.
    pub fn end_motions(&mut self, player: &mut Player, model: &Model) {
        self.tour.iter_mut().for_each(|tour| tour.motions.end(player, model));
    }

    /// Whether the tour's step carries a circle with a cross along.
    pub fn probes(&self) -> bool {
        self.stop().is_some_and(|stop| stop.probes)
    }

    /// Shows the card of the step beside or below the pictures; if it `yields` to a message, it is hidden on a low screen.
    /// `player` moves the points; `plots` are those that have no room elsewhere.
    pub fn show_tour(
        &self,
        ui: &mut Ui,
        player: &Player,
        yields: bool,
        plots: Option<CardPlots<'_>>,
        actions: &mut Actions,
    ) -> CardShown {
        let (Some(tour), Some(stop)) = (&self.tour, self.stop()) else { return CardShown::default() };
        if yields && tour::card::is_low(ui) {
            return CardShown::default();
        }
        let card = Card {
            stop,
            step: tour.step,
            count: tour.course.len(),
            is_lesson: tour.course.is_lesson(),
            motion: match tour.is_waiting {
                _ if player.is_playing() => Motion::Moving,
                true => Motion::Waiting,
                false => Motion::Over,
            },
            plots,
            // a window that opens over the tour gets the focus
            takes_focus: self.window.is_none() && self.focus_due,
        };
        CardShown { pointed: card.show(ui, actions), took_focus: card.takes_focus }
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
        for step in 0..Course::Guided.len() {
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
