//! The stored calibration of one arm: how it differs from the drawing.

use dobot_arm::{Calibration, Plane};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A stored calibration.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CalibrationFile {
    /// The name of the arm, at most 64 characters.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Zero offsets: how much further each joint stands than the arm reports, in degrees.
    pub zeros: Zeros,
    /// The tool's offset from the drawing of the arm.
    #[serde(default)]
    pub tool: ToolOffset,
    /// The position of the base's axis in the sheet's frame, in mm.
    #[serde(default)]
    pub axis: Axis,
    /// The position of the paper.
    #[serde(default)]
    pub paper: Option<PaperPlane>,
    /// The backlash of each joint, in degrees.
    #[serde(default)]
    pub backlash: Backlash,
    /// How well the touched points agree.
    #[serde(default)]
    pub touched: Option<Touched>,
}

/// Zero offsets: how much further each joint stands than the arm reports.
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

/// The tool's offset from the drawing of the arm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolOffset {
    /// Further out, in mm.
    pub out_mm: f64,
    /// To the left, in mm.
    pub left_mm: f64,
}

/// The position of the base's axis in the sheet's frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Axis {
    /// Forward, in mm.
    pub x_mm: f64,
    /// To the left, in mm.
    pub y_mm: f64,
}

/// The paper as a surface, given as Z of the wrist where the tool touches it: a plane, plus its
/// rise above the plane at the touched points.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PaperPlane {
    /// The height relative to the base's axis, in mm.
    pub z_mm: f64,
    /// The rise per mm forward.
    pub slope_x: f64,
    /// The rise per mm to the left.
    pub slope_y: f64,
    /// The touched points, in mm: forward, left, and the height of the paper above the plane. The
    /// surface is interpolated between them; without points it is flat.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub heights: Vec<[f64; 3]>,
}

impl PaperPlane {
    /// Returns the plane alone.
    #[must_use]
    pub const fn plane(&self) -> Plane {
        Plane {
            z0_mm: self.z_mm,
            slope_x: self.slope_x,
            slope_y: self.slope_y,
        }
    }

    /// Returns the plane lowered to the lowest touched point.
    #[must_use]
    pub fn table(&self) -> Plane {
        let lowest_mm = self
            .heights
            .iter()
            .map(|height| height[2])
            .fold(0.0, f64::min);
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
                ("paper.heights higher", higher_mm, MAX_BENT_MM),
            ]
        });
        let count = self.heights.len();
        let too_many = (count > MAX_HEIGHTS).then(|| too_many_heights(count));
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

fn too_many_heights(count: usize) -> NoSuchArm {
    NoSuchArm {
        key: "the number of paper.heights",
        #[expect(clippy::cast_precision_loss, reason = "a count")]
        found: count as f64,
        least: 0.0,
        #[expect(clippy::cast_precision_loss, reason = "a small count")]
        most: MAX_HEIGHTS as f64,
    }
}

/// Backlash: how far a motor turns before its joint follows after a reversal.
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

/// How well the touched points agree.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Touched {
    /// The number of points used.
    pub points: usize,
    /// Their typical residual, in mm.
    pub typical_mm: f64,
    /// Their largest residual, in mm.
    pub largest_mm: f64,
}

impl CalibrationFile {
    /// Returns the calibration for the kinematics.
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

    /// Returns this calibration without zero offsets, as it is after the arm was given its true
    /// joint angles.
    #[must_use]
    pub fn without_zeros(self) -> Self {
        Self {
            zeros: Zeros::default(),
            ..self
        }
    }

    /// Returns the backlash of base, rear arm and forearm, in degrees.
    #[must_use]
    pub const fn backlash_deg(&self) -> [f64; 3] {
        [self.backlash.base, self.backlash.rear, self.backlash.fore]
    }

    fn check_name(&self) -> Result<(), NoSuchArm> {
        let characters = self.name.as_ref().map_or(1, |name| name.chars().count());
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

    /// Checks that an arm can have these values.
    ///
    /// # Errors
    ///
    /// [`NoSuchArm`] with the first number outside its range.
    pub fn check(&self) -> Result<(), NoSuchArm> {
        self.check_name()?;
        let paper = self.paper.clone().unwrap_or_default();
        paper.check_heights()?;
        let wrong = self
            .ranges(&paper.plane())
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

    /// Returns all numbers with their ranges: name, value, minimum, maximum.
    fn ranges(&self, paper: &Plane) -> [(&'static str, f64, f64, f64); 13] {
        [
            ("zeros.base", self.zeros.base, -90.0, 90.0),
            ("zeros.rear", self.zeros.rear, -30.0, 30.0),
            ("zeros.fore", self.zeros.fore, -30.0, 30.0),
            ("tool.out_mm", self.tool.out_mm, -30.0, 30.0),
            ("tool.left_mm", self.tool.left_mm, -30.0, 30.0),
            ("axis.x_mm", self.axis.x_mm, -50.0, 50.0),
            ("axis.y_mm", self.axis.y_mm, -50.0, 50.0),
            ("paper.z_mm", paper.z0_mm, -300.0, 136.0),
            ("paper.slope_x", paper.slope_x, -0.18, 0.18),
            ("paper.slope_y", paper.slope_y, -0.18, 0.18),
            ("backlash.base", self.backlash.base, 0.0, 5.0),
            ("backlash.rear", self.backlash.rear, 0.0, 5.0),
            ("backlash.fore", self.backlash.fore, 0.0, 5.0),
        ]
    }
}

/// The farthest reach of the arm.
const FARTHEST_MM: f64 = 400.0;
/// Larger deviations are not paper on a table.
const MAX_BENT_MM: f64 = 20.0;
/// Fits on one line with other text, in characters.
const LONGEST_NAME: usize = 64;
/// More points than a person would touch.
const MAX_HEIGHTS: usize = 400;

/// The error returned when a calibration has a number outside its range.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{key} is {found}; allowed are {least} to {most}")]
pub struct NoSuchArm {
    /// The key.
    pub key: &'static str,
    /// The value found.
    pub found: f64,
    /// The smallest value allowed.
    pub least: f64,
    /// The largest value allowed.
    pub most: f64,
}

/// The calibration of an arm and the previous one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Calibrations {
    /// The current calibration; `None` for an arm that is assumed to match the drawing.
    pub calibration: Option<CalibrationFile>,
    /// The previous calibration, kept to restore it.
    pub before: Option<CalibrationFile>,
}

impl Calibrations {
    /// Returns the calibration for the kinematics.
    #[must_use]
    pub fn arm(&self) -> Calibration {
        let known = &self.calibration;
        known
            .as_ref()
            .map_or(Calibration::NONE, CalibrationFile::arm)
    }

    /// Replaces the calibration. The arm keeps its name unless the new calibration has one.
    #[must_use]
    pub fn replaced_by(self, calibration: Option<CalibrationFile>) -> Self {
        let before = self.calibration;
        let name = before.as_ref().and_then(|before| before.name.clone());
        let calibration = calibration.map(|calibration| CalibrationFile {
            name: calibration.name.or(name),
            ..calibration
        });
        Self {
            calibration,
            before,
        }
    }

    /// Returns the arm's name, if it is calibrated and has a name.
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
    fn an_arm_keeps_its_name_until_it_gets_another() {
        let known = Calibrations::default().replaced_by(Some(called(Some("desk 3"))));
        let again = known.replaced_by(Some(called(None)));
        assert_eq!(again.name(), Some("desk 3"));
        let other = again.replaced_by(Some(called(Some("the old one"))));
        assert_eq!(other.name(), Some("the old one"));
        assert_eq!(other.before.unwrap().name.as_deref(), Some("desk 3"));
    }

    #[test]
    fn a_name_longer_than_a_line_is_refused() {
        called(Some(&"n".repeat(64))).check().unwrap();
        let error = called(Some(&"n".repeat(65))).check().unwrap_err();
        assert_eq!(
            error.to_string(),
            "the number of characters of name is 65; allowed are 1 to 64"
        );
    }
}
