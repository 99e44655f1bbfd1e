//! Custom properties, and their values in `var()`.

use std::cell::Cell;
use std::collections::HashMap;

use cssparser::{ParseError, Parser, Token};

/// The custom properties of an element, by name (`--sea`).
pub(super) type Variables<'a> = HashMap<String, &'a str>;

/// The number of bytes that replaced functions may still produce: more would fill the memory.
#[derive(Debug)]
pub(super) struct BytesLeft(Cell<usize>);

impl Default for BytesLeft {
    fn default() -> Self {
        Self(Cell::new(20_000_000))
    }
}

impl BytesLeft {
    fn spend(&self, bytes: usize) -> Option<()> {
        self.0.set(self.0.get().checked_sub(bytes)?);
        Some(())
    }
}

/// Whether a value refers to custom properties.
pub(super) fn has_variables(text: &str) -> bool {
    text.contains('(') && text.to_ascii_lowercase().contains("var(")
}

/// A value with its custom properties replaced; `None` if one has no value.
pub(super) fn replaced(text: &str, variables: &Variables<'_>, left: &BytesLeft) -> Option<String> {
    replaced_at(text, variables, left, 0)
}

fn replaced_at(
    text: &str,
    variables: &Variables<'_>,
    left: &BytesLeft,
    depth: u32,
) -> Option<String> {
    if depth > MAX_DEPTH {
        return None;
    }
    left.spend(text.len())?;
    let mut whole = String::new();
    copy(&mut Parser::new(text), &mut whole, &mut |inner| {
        variable(inner, variables, left, depth)
    })
    .ok()?;
    Some(whole)
}

/// Copies tokens, with the value of each `var()` in its place.
fn copy<'i>(
    input: &mut Parser<'i>,
    whole: &mut String,
    variable: &mut dyn FnMut(&mut Parser<'i>) -> Option<String>,
) -> Result<(), ParseError<()>> {
    loop {
        let start = input.position();
        let Ok(token) = input.next_including_whitespace_and_comments().cloned() else {
            return Ok(());
        };
        let close = match &token {
            Token::Function(name) if name.eq_ignore_ascii_case("var") => {
                let value = input.parse_nested_block(|inner| {
                    let value = variable(inner);
                    while inner.next().is_ok() {}
                    value.ok_or(inner.new_error_for_next_token::<()>())
                })?;
                // Blanks keep tokens apart.
                whole.extend([" ", &value, " "]);
                continue;
            }
            Token::Function(_) | Token::ParenthesisBlock => ")",
            Token::SquareBracketBlock => "]",
            Token::CurlyBracketBlock => "}",
            _ => {
                *whole += input.slice_from(start);
                continue;
            }
        };
        *whole += input.slice_from(start);
        input.parse_nested_block(|inner| copy(inner, whole, variable))?;
        *whole += close;
    }
}

/// The value of `var()`, or else that after its comma.
fn variable(
    inner: &mut Parser<'_>,
    variables: &Variables<'_>,
    left: &BytesLeft,
    depth: u32,
) -> Option<String> {
    let name = inner.expect_ident_cloned().ok()?;
    let value = variables.get(&*name);
    let value = value.and_then(|value| replaced_at(value, variables, left, depth + 1));
    value.or_else(|| {
        inner.expect_comma().ok()?;
        inner.skip_whitespace();
        let start = inner.position();
        while inner.next().is_ok() {}
        replaced_at(inner.slice_from(start), variables, left, depth + 1)
    })
}

/// The largest depth of variables in variables.
const MAX_DEPTH: u32 = 8;
