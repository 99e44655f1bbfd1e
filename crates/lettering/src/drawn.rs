//! A small alphabet of lines, drawn by hand.

use std::fmt::Write as _;

/// A line of text as an SVG group: its left end, middle or right end at `x`, its foot at `y`, capitals
/// `height` tall. Small letters are written as capitals.
#[must_use]
pub fn lettering(text: &str, anchor: Anchor, x: f64, y: f64, height: f64) -> String {
    let scale = height / HIGH;
    let x = match anchor {
        Anchor::Left => x,
        Anchor::Middle => x - width(text, height) / 2.0,
        Anchor::Right => x - width(text, height),
    };
    let mut group = format!(
        r#"<g transform="translate({x:.2} {:.2}) scale({scale:.4})">"#,
        y - height
    );
    let mut at = 0.0;
    for (path, width) in text.chars().map(glyph) {
        if !path.is_empty() {
            write!(
                group,
                r#"<path transform="translate({at:.2})" d="{path}"/>"#
            )
            .expect("writing to a string works");
        }
        at += width + GAP;
    }
    group + "</g>"
}

/// How wide a line of text is whose capitals are so tall.
#[must_use]
pub fn width(text: &str, height: f64) -> f64 {
    let advance: f64 = text.chars().map(|c| glyph(c).1 + GAP).sum();
    (advance - GAP).max(0.0) * height / HIGH
}

/// Where a text is held.
#[derive(Clone, Copy, Debug)]
pub enum Anchor {
    /// At its left end.
    Left,
    /// In its middle.
    Middle,
    /// At its right end.
    Right,
}

/// The letter without its accent: titles hold names.
const fn plain(c: char) -> char {
    match c {
        'À'..='Å' | 'à'..='å' => 'A',
        'Ç' | 'ç' => 'C',
        'È'..='Ë' | 'è'..='ë' => 'E',
        'Ì'..='Ï' | 'ì'..='ï' => 'I',
        'Ñ' | 'ñ' => 'N',
        'Ò'..='Ö' | 'ò'..='ö' | 'Ø' | 'ø' => 'O',
        'Ù'..='Ü' | 'ù'..='ü' => 'U',
        'ß' => 'S',
        _ => c,
    }
}

/// The lines of a letter and its width, on a grid where capitals stand from y 0 to y 6.
fn glyph(c: char) -> (&'static str, f64) {
    match plain(c).to_ascii_uppercase() {
        ' ' => ("", 1.6),
        'A' => ("M0 6L2 0L4 6M.7 4H3.3", 4.0),
        'B' => (
            "M2.2 2.8H0M0 0V6H2.3A1.6 1.6 0 0 0 2.3 2.8M0 0H2A1.4 1.4 0 0 1 2 2.8",
            3.9,
        ),
        'C' => ("M4 1.2A2.2 3 0 1 0 4 4.8", 4.0),
        'D' => ("M0 0V6H1.4A2.6 3 0 0 0 1.4 0Z", 4.0),
        'E' => ("M3.3 0H0V6H3.3M0 2.9H2.7", 3.3),
        'F' => ("M3.3 0H0V6M0 2.9H2.7", 3.2),
        'G' => ("M4 1.2A2.2 3 0 1 0 4.1 4.4V3.3H2.5", 4.1),
        'H' => ("M0 0V6M3.8 0V6M0 2.9H3.8", 3.8),
        'I' => ("M0 0V6", 0.0),
        'J' => ("M2.6 0V4.4A1.3 1.6 0 0 1 0 4.4", 2.6),
        'K' => ("M0 0V6M3.7 0L0 3.6M1.3 2.4L3.9 6", 3.9),
        'L' => ("M0 0V6H3.1", 3.0),
        'M' => ("M0 6V0L2.3 3.8L4.6 0V6", 4.6),
        'N' => ("M0 6V0L3.9 6V0", 3.9),
        'O' => ("M2.2 0A2.2 3 0 1 0 2.2 6A2.2 3 0 1 0 2.2 0", 4.4),
        'P' => ("M0 6V0H2.1A1.65 1.65 0 0 1 2.1 3.3H0", 3.7),
        'Q' => (
            "M2.2 0A2.2 3 0 1 0 2.2 6A2.2 3 0 1 0 2.2 0M2.7 4.3L4.3 6.3",
            4.4,
        ),
        'R' => ("M0 6V0H2.1A1.65 1.65 0 0 1 2.1 3.3H0M2.1 3.3L3.8 6", 3.8),
        'S' => (
            "M3.4 1A1.7 1.45 0 0 0 1.8 0A1.6 1.45 0 0 0 1.8 2.9A1.75 1.55 0 0 1 1.8 6A1.9 1.7 0 0 1 0 4.9",
            3.5,
        ),
        'T' => ("M0 0H3.8M1.9 0V6", 3.8),
        'U' => ("M0 0V4A1.9 2 0 0 0 3.8 4V0", 3.8),
        'V' => ("M0 0L2 6L4 0", 4.0),
        'W' => ("M0 0L1.4 6L2.8 1L4.2 6L5.6 0", 5.6),
        'X' => ("M0 0L3.8 6M3.8 0L0 6", 3.8),
        'Y' => ("M0 0L2 3L4 0M2 3V6", 4.0),
        'Z' => ("M0 0H3.7L0 6H3.7", 3.7),
        '0' => ("M1.8 0A1.8 3 0 1 0 1.8 6A1.8 3 0 1 0 1.8 0", 3.6),
        '1' => ("M.6 1.3L2.1 0V6", 2.7),
        '2' => ("M.1 1.6A1.7 1.6 0 1 1 3.1 2.6L0 6H3.6", 3.6),
        '3' => ("M.2 .8A1.6 1.4 0 1 1 1.6 2.8A1.7 1.6 0 1 1 0 5", 3.3),
        '4' => ("M2.8 6V0L0 4.2H3.8", 3.8),
        '5' => ("M3.2 0H.6L.3 2.7A1.85 1.8 0 1 1 0 5.1", 3.5),
        '6' => ("M3 .2A3.4 4.2 0 0 0 0 4.1A1.8 1.9 0 1 0 .3 3.1", 3.6),
        '7' => ("M0 0H3.5L1.2 6", 3.5),
        '8' => (
            "M1.8 0A1.5 1.4 0 1 0 1.8 2.8A1.8 1.6 0 1 0 1.8 6A1.8 1.6 0 1 0 1.8 2.8A1.5 1.4 0 1 0 1.8 0",
            3.6,
        ),
        '9' => ("M.6 5.8A3.4 4.2 0 0 0 3.6 1.9A1.8 1.9 0 1 0 3.3 2.9", 3.6),
        '.' => ("M0 5.95V6", 0.0),
        ',' => ("M.3 5.7L0 6.9", 0.4),
        ':' => ("M0 2.2V2.25M0 5.95V6", 0.0),
        '-' | '\u{2013}' => ("M0 3.2H2", 2.0),
        '+' => ("M0 3.2H3M1.5 1.7V4.7", 3.0),
        '/' => ("M0 6.4L2.4 -.4", 2.4),
        '(' => ("M1.1 -.5A5.5 5.5 0 0 0 1.1 6.7", 1.1),
        ')' => ("M0 -.5A5.5 5.5 0 0 1 0 6.7", 1.1),
        '%' => (
            "M.4 6L3.6 0M.9 .2A.9 1 0 1 0 .9 2.2A.9 1 0 1 0 .9 .2M3.1 3.8A.9 1 0 1 0 3.1 5.8A.9 1 0 1 0 3.1 3.8",
            4.0,
        ),
        '\u{d7}' => ("M0 2.2L2.4 4.6M2.4 2.2L0 4.6", 2.4),
        '\u{b7}' => ("M0 3.15V3.2", 0.0),
        '\u{b0}' => ("M.9 0A.8 .8 0 1 0 .9 1.6A.8 .8 0 1 0 .9 0", 1.7),
        '#' => ("M.9 6L1.9 0M2.5 6L3.5 0M.3 2H4.2M0 4H3.9", 4.2),
        '_' => ("M0 6.5H3.4", 3.4),
        '\'' => ("M0 0V1.3", 0.0),
        _ => ("M0 0H3V6H0Z", 3.0),
    }
}

const HIGH: f64 = 6.0;
const GAP: f64 = 1.7;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_glyph_is_a_path_that_reads() {
        for c in (' '..='~').chain("×·–°".chars()) {
            let (path, width) = glyph(c);
            assert!(
                svgtypes::PathParser::from(path).all(|s| s.is_ok()),
                "{c}: {path}"
            );
            assert!((0.0..6.0).contains(&width));
        }
    }

    #[test]
    fn letters_with_accents_are_written_without_them() {
        let written = |text| lettering(text, Anchor::Left, 0.0, 0.0, 6.0);
        assert_eq!(written("Grüße, Çelik"), written("GRUSE, CELIK"));
    }

    #[test]
    fn small_letters_are_written_as_capitals() {
        let group = |text| lettering(text, Anchor::Left, 0.0, 6.0, 6.0);
        assert_eq!(group("mm"), group("MM"));
        assert_eq!(width("II", 6.0), GAP);
    }
}
