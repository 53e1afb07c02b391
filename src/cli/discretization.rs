//! The arguments that say how an outline is discretized, shared by several commands, and their conversion to the core's
//! types.

use super::named_outline::NamedOutline;
use super::values::SizingArgument;
use crate::conformal::{KernelMode, PrepareSettings};
use crate::laplace::SolverKind;
use crate::mesh::Sizing;
use crate::outline::{Interpretation, Sampling};

/// Options that `map` and `prepare` share.
#[derive(Debug, clap::Args)]
pub struct Discretization {
    /// Number of boundary samples [default for adaptive sampling: as many as the outline needs; for uniform
    /// sampling: the paper's number, or 500].
    #[arg(long, value_name = "N")]
    pub samples: Option<u32>,
    /// Spacing of the samples: uniform in arc length, or denser where the outline needs it.
    #[arg(long, default_value = "adaptive")]
    pub sampling: SamplingArgument,
    /// Use the outline's corners as samples (adaptive sampling does so unless they are more than half of its samples).
    #[arg(long)]
    pub keep_corners: bool,
    /// Triangle size: uniform, or growing by G per unit of distance from the boundary [default: graded].
    #[arg(long, value_name = "uniform|graded:G")]
    pub sizing: Option<SizingArgument>,
    /// How harmonic measure is computed: from an integral equation on the curve of an outline, to ten digits and more;
    /// or with finite elements, by one adjoint solve for each point or from the paper's table of all harmonic
    /// coordinates [default: integral for the outlines of `map` and `flatten`, adjoint for surfaces and `prepare`].
    #[arg(long)]
    pub kernel: Option<KernelArgument>,
    /// How linear systems are solved: with a complete Cholesky factor, or iteratively with an incomplete one.
    #[arg(long, default_value = "direct")]
    pub solver: SolverArgument,
    /// What an outline's points are taken for: straight edges between corners, or a smooth curve. "auto" takes the curve
    /// of a preset or an SVG path, and a smooth curve between the corners of 64 points or more; "smooth" tries that with
    /// fewer too.
    #[arg(long, default_value = "auto")]
    pub interpret: InterpretArgument,
}

/// What an outline's points are taken for.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum InterpretArgument {
    Auto,
    Polygon,
    Smooth,
}

impl From<InterpretArgument> for Interpretation {
    fn from(argument: InterpretArgument) -> Self {
        match argument {
            InterpretArgument::Auto => Self::Auto,
            InterpretArgument::Polygon => Self::Polygon,
            InterpretArgument::Smooth => Self::Smooth,
        }
    }
}

/// How kernels are computed.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum KernelArgument {
    Adjoint,
    Table,
    Integral,
}

/// How linear systems are solved.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum SolverArgument {
    Direct,
    Pcg,
}

/// How the boundary is sampled.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum SamplingArgument {
    Uniform,
    Adaptive,
}

impl Discretization {
    /// The settings for one outline, with the adjoint kernel if none is given; `samples` overrides the number for both
    /// sides.
    pub fn settings(&self, outline: &NamedOutline, samples: Option<u32>) -> PrepareSettings {
        let samples = samples.or(self.samples);
        let sampling = match self.sampling {
            SamplingArgument::Uniform => Sampling::Uniform {
                count: samples.or(outline.paper_samples()).unwrap_or(500),
                keep_corners: self.keep_corners,
            },
            SamplingArgument::Adaptive => Sampling::Adaptive { target: samples },
        };
        PrepareSettings {
            sampling,
            sizing: self.sizing.map_or_else(Sizing::default, |sizing| sizing.0),
            kernel: self.kernel_or(KernelMode::Adjoint),
            solver: self.solver_kind(),
        }
    }

    /// The selected kernel mode; `default` if none is given.
    pub fn kernel_or(&self, default: KernelMode) -> KernelMode {
        match self.kernel {
            None => default,
            Some(KernelArgument::Adjoint) => KernelMode::Adjoint,
            Some(KernelArgument::Table) => KernelMode::Table,
            Some(KernelArgument::Integral) => KernelMode::Integral,
        }
    }

    /// The selected solver.
    pub fn solver_kind(&self) -> SolverKind {
        match self.solver {
            SolverArgument::Direct => SolverKind::Direct,
            SolverArgument::Pcg => SolverKind::Pcg,
        }
    }
}
