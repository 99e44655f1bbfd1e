//! What the arm in use makes of a drawing: its calibration, the slack of its joints, the point where it resumes.

pub(crate) mod backlash;
pub(crate) mod calibrated;
pub(crate) mod resume_point;
