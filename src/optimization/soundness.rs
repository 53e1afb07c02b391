//! Which candidates are maps: a coarse mesh has candidates whose discrete image degenerates, and degenerate triangles can
//! have any area. They have no better criterion, whatever is measured.
//!
//! A map is sound if its mean Q is not much larger than that of the start, and it has no more flipped triangles and hardly
//! more area in collapsed ones. What a search minimizes grows with the excess, so that it leads back to sound maps.
//!
//! Limits are those of surfaces, whose mesh is given. That of an outline is refined for the map that comes out, and the search is
//! on the coarse one: onto a cinquefoil the symmetric map of a star has Q = 1.22 there, above the limit, and 1.13 when refined.

use crate::conformal::Quality;

/// The largest mean Q in that of the start, and in addition to it: a conformal map of a mesh whose triangles are small has
/// Q = 1 all over, and more only by the error of the mesh.
pub(super) const Q_FACTOR: f64 = 1.05;
const Q_ADDED: f64 = 0.02;
/// Of these limits as much is used, since the result is computed anew, with another rounding.
const MARGIN: f64 = 0.999;

/// The largest share of the area in collapsed triangles, in addition to that of the start.
const COLLAPSED_ADDED: f64 = 1e-3;

/// How much of a criterion an excess of ln Q of 1 costs. On an egg of 1,256 triangles the least area distortion of all maps is
/// by 15 % less than that of sound ones, at Q 30 times as large; a hundredth more than the limit is to cost more.
const STEEP: f64 = 20.0;

/// The limits of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Soundness {
    q_mean: f64,
    flipped: u32,
    collapsed_area: f64,
}

impl Soundness {
    /// The limits for a start with this distortion.
    pub fn of(start: &Quality) -> Self {
        let Quality { q_mean, flipped, collapsed_area, .. } = *start;
        let margin = MARGIN * (Q_FACTOR * q_mean + Q_ADDED);
        Self { q_mean: margin.max(q_mean), flipped, collapsed_area: collapsed_area + COLLAPSED_ADDED }
    }

    /// Whether a map with this distortion is within the limits.
    pub fn holds(&self, found: &Quality) -> bool {
        let is_resolved = found.collapsed_area <= self.collapsed_area;
        found.q_mean <= self.q_mean && found.flipped <= self.flipped && is_resolved
    }

    /// What is added to the minimized value of a map: 0 if it is sound.
    pub fn penalty(&self, found: &Quality, value: f64) -> f64 {
        if self.holds(found) {
            return 0.0;
        }
        let flipped = f64::from(found.flipped.saturating_sub(self.flipped));
        let collapsed = (found.collapsed_area - self.collapsed_area).max(0.0);
        penalty(found.q_mean / self.q_mean, value) + STEEP * (1.0 + value) * (collapsed + 1e-3 * flipped)
    }
}

/// What is added to a minimized value with this ratio of the mean Q to the largest one.
pub(super) fn penalty(ratio: f64, value: f64) -> f64 {
    STEEP * (1.0 + value) * ratio.max(1.0).ln()
}
