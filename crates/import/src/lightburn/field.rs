//! Texts and numbers of the file, with positions.

use usvg::roxmltree::Node;

use crate::error::SourceError;
use crate::limits::MAX_NUMBER;
use crate::place::shortened;

/// A text of the file: the value of an attribute, or the content of an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Field<'d> {
    pub(super) text: &'d str,
    /// The position in the file, in bytes.
    pub(super) at: usize,
}

impl<'d> Field<'d> {
    pub(super) fn attribute(node: Node<'d, '_>, name: &str) -> Option<Self> {
        let attribute = node.attribute_node(name)?;
        Some(Self {
            // Of the document, not of the current node.
            text: node.attribute(name)?,
            at: attribute.range_value().start,
        })
    }

    /// The value of a child such as `<index Value="0"/>`.
    pub(super) fn value(node: Node<'d, '_>, name: &str) -> Option<Self> {
        let child = node.children().find(|child| child.has_tag_name(name))?;
        Self::attribute(child, "Value")
    }

    /// The content of a child such as `<XForm>1 0 0 1 0 0</XForm>`; empty if it has none.
    pub(super) fn content(node: Node<'d, '_>, name: &str) -> Option<Self> {
        let child = node.children().find(|child| child.has_tag_name(name))?;
        let text = child.first_child().filter(Node::is_text);
        Some(Self {
            text: text.and_then(|text| text.text()).unwrap_or_default(),
            at: text.map_or(child.range().start, |text| text.range().start),
        })
    }

    /// A number of at most 1e9.
    pub(super) fn number(self, file: &str) -> Result<f64, SourceError> {
        let number = self.text.trim().parse().ok();
        let number = number.filter(|x: &f64| x.abs() <= MAX_NUMBER);
        number.ok_or_else(|| self.refused(file, "a number of at most 1e9"))
    }

    /// A whole number of 0 or more.
    pub(super) fn count(self, file: &str) -> Result<u32, SourceError> {
        let number = self.text.trim().parse().ok();
        number.ok_or_else(|| self.refused(file, "a whole number of 0 or more"))
    }

    /// Whether it is true: 1 or 0, as `LightBurn` writes it.
    pub(super) fn flag(self, file: &str) -> Result<bool, SourceError> {
        match self.text.trim() {
            "0" => Ok(false),
            "1" => Ok(true),
            _ => Err(self.refused(file, "0 or 1")),
        }
    }

    pub(super) fn refused(self, file: &str, expected: &str) -> SourceError {
        let found = format!("{:?}", shortened(self.text));
        SourceError::found(file.as_bytes(), self.at, found, expected)
    }
}

/// The number of an attribute, 0 if missing.
pub(super) fn number(file: &str, node: Node<'_, '_>, name: &str) -> Result<f64, SourceError> {
    Field::attribute(node, name).map_or(Ok(0.0), |field| field.number(file))
}

/// The length of an attribute, 0 or more; 0 if missing.
pub(super) fn length(file: &str, node: Node<'_, '_>, name: &str) -> Result<f64, SourceError> {
    let Some(field) = Field::attribute(node, name) else {
        return Ok(0.0);
    };
    let length = field.number(file)?;
    if length < 0.0 {
        return Err(field.refused(file, "a length of 0 mm or more"));
    }
    Ok(length)
}
