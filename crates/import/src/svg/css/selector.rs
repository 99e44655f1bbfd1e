//! The elements of a file, for the matching of selectors.

use std::borrow::Borrow;
use std::cell::Cell;
use std::fmt;

use cssparser::{ParseError, Parser as CssParser, ToCss, serialize_identifier};
use dobot_geometry::CancelToken;
use precomputed_hash::PrecomputedHash;
use selectors::attr::{AttrSelectorOperation, CaseSensitivity, NamespaceConstraint};
use selectors::bloom::BloomFilter;
use selectors::matching::{ElementSelectorFlags, MatchingContext};
use selectors::parser::{NonTSPseudoClass, Parser, SelectorImpl, SelectorParseErrorKind};
use selectors::{Element, OpaqueElement};
use usvg::roxmltree::Node;

/// The kinds of names in selectors, as the library for selectors needs them.
#[derive(Clone, Debug)]
pub(super) struct SvgSelectors;

/// A name or a value in a selector.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Name(String);

impl From<&str> for Name {
    fn from(text: &str) -> Self {
        Self(text.to_owned())
    }
}

impl Borrow<str> for Name {
    fn borrow(&self) -> &str {
        &self.0
    }
}

impl AsRef<str> for Name {
    fn as_ref(&self) -> &str {
        &self.0
    }
}

impl PrecomputedHash for Name {
    /// No hash is needed: the rules are found by their names.
    fn precomputed_hash(&self) -> u32 {
        0
    }
}

impl ToCss for Name {
    fn to_css<W: fmt::Write>(&self, dest: &mut W) -> fmt::Result {
        serialize_identifier(&self.0, dest)
    }
}

/// A pseudo-class or a pseudo-element, by its name in lower case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Pseudo(String);

impl ToCss for Pseudo {
    fn to_css<W: fmt::Write>(&self, dest: &mut W) -> fmt::Result {
        serialize_identifier(&self.0, dest)
    }
}

impl NonTSPseudoClass for Pseudo {
    fn is_active_or_hover(&self) -> bool {
        matches!(self.0.as_str(), "active" | "hover")
    }

    fn is_user_action_state(&self) -> bool {
        self.is_active_or_hover() || self.0.starts_with("focus")
    }
}

impl selectors::parser::PseudoElement for Pseudo {}

impl SelectorImpl for SvgSelectors {
    type ExtraMatchingData<'a> = ();
    type AttrValue = Name;
    type Identifier = Name;
    type LocalName = Name;
    type NamespaceUrl = Name;
    type NamespacePrefix = Name;
    type BorrowedNamespaceUrl = str;
    type BorrowedLocalName = str;
    type NonTSPseudoClass = Pseudo;
    type PseudoElement = Pseudo;
}

/// The parser of selectors, with the namespaces of its sheet: a prefix, empty for the default one,
/// and an address.
#[derive(Clone, Debug, Default)]
pub(super) struct SelectorParser {
    pub(super) namespaces: Vec<(String, String)>,
}

impl SelectorParser {
    fn namespace(&self, prefix: &str) -> Option<Name> {
        let mut namespaces = self.namespaces.iter().rev();
        let found = namespaces.find(|namespace| namespace.0 == prefix)?;
        Some(Name(found.1.clone()))
    }
}

impl<'i> Parser<'i> for SelectorParser {
    type Impl = SvgSelectors;
    type Error = SelectorParseErrorKind;

    fn parse_nth_child_of(&self) -> bool {
        true
    }

    fn parse_is_and_where(&self) -> bool {
        true
    }

    fn parse_has(&self) -> bool {
        true
    }

    fn parse_parent_selector(&self) -> bool {
        true
    }

    fn parse_non_ts_pseudo_class(
        &self,
        name: &str,
    ) -> Result<Pseudo, ParseError<SelectorParseErrorKind>> {
        known(name, &PSEUDO_CLASSES)
    }

    fn parse_non_ts_functional_pseudo_class(
        &self,
        name: &str,
        parser: &mut CssParser<'i>,
        _after_part: bool,
    ) -> Result<Pseudo, ParseError<SelectorParseErrorKind>> {
        while parser.next().is_ok() {}
        known(name, &["dir", "lang"])
    }

    fn parse_pseudo_element(
        &self,
        name: &str,
    ) -> Result<Pseudo, ParseError<SelectorParseErrorKind>> {
        known(name, &PSEUDO_ELEMENTS)
    }

    fn default_namespace(&self) -> Option<Name> {
        self.namespace("")
    }

    fn namespace_for_prefix(&self, prefix: &Name) -> Option<Name> {
        self.namespace(&prefix.0)
    }
}

fn known(name: &str, names: &[&str]) -> Result<Pseudo, ParseError<SelectorParseErrorKind>> {
    let name = name.to_ascii_lowercase();
    if names.contains(&name.as_str()) {
        return Ok(Pseudo(name));
    }
    let problem = SelectorParseErrorKind::UnsupportedPseudoClassOrElement;
    Err(ParseError::custom(problem))
}

/// An element, and the number of steps from element to element that matching may still take.
#[derive(Clone, Copy, Debug)]
pub(super) struct SvgElement<'a, 'input> {
    pub(super) node: Node<'a, 'input>,
    pub(super) cancel: &'a CancelToken,
    pub(super) steps_left: &'a Cell<u64>,
    /// One byte for each node, whose address identifies it.
    pub(super) identities: &'a [u8],
}

impl<'a, 'input> SvgElement<'a, 'input> {
    /// The number of steps left after one more; `None` if none is left, or if reading was cancelled.
    pub(super) fn spend_step(&self) -> Option<u64> {
        let left = self.steps_left.get().checked_sub(1);
        let left = left.filter(|_| !self.cancel.is_cancelled());
        self.steps_left.set(left.unwrap_or_default());
        left
    }

    /// Another element, unless no step is left.
    fn step(&self, to: Option<Node<'a, 'input>>) -> Option<Self> {
        self.spend_step()?;
        Some(Self { node: to?, ..*self })
    }
}

impl Element for SvgElement<'_, '_> {
    type Impl = SvgSelectors;

    fn opaque(&self) -> OpaqueElement {
        OpaqueElement::new(&self.identities[self.node.id().get_usize()])
    }

    fn parent_element(&self) -> Option<Self> {
        self.step(self.node.parent_element())
    }

    fn parent_node_is_shadow_root(&self) -> bool {
        false
    }

    fn containing_shadow_host(&self) -> Option<Self> {
        None
    }

    fn is_pseudo_element(&self) -> bool {
        false
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.step(self.node.prev_sibling_element())
    }

    fn next_sibling_element(&self) -> Option<Self> {
        self.step(self.node.next_sibling_element())
    }

    fn first_element_child(&self) -> Option<Self> {
        self.step(self.node.first_element_child())
    }

    fn is_html_element_in_html_document(&self) -> bool {
        false
    }

    fn has_local_name(&self, local_name: &str) -> bool {
        self.node.tag_name().name() == local_name
    }

    fn has_namespace(&self, ns: &str) -> bool {
        self.node.tag_name().namespace().unwrap_or_default() == ns
    }

    fn is_same_type(&self, other: &Self) -> bool {
        self.node.tag_name() == other.node.tag_name()
    }

    fn attr_matches(
        &self,
        ns: &NamespaceConstraint<&Name>,
        local_name: &Name,
        operation: &AttrSelectorOperation<&Name>,
    ) -> bool {
        self.node.attributes().any(|attribute| {
            let is_in_namespace = match ns {
                NamespaceConstraint::Any => true,
                NamespaceConstraint::Specific(url) => {
                    attribute.namespace().unwrap_or_default() == url.0
                }
            };
            let is_meant = is_in_namespace && attribute.name() == local_name.0;
            is_meant && operation.eval_str(attribute.value())
        })
    }

    /// No link was visited, and no element is pointed at.
    fn match_non_ts_pseudo_class(
        &self,
        class: &Pseudo,
        _context: &mut MatchingContext<SvgSelectors>,
    ) -> bool {
        match class.0.as_str() {
            "any-link" | "link" => self.is_link(),
            "defined" => true,
            _ => false,
        }
    }

    fn match_pseudo_element(
        &self,
        _element: &Pseudo,
        _context: &mut MatchingContext<SvgSelectors>,
    ) -> bool {
        false
    }

    fn apply_selector_flags(&self, _flags: ElementSelectorFlags) {}

    fn is_link(&self) -> bool {
        let mut attributes = self.node.attributes();
        self.has_local_name("a") && attributes.any(|attribute| attribute.name() == "href")
    }

    fn is_html_slot_element(&self) -> bool {
        false
    }

    fn has_id(&self, id: &Name, case_sensitivity: CaseSensitivity) -> bool {
        let own = self.node.attribute("id");
        own.is_some_and(|own| case_sensitivity.eq(own.as_bytes(), id.0.as_bytes()))
    }

    fn has_class(&self, name: &Name, case_sensitivity: CaseSensitivity) -> bool {
        let mut classes = classes(self.node);
        classes.any(|class| case_sensitivity.eq(class.as_bytes(), name.0.as_bytes()))
    }

    fn has_custom_state(&self, _name: &Name) -> bool {
        false
    }

    fn imported_part(&self, _name: &Name) -> Option<Name> {
        None
    }

    fn is_part(&self, _name: &Name) -> bool {
        false
    }

    fn is_empty(&self) -> bool {
        let mut children = self.node.children();
        children.all(|child| !child.is_element() && child.text().unwrap_or_default().is_empty())
    }

    fn is_root(&self) -> bool {
        self.node == self.node.document().root_element()
    }

    fn add_element_unique_hashes(&self, _filter: &mut BloomFilter) -> bool {
        false
    }
}

/// The classes of an element.
pub(super) fn classes<'a>(node: Node<'a, '_>) -> impl Iterator<Item = &'a str> {
    let classes = node.attribute("class").unwrap_or_default();
    classes.split_ascii_whitespace()
}

const PSEUDO_CLASSES: [&str; 20] = [
    "active",
    "any-link",
    "autofill",
    "checked",
    "default",
    "defined",
    "disabled",
    "enabled",
    "focus",
    "focus-visible",
    "focus-within",
    "fullscreen",
    "hover",
    "invalid",
    "link",
    "optional",
    "target",
    "target-within",
    "valid",
    "visited",
];
const PSEUDO_ELEMENTS: [&str; 8] = [
    "after",
    "backdrop",
    "before",
    "first-letter",
    "first-line",
    "marker",
    "placeholder",
    "selection",
];
