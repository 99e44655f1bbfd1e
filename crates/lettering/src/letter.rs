//! Glyphs composed of those in a font.

use dobot_geometry::{Point, Rect, Vec2, bounds};

use crate::hershey::{CAPITAL, Letter, StrokeFont};
use crate::smooth::smooth;
use crate::symbols::{self, Composition, Mark};

impl Letter {
    /// Returns the glyph for a character; `None` if the font lacks it and it cannot be composed.
    #[must_use]
    pub fn of(font: StrokeFont, character: char) -> Option<Self> {
        if let Some(glyph) = font.glyph(character) {
            return Some(glyph);
        }
        match symbols::composition(character)? {
            Composition::Text(text) => Self::sequence(font, text, 0.0),
            Composition::Ligature(text) => Self::sequence(font, text, LIGATURE),
            Composition::Raised(base) => Some(Self::of(font, base)?.raised()),
            Composition::Turned(base) => Some(Self::of(font, base)?.turned()),
            Composition::Own { strokes, advance } => {
                Some(Self::drawn(strokes, advance, font.slant()))
            }
            Composition::Marked(base, mark) => {
                Some(Self::of(font, base)?.marked(mark, font.slant()))
            }
        }
    }

    /// Rounds gentle corners, within a tolerance in grid units.
    #[must_use]
    pub fn rounded(&self, font: StrokeFont, tolerance: f64) -> Self {
        let is_gothic = font == StrokeFont::Gothic;
        let round = |points: &Vec<Point>| {
            let sharp = match (is_gothic, is_dot(points)) {
                (true, _) => SHARP_GOTHIC,
                (false, true) => ROUND,
                (false, false) => SHARP,
            };
            smooth(points, sharp, tolerance)
        };
        Self {
            strokes: self.strokes.iter().map(round).collect(),
            advance: self.advance,
        }
    }

    fn sequence(font: StrokeFont, text: &str, overlap: f64) -> Option<Self> {
        let mut whole = Self::default();
        for character in text.chars() {
            let next = Self::of(font, character)?;
            let start = (whole.advance - overlap).max(0.0);
            whole.advance = start + next.advance;
            whole
                .strokes
                .extend(next.each(|p| p + Vec2::new(start, 0.0)).strokes);
        }
        Some(whole)
    }

    fn drawn(strokes: &str, advance: f64, slant: f64) -> Self {
        let letter = Self {
            strokes: symbols::read(strokes),
            advance,
        };
        letter.each(|p| leaning(p, slant))
    }

    fn each(mut self, change: impl Fn(Point) -> Point) -> Self {
        for p in self.strokes.iter_mut().flatten() {
            *p = change(*p);
        }
        self
    }

    fn raised(self) -> Self {
        let advance = self.advance * RAISED;
        let up = Vec2::new(0.0, CAPITAL * (RAISED - 1.0));
        let small = self.each(|p| (p.to_vec2() * RAISED + up).to_point());
        Self { advance, ..small }
    }

    /// Turns the glyph upside down, as at the start of a Spanish question.
    fn turned(self) -> Self {
        let (width, middle) = (self.advance, X_HEIGHT);
        self.each(|p| Point::new(width - p.x, -middle - p.y))
    }

    fn marked(mut self, mark: Mark, slant: f64) -> Self {
        if mark.is_above() {
            self.strokes.retain(|stroke| !is_dot_above(stroke));
        }
        if mark == Mark::Slash {
            self.strokes.push(slash(self.bounds()));
            return self;
        }
        let at = mark.place(self.bounds(), self.top_middle());
        let lines = symbols::read(mark.strokes()).into_iter();
        let lines = lines.map(|line| {
            line.into_iter()
                .map(|p| leaning(p, slant) + at.to_vec2())
                .collect()
        });
        self.strokes.extend(lines);
        self
    }

    fn bounds(&self) -> Rect {
        bounds(self.strokes.iter().flatten().copied())
    }

    /// Returns the middle of the highest part.
    fn top_middle(&self) -> f64 {
        let ink = self.bounds();
        let limit = ink.y0 + 0.35 * ink.height();
        let upper = self.strokes.iter().flatten().filter(|p| p.y <= limit);
        bounds(upper.copied()).center().x
    }
}

/// Returns a stroke across the whole letter and slightly beyond.
fn slash(letter: Rect) -> Vec<Point> {
    let [low, high] = [Vec2::new(-1.0, 1.5), Vec2::new(1.0, -1.5)];
    let foot = Point::new(letter.x0, letter.y1) + low;
    vec![foot, Point::new(letter.x1, letter.y0) + high]
}

fn leaning(p: Point, slant: f64) -> Point {
    Point::new(p.x - slant * p.y, p.y)
}

/// Whether a stroke is the dot of an i or j, which a mark replaces.
fn is_dot_above(stroke: &[Point]) -> bool {
    let bounds = bounds(stroke.iter().copied());
    bounds.y1 < -X_HEIGHT - 1.0 && bounds.height() <= 4.0 && bounds.width() <= 5.0
}

/// Whether the points are a full stop or similar: a small square on its corner.
fn is_dot(points: &[Point]) -> bool {
    let is_near = |p: &Point| p.distance(points[0]) <= 2.5;
    points.len() > 3 && points.first() == points.last() && points.iter().all(is_near)
}

const X_HEIGHT: f64 = 14.0;
const RAISED: f64 = 0.6;
/// The overlap of the letters in æ and œ.
const LIGATURE: f64 = 4.0;
/// The turn above which a corner stays sharp, in radians.
const SHARP: f64 = 0.95;
const SHARP_GOTHIC: f64 = 0.6;
/// Larger than any turn, so that every corner is rounded.
const ROUND: f64 = 4.0;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn names_of_all_europe_can_be_written_in_every_font() {
        let text = "ÀÁÂÃÄÅÆÇÈÉÊËÌÍÎÏÑÒÓÔÕÖØÙÚÛÜÝßàáâãäåæçèéêëìíîïñòóôõöøùúûüýÿ\
            ĀāĂăĄąĆćĈĉĊċČčĎďĐđĒēĔĕĖėĘęĚěĜĝĞğĠġĢģĤĥĨĩĪīĬĭĮįİıĴĵĶķĹĺĻļĽľŁłŃńŅņŇňŌōŎŏŐőŒœ\
            ŔŕŖŗŘřŚśŜŝŞşŠšŢţŤťŨũŪūŬŭŮůŰűŲųŴŵŶŷŸŹźŻżŽžȘșȚțẞ\
            €£¥§°×÷±·•µ¹²³«»‹›„“”‚‘’–—…¿¡©®\u{a0}";
        for font in StrokeFont::ALL {
            let missing: String = text
                .chars()
                .filter(|&letter| Letter::of(font, letter).is_none())
                .collect();
            assert_eq!(missing, "", "{font:?}");
        }
    }

    #[test]
    fn a_mark_is_above_its_letter_and_a_cedilla_below() {
        for font in StrokeFont::ALL {
            let top = |c| Letter::of(font, c).unwrap().bounds().y0;
            let foot = |c| Letter::of(font, c).unwrap().bounds().y1;
            assert!(
                top('ü') < top('u') - 2.0 && top('Ü') < top('U') - 2.0,
                "{font:?}"
            );
            assert!(foot('ç') > foot('c') + 2.0, "{font:?}");
        }
    }

    #[test]
    fn an_i_with_an_accent_has_no_dot() {
        let strokes = |c| Letter::of(StrokeFont::Sans, c).unwrap().strokes.len();
        assert_eq!(strokes('í'), strokes('i'));
        assert_eq!(strokes('ı'), strokes('i') - 1);
    }

    #[test]
    fn letters_of_no_european_language_cannot_be_made() {
        assert_eq!(Letter::of(StrokeFont::Sans, '漢'), None);
        assert_eq!(Letter::of(StrokeFont::Sans, '\u{7}'), None);
    }
}
