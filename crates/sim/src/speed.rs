//! The simulation speed of a served arm.

use std::fmt;
use std::str::FromStr;
use std::time::Duration;

/// The simulation speed of a served arm: a multiple of real time, or `max`, as fast as the client
/// keeps up.
///
/// ```
/// use dobot_sim::Speed;
///
/// let speed: Speed = "10".parse()?;
/// assert_eq!(speed.to_string(), "10");
/// # Ok::<(), dobot_sim::SpeedError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed(Option<f64>);

impl Speed {
    /// Real time.
    pub const REAL: Self = Self(Some(1.0));

    /// As fast as the client keeps up: time runs on to the next status, and stands still until the
    /// client has answered or a millisecond has passed. Without a client it stands still, unless a
    /// fault has closed the port.
    pub const MAX: Self = Self(None);

    pub(crate) const fn is_max(self) -> bool {
        self.0.is_none()
    }

    /// The multiple of real time; the largest allowed one for [`Speed::MAX`].
    #[must_use]
    pub fn times(self) -> f64 {
        self.0.unwrap_or(FASTEST)
    }

    /// Converts real time to the time of the arm.
    pub(crate) fn of_clock(self, time: Duration) -> Duration {
        time.mul_f64(self.times())
    }

    /// Converts time of the arm to real time.
    pub(crate) fn of_arm(self, time: Duration) -> Duration {
        time.div_f64(self.times())
    }
}

impl Default for Speed {
    fn default() -> Self {
        Self::REAL
    }
}

impl FromStr for Speed {
    type Err = SpeedError;

    fn from_str(text: &str) -> Result<Self, SpeedError> {
        if text == "max" {
            return Ok(Self::MAX);
        }
        match text.parse() {
            Ok(times) if (SLOWEST..=FASTEST).contains(&times) => Ok(Self(Some(times))),
            _ => Err(SpeedError {
                found: text.to_owned(),
            }),
        }
    }
}

impl fmt::Display for Speed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(times) => write!(f, "{times}"),
            None => f.write_str("max"),
        }
    }
}

/// The error returned when a text is not a speed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("speed is `{found}`; allowed is 0.1 to 1000 times real time, or max")]
pub struct SpeedError {
    /// The whole text.
    pub found: String,
}

const SLOWEST: f64 = 0.1;
const FASTEST: f64 = 1000.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_speed_is_written_as_it_is_read() {
        for text in ["1", "10", "0.1", "1000", "2.5", "max"] {
            assert_eq!(text.parse::<Speed>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn what_is_no_speed_says_what_is_allowed() {
        for text in ["", "0", "-1", "0.09", "1001", "nan", "inf", "fast", "MAX"] {
            let error = text.parse::<Speed>().unwrap_err().to_string();
            assert!(error.contains(&format!("`{text}`")), "{error}");
            assert!(error.contains("0.1 to 1000") && error.contains("max"));
        }
    }

    #[test]
    fn ten_times_as_fast_is_a_tenth_of_the_time() {
        let ten: Speed = "10".parse().unwrap();
        let second = Duration::from_secs(1);
        assert_eq!(ten.of_clock(second), Duration::from_secs(10));
        assert_eq!(ten.of_arm(second), Duration::from_millis(100));
    }
}
