//! `riemap grid`: an orthogonal grid between four marks of an outline, in files.

use super::CliError;
use super::grid_arguments::GridArguments;
use super::invariants::Number;
use super::named_curve::NamedCurve;
use super::output::{check_paths, print, write_all};
use super::progress::Progress;
use crate::boundary_integral::Estimate;
use crate::conformal::{OrthogonalGrid, Quadrilateral, QuadrilateralError};
use crate::export::GridFormat;
use std::path::{Path, PathBuf};

/// Computes the grid, writes the files and prints the summary.
pub fn run(arguments: &GridArguments) -> Result<(), CliError> {
    let formats = arguments.out.iter().map(|path| format_of(path)).collect::<Result<Vec<_>, _>>()?;
    check_paths(&arguments.out)?;
    let progress = Progress::new("reading");
    let given = NamedCurve::read(&arguments.outline, &arguments.reading.one(&arguments.outline)?, arguments.interpret)?;
    let none = || CliError::Usage("a grid needs four marks: --marks, or --mark four times".to_owned());
    let marks = arguments.marks.on(&given)?.ok_or_else(none)?.marks;
    let NamedCurve { curve, polygon, .. } = given;
    let refused = |error: QuadrilateralError| CliError::Input(format!("{}: {error}", arguments.outline));
    progress.enter("the integral equation");
    let quadrilateral = Quadrilateral::of_outline((&polygon, &curve), marks).map_err(refused)?;
    progress.enter("the map");
    let map = quadrilateral.map().map_err(refused)?;
    progress.enter("the grid");
    let is_never_cancelled = &mut |done| {
        progress.report(done);
        true
    };
    let Some(grid) = map.grid(arguments.cells.0, is_never_cancelled) else { return Ok(()) };
    let file = |(path, format): (&PathBuf, GridFormat)| (path.clone(), format.text(&grid, &map, &curve).into_bytes());
    let files: Vec<(PathBuf, Vec<u8>)> = arguments.out.iter().zip(formats).map(file).collect();
    write_all(&files)?;
    drop(progress);
    let report = Report::new(&quadrilateral, &grid);
    if arguments.json {
        let text = serde_json::to_string_pretty(&report).map_err(|error| CliError::Input(error.to_string()))?;
        return print(&text);
    }
    print(&report.table())
}

fn format_of(path: &Path) -> Result<GridFormat, CliError> {
    let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    GridFormat::from_extension(extension)
        .ok_or_else(|| CliError::Usage(format!("--out {}: the extension must be csv, svg, obj or vtk", path.display())))
}

/// The report of `--json`.
#[derive(Debug, serde::Serialize)]
struct Report {
    /// The extremal distance between the sides from mark 1 to 2 and from mark 3 to 4.
    modulus: Number,
    cells: [u32; 2],
    /// The largest deviation of the lines' tangents from 90° at interior nodes, in degrees.
    angle_deviation: Option<f64>,
    /// The estimated error of a node, the largest one.
    image_error: f64,
    corners: [[f64; 2]; 4],
}

impl Report {
    fn new(quadrilateral: &Quadrilateral, grid: &OrthogonalGrid) -> Self {
        Self {
            modulus: quadrilateral.modulus().into(),
            cells: grid.cells().counts(),
            angle_deviation: grid.deviation(),
            image_error: grid.image_error(),
            corners: grid.corners().map(|corner| corner.to_array()),
        }
    }

    /// One line for each number.
    fn table(&self) -> String {
        let Estimate { value, error } = self.modulus.estimate();
        let [n, m] = self.cells;
        let mut lines = vec![
            format!("{:<16} {value} ± {error:.1e}", "modulus"),
            format!("{:<16} {n} x {m}", "cells"),
            format!("{:<16} {:.1e}", "error of nodes", self.image_error),
        ];
        if let Some(deviation) = self.angle_deviation {
            lines.push(format!("{:<16} 90° ± {deviation:.1e}°", "angles"));
        }
        lines.join("\n")
    }
}
