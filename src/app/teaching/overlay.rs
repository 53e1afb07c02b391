//! Curves that the plots draw over the map's own, by name.

use super::super::plots::Curve;
use super::through_disk::ThroughDisk;
use super::walks::Walks;
use crate::app::language::tr;
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
    /// Its name in a plot's legend and in the panel.
    pub fn name(self) -> &'static str {
        tr(match self {
            Self::Disk(DiskWay::Fresh) => "through the disk, fresh",
            Self::Disk(DiskWay::Precomputed) => "through the disk, precomputed",
            Self::Walks => "random walks",
        })
    }

    /// Its name where there is little room.
    pub fn short_name(self) -> &'static str {
        tr(match self {
            Self::Disk(DiskWay::Fresh) => "disk, fresh",
            Self::Disk(DiskWay::Precomputed) => "disk, precomputed",
            Self::Walks => "hits",
        })
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
    pub fn update(&mut self, disk: &ThroughDisk, walks: &Walks) -> bool {
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
