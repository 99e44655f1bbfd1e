//! The distribution of measured values.

use std::fmt;
use std::time::Duration;

/// Measured values, summarized by median and maximum.
#[derive(Clone, Debug, Default)]
pub(crate) struct Spread(Vec<f64>);

impl Spread {
    /// Takes a value.
    pub(crate) fn add(&mut self, value: f64) {
        self.0.push(value);
    }

    /// Takes the time from one moment to another, in seconds.
    pub(crate) fn add_time(&mut self, from: Duration, to: Duration) {
        self.add(to.saturating_sub(from).as_secs_f64());
    }

    /// The greatest value; 0 where there is none.
    pub(crate) fn most(&self) -> f64 {
        self.0.iter().copied().fold(0.0, f64::max)
    }

    /// Returns the number of values above this one.
    pub(crate) fn above(&self, most: f64) -> usize {
        self.0.iter().filter(|value| **value > most).count()
    }

    /// Returns a percentile.
    pub(crate) fn percent(&self, percent: usize) -> f64 {
        let mut sorted = self.0.clone();
        sorted.sort_by(f64::total_cmp);
        let last = sorted.len().saturating_sub(1);
        sorted.get(last * percent / 100).copied().unwrap_or(0.0)
    }
}

/// As cells of a table: middle, 99 of 100, most.
impl fmt::Display for Spread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [middle, nearly, most] = [50, 99, 100].map(|percent| self.percent(percent));
        write!(f, "{middle:.2} | {nearly:.2} | {most:.2}")
    }
}
