//! XML as a tree, unless the tree would fill the memory or take for ever to build.

use std::collections::HashSet;

use usvg::roxmltree::{Document, Error, ParsingOptions};

use crate::error::{SourceError, SvgError};
use crate::place::printable;

/// Reads a text as a tree.
///
/// A tree takes far more memory than the text that it comes from, so that it is measured first.
pub(crate) fn tree(text: &str, allow_dtd: bool) -> Result<Document<'_>, SourceError> {
    Measure::new(text).whole()?;
    let options = ParsingOptions {
        allow_dtd,
        nodes_limit: MOST_NODES,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| match error {
        Error::DtdDetected => {
            let at = text.find("<!DOCTYPE").unwrap_or_default();
            SourceError::unexpected(
                text.as_bytes(),
                at,
                "an element: nothing there needs a DOCTYPE",
            )
        }
        other => malformed(&other).into(),
    })
}

/// Tells where XML goes wrong.
pub(crate) fn malformed(error: &Error) -> SvgError {
    let place = error.pos();
    let problem = error.to_string();
    let suffix = format!(" at {place}");
    SvgError::Malformed {
        place: place.into(),
        problem: printable(problem.strip_suffix(&suffix).unwrap_or(&problem)),
    }
}

/// Counts what becomes of a text, comments included: at least as much as there is.
struct Measure<'a> {
    text: &'a [u8],
    /// How many elements, texts and attributes there are so far; what has to be copied counts as more.
    parts: usize,
    most: usize,
    /// Where the element in hand begins, and how many attributes it has.
    element: usize,
    attributes: usize,
    /// The short names of namespaces; each element that declares one keeps all that are known there.
    prefixes: HashSet<&'a [u8]>,
}

impl<'a> Measure<'a> {
    fn new(text: &'a str) -> Self {
        let text = text.as_bytes();
        Self {
            text,
            parts: 0,
            most: MOST_BYTES.saturating_sub(text.len()) / PART_BYTES,
            element: 0,
            attributes: 0,
            prefixes: HashSet::new(),
        }
    }

    fn whole(mut self) -> Result<(), SourceError> {
        let mut at = 0;
        while at < self.text.len() {
            at = self.characters(at)?;
            at = self.tag(at)?;
        }
        Ok(())
    }

    /// Counts the text that begins there, and tells where it ends.
    fn characters(&mut self, at: usize) -> Result<usize, SourceError> {
        let length = self.text[at..].iter().position(|&it| it == b'<');
        let end = length.map_or(self.text.len(), |it| at + it);
        self.count(at, usize::from(end > at))?;
        self.copied(at, end, b"&\r")?;
        // The library makes room for as many attributes as there are of these signs.
        let signs = self.text[at..end].iter().filter(|&&it| it == b'=');
        self.count(at, signs.count())?;
        Ok(end)
    }

    /// Counts the element, or whatever else begins with `<` there, and tells where it ends.
    fn tag(&mut self, start: usize) -> Result<usize, SourceError> {
        (self.element, self.attributes) = (start, 0);
        let kind = self.text.get(start + 1);
        self.count(start, usize::from(kind != Some(&b'/')))?;
        let has_values = !matches!(kind, Some(b'!' | b'?'));
        let mut at = start + 1;
        while let Some(&byte) = self.text.get(at) {
            match byte {
                // In values it is not allowed.
                b'<' => break,
                b'>' => return Ok(at + 1),
                b'=' if has_values => self.attribute(at)?,
                b'=' => self.count(at, 1)?,
                b'"' | b'\'' if has_values => {
                    at = self.value(at, byte)?;
                    continue;
                }
                _ => {}
            }
            at += 1;
        }
        Ok(at)
    }

    /// Counts the value that begins there with a quote, and tells where it ends.
    fn value(&mut self, at: usize, quote: u8) -> Result<usize, SourceError> {
        let rest = &self.text[at + 1..];
        let length = rest.iter().position(|&it| it == quote || it == b'<');
        let end = at + 1 + length.unwrap_or(rest.len());
        self.copied(at, end, b"&\r\n\t")?;
        let signs = self.text[at..end].iter().filter(|&&it| it == b'=');
        self.count(at, signs.count())?;
        Ok(if self.text.get(end) == Some(&quote) {
            end + 1
        } else {
            end
        })
    }

    /// Counts the attribute whose name ends there.
    fn attribute(&mut self, at: usize) -> Result<(), SourceError> {
        self.count(at, 1)?;
        self.attributes += 1;
        if self.attributes > MOST_ATTRIBUTES {
            let found = format!("an element with more than {MOST_ATTRIBUTES} attributes");
            let expected = format!("at most {MOST_ATTRIBUTES}; leave out what draws nothing");
            return Err(SourceError::found(self.text, self.element, found, expected));
        }
        let name = name_before(self.text, at);
        if name.starts_with(XMLNS) {
            self.prefixes.insert(name);
            self.count(at, NAMESPACE_PARTS)?;
        }
        if self.prefixes.len() > MOST_PREFIXES {
            let found = format!("more than {MOST_PREFIXES} names for namespaces (xmlns)");
            let expected = "fewer; save it as plain SVG";
            return Err(SourceError::found(self.text, at, found, expected));
        }
        Ok(())
    }

    /// A text with one of these bytes is copied, others are read where they stand.
    fn copied(&mut self, at: usize, end: usize, bytes: &[u8]) -> Result<(), SourceError> {
        let text = &self.text[at..end];
        // A few quick looks, not one at each byte.
        if bytes.iter().any(|it| text.contains(it)) {
            // While it is copied there are two.
            self.count(at, (2 * text.len()).div_ceil(PART_BYTES))?;
        }
        Ok(())
    }

    fn count(&mut self, at: usize, parts: usize) -> Result<(), SourceError> {
        self.parts += parts;
        if self.parts <= self.most {
            return Ok(());
        }
        let most = self.most;
        let found = format!("more than {most} elements, texts and attributes");
        let expected = format!(
            "no more in a file of {} MB; leave out what draws nothing, or draw it in parts",
            self.text.len().div_ceil(1_000_000)
        );
        Err(SourceError::found(self.text, at, found, expected))
    }
}

/// The name of the attribute whose sign `=` stands at an offset.
fn name_before(text: &[u8], at: usize) -> &[u8] {
    let name = text[at.saturating_sub(LONGEST_NAME)..at].trim_ascii_end();
    let before = name.iter().rposition(|it| b" \n\t\r\"'".contains(it));
    &name[before.map_or(0, |it| it + 1)..]
}

const XMLNS: &[u8] = b"xmlns:";
/// Longer names of namespaces are not looked for.
const LONGEST_NAME: usize = 60;
const MOST_PREFIXES: usize = 50;
/// All names of namespaces weigh as much as that many attributes.
const NAMESPACE_PARTS: usize = 2;
/// Each is compared with all the others.
const MOST_ATTRIBUTES: usize = 250;
/// What an element, a text or an attribute takes in the memory, in bytes.
const PART_BYTES: usize = 80;
/// What a file and its tree may take together; the rest of what a reader may take is for what it draws.
const MOST_BYTES: usize = 100_000_000;
/// No tree of an element and its attributes, texts and comments has more.
#[expect(clippy::cast_possible_truncation, reason = "some millions")]
const MOST_NODES: u32 = (MOST_BYTES / PART_BYTES) as u32;

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn refused(text: &str, parts: &[&str]) {
        let error = tree(text, false).expect_err("too much").to_string();
        for part in parts {
            assert!(error.contains(part), "{error}");
        }
    }

    #[test]
    fn what_a_drawing_has_is_read() {
        let text = "<!-- a = ' --><a b=\"1=2\" c='\n'>&amp;<![CDATA[ = ' ]]></a>";
        assert_eq!(tree(text, false).expect("XML").descendants().count(), 4);
        let many = format!("<!-- {} --><a/>", "= ".repeat(1000));
        assert!(tree(&many, false).is_ok());
    }

    #[test]
    fn a_tree_that_would_fill_the_memory_is_refused_before_it_is_built() {
        for part in [
            "<a/>",
            "<a b=\"\"/>",
            " <a/>",
            "<a b='\n'/>",
            "&amp;<a/>",
            "=",
        ] {
            let text = format!("<x>\n{}</x>", part.repeat(20_000_000 / part.len()));
            let told = [
                "found more than 9",
                " elements, texts and attributes; expected no more in a file of 21 MB",
            ];
            refused(&text, &told);
        }
    }

    #[test]
    fn the_name_of_an_attribute_stands_before_its_sign_whatever_stands_before_that() {
        let name = |text: &str| {
            let at = text.rfind('=').expect("a sign");
            let name = name_before(text.as_bytes(), at);
            String::from_utf8_lossy(name).into_owned()
        };
        for text in ["<a xmlns:b =", "<a c='d'xmlns:b=", "<a c=\"d\"\n\txmlns:b="] {
            assert_eq!(name(text), "xmlns:b");
        }
        assert_eq!(name("="), "");
    }

    #[test]
    fn elements_of_more_attributes_and_names_than_anybody_writes_are_refused() {
        let attributes = |count: usize| {
            let each: Vec<String> = (0..count).map(|it| format!(" a{it}=\"\"")).collect();
            each.concat()
        };
        assert!(tree(&format!("<x>\n<a{}/></x>", attributes(250)), false).is_ok());
        refused(
            &format!("<x>\n<a{}/></x>", attributes(251)),
            &["2:1: found an element with more than 250 attributes; expected at most 250"],
        );
        let names: Vec<String> = (0..51)
            .map(|it| format!("<a xmlns:n{it}=\"u\"/>"))
            .collect();
        refused(
            &format!("<x>{}</x>", names.concat()),
            &["more than 50 names for namespaces"],
        );
    }
}
