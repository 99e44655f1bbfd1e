//! A calibration as a text that a person can read and change.

use dobot_arm::Calibration;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::{Fit, Paper};

/// What is kept of an arm.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CalibrationFile {
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ToolOffset {
    /// Further out, in mm.
    pub out_mm: f64,
    /// To the left, in mm.
    pub left_mm: f64,
}

/// Where the base's axis stands in the sheet's frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Axis {
    /// Forward, in mm.
    pub x_mm: f64,
    /// To the left, in mm.
    pub y_mm: f64,
}

/// The plane of the paper, as Z of the wrist where the tool touches it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PaperPlane {
    /// The height below the base's axis, in mm.
    pub z_mm: f64,
    /// How much it rises for each mm forward.
    pub slope_x: f64,
    /// How much it rises for each mm to the left.
    pub slope_y: f64,
}

/// How far a motor turns in vain where its joint turns back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
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
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
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
    /// What a fit found, with the backlash that is known already.
    #[must_use]
    pub fn of(fit: &Fit, backlash: Backlash) -> Self {
        let Fit { arm, paper, .. } = fit;
        Self {
            zeros: Zeros {
                base: arm.base_deg,
                rear: arm.rear_deg,
                fore: arm.fore_deg,
            },
            tool: ToolOffset {
                out_mm: arm.reach_mm,
                left_mm: arm.left_mm,
            },
            axis: Axis {
                x_mm: arm.axis_mm[0],
                y_mm: arm.axis_mm[1],
            },
            paper: Some(PaperPlane {
                z_mm: paper.z0_mm,
                slope_x: paper.slope_x,
                slope_y: paper.slope_y,
            }),
            backlash,
            touched: Some(Touched {
                points: fit.residuals_mm.len() - usize::from(fit.left_out.is_some()),
                typical_mm: fit.typical_mm,
                largest_mm: fit.largest_mm,
            }),
        }
    }

    /// Reads a text.
    ///
    /// # Errors
    ///
    /// [`FileError`] where it is not a calibration, or one that no arm can have.
    pub fn parse(text: &str) -> Result<Self, FileError> {
        let file: Self =
            toml::from_str(text).map_err(|error| FileError::Text(error.to_string()))?;
        file.check()?;
        Ok(file)
    }

    /// The text.
    ///
    /// # Panics
    ///
    /// Never: all of it is tables of numbers.
    #[must_use]
    pub fn emit(&self) -> String {
        toml::to_string(self).expect("tables of numbers are TOML")
    }

    /// What is wrong with the arm.
    #[must_use]
    pub const fn arm(&self) -> Calibration {
        Calibration {
            base_deg: self.zeros.base,
            rear_deg: self.zeros.rear,
            fore_deg: self.zeros.fore,
            reach_mm: self.tool.out_mm,
            left_mm: self.tool.left_mm,
            axis_mm: [self.axis.x_mm, self.axis.y_mm],
        }
    }

    /// Where the paper lies, if that was found.
    #[must_use]
    pub fn paper(&self) -> Option<Paper> {
        self.paper.map(|it| Paper {
            z0_mm: it.z_mm,
            slope_x: it.slope_x,
            slope_y: it.slope_y,
        })
    }

    /// How slack base, rear arm and forearm are, in degrees.
    #[must_use]
    pub const fn backlash_deg(&self) -> [f64; 3] {
        [self.backlash.base, self.backlash.rear, self.backlash.fore]
    }

    fn check(&self) -> Result<(), FileError> {
        let plane = self.paper.unwrap_or(PaperPlane {
            z_mm: 0.0,
            slope_x: 0.0,
            slope_y: 0.0,
        });
        let ranges = [
            ("zeros.base", self.zeros.base, -90.0, 90.0),
            ("zeros.rear", self.zeros.rear, -30.0, 30.0),
            ("zeros.fore", self.zeros.fore, -30.0, 30.0),
            ("tool.out_mm", self.tool.out_mm, -30.0, 30.0),
            ("tool.left_mm", self.tool.left_mm, -30.0, 30.0),
            ("axis.x_mm", self.axis.x_mm, -50.0, 50.0),
            ("axis.y_mm", self.axis.y_mm, -50.0, 50.0),
            ("paper.z_mm", plane.z_mm, -300.0, 136.0),
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
            Err(FileError::Range {
                key,
                found,
                least,
                most,
            })
        })
    }
}

/// Why a text is not a calibration.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FileError {
    /// It does not say what it should.
    #[error("it is not a calibration: {0}")]
    Text(String),
    /// A number is one that no arm can have.
    #[error("{key} is {found}; allowed are {least} to {most}")]
    Range {
        /// Which.
        key: &'static str,
        /// What it is.
        found: f64,
        /// The least that is allowed.
        least: f64,
        /// The most that is allowed.
        most: f64,
    },
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again() {
        let file = CalibrationFile {
            zeros: Zeros {
                base: 3.5,
                rear: -24.4,
                fore: -3.9,
            },
            paper: Some(PaperPlane {
                z_mm: -42.5,
                slope_x: 0.01,
                slope_y: -0.02,
            }),
            ..CalibrationFile::default()
        };
        assert_eq!(CalibrationFile::parse(&file.emit()).unwrap(), file);
    }

    #[test]
    fn a_number_that_no_arm_can_have_is_told_with_what_is_allowed() {
        let error =
            CalibrationFile::parse("[zeros]\nbase = 0.0\nrear = 70.0\nfore = 0.0\n").unwrap_err();
        assert_eq!(error.to_string(), "zeros.rear is 70; allowed are -30 to 30");
    }
}
