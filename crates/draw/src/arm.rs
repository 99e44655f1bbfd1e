//! Adapts a drawing to the arm: calibration, backlash, and the resume point.

pub(crate) mod backlash;
pub(crate) mod calibrated;
pub(crate) mod resume_point;
