//! Areas become lines.

mod contour;
mod join;
mod scan;

#[cfg(test)]
mod tests;

use std::str::FromStr;

use contour::{contours, spirals};
use dobot_geometry::{Area, Point, Stroke, Vec2, direction};
use join::{Joined, each};
use scan::Scan;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// How an area is filled with lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hatch {
    /// Which kind of lines.
    pub style: HatchStyle,
    /// How far apart the lines are, in mm; from 0.05 up.
    pub spacing_mm: f64,
    /// How the lines run: 0 along x, 90 along y.
    pub angle_deg: f64,
    /// A second set of lines goes across the first.
    pub cross: bool,
    /// How far the lines stay away from the border, in mm: half the pen's width keeps the ink
    /// inside.
    pub inset_mm: f64,
    /// Each parallel line is a stroke of its own: a tool is slow where it turns from one into the next, and a laser burns
    /// more there.
    pub apart: bool,
}

impl Default for Hatch {
    /// 1 mm apart, at 45 degrees, not crossed, up to the border.
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

/// Fills an area with lines. Parallel ones lie on a grid that is the same for all areas, so that
/// those of neighbours meet. Where the end of the next line is near, and the way there stays
/// inside, the pen goes on without a lift, unless they are to stay apart:
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
/// [`HatchError`] where a setting is not a number or out of range, or where there would be too many lines.
pub fn hatch(area: &Area, hatch: &Hatch) -> Result<Vec<Stroke>, HatchError> {
    hatch.check(area)?;
    match hatch.style {
        HatchStyle::Lines => parallel(area, hatch),
        HatchStyle::Concentric => contours(area, hatch),
        HatchStyle::Spiral => spirals(area, hatch),
    }
}

fn parallel(area: &Area, hatch: &Hatch) -> Result<Vec<Stroke>, HatchError> {
    let mut strokes = lines(area, hatch, hatch.angle_deg)?;
    if hatch.cross {
        strokes.extend(lines(area, hatch, hatch.angle_deg + 90.0)?);
    }
    Ok(strokes)
}

/// The lines that an area is filled with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum HatchStyle {
    /// Parallel lines.
    #[default]
    Lines,
    /// The outline again and again, each time so much farther inside.
    Concentric,
    /// The same in one line, from the outside in.
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
                LEAST_SPACING_MM,
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

/// Why an area cannot be hatched.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HatchError {
    /// A setting is not a number, or less than it may be.
    #[error("the {name} of the hatch is {found} {unit}; it must be {allowed}")]
    Setting {
        /// Which setting.
        name: &'static str,
        /// What was asked for.
        found: f64,
        /// Its unit.
        unit: &'static str,
        /// What it may be.
        allowed: &'static str,
    },
    /// A corner of the area lies nowhere.
    #[error("a corner of the area is {x}, {y}; both must be finite numbers")]
    Corner {
        /// Its x.
        x: f64,
        /// Its y.
        y: f64,
    },
    /// More than a drawing can hold.
    #[error(
        "the hatch crosses borders {crossings:.0} times; at most {most} are allowed: \
         choose a wider spacing"
    )]
    TooMany {
        /// How often lines would meet the border.
        crossings: f64,
        /// How often they may.
        most: u32,
    },
    /// More than a drawing can hold.
    #[error(
        "the hatch has about {corners:.0} corners; at most {most} are allowed: choose a wider spacing"
    )]
    TooManyCorners {
        /// How many there would be.
        corners: f64,
        /// How many there may be.
        most: u32,
    },
}

/// The lines of one direction.
fn lines(area: &Area, hatch: &Hatch, angle_deg: f64) -> Result<Vec<Stroke>, HatchError> {
    // The lines are level once the area is turned back.
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
    let spans = scan.spans()?;
    let mut strokes = if hatch.apart {
        each(&spans)
    } else {
        Joined::new(&spans, scan.edges, hatch.spacing_mm).strokes()
    };
    for p in strokes.iter_mut().flat_map(|stroke| &mut stroke.points) {
        *p = turned(*p, forth);
    }
    Ok(strokes)
}

const LEAST_SPACING_MM: f64 = 0.05;
