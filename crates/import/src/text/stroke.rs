//! Text in single-line letters.

use std::collections::HashMap;

use dobot_geometry::{Point, Stroke};
use dobot_lettering::{CAPITAL, Letter, StrokeFont};

use super::composed::composed_for;
use super::wrap::{Line, lines};
use super::{Text, layer};
use crate::artwork::Layer;
use crate::error::SourceError;
use crate::limits::{Budget, MAX_SEGMENTS};
use crate::options::ReadOptions;
use crate::svg::SvgFont;
use crate::warning::Warning;

/// A font of single-line letters.
pub(super) enum Letters {
    BuiltIn(StrokeFont),
    File(SvgFont),
}

impl Letters {
    fn name(&self) -> &str {
        match self {
            Self::BuiltIn(font) => font.name(),
            Self::File(font) => &font.name,
        }
    }

    fn has(&self, character: char) -> bool {
        match self {
            Self::BuiltIn(font) => character.is_ascii() || Letter::of(*font, character).is_some(),
            Self::File(font) => font.has(character),
        }
    }

    /// The glyph of a character, within a tolerance in units of the grid.
    fn letter(&self, character: char, tolerance: f64) -> Option<Letter> {
        match self {
            Self::BuiltIn(font) => Some(Letter::of(*font, character)?.rounded(*font, tolerance)),
            Self::File(font) => font.letter(character, tolerance),
        }
    }
}

pub(super) fn read(
    text: &Text,
    font: &Letters,
    options: &ReadOptions,
) -> Result<(Layer, Vec<Warning>), SourceError> {
    let mut writer = Writer::new(font, text.height_mm, options);
    let whole = Text {
        text: composed_for(&text.text, |c| font.has(c)).into_owned(),
        ..text.clone()
    };
    let lines = lines(&whole, |part| writer.width_mm(part, 0.0));
    let widths: Vec<f64> = lines
        .iter()
        .map(|line| writer.width_mm(&line.text, line.extra_mm))
        .collect();
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

struct Writer<'a> {
    font: &'a Letters,
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

impl<'a> Writer<'a> {
    fn new(font: &'a Letters, height_mm: f64, options: &ReadOptions) -> Self {
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

    fn width_mm(&mut self, line: &str, extra_mm: f64) -> f64 {
        let advances = line
            .chars()
            .map(|c| self.letter(c).map_or(0.0, |c| c.advance));
        let width_mm = advances.sum::<f64>() * self.scale;
        let gaps = line.trim_start().matches(' ').map(|_| extra_mm);
        width_mm + gaps.sum::<f64>()
    }

    fn line(&mut self, line: &Line, mut at: Point) -> Result<(), SourceError> {
        let indent = line.text.len() - line.text.trim_start().len();
        for (place, character) in line.text.char_indices() {
            let scale = self.scale;
            if character == ' ' && place >= indent {
                at.x += line.extra_mm;
            }
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
        let letter = || font.letter(character, tolerance);
        self.letters
            .entry(character)
            .or_insert_with(letter)
            .as_ref()
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
