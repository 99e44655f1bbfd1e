//! A drawing as a step of a program.

use dobot_api::CalibrationFile;
use dobot_wire::{Command, Dialect};

use crate::{DrawingRequest, Materials, Options, Subject};

/// The commands that draw a file: as `dobot draw` makes them, with the wrist at this height in mm where the pen touches
/// the paper.
///
/// # Errors
///
/// Why it cannot be drawn, in one line that names the file.
pub fn draw_step(
    path: &str,
    bytes: Vec<u8>,
    options: Options,
    pen_down_mm: f64,
    dialect: Dialect,
    calibration: Option<CalibrationFile>,
) -> Result<Vec<Command>, String> {
    let told = |error: &dyn std::fmt::Display| format!("{path}: {error}");
    let subject = Subject::of_file(path, bytes).map_err(|error| told(&error))?;
    let asked = DrawingRequest::new(options, subject, &Materials::built_in())
        .map_err(|error| told(&error))?;
    let prepared = asked
        .calibrated(calibration)
        .prepare(Some(dialect), pen_down_mm)
        .map_err(|error| told(&error))?;
    Ok(prepared.0.plan.commands().collect())
}
