//! What there is to say of a map projection, in numbers.

use crate::outline::GeoRing;
use crate::projection::Projection;

/// The numbers of a projection, and what of a file's rings is in it.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[non_exhaustive]
pub struct ProjectionReport {
    /// The name of the region.
    pub name: String,
    /// The largest scale over the least one, of the map as it is written.
    pub scale_ratio: f64,
    /// By how much the least possible ratio may be smaller.
    pub scale_ratio_error: f64,
    /// The same ratio of the best stereographic projection.
    pub stereographic_scale_ratio: f64,
    /// Longitude and latitude of the center of that projection.
    pub stereographic_center: [f64; 2],
    /// Longitude and latitude of the point of least scale, where x = y = 0.
    pub least_scale_at: [f64; 2],
    /// The area on the unit sphere.
    pub area: f64,
    /// The rings that the region is made of, counted from 1 in the file's order.
    pub rings: Vec<usize>,
    /// The number of other boundaries, which were left out.
    pub rings_left_out: usize,
    /// The share of the region in the area of all.
    pub share: f64,
    /// The number of its holes, which are part of the map.
    pub holes_filled: usize,
    /// The largest |log k| on the boundary, where a constant scale has 0.
    pub residual: f64,
    /// Whether the map is the best stereographic projection, which varies less than the one that was fitted.
    pub is_stereographic: bool,
    /// Whether the map overlaps itself.
    pub overlaps: bool,
    /// Longitude and latitude of a boundary point where the image meets itself.
    pub overlap_at: Option<[f64; 2]>,
}

impl ProjectionReport {
    /// The report about a projection of the largest region in these rings. `stem` is its name if the rings have none.
    pub fn new(stem: &str, rings: &[GeoRing], projection: &Projection) -> Self {
        let selection = projection.region().selection();
        let taken: Vec<&GeoRing> = selection.rings.iter().filter_map(|number| rings.get(number - 1)).collect();
        let name = taken.iter().find_map(|ring| ring.name.clone()).unwrap_or_else(|| stem.to_owned());
        let stereographic = projection.stereographic();
        let scale_ratio = projection.scale_ratio();
        Self {
            name,
            scale_ratio,
            scale_ratio_error: -scale_ratio * (-2.0 * projection.residual()).exp_m1(),
            stereographic_scale_ratio: stereographic.ratio,
            stereographic_center: stereographic.center.to_array(),
            least_scale_at: projection.least_scale_at().to_array(),
            area: projection.region().area(),
            rings: selection.rings.clone(),
            rings_left_out: selection.left_out,
            share: selection.share,
            holes_filled: selection.holes + taken.iter().map(|ring| ring.holes).sum::<usize>(),
            residual: projection.residual(),
            is_stereographic: projection.is_stereographic(),
            overlaps: projection.overlap().is_some(),
            overlap_at: projection.overlap().map(|at| at.to_array()),
        }
    }
}
