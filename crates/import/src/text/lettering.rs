//! Texts that stand in files of other kinds, in plain letters.

use std::collections::HashMap;

use dobot_geometry::{Point, Vec2, bounds};
use dobot_lettering::{CAPITAL, Letter, StrokeFont};

use crate::error::SourceError;
use crate::sketch::Sketch;

/// Writes the letters of a file into its sketch.
#[derive(Debug, Default)]
pub(crate) struct Lettering {
    letters: HashMap<char, Option<Letter>>,
}

/// How a letter lies in the file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    /// Where its place on the base line begins.
    pub(crate) at: Point,
    /// A unit of the letters' grid to the right; a capital is [`CAPITAL`] units tall.
    pub(crate) across: Vec2,
    /// And a unit up.
    pub(crate) up: Vec2,
}

/// How much room a letter takes, in units of the grid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct LetterExtent {
    /// Where its ink begins and ends, to the right of its beginning.
    pub(crate) ink: [f64; 2],
    /// From its beginning to that of the next letter.
    pub(crate) advance: f64,
}

impl Lettering {
    /// The room of a character; `None` where it cannot be written.
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

    /// Draws a character; one that cannot be written is left out with a warning. `at` is the place
    /// in the file, for messages.
    pub(crate) fn write(
        &mut self,
        sketch: &mut Sketch<'_>,
        at: usize,
        character: char,
        pose: &Pose,
    ) -> Result<(), SourceError> {
        // Blanks count too: there may be too many of them to look at.
        sketch.spend(1)?;
        // Before rounding: letters as tall as mountains have many corners.
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
