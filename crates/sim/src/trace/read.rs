//! Parsing of traces.

use dobot_controller::Outputs;
use thiserror::Error;

use super::{STATUS_FIELDS, TICK_FIELDS, TICK_MS, Trace, TracedStatus, TracedTick};

/// The error returned when a text is not a trace.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TraceError {
    /// The first line names other fields.
    #[error("line 1 is `{found}`; allowed is `{allowed}`")]
    Header {
        /// The line.
        found: String,
        /// The fields of such a trace.
        allowed: String,
    },
    /// A row has other fields than the first line names.
    #[error("line {line} has {found} fields; allowed are {allowed}")]
    Count {
        /// The line's number; the first is 1.
        line: usize,
        /// The number of fields.
        found: usize,
        /// The allowed number.
        allowed: usize,
    },
    /// A field does not hold a valid number.
    #[error("line {line}, field {field} is `{found}`; allowed is {allowed}")]
    Field {
        /// The line's number; the first is 1.
        line: usize,
        /// The field's name.
        field: &'static str,
        /// The text of the field.
        found: String,
        /// The allowed text.
        allowed: &'static str,
    },
}

impl Trace {
    /// Parses a trace: its statuses and ticks as CSV, and the text printed on the other port.
    ///
    /// # Errors
    ///
    /// Returns a [`TraceError`] for the first invalid line.
    pub fn parse(statuses: &str, ticks: &str, other_port: &[u8]) -> Result<Self, TraceError> {
        Ok(Self {
            statuses: rows(statuses, STATUS_FIELDS, status)?,
            ticks: rows(ticks, TICK_FIELDS, tick)?,
            other_port: other_port.to_vec(),
        })
    }
}

fn status(row: &CsvRow<'_, 11>) -> Result<TracedStatus, TraceError> {
    let mut floats = [0.0; 10];
    for (index, float) in floats.iter_mut().enumerate() {
        *float = row.field(index + 1, "a number or `nan`")?;
    }
    Ok(TracedStatus {
        tick: row.tick()?,
        floats,
    })
}

fn tick(row: &CsvRow<'_, 12>) -> Result<TracedTick, TraceError> {
    row.tick()?;
    let whole = "a whole number";
    Ok(TracedTick {
        outputs: Outputs {
            pulses: [
                row.field(1, whole)?,
                row.field(2, whole)?,
                row.field(3, whole)?,
            ],
            head_servo: row.field(7, whole)?,
            gripper_servo: row.field(8, whole)?,
            pump: row.pin(9)?,
            valve: row.pin(10)?,
            laser: row.pin(11)?,
        },
        sums: [
            row.field(4, whole)?,
            row.field(5, whole)?,
            row.field(6, whole)?,
        ],
    })
}

/// A line of CSV.
struct CsvRow<'a, const N: usize> {
    line: usize,
    names: [&'static str; N],
    words: [&'a str; N],
}

impl<'a, const N: usize> CsvRow<'a, N> {
    fn of(text: &'a str, line: usize, names: [&'static str; N]) -> Result<Self, TraceError> {
        let words: Vec<_> = text.split(',').collect();
        let count = |words: Vec<_>| TraceError::Count {
            line,
            found: words.len(),
            allowed: N,
        };
        let words = words.try_into().map_err(count)?;
        Ok(Self { line, names, words })
    }

    fn tick(&self) -> Result<u32, TraceError> {
        let allowed = "a multiple of 20 ms";
        let t_ms: u32 = self.field(0, allowed)?;
        if t_ms.is_multiple_of(TICK_MS) {
            Ok(t_ms / TICK_MS)
        } else {
            Err(self.wrong(0, allowed))
        }
    }

    fn field<T: std::str::FromStr>(
        &self,
        index: usize,
        allowed: &'static str,
    ) -> Result<T, TraceError> {
        self.words[index]
            .parse()
            .map_err(|_| self.wrong(index, allowed))
    }

    fn pin(&self, index: usize) -> Result<bool, TraceError> {
        match self.words[index] {
            "0" => Ok(false),
            "1" => Ok(true),
            _ => Err(self.wrong(index, "0 or 1")),
        }
    }

    fn wrong(&self, index: usize, allowed: &'static str) -> TraceError {
        TraceError::Field {
            line: self.line,
            field: self.names[index],
            found: self.words[index].to_owned(),
            allowed,
        }
    }
}

fn rows<T, const N: usize>(
    text: &str,
    names: [&'static str; N],
    read: impl Fn(&CsvRow<'_, N>) -> Result<T, TraceError>,
) -> Result<Vec<T>, TraceError> {
    let mut lines = text.lines();
    let header = lines.next().unwrap_or_default();
    if header != names.join(",") {
        return Err(TraceError::Header {
            found: header.to_owned(),
            allowed: names.join(","),
        });
    }
    lines
        .zip(2..)
        .map(|(text, line)| read(&CsvRow::of(text, line, names)?))
        .collect()
}
