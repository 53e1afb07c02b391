//! The one place where actions become changes. Requests of the panels, the keyboard and the page are applied to the
//! session, the points in motion, the editor, files and windows. This file computes nothing itself.

use super::RiemapApp;
use crate::app::input::action::{Action, Actions, EditAction, ExploreAction};
use crate::app::input::locks::Locks;
use crate::app::input::preferences::{Habit, Preferences};
use crate::app::input::presentation;
use crate::app::messages::Notice;
use crate::app::windows::explore::Consequences;
use crate::conformal::Side;
use crate::language::{key, tr};
use crate::model::files::{FilePurpose, kind_of_file};
use crate::model::motion::PlayAction;
use crate::model::overlays::walks::WalkAction;
use crate::platform;
use crate::session::{Command, Session, Touched};

impl RiemapApp {
    /// Carries out all actions; a locked one is refused with a message.
    pub(super) fn carry_out(&mut self, context: &egui::Context, actions: Actions) {
        let locks = Locks::of(context);
        for action in actions {
            // a disabled widget emits no action: a locked action came from a key or the clipboard
            match locks.refused(&action) {
                Some(control) => self.refuse(control),
                None => self.act(context, action),
            }
        }
    }

    /// Queues actions for the start of the next frame, and requests that frame at once.
    pub(super) fn ask(&mut self, context: &egui::Context, actions: Actions) {
        if !actions.is_empty() {
            self.input.asked.extend(actions);
            context.request_repaint();
        }
    }

    fn act(&mut self, context: &egui::Context, action: Action) {
        match action {
            Action::Session(command) => {
                if matches!(command, Command::Open(_)) {
                    self.begin_visit();
                }
                let now = context.input(|input| input.time);
                if command == Command::Continue {
                    self.messages.notice = Some(Notice::new(key::choose_next_target(), now));
                }
                self.command(command, now);
            }
            Action::Undo => self.undo(),
            Action::Redo => self.redo(),
            Action::New => {
                self.begin_visit();
                self.open_session(Session::default());
            }
            Action::OpenKept(id) => self.open_kept(&id),
            Action::OpenSession => self.pick_file(FilePurpose::Session),
            Action::SaveSession => self.save_session(),
            Action::CopyLink => self.copy_link(context),
            Action::Share(action) => self.share(action),
            Action::OpenOutline(side) => self.pick_file(FilePurpose::Outline(side)),
            Action::OpenPart(side, number) => self.model.open_part(side, number),
            Action::OpenTrace(side) => self.pick_file(FilePurpose::Trace(side)),
            Action::TraceImage => self.trace_image(),
            Action::ShowUv(shown) => self.pictures.uv.is_shown = shown,
            Action::UseImage => self.use_offered_image(),
            Action::DismissOffer => self.messages.offer = None,
            Action::OpenImage => self.pick_file(FilePurpose::Image),
            Action::Fit(side) => self.fit(side),
            Action::Edit(action) => self.edit(action),
            Action::PasteText(text) => self.editor.take_text(text, &mut self.model),
            Action::QuickFix(side) => self.quick_fix(side),
            Action::Dismiss(side) => self.model.dismiss(side),
            Action::OpenReport(report) => self.windows.reports.open(report),
            Action::ShowLadder(shown) => self.windows.reports.show_ladder(shown),
            Action::CloseReport => self.windows.reports.close(),
            Action::DismissMessage => self.dismiss_message(),
            Action::Grid(action) => self.model.act_on_grids(action),
            Action::Projection(action) => self.act_on_projection(action),
            Action::Export(action) => self.export(action, context),
            Action::Play(PlayAction::Toggle) if self.model.pins().is_some() && !self.player.is_playing() => {
                self.messages.common = Some(key::pins_do_not_play().into());
            }
            Action::Play(action) => self.player.act(action, &self.model),
            Action::Best(action) => self.model.act_on_best(action),
            Action::Walks(action) => self.model.act_on_walks(action),
            Action::Invariants(action) => self.model.act_on_invariants(action),
            Action::Explore(action) => self.explore(action),
            Action::Lesson(action) => self.act_on_lesson(action, context),
            Action::Prefer(preferences) => self.prefer(context, preferences),
            Action::Recall(habit) => self.recall(habit),
            Action::TogglePanels => self.fold_panels(),
            Action::ToggleColumn => {
                let open = self.screen.column_open(context.content_rect().size(), self.windows.lesson.is_open);
                self.screen.column_asked = Some(!open);
            }
            Action::OpenSheet(open) => self.screen.sheet_open = open,
            Action::Plots(action) => self.plots.act(action),
            Action::ToggleFullScreen => platform::toggle_full_screen(context),
            Action::TogglePresentation => presentation::toggle(context),
        }
    }

    pub(super) fn pick_file(&self, purpose: FilePurpose) {
        platform::pick_file(purpose, tr(kind_of_file(purpose)), self.workers.mailbox.clone());
    }

    pub(super) fn command(&mut self, command: Command, now: f64) {
        let touched = self.model.dispatch(command, now);
        self.begin_change(touched);
    }

    /// The one place for the consequences of a change of these parts of the session: motion pauses, the tour ends,
    /// undo gets a step.
    pub(super) fn begin_change(&mut self, touched: Touched) {
        if touched.is_only(Touched::POINTS) {
            self.player.pause();
        }
        if touched.touches(Touched::NEW_SHAPE) {
            self.end_tour();
        }
        self.persistence.touch();
    }

    /// Fits the view of a side to its whole domain or surface.
    fn fit(&mut self, side: Side) {
        self.pictures.of_mut(&self.model, side).fit();
    }

    fn quick_fix(&mut self, side: Side) {
        let touched = self.model.quick_fix(side);
        if touched != Touched::NOTHING {
            self.begin_change(touched);
        }
    }

    fn edit(&mut self, action: EditAction) {
        if let EditAction::Draw(side, _) = action {
            // a message about the previous outline would cover the place where the new one is drawn
            self.model.dismiss(side);
        }
        let touched = self.editor.act(action, &mut self.model, &mut self.pictures.views);
        self.take_arrived(); // a pasted text that is too long is refused before it is sent
        self.begin_change(touched);
    }

    pub(super) fn explore(&mut self, action: ExploreAction) {
        let action = match action {
            // the file being read will replace the tour; restoring the session from before the tour would cancel it
            ExploreAction::LeaveTour { .. } if self.model.awaits_file() => ExploreAction::LeaveTour { keeps: true },
            other => other,
        };
        match action {
            ExploreAction::Tour(_) | ExploreAction::Step(_) | ExploreAction::Again => self.begin_playing(),
            ExploreAction::LeaveTour { .. } => self.windows.explore.end_motions(&mut self.player, &self.model),
            _ => {}
        }
        let was_lesson = self.windows.explore.plays_lesson();
        self.act_on_tour(action);
        if was_lesson && !self.windows.explore.plays_lesson() {
            // a reload is to show the session, not the lesson
            self.correct_address();
        }
    }

    fn act_on_tour(&mut self, action: ExploreAction) {
        let is_walking = self.model.overlay_state().walks.is_running();
        let was_touring = self.windows.explore.is_touring();
        let consequences = self.windows.explore.act(action, &self.model.requested(), is_walking);
        if was_touring && !self.windows.explore.is_touring() && consequences.session.is_some() {
            self.persistence.come_back();
        }
        self.follow(consequences);
    }

    /// Shows what an action of the tour or of a lesson leads to.
    pub(super) fn follow(&mut self, Consequences { session, walks }: Consequences) {
        if let Some(session) = session {
            self.show_session(session);
        }
        if walks.is_some_and(|run| run != self.model.overlay_state().walks.is_running()) {
            self.model.act_on_walks(WalkAction::Toggle);
        }
    }

    /// Ends the tour or lesson as [`Self::end_tour`] does and leaves the address as it is: another session's.
    pub(super) fn drop_tour(&mut self) {
        self.windows.explore.end_motions(&mut self.player, &self.model);
        self.act_on_tour(ExploreAction::LeaveTour { keeps: true });
    }

    /// Ends the tour because another picture replaces it: the session stays, and the random walks that the tour started
    /// stop.
    pub(super) fn end_tour(&mut self) {
        self.explore(ExploreAction::LeaveTour { keeps: true });
    }

    /// Closes the message. The name of a missing file of a link may have been hidden by this message: that is shown
    /// again, until it is closed itself.
    fn dismiss_message(&mut self) {
        let closed = self.messages.common.take();
        self.messages.common = closed.and_then(|closed| self.persistence.unread_after(&closed));
    }

    fn prefer(&mut self, context: &egui::Context, preferences: Preferences) {
        self.screen.preferences = preferences;
        preferences.apply(context);
        preferences.remember();
    }

    /// Stores what the user has seen or unfolded. Language and theme are stored as chosen: those of the screen may be
    /// the address's.
    pub(super) fn recall(&mut self, habit: Habit) {
        let habits = self.screen.preferences.habits.and(habit);
        if habits == std::mem::replace(&mut self.screen.preferences.habits, habits) || !self.screen.remembers {
            return;
        }
        Preferences { habits, ..Preferences::remembered() }.remember();
    }

    /// Hides the panels or shows them; an embedded app has none.
    fn fold_panels(&mut self) {
        self.screen.panels_open = !self.screen.panels_open && !self.options.embed;
    }
}
