//! Limits on references: a small file can describe a huge drawing, or a recursive one.

use std::collections::HashMap;

use usvg::roxmltree::{Attribute, Document, Node};

use crate::error::SvgError;

/// Refuses a document that becomes too large or too deep when every reference is replaced by a
/// copy, and one with recursive references. Returns the number of elements.
pub(crate) fn check(doc: &Document<'_>, segments: &[u64]) -> Result<u64, SvgError> {
    let mut counter = Counter {
        doc,
        segments,
        named: named(doc),
        known: vec![CostState::No; segments.len()],
    };
    let cost = counter.cost(doc.root_element(), 0)?;
    if cost.elements > MAX_ELEMENTS {
        let limit = MAX_ELEMENTS;
        return Err(SvgError::TooManyElements { limit });
    }
    if cost.elements.saturating_add(cost.groups) > MAX_WITH_GROUPS {
        let limit = MAX_WITH_GROUPS;
        return Err(SvgError::TooManyGroups { limit });
    }
    if cost.segments > MAX_COPIED_SEGMENTS {
        let limit = MAX_COPIED_SEGMENTS;
        return Err(SvgError::TooManyCorners { limit });
    }
    Ok(cost.elements)
}

/// The attributes by which an element would be drawn inside itself.
pub(super) fn circular_references<'a>(
    doc: &'a Document<'a>,
) -> Vec<(Node<'a, 'a>, Attribute<'a, 'a>)> {
    let mut search = CircleSearch {
        named: named(doc),
        states: vec![SearchState::New; doc.descendants().count()],
        found: Vec::new(),
    };
    search.visit(doc.root_element(), 0);
    search.found
}

struct CircleSearch<'a> {
    named: HashMap<&'a str, Node<'a, 'a>>,
    /// By element number in the document.
    states: Vec<SearchState>,
    found: Vec<(Node<'a, 'a>, Attribute<'a, 'a>)>,
}

#[derive(Clone, Copy, PartialEq)]
enum SearchState {
    New,
    /// Its content is being visited.
    Open,
    Done,
}

impl<'a> CircleSearch<'a> {
    /// Visits an element and what it draws. What is too deep is refused later.
    fn visit(&mut self, node: Node<'a, 'a>, depth: u32) {
        let number = node.id().get_usize();
        if self.states[number] != SearchState::New || depth > MAX_DEPTH {
            return;
        }
        self.states[number] = SearchState::Open;
        for child in node.children().filter(Node::is_element) {
            self.visit(child, depth + 1);
        }
        for (attribute, name) in references(node) {
            let Some(&target) = self.named.get(name) else {
                continue;
            };
            if self.states[target.id().get_usize()] == SearchState::Open {
                self.found.push((node, attribute));
            } else {
                self.visit(target, depth + 1);
            }
        }
        self.states[number] = SearchState::Done;
    }
}

/// The elements by name. Of those with the same name, the first counts.
fn named<'a>(doc: &'a Document<'a>) -> HashMap<&'a str, Node<'a, 'a>> {
    let nodes = doc.descendants().rev();
    nodes
        .filter_map(|node| Some((node.attribute("id")?, node)))
        .collect()
}

#[derive(Clone, Copy, Default)]
struct Cost {
    elements: u64,
    /// The number of elements that become a group.
    groups: u64,
    segments: u64,
    /// The number of element levels.
    height: u32,
}

impl Cost {
    fn add(&mut self, inner: Self, times: u64) {
        self.elements = self
            .elements
            .saturating_add(inner.elements.saturating_mul(times));
        self.groups = self
            .groups
            .saturating_add(inner.groups.saturating_mul(times));
        self.segments = self
            .segments
            .saturating_add(inner.segments.saturating_mul(times));
        self.height = self.height.max(inner.height + 1);
    }
}

struct Counter<'a> {
    doc: &'a Document<'a>,
    segments: &'a [u64],
    named: HashMap<&'a str, Node<'a, 'a>>,
    /// By element number in the document.
    known: Vec<CostState>,
}

#[derive(Clone, Copy)]
enum CostState {
    No,
    /// The cost is being computed.
    Soon,
    Yes(Cost),
}

impl<'a> Counter<'a> {
    /// The cost of an element including its content and references. Stops at the largest depth.
    fn cost(&mut self, node: Node<'a, 'a>, depth: u32) -> Result<Cost, SvgError> {
        let cost = match self.known[node.id().get_usize()] {
            CostState::Yes(cost) => cost,
            CostState::Soon => return Err(self.recursive(node)),
            CostState::No if depth > MAX_DEPTH => return Err(self.too_deep(node)),
            CostState::No => self.count(node, depth)?,
        };
        if depth + cost.height > MAX_DEPTH {
            return Err(self.too_deep(node));
        }
        Ok(cost)
    }

    fn count(&mut self, node: Node<'a, 'a>, depth: u32) -> Result<Cost, SvgError> {
        let number = node.id().get_usize();
        self.known[number] = CostState::Soon;
        let mut cost = Cost {
            elements: 1,
            groups: u64::from(is_group(node)),
            segments: self.segments[number],
            height: 0,
        };
        for child in node.children().filter(Node::is_element) {
            cost.add(self.cost(child, depth + 1)?, 1);
        }
        for (attribute, name) in references(node) {
            if let Some(&target) = self.named.get(name) {
                // A marker is drawn on every corner.
                let is_marker = attribute.name().starts_with("marker");
                let times = if is_marker { cost.segments + 1 } else { 1 };
                cost.add(self.cost(target, depth + 1)?, times);
            }
        }
        self.known[number] = CostState::Yes(cost);
        Ok(cost)
    }

    fn recursive(&self, node: Node<'_, '_>) -> SvgError {
        SvgError::Recursive {
            place: self.doc.text_pos_at(node.range().start).into(),
            element: node.tag_name().name().to_owned(),
        }
    }

    fn too_deep(&self, node: Node<'_, '_>) -> SvgError {
        SvgError::TooDeep {
            place: self.doc.text_pos_at(node.range().start).into(),
            limit: MAX_DEPTH,
        }
    }
}

/// Whether an attribute of an element applies to its content as a group.
fn is_group(node: Node<'_, '_>) -> bool {
    let mut attributes = node.attributes();
    attributes.any(|attribute| match attribute.name() {
        "opacity" => attribute.value() != "1",
        "transform" | "clip-path" | "mask" | "filter" => attribute.value() != "none",
        _ => false,
    })
}

/// The names that an element refers to, with their attributes.
fn references<'a>(node: Node<'a, 'a>) -> impl Iterator<Item = (Attribute<'a, 'a>, &'a str)> {
    // A link does not draw its target.
    let draws = !matches!(node.tag_name().name(), "a" | "animate" | "set" | "mpath");
    node.attributes().flat_map(move |attribute| {
        let (name, value) = (attribute.name(), attribute.value());
        let href = value.strip_prefix('#').filter(|_| draws && name == "href");
        let urls = value.split("url(").skip(1).filter_map(|rest| {
            let inner = rest.split(')').next()?.trim().trim_matches(['"', '\'']);
            inner.strip_prefix('#')
        });
        href.into_iter()
            .chain(urls)
            .map(move |target| (attribute, target))
    })
}

/// Far above any drawing, far below the limit of the stack.
const MAX_DEPTH: u32 = 100;
pub(super) const MAX_ELEMENTS: u64 = if cfg!(test) { 20_000 } else { 150_000 };
/// A group takes nearly as much memory as a shape.
const MAX_WITH_GROUPS: u64 = if cfg!(test) { 25_000 } else { 190_000 };
const MAX_COPIED_SEGMENTS: u64 = 4_000_000;
