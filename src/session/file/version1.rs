//! File format 1, frozen: a session with at most one surface, on the target's side; loaded outlines are polygons.

use super::{FileError, OutlineForm};
use crate::conformal::{Direction, Extension, PerSide, PrepareSettings, Side};
use crate::geometry::{DVec2, PicturePlacement};
use crate::session::limits::{Quantity, within};
use crate::session::view::Display;
use crate::session::{Colouring, Comparison, DomainSpec, Session, SideState, SurfaceState, TextureKind};
use crate::tiling::TilingPattern;
use serde::{Deserialize, Serialize};

/// Whether the format can hold the session.
pub(super) fn holds(session: &Session) -> bool {
    session.surface(Side::Source).is_none()
        && !session.surface(Side::Target).is_some_and(SurfaceState::chooses_loops)
        && session.picture().is_default()
        && !session.symmetries()
        && session.pins().is_none()
        && session.region().is_empty()
        && !session.has_marks()
        && session.display.without_tiling().1.is_none()
        && Side::BOTH.iter().all(|&side| session.domain(side).outline.is_only_polygon())
}

/// A session as written.
#[derive(Serialize)]
pub(super) struct Written<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    riemap: Option<u32>,
    version: u32,
    source: &'a DomainSpec,
    target: &'a DomainSpec,
    interior: [Option<DVec2>; 2],
    anchor: [f64; 2],
    #[serde(flatten)]
    display: Display,
    surface: Option<&'a SurfaceState>,
}

impl<'a> Written<'a> {
    pub fn new(session: &'a Session, is_file: bool) -> Self {
        let PerSide { source, target } = session.sides();
        Self {
            riemap: is_file.then_some(1),
            version: 1,
            source: &source.domain,
            target: &target.domain,
            interior: [source.interior, target.interior],
            anchor: [source.anchor, target.anchor],
            display: session.display,
            surface: target.surface.as_ref(),
        }
    }
}

/// A session as read.
#[derive(Deserialize)]
pub(super) struct Version1 {
    version: u32,
    source: DomainForm,
    target: DomainForm,
    interior: [Option<DVec2>; 2],
    anchor: [f64; 2],
    direction: Direction,
    extension: Extension,
    texture: TextureKind,
    texture_scale: f64,
    #[serde(default = "source")]
    texture_side: Side,
    #[serde(flatten)]
    added: Added,
    #[serde(default)]
    surface: Option<SurfaceState>,
}

/// What the first files of this version do not hold.
#[derive(Deserialize)]
struct Added {
    #[serde(default)]
    colouring: Colouring,
    #[serde(default)]
    wireframe: bool,
    #[serde(default)]
    plots: bool,
    #[serde(default)]
    comparison: Comparison,
    #[serde(default)]
    picture: PicturePlacement,
}

#[derive(Deserialize)]
struct DomainForm {
    outline: OutlineForm,
    settings: PrepareSettings,
}

fn source() -> Side {
    Side::Source
}

impl TryFrom<Version1> for Session {
    type Error = FileError;

    fn try_from(form: Version1) -> Result<Self, FileError> {
        within(Quantity::Version, f64::from(form.version), &(1.0..=1.0))?;
        let (interiors, anchors) = (PerSide::from(form.interior), PerSide::from(form.anchor));
        let side = |side: Side, DomainForm { outline, settings }: DomainForm, surface| {
            let domain = DomainSpec { outline: outline.checked(side)?, settings };
            let (interior, anchor) = (interiors[side], anchors[side]);
            Ok::<_, FileError>(SideState { domain, interior, anchor, surface })
        };
        Ok(Self {
            sides: PerSide::new(side(Side::Source, form.source, None)?, side(Side::Target, form.target, form.surface)?),
            display: Display {
                direction: form.direction,
                extension: form.extension,
                texture: form.texture,
                texture_scale: form.texture_scale,
                texture_side: form.texture_side,
                colouring: form.added.colouring,
                wireframe: form.added.wireframe,
                plots: form.added.plots,
                comparison: form.added.comparison,
                symmetries: false, // since format 2
                picture: form.added.picture,
                tiling: TilingPattern::default(),
            },
            pins: None,
            region: Vec::new(),
            marks: PerSide::default(),
        })
    }
}
