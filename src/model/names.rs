//! The names of outlines and surfaces in sessions and messages, in English whatever the screen's language.

use crate::language::{self, Value};
use crate::outline::Preset;
use crate::session::{OutlineSpec, SurfaceShape};
use crate::surface::SurfacePreset;

/// The mark at the end of a reshaped outline's name.
pub const EDITED: char = '*';
/// The name of an outline that was drawn.
pub const DRAWN: &str = "Drawing";
/// The name of an outline that was pasted.
pub const PASTED: &str = "Pasted";
/// The name of an outline that was traced from a picture without a name.
pub const TRACED: &str = "Traced";

/// The name of the rectangle of a marked outline.
pub const RECTANGLE: &str = "Rectangle";

/// The name of a preset.
pub fn preset(preset: Preset) -> &'static str {
    match preset {
        Preset::Disk => "Disk",
        Preset::Square => "Square",
        Preset::Gingerbread => "Gingerbread man",
        Preset::Heart => "Heart",
        Preset::Blob => "Blob",
        Preset::VShape => "V-shape",
        Preset::Cinquefoil => "Cinquefoil",
        Preset::MapleLeaf => "Maple leaf",
        Preset::Hand => "Hand",
        Preset::Turkey => "Turkey",
        Preset::LShape => "L-shape",
        Preset::Star => "Star",
        Preset::Spiral => "Spiral",
    }
}

/// The name of a built-in surface.
pub fn surface_preset(preset: SurfacePreset) -> &'static str {
    match preset {
        SurfacePreset::Hemisphere => "Hemisphere",
        SurfacePreset::Paraboloid => "Paraboloid",
        SurfacePreset::Saddle => "Saddle",
        SurfacePreset::BentStrip => "Bent strip",
        SurfacePreset::HalfTorus => "Half torus",
        SurfacePreset::HeightField => "Face-like",
        SurfacePreset::AnimalHead => "Animal head",
    }
}

/// The name of an outline.
pub fn outline(outline: &OutlineSpec) -> &str {
    match outline {
        OutlineSpec::Preset(shape) => preset(*shape),
        OutlineSpec::Points { name, .. } => name,
    }
}

/// The name of a surface.
pub fn surface(shape: &SurfaceShape) -> &str {
    match shape {
        SurfaceShape::Preset { preset, .. } => surface_preset(*preset),
        SurfaceShape::File { name } => name,
    }
}

/// The name of a surface in a message.
pub fn surface_in_message(shape: &SurfaceShape) -> Value {
    match shape {
        SurfaceShape::Preset { preset, .. } => language::surface_preset(*preset).into(),
        SurfaceShape::File { name } => name.into(),
    }
}

/// The name of an outline after reshaping: with the mark, but not twice.
pub fn edited(of: &OutlineSpec) -> String {
    let name = outline(of);
    format!("{}{EDITED}", name.strip_suffix(EDITED).unwrap_or(name))
}
