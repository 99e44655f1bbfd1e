//! The files named in a taught program: other programs, and drawings that become its steps.

use dobot_api::CalibrationFile;
use dobot_teach::{Drawing, Files};
use dobot_wire::{Command, Dialect};

use crate::{DrawingRequest, Materials, Subject};

/// The files named in a taught program, loaded by `read`; drawings are converted as by `dobot
/// draw`, for one arm.
#[derive(Clone, Debug)]
pub struct ProgramFiles<R> {
    read: R,
    dialect: Dialect,
    calibration: Option<CalibrationFile>,
}

impl<R: FnMut(&str) -> Result<Vec<u8>, String>> ProgramFiles<R> {
    /// Creates a loader for files by their names in the program, for an arm with this dialect and
    /// calibration. The error of `read` for a missing file names it.
    pub const fn new(read: R, dialect: Dialect, calibration: Option<CalibrationFile>) -> Self {
        Self {
            read,
            dialect,
            calibration,
        }
    }
}

impl<R: FnMut(&str) -> Result<Vec<u8>, String>> Files for ProgramFiles<R> {
    fn program(&mut self, path: &str) -> Result<String, String> {
        String::from_utf8((self.read)(path)?)
            .map_err(|_| format!("{path} is not text in UTF-8, so it is no program"))
    }

    fn drawing(&mut self, path: &str, drawing: &Drawing) -> Result<Vec<Command>, String> {
        let bytes = (self.read)(path)?;
        commands(path, bytes, drawing, self.dialect, self.calibration.clone())
            .map_err(|error| format!("{path}: {error}"))
    }
}

/// Converts a drawing to commands. This is not a method, so that it is compiled only once and not
/// for each `R`.
fn commands(
    path: &str,
    bytes: Vec<u8>,
    drawing: &Drawing,
    dialect: Dialect,
    calibration: Option<CalibrationFile>,
) -> Result<Vec<Command>, String> {
    let options = drawing.options.clone();
    let options = options.try_into().map_err(|error| error.to_string())?;
    let subject = Subject::of_file(path, bytes).map_err(|error| error.to_string())?;
    let asked = DrawingRequest::new(options, subject, &Materials::built_in())
        .map_err(|error| error.to_string())?;
    let prepared = asked
        .calibrated(calibration)
        .prepare(Some(dialect), drawing.pen_down)
        .map_err(|error| error.to_string())?;
    Ok(prepared.0.plan.commands().collect())
}
