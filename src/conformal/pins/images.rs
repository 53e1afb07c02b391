//! Boundary pairs of a map that is there: the image of a boundary point, and three pins that determine the map.

use super::{PinError, Pins};
use crate::conformal::{ConformalMap, PerSide, Side};
use crate::outline::BoundaryPoint;

impl ConformalMap {
    /// The image of a boundary point of the side `from`, whichever mesh is mapped. Both are fractions of the length of
    /// their boundary. Between outlines with the boundary integral it has the digits of [`Self::curve_map`], else those of
    /// the finite elements' measures.
    pub fn boundary_image(&self, from: Side, fraction: f64) -> f64 {
        let onto = from.other();
        let boundary = |side| self.side(side).curve_boundary();
        if let (Some(curves), Some(there), Some(here)) = (self.curve_map(from), boundary(onto), boundary(from)) {
            return there.fraction(curves.image(here.at_fraction(fraction)));
        }
        self.side(onto).fraction_at(self.image_by_samples(from, fraction))
    }

    /// [`Self::boundary_image`] by the measures at the samples, as a point between these.
    pub(super) fn image_by_samples(&self, from: Side, fraction: f64) -> BoundaryPoint {
        let omega = self.measure(from).at(self.side(from).at_fraction(fraction));
        self.measure(from.other()).point_at(omega)
    }
}

impl Pins {
    /// Three boundary pairs of a map: its anchors, and the pairs a third of the measure away from them. Errors: on one
    /// side f64 does not tell these apart.
    pub fn of(map: &ConformalMap) -> Result<Self, PinError> {
        let measure = map.measure(Side::Source);
        let place = |k: u32| match k {
            0 => measure.anchor(),
            _ => measure.point_at(f64::from(k) / 3.0),
        };
        let anchors = map.constraints().map(|constraints| constraints.anchors);
        let pair = |k| {
            let source = map.side(Side::Source).fraction_at(place(k));
            let image = || PerSide::new(source, map.boundary_image(Side::Source, source));
            anchors.filter(|_| k == 0).unwrap_or_else(image)
        };
        Self::new((0..3).map(pair))
    }

    /// These pins with another place of one of them, counted from 0, on one side. Errors: it is no pin, or the places do
    /// not run around both sides in one order.
    pub fn moved(&self, pin: usize, side: Side, fraction: f64) -> Result<Self, PinError> {
        let mut pairs = self.0.clone();
        pairs.get_mut(pin).ok_or(PinError::Count { count: pin + 1 })?[side] = fraction;
        Self::new(pairs)
    }

    /// These pins and one more. Errors: it is out of order, or there are too many.
    pub fn and(&self, pair: PerSide<f64>) -> Result<Self, PinError> {
        Self::new(self.0.iter().copied().chain([pair]))
    }

    /// These pins without one of them, counted from 0. Errors: fewer than three remain.
    pub fn without(&self, pin: usize) -> Result<Self, PinError> {
        Self::new(self.0.iter().enumerate().filter(|(k, _)| *k != pin).map(|(_, pair)| *pair))
    }

    /// These pins with source and target exchanged.
    #[must_use]
    pub fn exchanged(&self) -> Self {
        Self(self.0.iter().map(|pair| PerSide::new(pair.target, pair.source)).collect())
    }
}
