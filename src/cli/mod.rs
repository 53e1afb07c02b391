//! The command line: `riemap map`, `flatten`, `render`, `animate`, `link`, `prepare`, `invariants`, `grid`,
//! `project`, `formula`, `figure`, `bench`, `accuracy`; headless and native only.
//!
//! Exit status: 0, 1 for bad input (one line on stderr), 2 for bad usage. Files
//! are written whole or not at all.

mod accuracy;
mod animate;
mod arguments;
mod bench;
mod chain;
#[cfg(all(unix, not(target_vendor = "apple")))]
mod corners;
mod discretization;
mod display;
mod figure;
mod flatten;
mod flatten_arguments;
mod flatten_pins;
mod formula;
mod formula_arguments;
mod grid;
mod grid_arguments;
mod invariants;
mod invariants_arguments;
mod ladder;
mod ladder_arguments;
mod machine;
mod map;
mod map_arguments;
mod marks;
mod moved;
mod named_curve;
mod named_outline;
mod optimization;
mod output;
mod picture;
mod picture_arguments;
mod pins;
mod points;
mod prepare;
mod progress;
mod project;
mod project_arguments;
mod render;
mod repair;
mod side;
mod surface_picture;
mod tables;
mod values;

pub use arguments::{Arguments, Subcommand};
use std::process::ExitCode;

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// The arguments do not make sense: exit status 2.
    #[error("{0}")]
    Usage(String),
    /// An input cannot be used: exit status 1.
    #[error("{0}")]
    Input(String),
    /// An output cannot be written: exit status 1.
    #[error("cannot write {path}: {source}")]
    Write {
        /// The file.
        path: String,
        /// The cause.
        source: std::io::Error,
    },
}

/// To be called first in a program, before a subcommand that may draw: restarts the program (same process, same
/// arguments) if graphics libraries would otherwise report a missing display on stderr.
pub fn silence_display(command: &Subcommand) {
    #[cfg(all(unix, not(target_vendor = "apple")))]
    if !matches!(
        command,
        Subcommand::Link(_)
            | Subcommand::Prepare(_)
            | Subcommand::Invariants(_)
            | Subcommand::Grid(_)
            | Subcommand::Project(_)
            | Subcommand::Formula(_)
            | Subcommand::Bench(_)
            | Subcommand::Accuracy(_)
    ) {
        display::name_one();
    }
    #[cfg(not(all(unix, not(target_vendor = "apple"))))]
    let _ = command;
}

/// Runs a subcommand; prints its error, if any, and returns the exit status.
pub fn run(command: &Subcommand) -> ExitCode {
    let result = match command {
        Subcommand::Map(arguments) => map::run(arguments),
        Subcommand::Flatten(arguments) => flatten::run(arguments),
        Subcommand::Render(arguments) => render::run(arguments),
        Subcommand::Animate(arguments) => animate::run(arguments),
        Subcommand::Link(arguments) => render::link(arguments),
        Subcommand::Prepare(arguments) => prepare::run(arguments),
        Subcommand::Invariants(arguments) => invariants::run(arguments),
        Subcommand::Grid(arguments) => grid::run(arguments),
        Subcommand::Project(arguments) => project::run(arguments),
        Subcommand::Formula(arguments) => formula::run(arguments),
        Subcommand::Figure(arguments) => figure::run(arguments),
        Subcommand::Bench(arguments) => bench::run(arguments),
        Subcommand::Accuracy(arguments) => ladder::run(arguments),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("riemap: {error}");
            ExitCode::from(if matches!(error, CliError::Usage(_)) { 2 } else { 1 })
        }
    }
}
