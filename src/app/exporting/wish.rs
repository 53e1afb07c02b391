//! What a person wants to have as a file.

use crate::app::language::tr;
use crate::app::still::Shot;
use crate::conformal::Side;
use crate::export::FileFormat;
use crate::family::Path;
use crate::render::{FilmFormat, FilmSettings};

/// Kinds of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// One picture, as PNG.
    Picture,
    /// An animation.
    Film(FilmFormat),
    /// Numbers, or vector graphics.
    File(FileFormat),
}

impl Kind {
    const PLANAR: [Self; 6] = [
        Self::Picture,
        Self::File(FileFormat::Svg),
        Self::File(FileFormat::Csv),
        Self::File(FileFormat::Obj),
        Self::Film(FilmFormat::Png),
        Self::Film(FilmFormat::Gif),
    ];
    const SURFACE: [Self; 8] = [
        Self::Picture,
        Self::File(FileFormat::Obj),
        Self::File(FileFormat::Ply),
        Self::File(FileFormat::Glb),
        Self::File(FileFormat::Csv),
        Self::File(FileFormat::Svg),
        Self::Film(FilmFormat::Png),
        Self::Film(FilmFormat::Gif),
    ];

    /// Those that there are of the map that is shown.
    pub fn all(on_surface: bool) -> &'static [Self] {
        if on_surface { &Self::SURFACE } else { &Self::PLANAR }
    }

    /// What is written on its button.
    pub fn label(self) -> &'static str {
        match self {
            Self::Picture => "PNG",
            Self::Film(FilmFormat::Png) => tr("Animated PNG"),
            Self::Film(FilmFormat::Gif) => "GIF",
            Self::File(FileFormat::Svg) => "SVG",
            Self::File(FileFormat::Csv) => "CSV",
            Self::File(FileFormat::Obj) => "OBJ",
            Self::File(FileFormat::Ply) => "PLY",
            Self::File(FileFormat::Glb) => "GLB",
        }
    }

    /// What is in it.
    pub fn explained(self, on_surface: bool) -> &'static str {
        match (self, on_surface) {
            (Self::Picture, _) => tr("The picture, of any size"),
            (Self::Film(FilmFormat::Png), _) => tr("A turn of the points that goes on for ever, in all its colours"),
            (Self::Film(FilmFormat::Gif), _) => tr("A turn of the points that goes on for ever, in 256 colours"),
            (Self::File(FileFormat::Svg), false) => {
                tr("Outlines, the pattern's lines, the points, and the mesh where it is shown")
            }
            (Self::File(FileFormat::Svg), true) => tr("The edges of the layout in the outline"),
            (Self::File(FileFormat::Csv), false) => {
                tr("A table of boundary points that are mapped to each other: arc lengths, places, harmonic measure")
            }
            (Self::File(FileFormat::Csv), true) => tr("A table: x, y, z, u, v for each vertex"),
            (Self::File(FileFormat::Obj), false) => {
                tr("Wavefront OBJ: the mesh in the target, its texture coordinates in the source")
            }
            (Self::File(FileFormat::Obj), true) => {
                tr("Wavefront OBJ: the vertices in their order, each with its texture coordinate")
            }
            (Self::File(FileFormat::Ply), _) => tr("PLY, ascii: x y z s t for each vertex"),
            (Self::File(FileFormat::Glb), _) => tr("Binary glTF with texture coordinates"),
        }
    }

    /// Whether it is made of pixels.
    pub fn is_drawn(self) -> bool {
        !matches!(self, Self::File(_))
    }
}

/// All that can be chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wish {
    /// What.
    pub kind: Kind,
    /// Of pictures, in pixels.
    pub size: [u32; 2],
    /// Pictures without a ground.
    pub transparent: bool,
    /// One side of pictures and drawings; `None`: both.
    pub side: Option<Side>,
    /// Whether a surface's texture coordinates are moved and scaled into the unit box.
    pub unit: bool,
    /// What moves in animations.
    pub path: Path,
    /// How long a turn takes.
    pub seconds: f64,
    /// Pictures of a turn.
    pub frames: u32,
}

impl Default for Wish {
    fn default() -> Self {
        Self {
            kind: Kind::Picture,
            size: [1600, 900],
            transparent: false,
            side: None,
            unit: true,
            path: Path::Boundary,
            seconds: 4.0,
            frames: 60,
        }
    }
}

impl Wish {
    /// A picture of it, for a dark ground or a light one.
    pub fn shot(&self, dark: bool) -> Shot {
        let Self { size, transparent, side, .. } = *self;
        Shot { size, dark, transparent, side }
    }

    /// An animation's settings.
    pub fn film(&self, format: FilmFormat) -> FilmSettings {
        FilmSettings { format, size: self.size, frames: self.frames, seconds: self.seconds }
    }
}
