//! How tone becomes ink.

use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::ImageError;

/// How the tones of a picture become lines or dots.
///
/// [`Shading::new`] gives each style the values that make a good drawing of most photos.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shading {
    /// Lines of which kind, or dots.
    pub style: ShadingStyle,
    /// How near lines or dots come to each other, in millimetres on the paper; what is smaller
    /// than half of it is not drawn. About twice the width of the pen, or more.
    pub spacing_mm: f64,
    /// How many tones beside white are distinguished by [`ShadingStyle::Outline`] and [`ShadingStyle::Hatch`], from
    /// 1 to 8. Outlines are drawn of as many as the picture really has.
    pub levels: u8,
    /// What is darker is black and all else white: a darkness between 0 (white) and 1 (black), where
    /// [`ShadingStyle::Outline`] draws its only line. Without it all tones count.
    pub threshold: Option<f64>,
    /// Which way lines run, in degrees, counterclockwise from the page's horizontal.
    pub angle_deg: f64,
    /// Lighter above 0, darker below; from -1 (all black) to 1 (all white).
    pub brightness: f64,
    /// Tones farther apart above 0, nearer to each other below; from -1 (all the same) to 1 (black and
    /// white).
    pub contrast: f64,
    /// More ink in the middle tones above 1, less below; from 0.1 to 10.
    pub darkness: f64,
    /// Each line of [`ShadingStyle::Hatch`] and [`ShadingStyle::Lines`] is a stroke of its own: a tool is slow where it turns from one into
    /// the next, and a laser burns more there.
    pub apart: bool,
    /// Draws what is light: for a white pen on black paper.
    pub invert: bool,
    /// Another number scatters the dots of [`ShadingStyle::Stipple`] and [`ShadingStyle::Tsp`] anew.
    pub seed: u64,
}

impl Shading {
    /// How many tones beside white there may be.
    pub const LEVELS: [f64; 2] = [1.0, 8.0];

    /// The best values for a style.
    #[must_use]
    pub const fn new(style: ShadingStyle) -> Self {
        let (spacing_mm, angle_deg, levels) = match style {
            ShadingStyle::Outline => (1.0, 0.0, 4),
            ShadingStyle::Lines | ShadingStyle::Spiral => (1.6, 0.0, 4),
            ShadingStyle::Stipple => (0.9, 0.0, 4),
            ShadingStyle::Tsp => (1.2, 0.0, 4),
            ShadingStyle::Flow => (0.9, 45.0, 4),
            ShadingStyle::Hatch => (1.3, 45.0, 4),
        };
        Self {
            style,
            spacing_mm,
            levels,
            threshold: None,
            angle_deg,
            brightness: 0.0,
            contrast: 0.0,
            darkness: 1.0,
            apart: false,
            invert: false,
            seed: 1,
        }
    }

    pub(super) fn check(&self) -> Result<(), ImageError> {
        let in_range = |setting, found: f64, allowed, fine: bool| {
            let wrong = ImageError::Setting {
                setting,
                found,
                allowed,
            };
            if fine { Ok(()) } else { Err(wrong) }
        };
        let spacing = self.spacing_mm;
        let fine = spacing > 0.0 && spacing.is_finite();
        in_range("spacing", spacing, "a number above 0, in mm", fine)?;
        let (levels, [least, most]) = (self.levels.into(), Self::LEVELS);
        let fine = (least..=most).contains(&levels);
        in_range("levels", levels, "from 1 to 8", fine)?;
        let darkness = self.darkness;
        let fine = (0.1..=10.0).contains(&darkness);
        in_range("darkness", darkness, "from 0.1 to 10", fine)?;
        for (name, found) in [("brightness", self.brightness), ("contrast", self.contrast)] {
            let fine = (-1.0..=1.0).contains(&found);
            in_range(name, found, "from -1 to 1", fine)?;
        }
        let fine = self.angle_deg.is_finite();
        in_range("angle", self.angle_deg, "a number, in degrees", fine)?;
        let threshold = self.threshold.unwrap_or(0.5);
        let fine = threshold > 0.0 && threshold < 1.0;
        in_range("threshold", threshold, "between 0 and 1", fine)
    }
}

impl Default for Shading {
    /// [`ShadingStyle::Hatch`]: of all it asks for the fewest vectors.
    fn default() -> Self {
        Self::new(ShadingStyle::Hatch)
    }
}

/// What is drawn of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ShadingStyle {
    /// The borders between its tones, as closed lines.
    Outline,
    /// Parallel lines that swing the wider and the faster the darker it is.
    Lines,
    /// One line around the middle that swings the wider and the faster the darker it is.
    Spiral,
    /// Lines that run along the edges of what is seen, the denser the darker it is.
    Flow,
    /// Dots, the denser the darker it is.
    Stipple,
    /// Such dots, which the drawing joins to one line: the shortest that is found.
    Tsp,
    /// Straight lines, in the more directions the darker it is.
    Hatch,
}

impl FromStr for ShadingStyle {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "outline" => Ok(Self::Outline),
            "lines" => Ok(Self::Lines),
            "spiral" => Ok(Self::Spiral),
            "flow" => Ok(Self::Flow),
            "stipple" => Ok(Self::Stipple),
            "tsp" => Ok(Self::Tsp),
            "hatch" => Ok(Self::Hatch),
            _ => Err("allowed are hatch, lines, spiral, flow, stipple, tsp and outline"),
        }
    }
}
