//! What is drawn of the map and beside it: pattern, colours, comparisons.

/// The pattern drawn on one side and carried by the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TextureKind {
    /// A checkerboard with a vertical change of hue.
    #[default]
    Checker,
    /// Lines.
    Grid,
    /// Circles and rays about the interior point.
    Polar,
    /// The same in the disk: level sets of Green's function and of harmonic measure.
    Conformal,
    /// The user's own image.
    Image,
}

/// What the meshes are painted with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Colouring {
    /// The pattern that the map carries.
    #[default]
    Texture,
    /// The angle distortion Q = σ₁/σ₂ of every triangle.
    Angle,
    /// The area distortion log₂(σ₁σ₂) of every triangle.
    Area,
}

/// The ways that are shown beside the map: through the disk (sections 1.2 and 5.2).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Comparison {
    /// None.
    #[default]
    Off,
    /// Disk maps made for the present interior points.
    Fresh,
    /// Disk maps made for the poles of inaccessibility, then Möbius.
    Precomputed,
    /// Both of these.
    Both,
}

/// A way through the disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DiskWay {
    /// As [`Comparison::Fresh`].
    Fresh,
    /// As [`Comparison::Precomputed`].
    Precomputed,
}

impl DiskWay {
    /// Both, in the order in which they are listed.
    pub const ALL: [Self; 2] = [Self::Fresh, Self::Precomputed];
}

impl Comparison {
    /// Whether it shows this way.
    pub fn shows(self, way: DiskWay) -> bool {
        match self {
            Self::Off => false,
            Self::Fresh => way == DiskWay::Fresh,
            Self::Precomputed => way == DiskWay::Precomputed,
            Self::Both => true,
        }
    }
}
