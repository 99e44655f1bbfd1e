//! The lines of a text, wrapped at a width if requested.

use std::collections::HashMap;

use unicode_linebreak::linebreaks;

use super::{Text, Wrap};

/// A line to be written.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Line {
    /// Its text, without spaces at its end.
    pub(super) text: String,
    /// The additional width of each space between its words, in mm.
    pub(super) extra_mm: f64,
}

/// The lines of a text. `width_mm` measures a word or a run of spaces.
pub(super) fn lines(text: &Text, mut width_mm: impl FnMut(&str) -> f64) -> Vec<Line> {
    let mut known = HashMap::<String, f64>::new();
    let mut width_mm = |part: &str| {
        if let Some(width) = known.get(part) {
            return *width;
        }
        let width = width_mm(part);
        known.insert(part.to_owned(), width);
        width
    };
    let paragraphs = text.text.lines();
    match text.wrap {
        Some(wrap) => paragraphs
            .flat_map(|paragraph| wrapped(paragraph, wrap, &mut width_mm))
            .collect(),
        None => paragraphs.map(|line| Line::of(&visible(line))).collect(),
    }
}

impl Line {
    fn of(text: &str) -> Self {
        Self {
            text: text.trim_end().to_owned(),
            extra_mm: 0.0,
        }
    }

    /// The number of spaces between words; those before the first one are an indent.
    fn gaps(&self) -> usize {
        self.text.trim_start().matches(' ').count()
    }
}

/// A part of a paragraph after which a line may end (Unicode's UAX 14).
struct Piece {
    word: String,
    /// The spaces after the word, which are left out at the end of a line.
    spaces: String,
    /// Whether a hyphen is written if the line ends here.
    is_soft: bool,
}

/// Fills lines with as many pieces of a paragraph as fit. A word that is wider has its own line.
fn wrapped(paragraph: &str, wrap: Wrap, width_mm: &mut impl FnMut(&str) -> f64) -> Vec<Line> {
    let mut lines = Vec::new();
    let (mut text, mut used_mm, mut is_soft) = (String::new(), 0.0, false);
    for piece in pieces(paragraph) {
        let hyphen_mm = if piece.is_soft { width_mm("-") } else { 0.0 };
        let word_mm = width_mm(&piece.word);
        let is_full = used_mm + word_mm + hyphen_mm > wrap.width_mm;
        if is_full && !text.trim().is_empty() {
            let mut line = Line::of(&text);
            if is_soft {
                line.text.push('-');
            }
            lines.push(line);
            (text, used_mm) = (String::new(), 0.0);
        }
        used_mm += word_mm + width_mm(&piece.spaces);
        text += &piece.word;
        text += &piece.spaces;
        is_soft = piece.is_soft;
    }
    if wrap.justify {
        for line in &mut lines {
            stretch(line, wrap, width_mm);
        }
    }
    // The last line of a paragraph is not stretched.
    lines.push(Line::of(&text));
    lines
}

/// Widens the spaces of a line until it is as wide as all lines may be.
fn stretch(line: &mut Line, wrap: Wrap, width_mm: &mut impl FnMut(&str) -> f64) {
    let words = line.text.split_inclusive(' ');
    let parts = words.flat_map(|part| match part.strip_suffix(' ') {
        Some(word) => [word, " "],
        None => [part, ""],
    });
    let used_mm: f64 = parts.map(width_mm).sum();
    let gaps = u32::try_from(line.gaps()).unwrap_or(u32::MAX);
    if gaps > 0 {
        line.extra_mm = (wrap.width_mm - used_mm).max(0.0) / f64::from(gaps);
    }
}

fn pieces(paragraph: &str) -> impl Iterator<Item = Piece> + '_ {
    let mut start = 0;
    linebreaks(paragraph).map(move |(end, _)| {
        let piece = &paragraph[start..end];
        start = end;
        let word = piece.trim_end();
        Piece {
            word: visible(word),
            spaces: visible(&piece[word.len()..]),
            is_soft: word.ends_with(SOFT_HYPHEN),
        }
    })
}

/// Leaves out the characters that only mark where a line may end.
fn visible(text: &str) -> String {
    text.replace([SOFT_HYPHEN, ZERO_WIDTH_SPACE], "")
}

const SOFT_HYPHEN: char = '\u{ad}';
const ZERO_WIDTH_SPACE: char = '\u{200b}';

#[cfg(test)]
mod tests {
    use super::*;

    /// Wraps at a number of characters.
    fn wrap(text: &str, width_mm: f64, justify: bool) -> Vec<Line> {
        let text = Text {
            wrap: Some(Wrap { width_mm, justify }),
            ..Text::new(text)
        };
        lines(&text, |part| {
            f64::from(u32::try_from(part.chars().count()).unwrap_or(0))
        })
    }

    fn texts(text: &str, width_mm: f64) -> Vec<String> {
        let lines = wrap(text, width_mm, false);
        lines.into_iter().map(|line| line.text).collect()
    }

    #[test]
    fn lines_are_as_full_as_the_width_allows() {
        assert_eq!(
            texts("to be or not to be", 5.0),
            ["to be", "or", "not", "to be"]
        );
        assert_eq!(texts("to be or not to be", 9.0), ["to be or", "not to be"]);
        assert_eq!(texts("a", 5.0), ["a"]);
        assert_eq!(texts("", 5.0), Vec::<String>::new());
    }

    #[test]
    fn line_breaks_indents_and_blank_lines_are_kept() {
        let text = "Dear all,\n\n  come at\nnoon";
        assert_eq!(texts(text, 9.0), ["Dear all,", "", "  come at", "noon"]);
        assert_eq!(
            texts(text, 7.0),
            ["Dear", "all,", "", "  come", "at", "noon"]
        );
    }

    #[test]
    fn a_hyphen_is_kept_and_a_soft_one_is_written_only_where_a_line_ends() {
        assert_eq!(texts("a well-known arm", 7.0), ["a well-", "known", "arm"]);
        assert_eq!(texts("cali\u{ad}brated", 5.0), ["cali-", "brated"]);
        assert_eq!(texts("cali\u{ad}brated", 10.0), ["calibrated"]);
        // The hyphen needs a place of its own.
        assert_eq!(texts("x cali\u{ad}brated", 6.0), ["x", "cali-", "brated"]);
        assert_eq!(texts("at -5 or 20-30", 4.0), ["at", "-5", "or", "20-30"]);
    }

    #[test]
    fn words_that_belong_together_or_are_too_wide_are_not_divided() {
        assert_eq!(texts("10\u{a0}mm wide", 6.0), ["10\u{a0}mm", "wide"]);
        assert_eq!(texts("a windmill b", 4.0), ["a", "windmill", "b"]);
    }

    #[test]
    fn justified_lines_have_the_full_width_except_the_last_of_a_paragraph() {
        let lines = wrap("to be or not to be", 10.0, true);
        assert_eq!(lines[0].text, "to be or");
        assert_eq!(lines[0].extra_mm, 1.0);
        assert_eq!(lines[1].extra_mm, 0.0);
        // A single word cannot be stretched.
        assert_eq!(wrap("windmill a", 8.0, true)[0].extra_mm, 0.0);
    }

    #[test]
    fn text_without_wrapping_keeps_its_lines() {
        let text = Text::new("one\u{ad}two  \n three");
        let lines = lines(&text, |_| 1.0);
        let texts: Vec<&str> = lines.iter().map(|line| line.text.as_str()).collect();
        assert_eq!(texts, ["onetwo", " three"]);
    }
}
