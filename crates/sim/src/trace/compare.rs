//! Two traces side by side.

use std::cmp::Ordering;
use std::fmt;

use super::{STATUS_FIELDS, TICK_FIELDS, TICK_MS, Trace, TracedStatus, TracedTick};

/// How far a trace is from the one that is expected.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// How many statuses both have, at the same times.
    pub statuses: usize,
    /// Times of statuses that were expected and are not there, in milliseconds.
    pub missing_ms: Vec<i64>,
    /// Times of statuses that are there and were not expected, in milliseconds.
    pub extra_ms: Vec<i64>,
    /// The largest deviation of each float of the statuses.
    pub floats: [Deviation; 10],
    /// The largest deviation of each value of the ticks: pulses, their sums, servos and pins.
    pub outputs: [Deviation; 11],
    /// Whether there are as many ticks as expected.
    pub same_ticks: bool,
    /// Whether the same was printed on the other port.
    pub same_text: bool,
}

/// A field of a trace beside what was expected there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// The field's name in the trace.
    pub field: &'static str,
    /// When, in milliseconds.
    pub t_ms: i64,
    /// What was expected.
    pub expected: f64,
    /// What was found.
    pub found: f64,
}

/// How far a trace may be from the one that is expected. Servos, pins and text have to be the
/// same, and so has NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// For the floats of the statuses, in millimetres and degrees.
    pub float: f64,
    /// For the sums of motor pulses.
    pub sum: f64,
}

/// The first difference between a trace and the one that is expected.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Difference {
    /// A status is not there.
    Missing {
        /// When it was expected, in milliseconds.
        t_ms: i64,
    },
    /// A status was not expected.
    Extra {
        /// When it was sent, in milliseconds.
        t_ms: i64,
    },
    /// A field is too far off.
    Field(Deviation),
    /// There are more or fewer ticks.
    Ticks {
        /// How many were expected.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// Something else was printed on the other port.
    Text {
        /// What was expected.
        expected: String,
        /// What was found.
        found: String,
    },
}

impl Trace {
    /// Measures how far this is from the trace that is expected.
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

    /// The first difference from the trace that is expected, as far as it is not tolerated.
    #[must_use]
    pub fn first_difference(&self, expected: &Self, tolerance: &Tolerance) -> Option<Difference> {
        let status = pairs(expected, self).find_map(|pair| match pair {
            Pair::Missing(t_ms) => Some((t_ms, Difference::Missing { t_ms })),
            Pair::Extra(t_ms) => Some((t_ms, Difference::Extra { t_ms })),
            Pair::Both(floats) => tolerance.beyond(&floats),
        });
        let output = outputs(expected, self).find_map(|it| tolerance.beyond(&it));
        let earliest = status.into_iter().chain(output).min_by_key(|it| it.0);
        earliest.map(|it| it.1).or_else(|| self.other(expected))
    }

    fn other(&self, expected: &Self) -> Option<Difference> {
        if self.ticks.len() != expected.ticks.len() {
            return Some(Difference::Ticks {
                expected: expected.ticks.len(),
                found: self.ticks.len(),
            });
        }
        let text = |it: &Self| String::from_utf8_lossy(&it.other_port).into_owned();
        (self.other_port != expected.other_port).then(|| Difference::Text {
            expected: text(expected),
            found: text(self),
        })
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

    /// How far off it is; infinitely if only one of them is NaN.
    #[must_use]
    pub fn size(&self) -> f64 {
        if self.expected == self.found || self.expected.is_nan() && self.found.is_nan() {
            return 0.0;
        }
        let size = (self.found - self.expected).abs();
        if size.is_nan() { f64::INFINITY } else { size }
    }
}

impl Tolerance {
    /// The first field that is too far off, and when it is.
    fn beyond(&self, deviations: &[Deviation]) -> Option<(i64, Difference)> {
        let beyond = deviations.iter().find(|it| it.size() > self.of(it.field));
        beyond.map(|it| (it.t_ms, Difference::Field(*it)))
    }

    fn of(&self, field: &str) -> f64 {
        match field {
            "p_base" | "p_rear" | "p_fore" => 2.0 * self.sum,
            "sum_base" | "sum_rear" | "sum_fore" => self.sum,
            _ if STATUS_FIELDS.contains(&field) => self.float,
            _ => 0.0,
        }
    }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { t_ms } => write!(f, "at {t_ms} ms a status is missing"),
            Self::Extra { t_ms } => write!(f, "at {t_ms} ms a status was not expected"),
            Self::Field(it) => write!(
                f,
                "at {} ms {} is {}; expected {}, off by {:.6}",
                it.t_ms,
                it.field,
                it.found,
                it.expected,
                it.size()
            ),
            Self::Ticks { expected, found } => {
                write!(f, "there are {found} ticks; expected {expected}")
            }
            Self::Text { expected, found } => {
                write!(f, "the other port printed {found:?}; expected {expected:?}")
            }
        }
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
            Ordering::Less => expected.next().map(|it| Pair::Missing(it.t_ms())),
            Ordering::Greater => found.next().map(|it| Pair::Extra(it.t_ms())),
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
