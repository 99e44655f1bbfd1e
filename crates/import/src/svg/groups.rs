//! The outermost groups of a file, which drawing programs use as layers.

use std::borrow::Cow;
use std::collections::HashMap;

use usvg::roxmltree::{Document, Node};

use super::edits::{Edit, edited};
use super::layer_code::{LayerCode, LayerControl, layer_code};

/// The groups that make layers, by their existing or added `id`.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Groups<'a> {
    pub(crate) by_id: HashMap<String, LayerGroup>,
    /// The file, in which each of them has an `id`.
    pub(crate) text: Cow<'a, str>,
}

/// What a group means for layers.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct LayerGroup {
    /// The name, if it is an outermost group and these are layers.
    pub(crate) name: Option<String>,
    /// How it is drawn, if it is a layer of Inkscape.
    pub(crate) control: Option<LayerControl>,
}

impl<'a> Groups<'a> {
    /// The layers of Inkscape, and the outermost groups if these are layers.
    pub(crate) fn new(doc: &Document<'_>, text: &'a str, outermost_are_layers: bool) -> Self {
        let mut by_id: HashMap<String, LayerGroup> = HashMap::new();
        let mut missing = Vec::new();
        let unused = unused(text);
        for (group, number) in outermost(doc).zip(1..).filter(|_| outermost_are_layers) {
            let id = known_id(group, &mut missing, || format!("{unused}{number}"));
            let of_id = by_id.entry(id).or_default();
            of_id.name.get_or_insert_with(|| name(group, number));
        }
        for (group, control) in controls(doc) {
            let number = group.id().get_usize();
            let id = known_id(group, &mut missing, || format!("{unused}layer-{number}"));
            by_id.entry(id).or_default().control = Some(control);
        }
        let text = if missing.is_empty() {
            Cow::Borrowed(text)
        } else {
            Cow::Owned(with_ids(text, &missing))
        };
        Self { by_id, text }
    }
}

/// The existing or added `id` of a group; a new one is noted as missing.
fn known_id<'d, 'i>(
    group: Node<'d, 'i>,
    missing: &mut Vec<(Node<'d, 'i>, String)>,
    new: impl FnOnce() -> String,
) -> String {
    let added = || missing.iter().find(|known| known.0 == group);
    if let Some(id) = id(group).or_else(|| added().map(|known| &*known.1)) {
        return id.to_owned();
    }
    let id = new();
    missing.push((group, id.clone()));
    id
}

/// Whether the label of any layer says how it is drawn.
pub(crate) fn has_controls(doc: &Document<'_>) -> bool {
    controls(doc).any(|(_, control)| control != LayerControl::default())
}

fn controls<'a>(doc: &'a Document<'_>) -> impl Iterator<Item = (Node<'a, 'a>, LayerControl)> {
    let groups = doc.descendants().filter(|node| is_group(*node));
    groups.filter_map(|group| match layer_code(group)? {
        LayerCode::Control(control) => Some((group, control)),
        LayerCode::Comment => None,
    })
}

/// The outermost groups of a file: those in its root, or in a group around everything.
fn outermost<'a>(doc: &'a Document<'_>) -> impl Iterator<Item = Node<'a, 'a>> {
    let mut around = doc.root_element();
    while let Some(wrapper) = wrapper(around) {
        around = wrapper;
    }
    around.children().filter(|node| is_group(*node))
}

/// The only thing that an element draws, if it is a group of groups. A layer of Inkscape is one
/// unless it has layers in it.
fn wrapper<'a>(around: Node<'a, 'a>) -> Option<Node<'a, 'a>> {
    let mut drawn = around.children().filter(|node| draws(*node));
    let only = drawn.next().filter(|_| drawn.next().is_none())?;
    let is_layer = |node: Node<'_, '_>| node.attribute((INKSCAPE, "groupmode")) == Some("layer");
    let groups = || only.children().filter(|node| is_group(*node));
    let holds_layers = if is_layer(only) {
        groups().any(is_layer)
    } else {
        groups().count() > 1 || wrapper(only).is_some()
    };
    (is_group(only) && holds_layers).then_some(only)
}

fn is_group(node: Node<'_, '_>) -> bool {
    node.is_element() && node.tag_name().name() == "g"
}

/// Whether an element is drawn, unlike definitions and metadata.
fn draws(node: Node<'_, '_>) -> bool {
    let name = node.tag_name();
    let is_svg = matches!(name.namespace(), None | Some(super::SVG_NAMESPACE));
    node.is_element() && is_svg && !UNDRAWN.contains(&name.name())
}

/// The name of a group: its label, its `id` or its number from 1.
fn name(group: Node<'_, '_>, number: usize) -> String {
    let label = group.attribute((INKSCAPE, "label"));
    match label.filter(|label| !label.trim().is_empty()).or(id(group)) {
        Some(name) => name.trim().to_owned(),
        None => format!("group {number}"),
    }
}

fn id<'a>(group: Node<'a, '_>) -> Option<&'a str> {
    group.attribute("id").filter(|id| !id.is_empty())
}

/// A prefix of `id`s that is unused in the file.
fn unused(text: &str) -> String {
    let mut start = "outermost-".to_owned();
    while text.contains(&start) {
        start.push('-');
    }
    start
}

fn with_ids(text: &str, missing: &[(Node<'_, '_>, String)]) -> String {
    let edits = missing
        .iter()
        .map(|(group, id)| match group.attribute_node("id") {
            Some(empty) => Edit {
                range: empty.range_value(),
                words: id.clone(),
            },
            None => Edit::attribute(text, *group, "id", id),
        });
    edited(text, edits.collect())
}

const UNDRAWN: [&str; 14] = [
    "clipPath",
    "defs",
    "desc",
    "filter",
    "linearGradient",
    "marker",
    "mask",
    "metadata",
    "pattern",
    "radialGradient",
    "script",
    "style",
    "symbol",
    "title",
];
pub(super) const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn groups_get_missing_ids() {
        let text = r#"<svg><g><g/></g><g id="sea"/><g id=""/><g
            fill="red"/></svg>"#;
        let doc = Document::parse(text).unwrap();
        let groups = Groups::new(&doc, text, true);
        assert_eq!(
            groups.text,
            r#"<svg><g id="outermost-1"><g/></g><g id="sea"/><g id="outermost-3"/><g id="outermost-4"
            fill="red"/></svg>"#
        );
        let mut names: Vec<&String> = groups.by_id.values().flat_map(|of| &of.name).collect();
        names.sort();
        assert_eq!(names, ["group 1", "group 3", "group 4", "sea"]);
    }

    /// The names of the layers in a file with this content.
    fn layers(content: &str) -> Vec<String> {
        let text = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="{INKSCAPE}">{content}</svg>"#
        );
        let doc = Document::parse(&text).unwrap();
        let groups = Groups::new(&doc, &text, true).by_id.into_values();
        let mut names: Vec<String> = groups.filter_map(|of| of.name).collect();
        names.sort();
        names
    }

    #[test]
    fn groups_around_everything_do_not_hide_the_layers_in_them() {
        let two = r#"<g id="a"><path/></g><g id="b"><path/></g>"#;
        assert_eq!(layers(&format!("<g>{two}</g>")), ["a", "b"]);
        let nested = format!(
            "<title>x</title><defs><g/></defs><g id='all' transform='scale(2)'><g><desc/>{two}</g></g>"
        );
        assert_eq!(layers(&nested), ["a", "b"]);
        assert_eq!(layers(&format!("<g id='all'>{two}<path/></g>")), ["a", "b"]);
        // A group beside something else is a layer, and so is one without groups.
        assert_eq!(layers(&format!("<g id='all'>{two}</g><path/>")), ["all"]);
        assert_eq!(layers("<g id='all'><path/><path/></g>"), ["all"]);
        assert_eq!(layers("<g id='all'><g id='a'/></g>"), ["all"]);
        let layer = |content: &str| format!("<g id='all' inkscape:groupmode='layer'>{content}</g>");
        assert_eq!(layers(&layer(two)), ["all"]);
        let sublayers = two.replace("<g id", "<g inkscape:groupmode='layer' id");
        assert_eq!(layers(&layer(&sublayers)), ["a", "b"]);
        assert_eq!(
            layers(&layer(&layer(&sublayers).replace("all", "inner"))),
            ["a", "b"]
        );
    }

    #[test]
    fn a_label_is_preferred_to_an_id() {
        let text = r#"<svg xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">
            <g id="layer1" inkscape:label=" Red pen "/></svg>"#;
        let doc = Document::parse(text).unwrap();
        let groups = Groups::new(&doc, text, true);
        assert_eq!(groups.by_id["layer1"].name.as_deref(), Some("Red pen"));
        assert_eq!(groups.text, text);
    }
}
