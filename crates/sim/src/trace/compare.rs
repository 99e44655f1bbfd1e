//! Comparison of two traces.

use std::cmp::Ordering;

use super::{STATUS_FIELDS, TICK_FIELDS, TICK_MS, Trace, TracedStatus, TracedTick};

/// The deviation of a trace from the expected one.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// The number of statuses at the same times in both.
    pub statuses: usize,
    /// Times of missing statuses, in milliseconds.
    pub missing_ms: Vec<i64>,
    /// Times of unexpected statuses, in milliseconds.
    pub extra_ms: Vec<i64>,
    /// The largest deviation of each float of the statuses.
    pub floats: [Deviation; 10],
    /// The largest deviation of each value of the ticks: pulses, their sums, servos and pins.
    pub outputs: [Deviation; 11],
    /// Whether the number of ticks is as expected.
    pub same_ticks: bool,
    /// Whether the text printed on the other port is as expected.
    pub same_text: bool,
}

/// A field of a trace with its expected value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The field's name in the trace.
    pub field: &'static str,
    /// The time in milliseconds.
    pub t_ms: i64,
    /// The expected value.
    pub expected: f64,
    /// The actual value.
    pub found: f64,
}

impl Trace {
    /// Compares this trace with the expected one.
    #[must_use]
    pub fn compare(&self, expected: &Self) -> Comparison {
        let mut comparison = Comparison {
            statuses: 0,
            missing_ms: Vec::new(),
            extra_ms: Vec::new(),
            floats: std::array::from_fn(|index| Deviation::none(STATUS_FIELDS[index + 1])),
            outputs: std::array::from_fn(|index| Deviation::none(TICK_FIELDS[index + 1])),
            same_ticks: self.ticks.len() == expected.ticks.len(),
            same_text: self.other_port == expected.other_port,
        };
        for pair in pairs(expected, self) {
            match pair {
                Pair::Missing(t_ms) => comparison.missing_ms.push(t_ms),
                Pair::Extra(t_ms) => comparison.extra_ms.push(t_ms),
                Pair::Both(floats) => {
                    comparison.statuses += 1;
                    enlarge(&mut comparison.floats, &floats);
                }
            }
        }
        for outputs in outputs(expected, self) {
            enlarge(&mut comparison.outputs, &outputs);
        }
        comparison
    }
}

impl Deviation {
    const fn none(field: &'static str) -> Self {
        Self {
            field,
            t_ms: 0,
            expected: 0.0,
            found: 0.0,
        }
    }

    /// The deviation; infinite if only one of the values is NaN.
    #[must_use]
    pub fn size(&self) -> f64 {
        if self.expected == self.found || self.expected.is_nan() && self.found.is_nan() {
            return 0.0;
        }
        let size = (self.found - self.expected).abs();
        if size.is_nan() { f64::INFINITY } else { size }
    }
}

/// A time at which one trace or both have a status.
enum Pair {
    Missing(i64),
    Extra(i64),
    Both([Deviation; 10]),
}

/// The statuses of both traces by their times.
fn pairs<'a>(expected: &'a Trace, found: &'a Trace) -> impl Iterator<Item = Pair> + 'a {
    let mut expected = expected.statuses.iter().peekable();
    let mut found = found.statuses.iter().peekable();
    std::iter::from_fn(move || {
        let order = match (expected.peek(), found.peek()) {
            (None, None) => return None,
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (Some(a), Some(b)) => a.tick.cmp(&b.tick),
        };
        match order {
            Ordering::Less => expected.next().map(|status| Pair::Missing(status.t_ms())),
            Ordering::Greater => found.next().map(|status| Pair::Extra(status.t_ms())),
            Ordering::Equal => Some(Pair::Both(floats(expected.next()?, found.next()?))),
        }
    })
}

fn floats(expected: &TracedStatus, found: &TracedStatus) -> [Deviation; 10] {
    std::array::from_fn(|index| Deviation {
        field: STATUS_FIELDS[index + 1],
        t_ms: expected.t_ms(),
        expected: f64::from(expected.floats[index]),
        found: f64::from(found.floats[index]),
    })
}

fn outputs(expected: &Trace, found: &Trace) -> impl Iterator<Item = [Deviation; 11]> {
    let both = expected.ticks.iter().zip(&found.ticks);
    both.zip(0..).map(
        |((expected, found), tick): ((&TracedTick, &TracedTick), i64)| {
            let (expected, found) = (expected.values(), found.values());
            std::array::from_fn(|index| Deviation {
                field: TICK_FIELDS[index + 1],
                t_ms: tick * i64::from(TICK_MS),
                expected: whole(expected[index]),
                found: whole(found[index]),
            })
        },
    )
}

fn enlarge<const N: usize>(largest: &mut [Deviation; N], deviations: &[Deviation; N]) {
    for (largest, deviation) in largest.iter_mut().zip(deviations) {
        if deviation.size() > largest.size() {
            *largest = *deviation;
        }
    }
}

#[expect(
    clippy::cast_precision_loss,
    reason = "no motor makes more pulses than a float counts"
)]
const fn whole(value: i64) -> f64 {
    value as f64
}
