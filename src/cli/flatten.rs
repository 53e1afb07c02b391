//! `riemap flatten`: parameterizes a surface over an outline and writes it with texture coordinates.

use super::corners::Corners;
use super::flatten_arguments::{CornersArgument, FlattenArguments, SurfacePoint, UvArgument, read};
use super::named_outline::{NamedOutline, read_outline};
use super::optimization::{Optimized, optimized};
use super::output::{check_paths, edges_flipped, print, quality_in_words, say_solver, words, write_all};
use super::progress::Progress;
use super::repair::disk;
use super::side::{Asked, Given, NamedSide, Reading, SideAnchor, SidePoint, subdivided};
use super::tables::Counts;
use super::{CliError, flatten_pins, surface_picture};
use crate::conformal::{
    ConformalMap, Constraints, CornerCuts, FrameTimings, MapError, MapSettings, MeshedSurface, PerSide, PrepareTimings,
    PreparedSide, Quality, Side, Subdivided, prepare_surface,
};
use crate::export::{EncodedSurface, FileFormat, Flattened, Placement};
use crate::laplace::SolverKind;
use crate::mesh::{BarycentricPoint, FlipReport};
use crate::optimization::Criterion;
use crate::outline::Interpreted;
use crate::surface::{Surface, SurfaceMesh};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Durations of the stages in milliseconds.
#[derive(Debug, Clone, Copy, Default, serde::Serialize)]
struct Timings {
    /// Reading the surface's file.
    read: f64,
    /// Checking and repairing its connectivity.
    check: f64,
    surface: PrepareTimings,
    outline: PrepareTimings,
    #[serde(flatten)]
    frame: FrameTimings,
}

/// What `--json` prints.
#[derive(Debug, serde::Serialize)]
struct Summary {
    quality: Quality,
    counts: Counts,
    flips: FlipReport,
    repairs: Vec<String>,
    notes: Vec<String>,
    surface_point: Point,
    surface_anchor: f64,
    /// The search for the best map, and what came out in the outline, if it was asked for.
    #[serde(flatten)]
    best: Option<Best>,
    /// The pins, if they determine the map.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pins: Vec<flatten_pins::Pin>,
    uv: Placement,
    /// The outline's corners, if it has any and they were not switched off.
    corners: Option<Corners>,
    /// What the outline's points were taken for.
    interpretation: Option<Interpreted>,
    timing_ms: Timings,
}

/// The search for the best map, and its points in the outline.
#[derive(Debug, Clone, serde::Serialize)]
struct Best {
    optimised: Optimized,
    outline_point: Option<[f64; 2]>,
    outline_anchor: f64,
}

/// A point of the surface: a triangle, counted after polygons are cut into triangles, and barycentric weights.
#[derive(Debug, serde::Serialize)]
struct Point {
    triangle: u32,
    weights: [f64; 3],
    position: [f64; 3],
}

/// The formats of the output files.
#[derive(Debug, Clone, Copy)]
enum Format {
    /// The surface or its layout in the plane.
    Surface(FileFormat),
    /// A PNG of surface and outline.
    Picture,
}

fn format_of(path: &Path) -> Result<Format, CliError> {
    let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    let picture = extension.eq_ignore_ascii_case("png").then_some(Format::Picture);
    picture.or(FileFormat::from_extension(extension).map(Format::Surface)).ok_or_else(|| {
        let path = path.display();
        CliError::Usage(format!("--out {path}: the extension must be obj, ply, glb, csv, svg or png"))
    })
}

/// Computes the parameterization and writes the requested files.
pub fn run(arguments: &FlattenArguments) -> Result<(), CliError> {
    let formats = arguments.out.iter().map(|path| format_of(path)).collect::<Result<Vec<_>, _>>()?;
    check_paths(&arguments.out)?;
    let progress = Progress::new(format!("reading {}", arguments.surface));
    let (surface, read) = timed(|| read(&arguments.surface));
    let given = surface?;
    let surface = &given.surface;
    let (whole, timings) = compute(arguments, surface, &progress)?;
    progress.enter("writing");
    let map = &whole.map;
    let unit = arguments.layout.uv == UvArgument::Unit;
    let cuts = whole.cuts.as_ref();
    let flattened = match cuts {
        Some(cuts) => Flattened::cut(map, cuts, unit),
        None => Flattened::new(map, unit),
    };
    let flattened = flattened.ok_or_else(no_surface)?;
    let (mut files, mut bare) = (Vec::new(), Vec::new());
    for (path, format) in arguments.out.iter().zip(formats) {
        let bytes = match format {
            Format::Surface(format) => {
                let EncodedSurface { bytes, is_bare } = flattened.encode_as_read(format, given.source());
                bare.extend(is_bare.then(|| format!("{}: {BARE}", path.display())));
                bytes
            }
            Format::Picture => {
                let given = (&whole.constraints, PerSide::new(&[][..], &[][..]));
                surface_picture::png(&arguments.surface, map, cuts, given, false, arguments.size.0)?
            }
        };
        files.push((path.clone(), bytes));
    }
    write_all(&files)?;
    drop(progress);
    let mut summary = summarize(surface, &whole, &flattened, Timings { read, ..timings });
    summary.notes.extend(bare);
    summary.notes.iter().chain(&summary.repairs).for_each(|note| eprintln!("riemap: {}: {note}", arguments.surface));
    if arguments.json {
        let text = serde_json::to_string_pretty(&summary).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    let best = summary.best.as_ref().map(|best| format!("\n{}", best.optimised.said())).unwrap_or_default();
    let best = flatten_pins::in_words(&summary.pins) + &best;
    let Summary { quality, counts, flips, .. } = summary;
    let kind = summary.interpretation.map(|found| format!("\noutline: {}", words(found))).unwrap_or_default();
    let corners = summary.corners.map(|corners| format!("\n{}", corners.said())).unwrap_or_default();
    print(&format!(
        "{}; {}, negative weights {} → {}\n{}{best}{kind}{corners}",
        counts.said(),
        edges_flipped(flips.flips),
        flips.negative_before,
        flips.negative_after,
        quality_in_words(&quality)
    ))
}

/// The note about a file in the surface's own format that could not be written as it was read.
pub(super) const BARE: &str = "bare triangles: what else the surface's file has is not kept (triangle strips, free-form surfaces, \
                               buffers in other files, meshes that are placed twice, and maps between two surfaces)";

/// A surface mapped over an outline.
struct Parameterized {
    map: ConformalMap,
    /// The surface divided at the outline's corners, if there are any.
    cuts: Option<CornerCuts>,
    constraints: Constraints,
    sides: Sides,
    best: Option<Best>,
    pins: Vec<flatten_pins::Pin>,
    x2: BarycentricPoint,
    /// As a fraction of the loop's length.
    y2: f64,
}

/// Computes the map, and the durations of all stages except reading.
fn compute(
    arguments: &FlattenArguments,
    surface: &Surface,
    progress: &Progress,
) -> Result<(Parameterized, Timings), CliError> {
    let criterion = arguments.optimize.criterion.as_ref();
    criterion.map_or(Ok(()), |named| named.check(PerSide::new(true, false)))?;
    let outline = read_outline(&arguments.outline, &arguments.mending.reading.one(&arguments.outline)?)?
        .interpreted(arguments.discretization.interpret);
    progress.enter(format!("checking {}", arguments.surface));
    let outer = usize::from(arguments.mending.boundary_loop) - 1;
    let (disk, check) = timed(|| disk(surface, arguments.mending.reading.repair, outer));
    let disk = disk.map_err(|error| about(&arguments.surface, &error))?;
    let corners = outline.outline.corner_places();
    let mut sides = Sides::prepare(arguments, (surface, disk), outline, progress)?;
    let pinned = flatten_pins::constraints(&arguments.pins, &mut sides.source, (surface, &sides.subdivided), progress)?;
    let (pins, constraints) = match pinned {
        Some((pins, constraints)) => (Some(pins), constraints),
        None => (None, sides.constraints(arguments, surface)?),
    };
    let polygons = PerSide::new(sides.source.polygon(), None);
    let best = match criterion.map(|named| named.criterion(polygons)).transpose()? {
        Some(criterion) => Some(sides.best(criterion, constraints, progress)?),
        None => None,
    };
    let constraints = best.as_ref().map_or(constraints, |(constraints, _)| *constraints);
    let x2 = constraints.points.target.on_surface().unwrap_or(sides.meshed.centre());
    let y2 = constraints.anchors.target;
    progress.enter("the map");
    let timings = Timings {
        check,
        surface: sides.surface.timings().and(sides.subdivided.timings()),
        outline: sides.source.prepared.timings(),
        ..Timings::default()
    };
    let subdivided = PerSide::new(sides.source.subdivided.clone(), sides.subdivided.clone());
    let map = ConformalMap::subdivided(&subdivided, &constraints, MapSettings::default());
    let map = map.map_err(|error| refused(&error, arguments))?;
    sides.say_notes(arguments);
    let pins = pins.map_or_else(|| Ok(Vec::new()), |pins| flatten_pins::met(&map, &pins))?;
    let frame = map.timings();
    let has_cuts = arguments.layout.corners == CornersArgument::Hit && !corners.is_empty();
    let cuts = if has_cuts { map.cut_corners(&corners) } else { None };
    let best = best.map(|(_, best)| best);
    Ok((Parameterized { map, cuts, constraints, sides, best, pins, x2, y2 }, Timings { frame, ..timings }))
}

/// Both prepared sides.
struct Sides {
    source: NamedSide,
    surface: Arc<PreparedSide>,
    /// The surface on finer triangles.
    subdivided: Subdivided,
    meshed: Arc<MeshedSurface>,
    /// The requested solver, which may differ from the one used.
    solver: SolverKind,
}

impl Sides {
    fn prepare(
        arguments: &FlattenArguments,
        (given, disk): (&Surface, SurfaceMesh),
        outline: NamedOutline,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        let FlattenArguments { mending, discretization, .. } = arguments;
        let reading = Reading {
            repair: mending.reading.repair,
            intrinsic_delaunay: !arguments.triangles.no_intrinsic_delaunay,
            discretization,
            subdivide: !arguments.triangles.no_subdivision,
        };
        let settings = reading.surface_settings();
        let surface = prepare_surface(disk, settings, &mut progress.preparing(&arguments.surface));
        let surface = surface.map_err(|error| about(&arguments.surface, &error))?;
        let asked = Asked {
            name: &arguments.outline,
            title: &arguments.outline,
            samples: None,
            point: ("--outline-point", arguments.outline_point.map(SidePoint::Plane)),
            anchor: ("--outline-anchor", SideAnchor::Plane(arguments.outline_anchor)),
        };
        let source = NamedSide::prepare(&asked, Given::Outline(outline), reading, progress)?;
        let meshed = Arc::clone(surface.surface().ok_or_else(no_surface)?);
        let surface = Arc::new(surface);
        let x = point(arguments, given, &meshed)?.into();
        let subdivided = subdivided(&surface, x, reading, &mut progress.preparing(&arguments.surface));
        let subdivided = subdivided.map_err(|error| about(&arguments.surface, &error))?;
        Ok(Self { source, surface, subdivided, meshed, solver: settings.solver })
    }

    /// The given constraints; `surface` is as it was read.
    fn constraints(&self, arguments: &FlattenArguments, surface: &Surface) -> Result<Constraints, CliError> {
        let x1 = arguments.outline_point.map_or(self.source.prepared.default_point(), |p| p.0.into());
        let y1 = self.source.anchor("--outline-anchor", SideAnchor::Plane(arguments.outline_anchor))?;
        let x2 = point(arguments, surface, &self.meshed)?;
        let y2 = arguments.surface_anchor.fraction("--surface-anchor", surface, &self.meshed)?;
        Ok(Constraints::new((x1, y1), (x2, y2)))
    }

    /// The constraints of the best map.
    fn best(
        &mut self,
        criterion: Criterion,
        start: Constraints,
        progress: &Progress,
    ) -> Result<(Constraints, Best), CliError> {
        let sides = PerSide::new(Arc::clone(&self.source.prepared), Arc::clone(&self.surface));
        let (constraints, optimised) = optimized(sides, criterion, start, MapSettings::default(), progress)?;
        self.source.resolve(constraints.points.source, progress)?;
        let outline_point = constraints.points.source.in_plane().map(|x| x.to_array());
        Ok((constraints, Best { optimised, outline_point, outline_anchor: constraints.anchors.source }))
    }

    fn say_notes(&self, arguments: &FlattenArguments) {
        self.source.say_notes(&arguments.discretization);
        say_solver(&arguments.surface, self.solver, self.surface.solver_kind());
    }
}

/// The interior point of the surface, which is `given` as it was read.
fn point(arguments: &FlattenArguments, given: &Surface, meshed: &MeshedSurface) -> Result<BarycentricPoint, CliError> {
    let locate = |point: SurfacePoint| point.locate("--surface-point", given, meshed);
    arguments.surface_point.map_or(Ok(meshed.centre()), locate)
}

fn no_surface() -> CliError {
    CliError::Input(String::from("an outline is flat already"))
}

/// An error about the file `name`.
fn about(name: &str, error: &impl std::fmt::Display) -> CliError {
    CliError::Input(format!("{name}: {error}"))
}

/// A map's error in the terms of this subcommand, whose source is the outline.
fn refused(error: &MapError, arguments: &FlattenArguments) -> CliError {
    CliError::Input(match error {
        MapError::PointOutside { x, y, .. } => {
            format!("--outline-point: ({x}, {y}) is not inside the outline as it is sampled")
        }
        MapError::NotConverged { side: Side::Source, error } => format!("{}: {error}", arguments.outline),
        MapError::NotConverged { side: Side::Target, error } => format!("{}: {error}", arguments.surface),
        error => error.to_string(),
    })
}

fn summarize(surface: &Surface, whole: &Parameterized, flattened: &Flattened, timing_ms: Timings) -> Summary {
    let Parameterized { map, sides, x2, y2, .. } = whole;
    let meshed = &sides.meshed;
    let disk = meshed.surface();
    let weights = disk.weights_in(surface, *x2);
    Summary {
        quality: map.quality(),
        counts: Counts::of(map),
        flips: meshed.flips(),
        repairs: disk.repairs().iter().map(ToString::to_string).collect(),
        notes: surface
            .notes()
            .iter()
            .map(ToString::to_string)
            .chain(map.note(map.mapped_side()).map(|note| note.to_string()))
            .collect(),
        surface_point: Point {
            triangle: disk.triangle_origins()[x2.triangle().index()],
            weights,
            position: meshed.position(*x2).to_array(),
        },
        surface_anchor: *y2,
        best: whole.best.clone(),
        pins: whole.pins.clone(),
        uv: flattened.placement,
        corners: whole.cuts.as_ref().map(|cuts| Corners::of(cuts, flattened)),
        interpretation: sides.source.interpreted(),
        timing_ms,
    }
}

/// The result of `work` and its duration in milliseconds.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64() * 1e3)
}
