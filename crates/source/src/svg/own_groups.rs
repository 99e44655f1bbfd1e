//! Elements whose style holds for all that they draw together: each becomes a group, with that in it.

use simplecss::{AttributeOperator, PseudoClass, Selector, StyleSheet};
use usvg::roxmltree::{Document, Node};

use super::styles::sheets;

/// Tells which elements of a document become groups.
pub(super) struct OwnGroups<'a> {
    /// The rules of its sheets that make a group of what they are for.
    selectors: Vec<Selector<'a>>,
}

impl<'a> OwnGroups<'a> {
    pub(super) fn of(doc: &'a Document<'_>) -> Self {
        let mut sheet = StyleSheet::new();
        for text in sheets(doc).filter_map(|it| it.text()) {
            sheet.parse_more(text);
        }
        let rules = sheet.rules.into_iter();
        let makes_group = rules.filter(|rule| {
            let mut declarations = rule.declarations.iter();
            declarations.any(|it| makes_group(it.name, it.value))
        });
        Self {
            selectors: makes_group.map(|it| it.selector).collect(),
        }
    }

    pub(super) fn holds(&self, node: Node<'_, '_>) -> bool {
        let by_sheet = || self.selectors.iter().any(|it| it.matches(&Element(node)));
        is_told(node) || by_sheet()
    }
}

/// Whether the element says so itself.
fn is_told(node: Node<'_, '_>) -> bool {
    node.attributes().any(|attribute| {
        if attribute.name() != "style" {
            return makes_group(attribute.name(), attribute.value());
        }
        let declarations = attribute.value().split(';');
        let mut declared = declarations.filter_map(|it| it.split_once(':'));
        declared.any(|(name, value)| makes_group(name.trim(), value.trim()))
    })
}

fn makes_group(name: &str, value: &str) -> bool {
    match name {
        "opacity" => value != "1",
        "transform" | "clip-path" | "mask" | "filter" => value != "none",
        _ => false,
    }
}

/// An element as the rules of a sheet see it.
struct Element<'a, 'input>(Node<'a, 'input>);

impl simplecss::Element for Element<'_, '_> {
    fn parent_element(&self) -> Option<Self> {
        self.0.parent_element().map(Element)
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.0.prev_sibling_element().map(Element)
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.0.tag_name().name() == name
    }

    fn attribute_matches(&self, name: &str, operator: AttributeOperator<'_>) -> bool {
        let value = self.0.attribute(name);
        value.is_some_and(|it| operator.matches(it))
    }

    fn pseudo_class_matches(&self, class: PseudoClass<'_>) -> bool {
        class == PseudoClass::FirstChild && self.prev_sibling_element().is_none()
    }
}
