//! Colours of CSS, as hexadecimal digits or as names that the library knows.

use std::borrow::Cow;

use csscolorparser::Color;
use cssparser::{Parser, Token};

/// Parses a colour, with the words that only CSS knows replaced; `None` if it is invalid.
pub(super) fn color<'i>(input: &mut Parser<'i>) -> Option<Cow<'i, str>> {
    input.skip_whitespace();
    let start = input.position();
    match input.next().ok()?.clone() {
        Token::Hash(digits) | Token::IDHash(digits) => {
            let is_color = matches!(digits.len(), 3 | 4 | 6 | 8)
                && digits.chars().all(|digit| digit.is_ascii_hexdigit());
            is_color.then(|| Cow::Borrowed(input.slice_from(start)))
        }
        Token::Ident(name) if name.eq_ignore_ascii_case("currentcolor") => {
            Some("currentColor".into())
        }
        Token::Ident(name) => named(&name.to_ascii_lowercase()).map(Cow::Owned),
        Token::Function(name) => {
            let name = name.to_ascii_lowercase();
            let value = input.parse_nested_block(|inner| match name.as_str() {
                "light-dark" => light(inner).ok_or(inner.new_error_for_next_token::<()>()),
                "color-mix" => mixed(inner).ok_or(inner.new_error_for_next_token()),
                _ => {
                    while inner.next().is_ok() {}
                    Ok(String::new())
                }
            });
            let value = value.ok()?;
            if value.is_empty() {
                return function(input.slice_from(start)).map(Cow::Owned);
            }
            Some(Cow::Owned(value))
        }
        _ => None,
    }
}

fn named(name: &str) -> Option<String> {
    if let Some(system) = SYSTEM.iter().find(|system| system.0.contains(&name)) {
        return Some(system.1.to_owned());
    }
    // The library for colours takes digits without their sign too.
    let is_digits = name.chars().all(|sign| sign.is_ascii_hexdigit());
    (!is_digits).then(|| hex(name)).flatten()
}

/// A colour given by a function such as `rgb()` or `oklch()`.
fn function(text: &str) -> Option<String> {
    let text = text.to_ascii_lowercase();
    hex(&text).or_else(|| {
        // Wider colour spaces are near enough to that of screens.
        let channels = text.strip_prefix("color(")?.strip_suffix(')')?;
        let (space, channels) = channels.trim().split_once(' ')?;
        let is_known = SPACES.contains(&space);
        is_known.then(|| hex(&format!("rgb({})", percent(channels))))?
    })
}

/// Converts channels from 0 to 1 to percent, as in `rgb`.
fn percent(channels: &str) -> String {
    let (colors, alpha) = channels.split_once('/').unwrap_or((channels, "1"));
    let colors = colors
        .split_whitespace()
        .map(|word| match word.parse::<f64>() {
            Ok(share) => format!("{}%", 100.0 * share),
            Err(_) => word.to_owned(),
        });
    let colors: Vec<String> = colors.collect();
    format!("{} / {alpha}", colors.join(" "))
}

/// The first of two colours of `light-dark()`.
fn light(inner: &mut Parser<'_>) -> Option<String> {
    let light = color(inner)?.into_owned();
    inner.expect_comma().ok()?;
    color(inner)?;
    Some(light)
}

/// The colour of `color-mix()`.
fn mixed(inner: &mut Parser<'_>) -> Option<String> {
    inner.expect_ident_matching("in").ok()?;
    let space = inner.expect_ident_cloned().ok()?.to_ascii_lowercase();
    while inner.try_parse(Parser::expect_comma).is_err() {
        inner.next().ok()?;
    }
    let (first, first_share) = part(inner)?;
    inner.expect_comma().ok()?;
    let (second, second_share) = part(inner)?;
    let (first_share, second_share) = match (first_share, second_share) {
        (None, None) => (0.5, 0.5),
        (Some(first), None) => (first, 1.0 - first),
        (None, Some(second)) => (1.0 - second, second),
        (Some(first), Some(second)) => (first, second),
    };
    let sum = first_share + second_share;
    if first == "currentColor" || second == "currentColor" || sum <= 0.0 {
        return None;
    }
    let [first, second] = [first, second].map(|color| csscolorparser::parse(&color).ok());
    let (first, second, share) = (first?, second?, second_share / sum);
    let mut mixed = match space.as_str() {
        "srgb" | "hsl" | "hwb" => first.interpolate_rgb(&second, share),
        "srgb-linear" | "xyz" | "xyz-d50" | "xyz-d65" => {
            first.interpolate_linear_rgb(&second, share)
        }
        "lab" | "lch" => first.interpolate_lab(&second, share),
        _ => first.interpolate_oklab(&second, share),
    };
    mixed.a *= sum.min(1.0);
    Some(digits(&mixed))
}

/// A colour with its share in a mixture, from 0 to 1.
fn part(inner: &mut Parser<'_>) -> Option<(String, Option<f32>)> {
    let share = |inner: &mut Parser<'_>| inner.try_parse(Parser::expect_percentage).ok();
    let before = share(inner);
    let color = color(inner)?.into_owned();
    Some((color, before.or_else(|| share(inner))))
}

fn hex(color: &str) -> Option<String> {
    csscolorparser::parse(color)
        .ok()
        .map(|color| digits(&color))
}

fn digits(color: &Color) -> String {
    color.to_css_hex().to_string()
}

/// The colour spaces of `color()` whose channels are those of `rgb()`, nearly.
const SPACES: [&str; 5] = ["srgb", "display-p3", "a98-rgb", "prophoto-rgb", "rec2020"];
/// System colours of a light screen, as Chromium has them.
const SYSTEM: [(&[&str], &str); 9] = [
    (
        &[
            "accentcolor",
            "accentcolortext",
            "activeborder",
            "buttonborder",
            "buttontext",
            "canvastext",
            "captiontext",
            "fieldtext",
            "inactiveborder",
            "infotext",
            "marktext",
            "menutext",
            "threeddarkshadow",
            "threedhighlight",
            "threedlightshadow",
            "threedshadow",
            "windowframe",
            "windowtext",
        ],
        "#000000",
    ),
    (
        &[
            "activecaption",
            "appworkspace",
            "background",
            "canvas",
            "field",
            "highlighttext",
            "inactivecaption",
            "infobackground",
            "menu",
            "scrollbar",
            "selecteditemtext",
            "window",
        ],
        "#ffffff",
    ),
    (
        &[
            "buttonface",
            "buttonhighlight",
            "buttonshadow",
            "threedface",
        ],
        "#efefef",
    ),
    (&["graytext", "inactivecaptiontext"], "#808080"),
    (&["activetext"], "#ff0000"),
    (&["highlight", "selecteditem"], "#1967d2"),
    (&["linktext"], "#0000ee"),
    (&["mark"], "#ffff00"),
    (&["visitedtext"], "#551a8b"),
];
