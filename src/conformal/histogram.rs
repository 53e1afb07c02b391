//! The distribution of a weighted quantity: shares in equal bins, and the mean.
//!
//! For the distortion of a map (section 5.1) the values are Q or log₂(σ₁σ₂) and the
//! weights are areas: each share is then the fraction of the domain with that distortion.

/// The distribution of a quantity over `[low, high]`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Histogram {
    /// The lower end of the first bin.
    pub low: f64,
    /// The upper end of the last bin.
    pub high: f64,
    /// The share of the weight in each bin; the sum with `below` and `above` is 1.
    pub shares: Vec<f64>,
    /// The share of the weight below `low`.
    pub below: f64,
    /// The share of the weight above `high`.
    pub above: f64,
    /// The weighted mean, including values outside the range.
    pub mean: f64,
}

impl Histogram {
    /// The histogram of `(value, weight)` in `bins` equal bins of `[low, high]`, where
    /// `low < high`; the bins are half open, the last one is closed. `None` without
    /// positive weight. Cost O(values + bins).
    pub fn new(values: impl Iterator<Item = (f64, f64)>, low: f64, high: f64, bins: usize) -> Option<Self> {
        let mut histogram = Self { low, high, shares: vec![0.0; bins.max(1)], below: 0.0, above: 0.0, mean: 0.0 };
        let scale = histogram.shares.len() as f64 / (high - low);
        let mut total = 0.0;
        for (value, weight) in values {
            total += weight;
            histogram.mean += weight * value;
            *histogram.bin(value, scale) += weight;
        }
        if !(total > 0.0 && total.is_finite()) {
            return None;
        }
        let [below, above, mean] = [&mut histogram.below, &mut histogram.above, &mut histogram.mean];
        histogram.shares.iter_mut().chain([below, above, mean]).for_each(|sum| *sum /= total);
        Some(histogram)
    }

    fn bin(&mut self, value: f64, scale: f64) -> &mut f64 {
        if value < self.low {
            &mut self.below
        } else if value > self.high {
            &mut self.above
        } else {
            let last = self.shares.len() - 1;
            &mut self.shares[(((value - self.low) * scale) as usize).min(last)]
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn shares_are_weighted_and_add_up_to_one() {
        let values = [(-1.0, 1.0), (0.0, 2.0), (0.99, 1.0), (1.0, 3.0), (4.0, 5.0), (4.5, 8.0)];
        let histogram = Histogram::new(values.into_iter(), 0.0, 4.0, 4).unwrap();
        assert_eq!(histogram.shares, [3.0, 3.0, 0.0, 5.0].map(|weight: f64| weight / 20.0));
        assert_eq!((histogram.below, histogram.above), (0.05, 0.4));
        assert!((histogram.mean - (-1.0 + 0.99 + 3.0 + 20.0 + 36.0) / 20.0).abs() < 1e-15, "{}", histogram.mean);
    }

    #[test]
    fn nothing_has_no_histogram() {
        assert_eq!(Histogram::new(std::iter::empty(), 0.0, 1.0, 8), None);
        assert_eq!(Histogram::new(std::iter::once((0.5, 0.0)), 0.0, 1.0, 8), None);
    }
}
