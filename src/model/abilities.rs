//! Which features are available for the present two sides: the only table of those that need outlines, or surfaces.
//!
//! | feature | needs | otherwise |
//! |---|---|---|
//! | comparison through the disk, random walks, their curves and legends | two outlines | not offered |
//! | exact map, coarse map during a drag | two outlines | not offered |
//! | Cauchy–Green extension | two outlines | refused with a reason; the harmonic extension is used |
//! | exact extension | two outlines with the boundary integral | refused with a reason; the harmonic extension is used |
//! | choice of the direction | two sides of one kind | the surface is mapped |
//! | choice of the pattern's home | two outlines, a pattern that is not in the disk | the outline; between surfaces the disk |
//! | a point that moves along a circle | an outline on its side | refused |
//! | reshaping, resolution of an outline | an outline on its side | not offered |
//! | resolution of a surface | a surface on its side | not offered |
//! | map as a formula | two outlines | refused with a reason |
//! | texture coordinates in files | one surface | not offered |
//!
//! Bars, panels, overlays, plots, editor, windows and the texts for screen readers take their content from it.

use crate::closed_form::ExactMap;
use crate::conformal::{Extension, PerSide, PrepareSettings, PrepareTimings, Side};
use crate::family::Path;
use crate::language::{Label, key};
use crate::model::overlays::disk_comparison::DiskComparison;
use crate::model::overlays::overlay::Overlays;
use crate::model::overlays::walks::Walks;
use crate::model::{Model, SideKernel, pattern};
use crate::outline::Preset;
use crate::session::{OutlineSpec, Session, SurfaceSpec};

/// Why a choice is not possible between the present sides.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Unavailable {
    /// The Cauchy–Green extension maps planar domains only.
    #[error("{}", self.label().english())]
    CauchyGreen,
    /// Exact images need the boundary integral on both sides.
    #[error("{}", self.label().english())]
    Exact,
    /// The point that would move along a circle lies on a surface.
    #[error("{}", self.label().english())]
    Circle,
}

impl Unavailable {
    /// The sentence for the control's tooltip.
    pub fn label(self) -> Label {
        match self {
            Self::CauchyGreen => key::cauchy_green_needs_plane(),
            Self::Exact => key::exact_needs_integral(),
            Self::Circle => key::no_plane(),
        }
    }
}

/// The features of a map between two sides, each an outline or a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Abilities {
    surfaces: PerSide<bool>,
}

impl Abilities {
    /// Those of a map between sides of which these are surfaces.
    pub const fn between(surfaces: PerSide<bool>) -> Self {
        Self { surfaces }
    }

    /// Those of a session's map.
    pub fn of(session: &Session) -> Self {
        Self::between(PerSide::from_fn(|side| session.surface(side).is_some()))
    }

    /// Whether two outlines are mapped, which the comparisons and the coarse map need.
    pub fn compares_outlines(self) -> bool {
        self.surfaces.into_array() == [false, false]
    }

    /// Whether two surfaces are mapped, through the unit disk.
    pub fn maps_through_disk(self) -> bool {
        self.surfaces.into_array() == [true, true]
    }

    /// Whether one surface is laid out in the plane: then there are texture coordinates.
    pub fn has_layout(self) -> bool {
        self.surfaces.source != self.surfaces.target
    }

    /// Whether the direction can be chosen; one surface is mapped, whichever way the session's direction goes.
    pub fn chooses_direction(self) -> bool {
        !self.has_layout()
    }

    /// Whether a side is an outline.
    pub fn has_outline(self, side: Side) -> bool {
        !self.surfaces[side]
    }

    /// Why an extension cannot be chosen; `None` if it can.
    pub fn refused_extension(self, extension: Extension) -> Option<Unavailable> {
        match extension {
            _ if self.compares_outlines() => None,
            Extension::Harmonic => None,
            Extension::CauchyGreen => Some(Unavailable::CauchyGreen),
            Extension::Exact => Some(Unavailable::Exact),
        }
    }

    /// Why no point would move along a path: it is a circle in the plane, and the point is on a surface.
    pub fn refused_path(self, path: Path) -> Option<Unavailable> {
        let is_refused = match path {
            Path::SourcePoint => self.surfaces.source,
            Path::TargetPoint => self.surfaces.target,
            Path::Boundary | Path::All => false,
        };
        is_refused.then_some(Unavailable::Circle)
    }

    /// The side in whose coordinates a pattern is defined: the `chosen` one of two outlines, or the outline if the
    /// other side is a surface. `None` for two surfaces: the pattern is defined in the unit disk. The conformal
    /// pattern, which always is, is not considered here.
    pub fn pattern_home(self, chosen: Side) -> Option<Side> {
        match self.surfaces.into_array() {
            [false, false] => Some(chosen),
            [true, false] => Some(Side::Target),
            [false, true] => Some(Side::Source),
            [true, true] => None,
        }
    }

    /// The sentence in a surface's panel about the direction of the map; for two surfaces only in the first panel.
    pub fn direction_of_surface(self, side: Side) -> Option<Label> {
        match (side, self.surfaces.into_array()) {
            (Side::Source, [true, true]) => Some(key::surfaces_direction()),
            (Side::Target, [true, true]) => None,
            (Side::Source, _) => Some(key::surface_direction_target()),
            (Side::Target, _) => Some(key::surface_direction()),
        }
    }
}

impl Model {
    /// What the sides of the present session allow.
    pub fn abilities(&self) -> Abilities {
        Abilities::of(&self.session)
    }

    /// The comparison with the map through the disk; `None` where it is not defined.
    pub fn disk_comparison(&self) -> Option<&DiskComparison> {
        self.abilities().compares_outlines().then_some(&self.overlay_state.disk_comparison)
    }

    /// The random walks; `None` where they are not defined.
    pub fn walks(&self) -> Option<&Walks> {
        self.abilities().compares_outlines().then_some(&self.overlay_state.walks)
    }

    /// The curves that are drawn over those of the map; `None` where none are defined.
    pub fn overlays(&self) -> Option<&Overlays> {
        self.abilities().compares_outlines().then(|| self.overlay_state.overlays())
    }

    /// The presets whose exact map may be known; `None` if a side has none.
    pub fn exact_presets(&self) -> Option<PerSide<Preset>> {
        ExactMap::presets(&self.session).filter(|_| self.abilities().compares_outlines())
    }

    /// Why an extension cannot be chosen: as [`Abilities::refused_extension`], or finite elements are requested for a
    /// side or stay on one; `None` if it can.
    pub fn refused_extension(&self, extension: Extension) -> Option<Unavailable> {
        let has_elements =
            |side| matches!(self.side_kernel(side), Some(SideKernel::FiniteElements(_) | SideKernel::Stays(_)));
        let is_refused = extension == Extension::Exact && Side::BOTH.into_iter().any(has_elements);
        self.abilities().refused_extension(extension).or_else(|| is_refused.then_some(Unavailable::Exact))
    }

    /// The extension of the map: the session's, or harmonic where that is not possible.
    pub fn extension(&self) -> Extension {
        let asked = self.session.extension();
        if self.refused_extension(asked).is_some() { Extension::Harmonic } else { asked }
    }

    /// Whether the person chooses the side on which the pattern is undistorted.
    pub fn chooses_pattern_home(&self) -> bool {
        self.abilities().compares_outlines() && !pattern::needs_grid(&self.session)
    }

    /// The outline of a side that can be reshaped; `None` if the side is a surface.
    pub fn reshapable(&self, side: Side) -> Option<&OutlineSpec> {
        self.outline_settings(side)?;
        Some(&self.session.domain(side).outline)
    }

    /// The requested resolution of a side's outline; `None` if the side is a surface.
    pub fn outline_settings(&self, side: Side) -> Option<PrepareSettings> {
        self.abilities().has_outline(side).then(|| self.side(side).wanted().settings)
    }

    /// The requested resolution of a side's surface; `None` if the side is an outline.
    pub fn surface_settings(&self, side: Side) -> Option<&SurfaceSpec> {
        self.session.surface(side)?;
        self.sides[side].surface.preparation.wanted()
    }

    /// The times of the preparation of the surface that is mapped, if it is one.
    pub fn surface_timings(&self) -> Option<PrepareTimings> {
        let mapped = self.map()?.mapped();
        mapped.surface().map(|_| mapped.timings())
    }

    /// Whether the viewports have the present sides to draw: outlines as soon as they are prepared, surfaces with their
    /// map.
    pub fn has_picture(&self) -> bool {
        self.map().is_some() || self.abilities().compares_outlines()
    }

    /// The hint in the status line about the gestures in the pictures, for fingers or for a mouse.
    pub fn hint(&self, fingers: bool) -> Label {
        match (self.abilities().compares_outlines(), fingers) {
            (true, false) => key::hint_plane(),
            (true, true) => key::hint_plane_touch(),
            (false, false) => key::hint_surface(),
            (false, true) => key::hint_surface_touch(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [[bool; 2]; 4] = [[false, false], [false, true], [true, false], [true, true]];

    fn between([source, target]: [bool; 2]) -> Abilities {
        Abilities::between(PerSide::new(source, target))
    }

    #[test]
    fn the_table_holds_for_all_four_pairs_of_sides() {
        let compared = ALL.map(|sides| between(sides).compares_outlines());
        assert_eq!(compared, [true, false, false, false]);
        assert_eq!(ALL.map(|sides| between(sides).chooses_direction()), [true, false, false, true]);
        assert_eq!(ALL.map(|sides| between(sides).has_layout()), [false, true, true, false]);
        let homes = ALL.map(|sides| between(sides).pattern_home(Side::Target));
        assert_eq!(homes, [Some(Side::Target), Some(Side::Source), Some(Side::Target), None]);
    }

    #[test]
    fn a_refusal_names_its_reason() {
        for sides in ALL {
            let (abilities, has_surface) = (between(sides), sides != [false, false]);
            assert_eq!(abilities.refused_extension(Extension::Harmonic), None);
            let refused = abilities.refused_extension(Extension::CauchyGreen);
            assert_eq!(refused, has_surface.then_some(Unavailable::CauchyGreen));
            let exact = abilities.refused_extension(Extension::Exact);
            assert_eq!(exact, has_surface.then_some(Unavailable::Exact));
            let paths = [Path::SourcePoint, Path::TargetPoint].map(|path| abilities.refused_path(path));
            assert_eq!(paths, sides.map(|is_surface| is_surface.then_some(Unavailable::Circle)));
            assert_eq!([Path::Boundary, Path::All].map(|path| abilities.refused_path(path)), [None; 2]);
        }
        assert_eq!(Unavailable::Circle.to_string(), key::no_plane().english());
    }
}
