//! The maps between presets that are known in closed form, with their boundary correspondence.
//!
//! A map is known by harmonic measure if both measures are. They are known from any interior
//! point and any boundary point for four presets, so that all sixteen maps between these are known.
//!
//! | preset | harmonic measure | source |
//! |---|---|---|
//! | disk | (2θ − t)/2π | section 3.1 of the paper |
//! | square | the disk's, through the lemniscate sine | [`exact::square`](crate::exact::square) |
//! | blob | the disk's, through g by Newton's method | section 5.2 |
//! | V-shape | in the strip coordinate, where nothing is crowded | section 1.2 |
//!
//! No other preset has an elementary map. A loaded outline has none, even if its points are
//! a preset's. The presets are polygons along the curves: a fraction of the polygon's arc length is taken as the same
//! fraction of the curve's, with an error of at most 1e-5 (the V and the blob).

mod arc_length;
mod crossing;
mod measure;

pub use arc_length::ArcLength;
pub use measure::ExactMeasure;

use crate::conformal::{Constraints, PerSide, Side};
use crate::geometry::DVec2;
use crate::outline::Preset;
use crate::session::{OutlineSpec, Session};

/// The boundary values of the exact map between two presets under constraints.
///
/// Boundary points are given by their arc lengths from the anchor as fractions of the whole, in `[0, 1]`.
#[derive(Debug, Clone)]
pub struct ExactMap {
    sides: PerSide<Anchored>,
}

impl ExactMap {
    /// The map of a session whose domains have these poles; `None` if it is not known. See [`Self::between`].
    pub fn of_session(session: &Session, poles: PerSide<DVec2>) -> Option<Self> {
        Self::between(Self::presets(session)?, &session.constraints(poles))
    }

    /// The presets of a session's outlines; `None` if one is loaded.
    pub fn presets(session: &Session) -> Option<PerSide<Preset>> {
        let preset = |outline: &OutlineSpec| match outline {
            OutlineSpec::Preset(preset) => Some(*preset),
            OutlineSpec::Points { .. } => None,
        };
        PerSide::from_fn(|side| preset(&session.domain(side).outline)).both()
    }

    /// The map from one preset to another; `None` if it is not known in closed form, an
    /// interior point is not inside its curve, or an anchor is not finite. Cost: about 1000 evaluations per side.
    pub fn between(presets: PerSide<Preset>, constraints: &Constraints) -> Option<Self> {
        let anchored = |side: Side| {
            let measure = ExactMeasure::new(presets[side], constraints.points[side].in_plane()?)?;
            Anchored::new(measure, constraints.anchors[side])
        };
        Some(Self { sides: PerSide::from_fn(anchored).both()? })
    }

    /// ω of a side at `x`: 0 at 0, 1 at 1, non-decreasing up to rounding.
    pub fn measure(&self, side: Side, x: f64) -> f64 {
        self.sides[side].at(x)
    }

    /// r: the image on the other side of the point at `x`; 0 at 0, 1 at 1, non-decreasing up to rounding.
    pub fn reparameterisation(&self, from: Side, x: f64) -> f64 {
        match x {
            x if x <= 0.0 => 0.0,
            x if x >= 1.0 => 1.0,
            x => self.sides[from.other()].inverse_at(self.measure(from, x)),
        }
    }
}

/// A measure counted from an anchor.
#[derive(Debug, Clone)]
struct Anchored {
    measure: ExactMeasure,
    /// The anchor's fraction of arc length, in `[0, 1)`, and the measure there.
    anchor: f64,
    before: f64,
}

impl Anchored {
    fn new(measure: ExactMeasure, anchor: f64) -> Option<Self> {
        let anchor = anchor.rem_euclid(1.0);
        let before = measure.at(anchor);
        anchor.is_finite().then_some(Self { measure, anchor, before })
    }

    fn at(&self, x: f64) -> f64 {
        let s = self.anchor + x;
        if s < 1.0 { self.measure.at(s) - self.before } else { 1.0 - (self.before - self.measure.at(s - 1.0)) }
            .clamp(0.0, 1.0)
    }

    fn inverse_at(&self, omega: f64) -> f64 {
        let after = 1.0 - self.before;
        let x = if omega < after {
            self.measure.inverse_at(self.before + omega) - self.anchor
        } else {
            self.measure.inverse_at(omega - after) + (1.0 - self.anchor)
        };
        x.clamp(0.0, 1.0)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests;
