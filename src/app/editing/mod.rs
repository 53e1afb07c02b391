//! Editing of outlines in the pictures: drawing, reshaping by handles, pasting.
//!
//! An [`Editor`] holds the state and can be driven without a screen: gestures, keys and buttons become
//! [`EditAction`]s; [`Editor::act`] carries them out and requests outlines from the model. Painting is in
//! `paint` and `bar`, input in `gestures`, `pen` and `paste`.

mod bar;
mod gestures;
mod paint;
mod paste;
mod pen;
mod record;

pub use bar::{height as bar_height, show as show_bar};
pub use gestures::{interact, keys};
pub use paint::{paint, paint_sheet};
pub use paste::{pasted, show as show_paste};
pub use record::{EditingStats, stats};

use crate::app::input::action::EditAction;
use crate::app::viewport::view::View;
use crate::conformal::{PerSide, Side};
use crate::language::{Message, key};
use crate::model::editing::{Change, Crossing, Drawing, Hold, Reshaping};
use crate::model::{Model, names};
use crate::outline::Outline;
use crate::session::Touched;
use egui::vec2;
use paste::Paste;

#[derive(Debug)]
enum Work {
    Reshaping(Box<Reshaping>),
    Drawing(Drawing),
}

/// The outline that is being reshaped or drawn, if any, and the paste window.
#[derive(Debug, Default)]
pub struct Editor {
    work: Option<Work>,
    /// Whether the view was fitted before the editing; then it is fitted again afterwards.
    was_fitted: bool,
    /// The handle under the pointer.
    hovered: Option<usize>,
    /// The reason why the last change was refused.
    refusal: Option<Message>,
    /// The paste window, while it is open.
    paste: Option<Paste>,
}

impl Editor {
    /// The reshaping of this side's outline, if it is being reshaped.
    pub fn reshaping(&self, side: Side) -> Option<&Reshaping> {
        match &self.work {
            Some(Work::Reshaping(reshaping)) if reshaping.side() == side => Some(reshaping),
            _ => None,
        }
    }

    /// The side whose outline is being reshaped.
    pub fn reshaped_side(&self) -> Option<Side> {
        Side::BOTH.into_iter().find(|&side| self.reshaping(side).is_some())
    }

    /// The drawing for this side, if there is one.
    pub fn drawing(&self, side: Side) -> Option<&Drawing> {
        match &self.work {
            Some(Work::Drawing(drawing)) if drawing.side() == side => Some(drawing),
            _ => None,
        }
    }

    /// Whether nothing is drawn, reshaped or pasted.
    pub fn is_at_rest(&self) -> bool {
        self.side().is_none() && self.paste.is_none()
    }

    /// The side whose outline is being reshaped or drawn.
    pub fn side(&self) -> Option<Side> {
        match self.work.as_ref()? {
            Work::Reshaping(reshaping) => Some(reshaping.side()),
            Work::Drawing(drawing) => Some(drawing.side()),
        }
    }

    /// The place where the reshaped or drawn outline crosses itself, and the message about it.
    pub fn crossing(&self) -> Option<&Crossing> {
        match self.work.as_ref()? {
            Work::Reshaping(reshaping) => reshaping.crossing(),
            Work::Drawing(drawing) => drawing.crossing(),
        }
    }

    /// The message about a crossing, or else about a refused change.
    pub fn message(&self) -> Option<&Message> {
        self.crossing().map(|crossing| &crossing.text).or(self.refusal.as_ref())
    }

    /// The errors that are shown, those of the paste window included. A crossing while reshaping is not among them: the
    /// drag may still resolve it, and it is reported on release.
    pub fn errors(&self) -> impl Iterator<Item = &Message> {
        let drawn = self.crossing().filter(|_| self.reshaped_side().is_none()).map(|crossing| &crossing.text);
        drawn.or(self.refusal.as_ref()).into_iter().chain(self.paste.as_ref().and_then(Paste::error))
    }

    /// Ends the drag of a handle without a request to the model: its outline is about to be replaced.
    pub fn drop_handle(&mut self) {
        if let Some(Work::Reshaping(reshaping)) = &mut self.work {
            reshaping.drop_handle();
        }
    }

    /// Restarts from the side's outline if it was changed by other means; ends the editing if a surface replaced it.
    pub fn follow(&mut self, model: &mut Model, views: &mut PerSide<View>) {
        // the text is no longer read: something else was chosen meanwhile
        self.paste.take_if(|paste| paste.is_being_read() && !model.reads_pasted(paste.side()));
        let Some(Work::Reshaping(reshaping)) = &mut self.work else { return };
        if model.reshapable(reshaping.side()).is_none() {
            self.leave(model, views);
        } else {
            reshaping.follow(model);
        }
    }

    /// Carries out an action; one that does not apply to the current state is ignored. Returns the parts of the session
    /// that it changes or begins to change. A drawing touches the session when it is closed, a pasted text only when a
    /// worker has read an outline in it.
    pub fn act(&mut self, action: EditAction, model: &mut Model, views: &mut PerSide<View>) -> Touched {
        match action {
            EditAction::Toggle(side) if self.reshaping(side).is_some() => self.leave(model, views),
            EditAction::Toggle(side) => self.begin(side, model, views),
            EditAction::Draw(side, pen) => {
                self.leave(model, views);
                self.work = Some(Work::Drawing(Drawing::new(side, pen)));
            }
            EditAction::Leave => self.leave(model, views),
            EditAction::OpenPaste(side) => self.paste = Some(Paste::new(side)),
            EditAction::ClosePaste => self.paste = None,
            EditAction::TakePasted => {
                if let Some(paste) = &mut self.paste {
                    let side = paste.side();
                    model.open_pasted(side, paste.begin_reading());
                }
            }
            _ => match &self.work {
                Some(Work::Reshaping(reshaping)) => {
                    if matches!(action, EditAction::Grab(..) | EditAction::Change(_)) {
                        // the view must not refit while the outline changes: the handle stays under the pointer
                        views[reshaping.side()].stay();
                    }
                    self.reshape(action, model);
                    return action.leads_to();
                }
                Some(Work::Drawing(_)) => return self.draw(action, model, views),
                None => {}
            },
        }
        Touched::NOTHING
    }

    /// Begins to read a text that was pasted while no text field was focused, as an outline for the side of the paste
    /// window, or else for the source. A text that is no outline is shown in the window with the error.
    pub fn take_text(&mut self, text: String, model: &mut Model) {
        let open = self.paste.as_ref().filter(|paste| !paste.is_being_read());
        let side = open.map_or(Side::Source, Paste::side);
        let mut paste = Paste::with(side, text);
        model.open_pasted(side, paste.begin_reading());
        self.paste = Some(paste);
    }

    /// Closes the paste window: the text was an outline, which the side now requests.
    pub fn end_paste(&mut self, model: &mut Model, views: &mut PerSide<View>) {
        self.paste = None;
        self.leave(model, views);
    }

    /// Shows in the paste window why the text for a side is no outline.
    pub fn refuse_paste(&mut self, side: Side, why: Message) {
        self.paste.get_or_insert_with(|| Paste::new(side)).refuse(why);
    }

    /// Continues a drawing. Returns what it touches once it is closed and requested as an outline.
    fn draw(&mut self, action: EditAction, model: &mut Model, views: &mut PerSide<View>) -> Touched {
        let Some(Work::Drawing(drawing)) = &mut self.work else { return Touched::NOTHING };
        match action {
            EditAction::Point(point) => drawing.add(point),
            EditAction::TakeBack => drawing.take_back(),
            EditAction::Clear => drawing.clear(),
            EditAction::Dismiss => drawing.dismiss(),
            EditAction::Close => {
                let side = drawing.side();
                let view = &views[side];
                let pixel = view.to_world(view.rect.min + vec2(1.0, 0.0)).distance(view.to_world(view.rect.min));
                if let Some(polygon) = drawing.close(pixel) {
                    model.want_loaded(side, Outline::new(names::DRAWN, polygon));
                    self.leave(model, views);
                    return action.leads_to();
                }
            }
            _ => {}
        }
        Touched::NOTHING
    }

    fn reshape(&mut self, action: EditAction, model: &mut Model) {
        let Some(Work::Reshaping(reshaping)) = &mut self.work else { return };
        if !matches!(action, EditAction::Select(_) | EditAction::Drag(_)) {
            self.refusal = None;
        }
        match action {
            EditAction::Grab(handle, hold) => reshaping.grab(handle, hold, model),
            EditAction::Drag(to) => reshaping.drag(to, model),
            EditAction::Release => {
                let crossed = reshaping.release(model);
                self.refusal = crossed.then(|| key::outline_crossed_itself().into());
            }
            EditAction::Select(handle) => reshaping.selected = handle,
            EditAction::Change(change) => {
                self.refusal = reshaping.change(change, model).err().map(|error| Message::from(&error));
            }
            _ => {}
        }
    }

    fn begin(&mut self, side: Side, model: &mut Model, views: &mut PerSide<View>) {
        self.leave(model, views);
        if model.reshapable(side).is_none() {
            return;
        }
        let reshaping = Reshaping::new(side, model);
        self.work = Some(Work::Reshaping(Box::new(reshaping)));
        self.was_fitted = views[side].is_fitted();
    }

    fn leave(&mut self, model: &mut Model, views: &mut PerSide<View>) {
        if let Some(Work::Reshaping(mut reshaping)) = self.work.take() {
            reshaping.release(model);
            if self.was_fitted {
                views[reshaping.side()].fit();
            }
        }
        self.hovered = None;
        self.refusal = None;
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod screen_tests;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests;
