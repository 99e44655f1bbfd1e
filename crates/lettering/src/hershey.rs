//! The Hershey single-stroke fonts, digitised in 1967 for pen plotters.
//!
//! They were created by Dr. A. V. Hershey while working at the U. S. National Bureau of Standards;
//! the format is that of James Hurt, Cognition, Inc. (see `hershey/LICENSE-HERSHEY`).
//!
//! Each line of a file is a glyph, starting with the space: columns 9 and 10 hold its left and
//! right edge, followed by pairs of x and y. Each coordinate is a character's distance from `R`. `
//! R` lifts the pen.

use dobot_geometry::Point;

/// A single-stroke font built into the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum StrokeFont {
    /// Plain; the fastest to write.
    #[default]
    Sans,
    /// Plain with doubled strokes.
    Bold,
    /// Connected handwriting.
    Script,
    /// With serifs and thick stems.
    Serif,
    /// With serifs, slanted.
    Italic,
    /// Blackletter.
    Gothic,
}

/// A glyph as lines: from x 0 to its advance, on a baseline at y 0, with capitals up to y -21.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Letter {
    /// The lines; a line of a single point is a dot.
    pub strokes: Vec<Vec<Point>>,
    /// The distance from its origin to that of the next glyph.
    pub advance: f64,
}

impl StrokeFont {
    /// All fonts.
    pub const ALL: [Self; 6] = [
        Self::Sans,
        Self::Bold,
        Self::Script,
        Self::Serif,
        Self::Italic,
        Self::Gothic,
    ];

    /// Returns the name used on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Sans => "sans",
            Self::Bold => "bold",
            Self::Script => "script",
            Self::Serif => "serif",
            Self::Italic => "italic",
            Self::Gothic => "gothic",
        }
    }

    /// Returns the font for a family name in a file: `Hershey` with one of our names, or an
    /// Inkscape name such as `Hershey script`, `Hershey Sans 1-stroke`, `HersheySerifMed`.
    ///
    /// ```
    /// use dobot_lettering::StrokeFont;
    ///
    /// assert_eq!(StrokeFont::of_family("Hershey Script 1-stroke"), Some(StrokeFont::Script));
    /// assert_eq!(StrokeFont::of_family("Helvetica"), None);
    /// ```
    #[must_use]
    pub fn of_family(name: &str) -> Option<Self> {
        let letters = name.chars().filter(char::is_ascii_alphanumeric);
        let name = letters.collect::<String>().to_ascii_lowercase();
        Some(match name.strip_prefix("hershey")? {
            "" | "text" | "sans" | "sans1" | "sans1stroke" => Self::Sans,
            "bold" | "sansmed" | "sansmedium" => Self::Bold,
            "script" | "script1" | "script1stroke" | "scriptmed" | "scriptmedium" => Self::Script,
            "serif" | "serifmed" | "serifmedium" | "serifbold" => Self::Serif,
            "italic" | "serifmeditalic" | "serifmediumitalic" | "serifbolditalic" => Self::Italic,
            "gothic" | "gothenglish" | "gothicenglish" => Self::Gothic,
            _ => return None,
        })
    }

    /// Returns the slant: the shift to the right per unit upwards.
    pub(crate) const fn slant(self) -> f64 {
        match self {
            Self::Script | Self::Italic => 0.3,
            Self::Sans | Self::Bold | Self::Serif | Self::Gothic => 0.0,
        }
    }

    /// Returns a glyph of the font itself; Greek and Cyrillic letters come from the matching font.
    pub(crate) fn glyph(self, character: char) -> Option<Letter> {
        let place = |alphabet: &str| alphabet.chars().position(|letter| letter == character);
        let (file, number) = if let Some(number) = place(GREEK) {
            (self.greek(), number)
        } else if let Some(number) = place(CYRILLIC) {
            (include_str!("hershey/cyrillic.jhf"), number)
        } else {
            let number = u32::from(character).checked_sub(u32::from(' '))?;
            (self.file(), usize::try_from(number).ok()?)
        };
        parse(file.lines().nth(number)?.as_bytes())
    }

    const fn greek(self) -> &'static str {
        match self {
            Self::Sans | Self::Script => include_str!("hershey/greek.jhf"),
            Self::Bold | Self::Serif | Self::Italic | Self::Gothic => {
                include_str!("hershey/greek-serif.jhf")
            }
        }
    }

    const fn file(self) -> &'static str {
        match self {
            Self::Sans => include_str!("hershey/sans.jhf"),
            Self::Bold => include_str!("hershey/bold.jhf"),
            Self::Script => include_str!("hershey/script.jhf"),
            Self::Serif => include_str!("hershey/serif.jhf"),
            Self::Italic => include_str!("hershey/italic.jhf"),
            Self::Gothic => include_str!("hershey/gothic.jhf"),
        }
    }
}

fn parse(line: &[u8]) -> Option<Letter> {
    let grid = |byte: u8| f64::from(byte) - f64::from(b'R');
    let (edges, pairs) = line.get(8..)?.split_at_checked(2)?;
    let [left, right] = [grid(edges[0]), grid(edges[1])];
    let strokes = pairs.chunks_exact(2).collect::<Vec<_>>();
    let lines = strokes.split(|pair| *pair == b" R");
    let point = |pair: &&[u8]| Point::new(grid(pair[0]) - left, grid(pair[1]) - BASE_LINE);
    let strokes = lines.map(|line| line.iter().map(point).collect::<Vec<_>>());
    Some(Letter {
        strokes: strokes.filter(|line| !line.is_empty()).collect(),
        advance: right - left,
    })
}

/// The letters of the Greek files, in file order.
const GREEK: &str = "ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩαβγδεζηθικλμνξοπρστυφχψω";
/// The letters of the Cyrillic file, in file order.
const CYRILLIC: &str = "АБВГДЕЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯабвгдежзийклмнопрстуфхцчшщъыьэюя";
/// The baseline on the grid.
const BASE_LINE: f64 = 9.0;
/// The height of capitals on the grid.
pub const CAPITAL: f64 = 21.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;
    use dobot_geometry::bounds;

    #[test]
    fn every_font_has_every_ascii_character() {
        for font in StrokeFont::ALL {
            for character in ' '..='~' {
                let letter = font.glyph(character).unwrap();
                assert!(letter.advance > 0.0, "{font:?} {character}");
                assert_eq!(
                    letter.strokes.is_empty(),
                    character == ' ',
                    "{font:?} {character}"
                );
            }
        }
    }

    #[test]
    fn every_font_has_the_greek_and_the_cyrillic_alphabet() {
        for font in StrokeFont::ALL {
            for character in GREEK.chars().chain(CYRILLIC.chars()) {
                let letter = font.glyph(character).unwrap();
                assert!(!letter.strokes.is_empty(), "{font:?} {character}");
                let ink = bounds(letter.strokes.into_iter().flatten());
                assert!(
                    ink.y0 >= -CAPITAL - 8.0 && ink.y1 <= 8.0,
                    "{font:?} {character} {ink:?}"
                );
            }
        }
    }

    #[test]
    fn letters_of_the_same_shape_have_the_same_height_in_all_alphabets() {
        for font in StrokeFont::ALL {
            for (latin, others) in [('H', "ΗН"), ('M', "ΜМ"), ('P', "ΡР"), ('T', "ΤТ")] {
                // The Gothic P descends below the baseline.
                let others = others.chars();
                for other in others.filter(|_| font != StrokeFont::Gothic || latin != 'P') {
                    let height =
                        |letter| bounds(font.glyph(letter).unwrap().strokes.concat()).height();
                    let off = (height(other) - height(latin)).abs();
                    assert!(off <= 2.0, "{font:?} {latin} {other}: {off}");
                }
            }
        }
    }

    #[test]
    fn capitals_stand_on_the_base_line_and_have_the_given_height() {
        for font in StrokeFont::ALL {
            let strokes = font.glyph('H').unwrap().strokes;
            let bounds = bounds(strokes.into_iter().flatten());
            assert!(bounds.y1.abs() <= 1.0, "{font:?} {bounds:?}");
            assert!((bounds.y0 + CAPITAL).abs() <= 1.0, "{font:?} {bounds:?}");
        }
    }
}
