//! `riemap map`: computes the map between two sides and writes it.

use super::CliError;
use super::chain::{self, Chain};
use super::flatten::BARE;
use super::flatten_arguments::ReadSurface;
use super::map_arguments::{DirectionArgument, ExtensionArgument, MapArguments};
use super::named_outline::reach;
use super::optimization::optimized;
use super::output::{Format, check_paths, print, quality_in_words, words, write_all};
use super::pins::{self, Pinned};
use super::points::Points;
use super::progress::Progress;
use super::side::{self, Asked, Given, NamedSide, Placed, Reading, SideAnchor, SidePoint, is_surface};
use super::tables::{self, Best, Summary};
use super::{picture, surface_picture};
use crate::conformal::{
    ConformalMap, Constraints, Direction, Extension, KernelMode, MapError, MapSettings, PerSide, Pins, PrepareSettings,
    PrepareTimings, Side,
};
use crate::export::{
    EncodedSurface, FileFormat, Panel, Ruling, SurfaceSource, boundary_csv, mapped_mesh, panels, parts, svg,
};
use crate::geometry::DVec3;
use crate::optimization::Criterion;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Squares of the drawn grid across the source's larger side.
const GRID_CELLS: f64 = 12.0;

/// Computes the map and writes the requested files.
pub fn run(arguments: &MapArguments) -> Result<(), CliError> {
    let formats = arguments.out.iter().map(|path| Format::of(path)).collect::<Result<Vec<_>, _>>()?;
    check_paths(&arguments.out)?;
    check_formats(&formats, &arguments.sides.names())?;
    let progress = Progress::new("reading");
    let Computed { map, constraints, pins, summary, table, surface } =
        if arguments.sides.is_chain() { chain::compute(arguments, &progress)? } else { compute(arguments, &progress)? };
    progress.enter("writing");
    let names = arguments.sides.names();
    let names = PerSide::new(names[0], names[names.len() - 1]);
    let pins = PerSide::from_fn(|side| places(&map, pins.as_ref(), side));
    let source = surface.as_ref().and_then(ReadSurface::source);
    let scene = Scene { map: &map, constraints, names, pins, source };
    let mut files = Vec::new();
    for (path, format) in arguments.out.iter().zip(formats) {
        let bytes = match &table {
            Some(table) if format == Format::Csv => table.clone().into_bytes(),
            _ => scene.encode(format, &summary, (path, arguments.size.0))?,
        };
        files.push((path.clone(), bytes));
    }
    write_all(&files)?;
    drop(progress);
    if arguments.json {
        let text = serde_json::to_string_pretty(&summary).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    print(&in_words(&summary))
}

fn in_words(summary: &Summary) -> String {
    let Summary { quality, counts, unresolved_area, interpretation, accuracy, pinned, best, chain, .. } = summary;
    let unresolved = unresolved_area.filter(|area| *area > 0.0);
    let kinds =
        interpretation.iter().filter_map(|(side, found)| found.map(|found| format!("{side}: {}", words(found))));
    let kinds: Vec<String> = kinds.collect();
    let kinds = if kinds.is_empty() { String::new() } else { format!("\n{}", kinds.join("; ")) };
    let pinned =
        pinned.as_ref().map(|pinned| format!("\nthe pins are met to {:.1e}", pinned.miss())).unwrap_or_default();
    let best = best.as_ref().map(|best| format!("\n{}", best.optimised.said())).unwrap_or_default();
    let links = chain.as_ref().map(Chain::text).unwrap_or_default();
    format!(
        "{}\n{}{}{}{pinned}{best}{kinds}{links}",
        counts.said(),
        quality_in_words(quality),
        unresolved
            .map(|area| format!("\nunresolved, hatched in pictures: {area:.2e} of the other area"))
            .unwrap_or_default(),
        accuracy.text()
    )
}

/// The map, what it was made from, and what is said about it.
pub(super) struct Computed {
    pub map: ConformalMap,
    pub constraints: Constraints,
    /// The pins, where they determine the map.
    pub pins: Option<Pins>,
    pub summary: Summary,
    /// The images of the given points.
    pub table: Option<String>,
    /// The mapped side, if it is a surface.
    pub surface: Option<ReadSurface>,
}

/// The most vertices of both meshes whose errors are estimated by comparison with four times as many.
const MAX_COMPARED: usize = 20_000;

/// Whether numbers are written that an estimate of their errors belongs to.
fn asks_for_errors(arguments: &MapArguments) -> bool {
    let has_errors = |path: &PathBuf| matches!(Format::of(path), Ok(Format::Json | Format::Csv));
    arguments.json || arguments.out.iter().any(has_errors)
}

/// Estimates the errors of a map with finite elements by comparison with finer meshes; returns why not.
fn estimate(
    map: &mut ConformalMap,
    sides: [&NamedSide; 2],
    reading: Reading<'_>,
    progress: &Progress,
) -> Option<String> {
    if map.error_estimate().is_some() {
        return None;
    }
    let uncut = sides.iter().filter(|side| !side.subdivided.is_cut());
    let vertices: usize = uncut.map(|side| side.prepared.vertex_count()).sum();
    if vertices > MAX_COMPARED {
        return Some(format!("{vertices} vertices are too many to compare with a finer mesh"));
    }
    let compared = |map: &mut ConformalMap| -> Result<bool, String> {
        let [Some(source), Some(target)] = [sides[0].finer(reading, progress)?, sides[1].finer(reading, progress)?]
        else {
            return Ok(false);
        };
        let finer = PerSide::new(source, target);
        if sides.iter().any(|side| side.subdivided.is_cut()) {
            let subdivided = PerSide::from(sides.map(|side| side.subdivided.clone()));
            return map.compare_subdivided(&subdivided, &finer).map_err(|error| error.to_string());
        }
        let finer = map.on_finer(&finer).map_err(|error| error.to_string())?;
        Ok(finer.is_some_and(|finer| map.compare_with(&finer)))
    };
    match compared(map) {
        Ok(true) => None,
        Ok(false) => Some("the map cannot be compared with one on finer meshes".to_owned()),
        Err(error) => Some(format!("a finer mesh to compare with cannot be prepared: {error}")),
    }
}

/// The map on a mesh refined for it, if the settings of the `mapped` side or the argument ask for that, with the
/// preparation of the mesh before; where it cannot be refined, the map as it is, with the reason on stderr.
fn refined(
    map: ConformalMap,
    mapped: &NamedSide,
    arguments: &MapArguments,
    progress: &Progress,
) -> (ConformalMap, PrepareTimings) {
    // where the integral equation does not fit, the side is refined as with the adjoint kernel
    let is_finite = mapped.prepared.curve_boundary().is_none();
    let settings = mapped.settings.map(|settings| match settings.kernel {
        KernelMode::Integral if is_finite => settings.with_kernel(KernelMode::Adjoint),
        _ => settings,
    });
    let is_exact = arguments.extension == ExtensionArgument::Exact;
    let asked = |settings: &PrepareSettings| arguments.refine.refines(settings) && !is_exact;
    let Some(settings) = settings.filter(asked) else { return (map, PrepareTimings::default()) };
    match map.refined(&settings, &mut progress.preparing("refined")) {
        Ok(Some(fine)) => (fine, map.mapped().timings()),
        Ok(None) => (map, PrepareTimings::default()),
        Err(error) => {
            eprintln!("riemap: the mapped mesh is not refined: {error}");
            (map, PrepareTimings::default())
        }
    }
}

fn compute(arguments: &MapArguments, progress: &Progress) -> Result<Computed, CliError> {
    let making = Making::new(arguments, progress)?;
    let titles = titles(&arguments.sides.names());
    let asked = making.asked(&titles)?;
    let asked = [asked[0], asked[1]];
    let pins = arguments.instead.pins.check(&asked)?;
    let criterion = arguments.instead.optimize.criterion.as_ref();
    criterion.map_or(Ok(()), |named| named.check(PerSide::from(asked.map(|side| !is_surface(side.name)))))?;
    let how = arguments.reading.each(&[asked[0].name, asked[1].name])?;
    let [first, second] = [side::read(asked[0].name, &how[0])?, side::read(asked[1].name, &how[1])?];
    let mut source = making.prepared(&asked[0], first)?;
    let mut target = making.prepared(&asked[1], second)?;
    let pins = pins.map(|given| pins::constraints(given, [&mut source, &mut target], progress)).transpose()?;
    let given = match &pins {
        Some((_, constraints)) => *constraints,
        None => Constraints::new(source.constraint(&asked[0])?, target.constraint(&asked[1])?),
    };
    let direction = making.settings.direction;
    let criterion = criterion.map(|named| named.criterion(PerSide::new(source.polygon(), target.polygon())));
    let criterion = criterion.transpose()?;
    let best = criterion.map(|criterion| best(criterion, given, direction, [&mut source, &mut target], progress));
    let (constraints, best) = best.transpose()?.map_or((given, None), |(found, best)| (found, Some(best)));
    progress.enter("the map");
    let sides = [&source, &target];
    let map = making.map(sides, &constraints, &asked)?;
    let pins = pins.map(|(pins, _)| pins);
    let pinned = pins.as_ref().map(|pins| Pinned::of(&map, pins, &constraints, sides)).transpose()?;
    let Finished { map, summary, table } = making.finished(map, sides, making.points.as_ref())?;
    making.say_notes(&sides);
    say_map_notes(&map, &asked);
    let mapped = if map.mapped_side() == Side::Source { source } else { target };
    let surface = mapped.into_surface();
    Ok(Computed { map, constraints, pins, summary: Summary { pinned, best, ..summary }, table, surface })
}

/// What maps are made with.
pub(super) struct Making<'a> {
    pub arguments: &'a MapArguments,
    pub progress: &'a Progress,
    pub points: Option<Points>,
    settings: MapSettings,
    reading: Reading<'a>,
}

/// A complete map, with its summary and the images of points.
pub(super) struct Finished {
    pub map: ConformalMap,
    pub summary: Summary,
    pub table: Option<String>,
}

impl<'a> Making<'a> {
    /// Checks the settings and reads the points of the arguments.
    pub fn new(arguments: &'a MapArguments, progress: &'a Progress) -> Result<Self, CliError> {
        let reading = Reading {
            repair: arguments.reading.repair,
            intrinsic_delaunay: !arguments.triangles.no_intrinsic_delaunay,
            discretization: &arguments.discretization,
            subdivide: !arguments.triangles.no_subdivision,
        };
        let settings = settings(arguments)?;
        let points = arguments.evaluate.read(&arguments.out)?;
        Ok(Self { arguments, progress, points, settings, reading })
    }

    /// The arguments of each side; errors in any of them are reported before the first one is prepared.
    pub fn asked<'b>(&'b self, titles: &'b [String]) -> Result<Vec<Asked<'b>>, CliError> {
        let MapArguments { sides, points, samples, discretization, .. } = self.arguments;
        let source = (points.source_point, points.source_anchor);
        let names = sides.names();
        let targets = points.of_targets(names.len() - 1)?;
        let side = |(k, (point, anchor)): (usize, (Option<SidePoint>, SideAnchor))| {
            let (samples, options) = match k {
                0 => (samples.source_samples, ["--source-point", "--source-anchor"]),
                _ => (samples.target_samples, ["--target-point", "--target-anchor"]),
            };
            Asked {
                name: names[k],
                title: &titles[k],
                samples,
                point: (options[0], point),
                anchor: (options[1], anchor),
            }
        };
        let asked: Vec<Asked> = std::iter::once(source).chain(targets).enumerate().map(side).collect();
        asked.iter().try_for_each(Asked::check)?;
        if asked.iter().all(|side| is_surface(side.name)) && discretization.samples.is_some() {
            let text = "--samples is for outlines: both sides are surfaces, which have their own boundary vertices";
            return Err(CliError::Usage(text.to_owned()));
        }
        Ok(asked)
    }

    /// Prepares a side that was read.
    pub fn prepared(&self, asked: &Asked<'_>, given: Given) -> Result<NamedSide, CliError> {
        NamedSide::prepare(asked, given, self.reading, self.progress)
    }

    /// The map between two sides.
    pub fn map(
        &self,
        [source, target]: [&NamedSide; 2],
        constraints: &Constraints,
        asked: &[Asked<'_>; 2],
    ) -> Result<ConformalMap, CliError> {
        let sides = PerSide::new(source.subdivided.clone(), target.subdivided.clone());
        ConformalMap::subdivided(&sides, constraints, self.settings)
            .map_err(|error| refused(&error, asked, [source, target]))
    }

    /// The map, refined and extended as asked for, its summary, and the images of `points`.
    pub fn finished(
        &self,
        map: ConformalMap,
        sides: [&NamedSide; 2],
        points: Option<&Points>,
    ) -> Result<Finished, CliError> {
        let Self { arguments, progress, .. } = *self;
        // a refined mesh has its measures from the images, not from the integral equation
        let sharp = points.filter(|_| map.curve_map(Side::Source).is_some());
        let table = sharp.map(|points| points.table(&map, progress)).transpose()?;
        let mapped = if map.mapped_side() == Side::Source { sides[0] } else { sides[1] };
        let (mut map, coarse) = refined(map, mapped, arguments, progress);
        if self.settings.extension == Extension::CauchyGreen {
            progress.enter("the Cauchy–Green extension");
        }
        map.refine_exactly_with(&mut |done| progress.report(done));
        if arguments.extension == ExtensionArgument::Exact {
            extend_exactly(&mut map, progress)?;
        }
        let unestimated = if asks_for_errors(arguments) {
            progress.enter("the errors");
            estimate(&mut map, sides, self.reading, progress)
        } else {
            None
        };
        let table = match (table, points) {
            (None, Some(points)) => Some(points.table(&map, progress)?),
            (table, _) => table,
        };
        let interpreted = PerSide::new(sides[0].interpreted(), sides[1].interpreted());
        let summary = Summary::of(&map, interpreted, coarse, unestimated);
        Ok(Finished { map, summary, table })
    }

    /// Reports on stderr how the sides were read and prepared.
    pub fn say_notes(&self, sides: &[&NamedSide]) {
        for side in sides {
            side.say_notes(&self.arguments.discretization);
        }
    }
}

/// Reports on stderr the warnings about the sides of a map.
pub(super) fn say_map_notes(map: &ConformalMap, asked: &[Asked<'_>; 2]) {
    for (side, asked) in Side::BOTH.into_iter().zip(asked) {
        if let Some(note) = map.note(side) {
            eprintln!("riemap: {}: {note}", asked.title);
        }
    }
}

/// The constraints of the best map. An outline whose equation does not resolve its point is prepared anew with it.
fn best(
    criterion: Criterion,
    start: Constraints,
    direction: Direction,
    [source, target]: [&mut NamedSide; 2],
    progress: &Progress,
) -> Result<(Constraints, Best), CliError> {
    let sides = PerSide::new(Arc::clone(&source.prepared), Arc::clone(&target.prepared));
    let (found, optimised) = optimized(sides, criterion, start, direction.into(), progress)?;
    source.resolve(found.points.source, progress)?;
    target.resolve(found.points.target, progress)?;
    Ok((found, Best { optimised, constraints: Placed::of(&found, [source, target])? }))
}

/// Places the mesh's vertices by Cauchy's integral; says on stderr how many it cannot place.
fn extend_exactly(map: &mut ConformalMap, progress: &Progress) -> Result<(), CliError> {
    progress.enter("the exact extension");
    let beyond = map.extend_exactly(&mut |done| progress.report(done));
    let beyond = beyond.map_err(|error| CliError::Usage(format!("--extension exact: {error}")))?;
    if beyond > 0 {
        eprintln!("riemap: {beyond} vertices of the mesh lie outside of the curve and keep their harmonic images");
    }
    Ok(())
}

fn settings(arguments: &MapArguments) -> Result<MapSettings, CliError> {
    let direction = match arguments.direction {
        Some(DirectionArgument::Forward) => Direction::Forward,
        None if arguments.sides.is_chain() => Direction::Forward,
        Some(DirectionArgument::Backward) | None => Direction::Backward,
    };
    let extension = match arguments.extension {
        // exact images replace the harmonic ones once these are complete
        ExtensionArgument::Harmonic | ExtensionArgument::Exact => Extension::Harmonic,
        ExtensionArgument::CauchyGreen => Extension::CauchyGreen,
    };
    let names = arguments.sides.names();
    let is_integral = arguments.discretization.kernel_or(KernelMode::Adjoint) == KernelMode::Integral;
    if is_integral && names.iter().all(|name| is_surface(name)) {
        let text =
            "--kernel integral is for outlines; both sides are surfaces, which are computed with finite elements";
        return Err(CliError::Usage(text.to_owned()));
    }
    match names.into_iter().find(|name| is_surface(name)) {
        Some(name) if arguments.evaluate.points.is_some() => {
            Err(CliError::Usage(format!("--points is for two outlines; {name} is a surface")))
        }
        Some(name) if arguments.extension == ExtensionArgument::Exact => Err(CliError::Usage(format!(
            "--extension exact is for two outlines; {name} is a surface, whose map is extended harmonically"
        ))),
        Some(name) if extension == Extension::CauchyGreen => Err(CliError::Usage(format!(
            "--extension cauchy-green is for two outlines; {name} is a surface, whose map is extended harmonically"
        ))),
        _ => Ok(MapSettings { direction, extension }),
    }
}

/// Checks that files of surfaces are asked for of surfaces only.
fn check_formats(formats: &[Format], names: &[&str]) -> Result<(), CliError> {
    let is_planar = !names.iter().any(|name| is_surface(name));
    match formats.iter().find(|format| is_planar && matches!(format, Format::Ply | Format::Glb)) {
        Some(Format::Ply) => Err(planar_mesh("ply")),
        Some(_) => Err(planar_mesh("glb")),
        None => Ok(()),
    }
}

fn planar_mesh(extension: &str) -> CliError {
    CliError::Usage(format!("--out: a map between outlines is not written as .{extension}, but as .obj"))
}

/// What messages call the sides: by their names, with "source" and "target" where the names of two are the same, and
/// with their numbers where those of several are.
pub(super) fn titles(names: &[&str]) -> Vec<String> {
    let is_double = |name: &str| names.iter().filter(|other| **other == name).count() > 1;
    let numbered = |(k, name): (usize, &&str)| match (is_double(name), names.len(), k) {
        (false, ..) => (*name).to_owned(),
        (true, 2, 0) => format!("{name} (source)"),
        (true, 2, _) => format!("{name} (target)"),
        (true, ..) => format!("{name} ({})", k + 1),
    };
    names.iter().enumerate().map(numbered).collect()
}

/// An error of the map; one about a surface with its title, for there may be two.
fn refused(error: &MapError, [source, target]: &[Asked<'_>; 2], named: [&NamedSide; 2]) -> CliError {
    let (side, named) = if error.side() == Side::Source { (source, named[0]) } else { (target, named[1]) };
    CliError::Input(match (error, named.outline()) {
        (MapError::PointOutside { .. }, Some(outline)) => format!("{error}{}", reach(outline.polygon())),
        (_, Some(_)) => error.to_string(),
        (_, None) => format!("{}: {error}", side.title),
    })
}

/// Where pins lie on a side, in the plane z = 0 or in space; none without pins.
fn places(map: &ConformalMap, pins: Option<&Pins>, side: Side) -> Vec<DVec3> {
    let prepared = map.side(side);
    let pairs = pins.map_or(&[][..], Pins::pairs);
    pairs.iter().map(|pair| prepared.boundary_place(prepared.at_fraction(pair[side]))).collect()
}

/// A map with its constraints, as needed for drawing.
struct Scene<'a> {
    map: &'a ConformalMap,
    constraints: Constraints,
    names: PerSide<&'a str>,
    /// The places of the pins; empty: there are none.
    pins: PerSide<Vec<DVec3>>,
    /// The file of the mapped surface.
    source: Option<SurfaceSource<'a>>,
}

impl Scene<'_> {
    /// `path` is that of the file, for messages.
    fn encode(&self, format: Format, summary: &Summary, (path, size): (&Path, [u32; 2])) -> Result<Vec<u8>, CliError> {
        match format {
            Format::Json => tables::json(self.map, summary).map_err(|error| CliError::Input(error.to_string())),
            Format::Csv => Ok(boundary_csv(self.map).into_bytes()),
            Format::Obj => self.mesh(FileFormat::Obj, path),
            Format::Ply => self.mesh(FileFormat::Ply, path),
            Format::Glb => self.mesh(FileFormat::Glb, path),
            Format::Svg => Ok(self.drawing().into_bytes()),
            Format::Png => self.picture(size),
        }
    }

    fn mesh(&self, format: FileFormat, path: &Path) -> Result<Vec<u8>, CliError> {
        let mesh = mapped_mesh(self.map, format, self.source);
        let EncodedSurface { bytes, is_bare } = mesh.ok_or_else(|| planar_mesh(format.extension()))?;
        if is_bare {
            eprintln!("riemap: {}: {BARE}", path.display());
        }
        Ok(bytes)
    }

    /// The planar parts of the map as SVG, with a square grid on the source, on the only outline, or on the disk.
    fn drawing(&self) -> String {
        let mut parts = parts(self.map, &self.constraints);
        if !self.map.is_through_disk() {
            // two surfaces are drawn as mapped into the disk, where the pins have no places
            for part in &mut parts {
                part.panel.pins = &self.pins[part.side];
            }
        }
        let grid = parts.first().map(|part| {
            let (low, high) = part.panel.bounds();
            Ruling::Squares { origin: 0.5 * (low + high), spacing: (high - low).max_element() / GRID_CELLS }
        });
        svg(&parts, grid)
    }

    fn picture(&self, size: [u32; 2]) -> Result<Vec<u8>, CliError> {
        let Self { map, constraints, names, pins, .. } = self;
        let pins = pins.as_ref().map(Vec::as_slice);
        match panels(map, constraints) {
            Some(PerSide { source, target }) => {
                let panels = [Panel { pins: pins.source, ..source }, Panel { pins: pins.target, ..target }];
                picture::png(&panels, GRID_CELLS, size)
            }
            None if map.is_through_disk() => surface_picture::png_of_two(*names, map, (constraints, pins), size),
            None => {
                let side = map.mapped_side();
                surface_picture::png(names[side], map, None, (constraints, pins), side == Side::Target, size)
            }
        }
    }
}
