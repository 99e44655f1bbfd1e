//! Lines of a TOML text, for messages.

use toml::de::{DeTable, DeValue};

/// Returns the line of a byte offset in a text, counted from 1.
#[must_use]
pub fn line_at(text: &str, offset: usize) -> usize {
    text.get(..offset)
        .map_or(1, |before| before.split('\n').count())
}

/// Returns the line of a dotted key in a TOML text, or of the nearest table that is written out.
/// `None` if the text is not TOML or has neither.
#[must_use]
pub fn line_of(text: &str, key: &str) -> Option<usize> {
    let document = DeTable::parse(text).ok()?;
    let mut table = document.get_ref();
    let mut offset = None;
    for part in key.split('.') {
        let Some((name, value)) = table.iter().find(|(name, _)| *name.get_ref() == part) else {
            break;
        };
        offset = Some(name.span().start);
        match value.get_ref() {
            DeValue::Table(inner) => table = inner,
            _ => break,
        }
    }
    offset.map(|offset| line_at(text, offset))
}
