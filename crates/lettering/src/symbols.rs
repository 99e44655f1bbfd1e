//! Composition of characters beyond ASCII.

use dobot_geometry::{Point, Rect};

/// The composition of a character.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Composition {
    /// Other characters in its place.
    Text(&'static str),
    /// Two overlapping letters.
    Ligature(&'static str),
    /// A small letter at the top.
    Raised(char),
    /// A letter upside down.
    Turned(char),
    /// A letter with a mark.
    Marked(char, Mark),
    /// Its own strokes: see [`read`].
    Own { strokes: &'static str, advance: f64 },
}

/// A mark above, below or across a letter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Acute,
    Grave,
    Circumflex,
    Caron,
    Diaeresis,
    Tilde,
    Ring,
    Breve,
    Macron,
    Dot,
    DoubleAcute,
    /// No mark: removes the dot.
    Dotless,
    Cedilla,
    Ogonek,
    Comma,
    /// As tall as its letter.
    Slash,
    BarRight,
    BarLeft,
    Nick,
}

impl Mark {
    pub(crate) const fn is_above(self) -> bool {
        !matches!(
            self,
            Self::Cedilla
                | Self::Ogonek
                | Self::Comma
                | Self::Slash
                | Self::BarRight
                | Self::BarLeft
                | Self::Nick
        )
    }

    /// Returns the strokes around the origin.
    pub(crate) const fn strokes(self) -> &'static str {
        match self {
            Self::Acute => "-1.5,0 2,-4.5",
            Self::Grave => "1.5,0 -2,-4.5",
            Self::Circumflex => "-3.5,0 0,-4 3.5,0",
            Self::Caron => "-3.5,-4 0,0 3.5,-4",
            Self::Diaeresis => "-4,-3 -5,-2 -4,-1 -3,-2 -4,-3; 4,-3 3,-2 4,-1 5,-2 4,-3",
            Self::Tilde => "-5,-0.5 -4,-2.5 -2.5,-3.3 -1,-2.8 1,-1.2 2.5,-0.7 4,-1.5 5,-3.5",
            Self::Ring => "0,-5 -1.8,-4.3 -2.5,-2.5 -1.8,-0.7 0,0 1.8,-0.7 2.5,-2.5 1.8,-4.3 0,-5",
            Self::Breve => "-4,-4 -3,-1.5 -1,-0.3 1,-0.3 3,-1.5 4,-4",
            Self::Macron => "-4,-2 4,-2",
            Self::Dot => "0,-3 -1,-2 0,-1 1,-2 0,-3",
            Self::DoubleAcute => "-3.5,0 -1,-4.5; 1.5,0 4,-4.5",
            Self::Dotless | Self::Slash => "",
            Self::Cedilla => "0.5,0 0,2 2,2.8 2.5,4.5 1.5,6 -0.5,6.5 -2.5,6",
            Self::Ogonek => "0,0 -2,2 -2.8,4 -2,6 0,6.5 1.5,5.5",
            Self::Comma => "0.5,3 0.5,5 -1,7",
            Self::BarRight => "-7,0 2,0",
            Self::BarLeft => "-3,0 6,0",
            Self::Nick => "-3.5,2.5 4.5,-2.5",
        }
    }

    /// Returns the point of a letter around which the mark is drawn.
    pub(crate) fn place(self, letter: Rect, top_middle: f64) -> Point {
        let (middle, height) = (letter.center(), letter.height());
        match self {
            Self::Cedilla | Self::Comma => Point::new(middle.x, letter.y1.max(0.0)),
            Self::Ogonek => Point::new(letter.x1 - 0.15 * letter.width(), letter.y1.min(0.0)),
            Self::Slash => middle,
            Self::BarRight => Point::new(letter.x1, letter.y0 + 0.19 * height),
            Self::BarLeft | Self::Nick => {
                let stem = 0.15 * letter.width();
                Point::new(letter.x0 + stem, middle.y)
            }
            _ => Point::new(top_middle, letter.y0 - GAP),
        }
    }
}

/// Returns the composition of a character beyond ASCII; `None` if there is none.
pub(crate) fn composition(character: char) -> Option<Composition> {
    let fixed = COMPOSITIONS
        .iter()
        .find(|(composition, _)| *composition == character);
    let fixed = fixed.map(|(_, composition)| *composition);
    fixed
        .or_else(|| own(character))
        .or_else(|| marked(character))
}

fn own(character: char) -> Option<Composition> {
    let line = OWN.lines().find_map(|line| line.strip_prefix(character))?;
    let (advance, strokes) = line.trim_start().split_once(' ')?;
    let advance = advance.parse().ok()?;
    Some(Composition::Own { strokes, advance })
}

fn marked(character: char) -> Option<Composition> {
    MARKED.iter().find_map(|(mark, letters, bases)| {
        let at = letters.chars().position(|letter| letter == character)?;
        Some(Composition::Marked(bases.chars().nth(at)?, *mark))
    })
}

/// Parses lines of points: `x,y x,y; x,y x,y`.
pub(crate) fn read(strokes: &str) -> Vec<Vec<Point>> {
    let point = |pair: &str| {
        let (x, y) = pair.split_once(',')?;
        Some(Point::new(x.parse().ok()?, y.parse().ok()?))
    };
    let line = |line: &str| line.split_whitespace().filter_map(point).collect();
    let lines = strokes.split(';').map(line);
    lines.filter(|line: &Vec<Point>| !line.is_empty()).collect()
}

/// The gap between a letter and the mark above it.
const GAP: f64 = 2.5;

const MARKED: &[(Mark, &str, &str)] = &[
    (
        Mark::Acute,
        "ÁÉÍÓÚÝĆĹŃŔŚŹáéíóúýćĺńŕśź",
        "AEIOUYCLNRSZaeiouyclnrsz",
    ),
    (Mark::Acute, "ΆΈΉΊΌΎΏάέήίόύώЃЌѓќ", "ΑΕΗΙΟΥΩαεηιουωГКгк"),
    (Mark::Grave, "ÀÈÌÒÙàèìòùǸǹ", "AEIOUaeiouNn"),
    (
        Mark::Circumflex,
        "ÂÊÎÔÛĈĜĤĴŜŴŶâêîôûĉĝĥĵŝŵŷ",
        "AEIOUCGHJSWYaeioucghjswy",
    ),
    (Mark::Caron, "ČĎĚŇŘŠŤŽčěňřšž", "CDENRSTZcenrsz"),
    (Mark::Diaeresis, "ÄËÏÖÜŸäëïöüÿ", "AEIOUYaeiouy"),
    (Mark::Diaeresis, "ΪΫϊϋЁЇёї", "ΙΥιυЕIеi"),
    (Mark::Breve, "Ўў", "Уу"),
    (Mark::Tilde, "ÃÑÕĨŨãñõĩũ", "ANOIUanoiu"),
    (Mark::Ring, "ÅŮåů", "AUau"),
    (Mark::Breve, "ĂĔĞĬŎŬăĕğĭŏŭ", "AEGIOUaegiou"),
    (Mark::Macron, "ĀĒĪŌŪāēīōū", "AEIOUaeiou"),
    (Mark::Dot, "ĊĖĠİŻċėġż", "CEGIZcegz"),
    (Mark::DoubleAcute, "ŐŰőű", "OUou"),
    (Mark::Dotless, "ı", "i"),
    (Mark::Cedilla, "ÇŞŢçşţ", "CSTcst"),
    (Mark::Ogonek, "ĄĘĮŲąęįų", "AEIUaeiu"),
    (Mark::Comma, "ĢĶĻŅŖȘȚķļņŗșț", "GKLNRSTklnrst"),
    (Mark::Slash, "Øø", "Oo"),
    (Mark::BarRight, "đ", "d"),
    (Mark::BarLeft, "Đ", "D"),
    (Mark::Nick, "Łł", "Ll"),
];

const COMPOSITIONS: &[(char, Composition)] = &[
    ('\u{a0}', Composition::Text(" ")),
    ('\u{202f}', Composition::Text(" ")),
    ('\u{2009}', Composition::Text(" ")),
    ('\t', Composition::Text("    ")),
    ('‘', Composition::Text("'")),
    ('’', Composition::Text("'")),
    ('‚', Composition::Text(",")),
    ('“', Composition::Text("\"")),
    ('”', Composition::Text("\"")),
    ('„', Composition::Text(",,")),
    ('…', Composition::Text("...")),
    ('‐', Composition::Text("-")),
    ('‑', Composition::Text("-")),
    ('−', Composition::Text("-")),
    ('⌀', Composition::Text("Ø")),
    ('∅', Composition::Text("Ø")),
    ('Ω', Composition::Text("Ω")),
    ('І', Composition::Text("I")),
    ('і', Composition::Text("i")),
    ('Ј', Composition::Text("J")),
    ('ј', Composition::Text("j")),
    ('Ѕ', Composition::Text("S")),
    ('ѕ', Composition::Text("s")),
    ('ď', Composition::Text("d'")),
    ('ľ', Composition::Text("l'")),
    ('Ľ', Composition::Text("L'")),
    ('ť', Composition::Text("t'")),
    ('ģ', Composition::Marked('g', Mark::Acute)),
    ('æ', Composition::Ligature("ae")),
    ('Æ', Composition::Ligature("AE")),
    ('œ', Composition::Ligature("oe")),
    ('Œ', Composition::Ligature("OE")),
    ('¹', Composition::Raised('1')),
    ('²', Composition::Raised('2')),
    ('³', Composition::Raised('3')),
    ('¿', Composition::Turned('?')),
    ('¡', Composition::Turned('!')),
];

/// Characters with their own strokes, one per line: the character, its advance, and its strokes in
/// the format of [`read`].
const OWN: &str = "\
ß 16 3,0 3,-15 3.5,-18 5,-20.3 7.5,-21 10,-20.5 11.5,-18.5 11.5,-16 10.5,-13.8 8,-12 10.5,-11 12.5,-9 13.2,-6 12.5,-3 10.5,-0.7 8,0 6,-0.3
ẞ 17 3,0 3,-15 4,-19 7,-21 13,-21 9,-13 11.5,-12 13.5,-9.5 14,-6 13,-2.5 10.5,-0.4 8,0 6,-0.5
€ 19 16,-17.5 14,-20 11,-21 8.5,-20.5 6,-18.5 4.5,-15 4,-10.5 4.5,-6 6,-2.5 8.5,-0.5 11,0 14,-1 16,-3.5; 1.5,-12.5 12.5,-12.5; 1.5,-8.5 11.5,-8.5
£ 18 15,-17 14,-19.7 11.5,-21 9,-20.5 7.3,-18.5 7,-15 7.5,-10 7.3,-5.5 6,-2 3,0; 3,0 15.5,0; 3,-10.5 12,-10.5
¥ 18 2,-21 9,-10.5 16,-21; 9,-10.5 9,0; 4,-9.5 14,-9.5; 4,-5.5 14,-5.5
§ 16 11.5,-18 10.5,-20.2 8,-21 5.5,-20.5 4,-18.5 4.3,-16.5 6,-14.5 10.5,-11.5 12.2,-9.3 12.5,-7 11,-5; 5.5,-12.8 3.8,-11 3.5,-8.7 5,-6.5 9.5,-3.5 11.2,-1.5 11.5,0.5 10,2.5 7.5,3 5,2.2 4,0
ς 15 12.5,-11.5 11,-13.5 8.5,-14 6,-13.2 4.2,-11 3.5,-8 4,-5 6,-2.5 9,-1 10.5,0.8 10.2,3 8.5,4.5 7,4.7
Є 20 17,-17 15,-20 12,-21 8.5,-20.5 5.5,-18 4,-14.5 3.5,-10.5 4,-6.5 5.5,-3 8.5,-0.5 12,0 15,-1 17,-4; 3.5,-11 12.5,-11
є 16 13,-11.5 11.3,-13.4 9,-14 6.3,-13.2 4.2,-10.8 3.5,-7 4.2,-3.2 6.3,-0.8 9,0 11.3,-0.6 13,-2.5; 3.5,-7 9.5,-7
Ґ 17 4,0 4,-21 15,-21 15,-25
ґ 14 4,0 4,-14 12,-14 12,-17
° 12 6,-21 3.9,-20.1 3,-18 3.9,-15.9 6,-15 8.1,-15.9 9,-18 8.1,-20.1 6,-21
× 20 4,-15 16,-3; 16,-15 4,-3
÷ 22 3,-9 19,-9; 11,-16 10,-15 11,-14 12,-15 11,-16; 11,-4 10,-3 11,-2 12,-3 11,-4
± 22 3,-11 19,-11; 11,-19 11,-3; 3,0 19,0
· 10 5,-9 4,-8 5,-7 6,-8 5,-9
• 10 5,-11 3,-10 2,-8 3,-6 5,-5 7,-6 8,-8 7,-10 5,-11; 5,-9.5 4,-8 5,-6.5 6,-8 5,-9.5
µ 19 4,-14 4,7; 4,-4 5,-1 7,0 9,0 11,-1 14,-4; 14,-14 14,0
↑ 18 9,0 9,-21; 3,-14 9,-21 15,-14
√ 17 1,-8 4,-9.5 9,0 16,-24
– 18 2,-9 16,-9
— 26 1,-9 25,-9
« 17 8,-13 3,-7.5 8,-2; 14,-13 9,-7.5 14,-2
» 17 3,-13 8,-7.5 3,-2; 9,-13 14,-7.5 9,-2
‹ 11 8,-13 3,-7.5 8,-2
› 11 3,-13 8,-7.5 3,-2
© 26 13,-21 8.6,-20.1 5.3,-17.7 3.2,-14.5 2.5,-10.5 3.2,-6.5 5.3,-3.3 8.6,-0.9 13,0 17.4,-0.9 20.7,-3.3 22.8,-6.5 23.5,-10.5 22.8,-14.5 20.7,-17.7 17.4,-20.1 13,-21; 17,-13 15.5,-15 13,-15.5 10.5,-14.5 9,-12.5 8.7,-10.5 9,-8.5 10.5,-6.5 13,-5.5 15.5,-6 17,-8
® 26 13,-21 8.6,-20.1 5.3,-17.7 3.2,-14.5 2.5,-10.5 3.2,-6.5 5.3,-3.3 8.6,-0.9 13,0 17.4,-0.9 20.7,-3.3 22.8,-6.5 23.5,-10.5 22.8,-14.5 20.7,-17.7 17.4,-20.1 13,-21; 10,-5 10,-16 14,-16 16,-15 16.5,-13 16,-11 14,-10 10,-10; 13.5,-10 16.5,-5";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_marked_letter_has_a_base() {
        for (mark, letters, bases) in MARKED {
            assert_eq!(letters.chars().count(), bases.chars().count(), "{mark:?}");
        }
    }

    #[test]
    fn all_strokes_read() {
        let own =
            OWN.lines().map(
                |line| match composition(line.chars().next().unwrap_or_default()) {
                    Some(Composition::Own { strokes, .. }) => strokes,
                    other => panic!("{line} is {other:?}"),
                },
            );
        for strokes in own {
            let points: usize = read(strokes).iter().map(Vec::len).sum();
            assert_eq!(points, strokes.matches(',').count(), "{strokes}");
        }
    }
}
