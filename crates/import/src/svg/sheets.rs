//! Rewriting of style sheets for the library.
//!
//! ```text
//!   @media screen { .a { fill: red } }      .a { fill: red }
//!   :root { --sea: blue }                   svg { }
//!   [id^=a] { fill: red }                   [marked-1] { fill: red }
//! ```

use std::borrow::Cow;

use simplecss::Selector;

use super::css::{MAX_DEPTH, Variables, closed, replaced};
use super::selectors::Marks;

/// A rewritten sheet.
pub(super) fn readable_sheet<'t>(
    css: &'t str,
    variables: &Variables<'_>,
    marks: &mut Marks,
) -> Cow<'t, str> {
    let css = replaced(Cow::Borrowed(css), without_html_signs);
    let css = replaced(css, |text| text.contains('@').then(|| unwrapped(text, 0)));
    let css = replaced(css, |text| {
        text.contains(":root").then(|| text.replace(":root", "svg"))
    });
    let css = match css {
        Cow::Borrowed(css) => variables.readable(css),
        Cow::Owned(css) => Cow::Owned(variables.readable(&css).into_owned()),
    };
    let has_unread = unread_rules(&css) > 0;
    if has_unread {
        Cow::Owned(marked(&css, marks))
    } else {
        css
    }
}

/// Replaces unsupported selectors of a sheet by marks.
fn marked(css: &str, marks: &mut Marks) -> String {
    let rule = |statement: Statement<'_>| {
        let selectors = if is_unread(&statement) {
            marks.readable(statement.prelude)
        } else {
            None
        };
        match (selectors, statement.body) {
            (Some(selectors), Some(body)) => format!("{selectors}{{{body}}}"),
            _ => statement.whole.to_owned(),
        }
    };
    statements(css).map(rule).collect()
}

/// The rules of a sheet for an idle pointer that the library does not support.
pub(super) fn unread_rules(css: &str) -> usize {
    statements(css).filter(is_unread).count()
}

fn is_unread(statement: &Statement<'_>) -> bool {
    let body = statement
        .body
        .filter(|_| !statement.prelude.starts_with('@'));
    let shows = body.is_some_and(|body| VISIBLE.iter().any(|visible| body.contains(visible)));
    let nests = body.is_some_and(|body| body.contains('{'));
    let mut selectors = statement.prelude.split(',').map(str::trim);
    let mut is_unknown = || {
        selectors.any(|selector| !selector.contains("::") && Selector::parse(selector).is_none())
    };
    shows && (nests || is_unknown())
}

/// A rule or an at-rule of a sheet.
struct Statement<'a> {
    /// The text before its block, or the whole rule without one.
    prelude: &'a str,
    /// The content of its braces.
    body: Option<&'a str>,
    whole: &'a str,
}

/// The outermost statements of a sheet, with the comments before them in their preludes.
fn statements(css: &str) -> impl Iterator<Item = Statement<'_>> {
    let mut rest = css;
    std::iter::from_fn(move || {
        let before = rest;
        rest = without_comments(rest);
        if rest.is_empty() {
            return None;
        }
        let skipped = before.len() - rest.len();
        let end = rest.find(['{', ';']).unwrap_or(rest.len());
        let block = rest[end..].starts_with('{');
        let whole = if block {
            end + closed(&rest[end..], ['{', '}'])
        } else {
            (end + 1).min(rest.len())
        };
        let statement = Statement {
            prelude: rest[..end].trim(),
            body: block.then(|| inside(&rest[end + 1..whole])),
            whole: &before[..skipped + whole],
        };
        rest = &rest[whole..];
        Some(statement)
    })
}

/// A block without its closing brace.
fn inside(block: &str) -> &str {
    block.strip_suffix('}').unwrap_or(block)
}

fn without_comments(mut css: &str) -> &str {
    loop {
        css = css.trim_start();
        let Some(comment) = css.strip_prefix("/*") else {
            return css;
        };
        css = comment.split_once("*/").map_or("", |parts| parts.1);
    }
}

/// Flattens the blocks of at-rules that apply to a page on a light screen.
fn unwrapped(css: &str, depth: u32) -> String {
    let unwrap = |statement: Statement<'_>| match statement.body {
        Some(body) if depth < MAX_DEPTH && holds(statement.prelude) => unwrapped(body, depth + 1),
        _ => statement.whole.to_owned(),
    };
    statements(css).map(unwrap).collect()
}

fn holds(prelude: &str) -> bool {
    let (rule, condition) = prelude.split_once([' ', '(']).unwrap_or((prelude, ""));
    let condition = condition.trim().trim_start_matches("only ");
    match rule {
        "@layer" => true,
        "@supports" => !condition.starts_with("not"),
        "@media" => {
            let of_light =
                condition.contains("prefers-color-scheme") && condition.contains("light");
            matches!(condition, "" | "all" | "screen") || of_light
        }
        _ => false,
    }
}

/// Removes HTML comment signs, which old editors write around a sheet.
fn without_html_signs(css: &str) -> Option<String> {
    let is_marked = css.contains("<!--") || css.contains("-->");
    is_marked.then(|| css.replace("<!--", "").replace("-->", ""))
}

/// The declarations of a rule that change the drawing.
const VISIBLE: [&str; 8] = [
    "display",
    "visibility",
    "fill",
    "stroke",
    "opacity",
    "transform",
    "font",
    "clip",
];

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const PARTS: [&str; 30] = [
        "var(",
        "--a",
        "--ä→",
        ":",
        ";",
        ")",
        "(",
        "rgb(",
        "light-dark(",
        "→",
        "ä",
        " ",
        ",",
        "2rem",
        "rem",
        ".",
        "font",
        "/",
        "@media screen",
        "@layer",
        "{",
        "}",
        "/*",
        "*/",
        "5%",
        "color-mix(in srgb,",
        "color(srgb ",
        "oklch(",
        ":root",
        "1 2 3",
    ];

    proptest! {
        #[test]
        fn any_text_in_a_style_is_read(parts in prop::collection::vec(prop::sample::select(&PARTS[..]), 0..40)) {
            let css = parts.concat();
            let mut variables = Variables::new();
            variables.read(&css);
            let sheet = readable_sheet(&css, &variables, &mut Marks::default()).into_owned();
            unread_rules(&sheet);
            let once = variables.readable(&css).into_owned();
            prop_assert!(once.len() <= 1_000_000, "{css}");
        }
    }
}
