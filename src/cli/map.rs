//! `riemap map`: prepares both domains, computes the map, writes it.

use super::CliError;
use super::arguments::{DirectionArgument, ExtensionArgument, MapArguments, NamedOutline, read_outline};
use super::output::{Format, check_paths, print, say_solver, triangles, warn_if_coarse, write_all};
use super::picture;
use super::progress::Progress;
use super::tables::{self, Summary};
use crate::conformal::{ConformalMap, Constraints, Direction, Extension, MapSettings, PreparedDomain, Side, prepare};
use crate::export::{Part, Ruling, boundary_csv, mapped_obj, panels, svg};
use std::sync::Arc;

/// Cells of the drawn patterns across the source's larger side.
const GRID_CELLS: f64 = 12.0;

/// Computes the map and writes what is asked for.
pub fn run(arguments: &MapArguments) -> Result<(), CliError> {
    let formats = arguments.out.iter().map(|path| Format::of(path)).collect::<Result<Vec<_>, _>>()?;
    check_paths(&arguments.out)?;
    let progress = Progress::new("reading");
    let (map, constraints) = compute(arguments, &progress)?;
    progress.enter("writing");
    let summary = Summary::of(&map);
    let scene = Scene { map: &map, constraints };
    let mut files = Vec::new();
    for (path, format) in arguments.out.iter().zip(formats) {
        files.push((path.clone(), scene.encode(format, summary, arguments.size.0)?));
    }
    write_all(&files)?;
    drop(progress);
    if arguments.json {
        let text = serde_json::to_string_pretty(&summary).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    let Summary { quality, counts, .. } = summary;
    print(&format!(
        "m = {}, n = {}, {}\nmean Q = {:.4}, {} flipped, {} collapsed",
        counts.m,
        counts.n,
        triangles(counts.triangles),
        quality.q_mean,
        quality.flipped,
        quality.collapsed
    ))
}

fn compute(arguments: &MapArguments, progress: &Progress) -> Result<(ConformalMap, Constraints), CliError> {
    let outlines = [&arguments.source, &arguments.target].map(|name| read_outline(name, arguments.repair));
    let [source, target] = outlines;
    let outlines = [source?, target?];
    let prepared = |name: &str, outline: &NamedOutline, samples| -> Result<Arc<PreparedDomain>, CliError> {
        let settings = arguments.discretisation.settings(outline, samples);
        let domain = prepare(&outline.outline.polygon, &settings, &mut progress.preparing(name));
        domain.map(Arc::new).map_err(|error| CliError::Input(format!("{name}: {error}")))
    };
    let source = prepared(&arguments.source, &outlines[0], arguments.source_samples)?;
    let target = prepared(&arguments.target, &outlines[1], arguments.target_samples)?;
    let constraints = Constraints {
        source_point: arguments.source_point.map_or(source.pole, |p| p.0),
        target_point: arguments.target_point.map_or(target.pole, |p| p.0),
        source_anchor: arguments.source_anchor.fraction(&source.samples),
        target_anchor: arguments.target_anchor.fraction(&target.samples),
    };
    let direction = match arguments.direction {
        DirectionArgument::Forward => Direction::Forward,
        DirectionArgument::Backward => Direction::Backward,
    };
    let extension = match arguments.extension {
        ExtensionArgument::Harmonic => Extension::Harmonic,
        ExtensionArgument::CauchyGreen => Extension::CauchyGreen,
    };
    progress.enter("the map");
    let mut map = ConformalMap::new(source, target, &constraints, MapSettings { direction, extension })
        .map_err(|error| CliError::Input(error.to_string()))?;
    if extension == Extension::CauchyGreen {
        progress.enter("the Cauchy–Green extension");
    }
    map.refine_exactly_with(&mut |done| progress.report(done));
    for ((outline, name), side) in outlines.iter().zip([&arguments.source, &arguments.target]).zip(Side::BOTH) {
        outline.say_notes(name);
        warn_if_coarse(name, map.domain(side).refinement);
        say_solver(name, arguments.discretisation.solver_kind(), &map.domain(side).solver);
    }
    Ok((map, constraints))
}

/// A map with its constraints, ready to be drawn.
struct Scene<'a> {
    map: &'a ConformalMap,
    constraints: Constraints,
}

impl Scene<'_> {
    fn encode(&self, format: Format, summary: Summary, size: [u32; 2]) -> Result<Vec<u8>, CliError> {
        match format {
            Format::Json => tables::json(self.map, summary).map_err(|error| CliError::Input(error.to_string())),
            Format::Csv => Ok(boundary_csv(self.map).into_bytes()),
            Format::Obj => Ok(mapped_obj(self.map).into_bytes()),
            Format::Svg => Ok(self.drawing().into_bytes()),
            Format::Png => picture::png(&panels(self.map, &self.constraints), GRID_CELLS, size),
        }
    }

    /// Both outlines with a square grid of the source.
    fn drawing(&self) -> String {
        let panels = panels(self.map, &self.constraints);
        let (low, high) = panels[0].bounds();
        let grid = Ruling::Squares { origin: 0.5 * (low + high), spacing: (high - low).max_element() / GRID_CELLS };
        let parts = Side::BOTH.map(|side| Part { side, panel: panels[side as usize], wire: None });
        svg(&parts, Some(grid))
    }
}
