//! The styles of elements: their own ones, and the rules of all sheets.

use simplecss::{AttributeOperator, PseudoClass, Selector, StyleSheet};
use usvg::roxmltree::{Document, Node};

use super::styles::sheets;

/// The elements for which a style declares a property.
pub(super) struct Declared<'a> {
    /// Whether a name and a value are the property.
    is_match: fn(&str, &str) -> bool,
    /// The rules that declare it.
    selectors: Vec<&'a Selector<'a>>,
}

/// The rules of all sheets of a document.
pub(super) fn rules<'a>(doc: &'a Document<'_>) -> StyleSheet<'a> {
    let mut all = StyleSheet::new();
    for text in sheets(doc).filter_map(|sheet| sheet.text()) {
        all.parse_more(text);
    }
    all
}

impl<'a> Declared<'a> {
    pub(super) fn of(sheet: &'a StyleSheet<'a>, is_match: fn(&str, &str) -> bool) -> Self {
        let declares = sheet.rules.iter().filter(|rule| {
            let mut declarations = rule.declarations.iter();
            declarations.any(|declaration| is_match(declaration.name, declaration.value))
        });
        Self {
            is_match,
            selectors: declares.map(|rule| &rule.selector).collect(),
        }
    }

    pub(super) fn of_element(&self, node: Node<'_, '_>) -> bool {
        let style = node.attribute("style").unwrap_or_default();
        let mut own = style.split(';').filter_map(|part| part.split_once(':'));
        own.any(|(name, value)| (self.is_match)(name.trim(), value.trim()))
            || self
                .selectors
                .iter()
                .any(|selector| selector.matches(&Element(node)))
    }
}

/// The value of a property by the styles; the element's own style precedes the rules, of which the
/// last one counts.
pub(super) fn value_of<'a>(
    sheet: &'a StyleSheet<'a>,
    node: Node<'a, '_>,
    name: &str,
) -> Option<&'a str> {
    let style = node.attribute("style").unwrap_or_default();
    let own = style.split(';').filter_map(|part| part.split_once(':'));
    let mut own = own
        .filter(|value| value.0.trim() == name)
        .map(|value| value.1.trim());
    let declared = sheet.rules.iter().rev().filter_map(|rule| {
        let mut declarations = rule.declarations.iter().rev();
        let declaration = declarations.find(|declaration| declaration.name == name)?;
        rule.selector
            .matches(&Element(node))
            .then_some(declaration.value)
    });
    own.next_back().or_else(|| declared.into_iter().next())
}

/// The value of a property by the styles, or else by its attribute.
pub(super) fn property_of<'a>(
    sheet: &'a StyleSheet<'a>,
    node: Node<'a, '_>,
    name: &str,
) -> Option<&'a str> {
    let value = value_of(sheet, node, name).or_else(|| node.attribute(name))?;
    value.split('!').next().map(str::trim)
}

/// The value of a property on each element, by node number: its own, or else the inherited one.
pub(super) fn inherited<'a>(
    sheet: &'a StyleSheet<'a>,
    doc: &'a Document<'_>,
    name: &str,
) -> Vec<Option<&'a str>> {
    let mut values = vec![None; doc.descendants().count()];
    for node in doc.descendants().filter(Node::is_element) {
        let own = property_of(sheet, node, name).filter(|value| *value != "inherit");
        let outer = node
            .parent()
            .and_then(|parent| values[parent.id().get_usize()]);
        values[node.id().get_usize()] = own.or(outer);
    }
    values
}

/// An element for matching the selectors of a sheet.
pub(super) struct Element<'a, 'input>(pub(super) Node<'a, 'input>);

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
        value.is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass<'_>) -> bool {
        class == PseudoClass::FirstChild && self.prev_sibling_element().is_none()
    }
}
