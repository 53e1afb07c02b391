//! The edited outline as a plain record, for `window.riemap.stats()` and for tests.

use super::Editor;
use super::paste::Paste;
use crate::app::viewport::view::View;
use crate::conformal::{PerSide, Side};
use crate::geometry::DVec2;
use crate::language::Message;
use serde::Serialize;

/// An outline that is being drawn, reshaped or pasted.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EditingStats {
    /// The side of the outline.
    pub side: Side,
    /// The places of its handles, or of the points of a drawing, in CSS pixels of the page.
    pub handles: Vec<[f32; 2]>,
    /// Whether it is being drawn.
    pub draws: bool,
    /// The handle that keys and buttons act on.
    pub selected: Option<usize>,
    /// The place where it crosses itself, in CSS pixels of the page.
    pub crossing: Option<[f32; 2]>,
    /// The message about it, or about a pasted text that is no outline.
    pub message: Option<String>,
}

/// The record of the editor; `None` while no outline is edited.
pub fn stats(editor: &Editor, views: &PerSide<View>) -> Option<EditingStats> {
    let pasting = editor.paste.as_ref();
    let side = editor.side().or_else(|| pasting.map(Paste::side))?;
    let place = |at: DVec2| {
        let place = views[side].to_screen(at);
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
