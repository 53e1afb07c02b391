//! The outline in hand as a plain record, for `window.riemap.stats()` and for tests.

use super::Editor;
use super::paste::Paste;
use crate::app::viewport::view::View;
use crate::conformal::Side;
use crate::geometry::DVec2;
use crate::language::Message;
use serde::Serialize;

/// An outline that is being drawn, reshaped or pasted.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EditingStats {
    /// Whose.
    pub side: Side,
    /// Where its handles are, or the points of what is drawn, in CSS pixels of the page.
    pub handles: Vec<[f32; 2]>,
    /// Whether it is being drawn.
    pub draws: bool,
    /// The handle that keys and buttons mean.
    pub selected: Option<usize>,
    /// Where it crosses itself on the screen.
    pub crossing: Option<[f32; 2]>,
    /// What is said about it.
    pub message: Option<String>,
}

/// What is edited.
pub fn stats(editor: &Editor, views: &[View; 2]) -> Option<EditingStats> {
    let pasting = editor.paste.as_ref();
    let side = editor.side().or_else(|| pasting.map(Paste::side))?;
    let place = |at: DVec2| {
        let place = views[side as usize].to_screen(at);
        [place.x, place.y]
    };
    Some(EditingStats {
        side,
        handles: match (editor.reshaping(side), editor.drawing(side)) {
            (Some(reshaping), _) => reshaping.shape().handles().map(place).collect(),
            (None, Some(drawing)) => drawing.points().iter().copied().map(place).collect(),
            (None, None) => Vec::new(),
        },
        draws: editor.drawing(side).is_some(),
        selected: editor.reshaping(side).and_then(|reshaping| reshaping.selected),
        crossing: editor.crossing().and_then(|crossing| crossing.at).map(place),
        message: editor.message().or_else(|| pasting?.error()).map(Message::english),
    })
}
