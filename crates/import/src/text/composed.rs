//! Composition of letters with their combining marks.

use std::borrow::Cow;

use dobot_lettering::{Letter, StrokeFont};
use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::{compose, decompose_canonical};

/// Composes letters and their marks (Unicode's NFC), as far as the font has the result: file names
/// on macOS and texts of PDF files are decomposed.
pub(crate) fn composed(text: &str, font: StrokeFont) -> Cow<'_, str> {
    composed_for(text, |c| c.is_ascii() || Letter::of(font, c).is_some())
}

/// Composes letters and their marks, for a font that has these characters.
pub(super) fn composed_for(text: &str, has: impl Fn(char) -> bool) -> Cow<'_, str> {
    if text.is_ascii() {
        return Cow::Borrowed(text);
    }
    let mut whole = String::with_capacity(text.len());
    for character in text.nfc() {
        push(&mut whole, character, &has);
    }
    Cow::Owned(whole)
}

/// Appends a character: whole, or with as many of its marks as the font has, followed by the
/// others.
fn push(whole: &mut String, character: char, has: &impl Fn(char) -> bool) {
    let mut parts = Vec::new();
    decompose_canonical(character, |part| parts.push(part));
    let [base, marks @ ..] = parts.as_slice() else {
        return;
    };
    if has(character) || !has(*base) {
        whole.push(character);
        return;
    }
    let (mut letter, mut others) = (*base, String::new());
    for &mark in marks {
        match compose(letter, mark).filter(|composed| has(*composed)) {
            Some(marked) => letter = marked,
            None => others.push(mark),
        }
    }
    whole.push(letter);
    whole.push_str(&others);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_letter_and_its_marks_become_one_glyph_if_the_font_has_it() {
        for (parts, whole) in [
            ("Cafe\u{301}\nO\u{308}l", "Caf\u{e9}\n\u{d6}l"),
            ("caf\u{e9}", "caf\u{e9}"),
            ("plain", "plain"),
            ("\u{438}\u{306}", "\u{439}"),
            // The font has no a with a ring below, and no Hangul.
            ("a\u{325}", "a\u{325}"),
            // Nor both marks of Vietnamese on an e.
            ("\u{1ebf}", "\u{ea}\u{301}"),
            ("\u{1112}\u{1161}", "\u{d558}"),
            // A mark alone, and one after a non-letter.
            ("\u{301}", "\u{301}"),
            ("q\u{301}", "q\u{301}"),
        ] {
            assert_eq!(composed(parts, StrokeFont::Sans), whole, "{parts:?}");
        }
    }
}
