//! Limits on styles: the library's cost per declaration grows with the position in its text.

use usvg::roxmltree::{Document, Node};

use crate::error::SourceError;

/// The cost of reading the style of an element, in bytes examined.
pub(super) fn cost(node: Node<'_, '_>) -> u64 {
    node.attribute("style").map_or(0, declared)
}

/// Refuses a sheet that takes too long, alone or on all elements of the document.
pub(super) fn check(doc: &Document<'_>) -> Result<(), SourceError> {
    let elements = doc.descendants().filter(Node::is_element).count() as u64;
    let mut rules = 0;
    for sheet in sheets(doc) {
        let texts = sheet.children().filter_map(|child| child.text());
        for text in texts {
            rules += count(text, b"{,");
            if declared(text) > MAX_WORK {
                return Err(refused(doc, sheet, "a sheet of fewer or shorter rules"));
            }
        }
        if rules.saturating_mul(elements) > MAX_WORK {
            return Err(refused(doc, sheet, "fewer rules for so many elements"));
        }
    }
    Ok(())
}

/// All sheets of a document.
pub(super) fn sheets<'a, 'input>(
    doc: &'a Document<'input>,
) -> impl Iterator<Item = Node<'a, 'input>> {
    let all = doc.descendants();
    all.filter(|item| item.is_element() && item.tag_name().name() == "style")
}

fn declared(text: &str) -> u64 {
    count(text, b":{").saturating_mul(text.len() as u64)
}

fn count(text: &str, signs: &[u8]) -> u64 {
    text.bytes().filter(|byte| signs.contains(byte)).count() as u64
}

fn refused(doc: &Document<'_>, sheet: Node<'_, '_>, expected: &str) -> SourceError {
    SourceError::Found {
        place: doc.text_pos_at(sheet.range().start).into(),
        found: "styles (CSS) that take too long to read".to_owned(),
        expected: format!("{expected}; save the file as plain SVG"),
    }
}

/// This takes about a second.
pub(super) const MAX_WORK: u64 = 500_000_000;
