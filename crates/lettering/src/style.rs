//! How lines, areas and words style.

use std::fmt;

/// How a line or an area looks: colours as SVG names them, widths in units of the sheet.
#[derive(Clone, Copy, Debug, Default)]
pub struct ShapeStyle<'a> {
    fill: Option<&'a str>,
    line: Option<(&'a str, f64)>,
    dash: Option<&'a str>,
    opacity: Option<f64>,
}

impl<'a> ShapeStyle<'a> {
    /// A line.
    #[must_use]
    pub const fn line(color: &'a str, width: f64) -> Self {
        Self {
            fill: None,
            line: Some((color, width)),
            dash: None,
            opacity: None,
        }
    }

    /// An area.
    #[must_use]
    pub const fn area(color: &'a str) -> Self {
        Self {
            fill: Some(color),
            line: None,
            dash: None,
            opacity: None,
        }
    }

    /// The area with a line around it, or the line in another colour and width.
    #[must_use]
    pub const fn edged(self, color: &'a str, width: f64) -> Self {
        Self {
            line: Some((color, width)),
            ..self
        }
    }

    /// The line in dashes: how long each is and how long the gap after it.
    #[must_use]
    pub const fn dashed(self, dash: &'a str) -> Self {
        Self {
            dash: Some(dash),
            ..self
        }
    }

    /// The opacity, from 0 (invisible) to 1.
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

/// The height of capitals, the colour and the weight of words.
#[derive(Clone, Copy, Debug)]
pub struct TextStyle<'a> {
    pub(crate) height: f64,
    pub(crate) color: &'a str,
    /// The width of the lines, in heights.
    pub(crate) weight: f64,
}

impl<'a> TextStyle<'a> {
    /// Plain words.
    #[must_use]
    pub const fn new(height: f64, color: &'a str) -> Self {
        Self {
            height,
            color,
            weight: 0.135,
        }
    }

    /// The same in bold.
    #[must_use]
    pub const fn bold(self) -> Self {
        Self {
            weight: 0.19,
            ..self
        }
    }

    /// The same words as a wide border. Written below them, it sets them off from the picture.
    #[must_use]
    pub const fn halo(self, color: &'a str) -> Self {
        Self {
            color,
            weight: 0.42,
            ..self
        }
    }

    /// How wide a line of these words is.
    #[must_use]
    pub fn width(&self, words: &str) -> f64 {
        crate::width(words, self.height)
    }
}

/// A number to a hundredth, without the zeros at its end.
pub(crate) struct Rounded(pub(crate) f64);

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", (self.0 * 100.0).round() / 100.0 + 0.0)
    }
}
