//! Hatching of areas.

mod contour;
mod join;
mod scan;

#[cfg(test)]
mod tests;

use std::str::FromStr;

use contour::{contours, spirals};
use dobot_geometry::{Area, CancelToken, Cancelled, Point, Stroke, Vec2, direction};
use join::{Joined, each};
use scan::Scan;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// The hatching of an area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hatch {
    /// The style.
    pub style: HatchStyle,
    /// The line spacing, in mm; at least 0.05.
    pub spacing_mm: f64,
    /// The direction of the lines: 0 along x, 90 along y.
    pub angle_deg: f64,
    /// Whether a second set of lines crosses the first.
    pub cross: bool,
    /// The distance of the lines from the border, in mm: half the pen's width keeps the ink inside.
    pub inset_mm: f64,
    /// Whether each parallel line is a separate stroke: a tool is slow where it turns from one into
    /// the next, and a laser burns more there.
    pub apart: bool,
}

impl Default for Hatch {
    /// Returns a spacing of 1 mm at 45 degrees, not crossed, up to the border.
    fn default() -> Self {
        Self {
            style: HatchStyle::Lines,
            spacing_mm: 1.0,
            angle_deg: 45.0,
            cross: false,
            inset_mm: 0.0,
            apart: false,
        }
    }
}

/// Fills an area with lines. Parallel lines lie on a common grid for all areas, so that those of
/// neighbours meet. If the next line ends nearby and the connection stays inside, the pen continues
/// without lifting, unless the lines must stay apart:
///
/// ```text
///   .-------------.
///   |  .--------. |
///   |  '------. | |    one stroke to and fro
///   |  .------' | |
///   '-------------'
/// ```
///
/// # Errors
///
/// [`HatchError`] if a setting is not a number or out of range, or if there would be too many
/// lines.
pub fn hatch(area: &Area, hatch: &Hatch) -> Result<Vec<Stroke>, HatchError> {
    hatch_until(area, hatch, &CancelToken::default())
}

/// Like [`hatch`], until the drawing is cancelled.
pub(crate) fn hatch_until(
    area: &Area,
    hatch: &Hatch,
    cancel: &CancelToken,
) -> Result<Vec<Stroke>, HatchError> {
    hatch.check(area)?;
    match hatch.style {
        HatchStyle::Lines => parallel(area, hatch, cancel),
        HatchStyle::Concentric => contours(area, hatch, cancel),
        HatchStyle::Spiral => spirals(area, hatch, cancel),
    }
}

fn parallel(area: &Area, hatch: &Hatch, cancel: &CancelToken) -> Result<Vec<Stroke>, HatchError> {
    let mut strokes = lines(area, hatch, hatch.angle_deg, cancel)?;
    if hatch.cross {
        strokes.extend(lines(area, hatch, hatch.angle_deg + 90.0, cancel)?);
    }
    Ok(strokes)
}

/// The style of a hatching.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum HatchStyle {
    /// Parallel lines.
    #[default]
    Lines,
    /// The outline repeated inwards.
    Concentric,
    /// The repeated outline in one line, from the outside in.
    Spiral,
}

impl FromStr for HatchStyle {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "lines" => Ok(Self::Lines),
            "concentric" => Ok(Self::Concentric),
            "spiral" => Ok(Self::Spiral),
            _ => Err("allowed are lines, concentric and spiral"),
        }
    }
}

impl Hatch {
    fn check(&self, area: &Area) -> Result<(), HatchError> {
        let settings = [
            (
                "spacing",
                self.spacing_mm,
                "mm",
                MIN_SPACING_MM,
                "a number from 0.05 mm up",
            ),
            ("angle", self.angle_deg, "degrees", f64::MIN, "a number"),
            ("inset", self.inset_mm, "mm", 0.0, "a number from 0 up"),
        ];
        for (name, found, unit, least, allowed) in settings {
            if !(found >= least && found.is_finite()) {
                return Err(HatchError::Setting {
                    name,
                    found,
                    unit,
                    allowed,
                });
            }
        }
        let mut corners = area.rings.iter().flatten();
        match corners.find(|p| !p.is_finite()) {
            Some(p) => Err(HatchError::Corner { x: p.x, y: p.y }),
            None => Ok(()),
        }
    }
}

/// The error returned when an area cannot be hatched.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HatchError {
    /// The hatching was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A setting is not a number or below its minimum.
    #[error("the {name} of the hatch is {found} {unit}; it must be {allowed}")]
    Setting {
        /// The setting.
        name: &'static str,
        /// The value.
        found: f64,
        /// Its unit.
        unit: &'static str,
        /// The allowed values.
        allowed: &'static str,
    },
    /// A corner of the area is not finite.
    #[error("a corner of the area is {x}, {y}; both must be finite numbers")]
    Corner {
        /// Its x.
        x: f64,
        /// Its y.
        y: f64,
    },
    /// There are more crossings than a drawing can hold.
    #[error(
        "the hatch crosses borders {crossings:.0} times; at most {most} are allowed: \
         choose a wider spacing"
    )]
    TooMany {
        /// The number of crossings of lines with the border.
        crossings: f64,
        /// The maximum.
        most: u32,
    },
    /// The borders cross too often for [`HatchStyle::Concentric`] and [`HatchStyle::Spiral`].
    #[error(
        "the borders of the area cross each other too often for concentric hatching: choose lines"
    )]
    Entangled,
    /// There are more corners than a drawing can hold.
    #[error(
        "the hatch has about {corners:.0} corners; at most {most} are allowed: choose a wider spacing"
    )]
    TooManyCorners {
        /// The number of corners.
        corners: f64,
        /// The maximum.
        most: u32,
    },
}

/// Returns the lines in one direction.
fn lines(
    area: &Area,
    hatch: &Hatch,
    angle_deg: f64,
    cancel: &CancelToken,
) -> Result<Vec<Stroke>, HatchError> {
    // Rotate the area so that the lines are horizontal.
    let forth = direction(angle_deg);
    let back = Vec2::new(forth.x, -forth.y);
    let turned = |p: Point, by: Vec2| p.to_vec2().rotate_scale(by).to_point();
    let edges = area.rings.iter().flat_map(|ring| {
        let next = ring.iter().cycle().skip(1);
        ring.iter()
            .zip(next)
            .map(|(a, b)| (turned(*a, back), turned(*b, back)))
    });
    let scan = Scan {
        edges: edges.collect(),
        rule: area.rule,
        spacing_mm: hatch.spacing_mm,
        inset_mm: hatch.inset_mm,
    };
    let spans = scan.spans(cancel)?;
    let mut strokes = if hatch.apart {
        each(&spans)
    } else {
        Joined::new(&spans, scan.edges, hatch.spacing_mm).strokes(cancel)?
    };
    for p in strokes.iter_mut().flat_map(|stroke| &mut stroke.points) {
        *p = turned(*p, forth);
    }
    Ok(strokes)
}

const MIN_SPACING_MM: f64 = 0.05;
