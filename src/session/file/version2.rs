//! File format 2: each side has its outline, its points, and optionally a surface. Later versions of the program may
//! add fields with a default; readers skip unknown fields.

use super::{FileError, OutlineForm};
use crate::conformal::{Direction, Extension, PerSide, Pins, PrepareSettings, Side};
use crate::geometry::{DVec2, PicturePlacement};
use crate::optimization::Dab;
use crate::session::limits::{Quantity, within};
use crate::session::view::{Display, KeptTiling};
use crate::session::{Colouring, Comparison, DomainSpec, Session, SideState, SurfaceState, TextureKind};
use crate::tiling::TilingPattern;
use serde::{Deserialize, Serialize};

/// A session as written.
#[derive(Serialize)]
pub(super) struct Written<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    riemap: Option<u32>,
    version: u32,
    source: WrittenSide<'a>,
    target: WrittenSide<'a>,
    #[serde(flatten)]
    display: Display,
    #[serde(skip_serializing_if = "Option::is_none")]
    pins: Option<&'a [PerSide<f64>]>,
    #[serde(skip_serializing_if = "<[Dab]>::is_empty")]
    region: &'a [Dab],
    #[serde(skip_serializing_if = "Option::is_none")]
    tiling: Option<KeptTiling>,
}

#[derive(Serialize)]
struct WrittenSide<'a> {
    #[serde(flatten)]
    domain: &'a DomainSpec,
    interior: Option<DVec2>,
    anchor: f64,
    surface: Option<&'a SurfaceState>,
    #[serde(skip_serializing_if = "Option::is_none")]
    marks: Option<[f64; 4]>,
}

impl<'a> Written<'a> {
    pub fn new(session: &'a Session, is_file: bool) -> Self {
        let side = |side| {
            let SideState { domain, interior, anchor, surface } = session.side(side);
            let (marks, surface) = (session.marks(side), surface.as_ref());
            WrittenSide { domain, interior: *interior, anchor: *anchor, surface, marks }
        };
        let (source, target) = (side(Side::Source), side(Side::Target));
        let pins = session.pins().map(Pins::pairs);
        let ((display, tiling), region) = (session.display.without_tiling(), session.region());
        Self { riemap: is_file.then_some(2), version: 2, source, target, display, pins, region, tiling }
    }
}

/// A session as read.
#[derive(Deserialize)]
pub(super) struct Version2 {
    version: u32,
    source: SideForm,
    target: SideForm,
    direction: Direction,
    extension: Extension,
    texture: TextureKind,
    texture_scale: f64,
    texture_side: Side,
    colouring: Colouring,
    wireframe: bool,
    plots: bool,
    comparison: Comparison,
    #[serde(flatten)]
    added: Added,
    pins: Option<Vec<PerSide<f64>>>,
}

/// What the first files of this version do not hold.
#[derive(Deserialize)]
struct Added {
    #[serde(default)]
    symmetries: bool,
    #[serde(default)]
    picture: PicturePlacement,
    #[serde(default)]
    region: Vec<Dab>,
    tiling: Option<KeptTiling>,
}

#[derive(Deserialize)]
struct SideForm {
    outline: OutlineForm,
    settings: PrepareSettings,
    interior: Option<DVec2>,
    anchor: f64,
    surface: Option<SurfaceState>,
    marks: Option<[f64; 4]>,
}

impl SideForm {
    fn checked(self, side: Side) -> Result<SideState, FileError> {
        let Self { outline, settings, interior, anchor, surface, marks: _ } = self;
        Ok(SideState { domain: DomainSpec { outline: outline.checked(side)?, settings }, interior, anchor, surface })
    }
}

impl TryFrom<Version2> for Session {
    type Error = FileError;

    fn try_from(form: Version2) -> Result<Self, FileError> {
        within(Quantity::Version, f64::from(form.version), &(2.0..=2.0))?;
        let pins = form.pins.map(Pins::new).transpose().map_err(FileError::Pins)?;
        let mut session = Self {
            pins,
            marks: PerSide::new(form.source.marks, form.target.marks),
            region: form.added.region.into_iter().map(Dab::rounded).collect(),
            sides: PerSide::new(form.source.checked(Side::Source)?, form.target.checked(Side::Target)?),
            display: Display {
                direction: form.direction,
                extension: form.extension,
                texture: form.texture,
                texture_scale: form.texture_scale,
                texture_side: form.texture_side,
                colouring: form.colouring,
                wireframe: form.wireframe,
                plots: form.plots,
                comparison: form.comparison,
                symmetries: form.added.symmetries,
                picture: form.added.picture,
                tiling: TilingPattern::default(),
            },
        };
        if let Some(tiling) = form.added.tiling {
            session.display.put_tiling(tiling);
        }
        Ok(session)
    }
}
