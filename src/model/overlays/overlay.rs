//! Curves that the plots draw over the map's own, by name.

use crate::language::{Label, key};
use crate::model::curves::Curve;
use crate::model::overlays::disk_comparison::DiskComparison;
use crate::model::overlays::walks::Walks;
use crate::session::DiskWay;

/// Whose curve it is: decides the colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// A way through the disk.
    Disk(DiskWay),
    /// Random walks.
    Walks,
}

impl Origin {
    /// Its English name in a plot's legend and in the panel.
    pub fn name(self) -> Label {
        match self {
            Self::Disk(DiskWay::Fresh) => key::through_disk_fresh(),
            Self::Disk(DiskWay::Precomputed) => key::through_disk_precomputed(),
            Self::Walks => key::random_walks(),
        }
    }

    /// Its English name where there is little room.
    pub fn short_name(self) -> Label {
        match self {
            Self::Disk(DiskWay::Fresh) => key::disk_fresh(),
            Self::Disk(DiskWay::Precomputed) => key::disk_precomputed(),
            Self::Walks => key::hits(),
        }
    }

    /// Whether its lines are dashed. A fresh disk map agrees with this map where all goes well: both are to be seen then.
    pub fn is_dashed(self) -> bool {
        self == Self::Disk(DiskWay::Fresh)
    }
}

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// Whose.
    pub origin: Origin,
    /// The curve.
    pub curve: Curve,
}

/// All of them, by plot, from the lowest to the topmost.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Overlays {
    /// Over the harmonic measure.
    pub measure: Vec<Overlay>,
    /// Over the reparameterisation.
    pub reparameterisation: Vec<Overlay>,
    /// What they were made from.
    versions: [u64; 2],
}

impl Overlays {
    /// Renews them when the disk's or the walks' have changed; whether they have.
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
            self.measure.extend(found.measures.iter().map(|curve| by(Origin::Disk(way), curve)));
            self.reparameterisation.push(by(Origin::Disk(way), &found.reparameterisation));
        }
        self.measure.extend(walks.cumulative().map(|curve| Overlay { origin: Origin::Walks, curve }));
        true
    }
}
