//! Layout of a line of text in plain letters.

use std::sync::LazyLock;

use dobot_geometry::{Point, Vec2};

use crate::{CAPITAL, Letter, StrokeFont};

/// The point of a text that lies at the given place.
#[derive(Clone, Copy, Debug)]
pub enum Anchor {
    /// The left end.
    Left,
    /// The middle.
    Middle,
    /// The right end.
    Right,
}

impl Anchor {
    /// Returns the left end of a text of this width.
    pub(crate) fn left(self, at: f64, width: f64) -> f64 {
        match self {
            Self::Left => at,
            Self::Middle => at - width / 2.0,
            Self::Right => at - width,
        }
    }
}

/// Returns the width of a line of text, given the height of its capitals.
#[must_use]
pub fn width(text: &str, height: f64) -> f64 {
    let advance: f64 = text.chars().map(advance).sum();
    (advance - 2.0 * BEARING).max(0.0) * height / CAPITAL
}

/// Returns the lines of a text. Its anchor lies at the given place, on the baseline; y grows
/// downwards.
#[must_use]
pub fn strokes(text: &str, anchor: Anchor, at: Point, height: f64) -> Vec<Vec<Point>> {
    let scale = height / CAPITAL;
    let left = anchor.left(at.x, width(text, height));
    placed(text)
        .flat_map(|(x, letter)| {
            let begin = Vec2::new(left + x * scale, at.y);
            let placed = move |line: Vec<Point>| {
                line.iter()
                    .map(|p| (begin + p.to_vec2() * scale).to_point())
                    .collect()
            };
            letter_of(letter).strokes.into_iter().map(placed)
        })
        .collect()
}

/// Returns the letters of a text with the offset of each from the start, in grid units.
pub(crate) fn placed(text: &str) -> impl Iterator<Item = (f64, char)> {
    text.chars().scan(-BEARING, |x, letter| {
        let begin = *x;
        *x += advance(letter);
        Some((begin, letter))
    })
}

/// Returns a plain letter, round enough for a title; a box for unknown characters. The font's full
/// stops float and its spaces are wide, which suits handwriting but not pictures, so both are
/// adapted here.
pub(crate) fn letter_of(character: char) -> Letter {
    let mut letter = Letter::of(StrokeFont::Sans, character).unwrap_or_else(missing);
    match character {
        ' ' => letter.advance = 12.0,
        '.' | ',' | ':' | ';' => {
            letter.strokes.iter_mut().flatten().for_each(|p| p.y += 3.0);
        }
        _ => {}
    }
    letter.rounded(StrokeFont::Sans, ROUND)
}

fn missing() -> Letter {
    let corners = [
        (4.0, 0.0),
        (4.0, -21.0),
        (16.0, -21.0),
        (16.0, 0.0),
        (4.0, 0.0),
    ];
    Letter {
        strokes: vec![corners.map(|(x, y)| Point::new(x, y)).to_vec()],
        advance: 20.0,
    }
}

fn advance(character: char) -> f64 {
    let ascii = u32::from(character).checked_sub(u32::from(' '));
    let known = ascii.and_then(|index| ADVANCES.get(usize::try_from(index).ok()?));
    known.map_or_else(|| letter_of(character).advance, |advance| *advance)
}

/// The advances of ASCII from the space: line breaking measures text often.
static ADVANCES: LazyLock<Vec<f64>> = LazyLock::new(|| {
    (' '..='~')
        .map(|letter| letter_of(letter).advance)
        .collect()
});

/// The bearing beside the ink of most letters: a line of text ends where its ink ends.
const BEARING: f64 = 3.5;
const ROUND: f64 = 0.15;

#[cfg(test)]
mod tests {
    use super::*;
    use dobot_geometry::{Rect, bounds};

    fn ink(text: &str, anchor: Anchor) -> Rect {
        let lines = strokes(text, anchor, Point::ORIGIN, 6.0);
        bounds(lines.into_iter().flatten())
    }

    #[test]
    fn a_text_has_the_given_width_and_height() {
        let ink = ink("HuH", Anchor::Left);
        assert!((ink.width() - width("HuH", 6.0)).abs() < 0.5, "{ink:?}");
        assert!(
            (ink.height() - 6.0).abs() < 0.1 && ink.y1.abs() < 0.1,
            "{ink:?}"
        );
    }

    #[test]
    fn a_text_is_aligned_at_its_end_or_in_its_middle() {
        let [left, middle, right] =
            [Anchor::Left, Anchor::Middle, Anchor::Right].map(|anchor| ink("HH", anchor));
        assert!(
            left.x0.abs() < 0.5 && right.x1.abs() < 0.5,
            "{left:?} {right:?}"
        );
        assert!(middle.center().x.abs() < 0.1, "{middle:?}");
    }

    #[test]
    fn a_missing_character_is_drawn_as_a_box() {
        assert!((ink("漢", Anchor::Left).height() - 6.0).abs() < 0.1);
    }
}
