//! The arguments of the command line, and their conversion to the core's types.

use super::named_outline::NamedOutline;
use super::side::{SideAnchor, SidePoint};
use super::values::{FigureNumber, Size, SizingArgument};
use crate::conformal::{KernelMode, PrepareSettings, Side};
use crate::laplace::SolverKind;
use crate::mesh::Sizing;
use crate::outline::{Interpretation, Sampling};
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
    Map(MapArguments),
    /// Parameterizes a surface over an outline and writes it with texture coordinates.
    Flatten(Box<super::flatten_arguments::FlattenArguments>),
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
    Invariants(super::invariants_arguments::InvariantsArguments),
    /// Writes the map between two outlines, and its inverse, as rational functions: as numbers or as code.
    Formula(Box<super::formula_arguments::FormulaArguments>),
    /// Reproduces a figure of the paper: a drawing and a table of its numbers.
    Figure(FigureArguments),
    /// Measures Tables 1 and 2 of the paper on this machine.
    Bench(BenchArguments),
    /// Measures the errors of all methods on outlines whose maps are known, and their times on this machine.
    Accuracy(super::ladder_arguments::LadderArguments),
}

/// `riemap map SOURCE TARGET`.
#[derive(Debug, clap::Args)]
pub struct MapArguments {
    /// The source: an outline, as a file (JSON, CSV, text, SVG, GeoJSON) or `preset:NAME`; or a surface, as a file
    /// (obj, ply, stl, off, gltf, glb) or `preset:NAME[:M]` with M boundary vertices.
    pub source: String,
    /// The target: an outline or a surface, given like the source.
    pub target: String,
    /// The constraints.
    #[command(flatten)]
    pub points: PointArguments,
    /// The numbers of boundary samples.
    #[command(flatten)]
    pub samples: SampleArguments,
    /// Cut off small loops and spikes of a file's outline instead of refusing it, and make all safe repairs of a
    /// surface.
    #[arg(long)]
    pub repair: bool,
    /// Use a surface's own cotangent weights, even negative ones, instead of flipping its edges to be Delaunay.
    #[arg(long)]
    pub no_intrinsic_delaunay: bool,
    /// How outlines are discretized; kernel and solver apply to surfaces too.
    #[command(flatten)]
    pub discretization: Discretization,
    /// Which mesh is mapped: the source's forward, or the target's backward into the source. If only one side is a
    /// surface, its mesh is mapped.
    #[arg(long, default_value = "backward")]
    pub direction: DirectionArgument,
    /// How the boundary map is extended into that mesh; with a surface, always harmonically.
    #[arg(long, default_value = "harmonic")]
    pub extension: ExtensionArgument,
    /// Whether the mapped mesh is refined where images are long, so that they fill the other outline without folds;
    /// auto: with adaptive samples and graded triangles, the defaults, and not with the table.
    #[arg(long, default_value = "auto")]
    pub refine: RefineArgument,
    /// Write the map to this file; may be repeated; the extension selects the format: json, csv, obj, svg, png.
    #[arg(long, value_name = "FILE")]
    pub out: Vec<PathBuf>,
    /// Points at which the map is evaluated.
    #[command(flatten)]
    pub evaluate: super::points::PointsArguments,
    /// Size of a .png in pixels.
    #[arg(long, value_name = "WxH", default_value = "1600x900")]
    pub size: Size,
    /// Print quality, timings and counts as JSON on stdout.
    #[arg(long)]
    pub json: bool,
}

/// The constraints of a map.
#[derive(Debug, clap::Args)]
pub struct PointArguments {
    /// x₁, inside the source. In an outline, X,Y [default: its pole of inaccessibility]; in a surface, vertex V,
    /// triangle F with weights, or the point nearest to X,Y,Z [default: the vertex farthest from the boundary].
    #[arg(long, value_name = "X,Y|V|F:A,B,C|X,Y,Z", allow_hyphen_values = true)]
    pub source_point: Option<SidePoint>,
    /// x₂, the image of x₁, inside the target; same forms and defaults as x₁.
    #[arg(long, value_name = "X,Y|V|F:A,B,C|X,Y,Z", allow_hyphen_values = true)]
    pub target_point: Option<SidePoint>,
    /// y₁, on the boundary of the source: the boundary point nearest to X,Y (outline) or X,Y,Z (surface), a surface's
    /// boundary vertex V, or the point at fraction S of the boundary's length from its first point.
    #[arg(long, value_name = "X,Y|X,Y,Z|V|@S", default_value = "@0", allow_hyphen_values = true)]
    pub source_anchor: SideAnchor,
    /// y₂, the image of y₁, on the boundary of the target; same forms as y₁.
    #[arg(long, value_name = "X,Y|X,Y,Z|V|@S", default_value = "@0", allow_hyphen_values = true)]
    pub target_anchor: SideAnchor,
}

/// Numbers of boundary samples, one for each side.
#[derive(Debug, clap::Args)]
pub struct SampleArguments {
    /// Number of boundary samples of the source.
    #[arg(long, value_name = "N", conflicts_with = "samples")]
    pub source_samples: Option<u32>,
    /// Number of boundary samples of the target.
    #[arg(long, value_name = "N", conflicts_with = "samples")]
    pub target_samples: Option<u32>,
}

/// A session, and the files that its link does not contain.
#[derive(Debug, clap::Args)]
pub struct SessionArguments {
    /// The session: a link, the part of a link after #, or a session's file (.riemap).
    pub link: String,
    /// The source's outline, if the link says that it is a separate file.
    #[arg(long, value_name = "FILE")]
    pub source: Option<String>,
    /// The target's outline, if the link says that it is a separate file.
    #[arg(long, value_name = "FILE")]
    pub target: Option<String>,
    /// The surface, if the session's surface comes from a file; if both sides' surfaces do, give the option twice: files
    /// go to the surfaces of their names, others to the source's first, then the target's.
    #[arg(long, value_name = "FILE")]
    pub surface: Vec<String>,
}

/// `riemap render LINK`.
#[derive(Debug, clap::Args)]
pub struct RenderArguments {
    /// The session.
    #[command(flatten)]
    pub session: SessionArguments,
    /// The file to write; the extension selects the format: png, svg (outlines, lines of the pattern, edges), csv (the
    /// boundary correspondence), obj (the mapped mesh); for a surface with its texture coordinates obj, ply, glb, csv,
    /// svg.
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Size of a .png in pixels.
    #[arg(long, value_name = "WxH", default_value = "1600x900")]
    pub size: Size,
    /// Dark or light background of a .png.
    #[arg(long, default_value = "dark")]
    pub theme: ThemeArgument,
    /// Write a .png with a transparent background.
    #[arg(long)]
    pub transparent: bool,
    /// Write a .png without the dots of interior and boundary points.
    #[arg(long)]
    pub no_dots: bool,
    /// Draw only this side in a .png or .svg [default: both, side by side].
    #[arg(long)]
    pub side: Option<SideArgument>,
}

/// `riemap animate LINK`.
#[derive(Debug, clap::Args)]
pub struct AnimateArguments {
    /// The session at which the loop begins and ends.
    #[command(flatten)]
    pub session: SessionArguments,
    /// The file to write; the extension selects the format: png (animated, all colors) or gif (256 colors per frame).
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Size of the animation in pixels.
    #[arg(long, value_name = "WxH", default_value = "800x450")]
    pub size: Size,
    /// Number of frames.
    #[arg(long, value_name = "N", default_value_t = 60)]
    pub frames: u32,
    /// Duration of one loop in seconds.
    #[arg(long, value_name = "S", default_value_t = 4.0)]
    pub seconds: f64,
    /// Which points move along closed paths.
    #[arg(long, default_value = "boundary")]
    pub path: PathArgument,
    /// Dark or light background.
    #[arg(long, default_value = "dark")]
    pub theme: ThemeArgument,
    /// Make the background transparent.
    #[arg(long)]
    pub transparent: bool,
    /// Leave out the dots of interior and boundary points.
    #[arg(long)]
    pub no_dots: bool,
    /// Draw only this side [default: both, side by side].
    #[arg(long)]
    pub side: Option<SideArgument>,
}

/// Which points move in an animation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum PathArgument {
    /// x₁, around the largest circle through it whose distance from the source's outline is a quarter of its radius.
    Interior,
    /// x₂, around a circle in the target, chosen in the same way.
    TargetInterior,
    /// y₁, once around the source: equal times are equal harmonic measures.
    Boundary,
    /// All of them, x₂ in the opposite direction.
    #[value(alias = "both")]
    All,
}

/// One side of a picture, or both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum SideArgument {
    Both,
    Source,
    Target,
}

impl SideArgument {
    /// The side, or `None` for both.
    pub fn side(self) -> Option<Side> {
        match self {
            Self::Both => None,
            Self::Source => Some(Side::Source),
            Self::Target => Some(Side::Target),
        }
    }
}

/// `riemap link SESSION.riemap`.
#[derive(Debug, clap::Args)]
pub struct LinkArguments {
    /// The session's file (.riemap), or a link to rewrite in the current form.
    pub session: String,
}

/// The background of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum ThemeArgument {
    Dark,
    Light,
}

/// `riemap prepare DOMAIN`.
#[derive(Debug, clap::Args)]
pub struct PrepareArguments {
    /// The outline, given as a file or `preset:NAME`.
    pub domain: String,
    /// Cut off small loops and spikes of a file's outline instead of refusing it.
    #[arg(long)]
    pub repair: bool,
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
    /// coordinates [default: integral for the outlines of `map`, adjoint for surfaces, `flatten` and `prepare`].
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

/// Which mesh is mapped.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum DirectionArgument {
    Forward,
    Backward,
}

/// How the boundary map is extended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum ExtensionArgument {
    Harmonic,
    CauchyGreen,
    /// As --points: by Cauchy's integral over the boundary map, each vertex on its own; the mesh is not refined.
    Exact,
}

/// Whether the mapped mesh is refined for the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum RefineArgument {
    Auto,
    On,
    Off,
}

impl RefineArgument {
    /// Whether a map of an outline at these settings is refined.
    pub fn refines(self, settings: &PrepareSettings) -> bool {
        match self {
            Self::Auto => settings.is_refined(),
            Self::On => true,
            Self::Off => false,
        }
    }
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
