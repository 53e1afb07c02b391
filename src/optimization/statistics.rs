//! Statistics of a local scale: values with weights; triangles that stand for all.

/// The share of the weight that a [`spread`] leaves out at each end.
pub const LEFT_OUT: f64 = 0.01;

/// ln of the local scale |f′| at places of a domain, with their weights (areas, ≥ 0).
///
/// Places whose scale is not known count as those that are farthest from the others, so that no statistic is better for them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Scales {
    values: Vec<(f64, f64)>,
    missing: f64,
}

impl Scales {
    /// Drops all values.
    pub fn clear(&mut self) {
        self.values.clear();
        self.missing = 0.0;
    }

    /// Adds a place whose scale is not known.
    pub fn miss(&mut self, weight: f64) {
        self.missing += weight;
    }

    /// Adds a value; one without weight is left out, one that is not finite is not known.
    pub fn push(&mut self, ln_scale: f64, weight: f64) {
        if ln_scale.is_finite() && weight > 0.0 {
            self.values.push((ln_scale, weight));
        } else if weight > 0.0 {
            self.miss(weight);
        }
    }

    fn weight(&self) -> f64 {
        self.values.iter().map(|(_, weight)| weight).sum()
    }

    /// The weighted mean of (ln σ₁σ₂)² with σ₁ = σ₂ = |f′|, after the best common scale: the variance of 2 ln |f′|.
    /// `None` without weight.
    pub fn variance(&self) -> Option<f64> {
        let total = self.weight();
        let mean = self.values.iter().map(|(value, weight)| weight * value).sum::<f64>() / total;
        let deviations = self.values.iter().map(|(value, weight)| ((value - mean) * (value - mean), weight));
        let (squares, largest) =
            deviations.fold((0.0, 0.0_f64), |(sum, largest), (off, weight)| (sum + weight * off, largest.max(off)));
        Some(4.0 * (squares + self.missing * largest) / (total + self.missing))
            .filter(|variance| total > 0.0 && variance.is_finite())
    }

    /// The ratio of the largest to the least scale after [`LEFT_OUT`] of the weight at either end. `None` without weight.
    /// Sorts the values.
    pub fn spread(&mut self) -> Option<f64> {
        let known = self.weight();
        let left_out = (LEFT_OUT * (known + self.missing) - self.missing).max(0.0);
        self.values.sort_by(|a, b| a.0.total_cmp(&b.0));
        let low = self.quantile(left_out)?;
        Some((self.quantile(known - left_out)? - low).exp())
    }

    /// The sorted value at which this weight from below is reached.
    fn quantile(&self, at: f64) -> Option<f64> {
        let mut sum = 0.0;
        let reached = self.values.iter().find(|(_, weight)| {
            sum += weight;
            sum >= at
        });
        reached.or(self.values.last()).map(|(value, _)| *value)
    }
}

/// Of weighted triangles about `most`, at equal steps of weight, with equal weights; all if they are not more.
pub fn thinned(all: Vec<(usize, f64)>, most: usize) -> Vec<(usize, f64)> {
    if all.len() <= most {
        return all;
    }
    let total: f64 = all.iter().map(|(_, weight)| weight).sum();
    let step = total / most as f64;
    let mut sum = 0.0;
    let mut next = 0.5 * step;
    let mut chosen = Vec::with_capacity(most);
    for (t, weight) in all {
        sum += weight;
        if sum >= next {
            // a large triangle stands for several steps
            let steps = ((sum - next) / step).floor() + 1.0;
            chosen.push((t, steps * step));
            next += steps * step;
        }
    }
    chosen
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    fn scales(values: impl IntoIterator<Item = (f64, f64)>) -> Scales {
        let mut scales = Scales::default();
        values.into_iter().for_each(|(value, weight)| scales.push(value, weight));
        scales
    }

    #[test]
    fn places_without_a_scale_make_no_statistic_better() {
        let mut known = scales((0..1000).map(|k| (f64::from(k) / 1000.0, 1.0)));
        let mut before = (known.variance().unwrap(), known.spread().unwrap());
        for missing in [1.0, 5.0, 50.0] {
            known.miss(missing);
            let after = (known.variance().unwrap(), known.spread().unwrap());
            assert!(after.0 > before.0 && after.1 >= before.1, "{after:?} after {before:?}");
            before = after;
        }
        known.clear();
        assert_eq!(known, Scales::default());
    }

    #[test]
    fn the_variance_is_that_of_the_logarithm_of_area_and_a_common_scale_does_not_matter() {
        // ln σ₁σ₂ = ±2 with weights 3 : 1 has mean 1 and variance 3
        for shift in [0.0, 5.0, -700.0] {
            let found = scales([(1.0 + shift, 3.0), (-1.0 + shift, 1.0)]).variance().unwrap();
            assert!((found - 3.0).abs() < 1e-9, "{found}");
        }
        assert_eq!((scales([]).variance(), scales([]).spread()), (None, None));
        assert_eq!((scales([(1.0, 0.0)]).variance(), scales([(f64::NAN, 1.0)]).spread()), (None, None));
    }

    /// Of a uniform distribution of ln |f′| over an interval of length 1, 98 % of the weight spans 0.98.
    #[test]
    fn the_spread_leaves_out_a_hundredth_at_either_end_however_the_weight_is_divided() {
        for count in [50, 1000, 7919] {
            let n = f64::from(count);
            let uniform = scales((0..count).rev().map(|k| ((f64::from(k) + 0.5) / n, 1.0 / n))).spread().unwrap();
            assert!((uniform.ln() - 0.98).abs() < 2.0 / n, "{count}: {}", uniform.ln());
        }
        let outliers = scales([(-500.0, 0.004), (0.0, 0.6), (0.0, 0.392), (300.0, 0.004)]).spread().unwrap();
        assert!(outliers < 1e3, "{outliers}");
    }
}
