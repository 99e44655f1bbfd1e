//! Calibrations from touches.

use dobot_api::{Backlash, CalibrationFile};
use dobot_arm::{Joints, Millimeters, Position, Tool};
use dobot_calibrate::{
    Fit, SHEET_POINTS, Touch, Trust, fit, found, residuals_svg, write_calibration,
};
use pyo3::prelude::*;

use crate::failure::value_error;

/// A calibration fitted to touches.
#[pyclass(frozen)]
pub(crate) struct Calibrated {
    touches: Vec<Touch>,
    fit: Fit,
    file: CalibrationFile,
}

/// A touched point: its position on the sheet and its height above the paper, in mm; and the
/// reported angles of base, rear arm and forearm, in degrees.
type Touched = (f64, f64, f64, f64, f64, f64);

#[pymethods]
impl Calibrated {
    #[new]
    fn new(py: Python<'_>, touches: Vec<Touched>, tool_measured: bool) -> PyResult<Self> {
        let touches: Vec<Touch> = touches.into_iter().map(touch).collect();
        py.detach(|| {
            let fit = fit(&touches, TOOL).map_err(|error| value_error(&error))?;
            let fit = if tool_measured {
                fit.with_measured_tool()
            } else {
                fit
            };
            let file = found(&fit, Backlash::default());
            Ok(Self { touches, fit, file })
        })
    }

    /// Returns the zero offsets of base, rear arm and forearm, in degrees.
    #[getter]
    const fn zeros_deg(&self) -> (f64, f64, f64) {
        let zeros = &self.file.zeros;
        (zeros.base, zeros.rear, zeros.fore)
    }

    /// Returns the offset of the tool outward and to the left, in mm.
    #[getter]
    const fn tool_mm(&self) -> (f64, f64) {
        (self.file.tool.out_mm, self.file.tool.left_mm)
    }

    /// Returns the residual of each touch, in mm.
    #[getter]
    fn residuals_mm(&self) -> Vec<f64> {
        let all = 0..self.touches.len();
        all.map(|index| self.fit.residual_mm(index)).collect()
    }

    #[getter]
    const fn typical_mm(&self) -> f64 {
        self.fit.typical_mm
    }

    #[getter]
    const fn expected_mm(&self) -> f64 {
        self.fit.expected_mm
    }

    #[getter]
    fn wrong(&self) -> Vec<usize> {
        self.fit.left_out.clone()
    }

    #[getter]
    const fn trust(&self) -> &'static str {
        match self.fit.trust {
            Trust::Good => "good",
            Trust::Unchecked => "unchecked",
            Trust::Unmeasured => "unmeasured",
            Trust::Doubtful => "doubtful",
        }
    }

    /// Returns the text for `dobot calibrate FILE --use`.
    #[getter]
    fn text(&self) -> String {
        write_calibration(&self.file)
    }

    /// Returns the raw position to command for a calibrated position of the tool, in mm.
    fn raw_place(&self, x_mm: f64, y_mm: f64, z_mm: f64) -> PyResult<(f64, f64, f64)> {
        let place = Position::new(x_mm, y_mm, z_mm);
        let raw = self.fit.arm.raw_place(place, TOOL);
        Ok(numbers(raw.map_err(|error| value_error(&error))?))
    }

    /// Returns the calibrated position for a raw position, in mm.
    fn true_place(&self, x_mm: f64, y_mm: f64, z_mm: f64) -> PyResult<(f64, f64, f64)> {
        let place = Position::new(x_mm, y_mm, z_mm);
        let there = self.fit.arm.true_place(place, TOOL);
        Ok(numbers(there.map_err(|error| value_error(&error))?))
    }

    fn svg(&self, py: Python<'_>) -> String {
        py.detach(|| residuals_svg(&self.touches, &self.fit))
    }
}

/// Returns the points of the sheet, in the order of touching: x and y in mm.
#[pyfunction]
pub(crate) fn sheet_points() -> Vec<(f64, f64)> {
    SHEET_POINTS.into_iter().map(<(f64, f64)>::from).collect()
}

/// Returns the four corners of each of the sheet's markers 0 to 3, clockwise from the upper left one,
/// in mm.
#[pyfunction]
pub(crate) fn sheet_markers() -> Vec<Vec<(f64, f64)>> {
    dobot_calibrate::sheet_markers()
        .into_iter()
        .map(|(_, corners)| corners.map(<(f64, f64)>::from).to_vec())
        .collect()
}

fn touch((x_mm, y_mm, height_mm, base_deg, rear_deg, fore_deg): Touched) -> Touch {
    Touch {
        place_mm: [x_mm, y_mm],
        height_mm,
        raw: Joints::new(base_deg, rear_deg, fore_deg, 0.0),
    }
}

const fn numbers(position: Position) -> (f64, f64, f64) {
    let (Millimeters(x), Millimeters(y), Millimeters(z)) = (position.x, position.y, position.z);
    (x, y, z)
}

/// The tool that also holds a pen.
const TOOL: Tool = Tool::SuctionCup;
