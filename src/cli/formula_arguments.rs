//! The arguments of `riemap formula`.

use super::CliError;
use super::discretization::{Discretization, InterpretArgument, KernelArgument, SamplingArgument, SolverArgument};
use super::map_arguments::{PointArguments, SampleArguments};
use super::side::Asked;
use crate::conformal::PerSide;
use std::path::PathBuf;

/// `riemap formula SOURCE TARGET`.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  riemap formula preset:blob preset:disk --out blob.json --out blob.py
  riemap formula preset:disk preset:square --digits 6 --source-point 0.3,0.2 --out map.js --out map.glsl")]
pub struct FormulaArguments {
    /// The source: an outline, as a file (JSON, CSV, text, SVG, GeoJSON) or `preset:NAME`.
    pub source: String,
    /// The target: an outline, given like the source.
    pub target: String,
    /// The number of digits to reach, relative to half the larger side of the box around the values. Fewer may be
    /// possible: then a warning says how many, and the exit status is 0.
    #[arg(long, value_name = "N", default_value_t = 8,
        value_parser = clap::value_parser!(u32).range(1..=13))]
    pub digits: u32,
    /// The constraints.
    #[command(flatten)]
    pub points: PointArguments,
    /// Number of boundary samples of the mesh, on which the formula hardly depends.
    #[arg(long, value_name = "N")]
    pub samples: Option<u32>,
    /// The same for one side.
    #[command(flatten)]
    pub side_samples: SampleArguments,
    /// What an outline's points are taken for, as for `riemap map`.
    #[arg(long, default_value = "auto")]
    pub interpret: InterpretArgument,
    /// How files are read.
    #[command(flatten)]
    pub reading: super::named_outline::ReadingArguments,
    /// Write the formula to this file; may be repeated; the extension selects the format: json (all numbers), or code
    /// with the functions f and f_inverse: py (Python), jl (Julia), js (JavaScript), glsl (single precision: at most 5
    /// digits).
    #[arg(long, value_name = "FILE")]
    pub out: Vec<PathBuf>,
    /// Print degrees, errors and digits as JSON on stdout.
    #[arg(long)]
    pub json: bool,
}

impl FormulaArguments {
    /// How the sides are prepared: with the boundary integral.
    pub fn discretization(&self) -> Discretization {
        Discretization {
            samples: self.samples,
            sampling: SamplingArgument::Adaptive,
            keep_corners: false,
            sizing: None,
            kernel: Some(KernelArgument::Integral),
            solver: SolverArgument::Direct,
            interpret: self.interpret,
        }
    }

    /// What messages call the sides: by their names, with "source" and "target" where the names are the same.
    pub fn titles(&self) -> PerSide<String> {
        let Self { source, target, .. } = self;
        if source == target {
            PerSide::new(format!("{source} (source)"), format!("{target} (target)"))
        } else {
            PerSide::new(source.clone(), target.clone())
        }
    }

    /// The arguments of each side. Errors: an option is given more than once.
    pub fn asked<'a>(&'a self, titles: &'a PerSide<String>) -> Result<[Asked<'a>; 2], CliError> {
        let (points, samples) = (&self.points, &self.side_samples);
        let (target_point, target_anchor) = self.points.of_targets(1)?[0];
        Ok([
            Asked {
                name: &self.source,
                title: &titles.source,
                samples: samples.source_samples,
                point: ("--source-point", points.source_point),
                anchor: ("--source-anchor", points.source_anchor),
            },
            Asked {
                name: &self.target,
                title: &titles.target,
                samples: samples.target_samples,
                point: ("--target-point", target_point),
                anchor: ("--target-anchor", target_anchor),
            },
        ])
    }
}
