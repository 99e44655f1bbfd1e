//! How one arm differs from the drawing of it, as it is kept.

use dobot_arm::{Calibration, Plane};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What is kept of an arm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CalibrationFile {
    /// What people call the arm, at most 64 characters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// How much further each joint stands than the arm says, in degrees.
    pub zeros: Zeros,
    /// Where the tool is, compared with the drawing of the arm.
    #[serde(default)]
    pub tool: ToolOffset,
    /// Where the base's axis stands in the sheet's frame, in mm.
    #[serde(default)]
    pub axis: Axis,
    /// Where the paper lies.
    #[serde(default)]
    pub paper: Option<PaperPlane>,
    /// How slack each joint is, in degrees.
    #[serde(default)]
    pub backlash: Backlash,
    /// How well the touches agreed.
    #[serde(default)]
    pub touched: Option<Touched>,
}

/// How much further each joint stands than the arm says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Zeros {
    /// The base, in degrees.
    pub base: f64,
    /// The rear arm, in degrees.
    pub rear: f64,
    /// The forearm, in degrees.
    pub fore: f64,
}

/// Where the tool is, compared with the drawing of the arm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolOffset {
    /// Further out, in mm.
    pub out_mm: f64,
    /// To the left, in mm.
    pub left_mm: f64,
}

/// Where the base's axis stands in the sheet's frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Axis {
    /// Forward, in mm.
    pub x_mm: f64,
    /// To the left, in mm.
    pub y_mm: f64,
}

/// Where the paper lies, as Z of the wrist where the tool touches it: a plane, and what it rises above the plane at the
/// places that were touched.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PaperPlane {
    /// The height below the base's axis, in mm.
    pub z_mm: f64,
    /// How much it rises for each mm forward.
    pub slope_x: f64,
    /// How much it rises for each mm to the left.
    pub slope_y: f64,
    /// Places that were touched, in mm: forward, to the left, and how much higher than the plane the paper is there.
    /// Between them it is bent evenly; without any it is flat.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub heights: Vec<[f64; 3]>,
}

impl PaperPlane {
    /// The plane alone.
    #[must_use]
    pub const fn plane(&self) -> Plane {
        Plane {
            z0_mm: self.z_mm,
            slope_x: self.slope_x,
            slope_y: self.slope_y,
        }
    }

    /// The plane under the lowest place that was touched.
    #[must_use]
    pub fn table(&self) -> Plane {
        let lowest_mm = self.heights.iter().map(|it| it[2]).fold(0.0, f64::min);
        Plane {
            z0_mm: self.z_mm + lowest_mm,
            ..self.plane()
        }
    }

    fn check_heights(&self) -> Result<(), NoSuchArm> {
        let wrong = |&(_, found, most): &(&str, f64, f64)| !(-most..=most).contains(&found);
        let numbers = self.heights.iter().flat_map(|&[x_mm, y_mm, higher_mm]| {
            [
                ("paper.heights x", x_mm, FARTHEST_MM),
                ("paper.heights y", y_mm, FARTHEST_MM),
                ("paper.heights higher", higher_mm, MOST_BENT_MM),
            ]
        });
        let count = self.heights.len();
        let too_many = (count > MOST_HEIGHTS).then_some(NoSuchArm {
            key: "the number of paper.heights",
            #[expect(clippy::cast_precision_loss, reason = "a count")]
            found: count as f64,
            least: 0.0,
            #[expect(clippy::cast_precision_loss, reason = "a small count")]
            most: MOST_HEIGHTS as f64,
        });
        let beyond = numbers.into_iter().find(wrong);
        let beyond = beyond.map(|(key, found, most)| NoSuchArm {
            key,
            found,
            least: -most,
            most,
        });
        too_many.or(beyond).map_or(Ok(()), Err)
    }
}

/// How far a motor turns in vain where its joint turns back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Backlash {
    /// The base, in degrees.
    pub base: f64,
    /// The rear arm, in degrees.
    pub rear: f64,
    /// The forearm, in degrees.
    pub fore: f64,
}

/// How well the touches agreed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Touched {
    /// How many counted.
    pub points: usize,
    /// Their typical residual, in mm.
    pub typical_mm: f64,
    /// Their largest residual, in mm.
    pub largest_mm: f64,
}

impl CalibrationFile {
    /// What is wrong with the arm.
    #[must_use]
    pub fn arm(&self) -> Calibration {
        Calibration {
            base_deg: self.zeros.base,
            rear_deg: self.zeros.rear,
            fore_deg: self.zeros.fore,
            reach_mm: self.tool.out_mm,
            left_mm: self.tool.left_mm,
            axis_mm: [self.axis.x_mm, self.axis.y_mm],
            backlash_deg: self.backlash_deg(),
            table: self.paper.as_ref().map(PaperPlane::table),
        }
    }

    /// The same arm when it has been told its true joint angles.
    #[must_use]
    pub fn without_zeros(self) -> Self {
        Self {
            zeros: Zeros::default(),
            ..self
        }
    }

    /// How slack base, rear arm and forearm are, in degrees.
    #[must_use]
    pub const fn backlash_deg(&self) -> [f64; 3] {
        [self.backlash.base, self.backlash.rear, self.backlash.fore]
    }

    fn check_name(&self) -> Result<(), NoSuchArm> {
        let characters = self.name.as_ref().map_or(1, |it| it.chars().count());
        if (1..=LONGEST_NAME).contains(&characters) {
            return Ok(());
        }
        Err(NoSuchArm {
            key: "the number of characters of name",
            #[expect(clippy::cast_precision_loss, reason = "a count")]
            found: characters as f64,
            least: 1.0,
            #[expect(clippy::cast_precision_loss, reason = "a small count")]
            most: LONGEST_NAME as f64,
        })
    }

    /// Whether an arm can be so.
    ///
    /// # Errors
    ///
    /// [`NoSuchArm`] with the first number that no arm can have.
    pub fn check(&self) -> Result<(), NoSuchArm> {
        self.check_name()?;
        let paper = self.paper.clone().unwrap_or_default();
        paper.check_heights()?;
        let plane = paper.plane();
        let ranges = [
            ("zeros.base", self.zeros.base, -90.0, 90.0),
            ("zeros.rear", self.zeros.rear, -30.0, 30.0),
            ("zeros.fore", self.zeros.fore, -30.0, 30.0),
            ("tool.out_mm", self.tool.out_mm, -30.0, 30.0),
            ("tool.left_mm", self.tool.left_mm, -30.0, 30.0),
            ("axis.x_mm", self.axis.x_mm, -50.0, 50.0),
            ("axis.y_mm", self.axis.y_mm, -50.0, 50.0),
            ("paper.z_mm", plane.z0_mm, -300.0, 136.0),
            ("paper.slope_x", plane.slope_x, -0.18, 0.18),
            ("paper.slope_y", plane.slope_y, -0.18, 0.18),
            ("backlash.base", self.backlash.base, 0.0, 5.0),
            ("backlash.rear", self.backlash.rear, 0.0, 5.0),
            ("backlash.fore", self.backlash.fore, 0.0, 5.0),
        ];
        let wrong = ranges
            .into_iter()
            .find(|(_, found, least, most)| !(*least..=*most).contains(found));
        wrong.map_or(Ok(()), |(key, found, least, most)| {
            Err(NoSuchArm {
                key,
                found,
                least,
                most,
            })
        })
    }
}

/// The arm does not get further than this.
const FARTHEST_MM: f64 = 400.0;
/// What is bent by more is no paper on a table.
const MOST_BENT_MM: f64 = 20.0;
/// What fits into a line beside other words, in characters.
const LONGEST_NAME: usize = 64;
/// More than any person touches.
const MOST_HEIGHTS: usize = 400;

/// A calibration has a number that no arm can have.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{key} is {found}; allowed are {least} to {most}")]
pub struct NoSuchArm {
    /// Which.
    pub key: &'static str,
    /// What it is.
    pub found: f64,
    /// The least that is allowed.
    pub least: f64,
    /// The most that is allowed.
    pub most: f64,
}

/// What is known of how an arm differs from the drawing of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Calibrations {
    /// What holds; nothing for an arm that is taken to be as drawn.
    pub calibration: Option<CalibrationFile>,
    /// What held before, to bring it back.
    pub before: Option<CalibrationFile>,
}

impl Calibrations {
    /// What is wrong with the arm.
    #[must_use]
    pub fn arm(&self) -> Calibration {
        let known = &self.calibration;
        known
            .as_ref()
            .map_or(Calibration::NONE, CalibrationFile::arm)
    }

    /// Another calibration in place of the one that holds. The arm keeps its name, unless it is given one.
    #[must_use]
    pub fn replaced_by(self, calibration: Option<CalibrationFile>) -> Self {
        let before = self.calibration;
        let name = before.as_ref().and_then(|it| it.name.clone());
        let calibration = calibration.map(|it| CalibrationFile {
            name: it.name.or(name),
            ..it
        });
        Self {
            calibration,
            before,
        }
    }

    /// What people call the arm, if it is calibrated and has a name.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        self.calibration.as_ref()?.name.as_deref()
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn called(name: Option<&str>) -> CalibrationFile {
        CalibrationFile {
            name: name.map(str::to_owned),
            ..CalibrationFile::default()
        }
    }

    #[test]
    fn an_arm_keeps_its_name_until_it_is_given_another() {
        let known = Calibrations::default().replaced_by(Some(called(Some("desk 3"))));
        let again = known.replaced_by(Some(called(None)));
        assert_eq!(again.name(), Some("desk 3"));
        let other = again.replaced_by(Some(called(Some("the old one"))));
        assert_eq!(other.name(), Some("the old one"));
        assert_eq!(other.before.unwrap().name.as_deref(), Some("desk 3"));
    }

    #[test]
    fn a_name_that_fills_more_than_a_line_is_refused() {
        called(Some(&"n".repeat(64))).check().unwrap();
        let error = called(Some(&"n".repeat(65))).check().unwrap_err();
        assert_eq!(
            error.to_string(),
            "the number of characters of name is 65; allowed are 1 to 64"
        );
    }
}
