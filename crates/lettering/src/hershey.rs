//! The Hershey fonts: letters of straight strokes on a grid, drawn in 1967 for pen plotters.
//!
//! They were created by Dr. A. V. Hershey while working at the U. S. National Bureau of Standards;
//! the format is that of James Hurt, Cognition, Inc. (see `hershey/LICENSE-HERSHEY`).
//!
//! A line of a file is a letter, from the space on: in columns 9 and 10 its left and right edge,
//! then pairs of x and y, each a character whose distance from `R` counts. ` R` lifts the pen.

use dobot_geometry::Point;

/// A font of single strokes that comes with the program.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum StrokeFont {
    /// Plain: the fastest to write.
    #[default]
    Sans,
    /// Plain, each stroke doubled.
    Bold,
    /// Handwriting whose letters join.
    Script,
    /// With serifs and thick stems.
    Serif,
    /// With serifs, slanted.
    Italic,
    /// Blackletter.
    Gothic,
}

/// A letter as lines: from x 0 to its advance, on a base line at y 0, capitals up to y -21.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Letter {
    /// Its lines; each one of a single point is a dot.
    pub strokes: Vec<Vec<Point>>,
    /// From its beginning to that of the next letter.
    pub advance: f64,
}

impl StrokeFont {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Sans,
        Self::Bold,
        Self::Script,
        Self::Serif,
        Self::Italic,
        Self::Gothic,
    ];

    /// What it is called on the command line.
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

    /// How far its letters lean to the right for each unit up.
    pub(crate) const fn slant(self) -> f64 {
        match self {
            Self::Script | Self::Italic => 0.3,
            Self::Sans | Self::Bold | Self::Serif | Self::Gothic => 0.0,
        }
    }

    /// A letter that the font itself has.
    pub(crate) fn glyph(self, character: char) -> Option<Letter> {
        let number = u32::from(character).checked_sub(u32::from(' '))?;
        let line = self.file().lines().nth(usize::try_from(number).ok()?)?;
        parse(line.as_bytes())
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

/// Where capitals stand on the grid.
const BASE_LINE: f64 = 9.0;
/// How tall capitals are on the grid.
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
    fn capitals_stand_on_the_base_line_and_are_as_tall_as_said() {
        for font in StrokeFont::ALL {
            let strokes = font.glyph('H').unwrap().strokes;
            let bounds = bounds(strokes.into_iter().flatten());
            assert!(bounds.y1.abs() <= 1.0, "{font:?} {bounds:?}");
            assert!((bounds.y0 + CAPITAL).abs() <= 1.0, "{font:?} {bounds:?}");
        }
    }
}
