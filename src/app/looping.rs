//! Closed ways through the family of maps, from the points of a model.

use super::model::Model;
use crate::conformal::Side;
use crate::family::{Loop, Path, Place, Start};
use crate::session::Command;

/// The loop along `path` that begins at the model's points; `None` while its map is not complete, and where nothing
/// would move.
pub fn begin(model: &Model, path: Path) -> Option<Loop> {
    if !model.is_ready() {
        return None;
    }
    let source = (model.domain(Side::Source)?, model.interior(Side::Source)?);
    let start = if let Some(map) = model.surface_map() {
        Start { source, measure: map.source_measure(), target: None }
    } else {
        let target = (model.domain(Side::Target)?, model.interior(Side::Target)?);
        Start { source, measure: model.map()?.measure(Side::Source), target: Some(target) }
    };
    Loop::new(path, &start)
}

/// What brings a session's points to a place.
pub fn commands(place: Place) -> impl Iterator<Item = Command> {
    let moved = move |side: Side| {
        let point = place.interior[side as usize]?;
        Some(Command::MoveInterior { side, point })
    };
    let turned = place.anchor.map(|fraction| Command::MoveAnchor { side: Side::Source, fraction });
    Side::BOTH.into_iter().filter_map(moved).chain(turned)
}
