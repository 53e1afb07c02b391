//! The motions of a step of the tour: its points move one after another, each once around, until the user holds a
//! point, or starts or stops the motion.

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
    /// The paths that are left.
    paths: &'static [Path],
    stage: Stage,
    /// The player's settings from before the first motion.
    before: Option<[PlayAction; 2]>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Stage {
    /// The map is not complete yet.
    Waiting,
    /// The next motion begins at this time.
    Due(f64),
    Moving,
}

impl Motions {
    /// The motions along these paths, one after another.
    pub fn new(paths: &'static [Path]) -> Self {
        Self { paths, stage: Stage::Waiting, before: None }
    }

    /// Begins the next motion when it is due; returns the seconds until then. If the user `holds` a point, or has
    /// started or stopped the motion, no further one begins.
    pub fn conduct(&mut self, player: &mut Player, model: &Model, holds: bool, now: f64) -> Option<f64> {
        let is_moving = self.stage == Stage::Moving;
        if is_moving && player.has_come_around() {
            self.stage = Stage::Due(now);
        } else if holds || is_moving != player.is_playing() {
            self.paths = &[];
        }
        let (path, rest) = self.paths.split_first().filter(|_| self.stage != Stage::Moving && model.is_ready())?;
        let due = if let Stage::Due(due) = self.stage { due } else { now + LOOK };
        self.stage = Stage::Due(due);
        if due > now {
            return Some(due - now);
        }
        self.paths = rest;
        self.begin(*path, player, model);
        None
    }

    fn begin(&mut self, path: Path, player: &mut Player, model: &Model) {
        self.before.get_or_insert([PlayAction::Period(player.period()), PlayAction::Along(player.path())]);
        for action in [PlayAction::Period(TURN), PlayAction::Along(path), PlayAction::Once] {
            player.act(action, model);
        }
        self.stage = if player.is_playing() { Stage::Moving } else { Stage::Waiting };
    }

    /// Ends the motions, and gives the player its settings back.
    pub fn end(&mut self, player: &mut Player, model: &Model) {
        let Some(before) = self.before.take() else { return };
        player.pause();
        self.paths = &[];
        for setting in before {
            player.act(setting, model);
        }
    }
}
