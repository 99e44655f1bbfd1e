//! The text of an entity without its format codes.

use dobot_lettering::StrokeFont;

use crate::text::composed;

/// A text to be written.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Content {
    pub(super) text: String,
    /// Whether codes were removed that would be visible even in a single font: underlines,
    /// different heights and widths, fractions.
    pub(super) is_plainer: bool,
}

impl Content {
    /// Composes letters and their combining marks if the letters for DXF texts have them.
    pub(super) fn composed(self) -> Self {
        let text = composed(&self.text, StrokeFont::Sans).into_owned();
        Self { text, ..self }
    }
}

/// Parses the value of TEXT and similar entities: one line, with codes of two percent signs.
pub(super) fn line(value: &str) -> Content {
    let mut reader = CodeReader::new(value);
    while let Some(character) = reader.next() {
        match character {
            '%' if reader.rest.starts_with('%') => reader.percent(),
            '\\' if reader.unicode() => {}
            _ => reader.push(character),
        }
    }
    reader.content
}

/// Parses the value of MTEXT: several lines, also with backslash codes.
pub(super) fn lines(value: &str) -> Content {
    let mut reader = CodeReader::new(value);
    while let Some(character) = reader.next() {
        match character {
            '%' if reader.rest.starts_with('%') => reader.percent(),
            '\\' if reader.unicode() => {}
            '\\' => reader.backslash(),
            '^' => reader.caret(),
            '{' | '}' => {}
            _ => reader.push(character),
        }
    }
    reader.content
}

struct CodeReader<'a> {
    rest: &'a str,
    content: Content,
}

impl<'a> CodeReader<'a> {
    fn new(rest: &'a str) -> Self {
        Self {
            rest,
            content: Content::default(),
        }
    }

    fn next(&mut self) -> Option<char> {
        let character = self.rest.chars().next()?;
        self.rest = &self.rest[character.len_utf8()..];
        Some(character)
    }

    fn push(&mut self, character: char) {
        self.content.text.push(character);
    }

    /// Parses `%%c` after its first percent sign.
    fn percent(&mut self) {
        self.next();
        let number = self.rest.get(..3).and_then(|rest| rest.parse::<u8>().ok());
        if let Some(number) = number {
            self.rest = &self.rest[3..];
            return self.push(char::from(number));
        }
        match self.next() {
            Some('c' | 'C') => self.push('Ø'),
            Some('d' | 'D') => self.push('°'),
            Some('p' | 'P') => self.push('±'),
            // Underline, overline and strikethrough.
            Some('u' | 'U' | 'o' | 'O' | 'k' | 'K') => self.content.is_plainer = true,
            Some('%') => self.push('%'),
            Some(other) => self.content.text.extend(['%', '%', other]),
            None => self.content.text.push_str("%%"),
        }
    }

    /// Parses `\U+00E4` after its backslash; returns whether it is one.
    fn unicode(&mut self) -> bool {
        let digits = self.rest.strip_prefix("U+").and_then(|rest| rest.get(..4));
        let number = digits.and_then(|digit| u32::from_str_radix(digit, 16).ok());
        let Some(number) = number else {
            return false;
        };
        self.rest = &self.rest["U+0000".len()..];
        self.push(char::from_u32(number).unwrap_or(char::REPLACEMENT_CHARACTER));
        true
    }

    /// Parses an MTEXT code after its backslash.
    fn backslash(&mut self) {
        match self.next() {
            Some('P' | 'X' | 'N') => self.push('\n'),
            Some('~') => self.push(' '),
            Some('S') => self.fraction(),
            Some('f' | 'F' | 'C' | 'c' | 'A' | 'p') => _ = self.argument(),
            Some('H' | 'W' | 'Q' | 'T') => {
                self.argument();
                self.content.is_plainer = true;
            }
            Some('L' | 'O' | 'K') => self.content.is_plainer = true,
            // Line breaks.
            Some('l' | 'o' | 'k') => {}
            // A backslash and braces; other codes are unknown.
            Some(other) => self.push(other),
            None => self.push('\\'),
        }
    }

    /// Parses `\S1/2;`, a stacked fraction.
    fn fraction(&mut self) {
        let argument = self.argument();
        let text = argument.replace("^ ", " ").replace(['^', '#'], "/");
        self.content.text.push_str(text.trim());
        self.content.is_plainer = true;
    }

    /// Reads up to a semicolon, or to the end of the text if it is missing.
    fn argument(&mut self) -> &'a str {
        let (argument, rest) = self.rest.split_once(';').unwrap_or((self.rest, ""));
        self.rest = rest;
        argument
    }

    /// Converts `^I` to a tab, `^J` to a new line and `^ ` to a caret.
    fn caret(&mut self) {
        match self.next() {
            Some('I') => self.push(' '),
            Some('J') => self.push('\n'),
            Some('M') => {}
            Some(' ') | None => self.push('^'),
            Some(other) => self.content.text.extend(['^', other]),
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn codes_of_a_line_become_characters() {
        for (value, wanted, is_plainer) in [
            ("%%c20%%p0.1 45%%d 50%%%", "Ø20±0.1 45° 50%", false),
            ("%%C %%D %%P %%065", "Ø ° ± A", false),
            ("%%uunder%%u %%oover", "under over", true),
            (r"\U+00E4\U+2205", "ä∅", false),
            (
                r"\U+D800\U+12 50% {a}\P^J",
                "\u{FFFD}\\U+12 50% {a}\\P^J",
                false,
            ),
            ("100%%", "100%%", false),
            ("%%q %%ä", "%%q %%ä", false),
        ] {
            let text = wanted.to_owned();
            assert_eq!(line(value), Content { text, is_plainer }, "{value}");
        }
    }

    #[test]
    fn codes_of_lines_are_left_out() {
        for (value, wanted, is_plainer) in [
            (
                r"one\Ptwo\Xthree\~four^Jfive^Isix",
                "one\ntwo\nthree four\nfive six",
                false,
            ),
            (
                r"{\fArial|b0|i1|c0|p34;a}\A1;b\C1;c\pi0,l2;d{\c255;e}",
                "abcde",
                false,
            ),
            (r"\\ \{\} %%c \U+00B0 ^ 2", r"\ {} Ø ° ^2", false),
            (r"\H2.5x;a\W0.8;b\Q15;c\T2;d", "abcd", true),
            (r"\Lunder\l \Oover\o", "under over", true),
            (r"5{\H0.7x;\S1/2;}", "51/2", true),
            (r"\S1#4; \S+0.1^-0.2; \S+0.1^ ;", "1/4 +0.1/-0.2 +0.1", true),
            (r"\Sopen", "open", true),
            (r"end\", r"end\", false),
            ("{a", "a", false),
        ] {
            let text = wanted.to_owned();
            assert_eq!(lines(value), Content { text, is_plainer }, "{value}");
        }
    }

    proptest! {
        #[test]
        fn any_text_is_read(text in "(\\\\[A-Za-z~]?|%%[a-z0-9]?|\\\\U\\+|[;^{}/# ä漢0-9]){0,30}") {
            line(&text);
            lines(&text);
        }

        #[test]
        fn text_without_codes_is_unchanged(text in "[a-zA-Z0-9 äöü.,:+-]{0,30}") {
            prop_assert_eq!(&line(&text).text, &text);
            prop_assert_eq!(&lines(&text).text, &text);
        }
    }
}
