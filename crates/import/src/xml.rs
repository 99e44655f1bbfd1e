//! XML as a tree, within limits of memory and time.

use std::collections::HashSet;

use usvg::roxmltree::{Document, Error, ParsingOptions};

use crate::error::{SourceError, SvgError};
use crate::place::{Place, place, printable};

/// A document that was read up to its end or its first error.
pub(crate) struct Readable<'a> {
    /// What was parsed.
    pub(crate) text: &'a str,
    pub(crate) document: Document<'a>,
    pub(crate) error: Option<SourceError>,
}

/// Parses a text, or else what is complete before its first error: elements at most `deepest`
/// levels deep may lack content, others are left out. That part is stored in `part`.
pub(crate) fn tree_before_error<'a>(
    text: &'a str,
    allow_dtd: bool,
    deepest: usize,
    part: &'a mut String,
) -> Result<Readable<'a>, SourceError> {
    let error = match tree(text, allow_dtd) {
        Ok(document) => {
            return Ok(Readable {
                text,
                document,
                error: None,
            });
        }
        Err(error) => error,
    };
    match complete_part(text, &error, deepest) {
        Some(complete) => *part = complete,
        None => return Err(error),
    }
    match tree(part, allow_dtd) {
        Ok(document) => Ok(Readable {
            text: part,
            document,
            error: Some(error),
        }),
        Err(_) => Err(error),
    }
}

/// Parses a text as a tree.
///
/// A tree takes far more memory than its text, so its size is computed first.
pub(crate) fn tree(text: &str, allow_dtd: bool) -> Result<Document<'_>, SourceError> {
    Measure::new(text).whole()?;
    let options = ParsingOptions {
        allow_dtd,
        nodes_limit: MAX_NODES,
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options).map_err(|error| match error {
        Error::DtdDetected => {
            let at = text.find("<!DOCTYPE").unwrap_or_default();
            SourceError::unexpected(
                text.as_bytes(),
                at,
                "an element; no drawing needs a DOCTYPE",
            )
        }
        other => unclosed(text, &other)
            .unwrap_or_else(|| malformed(&other))
            .into(),
    })
}

/// The error of malformed XML.
pub(crate) fn malformed(error: &Error) -> SvgError {
    let at = error.pos();
    let problem = error.to_string();
    let suffix = format!(" at {at}");
    SvgError::Malformed {
        place: at.into(),
        problem: printable(problem.strip_suffix(&suffix).unwrap_or(&problem)),
    }
}

/// The innermost unclosed element, if it is the cause of an error.
fn unclosed(text: &str, error: &Error) -> Option<SvgError> {
    let mut open = Vec::new();
    let mut at = 0;
    let ends = matches!(
        error,
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream
    );
    let mut is_cut = ends;
    while let Some(start) = text[at..].find('<').map(|offset| at + offset) {
        let tag = &text[start..];
        let Some(end) = tag_end(tag) else {
            let begins = place(text.as_bytes(), start);
            let is_tag = !tag.starts_with("<!") && !tag.starts_with("<?");
            // A missing quote extends to the next tag.
            is_cut = !(is_tag && tag[1..].contains('<'));
            is_cut &= ends || begins <= Place::from(error.pos());
            if !tag.starts_with("</") {
                open.push(start);
            }
            break;
        };
        at = start + end;
        if tag.starts_with("</") {
            open.pop();
        } else if !tag[1..].starts_with(['!', '?']) && !tag[..end].ends_with("/>") {
            open.push(start);
        }
    }
    if !is_cut {
        return None;
    }
    let start = *open.last()?;
    let part = match &text[start + 1..] {
        // The content of its brackets is not examined.
        doctype if doctype.starts_with("!DOCTYPE") => return None,
        mark if mark.starts_with("!--") => "a comment".to_owned(),
        mark if mark.starts_with(['!', '?']) => "<".to_owned() + &mark[..1],
        tag => {
            let end = tag.find(|c: char| c.is_whitespace() || "<>/".contains(c));
            format!("<{}>", printable(&tag[..end.unwrap_or(tag.len())]))
        }
    };
    let place = place(text.as_bytes(), start);
    Some(SvgError::EndsTooSoon { place, part })
}

/// The text up to its last tag before an error after which at most `deepest` elements are open,
/// with those closed.
fn complete_part(text: &str, error: &SourceError, deepest: usize) -> Option<String> {
    let end = match error {
        SourceError::Svg(SvgError::Malformed { place, .. }) => offset(text, *place),
        SourceError::Svg(SvgError::EndsTooSoon { .. }) => text.len(),
        _ => return None,
    };
    let (mut at, mut open, mut complete) = (0, Vec::new(), None);
    while let Some(start) = text[at..end].find('<').map(|start| at + start) {
        let tag = &text[start..];
        let Some(length) = tag_end(tag).filter(|length| start + length <= end) else {
            break;
        };
        at = start + length;
        let name = tag[1..]
            .split(|c: char| c.is_whitespace() || "/>".contains(c))
            .next()?;
        if tag.starts_with("</") {
            open.pop()?;
        } else if !name.starts_with(['!', '?']) && !text[..at].ends_with("/>") {
            open.push(name);
        }
        if open.len() <= deepest {
            complete = Some((at, open.len()));
        }
    }
    let (at, count) = complete?;
    let ends = open[..count].iter().rev().map(|name| format!("</{name}>"));
    Some(text[..at].to_owned() + &ends.collect::<String>())
}

/// The offset of a place in a text.
fn offset(text: &str, place: Place) -> usize {
    let lines = text.split_inclusive('\n').take(place.line as usize - 1);
    let begin: usize = lines.map(str::len).sum();
    let column = text[begin..].char_indices().nth(place.column as usize - 1);
    column.map_or(text.len(), |(at, _)| begin + at)
}

/// The end of a tag, a comment or another markup at the start of a text.
pub(crate) fn tag_end(text: &str) -> Option<usize> {
    let after = |mark: &str| text.find(mark).map(|at| at + mark.len());
    if text.starts_with("<!--") {
        return after("-->");
    }
    if text.starts_with("<![CDATA[") {
        return after("]]>");
    }
    if text.starts_with("<?") {
        return after("?>");
    }
    // A DOCTYPE has declarations between brackets.
    let (mut quote, mut depth) = (None, 0_usize);
    for (at, sign) in text.bytes().enumerate() {
        match (quote, sign) {
            (Some(begun), _) if begun == sign => quote = None,
            (None, b'"' | b'\'') => quote = Some(sign),
            (None, b'[') => depth += 1,
            (None, b']') => depth = depth.saturating_sub(1),
            (None, b'>') if depth == 0 => return Some(at + 1),
            _ => {}
        }
    }
    None
}

/// An upper bound of the nodes of a text, including comments.
struct Measure<'a> {
    text: &'a [u8],
    /// The number of elements, texts and attributes; copied ones count as more.
    parts: usize,
    most: usize,
    /// The start of the current element, and the number of its attributes.
    element: usize,
    attributes: usize,
    /// The namespace prefixes; each element that declares one stores all known ones.
    prefixes: HashSet<&'a [u8]>,
}

impl<'a> Measure<'a> {
    fn new(text: &'a str) -> Self {
        let text = text.as_bytes();
        Self {
            text,
            parts: 0,
            most: MAX_BYTES.saturating_sub(text.len()) / PART_BYTES,
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

    /// Counts the text at an offset, and returns its end.
    fn characters(&mut self, at: usize) -> Result<usize, SourceError> {
        let length = self.text[at..].iter().position(|&byte| byte == b'<');
        let end = length.map_or(self.text.len(), |length| at + length);
        self.count(at, usize::from(end > at))?;
        self.copied(at, end, b"&\r")?;
        // The library reserves an attribute for each of these signs.
        let signs = self.text[at..end].iter().filter(|&&byte| byte == b'=');
        self.count(at, signs.count())?;
        Ok(end)
    }

    /// Counts the element or other markup with `<` at an offset, and returns its end.
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

    /// Counts the value with its quote at an offset, and returns its end.
    fn value(&mut self, at: usize, quote: u8) -> Result<usize, SourceError> {
        let rest = &self.text[at + 1..];
        let length = rest.iter().position(|&byte| byte == quote || byte == b'<');
        let end = at + 1 + length.unwrap_or(rest.len());
        self.copied(at, end, b"&\r\n\t")?;
        let signs = self.text[at..end].iter().filter(|&&byte| byte == b'=');
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
        if self.attributes > MAX_ATTRIBUTES {
            let found = format!("an element with more than {MAX_ATTRIBUTES} attributes");
            let expected = format!("at most {MAX_ATTRIBUTES}; remove what draws nothing");
            return Err(SourceError::found(self.text, self.element, found, expected));
        }
        let name = name_before(self.text, at);
        if name.starts_with(XMLNS) {
            self.prefixes.insert(name);
            self.count(at, NAMESPACE_PARTS)?;
        }
        if self.prefixes.len() > MAX_PREFIXES {
            let found = format!("more than {MAX_PREFIXES} namespace prefixes (xmlns)");
            let expected = "fewer; save it as plain SVG";
            return Err(SourceError::found(self.text, at, found, expected));
        }
        Ok(())
    }

    /// Whether a text has a byte for which it is copied instead of borrowed.
    fn copied(&mut self, at: usize, end: usize, bytes: &[u8]) -> Result<(), SourceError> {
        let text = &self.text[at..end];
        // A few fast searches, not a test of each byte.
        if bytes.iter().any(|byte| text.contains(byte)) {
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
        if most == 0 {
            let megabytes = self.text.len().div_ceil(1_000_000);
            let found = format!("a file of {megabytes} MB");
            let most_mb = crate::limits::MAX_BYTES / 1_000_000;
            let expected = format!("at most {most_mb} MB; remove what draws nothing");
            return Err(SourceError::found(self.text, at, found, expected));
        }
        let found = format!("more than {most} elements, texts and attributes");
        let expected = format!(
            "at most that in a file of {} MB; remove what draws nothing, or draw it in parts",
            self.text.len().div_ceil(1_000_000)
        );
        Err(SourceError::found(self.text, at, found, expected))
    }
}

/// The name of the attribute whose sign `=` is at an offset.
fn name_before(text: &[u8], at: usize) -> &[u8] {
    let name = text[at.saturating_sub(MAX_NAME_LEN)..at].trim_ascii_end();
    let before = name.iter().rposition(|item| b" \n\t\r\"'".contains(item));
    &name[before.map_or(0, |before| before + 1)..]
}

const XMLNS: &[u8] = b"xmlns:";
/// Longer prefixes are not tracked.
const MAX_NAME_LEN: usize = 60;
const MAX_PREFIXES: usize = 50;
/// The cost of all prefixes, in attributes.
const NAMESPACE_PARTS: usize = 2;
/// Each is compared with all the others.
const MAX_ATTRIBUTES: usize = 250;
/// The memory of an element, a text or an attribute, in bytes.
const PART_BYTES: usize = 80;
/// The memory limit of a file and its tree; the rest of a reader's memory is for its drawing.
const MAX_BYTES: usize = 100_000_000;
/// The largest number of nodes of a tree: elements, attributes, texts and comments.
#[expect(clippy::cast_possible_truncation, reason = "some millions")]
const MAX_NODES: u32 = (MAX_BYTES / PART_BYTES) as u32;

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
    fn unusual_but_valid_xml_is_read() {
        let text = "<!-- a = ' --><a b=\"1=2\" c='\n'>&amp;<![CDATA[ = ' ]]></a>";
        assert_eq!(tree(text, false).expect("XML").descendants().count(), 4);
        let many = format!("<!-- {} --><a/>", "= ".repeat(1000));
        assert!(tree(&many, false).is_ok());
    }

    #[test]
    fn a_truncated_text_is_reported_with_its_innermost_open_element() {
        for (text, message) in [
            (
                "<a>\n <b><c/></b><d e='>'>",
                "2:13: not well-formed XML: the file ends too soon: <d> starts here and is not closed",
            ),
            (
                "<a>\n  <b c=\"M0 0",
                "2:3: not well-formed XML: the file ends too soon: <b> starts",
            ),
            (
                "<?x <a>?><a><!-- <b> --><![CDATA[<c>]]>",
                "1:10: not well-formed XML: the file ends too soon: <a>",
            ),
            (
                "<a>\n  <b c=",
                "2:3: not well-formed XML: the file ends too soon: <b>",
            ),
            (
                "<a>\n  <b c/",
                "2:3: not well-formed XML: the file ends too soon: <b>",
            ),
            (
                "<a>\n  <b",
                "2:3: not well-formed XML: the file ends too soon: <b>",
            ),
            (
                "<a>b",
                "1:1: not well-formed XML: the file ends too soon: <a>",
            ),
            (
                "<a><b></b",
                "1:4: not well-formed XML: the file ends too soon: <b>",
            ),
            (
                "<a>\n<",
                "2:1: not well-formed XML: the file ends too soon: <>",
            ),
            (
                "<a><!-- b",
                "1:4: not well-formed XML: the file ends too soon: a comment starts",
            ),
            (
                "<a><![CDATA[",
                "1:4: not well-formed XML: the file ends too soon: <! starts",
            ),
        ] {
            refused(text, &[message]);
        }
    }

    #[test]
    fn a_missing_quote_is_not_mistaken_for_a_missing_end() {
        for text in ["<a>\n  <b c='>\n<d e=''></b></a>", "<a b='&c;'><d"] {
            let message = tree(text, false).expect_err("no XML").to_string();
            assert!(message.contains("not well-formed XML"), "{message}");
            assert!(!message.contains("too soon"), "{message}");
        }
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
            let message = [
                "found more than 9",
                " elements, texts and attributes; expected at most that in a file of 21 MB",
            ];
            refused(&text, &message);
        }
    }

    #[test]
    fn a_text_too_large_for_any_tree_is_reported_by_its_size() {
        let text = format!("<x>{}</x>", " ".repeat(100_000_000));
        refused(
            &text,
            &["1:1: found a file of 101 MB; expected at most 64 MB; remove what draws nothing"],
        );
    }

    #[test]
    fn the_name_of_an_attribute_is_found_before_its_equals_sign() {
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
    fn elements_with_too_many_attributes_or_names_are_refused() {
        let attributes = |count: usize| {
            let each: Vec<String> = (0..count).map(|i| format!(" a{i}=\"\"")).collect();
            each.concat()
        };
        assert!(tree(&format!("<x>\n<a{}/></x>", attributes(250)), false).is_ok());
        refused(
            &format!("<x>\n<a{}/></x>", attributes(251)),
            &["2:1: found an element with more than 250 attributes; expected at most 250"],
        );
        let names: Vec<String> = (0..51).map(|i| format!("<a xmlns:n{i}=\"u\"/>")).collect();
        refused(
            &format!("<x>{}</x>", names.concat()),
            &["more than 50 namespace prefixes"],
        );
    }
}
