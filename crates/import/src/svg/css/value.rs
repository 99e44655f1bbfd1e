//! Values of properties, rewritten in the words of the library.
//!
//! ```text
//!   STROKE: CurrentColor            currentColor
//!   opacity: 50%                    0.5
//!   stroke-width: calc(1px + 1mm)   4.779528px
//!   transform: rotate(0.25turn)     rotate(90)
//! ```

use std::borrow::Cow;
use std::str::FromStr;

use cssparser::{Parser, Token};

use super::super::check::check_path;
use super::color::color;
use super::family::quoted_families;
use super::length::{Length, angle_deg, length, number};
use super::property::Grammar;
use crate::limits::MAX_NUMBER;

/// A value of a property, without blanks around it; `None` if it is invalid.
pub(super) fn value(grammar: Grammar, text: &str) -> Option<Cow<'_, str>> {
    use Grammar as G;
    if is_plain(grammar, text) {
        return Some(text.into());
    }
    let mut input = Parser::new(text);
    let input = &mut input;
    let value = match grammar {
        G::Paint => paint(input)?,
        G::Color => color(input)?,
        G::Share => share(input)?.into(),
        G::Number => Some(number(input)?)
            .filter(|number| *number >= 0.0)?
            .to_string()
            .into(),
        G::Length { below_zero } => length(input)?.text(below_zero)?.into(),
        G::Dashes => dashes(input)?.into(),
        G::Words(words) => one_of(input, words)?.into(),
        G::LengthOr(words) => match one_of(input, words) {
            Some(word) => word.into(),
            None => length(input)?.text(true)?.into(),
        },
        G::Transform => transforms(input)?.into(),
        G::Moves => moves(input)?.into(),
        G::Turn => turn(input)?.into(),
        G::Factors => factors(input)?.into(),
        G::Path => path(input)?.into(),
        G::Fonts => return Some(quoted_families(text).map_or(text.into(), Cow::Owned)),
        G::Any => return any(text),
    };
    input.is_exhausted().then(|| unchanged(text, value))
}

/// Whether a value is a number, or a length with a unit, that the library reads as it is: nearly all
/// are.
fn is_plain(grammar: Grammar, text: &str) -> bool {
    use Grammar as G;
    let number = || text.parse().ok().filter(|number: &f64| number.is_finite());
    let length = || {
        let length = svgtypes::Length::from_str(text).ok()?;
        (length.number.abs() <= MAX_NUMBER).then_some(length)
    };
    match grammar {
        G::Share => number().is_some_and(|number| (0.0..=1.0).contains(&number)),
        G::Number => number().is_some_and(|number| number >= 0.0),
        G::Length { below_zero } => {
            length().is_some_and(|length| below_zero || length.number >= 0.0)
        }
        G::LengthOr(_) => length().is_some(),
        _ => false,
    }
}

/// The text itself if the value is the same.
fn unchanged<'t>(text: &'t str, value: Cow<'t, str>) -> Cow<'t, str> {
    if value == text {
        Cow::Borrowed(text)
    } else {
        value
    }
}

/// A value that the library reads, its words in lower case.
fn any(text: &str) -> Option<Cow<'_, str>> {
    let is_words = text
        .chars()
        .all(|sign| sign.is_ascii_alphanumeric() || " -%.,".contains(sign));
    if is_words && text.contains(|sign: char| sign.is_ascii_uppercase()) {
        let is_mixed = text.eq_ignore_ascii_case("linearrgb") || text.eq_ignore_ascii_case("srgb");
        return Some(if is_mixed {
            text.into()
        } else {
            text.to_ascii_lowercase().into()
        });
    }
    (!text.is_empty()).then_some(Cow::Borrowed(text))
}

/// The word at the start, in the case of the list.
pub(super) fn one_of(input: &mut Parser<'_>, words: &[&'static str]) -> Option<&'static str> {
    let word = input.try_parse(|input| {
        let word = input.expect_ident()?;
        let known = words.iter().find(|known| known.eq_ignore_ascii_case(word));
        known
            .copied()
            .ok_or(cssparser::BasicParseError::unexpected_token())
    });
    word.ok()
}

fn paint<'i>(input: &mut Parser<'i>) -> Option<Cow<'i, str>> {
    let words = ["none", "context-fill", "context-stroke"];
    if let Some(word) = one_of(input, &words) {
        return Some(word.into());
    }
    let Ok(link) = input.try_parse(Parser::expect_url) else {
        return color(input);
    };
    let link = format!("url({link})");
    if input.is_exhausted() {
        return Some(link.into());
    }
    let fallback = match one_of(input, &["none"]) {
        Some(word) => word.into(),
        None => color(input)?,
    };
    Some(format!("{link} {fallback}").into())
}

fn share(input: &mut Parser<'_>) -> Option<String> {
    let percentage = input.try_parse(Parser::expect_percentage);
    let share = percentage.ok().or_else(|| number(input))?;
    Some(share.clamp(0.0, 1.0).to_string())
}

fn dashes(input: &mut Parser<'_>) -> Option<String> {
    if let Some(none) = one_of(input, &["none"]) {
        return Some(none.to_owned());
    }
    let mut lengths = vec![length(input)?.text(false)?];
    while !input.is_exhausted() {
        let _comma = input.try_parse(Parser::expect_comma);
        lengths.push(length(input)?.text(false)?);
    }
    Some(lengths.join(" "))
}

/// The data of `path("...")`, with the rule of its filling left out. As a whole it is valid or not.
fn path(input: &mut Parser<'_>) -> Option<String> {
    if let Some(none) = one_of(input, &["none"]) {
        return Some(none.to_owned());
    }
    input.expect_function_matching("path").ok()?;
    let path = input.parse_nested_block(|inner| {
        let _rule = inner.try_parse(|inner| {
            inner.expect_ident()?;
            inner.expect_comma()
        });
        let path = inner.expect_string_cloned()?;
        inner.expect_exhausted()?;
        Ok::<_, cssparser::ParseError<()>>(path.to_string())
    });
    path.ok().filter(|path| check_path(path).is_ok())
}

/// Transforms in the form of the attribute.
fn transforms(input: &mut Parser<'_>) -> Option<String> {
    if let Some(none) = one_of(input, &["none"]) {
        return Some(none.to_owned());
    }
    let mut transforms = Vec::new();
    while !input.is_exhausted() {
        let name = input.expect_function().ok()?.to_ascii_lowercase();
        let transform = input.parse_nested_block(|inner| {
            let transform = transform(&name, inner).filter(|_| inner.is_exhausted());
            transform.ok_or(inner.new_error_for_next_token::<()>())
        });
        transforms.push(transform.ok()?);
    }
    (!transforms.is_empty()).then(|| transforms.join(" "))
}

fn transform(name: &str, inner: &mut Parser<'_>) -> Option<String> {
    Some(match name {
        "translate" => format!("translate({})", pair(inner, px)?),
        "translatex" => format!("translate({})", px(inner)?),
        "translatey" => format!("translate(0 {})", px(inner)?),
        "scale" => format!("scale({})", pair(inner, factor)?),
        "scalex" => format!("scale({} 1)", factor(inner)?),
        "scaley" => format!("scale(1 {})", factor(inner)?),
        "rotate" | "rotatez" => format!("rotate({})", angle_deg(inner)?),
        "skewx" => format!("skewX({})", angle_deg(inner)?),
        "skewy" => format!("skewY({})", angle_deg(inner)?),
        "skew" => {
            let first = angle_deg(inner)?;
            let second = inner.try_parse(Parser::expect_comma).ok();
            let second = second.map_or(Some(0.0), |()| angle_deg(inner))?;
            let [first, second] = [first, second].map(|angle| angle.to_radians().tan());
            format!("matrix(1 {second} {first} 1 0 0)")
        }
        "matrix" => {
            let numbers = inner.parse_comma_separated(|inner| {
                number(inner).ok_or(inner.new_error_for_next_token::<()>())
            });
            let numbers: Vec<String> = numbers.ok()?.iter().map(ToString::to_string).collect();
            (numbers.len() == 6).then(|| format!("matrix({})", numbers.join(" ")))?
        }
        _ => return None,
    })
}

/// One or two values with a comma between them, in the words of the attribute.
fn pair<T: ToString>(
    inner: &mut Parser<'_>,
    value: impl Fn(&mut Parser<'_>) -> Option<T>,
) -> Option<String> {
    let first = value(inner)?.to_string();
    if inner.try_parse(Parser::expect_comma).is_err() {
        return Some(first);
    }
    Some(format!("{first} {}", value(inner)?.to_string()))
}

fn moves(input: &mut Parser<'_>) -> Option<String> {
    if one_of(input, &["none"]).is_some() {
        return Some("none".to_owned());
    }
    let x = px(input)?;
    let y = if input.is_exhausted() {
        0.0
    } else {
        px(input)?
    };
    Some(format!("translate({x} {y})"))
}

fn turn(input: &mut Parser<'_>) -> Option<String> {
    if one_of(input, &["none"]).is_some() {
        return Some("none".to_owned());
    }
    Some(format!("rotate({})", angle_deg(input)?))
}

fn factors(input: &mut Parser<'_>) -> Option<String> {
    if one_of(input, &["none"]).is_some() {
        return Some("none".to_owned());
    }
    let x = factor(input)?;
    let y = if input.is_exhausted() {
        x
    } else {
        factor(input)?
    };
    Some(format!("scale({x} {y})"))
}

fn px(input: &mut Parser<'_>) -> Option<f32> {
    match length(input)? {
        Length::Px(px) => Some(px),
        Length::Number(0.0) => Some(0.0),
        _ => None,
    }
}

fn factor(input: &mut Parser<'_>) -> Option<f32> {
    let percentage = input.try_parse(Parser::expect_percentage);
    percentage.ok().or_else(|| number(input))
}

/// The link of a shorthand such as `mask`, or `none`.
pub(super) fn link(text: &str) -> Option<String> {
    let mut input = Parser::new(text);
    loop {
        if let Ok(link) = input.try_parse(Parser::expect_url) {
            return Some(format!("url({link})"));
        }
        match input.next().ok()? {
            Token::Ident(name) if name.eq_ignore_ascii_case("none") => return Some("none".into()),
            _ => {}
        }
    }
}
