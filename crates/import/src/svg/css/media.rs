//! The conditions of `@media` and `@supports`: a light screen of 1280 by 720 pixels.

use cssparser::{Parser, ToCss, Token};

use super::length::{Length, length};
use super::property::Property;
use super::variables::has_variables;

/// Whether a list of media queries holds; an empty one does.
pub(super) fn is_shown(input: &mut Parser<'_>) -> bool {
    if input.is_exhausted() {
        return true;
    }
    let queries = input.parse_comma_separated(|input| {
        let holds = query(input).filter(|_| input.is_exhausted());
        while input.next().is_ok() {}
        // An invalid query is never true.
        Ok::<_, cssparser::ParseError<()>>(holds.unwrap_or(false))
    });
    queries.is_ok_and(|queries| queries.contains(&true))
}

fn query(input: &mut Parser<'_>) -> Option<bool> {
    let word = input.try_parse(|input| {
        let word = input.expect_ident_cloned()?;
        Ok::<_, cssparser::BasicParseError>(word.to_ascii_lowercase())
    });
    let Ok(word) = word else {
        return condition(input, &feature);
    };
    if word == "not" && !input.is_exhausted() {
        let medium = input.try_parse(Parser::expect_ident_cloned);
        return Some(match medium {
            Ok(medium) => !of_medium(&medium, input)?,
            Err(_) => !one(input, &feature)?,
        });
    }
    if word == "only" {
        let medium = input.expect_ident_cloned().ok()?;
        return of_medium(&medium, input);
    }
    of_medium(&word, input)
}

fn of_medium(medium: &str, input: &mut Parser<'_>) -> Option<bool> {
    let is_medium = ["all", "screen"]
        .iter()
        .any(|known| medium.eq_ignore_ascii_case(known));
    let mut holds = is_medium;
    while input
        .try_parse(|input| input.expect_ident_matching("and"))
        .is_ok()
    {
        holds &= one(input, &feature)?;
    }
    Some(holds)
}

/// Conditions joined by `and` or `or`, or one after `not`.
fn condition(
    input: &mut Parser<'_>,
    test: &dyn Fn(&mut Parser<'_>) -> Option<bool>,
) -> Option<bool> {
    let mut holds = one(input, test)?;
    loop {
        if input
            .try_parse(|input| input.expect_ident_matching("and"))
            .is_ok()
        {
            holds &= one(input, test)?;
        } else if input
            .try_parse(|input| input.expect_ident_matching("or"))
            .is_ok()
        {
            holds |= one(input, test)?;
        } else {
            return Some(holds);
        }
    }
}

fn one(input: &mut Parser<'_>, test: &dyn Fn(&mut Parser<'_>) -> Option<bool>) -> Option<bool> {
    if input
        .try_parse(|input| input.expect_ident_matching("not"))
        .is_ok()
    {
        return Some(!one(input, test)?);
    }
    let function = input.try_parse(|input| input.expect_function().cloned());
    if let Ok(name) = function {
        // Of `selector()` and similar, all is supported.
        let is_known = name.eq_ignore_ascii_case("selector");
        let _rest = input.parse_nested_block(|inner| {
            while inner.next().is_ok() {}
            Ok::<_, cssparser::ParseError<()>>(())
        });
        return Some(is_known);
    }
    input.expect_parenthesis_block().ok()?;
    let holds = input.parse_nested_block(|inner| {
        let is_nested = |inner: &mut Parser<'_>| {
            let holds = condition(inner, test).filter(|_| inner.is_exhausted());
            holds.ok_or(inner.new_error_for_next_token::<()>())
        };
        let holds = inner.try_parse(is_nested).ok().or_else(|| test(inner));
        while inner.next().is_ok() {}
        holds.ok_or(inner.new_error_for_next_token::<()>())
    });
    holds.ok()
}

/// Whether a feature of the screen is as a query wants it.
fn feature(input: &mut Parser<'_>) -> Option<bool> {
    let mut words = Vec::new();
    while let Ok(token) = input.next().cloned() {
        words.push(token);
    }
    match &words[..] {
        [Token::Ident(name)] => {
            let value = known(&name.to_ascii_lowercase())?;
            Some(!["0", "none", "no-preference"].contains(&value))
        }
        [Token::Ident(name), Token::Colon, value @ ..] => {
            let name = name.to_ascii_lowercase();
            let bound = name.strip_prefix("min-").map(|name| (name, '>'));
            let bound = bound.or_else(|| name.strip_prefix("max-").map(|name| (name, '<')));
            match bound {
                Some((name, sign)) => {
                    Some(compare(number(known(name)?)?, sign, true, amount(value)?))
                }
                None => Some(is_equal(known(&name)?, value)),
            }
        }
        _ => range(&words),
    }
}

/// A comparison such as `(width >= 600px)` or `(1px < width <= 600px)`.
fn range(words: &[Token<'_>]) -> Option<bool> {
    let at = words.iter().position(|word| match word {
        Token::Ident(name) => known(&name.to_ascii_lowercase()).is_some(),
        _ => false,
    })?;
    let Token::Ident(name) = &words[at] else {
        return None;
    };
    let found = number(known(&name.to_ascii_lowercase())?)?;
    let mut holds = true;
    if let [before @ .., Token::Delim(sign)] = &words[..at] {
        holds &= compare(amount(before)?, *sign, false, found);
    } else if let [before @ .., Token::Delim(sign), Token::Delim('=')] = &words[..at] {
        holds &= compare(amount(before)?, *sign, true, found);
    }
    match &words[at + 1..] {
        [Token::Delim(sign), Token::Delim('='), after @ ..] => {
            holds &= compare(found, *sign, true, amount(after)?);
        }
        [Token::Delim(sign), after @ ..] => holds &= compare(found, *sign, false, amount(after)?),
        [] => {}
        _ => return None,
    }
    Some(holds)
}

fn compare(a: f32, sign: char, or_equal: bool, b: f32) -> bool {
    match sign {
        '<' => a < b || (or_equal && a == b),
        '>' => a > b || (or_equal && a == b),
        _ => a == b,
    }
}

fn is_equal(known: &str, value: &[Token<'_>]) -> bool {
    match (number(known), amount(value)) {
        (Some(known), Some(value)) => known == value,
        _ => matches!(value, [Token::Ident(word)] if word.eq_ignore_ascii_case(known)),
    }
}

fn number(text: &str) -> Option<f32> {
    text.parse().ok()
}

/// A length in pixels, a resolution in dots per pixel, or a number.
fn amount(value: &[Token<'_>]) -> Option<f32> {
    if let [Token::Dimension { value, unit, .. }] = value {
        match unit.to_ascii_lowercase().as_str() {
            "dppx" | "x" => return Some(*value),
            "dpi" => return Some(value / 96.0),
            "dpcm" => return Some(value * 2.54 / 96.0),
            "em" => return Some(value * 16.0),
            _ => {}
        }
    }
    if let [
        Token::Number { value: a, .. },
        Token::Delim('/'),
        Token::Number { value: b, .. },
    ] = value
    {
        return Some(a / b);
    }
    let text: String = value.iter().map(ToCss::to_css_string).collect();
    match length(&mut Parser::new(&text))? {
        Length::Number(number) | Length::Px(number) => Some(number),
        Length::Relative(..) => None,
    }
}

/// The value of a feature of the screen.
fn known(name: &str) -> Option<&'static str> {
    let found = SCREEN.iter().find(|feature| feature.0 == name)?;
    Some(found.1)
}

/// Whether the condition of `@supports` holds.
pub(super) fn is_supported(input: &mut Parser<'_>) -> bool {
    let holds = condition(input, &declaration).filter(|_| input.is_exhausted());
    while input.next().is_ok() {}
    holds.unwrap_or(false)
}

/// Whether a declaration is understood.
fn declaration(input: &mut Parser<'_>) -> Option<bool> {
    let name = input.expect_ident_cloned().ok()?;
    input.expect_colon().ok()?;
    input.skip_whitespace();
    let start = input.position();
    while input.next().is_ok() {}
    let value = input.slice_from(start);
    let is_valid = |property: &Property| has_variables(value) || property.value(value).is_some();
    Some(name.starts_with("--") || Property::of(&name).is_some_and(is_valid))
}

/// The features of a light screen with a mouse, as in a window of usual size.
const SCREEN: [(&str, &str); 28] = [
    ("any-hover", "hover"),
    ("any-pointer", "fine"),
    ("aspect-ratio", "1.7777778"),
    ("color", "8"),
    ("color-gamut", "srgb"),
    ("color-index", "0"),
    ("device-height", "720"),
    ("device-width", "1280"),
    ("display-mode", "browser"),
    ("dynamic-range", "standard"),
    ("forced-colors", "none"),
    ("grid", "0"),
    ("height", "720"),
    ("hover", "hover"),
    ("inverted-colors", "none"),
    ("monochrome", "0"),
    ("orientation", "landscape"),
    ("overflow-block", "scroll"),
    ("overflow-inline", "scroll"),
    ("pointer", "fine"),
    ("prefers-color-scheme", "light"),
    ("prefers-contrast", "no-preference"),
    ("prefers-reduced-motion", "no-preference"),
    ("prefers-reduced-transparency", "no-preference"),
    ("resolution", "1"),
    ("scripting", "enabled"),
    ("update", "fast"),
    ("width", "1280"),
];
