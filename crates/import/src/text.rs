//! Text, in single-line letters or in the outlines of any font.

mod composed;
mod lettering;
mod outline;
mod stroke;

use std::fmt;
use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub(super) use self::composed::composed;
pub(super) use self::lettering::{Lettering, Pose};
use crate::artwork::{Artwork, Layer};
use crate::error::{SourceError, TextError};
use crate::options::ReadOptions;
use crate::warning::Warning;
use dobot_geometry::bounds;
pub(super) use dobot_lettering::CAPITAL;
pub use dobot_lettering::StrokeFont;

/// Text to be written.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The text, in lines.
    pub text: String,
    /// The font.
    pub font: Font,
    /// The height of capitals, in millimetres on the page; 0.1 to 1000.
    pub height_mm: f64,
    /// The alignment.
    pub align: Align,
    /// The line distance, in heights of capitals; 0.5 to 10.
    pub line_spacing: f64,
}

impl Text {
    /// The allowed heights of capitals, in mm.
    pub const HEIGHT_MM: [f64; 2] = [0.1, 1000.0];

    /// Creates a text in plain single-stroke letters, 10 mm tall, with lines 1.75 heights apart.
    #[must_use]
    pub fn new(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            font: Font::default(),
            height_mm: 10.0,
            align: Align::default(),
            line_spacing: 1.75,
        }
    }

    pub(super) fn read(
        &self,
        options: &ReadOptions,
    ) -> Result<(Artwork, Vec<Warning>), SourceError> {
        self.check()?;
        let (layer, warnings) = match &self.font {
            Font::Stroke(font) => stroke::read(self, *font, options)?,
            Font::Outline(family) => outline::read(self, family, options)?,
        };
        if layer.is_empty() {
            return Err(nothing(&warnings));
        }
        Ok((on_page(layer), warnings))
    }

    fn check(&self) -> Result<(), TextError> {
        let is_in = |found: f64, [least, most]: [f64; 2]| found >= least && found <= most;
        let characters = self.text.chars().count();
        if characters > MAX_CHARACTERS {
            return Err(TextError::TooLong {
                characters,
                limit: MAX_CHARACTERS,
            });
        }
        if !is_in(self.height_mm, Self::HEIGHT_MM) {
            return Err(TextError::Height {
                found_mm: self.height_mm,
            });
        }
        if !is_in(self.line_spacing, LINE_SPACING) {
            return Err(TextError::LineSpacing {
                found: self.line_spacing,
            });
        }
        Ok(())
    }

    /// Its lines, without carriage returns.
    fn lines(&self) -> impl Iterator<Item = &str> {
        self.text.lines()
    }
}

/// The font of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Font {
    /// Single-line letters, as plotters write them.
    Stroke(StrokeFont),
    /// The outlines of a font family; `Bold`, `Italic` and similar words may follow its name.
    Outline(String),
}

impl Font {
    /// The single-line font of this name, or else the outline font.
    ///
    /// ```
    /// use dobot_import::{Font, StrokeFont};
    ///
    /// assert_eq!(Font::of("script"), Font::Stroke(StrokeFont::Script));
    /// assert_eq!(Font::of("DejaVu Sans"), Font::Outline("DejaVu Sans".to_owned()));
    /// ```
    #[must_use]
    pub fn of(name: &str) -> Self {
        let named = |font: &&StrokeFont| font.name().eq_ignore_ascii_case(name.trim());
        match StrokeFont::ALL.iter().find(named) {
            Some(font) => Self::Stroke(*font),
            None => Self::Outline(name.trim().to_owned()),
        }
    }
}

impl Default for Font {
    fn default() -> Self {
        Self::Stroke(StrokeFont::default())
    }
}

impl fmt::Display for Font {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stroke(font) => f.write_str(font.name()),
            Self::Outline(family) => f.write_str(family),
        }
    }
}

/// The alignment of lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Align {
    /// Left.
    #[default]
    Left,
    /// Centered.
    Center,
    /// Right.
    Right,
}

impl FromStr for Align {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "left" => Ok(Self::Left),
            "center" | "centre" => Ok(Self::Center),
            "right" => Ok(Self::Right),
            _ => Err("allowed are left, center and right"),
        }
    }
}

impl Align {
    /// The fraction of a line's remaining space before it.
    const fn share(self) -> f64 {
        match self {
            Self::Left => 0.0,
            Self::Center => 0.5,
            Self::Right => 1.0,
        }
    }
}

fn nothing(warnings: &[Warning]) -> SourceError {
    if warnings.is_empty() {
        return SourceError::nothing_to_draw(["the text is empty".to_owned()]);
    }
    SourceError::nothing_to_draw(warnings.iter().map(Warning::to_string))
}

/// The page is as large as the ink.
fn on_page(layer: Layer) -> Artwork {
    let bounds = bounds(layer.points());
    let mut layers = vec![layer];
    for p in layers.iter_mut().flat_map(Layer::points_mut) {
        *p -= bounds.origin().to_vec2();
    }
    Artwork {
        has_page: false,
        width_mm: bounds.width(),
        height_mm: bounds.height(),
        layers,
    }
}

fn layer(text: &str) -> Layer {
    let first = text.lines().find(|line| !line.trim().is_empty());
    let short: String = first.unwrap_or_default().trim().chars().take(24).collect();
    Layer {
        name: short,
        ..Layer::default()
    }
}

/// About ten pages, which the arm writes in days.
const MAX_CHARACTERS: usize = 20_000;
const LINE_SPACING: [f64; 2] = [0.5, 10.0];

#[cfg(test)]
mod tests;
