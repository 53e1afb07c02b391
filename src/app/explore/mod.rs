//! Ways to explore by oneself: a gallery of pictures, a guided tour, what the keys and the mouse do.

mod gallery;
mod shortcuts;
mod thumbnail;
mod tour;

use super::action::Actions;
use crate::session::Session;
use egui::{Context, TextureHandle};

/// What the menu opens.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExploreAction {
    /// The gallery.
    Gallery,
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

/// Which of them are open.
#[derive(Default)]
pub struct Explore {
    gallery: bool,
    shortcuts: bool,
    tour: Option<Tour>,
    /// The gallery's small pictures that have been made, in its order; `None`: could not be.
    thumbnails: Vec<Option<TextureHandle>>,
}

struct Tour {
    step: usize,
    /// What was on the screen before it.
    before: Session,
}

/// What an [`ExploreAction`] changes on the screen.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Consequences {
    /// This session is shown.
    pub session: Option<Session>,
    /// The random walks run, or not.
    pub walks: Option<bool>,
}

impl Explore {
    /// Opens or goes on; `present` is the session on the screen.
    pub fn act(&mut self, action: ExploreAction, present: &Session) -> Consequences {
        match action {
            ExploreAction::Gallery => self.gallery = true,
            ExploreAction::Shortcuts => self.shortcuts = true,
            ExploreAction::Tour(step) => return self.go_to(step, present),
            ExploreAction::LeaveTour { keeps } => {
                let tour = self.tour.take();
                let back = tour.filter(|_| !keeps).map(|tour| tour.before);
                return Consequences { session: back, walks: Some(false) };
            }
        }
        Consequences::default()
    }

    fn go_to(&mut self, step: usize, present: &Session) -> Consequences {
        let Some(stop) = tour::steps().into_iter().nth(step) else { return Consequences::default() };
        self.gallery = false;
        let before = self.tour.take().map_or_else(|| present.clone(), |tour| tour.before);
        self.tour = Some(Tour { step, before });
        Consequences { session: Some(stop.session), walks: Some(stop.walks) }
    }

    /// Shows what is open.
    pub fn show(&mut self, context: &Context, actions: &mut Actions) {
        gallery::show(context, &mut self.gallery, &mut self.thumbnails, actions);
        shortcuts::show(context, &mut self.shortcuts);
        if let Some(tour) = &self.tour {
            tour::show(context, tour.step, actions);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tour_goes_on_from_step_to_step_and_gives_the_picture_from_before_back() {
        let mine = Session { texture_scale: 13.0, ..Session::default() };
        let mut explore = Explore::default();
        for step in 0..tour::steps().len() {
            let shown = explore.act(ExploreAction::Tour(step), &mine).session;
            assert!(shown.is_some_and(|shown| shown != mine), "step {step}");
        }
        assert_eq!(explore.act(ExploreAction::Tour(99), &mine), Consequences::default(), "there is no such step");
        let left = explore.act(ExploreAction::LeaveTour { keeps: false }, &Session::default());
        assert_eq!(left, Consequences { session: Some(mine), walks: Some(false) });
        assert!(explore.tour.is_none());
    }

    #[test]
    fn who_keeps_the_tours_picture_keeps_it() {
        let mut explore = Explore::default();
        explore.act(ExploreAction::Tour(2), &Session::default());
        assert_eq!(explore.act(ExploreAction::LeaveTour { keeps: true }, &Session::default()).session, None);
    }
}
