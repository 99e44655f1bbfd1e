//! Namespaces and default attributes that a file declares in its DOCTYPE.
//!
//! ```text
//!   <!DOCTYPE svg [<!ATTLIST g xmlns:kvg CDATA #FIXED "urn:kvg" kvg:kind CDATA "line">]>
//!   <svg><g/></svg>             <svg xmlns:kvg="urn:kvg"><g kvg:kind="line"/></svg>
//! ```

use std::borrow::Cow;

use dobot_geometry::CancelToken;

use super::edits::{Edit, edited};
use crate::error::SvgError;
use crate::place::place;
use crate::xml::tag_end;

/// The default value of an attribute.
#[derive(Debug, PartialEq)]
struct Default<'t> {
    element: &'t str,
    attribute: &'t str,
    value: &'t str,
}

/// The text with the declared namespaces and default attributes in its elements, which the library
/// for XML does not add.
pub(super) fn with_defaults<'t>(
    text: &'t str,
    cancel: &CancelToken,
) -> Result<Cow<'t, str>, SvgError> {
    let Some((subset, begin)) = internal_subset(text) else {
        return Ok(Cow::Borrowed(text));
    };
    let defaults = defaults(subset);
    if defaults.is_empty() {
        return Ok(Cow::Borrowed(text));
    }
    let (mut edits, mut length) = (Vec::new(), 0);
    let mut at = begin;
    while let Some(start) = text[at..].find('<').map(|offset| at + offset) {
        cancel.check()?;
        let tag = &text[start..];
        let tag = &tag[..tag_end(tag).unwrap_or(tag.len())];
        at = start + tag.len();
        let name = tag[1..].split(|sign: char| sign.is_whitespace() || "/>".contains(sign));
        let name = name.into_iter().next().unwrap_or_default();
        if name.is_empty() || name.starts_with(['!', '?']) {
            continue;
        }
        let is_root = edits.is_empty() && length == 0 && is_first(&text[begin..start]);
        let words: String = added(&defaults, name, tag, is_root).collect();
        if words.is_empty() {
            continue;
        }
        length += words.len();
        if length > LIMIT {
            let first = text.find("<!ATTLIST").unwrap_or_default();
            return Err(SvgError::Entities {
                place: place(text.as_bytes(), first),
                problem: "more than 2 million characters of default attributes",
            });
        }
        let end = start + 1 + name.len();
        edits.push(Edit {
            range: end..end,
            words,
        });
    }
    Ok(Cow::Owned(edited(text, edits)))
}

/// The declarations in the DOCTYPE, and the end of it.
fn internal_subset(text: &str) -> Option<(&str, usize)> {
    let start = text.find("<!DOCTYPE")?;
    let rest = &text[start..];
    // A quote in a comment there may be without its pair.
    let end = tag_end(rest).or_else(|| rest.find("]>").map(|at| at + 2))?;
    let end = start + end;
    let doctype = &text[start..end];
    let open = doctype.find('[')?;
    doctype
        .contains("<!ATTLIST")
        .then(|| (&doctype[open + 1..], end))
}

/// Whether no element precedes.
fn is_first(before: &str) -> bool {
    let mut signs = before.match_indices('<');
    signs.all(|(at, _)| before[at + 1..].starts_with(['!', '?']))
}

/// The missing attributes of an element. The root declares all namespaces.
fn added<'d>(
    defaults: &'d [Default<'_>],
    name: &'d str,
    tag: &'d str,
    is_root: bool,
) -> impl Iterator<Item = String> + 'd {
    let names = attribute_names(tag);
    let mut known: Vec<&str> = Vec::new();
    defaults.iter().filter_map(move |default| {
        let is_namespace = default.attribute.starts_with("xmlns");
        let is_meant =
            default.element == name || (is_root && default.attribute.starts_with("xmlns:"));
        let is_meant = is_meant && (is_root || !is_namespace || default.attribute == "xmlns");
        if !is_meant || names.contains(&default.attribute) || known.contains(&default.attribute) {
            return None;
        }
        known.push(default.attribute);
        Some(format!(
            " {}=\"{}\"",
            default.attribute,
            default.value.replace('"', "&quot;")
        ))
    })
}

/// The names of the attributes in a tag.
fn attribute_names(tag: &str) -> Vec<&str> {
    let outside = tag.split(['"', '\'']).step_by(2);
    let names = outside.filter_map(|part| part.trim_end().strip_suffix('='));
    names
        .filter_map(|part| part.split_whitespace().next_back())
        .collect()
}

/// The default attributes of declarations.
fn defaults(subset: &str) -> Vec<Default<'_>> {
    let mut defaults = Vec::new();
    let mut rest = subset;
    while let Some(at) = rest.find("<!") {
        let declaration = &rest[at..];
        let end = tag_end(declaration).unwrap_or(declaration.len());
        let list = declaration[..end].strip_prefix("<!ATTLIST");
        if let Some(list) = list.and_then(|list| list.strip_suffix('>')) {
            let mut words = words(list).into_iter();
            let element = words.next().unwrap_or_default();
            while let (Some(attribute), Some(kind)) = (words.next(), words.next()) {
                if kind == "NOTATION" {
                    words.next();
                }
                let value = match words.next() {
                    Some("#FIXED") => words.next(),
                    other => other,
                };
                let quoted = value.filter(|value| value.starts_with(['"', '\'']));
                if let Some(value) = quoted.and_then(|value| value.get(1..value.len() - 1)) {
                    defaults.push(Default {
                        element,
                        attribute,
                        value,
                    });
                }
            }
        }
        rest = &declaration[end..];
    }
    defaults
}

/// Words, quoted texts and lists in brackets.
fn words(list: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = list.trim_start();
    while let Some(first) = rest.chars().next() {
        let end = match first {
            '"' | '\'' => rest[1..].find(first).map(|at| at + 2),
            '(' => rest.find(')').map(|at| at + 1),
            _ => rest.find(char::is_whitespace),
        };
        let (word, after) = rest.split_at(end.unwrap_or(rest.len()));
        words.push(word);
        rest = after.trim_start();
    }
    words
}

/// The largest length of all added attributes, in bytes.
const LIMIT: usize = 2_000_000;

#[cfg(test)]
mod tests {
    use super::*;

    fn read(declared: &str, content: &str) -> String {
        let text = format!("<?xml version=\"1.0\"?><!DOCTYPE svg [{declared}]>\n{content}");
        let read = with_defaults(&text, &CancelToken::default())
            .expect("few attributes")
            .into_owned();
        read[read.find("]>\n").map_or(0, |at| at + 3)..].to_owned()
    }

    #[test]
    fn the_root_declares_the_namespaces_and_elements_have_their_defaults() {
        let declared = r#"<!ENTITY a "b>"> <!-- <!ATTLIST g x CDATA "y"> -->
            <!ATTLIST g xmlns:kvg CDATA #FIXED "urn:kvg" kvg:kind (line|dot) 'line' id ID #IMPLIED >
            <!ATTLIST path fill CDATA "none" stroke CDATA 'a&amp;"b' >"#;
        assert_eq!(
            read(
                declared,
                "<!-- c --><svg><g/><g kvg:kind = 'dot' id=\"fill=1\"/><path\nfill='red'/></svg>"
            ),
            "<!-- c --><svg xmlns:kvg=\"urn:kvg\"><g kvg:kind=\"line\"/><g kvg:kind = 'dot' id=\"fill=1\"/><path stroke=\"a&amp;&quot;b\"\nfill='red'/></svg>"
        );
        let known = "<svg xmlns:kvg='urn:kvg'><a/></svg>";
        assert_eq!(read(declared, known), known);
        let default = r#"<!ATTLIST svg xmlns CDATA "http://www.w3.org/2000/svg">"#;
        assert_eq!(
            read(default, "<svg/>"),
            "<svg xmlns=\"http://www.w3.org/2000/svg\"/>"
        );
    }

    #[test]
    fn damaged_declarations_are_read_without_harm() {
        for declared in [
            "<!ATTLIST",
            "<!ATTLIST >",
            "<!ATTLIST g a CDATA \"",
            "<!ATTLIST g a (",
            "<!ATTLIST g a CDATA '>",
        ] {
            let content = "<svg><g/></svg>";
            let text = format!("<!DOCTYPE svg [{declared}]>{content}");
            assert!(
                with_defaults(&text, &CancelToken::default()).is_ok(),
                "{declared}"
            );
        }
    }

    #[test]
    fn defaults_that_would_fill_the_memory_are_refused() {
        let declared = format!("<!ATTLIST g a CDATA \"{}\">", "x".repeat(10_000));
        let text = format!(
            "<!DOCTYPE svg [{declared}]><svg>{}</svg>",
            "<g/>".repeat(1_000)
        );
        assert!(matches!(
            with_defaults(&text, &CancelToken::default()),
            Err(SvgError::Entities { .. })
        ));
    }
}
