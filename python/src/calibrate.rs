//! Calibrations from touches.

use dobot_api::{Backlash, CalibrationFile};
use dobot_arm::{Joints, Millimeters, Position, Tool};
use dobot_calibrate::{
    Fit, SHEET_POINTS, Touch, Trust, fit, found, residuals_svg, write_calibration,
};
use pyo3::prelude::*;

use crate::failure::value_error;

/// What touches tell of an arm.
#[pyclass(frozen)]
pub(crate) struct Calibrated {
    touches: Vec<Touch>,
    fit: Fit,
    file: CalibrationFile,
}

/// A touched point: its place on the sheet and its height above the paper, in mm; and what the arm said of its base, rear arm
/// and forearm, in degrees.
type Touched = (f64, f64, f64, f64, f64, f64);

#[pymethods]
impl Calibrated {
    #[new]
    fn new(py: Python<'_>, touches: Vec<Touched>) -> PyResult<Self> {
        let touches: Vec<Touch> = touches.into_iter().map(touch).collect();
        py.detach(|| {
            let fit = fit(&touches, TOOL).map_err(|error| value_error(&error))?;
            let file = found(&fit, Backlash::default());
            Ok(Self { touches, fit, file })
        })
    }

    /// How much further base, rear arm and forearm stand than the arm says, in degrees.
    #[getter]
    const fn zeros_deg(&self) -> (f64, f64, f64) {
        let zeros = &self.file.zeros;
        (zeros.base, zeros.rear, zeros.fore)
    }

    /// How far the tool is further out and to the left, in mm.
    #[getter]
    const fn tool_mm(&self) -> (f64, f64) {
        (self.file.tool.out_mm, self.file.tool.left_mm)
    }

    /// How far each touch is from where it should be, in mm.
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
    const fn left_out(&self) -> Option<usize> {
        self.fit.left_out
    }

    #[getter]
    const fn trust(&self) -> &'static str {
        match self.fit.trust {
            Trust::Good => "good",
            Trust::Unchecked => "unchecked",
            Trust::Doubtful => "doubtful",
        }
    }

    /// What `dobot calibrate FILE --use` reads.
    #[getter]
    fn text(&self) -> String {
        write_calibration(&self.file)
    }

    /// The place that the arm has to be told for its tool to be at a true one, in mm.
    fn told_place(&self, x_mm: f64, y_mm: f64, z_mm: f64) -> PyResult<(f64, f64, f64)> {
        let place = Position::new(x_mm, y_mm, z_mm);
        let told = self.fit.arm.told_place(place, TOOL);
        Ok(numbers(told.map_err(|error| value_error(&error))?))
    }

    /// Where the tool is when the arm says this place, in mm.
    fn true_place(&self, x_mm: f64, y_mm: f64, z_mm: f64) -> PyResult<(f64, f64, f64)> {
        let place = Position::new(x_mm, y_mm, z_mm);
        let there = self.fit.arm.true_place(place, TOOL);
        Ok(numbers(there.map_err(|error| value_error(&error))?))
    }

    fn svg(&self, py: Python<'_>) -> String {
        py.detach(|| residuals_svg(&self.touches, &self.fit))
    }
}

/// Where the points of the sheet are, in the order in which they are touched: x and y in mm.
#[pyfunction]
pub(crate) fn sheet_points() -> Vec<(f64, f64)> {
    SHEET_POINTS.into_iter().map(<(f64, f64)>::from).collect()
}

fn touch((x_mm, y_mm, height_mm, base_deg, rear_deg, fore_deg): Touched) -> Touch {
    Touch {
        place_mm: [x_mm, y_mm],
        height_mm,
        raw: Joints::new(base_deg, rear_deg, fore_deg, 0.0),
    }
}

const fn numbers(it: Position) -> (f64, f64, f64) {
    let (Millimeters(x), Millimeters(y), Millimeters(z)) = (it.x, it.y, it.z);
    (x, y, z)
}

/// That with which a pen is held, too.
const TOOL: Tool = Tool::SuctionCup;
