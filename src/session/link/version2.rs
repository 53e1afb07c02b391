//! The content of a link of version 2: that of version 1 and a list of sections.
//!
//! A section has a number, its length and its bytes, so that a reader that does not know the number can
//! skip to the next one. Each says whether it may be skipped: a link with an unknown section that may not
//! be skipped is refused, since its map would be wrong. Later settings of a [`Session`] become new sections;
//! the encoding of a section never changes once links with it have been sent.
//!
//! | number | content | may be skipped |
//! |---|---|---|
//! | 1 | the surface on the source's side, as `version1` has that of the target's | no |
//! | 2, 3 | the source's, the target's outline with its curve, which version 1 says to be in a file | no |
//! | 4 | the placement of the image, where it is not the default: it changes no map | yes |
//! | 5, 6 | the loop that is the outline of the source's, the target's surface, and whether its holes are painted | no |
//! | 7 | the pins, pairs of fractions; the points of the map through them are in the link too | yes |
//! | 8 | the hyperbolic tiling, and whether it is the pattern; to readers without it that is the conformal grid | yes |
//! | 9 | the painted region: runs of disks or balls of one radius; it changes no map | yes |
//! | 11 | empty: the symmetries of the outlines are shown | yes |
//! | 12 | the four marks of the source's and of the target's outline, where there are any; they change no map | yes |

use super::codes::Coded;
use super::curves::WiredCurve;
use super::version1::{Surface, Version1, WiredOutline};
use super::{Choice, Decoded, LinkError, MissingOutline};
use crate::conformal::{PerSide, Pins, Side};
use crate::geometry::PicturePlacement;
use crate::session::view::KeptTiling;
use crate::session::{OutlineSpec, Session, SurfaceState};
use serde::{Deserialize, Serialize};

/// The number of the section with the source's surface.
const SOURCE_SURFACE: u16 = 1;
/// The sections with the sides' curves.
const CURVES: PerSide<u16> = PerSide::new(2, 3);
/// The section with the placement of the image.
const PICTURE: u16 = 4;
/// The sections with the sides' choices among the boundary loops of a surface.
const LOOPS: PerSide<u16> = PerSide::new(5, 6);

/// The section with the pins.
const PINS: u16 = 7;

/// The section with the tiling.
const TILING: u16 = 8;

/// The section with the painted region.
const REGION: u16 = 9;

/// The section that shows the symmetries.
const SYMMETRIES: u16 = 11;

/// The section with the marks of both sides.
const MARKS: u16 = 12;

/// A session.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Version2 {
    first: Version1,
    sections: Vec<Section>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Section {
    pub number: u16,
    pub may_be_skipped: bool,
    pub content: Vec<u8>,
}

/// Whether the session has something that only version 2 holds.
pub(super) fn is_needed(session: &Session) -> bool {
    session.surface(Side::Source).is_some()
        || session.surface(Side::Target).is_some_and(SurfaceState::chooses_loops)
        || !session.picture().is_default()
        || session.pins().is_some()
        || !session.region().is_empty()
        || session.display.without_tiling().1.is_some()
        || session.symmetries()
        || session.has_marks()
}

impl Version2 {
    /// `session` with `outlines` in place of its own; `None` if it cannot be written.
    pub fn new(
        session: &Session,
        outlines: PerSide<WiredOutline>,
        curves: &PerSide<Option<&WiredCurve>>,
    ) -> Option<Self> {
        let mut sections = Vec::new();
        if let Some(surface) = session.surface(Side::Source) {
            let content = postcard::to_allocvec(&Surface::new(surface)).ok()?;
            sections.push(Section { number: SOURCE_SURFACE, may_be_skipped: false, content });
        }
        for (side, curve) in curves.iter() {
            if let Some(curve) = curve {
                let content = postcard::to_allocvec(curve).ok()?;
                sections.push(Section { number: CURVES[side], may_be_skipped: false, content });
            }
        }
        for (side, number) in LOOPS.iter() {
            if let Some(surface) = session.surface(side).filter(|surface| surface.chooses_loops()) {
                let content = postcard::to_allocvec(&(surface.spec.outline_loop, surface.holes.code())).ok()?;
                sections.push(Section { number: *number, may_be_skipped: false, content });
            }
        }
        if !session.picture().is_default() {
            let content = postcard::to_allocvec(&session.picture()).ok()?;
            sections.push(Section { number: PICTURE, may_be_skipped: true, content });
        }
        if let Some(pins) = session.pins() {
            let pairs: Vec<[f64; 2]> = pins.pairs().iter().map(|pair| pair.into_array()).collect();
            let content = postcard::to_allocvec(&pairs).ok()?;
            sections.push(Section { number: PINS, may_be_skipped: true, content });
        }
        if let (_, Some(tiling)) = session.display.without_tiling() {
            let content = postcard::to_allocvec(&tiling).ok()?;
            sections.push(Section { number: TILING, may_be_skipped: true, content });
        }
        if !session.region().is_empty() {
            let content = postcard::to_allocvec(&super::region::runs(session.region())).ok()?;
            sections.push(Section { number: REGION, may_be_skipped: true, content });
        }
        if session.symmetries() {
            sections.push(Section { number: SYMMETRIES, may_be_skipped: true, content: Vec::new() });
        }
        if session.has_marks() {
            let content = postcard::to_allocvec(&Side::BOTH.map(|side| session.marks(side))).ok()?;
            sections.push(Section { number: MARKS, may_be_skipped: true, content });
        }
        Some(Self { first: Version1::new(session, outlines), sections })
    }

    /// The session. Its outlines are checked, its numbers are not.
    pub fn session(self) -> Result<Decoded, LinkError> {
        let mut decoded = self.first.session()?;
        for Section { number, may_be_skipped, content } in &self.sections {
            match *number {
                SOURCE_SURFACE => {
                    let surface = &mut decoded.session.sides[Side::Source].surface;
                    if surface.is_some() {
                        return Err(LinkError::Damaged); // one section of a number
                    }
                    *surface = Some(super::whole::<Surface>(content)?.state()?);
                }
                PICTURE => decoded.session.display.picture = super::whole::<PicturePlacement>(content)?,
                PINS => {
                    let pairs = super::whole::<Vec<[f64; 2]>>(content)?.into_iter().map(PerSide::from);
                    decoded.session.pins = Some(Pins::new(pairs).map_err(LinkError::Pins)?);
                }
                TILING => decoded.session.display.put_tiling(super::whole::<KeptTiling>(content)?),
                REGION => decoded.session.region = super::region::dabs(super::whole(content)?),
                SYMMETRIES => {
                    super::whole::<()>(content)?;
                    decoded.session.display.symmetries = true;
                }
                MARKS => decoded.session.marks = super::whole::<[Option<[f64; 4]>; 2]>(content)?.into(),
                _ if *number == LOOPS.source => choose_loops(&mut decoded, Side::Source, content)?,
                _ if *number == LOOPS.target => choose_loops(&mut decoded, Side::Target, content)?,
                _ if *number == CURVES.source => place_curve(&mut decoded, Side::Source, content)?,
                _ if *number == CURVES.target => place_curve(&mut decoded, Side::Target, content)?,
                _ if *may_be_skipped => {}
                unknown => return Err(LinkError::Unknown { what: Choice::Setting, name: unknown.to_string() }),
            }
        }
        if !decoded.missing.is_empty() {
            // not on a disk that stands in for an outline
            let pins = decoded.session.pins.take();
            decoded.missing.iter_mut().for_each(|outline| outline.pins.clone_from(&pins));
            let is_painted = |outline: &&mut MissingOutline| outline.side == Side::Source;
            let is_outline = decoded.session.surface(Side::Source).is_none();
            if let Some(source) = decoded.missing.iter_mut().find(is_painted).filter(|_| is_outline) {
                source.region = std::mem::take(&mut decoded.session.region);
            }
        }
        Ok(decoded)
    }

    /// This link with another number for its sections of the number `old`.
    #[cfg(test)]
    pub fn renumbered(mut self, old: u16, new: u16) -> Self {
        self.sections.iter_mut().filter(|section| section.number == old).for_each(|section| section.number = new);
        self
    }

    /// This link with one more section.
    #[cfg(test)]
    pub fn and(mut self, section: Section) -> Self {
        self.sections.push(section);
        self
    }
}

/// Sets which boundary loop of a surface is its outline, and whether its holes are painted. Errors: the side has no
/// surface, as when the section comes before it.
fn choose_loops(decoded: &mut Decoded, side: Side, content: &[u8]) -> Result<(), LinkError> {
    let surface = decoded.session.sides[side].surface.as_mut().ok_or(LinkError::Damaged)?;
    let (outline_loop, holes) = super::whole::<(u16, u8)>(content)?;
    (surface.spec.outline_loop, surface.holes) = (outline_loop, Coded::of(holes)?);
    Ok(())
}

/// Puts an outline with its curve where the link's part of version 1 has a file's name. Errors: there is no such name,
/// as when the section comes twice, or the outline is none.
fn place_curve(decoded: &mut Decoded, side: Side, content: &[u8]) -> Result<(), LinkError> {
    let place = decoded.missing.iter().position(|outline| outline.side == side).ok_or(LinkError::Damaged)?;
    let MissingOutline { name, interior, anchor, .. } = decoded.missing.remove(place);
    let (polygon, form) = super::whole::<WiredCurve>(content)?.outline(side)?;
    let state = &mut decoded.session.sides[side];
    state.domain.outline = OutlineSpec::Points { name, polygon, form };
    (state.interior, state.anchor) = (interior, anchor);
    Ok(())
}
