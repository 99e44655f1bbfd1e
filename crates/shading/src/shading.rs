//! The conversion of tone to ink.

use std::str::FromStr;

use dobot_geometry::{CancelToken, Cancelled, Point, Stroke};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::flow::flowing;
use crate::hatch::hatched;
use crate::outline::outlines;
use crate::picture::GreyPicture;
use crate::spiral::spiral;
use crate::stipple::stippled;
use crate::tone::count;
use crate::waves::waves;

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

    /// Checks that the settings are in range.
    ///
    /// # Errors
    ///
    /// [`ShadingError::Setting`] names the first setting that is not.
    pub fn check(&self) -> Result<(), ShadingError> {
        let in_range = |setting, found: f64, allowed, fine: bool| {
            let wrong = ShadingError::Setting {
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
    /// Checks that the spacing suits a page, in millimetres, drawn at a scale.
    ///
    /// # Errors
    ///
    /// [`ShadingError::TooFine`] if drawing would take days.
    pub fn check_size(&self, page: Point, scale: f64) -> Result<(), ShadingError> {
        let spacing_mm = self.spacing_mm;
        let [width_mm, height_mm] = [page.x, page.y].map(|mm| mm * scale);
        let least_mm = (width_mm * height_mm / MAX_SPACINGS)
            .sqrt()
            .max(width_mm.max(height_mm) * CELLS / count(MAX_CELLS));
        if spacing_mm >= least_mm {
            return Ok(());
        }
        Err(ShadingError::TooFine {
            spacing_mm,
            least_mm,
            width_mm,
            height_mm,
        })
    }

    /// Returns the lines or dots of a picture that is drawn at a scale, in millimetres of its
    /// upright page; none if there is no ink. The spacing applies on the paper.
    ///
    /// # Errors
    ///
    /// [`Cancelled`] if it was cancelled.
    pub fn strokes(
        &self,
        picture: &GreyPicture<'_>,
        scale: f64,
        cancel: &CancelToken,
    ) -> Result<Vec<Stroke>, Cancelled> {
        let spacing_mm = self.spacing_mm / scale;
        let tone = &picture.toned(self, spacing_mm, cancel)?;
        let strokes = match self.style {
            ShadingStyle::Outline => outlines(tone, self, spacing_mm, cancel),
            ShadingStyle::Lines => waves(tone, self, spacing_mm, cancel),
            ShadingStyle::Spiral => spiral(tone, spacing_mm, cancel),
            ShadingStyle::Flow => flowing(tone, self, spacing_mm, cancel),
            ShadingStyle::Stipple | ShadingStyle::Tsp => stippled(tone, self, spacing_mm, cancel),
            ShadingStyle::Hatch => hatched(tone, self, spacing_mm, cancel),
        };
        // What a cancelled step returned is not a drawing.
        cancel.check()?;
        Ok(strokes)
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

/// The error returned when a picture cannot be drawn with some settings.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ShadingError {
    /// A setting is out of range.
    #[error("the {setting} of the shading is {found}; allowed is {allowed}")]
    Setting {
        /// The setting.
        setting: &'static str,
        /// Its value.
        found: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// The lines are too close for the size of the picture; drawing it would take days.
    #[error(
        "a spacing of {spacing_mm} mm is too fine for a picture of {width_mm:.0} x {height_mm:.0} mm on the paper; allowed are {least_mm:.2} mm or more; use a wider spacing or a smaller picture"
    )]
    TooFine {
        /// The spacing, on the paper.
        spacing_mm: f64,
        /// The smallest spacing for this size.
        least_mm: f64,
        /// The width of the picture on the paper.
        width_mm: f64,
        /// The height of the picture on the paper.
        height_mm: f64,
    },
}

/// Grid cells per spacing.
pub(crate) const CELLS: f64 = 4.0;
/// The largest number of cells along a side of the page.
pub(crate) const MAX_CELLS: usize = 100_000;
/// The largest number of square spacings on a page: 8 million cells.
const MAX_SPACINGS: f64 = 500_000.0;
