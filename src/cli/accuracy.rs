//! How a map's harmonic measures were computed, and the estimate of their errors, for `--json` and in words.

use crate::conformal::{ConformalMap, ErrorEstimate, PerSide, Side};

/// The method and the accuracy of a map.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Accuracy {
    /// `integral`, `adjoint` or `table`.
    kernel: PerSide<&'static str>,
    /// The unknowns of the integral equations.
    unknowns: PerSide<Option<usize>>,
    /// `None` unless both measures are from integral equations.
    error_estimate: Option<LargestErrors>,
    /// The share of each boundary where finite elements continue the measure of the integral equation.
    finite_element_share: PerSide<f64>,
    /// The number of edges of the mapped boundary both of whose ends have one image.
    coinciding_edges: usize,
    /// The errors of the images of the boundary vertices.
    #[serde(skip)]
    points: Option<Vec<f64>>,
}

/// The largest errors over the boundary.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
struct LargestErrors {
    omega: f64,
    image: f64,
}

impl Accuracy {
    /// That of this map.
    pub fn of(map: &ConformalMap) -> Self {
        let kernel = |side: Side| match (map.side(side).curve_boundary(), map.side(side).table()) {
            (Some(_), _) => "integral",
            (None, Some(_)) => "table",
            (None, None) => "adjoint",
        };
        let unknowns = |side: Side| map.side(side).curve_boundary().map(|boundary| boundary.integral().unknowns());
        let estimate = map.error_estimate();
        let largest = |&ErrorEstimate { omega, image, .. }: &ErrorEstimate| LargestErrors { omega, image };
        Self {
            kernel: PerSide::from_fn(kernel),
            unknowns: PerSide::from_fn(unknowns),
            error_estimate: estimate.as_ref().map(largest),
            finite_element_share: PerSide::from_fn(|side| map.continued_share(side)),
            coinciding_edges: map.coinciding_edges(),
            points: estimate.map(|estimate| estimate.points),
        }
    }

    /// The estimated errors of the images of the boundary vertices.
    pub fn points(&self) -> Option<&[f64]> {
        self.points.as_deref()
    }

    /// The estimate as a line, after a line break; nothing without one.
    pub fn text(&self) -> String {
        let line = |LargestErrors { omega, image }| {
            format!("\nestimated error of harmonic measure {omega:.1e}, of images of the boundary {image:.1e}")
        };
        self.error_estimate.map(line).unwrap_or_default()
    }
}
