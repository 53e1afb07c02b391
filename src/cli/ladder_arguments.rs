//! The arguments of `riemap accuracy`.

use std::path::PathBuf;

/// `riemap accuracy`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  riemap accuracy --quick
  riemap accuracy --out accuracy.csv --out accuracy.svg
  riemap accuracy --shape v-shape --shape blob --json")]
pub struct LadderArguments {
    /// Write the table (csv) or the figure (svg) to this file; may be repeated.
    #[arg(long, value_name = "FILE")]
    pub out: Vec<PathBuf>,
    /// Only this outline; may be repeated.
    #[arg(long, value_name = "NAME")]
    pub shape: Vec<ShapeArgument>,
    /// Print the machine, the errors and the times as JSON on stdout.
    #[arg(long)]
    pub json: bool,
    /// Fewer and coarser resolutions, each measured once.
    #[arg(long)]
    pub quick: bool,
}

/// An outline of the ladder.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[allow(missing_docs, reason = "the names are those of the outlines")]
pub enum ShapeArgument {
    Disk,
    Ellipse,
    Square,
    RoundedSquare,
    LShape,
    Rectangle,
    VShape,
    Blob,
    Quintic,
    Notch,
    Clef,
    Coast,
}
