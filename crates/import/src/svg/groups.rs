//! The outermost groups of a file, which drawing programs use as layers.

use std::borrow::Cow;
use std::collections::HashMap;

use usvg::roxmltree::{Document, Node};

use super::edits::{Edit, edited};

/// The names of the outermost groups, by their existing or added `id`.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Groups<'a> {
    pub(crate) names: HashMap<String, String>,
    /// The file, in which each of them has an `id`.
    pub(crate) text: Cow<'a, str>,
}

impl<'a> Groups<'a> {
    pub(crate) fn new(doc: &Document<'_>, text: &'a str) -> Self {
        let mut names = HashMap::new();
        let mut missing = Vec::new();
        let unused = unused(text);
        for (group, number) in outermost(doc).zip(1..) {
            let id = id(group).map_or_else(
                || {
                    let id = format!("{unused}{number}");
                    missing.push((group, id.clone()));
                    id
                },
                str::to_owned,
            );
            names.entry(id).or_insert_with(|| name(group, number));
        }
        let text = if missing.is_empty() {
            Cow::Borrowed(text)
        } else {
            Cow::Owned(with_ids(text, &missing))
        };
        Self { names, text }
    }
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

/// What the name of a layer means to `AxiDraw` (its user guide, layer control).
#[derive(Debug, PartialEq)]
pub(super) enum LayerCode {
    /// `%`: it is never drawn.
    Comment,
    /// `!`: pause before it; `+S`, `+H` and `+D`: its speed, pen height and delay.
    Other,
}

/// The codes for `AxiDraw` in the label of an Inkscape layer.
pub(super) fn layer_code(node: Node<'_, '_>) -> Option<LayerCode> {
    let is_layer = node.attribute((INKSCAPE, "groupmode")) == Some("layer");
    let label = node.attribute((INKSCAPE, "label")).filter(|_| is_layer)?;
    let label = label.trim_start();
    let mut codes = label.split('+').skip(1).map(str::as_bytes);
    let has_code = codes.any(|code| match code {
        [kind, number, ..] => b"SHDshd".contains(kind) && number.is_ascii_digit(),
        _ => false,
    });
    match label.as_bytes().first()? {
        b'%' => Some(LayerCode::Comment),
        b'!' => Some(LayerCode::Other),
        _ => has_code.then_some(LayerCode::Other),
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
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn groups_get_missing_ids() {
        let text = r#"<svg><g><g/></g><g id="sea"/><g id=""/><g
            fill="red"/></svg>"#;
        let doc = Document::parse(text).unwrap();
        let groups = Groups::new(&doc, text);
        assert_eq!(
            groups.text,
            r#"<svg><g id="outermost-1"><g/></g><g id="sea"/><g id="outermost-3"/><g id="outermost-4"
            fill="red"/></svg>"#
        );
        let mut names: Vec<&String> = groups.names.values().collect();
        names.sort();
        assert_eq!(names, ["group 1", "group 3", "group 4", "sea"]);
    }

    /// The names of the layers in a file with this content.
    fn layers(content: &str) -> Vec<String> {
        let text = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="{INKSCAPE}">{content}</svg>"#
        );
        let doc = Document::parse(&text).unwrap();
        let mut names: Vec<String> = Groups::new(&doc, &text).names.into_values().collect();
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
    fn names_of_layers_have_codes_for_axidraw() {
        let code = |label: &str| {
            let text = format!(
                r#"<svg xmlns:inkscape="{INKSCAPE}"><g inkscape:groupmode="layer" inkscape:label="{label}"/></svg>"#
            );
            let doc = Document::parse(&text).unwrap();
            layer_code(doc.root_element().first_element_child().unwrap())
        };
        for (label, expected) in [
            ("%guides", Some(LayerCode::Comment)),
            (" % guides", Some(LayerCode::Comment)),
            ("!red", Some(LayerCode::Other)),
            ("5 +S30+H50 red", Some(LayerCode::Other)),
            ("red+d100", Some(LayerCode::Other)),
            ("red + Sea", None),
            ("50 % red", None),
            ("", None),
        ] {
            assert_eq!(code(label), expected, "{label}");
        }
    }

    #[test]
    fn a_label_is_preferred_to_an_id() {
        let text = r#"<svg xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape">
            <g id="layer1" inkscape:label=" Red pen "/></svg>"#;
        let doc = Document::parse(text).unwrap();
        let groups = Groups::new(&doc, text);
        assert_eq!(groups.names["layer1"], "Red pen");
        assert_eq!(groups.text, text);
    }
}
