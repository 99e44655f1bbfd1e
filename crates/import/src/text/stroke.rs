//! Text in single-line letters.

use std::collections::HashMap;

use dobot_geometry::{Point, Stroke};
use dobot_lettering::{CAPITAL, Letter, StrokeFont};

use super::{Text, composed, layer};
use crate::artwork::Layer;
use crate::error::SourceError;
use crate::limits::{Budget, MAX_SEGMENTS};
use crate::options::ReadOptions;
use crate::warning::Warning;

pub(super) fn read(
    text: &Text,
    font: StrokeFont,
    options: &ReadOptions,
) -> Result<(Layer, Vec<Warning>), SourceError> {
    let mut writer = Writer::new(font, text.height_mm, options);
    let lines: Vec<_> = text.lines().map(|line| composed(line, font)).collect();
    let widths: Vec<f64> = lines.iter().map(|line| writer.width_mm(line)).collect();
    let widest_mm = widths.iter().fold(0.0, |a: f64, b| a.max(*b));
    let mut at = Point::default();
    for (line, width_mm) in lines.iter().zip(widths) {
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
    /// Millimetres per unit of the fonts' grid.
    scale: f64,
    /// In units of the grid.
    tolerance: f64,
    letters: HashMap<char, Option<Letter>>,
    strokes: Vec<Stroke>,
    budget: Budget,
    /// The characters that cannot be written, each once, and the number of their occurrences.
    missing: Vec<char>,
    missed: usize,
}

impl Writer {
    fn new(font: StrokeFont, height_mm: f64, options: &ReadOptions) -> Self {
        let scale = height_mm / CAPITAL;
        Self {
            font,
            scale,
            tolerance: options.tolerance_mm / scale,
            letters: HashMap::new(),
            strokes: Vec::new(),
            budget: Budget::until(MAX_SEGMENTS, &options.cancel),
            missing: Vec::new(),
            missed: 0,
        }
    }

    fn width_mm(&mut self, line: &str) -> f64 {
        let advances = line
            .chars()
            .map(|c| self.letter(c).map_or(0.0, |c| c.advance));
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
                self.budget.note_curve(points.len());
                self.budget.spend(points.len())?;
                let points = points.iter().map(|p| at + p.to_vec2() * scale).collect();
                self.strokes.push(stroke(points));
            }
            at.x += advance * scale;
        }
        Ok(())
    }

    fn letter(&mut self, character: char) -> Option<&Letter> {
        let (font, tolerance) = (self.font, self.tolerance);
        let round = || Some(Letter::of(font, character)?.rounded(font, tolerance));
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
        let font = self.font.name();
        let instead = format!(
            "not in the {font} letters, left out: {named:?}; use an installed font with --font"
        );
        (self.missed > 0).then(|| Warning::new("character", &instead, self.missed))
    }
}

fn stroke(points: Vec<Point>) -> Stroke {
    let closed = points.len() > 2 && points.first() == points.last();
    Stroke { points, closed }
}

/// The number of such characters that a warning lists.
const NAMED: usize = 20;
