//! Texts that the library would draw differently from a browser.

use usvg::roxmltree::{Document, Node};

use super::css::Styles;
use super::edits::Edit;

/// Removes hidden parts of texts: the library draws nested ones.
pub(super) fn undisplayed(doc: &Document<'_>, styles: &Styles<'_>) -> Vec<Edit> {
    let spans = doc.descendants().filter(|node| is_named(*node, &PARTS));
    let hidden = spans.filter(|span| styles.property(*span, "display") == Some("none"));
    let edits = hidden.map(|hidden| Edit {
        range: hidden.range(),
        words: String::new(),
    });
    edits.collect()
}

/// The anchors of right-to-left texts by node number: the library takes their left ends for their
/// starts. Empty if there are none.
pub(super) fn anchors(doc: &Document<'_>, styles: &Styles<'_>) -> Vec<Option<&'static str>> {
    let directions = styles.inherited(doc, "direction");
    if !directions.contains(&Some("rtl")) {
        return Vec::new();
    }
    let anchors = styles.inherited(doc, "text-anchor");
    let mut turned = vec![None; directions.len()];
    for text in doc.descendants().filter(|node| is_named(*node, &TEXTS)) {
        let number = text.id().get_usize();
        if directions[number] == Some("rtl") {
            turned[number] = match anchors[number] {
                Some("middle") => None,
                Some("end") => Some("start"),
                _ => Some("end"),
            };
        }
    }
    turned
}

fn is_named(node: Node<'_, '_>, names: &[&str]) -> bool {
    node.is_element() && names.contains(&node.tag_name().name())
}

const PARTS: [&str; 2] = ["tspan", "textPath"];
const TEXTS: [&str; 3] = ["text", "tspan", "textPath"];
