//! Curves that the plots draw over the map's own, by name.

use super::super::plots::Curve;
use super::through_disk::ThroughDisk;
use super::walks::Walks;

/// Whose curve it is: decides the colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The way through the disk.
    Disk,
    /// Random walks.
    Walks,
}

impl Origin {
    /// Its name in a legend.
    pub fn name(self) -> &'static str {
        match self {
            Self::Disk => "through the disk",
            Self::Walks => "random walks",
        }
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

/// All of them, by plot.
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
        if let Some(found) = disk.found() {
            self.measure.extend(found.measures.iter().map(|curve| by(Origin::Disk, curve)));
            self.reparameterisation.push(by(Origin::Disk, &found.reparameterisation));
        }
        self.measure.extend(walks.cumulative().map(|curve| Overlay { origin: Origin::Walks, curve }));
        true
    }
}
