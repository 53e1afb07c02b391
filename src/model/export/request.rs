//! What a person wants to have as a file.

use crate::conformal::Side;
use crate::export::FileFormat;
use crate::family::Path;
use crate::language::{Label, key};
use crate::model::Abilities;
use crate::model::scene::Shot;
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
    const THROUGH_DISK: [Self; 6] = [
        Self::Picture,
        Self::File(FileFormat::Obj),
        Self::File(FileFormat::Csv),
        Self::File(FileFormat::Svg),
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

    /// Those that there are of a map with these abilities.
    pub fn all(abilities: Abilities) -> &'static [Self] {
        match (abilities.has_layout(), abilities.maps_through_disk()) {
            (true, _) => &Self::SURFACE,
            (false, true) => &Self::THROUGH_DISK,
            (false, false) => &Self::PLANAR,
        }
    }

    /// What is written on its button.
    pub fn label(self) -> Label {
        match self {
            Self::Picture => key::png(),
            Self::Film(FilmFormat::Png) => key::animated_png(),
            Self::Film(FilmFormat::Gif) => key::gif(),
            Self::File(FileFormat::Svg) => key::svg(),
            Self::File(FileFormat::Csv) => key::csv(),
            Self::File(FileFormat::Obj) => key::obj(),
            Self::File(FileFormat::Ply) => key::ply(),
            Self::File(FileFormat::Glb) => key::glb(),
        }
    }

    /// What is in it.
    pub fn explained(self, abilities: Abilities) -> Label {
        let (through_disk, on_surface) = (abilities.maps_through_disk(), abilities.has_layout());
        match (self, on_surface) {
            (Self::Picture, _) => key::png_tooltip(),
            (Self::Film(FilmFormat::Png), _) => key::animated_png_tooltip(),
            (Self::Film(FilmFormat::Gif), _) => key::gif_tooltip(),
            (Self::File(FileFormat::Svg), _) if through_disk => key::disks_svg_tooltip(),
            (Self::File(FileFormat::Svg), false) => key::svg_tooltip(),
            (Self::File(FileFormat::Svg), true) => key::surface_svg_tooltip(),
            (Self::File(FileFormat::Csv), false) => key::csv_tooltip(),
            (Self::File(FileFormat::Csv), true) => key::surface_csv_tooltip(),
            (Self::File(FileFormat::Obj), false) => key::obj_tooltip(),
            (Self::File(FileFormat::Obj), true) => key::surface_obj_tooltip(),
            (Self::File(FileFormat::Ply), _) => key::surface_ply_tooltip(),
            (Self::File(FileFormat::Glb), _) => key::surface_glb_tooltip(),
        }
    }

    /// Whether it is made of pixels.
    pub fn is_drawn(self) -> bool {
        !matches!(self, Self::File(_))
    }
}

/// All that can be chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExportRequest {
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

impl Default for ExportRequest {
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

impl ExportRequest {
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
