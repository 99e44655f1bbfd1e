//! Minimum, maximum, mean, standard deviation and quantiles of a stream of numbers.

use dobot_wire::single;

/// The summary of a feature in a dataset, one number for each of its values.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Summary {
    pub(crate) min: Vec<f64>,
    pub(crate) max: Vec<f64>,
    pub(crate) mean: Vec<f64>,
    /// The sum of squared deviations from the mean (Welford).
    squares: Vec<f64>,
    /// All numbers, for the quantiles: 9 MB for an hour of all features.
    values: Vec<Vec<f32>>,
    pub(crate) count: u32,
}

impl Summary {
    /// Creates an empty summary of this number of values.
    pub(crate) fn new(len: usize) -> Self {
        Self {
            min: vec![f64::INFINITY; len],
            max: vec![f64::NEG_INFINITY; len],
            mean: vec![0.0; len],
            squares: vec![0.0; len],
            values: vec![Vec::new(); len],
            count: 0,
        }
    }

    pub(crate) fn push(&mut self, values: &[f64]) {
        self.count += 1;
        for (n, value) in values.iter().enumerate() {
            self.min[n] = self.min[n].min(*value);
            self.max[n] = self.max[n].max(*value);
            let apart = value - self.mean[n];
            self.mean[n] += apart / f64::from(self.count);
            self.squares[n] += apart * (value - self.mean[n]);
            self.values[n].push(single(*value));
        }
    }

    /// The standard deviation of all numbers.
    pub(crate) fn std(&self) -> Vec<f64> {
        let each = self.squares.iter();
        each.map(|item| (item / f64::from(self.count)).sqrt())
            .collect()
    }

    /// The quantiles of [`QUANTILES`] of all numbers, interpolated between the nearest two as numpy does.
    pub(crate) fn quantiles(&self) -> [Vec<f64>; QUANTILES.len()] {
        let mut found = [const { Vec::new() }; QUANTILES.len()];
        for values in &self.values {
            let mut sorted = values.clone();
            sorted.sort_unstable_by(f32::total_cmp);
            for (quantiles, (_, share)) in found.iter_mut().zip(QUANTILES) {
                quantiles.push(quantile(&sorted, share));
            }
        }
        found
    }
}

/// The quantiles that LeRobot normalises by: their names and shares.
pub(crate) const QUANTILES: [(&str, f64); 5] = [
    ("q01", 0.01),
    ("q10", 0.1),
    ("q50", 0.5),
    ("q90", 0.9),
    ("q99", 0.99),
];

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "an index into the numbers"
)]
fn quantile(sorted: &[f32], share: f64) -> f64 {
    let Some(last) = sorted.len().checked_sub(1) else {
        return f64::NAN;
    };
    let at = share * last as f64;
    let below = at.floor() as usize;
    let [low, high] = [below, (below + 1).min(last)].map(|at| f64::from(sorted[at]));
    low + (at - at.floor()) * (high - low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_numpy() {
        let mut summary = Summary::new(1);
        for value in [3.0, 0.0, 1.0, 2.0] {
            summary.push(&[value]);
        }
        // numpy.quantile([0, 1, 2, 3], [0.01, 0.1, 0.5, 0.9, 0.99])
        let expected = [0.03, 0.3, 1.5, 2.7, 2.97];
        for (found, expected) in summary.quantiles().iter().zip(expected) {
            assert!((found[0] - expected).abs() < 1e-12, "{found:?}");
        }
    }

    #[test]
    fn a_summary_is_that_of_the_textbook() {
        let mut summary = Summary::new(2);
        for values in [[2.0, -1.0], [4.0, -1.0], [4.0, -1.0], [4.0, -1.0]] {
            summary.push(&values);
        }
        for values in [[5.0, -1.0], [5.0, -1.0], [7.0, -1.0], [9.0, -1.0]] {
            summary.push(&values);
        }
        assert_eq!(summary.min, [2.0, -1.0]);
        assert_eq!(summary.max, [9.0, -1.0]);
        assert_eq!(summary.mean, [5.0, -1.0]);
        let std = summary.std();
        assert!((std[0] - 2.0).abs() < 1e-12 && std[1] == 0.0, "{std:?}");
    }
}
