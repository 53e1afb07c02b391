//! What a step of the tour does by itself: its points move one after another, each once around, until the user takes
//! over by a dot, a key or a button.

use crate::family::Path;
use crate::model::Model;
use crate::model::motion::{PlayAction, Player};

/// The time for a look at the picture before the first point moves, in seconds.
const LOOK: f64 = 1.2;
/// The seconds for a turn: three of them are shown one after another.
const TURN: f64 = 7.0;

/// The motions of a step.
#[derive(Debug)]
pub struct Motions {
    paths: std::slice::Iter<'static, Path>,
    /// When the step's map was first complete.
    since: Option<f64>,
    /// Whether a motion of this step has begun that has not ended.
    is_moving: bool,
    /// The player's settings from before the first motion.
    before: Option<[PlayAction; 2]>,
}

impl Motions {
    /// The motions along these paths, one after another.
    pub fn new(paths: &'static [Path]) -> Self {
        Self { paths: paths.iter(), since: None, is_moving: false, before: None }
    }

    /// Begins the next motion when it is due, and ends one that is once around; returns the seconds after which it
    /// wants to be asked again. After a pause that is not its own it does nothing more.
    pub fn conduct(&mut self, player: &mut Player, model: &Model, now: f64) -> Option<f64> {
        if self.is_moving && !player.is_playing() {
            self.paths = [].iter();
            self.is_moving = false;
        }
        if self.is_moving && player.turns() >= 1 {
            player.pause();
            self.is_moving = false;
        }
        if self.is_moving || self.paths.len() == 0 || !model.is_ready() {
            return None;
        }
        let left = *self.since.get_or_insert(now) + LOOK - now;
        if left > 0.0 {
            return Some(left);
        }
        let path = *self.paths.next()?;
        let settings = [PlayAction::Period(player.period()), PlayAction::Along(player.path())];
        self.before.get_or_insert(settings);
        player.act(PlayAction::Period(TURN), model);
        player.act(PlayAction::Along(path), model);
        player.act(PlayAction::Toggle, model);
        self.is_moving = player.is_playing();
        None
    }

    /// Ends the motions of this step, and gives the player its settings back.
    pub fn end(&mut self, player: &mut Player, model: &Model) {
        if std::mem::take(&mut self.is_moving) {
            player.pause();
        }
        self.paths = [].iter();
        for setting in self.before.take().into_iter().flatten() {
            player.act(setting, model);
        }
    }
}
