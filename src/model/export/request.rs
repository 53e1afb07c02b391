//! The settings of an export: kind of file, size, sides, motion.

use crate::conformal::Side;
use crate::export::{FileFormat, FormulaFormat};
use crate::family::Path;
use crate::language::{Label, key};
use crate::model::Abilities;
use crate::model::scene::Shot;
use crate::render::{FilmFormat, FilmSettings};

/// The kinds of exported files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// One picture, as PNG.
    Picture,
    /// An animation.
    Film(FilmFormat),
    /// Numbers, or vector graphics.
    File(FileFormat),
    /// Map and inverse as rational functions.
    Formula,
}

impl Kind {
    const PLANAR: [Self; 7] = [
        Self::Picture,
        Self::File(FileFormat::Svg),
        Self::File(FileFormat::Csv),
        Self::File(FileFormat::Obj),
        Self::Film(FilmFormat::Png),
        Self::Film(FilmFormat::Gif),
        Self::Formula,
    ];
    const THROUGH_DISK: [Self; 9] = [
        Self::Picture,
        Self::File(FileFormat::Obj),
        Self::File(FileFormat::Ply),
        Self::File(FileFormat::Glb),
        Self::File(FileFormat::Csv),
        Self::File(FileFormat::Svg),
        Self::Film(FilmFormat::Png),
        Self::Film(FilmFormat::Gif),
        Self::Formula,
    ];
    const SURFACE: [Self; 9] = [
        Self::Picture,
        Self::File(FileFormat::Obj),
        Self::File(FileFormat::Ply),
        Self::File(FileFormat::Glb),
        Self::File(FileFormat::Csv),
        Self::File(FileFormat::Svg),
        Self::Film(FilmFormat::Png),
        Self::Film(FilmFormat::Gif),
        Self::Formula,
    ];

    /// The kinds available for a map with these abilities.
    pub fn all(abilities: Abilities) -> &'static [Self] {
        match (abilities.has_layout(), abilities.maps_through_disk()) {
            (true, _) => &Self::SURFACE,
            (false, true) => &Self::THROUGH_DISK,
            (false, false) => &Self::PLANAR,
        }
    }

    /// The label of the kind's button.
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
            Self::Formula => key::formula(),
        }
    }

    /// The contents of the file, as a tooltip.
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
            (Self::File(FileFormat::Ply), false) => key::mapped_ply_tooltip(),
            (Self::File(FileFormat::Glb), false) => key::mapped_glb_tooltip(),
            (Self::File(FileFormat::Ply), _) => key::surface_ply_tooltip(),
            (Self::File(FileFormat::Glb), _) => key::surface_glb_tooltip(),
            (Self::Formula, _) => key::formula_tooltip(),
        }
    }

    /// Whether the file consists of pixels.
    pub fn is_drawn(self) -> bool {
        matches!(self, Self::Picture | Self::Film(_))
    }
}

/// How a surface's texture coordinates are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// Whether they are moved and scaled into the unit box.
    pub unit: bool,
    /// Whether the surface is divided so that they reach the outline's corners.
    pub corners: bool,
}

/// The settings of an export.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExportRequest {
    /// The kind of file.
    pub kind: Kind,
    /// Width and height of pictures and animations, in pixels.
    pub size: [u32; 2],
    /// Whether the background of pictures is transparent.
    pub transparent: bool,
    /// Whether pictures show the points as dots.
    pub dots: bool,
    /// The side shown in pictures and drawings; `None`: both.
    pub side: Option<Side>,
    /// How a surface's texture coordinates are written.
    pub layout: Layout,
    /// The points that move in animations.
    pub path: Path,
    /// The duration of one loop of an animation, in seconds.
    pub seconds: f64,
    /// The number of frames of one loop.
    pub frames: u32,
    /// The format of a formula.
    pub formula: FormulaFormat,
    /// The number of digits of a formula, where its format has so many.
    pub digits: u32,
}

impl Default for ExportRequest {
    fn default() -> Self {
        Self {
            kind: Kind::Picture,
            size: [1600, 900],
            transparent: false,
            dots: true,
            side: None,
            layout: Layout { unit: true, corners: true },
            path: Path::Boundary,
            seconds: 4.0,
            frames: 60,
            formula: FormulaFormat::Json,
            digits: 8,
        }
    }
}

impl ExportRequest {
    /// The settings of a picture, with strokes for a dark or a light background.
    pub fn shot(&self, dark: bool) -> Shot {
        let Self { size, transparent, dots, side, .. } = *self;
        Shot { size, dark, transparent, dots, side }
    }

    /// The number of digits to ask for.
    pub fn digits(&self) -> u32 {
        self.digits.min(*self.formula.digits().end())
    }

    /// The settings of an animation.
    pub fn film(&self, format: FilmFormat) -> FilmSettings {
        FilmSettings { format, size: self.size, frames: self.frames, seconds: self.seconds }
    }
}
