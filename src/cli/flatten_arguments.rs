//! The arguments of `riemap flatten`, and their conversion to the core's types.

use super::CliError;
use super::discretization::Discretization;
use super::map_arguments::TriangleArguments;
use super::named_outline::{ReadingArguments, read_file};
use super::values::{Anchor, Point, Size};
use crate::conformal::MeshedSurface;
use crate::counted::counted;
use crate::export::SurfaceSource;
use crate::geometry::DVec3;
use crate::mesh::{BarycentricPoint, TriangleId, VertexId};
use crate::surface::{
    MAX_BYTES, Surface, SurfaceFormat, SurfaceMesh, SurfaceNote, SurfacePreset, at_vertex, nearest_on_boundary, packed,
    read_surface_beside,
};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// `riemap flatten SURFACE OUTLINE`.
#[derive(Debug, clap::Args)]
pub struct FlattenArguments {
    /// The surface: a file (obj, ply, stl, off, gltf, glb) or `preset:NAME[:M]` with M boundary vertices.
    pub surface: String,
    /// The outline of the texture domain: a file (JSON, CSV, text, SVG, GeoJSON) or `preset:NAME`.
    pub outline: String,
    /// x₂, inside the surface: vertex V, triangle F with weights, or the point nearest to X,Y,Z. V and F count from 0
    /// in the file's order; F counts the triangles into which its faces are cut [default: the vertex farthest from the
    /// boundary].
    #[arg(long, value_name = "V|F:A,B,C|X,Y,Z", allow_hyphen_values = true)]
    pub surface_point: Option<SurfacePoint>,
    /// y₂, on the surface's boundary: vertex V, the boundary point nearest to X,Y,Z, or the one at fraction S of
    /// its length.
    #[arg(long, value_name = "V|X,Y,Z|@S", default_value = "@0", allow_hyphen_values = true)]
    pub surface_anchor: SurfaceAnchor,
    /// x₁, the image of x₂, inside the outline [default: its pole of inaccessibility].
    #[arg(long, alias = "source-point", value_name = "X,Y", allow_hyphen_values = true)]
    pub outline_point: Option<Point>,
    /// y₁, the image of y₂: the point of the outline nearest to X,Y, or the one at fraction S of its length.
    #[arg(long, alias = "source-anchor", value_name = "X,Y|@S", default_value = "@0", allow_hyphen_values = true)]
    pub outline_anchor: Anchor,
    /// A boundary point of the surface and its image on the outline: P is X,Y,Z, a boundary vertex V, or @S, and Q is X,Y or
    /// @S. Three of them determine the map, in place of points and anchors; more are met by least squares. They run around
    /// both boundaries in the same order.
    #[arg(long = "pin", value_name = "P:Q", allow_hyphen_values = true,
          conflicts_with_all = ["surface_point", "surface_anchor", "outline_point", "outline_anchor", "criterion"])]
    pub pins: Vec<super::pins::PinArgument>,
    /// The best map in place of the given one.
    #[command(flatten)]
    pub optimize: super::optimization::OptimizeArguments,
    /// What is mended before the surface is mapped.
    #[command(flatten)]
    pub mending: MendingArguments,
    /// On which triangles surfaces are computed.
    #[command(flatten)]
    pub triangles: TriangleArguments,
    /// How the outline is discretized; kernel and solver apply to the surface too.
    #[command(flatten)]
    pub discretization: Discretization,
    /// The layout of the texture.
    #[command(flatten)]
    pub layout: LayoutArguments,
    /// Write the surface with its texture coordinates to this file; may be repeated; the extension selects the format:
    /// obj, ply, glb, csv (a line for each vertex), svg (the layout), png (the textured surface beside its layout).
    #[arg(long, value_name = "FILE")]
    pub out: Vec<PathBuf>,
    /// Size of a .png in pixels.
    #[arg(long, value_name = "WxH", default_value = "1600x900")]
    pub size: Size,
    /// Print quality, counts, flips, repairs and timings as JSON on stdout.
    #[arg(long)]
    pub json: bool,
}

/// What is mended before the surface is mapped.
#[derive(Debug, clap::Args)]
pub struct MendingArguments {
    /// How files are read.
    #[command(flatten)]
    pub reading: ReadingArguments,
    /// Of several boundary loops the one that becomes the outline: 1 is the longest, which is the default. The others are
    /// filled; with --repair.
    #[arg(long, value_name = "K", requires = "repair", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..))]
    pub boundary_loop: u16,
}

/// The layout of the texture in the plane.
#[derive(Debug, clap::Args)]
pub struct LayoutArguments {
    /// Texture coordinates: moved and scaled into the unit square, or left in the outline's coordinates.
    #[arg(long, default_value = "unit")]
    pub uv: UvArgument,
    /// The outline's corners: hit exactly, with boundary edges divided where they lie, or left to the map, which cuts
    /// those off that no boundary vertex is mapped to.
    #[arg(long, default_value = "hit")]
    pub corners: CornersArgument,
}

/// The coordinate system of texture coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum UvArgument {
    Unit,
    True,
}

/// The outline's corners.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[allow(missing_docs, reason = "clap shows the comments of values as help")]
pub enum CornersArgument {
    Hit,
    Free,
}

/// A point of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SurfacePoint {
    /// A vertex, by its number in the file.
    Vertex(u32),
    /// A triangle, by its number in the file, and barycentric weights.
    InTriangle(u32, [f64; 3]),
    /// The point of the surface nearest to this one.
    Nearest(DVec3),
}

/// Parses three finite numbers separated by commas.
fn three(text: &str) -> Option<[f64; 3]> {
    let mut parts = text.split(',').map(|part| part.trim().parse::<f64>().ok().filter(|value| value.is_finite()));
    let numbers = [parts.next()??, parts.next()??, parts.next()??];
    parts.next().is_none().then_some(numbers)
}

impl FromStr for SurfacePoint {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "expected a vertex V, F:A,B,C with weights ≥ 0 of a triangle's corners, or X,Y,Z".to_owned();
        if let Some((triangle, weights)) = text.split_once(':') {
            let (triangle, weights) = (triangle.parse().map_err(|_| wrong())?, three(weights).ok_or_else(wrong)?);
            let sum: f64 = weights.iter().sum();
            let sound = weights.iter().all(|&w| w >= 0.0) && sum > 0.0 && sum.is_finite();
            return if sound { Ok(Self::InTriangle(triangle, weights.map(|w| w / sum))) } else { Err(wrong()) };
        }
        if let Ok(vertex) = text.parse() {
            return Ok(Self::Vertex(vertex));
        }
        three(text).map(|place| Self::Nearest(DVec3::from_array(place))).ok_or_else(wrong)
    }
}

impl SurfacePoint {
    /// Finds the point on the prepared surface; `given` is the surface as it was read.
    pub fn locate(self, option: &str, given: &Surface, surface: &MeshedSurface) -> Result<BarycentricPoint, CliError> {
        let whole = surface.surface();
        match self {
            Self::Vertex(vertex) => {
                let found = number_of(vertex, given, whole).and_then(|number| at_vertex(whole.mesh(), number));
                found.ok_or_else(|| CliError::Input(format!("{option}: {}", no_vertex(given, vertex))))
            }
            Self::InTriangle(triangle, weights) => {
                let kept = whole.triangle_origins().iter().position(|&origin| origin == triangle);
                let missing = || CliError::Input(format!("{option}: {}", no_triangle(given, triangle)));
                let kept = TriangleId::new(kept.ok_or_else(missing)? as u32);
                if let Some(corners) = whole.corners_in(given, kept) {
                    return Ok(BarycentricPoint::new(kept, corners.map(|i| weights[i])));
                }
                // a repair gave it other corners
                let corners = given.triangles()[triangle as usize].map(|v| given.vertices()[v as usize]);
                let place = corners.iter().zip(weights).map(|(&corner, weight)| weight * corner).sum();
                Self::Nearest(place).locate(option, given, surface)
            }
            Self::Nearest(place) => surface
                .tree()
                .nearest(place)
                .map(|(point, _)| point)
                .ok_or_else(|| CliError::Input(format!("{option}: nothing is near {place}"))),
        }
    }
}

/// The number in the mesh of a vertex of the file; `given` is the surface as it was read.
fn number_of(vertex: u32, given: &Surface, mesh: &SurfaceMesh) -> Option<VertexId> {
    mesh.number_of(VertexId::new(given.vertex_in_file(vertex)?))
}

/// The message for a vertex number that is out of range.
fn no_vertex(given: &Surface, vertex: u32) -> String {
    match given.count_in_file() {
        count if (vertex as usize) < count => format!("vertex {vertex} was dropped by the repair"),
        count => format!("the surface has no vertex {vertex}: it has {count}, counted from 0"),
    }
}

/// The message for a triangle number that is out of range.
fn no_triangle(given: &Surface, triangle: u32) -> String {
    let count = given.triangles().len();
    if (triangle as usize) < count {
        return format!("triangle {triangle} was dropped by the repair");
    }
    let faces = given.notes().iter().find_map(|note| match note {
        SurfaceNote::Triangulated { faces, .. } => {
            Some(counted!(*faces, "its 1 face was cut into", "its {faces} faces were cut into"))
        }
        _ => None,
    });
    let faces = faces.unwrap_or_else(|| String::from("it has"));
    format!("the surface has no triangle {triangle}: {faces} {count}, counted from 0")
}

/// A point of a surface's boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SurfaceAnchor {
    /// A vertex, by its number in the file.
    Vertex(u32),
    /// The boundary point nearest to this one.
    Nearest(DVec3),
    /// The point at this fraction of the boundary loop's length from its vertex of least index.
    Fraction(f64),
}

impl FromStr for SurfaceAnchor {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || "expected a boundary vertex V, X,Y,Z, or @S with a finite fraction S, such as @0.25".to_owned();
        if let Some(fraction) = text.strip_prefix('@') {
            let fraction = fraction.parse::<f64>().ok().filter(|s| s.is_finite());
            return fraction.map(Self::Fraction).ok_or_else(wrong);
        }
        if let Ok(vertex) = text.parse() {
            return Ok(Self::Vertex(vertex));
        }
        three(text).map(|place| Self::Nearest(DVec3::from_array(place))).ok_or_else(wrong)
    }
}

impl SurfaceAnchor {
    /// The anchor as a fraction of the boundary's length, in `[0, 1)`.
    /// `given` is the surface as it was read.
    pub fn fraction(self, option: &str, given: &Surface, surface: &MeshedSurface) -> Result<f64, CliError> {
        match self {
            Self::Fraction(s) => Ok(s.rem_euclid(1.0)),
            Self::Nearest(place) => Ok(surface.fraction_at(nearest_on_boundary(surface.mesh(), place))),
            Self::Vertex(vertex) => {
                let number = number_of(vertex, given, surface.surface());
                let number = number.and_then(|number| surface.fractions().get(number.index()));
                let inner = || CliError::Input(format!("{option}: vertex {vertex} is not on the boundary"));
                number.copied().ok_or_else(inner)
            }
        }
    }
}

/// The preset with this name, `preset:NAME[:M]`, if there is one.
pub fn preset(name: &str) -> Option<SurfacePreset> {
    let name = name.strip_prefix("preset:")?;
    SurfacePreset::from_str(name.split_once(':').map_or(name, |(preset, _)| preset)).ok()
}

/// A surface with the file that it was read from; presets have none.
pub struct ReadSurface {
    /// The surface, before any repair.
    pub surface: Surface,
    file: Option<(SurfaceFormat, Vec<u8>)>,
}

impl ReadSurface {
    /// The file, for writing it again.
    pub fn source(&self) -> Option<SurfaceSource<'_>> {
        let (format, bytes) = self.file.as_ref()?;
        Some(SurfaceSource { format: *format, bytes, surface: &self.surface })
    }
}

/// Reads `preset:NAME[:M]` or a file.
pub fn read(name: &str) -> Result<ReadSurface, CliError> {
    let input = |error: &dyn std::fmt::Display| CliError::Input(format!("{name}: {error}"));
    if let Some(preset) = name.strip_prefix("preset:") {
        let (preset, boundary) = preset.split_once(':').map_or((preset, None), |(preset, m)| (preset, Some(m)));
        let preset = SurfacePreset::from_str(preset).map_err(|error| CliError::Input(error.to_string()))?;
        let boundary = match boundary.map(str::parse) {
            None => SurfacePreset::USUAL_BOUNDARY,
            Some(Ok(count @ 12..=4000)) => count,
            Some(_) => return Err(input(&"the number of boundary vertices must be from 12 to 4000")),
        };
        let surface = preset.surface(boundary).map_err(|error| input(&error))?;
        return Ok(ReadSurface { surface, file: None });
    }
    let bytes = read_file(name, MAX_BYTES)?;
    let surface = read_surface_beside(name, &bytes, &mut beside(name)).map_err(|error| input(&error))?;
    let bytes = with_neighbors(name, bytes);
    let format = SurfaceFormat::of(name, &bytes).map_err(|error| input(&error))?;
    Ok(ReadSurface { surface, file: Some((format, bytes)) })
}

/// The content of a surface's file: a glTF document with the files beside it as one GLB.
pub fn with_neighbors(name: &str, bytes: Vec<u8>) -> Vec<u8> {
    if !matches!(SurfaceFormat::of(name, &bytes), Ok(SurfaceFormat::Gltf)) {
        return bytes;
    }
    match packed(&bytes, &mut beside(name)) {
        Some(whole) => whole.bytes,
        None => bytes,
    }
}

/// Reads files beside the one of this name.
fn beside(name: &str) -> impl FnMut(&str) -> Option<Vec<u8>> {
    let folder = Path::new(name).parent().unwrap_or(Path::new("")).to_owned();
    move |file| read_file(&folder.join(file).to_string_lossy(), MAX_BYTES).ok()
}
