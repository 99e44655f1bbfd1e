//! Shared parts of both XML formats: metres and radians.

use std::fmt::Write;

use dobot_arm::{Degrees, Span};
use xmlwriter::{Indent, Options, XmlWriter};

/// A document that begins with a comment.
pub(crate) fn document(comment: &str) -> XmlWriter {
    let mut xml = XmlWriter::new(Options {
        indent: Indent::Spaces(2),
        ..Options::default()
    });
    xml.write_declaration();
    xml.write_comment(comment);
    xml
}

/// Writes an element that has attributes and nothing else.
pub(crate) fn element(xml: &mut XmlWriter, name: &str, attributes: &[(&str, &str)]) {
    xml.start_element(name);
    for (name, value) in attributes {
        xml.write_attribute(name, *value);
    }
    xml.end_element();
}

/// Numbers with a space between.
pub(crate) fn numbers(values: impl IntoIterator<Item = f64>) -> String {
    let mut text = String::new();
    for (n, value) in values.into_iter().enumerate() {
        let space = if n == 0 { "" } else { " " };
        // Without a minus sign before 0.
        write!(text, "{space}{}", value + 0.0).expect("a text takes everything");
    }
    text
}

/// Lengths in mm as metres.
pub(crate) fn metres(values_mm: impl IntoIterator<Item = f64>) -> String {
    numbers(values_mm.into_iter().map(|value_mm| value_mm / MM_PER_M))
}

/// The ends of a span in radians.
pub(crate) fn radians(span: &Span<Degrees>) -> [f64; 2] {
    [span.min, span.max].map(|end| end.0.to_radians())
}

/// The common header.
pub(crate) const TITLE: &str =
    " The original Dobot Arm (V1.0, 2016): metres, radians; written by `dobot model` ";

const MM_PER_M: f64 = 1000.0;
