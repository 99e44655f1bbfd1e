//! The conversion of tone to ink.

use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::ImageError;

/// The conversion of the tones of a picture to lines or dots.
///
/// [`Shading::new`] gives each style values that suit most photos.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shading {
    /// The style of lines or dots.
    pub style: ShadingStyle,
    /// The smallest distance of lines or dots, in millimetres on the paper; details smaller than
    /// half of it are not drawn. About twice the width of the pen, or more.
    pub spacing_mm: f64,
    /// The number of tones beside white that [`ShadingStyle::Outline`] and [`ShadingStyle::Hatch`]
    /// distinguish, 1 to 8. Outlines use at most the tones that the picture has.
    pub levels: u8,
    /// The threshold darkness, between 0 (white) and 1 (black): darker tones become black and all
    /// others white, and [`ShadingStyle::Outline`] draws a single border. Without it all tones
    /// count.
    pub threshold: Option<f64>,
    /// The angle of lines, in degrees, counterclockwise from the page's horizontal.
    pub angle_deg: f64,
    /// The brightness: above 0 lighter, below 0 darker; from -1 (all black) to 1 (all white).
    pub brightness: f64,
    /// The contrast: above 0 more, below 0 less; from -1 (all tones equal) to 1 (black and white).
    pub contrast: f64,
    /// The ink in the middle tones: above 1 more, below 1 less; from 0.1 to 10.
    pub darkness: f64,
    /// Whether each line of [`ShadingStyle::Hatch`] and [`ShadingStyle::Lines`] is a separate
    /// stroke: a tool is slow at the turn from one line into the next, and a laser burns more
    /// there.
    pub apart: bool,
    /// Whether light tones are drawn instead of dark ones: for a white pen on black paper.
    pub invert: bool,
    /// The random seed of the dots of [`ShadingStyle::Stipple`] and [`ShadingStyle::Tsp`].
    pub seed: u64,
}

impl Shading {
    /// The allowed numbers of tones beside white.
    pub const LEVELS: [f64; 2] = [1.0, 8.0];

    /// The default values of a style.
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
    /// [`ShadingStyle::Hatch`], which needs the fewest vectors.
    fn default() -> Self {
        Self::new(ShadingStyle::Hatch)
    }
}

/// The style of a shaded picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ShadingStyle {
    /// The borders between tones, as closed lines.
    Outline,
    /// Parallel waves, wider and faster in darker areas.
    Lines,
    /// A spiral wave from the center, wider and faster in darker areas.
    Spiral,
    /// Lines along the edges of the picture, denser in darker areas.
    Flow,
    /// Dots, denser in darker areas.
    Stipple,
    /// Dots joined to one line, as short as possible (travelling salesman).
    Tsp,
    /// Straight lines, in more directions in darker areas.
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
