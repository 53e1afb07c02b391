//! How a map's harmonic measures were computed, and the estimate of their errors, for `--json` and in words.

use crate::boundary_integral::BoundaryIntegral;
use crate::conformal::{ConformalMap, ErrorEstimate, PerSide, Side};

/// The method and the accuracy of a map.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Accuracy {
    /// `integral`, `adjoint` or `table`.
    kernel: PerSide<&'static str>,
    /// The unknowns of the integral equations.
    unknowns: PerSide<Option<usize>>,
    /// Why an outline stays with finite elements although the integral equation was to be used.
    finite_element_reason: PerSide<Option<String>>,
    /// From the integral equations, or by comparison with finer meshes.
    error_estimate: Option<LargestErrors>,
    /// Why there is none although it was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    error_estimate_missing: Option<String>,
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
    /// That of this map; `missing` is why its errors are not estimated.
    pub fn of(map: &ConformalMap, missing: Option<String>) -> Self {
        let kernel = |side: Side| match (map.side(side).curve_boundary(), map.side(side).table()) {
            (Some(_), _) => "integral",
            (None, Some(_)) => "table",
            (None, None) => "adjoint",
        };
        let unknowns = |side: Side| map.side(side).boundary_integral().map(BoundaryIntegral::unknowns);
        let reason = |side: Side| map.side(side).unsharpened().map(ToString::to_string);
        let estimate = map.error_estimate();
        let largest = |&ErrorEstimate { omega, image, .. }: &ErrorEstimate| LargestErrors { omega, image };
        Self {
            kernel: PerSide::from_fn(kernel),
            unknowns: PerSide::from_fn(unknowns),
            finite_element_reason: PerSide::from_fn(reason),
            error_estimate: estimate.as_ref().map(largest),
            error_estimate_missing: missing,
            finite_element_share: PerSide::from_fn(|side| map.continued_share(side)),
            coinciding_edges: map.coinciding_edges(),
            points: estimate.map(|estimate| estimate.points),
        }
    }

    /// The estimated errors of the images of the boundary vertices.
    pub fn points(&self) -> Option<&[f64]> {
        self.points.as_deref()
    }

    /// The largest estimated error of an image of a boundary vertex.
    pub fn image_error(&self) -> Option<f64> {
        self.error_estimate.map(|largest| largest.image)
    }

    /// Where finite elements are used instead of the integral equation, and the estimate, as lines after line breaks.
    pub fn text(&self) -> String {
        let finite = |(side, reason): (Side, &Option<String>)| {
            reason
                .as_ref()
                .map(|reason| format!("\n{side}: finite elements instead of the integral equation: {reason}"))
        };
        let finite: String = self.finite_element_reason.iter().filter_map(finite).collect();
        format!("{finite}{}", self.estimate())
    }

    fn estimate(&self) -> String {
        let line = |LargestErrors { omega, image }| {
            format!("\nestimated error of harmonic measure {omega:.1e}, of images of the boundary {image:.1e}")
        };
        self.error_estimate.map(line).unwrap_or_default()
    }
}
