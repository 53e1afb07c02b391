//! Built-in outlines.

use super::Outline;
use crate::geometry::{DVec2, SimplePolygon};

/// A built-in outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Preset {
    /// The unit disk.
    Disk,
    /// A square.
    Square,
    /// A gingerbread man.
    Gingerbread,
    /// A heart.
    Heart,
    /// The blob of the paper's section 5.2.
    Blob,
    /// The V of the paper's section 1.2.
    VShape,
    /// A flower of five petals.
    Cinquefoil,
    /// A maple leaf.
    MapleLeaf,
    /// A hand.
    Hand,
    /// A turkey.
    Turkey,
    /// The L of finite element textbooks.
    LShape,
    /// A five-pointed star.
    Star,
    /// A spiral corridor.
    Spiral,
}

impl Preset {
    /// All presets, in the order of the menus.
    pub const ALL: [Self; 13] = [
        Self::Disk,
        Self::Square,
        Self::Gingerbread,
        Self::Heart,
        Self::Blob,
        Self::VShape,
        Self::Cinquefoil,
        Self::MapleLeaf,
        Self::Hand,
        Self::Turkey,
        Self::LShape,
        Self::Star,
        Self::Spiral,
    ];

    /// The name in `preset:NAME`, links and session files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Disk => "disk",
            Self::Square => "square",
            Self::Gingerbread => "gingerbread",
            Self::Heart => "heart",
            Self::Blob => "blob",
            Self::VShape => "v-shape",
            Self::Cinquefoil => "cinquefoil",
            Self::MapleLeaf => "maple-leaf",
            Self::Hand => "hand",
            Self::Turkey => "turkey",
            Self::LShape => "l-shape",
            Self::Star => "star",
            Self::Spiral => "spiral",
        }
    }

    /// The number of boundary samples that the paper uses for this outline.
    pub fn paper_samples(self) -> Option<u32> {
        match self {
            Self::Gingerbread => Some(500),
            Self::Heart | Self::Blob | Self::Cinquefoil => Some(1000),
            Self::VShape => Some(2000),
            Self::MapleLeaf => Some(3200),
            Self::Hand => Some(1800),
            _ => None,
        }
    }

    /// The outline itself: a dense polygon.
    pub fn outline(self) -> Outline {
        // skeleton: every preset is a disk
        let points: Vec<DVec2> =
            (0..2000).map(|k| DVec2::from_angle(std::f64::consts::TAU * k as f64 / 2000.0)).collect();
        let polygon = match SimplePolygon::try_from(points) {
            Ok(polygon) => polygon,
            Err(_) => unreachable!(),
        };
        Outline { name: self.name().to_owned(), polygon, notes: Vec::new() }
    }
}
