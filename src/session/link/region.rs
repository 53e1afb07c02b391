//! The painted region in a link: dabs of one radius follow each other, with 32 bits a number and no third coordinate in the
//! plane, so that a dab of a stroke takes eight bytes.

use crate::geometry::DVec3;
use crate::optimization::Dab;
use serde::{Deserialize, Serialize};

/// Dabs of one radius, in the plane or in space.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) enum Run {
    Plane(f32, Vec<[f32; 2]>),
    Space(f32, Vec<[f32; 3]>),
}

/// The runs of these dabs, whose numbers are [rounded](Dab::rounded).
pub(super) fn runs(dabs: &[Dab]) -> Vec<Run> {
    let is_planar = |dab: &Dab| dab.middle.z == 0.0;
    let is_alike = |a: &Dab, b: &Dab| a.radius == b.radius && is_planar(a) == is_planar(b);
    let of = |dabs: &[Dab]| {
        let radius = dabs[0].radius as f32;
        let middles = dabs.iter().map(|dab| dab.middle.to_array().map(|value| value as f32));
        if is_planar(&dabs[0]) {
            Run::Plane(radius, middles.map(|[x, y, _]| [x, y]).collect())
        } else {
            Run::Space(radius, middles.collect())
        }
    };
    dabs.chunk_by(is_alike).map(of).collect()
}

/// The dabs of runs.
pub(super) fn dabs(runs: Vec<Run>) -> Vec<Dab> {
    let of = |run: Run| {
        let (radius, middles) = match run {
            Run::Plane(radius, middles) => (radius, middles.into_iter().map(|[x, y]| [x, y, 0.0]).collect()),
            Run::Space(radius, middles) => (radius, middles),
        };
        let dab =
            move |middle: [f32; 3]| Dab { middle: DVec3::from_array(middle.map(f64::from)), radius: radius.into() };
        middles.into_iter().map(dab).collect::<Vec<_>>()
    };
    runs.into_iter().flat_map(of).collect()
}
