//! The size of the page: that of the root, in units known to the library.

use std::str::FromStr;

use svgtypes::Length;
use usvg::roxmltree::{Attribute, Document};

use super::css::{Found, Styles};
use super::edits::{Additions, Edit, escaped};

/// The rewritten attributes of the root, and the ignored sizes.
#[derive(Debug, Default)]
pub(super) struct PageSize {
    pub(super) edits: Vec<Edit>,
    pub(super) added: Additions,
    pub(super) unread: Found,
}

impl PageSize {
    /// The width and the height by the styles, which precede the attributes. A size that a browser
    /// ignores, or takes from its window, is the whole page.
    pub(super) fn of(doc: &Document<'_>, styles: &Styles<'_>) -> Self {
        let root = doc.root_element();
        let mut size = Self::default();
        for name in ["width", "height"] {
            let attribute = root.attribute_node(name);
            let styled = styles.value(root, name);
            let styled = styled.filter(|value| !value.ends_with('%'));
            match (styled.filter(|value| is_length(value)), attribute) {
                (Some(value), Some(attribute)) => size.edits.push(replaced(&attribute, value)),
                (Some(value), None) => size.added.attribute(name, value),
                (None, Some(attribute)) if !is_read(attribute.value().trim()) => {
                    size.edits.push(replaced(&attribute, "100%"));
                    size.unread.add(1, attribute.range_value().start);
                }
                _ => {}
            }
        }
        size
    }
}

fn replaced(attribute: &Attribute<'_, '_>, value: &str) -> Edit {
    Edit {
        range: attribute.range_value(),
        words: escaped(value),
    }
}

fn is_read(value: &str) -> bool {
    value == "auto" || is_length(value)
}

fn is_length(value: &str) -> bool {
    Length::from_str(value).is_ok_and(|length| length.number >= 0.0)
}
