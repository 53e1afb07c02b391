//! The arguments of the command line, and their conversion to the core's types.

use super::CliError;
use super::side::{SideAnchor, SidePoint};
use super::values::{FigureNumber, Size, SizingArgument};
use crate::conformal::{KernelMode, PrepareSettings, Side};
use crate::laplace::SolverKind;
use crate::mesh::Sizing;
use crate::outline::{self, Outline, Preset, Sampling};
use std::io::Read as _;
use std::path::PathBuf;
use std::str::FromStr;

/// Real-time conformal maps between outlines or surfaces.
///
/// Without a subcommand, opens the app in a window.
#[derive(Debug, clap::Parser)]
#[command(version, about)]
pub struct Arguments {
    /// What to do headless.
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
    /// Prints the link of a session's file: what comes after the app's address and #.
    Link(LinkArguments),
    /// Prepares one outline; prints counts and timings.
    Prepare(PrepareArguments),
    /// Makes a figure of the paper anew: a drawing and a table of its numbers.
    Figure(FigureArguments),
    /// Measures Tables 1 and 2 of the paper on this machine.
    Bench(BenchArguments),
}

/// `riemap map SOURCE TARGET`.
#[derive(Debug, clap::Args)]
pub struct MapArguments {
    /// The source: an outline, as a file (JSON, CSV, text, SVG, GeoJSON) or `preset:NAME`, or a surface, as a file (obj,
    /// ply, stl, off, gltf, glb) or `preset:NAME[:M]` with M boundary vertices.
    pub source: String,
    /// The target, likewise.
    pub target: String,
    /// x₁, x₂, y₁ and y₂.
    #[command(flatten)]
    pub points: PointArguments,
    /// How many boundary samples each side has.
    #[command(flatten)]
    pub samples: SampleArguments,
    /// Cut off small loops and spikes of a file's outline instead of refusing it, and make the repairs of a surface that
    /// are safe.
    #[arg(long)]
    pub repair: bool,
    /// Use a surface's own cotangent weights, negative ones too, instead of flipping edges to be Delaunay.
    #[arg(long)]
    pub no_intrinsic_delaunay: bool,
    /// How outlines are discretised; kernel and solver are the surfaces' too.
    #[command(flatten)]
    pub discretisation: Discretisation,
    /// Which mesh is mapped: the source's, or the target's back into the source. With one surface, the surface's.
    #[arg(long, default_value = "backward")]
    pub direction: DirectionArgument,
    /// How the boundary map is extended into that mesh; with a surface, harmonically.
    #[arg(long, default_value = "harmonic")]
    pub extension: ExtensionArgument,
    /// Write the map; repeatable; the format follows the extension: json, csv, obj, svg, png.
    #[arg(long, value_name = "FILE")]
    pub out: Vec<PathBuf>,
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
    /// x₁, inside the source: X,Y in an outline [default: its pole of inaccessibility]; in a surface vertex V, or triangle F
    /// with weights, or the point nearest to X,Y,Z [default: the vertex farthest from the boundary].
    #[arg(long, value_name = "X,Y|V|F:A,B,C|X,Y,Z", allow_hyphen_values = true)]
    pub source_point: Option<SidePoint>,
    /// x₂, inside the target, the image of x₁, likewise.
    #[arg(long, value_name = "X,Y|V|F:A,B,C|X,Y,Z", allow_hyphen_values = true)]
    pub target_point: Option<SidePoint>,
    /// y₁: the boundary point nearest to X,Y, or of a surface to X,Y,Z, or its boundary vertex V; or at fraction S of the
    /// boundary's length from the first point.
    #[arg(long, value_name = "X,Y|X,Y,Z|V|@S", default_value = "@0", allow_hyphen_values = true)]
    pub source_anchor: SideAnchor,
    /// y₂, the image of y₁, likewise on the target.
    #[arg(long, value_name = "X,Y|X,Y,Z|V|@S", default_value = "@0", allow_hyphen_values = true)]
    pub target_anchor: SideAnchor,
}

/// Numbers of boundary samples, for each side its own.
#[derive(Debug, clap::Args)]
pub struct SampleArguments {
    /// Boundary samples of the source.
    #[arg(long, value_name = "N", conflicts_with = "samples")]
    pub source_samples: Option<u32>,
    /// Boundary samples of the target.
    #[arg(long, value_name = "N", conflicts_with = "samples")]
    pub target_samples: Option<u32>,
}

/// A session, with what travels as files of its own.
#[derive(Debug, clap::Args)]
pub struct SessionArguments {
    /// A link, or the part of it after #, or a session's file (.riemap).
    pub link: String,
    /// The source's outline, where the link says that it travels as a file.
    #[arg(long, value_name = "FILE")]
    pub source: Option<String>,
    /// The target's outline, likewise.
    #[arg(long, value_name = "FILE")]
    pub target: Option<String>,
    /// The surface, where the session's comes from a file; where both sides' do, the source's first and then once more the
    /// target's.
    #[arg(long, value_name = "FILE")]
    pub surface: Vec<String>,
}

/// `riemap render LINK`.
#[derive(Debug, clap::Args)]
pub struct RenderArguments {
    /// The session.
    #[command(flatten)]
    pub session: SessionArguments,
    /// The file; the format follows the extension: png, or svg (outlines, lines of the pattern, edges), csv (the boundary
    /// correspondence), obj (the mapped mesh); of a surface with its texture coordinates obj, ply, glb, csv, svg.
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Size of a .png in pixels.
    #[arg(long, value_name = "WxH", default_value = "1600x900")]
    pub size: Size,
    /// Dark or light ground of a .png.
    #[arg(long, default_value = "dark")]
    pub theme: ThemeArgument,
    /// A .png without the ground.
    #[arg(long)]
    pub transparent: bool,
    /// Only one side of a .png or .svg [default: both, side by side].
    #[arg(long)]
    pub side: Option<SideArgument>,
}

/// `riemap animate LINK`.
#[derive(Debug, clap::Args)]
pub struct AnimateArguments {
    /// The session at which the loop begins and ends.
    #[command(flatten)]
    pub session: SessionArguments,
    /// The animation; the format follows the extension: png (animated, all colours) or gif (256 colours a frame).
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Its size in pixels.
    #[arg(long, value_name = "WxH", default_value = "800x450")]
    pub size: Size,
    /// How many pictures it has.
    #[arg(long, value_name = "N", default_value_t = 60)]
    pub frames: u32,
    /// How long a turn takes.
    #[arg(long, value_name = "S", default_value_t = 4.0)]
    pub seconds: f64,
    /// What moves.
    #[arg(long, default_value = "boundary")]
    pub path: PathArgument,
    /// Dark or light ground.
    #[arg(long, default_value = "dark")]
    pub theme: ThemeArgument,
    /// Without the ground.
    #[arg(long)]
    pub transparent: bool,
    /// Only one side [default: both, side by side].
    #[arg(long)]
    pub side: Option<SideArgument>,
}

/// What moves in an animation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum PathArgument {
    /// x₁, around the largest circle through it that keeps a quarter of its radius from the source's outline.
    Interior,
    /// x₂, likewise in the target.
    TargetInterior,
    /// y₁, once around the source: equal times are equal harmonic measures.
    Boundary,
    /// All of them, x₂ the other way around.
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
    /// The session's file (.riemap), or a link to be written anew.
    pub session: String,
}

/// The ground of a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum ThemeArgument {
    Dark,
    Light,
}

/// `riemap prepare DOMAIN`.
#[derive(Debug, clap::Args)]
pub struct PrepareArguments {
    /// The outline: a file or `preset:NAME`.
    pub domain: String,
    /// Cut off small loops and spikes of a file's outline instead of refusing it.
    #[arg(long)]
    pub repair: bool,
    /// How the domain is discretised.
    #[command(flatten)]
    pub discretisation: Discretisation,
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
    /// own animal head, and its height field; the paper's meshes are not part of riemap].
    #[arg(long, value_name = "FILE")]
    pub surface: Option<String>,
    /// Write into this folder (made if absent), or to this file (.svg, .csv, and .png where meshes are shown);
    /// repeatable [default: the current folder, all formats].
    #[arg(long, value_name = "FOLDER|FILE")]
    pub out: Vec<PathBuf>,
    /// Use a quarter of the paper's boundary samples.
    #[arg(long)]
    pub quick: bool,
}

/// `riemap bench`.
#[derive(Debug, clap::Args)]
pub struct BenchArguments {
    /// Print machine, times and the paper's times as JSON on stdout.
    #[arg(long)]
    pub json: bool,
    /// Measure every row once instead of taking the median of five runs, and no table of Ψ.
    #[arg(long)]
    pub quick: bool,
}

/// Options that `map` and `prepare` share.
#[derive(Debug, clap::Args)]
pub struct Discretisation {
    /// Boundary samples [default: what an adaptive sampling needs; the paper's number for a uniform one, else 500].
    #[arg(long, value_name = "N")]
    pub samples: Option<u32>,
    /// Uniform in arc length, or denser where the outline needs it.
    #[arg(long, default_value = "adaptive")]
    pub sampling: SamplingArgument,
    /// Makes the outline's corners samples (adaptive sampling does so unless they are more than half of its samples).
    #[arg(long)]
    pub keep_corners: bool,
    /// Triangle size: uniform, or growing by G per distance from the boundary [default: graded].
    #[arg(long, value_name = "uniform|graded:G")]
    pub sizing: Option<SizingArgument>,
    /// How kernels are computed: by one adjoint solve each, or from the paper's table of all harmonic coordinates.
    #[arg(long, default_value = "adjoint")]
    pub kernel: KernelArgument,
    /// How linear systems are solved: by a complete Cholesky factor, or iteratively with an incomplete one.
    #[arg(long, default_value = "direct")]
    pub solver: SolverArgument,
}

/// How kernels are computed.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum KernelArgument {
    Adjoint,
    Table,
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
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum ExtensionArgument {
    Harmonic,
    CauchyGreen,
}

/// How the boundary is sampled.
#[derive(Debug, Clone, Copy, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum SamplingArgument {
    Uniform,
    Adaptive,
}

/// An outline named on the command line.
pub struct NamedOutline {
    /// The outline.
    pub outline: Outline,
    /// The paper's number of samples, for presets used in the paper.
    paper_samples: Option<u32>,
}

impl NamedOutline {
    /// Prints the reader's notes to stderr.
    pub fn say_notes(&self, name: &str) {
        for note in &self.outline.notes {
            eprintln!("riemap: {name}: {note}");
        }
    }
}

/// Reads at most `most` + 1 bytes of a file; the reader rejects a file with more than `most`.
pub fn read_file(name: &str, most: usize) -> Result<Vec<u8>, CliError> {
    let mut bytes = Vec::new();
    let read = std::fs::File::open(name).and_then(|file| file.take(most as u64 + 1).read_to_end(&mut bytes));
    read.map_err(|error| CliError::Input(format!("cannot read {name}: {error}")))?;
    Ok(bytes)
}

/// Reads `preset:NAME` or a file. With `repair`, parts where it meets itself in a vertex are cut off and noted.
pub fn read_outline(name: &str, repair: bool) -> Result<NamedOutline, CliError> {
    if let Some(preset) = name.strip_prefix("preset:") {
        let preset = Preset::from_str(preset).map_err(|error| CliError::Input(error.to_string()))?;
        return Ok(NamedOutline { outline: preset.outline(), paper_samples: preset.paper_samples() });
    }
    let bytes = read_file(name, outline::MAX_BYTES)?;
    let parse = if repair { outline::parse_repaired } else { outline::parse };
    let outline = parse(name, &bytes).map_err(|error| CliError::Input(format!("{name}: {error}")))?;
    Ok(NamedOutline { outline, paper_samples: None })
}

impl Discretisation {
    /// The settings for one outline; `samples` overrides the number that both sides share.
    pub fn settings(&self, outline: &NamedOutline, samples: Option<u32>) -> PrepareSettings {
        let samples = samples.or(self.samples);
        let sampling = match self.sampling {
            SamplingArgument::Uniform => Sampling::Uniform {
                count: samples.or(outline.paper_samples).unwrap_or(500),
                keep_corners: self.keep_corners,
            },
            SamplingArgument::Adaptive => Sampling::Adaptive { target: samples },
        };
        PrepareSettings {
            sampling,
            sizing: self.sizing.map_or_else(Sizing::default, |sizing| sizing.0),
            kernel: self.kernel_mode(),
            solver: self.solver_kind(),
        }
    }

    /// The kernel mode that the argument means.
    pub fn kernel_mode(&self) -> KernelMode {
        match self.kernel {
            KernelArgument::Adjoint => KernelMode::Adjoint,
            KernelArgument::Table => KernelMode::Table,
        }
    }

    /// The solver that the argument means.
    pub fn solver_kind(&self) -> SolverKind {
        match self.solver {
            SolverArgument::Direct => SolverKind::Direct,
            SolverArgument::Pcg => SolverKind::Pcg,
        }
    }
}
