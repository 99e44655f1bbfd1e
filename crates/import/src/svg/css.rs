//! Rewriting of CSS values that are newer than the library.
//!
//! ```text
//!   stroke: light-dark(black, white)        stroke: black
//!   fill: var(--sea, blue)                  fill: blue
//!   fill: oklch(0.63 0.26 29)               fill: #ff0000
//!   font: bold 1rem/1.5 serif               font: bold 16px serif
//! ```

use std::borrow::Cow;
use std::cell::Cell;
use std::collections::HashMap;
use std::ops::Range;

/// The values of custom properties, by name (`--sea`). Of several values the first counts: the
/// others are for a dark screen, or for another part of the page.
#[derive(Debug)]
pub(super) struct Variables<'a> {
    values: HashMap<&'a str, &'a str>,
    /// The number of bytes in function arguments that may still be processed.
    left: Cell<usize>,
}

impl<'a> Variables<'a> {
    pub(super) fn new() -> Self {
        Self {
            values: HashMap::new(),
            left: Cell::new(MAX_BYTES),
        }
    }

    /// Collects those of a sheet, or of the style of an element.
    pub(super) fn read(&mut self, css: &'a str) {
        for Custom { name, value, .. } in custom(css) {
            self.values.entry(name).or_insert(value);
        }
    }

    /// Rewrites a value, or the declarations of a style, for the library.
    pub(super) fn readable<'t>(&self, css: &'t str) -> Cow<'t, str> {
        let css = if css.contains('(') {
            self.without_functions(css, 0)
        } else {
            Cow::Borrowed(css)
        };
        let css = replaced(css, without_custom);
        let css = replaced(css, rem_to_px);
        let css = replaced(css, with_quoted_families);
        replaced(css, |text| {
            text.contains("font").then(|| without_line_heights(text))
        })
    }

    /// Replaces functions by their values.
    fn without_functions<'t>(&self, css: &'t str, depth: u32) -> Cow<'t, str> {
        let (mut whole, mut done, mut at) = (String::new(), 0, 0);
        while let Some(open) = css[at..].find('(').map(|offset| at + offset) {
            let head = &css[at..open];
            let begin = open - head.len() + head.trim_end_matches(is_of_name).len();
            at = open + 1;
            if let Some((value, end)) = self.value(&css[begin..open], &css[open..], depth) {
                whole += &css[done..begin];
                whole += &value;
                at = open + end;
                done = at;
            }
        }
        if done == 0 {
            return Cow::Borrowed(css);
        }
        Cow::Owned(whole + &css[done..])
    }

    /// The value of a function unknown to the library, at the start of a text after its name, if
    /// its brackets are closed.
    fn value(&self, name: &str, text: &str, depth: u32) -> Option<(String, usize)> {
        if depth == MAX_DEPTH || !FUNCTIONS.contains(&name) {
            return None;
        }
        let end = closed(text, ['(', ')']);
        self.left.set(self.left.get().checked_sub(end)?);
        let inner = &text[1..end];
        let arguments = inner.strip_suffix(')').unwrap_or(inner);
        let (first, others) = arguments.split_at(comma(arguments));
        let other = others.strip_prefix(',');
        let deeper = |css: &str| self.without_functions(css.trim(), depth + 1).into_owned();
        let value = match name {
            "var" => {
                let value = self.values.get(first.trim()).copied().or(other);
                value.map_or_else(|| "inherit".to_owned(), deeper)
            }
            "light-dark" => deeper(first),
            "color-mix" => {
                let other = other?;
                let mixed = deeper(&other[..comma(other)]);
                // The alpha value.
                let share = mixed.rfind(' ').filter(|_| mixed.ends_with('%'));
                share.map_or(mixed.clone(), |share| mixed[..share].to_owned())
            }
            "color" => {
                let (_, channels) = arguments.trim().split_once(' ')?;
                hex(&format!("rgb({})", percent(channels)))?
            }
            _ if first.len() < arguments.len() && !arguments.contains('(') => return None,
            _ => hex(&format!("{name}({})", deeper(arguments)))?,
        };
        self.left.set(self.left.get().checked_sub(value.len())?);
        Some((value, end))
    }
}

/// The declarations of a custom property.
struct Custom<'a> {
    name: &'a str,
    value: &'a str,
    range: Range<usize>,
}

fn custom(css: &str) -> impl Iterator<Item = Custom<'_>> {
    let mut done = 0;
    std::iter::from_fn(move || {
        while let Some(at) = css[done..].find("--").map(|at| done + at) {
            let rest = &css[at..];
            let name = &rest[..name_end(rest)];
            let before = css[done..at].trim_end().chars().next_back();
            let begins = before.is_none_or(|before| ";{}/".contains(before));
            done = at + name.len();
            let value = rest[name.len()..].trim_start().strip_prefix(':');
            if let (true, Some(value)) = (begins, value) {
                let end = value.find([';', '}']).unwrap_or(value.len());
                done = css.len() - value.len() + end;
                if value[end..].starts_with(';') {
                    done += 1;
                }
                return Some(Custom {
                    name,
                    value: value[..end].trim(),
                    range: at..done,
                });
            }
        }
        None
    })
}

/// Removes the custom properties, which would make the library drop the declarations beside them.
fn without_custom(css: &str) -> Option<String> {
    let (mut whole, mut done) = (String::new(), 0);
    for Custom { range, .. } in custom(css) {
        whole += &css[done..range.start];
        done = range.end;
    }
    (done > 0).then(|| whole + &css[done..])
}

/// The end of the bracketed text at the start, after the closing bracket.
pub(super) fn closed(text: &str, [open, close]: [char; 2]) -> usize {
    let mut depth = 0_usize;
    for (at, sign) in text.char_indices() {
        if sign == open {
            depth += 1;
        } else if sign == close {
            depth -= 1;
            if depth == 0 {
                return at + 1;
            }
        }
    }
    text.len()
}

/// The end of the first argument.
fn comma(arguments: &str) -> usize {
    let mut depth = 0_i32;
    let is_end = |sign: char| {
        depth += i32::from(sign == '(') - i32::from(sign == ')');
        sign == ',' && depth == 0
    };
    arguments.find(is_end).unwrap_or(arguments.len())
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

/// The hexadecimal digits of a colour.
fn hex(color: &str) -> Option<String> {
    let color = csscolorparser::parse(color).ok()?;
    Some(color.to_css_hex().to_string())
}

/// Converts lengths in the font size of the page, which is 16 px.
fn rem_to_px(css: &str) -> Option<String> {
    let mut whole = String::new();
    let mut done = 0;
    for (at, unit) in css.match_indices("rem") {
        let before = css[done..at].trim_end_matches(|c: char| c.is_ascii_digit() || c == '.');
        let begin = done + before.len();
        let ends = !css[at + unit.len()..].starts_with(is_of_name);
        if let (true, Ok(number)) = (ends, css[begin..at].parse::<f64>()) {
            whole += &css[done..begin];
            whole += &(REM_PX * number).to_string();
            whole += "px";
            done = at + unit.len();
        }
    }
    (done > 0).then(|| whole + &css[done..])
}

/// Removes line heights from `font` shorthands.
fn without_line_heights(css: &str) -> String {
    let mut whole = String::new();
    let mut rest = css;
    while let Some(at) = rest.find("font") {
        let (before, font) = rest.split_at(at + "font".len());
        whole += before;
        let end = font.find([';', '}']).unwrap_or(font.len());
        let (value, after) = font.split_at(end);
        let is_font = value.trim_start().starts_with(':');
        match value.split_once('/').filter(|_| is_font) {
            Some((size, height)) => {
                whole += size;
                let height = height.trim_start();
                whole += height.find(' ').map_or("", |at| &height[at..]);
            }
            None => whole += value,
        }
        rest = after;
    }
    whole + rest
}

/// Quotes font names that are invalid without quotes.
fn with_quoted_families(css: &str) -> Option<String> {
    let (mut whole, mut done) = (String::new(), 0);
    for (at, property) in css.match_indices("font-family") {
        let value = css[at + property.len()..].trim_start();
        let Some(value) = value.strip_prefix(':') else {
            continue;
        };
        let list = &value[..value.find([';', '}']).unwrap_or(value.len())];
        if let Some(families) = quoted_families(list) {
            let begin = css.len() - value.len();
            whole += &css[done..begin];
            whole += &families;
            done = begin + list.len();
        }
    }
    (done > 0).then(|| whole + &css[done..])
}

/// Quotes the fonts of a list that have a word starting with a digit (`Hershey Sans 1-stroke`):
/// many programs omit the quotes. `None` if there is no such name.
pub(super) fn quoted_families(list: &str) -> Option<String> {
    let is_quote = |sign: char| sign == '"' || sign == '\'';
    let has_number = |name: &str| {
        let mut words = name.split_whitespace();
        words.any(|word| word.starts_with(|sign: char| sign.is_ascii_digit()))
    };
    let (mut families, mut is_open, mut is_changed) = (Vec::new(), false, false);
    for family in list.split(',') {
        let is_bare =
            !is_open && !family.contains(|family| is_quote(family) || "!(\\".contains(family));
        is_open ^= family.chars().filter(|c| is_quote(*c)).count() % 2 == 1;
        if is_bare && has_number(family) {
            families.push(Cow::Owned(format!("'{}'", family.trim())));
            is_changed = true;
        } else {
            families.push(Cow::Borrowed(family));
        }
    }
    is_changed.then(|| families.join(","))
}

pub(super) fn replaced(css: Cow<'_, str>, by: impl Fn(&str) -> Option<String>) -> Cow<'_, str> {
    match by(&css) {
        Some(new) => Cow::Owned(new),
        None => css,
    }
}

fn name_end(text: &str) -> usize {
    text.find(|text| !is_of_name(text)).unwrap_or(text.len())
}

fn is_of_name(sign: char) -> bool {
    sign.is_alphanumeric() || sign == '-' || sign == '_'
}

/// The largest depth of variables in variables.
pub(super) const MAX_DEPTH: u32 = 8;
/// More would fill the memory.
const MAX_BYTES: usize = 20_000_000;
/// The functions that are replaced by their values.
const FUNCTIONS: [&str; 13] = [
    "color",
    "color-mix",
    "hsl",
    "hsla",
    "hwb",
    "lab",
    "lch",
    "light-dark",
    "oklab",
    "oklch",
    "rgb",
    "rgba",
    "var",
];
const REM_PX: f64 = 16.0;
