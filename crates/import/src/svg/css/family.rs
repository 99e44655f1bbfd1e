//! Names of fonts.

use std::borrow::Cow;

/// Quotes the fonts of a list that have a word starting with a digit (`Hershey Sans 1-stroke`):
/// many programs omit the quotes. `None` if there is no such name.
pub(super) fn quoted_families(list: &str) -> Option<String> {
    let is_quote = |sign: char| sign == '"' || sign == '\'';
    let has_number = |name: &str| {
        let mut words = name.split_whitespace();
        words.any(|word| word.starts_with(|sign: char| sign.is_ascii_digit()))
    };
    let (mut families, mut is_open, mut is_changed) = (Vec::new(), false, false);
    for family in list.split(',') {
        let is_bare =
            !is_open && !family.contains(|family| is_quote(family) || "!(\\".contains(family));
        is_open ^= family.chars().filter(|c| is_quote(*c)).count() % 2 == 1;
        if is_bare && has_number(family) {
            families.push(Cow::Owned(format!("'{}'", family.trim())));
            is_changed = true;
        } else {
            families.push(Cow::Borrowed(family));
        }
    }
    is_changed.then(|| families.join(","))
}
