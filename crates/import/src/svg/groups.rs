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

/// The groups in the root of a file.
pub(crate) fn outermost<'a>(doc: &'a Document<'_>) -> impl Iterator<Item = Node<'a, 'a>> {
    let is_group = |node: &Node<'_, '_>| node.is_element() && node.tag_name().name() == "g";
    doc.root_element().children().filter(is_group)
}

/// The name of a group: its label, its `id` or its number from 1.
pub(crate) fn name(group: Node<'_, '_>, number: usize) -> String {
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
