//! Rewriting of a file for the library: newer syntax, and what it would drop needlessly.

use std::borrow::Cow;
use std::collections::HashSet;
use std::str::FromStr;

use simplecss::StyleSheet;
use svgtypes::Length;
use usvg::roxmltree::{Attribute, Document, Node};

use super::check::is_length;
use super::css::{Variables, quoted_families, replaced};
use super::declared::{Declared, property_of, rules, value_of};
use super::edits::{Additions, Edit, edited, escaped};
use super::handles::freed;
use super::ink::SCREEN_LINE;
use super::letters::{anchors, undisplayed};
use super::page_size::PageSize;
use super::selectors::Marks;
use super::sheets::{readable_sheet, unread_rules};
use super::styles::sheets;

/// The rewritten parts of a file, and what is still unsupported.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Readable {
    /// The whole file, if anything changed.
    pub(super) text: Option<String>,
    /// The number of ignored sheet rules.
    pub(super) unread_rules: usize,
    /// The number of ignored page sizes.
    pub(super) unread_sizes: usize,
    /// The number of lines drawn solid whose dashes are given as fractions of a path.
    pub(super) solid: usize,
}

impl Readable {
    pub(super) fn of(doc: &Document<'_>, text: &str) -> Self {
        let mut variables = Variables::new();
        let styles = doc.descendants().filter_map(|node| node.attribute("style"));
        for css in sheets(doc).filter_map(|sheet| sheet.text()).chain(styles) {
            variables.read(css);
        }
        let mut edits = Vec::new();
        let mut unread = 0;
        let mut marks = Marks::default();
        for sheet in sheets(doc) {
            let (Some(begin), Some(end)) = (sheet.first_child(), sheet.last_child()) else {
                continue;
            };
            let css = sheet.text().unwrap_or_default();
            let new = readable_sheet(css, &variables, &mut marks);
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
            .filter_map(|node| node.attribute("id"))
            .collect();
        let PageSize {
            edits: of_page,
            added: of_root,
            unread: unread_sizes,
        } = PageSize::of(doc, &rules);
        edits.extend(of_page);
        edits.extend(undisplayed(doc, &rules));
        let marks = marks.of(doc);
        let mut rewriter = Rewriter::of(doc, text, &rules);
        for node in doc.descendants().filter(Node::is_element) {
            let attributes = node.attributes();
            let attributes = attributes.filter(|attribute| {
                attribute.namespace().is_none() && !PLAIN.contains(&attribute.name())
            });
            edits.extend(
                attributes
                    .clone()
                    .filter_map(|attribute| trimmed(node, attribute)),
            );
            edits.extend(attributes.filter_map(|attribute| readable(attribute, &variables, &ids)));
            edits.extend(rewriter.path(node));
            let mut added = rewriter.additions(node);
            for mark in marks.get(node.id().get_usize()).into_iter().flatten() {
                added.attribute(mark, "");
            }
            if node == doc.root_element() {
                added.append(&of_root);
            }
            edits.extend(added.edits(text, node));
        }
        Self {
            text: (!edits.is_empty()).then(|| edited(text, edits)),
            unread_rules: unread,
            unread_sizes,
            solid: rewriter.solid,
        }
    }
}

/// Collects the additions to elements, so that the library draws them like a browser.
struct Rewriter<'a> {
    rules: &'a StyleSheet<'a>,
    /// Whether anything has dashes.
    dashes: bool,
    /// Whether any line keeps its width on the page, however it is scaled.
    on_page: bool,
    /// The elements with markers, by node number; empty if there are none.
    marked: Vec<bool>,
    /// The new anchors of texts, by node number; empty if unchanged.
    anchors: Vec<Option<&'static str>>,
    /// The number of lines made solid.
    solid: usize,
}

impl<'a> Rewriter<'a> {
    fn of(doc: &'a Document<'_>, text: &str, rules: &'a StyleSheet<'a>) -> Self {
        Self {
            rules,
            dashes: text.contains(DASHES),
            on_page: text.contains(ON_PAGE),
            marked: marked(doc, rules),
            anchors: anchors(doc, rules),
            solid: 0,
        }
    }

    /// The rewritten path of an element, if needed.
    fn path(&self, node: Node<'_, '_>) -> Option<Edit> {
        let is_marked = self.marked.get(node.id().get_usize()) == Some(&true);
        let freed = || freed(node);
        (is_marked && node.tag_name().name() == "path")
            .then(freed)
            .flatten()
    }

    fn additions(&mut self, node: Node<'_, '_>) -> Additions {
        let mut added = Additions::default();
        let anchor = self.anchors.get(node.id().get_usize()).copied();
        if let Some(anchor) = anchor.flatten() {
            added.declaration("text-anchor", anchor);
        }
        if self.on_page && property_of(self.rules, node, "vector-effect") == Some(ON_PAGE) {
            added.declaration("stroke-miterlimit", &SCREEN_LINE.to_string());
        }
        if !self.dashes {
            return added;
        }
        let is_dashed = node.has_attribute(DASHES) || value_of(self.rules, node, DASHES).is_some();
        if node.has_attribute("pathLength") && is_dashed {
            added.declaration(DASHES, "none");
            self.solid += 1;
        }
        added
    }
}

/// The elements with their own or inherited markers, by number; empty if there are none.
fn marked(doc: &Document<'_>, rules: &StyleSheet<'_>) -> Vec<bool> {
    let is_marker = |node: Node<'_, '_>| node.tag_name().name() == "marker";
    if !doc.descendants().any(is_marker) {
        return Vec::new();
    }
    let markers = Declared::of(rules, |name, _| name.starts_with("marker"));
    let mut marked = vec![false; doc.descendants().count()];
    for node in doc.descendants().filter(Node::is_element) {
        let mut own = node.attributes();
        let own = own.any(|value| value.name().starts_with("marker")) || markers.of_element(node);
        let outer = node
            .parent()
            .is_some_and(|parent| marked[parent.id().get_usize()]);
        marked[node.id().get_usize()] = own || outer;
    }
    marked
}

/// Rewrites an attribute for the library. A missing filter would hide its element.
fn readable(
    attribute: Attribute<'_, '_>,
    variables: &Variables<'_>,
    ids: &HashSet<&str>,
) -> Option<Edit> {
    let value = attribute.value();
    let is_missing =
        attribute.name() == "filter" && linked(value).is_some_and(|linked| !ids.contains(linked));
    let words = if is_missing {
        Cow::Owned("none".to_owned())
    } else if attribute.name() == "font-family" {
        replaced(variables.readable(value), quoted_families)
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

/// A length without surrounding blanks, which the library rejects.
fn trimmed(node: Node<'_, '_>, attribute: Attribute<'_, '_>) -> Option<Edit> {
    let (name, value) = (attribute.name(), attribute.value());
    let has_blanks = value.trim() != value && Length::from_str(value.trim()).is_ok();
    (has_blanks && is_length(node.tag_name().name(), name)).then(|| Edit {
        range: attribute.range_value(),
        words: escaped(value.trim()),
    })
}

/// The element of this file that `url(#name)` refers to.
fn linked(value: &str) -> Option<&str> {
    let inner = value.trim().strip_prefix("url(")?.strip_suffix(')')?;
    inner.trim_matches(['"', '\'', ' ']).strip_prefix('#')
}

const ON_PAGE: &str = "non-scaling-stroke";
const DASHES: &str = "stroke-dasharray";
/// Attributes without CSS: names, and long values.
const PLAIN: [&str; 6] = ["id", "class", "href", "d", "points", "transform"];
