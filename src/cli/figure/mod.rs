//! `riemap figure N`: reproduces a figure of the paper as a drawing and a table.
//!
//! Plots are SVG. Figures with textured meshes or surfaces are also written as PNG without labels;
//! the SVG embeds these pictures between its labels. The numbers come from `figures`.

mod crowding;
mod disk_kernel;
mod distortion;
mod moebius;
mod pictures;
pub(super) mod plot;
mod raster;
mod surfaces;
pub(super) mod svg;

use super::CliError;
use super::arguments::FigureArguments;
use super::output::{check_paths, print, write_all};
use super::progress::Progress;
use crate::figures::{Detail, Figure, FigureError, Table};
use std::path::{Path, PathBuf};

/// A figure, ready to be written.
struct Drawing {
    svg: String,
    /// Only for figures with textured meshes.
    png: Option<Vec<u8>>,
    table: Table,
    /// The results printed to the terminal.
    findings: Vec<String>,
}

impl From<FigureError> for CliError {
    fn from(error: FigureError) -> Self {
        Self::Input(error.to_string())
    }
}

/// The formats of a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Format {
    Svg,
    Png,
    Csv,
}

/// Computes, draws and writes the figure; prints the choices made where the paper is silent, and the results.
pub fn run(arguments: &FigureArguments) -> Result<(), CliError> {
    let figure = arguments.number.0;
    let outputs = outputs(figure, &arguments.out)?;
    let detail = if arguments.quick { Detail::Quick } else { Detail::Paper };
    let progress = Progress::new(format!("figure {}", figure.number()));
    let drawing = match (&arguments.surface, figure.stand_in()) {
        (None, _) => draw(figure, detail)?,
        (Some(name), Some(_)) => surfaces::draw(figure, detail, Some(name))?,
        (Some(_), None) => {
            let number = figure.number();
            return Err(CliError::Usage(format!("--surface: figure {number} takes no surface, 16 and 17 do")));
        }
    };
    let mut files = Vec::new();
    for (path, format) in &outputs {
        let bytes = match format {
            Format::Svg => drawing.svg.clone().into_bytes(),
            Format::Csv => drawing.table.csv().into_bytes(),
            Format::Png => drawing.png.clone().unwrap_or_default(),
        };
        files.push((path.clone(), bytes));
    }
    for folder in arguments.out.iter().filter(|path| is_folder(path)) {
        let failed = |source| CliError::Write { path: folder.display().to_string(), source };
        std::fs::create_dir_all(folder).map_err(failed)?;
    }
    write_all(&files)?;
    drop(progress);
    print(&report(figure, &drawing, &outputs))
}

fn report(figure: Figure, drawing: &Drawing, outputs: &[(PathBuf, Format)]) -> String {
    let mut lines = vec![format!("Figure {}: {}", figure.number(), figure.title())];
    lines.extend(figure.choices().iter().map(|choice| format!("  choice: {choice}")));
    lines.extend(drawing.findings.iter().map(|finding| format!("  {finding}")));
    lines.extend(outputs.iter().map(|(path, _)| format!("wrote {}", path.display())));
    lines.join("\n")
}

fn draw(figure: Figure, detail: Detail) -> Result<Drawing, CliError> {
    match figure {
        Figure::DiskKernel => disk_kernel::draw(detail),
        Figure::Moebius => moebius::draw(detail),
        Figure::Options => pictures::options(detail),
        Figure::Distortion => distortion::draw(detail),
        Figure::Reshaping => pictures::reshaping(detail),
        Figure::Crowding => crowding::figure_12(detail),
        Figure::Convergence => crowding::figure_15(detail),
        Figure::LShapes | Figure::Head | Figure::Face => surfaces::draw(figure, detail, None),
    }
}

/// The formats available for a figure.
fn formats(figure: Figure) -> &'static [Format] {
    match figure {
        Figure::DiskKernel | Figure::Moebius | Figure::Convergence => &[Format::Svg, Format::Csv],
        _ => &[Format::Svg, Format::Png, Format::Csv],
    }
}

/// A path counts as a folder if it is one or has no extension.
fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.extension().is_none()
}

/// The files to write, with their formats.
fn outputs(figure: Figure, out: &[PathBuf]) -> Result<Vec<(PathBuf, Format)>, CliError> {
    let current = [PathBuf::from(".")];
    let mut outputs = Vec::new();
    for path in if out.is_empty() { &current } else { out } {
        if is_folder(path) {
            outputs.extend(formats(figure).iter().map(|&format| {
                let name = format!("figure-{}.{}", figure.number(), extension(format));
                (if out.is_empty() { PathBuf::from(name) } else { path.join(name) }, format)
            }));
        } else {
            outputs.push((path.clone(), format_of(figure, path)?));
        }
    }
    check_paths(&outputs.iter().map(|(path, _)| path.clone()).collect::<Vec<_>>())?;
    Ok(outputs)
}

fn extension(format: Format) -> &'static str {
    match format {
        Format::Svg => "svg",
        Format::Png => "png",
        Format::Csv => "csv",
    }
}

fn format_of(figure: Figure, path: &Path) -> Result<Format, CliError> {
    let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
    let found = formats(figure).iter().copied().find(|&format| extension(format) == ending);
    found.ok_or_else(|| {
        let names: Vec<&str> = formats(figure).iter().map(|&format| extension(format)).collect();
        let (path, number) = (path.display(), figure.number());
        CliError::Usage(format!("--out {path}: figure {number} comes as {}", names.join(", ")))
    })
}
