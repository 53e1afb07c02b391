//! The arguments of `riemap grid`.

use super::discretization::InterpretArgument;
use super::marks::MarkArguments;
use crate::conformal::{GridCells, MOST_CELLS};
use std::path::PathBuf;
use std::str::FromStr;

/// `riemap grid OUTLINE`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  riemap grid preset:l-shape --marks 0,0.25,0.625,0.75 --cells 40x20 --out grid.csv --out grid.svg
  riemap grid outline.svg --marks 0.1,0.4,0.6,0.9 --cells 64x32 --out grid.vtk --json")]
pub struct GridArguments {
    /// The outline, given as a file (JSON, CSV, text, SVG, GeoJSON) or `preset:NAME`.
    pub outline: String,
    /// The four corners of the grid.
    #[command(flatten)]
    pub marks: MarkArguments,
    /// The number of cells from mark 1 to mark 2 and from mark 2 to mark 3; each at most 1000.
    #[arg(long, value_name = "NxM", allow_hyphen_values = true)]
    pub cells: CellsArgument,
    /// What an outline's points are taken for, as for `riemap map`.
    #[arg(long, default_value = "auto")]
    pub interpret: InterpretArgument,
    /// How its file is read.
    #[command(flatten)]
    pub reading: super::named_outline::ReadingArguments,
    /// Write the grid to this file; may be repeated; the extension selects the format: csv (rows i,j,x,y), svg (outline
    /// and lines), obj (the cells as quadrilaterals), vtk (legacy, a structured grid).
    #[arg(long, value_name = "FILE")]
    pub out: Vec<PathBuf>,
    /// Print modulus, angles and errors as JSON on stdout.
    #[arg(long)]
    pub json: bool,
}

/// Two numbers of cells, `NxM`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CellsArgument(pub GridCells);

impl FromStr for CellsArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let counts = text.split_once('x').and_then(|(n, m)| Some([n.trim().parse().ok()?, m.trim().parse().ok()?]));
        let cells = counts.and_then(GridCells::new).map(Self);
        cells.ok_or_else(|| format!("expected NxM, each from 1 to {MOST_CELLS}, such as 40x20"))
    }
}
