//! Outlines from text: a small window to paste it into, and pasting anywhere.

use super::{EditAction, Editor};
use crate::app::action::{Action, Actions};
use crate::app::language::{tr, tr_message};
use crate::app::theme::Palette;
use crate::conformal::Side;
use crate::outline::{Outline, parse};
use egui::{Align2, Button, Context, Event, FontId, Key, Label, RichText, ScrollArea, TextEdit, Ui, Window, vec2};

/// What the text may be.
const KINDS: &str =
    "SVG path data (M 0 0 L 2 0 …), SVG, coordinates (0,0 2,0 1,3 or one point per line), JSON or GeoJSON";

/// The height of the field for the text: ten lines.
const FIELD: f32 = 150.0;

/// The window's content.
#[derive(Debug)]
pub struct Paste {
    side: Side,
    /// What is written in it.
    text: String,
    /// Why that is no outline.
    error: Option<String>,
}

impl Paste {
    /// An empty field, for a side.
    pub fn new(side: Side) -> Self {
        Self::with(side, String::new())
    }

    /// A field with a text.
    pub fn with(side: Side, text: String) -> Self {
        Self { side, text, error: None }
    }

    /// For which side.
    pub fn side(&self) -> Side {
        self.side
    }

    /// Why the text is no outline.
    pub fn error(&self) -> Option<&str> {
        self.error.as_deref()
    }

    /// The outline that is written in it; where there is none, the reason is kept.
    pub fn take(&mut self) -> Option<(Side, Outline)> {
        match parse(tr("Pasted"), self.text.as_bytes()) {
            Ok(outline) => Some((self.side, outline)),
            Err(error) => {
                self.error = Some(error.to_string());
                None
            }
        }
    }
}

/// What was pasted in this frame, unless a text is being written.
pub fn pasted(ui: &Ui) -> Option<String> {
    if ui.ctx().text_edit_focused() {
        return None;
    }
    ui.input(|input| {
        input.events.iter().find_map(|event| match event {
            Event::Paste(text) if !text.trim().is_empty() => Some(text.clone()),
            _ => None,
        })
    })
}

/// Shows the window while it is open.
pub fn show(context: &Context, editor: &mut Editor, actions: &mut Actions) {
    let Some(paste) = &mut editor.paste else { return };
    let width = (context.content_rect().width() - 40.0).min(460.0);
    let mut open = true;
    let title = match paste.side {
        Side::Source => tr("Paste an outline for the source"),
        Side::Target => tr("Paste an outline for the target"),
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
    ScrollArea::vertical().max_height(FIELD).show(ui, |ui| {
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
        }
    });
    if let Some(error) = &paste.error {
        ui.add(Label::new(RichText::new(tr_message(error)).color(palette.error_edge)).wrap());
    }
    ui.horizontal(|ui| {
        let filled = !paste.text.trim().is_empty();
        if ui.add_enabled(filled, Button::new(tr("Use it")).min_size(vec2(0.0, 40.0))).clicked() {
            actions.push(Action::Edit(EditAction::TakePasted));
        }
        if ui.add(Button::new(tr("Cancel")).min_size(vec2(0.0, 40.0))).clicked() {
            actions.push(Action::Edit(EditAction::ClosePaste));
        }
    });
}
