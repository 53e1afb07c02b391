//! A side given on the command line, an outline or a surface: reading, preparing and locating its points.

use super::CliError;
use super::discretization::Discretization;
use super::flatten_arguments::{self, ReadSurface, SurfaceAnchor, SurfacePoint, preset};
use super::named_outline::{NamedOutline, read_outline};
use super::output::{say_solver, warn_if_coarse};
use super::progress::Progress;
use super::repair::{RepairArgument, disk};
use super::values::{Anchor, Point};
use crate::conformal::{
    Constraints, InteriorPoint, KernelMode, PrepareSettings, PreparedSide, SideGeometry, Stage, Subdivided,
    SubdivisionError, SurfaceSettings, prepare_quartered, prepare_surface,
};
use crate::geometry::SimplePolygon;
use crate::outline::{self, Interpreted, Preset};
use crate::surface::{SurfacePreset, names_format};
use std::str::FromStr;
use std::sync::Arc;

/// An interior point of a side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SidePoint {
    /// A point inside an outline.
    Plane(Point),
    /// A point of a surface.
    Surface(SurfacePoint),
}

impl FromStr for SidePoint {
    type Err = String;

    /// Two numbers are a point in the plane; anything else is parsed as a point of a surface.
    fn from_str(text: &str) -> Result<Self, String> {
        let planar = text.parse().map(Self::Plane);
        planar.or_else(|_: String| text.parse().map(Self::Surface)).map_err(|_: String| {
            "expected X,Y in an outline, or in a surface a vertex V, F:A,B,C (triangle F with weights that are not \
             negative and not all zero) or X,Y,Z, all finite"
                .to_owned()
        })
    }
}

/// A boundary point of a side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SideAnchor {
    /// At this fraction of the boundary's length.
    Fraction(f64),
    /// A boundary point of an outline.
    Plane(Anchor),
    /// A boundary point of a surface.
    Surface(SurfaceAnchor),
}

impl FromStr for SideAnchor {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse() {
            Ok(Anchor::Fraction(s)) => Ok(Self::Fraction(s)),
            Ok(anchor) => Ok(Self::Plane(anchor)),
            Err(_) => text.parse().map(Self::Surface).map_err(|_: String| {
                "expected vK or X,Y of an outline, a boundary vertex V or X,Y,Z of a surface, or @S with a finite fraction S, \
                 such as @0.25"
                    .to_owned()
            }),
        }
    }
}

/// An interior point as it is written: `[x, y]`, or a surface's triangle (counted after polygons are cut into
/// triangles) with the weights of its corners in the file's order.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(untagged)]
pub enum Place {
    /// In an outline.
    Plane([f64; 2]),
    /// On a surface.
    Surface { triangle: u32, weights: [f64; 3], position: [f64; 3] },
}

/// The constraints of a map as they are written.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Placed {
    source_point: Place,
    target_point: Place,
    /// Fractions of the boundaries' lengths.
    source_anchor: f64,
    target_anchor: f64,
}

impl Placed {
    /// The constraints between these sides.
    pub fn of(
        Constraints { points, anchors, .. }: &Constraints,
        [source, target]: [&NamedSide; 2],
    ) -> Result<Self, CliError> {
        Ok(Self {
            source_point: source.place(points.source)?,
            target_point: target.place(points.target)?,
            source_anchor: anchors.source,
            target_anchor: anchors.target,
        })
    }
}

/// A side as it was read.
pub enum Given {
    /// An outline.
    Outline(NamedOutline),
    /// A surface.
    Surface(ReadSurface),
}

/// A prepared side with its name.
pub struct NamedSide {
    title: String,
    given: Given,
    interpreted: Option<Interpreted>,
    pub prepared: Arc<PreparedSide>,
    /// A surface on finer triangles.
    pub subdivided: Subdivided,
    /// The settings of an outline.
    pub settings: Option<PrepareSettings>,
}

/// The options for reading and preparing sides.
#[derive(Debug, Clone, Copy)]
pub struct Reading<'a> {
    /// The repairs to make.
    pub repair: Option<RepairArgument>,
    /// Whether a surface's edges are flipped to be Delaunay.
    pub intrinsic_delaunay: bool,
    pub discretization: &'a Discretization,
    /// Whether surfaces are computed on finer triangles than their own.
    pub subdivide: bool,
}

impl Reading<'_> {
    /// The settings for surfaces, which are computed with finite elements.
    pub fn surface_settings(&self) -> SurfaceSettings {
        let kernel = match self.discretization.kernel_or(KernelMode::Adjoint) {
            KernelMode::Integral => KernelMode::Adjoint,
            finite => finite,
        };
        let solver = self.discretization.solver_kind();
        SurfaceSettings { intrinsic_delaunay: self.intrinsic_delaunay, kernel, solver }
    }
}

/// A surface on triangles that resolve the map at its vertices, if it is to be: the paper's table, and a surface's own
/// weights, are those of the triangles as given.
pub fn subdivided(
    own: &Arc<PreparedSide>,
    x: InteriorPoint,
    reading: Reading<'_>,
    progress: &mut dyn FnMut(Stage),
) -> Result<Subdivided, SubdivisionError> {
    let settings = reading.surface_settings();
    if !reading.subdivide || !settings.intrinsic_delaunay || settings.kernel != KernelMode::Adjoint {
        return Ok(Subdivided::not(own));
    }
    Subdivided::new(own, x, settings, progress)
}

/// Whether a name means a surface: a surface preset, or a file with a surface format's extension.
pub fn is_surface(name: &str) -> bool {
    preset(name).is_some() || (!name.starts_with("preset:") && names_format(name))
}

/// The arguments about one side. Each point comes with the name of its option, for error messages.
#[derive(Debug, Clone, Copy)]
pub struct Asked<'a> {
    /// The file or preset.
    pub name: &'a str,
    /// What messages call the side: its name, with "source" or "target" where both sides have the same name.
    pub title: &'a str,
    /// The number of boundary samples.
    pub samples: Option<u32>,
    /// The interior point.
    pub point: (&'static str, Option<SidePoint>),
    /// The boundary point.
    pub anchor: (&'static str, SideAnchor),
}

impl Asked<'_> {
    /// Checks that the arguments fit the side's kind, outline or surface.
    pub fn check(&self) -> Result<(), CliError> {
        let is_surface = is_surface(self.name);
        let (point_option, point) = self.point;
        if let (true, Some(SidePoint::Plane(_))) | (false, Some(SidePoint::Surface(_))) = (is_surface, point) {
            return Err(other_point(self.title, is_surface, point_option));
        }
        let (anchor_option, anchor) = self.anchor;
        self.check_anchor(anchor_option, anchor)?;
        if is_surface && self.samples.is_some() {
            return Err(CliError::Usage(format!(
                "{} is a surface: it has its own boundary vertices, and takes no samples",
                self.title
            )));
        }
        Ok(())
    }

    /// Checks that a boundary point given by `option` fits the side's kind.
    pub fn check_anchor(&self, option: &str, anchor: SideAnchor) -> Result<(), CliError> {
        match (is_surface(self.name), anchor) {
            (true, SideAnchor::Plane(Anchor::Vertex(_))) => Ok(()),
            (true, SideAnchor::Plane(_)) => Err(other_anchor(self.title, true, option)),
            (false, SideAnchor::Surface(_)) => Err(other_anchor(self.title, false, option)),
            _ => Ok(()),
        }
    }
}

fn other_point(title: &str, is_surface: bool, option: &str) -> CliError {
    let meant = if is_surface { "a surface: V, F:A,B,C or X,Y,Z" } else { "an outline: X,Y" };
    CliError::Usage(format!("{option}: {title} is {meant} is meant"))
}

fn other_anchor(title: &str, is_surface: bool, option: &str) -> CliError {
    let meant = if is_surface { "a surface: V, X,Y,Z or @S" } else { "an outline: vK, X,Y or @S" };
    CliError::Usage(format!("{option}: {title} is {meant} is meant"))
}

/// Reads the side of this name; a preset that is neither an outline nor a surface is refused with the names of both.
pub fn read(name: &str, how: &outline::Reading) -> Result<Given, CliError> {
    if is_surface(name) {
        return flatten_arguments::read(name).map(Given::Surface);
    }
    let is_unknown = name.strip_prefix("preset:").is_some_and(|preset| Preset::from_str(preset).is_err());
    read_outline(name, how).map(Given::Outline).map_err(|error| match error {
        CliError::Input(text) if is_unknown => {
            let surfaces = SurfacePreset::ALL.map(SurfacePreset::name).join(", ");
            CliError::Input(format!("{text}; surfaces: {surfaces}"))
        }
        other => other,
    })
}

impl NamedSide {
    /// Prepares a side.
    pub fn prepare(
        Asked { title, samples, point, .. }: &Asked<'_>,
        given: Given,
        reading: Reading<'_>,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        let about = |error: &dyn std::fmt::Display| CliError::Input(format!("{title}: {error}"));
        let Reading { repair, discretization, .. } = reading;
        let given = match given {
            Given::Outline(outline) => Given::Outline(outline.interpreted(discretization.interpret)),
            surface @ Given::Surface(_) => surface,
        };
        let mut kept = None;
        let prepared = match &given {
            Given::Surface(ReadSurface { surface, .. }) => {
                let mesh = disk(surface, repair, 0);
                let settings = reading.surface_settings();
                let mesh = mesh.map_err(|error| about(&error))?;
                prepare_surface(mesh, settings, &mut progress.preparing(title)).map_err(|error| about(&error))?
            }
            Given::Outline(outline) => {
                let kernel = discretization.kernel_or(KernelMode::Integral);
                let settings = discretization.settings(outline, *samples).with_kernel(kernel);
                kept = Some(settings);
                let near = match point {
                    (_, Some(SidePoint::Plane(point))) => vec![point.0],
                    _ => Vec::new(),
                };
                let prepared = outline.prepare(&near, &settings, &mut progress.preparing(title));
                prepared.map_err(|error| about(&error))?
            }
        };
        let interpreted = if let Given::Outline(outline) = &given { outline.interpretation(title) } else { None };
        let prepared = Arc::new(prepared);
        let own = Subdivided::not(&prepared);
        let side = Self { title: (*title).to_owned(), given, interpreted, prepared, subdivided: own, settings: kept };
        let x = side.point(point.0, point.1)?;
        let subdivided = subdivided(&side.prepared, x, reading, &mut progress.preparing(title));
        Ok(Self { subdivided: subdivided.map_err(|error| about(&error))?, ..side })
    }

    /// The side on a finer mesh, to compare with; itself if it has the integral equation. `None` with too many samples.
    pub fn finer(&self, reading: Reading<'_>, progress: &Progress) -> Result<Option<Arc<PreparedSide>>, String> {
        let mut progress = progress.preparing(&self.title);
        let finer = match (&self.given, self.prepared.geometry()) {
            _ if self.prepared.curve_boundary().is_some() => return Ok(Some(Arc::clone(&self.prepared))),
            _ if self.subdivided.is_cut() => return Ok(Some(Arc::clone(self.subdivided.finest()))),
            (_, SideGeometry::Space(surface)) => prepare_quartered(surface, reading.surface_settings(), &mut progress)
                .map_err(|error| error.to_string())?,
            (Given::Outline(outline), SideGeometry::Plane(_)) => {
                let finer = self.settings.and_then(|settings| settings.finer(self.prepared.boundary_count()));
                let Some(settings) = finer else { return Ok(None) };
                outline.prepare(&[], &settings, &mut progress).map_err(|error| error.to_string())?
            }
            (Given::Surface(_), SideGeometry::Plane(_)) => return Ok(None),
        };
        Ok(Some(Arc::new(finer)))
    }

    /// Prepares an outline anew for this interior point, if its integral equation does not resolve it; says whether.
    pub fn resolve(&mut self, point: InteriorPoint, progress: &Progress) -> Result<bool, CliError> {
        let (Given::Outline(outline), Some(settings), Some(x)) = (&self.given, self.settings, point.in_plane()) else {
            return Ok(false);
        };
        if self.prepared.equation().is_none_or(|equation| equation.resolves(x)) {
            return Ok(false);
        }
        let prepared = outline.prepare(&[x], &settings, &mut progress.preparing(&self.title));
        let prepared = prepared.map_err(|error| CliError::Input(format!("{}: {error}", self.title)))?;
        self.prepared = Arc::new(prepared);
        self.subdivided = Subdivided::not(&self.prepared);
        Ok(true)
    }

    /// What an outline's points were taken for.
    pub fn interpreted(&self) -> Option<Interpreted> {
        self.interpreted
    }

    /// The polygon of an outline.
    pub fn polygon(&self) -> Option<&SimplePolygon> {
        if let Given::Outline(outline) = &self.given { Some(outline.outline.polygon()) } else { None }
    }

    fn is_surface(&self) -> bool {
        matches!(self.given, Given::Surface(_))
    }

    /// Its interior point, or the default one, and its boundary point as a fraction of the boundary's length.
    pub fn constraint(&self, asked: &Asked<'_>) -> Result<(InteriorPoint, f64), CliError> {
        let ((point_option, point), (anchor_option, anchor)) = (asked.point, asked.anchor);
        Ok((self.point(point_option, point)?, self.anchor(anchor_option, anchor)?))
    }

    /// The interior point given by `option`, or the default one.
    fn point(&self, option: &str, point: Option<SidePoint>) -> Result<InteriorPoint, CliError> {
        match (point, self.prepared.geometry(), &self.given) {
            (None, ..) => Ok(self.prepared.default_point()),
            (Some(SidePoint::Plane(point)), SideGeometry::Plane(_), _) => Ok(point.0.into()),
            (Some(SidePoint::Surface(point)), SideGeometry::Space(surface), Given::Surface(given)) => {
                point.locate(option, &given.surface, surface).map(Into::into)
            }
            (Some(_), ..) => Err(other_point(&self.title, self.is_surface(), option)),
        }
    }

    /// An interior point of this side as it is written in summaries.
    pub fn place(&self, point: InteriorPoint) -> Result<Place, CliError> {
        match (point, self.prepared.geometry(), &self.given) {
            (InteriorPoint::Plane(x), ..) => Ok(Place::Plane(x.to_array())),
            (InteriorPoint::Surface(point), SideGeometry::Space(meshed), Given::Surface(given)) => {
                let disk = meshed.surface();
                let weights = disk.weights_in(&given.surface, point);
                let triangle = disk.triangle_origins()[point.triangle().index()];
                Ok(Place::Surface { triangle, weights, position: meshed.position(point).to_array() })
            }
            (InteriorPoint::Surface(_), ..) => Err(CliError::Input(format!("{} is no surface", self.title))),
        }
    }

    /// The surface as it was read; `None` of an outline.
    pub fn into_surface(self) -> Option<ReadSurface> {
        if let Given::Surface(read) = self.given { Some(read) } else { None }
    }

    /// The outline; `None` of a surface.
    pub fn outline(&self) -> Option<&outline::Outline> {
        if let Given::Outline(named) = &self.given { Some(&named.outline) } else { None }
    }

    /// The fraction of the boundary's length given by `option`.
    pub fn anchor(&self, option: &str, anchor: SideAnchor) -> Result<f64, CliError> {
        match (anchor, self.prepared.geometry(), &self.given) {
            (SideAnchor::Fraction(s), ..) => Ok(s.rem_euclid(1.0)),
            (SideAnchor::Plane(anchor), SideGeometry::Plane(domain), Given::Outline(outline)) => {
                anchor.fraction(domain, self.prepared.curve_boundary().map(Arc::as_ref), &outline.vertices)
            }
            (SideAnchor::Plane(Anchor::Vertex(vertex)), SideGeometry::Space(surface), Given::Surface(given)) => {
                SurfaceAnchor::Vertex(vertex).fraction(option, &given.surface, surface)
            }
            (SideAnchor::Surface(anchor), SideGeometry::Space(surface), Given::Surface(given)) => {
                anchor.fraction(option, &given.surface, surface)
            }
            (SideAnchor::Plane(_) | SideAnchor::Surface(_), ..) => {
                Err(other_anchor(&self.title, self.is_surface(), option))
            }
        }
    }

    /// Reports on stderr what was changed while reading and how the side was prepared.
    pub fn say_notes(&self, discretization: &Discretization) {
        match &self.given {
            Given::Outline(outline) => outline.say_notes(&self.title),
            Given::Surface(ReadSurface { surface, .. }) => {
                let repairs = self.prepared.surface().into_iter().flat_map(|meshed| meshed.surface().repairs());
                let notes = surface.notes().iter().map(ToString::to_string).chain(repairs.map(ToString::to_string));
                notes.for_each(|note| eprintln!("riemap: {}: {note}", self.title));
            }
        }
        warn_if_coarse(&self.title, &self.prepared);
        say_solver(&self.title, discretization.solver_kind(), self.prepared.solver_kind());
    }
}
