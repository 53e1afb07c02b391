//! `riemap flatten`: prepares a surface and an outline, parameterizes the surface over it, writes it.

use super::CliError;
use super::arguments::read_outline;
use super::flatten_arguments::{FlattenArguments, UvArgument, read};
use super::output::{check_paths, edges_flipped, print, say_solver, triangles, warn_if_coarse, write_all};
use super::progress::Progress;
use super::surface_picture;
use crate::conformal::{
    FrameTimings, MapError, Memory, PrepareTimings, Quality, SurfaceConstraints, SurfaceMap, SurfaceMapError,
    SurfaceSettings, prepare, prepare_surface,
};
use crate::export::{FileFormat, Flattened, Placement};
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
    let mut timings = Timings::default();
    let progress = Progress::new(format!("reading {}", arguments.surface));
    let surface = timed(&mut timings.read, || read(&arguments.surface))?;
    let (map, constraints) = compute(arguments, &surface, &mut timings, &progress)?;
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
    let summary = summarize(&surface, &map, &constraints, flattened.placement, timings);
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

fn compute(
    arguments: &FlattenArguments,
    surface: &Surface,
    timings: &mut Timings,
    progress: &Progress,
) -> Result<(SurfaceMap, SurfaceConstraints), CliError> {
    let about = |name: &str, error: &dyn std::fmt::Display| CliError::Input(format!("{name}: {error}"));
    let outline = read_outline(&arguments.outline, arguments.repair)?;
    progress.enter(format!("checking {}", arguments.surface));
    let disk = timed(&mut timings.check, || {
        if arguments.repair { SurfaceMesh::repaired(surface) } else { SurfaceMesh::new(surface) }
    });
    let disk = disk.map_err(|error| about(&arguments.surface, &error))?;
    let settings = arguments.discretisation.settings(&outline, None);
    let on_surface = SurfaceSettings {
        intrinsic_delaunay: !arguments.no_intrinsic_delaunay,
        kernel: settings.kernel,
        solver: settings.solver,
    };
    let prepared = prepare_surface(Memory::default(), disk, on_surface, &mut progress.preparing(&arguments.surface));
    let prepared = Arc::new(prepared.map_err(|error| about(&arguments.surface, &error))?);
    let source = prepare(&outline.outline.polygon, &settings, &mut progress.preparing(&arguments.outline));
    let source = Arc::new(source.map_err(|error| about(&arguments.outline, &error))?);
    (timings.surface, timings.outline) = (prepared.timings, source.timings);
    let constraints = SurfaceConstraints {
        source_point: arguments.outline_point.map_or(source.pole, |p| p.0),
        source_anchor: arguments.outline_anchor.fraction(&source.samples),
        surface_point: arguments.surface_point.map_or(Ok(prepared.centre), |point| point.locate(surface, &prepared))?,
        surface_anchor: arguments.surface_anchor.fraction(&prepared)?,
    };
    outline.say_notes(&arguments.outline);
    warn_if_coarse(&arguments.outline, source.refinement);
    say_solver(&arguments.outline, settings.solver, &source.solver);
    say_solver(&arguments.surface, settings.solver, &prepared.solver);
    progress.enter("the map");
    let map = SurfaceMap::new(source, prepared, &constraints).map_err(|error| refused(&error, arguments))?;
    timings.frame = map.timings();
    Ok((map, constraints))
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

fn timed<T>(milliseconds: &mut f64, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    *milliseconds = start.elapsed().as_secs_f64() * 1e3;
    result
}
