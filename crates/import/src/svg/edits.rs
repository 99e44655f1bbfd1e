//! Edits of the text of a file.

use std::ops::Range;

use usvg::roxmltree::Node;

/// A replacement for a part of a text.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Edit {
    pub(super) range: Range<usize>,
    pub(super) words: String,
}

impl Edit {
    /// Adds an attribute to an element of the text.
    pub(super) fn attribute(text: &str, node: Node<'_, '_>, name: &str, value: &str) -> Self {
        let at = after_tag(text, node.range().start);
        Self {
            range: at..at,
            words: format!(" {name}=\"{}\"", escaped(value)),
        }
    }
}

/// Additions to an element.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Additions {
    attributes: String,
    declarations: String,
}

impl Additions {
    pub(super) fn attribute(&mut self, name: &str, value: &str) {
        for part in [" ", name, "=\"", &escaped(value), "\""] {
            self.attributes += part;
        }
    }

    /// Adds a declaration to its style.
    pub(super) fn declaration(&mut self, name: &str, value: &str) {
        for part in [name, ":", value, ";"] {
            self.declarations += part;
        }
    }

    /// The attributes, each after a blank.
    pub(super) fn attributes(&self) -> &str {
        &self.attributes
    }

    pub(super) fn append(&mut self, other: &Self) {
        self.attributes += &other.attributes;
        self.declarations += &other.declarations;
    }

    /// The edit that applies the additions to an element of the text without a style.
    pub(super) fn edit(mut self, text: &str, node: Node<'_, '_>) -> Option<Edit> {
        let declarations = std::mem::take(&mut self.declarations);
        if !declarations.is_empty() {
            self.attribute("style", &declarations);
        }
        let at = after_tag(text, node.range().start);
        (!self.attributes.is_empty()).then_some(Edit {
            range: at..at,
            words: self.attributes,
        })
    }
}

/// Applies all edits to the text. The content of an entity is in the text once, wherever it is
/// used: of several edits of a part the first one is made.
pub(super) fn edited(text: &str, mut edits: Vec<Edit>) -> String {
    edits.sort_by_key(|edit| edit.range.start);
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

/// Escapes a text for XML, in an element or in the quotes of an attribute.
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

/// The end of an element's name.
fn after_tag(text: &str, start: usize) -> usize {
    let is_end = |c: char| c.is_whitespace() || c == '>' || c == '/';
    text[start..]
        .find(is_end)
        .map_or(text.len(), |end| start + end)
}
