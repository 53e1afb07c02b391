//! Outlines by hand, in the pictures: reshaping one by its handles.
//!
//! An [`Editor`] is a state without a screen: gestures, keys and buttons become [`EditAction`]s,
//! [`Editor::act`] carries them out and tells the model what to prepare. What the person sees of it is
//! in `paint` and `bar`, what the person does in `gestures`.

mod bar;
mod gestures;
mod live;
mod paint;
mod record;
mod reshaping;

pub use bar::show as show_bar;
pub use gestures::{interact, keys};
pub use live::Reshaped;
pub use paint::paint;
pub use record::{EditingStats, stats};
pub use reshaping::{Change, Reshaping};

use super::language::tr;
use super::model::Model;
use super::view::View;
use super::words;
use crate::conformal::Side;
use crate::geometry::DVec2;

/// What is added to the name of an outline that was reshaped, in any language.
const EDITED: &str = "*";

/// A step of a person who edits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EditAction {
    /// Reshape the outline of a side; once more: no more.
    Toggle(Side),
    /// No more.
    Leave,
    /// Take a handle in hand.
    Grab(usize),
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
}

/// What is edited, if anything.
#[derive(Debug, Default)]
pub struct Editor {
    reshaping: Option<Reshaping>,
    /// Whether the view showed all of the outline before: it does again afterwards.
    was_fitted: bool,
    /// The handle under the pointer.
    hovered: Option<usize>,
    /// Why the last change was not made.
    refusal: Option<String>,
}

impl Editor {
    /// The outline of this side under the hand.
    pub fn reshaping(&self, side: Side) -> Option<&Reshaping> {
        self.reshaping.as_ref().filter(|reshaping| reshaping.side() == side)
    }

    /// The side that is edited.
    pub fn side(&self) -> Option<Side> {
        self.reshaping.as_ref().map(Reshaping::side)
    }

    /// What is to be said about the outline in hand, or about a change that was not made.
    pub fn message(&self) -> Option<&str> {
        let crossing = self.reshaping.as_ref().and_then(Reshaping::crossing);
        crossing.map(|crossing| crossing.text.as_str()).or(self.refusal.as_deref())
    }

    /// Lets go without a word to the model: what was in hand is about to be replaced.
    pub fn drop_handle(&mut self) {
        if let Some(reshaping) = &mut self.reshaping {
            reshaping.drop_handle();
        }
    }

    /// Takes in what became of the outline by other means; a surface in its place ends the editing.
    pub fn follow(&mut self, model: &mut Model, views: &mut [View; 2]) {
        let hidden = self.side() == Some(Side::Target) && model.surface().is_some();
        if hidden {
            return self.leave(model, views);
        }
        if let Some(reshaping) = &mut self.reshaping {
            reshaping.follow(model);
        }
    }

    /// Carries out a step.
    pub fn act(&mut self, action: EditAction, model: &mut Model, views: &mut [View; 2]) {
        match action {
            EditAction::Toggle(side) if self.side() == Some(side) => return self.leave(model, views),
            EditAction::Toggle(side) => return self.begin(side, model, views),
            EditAction::Leave => return self.leave(model, views),
            _ => {}
        }
        let Some(reshaping) = &mut self.reshaping else { return };
        if !matches!(action, EditAction::Select(_) | EditAction::Drag(_)) {
            self.refusal = None;
        }
        match action {
            EditAction::Grab(handle) => reshaping.grab(handle, model),
            EditAction::Drag(to) => reshaping.drag(to, model),
            EditAction::Release => {
                if reshaping.release(model) {
                    self.refusal =
                        Some(String::from(tr("The outline crossed itself there: the last good one was kept.")));
                }
            }
            EditAction::Select(handle) => reshaping.selected = handle,
            EditAction::Change(change) => {
                self.refusal = reshaping.change(change, model).err().map(|error| error.to_string());
            }
            EditAction::Dismiss | EditAction::Toggle(_) | EditAction::Leave => {}
        }
    }

    fn begin(&mut self, side: Side, model: &mut Model, views: &mut [View; 2]) {
        self.leave(model, views);
        if side == Side::Target && model.surface().is_some() {
            return;
        }
        let name = words::outline(&model.side(side).wanted().outline);
        let name = format!("{}{EDITED}", name.strip_suffix(EDITED).unwrap_or(name));
        self.reshaping = Reshaping::new(side, name, model);
        let view = &mut views[side as usize];
        self.was_fitted = view.is_fitted();
        view.stay();
    }

    fn leave(&mut self, model: &mut Model, views: &mut [View; 2]) {
        if let Some(mut reshaping) = self.reshaping.take() {
            reshaping.release(model);
            if self.was_fitted {
                views[reshaping.side() as usize].fit();
            }
        }
        self.hovered = None;
        self.refusal = None;
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests;
