//! Curves of overlays, drawn in the plots over the map's own.

use crate::language::{Label, key};
use crate::model::curves::Curve;
use crate::model::overlays::disk_comparison::DiskComparison;
use crate::model::overlays::walks::Walks;
use crate::session::DiskWay;

/// The source of a curve, which determines its color.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A method through the disk.
    Disk(DiskWay),
    /// Random walks.
    Walks,
}

impl Origin {
    /// Its name in a plot's legend and in the panel.
    pub fn name(self) -> Label {
        match self {
            Self::Disk(DiskWay::Fresh) => key::through_disk_fresh(),
            Self::Disk(DiskWay::Precomputed) => key::through_disk_precomputed(),
            Self::Walks => key::random_walks(),
        }
    }

    /// Its short name.
    pub fn short_name(self) -> Label {
        match self {
            Self::Disk(DiskWay::Fresh) => key::disk_fresh(),
            Self::Disk(DiskWay::Precomputed) => key::disk_precomputed(),
            Self::Walks => key::hits(),
        }
    }

    /// Whether its lines are dashed: a fresh disk map ideally coincides with this map, and both must be visible.
    pub fn is_dashed(self) -> bool {
        self == Self::Disk(DiskWay::Fresh)
    }
}

/// A curve and its source.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// The source.
    pub origin: Origin,
    /// The curve.
    pub curve: Curve,
}

/// All curves of overlays by plot, from bottom to top.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Overlays {
    /// Drawn over the harmonic measure.
    pub measure: Vec<Overlay>,
    /// Drawn over the reparameterization.
    pub reparameterisation: Vec<Overlay>,
    /// The versions of the disk comparison and of the walks that the curves come from.
    versions: [u64; 2],
}

impl Overlays {
    /// Updates the curves if the disk comparison or the walks have changed; returns whether they have.
    pub fn update(&mut self, disk: &DiskComparison, walks: &Walks) -> bool {
        let versions = [disk.version(), walks.version()];
        if self.versions == versions {
            return false;
        }
        self.versions = versions;
        let by = |origin, curve: &Curve| Overlay { origin, curve: curve.clone() };
        self.measure.clear();
        self.reparameterisation.clear();
        for (way, found) in disk.all_found().rev() {
            self.measure.extend(found.measures.iter().map(|(_, curve)| by(Origin::Disk(way), curve)));
            self.reparameterisation.push(by(Origin::Disk(way), &found.reparameterisation));
        }
        self.measure.extend(walks.cumulative().map(|curve| Overlay { origin: Origin::Walks, curve }));
        true
    }
}
