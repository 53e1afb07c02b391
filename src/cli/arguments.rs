//! The command line's subcommands, and the arguments of the short ones.

use super::discretization::Discretization;
use super::flatten_arguments::FlattenArguments;
use super::formula_arguments::FormulaArguments;
use super::grid_arguments::GridArguments;
use super::invariants_arguments::InvariantsArguments;
use super::ladder_arguments::LadderArguments;
use super::map_arguments::MapArguments;
use super::picture_arguments::{AnimateArguments, LinkArguments, RenderArguments};
use super::project_arguments::ProjectArguments;
use super::values::FigureNumber;
use std::path::PathBuf;

/// Real-time conformal maps between outlines or surfaces.
///
/// Without a subcommand, opens the app in a window.
#[derive(Debug, clap::Parser)]
#[command(version, about)]
pub struct Arguments {
    /// The headless command.
    #[command(subcommand)]
    pub command: Option<Subcommand>,
}

/// The headless commands.
#[derive(Debug, clap::Subcommand)]
pub enum Subcommand {
    /// Computes a conformal map between two outlines or surfaces and writes it.
    Map(Box<MapArguments>),
    /// Parameterizes a surface over an outline and writes it with texture coordinates.
    Flatten(Box<FlattenArguments>),
    /// Draws the picture that the app shows of a session, or writes its map as another file.
    Render(Box<RenderArguments>),
    /// Makes an animation of a loop through all maps of one domain onto the other.
    Animate(Box<AnimateArguments>),
    /// Prints a session as a link: the text that follows the app's address and #.
    Link(LinkArguments),
    /// Prepares one outline and prints counts and timings.
    Prepare(PrepareArguments),
    /// Computes conformal invariants of an outline to many digits, each with its error: harmonic measure, conformal
    /// radius, capacity, modulus, hyperbolic distance.
    Invariants(InvariantsArguments),
    /// Divides an outline between four marks by an orthogonal grid, the image of a rectangle's under the conformal map.
    Grid(GridArguments),
    /// Maps a region of the sphere, such as a country, conformally into the plane with the least variation of scale.
    Project(ProjectArguments),
    /// Writes the map between two outlines, and its inverse, as rational functions: as numbers or as code.
    Formula(Box<FormulaArguments>),
    /// Reproduces a figure of the paper: a drawing and a table of its numbers.
    Figure(FigureArguments),
    /// Measures Tables 1 and 2 of the paper on this machine.
    Bench(BenchArguments),
    /// Measures the errors of all methods on outlines whose maps are known, and their times on this machine.
    Accuracy(LadderArguments),
}

/// `riemap prepare DOMAIN`.
#[derive(Debug, clap::Args)]
pub struct PrepareArguments {
    /// The outline, given as a file or `preset:NAME`.
    pub domain: String,
    /// How its file is read.
    #[command(flatten)]
    pub reading: super::named_outline::ReadingArguments,
    /// How the domain is discretized.
    #[command(flatten)]
    pub discretization: Discretization,
    /// Prepare this many times and report the median of each stage.
    #[arg(long, value_name = "K", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub repeat: u32,
    /// Print counts and timings as JSON on stdout.
    #[arg(long)]
    pub json: bool,
}

/// `riemap figure N`.
#[derive(Debug, clap::Args)]
pub struct FigureArguments {
    /// The figure's number in the paper: 6, 7, 8, 9, 10, 12, 14, 15, 16 or 17.
    pub number: FigureNumber,
    /// The surface of figures 16 and 17: a file (obj, ply, stl, off, gltf, glb) or `preset:NAME[:M]` [default: riemap's
    /// animal head and its height field, since the paper's meshes are not part of riemap].
    #[arg(long, value_name = "FILE")]
    pub surface: Option<String>,
    /// Write into this folder (created if absent), or to this file (.svg, .csv, and .png for figures that show meshes);
    /// may be repeated [default: the current folder, all formats].
    #[arg(long, value_name = "FOLDER|FILE")]
    pub out: Vec<PathBuf>,
    /// Use a quarter of the paper's boundary samples.
    #[arg(long)]
    pub quick: bool,
}

/// `riemap bench`.
#[derive(Debug, clap::Args)]
pub struct BenchArguments {
    /// Print the machine, the times and the paper's times as JSON on stdout.
    #[arg(long)]
    pub json: bool,
    /// Measure every row once instead of taking the median of five runs, and skip the table of Ψ.
    #[arg(long)]
    pub quick: bool,
}
