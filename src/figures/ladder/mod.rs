//! The ladder of accuracy: errors of harmonic measure and of boundary images against unknowns, boundary points and time.
//!
//! A [`Rung`] is one outline by one method at one resolution. Errors of ω are taken counted from the start of the
//! curve: along the whole of it for the boundary integral, at the samples for the others. Errors of the image are those
//! of a map whose exact one is known ([`ImageOf`]), both sides by the same method at the same resolution. Everything
//! runs on the calling thread.
//!
//! | file | what |
//! |---|---|
//! | `shape`, `polygons` | the outlines, and the points from which measure is taken |
//! | `truth` | what errors are measured against |
//! | `measured` | what the methods share: errors, medians of times |
//! | `integral`, `sampled` | the boundary integral; finite elements and Zipper, which sample the boundary |

mod integral;
mod measured;
mod polygons;
mod sampled;
mod shape;
mod truth;

use super::{Cell, Detail, FigureError, Table};
use measured::Measured;
pub use polygons::coast;
pub use shape::LadderShape;
pub use truth::{Reference, Truth};

/// A way to compute harmonic measure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LadderMethod {
    /// The integral equation on the boundary.
    Integral,
    /// Finite elements, adjoint solves, uniform samples and triangles: the paper's.
    AdjointUniform,
    /// Finite elements, adjoint solves, adaptive samples and graded triangles: the app's while editing.
    AdjointDefault,
    /// The geodesic algorithm, run for each point.
    Zipper,
}

impl LadderMethod {
    /// All methods, in the order of the table.
    pub const ALL: [Self; 4] = [Self::Integral, Self::AdjointUniform, Self::AdjointDefault, Self::Zipper];

    /// The name in a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Integral => "integral",
            Self::AdjointUniform => "adjoint-uniform",
            Self::AdjointDefault => "adjoint-default",
            Self::Zipper => "zipper",
        }
    }

    /// The name in a figure.
    pub fn title(self) -> &'static str {
        match self {
            Self::Integral => "boundary integral",
            Self::AdjointUniform => "finite elements, uniform",
            Self::AdjointDefault => "finite elements, adaptive and graded",
            Self::Zipper => "Zipper",
        }
    }

    /// The resolutions: steps of [`integral`](Self::Integral), boundary samples of the others.
    fn resolutions(self, shape: LadderShape, detail: Detail) -> &'static [u32] {
        match (self, detail) {
            (Self::Integral, Detail::Paper) => &[0, 1, 2, 3, 4],
            (Self::Integral, Detail::Quick) => &[0, 2, 3],
            (Self::AdjointDefault, Detail::Paper) if shape.has_many_corners() => &[1000, 2000, 4000],
            (_, Detail::Paper) if shape.has_many_corners() => &[500, 1000, 2000],
            (_, Detail::Quick) if shape.has_many_corners() => &[500, 750, 1000],
            (Self::AdjointUniform, Detail::Quick) => &[125, 250, 500],
            (Self::Zipper | Self::AdjointDefault, Detail::Quick) => &[250, 500, 1000],
            (Self::AdjointDefault, Detail::Paper) => &[250, 500, 1000, 2000, 4000],
            // uniform triangles of a round outline are m²/8; Zipper's time is of the order of m² for each point
            (Self::AdjointUniform | Self::Zipper, Detail::Paper) if shape == LadderShape::VShape => {
                &[250, 500, 1000, 2000, 4000]
            }
            (Self::AdjointUniform | Self::Zipper, Detail::Paper) => &[250, 500, 1000, 2000],
        }
    }
}

/// The map whose boundary images are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ImageOf {
    /// The outline onto the disk, its point to 0.
    OntoDisk,
    /// The disk onto the outline, 0 to its point.
    DiskOnto,
    /// The outline onto the blob, its point to the blob's: on the V most of the disk's points go to its tip.
    OntoBlob,
    /// None: the measure is known at the corners only.
    Unknown,
}

impl ImageOf {
    /// The name in a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::OntoDisk => "onto-disk",
            Self::DiskOnto => "disk-onto",
            Self::OntoBlob => "onto-blob",
            Self::Unknown => "",
        }
    }
}

impl LadderShape {
    /// The map whose images are compared.
    pub fn image_of(self) -> ImageOf {
        match self {
            Self::Disk => ImageOf::OntoDisk,
            Self::VShape => ImageOf::OntoBlob,
            Self::LShape => ImageOf::Unknown,
            _ => ImageOf::DiskOnto,
        }
    }
}

/// One outline by one method at one resolution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Rung {
    /// The outline.
    pub shape: LadderShape,
    /// The method.
    pub method: LadderMethod,
    /// The number of boundary samples asked for; for the boundary integral a step: 3 is its default, 4 the finer one,
    /// each step below 3 has panels up to twice as long.
    pub resolution: u32,
}

/// Maximum and mean of errors.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[allow(missing_docs, reason = "the names say it")]
pub struct Errors {
    pub max: f64,
    pub mean: f64,
}

/// A measured rung.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct LadderRow {
    /// What was measured.
    #[serde(flatten)]
    pub rung: Rung,
    /// Points on the boundary: samples, or the nodes of the integral equation.
    pub m: usize,
    /// Unknowns of the linear system: interior vertices, or nodes; for Zipper, geodesics.
    pub unknowns: usize,
    /// Errors of harmonic measure.
    pub omega: Errors,
    /// Errors of the images; `None` if no exact map is known.
    pub image: Option<Errors>,
    /// What is computed once for an outline, in milliseconds. Zipper prepares nothing.
    pub prepare_ms: f64,
    /// What is computed for each new point, in milliseconds.
    pub point_ms: f64,
}

impl Rung {
    /// All rungs, outline by outline, method by method, with rising resolution.
    pub fn all(detail: Detail) -> Vec<Self> {
        LadderShape::ALL.into_iter().flat_map(|shape| Self::of(shape, detail)).collect()
    }

    /// The rungs of one outline.
    pub fn of(shape: LadderShape, detail: Detail) -> Vec<Self> {
        let of_method = |method: LadderMethod| {
            let resolutions = method.resolutions(shape, detail).iter();
            resolutions.map(move |&resolution| Self { shape, method, resolution })
        };
        LadderMethod::ALL.into_iter().flat_map(of_method).collect()
    }

    /// Measures the rung; times are medians of `runs` (at least one).
    pub fn measure(self, runs: usize) -> Result<LadderRow, FigureError> {
        let truth = Truth::new(self.shape)?;
        let Measured { m, unknowns, omega, image, prepare_ms, point_ms } = match self.method {
            LadderMethod::Integral => integral::measure(&truth, self, runs.max(1))?,
            LadderMethod::AdjointUniform | LadderMethod::AdjointDefault => {
                sampled::finite_elements(&truth, self, runs.max(1))?
            }
            LadderMethod::Zipper => sampled::zipper(&truth, self, runs.max(1))?,
        };
        Ok(LadderRow { rung: self, m, unknowns, omega, image, prepare_ms, point_ms })
    }
}

impl LadderRow {
    /// A table with a line for each of `rows`.
    pub fn table(rows: &[Self]) -> Table {
        let mut table = Table::new(&[
            "shape",
            "method",
            "m",
            "unknowns",
            "omega_max",
            "omega_mean",
            "image_max",
            "image_mean",
            "prepare_ms",
            "point_ms",
            "reference",
            "image_of",
        ]);
        for Self { rung, m, unknowns, omega, image, prepare_ms, point_ms } in rows {
            let image_cell =
                |value: fn(&Errors) -> f64| image.as_ref().map_or(Cell::Empty, |errors| value(errors).into());
            table.rows.push(vec![
                rung.shape.name().into(),
                rung.method.name().into(),
                (*m).into(),
                (*unknowns).into(),
                omega.max.into(),
                omega.mean.into(),
                image_cell(|errors| errors.max),
                image_cell(|errors| errors.mean),
                (*prepare_ms).into(),
                (*point_ms).into(),
                rung.shape.reference().name().into(),
                rung.shape.image_of().name().into(),
            ]);
        }
        table
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
