//! Changes in the text of a file.

use std::ops::Range;

use usvg::roxmltree::Node;

/// Words for a part of a text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Edit {
    pub(super) range: Range<usize>,
    pub(super) words: String,
}

impl Edit {
    /// One more attribute of an element of the text.
    pub(super) fn attribute(text: &str, node: Node<'_, '_>, name: &str, value: &str) -> Self {
        let at = after_tag(text, node.range().start);
        Self {
            range: at..at,
            words: format!(" {name}=\"{}\"", escaped(value)),
        }
    }
}

/// The text with all changes made. What an entity holds stands in the text once, wherever it is used: of several changes of one
/// part the first is made.
pub(super) fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|it| it.range.start);
    let mut whole = String::with_capacity(text.len() + 32 * edits.len());
    let mut done = 0;
    let mut inserted = None;
    for Edit { range, words } in edits {
        if range.start >= done && inserted != Some(range.end) {
            whole += &text[done..range.start];
            whole += &words;
            done = range.end;
            inserted = range.is_empty().then_some(done);
        }
    }
    whole + &text[done..]
}

/// A text as it stands in XML, in an element or in the quotes of an attribute.
pub(super) fn escaped(text: &str) -> String {
    let mut whole = String::with_capacity(text.len());
    for sign in text.chars() {
        match sign {
            '&' => whole += "&amp;",
            '<' => whole += "&lt;",
            '>' => whole += "&gt;",
            '"' => whole += "&quot;",
            '\'' => whole += "&apos;",
            _ => whole.push(sign),
        }
    }
    whole
}

/// Where the name of an element ends.
fn after_tag(text: &str, start: usize) -> usize {
    let is_end = |c: char| c.is_whitespace() || c == '>' || c == '/';
    text[start..]
        .find(is_end)
        .map_or(text.len(), |end| start + end)
}
