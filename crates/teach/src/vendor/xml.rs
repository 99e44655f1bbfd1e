//! Elements of the vendor's XML files.

use roxmltree::{Document, Node, ParsingOptions};

use super::bad;
use super::text::number;
use crate::ProgramError;
use crate::number::within;

/// Parses a document.
pub(super) fn document(text: &str) -> Result<Document<'_>, ProgramError> {
    // Without entities there are no entity bombs.
    let options = ParsingOptions {
        allow_dtd: false,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text.trim_start(), options).map_err(|error| {
        let line = usize::try_from(error.pos().row).ok();
        bad(line, format!("not well-formed XML: {}", problem(&error)))
    })
}

/// The outermost element, which must have this name; other letter case is a warning.
pub(super) fn root<'a, 'input>(
    document: &'a Document<'input>,
    name: &str,
    warnings: &mut Vec<String>,
) -> Result<Node<'a, 'input>, ProgramError> {
    let root = document.root_element();
    let found = root.tag_name().name();
    if !found.eq_ignore_ascii_case(name) {
        return Err(bad(
            line(root),
            format!("the outermost element is <{found}>; it must be <{name}>"),
        ));
    }
    if found != name {
        warnings.push(format!(
            "line {}: the outermost element is <{found}>; read as <{name}>",
            line(root)
        ));
    }
    Ok(root)
}

/// The warning about an unknown element.
pub(super) fn unknown(node: Node<'_, '_>) -> String {
    let (line, name) = (line(node), node.tag_name().name());
    format!("line {line}: <{name}> is unknown; left out")
}

pub(super) fn line(node: Node<'_, '_>) -> usize {
    let at = node.document().text_pos_at(node.range().start);
    usize::try_from(at.row).unwrap_or(usize::MAX)
}

/// The fields of a point: its child elements.
pub(super) struct Fields<'a, 'input> {
    node: Node<'a, 'input>,
    warnings: &'a mut Vec<String>,
}

impl<'a, 'input> Fields<'a, 'input> {
    pub(super) const fn new(node: Node<'a, 'input>, warnings: &'a mut Vec<String>) -> Self {
        Self { node, warnings }
    }

    /// The text of a field and its line; `None` if it is missing or empty.
    pub(super) fn find(&self, name: &str) -> Option<(&'a str, usize)> {
        let mut children = self.node.children();
        let found = children.find(|child| child.tag_name().name() == name)?;
        let text = found.text()?.trim();
        (!text.is_empty()).then(|| (text, line(found)))
    }

    /// The text of a field and its line; `None`, with a warning, if it is missing.
    pub(super) fn text(&mut self, name: &str, otherwise: &str) -> Option<(&'a str, usize)> {
        let found = self.find(name);
        if found.is_none() {
            let line = line(self.node);
            self.warnings.push(format!(
                "line {line}: the point has no <{name}>; read as {otherwise}"
            ));
        }
        found
    }

    /// A number that must be there: an angle or a coordinate.
    pub(super) fn required(&mut self, name: &str) -> Result<f64, ProgramError> {
        if self.find(name).is_none() {
            return Err(bad(
                line(self.node),
                format!("the point has no <{name}>, which is required"),
            ));
        }
        self.number(name, -MAX_NUMBER, MAX_NUMBER)
    }

    /// A number within bounds; 0, with a warning, if it is missing.
    pub(super) fn number(
        &mut self,
        name: &str,
        least: f64,
        most: f64,
    ) -> Result<f64, ProgramError> {
        let Some((text, line)) = self.text(name, "0") else {
            return Ok(0.0);
        };
        let (value, is_comma) = number(text)
            .ok_or_else(|| bad(line, format!("<{name}> is {text:?}; expected a number")))?;
        if is_comma {
            self.warnings.push(format!(
                "line {line}: <{name}> is {text:?}; the comma is read as a point"
            ));
        }
        within(&format!("<{name}>"), "", value, least, most).map_err(|reason| bad(line, reason))
    }

    /// Adds a warning about the point.
    pub(super) fn warn(&mut self, reason: &str) {
        let line = line(self.node);
        self.warnings.push(format!("line {line}: {reason}"));
    }
}

/// What the XML parser reports, without the position that it appends.
fn problem(error: &roxmltree::Error) -> String {
    let message = error.to_string();
    let problem = message
        .rsplit_once(" at ")
        .map_or(&*message, |parts| parts.0);
    problem.replace('\'', "`")
}

/// Larger than any angle or length of an arm.
pub(super) const MAX_NUMBER: f64 = 1e6;
