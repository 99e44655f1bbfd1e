//! The calibration file, a text that people can read and edit.

use dobot_api::{
    Axis, Backlash, CalibrationFile, NoSuchArm, PaperPlane, ToolOffset, Touched, Zeros,
};
use dobot_arm::Plane;
use thiserror::Error;

use crate::Fit;

/// Returns the calibration that a fit found, with the backlash measured before.
#[must_use]
pub fn found(fit: &Fit, backlash: Backlash) -> CalibrationFile {
    let Fit { arm, paper, .. } = fit;
    CalibrationFile {
        name: None,
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
        paper: Some(level(paper)),
        backlash,
        touched: Some(touched(fit)),
    }
}

const fn level(paper: &Plane) -> PaperPlane {
    PaperPlane {
        z_mm: paper.z0_mm,
        slope_x: paper.slope_x,
        slope_y: paper.slope_y,
        heights: Vec::new(),
    }
}

const fn touched(fit: &Fit) -> Touched {
    Touched {
        points: fit.residuals_mm.len() - fit.left_out.len(),
        typical_mm: fit.typical_mm,
        largest_mm: fit.largest_mm,
    }
}

/// Parses a calibration file.
///
/// # Errors
///
/// [`FileError`] if the text is not a calibration or has values outside the limits of an arm.
pub fn read_calibration(text: &str) -> Result<CalibrationFile, FileError> {
    let file: CalibrationFile =
        toml::from_str(text).map_err(|error| FileError::Text(error.to_string()))?;
    file.check()?;
    Ok(file)
}

/// Writes a calibration file.
///
/// # Panics
///
/// Never: the file consists of tables of numbers.
#[must_use]
pub fn write_calibration(file: &CalibrationFile) -> String {
    toml::to_string(file).expect("tables of numbers are TOML")
}

/// The error returned when a text is not a calibration.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FileError {
    /// The text does not parse.
    #[error("not a calibration file: {0}")]
    Text(String),
    /// A number is outside the limits of an arm.
    #[error(transparent)]
    Range(#[from] NoSuchArm),
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_written_file_is_read_back() {
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
                heights: vec![[200.0, 0.0, 0.5]],
            }),
            ..CalibrationFile::default()
        };
        assert_eq!(read_calibration(&write_calibration(&file)).unwrap(), file);
    }

    #[test]
    fn a_number_that_no_arm_can_have_is_reported_with_the_allowed_range() {
        let error = read_calibration("[zeros]\nbase = 0.0\nrear = 70.0\nfore = 0.0\n").unwrap_err();
        assert_eq!(error.to_string(), "zeros.rear is 70; allowed are -30 to 30");
    }
}
