//! Outlines from text: the paste window, and pasting while no text field is focused.
//!
//! All text formats of outline files are read, by the side's worker; the window is hidden meanwhile. A text longer than
//! [`LONGEST_SHOWN`] is read at once and never shown in the field.

use super::Editor;
use crate::app::input::action::{Action, Actions, EditAction};
use crate::app::theme::{Palette, ROUNDING};
use crate::conformal::Side;
use crate::language::{Label as Words, Message, key, say, tr};
use egui::{
    Align2, Button, Context, CornerRadius, Event, FontId, Frame, Key, Label, RichText, ScrollArea, Stroke, TextEdit,
    Ui, Window, vec2,
};

/// The text that lists the supported formats.
const KINDS: Words = key::paste_kinds();

/// The most bytes of a text in the field: 1600 points with twelve digits. The field lays out the whole text after every
/// change; on a desktop that takes 0.3 ms at this length, and 20 to 90 ms per key press for a megabyte.
pub const LONGEST_SHOWN: usize = 50_000;

/// The height of the text field, in points: ten lines.
const FIELD: f32 = 150.0;

/// The state of the paste window.
#[derive(Debug)]
pub struct Paste {
    side: Side,
    /// The text in the field.
    text: String,
    /// The reason why the text is no outline.
    error: Option<Message>,
    is_being_read: bool,
}

impl Paste {
    /// An empty field, for a side.
    pub fn new(side: Side) -> Self {
        Self::with(side, String::new())
    }

    /// A field with a text.
    pub fn with(side: Side, text: String) -> Self {
        Self { side, text, error: None, is_being_read: false }
    }

    /// The side that gets the outline.
    pub fn side(&self) -> Side {
        self.side
    }

    /// The text in the field.
    #[cfg(test)]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The reason why the text is no outline.
    pub fn error(&self) -> Option<&Message> {
        self.error.as_ref()
    }

    /// Whether a worker is reading the text.
    pub fn is_being_read(&self) -> bool {
        self.is_being_read
    }

    /// Hides the window and returns the text for a worker to read.
    pub fn begin_reading(&mut self) -> &str {
        (self.is_being_read, self.error) = (true, None);
        &self.text
    }

    /// Keeps why the text is no outline; a text longer than [`LONGEST_SHOWN`] is cleared.
    pub fn refuse(&mut self, why: Message) {
        self.is_being_read = false;
        let length = self.text.len();
        self.error = Some(if length > LONGEST_SHOWN {
            self.text = String::new();
            key::pasted_text_not_shown(why, length, LONGEST_SHOWN)
        } else {
            why
        });
    }
}

/// Takes the text that was pasted in this frame; `None` if it belongs to a focused text field. A text longer than
/// [`LONGEST_SHOWN`] is taken even then.
pub fn pasted(ui: &Ui) -> Option<String> {
    let writes = ui.ctx().text_edit_focused();
    let is_ours = |text: &str| if writes { text.len() > LONGEST_SHOWN } else { !text.trim().is_empty() };
    ui.input_mut(|input| {
        let at = input.events.iter().position(|event| matches!(event, Event::Paste(text) if is_ours(text)))?;
        let Event::Paste(text) = input.events.remove(at) else { return None };
        Some(text)
    })
}

/// Shows the window while it is open.
pub fn show(context: &Context, editor: &mut Editor, actions: &mut Actions) {
    let Some(paste) = editor.paste.as_mut().filter(|paste| !paste.is_being_read) else { return };
    let width = (context.content_rect().width() - 40.0).min(460.0);
    let mut open = true;
    let title = match paste.side {
        Side::Source => tr(key::paste_outline_source()),
        Side::Target => tr(key::paste_outline_target()),
    };
    Window::new(title)
        .id(egui::Id::unique("paste"))
        .open(&mut open)
        .collapsible(false)
        .resizable(false)
        .fixed_size(vec2(width, 0.0))
        .anchor(Align2::CENTER_CENTER, vec2(0.0, 0.0))
        .show(context, |ui| content(ui, paste, actions));
    if !open || context.input(|input| input.key_pressed(Key::Escape)) {
        actions.push(Action::Edit(EditAction::ClosePaste));
    }
}

fn content(ui: &mut Ui, paste: &mut Paste, actions: &mut Actions) {
    let palette = Palette::of(ui.visuals());
    ui.add(Label::new(RichText::new(tr(KINDS)).small().color(palette.weak)).wrap());
    // in the light theme the field's own edge has the color of the background
    let edge = Frame::new().stroke(Stroke::new(1.0, palette.border)).corner_radius(CornerRadius::same(ROUNDING));
    edge.show(ui, |ui| field(ui, paste, actions));
    if let Some(error) = &paste.error {
        ui.add(Label::new(RichText::new(say(error)).color(palette.error_edge)).wrap());
    }
    ui.horizontal(|ui| {
        let filled = !paste.text.trim().is_empty();
        if ui.add_enabled(filled, Button::new(tr(key::use_pasted())).min_size(vec2(0.0, 40.0))).clicked() {
            actions.push(Action::Edit(EditAction::TakePasted));
        }
        if ui.add(Button::new(tr(key::cancel())).min_size(vec2(0.0, 40.0))).clicked() {
            actions.push(Action::Edit(EditAction::ClosePaste));
        }
    });
}

fn field(ui: &mut Ui, paste: &mut Paste, actions: &mut Actions) {
    ScrollArea::vertical().max_height(FIELD).min_scrolled_height(FIELD).show(ui, |ui| {
        let field = TextEdit::multiline(&mut paste.text)
            .font(FontId::monospace(12.0))
            .desired_width(f32::INFINITY)
            .desired_rows(8)
            .hint_text("M 0 0 L 2 0 L 1 3 Z");
        let response = ui.add(field);
        if paste.text.is_empty() && paste.error.is_none() {
            response.request_focus();
        }
        if response.changed() {
            paste.error = None;
            if paste.text.len() > LONGEST_SHOWN {
                actions.push(Action::Edit(EditAction::TakePasted));
            }
        }
    });
}
