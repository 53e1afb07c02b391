//! Reports to the sender of a link what it does not hold.

use crate::conformal::Side;
use crate::language::{Message, key};
use crate::session::link::{self, Encoded, MissingOutline};
use crate::session::{Session, SurfaceShape};

/// As [`lacks`], as the report of a link that was copied.
pub fn link_report(session: &Session, encoded: &Encoded, missing: &[MissingOutline]) -> Option<Message> {
    lacks(session, encoded, missing).map(key::link_copied_but)
}

/// What the `encoded` link of `session` does not hold, if anything; `missing`: outlines that were never loaded.
pub fn lacks(session: &Session, encoded: &Encoded, missing: &[MissingOutline]) -> Option<Message> {
    let outlines = encoded.left_out.iter().map(Message::from).chain(encoded.shortened.iter().map(Message::from));
    let missing = missing.iter().map(|outline| key::disk_stands_in(outline.side, &outline.name));
    let surfaces = Side::BOTH.into_iter().filter_map(|side| session.surface(side));
    let surfaces = surfaces.filter_map(|surface| match &surface.spec.shape {
        SurfaceShape::File { name } => Some(key::surface_not_in_link(name)),
        SurfaceShape::Preset { .. } => None,
    });
    let image = session.shows_picture().then(|| key::image_not_in_link().into());
    let all = outlines.chain(missing).chain(surfaces).chain(image);
    Message::joined(all, key::both_clauses)
}

/// The link of `session` if it holds all outlines, perhaps with fewer points, and none is `missing`.
pub fn whole_link(session: &Session, missing: &[MissingOutline]) -> Option<String> {
    let is_whole = |left_out: &[_]| left_out.is_empty() && missing.is_empty();
    let encoded = link::encode(session).ok().filter(|encoded| is_whole(&encoded.left_out))?;
    Some(encoded.fragment)
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::geometry::DVec2;
    use crate::session::{Command, OutlineSpec, SurfaceSpec, TextureKind};

    #[test]
    fn everything_that_is_not_in_the_link_is_named() {
        let mut session = Session::default();
        let encoded = link::encode(&session).unwrap();
        assert_eq!(link_report(&session, &encoded, &[]), None);
        assert_eq!(whole_link(&session, &[]), Some(encoded.fragment));
        let name = String::from("spike");
        let spike =
            [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.31 + 1e-9, 1.0), (0.31, 0.2), (0.31 - 1e-9, 1.0), (0.0, 1.0)];
        let polygon = spike.map(DVec2::from).to_vec().try_into().unwrap();
        session.apply(Command::SetOutline { side: Side::Source, outline: OutlineSpec::points(name, polygon) });
        assert_eq!(whole_link(&session, &[]), None, "a spike finer than a link can tell");
        let shape = SurfaceShape::File { name: "cow.obj".into() };
        session.apply(Command::SetSurface {
            side: Side::Target,
            surface: SurfaceSpec { shape, ..SurfaceSpec::default() },
        });
        session.apply(Command::SetTexture(TextureKind::Image));
        let missing = MissingOutline {
            side: Side::Target,
            name: "long".into(),
            interior: None,
            anchor: 0.0,
            pins: None,
            region: Vec::new(),
        };
        let missing = [missing];
        assert_eq!(whole_link(&Session::default(), &missing), None, "a disk stands in");
        let report = link_report(&session, &link::encode(&session).unwrap(), &missing).unwrap().english();
        for word in ["spike", "cow.obj", "image", "long"] {
            assert!(report.contains(word), "no {word:?} in: {report}");
        }
    }
}
