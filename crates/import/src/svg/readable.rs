//! Rewriting of a file for the library: styles become attributes, and what it would drop
//! needlessly is replaced.

use std::borrow::Cow;
use std::collections::HashSet;
use std::str::FromStr;

use dobot_geometry::{CancelToken, Cancelled};
use svgtypes::Length;
use usvg::roxmltree::{Attribute, Document, Node};

use super::SVG_NAMESPACE;
use super::check::is_length;
use super::css::{Found, Styles, presentation, sheets};
use super::edits::{Additions, Edit, edited, escaped};
use super::foreign_text::plain_text;
use super::handles::freed;
use super::ink::{PATH_DASHES, SCREEN_LINE, SCREEN_PATH_DASHES};
use super::layer_code::{LayerCode, layer_code};
use super::letters::{anchors, undisplayed};
use super::page_size::PageSize;
use super::warning_count::WarningKind;

/// The rewritten parts of a file, and what is still unsupported.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Readable {
    /// The whole file, if anything changed.
    pub(super) text: Option<String>,
    /// What is reported, and where it is found first.
    pub(super) warnings: Vec<(WarningKind, Found)>,
}

impl Readable {
    /// Rewrites a file with these edits, and with others.
    pub(super) fn of(
        doc: &Document<'_>,
        text: &str,
        styles: &Styles<'_>,
        damaged: Vec<Edit>,
        cancel: &CancelToken,
    ) -> Result<Self, Cancelled> {
        let ids: HashSet<&str> = doc
            .descendants()
            .filter_map(|node| node.attribute("id"))
            .collect();
        let [missing_targets, linked] = copies(doc, &ids);
        let mut rewriter = Rewriter::of(doc, text, styles, ids);
        let PageSize {
            edits: of_page,
            added: of_root,
            unread: unread_sizes,
        } = PageSize::of(doc, styles);
        rewriter.edits.extend(of_page);
        rewriter.edits.extend(damaged);
        rewriter.edits.extend(undisplayed(doc, styles));
        let mut labels = Found::default();
        for sheet in sheets(doc) {
            rewriter
                .edits
                .extend(sheet.children().map(|child| removed(child.range())));
        }
        for node in doc.descendants().filter(Node::is_element) {
            cancel.check()?;
            let label = plain_text(text, node, styles);
            labels.add(usize::from(label.is_some()), node.range().start);
            rewriter.edits.extend(label);
            let mut added = rewriter.element(node);
            if node == doc.root_element() {
                added.append(&of_root);
            }
            rewriter.edits.extend(added.edit(text, node));
        }
        let counts = [
            (WarningKind::IgnoredRule, styles.ignored_rules),
            (
                WarningKind::IgnoredValue,
                styles.ignored_values.plus(rewriter.ignored),
            ),
            (
                WarningKind::ExternalSheet,
                styles.external.plus(external_sheets(doc)),
            ),
            (WarningKind::UnreadSize, unread_sizes),
            (WarningKind::LinkedShape, linked),
            (WarningKind::MissingTarget, missing_targets),
            (WarningKind::MovedByStyle, rewriter.moved),
            (WarningKind::SolidPath, rewriter.solid),
            (WarningKind::PlainLabel, labels),
            (WarningKind::CommentLayer, rewriter.comment_layers),
            (WarningKind::LayerCodes, rewriter.layer_codes),
            (WarningKind::WidthZero, lines_of_width_0(doc, text, styles)),
        ];
        Ok(Self {
            text: (!rewriter.edits.is_empty()).then(|| edited(text, rewriter.edits)),
            warnings: counts
                .into_iter()
                .filter(|warning| warning.1.count > 0)
                .collect(),
        })
    }
}

/// Collects the edits by which the library draws elements like a browser.
struct Rewriter<'a> {
    styles: &'a Styles<'a>,
    ids: HashSet<&'a str>,
    edits: Vec<Edit>,
    /// Whether anything has dashes.
    has_dashes: bool,
    /// Whether any line keeps its width on the page, however it is scaled.
    on_page: bool,
    /// The own or inherited dashes and their offsets, by node number; empty if none are shares of a
    /// path.
    dashes: Vec<Option<&'a str>>,
    offsets: Vec<Option<&'a str>>,
    /// The elements with markers, by node number; empty if there are none.
    marked: Vec<bool>,
    /// The new anchors of texts, by node number; empty if unchanged.
    anchors: Vec<Option<&'static str>>,
    /// The number of lines made solid.
    solid: Found,
    /// The number of ignored values of attributes.
    ignored: Found,
    /// The number of layers that `AxiDraw` does not draw, and of those with codes that are not read.
    comment_layers: Found,
    layer_codes: Found,
    /// The number of elements that turn around a place in their own box.
    moved: Found,
}

impl<'a> Rewriter<'a> {
    fn of(
        doc: &'a Document<'_>,
        text: &str,
        styles: &'a Styles<'a>,
        ids: HashSet<&'a str>,
    ) -> Self {
        let has_shares = text.contains(DASHES) && text.contains("pathLength");
        let inherited = |name| {
            if has_shares {
                styles.inherited(doc, name)
            } else {
                Vec::new()
            }
        };
        Self {
            styles,
            ids,
            edits: Vec::new(),
            has_dashes: text.contains(DASHES),
            on_page: text.contains(ON_PAGE),
            dashes: inherited(DASHES),
            offsets: inherited("stroke-dashoffset"),
            marked: marked(doc, styles),
            anchors: anchors(doc, styles),
            solid: Found::default(),
            ignored: Found::default(),
            comment_layers: Found::default(),
            layer_codes: Found::default(),
            moved: Found::default(),
        }
    }

    /// Rewrites the attributes of an element, and returns its additional ones.
    fn element(&mut self, node: Node<'_, '_>) -> Additions {
        let mut set = self.values(node);
        for attribute in node.attributes() {
            if attribute.namespace().is_some() {
                continue;
            }
            let value = set.iter().position(|value| value.0 == attribute.name());
            let value = value.map(|place| set.swap_remove(place).1);
            let edit = self.attribute(node, attribute, value);
            self.edits.extend(edit);
        }
        let is_marked = self.marked.get(node.id().get_usize()) == Some(&true);
        if is_marked && node.tag_name().name() == "path" {
            self.edits.extend(freed(node));
        }
        let mut added = Additions::default();
        set.sort_unstable_by_key(|value| value.0);
        for (name, value) in set {
            if IN_STYLES.contains(&name) {
                added.declaration(name, &value);
            } else {
                added.attribute(name, &value);
            }
        }
        added
    }

    /// The values that styles set, and those set here, by name.
    fn values(&mut self, node: Node<'_, '_>) -> Vec<(&'static str, Cow<'a, str>)> {
        let is_root = node.parent_element().is_none();
        let of_page = |name: &str| is_root && matches!(name, "width" | "height");
        let mut set = self.styles.set(node).to_vec();
        set.retain(|value| !TRANSFORMS.contains(&value.0) && !of_page(value.0));
        set.extend(self.transform(node).map(|value| ("transform", value)));
        let mut replace = |name, value| {
            set.retain(|set| set.0 != name);
            set.push((name, value));
        };
        match layer_code(node) {
            Some(LayerCode::Comment) => {
                self.comment_layers.add(1, node.range().start);
                replace("display", "none".into());
            }
            Some(LayerCode::Control(control)) => {
                let has_others = usize::from(control.has_others);
                self.layer_codes.add(has_others, node.range().start);
            }
            None => {}
        }
        let anchor = self.anchors.get(node.id().get_usize()).copied();
        if let Some(anchor) = anchor.flatten() {
            replace("text-anchor", anchor.into());
        }
        let is_on_page =
            self.on_page && self.styles.property(node, "vector-effect") == Some(ON_PAGE);
        let mut mark = is_on_page.then_some(SCREEN_LINE);
        if self.has_dashes {
            match self.path_dashes(node) {
                PathDashes::None => {}
                PathDashes::Solid => replace(DASHES, "none".into()),
                PathDashes::Unread => {
                    self.solid.add(1, node.range().start);
                    replace(DASHES, "none".into());
                }
                PathDashes::Shares { dashes, offset } => {
                    replace(DASHES, dashes.into());
                    replace("stroke-dashoffset", offset.into());
                    mark = Some(if is_on_page {
                        SCREEN_PATH_DASHES
                    } else {
                        PATH_DASHES
                    });
                }
            }
        }
        if let Some(mark) = mark {
            replace("stroke-miterlimit", mark.to_string().into());
        }
        let filter = self.styles.property(node, "filter");
        if filter.is_some_and(|filter| self.is_missing(filter)) {
            // A missing filter would hide its element.
            replace("filter", "none".into());
        }
        set
    }

    /// The dashes of an element with `pathLength`, as shares of its path.
    fn path_dashes(&self, node: Node<'_, '_>) -> PathDashes {
        let number = node.id().get_usize();
        let length = node
            .attribute("pathLength")
            .and_then(|length| length.trim().parse::<f64>().ok());
        let dashes = self.dashes.get(number).copied().flatten();
        let (Some(length), Some(dashes)) = (length, dashes.filter(|dashes| *dashes != "none"))
        else {
            return PathDashes::None;
        };
        // A length below 0 counts as none.
        if length < 0.0 {
            return PathDashes::None;
        }
        if length == 0.0 {
            return PathDashes::Solid;
        }
        let share = |text: &str| {
            let value = text
                .strip_suffix("px")
                .unwrap_or(text)
                .parse::<f64>()
                .ok()?;
            Some((value / length).to_string())
        };
        let dashes = dashes
            .split([' ', ','])
            .filter(|dash| !dash.is_empty())
            .map(share);
        let dashes: Option<Vec<String>> = dashes.collect();
        let offset = self.offsets.get(number).copied().flatten().unwrap_or("0");
        match (dashes, share(offset.trim())) {
            (Some(dashes), Some(offset)) => PathDashes::Shares {
                dashes: dashes.join(" "),
                offset,
            },
            _ => PathDashes::Unread,
        }
    }

    /// The transform of an element with styles that move it.
    fn transform(&mut self, node: Node<'_, '_>) -> Option<Cow<'a, str>> {
        let is_set = |name: &&str| self.styles.value(node, name).is_some();
        if !TRANSFORMS.iter().any(is_set) {
            return None;
        }
        let transforms = TRANSFORMS.map(|name| match name {
            "transform" => self.styles.property(node, name),
            _ => self.styles.value(node, name),
        });
        let transforms = transforms
            .into_iter()
            .flatten()
            .filter(|value| *value != "none");
        let transforms: Vec<&str> = transforms.collect();
        let value = |name| self.styles.value(node, name);
        let has_own_box = value("transform-box").is_some_and(|of| of != "view-box");
        if has_own_box && value("transform-origin").is_some() && !transforms.is_empty() {
            self.moved.add(1, node.range().start);
        }
        Some(match &transforms[..] {
            [] => "none".into(),
            all => all.join(" ").into(),
        })
    }

    /// Rewrites an attribute, with its value by the styles if there is one.
    fn attribute(
        &mut self,
        node: Node<'_, '_>,
        attribute: Attribute<'_, '_>,
        by_styles: Option<Cow<'_, str>>,
    ) -> Option<Edit> {
        let (name, value) = (attribute.name(), attribute.value());
        let replaced = |value: &str| Edit {
            range: attribute.range_value(),
            words: escaped(value),
        };
        if let Some(by_styles) = by_styles {
            return (by_styles != value).then(|| replaced(&by_styles));
        }
        if name == "style" {
            return Some(removed(attribute.range()));
        }
        if is_length(node.tag_name().name(), name) {
            let has_blanks = value.trim() != value && Length::from_str(value.trim()).is_ok();
            return has_blanks.then(|| replaced(value.trim()));
        }
        // Other elements have attributes of these names with other meanings.
        let element = node.tag_name();
        let is_other = element
            .namespace()
            .is_some_and(|namespace| namespace != SVG_NAMESPACE)
            || ANIMATIONS.contains(&element.name());
        if is_other {
            return None;
        }
        match presentation(name, value) {
            Ok(Cow::Borrowed(same)) if same == value => None,
            Ok(value) => Some(replaced(&value)),
            Err(()) => {
                self.ignored.add(1, attribute.range_value().start);
                Some(removed(attribute.range()))
            }
        }
    }

    /// Whether `url(#name)` refers to no element of this file.
    fn is_missing(&self, value: &str) -> bool {
        let inner = value
            .trim()
            .strip_prefix("url(")
            .and_then(|inner| inner.strip_suffix(')'));
        let name = inner.and_then(|inner| inner.trim_matches(['"', '\'', ' ']).strip_prefix('#'));
        name.is_some_and(|name| !self.ids.contains(name))
    }
}

/// The dashes of an element with `pathLength`.
enum PathDashes {
    /// It has none.
    None,
    /// They fill the whole path.
    Solid,
    /// They have units that depend on something else.
    Unread,
    /// The shares of the path.
    Shares { dashes: String, offset: String },
}

fn removed(range: std::ops::Range<usize>) -> Edit {
    Edit {
        range,
        words: String::new(),
    }
}

/// The number of style sheets in other files that the file names outside its sheets.
fn external_sheets(doc: &Document<'_>) -> Found {
    let is_sheet = |node: &Node<'_, '_>| {
        let is_instruction = node.pi().is_some_and(|pi| pi.target == "xml-stylesheet");
        let is_link =
            node.tag_name().name() == "link" && node.attribute("rel") == Some("stylesheet");
        is_instruction || is_link
    };
    found(doc.descendants().filter(is_sheet))
}

/// The number of shapes whose line has a colour, but no width.
fn lines_of_width_0(doc: &Document<'_>, text: &str, styles: &Styles<'_>) -> Found {
    if !text.contains("stroke-width") {
        return Found::default();
    }
    let widths = styles.inherited(doc, "stroke-width");
    let paints = styles.inherited(doc, "stroke");
    let is_zero = |node: &Node<'_, '_>| {
        let number = node.id().get_usize();
        let width = widths[number].and_then(|width| Length::from_str(width).ok());
        let is_painted = paints[number].is_some_and(|paint| paint != "none");
        let is_shape = SHAPES.contains(&node.tag_name().name());
        is_shape && is_painted && width.is_some_and(|width| width.number == 0.0)
    };
    found(doc.descendants().filter(is_zero))
}

/// Copies of elements that the file does not have, and of those in other files.
fn copies(doc: &Document<'_>, ids: &HashSet<&str>) -> [Found; 2] {
    let (mut missing, mut linked) = (Found::default(), Found::default());
    for node in doc
        .descendants()
        .filter(|node| node.tag_name().name() == "use")
    {
        let target = node
            .attributes()
            .find(|attribute| attribute.name() == "href");
        let Some(target) = target.map(|target| target.value().trim()) else {
            continue;
        };
        match target.strip_prefix('#') {
            None => linked.add(1, node.range().start),
            Some(id) => missing.add(usize::from(!ids.contains(id)), node.range().start),
        }
    }
    [missing, linked]
}

fn found<'a, 'input: 'a>(nodes: impl Iterator<Item = Node<'a, 'input>>) -> Found {
    let mut found = Found::default();
    for node in nodes {
        found.add(1, node.range().start);
    }
    found
}

/// The elements with their own or inherited markers, by number; empty if there are none.
fn marked(doc: &Document<'_>, styles: &Styles<'_>) -> Vec<bool> {
    let is_marker = |node: Node<'_, '_>| node.tag_name().name() == "marker";
    if !doc.descendants().any(is_marker) {
        return Vec::new();
    }
    let mut marked = vec![false; doc.descendants().count()];
    for node in doc.descendants().filter(Node::is_element) {
        let own = MARKERS
            .iter()
            .any(|name| styles.property(node, name).is_some());
        let outer = node
            .parent()
            .is_some_and(|parent| marked[parent.id().get_usize()]);
        marked[node.id().get_usize()] = own || outer;
    }
    marked
}

const ON_PAGE: &str = "non-scaling-stroke";
const ANIMATIONS: [&str; 5] = [
    "animate",
    "animateColor",
    "animateMotion",
    "animateTransform",
    "set",
];
const DASHES: &str = "stroke-dasharray";
const SHAPES: [&str; 8] = [
    "circle", "ellipse", "line", "path", "polygon", "polyline", "rect", "text",
];
const MARKERS: [&str; 3] = ["marker-start", "marker-mid", "marker-end"];
/// The properties that move an element, in the order in which they apply.
const TRANSFORMS: [&str; 4] = ["translate", "rotate", "scale", "transform"];
/// Properties that the library does not read as attributes.
const IN_STYLES: [&str; 3] = ["font-kerning", "isolation", "mix-blend-mode"];
