//! Styles (CSS) as a browser applies them on a light screen: the value of each property on each
//! element.
//!
//! The libraries `cssparser` and `selectors` read sheets and match elements. `lightningcss` does
//! not match elements, and takes much longer to build.

mod color;
mod declaration;
mod family;
mod length;
mod media;
mod property;
mod selector;
mod sheet;
mod value;
mod variables;

use std::borrow::Cow;
use std::cell::Cell;
use std::cmp::Reverse;
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use cssparser::Parser;
use dobot_geometry::CancelToken;
use selectors::context::{
    MatchingContext, MatchingForInvalidation, MatchingMode, NeedsSelectorFlags, QuirksMode,
    SelectorCaches,
};
use selectors::matching::matches_selector;
use selectors::parser::{Component, Selector};
use usvg::roxmltree::{Document, Node};

use self::declaration::{Content, Declaration, declarations, longhands, values};
use self::property::Property;
use self::selector::{SvgElement, SvgSelectors, classes};
use self::sheet::Sheets;
use self::variables::{BytesLeft, Variables, replaced};
use crate::error::SvgError;

/// The values of the properties of all elements.
#[derive(Debug, Default)]
pub(super) struct Styles<'a> {
    /// Those that styles set, by node number: name and value.
    set: Vec<Vec<(&'static str, Cow<'a, str>)>>,
    /// The ignored rules.
    pub(super) ignored_rules: Found,
    /// The ignored values.
    pub(super) ignored_values: Found,
    /// The style sheets in other files.
    pub(super) external: Found,
}

/// A number of occurrences in a file, and the position of the first, in bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Found {
    pub(super) count: usize,
    pub(super) first: Option<usize>,
}

impl Found {
    pub(super) fn add(&mut self, count: usize, at: usize) {
        self.count += count;
        if count > 0 {
            self.first = Some(self.first.map_or(at, |first| first.min(at)));
        }
    }

    pub(super) fn plus(mut self, other: Self) -> Self {
        self.add(other.count, other.first.unwrap_or_default());
        self
    }
}

/// The text of a style sheet, and its position in the file, in bytes.
#[derive(Debug)]
pub(super) struct SheetText {
    at: usize,
    css: String,
}

/// The texts of all sheets that apply to a light screen.
pub(super) fn sheet_texts(doc: &Document<'_>) -> Vec<SheetText> {
    let applies = |sheet: &Node<'_, '_>| {
        let kind = sheet.attribute("type").unwrap_or_default().trim();
        let media = sheet.attribute("media").unwrap_or_default();
        let is_css = kind.is_empty() || kind.eq_ignore_ascii_case("text/css");
        is_css && media::is_shown(&mut Parser::new(media))
    };
    let text = |sheet: Node<'_, '_>| {
        let texts = sheet.children().filter_map(|child| child.text());
        SheetText {
            at: sheet.range().start,
            css: texts.collect(),
        }
    };
    sheets(doc).filter(applies).map(text).collect()
}

/// All sheets of a document.
pub(super) fn sheets<'a, 'input>(
    doc: &'a Document<'input>,
) -> impl Iterator<Item = Node<'a, 'input>> {
    let all = doc.descendants();
    all.filter(|item| item.is_element() && item.tag_name().name() == "style")
}

impl<'a> Styles<'a> {
    /// Computes the values of all elements.
    pub(super) fn of(
        doc: &'a Document<'_>,
        texts: &'a [SheetText],
        cancel: &CancelToken,
    ) -> Result<Self, SvgError> {
        let mut sheets = Sheets::new(cancel);
        for text in texts {
            sheets.add(text.at, &text.css)?;
        }
        let cascade = Cascade::new(doc, &sheets, cancel);
        let mut styles = Self {
            set: vec![Vec::new(); doc.descendants().count()],
            ignored_rules: sheets.ignored_rules,
            ignored_values: sheets.ignored_values,
            external: sheets.external,
        };
        let mut caches = SelectorCaches::default();
        let mut variables: HashMap<usize, Rc<Variables<'a>>> = HashMap::new();
        for node in doc.descendants().filter(Node::is_element) {
            cancel.check()?;
            let number = node.id().get_usize();
            let own = node.attribute("style").unwrap_or_default();
            let (own, ignored) = declarations(own);
            let place = node
                .attribute_node("style")
                .map(|style| style.range().start);
            styles
                .ignored_values
                .add(ignored, place.unwrap_or_default());
            let attributes = attributes_with_variables(node);
            let declared = cascade.declared(node, &attributes, &own, &mut caches);
            let outer = node.parent().map(|parent| parent.id().get_usize());
            let outer = outer.and_then(|outer| variables.get(&outer)).cloned();
            let known = known_variables(outer, &declared);
            styles.set[number] = cascade.values(node, &declared, known.as_deref());
            if let Some(known) = known {
                variables.insert(number, known);
            }
        }
        cancel.check()?;
        if cascade.steps_left.get() == 0 {
            return Err(SvgError::LongStyles);
        }
        Ok(styles)
    }

    /// The values that styles set on an element, by name.
    pub(super) fn set(&self, node: Node<'_, '_>) -> &[(&'static str, Cow<'a, str>)] {
        &self.set[node.id().get_usize()]
    }

    /// The value that a style sets.
    pub(super) fn value(&self, node: Node<'_, '_>, name: &str) -> Option<&str> {
        let values = self.set.get(node.id().get_usize())?;
        let found = values.iter().find(|value| value.0 == name)?;
        Some(&found.1)
    }

    /// The value of a property by the styles, or else by its attribute.
    pub(super) fn property<'n: 's, 's>(
        &'s self,
        node: Node<'n, '_>,
        name: &str,
    ) -> Option<&'s str> {
        self.value(node, name)
            .or_else(|| node.attribute(name))
            .map(str::trim)
    }

    /// The value of a property on each element, by node number: its own, or else the inherited one.
    pub(super) fn inherited<'s>(
        &'s self,
        doc: &'s Document<'_>,
        name: &str,
    ) -> Vec<Option<&'s str>> {
        let mut values = vec![None; doc.descendants().count()];
        for node in doc.descendants().filter(Node::is_element) {
            let own = self
                .property(node, name)
                .filter(|value| *value != "inherit");
            let outer = node
                .parent()
                .and_then(|parent| values[parent.id().get_usize()]);
            values[node.id().get_usize()] = own.or(outer);
        }
        values
    }
}

/// The value of an attribute in the words of the library, if it is a property written in those of
/// CSS; `Err` if a browser ignores it.
pub(super) fn presentation<'v>(name: &str, value: &'v str) -> Result<Cow<'v, str>, ()> {
    match Property::of(name).filter(|property| property.name == name && property.is_presentation())
    {
        Some(property) if !variables::has_variables(value) => property.value(value).ok_or(()),
        _ => Ok(Cow::Borrowed(value)),
    }
}

/// The attributes of an element with custom properties in their values.
fn attributes_with_variables<'a>(node: Node<'a, '_>) -> Vec<Declaration<'a>> {
    let attributes = node.attributes().filter(|attribute| {
        let property = Property::of(attribute.name());
        property.is_some_and(Property::is_presentation)
            && variables::has_variables(attribute.value())
    });
    let pending = attributes.map(|attribute| Declaration {
        content: Content::Pending {
            name: attribute.name().to_owned(),
            value: attribute.value(),
        },
        is_important: false,
    });
    pending.collect()
}

/// A declaration that applies to an element, with its precedence.
type Applied<'d, 'a> = (Precedence, &'d Declaration<'a>);

/// What decides between declarations: importance, the style of the element itself, the layer, the
/// specificity of the selector, and the order.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Precedence {
    is_important: bool,
    is_own: bool,
    layer: LayerRank,
    specificity: u32,
    order: usize,
}

/// The rank of a layer, which is the other way round for important declarations.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum LayerRank {
    Usual(Rc<[usize]>),
    Important(Reverse<Rc<[usize]>>),
}

/// The rules of all sheets, found by what they select.
struct Cascade<'s, 'a> {
    selectors: Vec<(&'s Selector<SvgSelectors>, usize)>,
    /// The numbers of the selectors for an id, a class or a name of elements; `None` for any.
    by_key: HashMap<Option<Key<'s>>, Vec<usize>>,
    sheets: &'s Sheets<'a>,
    ranks: Vec<Rc<[usize]>>,
    cancel: &'s CancelToken,
    steps_left: Cell<u64>,
    bytes_left: BytesLeft,
    identities: Vec<u8>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Key<'s> {
    Id(&'s str),
    Class(&'s str),
    Element(&'s str),
}

impl<'s, 'a> Cascade<'s, 'a> {
    fn new(doc: &Document<'_>, sheets: &'s Sheets<'a>, cancel: &'s CancelToken) -> Self {
        let mut selectors = Vec::new();
        let mut by_key: HashMap<_, Vec<usize>> = HashMap::new();
        for (number, rule) in sheets.rules.iter().enumerate() {
            for selector in rule.selectors.slice() {
                by_key
                    .entry(key(selector))
                    .or_default()
                    .push(selectors.len());
                selectors.push((selector, number));
            }
        }
        Self {
            selectors,
            by_key,
            sheets,
            ranks: sheets
                .rules
                .iter()
                .map(|rule| sheets.rank(rule).into())
                .collect(),
            cancel,
            steps_left: Cell::new(MAX_STEPS),
            bytes_left: BytesLeft::default(),
            identities: vec![0; doc.descendants().count()],
        }
    }

    /// The declarations that apply to an element, the weakest first.
    fn declared<'d>(
        &'d self,
        node: Node<'_, '_>,
        attributes: &'d [Declaration<'a>],
        own: &'d [Declaration<'a>],
        caches: &mut SelectorCaches,
    ) -> Vec<Applied<'d, 'a>> {
        let weakest: Rc<[usize]> = Rc::new([]);
        let weakest = |declaration| {
            (
                precedence(declaration, Rc::clone(&weakest), 0, 0),
                declaration,
            )
        };
        let mut declared: Vec<Applied<'d, 'a>> = attributes.iter().map(weakest).collect();
        for (specificity, rule) in self.matching(node, caches) {
            for declaration in &*self.sheets.rules[rule].declarations {
                let rank = Rc::clone(&self.ranks[rule]);
                declared.push((
                    precedence(declaration, rank, specificity, rule),
                    declaration,
                ));
            }
        }
        let outside: Rc<[usize]> = Rc::new([usize::MAX]);
        for (order, declaration) in own.iter().enumerate() {
            let precedence = Precedence {
                is_own: true,
                ..precedence(declaration, Rc::clone(&outside), 0, order)
            };
            declared.push((precedence, declaration));
        }
        // Declarations of a rule keep their order.
        declared.sort_by(|a, b| a.0.cmp(&b.0));
        declared
    }

    /// The rules that select an element, with the specificity of the selector.
    fn matching(&self, node: Node<'_, '_>, caches: &mut SelectorCaches) -> Vec<(u32, usize)> {
        if self.selectors.is_empty() {
            return Vec::new();
        }
        let keys = [
            node.attribute("id").map(Key::Id),
            Some(Key::Element(node.tag_name().name())),
        ];
        let keys = keys
            .into_iter()
            .flatten()
            .chain(classes(node).map(Key::Class));
        let keys = keys.map(Some).chain([None]);
        let element = SvgElement {
            node,
            cancel: self.cancel,
            steps_left: &self.steps_left,
            identities: &self.identities,
        };
        let mut matching = Vec::new();
        for number in keys.filter_map(|key| self.by_key.get(&key)).flatten() {
            let left = element.spend_step().unwrap_or_default();
            let (selector, rule) = self.selectors[*number];
            let mut context = MatchingContext::new(
                MatchingMode::Normal,
                None,
                caches,
                QuirksMode::NoQuirks,
                NeedsSelectorFlags::No,
                MatchingForInvalidation::No,
            );
            if left > 0 && matches_selector(selector, 0, None, element, &mut context) {
                matching.push((selector.specificity(), rule));
            }
        }
        matching
    }

    /// The values that win, by name.
    fn values(
        &self,
        node: Node<'_, '_>,
        declared: &[Applied<'_, 'a>],
        variables: Option<&Variables<'a>>,
    ) -> Vec<(&'static str, Cow<'a, str>)> {
        let none = Variables::new();
        let mut winners: BTreeMap<&'static str, Cow<'a, str>> = BTreeMap::new();
        let element = node.tag_name().name();
        for (_, declaration) in declared {
            match &declaration.content {
                Content::Value(property, value) if property.is_of(element) => {
                    winners.insert(property.name, value.clone());
                }
                Content::Value(..) | Content::Custom { .. } => {}
                Content::Pending { name, value } => {
                    let known = variables.unwrap_or(&none);
                    let text = replaced(value, known, &self.bytes_left);
                    let found = text.as_deref().and_then(|text| values(name, text));
                    let found = found.unwrap_or_else(|| unset(name));
                    let found = found.into_iter().filter(|value| value.0.is_of(element));
                    winners.extend(
                        found.map(|(property, value)| {
                            (property.name, Cow::Owned(value.into_owned()))
                        }),
                    );
                }
            }
        }
        winners.into_iter().collect()
    }
}

fn precedence(
    declaration: &Declaration<'_>,
    rank: Rc<[usize]>,
    specificity: u32,
    order: usize,
) -> Precedence {
    let is_important = declaration.is_important;
    Precedence {
        is_important,
        is_own: false,
        layer: if is_important {
            LayerRank::Important(Reverse(rank))
        } else {
            LayerRank::Usual(rank)
        },
        specificity,
        order,
    }
}

/// The values of properties whose declaration has an invalid custom property.
fn unset(name: &str) -> declaration::Values<'static> {
    let names = longhands(name);
    let properties = names.iter().filter_map(|name| Property::of(name));
    properties
        .map(|property| (property, property.unset().into()))
        .collect()
}

/// The custom properties of an element: its own ones and the inherited ones.
fn known_variables<'a>(
    outer: Option<Rc<Variables<'a>>>,
    declared: &[Applied<'_, 'a>],
) -> Option<Rc<Variables<'a>>> {
    let mut known = outer;
    for (_, declaration) in declared {
        if let Content::Custom { name, value } = &declaration.content {
            let all = Rc::make_mut(known.get_or_insert_default());
            all.insert(name.clone(), value);
        }
    }
    known
}

/// What an element needs to be selected.
fn key(selector: &Selector<SvgSelectors>) -> Option<Key<'_>> {
    let mut found = None;
    for component in selector.iter() {
        match component {
            Component::ID(id) => return Some(Key::Id(id.as_ref())),
            Component::Class(class) => found = Some(Key::Class(class.as_ref())),
            Component::LocalName(name) if found.is_none() => {
                found = Some(Key::Element(name.name.as_ref()));
            }
            _ => {}
        }
    }
    found
}

/// The number of steps from element to element, and of tests; this takes about a second.
const MAX_STEPS: u64 = if cfg!(test) { 1_000_000 } else { 50_000_000 };
