//! The time window of a fault.

use std::fmt;
use std::time::Duration;

/// The time window of a fault.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FaultTime {
    pub(crate) begin: FaultMoment,
    pub(crate) end: Option<FaultEnd>,
}

/// The start of a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FaultMoment {
    /// A time after the first power-up.
    Time(Duration),
    /// A number of complete packets received.
    Packet(u64),
    /// A number of statuses sent.
    Status(u64),
    /// Each time a client opens the port.
    Open,
}

/// The end of a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FaultEnd {
    At(FaultMoment),
    /// A time after its start.
    After(Duration),
}

impl FaultTime {
    /// From power-up on, without end.
    pub(crate) const ALWAYS: Self = Self {
        begin: FaultMoment::Time(Duration::ZERO),
        end: None,
    };

    /// Parses the text after `@`.
    pub(crate) fn parse(text: &str) -> Option<Self> {
        let Some((begin, end)) = text.split_once("..") else {
            return Some(Self {
                begin: FaultMoment::parse(text)?,
                end: None,
            });
        };
        let when = Self {
            begin: FaultMoment::parse(begin)?,
            end: Some(FaultEnd::parse(end)?),
        };
        when.has_length().then_some(when)
    }

    /// Whether it begins at each opening of the port.
    pub(crate) fn is_open(&self) -> bool {
        self.begin == FaultMoment::Open || self.end == Some(FaultEnd::At(FaultMoment::Open))
    }

    /// Shifts the window, so that times, packets and statuses count from the given ones.
    pub(crate) fn counted_from(&self, now: Duration, packets: u64, statuses: u64) -> Self {
        let later = |moment| match moment {
            FaultMoment::Time(at) => FaultMoment::Time(now + at),
            FaultMoment::Packet(number) => FaultMoment::Packet(packets + number),
            FaultMoment::Status(number) => FaultMoment::Status(statuses + number),
            FaultMoment::Open => FaultMoment::Open,
        };
        Self {
            begin: later(self.begin),
            end: self.end.map(|end| match end {
                FaultEnd::At(moment) => FaultEnd::At(later(moment)),
                after @ FaultEnd::After(_) => after,
            }),
        }
    }

    fn has_length(&self) -> bool {
        match (self.begin, self.end) {
            (_, Some(FaultEnd::After(lasts))) => !lasts.is_zero(),
            (FaultMoment::Time(begin), Some(FaultEnd::At(FaultMoment::Time(end)))) => begin < end,
            (FaultMoment::Packet(begin), Some(FaultEnd::At(FaultMoment::Packet(end))))
            | (FaultMoment::Status(begin), Some(FaultEnd::At(FaultMoment::Status(end)))) => {
                begin < end
            }
            _ => true,
        }
    }
}

impl fmt::Display for FaultTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.end {
            None if *self == Self::ALWAYS => Ok(()),
            None => write!(f, "@{}", self.begin),
            Some(FaultEnd::At(end)) => write!(f, "@{}..{end}", self.begin),
            Some(FaultEnd::After(lasts)) => write!(f, "@{}..+{}", self.begin, Time(lasts)),
        }
    }
}

impl FaultMoment {
    fn parse(text: &str) -> Option<Self> {
        if text == "open" {
            return Some(Self::Open);
        }
        if let Some(number) = text.strip_prefix("packet") {
            return ordinal(number).map(Self::Packet);
        }
        if let Some(number) = text.strip_prefix("status") {
            return ordinal(number).map(Self::Status);
        }
        time(text).map(Self::Time)
    }
}

impl fmt::Display for FaultMoment {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Time(at) => Time(*at).fmt(f),
            Self::Packet(number) => write!(f, "packet{number}"),
            Self::Status(number) => write!(f, "status{number}"),
            Self::Open => f.write_str("open"),
        }
    }
}

impl FaultEnd {
    fn parse(text: &str) -> Option<Self> {
        match text.strip_prefix('+') {
            Some(lasts) => time(lasts).map(Self::After),
            None => FaultMoment::parse(text).map(Self::At),
        }
    }
}

/// Formats a time as it is parsed: `50ms`, `12.5s`.
pub(crate) struct Time(pub(crate) Duration);

impl fmt::Display for Time {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let seconds = self.0.as_secs_f64();
        if self.0.is_zero() || seconds >= 1.0 {
            write!(f, "{seconds}s")
        } else {
            write!(f, "{}ms", seconds * 1e3)
        }
    }
}

/// Parses a time, to the microsecond.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "it is neither negative nor too large"
)]
pub(crate) fn time(text: &str) -> Option<Duration> {
    let (number, unit_us) = TIME_UNITS
        .iter()
        .find_map(|&(unit, us)| Some((text.strip_suffix(unit)?, us)))?;
    let us = (unsigned(number)? * unit_us).round();
    (us <= LONGEST_US).then(|| Duration::from_micros(us as u64))
}

/// Parses a plain decimal number: no sign, no exponent, no infinity.
pub(crate) fn unsigned(text: &str) -> Option<f64> {
    let plain = text
        .bytes()
        .all(|byte| byte.is_ascii_digit() || byte == b'.');
    text.parse().ok().filter(|it: &f64| plain && it.is_finite())
}

/// The first is 1.
fn ordinal(text: &str) -> Option<u64> {
    let plain = text.bytes().all(|byte| byte.is_ascii_digit());
    text.parse().ok().filter(|&it| plain && it > 0)
}

/// A unit that is a suffix of another follows it.
const TIME_UNITS: [(&str, f64); 4] = [("ms", 1e3), ("s", 1e6), ("min", 60e6), ("h", 3600e6)];
/// 1000 hours, in which floats still resolve a microsecond.
const LONGEST_US: f64 = 3600e9;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_in_four_units() {
        for (text, us) in [
            ("50ms", 50_000),
            ("12s", 12_000_000),
            ("1.5s", 1_500_000),
            ("0.1ms", 100),
            ("2min", 120_000_000),
            ("1h", 3_600_000_000),
            ("0s", 0),
        ] {
            assert_eq!(time(text), Some(Duration::from_micros(us)), "{text}");
        }
        for text in [
            "", "s", "12", "-1s", "+1s", "1e3s", "infs", "nans", ".s", "1001h", "12 s", "1.2.3s",
        ] {
            assert_eq!(time(text), None, "{text}");
        }
    }

    #[test]
    fn a_window_without_length_is_none() {
        for text in ["12s..12s", "12s..3s", "packet5..packet5", "open..+0s"] {
            assert_eq!(FaultTime::parse(text), None, "{text}");
        }
        for text in ["12s..13s", "packet5..packet6", "status3..2s", "2s..+1ms"] {
            assert!(FaultTime::parse(text).is_some(), "{text}");
        }
    }

    #[test]
    fn packets_and_statuses_are_counted_from_one() {
        for text in [
            "packet0",
            "packet",
            "packet-1",
            "packet+1",
            "status1.5",
            "pack1",
        ] {
            assert_eq!(FaultMoment::parse(text), None, "{text}");
        }
    }
}
