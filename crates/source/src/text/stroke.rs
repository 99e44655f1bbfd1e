//! Text in letters of single lines.

use std::collections::HashMap;

use dobot_geometry::{Point, Stroke};

use super::hershey::{CAPITAL, StrokeFont};
use super::letter::Letter;
use super::smooth::smooth;
use super::{Text, layer};
use crate::artwork::Layer;
use crate::error::MAX_SEGMENTS;
use crate::error::{SourceError, Warning};

pub(super) fn read(
    text: &Text,
    font: StrokeFont,
    tolerance_mm: f64,
) -> Result<(Layer, Vec<Warning>), SourceError> {
    let mut writer = Writer::new(font, text.height_mm, tolerance_mm);
    let widths: Vec<f64> = text.lines().map(|line| writer.width_mm(line)).collect();
    let widest_mm = widths.iter().fold(0.0, |a: f64, b| a.max(*b));
    let mut at = Point::default();
    for (line, width_mm) in text.lines().zip(widths) {
        at.x = (widest_mm - width_mm) * text.align.share();
        writer.line(line, at)?;
        at.y += text.line_spacing * text.height_mm;
    }
    let warnings = writer.warning().into_iter().collect();
    let layer = Layer {
        strokes: writer.strokes,
        ..layer(&text.text)
    };
    Ok((layer, warnings))
}

struct Writer {
    font: StrokeFont,
    /// Millimetres for each unit of the fonts' grid.
    scale: f64,
    /// In units of the grid.
    tolerance: f64,
    letters: HashMap<char, Option<Letter>>,
    strokes: Vec<Stroke>,
    segments: usize,
    /// What cannot be written, each once, and how often that happened.
    missing: Vec<char>,
    missed: usize,
}

impl Writer {
    fn new(font: StrokeFont, height_mm: f64, tolerance_mm: f64) -> Self {
        let scale = height_mm / CAPITAL;
        Self {
            font,
            scale,
            tolerance: tolerance_mm / scale,
            letters: HashMap::new(),
            strokes: Vec::new(),
            segments: 0,
            missing: Vec::new(),
            missed: 0,
        }
    }

    fn width_mm(&mut self, line: &str) -> f64 {
        let advances = line
            .chars()
            .map(|it| self.letter(it).map_or(0.0, |it| it.advance));
        advances.sum::<f64>() * self.scale
    }

    fn line(&mut self, line: &str, mut at: Point) -> Result<(), SourceError> {
        for character in line.chars() {
            let scale = self.scale;
            let Some(letter) = self.letter(character) else {
                self.miss(character);
                continue;
            };
            let (advance, lines) = (letter.advance, letter.strokes.clone());
            for points in lines {
                self.segments += points.len();
                let points = points.iter().map(|p| at + p.to_vec2() * scale).collect();
                self.strokes.push(stroke(points));
            }
            at.x += advance * scale;
            if self.segments > MAX_SEGMENTS {
                return Err(SourceError::TooManySegments {
                    limit: MAX_SEGMENTS,
                });
            }
        }
        Ok(())
    }

    fn letter(&mut self, character: char) -> Option<&Letter> {
        let (font, tolerance) = (self.font, self.tolerance);
        let round = || Some(rounded(&Letter::of(font, character)?, font, tolerance));
        self.letters.entry(character).or_insert_with(round).as_ref()
    }

    fn miss(&mut self, character: char) {
        self.missed += 1;
        if !self.missing.contains(&character) && self.missing.len() < NAMED {
            self.missing.push(character);
        }
    }

    fn warning(&self) -> Option<Warning> {
        let named: String = self.missing.iter().collect();
        (self.missed > 0).then(|| Warning {
            place: None,
            what: "character".to_owned(),
            instead: format!(
                "not in the {} letters, left out: {named:?}",
                self.font.name()
            ),
            count: self.missed,
        })
    }
}

/// A letter with its gentle corners rounded, in units of the grid.
pub(super) fn rounded(letter: &Letter, font: StrokeFont, tolerance: f64) -> Letter {
    let sharp = if font == StrokeFont::Gothic {
        SHARP_GOTHIC
    } else {
        SHARP
    };
    let round = |points: &Vec<Point>| {
        let is_dot = is_dot(points) && font != StrokeFont::Gothic;
        smooth(points, if is_dot { ROUND } else { sharp }, tolerance)
    };
    Letter {
        strokes: letter.strokes.iter().map(round).collect(),
        advance: letter.advance,
    }
}

/// A full stop and the like: a small square on its corner.
fn is_dot(points: &[Point]) -> bool {
    let is_near = |p: &Point| p.distance(points[0]) <= 2.5;
    points.len() > 3 && points.first() == points.last() && points.iter().all(is_near)
}

fn stroke(points: Vec<Point>) -> Stroke {
    let closed = points.len() > 2 && points.first() == points.last();
    Stroke { points, closed }
}

/// From what turn on a corner is meant to be one, in radians.
const SHARP: f64 = 0.95;
const SHARP_GOTHIC: f64 = 0.6;
/// Every corner is rounded.
const ROUND: f64 = 4.0;
/// So many characters that cannot be written are named.
const NAMED: usize = 20;
