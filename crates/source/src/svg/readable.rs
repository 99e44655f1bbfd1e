//! A file in words that the library knows: what is newer in it, or what it would leave out without need, is written otherwise.

use std::borrow::Cow;
use std::collections::HashSet;

use simplecss::StyleSheet;
use usvg::roxmltree::{Attribute, Document, Node};

use super::css::{Variables, unread_rules};
use super::declared::{rules, value_of};
use super::edits::{Edit, edited, escaped};
use super::styles::sheets;

/// What is written otherwise in a file, and what of it is still not read as a browser does.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Readable {
    /// The whole file, if anything of it is.
    pub(super) text: Option<String>,
    /// How many rules of sheets are not read.
    pub(super) unread_rules: usize,
    /// How many lines are solid whose dashes are told in shares of a path.
    pub(super) solid: usize,
}

impl Readable {
    pub(super) fn of(doc: &Document<'_>, text: &str) -> Self {
        let mut variables = Variables::new();
        let styles = doc.descendants().filter_map(|it| it.attribute("style"));
        for css in sheets(doc).filter_map(|it| it.text()).chain(styles) {
            variables.read(css);
        }
        let mut edits = Vec::new();
        let mut unread = 0;
        for sheet in sheets(doc) {
            let (Some(begin), Some(end)) = (sheet.first_child(), sheet.last_child()) else {
                continue;
            };
            let css = sheet.text().unwrap_or_default();
            let new = variables.readable_sheet(css);
            unread += unread_rules(&new);
            if let Cow::Owned(new) = new {
                edits.push(Edit {
                    range: begin.range().start..end.range().end,
                    words: escaped(&new),
                });
            }
        }
        let rules = rules(doc);
        let ids: HashSet<&str> = doc
            .descendants()
            .filter_map(|it| it.attribute("id"))
            .collect();
        let elements = || doc.descendants().filter(Node::is_element);
        for node in elements() {
            let attributes = node.attributes();
            let attributes =
                attributes.filter(|it| it.namespace().is_none() && !PLAIN.contains(&it.name()));
            edits.extend(attributes.filter_map(|it| readable(it, &variables, &ids)));
        }
        edits.extend(sized_root(doc, text, &rules));
        let dashed = |it: &Node<'_, '_>| {
            it.has_attribute("pathLength")
                && (it.has_attribute(DASHES) || value_of(&rules, *it, DASHES).is_some())
        };
        let solid: Vec<Node<'_, '_>> = elements().filter(dashed).collect();
        edits.extend(solid.iter().map(|it| made_solid(text, *it)));
        Self {
            text: (!edits.is_empty()).then(|| edited(text, edits)),
            unread_rules: unread,
            solid: solid.len(),
        }
    }
}

/// An attribute in words that the library knows. A filter that is not in the file would hide what has it.
fn readable(
    attribute: Attribute<'_, '_>,
    variables: &Variables<'_>,
    ids: &HashSet<&str>,
) -> Option<Edit> {
    let value = attribute.value();
    let is_missing =
        attribute.name() == "filter" && linked(value).is_some_and(|it| !ids.contains(it));
    let words = if is_missing {
        Cow::Owned("none".to_owned())
    } else {
        variables.readable(value)
    };
    match words {
        Cow::Borrowed(_) => None,
        Cow::Owned(words) => Some(Edit {
            range: attribute.range_value(),
            words: escaped(&words),
        }),
    }
}

/// The element of this file that is meant by `url(#name)`.
fn linked(value: &str) -> Option<&str> {
    let inner = value.trim().strip_prefix("url(")?.strip_suffix(')')?;
    inner.trim_matches(['"', '\'', ' ']).strip_prefix('#')
}

/// The width and the height of the page as the styles have them: they come before the attributes.
fn sized_root(doc: &Document<'_>, text: &str, rules: &StyleSheet<'_>) -> Vec<Edit> {
    let root = doc.root_element();
    let sized = ["width", "height"].into_iter().filter_map(|name| {
        let value = value_of(rules, root, name)?;
        let has_unit = UNITS.iter().any(|it| value.ends_with(it));
        has_unit.then(|| match root.attribute_node(name) {
            Some(it) => Edit {
                range: it.range_value(),
                words: escaped(value),
            },
            None => Edit::attribute(text, root, name, value),
        })
    });
    sized.collect()
}

/// An element whose line has no dashes.
fn made_solid(text: &str, node: Node<'_, '_>) -> Edit {
    let solid = format!("{DASHES}:none");
    match node.attribute_node("style") {
        None => Edit::attribute(text, node, "style", &solid),
        Some(it) => {
            let end = it.range_value().end;
            Edit {
                range: end..end,
                words: format!(";{solid}"),
            }
        }
    }
}

const DASHES: &str = "stroke-dasharray";
/// Attributes that hold no CSS: names, and what may be long.
const PLAIN: [&str; 6] = ["id", "class", "href", "d", "points", "transform"];
/// Units in which a page may be as large as styles tell.
const UNITS: [&str; 6] = ["px", "mm", "cm", "in", "pt", "pc"];
