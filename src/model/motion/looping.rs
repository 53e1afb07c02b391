//! Loops through the family of maps, started at the points of a model.

use crate::conformal::{PerSide, Side};
use crate::family::{Loop, Path, Place, Start};
use crate::model::Model;
use crate::session::Command;

/// The loop along `path` that starts at the model's points; `None` if the map is not complete, or if no point would
/// move.
pub fn begin(model: &Model, path: Path) -> Option<Loop> {
    if !model.is_mapped() {
        return None;
    }
    let map = model.map()?;
    let sides = PerSide::from_fn(|side| Some((map.side(side), model.point(side)?)));
    Loop::new(path, &Start::new(sides.both()?, map.measure(Side::Source)))
}

/// The commands that move a session's points to a place on the loop.
pub fn commands(place: Place) -> impl Iterator<Item = Command> {
    let moved = move |side: Side| {
        let point = place.interior[side]?;
        Some(Command::MoveInterior { side, point: point.into() })
    };
    let turned = place.anchor.map(|fraction| Command::MoveAnchor { side: Side::Source, fraction });
    Side::BOTH.into_iter().filter_map(moved).chain(turned)
}
