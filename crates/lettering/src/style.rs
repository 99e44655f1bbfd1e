//! Styles of lines, areas and words.

use std::fmt;

/// The style of a line or an area: SVG colours, widths in units of the sheet.
#[derive(Clone, Copy, Debug, Default)]
pub struct ShapeStyle<'a> {
    fill: Option<&'a str>,
    line: Option<(&'a str, f64)>,
    dash: Option<&'a str>,
    opacity: Option<f64>,
}

impl<'a> ShapeStyle<'a> {
    /// Creates the style of a line.
    #[must_use]
    pub const fn line(color: &'a str, width: f64) -> Self {
        Self {
            fill: None,
            line: Some((color, width)),
            dash: None,
            opacity: None,
        }
    }

    /// Creates the style of an area.
    #[must_use]
    pub const fn area(color: &'a str) -> Self {
        Self {
            fill: Some(color),
            line: None,
            dash: None,
            opacity: None,
        }
    }

    /// Adds an outline to an area, or changes the colour and width of a line.
    #[must_use]
    pub const fn edged(self, color: &'a str, width: f64) -> Self {
        Self {
            line: Some((color, width)),
            ..self
        }
    }

    /// Makes the line dashed: the length of the dashes and of the gaps.
    #[must_use]
    pub const fn dashed(self, dash: &'a str) -> Self {
        Self {
            dash: Some(dash),
            ..self
        }
    }

    /// Sets the opacity, from 0 (invisible) to 1.
    #[must_use]
    pub const fn faded(self, opacity: f64) -> Self {
        Self {
            opacity: Some(opacity),
            ..self
        }
    }
}

impl fmt::Display for ShapeStyle<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(color) = self.fill {
            write!(f, r#" fill="{color}""#)?;
        }
        if let Some((color, width)) = self.line {
            write!(f, r#" stroke="{color}" stroke-width="{}""#, Rounded(width))?;
        }
        if let Some(dash) = self.dash {
            write!(f, r#" stroke-dasharray="{dash}""#)?;
        }
        if let Some(opacity) = self.opacity {
            write!(f, r#" opacity="{}""#, Rounded(opacity))?;
        }
        Ok(())
    }
}

/// The capital height, colour and weight of text.
#[derive(Clone, Copy, Debug)]
pub struct TextStyle<'a> {
    pub(crate) height: f64,
    pub(crate) color: &'a str,
    /// The line width, in capital heights.
    pub(crate) weight: f64,
}

impl<'a> TextStyle<'a> {
    /// Creates a plain text style.
    #[must_use]
    pub const fn new(height: f64, color: &'a str) -> Self {
        Self {
            height,
            color,
            weight: 0.135,
        }
    }

    /// Makes the text bold.
    #[must_use]
    pub const fn bold(self) -> Self {
        Self {
            weight: 0.19,
            ..self
        }
    }

    /// Returns the style of a wide border around the text. Drawn below the text, it separates it
    /// from the picture.
    #[must_use]
    pub const fn halo(self, color: &'a str) -> Self {
        Self {
            color,
            weight: 0.42,
            ..self
        }
    }

    /// Returns the width of a line of text.
    #[must_use]
    pub fn width(&self, words: &str) -> f64 {
        crate::width(words, self.height)
    }
}

/// A number rounded to a hundredth, without trailing zeros.
pub(crate) struct Rounded(pub(crate) f64);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", (self.0 * 100.0).round() / 100.0 + 0.0)
    }
}
