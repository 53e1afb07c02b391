//! `riemap flatten`: prepares a surface and an outline, parameterizes the surface over it, writes it.

use super::CliError;
use super::arguments::{NamedOutline, read_outline};
use super::flatten_arguments::{FlattenArguments, UvArgument, read};
use super::output::{check_paths, edges_flipped, print, say_solver, triangles, warn_if_coarse, write_all};
use super::progress::Progress;
use super::surface_picture;
use crate::conformal::{
    FrameTimings, MapError, Memory, PrepareSettings, PrepareTimings, PreparedDomain, PreparedSurface, Quality,
    SurfaceConstraints, SurfaceMap, SurfaceMapError, SurfaceSettings, prepare, prepare_surface,
};
use crate::export::{FileFormat, Flattened, Placement};
use crate::laplace::SolverKind;
use crate::mesh::FlipReport;
use crate::surface::{Surface, SurfaceMesh};
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Milliseconds by stage.
#[derive(Debug, Clone, Copy, Default, serde::Serialize)]
struct Timings {
    /// The surface's file.
    read: f64,
    /// Its connectivity, and repairs.
    check: f64,
    surface: PrepareTimings,
    outline: PrepareTimings,
    #[serde(flatten)]
    frame: FrameTimings,
}

#[derive(Debug, serde::Serialize)]
struct Counts {
    /// Boundary vertices.
    m: u32,
    /// Interior vertices.
    n: usize,
    triangles: usize,
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
    uv: Placement,
    timing_ms: Timings,
}

/// A point of the surface, by its triangle, counted once the file's faces are cut, and the weights of its corners there.
#[derive(Debug, serde::Serialize)]
struct Point {
    triangle: u32,
    weights: [f64; 3],
    position: [f64; 3],
}

/// What a file is to be.
#[derive(Debug, Clone, Copy)]
enum Format {
    /// The surface or its layout.
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

/// Computes the parameterization and writes what is asked for.
pub fn run(arguments: &FlattenArguments) -> Result<(), CliError> {
    let formats = arguments.out.iter().map(|path| format_of(path)).collect::<Result<Vec<_>, _>>()?;
    check_paths(&arguments.out)?;
    let progress = Progress::new(format!("reading {}", arguments.surface));
    let (surface, read) = timed(|| read(&arguments.surface));
    let surface = surface?;
    let (map, constraints, timings) = compute(arguments, &surface, &progress)?;
    progress.enter("writing");
    let flattened = Flattened::new(&surface, &map, arguments.uv == UvArgument::Unit);
    let mut files = Vec::new();
    for (path, format) in arguments.out.iter().zip(formats) {
        let bytes = match format {
            Format::Surface(format) => flattened.encode(format),
            Format::Picture => surface_picture::png(&arguments.surface, &map, &constraints, arguments.size.0)?,
        };
        files.push((path.clone(), bytes));
    }
    write_all(&files)?;
    drop(progress);
    let summary = summarize(&surface, &map, &constraints, flattened.placement, Timings { read, ..timings });
    summary.notes.iter().chain(&summary.repairs).for_each(|note| eprintln!("riemap: {}: {note}", arguments.surface));
    if arguments.json {
        let text = serde_json::to_string_pretty(&summary).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    let Summary { quality, counts, flips, .. } = summary;
    print(&format!(
        "m = {}, n = {}, {}; {}, negative weights {} → {}\nmean Q = {:.4}, {} flipped, {} collapsed",
        counts.m,
        counts.n,
        triangles(counts.triangles),
        edges_flipped(flips.flips),
        flips.negative_before,
        flips.negative_after,
        quality.q_mean,
        quality.flipped,
        quality.collapsed
    ))
}

/// The map with its constraints, and what it took but for the reading.
fn compute(
    arguments: &FlattenArguments,
    surface: &Surface,
    progress: &Progress,
) -> Result<(SurfaceMap, SurfaceConstraints, Timings), CliError> {
    let outline = read_outline(&arguments.outline, arguments.repair)?;
    progress.enter(format!("checking {}", arguments.surface));
    let (disk, check) =
        timed(|| if arguments.repair { SurfaceMesh::repaired(surface) } else { SurfaceMesh::new(surface) });
    let disk = disk.map_err(|error| about(&arguments.surface, &error))?;
    let sides = Sides::prepare(arguments, &outline, disk, progress)?;
    let constraints = sides.constraints(arguments, surface)?;
    outline.say_notes(&arguments.outline);
    sides.say_notes(arguments);
    progress.enter("the map");
    let Sides { source, surface, .. } = sides;
    let timings = Timings { check, surface: surface.timings, outline: source.timings, ..Timings::default() };
    let map = SurfaceMap::new(source, surface, &constraints).map_err(|error| refused(&error, arguments))?;
    let frame = map.timings();
    Ok((map, constraints, Timings { frame, ..timings }))
}

/// What is mapped, prepared.
struct Sides {
    source: Arc<PreparedDomain>,
    surface: Arc<PreparedSurface>,
    /// The solver that was asked for.
    solver: SolverKind,
}

impl Sides {
    fn prepare(
        arguments: &FlattenArguments,
        outline: &NamedOutline,
        disk: SurfaceMesh,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        let settings = arguments.discretisation.settings(outline, None);
        let PrepareSettings { kernel, solver, .. } = settings;
        let on_surface = SurfaceSettings { intrinsic_delaunay: !arguments.no_intrinsic_delaunay, kernel, solver };
        let surface = prepare_surface(Memory::default(), disk, on_surface, &mut progress.preparing(&arguments.surface));
        let surface = surface.map_err(|error| about(&arguments.surface, &error))?;
        let source = prepare(&outline.outline.polygon, &settings, &mut progress.preparing(&arguments.outline));
        let source = source.map_err(|error| about(&arguments.outline, &error))?;
        Ok(Self { source: Arc::new(source), surface: Arc::new(surface), solver })
    }

    fn constraints(&self, arguments: &FlattenArguments, given: &Surface) -> Result<SurfaceConstraints, CliError> {
        let Self { source, surface, .. } = self;
        let point = arguments.surface_point.map_or(Ok(surface.centre), |point| point.locate(given, surface))?;
        Ok(SurfaceConstraints {
            source_point: arguments.outline_point.map_or(source.pole, |p| p.0),
            source_anchor: arguments.outline_anchor.fraction(&source.samples),
            surface_point: point,
            surface_anchor: arguments.surface_anchor.fraction(surface)?,
        })
    }

    fn say_notes(&self, arguments: &FlattenArguments) {
        warn_if_coarse(&arguments.outline, self.source.refinement);
        say_solver(&arguments.outline, self.solver, &self.source.solver);
        say_solver(&arguments.surface, self.solver, &self.surface.solver);
    }
}

/// An error of the file that has this name.
fn about(name: &str, error: &impl std::fmt::Display) -> CliError {
    CliError::Input(format!("{name}: {error}"))
}

/// An error of the map in the words of this subcommand, whose source is the outline.
fn refused(error: &SurfaceMapError, arguments: &FlattenArguments) -> CliError {
    CliError::Input(match error {
        SurfaceMapError::Planar(MapError::PointOutside { x, y, .. }) => {
            format!("--outline-point: ({x}, {y}) is not inside the outline as it is sampled")
        }
        SurfaceMapError::Planar(MapError::NotConverged { error, .. }) => format!("{}: {error}", arguments.outline),
        SurfaceMapError::NotConverged(error) => format!("{}: {error}", arguments.surface),
        error => error.to_string(),
    })
}

fn summarize(
    surface: &Surface,
    map: &SurfaceMap,
    constraints: &SurfaceConstraints,
    uv: Placement,
    timing_ms: Timings,
) -> Summary {
    let prepared = map.surface();
    let mesh = &prepared.surface.mesh;
    let point = constraints.surface_point;
    let mut weights = [0.0; 3];
    for (i, weight) in prepared.surface.corners_in(surface, point.triangle).into_iter().zip(point.weights) {
        weights[i] = weight;
    }
    Summary {
        quality: map.quality(),
        counts: Counts { m: mesh.boundary_count, n: mesh.interior_count(), triangles: mesh.triangles.len() },
        flips: prepared.flips,
        repairs: prepared.surface.repairs.iter().map(ToString::to_string).collect(),
        notes: surface.notes.iter().map(ToString::to_string).chain(map.note().map(|note| note.to_string())).collect(),
        surface_point: Point {
            triangle: prepared.surface.triangle_origins[point.triangle as usize],
            weights,
            position: prepared.position(point).to_array(),
        },
        surface_anchor: constraints.surface_anchor,
        uv,
        timing_ms,
    }
}

/// What `work` gives, and how many milliseconds it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = work();
    (result, start.elapsed().as_secs_f64() * 1e3)
}
