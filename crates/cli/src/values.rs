//! Value parsers. Each error states what is allowed, with its unit.

use std::fmt;
use std::net::SocketAddr;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::Duration;

/// Returns a parser of finite numbers in a range.
pub(crate) fn number<T>(
    range: RangeInclusive<T>,
    unit: &'static str,
) -> impl Fn(&str) -> Result<T, String> + Clone
where
    T: FromStr + PartialOrd + Clone + fmt::Display,
{
    move |text: &str| {
        let value = text.parse().ok().filter(|value| range.contains(value));
        value.ok_or_else(|| format!("expected {} to {} {unit}", range.start(), range.end()))
    }
}

/// Returns a parser of durations in seconds.
pub(crate) fn seconds(
    range: RangeInclusive<f64>,
) -> impl Fn(&str) -> Result<Duration, String> + Clone {
    let number = number(range, "seconds");
    move |text: &str| number(text).map(Duration::from_secs_f64)
}

/// Returns a parser of whole numbers from `least` on.
pub(crate) fn whole_from(least: u64) -> impl Fn(&str) -> Result<u64, String> + Clone {
    move |text: &str| {
        let value = text.parse().ok().filter(|value| *value >= least);
        value.ok_or_else(|| format!("expected a whole number, {least} or more"))
    }
}

/// Parses any finite number, such as a coordinate.
pub(crate) fn finite(text: &str) -> Result<f32, &'static str> {
    let value = text.parse().ok().filter(|value: &f32| value.is_finite());
    value.ok_or("expected a finite number")
}

/// Parses a positive number, such as a speed.
pub(crate) fn positive(text: &str) -> Result<f32, &'static str> {
    let value = finite(text).ok().filter(|value| *value > 0.0);
    value.ok_or("expected a number above 0")
}

/// Parses a number that may be 0.
pub(crate) fn non_negative(text: &str) -> Result<f32, &'static str> {
    let value = finite(text).ok().filter(|value| *value >= 0.0);
    value.ok_or("expected a number, 0 or more")
}

/// Parses a switch.
pub(crate) fn on_off(text: &str) -> Result<bool, &'static str> {
    match text {
        "on" => Ok(true),
        "off" => Ok(false),
        _ => Err("expected on or off"),
    }
}

/// Parses a percentage above 0.
pub(crate) fn percent(text: &str) -> Result<f32, &'static str> {
    let value = positive(text).ok().filter(|value| *value <= 100.0);
    value.ok_or("expected a number above 0, up to 100 percent")
}

/// Parses how long the laser is armed.
pub(crate) fn laser_seconds(text: &str) -> Result<Duration, String> {
    seconds(LASER_S)(text)
}

/// Parses an address to listen on.
pub(crate) fn socket_address(text: &str) -> Result<SocketAddr, &'static str> {
    let address = text.parse();
    address.map_err(|_| "expected HOST:PORT with a numeric host, as in 127.0.0.1:5555")
}

/// Parses the name of an SVG file.
pub(crate) fn svg_file(text: &str) -> Result<PathBuf, &'static str> {
    match extension(text).as_deref() {
        Some("svg") => Ok(text.into()),
        _ => Err("expected a file name that ends in .svg"),
    }
}

/// Returns the extension of a file name, in lower case.
pub(crate) fn extension(file: &str) -> Option<String> {
    let extension = Path::new(file).extension()?;
    extension.to_str().map(str::to_ascii_lowercase)
}

/// How long the laser may be armed, in seconds.
const LASER_S: RangeInclusive<f64> = 1.0..=3600.0;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_out_of_range_is_refused_with_range_and_unit() {
        let parse = number(-90.0..=90.0_f32, "degrees");
        assert_eq!(parse("12.5"), Ok(12.5));
        for text in ["91", "nan", "inf", "", "ten"] {
            assert_eq!(parse(text), Err("expected -90 to 90 degrees".to_owned()));
        }
        let seconds = seconds(0.02..=60.0);
        assert_eq!(seconds("0.5"), Ok(Duration::from_millis(500)));
        assert_eq!(seconds("-1"), Err("expected 0.02 to 60 seconds".to_owned()));
        assert_eq!(
            whole_from(1)("0"),
            Err("expected a whole number, 1 or more".to_owned())
        );
    }

    #[test]
    fn numbers_that_are_not_finite_are_refused() {
        for text in ["nan", "inf", "-inf", "1e99", "x"] {
            assert!(finite(text).is_err() && positive(text).is_err(), "{text}");
        }
        assert!(positive("0").is_err() && non_negative("0").is_ok());
    }
}
