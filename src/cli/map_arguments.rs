//! The arguments of `riemap map`; those of its points and samples are shared with `formula`.

use super::CliError;
use super::discretization::Discretization;
use super::side::{SideAnchor, SidePoint};
use super::values::Size;
use crate::conformal::PrepareSettings;
use crate::counted::counted;
use std::path::PathBuf;

/// `riemap map SOURCE TARGET [NEXT]…`.
#[derive(Debug, clap::Args)]
pub struct MapArguments {
    /// The sides.
    #[command(flatten)]
    pub sides: SideArguments,
    /// The constraints.
    #[command(flatten)]
    pub points: PointArguments,
    /// What determines the map in their place.
    #[command(flatten)]
    pub instead: InsteadArguments,
    /// The numbers of boundary samples.
    #[command(flatten)]
    pub samples: SampleArguments,
    /// How files are read.
    #[command(flatten)]
    pub reading: super::named_outline::ReadingArguments,
    /// On which triangles surfaces are computed.
    #[command(flatten)]
    pub triangles: TriangleArguments,
    /// How outlines are discretized; kernel and solver apply to surfaces too.
    #[command(flatten)]
    pub discretization: Discretization,
    /// Which mesh is mapped: the source's forward, or the target's backward into the source. If only one side is a
    /// surface, its mesh is mapped [default: backward; with further targets forward].
    #[arg(long)]
    pub direction: Option<DirectionArgument>,
    /// How the boundary map is extended into that mesh; with a surface, always harmonically.
    #[arg(long, default_value = "harmonic")]
    pub extension: ExtensionArgument,
    /// Whether the mapped mesh is refined where images are long, so that they fill the other outline without folds;
    /// auto: with adaptive samples and graded triangles, the defaults, and not with the table.
    #[arg(long, default_value = "auto")]
    pub refine: RefineArgument,
    /// Write the map to this file; may be repeated; the extension selects the format: json, csv, obj, svg, png; with a
    /// surface also ply and glb. The vertices of a mapped surface are in the order of its file.
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

/// On which triangles surfaces are computed.
#[derive(Debug, clap::Args)]
pub struct TriangleArguments {
    /// Use a surface's own cotangent weights, even negative ones, instead of flipping its edges to be Delaunay.
    #[arg(long)]
    pub no_intrinsic_delaunay: bool,
    /// Compute surfaces on their own triangles. Else these are cut into four until the map is resolved at the surface's
    /// vertices, up to 200,000 triangles, except with the table and without intrinsic Delaunay flips.
    #[arg(long)]
    pub no_subdivision: bool,
}

/// What determines a map in place of its constraints.
#[derive(Debug, clap::Args)]
pub struct InsteadArguments {
    /// Boundary pairs.
    #[command(flatten)]
    pub pins: super::pins::PinArguments,
    /// A criterion that the map is to minimize.
    #[command(flatten)]
    pub optimize: super::optimization::OptimizeArguments,
}

impl InsteadArguments {
    /// Whether the constraints determine the map.
    pub fn is_empty(&self) -> bool {
        self.pins.pins.is_empty() && self.optimize.criterion.is_none()
    }
}

/// The sides of a map, or of a chain of maps.
#[derive(Debug, clap::Args)]
pub struct SideArguments {
    /// The source: an outline, as a file (JSON, CSV, text, SVG, GeoJSON) or `preset:NAME`; or a surface, as a file
    /// (obj, ply, stl, off, gltf, glb) or `preset:NAME[:M]` with M boundary vertices.
    pub source: String,
    /// The target: an outline or a surface, given like the source.
    pub target: String,
    /// The targets after that: the map goes from each one to the next. The composition is written, which maps the first
    /// to the last; --json has each link.
    #[arg(value_name = "NEXT")]
    pub further: Vec<String>,
}

impl SideArguments {
    /// The names of the sides, in order.
    pub fn names(&self) -> Vec<&str> {
        let Self { source, target, further } = self;
        [source, target].into_iter().chain(further).map(String::as_str).collect()
    }

    /// Whether there are more than two sides.
    pub fn is_chain(&self) -> bool {
        !self.further.is_empty()
    }
}

/// The constraints of a map.
#[derive(Debug, clap::Args)]
pub struct PointArguments {
    /// x₁, inside the source. In an outline, X,Y [default: its pole of inaccessibility]; in a surface, vertex V,
    /// triangle F with weights, or the point nearest to X,Y,Z [default: the vertex farthest from the boundary].
    #[arg(long, value_name = "X,Y|V|F:A,B,C|X,Y,Z", allow_hyphen_values = true)]
    pub source_point: Option<SidePoint>,
    /// x₂, the image of x₁, inside the target; same forms and defaults as x₁. With several targets one for each, in their
    /// order: each is the image of the one before.
    #[arg(long, value_name = "X,Y|V|F:A,B,C|X,Y,Z", allow_hyphen_values = true)]
    pub target_point: Vec<SidePoint>,
    /// y₁, on the boundary of the source: the boundary point nearest to X,Y (outline) or X,Y,Z (surface), a surface's
    /// boundary vertex V, or the point at fraction S of the boundary's length from its first point.
    #[arg(long, value_name = "X,Y|X,Y,Z|V|@S", default_value = "@0", allow_hyphen_values = true)]
    pub source_anchor: SideAnchor,
    /// y₂, the image of y₁, on the boundary of the target; same forms as y₁, and one for each target as x₂.
    #[arg(long, value_name = "X,Y|X,Y,Z|V|@S", default_value = "@0", allow_hyphen_values = true)]
    pub target_anchor: Vec<SideAnchor>,
}

impl PointArguments {
    /// The points of so many targets, those that are not given by default. Errors: more are given.
    pub fn of_targets(&self, count: usize) -> Result<Vec<(Option<SidePoint>, SideAnchor)>, CliError> {
        let given = [("--target-point", self.target_point.len()), ("--target-anchor", self.target_anchor.len())];
        if let Some((option, times)) = given.into_iter().find(|(_, times)| *times > count) {
            let targets = counted!(count, "1 target", "{count} targets");
            return Err(CliError::Usage(format!("{option} is given {times} times for {targets}")));
        }
        let anchor = |k: usize| self.target_anchor.get(k).copied().unwrap_or(SideAnchor::Fraction(0.0));
        Ok((0..count).map(|k| (self.target_point.get(k).copied(), anchor(k))).collect())
    }
}

/// Numbers of boundary samples, one for each side.
#[derive(Debug, clap::Args)]
pub struct SampleArguments {
    /// Number of boundary samples of the source.
    #[arg(long, value_name = "N", conflicts_with = "samples")]
    pub source_samples: Option<u32>,
    /// Number of boundary samples of the target, or of each.
    #[arg(long, value_name = "N", conflicts_with = "samples")]
    pub target_samples: Option<u32>,
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
