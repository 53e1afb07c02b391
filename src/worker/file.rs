//! Files that a worker reads: outlines and sessions, and why there is none in a file.
//!
//! What has been read keeps its proof: an [`Outline`]'s polygon is checked here and not again. To the page it crosses
//! as flat arrays ([`FlatOutline`], [`FlatSession`]).

use crate::conformal::{PerSide, Side};
use crate::geometry::{DVec2, SimplePolygon};
use crate::language::Message;
use crate::outline::{Outline, parse, parse_repaired};
use crate::session::{Command, OutlineSpec, Session, SidePoints, file};
use std::sync::Arc;

/// A file's name and its content.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedFile {
    /// Its name; for an outline it says the format, and for a surface too.
    pub name: String,
    /// Its content.
    pub bytes: Arc<Vec<u8>>,
}

/// Why a file holds nothing that can be used.
#[derive(Debug, Clone, PartialEq)]
pub struct Unread {
    /// In words for the person.
    pub text: Message,
    /// The outline that safe repairs make of it.
    pub repaired: Option<Box<Outline>>,
}

impl NamedFile {
    /// The outline that is in it, or what it would be once repaired.
    pub fn outline(&self) -> Result<Outline, Unread> {
        parse(&self.name, &self.bytes).map_err(|error| Unread {
            text: Message::from(&error),
            repaired: parse_repaired(&self.name, &self.bytes).ok().map(Box::new),
        })
    }

    /// The session that is in it.
    pub fn session(&self) -> Result<Session, Unread> {
        file::read(&self.bytes).map_err(|error| Unread { text: Message::from(&error), repaired: None })
    }
}

/// An outline on its way from a worker: its points as they lie in memory, the rest as JSON.
#[derive(Debug, Clone, PartialEq)]
pub struct FlatOutline {
    /// The coordinates of the vertices, in turn.
    pub points: Vec<f64>,
    /// Name and notes.
    pub text: String,
}

impl From<&Outline> for FlatOutline {
    fn from(Outline { name, polygon, notes }: &Outline) -> Self {
        // plain data: it always has a form as text
        let text = serde_json::to_string(&(name, notes)).unwrap_or_default();
        Self { points: polygon.vertices().iter().flat_map(DVec2::to_array).collect(), text }
    }
}

impl FlatOutline {
    /// The outline; `None` if the text is not what [`Self::from`] makes. The points are taken for those of a simple
    /// polygon: that was checked where they were read.
    pub fn outline(&self) -> Option<Outline> {
        let (name, notes) = serde_json::from_str(&self.text).ok()?;
        let polygon = SimplePolygon::known_simple(self.points.chunks_exact(2).map(DVec2::from_slice).collect());
        Some(Outline { name, polygon, notes })
    }
}

/// A session on its way from a worker: its loaded outlines flat, the rest as JSON, in which presets stand in for them.
#[derive(Debug, Clone, PartialEq)]
pub struct FlatSession {
    /// The outlines that were loaded.
    pub outlines: PerSide<Option<FlatOutline>>,
    /// All else.
    pub text: String,
}

impl FlatSession {
    /// Of a session that was read from a file; `None` if that is not one that can be written.
    pub fn of(session: &Session) -> Option<Self> {
        let mut light = session.clone();
        let outlines = PerSide::from_fn(|side| {
            let OutlineSpec::Points { name, polygon } = session.domain(side).outline.clone() else { return None };
            light.apply(reshaped(session, side, OutlineSpec::Preset(crate::outline::Preset::Disk)));
            Some(FlatOutline::from(&Outline { name, polygon, notes: Vec::new() }))
        });
        Some(Self { outlines, text: file::write_object(&light).ok()? })
    }

    /// The session; `None` if it is not what [`Self::of`] makes.
    pub fn session(&self) -> Option<Session> {
        let mut session = file::read_object(&self.text).ok()?;
        for (side, outline) in self.outlines.iter() {
            if let Some(outline) = outline {
                let command = reshaped(&session, side, outline.outline()?.into());
                session.apply(command);
            }
        }
        Some(session)
    }
}

/// Puts another outline on a side of a session, and leaves points and surface as they are.
fn reshaped(session: &Session, side: Side, outline: OutlineSpec) -> Command {
    let points = session.side(side).outline_points();
    let interior = if let SidePoints::Outline { interior, .. } = points { interior } else { None };
    Command::ReshapeOutline { side, outline, interior, anchor: points.anchor() }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::Direction;
    use crate::session::SurfaceSpec;

    fn named(name: &str, text: &str) -> NamedFile {
        NamedFile { name: name.into(), bytes: Arc::new(text.into()) }
    }

    #[test]
    fn an_outline_crosses_as_it_was_read_with_its_notes() {
        let outline = named("a.csv", "0,0\n0,2\n2,2\n2,0\n0,0\n").outline().unwrap();
        assert!(outline.notes.len() == 2, "reversed and closed: {:?}", outline.notes);
        assert_eq!(FlatOutline::from(&outline).outline().unwrap(), outline);
        assert_eq!(FlatOutline { points: Vec::new(), text: "{".into() }.outline(), None);
    }

    #[test]
    fn a_spike_can_be_cut_off_and_a_crossing_cannot() {
        let spike = named("a.json", "[[0,0],[2,0],[2,1],[3,1],[2,1],[2,2],[0,2]]").outline().unwrap_err();
        assert_eq!(spike.repaired.unwrap().name, "a");
        // which part is meant is not for a machine to say
        assert_eq!(named("a.json", "[[0,0],[2,2],[2,0],[0,3]]").outline().unwrap_err().repaired, None);
    }

    #[test]
    fn a_session_crosses_bit_for_bit_with_its_loaded_outlines_points_and_surface() {
        let outline = named("a.csv", "0,0\n0.1,0\n0.3,0.7\n").outline().unwrap();
        let session = Session::with([
            Command::SetOutline { side: Side::Target, outline: outline.into() },
            Command::MoveInterior { side: Side::Target, point: DVec2::new(0.13, 1.0 / 7.0).into() },
            Command::MoveAnchor { side: Side::Target, fraction: 1.0 / 3.0 },
            Command::SetSurface { side: Side::Target, surface: SurfaceSpec::default() },
            Command::MoveAnchor { side: Side::Target, fraction: 0.7 },
            Command::SetDirection(Direction::Forward),
        ]);
        let flat = FlatSession::of(&session).unwrap();
        assert!(flat.outlines[Side::Source].is_none() && flat.outlines[Side::Target].is_some());
        assert_eq!(flat.session().unwrap(), session);
        let file = named("a.riemap", &file::write(&session).unwrap());
        assert_eq!(file.session().unwrap(), session);
        assert!(named("a.riemap", "{}").session().is_err());
    }
}
