//! The arguments of `riemap render`, `animate` and `link`: a session, and how it is drawn.

use super::values::{Size, TilingArgument};
use crate::conformal::Side;
use std::path::PathBuf;

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
    /// The hyperbolic tiling {P, Q} instead of the session's pattern: polygons with P sides, Q around each corner; its
    /// style is tiles (the default), edges, triangles or picture (the session's own picture in every tile).
    #[arg(long, value_name = "P,Q[,STYLE]")]
    pub tiling: Option<TilingArgument>,
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
