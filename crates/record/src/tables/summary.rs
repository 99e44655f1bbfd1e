//! Minimum, maximum, mean and standard deviation of a stream of numbers.

/// The summary of a feature in a dataset, one number for each of its values.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Summary {
    pub(crate) min: Vec<f64>,
    pub(crate) max: Vec<f64>,
    pub(crate) mean: Vec<f64>,
    /// The sum of squared deviations from the mean (Welford).
    squares: Vec<f64>,
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
        }
    }

    /// The standard deviation of all numbers.
    pub(crate) fn std(&self) -> Vec<f64> {
        let each = self.squares.iter();
        each.map(|item| (item / f64::from(self.count)).sqrt())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
