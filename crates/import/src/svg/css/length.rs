//! Lengths, numbers and angles, with the arithmetic of `calc()`.

use cssparser::{Parser, Token};

use crate::limits::MAX_NUMBER;

/// A length, or a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Length {
    Number(f32),
    /// Pixels, and units of a known number of pixels.
    Px(f32),
    /// A multiple of a unit that the library resolves: em, ex or %.
    Relative(f32, &'static str),
}

impl Length {
    /// The length in the words of the library; `None` if it is too large, or below 0 where that is
    /// not allowed. In styles of SVG elements, browsers read lengths without a unit.
    pub(super) fn text(self, below_zero: bool) -> Option<String> {
        let (Self::Number(value) | Self::Px(value) | Self::Relative(value, _)) = self;
        let is_allowed = f64::from(value).abs() <= MAX_NUMBER && (below_zero || value >= 0.0);
        is_allowed.then(|| match self {
            Self::Number(number) => number.to_string(),
            Self::Px(px) => format!("{px}px"),
            Self::Relative(number, unit) => format!("{number}{unit}"),
        })
    }

    fn map(self, by: impl Fn(f32) -> f32) -> Self {
        match self {
            Self::Number(value) => Self::Number(by(value)),
            Self::Px(value) => Self::Px(by(value)),
            Self::Relative(value, unit) => Self::Relative(by(value), unit),
        }
    }

    /// The sum of two lengths of one kind.
    fn plus(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Number(a), Self::Number(b)) => Some(Self::Number(a + b)),
            (Self::Px(a), Self::Px(b)) => Some(Self::Px(a + b)),
            (Self::Relative(a, unit), Self::Relative(b, other)) if unit == other => {
                Some(Self::Relative(a + b, unit))
            }
            _ => None,
        }
    }

    fn times(self, other: Self) -> Option<Self> {
        match (self, other) {
            (Self::Number(factor), length) | (length, Self::Number(factor)) => {
                Some(length.map(|value| value * factor))
            }
            _ => None,
        }
    }
}

/// Parses a length or a number; `None` if it is invalid, or depends on the window.
pub(super) fn length(input: &mut Parser<'_>) -> Option<Length> {
    Some(match input.next().ok()?.clone() {
        Token::Number { value, .. } => Length::Number(value),
        Token::Percentage { unit_value, .. } => Length::Relative(100.0 * unit_value, "%"),
        Token::Dimension { value, unit, .. } => dimension(value, &unit.to_ascii_lowercase())?,
        Token::ParenthesisBlock => nested(input, sum)?,
        Token::Function(name) => {
            let name = name.to_ascii_lowercase();
            match name.as_str() {
                "calc" => nested(input, sum)?,
                "min" | "max" | "clamp" => nested(input, |inner| chosen(&name, inner))?,
                _ => return None,
            }
        }
        _ => return None,
    })
}

/// Parses a number without a unit.
pub(super) fn number(input: &mut Parser<'_>) -> Option<f32> {
    match length(input)? {
        Length::Number(number) => Some(number),
        _ => None,
    }
}

/// Parses an angle.
pub(super) fn angle_deg(input: &mut Parser<'_>) -> Option<f32> {
    match input.next().ok()?.clone() {
        Token::Number { value: 0.0, .. } => Some(0.0),
        Token::Dimension { value, unit, .. } => match unit.to_ascii_lowercase().as_str() {
            "deg" => Some(value),
            "grad" => Some(value * 0.9),
            "rad" => Some(value.to_degrees()),
            "turn" => Some(value * 360.0),
            _ => None,
        },
        _ => None,
    }
}

fn dimension(value: f32, unit: &str) -> Option<Length> {
    let px = match unit {
        "px" => 1.0,
        "pt" => 96.0 / 72.0,
        "pc" | "rem" => 16.0,
        "in" => 96.0,
        "cm" => 96.0 / 2.54,
        "mm" => 96.0 / 25.4,
        "q" => 96.0 / 101.6,
        "em" => return Some(Length::Relative(value, "em")),
        "ex" => return Some(Length::Relative(value, "ex")),
        "ch" => return Some(Length::Relative(0.5 * value, "em")),
        _ => return None,
    };
    Some(Length::Px(px * value))
}

fn nested(
    input: &mut Parser<'_>,
    parse: impl FnOnce(&mut Parser<'_>) -> Option<Length>,
) -> Option<Length> {
    let length = input.parse_nested_block(|inner| {
        let length = parse(inner).filter(|_| inner.is_exhausted());
        length.ok_or(inner.new_error_for_next_token::<()>())
    });
    length.ok()
}

fn sum(inner: &mut Parser<'_>) -> Option<Length> {
    let mut sum = product(inner)?;
    while let Ok(sign) = inner.try_parse(|inner| sign(inner, ['+', '-'])) {
        let next = product(inner)?;
        sum = sum.plus(if sign == '+' {
            next
        } else {
            next.map(|value| -value)
        })?;
    }
    Some(sum)
}

fn product(inner: &mut Parser<'_>) -> Option<Length> {
    let mut product = length(inner)?;
    while let Ok(sign) = inner.try_parse(|inner| sign(inner, ['*', '/'])) {
        let next = length(inner)?;
        product = match (sign, next) {
            ('*', next) => product.times(next)?,
            (_, Length::Number(by)) if by != 0.0 => product.map(|value| value / by),
            _ => return None,
        };
    }
    Some(product)
}

fn sign(inner: &mut Parser<'_>, signs: [char; 2]) -> Result<char, ()> {
    match inner.next() {
        Ok(Token::Delim(sign)) if signs.contains(sign) => Ok(*sign),
        _ => Err(()),
    }
}

/// The value of `min()`, `max()` or `clamp()`.
fn chosen(name: &str, inner: &mut Parser<'_>) -> Option<Length> {
    let mut lengths = vec![sum(inner)?];
    while inner.try_parse(Parser::expect_comma).is_ok() {
        lengths.push(sum(inner)?);
    }
    let least = |a: Length, b: Length| {
        let difference = a.plus(b.map(|value| -value))?;
        let (Length::Number(value) | Length::Px(value) | Length::Relative(value, _)) = difference;
        Some(if value <= 0.0 { (a, b) } else { (b, a) })
    };
    let first = lengths[0];
    match (name, &lengths[..]) {
        ("clamp", &[low, value, high]) => least(low, least(value, high)?.0).map(|pair| pair.1),
        ("min", all) => all
            .iter()
            .try_fold(first, |a, b| least(a, *b).map(|pair| pair.0)),
        ("max", all) => all
            .iter()
            .try_fold(first, |a, b| least(a, *b).map(|pair| pair.1)),
        _ => None,
    }
}
