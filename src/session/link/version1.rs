//! The content of a link of version 1 in postcard's encoding: the values of the fields in order, without names.
//!
//! Frozen: a field that is moved, added or removed would change the meaning of every link of version 1.
//! Later settings of a [`Session`] are stored in the sections of `version2`; for links of version 1 they
//! have their defaults. Presets are stored by name and other enum values by the numbers of `codes`, so
//! that values can be added.
//!
//! Interior points, anchors and weights are f64: they are a small part of the bytes, the decoded
//! session equals the encoded one, and in a crowded domain the map depends on every digit.

use super::codes::Coded;
use super::quantized::Quantized;
use super::{Choice, Decoded, LinkError, MissingOutline};
use crate::conformal::{PerSide, PrepareSettings, Side, SurfaceSettings};
use crate::geometry::{DVec2, PicturePlacement, SimplePolygon};
use crate::mesh::{BarycentricPoint, Sizing, TriangleId};
use crate::outline::{CurveForm, Preset, Sampling};
use crate::session::view::Display;
use crate::session::{DomainSpec, OutlineSpec, Session, SideState, SurfaceShape, SurfaceSpec, SurfaceState};
use crate::tiling::TilingPattern;
use serde::{Deserialize, Serialize};

/// The outline used in place of one that the link does not hold.
pub(super) const STAND_IN: Preset = Preset::Disk;

/// The maximal number of characters of a name.
const MAX_NAME: usize = 48;

/// A session.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Version1 {
    domains: [Domain; 2],
    interior: [Option<[f64; 2]>; 2],
    anchor: [f64; 2],
    direction: u8,
    extension: u8,
    texture: u8,
    texture_scale: f64,
    texture_side: u8,
    colouring: u8,
    wireframe: bool,
    plots: bool,
    comparison: u8,
    surface: Option<Surface>,
    later: Vec<Later>,
}

/// A place for settings added after the format was frozen; always empty.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Later {
    code: u16,
    value: Vec<u8>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Domain {
    outline: WiredOutline,
    sampling: WiredSampling,
    sizing: WiredSizing,
    kernel: u8,
    solver: u8,
}

/// An outline. Here and below, the order of the variants is part of the format.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) enum WiredOutline {
    /// A preset, by name.
    Preset(String),
    /// A loaded outline with its points.
    Points { name: String, points: Quantized },
    /// An outline that must be loaded from a file.
    File { name: String },
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum WiredSampling {
    Adaptive(Option<u32>),
    Uniform { count: u32, keep_corners: bool },
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum WiredSizing {
    Uniform,
    Graded(f64),
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Surface {
    shape: Shape,
    repair: bool,
    intrinsic_delaunay: bool,
    kernel: u8,
    solver: u8,
    point: Option<(u32, [f64; 3])>,
    anchor: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
enum Shape {
    Preset { name: String, boundary: u32 },
    File { name: String },
}

impl Version1 {
    /// `session` with `outlines` in place of its own, and without a surface on the source's side.
    pub fn new(session: &Session, outlines: PerSide<WiredOutline>) -> Self {
        // Destructured, so that the compiler reports a new field that is not handled here.
        let Session {
            sides: PerSide { source, target },
            display:
                Display {
                    direction,
                    extension,
                    texture,
                    texture_scale,
                    texture_side,
                    colouring,
                    wireframe,
                    plots,
                    comparison,
                    picture: _,    // in a section of version 2
                    tiling: _,     // the same
                    symmetries: _, // the same
                },
            pins: _,   // a section of version 2
            region: _, // the same
            marks: _,  // the same
        } = session;
        let sides = [source, target];
        Self {
            domains: [
                Domain::new(outlines.source, source.domain.settings),
                Domain::new(outlines.target, target.domain.settings),
            ],
            interior: sides.map(|side| side.interior.map(|p| p.to_array())),
            anchor: sides.map(|side| side.anchor),
            direction: direction.code(),
            extension: extension.code(),
            texture: texture.code(),
            texture_scale: *texture_scale,
            texture_side: texture_side.code(),
            colouring: colouring.code(),
            wireframe: *wireframe,
            plots: *plots,
            comparison: comparison.code(),
            surface: target.surface.as_ref().map(Surface::new),
            later: Vec::new(),
        }
    }

    /// The session. Its outlines are checked, its numbers are not.
    pub fn session(self) -> Result<Decoded, LinkError> {
        if let Some(later) = self.later.first() {
            return Err(LinkError::Unknown { what: Choice::Setting, name: later.code.to_string() });
        }
        let (interiors, anchors) = (PerSide::from(self.interior), PerSide::from(self.anchor));
        let mut missing = Vec::new();
        let mut side = |side: Side, wired: Domain, surface: Option<Surface>| -> Result<SideState, LinkError> {
            let settings = wired.settings()?;
            let (interior, anchor) = (interiors[side].map(DVec2::from_array), anchors[side]);
            let (outline, interior, anchor) = match wired.outline {
                WiredOutline::Preset(name) => (preset(&name)?, interior, anchor),
                WiredOutline::Points { name, points } => (with_points(side, name, &points)?, interior, anchor),
                WiredOutline::File { name } => {
                    missing.push(MissingOutline {
                        side,
                        name: checked_name(name)?,
                        interior,
                        anchor,
                        pins: None,
                        region: Vec::new(),
                    });
                    (OutlineSpec::Preset(STAND_IN), None, 0.0)
                }
            };
            let surface = surface.map(Surface::state).transpose()?;
            Ok(SideState { domain: DomainSpec { outline, settings }, interior, anchor, surface })
        };
        let [source, target] = self.domains;
        let session = Session {
            sides: PerSide::new(side(Side::Source, source, None)?, side(Side::Target, target, self.surface)?),
            display: Display {
                direction: Coded::of(self.direction)?,
                extension: Coded::of(self.extension)?,
                texture: Coded::of(self.texture)?,
                texture_scale: self.texture_scale,
                texture_side: Coded::of(self.texture_side)?,
                tiling: TilingPattern::default(),
                colouring: Coded::of(self.colouring)?,
                wireframe: self.wireframe,
                plots: self.plots,
                comparison: Coded::of(self.comparison)?,
                symmetries: false,
                picture: PicturePlacement::default(),
            },
            pins: None,
            region: Vec::new(),
            marks: PerSide::default(),
        };
        Ok(Decoded { session, missing })
    }
}

impl Domain {
    fn new(outline: WiredOutline, settings: PrepareSettings) -> Self {
        let PrepareSettings { sampling, sizing, kernel, solver } = settings;
        let sampling = match sampling {
            Sampling::Adaptive { target } => WiredSampling::Adaptive(target),
            Sampling::Uniform { count, keep_corners } => WiredSampling::Uniform { count, keep_corners },
        };
        let sizing = match sizing {
            Sizing::Uniform => WiredSizing::Uniform,
            Sizing::Graded(growth) => WiredSizing::Graded(growth),
        };
        Self { outline, sampling, sizing, kernel: kernel.code(), solver: solver.code() }
    }

    fn settings(&self) -> Result<PrepareSettings, LinkError> {
        let sampling = match self.sampling {
            WiredSampling::Adaptive(target) => Sampling::Adaptive { target },
            WiredSampling::Uniform { count, keep_corners } => Sampling::Uniform { count, keep_corners },
        };
        let sizing = match self.sizing {
            WiredSizing::Uniform => Sizing::Uniform,
            WiredSizing::Graded(growth) => Sizing::Graded(growth),
        };
        Ok(PrepareSettings { sampling, sizing, kernel: Coded::of(self.kernel)?, solver: Coded::of(self.solver)? })
    }
}

fn preset(name: &str) -> Result<OutlineSpec, LinkError> {
    let unknown = |_| LinkError::Unknown { what: Choice::Outline, name: short_name(name) };
    name.parse().map(OutlineSpec::Preset).map_err(unknown)
}

fn with_points(side: Side, name: String, points: &Quantized) -> Result<OutlineSpec, LinkError> {
    let polygon = SimplePolygon::try_from(points.points()).map_err(|reason| LinkError::Outline { side, reason })?;
    let form = CurveForm::of_polygon(&polygon);
    Ok(OutlineSpec::Points { name: checked_name(name)?, polygon, form })
}

impl Surface {
    pub fn new(state: &SurfaceState) -> Self {
        let SurfaceState { spec, point, anchor, .. } = state;
        let SurfaceSpec { shape, repair, settings, .. } = spec;
        let SurfaceSettings { intrinsic_delaunay, kernel, solver } = *settings;
        let shape = match shape {
            SurfaceShape::Preset { preset, boundary } => {
                Shape::Preset { name: preset.name().to_owned(), boundary: *boundary }
            }
            SurfaceShape::File { name } => Shape::File { name: short_name(name) },
        };
        Self {
            shape,
            repair: *repair,
            intrinsic_delaunay,
            kernel: kernel.code(),
            solver: solver.code(),
            point: point.map(|point| (point.triangle().number(), point.weights())),
            anchor: *anchor,
        }
    }

    pub fn state(self) -> Result<SurfaceState, LinkError> {
        let shape = match self.shape {
            Shape::Preset { name, boundary } => {
                let unknown = |_| LinkError::Unknown { what: Choice::Surface, name: short_name(&name) };
                SurfaceShape::Preset { preset: name.parse().map_err(unknown)?, boundary }
            }
            Shape::File { name } => SurfaceShape::File { name: checked_name(name)? },
        };
        let settings = SurfaceSettings {
            intrinsic_delaunay: self.intrinsic_delaunay,
            kernel: Coded::of(self.kernel)?,
            solver: Coded::of(self.solver)?,
        };
        let point = self.point.map(|(triangle, weights)| BarycentricPoint::new(TriangleId::new(triangle), weights));
        let spec = SurfaceSpec::new(shape).with_repair(self.repair).with_settings(settings);
        Ok(SurfaceState { point, anchor: self.anchor, ..SurfaceState::new(spec) })
    }
}

/// The first [`MAX_NAME`] characters of a name, without control characters, which a terminal or page could execute.
pub(super) fn short_name(name: &str) -> String {
    name.chars().filter(|c| !c.is_control()).take(MAX_NAME).collect()
}

/// Accepts only names that [`short_name`] leaves unchanged.
fn checked_name(name: String) -> Result<String, LinkError> {
    if short_name(&name) == name { Ok(name) } else { Err(LinkError::Damaged) }
}
