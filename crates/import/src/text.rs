//! Text, in single-line letters or in the outlines of any font.

mod composed;
mod lettering;
mod outline;
mod stroke;
mod wrap;

use std::str::FromStr;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub(super) use self::composed::composed;
pub(super) use self::lettering::{Lettering, Pose};
use self::stroke::Letters;
use crate::artwork::{Artwork, Layer};
use crate::error::{SourceError, TextError};
use crate::options::ReadOptions;
use crate::svg::SvgFont;
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
    /// How long lines are wrapped; by default they are as long as in the text.
    pub wrap: Option<Wrap>,
}

/// The wrapping of lines, between words and after hyphens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wrap {
    /// The width of the lines, in millimetres on the page; 1 to 10000. A wider word has its own
    /// line.
    pub width_mm: f64,
    /// Whether spaces are widened so that all lines except the last of a paragraph have this width.
    pub justify: bool,
}

impl Wrap {
    /// The allowed widths of lines, in mm.
    pub const WIDTH_MM: [f64; 2] = [1.0, 10_000.0];
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
            wrap: None,
        }
    }

    pub(super) fn read(
        &self,
        options: &ReadOptions,
    ) -> Result<(Artwork, Vec<Warning>), SourceError> {
        self.check()?;
        let (layer, warnings) = self.fitted(options)?;
        if layer.is_empty() {
            return Err(nothing(&warnings));
        }
        Ok((on_page(layer), warnings))
    }

    /// Writes the text with all ink within the width of its lines: letters may extend beyond their
    /// own width, as slanted ones do. A word that is wider than that stays as it is.
    fn fitted(&self, options: &ReadOptions) -> Result<(Layer, Vec<Warning>), SourceError> {
        let first = self.layer(options)?;
        let Some(wrap) = self.wrap else {
            return Ok(first);
        };
        let excess_mm = |layer: &Layer| bounds(layer.points()).width() - wrap.width_mm;
        let excess = excess_mm(&first.0);
        if excess <= 0.0 {
            return Ok(first);
        }
        let mut narrower = self.clone();
        let beyond_mm = BEYOND.map(|heights| heights * self.height_mm);
        for shorter_mm in [1.001 * excess].into_iter().chain(beyond_mm) {
            let width_mm = wrap.width_mm - shorter_mm;
            narrower.wrap = Some(Wrap { width_mm, ..wrap });
            let again = narrower.layer(options)?;
            if excess_mm(&again.0) <= 0.0 {
                return Ok(again);
            }
        }
        Ok(first)
    }

    /// Writes the text anywhere.
    fn layer(&self, options: &ReadOptions) -> Result<(Layer, Vec<Warning>), SourceError> {
        Ok(match &self.font {
            Font::Stroke(font) => stroke::read(self, &Letters::BuiltIn(*font), options)?,
            Font::Svg(file) => {
                let font = Letters::File(SvgFont::read(file)?);
                stroke::read(self, &font, options)?
            }
            Font::Outline(name) if name.to_ascii_lowercase().ends_with(".svg") => {
                let what = format!("{name} is its name; give the content of the file");
                return Err(TextError::FontFile { what }.into());
            }
            Font::Outline(family) => outline::read(self, family, options)?,
        })
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
        let width_mm = self.wrap.map(|wrap| wrap.width_mm);
        if let Some(found_mm) = width_mm.filter(|mm| !is_in(*mm, Wrap::WIDTH_MM)) {
            return Err(TextError::Width { found_mm });
        }
        Ok(())
    }
}

/// The font of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Font {
    /// Single-line letters, as plotters write them.
    Stroke(StrokeFont),
    /// Single-line letters of an SVG font: the content of its file.
    Svg(Arc<str>),
    /// The outlines of a font family; `Bold`, `Italic` and similar words may follow its name.
    Outline(String),
}

impl Font {
    /// The single-line font of this name, an SVG font if this is the content of its file, or else
    /// the outline font.
    ///
    /// ```
    /// use dobot_import::{Font, StrokeFont};
    ///
    /// assert_eq!(Font::of("script"), Font::Stroke(StrokeFont::Script));
    /// assert!(matches!(Font::of("hand"), Font::Svg(_)));
    /// assert_eq!(Font::of("DejaVu Sans"), Font::Outline("DejaVu Sans".to_owned()));
    /// ```
    #[must_use]
    pub fn of(name: &str) -> Self {
        let name = name.trim_start_matches('\u{feff}').trim();
        let named = |font: &&StrokeFont| font.name().eq_ignore_ascii_case(name);
        match StrokeFont::ALL.iter().find(named) {
            Some(font) => Self::Stroke(*font),
            None if name.eq_ignore_ascii_case("hand") => Self::Svg(HAND.into()),
            None if name.starts_with('<') => Self::Svg(name.into()),
            None => Self::Outline(name.to_owned()),
        }
    }
}

impl Default for Font {
    fn default() -> Self {
        Self::Stroke(StrokeFont::default())
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
        width_mm: bounds.width(),
        height_mm: bounds.height(),
        layers,
        ..Artwork::default()
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
/// How far letters may extend beyond both ends of their line, in heights of capitals.
const BEYOND: [f64; 2] = [0.25, 0.6];
const LINE_SPACING: [f64; 2] = [0.5, 10.0];
/// Handwriting: EMS Felix, by Sheldon B. Michaels, after Felipa by Fontstage (see
/// `text/fonts/LICENSE-OFL`).
const HAND: &str = include_str!("text/fonts/EMSFelix.svg");

#[cfg(test)]
mod tests;
