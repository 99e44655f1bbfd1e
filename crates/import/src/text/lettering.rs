//! Texts in files of other formats, in plain letters.

use std::collections::HashMap;

use dobot_geometry::{Point, Vec2, bounds};
use dobot_lettering::{CAPITAL, Letter, StrokeFont};

use crate::error::SourceError;
use crate::sketch::Sketch;

/// A writer of letters into the sketch of a file.
#[derive(Debug, Default)]
pub(crate) struct Lettering {
    letters: HashMap<char, Option<Letter>>,
}

/// The position and the axes of a letter in the file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    /// The start on the base line.
    pub(crate) at: Point,
    /// A unit of the letters' grid to the right; a capital is [`CAPITAL`] units tall.
    pub(crate) across: Vec2,
    /// A unit of the grid up.
    pub(crate) up: Vec2,
}

/// The width of a letter, in units of the grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct LetterExtent {
    /// The start and the end of its ink, to the right of its origin.
    pub(crate) ink: [f64; 2],
    /// The distance to the origin of the next letter.
    pub(crate) advance: f64,
}

impl Lettering {
    /// The width of a character; `None` if it cannot be written.
    pub(crate) fn extent(&mut self, character: char) -> Option<LetterExtent> {
        let letter = self.letter(character)?;
        let ink = bounds(letter.strokes.iter().flatten().copied());
        let advance = letter.advance;
        let is_blank = letter.strokes.is_empty();
        let ink = if is_blank {
            [0.0, advance]
        } else {
            [ink.x0, ink.x1]
        };
        Some(LetterExtent { ink, advance })
    }

    /// Draws a character, or warns if it cannot be written. `at` is the position in the file.
    pub(crate) fn write(
        &mut self,
        sketch: &mut Sketch<'_>,
        at: usize,
        character: char,
        pose: &Pose,
    ) -> Result<(), SourceError> {
        // Blanks count too, as there may be too many of them.
        sketch.spend(1)?;
        // Before rounding: huge letters have many corners.
        for way in [Vec2::ZERO, pose.up, pose.across] {
            sketch.check(at, pose.at + way * CAPITAL)?;
        }
        let Some(letter) = self.letter(character) else {
            let instead = format!("not in the sans letters, left out; the first is {character:?}");
            sketch.warn(at, "character", &instead);
            return Ok(());
        };
        let unit_mm = pose.across.length().max(pose.up.length());
        let tolerance = sketch.tolerance_mm() / unit_mm;
        for points in letter.rounded(StrokeFont::Sans, tolerance).strokes {
            sketch.note_curve(points.len());
            let place = |p: &Point| pose.at + pose.across * p.x - pose.up * p.y;
            let points: Vec<Point> = points.iter().map(place).collect();
            points
                .iter()
                .try_for_each(|&p| sketch.check(at, p).map(drop))?;
            sketch.stroke(points)?;
        }
        Ok(())
    }

    fn letter(&mut self, character: char) -> Option<&Letter> {
        let make = || Letter::of(StrokeFont::Sans, character);
        self.letters.entry(character).or_insert_with(make).as_ref()
    }
}
