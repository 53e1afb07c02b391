//! The names of sides and of built-in shapes.

use super::{Label, Value, key};
use crate::conformal::Side;
use crate::outline::Preset;
use crate::surface::SurfacePreset;

/// The name within a sentence: "source", "target".
impl From<Side> for Label {
    fn from(side: Side) -> Self {
        match side {
            Side::Source => key::source(),
            Side::Target => key::target(),
        }
    }
}

impl From<Side> for Value {
    fn from(side: Side) -> Self {
        Label::from(side).into()
    }
}

/// The name as a heading: "Source", "Target".
pub fn side_heading(side: Side) -> Label {
    match side {
        Side::Source => key::source_heading(),
        Side::Target => key::target_heading(),
    }
}

/// The name of a built-in outline.
pub fn preset(preset: Preset) -> Label {
    match preset {
        Preset::Disk => key::disk(),
        Preset::Square => key::square(),
        Preset::Gingerbread => key::gingerbread_man(),
        Preset::Heart => key::heart(),
        Preset::Blob => key::blob(),
        Preset::VShape => key::v_shape(),
        Preset::Cinquefoil => key::cinquefoil(),
        Preset::MapleLeaf => key::maple_leaf(),
        Preset::Hand => key::hand(),
        Preset::Turkey => key::turkey(),
        Preset::LShape => key::l_shape(),
        Preset::Star => key::star(),
        Preset::Spiral => key::spiral(),
    }
}

/// The name of a built-in surface.
pub fn surface_preset(preset: SurfacePreset) -> Label {
    match preset {
        SurfacePreset::Hemisphere => key::hemisphere(),
        SurfacePreset::Paraboloid => key::paraboloid(),
        SurfacePreset::Saddle => key::saddle(),
        SurfacePreset::BentStrip => key::bent_strip(),
        SurfacePreset::HalfTorus => key::half_torus(),
        SurfacePreset::HeightField => key::face_like(),
        SurfacePreset::AnimalHead => key::animal_head(),
    }
}
