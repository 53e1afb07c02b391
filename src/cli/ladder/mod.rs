//! `riemap accuracy`: the errors of all methods on twelve outlines against unknowns, boundary points and time, as a table
//! on the terminal, CSV, a figure, or JSON. The numbers come from `figures`.

mod figure;

use super::CliError;
use super::ladder_arguments::{LadderArguments, ShapeArgument};
use super::machine::Machine;
use super::output::{check_paths, print, write_all};
use super::progress::Progress;
use crate::figures::{Detail, Errors, LadderMethod, LadderRow, LadderShape, Reference, Rung};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Runs per rung; the median of their times is reported.
const RUNS: usize = 3;

#[derive(serde::Serialize)]
struct Report<'a> {
    machine: &'a Machine,
    runs: usize,
    rows: &'a [LadderRow],
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Csv,
    Svg,
}

impl From<ShapeArgument> for LadderShape {
    fn from(shape: ShapeArgument) -> Self {
        match shape {
            ShapeArgument::Disk => Self::Disk,
            ShapeArgument::Ellipse => Self::Ellipse,
            ShapeArgument::Square => Self::Square,
            ShapeArgument::RoundedSquare => Self::RoundedSquare,
            ShapeArgument::LShape => Self::LShape,
            ShapeArgument::Rectangle => Self::Rectangle,
            ShapeArgument::VShape => Self::VShape,
            ShapeArgument::Blob => Self::Blob,
            ShapeArgument::Quintic => Self::Quintic,
            ShapeArgument::Notch => Self::Notch,
            ShapeArgument::Clef => Self::Clef,
            ShapeArgument::Coast => Self::Coast,
        }
    }
}

/// Measures all rungs, prints them, and writes the files.
pub fn run(arguments: &LadderArguments) -> Result<(), CliError> {
    check_paths(&arguments.out)?;
    let formats = arguments.out.iter().map(|path| format_of(path)).collect::<Result<Vec<_>, _>>()?;
    let detail = if arguments.quick { Detail::Quick } else { Detail::Paper };
    let runs = if arguments.quick { 1 } else { RUNS };
    let rows = measured(&shapes(&arguments.shape), detail, runs)?;
    let machine = Machine::this();
    let content = |format: Format| match format {
        Format::Csv => LadderRow::table(&rows).csv().into_bytes(),
        Format::Svg => figure::draw(&rows, &machine.say()).into_bytes(),
    };
    let files: Vec<(PathBuf, Vec<u8>)> = arguments.out.iter().cloned().zip(formats.into_iter().map(content)).collect();
    write_all(&files)?;
    if arguments.json {
        let report = Report { machine: &machine, runs, rows: &rows };
        let text = serde_json::to_string_pretty(&report).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    print(&say(&rows, &machine, runs))
}

/// The outlines asked for, each once and in the order of the table; all without any.
fn shapes(wanted: &[ShapeArgument]) -> Vec<LadderShape> {
    let wanted: Vec<LadderShape> = wanted.iter().map(|&shape| shape.into()).collect();
    LadderShape::ALL.into_iter().filter(|shape| wanted.is_empty() || wanted.contains(shape)).collect()
}

fn measured(shapes: &[LadderShape], detail: Detail, runs: usize) -> Result<Vec<LadderRow>, CliError> {
    let rungs: Vec<Rung> = shapes.iter().flat_map(|&shape| Rung::of(shape, detail)).collect();
    let progress = Progress::new("measuring");
    let count = rungs.len();
    let measure = |(k, rung): (usize, &Rung)| {
        progress.enter(format!("{}, {}: row {} of {count}", rung.shape.name(), rung.method.name(), k + 1));
        Ok(rung.measure(runs)?)
    };
    rungs.iter().enumerate().map(measure).collect()
}

fn format_of(path: &Path) -> Result<Format, CliError> {
    match path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase().as_str() {
        "csv" => Ok(Format::Csv),
        "svg" => Ok(Format::Svg),
        _ => Err(CliError::Usage(format!("--out {}: the table comes as csv, the figure as svg", path.display()))),
    }
}

fn say(rows: &[LadderRow], machine: &Machine, runs: usize) -> String {
    let mut text = format!("{}\n", machine.say());
    let _ = writeln!(text, "absolute errors of harmonic measure and of boundary images; median of {runs} run(s)");
    let mut shape = None;
    for row in rows {
        if shape.replace(row.rung.shape) != Some(row.rung.shape) {
            let _ = writeln!(text, "\n{}{}", row.rung.shape.title(), note(row.rung.shape));
            let _ = writeln!(
                text,
                "{:<16} {:>5} {:>8} | {:>8} {:>8} | {:>8} {:>8} | {:>9} {:>9}",
                "", "m", "unknowns", "ω max", "ω mean", "img max", "img mean", "prepare", "per point"
            );
        }
        text.push_str(&line(row));
    }
    text.truncate(text.trim_end().len());
    text
}

fn line(LadderRow { rung, m, unknowns, omega, image, prepare_ms, point_ms, .. }: &LadderRow) -> String {
    let image_error =
        |value: fn(&Errors) -> f64| image.as_ref().map_or("–".to_owned(), |errors| format!("{:.1e}", value(errors)));
    let prepare = if rung.method == LadderMethod::Zipper { "–".to_owned() } else { format!("{prepare_ms:.1} ms") };
    format!(
        "{:<16} {m:>5} {unknowns:>8} | {:>8.1e} {:>8.1e} | {:>8} {:>8} | {prepare:>9} {point_ms:>6.2} ms\n",
        rung.method.name(),
        omega.max,
        omega.mean,
        image_error(|errors| errors.max),
        image_error(|errors| errors.mean),
    )
}

/// What errors are measured against, where that is not an exact value along the boundary; and the map of the images.
fn note(shape: LadderShape) -> &'static str {
    match (shape, shape.reference()) {
        (LadderShape::Disk, _) => ", images on the disk",
        (LadderShape::VShape, _) => ", images on the blob",
        (_, Reference::Corners) => ": exact values at the corners only; no images",
        (_, Reference::Finer) => {
            ": against the boundary integral with about twice the default's unknowns, images of the disk"
        }
        (_, Reference::Exact) => ", images of the disk",
    }
}
